// SPDX-License-Identifier: MIT
// What properties say about themselves, values, text, containers, enums, structs, metadata.
#include "coreuobject_fixture.h"

#include "Misc/StringOutputDevice.h"

using namespace reflection_test;

namespace {
FProperty* PropertyOf(const TCHAR* Name) {
    FProperty* Property = UReflectionSubject::StaticClass()->FindPropertyByName(FName(Name));
    REQUIRE(Property != nullptr);
    return Property;
}
FString TypeOf(const TCHAR* Name) {
    FString Extended;
    const FString Type = PropertyOf(Name)->GetCPPType(&Extended);
    return Type + Extended;
}
} // namespace

TEST_CASE("coreuobject properties: classes and C++ types") {
    struct FRow {
        const TCHAR* Name;
        const TCHAR* Class;
        const TCHAR* Type;
    };
    const FRow Rows[] = {
        {TEXT("Int32Value"), TEXT("IntProperty"), TEXT("int32")},
        {TEXT("Int8Value"), TEXT("Int8Property"), TEXT("int8")},
        {TEXT("Int16Value"), TEXT("Int16Property"), TEXT("int16")},
        {TEXT("Int64Value"), TEXT("Int64Property"), TEXT("int64")},
        {TEXT("UInt8Value"), TEXT("ByteProperty"), TEXT("uint8")},
        {TEXT("UInt16Value"), TEXT("UInt16Property"), TEXT("uint16")},
        {TEXT("UInt32Value"), TEXT("UInt32Property"), TEXT("uint32")},
        {TEXT("UInt64Value"), TEXT("UInt64Property"), TEXT("uint64")},
        {TEXT("FloatValue"), TEXT("FloatProperty"), TEXT("float")},
        {TEXT("DoubleValue"), TEXT("DoubleProperty"), TEXT("double")},
        {TEXT("bNative"), TEXT("BoolProperty"), TEXT("bool")},
        {TEXT("bBitTwo"), TEXT("BoolProperty"), TEXT("uint8")},
        {TEXT("RegularEnum"), TEXT("ByteProperty"), TEXT("TEnumAsByte<ERegularTestEnum>")},
        {TEXT("NamespacedEnum"), TEXT("ByteProperty"), TEXT("TEnumAsByte<ENamespacedTestEnum::Type>")},
        {TEXT("Color"), TEXT("EnumProperty"), TEXT("ETestColor")},
        {TEXT("Flags"), TEXT("EnumProperty"), TEXT("ETestFlags")},
        {TEXT("String"), TEXT("StrProperty"), TEXT("FString")},
        {TEXT("Name"), TEXT("NameProperty"), TEXT("FName")},
        {TEXT("Text"), TEXT("TextProperty"), TEXT("FText")},
        {TEXT("Strong"), TEXT("ObjectProperty"), TEXT("TObjectPtr<UObject>")},
        {TEXT("RawStrong"), TEXT("ObjectProperty"), TEXT("UReflectionSubject*")},
        {TEXT("SubclassOf"), TEXT("ClassProperty"), TEXT("TSubclassOf<UReflectionBase>")},
        {TEXT("Weak"), TEXT("WeakObjectProperty"), TEXT("TWeakObjectPtr<UObject>")},
        {TEXT("Lazy"), TEXT("LazyObjectProperty"), TEXT("TLazyObjectPtr<UObject>")},
        {TEXT("Soft"), TEXT("SoftObjectProperty"), TEXT("TSoftObjectPtr<UObject>")},
        {TEXT("SoftClass"), TEXT("SoftClassProperty"), TEXT("TSoftClassPtr<UReflectionBase>")},
        {TEXT("Greeter"), TEXT("InterfaceProperty"), TEXT("TScriptInterface<ITestGreeter>")},
        {TEXT("Struct"), TEXT("StructProperty"), TEXT("FOuterTestStruct")},
        {TEXT("Vector"), TEXT("StructProperty"), TEXT("FVector")},
        {TEXT("Ints"), TEXT("ArrayProperty"), TEXT("TArray<int32>")},
        {TEXT("Objects"), TEXT("ArrayProperty"), TEXT("TArray<TObjectPtr<UObject>>")},
        {TEXT("Names"), TEXT("SetProperty"), TEXT("TSet<FName>")},
        {TEXT("Vectors"), TEXT("MapProperty"), TEXT("TMap<FString,FVector>")},
        {TEXT("OnEvent"), TEXT("DelegateProperty"), TEXT("FTestDelegate")},
        {TEXT("OnMulticast"), TEXT("MulticastInlineDelegateProperty"), TEXT("FTestMulticast")},
        {TEXT("OnSparse"), TEXT("MulticastSparseDelegateProperty"), TEXT("FTestSparse")},
    };
    for (const FRow& Row : Rows) {
        CAPTURE(TCHAR_TO_UTF8(Row.Name));
        CHECK(std::string(TCHAR_TO_UTF8(*PropertyOf(Row.Name)->GetClass()->GetName())) == TCHAR_TO_UTF8(Row.Class));
        CHECK(std::string(TCHAR_TO_UTF8(*TypeOf(Row.Name))) == TCHAR_TO_UTF8(Row.Type));
    }
    CHECK(PropertyOf(TEXT("FixedArray"))->ArrayDim == 4);
    CHECK(PropertyOf(TEXT("FixedArray"))->GetSize() == 16);
    CHECK(CastField<FEnumProperty>(PropertyOf(TEXT("Flags")))->GetUnderlyingProperty()->IsA<FUInt32Property>());
    CHECK(CastField<FNumericProperty>(PropertyOf(TEXT("Int8Value"))) != nullptr);
    CHECK(CastField<FObjectPropertyBase>(PropertyOf(TEXT("Soft"))) != nullptr);
    CHECK(CastField<FIntProperty>(PropertyOf(TEXT("FloatValue"))) == nullptr);
}

TEST_CASE("coreuobject properties: flags, access, order, metadata") {
    CHECK(PropertyOf(TEXT("Int32Value"))
            ->HasAllPropertyFlags(CPF_Edit | CPF_BlueprintVisible | CPF_NativeAccessSpecifierPublic));
    CHECK(PropertyOf(TEXT("Int32Value"))->GetMetaData(TEXT("ClampMin")) == TEXT("0"));
    CHECK(PropertyOf(TEXT("Int32Value"))->GetMetaData(TEXT("category")) == TEXT("Test"));
    CHECK(PropertyOf(TEXT("ProtectedValue"))->HasAnyPropertyFlags(CPF_NativeAccessSpecifierProtected));
    CHECK(PropertyOf(TEXT("PrivateValue"))->HasAnyPropertyFlags(CPF_NativeAccessSpecifierPrivate));
    CHECK(PropertyOf(TEXT("Part"))->HasAnyPropertyFlags(CPF_InstancedReference));
    CHECK(PropertyOf(TEXT("Strong"))->HasAllPropertyFlags(CPF_TObjectPtr | CPF_UObjectWrapper));
    CHECK(PropertyOf(TEXT("Vector"))
            ->HasAllPropertyFlags(
                CPF_IsPlainOldData | CPF_NoDestructor | CPF_ZeroConstructor | CPF_HasGetValueTypeHash));
    CHECK_FALSE(PropertyOf(TEXT("String"))->HasAnyPropertyFlags(CPF_IsPlainOldData));
    CHECK(PropertyOf(TEXT("int32VALUE")) == PropertyOf(TEXT("Int32Value")));
    CHECK(UReflectionSubject::StaticClass()->FindPropertyByName(TEXT("NoSuchProperty")) == nullptr);

    TArray<FString> Own;
    for (TFieldIterator<FProperty> It(UReflectionBase::StaticClass(), EFieldIterationFlags::None); It; ++It) {
        Own.Add(It->GetName());
    }
    CHECK(Own == TArray<FString>{TEXT("Part"), TEXT("BaseNumber")});
    bool bSawBase = false;
    for (FProperty* Property : TFieldRange<FProperty>(UReflectionSubject::StaticClass())) {
        bSawBase = bSawBase || Property->GetName() == TEXT("BaseNumber");
    }
    CHECK(bSawBase);
    TArray<FString> Interface;
    for (TFieldIterator<UFunction> It(UReflectionSubject::StaticClass(), EFieldIterationFlags::IncludeAll); It; ++It) {
        Interface.Add(It->GetName());
    }
    CHECK(Interface.Contains(TEXT("Greet")));
    CHECK(Interface.Contains(TEXT("NativeEvent")));
    CHECK(UReflectionBase::StaticClass()->GetMetaData(TEXT("BlueprintType")) == TEXT("true"));
    CHECK(UReflectionSubject::StaticClass()->GetPrefixCPP() == FString(TEXT("U")));
}

TEST_CASE("coreuobject properties: bits") {
    UReflectionSubject* Subject = MakeSubject();
    FBoolProperty* One = CastField<FBoolProperty>(PropertyOf(TEXT("bBitOne")));
    FBoolProperty* Two = CastField<FBoolProperty>(PropertyOf(TEXT("bBitTwo")));
    FBoolProperty* Wide = CastField<FBoolProperty>(PropertyOf(TEXT("bWideBit")));
    CHECK_FALSE(One->IsNativeBool());
    CHECK(CastField<FBoolProperty>(PropertyOf(TEXT("bNative")))->IsNativeBool());
    CHECK(One->GetFieldMask() != Two->GetFieldMask());
    CHECK(Two->GetPropertyValue_InContainer(Subject));
    One->SetPropertyValue_InContainer(Subject, true);
    Wide->SetPropertyValue_InContainer(Subject, true);
    CHECK(int(Subject->bBitOne) == 1);
    CHECK(int(Subject->bBitTwo) == 1);
    CHECK(int(Subject->bWideBit) == 1);
    Two->SetPropertyValue_InContainer(Subject, false);
    CHECK(int(Subject->bBitOne) == 1);
    CHECK(int(Subject->bBitTwo) == 0);
}

TEST_CASE("coreuobject properties: native accessors") {
    UReflectionSubject* Subject = MakeSubject();
    FFloatProperty* Guarded = CastField<FFloatProperty>(PropertyOf(TEXT("Guarded")));
    CHECK(Guarded->HasSetter());
    CHECK(Guarded->HasGetter());
    const float Value = 25.0f;
    Guarded->CallSetter(Subject, &Value);
    CHECK(Subject->NumSetterCalls == 1);
    float Read = 0;
    Guarded->CallGetter(Subject, &Read);
    CHECK(Read == 10.0f);
    CHECK(ImportInto(Subject, TEXT("Guarded"), TEXT("3.5")));
    CHECK(Subject->NumSetterCalls == 2);
    CHECK(Subject->GetGuarded() == 3.5f);
    CHECK_FALSE(PropertyOf(TEXT("FloatValue"))->HasSetterOrGetter());
}

TEST_CASE("coreuobject properties: text out and in") {
    UReflectionSubject* Subject = MakeSubject();
    struct FRow {
        const TCHAR* Name;
        const TCHAR* Text;
        const TCHAR* Other;
    };
    const FRow Rows[] = {
        {TEXT("Int32Value"), TEXT("42"), TEXT("-7")},
        {TEXT("UInt64Value"), TEXT("64"), TEXT("18446744073709551615")},
        {TEXT("FloatValue"), TEXT("1.500000"), TEXT("0.250000")},
        {TEXT("DoubleValue"), TEXT("2.250000"), TEXT("-1.000000")},
        {TEXT("bNative"), TEXT("True"), TEXT("False")},
        {TEXT("bBitTwo"), TEXT("True"), TEXT("False")},
        {TEXT("RegularEnum"), TEXT("RTE_Second"), TEXT("RTE_Tenth")},
        {TEXT("NamespacedEnum"), TEXT("Beta"), TEXT("Alpha")},
        {TEXT("Color"), TEXT("Green"), TEXT("Blue")},
        {TEXT("String"), TEXT("text"), TEXT("a, \"quoted\" (text)")},
        {TEXT("Name"), TEXT("SomeName"), TEXT("Other Name")},
        {TEXT("Vector"), TEXT("(X=1.000000,Y=2.000000,Z=3.000000)"), TEXT("(X=4.000000,Y=5.000000,Z=6.000000)")},
        {TEXT("Ints"), TEXT("()"), TEXT("(1,2,3)")},
        {TEXT("Strings"), TEXT("()"), TEXT("(\"a\",\"b,c\",\"d\\\"e\\\"\")")},
        {TEXT("Names"), TEXT("()"), TEXT("(\"One\",\"Two\")")},
        {TEXT("Vectors"), TEXT("()"), TEXT("((\"k\", (X=1.000000,Y=0.000000,Z=0.000000)))")},
        {TEXT("Strong"), TEXT("None"), TEXT("/Script/CoreUObject.Class'/Script/CoreUObject.Object'")},
        {TEXT("SubclassOf"), TEXT("None"), TEXT("/Script/CoreUObject.Class'/Script/ReflectionTest.ReflectionChild'")},
        {TEXT("Soft"), TEXT("None"), TEXT("/Game/Thing.Thing")},
        {TEXT("Guid"), TEXT("00000000000000000000000000000000"), TEXT("0123456789ABCDEF0123456789ABCDEF")},
        {TEXT("Struct"),
            TEXT("(Count=3,Label=\"label\",Inners=,Object=None,Location=(X=1.000000,Y=2.000000,Z=3.000000),Scores=)"),
            TEXT("(Count=5,Label=\"x\",Inners=((Count=1,Label=\"y\")),Object=None,Location=(X=0.000000,Y=0.000000,Z=0."
                 "000000),Scores=((\"s\", 2)))")},
    };
    for (const FRow& Row : Rows) {
        CAPTURE(TCHAR_TO_UTF8(Row.Name));
        const FString Default = ExportOf(Subject, Row.Name);
        const FString Expected = FString(Row.Text).Replace(TEXT("=,"), TEXT("=(),")).Replace(TEXT("=)"), TEXT("=())"));
        CHECK(std::string(TCHAR_TO_UTF8(*Default)) == TCHAR_TO_UTF8(*Expected));
        CHECK(ImportInto(Subject, Row.Name, Row.Other));
        CHECK(std::string(TCHAR_TO_UTF8(*ExportOf(Subject, Row.Name))) == TCHAR_TO_UTF8(Row.Other));
    }
    CHECK(Subject->SubclassOf == UReflectionChild::StaticClass());
    CHECK(Subject->Strings[2] == TEXT("d\"e\""));
    CHECK(Subject->Struct.Scores[TEXT("s")] == 2);
    // A part of a struct leaves the rest alone.
    CHECK(ImportInto(Subject, TEXT("Vector"), TEXT("(Y=9)")));
    CHECK(Subject->Vector == FVector(4, 9, 6));
    // Enums are read by full name and by number too.
    CHECK(ImportInto(Subject, TEXT("Color"), TEXT("ETestColor::Red")));
    CHECK(Subject->Color == ETestColor::Red);
    CHECK(ExportOf(Subject, TEXT("Text")) == TEXT("shown"));
    CHECK(ImportInto(Subject, TEXT("Text"), TEXT("NSLOCTEXT(\"ns\", \"key\", \"source\")")));
    CHECK(Subject->Text.ToString() == TEXT("source"));
}

TEST_CASE("coreuobject properties: bad text is refused with a reason") {
    UReflectionSubject* Subject = MakeSubject();
    auto Reason = [Subject](const TCHAR* Name, const TCHAR* Text) {
        FStringOutputDevice Errors;
        FProperty* Property = PropertyOf(Name);
        CHECK(Property->ImportText_InContainer(Text, Subject, Subject, PPF_None, &Errors) == nullptr);
        return FString(Errors);
    };
    CHECK(Reason(TEXT("Int32Value"), TEXT("abc")).Contains(TEXT("Int32Value")));
    CHECK(Subject->Int32Value == 42);
    CHECK(Reason(TEXT("Color"), TEXT("Purple")).Contains(TEXT("ETestColor")));
    CHECK(Reason(TEXT("Vector"), TEXT("(X=1,W=2)")).Contains(TEXT("'W'")));
    CHECK(Reason(TEXT("Vector"), TEXT("1,2,3")).Contains(TEXT("'('")));
    CHECK(Reason(TEXT("bNative"), TEXT("maybe")).Contains(TEXT("True or False")));
    CHECK(Reason(TEXT("SubclassOf"), TEXT("/Script/ReflectionTest.ReflectionPart")).Contains(TEXT("ReflectionBase")));
    CHECK(Reason(TEXT("Ints"), TEXT("(1,2")).Contains(TEXT("','")));
}

TEST_CASE("coreuobject properties: copies, comparisons and hashes of every kind") {
    UReflectionSubject* A = MakeSubject();
    UReflectionSubject* B = MakeSubject();
    A->Strings = {TEXT("p"), TEXT("q")};
    A->Names = {TEXT("n")};
    A->Vectors.Add(TEXT("v"), FVector(1, 1, 1));
    A->Structs.AddDefaulted_GetRef().Inners.AddDefaulted(3);
    A->FixedArray[2] = 99;
    A->Color = ETestColor::Blue;
    A->Text = FText::FromString(TEXT("other"));
    A->Soft = FSoftObjectPath(TEXT("/Game/X.X"));
    A->Greeter = A;
    int32 NumDifferent = 0;
    for (TFieldIterator<FProperty> It(UReflectionSubject::StaticClass()); It; ++It) {
        FProperty* Property = *It;
        CAPTURE(TCHAR_TO_UTF8(*Property->GetName()));
        NumDifferent +=
            Property->IdenticalAll(Property->ContainerPtrToValuePtr<void>(A), Property->ContainerPtrToValuePtr<void>(B))
                ? 0
                : 1;
        void* Value = Property->AllocateAndInitializeValue();
        Property->CopyCompleteValue(Value, Property->ContainerPtrToValuePtr<void>(A));
        CHECK(Property->IdenticalAll(Value, Property->ContainerPtrToValuePtr<void>(A)));
        if (Property->HasAnyPropertyFlags(CPF_HasGetValueTypeHash)) {
            CHECK(Property->GetValueTypeHash(Value) ==
                  Property->GetValueTypeHash(Property->ContainerPtrToValuePtr<void>(A)));
        }
        Property->ClearValue(Value);
        Property->DestroyAndFreeValue(Value);
        if (!Property->HasAnyPropertyFlags(CPF_InstancedReference)) {
            Property->CopyCompleteValue_InContainer(B, A);
        }
    }
    CHECK(NumDifferent == 10);
    CHECK(B->Vectors[TEXT("v")] == FVector(1, 1, 1));
    CHECK(B->Names.Contains(TEXT("n")));
    CHECK(B->Structs[0].Inners.Num() == 3);
    CHECK(B->FixedArray[2] == 99);
}

TEST_CASE("coreuobject properties: container helpers see what C++ sees") {
    UReflectionSubject* Subject = MakeSubject();
    {
        FScriptArrayHelper_InContainer Array(CastField<FArrayProperty>(PropertyOf(TEXT("Strings"))), Subject);
        const int32 Index = Array.AddValue();
        *reinterpret_cast<FString*>(Array.GetRawPtr(Index)) = TEXT("first");
        Array.InsertValues(0, 1);
        CHECK(Subject->Strings == TArray<FString>{TEXT(""), TEXT("first")});
        Array.RemoveValues(0, 1);
        Array.Resize(3);
        CHECK(Subject->Strings.Num() == 3);
        CHECK(Subject->Strings[0] == TEXT("first"));
        Array.EmptyValues();
        CHECK(Subject->Strings.IsEmpty());
    }
    {
        FScriptSetHelper_InContainer Set(CastField<FSetProperty>(PropertyOf(TEXT("Names"))), Subject);
        const FName One(TEXT("One")), Two(TEXT("Two"));
        Set.AddElement(&One);
        Set.AddElement(&Two);
        Set.AddElement(&One);
        CHECK(Set.Num() == 2);
        CHECK(Subject->Names.Contains(TEXT("two")));
        CHECK(Set.RemoveElement(&One));
        CHECK_FALSE(Subject->Names.Contains(TEXT("One")));
        Subject->Names.Add(TEXT("Three"));
        const FName Three(TEXT("Three"));
        CHECK(Set.FindElementIndex(&Three) != INDEX_NONE);
        CHECK(Set.FindNthElementPtr(2) == nullptr);
    }
    {
        FScriptMapHelper_InContainer Map(CastField<FMapProperty>(PropertyOf(TEXT("Vectors"))), Subject);
        for (int32 Number = 0; Number < 100; ++Number) {
            const FString Key = LexToString(Number);
            const FVector Value(Number, 0, 0);
            Map.AddPair(&Key, &Value);
        }
        CHECK(Subject->Vectors.Num() == 100);
        CHECK(Subject->Vectors[TEXT("57")].X == 57.0);
        const FString Key = TEXT("57");
        CHECK(Map.RemovePair(&Key));
        CHECK(Subject->Vectors.Find(TEXT("57")) == nullptr);
        Subject->Vectors.Add(TEXT("new"), FVector(5, 5, 5));
        const FString NewKey = TEXT("new");
        REQUIRE(Map.FindValueFromHash(&NewKey) != nullptr);
        CHECK(*reinterpret_cast<FVector*>(Map.FindValueFromHash(&NewKey)) == FVector(5, 5, 5));
    }
}

TEST_CASE("coreuobject types: enums") {
    const UEnum* Regular = StaticEnum<ERegularTestEnum>();
    CHECK(Regular->NumEnums() == 4);
    CHECK(Regular->GetNameByIndex(3) == FName(TEXT("RTE_MAX")));
    CHECK(Regular->GetValueByIndex(3) == 11);
    CHECK(Regular->HasGeneratedMax());
    CHECK(Regular->GetValueByName(TEXT("rte_tenth")) == 10);
    CHECK(Regular->GetDisplayNameTextByValue(RTE_Second).ToString() == TEXT("Number Two"));
    CHECK(Regular->GetMetaData(TEXT("ToolTip"), 0) == TEXT("The first one."));
    CHECK(Regular->GetCppForm() == UEnum::ECppForm::Regular);

    const UEnum* Color = StaticEnum<ETestColor>();
    CHECK(Color->GetNameByValue(5) == FName(TEXT("ETestColor::Green")));
    CHECK(Color->GetNameStringByValue(5) == TEXT("Green"));
    CHECK(Color->GetValueByName(TEXT("ETestColor::Blue")) == 6);
    CHECK(Color->GetValueByNameString(TEXT("Blue")) == 6);
    CHECK(Color->GetValueByName(TEXT("Purple")) == INDEX_NONE);
    CHECK(Color->GetNameByIndex(Color->NumEnums() - 1) == FName(TEXT("ETestColor::ETestColor_MAX")));
    CHECK(Color->GetCppForm() == UEnum::ECppForm::EnumClass);
    CHECK(UEnum::GetValueAsString(ETestColor::Red) == TEXT("ETestColor::Red"));

    const UEnum* Namespaced = StaticEnum<ENamespacedTestEnum::Type>();
    CHECK(Namespaced->CppType == TEXT("ENamespacedTestEnum::Type"));
    CHECK(Namespaced->GetNameByValue(ENamespacedTestEnum::Beta) == FName(TEXT("ENamespacedTestEnum::Beta")));

    const UEnum* Flags = StaticEnum<ETestFlags>();
    CHECK(Flags->HasAnyEnumFlags(EEnumFlags::Flags));
    CHECK(Flags->GetValueOrBitfieldAsString(3) == TEXT("One | Two"));
    CHECK(Flags->GetValueByName(TEXT("ETestFlags::Big")) == 0x10000);
    CHECK(FindObject<UEnum>(nullptr, TEXT("/Script/ReflectionTest.ETestColor")) == Color);
}

TEST_CASE("coreuobject types: structs") {
    UScriptStruct* Outer = FOuterTestStruct::StaticStruct();
    CHECK(Outer->GetSuperStruct() == FInnerTestStruct::StaticStruct());
    CHECK(Outer->GetStructureSize() == static_cast<int32>(sizeof(FOuterTestStruct)));
    CHECK(Outer->GetMinAlignment() == static_cast<int32>(alignof(FOuterTestStruct)));
    CHECK(Outer->GetStructCPPName() == TEXT("FOuterTestStruct"));
    CHECK(Outer->FindPropertyByName(TEXT("Count")) != nullptr);
    CHECK((FPlainTestStruct::StaticStruct()->StructFlags & STRUCT_IsPlainOldData) != 0);
    CHECK((Outer->StructFlags & STRUCT_IsPlainOldData) == 0);

    FStructOnScope Value(Outer);
    FOuterTestStruct& Typed = *reinterpret_cast<FOuterTestStruct*>(Value.GetStructMemory());
    CHECK(Typed.Count == 3);
    CHECK(Typed.Label == TEXT("label"));
    CHECK(Typed.Location == FVector(1, 2, 3));
    FOuterTestStruct Other;
    Other.Count = 9;
    Other.Scores.Add(TEXT("z"), 1);
    CHECK_FALSE(Outer->CompareScriptStruct(&Typed, &Other, PPF_None));
    Outer->CopyScriptStruct(&Typed, &Other);
    CHECK(Outer->CompareScriptStruct(&Typed, &Other, PPF_None));
    Outer->ClearScriptStruct(&Typed);
    CHECK(Typed.Count == 3);
    CHECK(FInnerTestStruct::StaticStruct()->GetStructTypeHash(&Other) ==
          GetTypeHash(static_cast<const FInnerTestStruct&>(Other)));
}

TEST_CASE("coreuobject types: core structs") {
    CHECK(TBaseStructure<FVector>::Get()->GetPathName() == TEXT("/Script/CoreUObject.Vector"));
    CHECK(TBaseStructure<FVector>::Get()->FindPropertyByName(TEXT("Y"))->GetOffset_ForInternal() == 8);
    CHECK(TBaseStructure<FVector>::Get()->FindPropertyByName(TEXT("Y"))->IsA<FDoubleProperty>());
    CHECK(TBaseStructure<FTransform>::Get()->GetStructureSize() == static_cast<int32>(sizeof(FTransform)));
    FTransform Transform;
    TBaseStructure<FTransform>::Get()->InitializeStruct(&Transform);
    CHECK(Transform.Equals(FTransform::Identity));
    FString Text;
    const FTransform Moved(FQuat::Identity, FVector(1, 2, 3), FVector(2, 2, 2));
    TBaseStructure<FTransform>::Get()->ExportText(Text, &Moved, nullptr, nullptr, PPF_None, nullptr);
    CHECK(Text == TEXT("(Rotation=(X=0.000000,Y=0.000000,Z=0.000000,W=1.000000),Translation=(X=1.000000,Y=2.000000,Z=3."
                       "000000),Scale3D=(X=2.000000,Y=2.000000,Z=2.000000))"));
    FColor Color;
    CHECK(TBaseStructure<FColor>::Get()->ImportText(
              TEXT("(R=255,G=1,B=2,A=3)"), &Color, nullptr, PPF_None, nullptr, TEXT("Color")) != nullptr);
    CHECK(Color == FColor(255, 1, 2, 3));
}

TEST_CASE("coreuobject types: class relations") {
    TArray<UClass*> Derived;
    GetDerivedClasses(UReflectionSubject::StaticClass(), Derived);
    CHECK(Derived.Contains(UReflectionChild::StaticClass()));
    CHECK(Derived.Contains(UReflectionImplicit::StaticClass()));
    CHECK_FALSE(Derived.Contains(UReflectionSubject::StaticClass()));
    CHECK(UReflectionChild::StaticClass()->IsChildOf<UReflectionBase>());
    CHECK(UReflectionSubject::StaticClass()->GetSuperClass() == UReflectionBase::StaticClass());
    CHECK(UReflectionSubject::StaticClass()->HasAnyClassFlags(CLASS_Native));
    CHECK(UTestGreeter::StaticClass()->HasAnyClassFlags(CLASS_Interface));
    CHECK(UReflectionSubject::StaticClass()->GetPropertiesSize() == static_cast<int32>(sizeof(UReflectionSubject)));
    CHECK(UReflectionPart::StaticClass()->HasAnyClassFlags(CLASS_DefaultToInstanced));
    CHECK(UReflectionSubject::StaticClass()->HasAnyClassFlags(CLASS_HasInstancedReference));
    CHECK(UClass::FindCommonBase(UReflectionChild::StaticClass(), UReflectionImplicit::StaticClass()) ==
          UReflectionSubject::StaticClass());
}
