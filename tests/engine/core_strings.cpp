// SPDX-License-Identifier: MIT
// FString, views, builders, names, texts.
#include "core_test.h"

#include "Misc/Parse.h"

using namespace core_test;

TEST_CASE("Core: FString compares without case, Equals with") {
    CHECK(FString(TEXT("Abc")) == TEXT("aBC"));
    CHECK(!FString(TEXT("Abc")).Equals(TEXT("aBC")));
    CHECK(FString(TEXT("Abc")).Equals(TEXT("aBC"), ESearchCase::IgnoreCase));
    CHECK(FString(TEXT("a")) < FString(TEXT("B")));
    CHECK(FString(TEXT("b")).Compare(TEXT("B")) > 0);
    CHECK(FStringView(TEXT("x")) == FString(TEXT("X")));
    CHECK(GetTypeHash(FString(TEXT("Abc"))) == GetTypeHash(FString(TEXT("aBC"))));
}

TEST_CASE("Core: FString::Printf") {
    CHECK(text(FString::Printf(TEXT("%s %d %5.2f|%-4d|%04x %c %%"), TEXT("ä"), -3, 1.005, 7, 255, TCHAR('q'))) ==
          "ä -3  1.00|7   |00ff q %");
    CHECK(text(FString::Printf(TEXT("%lld %llu %hs %S %5s|%-5s|%.2s"), 1ll << 40, ~0ull, "ansi", "narrow", TEXT("ab"),
              TEXT("cd"), TEXT("efgh"))) == "1099511627776 18446744073709551615 ansi narrow    ab|cd   |ef");
    CHECK(text(FString::Printf(TEXT("%*d"), 5, 42)) == "   42");
    const FString long_text = FString::ChrN(5000, TCHAR('x'));
    CHECK(FString::Printf(TEXT("<%s>"), *long_text).Len() == 5002);
    CHECK(FString::Printf(TEXT("%f"), 1e308).Len() > 300);
    TCHAR small[4];
    CHECK(FCString::Snprintf(small, 4, TEXT("%d"), 12345) == -1);
    CHECK(FCString::Snprintf(small, 4, TEXT("%d"), 123) == 3);
}

TEST_CASE("Core: FString parts and searching") {
    const FString s = TEXT("One,Two,,Three");
    FString left, right;
    CHECK(s.Split(TEXT(","), &left, &right));
    CHECK(text(left) == "One");
    CHECK(text(right) == "Two,,Three");
    CHECK(s.Split(TEXT(","), &left, &right, ESearchCase::IgnoreCase, ESearchDir::FromEnd));
    CHECK(text(right) == "Three");
    CHECK(!s.Split(TEXT(";"), &left, &right));
    TArray<FString> parts;
    CHECK(s.ParseIntoArray(parts, TEXT(",")) == 3);
    CHECK(s.ParseIntoArray(parts, TEXT(","), false) == 4);
    CHECK(text(FString::Join(parts, TEXT("+"))) == "One+Two++Three");
    CHECK(FString(TEXT("a\r\nb\n\nc")).ParseIntoArrayLines(parts, false) == 4);
    CHECK(FString(TEXT("")).ParseIntoArray(parts, TEXT(",")) == 0);
    CHECK(s.Contains(TEXT("two")));
    CHECK(!s.Contains(TEXT("two"), ESearchCase::CaseSensitive));
    CHECK(s.Find(TEXT(",")) == 3);
    CHECK(s.Find(TEXT(","), ESearchCase::IgnoreCase, ESearchDir::FromEnd) == 8);
    CHECK(s.Find(TEXT(","), ESearchCase::IgnoreCase, ESearchDir::FromEnd, 8) == 7);
    CHECK(s.StartsWith(TEXT("one")));
    CHECK(s.EndsWith(TEXT("THREE")));
    CHECK(text(s.Mid(4, 3)) == "Two");
    CHECK(text(s.Left(3)) == "One");
    CHECK(text(s.RightChop(9)) == "Three");
    CHECK(text(s.LeftChop(6)) == "One,Two,");
    CHECK(text(s.Right(100)) == "One,Two,,Three");
    CHECK(text(FString(TEXT("aXbxc")).Replace(TEXT("x"), TEXT("--"))) == "a--b--c");
    CHECK(text(FString(TEXT("aXbxc")).Replace(TEXT("x"), TEXT("--"), ESearchCase::CaseSensitive)) == "aXb--c");
    CHECK(text(FString(TEXT("  t \n")).TrimStartAndEnd()) == "t");
    CHECK(text(FString(TEXT("a")) / TEXT("b") / FString(TEXT("/c"))) == "a/b/c");
    CHECK(FString(TEXT("level_12.umap")).MatchesWildcard(TEXT("*_??.u*")));
    CHECK(!FString(TEXT("level_1.umap")).MatchesWildcard(TEXT("*_??.u*")));
    FString prefix = TEXT("PrefixRest");
    CHECK(prefix.RemoveFromStart(TEXT("prefix")));
    CHECK(text(prefix) == "Rest");
    FString inserted = TEXT("ad");
    inserted.InsertAt(1, TEXT("bc"));
    CHECK(text(inserted) == "abcd");
    inserted.RemoveAt(1, 2);
    CHECK(text(inserted) == "ad");
    inserted += inserted;
    CHECK(text(inserted) == "adad");
}

TEST_CASE("Core: numbers in text") {
    CHECK(text(FString::FromInt(MIN_int32)) == "-2147483648");
    CHECK(text(FString::SanitizeFloat(1.0)) == "1.0");
    CHECK(text(FString::SanitizeFloat(-0.0)) == "0.0");
    CHECK(text(FString::SanitizeFloat(2.500)) == "2.5");
    CHECK(text(FString::SanitizeFloat(3.0, 0)) == "3");
    CHECK(text(FString::FormatAsNumber(-1234567)) == "-1,234,567");
    CHECK(text(LexToString(true)) == "true");
    CHECK(text(LexToString(uint64(~0ull))) == "18446744073709551615");
    CHECK(FCString::Atoi(TEXT("42x")) == 42);
    CHECK(FCString::Atod(TEXT("-1.5e3")) == -1500.0);
    CHECK(FString(TEXT("-1.5")).IsNumeric());
    CHECK(!FString(TEXT("1.5.2")).IsNumeric());
    CHECK(!FString(TEXT("")).IsNumeric());
    CHECK(FString(TEXT("Yes")).ToBool());
    CHECK(!FString(TEXT("0")).ToBool());
    int64 parsed = 0;
    LexFromString(parsed, TEXT("-9000000000"));
    CHECK(parsed == -9000000000ll);
}

TEST_CASE("Core: FString::Format") {
    CHECK(text(FString::Format(TEXT("{0}-{1}-{0}"), {1, TEXT("x")})) == "1-x-1");
    FStringFormatNamedArguments named;
    named.Add(TEXT("who"), TEXT("you"));
    CHECK(text(FString::Format(TEXT("hello {who}, {unknown} `{who}"), named)) == "hello you, {unknown} {who}");
}

TEST_CASE("Core: encodings") {
    const char* utf8 = "z\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80"; // z, a-umlaut, euro, an emoji
    const FString s = UTF8_TO_TCHAR(utf8);
    CHECK(s.Len() == 5);
    CHECK(text(s) == utf8);
    CHECK(std::string(TCHAR_TO_UTF8(*s)) == utf8);
    CHECK(std::string(TCHAR_TO_ANSI(*s)) == "z???");
    // Broken input becomes replacement characters, never an overrun.
    const FString broken = FString::ConstructFromPtrSize(reinterpret_cast<const UTF8CHAR*>("a\xE2\x82"), 3);
    CHECK(broken.Len() >= 2);
    CHECK(broken[1] == TCHAR(0xFFFD));
    const FString overlong = FString::ConstructFromPtrSize(reinterpret_cast<const UTF8CHAR*>("\xC0\x80"), 2);
    CHECK(overlong[0] == TCHAR(0xFFFD));
    const auto cast = StringCast<ANSICHAR>(TEXT("plain"));
    CHECK(std::string(cast.Get(), 5) == "plain");
    CHECK(cast.Length() == 5);
    CHECK(text(FString("ansi")) == "ansi");
    CHECK(text(FString(TEXT("\x00C4pfel")).ToLower()) == "\xC3\xA4pfel");
}

TEST_CASE("Core: string builders") {
    TStringBuilder<8> builder;
    builder << TEXT("a") << 12 << TEXTVIEW("-") << FString(TEXT("long enough for the heap")) << 'c';
    CHECK(text(FString(builder.ToView())) == "a12-long enough for the heapc");
    CHECK(FString(builder.ToString()).Len() == builder.Len());
    builder.Reset();
    builder.Appendf(TEXT("%d"), 3);
    CHECK(text(FString(builder)) == "3");
    CHECK(text(FString(*WriteToString<16>(TEXT("x"), 1, TEXT("y")))) == "x1y");
}

TEST_CASE("Core: names compare without case and keep theirs") {
    const FName a(TEXT("CoreTestName")), b(TEXT("coretestNAME"));
    CHECK(a == b);
    CHECK(text(a) == "CoreTestName");
    CHECK(text(b) == "coretestNAME");
    CHECK(GetTypeHash(a) == GetTypeHash(b));
    CHECK(!a.IsEqual(b, ENameCase::CaseSensitive));
    CHECK(FName() == NAME_None);
    CHECK(text(FName()) == "None");
    CHECK(FName(TEXT("none")).IsNone());
    CHECK(FName(TEXT("")).IsNone());
    CHECK(FName(TEXT("NobodyMadeThisName"), FNAME_Find).IsNone());
    CHECK(FName(TEXT("CORETESTNAME"), FNAME_Find) == a);
}

TEST_CASE("Core: number suffixes of names") {
    const FName plain(TEXT("Actor")), numbered(TEXT("Actor_12"));
    CHECK(numbered.GetNumber() == NAME_EXTERNAL_TO_INTERNAL(12));
    CHECK(text(numbered) == "Actor_12");
    CHECK(text(numbered.GetPlainNameString()) == "Actor");
    CHECK(plain.GetComparisonIndex() == numbered.GetComparisonIndex());
    CHECK(plain != numbered);
    CHECK(numbered == FName(plain, NAME_EXTERNAL_TO_INTERNAL(12)));
    for (const char* odd : {"Actor_01", "_7", "Actor_99999999999", "Actor_", "12"}) {
        const FName name(odd);
        CHECK_MESSAGE(name.GetNumber() == NAME_NO_NUMBER_INTERNAL, odd);
        CHECK(text(name) == odd);
    }
    CHECK(FName(TEXT("Actor_0")).GetNumber() == 1);
    CHECK(FName(TEXT("A_2")).Compare(FName(TEXT("A_10"))) < 0);
    CHECK(FName(TEXT("b")).LexicalLess(FName(TEXT("C"))));
    CHECK(text(FName::NameToDisplayString(TEXT("bHiddenInGame"), true)) == "Hidden In Game");
    CHECK(text(FName::NameToDisplayString(TEXT("MaxHTTPRetries"), false)) == "Max HTTP Retries");
    CHECK(!FName(TEXT("a b")).IsValidXName());
}

TEST_CASE("Core: texts") {
    CHECK(FText().IsEmpty());
    CHECK(text(FText::FromString(TEXT("abc"))) == "abc");
    CHECK(text(FText::AsNumber(1234567)) == "1,234,567");
    CHECK(text(FText::AsNumber(-1234.5678)) == "-1,234.568");
    CHECK(text(FText::AsPercent(0.25)) == "25%");
    CHECK(text(FText::Format(INVTEXT("{0} of {1}"), 3, FText::FromString(TEXT("many")))) == "3 of many");
    FFormatNamedArguments named;
    named.Add(TEXT("Name"), FText::FromString(TEXT("Jo")));
    CHECK(text(FText::Format(INVTEXT("Hi {Name}"), named)) == "Hi Jo");
    const FText shared = FText::FromString(TEXT("same"));
    CHECK(shared.IdenticalTo(FText(shared)));
    CHECK(!shared.IdenticalTo(FText::FromString(TEXT("same"))));
    CHECK(shared.EqualTo(FText::FromString(TEXT("same"))));
}

TEST_CASE("Core: FParse") {
    const TCHAR* line = TEXT("Map1 -Name=\"two words\" -Num=42 -Flag -Dir=/a/b,c -FlagMore Big=1.5");
    FString value;
    CHECK(FParse::Value(line, TEXT("name="), value));
    CHECK(text(value) == "two words");
    int32 number = 0;
    CHECK(FParse::Value(line, TEXT("-Num="), number));
    CHECK(number == 42);
    CHECK(FParse::Param(line, TEXT("flag")));
    CHECK(!FParse::Param(line, TEXT("Fla")));
    CHECK(!FParse::Param(line, TEXT("Num2")));
    CHECK(FParse::Value(line, TEXT("Dir="), value, false));
    CHECK(text(value) == "/a/b,c");
    float big = 0;
    CHECK(FParse::Value(line, TEXT("Big="), big));
    CHECK(big == 1.5f);
    const TCHAR* cursor = TEXT("run \"a b\" c");
    CHECK(FParse::Command(&cursor, TEXT("RUN")));
    FString token;
    CHECK(FParse::Token(cursor, token, false));
    CHECK(text(token) == "a b");
    CHECK(FParse::Token(cursor, token, false));
    CHECK(text(token) == "c");
    CHECK(!FParse::Token(cursor, token, false));
}
