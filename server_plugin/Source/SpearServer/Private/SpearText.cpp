// SPDX-License-Identifier: MIT
#include "SpearText.h"

#include "Containers/StringConv.h"

#include <algorithm>
#include <limits>

namespace SpearServer {

std::string ToUtf8(FStringView Text) {
    const FTCHARToUTF8 Converted(Text.GetData(), Text.Len());
    return std::string(reinterpret_cast<const char*>(Converted.Get()), static_cast<std::size_t>(Converted.Length()));
}

FString FromUtf8(std::string_view Text) {
    if (Text.empty()) {
        return FString();
    }
    const FUTF8ToTCHAR Converted(reinterpret_cast<const ANSICHAR*>(Text.data()), static_cast<int32>(Text.size()));
    return FString::ConstructFromPtrSize(Converted.Get(), Converted.Length());
}

bool IsValidName(std::string_view Text) {
    // A UTF-8 text never has more bytes than UTF-16 characters times three; short texts need no counting.
    if (Text.size() >= NAME_SIZE && FromUtf8(Text).Len() >= NAME_SIZE) {
        return false;
    }
    return Text.find('\0') == std::string_view::npos;
}

FName FindName(std::string_view Text) {
    if (Text.empty() || !IsValidName(Text)) {
        return NAME_None;
    }
    return FName(*FromUtf8(Text), FNAME_Find);
}

std::string ToLower(std::string_view Text) {
    std::string Lower(Text);
    std::transform(Lower.begin(), Lower.end(), Lower.begin(),
        [](char C) { return C >= 'A' && C <= 'Z' ? static_cast<char>(C + 32) : C; });
    return Lower;
}

bool EqualsWithoutCase(std::string_view A, std::string_view B) {
    return A.size() == B.size() && std::equal(A.begin(), A.end(), B.begin(), [](char X, char Y) {
        const auto Lower = [](char C) { return C >= 'A' && C <= 'Z' ? static_cast<char>(C + 32) : C; };
        return Lower(X) == Lower(Y);
    });
}

bool MatchesPattern(std::string_view Text, std::string_view Pattern) {
    const std::string LowerText = ToLower(Text);
    const std::string LowerPattern = ToLower(Pattern);
    std::size_t At = 0, Want = 0, Star = std::string::npos, StarAt = 0;
    while (At < LowerText.size()) {
        if (Want < LowerPattern.size() && LowerPattern[Want] == '*') {
            Star = Want++;
            StarAt = At;
        } else if (Want < LowerPattern.size() && (LowerPattern[Want] == '?' || LowerPattern[Want] == LowerText[At])) {
            ++At;
            ++Want;
        } else if (Star != std::string::npos) {
            Want = Star + 1;
            At = ++StarAt;
        } else {
            return false;
        }
    }
    while (Want < LowerPattern.size() && LowerPattern[Want] == '*') {
        ++Want;
    }
    return Want == LowerPattern.size();
}

} // namespace SpearServer
