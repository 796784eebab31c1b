// SPDX-License-Identifier: MIT
#pragma once

// "Did you mean ...?": the names nearest to one that does not exist.

#include "CoreMinimal.h"

#include <string>
#include <string_view>
#include <vector>

namespace SpearServer {

/// Collects candidates and keeps the (at most three) nearest by edit distance without case.
class FNearestNames {
public:
    explicit FNearestNames(std::string_view Wanted);
    void Add(std::string_view Candidate);
    /// "; did you mean 'SetActorScale3D' or 'SetActorHiddenInGame'?", or nothing if no candidate is near.
    std::string Suggestion() const;

private:
    struct FCandidate {
        std::string Name;
        uint32 Distance = 0;
    };
    std::string Wanted; ///< lower case
    std::vector<FCandidate> Best;
};

} // namespace SpearServer
