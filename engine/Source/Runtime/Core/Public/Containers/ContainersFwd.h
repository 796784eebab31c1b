// SPDX-License-Identifier: MIT
/** Forward declarations of the containers, with their default arguments. */
#pragma once

#include "HAL/Platform.h"

template <int IndexSize>
class TSizedDefaultAllocator;
using FDefaultAllocator = TSizedDefaultAllocator<32>;
using FDefaultAllocator64 = TSizedDefaultAllocator<64>;
class FDefaultBitArrayAllocator;
class FDefaultSparseArrayAllocator;
class FDefaultSetAllocator;

class FString;
class FText;
class FName;
struct FScriptContainerElement;

template <typename T, typename Allocator = FDefaultAllocator>
class TArray;
template <typename T>
using TArray64 = TArray<T, FDefaultAllocator64>;
template <typename InElementType, typename InSizeType = int32>
class TArrayView;
template <typename T, typename SizeType = int32>
using TConstArrayView = TArrayView<const T, SizeType>;
template <typename Allocator = FDefaultBitArrayAllocator>
class TBitArray;
template <typename InElementType, typename Allocator = FDefaultSparseArrayAllocator>
class TSparseArray;
template <typename ElementType, bool bInAllowDuplicateKeys = false>
struct DefaultKeyFuncs;
template <typename InElementType, typename KeyFuncs = DefaultKeyFuncs<InElementType>,
    typename Allocator = FDefaultSetAllocator>
class TSet;
template <typename KeyType, typename ValueType, bool bInAllowDuplicateKeys>
struct TDefaultMapHashableKeyFuncs;
template <typename KeyType, typename ValueType, typename SetAllocator = FDefaultSetAllocator,
    typename KeyFuncs = TDefaultMapHashableKeyFuncs<KeyType, ValueType, false>>
class TMap;
template <typename KeyType, typename ValueType, typename SetAllocator = FDefaultSetAllocator,
    typename KeyFuncs = TDefaultMapHashableKeyFuncs<KeyType, ValueType, true>>
class TMultiMap;
template <typename CharType>
class TStringView;
using FStringView = TStringView<TCHAR>;
using FAnsiStringView = TStringView<ANSICHAR>;
using FUtf8StringView = TStringView<UTF8CHAR>;
template <typename CharType>
class TStringBuilderBase;
using FStringBuilderBase = TStringBuilderBase<TCHAR>;
using FAnsiStringBuilderBase = TStringBuilderBase<ANSICHAR>;
using FUtf8StringBuilderBase = TStringBuilderBase<UTF8CHAR>;
