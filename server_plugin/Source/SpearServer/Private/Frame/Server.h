// SPDX-License-Identifier: MIT
#pragma once

// The server as a whole: spear_wire's callbacks on one side, the frames on the other.

#include "CoreMinimal.h"

#include "Frame/FrameRunner.h"
#include "Frame/Inbox.h"
#include "Frame/Result.h"

#include "spear_wire.h"

#include <string>
#include <vector>

namespace SpearServer {

struct FServerOptions {
    std::string Address;
    std::vector<uint8> Token;
    uint32 LeaseMs = 0;             ///< 0: the default
    std::size_t MaxQueuedBytes = 0; ///< 0: limits::max_queued_bytes
};

class FServer {
public:
    FServer() : Runner(Inbox) {}
    ~FServer() { Stop(); }
    FServer(const FServer&) = delete;
    FServer& operator=(const FServer&) = delete;

    /// Listens. Game thread.
    FStatus Start(const FServerOptions& Options);
    /// Ends all sessions. Game thread.
    void Stop();
    const std::string& GetAddress() const { return Address; }

private:
    static int OnConnect(void* User, const spear_hello* Hello, spear_wire_error* Error);
    static void OnDisconnect(void* User, uint64_t Session, const char* Reason);
    static void OnSubmit(void* User, uint64_t Session, uint64_t Request, const spear_batch* Batch);
    static void OnStatus(void* User, uint64_t Session, spear_status* Status);
    static void OnDescribe(void* User, spear_description* Description);
    static void OnLog(void* User, const char* Text);

    FInbox Inbox;
    FFrameRunner Runner;
    std::atomic<spear_server*> Wire{nullptr};
    std::string Address;
};

} // namespace SpearServer
