// SPDX-License-Identifier: MIT
#pragma once

template <typename FuncType>
class TFunction;
template <typename FuncType>
class TFunctionRef;
template <typename FuncType>
class TUniqueFunction;
