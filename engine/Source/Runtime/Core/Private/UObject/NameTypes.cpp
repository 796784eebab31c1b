// SPDX-License-Identifier: MIT
// The name table. Texts are kept for ever in fixed blocks, so that reading a text by its index needs no lock.
#include "UObject/NameTypes.h"

#include <atomic>
#include <mutex>
#include <new>
#include <shared_mutex>
#include <string_view>
#include <unordered_map>

#include "Internationalization/Text.h"

namespace {
struct FNameEntry {
    /** Entry of the text that differs at most by case and was there first. */
    uint32 ComparisonId;
    int32 Length;
    const TCHAR* Text;
};

struct FCaseSensitiveHash {
    size_t operator()(FStringView View) const {
        return std::hash<std::u16string_view>()(std::u16string_view(View.GetData(), static_cast<size_t>(View.Len())));
    }
};
struct FCaseSensitiveEqual {
    bool operator()(FStringView A, FStringView B) const { return A.Equals(B, ESearchCase::CaseSensitive); }
};
struct FIgnoreCaseHash {
    size_t operator()(FStringView View) const { return GetTypeHash(View); }
};
struct FIgnoreCaseEqual {
    bool operator()(FStringView A, FStringView B) const { return A.Equals(B, ESearchCase::IgnoreCase); }
};

class FNamePool {
public:
    static FNamePool& Get() {
        // Never destroyed: names are used until the last static destructor has run.
        static FNamePool& Pool = *new FNamePool();
        return Pool;
    }

    const FNameEntry& Entry(uint32 Id) const {
        checkf(Id < NumEntries.load(std::memory_order_acquire), TEXT("Invalid name index %u"), Id);
        return Blocks[Id / BlockSize].load(std::memory_order_acquire)[Id % BlockSize];
    }
    int32 Num() const { return static_cast<int32>(NumEntries.load(std::memory_order_acquire)); }

    /** Finds or makes the text; false if it is not there and is not to be made. */
    bool Find(FStringView Text, EFindName FindType, uint32& OutDisplay, uint32& OutComparison) {
        {
            std::shared_lock<std::shared_mutex> Lock(Mutex);
            if (const auto It = ByText.find(Text); It != ByText.end()) {
                OutDisplay = It->second;
                OutComparison = Entry(OutDisplay).ComparisonId;
                return true;
            }
            if (FindType == FNAME_Find) {
                // Some other case of the name will do.
                const auto It = ByFoldedText.find(Text);
                if (It == ByFoldedText.end()) {
                    return false;
                }
                OutDisplay = OutComparison = It->second;
                return true;
            }
        }
        std::unique_lock<std::shared_mutex> Lock(Mutex);
        if (const auto It = ByText.find(Text); It != ByText.end()) {
            OutDisplay = It->second;
        } else {
            OutDisplay = Add(Text);
        }
        OutComparison = Entry(OutDisplay).ComparisonId;
        return true;
    }

private:
    static constexpr uint32 BlockSize = 4096;
    static constexpr uint32 MaxBlocks = 16384;

    FNamePool() {
        const uint32 None = Add(TEXTVIEW("None"));
        check(None == 0);
    }
    uint32 Add(FStringView Text) {
        const uint32 Id = NumEntries.load(std::memory_order_relaxed);
        const uint32 Block = Id / BlockSize;
        checkf(Block < MaxBlocks, TEXT("The name table is full (%u names)"), Id);
        if (Id % BlockSize == 0) {
            Blocks[Block].store(new FNameEntry[BlockSize], std::memory_order_release);
        }
        const SIZE_T Size = static_cast<SIZE_T>(Text.Len());
        TCHAR* Copy = static_cast<TCHAR*>(FMemory::Malloc((Size + 1) * sizeof(TCHAR)));
        FMemory::Memcpy(Copy, Text.GetData(), Size * sizeof(TCHAR));
        Copy[Size] = 0;
        const FStringView Kept(Copy, Text.Len());
        const uint32 ComparisonId = ByFoldedText.try_emplace(Kept, Id).first->second;
        Blocks[Block].load(std::memory_order_relaxed)[Id % BlockSize] = {ComparisonId, Text.Len(), Copy};
        ByText.emplace(Kept, Id);
        NumEntries.store(Id + 1, std::memory_order_release);
        return Id;
    }

    std::shared_mutex Mutex;
    std::unordered_map<FStringView, uint32, FCaseSensitiveHash, FCaseSensitiveEqual> ByText;
    std::unordered_map<FStringView, uint32, FIgnoreCaseHash, FIgnoreCaseEqual> ByFoldedText;
    std::atomic<FNameEntry*> Blocks[MaxBlocks] = {};
    std::atomic<uint32> NumEntries{0};
};

FStringView TextOf(FNameEntryId Id) {
    const FNameEntry& Entry = FNamePool::Get().Entry(Id.ToUnstableInt());
    return FStringView(Entry.Text, Entry.Length);
}

/** Splits "Name_12" into "Name" and internal number 13; numbers with leading zeros belong to the text. */
int32 SplitNumber(FStringView& Text) {
    int32 Digits = 0;
    while (Digits < Text.Len() && FChar::IsDigit(Text[Text.Len() - 1 - Digits])) {
        ++Digits;
    }
    const int32 Underscore = Text.Len() - Digits - 1;
    if (Digits == 0 || Digits > 10 || Underscore < 1 || Text[Underscore] != TCHAR('_') ||
        (Digits > 1 && Text[Underscore + 1] == TCHAR('0'))) {
        return NAME_NO_NUMBER_INTERNAL;
    }
    int64 Number = 0;
    for (int32 Index = Underscore + 1; Index < Text.Len(); ++Index) {
        Number = Number * 10 + FChar::ConvertCharDigitToInt(Text[Index]);
    }
    if (Number >= MAX_int32) {
        return NAME_NO_NUMBER_INTERNAL;
    }
    Text = Text.Left(Underscore);
    return NAME_EXTERNAL_TO_INTERNAL(static_cast<int32>(Number));
}
} // namespace

int32 FNameEntryId::CompareLexical(FNameEntryId Other) const {
    return Value == Other.Value ? 0 : TextOf(*this).Compare(TextOf(Other), ESearchCase::IgnoreCase);
}

FName::FName(FStringView View, EFindName FindType) {
    if (View.IsEmpty()) {
        return;
    }
    checkf(
        View.Len() < NAME_SIZE, TEXT("FName's %d max length exceeded. Got %d characters"), NAME_SIZE - 1, View.Len());
    const int32 SplitOff = SplitNumber(View);
    uint32 Display = 0;
    uint32 Comparison = 0;
    if (FNamePool::Get().Find(View, FindType, Display, Comparison)) {
        ComparisonIndex = FNameEntryId(Comparison);
        DisplayIndex = FNameEntryId(Display);
        Number = static_cast<uint32>(SplitOff);
    }
}

FName::FName(FStringView View, int32 InNumber) {
    if (View.IsEmpty()) {
        return;
    }
    checkf(
        View.Len() < NAME_SIZE, TEXT("FName's %d max length exceeded. Got %d characters"), NAME_SIZE - 1, View.Len());
    uint32 Display = 0;
    uint32 Comparison = 0;
    FNamePool::Get().Find(View, FNAME_Add, Display, Comparison);
    ComparisonIndex = FNameEntryId(Comparison);
    DisplayIndex = FNameEntryId(Display);
    Number = static_cast<uint32>(InNumber);
}

FString FName::ToString() const {
    FString Result(TextOf(DisplayIndex), Number == NAME_NO_NUMBER_INTERNAL ? 0 : 12);
    if (Number != NAME_NO_NUMBER_INTERNAL) {
        Result.AppendChar(TCHAR('_'));
        Result.AppendInt(NAME_INTERNAL_TO_EXTERNAL(static_cast<int32>(Number)));
    }
    return Result;
}

FString FName::GetPlainNameString() const { return FString(TextOf(DisplayIndex)); }

bool FName::IsEqual(const FName& Other, ENameCase CompareMethod, bool bCompareNumber) const {
    const bool bSameText = CompareMethod == ENameCase::IgnoreCase ? ComparisonIndex == Other.ComparisonIndex
                                                                  : DisplayIndex == Other.DisplayIndex;
    return bSameText && (!bCompareNumber || Number == Other.Number);
}

int32 FName::Compare(const FName& Other) const {
    const int32 Result = ComparisonIndex.CompareLexical(Other.ComparisonIndex);
    if (Result != 0) {
        return Result;
    }
    return Number == Other.Number ? 0 : (GetNumber() < Other.GetNumber() ? -1 : 1);
}

int32 FName::GetNumNames() { return FNamePool::Get().Num(); }

bool FName::IsValidXName(const FString& InvalidChars, FText* OutReason, const FText* InErrorCtx) const {
    return IsValidXName(ToString(), InvalidChars, OutReason, InErrorCtx);
}

bool FName::IsValidXName(
    const FString& InName, const FString& InInvalidChars, FText* OutReason, const FText* InErrorCtx) {
    FString Found;
    for (const TCHAR Char : InName) {
        int32 Index;
        if (InInvalidChars.FindChar(Char, Index) && !Found.FindChar(Char, Index)) {
            Found.AppendChar(Char);
        }
    }
    if (Found.IsEmpty()) {
        return true;
    }
    if (OutReason) {
        const FString Context = InErrorCtx ? InErrorCtx->ToString() : FString(TEXT("Name"));
        *OutReason = FText::FromString(
            FString::Printf(TEXT("%s may not contain the following characters: '%s'"), *Context, *Found));
    }
    return false;
}

FString FName::NameToDisplayString(const FString& InDisplayName, const bool bIsBool) {
    // A blank before each capital that begins a word, and none within an abbreviation; "bFlag" loses its b.
    FString Result;
    const FString& Name = InDisplayName;
    int32 Start = 0;
    if (bIsBool && Name.Len() > 1 && Name[0] == TCHAR('b') && FChar::IsUpper(Name[1])) {
        Start = 1;
    }
    for (int32 Index = Start; Index < Name.Len(); ++Index) {
        TCHAR Char = Name[Index];
        const TCHAR Previous = Index > Start ? Name[Index - 1] : TCHAR(0);
        const TCHAR Next = Index + 1 < Name.Len() ? Name[Index + 1] : TCHAR(0);
        if (Char == TCHAR('_')) {
            if (!Result.IsEmpty() && !Result.EndsWith(TEXT(" "))) {
                Result.AppendChar(TCHAR(' '));
            }
            continue;
        }
        const bool bBeginsWord = (FChar::IsUpper(Char) && (FChar::IsLower(Previous) || FChar::IsDigit(Previous) ||
                                                              (FChar::IsUpper(Previous) && FChar::IsLower(Next)))) ||
                                 (FChar::IsDigit(Char) && FChar::IsLower(Previous));
        if (bBeginsWord && !Result.IsEmpty() && !Result.EndsWith(TEXT(" "))) {
            Result.AppendChar(TCHAR(' '));
        }
        if (Result.IsEmpty()) {
            Char = FChar::ToUpper(Char);
        }
        Result.AppendChar(Char);
    }
    return Result;
}
