// SPDX-License-Identifier: MIT
/** All math types. */
#pragma once

#include "Math/Box.h"
#include "Math/Box2D.h"
#include "Math/BoxSphereBounds.h"
#include "Math/Color.h"
#include "Math/RandomStream.h"
#include "Math/Ray.h"
#include "Math/Transform.h"
