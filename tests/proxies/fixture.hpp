// SPDX-License-Identifier: MIT
#pragma once

// The engine that the tests of this binary share, and a client with a session of its own for each test.

#include <functional>
#include <utility>

#include <doctest/doctest.h>

#include "spear/spear.hpp"

namespace proxies {

namespace unreal = spear::unreal;

/// The shared engine, started at the first use, ended by main().
spear::Instance& engine();

struct Client {
    spear::Instance instance;
    spear::Game game;

    Client() : instance(spear::connect(engine().process()->address())), game(instance.game()) {}

    /// Runs one transaction.
    void transact(const std::function<void()>& begin, const std::function<void()>& end = nullptr) {
        {
            auto frame = instance.begin_frame();
            begin();
            frame.execute();
        }
        auto frame = instance.end_frame();
        if (end)
            end();
        frame.execute();
    }
};

} // namespace proxies
