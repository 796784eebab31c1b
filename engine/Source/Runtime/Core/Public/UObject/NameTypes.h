// SPDX-License-Identifier: MIT
/**
 * FName: a name in a global table. Names compare without case and remember the case they were made with; a suffix
 * `_<number>` is kept as a number. The table is never emptied and may be used from any thread.
 */
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/StringBuilder.h"
#include "UObject/UnrealNames.h"

/** External number of a name without number. */
#define NAME_NO_NUMBER_INTERNAL 0
#define NAME_INTERNAL_TO_EXTERNAL(x) ((x) - 1)
#define NAME_EXTERNAL_TO_INTERNAL(x) ((x) + 1)
#define NAME_NO_NUMBER NAME_INTERNAL_TO_EXTERNAL(NAME_NO_NUMBER_INTERNAL)

#define INVALID_NAME_CHARACTERS TEXT("\"' ,\n\r\t")
#define INVALID_OBJECTNAME_CHARACTERS TEXT("\"' ,/.:|&!~\n\r\t@#(){}[]=;^%$`")
#define INVALID_OBJECTPATH_CHARACTERS TEXT("\"' ,|&!~\n\r\t@#(){}[]=;^%$`")
#define INVALID_LONGPACKAGE_CHARACTERS TEXT("\\:*?\"<>|' ,.&!~\n\r\t@#")

enum EFindName {
    /** Only a name that exists; otherwise the result is NAME_None. */
    FNAME_Find,
    /** Make the name if need be. */
    FNAME_Add,
};
enum class ENameCase : uint8 { CaseSensitive, IgnoreCase };

/** Index of a text in the name table. */
struct FNameEntryId {
    constexpr FNameEntryId() : Value(0) {}
    constexpr FNameEntryId(ENoInit) : Value(0) {}
    constexpr explicit FNameEntryId(uint32 InValue) : Value(InValue) {}
    bool IsNone() const { return Value == 0; }
    explicit operator bool() const { return Value != 0; }
    bool operator==(FNameEntryId Other) const { return Value == Other.Value; }
    /** Order of registration: fast, and different from run to run. */
    bool FastLess(FNameEntryId Other) const { return Value < Other.Value; }
    CORE_API int32 CompareLexical(FNameEntryId Other) const;
    bool LexicalLess(FNameEntryId Other) const { return CompareLexical(Other) < 0; }
    uint32 ToUnstableInt() const { return Value; }
    static FNameEntryId FromUnstableInt(uint32 UnstableInt) { return FNameEntryId(UnstableInt); }
    friend uint32 GetTypeHash(FNameEntryId Id) { return Id.Value * 0x9e3779b1u; }

private:
    uint32 Value;
};

class FName {
public:
    constexpr FName() = default;
    FName(ENoInit) {}
    constexpr FName(EName Name) : ComparisonIndex(static_cast<uint32>(Name)), DisplayIndex(static_cast<uint32>(Name)) {}
    constexpr FName(EName Name, int32 InNumber) : FName(Name) { Number = static_cast<uint32>(InNumber); }
    /** The same text with another internal number. */
    FName(const FName& Other, int32 InNumber) : FName(Other) { Number = static_cast<uint32>(InNumber); }
    FName(const TCHAR* Name, EFindName FindType = FNAME_Add) : FName(FStringView(Name), FindType) {}
    FName(const ANSICHAR* Name, EFindName FindType = FNAME_Add) : FName(FString(Name), FindType) {}
    FName(const UTF8CHAR* Name, EFindName FindType = FNAME_Add) : FName(FString(Name), FindType) {}
    FName(int32 Len, const TCHAR* Name, EFindName FindType = FNAME_Add) : FName(FStringView(Name, Len), FindType) {}
    explicit FName(const FString& Name, EFindName FindType = FNAME_Add) : FName(FStringView(Name), FindType) {}
    explicit CORE_API FName(FStringView View, EFindName FindType = FNAME_Add);
    explicit FName(FAnsiStringView View, EFindName FindType = FNAME_Add) : FName(FString(View), FindType) {}
    /** The text as it is, with that internal number; nothing is split off. */
    CORE_API FName(FStringView View, int32 InNumber);
    FName(const TCHAR* Name, int32 InNumber) : FName(FStringView(Name), InNumber) {}
    FName(const ANSICHAR* Name, int32 InNumber) : FName(FStringView(FString(Name)), InNumber) {}

    FNameEntryId GetComparisonIndex() const { return ComparisonIndex; }
    FNameEntryId GetDisplayIndex() const { return DisplayIndex; }
    int32 GetNumber() const { return static_cast<int32>(Number); }
    void SetNumber(int32 NewNumber) { Number = static_cast<uint32>(NewNumber); }

    CORE_API FString ToString() const;
    void ToString(FString& Out) const { Out = ToString(); }
    void AppendString(FString& Out) const { Out += ToString(); }
    void AppendString(FStringBuilderBase& Out) const { Out << ToString(); }
    void ToString(FStringBuilderBase& Out) const {
        Out.Reset();
        AppendString(Out);
    }
    /** The text without number. */
    CORE_API FString GetPlainNameString() const;
    uint32 GetStringLength() const { return static_cast<uint32>(ToString().Len()); }

    bool IsNone() const { return ComparisonIndex.IsNone() && Number == NAME_NO_NUMBER_INTERNAL; }
    bool IsValid() const { return true; }
    bool IsValidIndexFast() const { return true; }
    /** Has the name none of those characters? */
    CORE_API bool IsValidXName(const FString& InvalidChars = INVALID_NAME_CHARACTERS, FText* OutReason = nullptr,
        const FText* InErrorCtx = nullptr) const;
    static CORE_API bool IsValidXName(const FString& InName, const FString& InInvalidChars, FText* OutReason = nullptr,
        const FText* InErrorCtx = nullptr);
    bool IsValidObjectName(FText& OutReason) const { return IsValidXName(INVALID_OBJECTNAME_CHARACTERS, &OutReason); }

    bool operator==(const FName& Other) const {
        return ComparisonIndex == Other.ComparisonIndex && Number == Other.Number;
    }
    bool operator==(EName Name) const { return *this == FName(Name); }
    bool operator==(const TCHAR* Other) const { return ToString() == Other; }
    bool operator==(const ANSICHAR* Other) const { return ToString() == FString(Other); }
    CORE_API bool IsEqual(
        const FName& Other, ENameCase CompareMethod = ENameCase::IgnoreCase, bool bCompareNumber = true) const;
    /** Alphabetical without case, then by number. */
    CORE_API int32 Compare(const FName& Other) const;
    int32 CompareIndexes(const FName& Other) const { return FastLess(Other) ? -1 : (*this == Other ? 0 : 1); }
    bool LexicalLess(const FName& Other) const { return Compare(Other) < 0; }
    bool FastLess(const FName& Other) const {
        return ComparisonIndex == Other.ComparisonIndex ? Number < Other.Number
                                                        : ComparisonIndex.FastLess(Other.ComparisonIndex);
    }
    uint64 ToUnstableInt() const { return (static_cast<uint64>(Number) << 32) | ComparisonIndex.ToUnstableInt(); }
    /** "bMyFlag" to "My Flag", as property names are shown to people. */
    static CORE_API FString NameToDisplayString(const FString& InDisplayName, const bool bIsBool);
    /** Names in the table. */
    static CORE_API int32 GetNumNames();

    friend uint32 GetTypeHash(const FName& Name) { return GetTypeHash(Name.ComparisonIndex) + Name.Number; }
    friend FStringBuilderBase& operator<<(FStringBuilderBase& Builder, const FName& Name) {
        return Builder << Name.ToString();
    }

private:
    FNameEntryId ComparisonIndex;
    uint32 Number = NAME_NO_NUMBER_INTERNAL;
    FNameEntryId DisplayIndex;
};
static_assert(sizeof(FName) == 12);

inline FString LexToString(const FName& Name) { return Name.ToString(); }
inline void LexFromString(FName& Name, const TCHAR* Str) { Name = FName(Str); }

/** Order for sorted lists that people see. */
struct FNameLexicalLess {
    bool operator()(const FName& A, const FName& B) const { return A.LexicalLess(B); }
    bool operator()(FNameEntryId A, FNameEntryId B) const { return A.LexicalLess(B); }
};
/** Fast order, different from run to run. */
struct FNameFastLess {
    bool operator()(const FName& A, const FName& B) const { return A.FastLess(B); }
    bool operator()(FNameEntryId A, FNameEntryId B) const { return A.FastLess(B); }
};
