# SPDX-License-Identifier: MIT
"""Each rule of --strict: what Unreal's header tool rejects is an error with file, line and reason; the same header is fine after the repair."""

from __future__ import annotations

import pytest
from header_tool_runs import Dump

HEAD = '#pragma once\n#include "UObject/Object.h"\n#include "Test.generated.h"\n'


def in_class(members: str, specifiers: str = "") -> str:
    return f"{HEAD}UCLASS({specifiers})\nclass UTest : public UObject\n{{\n\tGENERATED_BODY()\npublic:\n{members}\n}};\n"


def in_struct(members: str) -> str:
    return f"{HEAD}USTRUCT(BlueprintType)\nstruct FTest\n{{\n\tGENERATED_BODY()\n{members}\n}};\n"


# rule, line of the error, header text (members of in_class start on line 9, of in_struct on line 8)
CASES = [
    ("nested-container", 9, in_class("UPROPERTY() TArray<TArray<int32>> X;")),
    ("nested-container", 9, in_class("UPROPERTY() TMap<FName, TArray<int32>> X;")),
    ("nested-container", 9, in_class("UFUNCTION() void F(const TMap<int32, TSet<int32>>& X);")),
    ("overloaded-function", 10, in_class("UFUNCTION() void F();\nUFUNCTION() void F(int32 X);")),
    ("overloaded-function", 10, in_class("UFUNCTION() void Same();\nUFUNCTION() void SAME();")),
    ("namespaced-type", 5, f"{HEAD}namespace N {{\nUSTRUCT() struct FTest {{ GENERATED_BODY() }};\n}}\n"),
    ("namespaced-type", 4, f"{HEAD}namespace N {{ UENUM() enum class E : uint8 {{ A }}; }}\n"),
    ("namespaced-type", 4, f"{HEAD}namespace N {{ DECLARE_DYNAMIC_DELEGATE(FFoo); }}\n"),
    ("unsupported-blueprint-type", 9, in_class("UFUNCTION(BlueprintCallable) void F(uint32 X);")),
    ("unsupported-blueprint-type", 9, in_class("UFUNCTION(BlueprintPure) uint16 F() const;")),
    ("unsupported-blueprint-type", 9, in_class("UFUNCTION(BlueprintImplementableEvent) void F(const TArray<int8>& X);")),
    ("unsupported-blueprint-type", 9, in_class("UPROPERTY(BlueprintReadWrite) uint64 X;")),
    ("unsupported-blueprint-type", 9, in_class("UPROPERTY(BlueprintReadOnly) int32 X[3];")),
    ("unsupported-blueprint-type", 9, in_class("UPROPERTY(BlueprintAssignable) int32 X;")),
    ("arbitrary-condition", 10, in_class("#if PLATFORM_LINUX\nUPROPERTY() int32 X;\n#endif")),
    ("arbitrary-condition", 10, in_class("#ifndef SOMETHING\nUFUNCTION() void F();\n#endif")),
    ("generated-include-last", 4, f'{HEAD}#include "Late.h"\nUSTRUCT() struct FTest {{ GENERATED_BODY() }};\n'),
    ("generated-include-last", 1, '#include "Other.generated.h"\nUSTRUCT() struct FTest { GENERATED_BODY() };\n'),
    ("no-generated-include", 1, "USTRUCT() struct FTest { GENERATED_BODY() };\n"),
    ("missing-generated-body", 5, f"{HEAD}USTRUCT()\nstruct FTest {{ int32 X; }};\n"),
    ("missing-generated-body", 5, f"{HEAD}UCLASS()\nclass UTest : public UObject {{ }};\n"),
    ("unnamed-parameter", 9, in_class("UFUNCTION() void F(int32);")),
    ("template-type", 9, in_class("UFUNCTION() template <class T> void F(T X);")),
    ("private-blueprint-property", 10, in_class("private:\nUPROPERTY(BlueprintReadWrite) int32 X;")),
    ("private-blueprint-property", 10, in_class("private:\nUFUNCTION(BlueprintNativeEvent) void F();")),
    ("enum-underlying", 4, f"{HEAD}UENUM(BlueprintType) enum class E : uint16 {{ A }};\n"),
    ("enum-underlying", 4, f"{HEAD}UENUM(BlueprintType) enum class E {{ A }};\n"),
    ("enum-value", 4, f"{HEAD}UENUM() enum class E : uint8 {{ A = Unknown::B }};\n"),
    ("raw-enum-member", 5, f"{HEAD}UENUM() enum EPlain {{ Plain_A }};\nUSTRUCT() struct FTest {{ GENERATED_BODY() UPROPERTY() EPlain X; }};\n"),
    ("nested-type", 9, in_class("USTRUCT() struct FInner { GENERATED_BODY() };")),
    ("nested-type", 4, f"{HEAD}class FPlain {{ UPROPERTY() int32 X; }};\n"),
    ("static-property", 9, in_class("UPROPERTY() static int32 X;")),
    ("const-property", 9, in_class("UPROPERTY() const int32 X = 1;")),
    ("unsupported-type", 9, in_class("UPROPERTY() int32& X;")),
    ("unsupported-type", 9, in_class("UPROPERTY() TSharedPtr<int32> X;")),
    ("unsupported-type", 9, in_class("UPROPERTY() TVariant<int32, float> X;")),
    ("unsupported-type", 9, in_class("UPROPERTY() FVerseFunction X;")),
    ("container-allocator", 9, in_class("UPROPERTY() TArray<int32, TInlineAllocator<4>> X;")),
    ("container-allocator", 9, in_class("UFUNCTION() void F(const TMap<int32, float, FOtherAllocator>& X);")),
    ("unsupported-type", 9, in_class("UPROPERTY() FVector* X;")),
    ("unsupported-type", 9, in_class("UPROPERTY() int32** X;")),
    ("unsupported-type", 9, in_class("UFUNCTION() void F(int32 X[3]);")),
    ("unsupported-type", 9, in_class("UFUNCTION() void F(FString&& X);")),
    ("unsupported-type", 9, in_class("UFUNCTION() std::string F();")),
    ("unsupported-type", 8, in_struct("UPROPERTY() int32 X[2][2];")),
    (
        "interface-property",
        5,
        f"{HEAD}UINTERFACE() class UI : public UInterface {{ GENERATED_BODY() }};\nclass II {{ GENERATED_BODY() UPROPERTY() int32 X; }};\n",
    ),
    ("missing-body", 4, f"{HEAD}UINTERFACE() class UI : public UInterface {{ GENERATED_BODY() }};\n"),
    ("missing-body", 5, f"{HEAD}UCLASS()\nclass UTest {{ GENERATED_BODY() }};\n"),
    ("delegate-parameter-count", 4, f"{HEAD}DECLARE_DYNAMIC_DELEGATE_TwoParams(FFoo, int32, A);\n"),
    ("delegate-parameter-count", 4, f"{HEAD}DECLARE_DYNAMIC_DELEGATE(FFoo, int32, A);\n"),
    ("function-name", 9, in_class("UFUNCTION(BlueprintImplementableEvent) void F() {}")),
    ("function-name", 9, in_class("UFUNCTION(BlueprintNativeEvent) virtual void F();")),
    ("config-without-class-config", 11, f'{HEAD}UCLASS(NoExport)\nclass UObject {{ }};\n' + in_class("UPROPERTY(Config) int32 X;").replace(HEAD, "")),
    ("missing-rep-notify", 11, f"{HEAD}UCLASS(NoExport)\nclass UObject {{ }};\n" + in_class("UPROPERTY(ReplicatedUsing=OnRep_X) int32 X;").replace(HEAD, "")),
    ("missing-accessor", 11, f"{HEAD}UCLASS(NoExport)\nclass UObject {{ }};\n" + in_class("UPROPERTY(BlueprintGetter=GetX) int32 X;").replace(HEAD, "")),
    ("prefix", 5, f"{HEAD}UCLASS()\nclass Test : public UObject {{ GENERATED_BODY() }};\n"),
    ("prefix", 5, f"{HEAD}USTRUCT()\nstruct Test {{ GENERATED_BODY() }};\n"),
    ("prefix", 4, f"{HEAD}DECLARE_DYNAMIC_DELEGATE(Bar);\n"),
    ("unknown-specifier", 9, in_class("UPROPERTY(EditEverywhere) int32 X;")),
    ("unknown-specifier", 9, in_class("UFUNCTION(BlueprintCallabel) void F();")),
    ("unknown-specifier", 4, f"{HEAD}UCLASS(Abstrakt)\nclass UTest : public UObject {{ GENERATED_BODY() }};\n"),
    ("duplicate-name", 10, in_class("UPROPERTY() int32 X;\nUPROPERTY() int32 x;")),
    ("duplicate-name", 10, in_class("UFUNCTION() void Foo();\nUPROPERTY() int32 Foo;")),
    ("duplicate-name", 5, f"{HEAD}USTRUCT() struct FTest {{ GENERATED_BODY() }};\nUSTRUCT() struct FTest {{ GENERATED_BODY() }};\n"),
    ("duplicate-name", 4, f"{HEAD}UENUM() enum class E : uint8 {{ Aa, AA }};\n"),
    ("default-argument", 9, in_class("UFUNCTION() void F(int32 X = Compute());")),
    ("orphan-macro", 4, f"{HEAD}UPROPERTY() int32 X;\n"),
    ("orphan-macro", 8, in_struct("UFUNCTION() void F();")),
    ("orphan-macro", 4, f"{HEAD}class IFoo {{ GENERATED_BODY() UFUNCTION() void F(); }};\n"),
    ("unparsed-declaration", 9, in_class("UPROPERTY()")),
    ("unparsed-declaration", 9, in_class("UFUNCTION() int32 X;")),
    ("unparsed-declaration", 4, f"{HEAD}UCLASS() struct FTest {{ }};\n"),
    ("unresolved-type", 11, f"{HEAD}UCLASS(NoExport)\nclass UObject {{ }};\n" + in_class("UPROPERTY() FVektor X;").replace(HEAD, "")),
    ("unresolved-super", 5, f"{HEAD}UCLASS(NoExport) class UObject {{ }};\nUCLASS() class UTest : public UMissing {{ GENERATED_BODY() }};\n"),
]


@pytest.mark.parametrize(("rule", "line", "text"), CASES, ids=[f"{rule}-{i}" for i, (rule, _, _) in enumerate(CASES)])
def test_rule_is_an_error_in_strict_mode(dump: Dump, rule: str, line: int, text: str) -> None:
    result = dump({"Test.h": text}, "--strict")
    assert result.code == 1, result.errors
    assert result.schema is None, "nothing is written when there are errors"
    assert f"Public/Test.h:{line}: error:" in result.errors and f"[{rule}]" in result.errors, result.errors
    assert (rule, line) in result.rules()


@pytest.mark.parametrize(("rule", "line", "text"), CASES, ids=[f"{rule}-{i}" for i, (rule, _, _) in enumerate(CASES)])
def test_one_bad_declaration_never_fails_a_lenient_run(dump: Dump, rule: str, line: int, text: str) -> None:
    good = f"{HEAD}USTRUCT() struct FGood {{ GENERATED_BODY() UPROPERTY() int32 Value; }};\n".replace("Test.generated", "Good.generated")
    result = dump({"Test.h": text, "Good.h": good})
    assert result.code == 0, result.errors
    assert result.property("structs", "FGood", "Value")["type"]["kind"] == "int32"
    if rule not in ("unresolved-type", "unresolved-super"):  # notes of another name there
        assert (rule, line) in result.rules(), "the skipped or doubtful declaration has to be in the report"


GOOD = [
    in_class("UPROPERTY(BlueprintReadWrite, meta=(AllowPrivateAccess=\"true\")) uint8 bFlag : 1;"),
    in_class("#if WITH_EDITORONLY_DATA\nUPROPERTY() int32 X;\n#endif\n#if WITH_EDITOR\nUFUNCTION() void F();\n#endif"),
    in_class("UFUNCTION() void F(uint32 NotForBlueprints);"),
    in_class("UPROPERTY() TArray<FTransform> X; UPROPERTY() TMap<FName, TObjectPtr<UObject>> Y; UPROPERTY() TSet<int32> Z;"),
    in_class("UFUNCTION(BlueprintCallable, CustomThunk, meta=(ArrayParm=\"X\")) static void F(const TArray<int32>& X);\nDECLARE_FUNCTION(execF);"),
    "#ifndef TEST_H\n#define TEST_H\n" + in_struct("UPROPERTY() int32 X;").replace("#pragma once\n", "") + "#endif\n",
    in_struct("UPROPERTY() FString Name = TEXT(\"a{b\");") + '#include "Test.inl"\n',
]


@pytest.mark.parametrize("text", GOOD)
def test_good_headers_pass(dump: Dump, text: str) -> None:
    result = dump({"Test.h": text}, "--strict")
    assert result.code == 0, result.errors
