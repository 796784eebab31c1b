// SPDX-License-Identifier: MIT
#include "RoundTrip.h"
#include "RoundTripCalls.h"

#include "Engine/Engine.h"
#include "Engine/World.h"
#include "HAL/PlatformProcess.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "UObject/Stack.h"
#include "UObject/UObjectGlobals.h"

#include <dlfcn.h>
#include <malloc.h>

void URoundTrip::CallListener(int32 Number) {
    if (UObject* Listener = InterfaceValue.GetObject()) {
        IRoundTripListener::Execute_Hear(Listener, Number);
    }
}

FString URoundTripCalls::Describe(const FString& Text, int32 Number, double Weight, FVector Place, bool bLoud,
    ERoundTripMode Mode, FName Tag, const FString& Suffix, UObject* Object) {
    return FString::Printf(TEXT("%s %d %.2f %.0f,%.0f,%.0f %d %d %s%s %d"), *Text, Number, Weight, Place.X, Place.Y,
        Place.Z, bLoud ? 1 : 0, static_cast<int32>(Mode), *Tag.ToString(), *Suffix, Object ? 1 : 0);
}

bool URoundTripCalls::Split(const FString& Text, FString& Left, FString& Right) {
    return Text.Split(TEXT("|"), &Left, &Right);
}

bool URoundTripCalls::Pair(AActor* First, AActor* Second, AActor*& OutFirst, AActor*& OutSecond) {
    OutFirst = First;
    OutSecond = Second;
    return First && Second;
}

FString URoundTripCalls::WorldName(const UObject* WorldContextObject) {
    const UWorld* World = WorldContextObject ? WorldContextObject->GetWorld() : nullptr;
    return World ? World->GetName() : FString();
}

FString URoundTripCalls::WhoAmI_Implementation() { return TEXT("parent"); }

void URoundTripCalls::Thunked(int32 Number) {}

DEFINE_FUNCTION(URoundTripCalls::execThunked) {
    P_GET_PROPERTY(FIntProperty, Number);
    P_FINISH;
    static_cast<URoundTripCalls*>(P_THIS_OBJECT)->Thunked(Number);
}

void URoundTripCalls::CollectNow() { CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS); }

int64 URoundTripCalls::AllocatedBytes() {
    const struct mallinfo2 Info = mallinfo2();
    return static_cast<int64>(Info.uordblks + Info.hblkhd);
}

int64 URoundTripCalls::Ticket() {
    static int64 Last = 0;
    return ++Last;
}

int64 URoundTripCalls::Allocations() {
    using FCount = uint64_t (*)();
    static const auto Count = reinterpret_cast<FCount>(dlsym(RTLD_DEFAULT, "spear_test_allocations"));
    return Count ? static_cast<int64>(Count()) : -1;
}

void URoundTripCalls::BlockFrames(const FString& Folder) {
    FFileHelper::SaveStringToFile(TEXT("began"), *(Folder / TEXT("began")));
    while (!FPaths::FileExists(Folder / TEXT("go"))) {
        FPlatformProcess::Sleep(0.001f);
    }
}

TArray<uint8> URoundTripCalls::Bytes(int64 Count) {
    TArray<uint8> Result;
    Result.SetNumZeroed(static_cast<int32>(Count));
    return Result;
}

double URoundTripCalls::GetGuarded() const { return Guarded; }

void URoundTripCalls::SetGuarded(double NewGuarded) {
    Guarded = FMath::Clamp(NewGuarded, 0.0, 10.0);
    ++SetterCalls;
}

void URoundTripCalls::SetSnapped(const FVector& NewSnapped) {
    Snapped = FVector(
        FMath::RoundToDouble(NewSnapped.X), FMath::RoundToDouble(NewSnapped.Y), FMath::RoundToDouble(NewSnapped.Z));
    ++SetterCalls;
}

IMPLEMENT_MODULE(FDefaultModuleImpl, RoundTrip)
