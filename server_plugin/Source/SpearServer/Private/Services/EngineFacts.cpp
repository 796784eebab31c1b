// SPDX-License-Identifier: MIT
#include "Services/EngineFacts.h"

#include "SpearCompat.h"
#include "SpearText.h"

#include "Reflection/Worlds.h"

#include "Engine/World.h"
#include "HAL/PlatformProcess.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/EngineVersion.h"

#include "spear/version.hpp"

#include <mutex>

namespace SpearServer {

namespace {

struct FFacts {
    std::mutex Mutex;
    spear::EngineInfo Info;
    FName Scene;
};

FFacts& GetFacts() {
    static FFacts Facts;
    return Facts;
}

} // namespace

void UpdateEngineFacts() {
    FFacts& Facts = GetFacts();
    const UWorld* World = GetPrimaryWorld();
    const FName Scene = World ? World->GetFName() : FName();
    const std::lock_guard Lock(Facts.Mutex);
    Facts.Info.frame = GFrameCounter;
    if (Facts.Info.engine_name.empty()) {
        Facts.Info.spear_version = std::string(spear::version);
        Facts.Info.engine_name = EngineName;
        Facts.Info.engine_version = ToUtf8(FEngineVersion::Current().ToString(EVersionComponent::Patch));
        Facts.Info.project = ToUtf8(FString(FApp::GetProjectName()));
        Facts.Info.command_line = ToUtf8(FString(FCommandLine::Get()));
        Facts.Info.process_id = FPlatformProcess::GetCurrentProcessId();
        Facts.Info.is_editor = GIsEditor;
    }
    if (Scene != Facts.Scene) {
        Facts.Scene = Scene;
        Facts.Info.scene = World ? ToUtf8(World->GetMapName()) : std::string();
    }
}

spear::EngineInfo GetEngineFacts() {
    FFacts& Facts = GetFacts();
    const std::lock_guard Lock(Facts.Mutex);
    return Facts.Info;
}

} // namespace SpearServer
