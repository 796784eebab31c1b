// SPDX-License-Identifier: MIT
#include "Frame/Session.h"

namespace SpearServer {

void FSession::Sweep() {
    Handles.Sweep();
    TypeNumbers.Sweep();
    Conversions.clear();
    CallPlans.Sweep();
    PropertyPaths.Sweep();
}

} // namespace SpearServer
