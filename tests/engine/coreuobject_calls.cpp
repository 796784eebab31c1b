// SPDX-License-Identifier: MIT
// ProcessEvent with every kind of property as argument, out-parameter and return value.
#include "coreuobject_fixture.h"

using namespace reflection_test;

TEST_CASE("coreuobject: numbers as arguments and results") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK(FCall(Subject, TEXT("Add")).Set<int32>(TEXT("A"), 3).Set<int32>(TEXT("B"), 4).Run().Result<int32>() == 7);
    CHECK(FCall(Subject, TEXT("EchoDouble"))
              .Set(TEXT("Value"), 0.5)
              .Set(TEXT("Single"), 0.25f)
              .Set<int64>(TEXT("Wide"), int64(1) << 40)
              .Run()
              .Result<double>() == 0.75 + static_cast<double>(int64(1) << 40));
}

TEST_CASE("coreuobject: bools, strings, names and texts in calls") {
    UReflectionSubject* Subject = MakeSubject();
    FCall Bool(Subject, TEXT("EchoBool"));
    Bool.Set(TEXT("bValue"), true).Set(TEXT("bInverted"), true).Run();
    CHECK(Bool.Result<bool>());
    CHECK_FALSE(Bool.At<bool>(TEXT("bInverted")));

    FCall String(Subject, TEXT("EchoString"));
    String.Set(TEXT("Value"), FString(TEXT("abc"))).Set(TEXT("InName"), FName(TEXT("Foo"))).Run();
    CHECK(String.Result<FString>() == TEXT("abc"));
    CHECK(String.At<FString>(TEXT("OutUpper")).Equals(TEXT("ABC")));
    CHECK(String.At<FName>(TEXT("OutName")) == FName(TEXT("foo")));

    FCall Text(Subject, TEXT("EchoText"));
    Text.Set(TEXT("Value"), FText::FromString(TEXT("shown"))).Run();
    CHECK(Text.Result<FText>().ToString() == TEXT("shown"));
}

TEST_CASE("coreuobject: enums in calls") {
    FCall Call(MakeSubject(), TEXT("EchoEnum"));
    Call.Set(TEXT("Value"), ETestColor::Blue).Set(TEXT("Regular"), TEnumAsByte<ERegularTestEnum>(RTE_Tenth)).Run();
    CHECK(Call.Result<ETestColor>() == ETestColor::Blue);
    CHECK(Call.At<TEnumAsByte<ERegularTestEnum>>(TEXT("OutRegular")) == RTE_Tenth);
    CHECK(Call.At<ETestFlags>(TEXT("OutFlags")) == (ETestFlags::Big | ETestFlags::One));
}

TEST_CASE("coreuobject: structs in calls") {
    UReflectionSubject* Subject = MakeSubject();
    FCall Vector(Subject, TEXT("EchoVector"));
    Vector.Set(TEXT("Value"), FVector(1, 2, 3)).Set(TEXT("Transform3D"), FTransform(FVector(10, 0, 0))).Run();
    CHECK(Vector.Result<FVector>() == FVector(11, 2, 3));
    CHECK(Vector.At<FVector>(TEXT("OutDoubled")) == FVector(2, 4, 6));

    FCall Struct(Subject, TEXT("EchoStruct"));
    FOuterTestStruct Outer;
    Outer.Count = 12;
    Outer.Inners.AddDefaulted(2);
    Outer.Scores.Add(TEXT("a"), 1);
    FInnerTestStruct Inner;
    Inner.Label = TEXT("given");
    Struct.Set(TEXT("Value"), Outer).Set(TEXT("ByValue"), Inner).Run();
    CHECK(Struct.Result<FOuterTestStruct>().Count == 12);
    CHECK(Struct.Result<FOuterTestStruct>().Inners.Num() == 2);
    CHECK(Struct.Result<FOuterTestStruct>().Scores[TEXT("a")] == 1);
    CHECK(Struct.At<FInnerTestStruct>(TEXT("OutInner")).Label == TEXT("given"));
}

TEST_CASE("coreuobject: objects, classes and interfaces in calls") {
    UReflectionSubject* Subject = MakeSubject();
    FCall Object(Subject, TEXT("EchoObject"));
    Object.Set<UObject*>(TEXT("Value"), Subject->Part).Run();
    CHECK(Object.Result<UObject*>() == Subject->Part);
    CHECK(Object.At<UReflectionSubject*>(TEXT("OutSelf")) == Subject);

    FCall Class(Subject, TEXT("EchoClass"));
    Class.Set(TEXT("Value"), TSubclassOf<UReflectionBase>(UReflectionChild::StaticClass()))
        .Set<UClass*>(TEXT("Any"), UObject::StaticClass())
        .Run();
    CHECK(Class.Result<TSubclassOf<UReflectionBase>>() == UReflectionChild::StaticClass());
    CHECK(Class.At<UClass*>(TEXT("OutAny")) == UObject::StaticClass());

    FCall Interface(Subject, TEXT("EchoInterface"));
    Interface.Set(TEXT("Value"), TScriptInterface<ITestGreeter>(Subject)).Run();
    CHECK(Interface.Result<TScriptInterface<ITestGreeter>>().GetObject() == Subject);
    CHECK(Interface.Result<TScriptInterface<ITestGreeter>>().GetInterface() == static_cast<ITestGreeter*>(Subject));

    FCall Soft(Subject, TEXT("EchoSoft"));
    Soft.Set(TEXT("Value"), TSoftObjectPtr<UObject>(Subject))
        .Set(TEXT("ClassValue"), TSoftClassPtr<UReflectionBase>(UReflectionChild::StaticClass()))
        .Run();
    CHECK(Soft.Result<TSoftObjectPtr<UObject>>().Get() == Subject);
    CHECK(Soft.At<TSoftClassPtr<UReflectionBase>>(TEXT("OutClass")).Get() == UReflectionChild::StaticClass());

    FCall Weak(Subject, TEXT("EchoWeak"));
    Weak.Set(TEXT("Value"), TWeakObjectPtr<UObject>(Subject)).Run();
    CHECK(Weak.Result<TWeakObjectPtr<UObject>>().Get() == Subject);
}

TEST_CASE("coreuobject: containers in calls") {
    UReflectionSubject* Subject = MakeSubject();
    FCall Array(Subject, TEXT("EchoArray"));
    Array.Set(TEXT("Values"), TArray<int32>{1, 2, 3}).Run();
    CHECK(Array.Result<TArray<FString>>() == TArray<FString>{TEXT("1"), TEXT("2"), TEXT("3")});
    CHECK(Array.At<TArray<int32>>(TEXT("OutReversed")) == TArray<int32>{3, 2, 1});
    CHECK(Array.At<TArray<FInnerTestStruct>>(TEXT("OutStructs"))[2].Count == 3);

    FCall Map(Subject, TEXT("EchoMap"));
    TMap<FString, int32> Value;
    Value.Add(TEXT("one"), 1);
    Value.Add(TEXT("two"), 2);
    Map.Set(TEXT("Value"), Value).Set(TEXT("InSet"), TSet<FName>{TEXT("x"), TEXT("y")}).Run();
    CHECK(Map.Result<TMap<FString, int32>>()[TEXT("two")] == 2);
    CHECK(Map.At<TSet<FName>>(TEXT("OutSet")).Contains(TEXT("Y")));
}

TEST_CASE("coreuobject: references are changed in place") {
    FCall Call(MakeSubject(), TEXT("ChangeInPlace"));
    FInnerTestStruct Value;
    Value.Count = 41;
    Call.Set(TEXT("Value"), Value).Set(TEXT("Values"), TArray<int32>{7}).Run();
    CHECK(Call.At<FInnerTestStruct>(TEXT("Value")).Count == 42);
    CHECK(Call.At<TArray<int32>>(TEXT("Values")) == TArray<int32>{7, 42});
}

TEST_CASE("coreuobject: static functions, custom thunks and remote calls") {
    UReflectionSubject* Subject = MakeSubject();
    FCall Static(UReflectionSubject::StaticClass()->GetDefaultObject(), TEXT("StaticSum"));
    CHECK(Static.Set<int32>(TEXT("A"), 1).Set<int32>(TEXT("B"), 2).Run().Result<int32>() == 3);
    CHECK(Static.GetFunction()->HasAllFunctionFlags(FUNC_Static | FUNC_Native | FUNC_Public | FUNC_BlueprintCallable));

    CHECK(FCall(Subject, TEXT("CustomDouble")).Set<int32>(TEXT("Value"), 5).Run().Result<int32>() == 11);

    FCall(Subject, TEXT("ServerSetNumber")).Set<int32>(TEXT("Number"), 6).Run();
    CHECK(Subject->LastNumber == 6);
    FCall(Subject, TEXT("ServerSetNumber")).Set<int32>(TEXT("Number"), -1).Run();
    CHECK(Subject->LastNumber == 6);
    Subject->ServerSetNumber(8);
    CHECK(Subject->LastNumber == 8);
    CHECK(Subject->FindFunction(TEXT("ServerSetNumber"))
            ->HasAllFunctionFlags(FUNC_Net | FUNC_NetServer | FUNC_NetReliable | FUNC_NetValidate));
}

TEST_CASE("coreuobject: functions are found without case and overrides count") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK(Subject->FindFunction(TEXT("aDD")) == Subject->FindFunction(TEXT("Add")));
    CHECK(Subject->FindFunction(TEXT("NoSuchFunction")) == nullptr);
    CHECK(FCall(Subject, TEXT("VirtualNumber")).Run().Result<int32>() == 200);
    CHECK(FCall(NewObject<UReflectionChild>(), TEXT("VirtualNumber")).Run().Result<int32>() == 300);
    CHECK(Subject->FindFunction(TEXT("VirtualNumber"))->GetOwnerClass() == UReflectionBase::StaticClass());
    // Functions of interfaces are found through the class that implements them.
    CHECK(Subject->FindFunction(TEXT("Greet"))->GetOwnerClass() == UTestGreeter::StaticClass());
}

TEST_CASE("coreuobject: native and implementable events") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK(Subject->NativeEvent(4) == 50);
    CHECK(FCall(Subject, TEXT("NativeEvent")).Set<int32>(TEXT("Number"), 4).Run().Result<int32>() == 50);
    // Nobody implements it: nothing happens, the result is the initial one.
    CHECK(Subject->ImplementableEvent(4) == 0);
    const UFunction* Event = Subject->FindFunction(TEXT("ImplementableEvent"));
    CHECK_FALSE(Event->HasAnyFunctionFlags(FUNC_Native));
    CHECK(Event->HasAllFunctionFlags(FUNC_Event | FUNC_BlueprintEvent));
}

TEST_CASE("coreuobject: interfaces") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK(Subject->GetClass()->ImplementsInterface(UTestGreeter::StaticClass()));
    CHECK(UReflectionChild::StaticClass()->ImplementsInterface(UTestGreeter::StaticClass()));
    CHECK_FALSE(UReflectionPart::StaticClass()->ImplementsInterface(UTestGreeter::StaticClass()));
    CHECK(ITestGreeter::Execute_Greet(Subject, TEXT("you")) == TEXT("Hello you"));
    int32 Total = 1;
    ITestGreeter::Execute_AddTo(Subject, Total, 4);
    CHECK(Total == 5);
    CHECK(Cast<ITestGreeter>(static_cast<UObject*>(Subject)) == static_cast<ITestGreeter*>(Subject));
    CHECK(Cast<UReflectionSubject>(static_cast<ITestGreeter*>(Subject)) == Subject);
    CHECK(Cast<ITestGreeter>(Subject->Part.Get()) == nullptr);
    CHECK(FCall(Subject, TEXT("Greet")).Set(TEXT("Name"), FString(TEXT("them"))).Run().Result<FString>() ==
          TEXT("Hello them"));
}

TEST_CASE("coreuobject: garbage objects take no calls") {
    UReflectionSubject* Subject = MakeSubject();
    Subject->MarkAsGarbage();
    FCall Call(Subject, TEXT("Add"));
    Call.Set<int32>(TEXT("A"), 1).Set<int32>(TEXT("B"), 1).Run();
    CHECK(Call.Result<int32>() == 0);
}

TEST_CASE("coreuobject: calls by command line") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK(Subject->CallFunctionByNameWithArguments(TEXT("SetNumberByCommand 17 the rest of it"), *GLog, nullptr));
    CHECK(Subject->LastNumber == 17);
    CHECK(Subject->LastText == TEXT("the rest of it"));
    CHECK_FALSE(Subject->CallFunctionByNameWithArguments(TEXT("Add 1 2"), *GLog, nullptr));
    CHECK(Subject->CallFunctionByNameWithArguments(TEXT("Add 1"), *GLog, nullptr, true));
}

TEST_CASE("coreuobject: functions describe their parameters") {
    const UFunction* Function = UReflectionSubject::StaticClass()->FindFunctionByName(TEXT("EchoVector"));
    CHECK(Function->NumParms == 4);
    const FProperty* Value = Function->FindPropertyByName(TEXT("Value"));
    CHECK(Value->HasAllPropertyFlags(CPF_Parm | CPF_OutParm | CPF_ReferenceParm | CPF_ConstParm));
    const FProperty* Out = Function->FindPropertyByName(TEXT("OutDoubled"));
    CHECK(Out->HasAllPropertyFlags(CPF_Parm | CPF_OutParm));
    CHECK_FALSE(Out->HasAnyPropertyFlags(CPF_ConstParm));
    CHECK(Function->GetReturnProperty()->HasAllPropertyFlags(CPF_Parm | CPF_OutParm | CPF_ReturnParm));
    CHECK(Function->ReturnValueOffset == Function->GetReturnProperty()->GetOffset_ForUFunction());
    CHECK(Function->HasAllFunctionFlags(FUNC_HasOutParms | FUNC_HasDefaults | FUNC_Const));
    TArray<FString> Names;
    for (TFieldIterator<FProperty> It(Function); It; ++It) {
        Names.Add(It->GetName());
    }
    CHECK(Names == TArray<FString>{TEXT("Value"), TEXT("OutDoubled"), TEXT("Transform3D"), TEXT("ReturnValue")});
    CHECK(UReflectionSubject::StaticClass()->FindFunctionByName(TEXT("Add"))->GetMetaData(TEXT("CPP_Default_B")) ==
          TEXT("5"));
}
