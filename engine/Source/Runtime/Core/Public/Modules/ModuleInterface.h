// SPDX-License-Identifier: MIT
#pragma once

#include "CoreTypes.h"

/** Base of module classes. */
class IModuleInterface {
public:
    virtual ~IModuleInterface() = default;
    /** Right after the library is loaded and its classes are registered. */
    virtual void StartupModule() {}
    virtual void PreUnloadCallback() {}
    virtual void PostLoadCallback() {}
    /** Before the library is unloaded; in reverse order of loading at shutdown. */
    virtual void ShutdownModule() {}
    virtual bool SupportsDynamicReloading() { return true; }
    virtual bool SupportsAutomaticShutdown() { return true; }
    virtual bool IsGameModule() const { return false; }
};
