// SPDX-License-Identifier: MIT
#include "SpearBench.h"

#include "HAL/PlatformTime.h"
#include "UObject/Class.h"

double USpearBench::MeasureDirect(int32 Calls, bool bByName) {
    const FName Name(TEXT("Move"));
    UFunction* const Kept = FindFunctionChecked(Name);
    const double Began = FPlatformTime::Seconds();
    for (int32 Call = 0; Call < Calls; ++Call) {
        struct {
            FVector By = FVector(1, 0, 0);
            FVector ReturnValue = FVector::ZeroVector;
        } Parameters;
        ProcessEvent(bByName ? FindFunctionChecked(Name) : Kept, &Parameters);
    }
    return (FPlatformTime::Seconds() - Began) * 1e9 / FMath::Max(Calls, 1);
}
