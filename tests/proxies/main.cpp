// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT
#include "fixture.hpp"

#include <memory>

namespace proxies {
namespace {
std::unique_ptr<spear::Instance> shared;
}

spear::Instance& engine() {
    if (!shared) {
        shared = std::make_unique<spear::Instance>(spear::launch({.fps = 200,
            .fixed_dt = 1.0 / 60,
            .seed = 1,
            .executable = SPEAR_TEST_ENGINE,
            .arguments = {"--plugin-dir", SPEAR_TEST_PLUGINS},
            .connect_timeout = std::chrono::seconds(60),
            .deadline = std::chrono::seconds(10)}));
    }
    return *shared;
}
} // namespace proxies

int main(int argc, char** argv) {
    doctest::Context context(argc, argv);
    const int result = context.run();
    proxies::shared.reset();
    return result;
}
