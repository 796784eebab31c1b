// SPDX-License-Identifier: MIT
// The tests of the embedded engine: one binary, one process, modules loaded once, a fresh engine per test case
// (engine_fixture.h).
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "CoreMinimal.h"
#include "Logging/LogMacros.h"
#include "Misc/CommandLine.h"
#include "Modules/ModuleManager.h"

int main(int argument_count, char** arguments) {
    FCommandLine::Set(TEXT(""));
    // Errors and warnings that tests provoke are many; --log shows them.
    bool show_log = false;
    for (int index = 1; index < argument_count; ++index) {
        show_log = show_log || std::string_view(arguments[index]) == "--log";
    }
    ApplyLogCommands(show_log ? TEXT("global verbose") : TEXT("global fatal"));
    FModuleManager::Get().StartProcessingNewlyLoadedObjects();

    doctest::Context context(argument_count, arguments);
    const int result = context.run();
    FModuleManager::Get().UnloadModulesAtShutdown();
    return result;
}
