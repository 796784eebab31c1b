// SPDX-License-Identifier: MIT
#include "Kismet/KismetStringLibrary.h"

#include <cmath>

// Building and comparing

FString UKismetStringLibrary::Concat_StrStr(const FString& A, const FString& B) { return A + B; }

FString UKismetStringLibrary::BuildString_Double(
    const FString& AppendTo, const FString& Prefix, double InDouble, const FString& Suffix) {
    return AppendTo + Prefix + Conv_DoubleToString(InDouble) + Suffix;
}

FString UKismetStringLibrary::BuildString_Int(
    const FString& AppendTo, const FString& Prefix, int32 InInt, const FString& Suffix) {
    return AppendTo + Prefix + Conv_IntToString(InInt) + Suffix;
}

FString UKismetStringLibrary::BuildString_Bool(
    const FString& AppendTo, const FString& Prefix, bool InBool, const FString& Suffix) {
    return AppendTo + Prefix + Conv_BoolToString(InBool) + Suffix;
}

FString UKismetStringLibrary::BuildString_Vector(
    const FString& AppendTo, const FString& Prefix, FVector InVector, const FString& Suffix) {
    return AppendTo + Prefix + Conv_VectorToString(InVector) + Suffix;
}

FString UKismetStringLibrary::BuildString_Rotator(
    const FString& AppendTo, const FString& Prefix, FRotator InRot, const FString& Suffix) {
    return AppendTo + Prefix + Conv_RotatorToString(InRot) + Suffix;
}

FString UKismetStringLibrary::BuildString_Object(
    const FString& AppendTo, const FString& Prefix, UObject* InObj, const FString& Suffix) {
    return AppendTo + Prefix + Conv_ObjectToString(InObj) + Suffix;
}

FString UKismetStringLibrary::BuildString_Color(
    const FString& AppendTo, const FString& Prefix, FLinearColor InColor, const FString& Suffix) {
    return AppendTo + Prefix + Conv_ColorToString(InColor) + Suffix;
}

FString UKismetStringLibrary::BuildString_Name(
    const FString& AppendTo, const FString& Prefix, const FName& InName, const FString& Suffix) {
    return AppendTo + Prefix + Conv_NameToString(InName) + Suffix;
}

bool UKismetStringLibrary::EqualEqual_StriStri(const FString& A, const FString& B) {
    return A.Equals(B, ESearchCase::IgnoreCase);
}

bool UKismetStringLibrary::EqualEqual_StrStr(const FString& A, const FString& B) {
    return A.Equals(B, ESearchCase::CaseSensitive);
}

bool UKismetStringLibrary::NotEqual_StriStri(const FString& A, const FString& B) {
    return !A.Equals(B, ESearchCase::IgnoreCase);
}

bool UKismetStringLibrary::NotEqual_StrStr(const FString& A, const FString& B) {
    return !A.Equals(B, ESearchCase::CaseSensitive);
}

int32 UKismetStringLibrary::Len(const FString& S) { return S.Len(); }

bool UKismetStringLibrary::IsEmpty(const FString& InString) { return InString.IsEmpty(); }

// Searching

FString UKismetStringLibrary::GetSubstring(const FString& SourceString, int32 StartIndex, int32 Length) {
    return StartIndex >= 0 && Length > 0 && StartIndex < SourceString.Len() ? SourceString.Mid(StartIndex, Length)
                                                                            : FString();
}

int32 UKismetStringLibrary::FindSubstring(
    const FString& SearchIn, const FString& Substring, bool bUseCase, bool bSearchFromEnd, int32 StartPosition) {
    return SearchIn.Find(Substring, bUseCase ? ESearchCase::CaseSensitive : ESearchCase::IgnoreCase,
        bSearchFromEnd ? ESearchDir::FromEnd : ESearchDir::FromStart, StartPosition);
}

bool UKismetStringLibrary::Contains(
    const FString& SearchIn, const FString& Substring, bool bUseCase, bool bSearchFromEnd) {
    return SearchIn.Contains(Substring, bUseCase ? ESearchCase::CaseSensitive : ESearchCase::IgnoreCase,
        bSearchFromEnd ? ESearchDir::FromEnd : ESearchDir::FromStart);
}

int32 UKismetStringLibrary::GetCharacterAsNumber(const FString& SourceString, int32 Index) {
    return Index >= 0 && Index < SourceString.Len() ? static_cast<int32>(SourceString[Index]) : 0;
}

bool UKismetStringLibrary::StartsWith(
    const FString& SourceString, const FString& InPrefix, ESearchCase::Type SearchCase) {
    return SourceString.StartsWith(InPrefix, SearchCase);
}

bool UKismetStringLibrary::EndsWith(
    const FString& SourceString, const FString& InSuffix, ESearchCase::Type SearchCase) {
    return SourceString.EndsWith(InSuffix, SearchCase);
}

bool UKismetStringLibrary::MatchesWildcard(
    const FString& SourceString, const FString& Wildcard, ESearchCase::Type SearchCase) {
    return SourceString.MatchesWildcard(Wildcard, SearchCase);
}

bool UKismetStringLibrary::IsNumeric(const FString& SourceString) { return SourceString.IsNumeric(); }

// Changing

TArray<FString> UKismetStringLibrary::ParseIntoArray(
    const FString& SourceString, const FString& Delimiter, const bool CullEmptyStrings) {
    TArray<FString> Parts;
    SourceString.ParseIntoArray(Parts, *Delimiter, CullEmptyStrings);
    return Parts;
}

FString UKismetStringLibrary::JoinStringArray(const TArray<FString>& SourceArray, const FString& Separator) {
    return FString::Join(SourceArray, *Separator);
}

TArray<FString> UKismetStringLibrary::GetCharacterArrayFromString(const FString& SourceString) {
    TArray<FString> Characters;
    for (int32 Index = 0; Index < SourceString.Len(); ++Index) {
        Characters.Add(SourceString.Mid(Index, 1));
    }
    return Characters;
}

FString UKismetStringLibrary::ToUpper(const FString& SourceString) { return SourceString.ToUpper(); }

FString UKismetStringLibrary::ToLower(const FString& SourceString) { return SourceString.ToLower(); }

FString UKismetStringLibrary::LeftPad(const FString& SourceString, int32 ChCount) {
    return SourceString.LeftPad(ChCount);
}

FString UKismetStringLibrary::RightPad(const FString& SourceString, int32 ChCount) {
    return SourceString.RightPad(ChCount);
}

FString UKismetStringLibrary::Trim(const FString& SourceString) { return SourceString.TrimStart(); }

FString UKismetStringLibrary::TrimTrailing(const FString& SourceString) { return SourceString.TrimEnd(); }

FString UKismetStringLibrary::Reverse(const FString& SourceString) { return SourceString.Reverse(); }

FString UKismetStringLibrary::Replace(
    const FString& SourceString, const FString& From, const FString& To, ESearchCase::Type SearchCase) {
    return SourceString.Replace(*From, *To, SearchCase);
}

bool UKismetStringLibrary::Split(const FString& SourceString, const FString& InStr, FString& LeftS, FString& RightS,
    ESearchCase::Type SearchCase, ESearchDir::Type SearchDir) {
    return SourceString.Split(InStr, &LeftS, &RightS, SearchCase, SearchDir);
}

FString UKismetStringLibrary::Left(const FString& SourceString, int32 Count) { return SourceString.Left(Count); }

FString UKismetStringLibrary::LeftChop(const FString& SourceString, int32 Count) {
    return SourceString.LeftChop(Count);
}

FString UKismetStringLibrary::Right(const FString& SourceString, int32 Count) { return SourceString.Right(Count); }

FString UKismetStringLibrary::RightChop(const FString& SourceString, int32 Count) {
    return SourceString.RightChop(Count);
}

FString UKismetStringLibrary::Mid(const FString& SourceString, int32 Start, int32 Count) {
    return SourceString.Mid(Start, Count);
}

FString UKismetStringLibrary::TimeSecondsToString(float InSeconds) {
    const TCHAR* const Sign = InSeconds < 0.0f ? TEXT("-") : TEXT("");
    const int64 Hundredths = static_cast<int64>(std::fabs(static_cast<double>(InSeconds)) * 100.0);
    return FString::Printf(TEXT("%s%02d:%02d.%02d"), Sign, static_cast<int32>(Hundredths / 6000),
        static_cast<int32>(Hundredths / 100 % 60), static_cast<int32>(Hundredths % 100));
}
