// SPDX-License-Identifier: MIT
#include "ReflectionTestTypes.h"

#include "Modules/ModuleManager.h"
#include "UObject/Stack.h"

IMPLEMENT_MODULE(FDefaultModuleImpl, ReflectionTest)

int32 UReflectionSubject::NumDestroyed = 0;

UReflectionBase::UReflectionBase(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Part = ObjectInitializer.CreateDefaultSubobject<UReflectionPart>(this, TEXT("Part"));
}
int32 UReflectionBase::VirtualNumber() const { return 100; }
int32 UReflectionBase::NativeEvent_Implementation(int32 Number) { return Number + 1; }

UReflectionSubject::UReflectionSubject(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    bBitTwo = true;
    CreateOptionalDefaultSubobject<UReflectionPart>(TEXT("Extra"));
}
int32 UReflectionSubject::Add(int32 A, int32 B) const { return A + B; }
double UReflectionSubject::EchoDouble(double Value, float Single, int64 Wide) const {
    return Value + static_cast<double>(Single) + static_cast<double>(Wide);
}
bool UReflectionSubject::EchoBool(bool bValue, bool& bInverted) const {
    bInverted = !bValue;
    return bValue;
}
FString UReflectionSubject::EchoString(const FString& Value, FString& OutUpper, FName InName, FName& OutName) const {
    OutUpper = Value.ToUpper();
    OutName = InName;
    return Value;
}
FText UReflectionSubject::EchoText(const FText& Value) const { return Value; }
ETestColor UReflectionSubject::EchoEnum(ETestColor Value, TEnumAsByte<ERegularTestEnum> Regular,
    TEnumAsByte<ERegularTestEnum>& OutRegular, ETestFlags& OutFlags) const {
    OutRegular = Regular;
    OutFlags = ETestFlags::Big | ETestFlags::One;
    return Value;
}
FVector UReflectionSubject::EchoVector(const FVector& Value, FVector& OutDoubled, const FTransform& Transform3D) const {
    OutDoubled = Value * 2.0;
    return Value + Transform3D.GetTranslation();
}
FOuterTestStruct UReflectionSubject::EchoStruct(
    const FOuterTestStruct& Value, FInnerTestStruct ByValue, FInnerTestStruct& OutInner) const {
    OutInner = ByValue;
    return Value;
}
UObject* UReflectionSubject::EchoObject(UObject* Value, UReflectionSubject*& OutSelf, const UReflectionBase*) {
    OutSelf = this;
    return Value;
}
TSubclassOf<UReflectionBase> UReflectionSubject::EchoClass(
    TSubclassOf<UReflectionBase> Value, UClass* Any, UClass*& OutAny) const {
    OutAny = Any;
    return Value;
}
TArray<FString> UReflectionSubject::EchoArray(
    const TArray<int32>& Values, TArray<int32>& OutReversed, TArray<FInnerTestStruct>& OutStructs) const {
    TArray<FString> Texts;
    for (int32 Value : Values) {
        Texts.Add(LexToString(Value));
        OutReversed.Insert(Value, 0);
        OutStructs.AddDefaulted_GetRef().Count = Value;
    }
    return Texts;
}
TMap<FString, int32> UReflectionSubject::EchoMap(
    const TMap<FString, int32>& Value, TSet<FName> InSet, TSet<FName>& OutSet) const {
    OutSet = InSet;
    return Value;
}
TSoftObjectPtr<UObject> UReflectionSubject::EchoSoft(TSoftObjectPtr<UObject> Value,
    TSoftClassPtr<UReflectionBase> ClassValue, TSoftClassPtr<UReflectionBase>& OutClass) const {
    OutClass = ClassValue;
    return Value;
}
TWeakObjectPtr<UObject> UReflectionSubject::EchoWeak(TWeakObjectPtr<UObject> Value) const { return Value; }
TScriptInterface<ITestGreeter> UReflectionSubject::EchoInterface(const TScriptInterface<ITestGreeter>& Value) const {
    return Value;
}
void UReflectionSubject::CallBack(FTestDelegate Callback, int32 Number) const {
    Callback.ExecuteIfBound(Number, TEXT("called"));
}
void UReflectionSubject::ChangeInPlace(FInnerTestStruct& Value, TArray<int32>& Values) const {
    Value.Count += 1;
    Values.Add(Value.Count);
}
int32 UReflectionSubject::StaticSum(const UObject*, int32 A, int32 B) { return A + B; }
int32 UReflectionSubject::CustomDouble(int32 Value) { return Value * 2; }
DEFINE_FUNCTION(UReflectionSubject::execCustomDouble) {
    P_GET_PROPERTY(FIntProperty, Value);
    P_FINISH;
    // One more than the C++ function, so that the test knows who answered.
    *static_cast<int32*>(RESULT_PARAM) = P_THIS->CustomDouble(Value) + 1;
}
void UReflectionSubject::ServerSetNumber_Implementation(int32 Number) { LastNumber = Number; }
bool UReflectionSubject::ServerSetNumber_Validate(int32 Number) { return Number >= 0; }
void UReflectionSubject::SetNumberByCommand(int32 Number, const FString& Note) {
    LastNumber = Number;
    LastText = Note;
}
void UReflectionSubject::HandleEvent(int32 Number, const FString& Text3D) {
    LastNumber = Number;
    LastText = Text3D;
}
void UReflectionSubject::HandleMulticast(int32 Number) { LastNumber += Number; }
int32 UReflectionSubject::HandleRetVal(int32 Number) { return Number * 3; }
int32 UReflectionSubject::VirtualNumber() const { return 200; }
int32 UReflectionSubject::NativeEvent_Implementation(int32 Number) {
    return Super::NativeEvent_Implementation(Number) * 10;
}
FString UReflectionSubject::Greet_Implementation(const FString& InName) const { return TEXT("Hello ") + InName; }
void UReflectionSubject::AddTo_Implementation(int32& Total, int32 Amount) { Total += Amount; }
void UReflectionSubject::BeginDestroy() {
    ++NumDestroyed;
    Super::BeginDestroy();
}
void UReflectionSubject::SetGuarded(float Value) {
    ++NumSetterCalls;
    Guarded = FMath::Clamp(Value, 0.0f, 10.0f);
}

UReflectionChild::UReflectionChild(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer.SetDefaultSubobjectClass<UReflectionDerivedPart>(TEXT("Part"))
              .DoNotCreateDefaultSubobject(TEXT("Extra"))) {}

UReflectionLegacy::UReflectionLegacy(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Number = 5;
}
