// SPDX-License-Identifier: MIT
#pragma once

#include "Containers/ContainersFwd.h"
