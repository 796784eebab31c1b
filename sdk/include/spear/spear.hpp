// SPDX-License-Identifier: MIT
#pragma once

// Everything of the SPEAR SDK. Start reading at instance.hpp; then frame.hpp, object.hpp, game.hpp, value.hpp,
// future.hpp, error.hpp.

#include "spear/aliases.hpp"
#include "spear/entry_points/all.hpp"
#include "spear/error.hpp"
#include "spear/frame.hpp"
#include "spear/future.hpp"
#include "spear/game.hpp"
#include "spear/instance.hpp"
#include "spear/launch.hpp"
#include "spear/limits.hpp"
#include "spear/log.hpp"
#include "spear/object.hpp"
#include "spear/session.hpp"
#include "spear/trace.hpp"
#include "spear/unreal_types.hpp"
#include "spear/value.hpp"
#include "spear/version.hpp"
