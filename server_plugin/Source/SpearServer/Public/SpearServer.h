// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Modules/ModuleInterface.h"
#include "Modules/ModuleManager.h"

/**
 * The SPEAR server: lets programs in other processes call the reflection system of this application. It starts with the
 * engine and needs no calls. Command line options:
 *
 * - `-SpearAddress=unix:/path` or `-SpearAddress=tcp://host:port`: where to listen. By default at a Unix socket in
 *   $XDG_RUNTIME_DIR/spear or /tmp/spear-<uid>.
 * - `-SpearToken=text`, `-SpearTokenFile=path`: what clients must know; needed for addresses other than loopback.
 * - `-SpearLease=milliseconds`: how long a silent client is taken for alive, if it does not ask for something else.
 * - `-SpearQueuedBytes=bytes`: how much one client may have waiting for its frame, less than
 *   limits::max_queued_bytes, for machines with little memory.
 * - `-SpearOff`: no server.
 */
class ISpearServerModule : public IModuleInterface {
public:
    static ISpearServerModule* Get() { return FModuleManager::Get().GetModulePtr<ISpearServerModule>("SpearServer"); }

    /** Where clients can connect, e.g. "unix:/tmp/spear-1000/4711.sock"; empty while the server does not run. */
    virtual FString GetAddress() const = 0;
};
