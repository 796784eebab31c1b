// SPDX-License-Identifier: MIT
// Times, GUIDs, paths, files, logs, threads, modules.
#include "core_test.h"

#include <atomic>
#include <cstdlib>

#include "Async/Async.h"
#include "HAL/Event.h"
#include "HAL/FileManager.h"
#include "HAL/PlatformMisc.h"
#include "HAL/PlatformTLS.h"
#include "HAL/RunnableThread.h"
#include "HAL/ThreadHeartBeat.h"
#include "HAL/ThreadSafeCounter.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/EngineVersion.h"
#include "Misc/FileHelper.h"
#include "Misc/OutputDeviceHelper.h"
#include "Misc/Paths.h"
#include "Misc/ScopeExit.h"
#include "Misc/ScopeLock.h"
#include "Misc/ScopeRWLock.h"
#include "Modules/ModuleManager.h"

using namespace core_test;

DEFINE_LOG_CATEGORY_STATIC(LogCoreTest, Log, All)

TEST_CASE("Core: dates and spans") {
    const FDateTime t(2024, 2, 29, 13, 45, 30, 250);
    CHECK(t.GetYear() == 2024);
    CHECK(t.GetMonth() == 2);
    CHECK(t.GetDay() == 29);
    CHECK(t.GetHour() == 13);
    CHECK(t.GetMillisecond() == 250);
    CHECK(t.GetDayOfWeek() == EDayOfWeek::Thursday);
    CHECK(text(t.ToString()) == "2024.02.29-13.45.30");
    CHECK(text(t.ToIso8601()) == "2024-02-29T13:45:30.250Z");
    FDateTime parsed;
    CHECK(FDateTime::ParseIso8601(TEXT("2024-02-29T13:45:30.250Z"), parsed));
    CHECK(parsed == t);
    CHECK(FDateTime(1970, 1, 2).ToUnixTimestamp() == 86400);
    CHECK((FDateTime(2024, 3, 1) - FDateTime(2024, 2, 1)).GetDays() == 29);
    CHECK(FDateTime::DaysInMonth(2023, 2) == 28);
    CHECK(FTimespan::FromSeconds(90061.5).GetDays() == 1);
    CHECK(FTimespan::FromSeconds(90061.5).GetHours() == 1);
    CHECK(FTimespan(1, 2, 3).GetTotalSeconds() == 3723.0);
    CHECK(FTimespan::FromMilliseconds(1.5).GetTicks() == 15000);
    CHECK(FTimespan(5) < FTimespan(6));
}

TEST_CASE("Core: GUIDs") {
    const FGuid a = FGuid::NewGuid(), b = FGuid::NewGuid();
    CHECK(a.IsValid());
    CHECK(a != b);
    CHECK(!FGuid().IsValid());
    const FGuid known(0x01234567, 0x89abcdef, 0xfedcba98, 0x76543210);
    CHECK(text(known.ToString()) == "0123456789ABCDEFFEDCBA9876543210");
    CHECK(text(known.ToString(EGuidFormats::DigitsWithHyphens)) == "01234567-89AB-CDEF-FEDC-BA9876543210");
    for (const EGuidFormats format :
        {EGuidFormats::Digits, EGuidFormats::DigitsWithHyphens, EGuidFormats::DigitsWithHyphensInBraces}) {
        FGuid parsed;
        CHECK(FGuid::Parse(known.ToString(format), parsed));
        CHECK(parsed == known);
    }
    FGuid bad;
    CHECK(!FGuid::Parse(TEXT("no guid"), bad));
}

TEST_CASE("Core: paths") {
    const FString p = TEXT("/dir/sub/File.tar.gz");
    CHECK(text(FPaths::GetExtension(p)) == "gz");
    CHECK(text(FPaths::GetCleanFilename(p)) == "File.tar.gz");
    CHECK(text(FPaths::GetBaseFilename(p)) == "File.tar");
    CHECK(text(FPaths::GetPath(p)) == "/dir/sub");
    CHECK(text(FPaths::ChangeExtension(p, TEXT("zip"))) == "/dir/sub/File.tar.zip");
    CHECK(text(FPaths::Combine(TEXT("a"), FString(TEXT("b/")), TEXT("c"))) == "a/b/c");
    FString relative = TEXT("/a/b/../c/./d");
    CHECK(FPaths::CollapseRelativeDirectories(relative));
    CHECK(text(relative) == "/a/c/d");
    CHECK(FPaths::IsRelative(TEXT("a/b")));
    CHECK(!FPaths::IsRelative(TEXT("/a")));
}

TEST_CASE("Core: files") {
    const FString directory = FString(FPlatformProcess::UserTempDir()) /
                              FString::Printf(TEXT("spear_core_test_%u"), FPlatformProcess::GetCurrentProcessId());
    IFileManager& files = IFileManager::Get();
    REQUIRE(files.MakeDirectory(*(directory / TEXT("sub")), true));
    ON_SCOPE_EXIT { IFileManager::Get().DeleteDirectory(*directory, false, true); };
    const FString path = directory / TEXT("text.txt");
    CHECK(FFileHelper::SaveStringToFile(FString(TEXT("line one\n\x00E4 two")), *path));
    FString read;
    CHECK(FFileHelper::LoadFileToString(read, *path));
    CHECK(text(read) == "line one\n\xC3\xA4 two");
    TArray<FString> lines;
    CHECK(FFileHelper::LoadFileToStringArray(lines, *path));
    CHECK(lines.Num() == 2);
    TArray<uint8> bytes = {1, 2, 0, 255};
    CHECK(FFileHelper::SaveArrayToFile(bytes, *(directory / TEXT("sub/data.bin"))));
    TArray<uint8> back;
    CHECK(FFileHelper::LoadFileToArray(back, *(directory / TEXT("sub/data.bin"))));
    CHECK(back == bytes);
    CHECK(files.FileSize(*(directory / TEXT("sub/data.bin"))) == 4);
    CHECK(FPaths::FileExists(path));
    CHECK(FPaths::DirectoryExists(directory));
    TArray<FString> found;
    files.FindFilesRecursive(found, *directory, TEXT("*.bin"), true, false);
    CHECK(found.Num() == 1);
    CHECK(!FFileHelper::LoadFileToString(read, *(directory / TEXT("missing"))));
}

TEST_CASE("Core: logs reach devices, by verbosity") {
    struct Device : FOutputDevice {
        TArray<FString> lines;
        using FOutputDevice::Serialize;
        void Serialize(const TCHAR* v, ELogVerbosity::Type verbosity, const FName& category) override {
            if (category == TEXT("LogCoreTest")) {
                lines.Add(FOutputDeviceHelper::FormatLogLine(verbosity, category, v, false));
            }
        }
    } device;
    GLog->RemoveOutputDevice(&FOutputDeviceStdErr::Get());
    GLog->AddOutputDevice(&device);
    const ELogVerbosity::Type before = LogCoreTest.GetVerbosity();
    LogCoreTest.SetVerbosity(ELogVerbosity::Log);
    UE_LOG(LogCoreTest, Warning, TEXT("value %d of %s"), 3, *FString(TEXT("x")));
    UE_LOG(LogCoreTest, Log, TEXT("plain"));
    UE_LOG(LogCoreTest, Verbose, TEXT("unseen"));
    CHECK(ApplyLogCommands(TEXT("LogCoreTest Verbose")));
    UE_LOG(LogCoreTest, Verbose, TEXT("seen"));
    UE_CLOG(false, LogCoreTest, Error, TEXT("not this"));
    CHECK(!ApplyLogCommands(TEXT("LogCoreTest Loudest")));
    LogCoreTest.SetVerbosity(before);
    GLog->RemoveOutputDevice(&device);
    GLog->AddOutputDevice(&FOutputDeviceStdErr::Get());
    REQUIRE(device.lines.Num() == 3);
    CHECK(text(device.lines[0]) == "LogCoreTest: Warning: value 3 of x");
    CHECK(text(device.lines[1]) == "LogCoreTest: plain");
    CHECK(text(device.lines[2]) == "LogCoreTest: Verbose: seen");
    CHECK(FOutputDeviceHelper::FormatLogLine(ELogVerbosity::Log, "LogX", TEXT("y")).StartsWith(TEXT("[20")));
}

TEST_CASE("Core: threads, events, heartbeats") {
    struct Worker : FRunnable {
        std::atomic<bool> stop{false};
        FThreadSafeCounter counter;
        FEvent* started = FPlatformProcess::GetSynchEventFromPool();
        uint32 id = 0;
        uint32 Run() override {
            id = FPlatformTLS::GetCurrentThreadId();
            FThreadHeartBeat::Get().HeartBeat();
            started->Trigger();
            while (!stop) {
                counter.Increment();
                FPlatformProcess::Sleep(0.001f);
            }
            return 0;
        }
        void Stop() override { stop = true; }
    } worker;
    FRunnableThread* thread = FRunnableThread::Create(&worker, TEXT("CoreTestThread"));
    REQUIRE(thread);
    CHECK(worker.started->Wait(10000));
    CHECK(worker.id != FPlatformTLS::GetCurrentThreadId());
    CHECK(FThreadHeartBeat::Get().GetNumHeartBeats(worker.id) == 1);
    CHECK(FPlatformTime::Seconds() - FThreadHeartBeat::Get().GetLastHeartBeatTime(worker.id) < 10.0);
    CHECK(thread->Kill(true));
    delete thread;
    CHECK(worker.stop);
    CHECK_MESSAGE(!worker.started->Wait(1), "an auto-reset event is used up by one wait");
    FPlatformProcess::ReturnSynchEventToPool(worker.started);

    FThreadHeartBeat::Get().HeartBeat();
    CHECK(FThreadHeartBeat::Get().IsBeating());
    FThreadHeartBeat::Get().KillHeartBeat();
    CHECK(!FThreadHeartBeat::Get().IsBeating());

    FEventRef manual(EEventMode::ManualReset);
    manual->Trigger();
    CHECK(manual->Wait(0));
    CHECK(manual->Wait(0));
    manual->Reset();
    CHECK(!manual->Wait(0));
}

TEST_CASE("Core: work for the game thread waits for its pump") {
    std::atomic<int> done{0};
    FEventRef ran;
    AsyncTask(ENamedThreads::GameThread, [&] {
        CHECK(IsInGameThread());
        ++done;
    });
    CHECK(done == 0);
    AsyncTask(ENamedThreads::AnyThread, [&] {
        if (!IsInGameThread()) {
            ++done;
        }
        ran->Trigger();
    });
    CHECK(ran->Wait(10000));
    CHECK(done == 1);
    CHECK(FTaskGraphInterface::Get().ProcessThreadUntilIdle(ENamedThreads::GameThread) == 1);
    CHECK(done == 2);
}

TEST_CASE("Core: names may be made on many threads at once") {
    struct Maker : FRunnable {
        TArray<FName> names;
        uint32 Run() override {
            for (int32 i = 0; i < 2000; ++i) {
                names.Add(FName(*FString::Printf(TEXT("ThreadedName%dx"), i)));
            }
            return 0;
        }
    } makers[4];
    FRunnableThread* threads[4];
    for (int i = 0; i < 4; ++i) {
        threads[i] = FRunnableThread::Create(&makers[i], TEXT("NameMaker"));
    }
    for (FRunnableThread* thread : threads) {
        thread->WaitForCompletion();
        delete thread;
    }
    CHECK(makers[0].names == makers[3].names);
    CHECK(text(makers[1].names[1999]) == "ThreadedName1999x");
}

namespace {
struct TestModule : IModuleInterface {
    static int started, stopped;
    void StartupModule() override { ++started; }
    void ShutdownModule() override { ++stopped; }
};
int TestModule::started = 0;
int TestModule::stopped = 0;
IModuleInterface* make_test_module() { return new TestModule(); }
} // namespace

TEST_CASE("Core: modules") {
    FModuleManager& modules = FModuleManager::Get();
    modules.RegisterStaticallyLinkedModule(TEXT("CoreTestModule"), &make_test_module);
    CHECK(!modules.IsModuleLoaded(TEXT("CoreTestModule")));
    FString order;
    const FDelegateHandle processed = modules.OnProcessLoadedObjectsCallback().AddLambda([&](FName name, bool) {
        if (name == TEXT("CoreTestModule")) {
            order += TestModule::started == 0 ? TEXT("classes;") : TEXT("late;");
        }
    });
    const FDelegateHandle changed = modules.OnModulesChanged().AddLambda([&](FName name, EModuleChangeReason reason) {
        if (name == TEXT("CoreTestModule")) {
            order += reason == EModuleChangeReason::ModuleLoaded ? TEXT("loaded;") : TEXT("unloaded;");
        }
    });
    CHECK(modules.LoadModule(TEXT("CoreTestModule")) != nullptr);
    CHECK(TestModule::started == 1);
    CHECK(modules.LoadModule(TEXT("coretestmodule")) == modules.GetModule(TEXT("CoreTestModule")));
    CHECK(TestModule::started == 1);
    CHECK(modules.GetModulePtr<TestModule>("CoreTestModule") != nullptr);
    CHECK(modules.UnloadModule(TEXT("CoreTestModule")));
    CHECK(TestModule::stopped == 1);
    CHECK(text(order) == "classes;loaded;unloaded;");
    modules.OnProcessLoadedObjectsCallback().Remove(processed);
    modules.OnModulesChanged().Remove(changed);

    EModuleLoadResult reason = EModuleLoadResult::Success;
    CHECK(modules.LoadModuleWithFailureReason(TEXT("NoSuchModule"), reason) == nullptr);
    CHECK(reason == EModuleLoadResult::FileNotFound);
    CHECK(!modules.ModuleExists(TEXT("NoSuchModule")));
    CHECK_MESSAGE(modules.LoadModule(TEXT("Core")) != nullptr, "libSpearUE-Core.so is found beside itself");
}

TEST_CASE("Core: application state") {
    const double fixed = FApp::GetFixedDeltaTime();
    FApp::SetFixedDeltaTime(0.02);
    CHECK(FApp::GetFixedDeltaTime() == 0.02);
    FApp::SetFixedDeltaTime(fixed);
    CHECK(FApp::GetInstanceId() == FApp::GetInstanceId());
    CHECK(text(FEngineVersion::Current().ToString(EVersionComponent::Patch)) == "5.5.0");
    CHECK(FEngineVersion::Current().GetMajor() == 5);
    CHECK(IsInGameThread());
    CHECK(!IsRunningCommandlet());
    char program[] = "p", a[] = "-Path=/a b", b[] = "-x";
    char* arguments[] = {program, a, b};
    FString value;
    const FString line = FCommandLine::BuildFromArgV(nullptr, 3, arguments, nullptr);
    CHECK(FParse::Value(*line, TEXT("Path="), value));
    CHECK(text(value) == "/a b");
    CHECK(FParse::Param(*line, TEXT("x")));
    CHECK(FCrc::MemCrc32("123456789", 9) == 0xCBF43926u);
    int32 guarded = 1;
    {
        TGuardValue<int32> guard(guarded, 2);
        CHECK(guarded == 2);
    }
    CHECK(guarded == 1);
}
