// SPDX-License-Identifier: MIT
#include "Engine/EngineBaseTypes.h"

FURL::FURL() : Protocol(TEXT("unreal")), Port(7777), Valid(1) {}

FURL::FURL(FURL* Base, const TCHAR* TextURL, ETravelType Type) : FURL() {
    if (Base && Type == TRAVEL_Relative) {
        Map = Base->Map;
    }
    if (Base && (Type == TRAVEL_Relative || Type == TRAVEL_Partial)) {
        for (const FString& Option : Base->Op) {
            // "restart" and the like are meant once.
            if (!Option.Equals(TEXT("restart"), ESearchCase::IgnoreCase)) {
                Op.Add(Option);
            }
        }
    }

    FString Text(TextURL ? TextURL : TEXT(""));
    Text.TrimStartAndEndInline();
    int32 PortalIndex = INDEX_NONE;
    if (Text.FindChar(TEXT('#'), PortalIndex)) {
        Portal = Text.Mid(PortalIndex + 1);
        Text.LeftInline(PortalIndex);
    }
    TArray<FString> Parts;
    Text.ParseIntoArray(Parts, TEXT("?"), false);
    if (Parts.Num() > 0 && !Parts[0].IsEmpty()) {
        Map = Parts[0];
    }
    for (int32 Index = 1; Index < Parts.Num(); ++Index) {
        if (Parts[Index].StartsWith(TEXT("-"))) {
            RemoveOption(*Parts[Index].Mid(1));
        } else if (!Parts[Index].IsEmpty()) {
            AddOption(*Parts[Index]);
        }
    }
    Valid = Map.IsEmpty() ? 0 : 1;
}

namespace {
/** "Name" of "Name=Value" and of "Name". */
FString OptionName(const FString& Option) {
    int32 Equals = INDEX_NONE;
    return Option.FindChar(TEXT('='), Equals) ? Option.Left(Equals) : Option;
}
} // namespace

bool FURL::HasOption(const TCHAR* Test) const { return GetOption(Test, nullptr) != nullptr; }

const TCHAR* FURL::GetOption(const TCHAR* Match, const TCHAR* Default) const {
    const FString Name = OptionName(Match);
    for (const FString& Option : Op) {
        if (OptionName(Option).Equals(Name, ESearchCase::IgnoreCase)) {
            int32 Equals = INDEX_NONE;
            return Option.FindChar(TEXT('='), Equals) ? *Option + Equals + 1 : TEXT("");
        }
    }
    return Default;
}

void FURL::AddOption(const TCHAR* Str) {
    RemoveOption(*OptionName(Str));
    Op.Add(Str);
}

void FURL::RemoveOption(const TCHAR* Key) {
    const FString Name = OptionName(Key);
    Op.RemoveAll([&Name](const FString& Option) { return OptionName(Option).Equals(Name, ESearchCase::IgnoreCase); });
}

FString FURL::OptionsToString() const {
    FString Result;
    for (const FString& Option : Op) {
        Result += TEXT("?");
        Result += Option;
    }
    return Result;
}

FString FURL::ToString(bool FullyQualified) const {
    FString Result;
    if (FullyQualified && !Protocol.IsEmpty()) {
        Result = Protocol + TEXT(":");
    }
    Result += Map;
    Result += OptionsToString();
    if (!Portal.IsEmpty()) {
        Result += TEXT("#");
        Result += Portal;
    }
    return Result;
}

bool FURL::operator==(const FURL& Other) const {
    return Protocol == Other.Protocol && Host == Other.Host && Port == Other.Port && Map == Other.Map &&
           Op == Other.Op && Portal == Other.Portal;
}
