// SPDX-License-Identifier: MIT
#include "Reflection/NearestNames.h"

#include "SpearText.h"

#include <algorithm>

namespace SpearServer {

namespace {

/// Longer names than this are not compared: the table of distances grows with the square.
constexpr std::size_t LongestName = 128;
constexpr std::size_t MostSuggestions = 3;

/// Edit distance (insert, delete, replace, swap of neighbours), or Limit if it is at least that.
uint32 EditDistance(std::string_view A, std::string_view B, uint32 Limit) {
    const std::size_t Difference = A.size() > B.size() ? A.size() - B.size() : B.size() - A.size();
    if (Difference >= Limit) {
        return Limit;
    }
    uint32 Rows[3][LongestName + 1];
    uint32* BeforeLast = Rows[0];
    uint32* Last = Rows[1];
    uint32* Current = Rows[2];
    for (std::size_t J = 0; J <= B.size(); ++J) {
        Last[J] = static_cast<uint32>(J);
    }
    for (std::size_t I = 1; I <= A.size(); ++I) {
        Current[0] = static_cast<uint32>(I);
        uint32 Smallest = Current[0];
        for (std::size_t J = 1; J <= B.size(); ++J) {
            Current[J] = std::min({Last[J] + 1, Current[J - 1] + 1, Last[J - 1] + (A[I - 1] == B[J - 1] ? 0u : 1u)});
            if (I > 1 && J > 1 && A[I - 1] == B[J - 2] && A[I - 2] == B[J - 1]) {
                Current[J] = std::min(Current[J], BeforeLast[J - 2] + 1);
            }
            Smallest = std::min(Smallest, Current[J]);
        }
        if (Smallest >= Limit) {
            return Limit;
        }
        uint32* Reused = BeforeLast;
        BeforeLast = Last;
        Last = Current;
        Current = Reused;
    }
    return std::min(Last[B.size()], Limit);
}

} // namespace

FNearestNames::FNearestNames(std::string_view InWanted) : Wanted(ToLower(InWanted)) {}

void FNearestNames::Add(std::string_view Candidate) {
    if (Wanted.empty() || Wanted.size() > LongestName || Candidate.size() > LongestName) {
        return;
    }
    const std::string Lower = ToLower(Candidate);
    // A name that contains the wanted one ("GetActorLocation" in "K2_GetActorLocation") is near however much longer it
    // is.
    const uint32 Limit = static_cast<uint32>(std::max<std::size_t>(2, Wanted.size() / 3)) + 1;
    uint32 Distance = EditDistance(Wanted, Lower, Limit);
    if (Distance >= Limit && Wanted.size() >= 4 && Lower.find(Wanted) != std::string::npos) {
        Distance = Limit - 1;
    }
    if (Distance >= Limit) {
        return;
    }
    const bool bKnown =
        std::any_of(Best.begin(), Best.end(), [&](const FCandidate& Known) { return Known.Name == Candidate; });
    if (bKnown) {
        return;
    }
    const auto At = std::upper_bound(Best.begin(), Best.end(), Distance,
        [](uint32 Value, const FCandidate& Other) { return Value < Other.Distance; });
    Best.insert(At, {std::string(Candidate), Distance});
    if (Best.size() > MostSuggestions) {
        Best.pop_back();
    }
}

std::string FNearestNames::Suggestion() const {
    std::string Text;
    for (std::size_t Index = 0; Index < Best.size(); ++Index) {
        Text += Index == 0 ? "; did you mean '" : Index + 1 == Best.size() ? "' or '" : "', '";
        Text += Best[Index].Name;
    }
    return Text.empty() ? Text : Text + "'?";
}

} // namespace SpearServer
