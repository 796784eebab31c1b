// SPDX-License-Identifier: MIT
#include "UObject/Field.h"

#include "UObject/Class.h"
#include "UObject/Package.h"

FFieldClass::FFieldClass(
    const TCHAR* InCPPName, uint64 InId, uint64 InCastFlags, FFieldClass* InSuperClass, ConstructFn InConstruct)
    : Name(InCPPName), Id(InId), CastFlags(InCastFlags), SuperClass(InSuperClass), ConstructFunction(InConstruct) {
    GetAllFieldClasses().Add(this);
}
TArray<FFieldClass*>& FFieldClass::GetAllFieldClasses() {
    static TArray<FFieldClass*>& Instance = *new TArray<FFieldClass*>;
    return Instance;
}
FFieldClass* FFieldClass::FindFieldClass(FName InName) {
    const FString Text = InName.ToString();
    const FName Short(*(Text.StartsWith(TEXT("F"), ESearchCase::CaseSensitive) ? Text.Mid(1) : Text));
    for (FFieldClass* Class : GetAllFieldClasses()) {
        if (Class->GetFName() == InName || Class->GetFName() == Short) {
            return Class;
        }
    }
    return nullptr;
}

FFieldVariant FFieldVariant::GetOwnerVariant() const {
    if (!IsValid()) {
        return FFieldVariant();
    }
    return bIsUObject ? FFieldVariant(ToUObject()->GetOuter()) : ToField()->GetOwnerVariant();
}
FName FFieldVariant::GetFName() const {
    return !IsValid() ? FName(NAME_None) : (bIsUObject ? ToUObject()->GetFName() : ToField()->GetFName());
}
FString FFieldVariant::GetName() const { return GetFName().ToString(); }
FString FFieldVariant::GetPathName() const {
    return !IsValid() ? FString(TEXT("None")) : (bIsUObject ? ToUObject()->GetPathName() : ToField()->GetPathName());
}
FString FFieldVariant::GetFullName() const {
    return !IsValid() ? FString(TEXT("None")) : (bIsUObject ? ToUObject()->GetFullName() : ToField()->GetFullName());
}

FFieldClass* FField::StaticClass() {
    static FFieldClass StaticFieldClass(TEXT("Field"), 0, 0, nullptr, nullptr);
    return &StaticFieldClass;
}

FField::FField(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)
    : Owner(InOwner), NamePrivate(InName), FlagsPrivate(InObjectFlags), ClassPrivate(StaticClass()) {}
FField::~FField() {
#if WITH_METADATA
    delete MetaDataMap;
#endif
}

UObject* FField::GetOwnerUObject() const {
    FFieldVariant Current = Owner;
    while (Current.IsValid() && !Current.IsUObject()) {
        Current = Current.ToField()->Owner;
    }
    return Current.ToUObject();
}
UStruct* FField::GetOwnerStruct() const { return Cast<UStruct>(GetOwnerUObject()); }
UField* FField::GetOwnerUField() const { return Cast<UField>(GetOwnerUObject()); }
UClass* FField::GetOwnerClass() const {
    UField* Field = GetOwnerUField();
    return Field ? Field->GetOwnerClass() : nullptr;
}
UPackage* FField::GetOutermost() const {
    UObject* Object = GetOwnerUObject();
    return Object ? Object->GetPackage() : nullptr;
}
FString FField::GetPathName(const UObject* StopOuter) const {
    if (!Owner.IsValid()) {
        return GetName();
    }
    return (Owner.IsUObject() ? Owner.ToUObject()->GetPathName(StopOuter) : Owner.ToField()->GetPathName(StopOuter)) +
           SUBOBJECT_DELIMITER + GetName();
}
FString FField::GetFullName() const { return GetClass()->GetName() + TEXT(" ") + GetPathName(); }
FString GetFullNameSafe(const FField* InField) { return InField ? InField->GetFullName() : FString(TEXT("None")); }
FString GetPathNameSafe(const FField* InField) { return InField ? InField->GetPathName() : FString(TEXT("None")); }

#if WITH_METADATA
const FString* FField::FindMetaData(const FName& Key) const { return MetaDataMap ? MetaDataMap->Find(Key) : nullptr; }
const FString* FField::FindMetaData(const TCHAR* Key) const { return FindMetaData(FName(Key)); }
const FString& FField::GetMetaData(const FName& Key) const {
    static const FString Empty;
    const FString* Found = FindMetaData(Key);
    return Found ? *Found : Empty;
}
const FString& FField::GetMetaData(const TCHAR* Key) const { return GetMetaData(FName(Key)); }
bool FField::GetBoolMetaData(const FName& Key) const {
    const FString* Found = FindMetaData(Key);
    return Found && (Found->IsEmpty() || Found->ToBool());
}
int32 FField::GetIntMetaData(const FName& Key) const { return FCString::Atoi(*GetMetaData(Key)); }
float FField::GetFloatMetaData(const FName& Key) const { return FCString::Atof(*GetMetaData(Key)); }
void FField::SetMetaData(const FName& Key, const FString& InValue) {
    if (!MetaDataMap) {
        MetaDataMap = new TMap<FName, FString>;
    }
    MetaDataMap->Add(Key, InValue);
}
void FField::RemoveMetaData(const FName& Key) {
    if (MetaDataMap) {
        MetaDataMap->Remove(Key);
    }
}
FText FField::GetDisplayNameText() const {
    const FString* DisplayName = FindMetaData(TEXT("DisplayName"));
    return FText::FromString(
        DisplayName ? *DisplayName
                    : FName::NameToDisplayString(GetName(), ClassPrivate->GetName() == TEXT("BoolProperty")));
}
FText FField::GetToolTipText(bool) const {
    const FString* ToolTip = FindMetaData(TEXT("ToolTip"));
    return ToolTip ? FText::FromString(*ToolTip) : GetDisplayNameText();
}
#endif
