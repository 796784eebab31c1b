// SPDX-License-Identifier: MIT
// Class default objects, construction, names, paths, subobjects, copies.
#include "coreuobject_fixture.h"

#include "UObject/ContentLoader.h"

using namespace reflection_test;

TEST_CASE("coreuobject: class default objects") {
    const UReflectionSubject* Default = GetDefault<UReflectionSubject>();
    CHECK(Default->HasAnyFlags(RF_ClassDefaultObject));
    CHECK(Default->GetName() == TEXT("Default__ReflectionSubject"));
    CHECK(Default->GetPathName() == TEXT("/Script/ReflectionTest.Default__ReflectionSubject"));
    CHECK(Default->Int32Value == 42);
    CHECK(Default->GetClass()->GetDefaultObject() == Default);
    // Abstract classes have one too.
    CHECK(UReflectionBase::StaticClass()->GetDefaultObject() != nullptr);
    CHECK(UReflectionBase::StaticClass()->HasAnyClassFlags(CLASS_Abstract));
    CHECK_FALSE(UReflectionSubject::StaticClass()->HasAnyClassFlags(CLASS_Abstract));
    CHECK(MakeSubject()->GetArchetype() == Default);
}

TEST_CASE("coreuobject: names and paths") {
    UReflectionSubject* Subject = NewObject<UReflectionSubject>(GetTransientPackage(), TEXT("Named"));
    CHECK(Subject->GetPathName() == TEXT("/Engine/Transient.Named"));
    CHECK(Subject->Part->GetPathName() == TEXT("/Engine/Transient.Named:Part"));
    CHECK(Subject->GetFullName() == TEXT("ReflectionSubject /Engine/Transient.Named"));
    UReflectionPart* Deep = NewObject<UReflectionPart>(Subject->Part, TEXT("Deep"));
    CHECK(Deep->GetPathName() == TEXT("/Engine/Transient.Named:Part.Deep"));
    CHECK(Deep->GetPathName(Subject) == TEXT("Part.Deep"));
    CHECK(FindObject<UObject>(nullptr, TEXT("/engine/transient.named:part.deep")) == Deep);
    CHECK(FindObject<UObject>(Subject, TEXT("Part.Deep")) == Deep);
    CHECK(FindObject<UReflectionSubject>(nullptr, TEXT("/Engine/Transient.Named:Part.Deep")) == nullptr);
    CHECK(FindFirstObject<UReflectionSubject>(TEXT("Named")) == Subject);
    CHECK(Deep->GetTypedOuter<UReflectionSubject>() == Subject);
    CHECK(Deep->IsIn(Subject));
    CHECK(Deep->GetOutermost() == GetTransientPackage());
    CHECK(UReflectionSubject::StaticClass()->GetPathName() == TEXT("/Script/ReflectionTest.ReflectionSubject"));
    CHECK(UObject::StaticClass()->GetPathName() == TEXT("/Script/CoreUObject.Object"));
    CHECK(UClass::StaticClass()->GetClass() == UClass::StaticClass());
    CHECK(FindObject<UClass>(nullptr, TEXT("/Script/CoreUObject.Class")) == UClass::StaticClass());
    CHECK(LoadClass<UReflectionBase>(nullptr, TEXT("/Script/ReflectionTest.ReflectionChild")) ==
          UReflectionChild::StaticClass());
    CHECK(
        LoadObject<UObject>(nullptr, TEXT("/Engine/Transient.Nothing"), nullptr, LOAD_NoWarn | LOAD_Quiet) == nullptr);
}

TEST_CASE("coreuobject: unique names and renaming") {
    UReflectionPart* First = NewObject<UReflectionPart>();
    UReflectionPart* Second = NewObject<UReflectionPart>();
    CHECK(First->GetFName() != Second->GetFName());
    CHECK(First->GetName().StartsWith(TEXT("ReflectionPart_")));
    UReflectionSubject* Outer = MakeSubject();
    CHECK(First->Rename(TEXT("Moved"), Outer));
    CHECK(First->GetOuter() == Outer);
    CHECK(StaticFindObjectFast(nullptr, Outer, TEXT("Moved")) == First);
    CHECK_FALSE(Second->Rename(TEXT("Moved"), Outer, REN_Test));
    CHECK(Second->Rename(TEXT("Other"), Outer));
}

TEST_CASE("coreuobject: a new object takes the place of one with the same name") {
    UReflectionPart* Old = NewObject<UReflectionPart>(GetTransientPackage(), TEXT("Replaced"));
    Old->Value = 77;
    const TWeakObjectPtr<UReflectionPart> Weak(Old);
    UReflectionPart* New = NewObject<UReflectionPart>(GetTransientPackage(), TEXT("replaced"));
    CHECK(New == Old);
    CHECK(New->Value == 1);
    CHECK_FALSE(Weak.IsValid());
    CHECK(TWeakObjectPtr<UReflectionPart>(New).IsValid());
}

TEST_CASE("coreuobject: default subobjects") {
    UReflectionSubject* Subject = MakeSubject();
    REQUIRE(Subject->Part != nullptr);
    CHECK(Subject->Part->GetOuter() == Subject);
    CHECK(Subject->Part->IsDefaultSubobject());
    CHECK(Subject->Part != GetDefault<UReflectionSubject>()->Part);
    CHECK(Subject->GetDefaultSubobjectByName(TEXT("Extra")) != nullptr);
    TArray<UObject*> Parts;
    Subject->GetDefaultSubobjects(Parts);
    CHECK(Parts.Num() == 2);

    UReflectionChild* Child = NewObject<UReflectionChild>();
    CHECK(Child->Part->IsA<UReflectionDerivedPart>());
    CHECK(Child->GetDefaultSubobjectByName(TEXT("Extra")) == nullptr);
    CHECK(GetDefault<UReflectionChild>()->Part->HasAnyFlags(RF_ArchetypeObject));
}

TEST_CASE("coreuobject: constructors") {
    CHECK(NewObject<UReflectionImplicit>()->Int32Value == 42);
    CHECK(NewObject<UReflectionLegacy>()->Number == 5);
    UReflectionSubject* Subject = MakeSubject();
    CHECK(NewObject<UReflectionWithin>(Subject)->GetOuter() == Subject);
    CHECK(UReflectionWithin::StaticClass()->ClassWithin == UReflectionSubject::StaticClass());
}

TEST_CASE("coreuobject: templates") {
    UReflectionSubject* Template = MakeSubject();
    Template->Int32Value = 1000;
    Template->Strings = {TEXT("x")};
    CastChecked<UReflectionPart>(Template->Part.Get())->Value = 55;
    Template->Strong = Template->Part;
    UObject* Outside = NewObject<UReflectionPart>();
    Template->Objects.Add(Outside);
    UReflectionSubject* Copy = NewObject<UReflectionSubject>(GetTransientPackage(), NAME_None, RF_NoFlags, Template);
    CHECK(Copy->Int32Value == 1000);
    CHECK(Copy->Strings == TArray<FString>{TEXT("x")});
    REQUIRE(Copy->Part != nullptr);
    CHECK(Copy->Part != Template->Part);
    CHECK(Copy->Part->GetOuter() == Copy);
    CHECK(CastChecked<UReflectionPart>(Copy->Part.Get())->Value == 55);
    CHECK(Copy->Strong == Copy->Part);
    CHECK(Copy->Objects[0] == Outside);
}

TEST_CASE("coreuobject: duplicates") {
    UReflectionSubject* Source = MakeSubject();
    Source->String = TEXT("copied");
    Source->TransientValue = 5;
    Source->Strong = NewObject<UReflectionPart>(Source, TEXT("Inner"));
    Source->RawStrong = Source;
    UReflectionSubject* Copy = DuplicateObject(Source, GetTransientPackage(), TEXT("TheCopy"));
    CHECK(Copy->GetName() == TEXT("TheCopy"));
    CHECK(Copy->String == TEXT("copied"));
    CHECK(Copy->TransientValue == 0);
    CHECK(Copy->RawStrong == Copy);
    CHECK(Copy->Strong != Source->Strong);
    CHECK(Copy->Strong->GetOuter() == Copy);
    CHECK(Copy->Strong->GetName() == TEXT("Inner"));
    CHECK(Copy->Part->GetOuter() == Copy);
}

TEST_CASE("coreuobject: casts") {
    UObject* Object = MakeSubject();
    CHECK(Cast<UReflectionBase>(Object) == Object);
    CHECK(Cast<UReflectionChild>(Object) == nullptr);
    CHECK(Cast<UReflectionChild>(static_cast<UObject*>(nullptr)) == nullptr);
    CHECK(Cast<UClass>(static_cast<UObject*>(UObject::StaticClass())) == UObject::StaticClass());
    CHECK(Cast<UStruct>(static_cast<UObject*>(UObject::StaticClass())) != nullptr);
    CHECK(ExactCast<UReflectionBase>(Object) == nullptr);
    const UObject* Constant = Object;
    CHECK(Cast<UReflectionSubject>(Constant) == Object);
    CHECK(Object->IsA(UReflectionBase::StaticClass()));
    TSubclassOf<UReflectionChild> Wrong = UReflectionSubject::StaticClass();
    CHECK(Wrong.Get() == nullptr);
    CHECK(TSubclassOf<UReflectionBase>(UReflectionChild::StaticClass())->GetName() == TEXT("ReflectionChild"));
}

TEST_CASE("coreuobject: content loaders supply objects by path") {
    int32 NumAsked = 0;
    FContentLoaderRegistry::Register(
        TEXT("Test"), [&NumAsked](UClass*, const FString& PackageName, const FString& AssetName) -> UObject* {
            ++NumAsked;
            return PackageName == TEXT("/Test/Thing")
                       ? NewObject<UReflectionPart>(CreatePackage(*PackageName), FName(*AssetName), RF_Public)
                       : nullptr;
        });
    UReflectionPart* Thing = LoadObject<UReflectionPart>(nullptr, TEXT("/Test/Thing.Thing"));
    REQUIRE(Thing != nullptr);
    CHECK(Thing->GetPathName() == TEXT("/Test/Thing.Thing"));
    CHECK(LoadObject<UReflectionPart>(nullptr, TEXT("/Test/Thing")) == Thing);
    CHECK(NumAsked == 1);
    CHECK(TSoftObjectPtr<UReflectionPart>(FSoftObjectPath(TEXT("/Test/Thing.Thing"))).LoadSynchronous() == Thing);
    FContentLoaderRegistry::Unregister(TEXT("Test"));
    CHECK(LoadObject<UReflectionPart>(nullptr, TEXT("/Test/Missing.Missing"), nullptr, LOAD_NoWarn | LOAD_Quiet) ==
          nullptr);
}

TEST_CASE("coreuobject: soft paths") {
    const FSoftObjectPath Path(TEXT("/Game/Maps/Town.Town:PersistentLevel.Lamp"));
    CHECK(Path.GetLongPackageName() == TEXT("/Game/Maps/Town"));
    CHECK(Path.GetAssetName() == TEXT("Town"));
    CHECK(Path.GetSubPathString() == TEXT("PersistentLevel.Lamp"));
    CHECK(Path.ToString() == TEXT("/Game/Maps/Town.Town:PersistentLevel.Lamp"));
    CHECK(Path.IsSubobject());
    CHECK(FSoftObjectPath(TEXT("StaticMesh'/Game/A.A'")).ToString() == TEXT("/Game/A.A"));
    CHECK(FSoftObjectPath(TEXT("nonsense")).IsNull());
    UReflectionSubject* Subject = MakeSubject();
    CHECK(FSoftObjectPath(Subject->Part.Get()).ResolveObject() == Subject->Part);
}

TEST_CASE("coreuobject: lazy pointers") {
    UReflectionSubject* Subject = MakeSubject();
    Subject->Lazy = Subject->Part;
    CHECK(Subject->Lazy.Get() == Subject->Part);
    CHECK(Subject->Lazy.GetUniqueID().IsValid());
}
