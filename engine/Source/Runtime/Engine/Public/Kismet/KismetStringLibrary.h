// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "UObject/ObjectMacros.h"

#include "KismetStringLibrary.generated.h"

/**
 * Strings for scripts and remote programs. Epic page: UKismetStringLibrary.
 */
UCLASS(meta = (BlueprintThreadSafe, ScriptName = "StringLibrary"))
class ENGINE_API UKismetStringLibrary : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    // ------------------------------------------------------------------------------------------ Conversions to strings

    /** Converts a float value to a string, with the fewest digits that tell it, at least one after the point. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Float)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_DoubleToString(double InDouble);

    /** Converts an integer value to a string. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Integer)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_IntToString(int32 InInt);

    /** Converts a 64 bit integer value to a string. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Integer64)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_Int64ToString(int64 InInt);

    /** Converts a byte value to a string. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Byte)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_ByteToString(uint8 InByte);

    /** Converts a boolean value to a string, either "true" or "false". */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Boolean)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_BoolToString(bool InBool);

    /** Converts a vector value to a string, in the form "X= Y= Z=". */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Vector)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_VectorToString(FVector InVec);

    /** Converts a 2D vector value to a string, in the form "X= Y=". */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Vector2D)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_Vector2dToString(FVector2D InVec);

    /** Converts a rotator value to a string, in the form "P= Y= R=". */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Rotator)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_RotatorToString(FRotator InRot);

    /** Converts a transform value to a string: translation, rotation and scale. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Transform)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_TransformToString(const FTransform& InTrans);

    /** Converts an object value to a string by calling the object's GetName method; "None" for null. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Object)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_ObjectToString(UObject* InObj);

    /** Converts a linear colour value to a string, in the form "(R=,G=,B=,A=)". */
    UFUNCTION(BlueprintPure,
        meta = (DisplayName = "To String (LinearColor)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_ColorToString(FLinearColor InColor);

    /** Converts a name value to a string. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To String (Name)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FString Conv_NameToString(FName InName);

    // ---------------------------------------------------------------------------------------- Conversions from strings

    /** Converts a string to a name value. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Name (String)", CompactNodeTitle = "->", BlueprintAutocast),
        Category = "Utilities|String")
    static FName Conv_StringToName(const FString& InString);

    /** Converts a string to an int value; 0 if it does not begin with a number. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Integer (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static int32 Conv_StringToInt(const FString& InString);

    /** Converts a string to a 64 bit integer value; 0 if it does not begin with a number. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Integer64 (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static int64 Conv_StringToInt64(const FString& InString);

    /** Converts a string to a float value; 0 if it does not begin with a number. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Float (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static double Conv_StringToDouble(const FString& InString);

    /** Converts a string of the form "X= Y= Z=" to a vector, and says whether that worked. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Vector (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static void Conv_StringToVector(const FString& InString, FVector& OutConvertedVector, bool& OutIsValid);

    /** Converts a string of the form "X= Y=" to a 2D vector, and says whether that worked. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Vector2D (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static void Conv_StringToVector2D(const FString& InString, FVector2D& OutConvertedVector2D, bool& OutIsValid);

    /** Converts a string of the form "P= Y= R=" to a rotator, and says whether that worked. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To Rotator (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static void Conv_StringToRotator(const FString& InString, FRotator& OutConvertedRotator, bool& OutIsValid);

    /** Converts a string of the form "(R=,G=,B=,A=)" to a linear colour, and says whether that worked. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "To LinearColor (String)", CompactNodeTitle = "->"),
        Category = "Utilities|String")
    static void Conv_StringToColor(const FString& InString, FLinearColor& OutConvertedColor, bool& OutIsValid);

    // ------------------------------------------------------------------------------------------ Building and comparing

    /** Concatenates two strings together to make a new string. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Append", CommutativeAssociativeBinaryOperator = "true"),
        Category = "Utilities|String")
    static FString Concat_StrStr(const FString& A, const FString& B);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Float)"), Category = "Utilities|String")
    static FString BuildString_Double(
        const FString& AppendTo, const FString& Prefix, double InDouble, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Integer)"), Category = "Utilities|String")
    static FString BuildString_Int(const FString& AppendTo, const FString& Prefix, int32 InInt, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Boolean)"), Category = "Utilities|String")
    static FString BuildString_Bool(const FString& AppendTo, const FString& Prefix, bool InBool, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Vector)"), Category = "Utilities|String")
    static FString BuildString_Vector(
        const FString& AppendTo, const FString& Prefix, FVector InVector, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Rotator)"), Category = "Utilities|String")
    static FString BuildString_Rotator(
        const FString& AppendTo, const FString& Prefix, FRotator InRot, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Object)"), Category = "Utilities|String")
    static FString BuildString_Object(
        const FString& AppendTo, const FString& Prefix, UObject* InObj, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Color)"), Category = "Utilities|String")
    static FString BuildString_Color(
        const FString& AppendTo, const FString& Prefix, FLinearColor InColor, const FString& Suffix);

    /** Converts a value to a string and appends it to a string, between a prefix and a suffix. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Build String (Name)"), Category = "Utilities|String")
    static FString BuildString_Name(
        const FString& AppendTo, const FString& Prefix, const FName& InName, const FString& Suffix);

    /** Tests if two strings are equal, regardless of case. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal, Case Insensitive (String)", CompactNodeTitle = "=="),
        Category = "Utilities|String")
    static bool EqualEqual_StriStri(const FString& A, const FString& B);

    /** Tests if two strings are equal, case counted. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Equal Exactly (String)", CompactNodeTitle = "==="),
        Category = "Utilities|String")
    static bool EqualEqual_StrStr(const FString& A, const FString& B);

    /** Tests if two strings are not equal, regardless of case. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Not Equal, Case Insensitive (String)", CompactNodeTitle = "!="),
        Category = "Utilities|String")
    static bool NotEqual_StriStri(const FString& A, const FString& B);

    /** Tests if two strings are not equal, case counted. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Not Equal Exactly (String)", CompactNodeTitle = "!=="),
        Category = "Utilities|String")
    static bool NotEqual_StrStr(const FString& A, const FString& B);

    /** Returns the number of characters in the string. */
    UFUNCTION(BlueprintPure, meta = (CompactNodeTitle = "LEN"), Category = "Utilities|String")
    static int32 Len(const FString& S);

    /** Returns true if the string is empty. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool IsEmpty(const FString& InString);

    // ------------------------------------------------------------------------------------------------------- Searching

    /** Returns a substring from the string starting at the specified position; an empty one if that is out of range. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString GetSubstring(const FString& SourceString, int32 StartIndex = 0, int32 Length = 1);

    /** Finds the starting index of a substring in a string; -1 if it is not found. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "find"), Category = "Utilities|String")
    static int32 FindSubstring(const FString& SearchIn, const FString& Substring, bool bUseCase = false,
        bool bSearchFromEnd = false, int32 StartPosition = -1);

    /** Returns whether this string contains the specified substring. */
    UFUNCTION(BlueprintPure, meta = (Keywords = "find"), Category = "Utilities|String")
    static bool Contains(
        const FString& SearchIn, const FString& Substring, bool bUseCase = false, bool bSearchFromEnd = false);

    /** Gets a single character from the string (as an integer); 0 if the index is out of range. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static int32 GetCharacterAsNumber(const FString& SourceString, int32 Index = 0);

    /** Tests whether this string starts with the given string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool StartsWith(
        const FString& SourceString, const FString& InPrefix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);

    /** Tests whether this string ends with the given string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool EndsWith(
        const FString& SourceString, const FString& InSuffix, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);

    /** Searches this string for a given wildcard: * is any text, ? any one character. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool MatchesWildcard(
        const FString& SourceString, const FString& Wildcard, ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);

    /** Checks whether the string is a number. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool IsNumeric(const FString& SourceString);

    // -------------------------------------------------------------------------------------------------------- Changing

    /** Gets an array of strings from a source string divided up by a delimiter. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static TArray<FString> ParseIntoArray(
        const FString& SourceString, const FString& Delimiter = FString(TEXT(" ")), const bool CullEmptyStrings = true);

    /** Concatenates an array of strings into a single string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString JoinStringArray(const TArray<FString>& SourceArray, const FString& Separator = FString(TEXT(" ")));

    /** Returns an array that contains one entry for each character of the string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static TArray<FString> GetCharacterArrayFromString(const FString& SourceString);

    /** Returns a string converted to upper case. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString ToUpper(const FString& SourceString);

    /** Returns a string converted to lower case. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString ToLower(const FString& SourceString);

    /** Pads the left of this string for a number of characters. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString LeftPad(const FString& SourceString, int32 ChCount);

    /** Pads the right of this string for a number of characters. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString RightPad(const FString& SourceString, int32 ChCount);

    /** Removes white space characters from the start of this string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Trim(const FString& SourceString);

    /** Removes white space characters from the end of this string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString TrimTrailing(const FString& SourceString);

    /** Returns a copy of this string, with the characters in reverse order. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Reverse(const FString& SourceString);

    /** Replaces all occurrences of a substring in this string. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Replace(const FString& SourceString, const FString& From, const FString& To,
        ESearchCase::Type SearchCase = ESearchCase::IgnoreCase);

    /** Splits this string at the first (or last) occurrence of another one; returns whether there is one. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static bool Split(const FString& SourceString, const FString& InStr, FString& LeftS, FString& RightS,
        ESearchCase::Type SearchCase = ESearchCase::IgnoreCase, ESearchDir::Type SearchDir = ESearchDir::FromStart);

    /** Returns the left most given number of characters. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Left(const FString& SourceString, int32 Count);

    /** Returns the left most characters from the string chopping the given number of characters from the end. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString LeftChop(const FString& SourceString, int32 Count);

    /** Returns the string to the right of the specified location, counting back from the right. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Right(const FString& SourceString, int32 Count);

    /** Returns the string to the right of the specified location, counting forward from the left. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString RightChop(const FString& SourceString, int32 Count);

    /** Returns the substring from Start for Count characters. */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString Mid(const FString& SourceString, int32 Start, int32 Count);

    /** Converts a number of seconds into minutes:seconds.hundredths format ([-]MM:SS.hh). */
    UFUNCTION(BlueprintPure, Category = "Utilities|String")
    static FString TimeSecondsToString(float InSeconds);
};
