// SPDX-License-Identifier: MIT
// Weak, soft and lazy pointers.
#include <unordered_map>

#include "ObjectSystem.h"
#include "PropertyText.h"
#include "UObject/LazyObjectPtr.h"
#include "UObject/SoftObjectPath.h"
#include "UObject/SoftObjectPtr.h"
#include "UObject/SparseDelegate.h"
#include "UObject/UnrealType.h"
#include "UObject/WeakObjectPtr.h"

void FWeakObjectPtr::operator=(const UObject* Object) {
    // A dying object takes no new weak pointers.
    if (Object && GUObjectArray.IsValid(Object) && !Object->IsUnreachable()) {
        ObjectIndex = static_cast<int32>(Object->GetUniqueID());
        ObjectSerialNumber = GUObjectArray.AllocateSerialNumber(ObjectIndex);
    } else {
        Reset();
    }
}
FUObjectItem* FWeakObjectPtr::FindItem() const {
    if (ObjectSerialNumber == 0) {
        return nullptr;
    }
    FUObjectItem* Item = GUObjectArray.IndexToObject(ObjectIndex);
    return Item && Item->Object && Item->SerialNumber == ObjectSerialNumber ? Item : nullptr;
}
UObject* FWeakObjectPtr::Get(bool bEvenIfGarbage) const {
    const FUObjectItem* Item = FindItem();
    return Item && !Item->IsUnreachable() && (bEvenIfGarbage || !Item->IsGarbage())
               ? static_cast<UObject*>(Item->Object)
               : nullptr;
}
UObject* FWeakObjectPtr::GetEvenIfUnreachable() const {
    const FUObjectItem* Item = FindItem();
    return Item ? static_cast<UObject*>(Item->Object) : nullptr;
}
bool FWeakObjectPtr::IsValid(bool bEvenIfGarbage, bool bThreadsafeTest) const {
    return bThreadsafeTest ? FindItem() != nullptr : Get(bEvenIfGarbage) != nullptr;
}
bool FWeakObjectPtr::IsStale(bool bIncludingGarbage, bool bThreadsafeTest) const {
    return !IsExplicitlyNull() && !IsValid(!bIncludingGarbage, bThreadsafeTest);
}

// ---------------------------------------------------------------------------------------------------------------------------

FTopLevelAssetPath::FTopLevelAssetPath(const UObject* InObject) {
    if (!InObject) {
        return;
    }
    if (!InObject->GetOuter()) {
        PackageName = InObject->GetFName();
    } else if (!InObject->GetOuter()->GetOuter()) {
        PackageName = InObject->GetOuter()->GetFName();
        AssetName = InObject->GetFName();
    }
}
bool FTopLevelAssetPath::TrySetPath(const FString& Path) {
    Reset();
    if (!Path.StartsWith(TEXT("/"))) {
        return false;
    }
    int32 Dot = INDEX_NONE;
    if (!Path.FindChar(TCHAR('.'), Dot)) {
        PackageName = FName(*Path);
        return true;
    }
    const FString Asset = Path.Mid(Dot + 1);
    int32 Unused = INDEX_NONE;
    if (Asset.IsEmpty() || Asset.FindChar(TCHAR('.'), Unused) || Asset.FindChar(TCHAR(':'), Unused)) {
        return false;
    }
    PackageName = FName(*Path.Left(Dot));
    AssetName = FName(*Asset);
    return true;
}
FString FTopLevelAssetPath::ToString() const {
    if (!IsValid()) {
        return FString();
    }
    return AssetName.IsNone() ? PackageName.ToString() : PackageName.ToString() + TEXT(".") + AssetName.ToString();
}

FSoftObjectPath::FSoftObjectPath(const UObject* InObject) {
    if (InObject) {
        SetPath(InObject->GetPathName());
    }
}
FString FSoftObjectPath::ToString() const {
    if (IsNull()) {
        return FString();
    }
    return SubPathString.IsEmpty() ? AssetPath.ToString() : AssetPath.ToString() + SUBOBJECT_DELIMITER + SubPathString;
}
void FSoftObjectPath::SetPath(const FString& InPath) {
    Reset();
    FString Path = InPath;
    int32 Quote = INDEX_NONE;
    if (Path.FindChar(TCHAR('\''), Quote)) {
        Path = Path.Mid(Quote + 1);
        Path.RemoveFromEnd(TEXT("'"));
    }
    if (Path.IsEmpty() || Path == TEXT("None")) {
        return;
    }
    int32 Colon = INDEX_NONE;
    if (Path.FindChar(TCHAR(':'), Colon)) {
        SubPathString = Path.Mid(Colon + 1);
        Path.LeftInline(Colon);
    } else {
        // "/Package.Asset.Sub" is an old way to write "/Package.Asset:Sub".
        int32 Dot = INDEX_NONE;
        if (Path.FindChar(TCHAR('.'), Dot)) {
            const int32 Second = Path.Find(TEXT("."), ESearchCase::CaseSensitive, ESearchDir::FromStart, Dot + 1);
            if (Second != INDEX_NONE) {
                SubPathString = Path.Mid(Second + 1);
                Path.LeftInline(Second);
            }
        }
    }
    if (!AssetPath.TrySetPath(Path)) {
        SubPathString.Reset();
    }
}
UObject* FSoftObjectPath::ResolveObject() const {
    return IsNull() ? nullptr : FindObject<UObject>(nullptr, *ToString());
}
UObject* FSoftObjectPath::TryLoad(void*) const {
    return IsNull() ? nullptr : StaticLoadObject(UObject::StaticClass(), nullptr, *ToString());
}
bool FSoftObjectPath::ExportTextItem(FString& ValueStr, const FSoftObjectPath& DefaultValue, UObject* Parent,
    int32 PortFlags, UObject* ExportRootScope) const {
    ValueStr += IsNull() ? (PortFlags & PPF_Delimited ? FString(TEXT("\"\"")) : FString())
                         : (PortFlags & PPF_Delimited ? PropertyText::Quote(ToString()) : ToString());
    return true;
}
bool FSoftObjectPath::ImportTextItem(const TCHAR*& Buffer, int32 PortFlags, UObject* Parent, FOutputDevice* ErrorText) {
    PropertyText::FReader Reader(Buffer);
    // "(AssetPath=...)" is the text of the members; leave it to the general rule.
    if (Reader.Is('(')) {
        return false;
    }
    FString Token;
    if (!Reader.ReadToken(Token)) {
        return false;
    }
    SetPath(Token);
    Buffer = Reader.Cursor();
    return true;
}

FSoftClassPath::FSoftClassPath(const UClass* InClass) : FSoftObjectPath(static_cast<const UObject*>(InClass)) {}
UClass* FSoftClassPath::ResolveClass() const { return Cast<UClass>(ResolveObject()); }
UClass* FSoftClassPath::LoadClassOfBase(UClass* BaseClass) const {
    return IsNull() ? nullptr : StaticLoadClass(BaseClass, nullptr, *ToString());
}

// ---------------------------------------------------------------------------------------------------------------------------

namespace {
struct FGuidHash {
    SIZE_T operator()(const FGuid& Guid) const { return GetTypeHash(Guid); }
};
struct FGuidTables {
    std::unordered_map<const UObject*, FGuid> ByObject;
    std::unordered_map<FGuid, const UObject*, FGuidHash> ByGuid;
};
FGuidTables& GuidTables() {
    static FGuidTables& Instance = *new FGuidTables;
    return Instance;
}
} // namespace

FUniqueObjectGuid::FUniqueObjectGuid(const UObject* InObject) {
    const auto Found = GuidTables().ByObject.find(InObject);
    if (Found != GuidTables().ByObject.end()) {
        Guid = Found->second;
    }
}
FUniqueObjectGuid FUniqueObjectGuid::GetOrCreateIDForObject(const UObject* Object) {
    FUniqueObjectGuid Result(Object);
    if (!Result.IsValid() && Object) {
        Result.Guid = FGuid::NewGuid();
        GuidTables().ByObject[Object] = Result.Guid;
        GuidTables().ByGuid[Result.Guid] = Object;
    }
    return Result;
}
UObject* FUniqueObjectGuid::ResolveObject() const {
    const auto Found = GuidTables().ByGuid.find(Guid);
    return Found != GuidTables().ByGuid.end() ? const_cast<UObject*>(Found->second) : nullptr;
}
FString FUniqueObjectGuid::ToString() const { return Guid.ToString(EGuidFormats::UniqueObjectGuid); }
bool FUniqueObjectGuid::FromString(const FString& From) { return FGuid::Parse(From, Guid); }

void FObjectSystem::ForgetObject(const UObject* Object) {
    FSparseDelegateStorage::NotifyObjectDestroyed(Object);
    FGuidTables& Tables = GuidTables();
    const auto Found = Tables.ByObject.find(Object);
    if (Found != Tables.ByObject.end()) {
        Tables.ByGuid.erase(Found->second);
        Tables.ByObject.erase(Found);
    }
}
