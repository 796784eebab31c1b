// SPDX-License-Identifier: MIT
// Garbage collection, weak and strong pointers.
#include "coreuobject_fixture.h"

using namespace reflection_test;

namespace {
void Collect() { CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS); }

class FHolder : public FGCObject {
public:
    TObjectPtr<UObject> Object;
    virtual void AddReferencedObjects(FReferenceCollector& Collector) override {
        Collector.AddReferencedObject(Object);
    }
    virtual FString GetReferencerName() const override { return TEXT("FHolder"); }
};
} // namespace

TEST_CASE("coreuobject gc: unreferenced objects and cycles go, rooted ones stay") {
    UReflectionSubject* Rooted = MakeSubject();
    Rooted->AddToRoot();
    UReflectionSubject* A = MakeSubject();
    UReflectionSubject* B = MakeSubject();
    A->Strong = B;
    B->Strong = A;
    const TWeakObjectPtr<UObject> WeakRooted(Rooted), WeakA(A), WeakB(B), WeakPart(A->Part);
    const int32 Before = UReflectionSubject::NumDestroyed;
    Collect();
    CHECK(WeakRooted.IsValid());
    CHECK_FALSE(WeakA.IsValid());
    CHECK(WeakA.IsStale());
    CHECK_FALSE(WeakB.IsValid());
    CHECK_FALSE(WeakPart.IsValid());
    CHECK(UReflectionSubject::NumDestroyed >= Before + 2);
    Rooted->RemoveFromRoot();
    Collect();
    CHECK_FALSE(WeakRooted.IsValid());
}

TEST_CASE("coreuobject gc: every kind of strong reference keeps its object") {
    UReflectionSubject* Root = MakeSubject();
    Root->AddToRoot();
    TArray<TWeakObjectPtr<UObject>> Held;
    auto Make = [&Held] {
        UObject* Object = NewObject<UReflectionPart>();
        Held.Add(Object);
        return Object;
    };
    Root->Strong = Make();
    Root->RawStrong = MakeSubject();
    Held.Add(Root->RawStrong);
    Root->Objects.Add(Make());
    Root->Objects.Add(Make());
    Root->ObjectMap.Add(TEXT("key"), Make());
    Root->ObjectSet.Add(Make());
    Root->Struct.Object = Make();
    Root->Structs.AddDefaulted_GetRef().Object = Make();
    UReflectionSubject* Greeter = MakeSubject();
    Held.Add(Greeter);
    Root->Greeter = Greeter;
    CastChecked<UReflectionPart>(Root->Part.Get())->Reference = Make();
    Collect();
    for (const TWeakObjectPtr<UObject>& Weak : Held) {
        CHECK(Weak.IsValid());
    }
    // An outer is kept alive by what is inside it.
    UReflectionSubject* Outer = MakeSubject();
    UReflectionWithin* Inner = NewObject<UReflectionWithin>(Outer);
    Root->Strong = Inner;
    const TWeakObjectPtr<UObject> WeakOuter(Outer);
    Collect();
    CHECK(WeakOuter.IsValid());
    Root->RemoveFromRoot();
    Collect();
    for (const TWeakObjectPtr<UObject>& Weak : Held) {
        CHECK_FALSE(Weak.IsValid());
    }
}

TEST_CASE("coreuobject gc: weak, soft and delegate references do not keep objects") {
    UReflectionSubject* Root = MakeSubject();
    Root->AddToRoot();
    UReflectionSubject* Other = MakeSubject();
    Root->Weak = Other;
    Root->Soft = Other;
    Root->OnEvent.BindDynamic(Other, &UReflectionSubject::HandleEvent);
    Root->OnMulticast.AddDynamic(Other, &UReflectionSubject::HandleMulticast);
    Collect();
    CHECK(Root->Weak.Get() == nullptr);
    CHECK(Root->Soft.Get() == nullptr);
    CHECK(Root->Soft.IsPending());
    CHECK_FALSE(Root->OnEvent.IsBound());
    CHECK_FALSE(Root->OnMulticast.IsBound());
    Root->OnMulticast.Broadcast(1);
    Root->RemoveFromRoot();
}

TEST_CASE("coreuobject gc: references to garbage are nulled") {
    UReflectionSubject* Root = MakeSubject();
    Root->AddToRoot();
    UReflectionSubject* Garbage = MakeSubject();
    Root->Strong = Garbage;
    Root->Objects.Add(Garbage);
    Root->ObjectSet.Add(Garbage);
    Root->Struct.Object = Garbage;
    const TWeakObjectPtr<UObject> Weak(Garbage);
    Garbage->MarkAsGarbage();
    CHECK_FALSE(IsValid(Garbage));
    CHECK(Root->Strong == Garbage);
    CHECK_FALSE(Weak.IsValid());
    CHECK(Weak.Get(true) == Garbage);
    Collect();
    CHECK(Root->Strong == nullptr);
    CHECK(Root->Objects.Num() == 1);
    CHECK(Root->Objects[0] == nullptr);
    CHECK(Root->ObjectSet.Contains(nullptr));
    CHECK(Root->Struct.Object == nullptr);
    CHECK(Weak.GetEvenIfUnreachable() == nullptr);
    Root->RemoveFromRoot();
}

TEST_CASE("coreuobject gc: slots are used again with another serial number") {
    const FWeakObjectPtr First(NewObject<UReflectionPart>());
    const int32 Index = First.GetObjectIndex();
    Collect();
    CHECK_FALSE(First.IsValid());
    // New objects take free slots; one of them is the old index.
    TArray<FWeakObjectPtr> Fresh;
    for (int32 Number = 0; Number < 64; ++Number) {
        Fresh.Add(FWeakObjectPtr(NewObject<UReflectionPart>()));
    }
    bool bReused = false;
    for (const FWeakObjectPtr& Weak : Fresh) {
        CHECK_FALSE(Weak.HasSameIndexAndSerialNumber(First));
        bReused = bReused || Weak.GetObjectIndex() == Index;
    }
    CHECK(bReused);
    CHECK_FALSE(First.IsValid());
    Collect();
}

TEST_CASE("coreuobject gc: FGCObject and TStrongObjectPtr") {
    FHolder Holder;
    Holder.Object = NewObject<UReflectionPart>();
    TStrongObjectPtr<UReflectionPart> Strong(NewObject<UReflectionPart>());
    const TWeakObjectPtr<UObject> WeakHeld(Holder.Object), WeakStrong(Strong.Get());
    Collect();
    CHECK(WeakHeld.IsValid());
    CHECK(WeakStrong.IsValid());
    TStrongObjectPtr<UReflectionPart> Copy = Strong;
    Strong.Reset();
    Holder.Object = nullptr;
    Collect();
    CHECK_FALSE(WeakHeld.IsValid());
    CHECK(WeakStrong.IsValid());
    Copy.Reset();
    Collect();
    CHECK_FALSE(WeakStrong.IsValid());
}

TEST_CASE("coreuobject gc: classes, class default objects and packages survive") {
    Collect();
    CHECK(IsValid(UReflectionSubject::StaticClass()));
    CHECK(IsValid(GetDefault<UReflectionSubject>()));
    CHECK(GetDefault<UReflectionSubject>()->Part != nullptr);
    CHECK(IsValid(FindPackage(nullptr, TEXT("/Script/ReflectionTest"))));
}

TEST_CASE("coreuobject gc: incremental purge, locks, delegates and iteration") {
    int32 NumPre = 0, NumPost = 0;
    const FDelegateHandle Pre =
        FCoreUObjectDelegates::GetPreGarbageCollectDelegate().AddLambda([&NumPre] { ++NumPre; });
    const FDelegateHandle Post = FCoreUObjectDelegates::GetPostGarbageCollect().AddLambda([&NumPost] { ++NumPost; });
    UReflectionPart* Part = NewObject<UReflectionPart>();
    const TWeakObjectPtr<UObject> Weak(Part);
    {
        FGCScopeGuard Guard;
        CHECK_FALSE(TryCollectGarbage(RF_NoFlags));
    }
    CHECK(Weak.IsValid());
    bool bSeen = false;
    for (TObjectIterator<UReflectionPart> It; It; ++It) {
        bSeen = bSeen || *It == Part;
    }
    CHECK(bSeen);
    CollectGarbage(RF_NoFlags, false);
    CHECK_FALSE(Weak.IsValid());
    CHECK(IsIncrementalPurgePending());
    IncrementalPurgeGarbage(false);
    CHECK_FALSE(IsIncrementalPurgePending());
    CHECK(NumPre == 1);
    CHECK(NumPost == 1);
    FCoreUObjectDelegates::GetPreGarbageCollectDelegate().Remove(Pre);
    FCoreUObjectDelegates::GetPostGarbageCollect().Remove(Post);
}

TEST_CASE("coreuobject gc: keep flags") {
    const TWeakObjectPtr<UObject> Standalone(
        NewObject<UReflectionPart>(GetTransientPackage(), FName(TEXT("KeptByFlag")), RF_Standalone));
    CollectGarbage(RF_Standalone);
    CHECK(Standalone.IsValid());
    CollectGarbage(RF_NoFlags);
    CHECK_FALSE(Standalone.IsValid());
}
