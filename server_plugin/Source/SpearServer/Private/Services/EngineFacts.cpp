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
#include <string>
#include <string_view>

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

/// The command line for clients: without the token.
std::string PublicCommandLine() {
    std::string Text = ToUtf8(FString(FCommandLine::Get()));
    static constexpr std::string_view Option = "-speartoken=";
    for (std::size_t At = ToLower(Text).find(Option); At != std::string::npos;
        At = ToLower(Text).find(Option, At + Option.size())) {
        const std::size_t Value = At + Option.size();
        const bool bQuoted = Value < Text.size() && Text[Value] == '"';
        const std::size_t End = bQuoted ? Text.find('"', Value + 1) : Text.find(' ', Value);
        Text.replace(Value, End == std::string::npos ? std::string::npos : End - Value + (bQuoted ? 1 : 0), "***");
    }
    return Text;
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
        Facts.Info.command_line = PublicCommandLine();
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
