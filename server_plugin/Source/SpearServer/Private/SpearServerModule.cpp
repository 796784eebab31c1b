// SPDX-License-Identifier: MIT
#include "SpearServer.h"

#include "SpearLog.h"
#include "SpearText.h"

#include "Frame/Server.h"

#include "HAL/PlatformMisc.h"
#include "HAL/PlatformProcess.h"
#include "Misc/CommandLine.h"
#include "Misc/CoreDelegates.h"
#include "Misc/FileHelper.h"
#include "Misc/Parse.h"
#include "Modules/ModuleManager.h"

#include "spear/limits.hpp"

#include <algorithm>
#include <memory>

#if PLATFORM_LINUX || PLATFORM_MAC
#include <sys/stat.h>
#include <unistd.h>
#endif

DEFINE_LOG_CATEGORY(LogSpear);

namespace SpearServer {

namespace {

#if PLATFORM_LINUX || PLATFORM_MAC

/// A folder that only this user can enter, made if it is not there. False if it is somebody else's.
bool EnsurePrivateFolder(const std::string& Folder) {
    mkdir(Folder.c_str(), 0700);
    struct stat Status{};
    return lstat(Folder.c_str(), &Status) == 0 && S_ISDIR(Status.st_mode) && Status.st_uid == geteuid() &&
           (Status.st_mode & 0077) == 0;
}

std::string DefaultAddress() {
    const std::string Name = std::to_string(FPlatformProcess::GetCurrentProcessId()) + ".sock";
    const std::string Runtime = ToUtf8(FPlatformMisc::GetEnvironmentVariable(TEXT("XDG_RUNTIME_DIR")));
    if (!Runtime.empty() && EnsurePrivateFolder(Runtime + "/spear")) {
        return "unix:" + Runtime + "/spear/" + Name;
    }
    const std::string Folder = "/tmp/spear-" + std::to_string(geteuid());
    return EnsurePrivateFolder(Folder) ? "unix:" + Folder + "/" + Name : std::string();
}

#else

std::string DefaultAddress() { return "tcp://127.0.0.1:0"; }

#endif

TSpearResult<FServerOptions> ReadOptions() {
    FServerOptions Options;
    FString Text;
    if (FParse::Value(FCommandLine::Get(), TEXT("-SpearAddress="), Text, false)) {
        Options.Address = ToUtf8(Text);
    } else {
        Options.Address = DefaultAddress();
        if (Options.Address.empty()) {
            return MakeError(ErrorCode::ConnectionError,
                "no private folder for the default socket; give -SpearAddress=unix:/path or tcp://127.0.0.1:port");
        }
    }
    if (FParse::Value(FCommandLine::Get(), TEXT("-SpearTokenFile="), Text, false)) {
        TArray<uint8> Bytes;
        if (!FFileHelper::LoadFileToArray(Bytes, *Text)) {
            return MakeError(ErrorCode::ConnectionError, "the token file '" + ToUtf8(Text) + "' cannot be read");
        }
        Options.Token.assign(Bytes.GetData(), Bytes.GetData() + Bytes.Num());
        while (!Options.Token.empty() && (Options.Token.back() == '\n' || Options.Token.back() == '\r')) {
            Options.Token.pop_back();
        }
    } else if (FParse::Value(FCommandLine::Get(), TEXT("-SpearToken="), Text, false)) {
        const std::string Token = ToUtf8(Text);
        Options.Token.assign(Token.begin(), Token.end());
    }
    int32 LeaseMs = 0;
    if (FParse::Value(FCommandLine::Get(), TEXT("-SpearLease="), LeaseMs)) {
        Options.LeaseMs = std::clamp(
            static_cast<uint32>(std::max(LeaseMs, 0)), spear::limits::min_lease_ms, spear::limits::max_lease_ms);
    }
    int64 QueuedBytes = 0;
    if (FParse::Value(FCommandLine::Get(), TEXT("-SpearQueuedBytes="), QueuedBytes)) { // for machines with little memory
        Options.MaxQueuedBytes = static_cast<std::size_t>(
            std::clamp(QueuedBytes, int64{1} << 20, static_cast<int64>(spear::limits::max_queued_bytes)));
    }
    return Options;
}

} // namespace

/// Owns the server: from the end of the engine's initialisation to the beginning of its end.
class FSpearServerModule : public ISpearServerModule {
public:
    virtual void StartupModule() override {
        if (IsRunningCommandlet() || FParse::Param(FCommandLine::Get(), TEXT("SpearOff"))) {
            return;
        }
        // The first frame is the fallback for modules that are loaded after the engine has been initialised.
        PostEngineInitHandle = FCoreDelegates::OnPostEngineInit.AddRaw(this, &FSpearServerModule::StartServer);
        BeginFrameHandle = FCoreDelegates::OnBeginFrame.AddRaw(this, &FSpearServerModule::StartServer);
        PreExitHandle = FCoreDelegates::OnEnginePreExit.AddRaw(this, &FSpearServerModule::StopServer);
    }

    virtual void ShutdownModule() override {
        StopServer();
        FCoreDelegates::OnEnginePreExit.Remove(PreExitHandle);
    }

    virtual FString GetAddress() const override { return Server ? FromUtf8(Server->GetAddress()) : FString(); }

private:
    void StartServer() {
        FCoreDelegates::OnPostEngineInit.Remove(PostEngineInitHandle);
        FCoreDelegates::OnBeginFrame.Remove(BeginFrameHandle);
        if (bTried) {
            return;
        }
        bTried = true;
        TSpearResult<FServerOptions> Options = ReadOptions();
        if (!Options.IsOk()) {
            UE_LOG(LogSpear, Error, TEXT("SPEAR does not listen: %s"), *FromUtf8(Options.GetError().message));
            ExitIfItMustListen();
            return;
        }
        Server = std::make_unique<FServer>();
        FStatus Started = Server->Start(Options.GetValue());
        if (!Started.IsOk()) {
            UE_LOG(LogSpear, Error, TEXT("SPEAR does not listen at %s: %s"), *FromUtf8(Options.GetValue().Address),
                *FromUtf8(Started.GetError().message));
            Server.reset();
            ExitIfItMustListen();
            return;
        }
        UE_LOG(LogSpear, Display, TEXT("SPEAR listens at %s"), *FromUtf8(Server->GetAddress()));
    }

    /// For engines that were started to be driven: nobody could ever reach this one.
    static void ExitIfItMustListen() {
        if (FParse::Param(FCommandLine::Get(), TEXT("SpearMustListen"))) {
            FPlatformMisc::RequestExitWithStatus(false, 1);
        }
    }

    void StopServer() {
        FCoreDelegates::OnPostEngineInit.Remove(PostEngineInitHandle);
        FCoreDelegates::OnBeginFrame.Remove(BeginFrameHandle);
        Server.reset();
    }

    std::unique_ptr<FServer> Server;
    FDelegateHandle PostEngineInitHandle;
    FDelegateHandle BeginFrameHandle;
    FDelegateHandle PreExitHandle;
    bool bTried = false;
};

} // namespace SpearServer

IMPLEMENT_MODULE(SpearServer::FSpearServerModule, SpearServer)
