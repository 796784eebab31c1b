// SPDX-License-Identifier: MIT
/** FStringOutputDevice: log lines into a string. */
#pragma once

#include "Misc/OutputDevice.h"

class FStringOutputDevice : public FString, public FOutputDevice {
public:
    explicit FStringOutputDevice(const TCHAR* InitialText = TEXT("")) : FString(InitialText) {
        bAutoEmitLineTerminator = false;
    }
    void Serialize(const TCHAR* InData, ELogVerbosity::Type, const FName&) override {
        FString::operator+=(InData);
        if (bAutoEmitLineTerminator) {
            FString::operator+=(LINE_TERMINATOR);
        }
    }
    using FOutputDevice::Serialize;
};
