// SPDX-License-Identifier: MIT
// Dynamic delegates: single, multicast, sparse; as values of properties.
#include "coreuobject_fixture.h"

using namespace reflection_test;

TEST_CASE("coreuobject delegates: single") {
    UReflectionSubject* Subject = MakeSubject();
    CHECK_FALSE(Subject->OnEvent.IsBound());
    CHECK_FALSE(Subject->OnEvent.ExecuteIfBound(1, TEXT("x")));
    Subject->OnEvent.BindDynamic(Subject, &UReflectionSubject::HandleEvent);
    CHECK(Subject->OnEvent.IsBound());
    Subject->OnEvent.Execute(12, TEXT("twelve"));
    CHECK(Subject->LastNumber == 12);
    CHECK(Subject->LastText == TEXT("twelve"));

    FTestRetValDelegate RetVal;
    RetVal.BindUFunction(Subject, TEXT("HandleRetVal"));
    CHECK(RetVal.Execute(5) == 15);

    UReflectionSubject* Other = MakeSubject();
    FCall Call(Subject, TEXT("CallBack"));
    FTestDelegate Callback;
    Callback.BindDynamic(Other, &UReflectionSubject::HandleEvent);
    Call.Set(TEXT("Callback"), Callback).Set<int32>(TEXT("Number"), 3).Run();
    CHECK(Other->LastNumber == 3);
    CHECK(Other->LastText == TEXT("called"));
    Subject->OnEvent.Unbind();
    CHECK_FALSE(Subject->OnEvent.IsBound());
}

TEST_CASE("coreuobject delegates: multicast") {
    UReflectionSubject* Subject = MakeSubject();
    UReflectionSubject* A = MakeSubject();
    UReflectionSubject* B = MakeSubject();
    Subject->OnMulticast.AddDynamic(A, &UReflectionSubject::HandleMulticast);
    Subject->OnMulticast.AddUniqueDynamic(A, &UReflectionSubject::HandleMulticast);
    Subject->OnMulticast.AddDynamic(B, &UReflectionSubject::HandleMulticast);
    CHECK(Subject->OnMulticast.IsAlreadyBound(A, &UReflectionSubject::HandleMulticast));
    Subject->OnMulticast.Broadcast(2);
    CHECK(A->LastNumber == 2);
    CHECK(B->LastNumber == 2);
    Subject->OnMulticast.RemoveDynamic(A, &UReflectionSubject::HandleMulticast);
    Subject->OnMulticast.Broadcast(3);
    CHECK(A->LastNumber == 2);
    CHECK(B->LastNumber == 5);
    B->MarkAsGarbage();
    Subject->OnMulticast.Broadcast(10);
    CHECK(B->LastNumber == 5);
    CHECK_FALSE(Subject->OnMulticast.IsBound());
}

TEST_CASE("coreuobject delegates: sparse") {
    static_assert(sizeof(FTestSparse) == 1);
    UReflectionSubject* Subject = MakeSubject();
    UReflectionSubject* A = MakeSubject();
    CHECK_FALSE(Subject->OnSparse.IsBound());
    Subject->OnSparse.Broadcast(1);
    Subject->OnSparse.AddDynamic(A, &UReflectionSubject::HandleMulticast);
    CHECK(Subject->OnSparse.IsBound());
    Subject->OnSparse.Broadcast(4);
    CHECK(A->LastNumber == 4);
    Subject->OnSparse.RemoveDynamic(A, &UReflectionSubject::HandleMulticast);
    CHECK_FALSE(Subject->OnSparse.IsBound());
    CHECK(FSparseDelegateStorage::GetMulticastDelegate(Subject, TEXT("OnSparse")) == nullptr);
}

TEST_CASE("coreuobject delegates: through properties") {
    UReflectionSubject* Subject = MakeSubject();
    UReflectionSubject* Target = NewObject<UReflectionSubject>(GetTransientPackage(), TEXT("DelegateTarget"));
    for (const TCHAR* Name : {TEXT("OnMulticast"), TEXT("OnSparse")}) {
        FMulticastDelegateProperty* Property =
            CastField<FMulticastDelegateProperty>(Subject->GetClass()->FindPropertyByName(Name));
        REQUIRE(Property != nullptr);
        CHECK(Property->SignatureFunction->NumParms == 1);
        FScriptDelegate Delegate;
        Delegate.BindUFunction(Target, TEXT("HandleMulticast"));
        Property->AddDelegate(Delegate, Subject);
        CHECK(ExportOf(Subject, Name) == TEXT("(/Engine/Transient.DelegateTarget.HandleMulticast)"));
        Property->ClearDelegate(Subject);
        CHECK(ExportOf(Subject, Name) == TEXT("()"));
        CHECK(ImportInto(Subject, Name, TEXT("(/Engine/Transient.DelegateTarget.HandleMulticast)")));
        const void* Value = Property->ContainerPtrToValuePtr<void>(Subject);
        REQUIRE(Property->GetMulticastDelegate(Value) != nullptr);
        CHECK(Property->GetMulticastDelegate(Value)->IsBound());
    }
    Subject->OnMulticast.Broadcast(1);
    Subject->OnSparse.Broadcast(2);
    CHECK(Target->LastNumber == 3);
    CHECK_FALSE(ImportInto(Subject, TEXT("OnEvent"), TEXT("/Engine/Transient.DelegateTarget.Add")));
    CHECK(ImportInto(Subject, TEXT("OnEvent"), TEXT("/Engine/Transient.DelegateTarget.HandleEvent")));
    CHECK(Subject->OnEvent.IsBound());
}

TEST_CASE("coreuobject delegates: signatures are objects") {
    UFunction* Signature =
        FindObject<UFunction>(nullptr, TEXT("/Script/ReflectionTest.TestDelegate__DelegateSignature"));
    REQUIRE(Signature != nullptr);
    CHECK(Signature->HasAllFunctionFlags(FUNC_Delegate | FUNC_Public));
    CHECK(Signature->IsSignatureCompatibleWith(
        UReflectionSubject::StaticClass()->FindFunctionByName(TEXT("HandleEvent"))));
    CHECK_FALSE(Signature->IsSignatureCompatibleWith(
        UReflectionSubject::StaticClass()->FindFunctionByName(TEXT("HandleMulticast"))));
    USparseDelegateFunction* Sparse =
        FindObject<USparseDelegateFunction>(nullptr, TEXT("/Script/ReflectionTest.TestSparse__DelegateSignature"));
    REQUIRE(Sparse != nullptr);
    CHECK(Sparse->DelegateName == FName(TEXT("OnSparse")));
}
