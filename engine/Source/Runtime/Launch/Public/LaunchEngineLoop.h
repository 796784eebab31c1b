// SPDX-License-Identifier: MIT
/** @file The main loop. Mirrors UE's LaunchEngineLoop.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"

#include <vector>

struct FLaunchOptions;
struct FPluginDescriptor;

/**
 * Implements the main engine loop: PreInit, Init, Tick until IsEngineExitRequested(), Exit.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Launch/FEngineLoop
 */
class FEngineLoop : public IEngineLoop {
public:
    FEngineLoop();
    virtual ~FEngineLoop();

    /** Sets up the command line, the log, time and random numbers, and loads the modules of engine and plugins. @return
     * 0, or the code to exit with. */
    int32 PreInit(const FLaunchOptions& Options);
    /** Makes the engine, broadcasts OnPostEngineInit, loads the map. @return 0, or the code to exit with. */
    virtual int32 Init() override;
    /** Runs one frame: OnBeginFrame, time, engine tick, OnEndFrame, then GFrameCounter counts. */
    virtual void Tick() override;
    /** Nothing is deferred beyond a frame here. */
    virtual void ClearPendingCleanupObjects() override {}
    /** Ends everything in the reverse order: OnEnginePreExit with worlds alive, EndPlay, modules. Safe to call after a
     * failed Init. */
    void Exit();

private:
    bool LoadPluginModules(bool bPostEngineInit);
    bool LoadNamedModule(const FString& ModuleName, const FString& WhatFor);
    void PrintScene() const;

    TUniquePtr<FLaunchOptions> LaunchOptions;
    std::vector<FPluginDescriptor> Plugins; // not a TArray: it moves elements bitwise, which std::string does not survive
    uint64 FramesToGo;
    bool bLimitFrames;
};
