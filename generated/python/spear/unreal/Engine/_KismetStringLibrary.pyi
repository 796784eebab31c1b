# generated, do not edit (Engine: Public/Kismet/KismetStringLibrary.h)
from collections.abc import Sequence
from typing import NamedTuple
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._NoExportTypes import (
    ESearchCase, ESearchCase_in, ESearchDir, ESearchDir_in, FLinearColor, FLinearColor_in, FRotator, FRotator_in, FTransform_in, FVector, FVector2D,
    FVector2D_in, FVector_in, UObject,
)
from ._BlueprintFunctionLibrary import (
    UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_async, UBlueprintFunctionLibrary_members, UBlueprintFunctionLibrary_send,
)

class UKismetStringLibrary_Conv_StringToColor_Result(NamedTuple):
    """Results of UKismetStringLibrary.Conv_StringToColor."""
    OutConvertedColor: FLinearColor
    OutIsValid: bool

class UKismetStringLibrary_Conv_StringToRotator_Result(NamedTuple):
    """Results of UKismetStringLibrary.Conv_StringToRotator."""
    OutConvertedRotator: FRotator
    OutIsValid: bool

class UKismetStringLibrary_Conv_StringToVector_Result(NamedTuple):
    """Results of UKismetStringLibrary.Conv_StringToVector."""
    OutConvertedVector: FVector
    OutIsValid: bool

class UKismetStringLibrary_Conv_StringToVector2D_Result(NamedTuple):
    """Results of UKismetStringLibrary.Conv_StringToVector2D."""
    OutConvertedVector2D: FVector2D
    OutIsValid: bool

class UKismetStringLibrary_Split_Result(NamedTuple):
    """Results of UKismetStringLibrary.Split."""
    ReturnValue: bool
    LeftS: str
    RightS: str

class UKismetStringLibrary_members(UBlueprintFunctionLibrary_members):
    """Functions and variables of UKismetStringLibrary."""
    def BuildString_Bool(self, AppendTo: str | Future[str], Prefix: str | Future[str], InBool: bool | Future[bool], Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Bool (static)
        """
    def BuildString_Color(self, AppendTo: str | Future[str], Prefix: str | Future[str], InColor: FLinearColor_in, Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Color (static)
        """
    def BuildString_Double(self, AppendTo: str | Future[str], Prefix: str | Future[str], InDouble: float | Future[float], Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Double (static)
        """
    def BuildString_Int(self, AppendTo: str | Future[str], Prefix: str | Future[str], InInt: int | Future[int], Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Int (static)
        """
    def BuildString_Name(self, AppendTo: str | Future[str], Prefix: str | Future[str], InName: str | Future[str], Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Name (static)
        """
    def BuildString_Object(self, AppendTo: str | Future[str], Prefix: str | Future[str], InObj: UObject | Future[UObject], Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Object (static)
        """
    def BuildString_Rotator(self, AppendTo: str | Future[str], Prefix: str | Future[str], InRot: FRotator_in, Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Rotator (static)
        """
    def BuildString_Vector(self, AppendTo: str | Future[str], Prefix: str | Future[str], InVector: FVector_in, Suffix: str | Future[str]) -> str:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix.

        Unreal: UKismetStringLibrary.BuildString_Vector (static)
        """
    def Concat_StrStr(self, A: str | Future[str], B: str | Future[str]) -> str:
        """Concatenates two strings together to make a new string.

        Unreal: UKismetStringLibrary.Concat_StrStr (static)
        """
    def Contains(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False) -> bool:
        """Returns whether this string contains the specified substring.

        Unreal: UKismetStringLibrary.Contains (static)
        """
    def Conv_BoolToString(self, InBool: bool | Future[bool]) -> str:
        """Converts a boolean value to a string, either "true" or "false".

        Unreal: UKismetStringLibrary.Conv_BoolToString (static)
        """
    def Conv_ByteToString(self, InByte: int | Future[int]) -> str:
        """Converts a byte value to a string.

        Unreal: UKismetStringLibrary.Conv_ByteToString (static)
        """
    def Conv_ColorToString(self, InColor: FLinearColor_in) -> str:
        """Converts a linear colour value to a string, in the form "(R=,G=,B=,A=)".

        Unreal: UKismetStringLibrary.Conv_ColorToString (static)
        """
    def Conv_DoubleToString(self, InDouble: float | Future[float]) -> str:
        """Converts a float value to a string, with the fewest digits that tell it, at least one after the point.

        Unreal: UKismetStringLibrary.Conv_DoubleToString (static)
        """
    def Conv_Int64ToString(self, InInt: int | Future[int]) -> str:
        """Converts a 64 bit integer value to a string.

        Unreal: UKismetStringLibrary.Conv_Int64ToString (static)
        """
    def Conv_IntToString(self, InInt: int | Future[int]) -> str:
        """Converts an integer value to a string.

        Unreal: UKismetStringLibrary.Conv_IntToString (static)
        """
    def Conv_NameToString(self, InName: str | Future[str]) -> str:
        """Converts a name value to a string.

        Unreal: UKismetStringLibrary.Conv_NameToString (static)
        """
    def Conv_ObjectToString(self, InObj: UObject | Future[UObject]) -> str:
        """Converts an object value to a string by calling the object's GetName method; "None" for null.

        Unreal: UKismetStringLibrary.Conv_ObjectToString (static)
        """
    def Conv_RotatorToString(self, InRot: FRotator_in) -> str:
        """Converts a rotator value to a string, in the form "P= Y= R=".

        Unreal: UKismetStringLibrary.Conv_RotatorToString (static)
        """
    def Conv_StringToColor(self, InString: str | Future[str]) -> UKismetStringLibrary_Conv_StringToColor_Result:
        """Converts a string of the form "(R=,G=,B=,A=)" to a linear colour, and says whether that worked.

        Unreal: UKismetStringLibrary.Conv_StringToColor (static)
        """
    def Conv_StringToDouble(self, InString: str | Future[str]) -> float:
        """Converts a string to a float value; 0 if it does not begin with a number.

        Unreal: UKismetStringLibrary.Conv_StringToDouble (static)
        """
    def Conv_StringToInt(self, InString: str | Future[str]) -> int:
        """Converts a string to an int value; 0 if it does not begin with a number.

        Unreal: UKismetStringLibrary.Conv_StringToInt (static)
        """
    def Conv_StringToInt64(self, InString: str | Future[str]) -> int:
        """Converts a string to a 64 bit integer value; 0 if it does not begin with a number.

        Unreal: UKismetStringLibrary.Conv_StringToInt64 (static)
        """
    def Conv_StringToName(self, InString: str | Future[str]) -> str:
        """Converts a string to a name value.

        Unreal: UKismetStringLibrary.Conv_StringToName (static)
        """
    def Conv_StringToRotator(self, InString: str | Future[str]) -> UKismetStringLibrary_Conv_StringToRotator_Result:
        """Converts a string of the form "P= Y= R=" to a rotator, and says whether that worked.

        Unreal: UKismetStringLibrary.Conv_StringToRotator (static)
        """
    def Conv_StringToVector(self, InString: str | Future[str]) -> UKismetStringLibrary_Conv_StringToVector_Result:
        """Converts a string of the form "X= Y= Z=" to a vector, and says whether that worked.

        Unreal: UKismetStringLibrary.Conv_StringToVector (static)
        """
    def Conv_StringToVector2D(self, InString: str | Future[str]) -> UKismetStringLibrary_Conv_StringToVector2D_Result:
        """Converts a string of the form "X= Y=" to a 2D vector, and says whether that worked.

        Unreal: UKismetStringLibrary.Conv_StringToVector2D (static)
        """
    def Conv_TransformToString(self, InTrans: FTransform_in) -> str:
        """Converts a transform value to a string: translation, rotation and scale.

        Unreal: UKismetStringLibrary.Conv_TransformToString (static)
        """
    def Conv_Vector2dToString(self, InVec: FVector2D_in) -> str:
        """Converts a 2D vector value to a string, in the form "X= Y=".

        Unreal: UKismetStringLibrary.Conv_Vector2dToString (static)
        """
    def Conv_VectorToString(self, InVec: FVector_in) -> str:
        """Converts a vector value to a string, in the form "X= Y= Z=".

        Unreal: UKismetStringLibrary.Conv_VectorToString (static)
        """
    def EndsWith(self, SourceString: str | Future[str], InSuffix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> bool:
        """Tests whether this string ends with the given string.

        Unreal: UKismetStringLibrary.EndsWith (static)
        """
    def EqualEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Tests if two strings are equal, case counted.

        Unreal: UKismetStringLibrary.EqualEqual_StrStr (static)
        """
    def EqualEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Tests if two strings are equal, regardless of case.

        Unreal: UKismetStringLibrary.EqualEqual_StriStri (static)
        """
    def FindSubstring(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False, StartPosition: int | Future[int] = -1) -> int:
        """Finds the starting index of a substring in a string; -1 if it is not found.

        Unreal: UKismetStringLibrary.FindSubstring (static)
        """
    def GetCharacterArrayFromString(self, SourceString: str | Future[str]) -> list[str]:
        """Returns an array that contains one entry for each character of the string.

        Unreal: UKismetStringLibrary.GetCharacterArrayFromString (static)
        """
    def GetCharacterAsNumber(self, SourceString: str | Future[str], Index: int | Future[int] = 0) -> int:
        """Gets a single character from the string (as an integer); 0 if the index is out of range.

        Unreal: UKismetStringLibrary.GetCharacterAsNumber (static)
        """
    def GetSubstring(self, SourceString: str | Future[str], StartIndex: int | Future[int] = 0, Length: int | Future[int] = 1) -> str:
        """Returns a substring from the string starting at the specified position; an empty one if that is out of range.

        Unreal: UKismetStringLibrary.GetSubstring (static)
        """
    def IsEmpty(self, InString: str | Future[str]) -> bool:
        """Returns true if the string is empty.

        Unreal: UKismetStringLibrary.IsEmpty (static)
        """
    def IsNumeric(self, SourceString: str | Future[str]) -> bool:
        """Checks whether the string is a number.

        Unreal: UKismetStringLibrary.IsNumeric (static)
        """
    def JoinStringArray(self, SourceArray: Sequence[str | Future[str]] | Future[list[str]], Separator: str | Future[str] = " ") -> str:
        """Concatenates an array of strings into a single string.

        Unreal: UKismetStringLibrary.JoinStringArray (static)
        """
    def Left(self, SourceString: str | Future[str], Count: int | Future[int]) -> str:
        """Returns the left most given number of characters.

        Unreal: UKismetStringLibrary.Left (static)
        """
    def LeftChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> str:
        """Returns the left most characters from the string chopping the given number of characters from the end.

        Unreal: UKismetStringLibrary.LeftChop (static)
        """
    def LeftPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> str:
        """Pads the left of this string for a number of characters.

        Unreal: UKismetStringLibrary.LeftPad (static)
        """
    def Len(self, S: str | Future[str]) -> int:
        """Returns the number of characters in the string.

        Unreal: UKismetStringLibrary.Len (static)
        """
    def MatchesWildcard(self, SourceString: str | Future[str], Wildcard: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> bool:
        """Searches this string for a given wildcard: * is any text, ? any one character.

        Unreal: UKismetStringLibrary.MatchesWildcard (static)
        """
    def Mid(self, SourceString: str | Future[str], Start: int | Future[int], Count: int | Future[int]) -> str:
        """Returns the substring from Start for Count characters.

        Unreal: UKismetStringLibrary.Mid (static)
        """
    def NotEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Tests if two strings are not equal, case counted.

        Unreal: UKismetStringLibrary.NotEqual_StrStr (static)
        """
    def NotEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Tests if two strings are not equal, regardless of case.

        Unreal: UKismetStringLibrary.NotEqual_StriStri (static)
        """
    def ParseIntoArray(self, SourceString: str | Future[str], Delimiter: str | Future[str] = " ", CullEmptyStrings: bool | Future[bool] = True) -> list[str]:
        """Gets an array of strings from a source string divided up by a delimiter.

        Unreal: UKismetStringLibrary.ParseIntoArray (static)
        """
    def Replace(self, SourceString: str | Future[str], From: str | Future[str], To: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> str:
        """Replaces all occurrences of a substring in this string.

        Unreal: UKismetStringLibrary.Replace (static)
        """
    def Reverse(self, SourceString: str | Future[str]) -> str:
        """Returns a copy of this string, with the characters in reverse order.

        Unreal: UKismetStringLibrary.Reverse (static)
        """
    def Right(self, SourceString: str | Future[str], Count: int | Future[int]) -> str:
        """Returns the string to the right of the specified location, counting back from the right.

        Unreal: UKismetStringLibrary.Right (static)
        """
    def RightChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> str:
        """Returns the string to the right of the specified location, counting forward from the left.

        Unreal: UKismetStringLibrary.RightChop (static)
        """
    def RightPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> str:
        """Pads the right of this string for a number of characters.

        Unreal: UKismetStringLibrary.RightPad (static)
        """
    def Split(self, SourceString: str | Future[str], InStr: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase, SearchDir: ESearchDir_in = ESearchDir.FromStart) -> UKismetStringLibrary_Split_Result:
        """Splits this string at the first (or last) occurrence of another one; returns whether there is one.

        Unreal: UKismetStringLibrary.Split (static)
        """
    def StartsWith(self, SourceString: str | Future[str], InPrefix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> bool:
        """Tests whether this string starts with the given string.

        Unreal: UKismetStringLibrary.StartsWith (static)
        """
    def TimeSecondsToString(self, InSeconds: float | Future[float]) -> str:
        """Converts a number of seconds into minutes:seconds.hundredths format ([-]MM:SS.hh).

        Unreal: UKismetStringLibrary.TimeSecondsToString (static)
        """
    def ToLower(self, SourceString: str | Future[str]) -> str:
        """Returns a string converted to lower case.

        Unreal: UKismetStringLibrary.ToLower (static)
        """
    def ToUpper(self, SourceString: str | Future[str]) -> str:
        """Returns a string converted to upper case.

        Unreal: UKismetStringLibrary.ToUpper (static)
        """
    def Trim(self, SourceString: str | Future[str]) -> str:
        """Removes white space characters from the start of this string.

        Unreal: UKismetStringLibrary.Trim (static)
        """
    def TrimTrailing(self, SourceString: str | Future[str]) -> str:
        """Removes white space characters from the end of this string.

        Unreal: UKismetStringLibrary.TrimTrailing (static)
        """

class UKismetStringLibrary_async(UBlueprintFunctionLibrary_async):
    """UKismetStringLibrary under ``async_``: each function gives a future."""
    def BuildString_Bool(self, AppendTo: str | Future[str], Prefix: str | Future[str], InBool: bool | Future[bool], Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Color(self, AppendTo: str | Future[str], Prefix: str | Future[str], InColor: FLinearColor_in, Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Double(self, AppendTo: str | Future[str], Prefix: str | Future[str], InDouble: float | Future[float], Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Int(self, AppendTo: str | Future[str], Prefix: str | Future[str], InInt: int | Future[int], Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Name(self, AppendTo: str | Future[str], Prefix: str | Future[str], InName: str | Future[str], Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Object(self, AppendTo: str | Future[str], Prefix: str | Future[str], InObj: UObject | Future[UObject], Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Rotator(self, AppendTo: str | Future[str], Prefix: str | Future[str], InRot: FRotator_in, Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Vector(self, AppendTo: str | Future[str], Prefix: str | Future[str], InVector: FVector_in, Suffix: str | Future[str]) -> Future[str]:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def Concat_StrStr(self, A: str | Future[str], B: str | Future[str]) -> Future[str]:
        """Concatenates two strings together to make a new string."""
    def Contains(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False) -> Future[bool]:
        """Returns whether this string contains the specified substring."""
    def Conv_BoolToString(self, InBool: bool | Future[bool]) -> Future[str]:
        """Converts a boolean value to a string, either "true" or "false"."""
    def Conv_ByteToString(self, InByte: int | Future[int]) -> Future[str]:
        """Converts a byte value to a string."""
    def Conv_ColorToString(self, InColor: FLinearColor_in) -> Future[str]:
        """Converts a linear colour value to a string, in the form "(R=,G=,B=,A=)"."""
    def Conv_DoubleToString(self, InDouble: float | Future[float]) -> Future[str]:
        """Converts a float value to a string, with the fewest digits that tell it, at least one after the point."""
    def Conv_Int64ToString(self, InInt: int | Future[int]) -> Future[str]:
        """Converts a 64 bit integer value to a string."""
    def Conv_IntToString(self, InInt: int | Future[int]) -> Future[str]:
        """Converts an integer value to a string."""
    def Conv_NameToString(self, InName: str | Future[str]) -> Future[str]:
        """Converts a name value to a string."""
    def Conv_ObjectToString(self, InObj: UObject | Future[UObject]) -> Future[str]:
        """Converts an object value to a string by calling the object's GetName method; "None" for null."""
    def Conv_RotatorToString(self, InRot: FRotator_in) -> Future[str]:
        """Converts a rotator value to a string, in the form "P= Y= R="."""
    def Conv_StringToColor(self, InString: str | Future[str]) -> Future[UKismetStringLibrary_Conv_StringToColor_Result]:
        """Converts a string of the form "(R=,G=,B=,A=)" to a linear colour, and says whether that worked."""
    def Conv_StringToDouble(self, InString: str | Future[str]) -> Future[float]:
        """Converts a string to a float value; 0 if it does not begin with a number."""
    def Conv_StringToInt(self, InString: str | Future[str]) -> Future[int]:
        """Converts a string to an int value; 0 if it does not begin with a number."""
    def Conv_StringToInt64(self, InString: str | Future[str]) -> Future[int]:
        """Converts a string to a 64 bit integer value; 0 if it does not begin with a number."""
    def Conv_StringToName(self, InString: str | Future[str]) -> Future[str]:
        """Converts a string to a name value."""
    def Conv_StringToRotator(self, InString: str | Future[str]) -> Future[UKismetStringLibrary_Conv_StringToRotator_Result]:
        """Converts a string of the form "P= Y= R=" to a rotator, and says whether that worked."""
    def Conv_StringToVector(self, InString: str | Future[str]) -> Future[UKismetStringLibrary_Conv_StringToVector_Result]:
        """Converts a string of the form "X= Y= Z=" to a vector, and says whether that worked."""
    def Conv_StringToVector2D(self, InString: str | Future[str]) -> Future[UKismetStringLibrary_Conv_StringToVector2D_Result]:
        """Converts a string of the form "X= Y=" to a 2D vector, and says whether that worked."""
    def Conv_TransformToString(self, InTrans: FTransform_in) -> Future[str]:
        """Converts a transform value to a string: translation, rotation and scale."""
    def Conv_Vector2dToString(self, InVec: FVector2D_in) -> Future[str]:
        """Converts a 2D vector value to a string, in the form "X= Y="."""
    def Conv_VectorToString(self, InVec: FVector_in) -> Future[str]:
        """Converts a vector value to a string, in the form "X= Y= Z="."""
    def EndsWith(self, SourceString: str | Future[str], InSuffix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> Future[bool]:
        """Tests whether this string ends with the given string."""
    def EqualEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Tests if two strings are equal, case counted."""
    def EqualEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Tests if two strings are equal, regardless of case."""
    def FindSubstring(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False, StartPosition: int | Future[int] = -1) -> Future[int]:
        """Finds the starting index of a substring in a string; -1 if it is not found."""
    def GetCharacterArrayFromString(self, SourceString: str | Future[str]) -> Future[list[str]]:
        """Returns an array that contains one entry for each character of the string."""
    def GetCharacterAsNumber(self, SourceString: str | Future[str], Index: int | Future[int] = 0) -> Future[int]:
        """Gets a single character from the string (as an integer); 0 if the index is out of range."""
    def GetSubstring(self, SourceString: str | Future[str], StartIndex: int | Future[int] = 0, Length: int | Future[int] = 1) -> Future[str]:
        """Returns a substring from the string starting at the specified position; an empty one if that is out of range."""
    def IsEmpty(self, InString: str | Future[str]) -> Future[bool]:
        """Returns true if the string is empty."""
    def IsNumeric(self, SourceString: str | Future[str]) -> Future[bool]:
        """Checks whether the string is a number."""
    def JoinStringArray(self, SourceArray: Sequence[str | Future[str]] | Future[list[str]], Separator: str | Future[str] = " ") -> Future[str]:
        """Concatenates an array of strings into a single string."""
    def Left(self, SourceString: str | Future[str], Count: int | Future[int]) -> Future[str]:
        """Returns the left most given number of characters."""
    def LeftChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> Future[str]:
        """Returns the left most characters from the string chopping the given number of characters from the end."""
    def LeftPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> Future[str]:
        """Pads the left of this string for a number of characters."""
    def Len(self, S: str | Future[str]) -> Future[int]:
        """Returns the number of characters in the string."""
    def MatchesWildcard(self, SourceString: str | Future[str], Wildcard: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> Future[bool]:
        """Searches this string for a given wildcard: * is any text, ? any one character."""
    def Mid(self, SourceString: str | Future[str], Start: int | Future[int], Count: int | Future[int]) -> Future[str]:
        """Returns the substring from Start for Count characters."""
    def NotEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Tests if two strings are not equal, case counted."""
    def NotEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Tests if two strings are not equal, regardless of case."""
    def ParseIntoArray(self, SourceString: str | Future[str], Delimiter: str | Future[str] = " ", CullEmptyStrings: bool | Future[bool] = True) -> Future[list[str]]:
        """Gets an array of strings from a source string divided up by a delimiter."""
    def Replace(self, SourceString: str | Future[str], From: str | Future[str], To: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> Future[str]:
        """Replaces all occurrences of a substring in this string."""
    def Reverse(self, SourceString: str | Future[str]) -> Future[str]:
        """Returns a copy of this string, with the characters in reverse order."""
    def Right(self, SourceString: str | Future[str], Count: int | Future[int]) -> Future[str]:
        """Returns the string to the right of the specified location, counting back from the right."""
    def RightChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> Future[str]:
        """Returns the string to the right of the specified location, counting forward from the left."""
    def RightPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> Future[str]:
        """Pads the right of this string for a number of characters."""
    def Split(self, SourceString: str | Future[str], InStr: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase, SearchDir: ESearchDir_in = ESearchDir.FromStart) -> Future[UKismetStringLibrary_Split_Result]:
        """Splits this string at the first (or last) occurrence of another one; returns whether there is one."""
    def StartsWith(self, SourceString: str | Future[str], InPrefix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> Future[bool]:
        """Tests whether this string starts with the given string."""
    def TimeSecondsToString(self, InSeconds: float | Future[float]) -> Future[str]:
        """Converts a number of seconds into minutes:seconds.hundredths format ([-]MM:SS.hh)."""
    def ToLower(self, SourceString: str | Future[str]) -> Future[str]:
        """Returns a string converted to lower case."""
    def ToUpper(self, SourceString: str | Future[str]) -> Future[str]:
        """Returns a string converted to upper case."""
    def Trim(self, SourceString: str | Future[str]) -> Future[str]:
        """Removes white space characters from the start of this string."""
    def TrimTrailing(self, SourceString: str | Future[str]) -> Future[str]:
        """Removes white space characters from the end of this string."""

class UKismetStringLibrary_send(UBlueprintFunctionLibrary_send):
    """UKismetStringLibrary under ``send_``: no function answers."""
    def BuildString_Bool(self, AppendTo: str | Future[str], Prefix: str | Future[str], InBool: bool | Future[bool], Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Color(self, AppendTo: str | Future[str], Prefix: str | Future[str], InColor: FLinearColor_in, Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Double(self, AppendTo: str | Future[str], Prefix: str | Future[str], InDouble: float | Future[float], Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Int(self, AppendTo: str | Future[str], Prefix: str | Future[str], InInt: int | Future[int], Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Name(self, AppendTo: str | Future[str], Prefix: str | Future[str], InName: str | Future[str], Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Object(self, AppendTo: str | Future[str], Prefix: str | Future[str], InObj: UObject | Future[UObject], Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Rotator(self, AppendTo: str | Future[str], Prefix: str | Future[str], InRot: FRotator_in, Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def BuildString_Vector(self, AppendTo: str | Future[str], Prefix: str | Future[str], InVector: FVector_in, Suffix: str | Future[str]) -> None:
        """Converts a value to a string and appends it to a string, between a prefix and a suffix."""
    def Concat_StrStr(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Concatenates two strings together to make a new string."""
    def Contains(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False) -> None:
        """Returns whether this string contains the specified substring."""
    def Conv_BoolToString(self, InBool: bool | Future[bool]) -> None:
        """Converts a boolean value to a string, either "true" or "false"."""
    def Conv_ByteToString(self, InByte: int | Future[int]) -> None:
        """Converts a byte value to a string."""
    def Conv_ColorToString(self, InColor: FLinearColor_in) -> None:
        """Converts a linear colour value to a string, in the form "(R=,G=,B=,A=)"."""
    def Conv_DoubleToString(self, InDouble: float | Future[float]) -> None:
        """Converts a float value to a string, with the fewest digits that tell it, at least one after the point."""
    def Conv_Int64ToString(self, InInt: int | Future[int]) -> None:
        """Converts a 64 bit integer value to a string."""
    def Conv_IntToString(self, InInt: int | Future[int]) -> None:
        """Converts an integer value to a string."""
    def Conv_NameToString(self, InName: str | Future[str]) -> None:
        """Converts a name value to a string."""
    def Conv_ObjectToString(self, InObj: UObject | Future[UObject]) -> None:
        """Converts an object value to a string by calling the object's GetName method; "None" for null."""
    def Conv_RotatorToString(self, InRot: FRotator_in) -> None:
        """Converts a rotator value to a string, in the form "P= Y= R="."""
    def Conv_StringToColor(self, InString: str | Future[str]) -> None:
        """Converts a string of the form "(R=,G=,B=,A=)" to a linear colour, and says whether that worked."""
    def Conv_StringToDouble(self, InString: str | Future[str]) -> None:
        """Converts a string to a float value; 0 if it does not begin with a number."""
    def Conv_StringToInt(self, InString: str | Future[str]) -> None:
        """Converts a string to an int value; 0 if it does not begin with a number."""
    def Conv_StringToInt64(self, InString: str | Future[str]) -> None:
        """Converts a string to a 64 bit integer value; 0 if it does not begin with a number."""
    def Conv_StringToName(self, InString: str | Future[str]) -> None:
        """Converts a string to a name value."""
    def Conv_StringToRotator(self, InString: str | Future[str]) -> None:
        """Converts a string of the form "P= Y= R=" to a rotator, and says whether that worked."""
    def Conv_StringToVector(self, InString: str | Future[str]) -> None:
        """Converts a string of the form "X= Y= Z=" to a vector, and says whether that worked."""
    def Conv_StringToVector2D(self, InString: str | Future[str]) -> None:
        """Converts a string of the form "X= Y=" to a 2D vector, and says whether that worked."""
    def Conv_TransformToString(self, InTrans: FTransform_in) -> None:
        """Converts a transform value to a string: translation, rotation and scale."""
    def Conv_Vector2dToString(self, InVec: FVector2D_in) -> None:
        """Converts a 2D vector value to a string, in the form "X= Y="."""
    def Conv_VectorToString(self, InVec: FVector_in) -> None:
        """Converts a vector value to a string, in the form "X= Y= Z="."""
    def EndsWith(self, SourceString: str | Future[str], InSuffix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> None:
        """Tests whether this string ends with the given string."""
    def EqualEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Tests if two strings are equal, case counted."""
    def EqualEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Tests if two strings are equal, regardless of case."""
    def FindSubstring(self, SearchIn: str | Future[str], Substring: str | Future[str], bUseCase: bool | Future[bool] = False, bSearchFromEnd: bool | Future[bool] = False, StartPosition: int | Future[int] = -1) -> None:
        """Finds the starting index of a substring in a string; -1 if it is not found."""
    def GetCharacterArrayFromString(self, SourceString: str | Future[str]) -> None:
        """Returns an array that contains one entry for each character of the string."""
    def GetCharacterAsNumber(self, SourceString: str | Future[str], Index: int | Future[int] = 0) -> None:
        """Gets a single character from the string (as an integer); 0 if the index is out of range."""
    def GetSubstring(self, SourceString: str | Future[str], StartIndex: int | Future[int] = 0, Length: int | Future[int] = 1) -> None:
        """Returns a substring from the string starting at the specified position; an empty one if that is out of range."""
    def IsEmpty(self, InString: str | Future[str]) -> None:
        """Returns true if the string is empty."""
    def IsNumeric(self, SourceString: str | Future[str]) -> None:
        """Checks whether the string is a number."""
    def JoinStringArray(self, SourceArray: Sequence[str | Future[str]] | Future[list[str]], Separator: str | Future[str] = " ") -> None:
        """Concatenates an array of strings into a single string."""
    def Left(self, SourceString: str | Future[str], Count: int | Future[int]) -> None:
        """Returns the left most given number of characters."""
    def LeftChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> None:
        """Returns the left most characters from the string chopping the given number of characters from the end."""
    def LeftPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> None:
        """Pads the left of this string for a number of characters."""
    def Len(self, S: str | Future[str]) -> None:
        """Returns the number of characters in the string."""
    def MatchesWildcard(self, SourceString: str | Future[str], Wildcard: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> None:
        """Searches this string for a given wildcard: * is any text, ? any one character."""
    def Mid(self, SourceString: str | Future[str], Start: int | Future[int], Count: int | Future[int]) -> None:
        """Returns the substring from Start for Count characters."""
    def NotEqual_StrStr(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Tests if two strings are not equal, case counted."""
    def NotEqual_StriStri(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Tests if two strings are not equal, regardless of case."""
    def ParseIntoArray(self, SourceString: str | Future[str], Delimiter: str | Future[str] = " ", CullEmptyStrings: bool | Future[bool] = True) -> None:
        """Gets an array of strings from a source string divided up by a delimiter."""
    def Replace(self, SourceString: str | Future[str], From: str | Future[str], To: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> None:
        """Replaces all occurrences of a substring in this string."""
    def Reverse(self, SourceString: str | Future[str]) -> None:
        """Returns a copy of this string, with the characters in reverse order."""
    def Right(self, SourceString: str | Future[str], Count: int | Future[int]) -> None:
        """Returns the string to the right of the specified location, counting back from the right."""
    def RightChop(self, SourceString: str | Future[str], Count: int | Future[int]) -> None:
        """Returns the string to the right of the specified location, counting forward from the left."""
    def RightPad(self, SourceString: str | Future[str], ChCount: int | Future[int]) -> None:
        """Pads the right of this string for a number of characters."""
    def Split(self, SourceString: str | Future[str], InStr: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase, SearchDir: ESearchDir_in = ESearchDir.FromStart) -> None:
        """Splits this string at the first (or last) occurrence of another one; returns whether there is one."""
    def StartsWith(self, SourceString: str | Future[str], InPrefix: str | Future[str], SearchCase: ESearchCase_in = ESearchCase.IgnoreCase) -> None:
        """Tests whether this string starts with the given string."""
    def TimeSecondsToString(self, InSeconds: float | Future[float]) -> None:
        """Converts a number of seconds into minutes:seconds.hundredths format ([-]MM:SS.hh)."""
    def ToLower(self, SourceString: str | Future[str]) -> None:
        """Returns a string converted to lower case."""
    def ToUpper(self, SourceString: str | Future[str]) -> None:
        """Returns a string converted to upper case."""
    def Trim(self, SourceString: str | Future[str]) -> None:
        """Removes white space characters from the start of this string."""
    def TrimTrailing(self, SourceString: str | Future[str]) -> None:
        """Removes white space characters from the end of this string."""

class UKismetStringLibrary(UKismetStringLibrary_members, UBlueprintFunctionLibrary):
    """Strings for scripts and remote programs. Epic page: UKismetStringLibrary.

    Unreal: /Script/Engine.KismetStringLibrary
    """
    @property
    def async_(self) -> UKismetStringLibrary_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UKismetStringLibrary_send:
        """The same functions and variables, fire-and-forget."""

class UKismetStringLibrary_path(ObjectPath[UKismetStringLibrary, UKismetStringLibrary_async_path, UKismetStringLibrary_send], UKismetStringLibrary_members):
    """A variable that refers to an object of UKismetStringLibrary: its path."""

class UKismetStringLibrary_async_path(AsyncObjectPath[UKismetStringLibrary], UKismetStringLibrary_async):
    """The same under ``async_``."""
