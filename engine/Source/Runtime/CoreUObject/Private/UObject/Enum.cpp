// SPDX-License-Identifier: MIT
// UEnum.
#include <string_view>

#include "UObject/Class.h"
#include "UObject/Package.h"
#include "UObject/UObjectHash.h"

namespace {
/** All enums by C++ type and all entries by full name. Lives until the process ends. */
struct FEnumIndex {
    TMap<FString, UEnum*> ByCppType;
    TMap<FName, UEnum*> ByEntry;
};
FEnumIndex& EnumIndex() {
    static FEnumIndex& Instance = *new FEnumIndex;
    return Instance;
}

FString ShortName(const FString& FullName) {
    const int32 Separator = FullName.Find(TEXT("::"), ESearchCase::CaseSensitive, ESearchDir::FromEnd);
    return Separator == INDEX_NONE ? FullName : FullName.Mid(Separator + 2);
}
} // namespace

UEnum::~UEnum() {
    FEnumIndex& Index = EnumIndex();
    UEnum* const* Registered = Index.ByCppType.Find(CppType);
    if (Registered && *Registered == this) {
        Index.ByCppType.Remove(CppType);
    }
    for (const TPair<FName, int64>& Entry : Names) {
        UEnum* const* Owner = Index.ByEntry.Find(Entry.Key);
        if (Owner && *Owner == this) {
            Index.ByEntry.Remove(Entry.Key);
        }
    }
}

bool UEnum::SetEnums(
    TArray<TPair<FName, int64>>& InNames, ECppForm InCppForm, EEnumFlags InFlags, bool bAddMaxKeyIfMissing) {
    Names = InNames;
    CppForm = InCppForm;
    EnumFlags = InFlags;
    bHasGeneratedMax = false;
    if (bAddMaxKeyIfMissing && !ContainsExistingMax()) {
        const FName MaxName(*GenerateFullEnumName(*(GenerateEnumPrefix() + TEXT("_MAX"))));
        if (GetIndexByName(MaxName) == INDEX_NONE) {
            Names.Add(TPair<FName, int64>(MaxName, Names.IsEmpty() ? 0 : GetMaxEnumValue() + 1));
            bHasGeneratedMax = true;
        }
    }
    FEnumIndex& Index = EnumIndex();
    for (const TPair<FName, int64>& Entry : Names) {
        Index.ByEntry.Add(Entry.Key, this);
    }
    if (!CppType.IsEmpty()) {
        Index.ByCppType.Add(CppType, this);
    }
    return true;
}

int32 UEnum::GetIndexByName(FName InName, EGetByNameFlags Flags) const {
    const ENameCase Case =
        EnumHasAnyFlags(Flags, EGetByNameFlags::CaseSensitive) ? ENameCase::CaseSensitive : ENameCase::IgnoreCase;
    for (int32 Index = 0; Index < Names.Num(); ++Index) {
        if (Names[Index].Key.IsEqual(InName, Case)) {
            return Index;
        }
    }
    const FString Text = InName.ToString();
    if (CppForm != ECppForm::Regular && !IsFullEnumName(*Text)) {
        const FName FullName(*GenerateFullEnumName(*Text), FNAME_Find);
        for (int32 Index = 0; Index < Names.Num(); ++Index) {
            if (!FullName.IsNone() && Names[Index].Key.IsEqual(FullName, Case)) {
                return Index;
            }
        }
    } else if (CppForm == ECppForm::Regular && IsFullEnumName(*Text)) {
        // "ECollisionChannel::ECC_Pawn" is accepted for regular enums too.
        const FName Short(*ShortName(Text), FNAME_Find);
        if (!Short.IsNone() && Text.StartsWith(GetName() + TEXT("::"))) {
            return GetIndexByName(Short, Flags);
        }
    }
    ensureMsgf(!EnumHasAnyFlags(Flags, EGetByNameFlags::ErrorIfNotFound), TEXT("Enum %s has no entry '%s'"), *GetName(),
        *Text);
    return INDEX_NONE;
}
int32 UEnum::GetIndexByNameString(const FString& SearchString, EGetByNameFlags Flags) const {
    return GetIndexByName(FName(*SearchString), Flags);
}
int32 UEnum::GetIndexByValue(int64 InValue) const {
    for (int32 Index = 0; Index < Names.Num(); ++Index) {
        if (Names[Index].Value == InValue) {
            return Index;
        }
    }
    return INDEX_NONE;
}
FName UEnum::GetNameByIndex(int32 Index) const {
    return Names.IsValidIndex(Index) ? Names[Index].Key : FName(NAME_None);
}
FName UEnum::GetNameByValue(int64 InValue) const { return GetNameByIndex(GetIndexByValue(InValue)); }
FString UEnum::GetNameStringByIndex(int32 InIndex) const {
    return Names.IsValidIndex(InIndex) ? ShortName(Names[InIndex].Key.ToString()) : FString();
}
FString UEnum::GetNameStringByValue(int64 InValue) const { return GetNameStringByIndex(GetIndexByValue(InValue)); }
bool UEnum::FindNameStringByValue(FString& Out, int64 InValue) const {
    const int32 Index = GetIndexByValue(InValue);
    if (Index == INDEX_NONE) {
        return false;
    }
    Out = GetNameStringByIndex(Index);
    return true;
}
int64 UEnum::GetValueByIndex(int32 Index) const {
    check(Names.IsValidIndex(Index));
    return Names[Index].Value;
}
int64 UEnum::GetValueByName(FName InName, EGetByNameFlags Flags) const {
    const int32 Index = GetIndexByName(InName, Flags);
    return Index == INDEX_NONE ? INDEX_NONE : Names[Index].Value;
}
int64 UEnum::GetValueByNameString(const FString& SearchString, EGetByNameFlags Flags) const {
    return GetValueByName(FName(*SearchString), Flags);
}
int64 UEnum::GetMaxEnumValue() const {
    int64 Max = Names.IsEmpty() ? 0 : Names[0].Value;
    for (const TPair<FName, int64>& Entry : Names) {
        Max = FMath::Max(Max, Entry.Value);
    }
    return Max;
}
bool UEnum::IsValidEnumValueOrBitfield(int64 InValue) const {
    if (!HasAnyEnumFlags(EEnumFlags::Flags)) {
        return IsValidEnumValue(InValue);
    }
    int64 All = 0;
    for (int32 Index = 0; Index < Names.Num() - (bHasGeneratedMax ? 1 : 0); ++Index) {
        All |= Names[Index].Value;
    }
    return (InValue & ~All) == 0;
}
FString UEnum::GetValueOrBitfieldAsString(int64 InValue) const {
    if (!HasAnyEnumFlags(EEnumFlags::Flags) || IsValidEnumValue(InValue)) {
        return GetNameStringByValue(InValue);
    }
    FString Result;
    for (int32 Index = 0; Index < Names.Num() - (bHasGeneratedMax ? 1 : 0); ++Index) {
        const int64 Bits = Names[Index].Value;
        if (Bits != 0 && (Bits & (Bits - 1)) == 0 && (InValue & Bits) != 0) {
            Result += (Result.IsEmpty() ? FString() : FString(TEXT(" | "))) + GetNameStringByIndex(Index);
        }
    }
    return Result;
}

FText UEnum::GetDisplayNameTextByIndex(int32 InIndex) const {
    if (!Names.IsValidIndex(InIndex)) {
        return FText::GetEmpty();
    }
    if (EnumDisplayNameFn) {
        return EnumDisplayNameFn(InIndex);
    }
#if WITH_METADATA
    const FString DisplayName = GetMetaData(TEXT("DisplayName"), InIndex);
    if (!DisplayName.IsEmpty()) {
        return FText::FromString(DisplayName);
    }
#endif
    return FText::FromString(FName::NameToDisplayString(GetNameStringByIndex(InIndex), false));
}
FText UEnum::GetDisplayNameTextByValue(int64 InValue) const {
    return GetDisplayNameTextByIndex(GetIndexByValue(InValue));
}
bool UEnum::FindDisplayNameTextByValue(FText& Out, int64 InValue) const {
    const int32 Index = GetIndexByValue(InValue);
    if (Index == INDEX_NONE) {
        return false;
    }
    Out = GetDisplayNameTextByIndex(Index);
    return true;
}

FString UEnum::GenerateEnumPrefix() const {
    if (Names.IsEmpty()) {
        return GetName();
    }
    FString Prefix = ShortName(Names[0].Key.ToString());
    for (const TPair<FName, int64>& Entry : Names) {
        const FString Name = ShortName(Entry.Key.ToString());
        int32 Common = 0;
        while (Common < Prefix.Len() && Common < Name.Len() && Prefix[Common] == Name[Common]) {
            ++Common;
        }
        Prefix.LeftInline(Common);
    }
    int32 Underscore = INDEX_NONE;
    if (Prefix.FindLastChar(TCHAR('_'), Underscore) && Underscore > 0) {
        return Prefix.Left(Underscore);
    }
    return GetName();
}
bool UEnum::ContainsExistingMax() const {
    if (GetIndexByName(FName(*GenerateFullEnumName(TEXT("MAX")), FNAME_Find)) != INDEX_NONE &&
        !FName(*GenerateFullEnumName(TEXT("MAX")), FNAME_Find).IsNone()) {
        return true;
    }
    const FName PrefixMax(*GenerateFullEnumName(*(GenerateEnumPrefix() + TEXT("_MAX"))), FNAME_Find);
    return !PrefixMax.IsNone() && GetIndexByName(PrefixMax) != INDEX_NONE;
}
FString UEnum::GenerateFullEnumName(const TCHAR* InEnumName) const {
    return CppForm == ECppForm::Regular || IsFullEnumName(InEnumName) ? FString(InEnumName)
                                                                      : GetName() + TEXT("::") + InEnumName;
}

int64 UEnum::LookupEnumName(FName, FName TestName, UEnum** FoundEnum) {
    UEnum* const* Owner = EnumIndex().ByEntry.Find(TestName);
    if (FoundEnum) {
        *FoundEnum = Owner ? *Owner : nullptr;
    }
    return Owner ? (*Owner)->GetValueByName(TestName) : INDEX_NONE;
}
int64 UEnum::LookupEnumNameSlow(const TCHAR* TestShortName, UEnum** FoundEnum) {
    const int64 Direct = LookupEnumName(NAME_None, FName(TestShortName), FoundEnum);
    if (Direct != INDEX_NONE) {
        return Direct;
    }
    const FString Suffix = FString(TEXT("::")) + TestShortName;
    for (const TPair<FName, UEnum*>& Entry : EnumIndex().ByEntry) {
        if (Entry.Key.ToString().EndsWith(Suffix)) {
            return LookupEnumName(NAME_None, Entry.Key, FoundEnum);
        }
    }
    return INDEX_NONE;
}
int64 UEnum::ParseEnum(const TCHAR*& Str) {
    FString Token;
    while (FChar::IsAlnum(*Str) || *Str == TCHAR('_') || *Str == TCHAR('.') || *Str == TCHAR(':')) {
        Token.AppendChar(*Str++);
    }
    int32 Dot = INDEX_NONE;
    if (Token.FindLastChar(TCHAR('.'), Dot)) {
        UEnum* Enum = FindFirstObject<UEnum>(*Token.Left(Dot));
        return Enum ? Enum->GetValueByNameString(Token.Mid(Dot + 1)) : INDEX_NONE;
    }
    return LookupEnumNameSlow(*Token);
}

#if WITH_METADATA
bool UEnum::HasMetaData(const TCHAR* Key, int32 NameIndex) const {
    if (NameIndex == INDEX_NONE) {
        return UField::HasMetaData(Key);
    }
    return UField::HasMetaData(*(GetNameStringByIndex(NameIndex) + TEXT(".") + Key));
}
FString UEnum::GetMetaData(const TCHAR* Key, int32 NameIndex, bool) const {
    if (NameIndex == INDEX_NONE) {
        return UField::GetMetaData(Key);
    }
    return UField::GetMetaData(*(GetNameStringByIndex(NameIndex) + TEXT(".") + Key));
}
void UEnum::SetMetaData(const TCHAR* Key, const TCHAR* InValue, int32 NameIndex) const {
    UEnum* This = const_cast<UEnum*>(this);
    if (NameIndex == INDEX_NONE) {
        This->UField::SetMetaData(Key, InValue);
    } else {
        This->UField::SetMetaData(*(GetNameStringByIndex(NameIndex) + TEXT(".") + Key), InValue);
    }
}
FText UEnum::GetToolTipTextByIndex(int32 NameIndex) const {
    const FString ToolTip = GetMetaData(TEXT("ToolTip"), NameIndex);
    return ToolTip.IsEmpty() ? GetDisplayNameTextByIndex(NameIndex) : FText::FromString(ToolTip);
}
#endif

namespace UE::CoreUObject::Private {
UEnum* FindEnumOfCppType(const char* TypeName) {
    UEnum* const* Found = EnumIndex().ByCppType.Find(FString(TypeName));
    checkf(Found, TEXT("StaticEnum<%s>: not a UENUM, or its module is not loaded"), *FString(TypeName));
    return *Found;
}
} // namespace UE::CoreUObject::Private
