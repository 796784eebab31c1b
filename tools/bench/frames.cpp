// SPDX-License-Identifier: MIT
#include "frames.hpp"

#include <deque>
#include <utility>

#include "spear/spear.hpp"

TransactionFrames run_transactions(const std::string& address, std::size_t transactions, std::size_t calls) {
    using spear::unreal::FVector;
    struct Pending {
        spear::Future<std::int64_t> begin, end;
        std::vector<spear::Future<FVector>> moves;
    };
    spear::Instance instance = spear::connect(address, {.client_name = "spear-bench"});
    const spear::Game game = instance.game();
    const spear::Class frames = game.get_class("USpearBenchFrames");
    spear::Object bench;
    {
        auto frame = instance.begin_frame();
        bench = game.new_object("USpearBench");
        frame.execute();
        instance.end_frame().execute();
        instance.flush();
    }
    TransactionFrames result;
    result.frames.reserve(transactions);
    std::deque<Pending> pending;
    const auto take = [&] {
        const std::int64_t begin = pending.front().begin.get();
        result.split += pending.front().end.get() != begin;
        result.frames.push_back(begin);
        pending.pop_front();
    };
    for (std::size_t number = 0; number < transactions; ++number) {
        Pending& now = pending.emplace_back();
        auto begin = instance.begin_frame();
        now.begin = frames.async<std::int64_t>("Frame");
        for (std::size_t call = 2; call < calls; ++call) {
            now.moves.push_back(bench.async<FVector>("Move", FVector{1, 0, 0}));
        }
        begin.execute();
        auto end = instance.end_frame();
        now.end = frames.async<std::int64_t>("Frame");
        end.execute();
        if (pending.size() > 2) { // its end block was answered before the last one could be opened
            take();
        }
    }
    instance.flush();
    while (!pending.empty()) {
        take();
    }
    return result;
}
