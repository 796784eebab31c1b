// SPDX-License-Identifier: MIT
#pragma once

// engine_service: the process, not its objects. Everything here but wait_for_result is answered by the server thread, also while
// the game thread is busy or held. (Frames are not entry points: they are part of the session, see session.hpp.)

#include "spear/entry_point.hpp"
#include "spear/entry_points/types.hpp"

namespace spear::engine_service {

inline constexpr EntryPoint<"engine_service.ping", std::string(std::string_view), Names<"text">, RunsOn::server_thread,
    "Returns its argument: measures the round trip to the server thread."> ping;

inline constexpr EntryPoint<"engine_service.get_engine_info", EngineInfo(), Names<>, RunsOn::server_thread,
    "Which engine, version, project, scene and process is at the other end."> get_engine_info;

inline constexpr EntryPoint<"engine_service.get_frame_number", std::uint64_t(), Names<>, RunsOn::server_thread,
    "The engine's frame counter (GFrameCounter) as of the last frame begun."> get_frame_number;

inline constexpr EntryPoint<"engine_service.request_exit", void(), Names<>, RunsOn::server_thread,
    "Asks the engine to end at the next frame, as if its window were closed."> request_exit;

inline constexpr EntryPoint<"engine_service.wait_for_result", AnyView(std::uint64_t), Names<"operation">, RunsOn::any_frame,
    "The result of an earlier operation whose answer was \"pending\": a latent function. Answered as soon as the function has completed, "
    "some frames later; raises NeedsFrames at once while the caller itself holds the engine."> wait_for_result;

using List = EntryPointList<std::remove_cv_t<decltype(ping)>, std::remove_cv_t<decltype(get_engine_info)>,
    std::remove_cv_t<decltype(get_frame_number)>, std::remove_cv_t<decltype(request_exit)>,
    std::remove_cv_t<decltype(wait_for_result)>>;

} // namespace spear::engine_service
