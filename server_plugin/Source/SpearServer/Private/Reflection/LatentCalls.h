// SPDX-License-Identifier: MIT
#pragma once

// Latent functions (UFUNCTION(meta=(Latent, LatentInfo=...)): they complete frames after they were called. Game thread
// only.

#include "CoreMinimal.h"
#include "UObject/StrongObjectPtr.h"
#include "UObject/WeakObjectPtr.h"

#include "Reflection/CallPlan.h"

#include <functional>
#include <map>
#include <memory>

class USpearLatentReceiver;
class UWorld;

namespace SpearServer {

class FLatentCalls {
public:
    static FLatentCalls& Get();

    void Start(std::function<FSession*(uint64)> InFindSession);
    void Stop();

    /// Notes a call that is about to be made; returns its number. The plan and the parameters live until it completes.
    int32 Begin(
        uint64 Session, uint64 Operation, std::shared_ptr<FCallPlan> Plan, std::shared_ptr<FParameters> Parameters);
    /// Fills an FLatentActionInfo.
    void FillInfo(int32 Call, void* LatentInfo) const;
    /// After the function has returned: whether it has completed already (the call is then forgotten). If not, its
    /// result goes to the session's kept results later.
    bool Completed(int32 Call);
    /// From the receiver.
    void NoteCompleted(int32 Call);

private:
    struct FCall {
        uint64 Session = 0;
        uint64 Operation = 0;
        std::shared_ptr<FCallPlan> Plan;
        std::shared_ptr<FParameters> Parameters;
        bool bReturned = false; ///< from the first call
        bool bCompleted = false;
    };
    void Finish(const FCall& Call);
    void OnWorldCleanup(UWorld* World, bool bSessionEnded, bool bCleanupResources);

    std::function<FSession*(uint64)> FindSession;
    TStrongObjectPtr<USpearLatentReceiver> Receiver;
    FDelegateHandle WorldCleanupHandle;
    std::map<int32, FCall> Calls;
    int32 LastCall = 0;
};

} // namespace SpearServer
