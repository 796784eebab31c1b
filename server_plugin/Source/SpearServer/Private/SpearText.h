// SPDX-License-Identifier: MIT
#pragma once

// Text between the wire (UTF-8, std::string) and Unreal (FString, FName), and small helpers for messages.

#include "CoreMinimal.h"

#include <string>
#include <string_view>

namespace SpearServer {

/// UTF-8 of an Unreal string.
std::string ToUtf8(FStringView Text);
inline std::string ToUtf8(const FString& Text) { return ToUtf8(FStringView(Text)); }
inline std::string ToUtf8(FName Name) { return ToUtf8(Name.ToString()); }

/// An Unreal string from UTF-8. Bytes that are not UTF-8 become replacement characters.
FString FromUtf8(std::string_view Text);

/// The name if it exists already, else NAME_None: so that looking something up never fills the name table. Also
/// NAME_None for texts that cannot be names (empty, too long, with a zero byte).
FName FindName(std::string_view Text);

/// Whether the text may become a new FName: not longer than NAME_SIZE - 1 characters and without a zero byte.
bool IsValidName(std::string_view Text);

/// Lower case for ASCII letters: how names are compared. (Unreal compares names without case the same way.)
std::string ToLower(std::string_view Text);
bool EqualsWithoutCase(std::string_view A, std::string_view B);

/// Whether the text fits a pattern in which * stands for any characters and ? for one; without case.
bool MatchesPattern(std::string_view Text, std::string_view Pattern);

} // namespace SpearServer
