// SPDX-License-Identifier: MIT
// Reading and writing of property text. Private to the module.
#pragma once

#include "CoreMinimal.h"

class FOutputDevice;

namespace PropertyText {
/** Sends an import error to its receiver, if there is one. */
void Report(FOutputDevice* ErrorText, const FString& Message);
/** `"text"` with \" \\ \n \r \t escaped. */
FString Quote(const FString& Text);

/** A cursor over text. */
class FReader {
public:
    explicit FReader(const TCHAR* InText) : Text(InText) {}
    const TCHAR* Cursor() const { return Text; }
    void Set(const TCHAR* InText) { Text = InText; }
    bool Is(char Character) const { return *Text == static_cast<TCHAR>(Character); }
    bool AtEnd() const { return *Text == 0; }
    bool Accept(char Character) {
        if (Is(Character)) {
            ++Text;
            return true;
        }
        return false;
    }
    void SkipSpace() {
        while (*Text == TCHAR(' ') || *Text == TCHAR('\t') || *Text == TCHAR('\n') || *Text == TCHAR('\r')) {
            ++Text;
        }
    }
    /** Letters, digits, '_'. */
    FString ReadName();
    int32 ReadInt();
    /** Digits with sign, fraction, exponent; hexadecimal; "inf", "nan". */
    FString ReadNumber();
    /** A quoted text (escapes resolved) or everything up to ',' ')' or white space. False for an unterminated quote. */
    bool ReadToken(FString& Out, bool bAllowSpaces = false);
    bool ReadQuoted(FString& Out);
    /** The beginning of what is left, for messages. */
    FString Rest() const;

private:
    const TCHAR* Text;
};
} // namespace PropertyText
