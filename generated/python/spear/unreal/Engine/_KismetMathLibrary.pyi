# generated, do not edit (Engine: Public/Kismet/KismetMathLibrary.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias
from spear.enums import UnrealEnum
from spear.typing import AsyncObjectPath, Buffer, Future, ObjectPath
from ..CoreUObject._Intrinsic import UClass
from ..CoreUObject._NoExportTypes import (
    FBox, FBox_in, FColor, FColor_in, FDateTime, FDateTime_in, FIntPoint_in, FIntVector_in, FLinearColor, FLinearColor_in, FQuat, FQuat_in,
    FRandomStream, FRandomStream_in, FRotator, FRotator_in, FTimespan, FTimespan_in, FTransform, FTransform_in, FVector, FVector2D, FVector2D_in,
    FVector_in, UObject,
)
from ._BlueprintFunctionLibrary import (
    UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_async, UBlueprintFunctionLibrary_members, UBlueprintFunctionLibrary_send,
)

class EEasingFunc(UnrealEnum):
    """Easing functions. Epic page: EEasingFunc::Type.

    Unreal: /Script/Engine.EEasingFunc
    """
    Linear = 0
    """Simple linear interpolation."""
    Step = 1
    """Simple step interpolation."""
    SinusoidalIn = 2
    """Sinusoidal in interpolation."""
    SinusoidalOut = 3
    """Sinusoidal out interpolation."""
    SinusoidalInOut = 4
    """Sinusoidal in/out interpolation."""
    EaseIn = 5
    """Smoothly accelerates, but does not decelerate into the target. Ease amount controlled by BlendExp."""
    EaseOut = 6
    """Immediately accelerates, but smoothly decelerates into the target. Ease amount controlled by BlendExp."""
    EaseInOut = 7
    """Smoothly accelerates and decelerates. Ease amount controlled by BlendExp."""
    ExpoIn = 8
    """Easing in using an exponential."""
    ExpoOut = 9
    """Easing out using an exponential."""
    ExpoInOut = 10
    """Easing in/out using an exponential method."""
    CircularIn = 11
    """Easing is based on a half circle."""
    CircularOut = 12
    """Easing is based on an inverted half circle."""
    CircularInOut = 13
    """Easing is based on two half circles."""

EEasingFunc_in: TypeAlias = EEasingFunc | str | Future[EEasingFunc]
"""What stands for EEasingFunc as an argument: an entry, the name that Unreal gives it, a future."""

class ELerpInterpolationMode(UnrealEnum):
    """Different methods for interpolating rotation between transforms. Epic page: ELerpInterpolationMode::Type.

    Unreal: /Script/Engine.ELerpInterpolationMode
    """
    QuatInterp = 0
    """Shortest path or quaternion interpolation for the rotation."""
    EulerInterp = 1
    """Rotor or Euler angle interpolation."""
    DualQuatInterp = 2
    """Dual quaternion interpolation, follows helix or screw-motion path between keyframes."""

ELerpInterpolationMode_in: TypeAlias = ELerpInterpolationMode | str | Future[ELerpInterpolationMode]
"""What stands for ELerpInterpolationMode as an argument: an entry, the name that Unreal gives it, a future."""

class UKismetMathLibrary_BreakColor_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakColor."""
    R: float
    G: float
    B: float
    A: float

class UKismetMathLibrary_BreakDateTime_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakDateTime."""
    Year: int
    Month: int
    Day: int
    Hour: int
    Minute: int
    Second: int
    Millisecond: int

class UKismetMathLibrary_BreakRandomStream_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakRandomStream."""
    InitialSeed: int

class UKismetMathLibrary_BreakRotIntoAxes_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakRotIntoAxes."""
    X: FVector
    Y: FVector
    Z: FVector

class UKismetMathLibrary_BreakRotator_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakRotator."""
    Roll: float
    Pitch: float
    Yaw: float

class UKismetMathLibrary_BreakTimespan_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakTimespan."""
    Days: int
    Hours: int
    Minutes: int
    Seconds: int
    Milliseconds: int

class UKismetMathLibrary_BreakTransform_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakTransform."""
    Location: FVector
    Rotation: FRotator
    Scale: FVector

class UKismetMathLibrary_BreakVector_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakVector."""
    X: float
    Y: float
    Z: float

class UKismetMathLibrary_BreakVector2D_Result(NamedTuple):
    """Results of UKismetMathLibrary.BreakVector2D."""
    X: float
    Y: float

class UKismetMathLibrary_FMod_Result(NamedTuple):
    """Results of UKismetMathLibrary.FMod."""
    ReturnValue: int
    Remainder: float

class UKismetMathLibrary_GetAzimuthAndElevation_Result(NamedTuple):
    """Results of UKismetMathLibrary.GetAzimuthAndElevation."""
    Azimuth: float
    Elevation: float

class UKismetMathLibrary_GetYawPitchFromVector_Result(NamedTuple):
    """Results of UKismetMathLibrary.GetYawPitchFromVector."""
    Yaw: float
    Pitch: float

class UKismetMathLibrary_MaxOfFloatArray_Result(NamedTuple):
    """Results of UKismetMathLibrary.MaxOfFloatArray."""
    IndexOfMaxValue: int
    MaxValue: float

class UKismetMathLibrary_MaxOfIntArray_Result(NamedTuple):
    """Results of UKismetMathLibrary.MaxOfIntArray."""
    IndexOfMaxValue: int
    MaxValue: int

class UKismetMathLibrary_MinOfFloatArray_Result(NamedTuple):
    """Results of UKismetMathLibrary.MinOfFloatArray."""
    IndexOfMinValue: int
    MinValue: float

class UKismetMathLibrary_MinOfIntArray_Result(NamedTuple):
    """Results of UKismetMathLibrary.MinOfIntArray."""
    IndexOfMinValue: int
    MinValue: int

class UKismetMathLibrary_RGBToHSV_Result(NamedTuple):
    """Results of UKismetMathLibrary.RGBToHSV."""
    H: float
    S: float
    V: float
    A: float

class UKismetMathLibrary_SeedRandomStream_Result(NamedTuple):
    """Results of UKismetMathLibrary.SeedRandomStream."""
    Stream: FRandomStream

class UKismetMathLibrary_SetRandomStreamSeed_Result(NamedTuple):
    """Results of UKismetMathLibrary.SetRandomStreamSeed."""
    Stream: FRandomStream

class UKismetMathLibrary_Vector_Assign_Result(NamedTuple):
    """Results of UKismetMathLibrary.Vector_Assign."""
    A: FVector

class UKismetMathLibrary_Vector_Set_Result(NamedTuple):
    """Results of UKismetMathLibrary.Vector_Set."""
    A: FVector

class UKismetMathLibrary_members(UBlueprintFunctionLibrary_members):
    """Functions and variables of UKismetMathLibrary."""
    def Abs(self, A: float | Future[float]) -> float:
        """Returns the absolute (positive) value of A.

        Unreal: UKismetMathLibrary.Abs (static)
        """
    def Abs_Int(self, A: int | Future[int]) -> int:
        """Returns the absolute (positive) value of A.

        Unreal: UKismetMathLibrary.Abs_Int (static)
        """
    def Abs_Int64(self, A: int | Future[int]) -> int:
        """Returns the absolute (positive) value of A.

        Unreal: UKismetMathLibrary.Abs_Int64 (static)
        """
    def Acos(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arccos) of A (result is in Radians).

        Unreal: UKismetMathLibrary.Acos (static)
        """
    def Add_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Addition (A + B), modulo 256.

        Unreal: UKismetMathLibrary.Add_ByteByte (static)
        """
    def Add_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> FDateTime:
        """Addition (A + B).

        Unreal: UKismetMathLibrary.Add_DateTimeTimespan (static)
        """
    def Add_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> float:
        """Addition (A + B).

        Unreal: UKismetMathLibrary.Add_DoubleDouble (static)
        """
    def Add_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Addition (A + B); wraps on overflow.

        Unreal: UKismetMathLibrary.Add_Int64Int64 (static)
        """
    def Add_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Addition (A + B); wraps on overflow.

        Unreal: UKismetMathLibrary.Add_IntInt (static)
        """
    def Add_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> FLinearColor:
        """Element-wise addition of two linear colours.

        Unreal: UKismetMathLibrary.Add_LinearColorLinearColor (static)
        """
    def Add_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> FQuat:
        """Returns addition of vector B to vector A, element by element.

        Unreal: UKismetMathLibrary.Add_QuatQuat (static)
        """
    def Add_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> FTimespan:
        """Addition (A + B).

        Unreal: UKismetMathLibrary.Add_TimespanTimespan (static)
        """
    def Add_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> FVector2D:
        """Addition (A + B).

        Unreal: UKismetMathLibrary.Add_Vector2DVector2D (static)
        """
    def Add_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> FVector:
        """Adds a float to each component of a vector.

        Unreal: UKismetMathLibrary.Add_VectorFloat (static)
        """
    def Add_VectorInt(self, A: FVector_in, B: int | Future[int]) -> FVector:
        """Adds an integer to each component of a vector.

        Unreal: UKismetMathLibrary.Add_VectorInt (static)
        """
    def Add_VectorVector(self, A: FVector_in, B: FVector_in) -> FVector:
        """Vector addition.

        Unreal: UKismetMathLibrary.Add_VectorVector (static)
        """
    def And_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise AND (A & B).

        Unreal: UKismetMathLibrary.And_Int64Int64 (static)
        """
    def And_IntInt(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise AND (A & B).

        Unreal: UKismetMathLibrary.And_IntInt (static)
        """
    def Asin(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arcsin) of A (result is in Radians).

        Unreal: UKismetMathLibrary.Asin (static)
        """
    def Atan(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arctan) of A (result is in Radians).

        Unreal: UKismetMathLibrary.Atan (static)
        """
    def Atan2(self, Y: float | Future[float], X: float | Future[float]) -> float:
        """Returns the inverse tan (atan2) of Y/X (result is in Radians).

        Unreal: UKismetMathLibrary.Atan2 (static)
        """
    def BMax(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the maximum value of A and B.

        Unreal: UKismetMathLibrary.BMax (static)
        """
    def BMin(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the minimum value of A and B.

        Unreal: UKismetMathLibrary.BMin (static)
        """
    def BooleanAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns the logical AND of two values (A AND B).

        Unreal: UKismetMathLibrary.BooleanAND (static)
        """
    def BooleanNAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns the logical NAND of two values (A NAND B).

        Unreal: UKismetMathLibrary.BooleanNAND (static)
        """
    def BooleanNOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns the logical Not OR of two values (A NOR B).

        Unreal: UKismetMathLibrary.BooleanNOR (static)
        """
    def BooleanOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns the logical OR of two values (A OR B).

        Unreal: UKismetMathLibrary.BooleanOR (static)
        """
    def BooleanXOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns the logical eXclusive OR of two values (A XOR B).

        Unreal: UKismetMathLibrary.BooleanXOR (static)
        """
    def Box_Intersects(self, A: FBox_in, B: FBox_in) -> bool:
        """Checks whether bounding box A intersects bounding box B. Boxes that touch do.

        Unreal: UKismetMathLibrary.Box_Intersects (static)
        """
    def Box_IsPointInside(self, Box: FBox_in, Point: FVector_in) -> bool:
        """Checks whether the given location is inside this box. Points on the border do not count, see IsPointInBox_Box.

        Unreal: UKismetMathLibrary.Box_IsPointInside (static)
        """
    def BreakColor(self, InColor: FLinearColor_in) -> UKismetMathLibrary_BreakColor_Result:
        """Breaks apart a colour into individual RGB components (as well as alpha).

        Unreal: UKismetMathLibrary.BreakColor (static)
        """
    def BreakDateTime(self, InDateTime: FDateTime_in) -> UKismetMathLibrary_BreakDateTime_Result:
        """Breaks a date and time into its components.

        Unreal: UKismetMathLibrary.BreakDateTime (static)
        """
    def BreakRandomStream(self, InRandomStream: FRandomStream_in) -> UKismetMathLibrary_BreakRandomStream_Result:
        """Breaks out a random number generator into its initial seed.

        Unreal: UKismetMathLibrary.BreakRandomStream (static)
        """
    def BreakRotIntoAxes(self, InRot: FRotator_in) -> UKismetMathLibrary_BreakRotIntoAxes_Result:
        """Breaks apart a rotator into its component axes.

        Unreal: UKismetMathLibrary.BreakRotIntoAxes (static)
        """
    def BreakRotator(self, InRot: FRotator_in) -> UKismetMathLibrary_BreakRotator_Result:
        """Breaks apart a rotator into {Roll, Pitch, Yaw} angles in degrees.

        Unreal: UKismetMathLibrary.BreakRotator (static)
        """
    def BreakTimespan(self, InTimespan: FTimespan_in) -> UKismetMathLibrary_BreakTimespan_Result:
        """Breaks a time span into its components.

        Unreal: UKismetMathLibrary.BreakTimespan (static)
        """
    def BreakTransform(self, InTransform: FTransform_in) -> UKismetMathLibrary_BreakTransform_Result:
        """Breaks apart a transform into location, rotation and scale.

        Unreal: UKismetMathLibrary.BreakTransform (static)
        """
    def BreakVector(self, InVec: FVector_in) -> UKismetMathLibrary_BreakVector_Result:
        """Breaks a vector apart into X, Y, Z.

        Unreal: UKismetMathLibrary.BreakVector (static)
        """
    def BreakVector2D(self, InVec: FVector2D_in) -> UKismetMathLibrary_BreakVector2D_Result:
        """Breaks a 2D vector apart into X, Y.

        Unreal: UKismetMathLibrary.BreakVector2D (static)
        """
    def CInterpTo(self, Current: FLinearColor_in, Target: FLinearColor_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FLinearColor:
        """Tries to reach a target colour. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.CInterpTo (static)
        """
    def Clamp(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> int:
        """Returns Value clamped to be between Min and Max (inclusive).

        Unreal: UKismetMathLibrary.Clamp (static)
        """
    def ClampAngle(self, AngleDegrees: float | Future[float], MinAngleDegrees: float | Future[float], MaxAngleDegrees: float | Future[float]) -> float:
        """Clamps an arbitrary angle to be between the given angles. Will clamp to nearest boundary. The result is
        between -180 and 180.

        Unreal: UKismetMathLibrary.ClampAngle (static)
        """
    def ClampAxis(self, Angle: float | Future[float]) -> float:
        """Clamps an angle to the range of [0, 360].

        Unreal: UKismetMathLibrary.ClampAxis (static)
        """
    def ClampInt64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> int:
        """Returns Value clamped to be between Min and Max (inclusive).

        Unreal: UKismetMathLibrary.ClampInt64 (static)
        """
    def ClampVectorSize(self, A: FVector_in, Min: float | Future[float], Max: float | Future[float]) -> FVector:
        """Creates a copy of this vector with its magnitude clamped between Min and Max.

        Unreal: UKismetMathLibrary.ClampVectorSize (static)
        """
    def ClassIsChildOf(self, TestClass: type[UObject] | UClass | str | Future[UClass], ParentClass: type[UObject] | UClass | str | Future[UClass]) -> bool:
        """Determines if a class is a child of another class.

        Unreal: UKismetMathLibrary.ClassIsChildOf (static)
        """
    def ComposeRotators(self, A: FRotator_in, B: FRotator_in) -> FRotator:
        """Combines 2 rotations to give you the resulting rotation of first applying A, then B.

        Unreal: UKismetMathLibrary.ComposeRotators (static)
        """
    def ComposeTransforms(self, A: FTransform_in, B: FTransform_in) -> FTransform:
        """Composes two transforms in order: A * B. Order matters when composing transforms: A * B first applies A, then
        B.

        Unreal: UKismetMathLibrary.ComposeTransforms (static)
        """
    def Conv_BoolToByte(self, InBool: bool | Future[bool]) -> int:
        """Converts a bool to a byte.

        Unreal: UKismetMathLibrary.Conv_BoolToByte (static)
        """
    def Conv_BoolToDouble(self, InBool: bool | Future[bool]) -> float:
        """Converts a bool to a float (0.0 or 1.0).

        Unreal: UKismetMathLibrary.Conv_BoolToDouble (static)
        """
    def Conv_BoolToInt(self, InBool: bool | Future[bool]) -> int:
        """Converts a bool to an int.

        Unreal: UKismetMathLibrary.Conv_BoolToInt (static)
        """
    def Conv_ByteToDouble(self, InByte: int | Future[int]) -> float:
        """Converts a byte to a float.

        Unreal: UKismetMathLibrary.Conv_ByteToDouble (static)
        """
    def Conv_ByteToInt(self, InByte: int | Future[int]) -> int:
        """Converts a byte to an integer.

        Unreal: UKismetMathLibrary.Conv_ByteToInt (static)
        """
    def Conv_ByteToInt64(self, InByte: int | Future[int]) -> int:
        """Converts a byte to a 64 bit integer.

        Unreal: UKismetMathLibrary.Conv_ByteToInt64 (static)
        """
    def Conv_ColorToLinearColor(self, InColor: FColor_in) -> FLinearColor:
        """Converts an sRGB-encoded colour to a linear one.

        Unreal: UKismetMathLibrary.Conv_ColorToLinearColor (static)
        """
    def Conv_DoubleToFloat(self, InDouble: float | Future[float]) -> float:
        """Converts a double-precision number to a single-precision one.

        Unreal: UKismetMathLibrary.Conv_DoubleToFloat (static)
        """
    def Conv_DoubleToInt64(self, InDouble: float | Future[float]) -> int:
        """Converts a float to a 64 bit integer.

        Unreal: UKismetMathLibrary.Conv_DoubleToInt64 (static)
        """
    def Conv_DoubleToLinearColor(self, InDouble: float | Future[float]) -> FLinearColor:
        """Converts a float to a linear colour: grey, opaque.

        Unreal: UKismetMathLibrary.Conv_DoubleToLinearColor (static)
        """
    def Conv_DoubleToVector(self, InDouble: float | Future[float]) -> FVector:
        """Converts a float to a vector, with the same value in every component.

        Unreal: UKismetMathLibrary.Conv_DoubleToVector (static)
        """
    def Conv_DoubleToVector2D(self, InDouble: float | Future[float]) -> FVector2D:
        """Converts a float to a 2D vector, with the same value in both components.

        Unreal: UKismetMathLibrary.Conv_DoubleToVector2D (static)
        """
    def Conv_FloatToDouble(self, InFloat: float | Future[float]) -> float:
        """Converts a single-precision number to a double-precision one.

        Unreal: UKismetMathLibrary.Conv_FloatToDouble (static)
        """
    def Conv_Int64ToDouble(self, InInt: int | Future[int]) -> float:
        """Converts a 64 bit integer to a float.

        Unreal: UKismetMathLibrary.Conv_Int64ToDouble (static)
        """
    def Conv_Int64ToInt(self, InInt: int | Future[int]) -> int:
        """Converts a 64 bit integer to a 32 bit integer (the low 32 bits).

        Unreal: UKismetMathLibrary.Conv_Int64ToInt (static)
        """
    def Conv_IntPointToVector2D(self, InIntPoint: FIntPoint_in) -> FVector2D:
        """Converts an integer point to a 2D vector.

        Unreal: UKismetMathLibrary.Conv_IntPointToVector2D (static)
        """
    def Conv_IntToBool(self, InInt: int | Future[int]) -> bool:
        """Converts an int to a bool.

        Unreal: UKismetMathLibrary.Conv_IntToBool (static)
        """
    def Conv_IntToByte(self, InInt: int | Future[int]) -> int:
        """Converts an integer to a byte (if the integer is too large, returns the low 8 bits).

        Unreal: UKismetMathLibrary.Conv_IntToByte (static)
        """
    def Conv_IntToDouble(self, InInt: int | Future[int]) -> float:
        """Converts an integer to a float.

        Unreal: UKismetMathLibrary.Conv_IntToDouble (static)
        """
    def Conv_IntToInt64(self, InInt: int | Future[int]) -> int:
        """Converts an integer to a 64 bit integer.

        Unreal: UKismetMathLibrary.Conv_IntToInt64 (static)
        """
    def Conv_IntToVector(self, InInt: int | Future[int]) -> FVector:
        """Converts an integer to a vector, with the same value in every component.

        Unreal: UKismetMathLibrary.Conv_IntToVector (static)
        """
    def Conv_IntVectorToVector(self, InIntVector: FIntVector_in) -> FVector:
        """Converts an integer vector to a vector.

        Unreal: UKismetMathLibrary.Conv_IntVectorToVector (static)
        """
    def Conv_LinearColorToColor(self, InLinearColor: FLinearColor_in, InUseSRGB: bool | Future[bool] = True) -> FColor:
        """Converts a linear colour to a byte colour, with or without the sRGB gamma.

        Unreal: UKismetMathLibrary.Conv_LinearColorToColor (static)
        """
    def Conv_LinearColorToVector(self, InLinearColor: FLinearColor_in) -> FVector:
        """Converts a linear colour to a vector (alpha is dropped).

        Unreal: UKismetMathLibrary.Conv_LinearColorToVector (static)
        """
    def Conv_RotatorToQuaternion(self, InRot: FRotator_in) -> FQuat:
        """Converts a rotator to a quaternion.

        Unreal: UKismetMathLibrary.Conv_RotatorToQuaternion (static)
        """
    def Conv_RotatorToTransform(self, InRotator: FRotator_in) -> FTransform:
        """Converts a rotator to a transform.

        Unreal: UKismetMathLibrary.Conv_RotatorToTransform (static)
        """
    def Conv_RotatorToVector(self, InRot: FRotator_in) -> FVector:
        """Gets the X direction vector after this rotation.

        Unreal: UKismetMathLibrary.Conv_RotatorToVector (static)
        """
    def Conv_Vector2DToVector(self, InVector2D: FVector2D_in, Z: float | Future[float] = 0.0) -> FVector:
        """Converts a 2D vector to a vector.

        Unreal: UKismetMathLibrary.Conv_Vector2DToVector (static)
        """
    def Conv_VectorToLinearColor(self, InVec: FVector_in) -> FLinearColor:
        """Converts a vector to a linear colour, opaque.

        Unreal: UKismetMathLibrary.Conv_VectorToLinearColor (static)
        """
    def Conv_VectorToQuaternion(self, InVec: FVector_in) -> FQuat:
        """Returns the rotation that points along a direction.

        Unreal: UKismetMathLibrary.Conv_VectorToQuaternion (static)
        """
    def Conv_VectorToRotator(self, InVec: FVector_in) -> FRotator:
        """Returns the rotation that points along a direction: yaw and pitch, no roll.

        Unreal: UKismetMathLibrary.Conv_VectorToRotator (static)
        """
    def Conv_VectorToTransform(self, InLocation: FVector_in) -> FTransform:
        """Converts a vector to a transform: a translation.

        Unreal: UKismetMathLibrary.Conv_VectorToTransform (static)
        """
    def Conv_VectorToVector2D(self, InVector: FVector_in) -> FVector2D:
        """Converts a vector to a 2D vector by dropping Z.

        Unreal: UKismetMathLibrary.Conv_VectorToVector2D (static)
        """
    def Cos(self, A: float | Future[float]) -> float:
        """Returns the cosine of A (expects Radians).

        Unreal: UKismetMathLibrary.Cos (static)
        """
    def CreateVectorFromYawPitch(self, Yaw: float | Future[float], Pitch: float | Future[float], Length: float | Future[float] = 1.0) -> FVector:
        """Creates a directional vector from rotation values {Yaw, Pitch} supplied in degrees with specified Length.

        Unreal: UKismetMathLibrary.CreateVectorFromYawPitch (static)
        """
    def CrossProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> float:
        """Returns the cross product of two 2D vectors.

        Unreal: UKismetMathLibrary.CrossProduct2D (static)
        """
    def Cross_VectorVector(self, A: FVector_in, B: FVector_in) -> FVector:
        """Returns the cross product of two 3D vectors.

        Unreal: UKismetMathLibrary.Cross_VectorVector (static)
        """
    def DaysInMonth(self, Year: int | Future[int], Month: int | Future[int]) -> int:
        """Returns the number of days in the given year and month; 0 with a warning for a month out of range.

        Unreal: UKismetMathLibrary.DaysInMonth (static)
        """
    def DaysInYear(self, Year: int | Future[int]) -> int:
        """Returns the number of days in the given year.

        Unreal: UKismetMathLibrary.DaysInYear (static)
        """
    def DegAcos(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arccos) of A (result is in Degrees).

        Unreal: UKismetMathLibrary.DegAcos (static)
        """
    def DegAsin(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arcsin) of A (result is in Degrees).

        Unreal: UKismetMathLibrary.DegAsin (static)
        """
    def DegAtan(self, A: float | Future[float]) -> float:
        """Returns the inverse function (arctan) of A (result is in Degrees).

        Unreal: UKismetMathLibrary.DegAtan (static)
        """
    def DegAtan2(self, Y: float | Future[float], X: float | Future[float]) -> float:
        """Returns the inverse tan (atan2) of Y/X (result is in Degrees).

        Unreal: UKismetMathLibrary.DegAtan2 (static)
        """
    def DegCos(self, A: float | Future[float]) -> float:
        """Returns the cos of A (expects Degrees).

        Unreal: UKismetMathLibrary.DegCos (static)
        """
    def DegSin(self, A: float | Future[float]) -> float:
        """Returns the sin of A (expects Degrees).

        Unreal: UKismetMathLibrary.DegSin (static)
        """
    def DegTan(self, A: float | Future[float]) -> float:
        """Returns the tan of A (expects Degrees).

        Unreal: UKismetMathLibrary.DegTan (static)
        """
    def DegreesToRadians(self, A: float | Future[float]) -> float:
        """Returns radians value based on the input degrees.

        Unreal: UKismetMathLibrary.DegreesToRadians (static)
        """
    def Distance2D(self, V1: FVector2D_in, V2: FVector2D_in) -> float:
        """Distance between two 2D points.

        Unreal: UKismetMathLibrary.Distance2D (static)
        """
    def Divide_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Division (A / B). Division by zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_ByteByte (static)
        """
    def Divide_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> float:
        """Division (A / B). Division by zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_DoubleDouble (static)
        """
    def Divide_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Division (A / B), towards zero. Division by zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_Int64Int64 (static)
        """
    def Divide_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Division (A / B), towards zero. Division by zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_IntInt (static)
        """
    def Divide_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float] = 1.0) -> FVector2D:
        """Division by a float. Division by zero gives a zero vector and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_Vector2DFloat (static)
        """
    def Divide_VectorFloat(self, A: FVector_in, B: float | Future[float] = 1.0) -> FVector:
        """Vector divide by a float. Division by zero gives a zero vector and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_VectorFloat (static)
        """
    def Divide_VectorInt(self, A: FVector_in, B: int | Future[int] = 1) -> FVector:
        """Vector divide by an integer. Division by zero gives a zero vector and a warning in the log.

        Unreal: UKismetMathLibrary.Divide_VectorInt (static)
        """
    def Divide_VectorVector(self, A: FVector_in, B: FVector_in = ...) -> FVector:
        """Element-wise vector division (Result = {A.x/B.x, A.y/B.y, A.z/B.z}). A component of B that is zero gives a
        zero vector and a warning in the log.

        Args:
            B: Default FVector(X=1.0, Y=1.0, Z=1.0).

        Unreal: UKismetMathLibrary.Divide_VectorVector (static)
        """
    def DotProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> float:
        """Returns the dot product of two 2D vectors.

        Unreal: UKismetMathLibrary.DotProduct2D (static)
        """
    def Dot_VectorVector(self, A: FVector_in, B: FVector_in) -> float:
        """Returns the dot product of two 3D vectors.

        Unreal: UKismetMathLibrary.Dot_VectorVector (static)
        """
    def Ease(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> float:
        """Eases between A and B using a specified easing function.

        Unreal: UKismetMathLibrary.Ease (static)
        """
    def EqualEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns true if the values are equal (A == B).

        Unreal: UKismetMathLibrary.EqualEqual_BoolBool (static)
        """
    def EqualEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A == B.

        Unreal: UKismetMathLibrary.EqualEqual_ByteByte (static)
        """
    def EqualEqual_ClassClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass]) -> bool:
        """Returns true if A and B are the same class.

        Unreal: UKismetMathLibrary.EqualEqual_ClassClass (static)
        """
    def EqualEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A == B.

        Unreal: UKismetMathLibrary.EqualEqual_DateTimeDateTime (static)
        """
    def EqualEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A == B exactly.

        Unreal: UKismetMathLibrary.EqualEqual_DoubleDouble (static)
        """
    def EqualEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A == B.

        Unreal: UKismetMathLibrary.EqualEqual_Int64Int64 (static)
        """
    def EqualEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A == B.

        Unreal: UKismetMathLibrary.EqualEqual_IntInt (static)
        """
    def EqualEqual_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> bool:
        """Returns true if linear colour A is equal to linear colour B exactly.

        Unreal: UKismetMathLibrary.EqualEqual_LinearColorLinearColor (static)
        """
    def EqualEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Returns true if A and B are equal (A == B); names compare without case.

        Unreal: UKismetMathLibrary.EqualEqual_NameName (static)
        """
    def EqualEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> bool:
        """Returns true if A and B are the same object.

        Unreal: UKismetMathLibrary.EqualEqual_ObjectObject (static)
        """
    def EqualEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if quaternion A is equal to quaternion B (A == B) within a specified error tolerance; Q and -Q
        are the same rotation.

        Unreal: UKismetMathLibrary.EqualEqual_QuatQuat (static)
        """
    def EqualEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if rotator A is equal to rotator B (A == B) within a specified error tolerance; whole turns do
        not count.

        Unreal: UKismetMathLibrary.EqualEqual_RotatorRotator (static)
        """
    def EqualEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A == B.

        Unreal: UKismetMathLibrary.EqualEqual_TimespanTimespan (static)
        """
    def EqualEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in) -> bool:
        """Returns true if transform A is equal to transform B, within a small tolerance.

        Unreal: UKismetMathLibrary.EqualEqual_TransformTransform (static)
        """
    def EqualEqual_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if A equals B within a specified error tolerance.

        Unreal: UKismetMathLibrary.EqualEqual_Vector2DVector2D (static)
        """
    def EqualEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if vector A is equal to vector B (A == B) within a specified error tolerance.

        Unreal: UKismetMathLibrary.EqualEqual_VectorVector (static)
        """
    def EqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> bool:
        """Returns true if vector A is equal to vector B (A == B) exactly.

        Unreal: UKismetMathLibrary.EqualExactly_VectorVector (static)
        """
    def Exp(self, A: float | Future[float]) -> float:
        """Returns exponential (e) to the power A (e^A).

        Unreal: UKismetMathLibrary.Exp (static)
        """
    def FCeil(self, A: float | Future[float]) -> int:
        """Rounds A up towards positive infinity.

        Unreal: UKismetMathLibrary.FCeil (static)
        """
    def FCeil64(self, A: float | Future[float]) -> int:
        """Rounds A up towards positive infinity.

        Unreal: UKismetMathLibrary.FCeil64 (static)
        """
    def FClamp(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> float:
        """Returns Value clamped between Min and Max (inclusive).

        Unreal: UKismetMathLibrary.FClamp (static)
        """
    def FFloor(self, A: float | Future[float]) -> int:
        """Rounds A down towards negative infinity.

        Unreal: UKismetMathLibrary.FFloor (static)
        """
    def FFloor64(self, A: float | Future[float]) -> int:
        """Rounds A down towards negative infinity.

        Unreal: UKismetMathLibrary.FFloor64 (static)
        """
    def FInterpEaseInOut(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], Exponent: float | Future[float]) -> float:
        """Interpolates between A and B, applying an ease in/out function. Exponent controls the degree of the curve.

        Unreal: UKismetMathLibrary.FInterpEaseInOut (static)
        """
    def FInterpTo(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> float:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a
        position. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.FInterpTo (static)
        """
    def FInterpTo_Constant(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> float:
        """Tries to reach Target at a constant rate.

        Unreal: UKismetMathLibrary.FInterpTo_Constant (static)
        """
    def FMax(self, A: float | Future[float], B: float | Future[float]) -> float:
        """Returns the maximum value of A and B.

        Unreal: UKismetMathLibrary.FMax (static)
        """
    def FMin(self, A: float | Future[float], B: float | Future[float]) -> float:
        """Returns the minimum value of A and B.

        Unreal: UKismetMathLibrary.FMin (static)
        """
    def FMod(self, Dividend: float | Future[float], Divisor: float | Future[float]) -> UKismetMathLibrary_FMod_Result:
        """Returns the number of times Divisor will go into Dividend and the remainder. A zero divisor gives 0 and 0.

        Unreal: UKismetMathLibrary.FMod (static)
        """
    def FTrunc(self, A: float | Future[float]) -> int:
        """Rounds A towards zero, truncating the fractional part.

        Unreal: UKismetMathLibrary.FTrunc (static)
        """
    def FTrunc64(self, A: float | Future[float]) -> int:
        """Rounds A towards zero, truncating the fractional part.

        Unreal: UKismetMathLibrary.FTrunc64 (static)
        """
    def FWrap(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> float:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min.

        Unreal: UKismetMathLibrary.FWrap (static)
        """
    def FindClosestPointOnLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> FVector:
        """Finds the closest point on an infinite line to a given point.

        Unreal: UKismetMathLibrary.FindClosestPointOnLine (static)
        """
    def FindClosestPointOnSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> FVector:
        """Finds the closest point on a line segment to a given point.

        Unreal: UKismetMathLibrary.FindClosestPointOnSegment (static)
        """
    def FindLookAtRotation(self, Start: FVector_in, Target: FVector_in) -> FRotator:
        """Finds a rotation for an object at Start location to point at Target location.

        Unreal: UKismetMathLibrary.FindLookAtRotation (static)
        """
    def FixedTurn(self, InCurrent: float | Future[float], InDesired: float | Future[float], InDeltaRate: float | Future[float]) -> float:
        """Returns a new rotation component value: InCurrent moved towards InDesired the shorter way by no more than
        InDeltaRate, in degrees.

        Unreal: UKismetMathLibrary.FixedTurn (static)
        """
    def Fraction(self, A: float | Future[float]) -> float:
        """Returns the fractional part of a float: A - floor(A).

        Unreal: UKismetMathLibrary.Fraction (static)
        """
    def FromDays(self, Days: float | Future[float]) -> FTimespan:
        """Returns a time span that represents the specified number of days.

        Unreal: UKismetMathLibrary.FromDays (static)
        """
    def FromHours(self, Hours: float | Future[float]) -> FTimespan:
        """Returns a time span that represents the specified number of hours.

        Unreal: UKismetMathLibrary.FromHours (static)
        """
    def FromMilliseconds(self, Milliseconds: float | Future[float]) -> FTimespan:
        """Returns a time span that represents the specified number of milliseconds.

        Unreal: UKismetMathLibrary.FromMilliseconds (static)
        """
    def FromMinutes(self, Minutes: float | Future[float]) -> FTimespan:
        """Returns a time span that represents the specified number of minutes.

        Unreal: UKismetMathLibrary.FromMinutes (static)
        """
    def FromSeconds(self, Seconds: float | Future[float]) -> FTimespan:
        """Returns a time span that represents the specified number of seconds.

        Unreal: UKismetMathLibrary.FromSeconds (static)
        """
    def FromUnixTimestamp(self, UnixTime: int | Future[int]) -> FDateTime:
        """Returns a date and time from a unix timestamp (seconds since 1970-01-01 00:00 UTC).

        Unreal: UKismetMathLibrary.FromUnixTimestamp (static)
        """
    def GetAzimuthAndElevation(self, InDirection: FVector_in, ReferenceFrame: FTransform_in) -> UKismetMathLibrary_GetAzimuthAndElevation_Result:
        """Breaks a direction vector apart into azimuth (yaw) and elevation (pitch) rotation values given in degrees, in
        the frame of the transform.

        Unreal: UKismetMathLibrary.GetAzimuthAndElevation (static)
        """
    def GetDate(self, A: FDateTime_in) -> FDateTime:
        """Returns the date component of A.

        Unreal: UKismetMathLibrary.GetDate (static)
        """
    def GetDay(self, A: FDateTime_in) -> int:
        """Returns the day component, 1 to 31 of A.

        Unreal: UKismetMathLibrary.GetDay (static)
        """
    def GetDayOfYear(self, A: FDateTime_in) -> int:
        """Returns the day of the year, 1 to 366 of A.

        Unreal: UKismetMathLibrary.GetDayOfYear (static)
        """
    def GetDays(self, A: FTimespan_in) -> int:
        """Returns the days component of A.

        Unreal: UKismetMathLibrary.GetDays (static)
        """
    def GetDirectionUnitVector(self, From: FVector_in, To: FVector_in) -> FVector:
        """Finds the unit direction vector from one position to another; a zero vector when they coincide.

        Unreal: UKismetMathLibrary.GetDirectionUnitVector (static)
        """
    def GetDuration(self, A: FTimespan_in) -> FTimespan:
        """Returns the absolute value of A.

        Unreal: UKismetMathLibrary.GetDuration (static)
        """
    def GetForwardVector(self, InRot: FRotator_in) -> FVector:
        """Rotates the world forward vector by the given rotation.

        Unreal: UKismetMathLibrary.GetForwardVector (static)
        """
    def GetHour(self, A: FDateTime_in) -> int:
        """Returns the hour of the day, 0 to 23 of A.

        Unreal: UKismetMathLibrary.GetHour (static)
        """
    def GetHour12(self, A: FDateTime_in) -> int:
        """Returns the hour of the day in 12-hour format, 1 to 12 of A.

        Unreal: UKismetMathLibrary.GetHour12 (static)
        """
    def GetHours(self, A: FTimespan_in) -> int:
        """Returns the hours component of A.

        Unreal: UKismetMathLibrary.GetHours (static)
        """
    def GetMaxElement(self, A: FVector_in) -> float:
        """Finds the maximum element (X, Y or Z) of a vector.

        Unreal: UKismetMathLibrary.GetMaxElement (static)
        """
    def GetMillisecond(self, A: FDateTime_in) -> int:
        """Returns the millisecond component, 0 to 999 of A.

        Unreal: UKismetMathLibrary.GetMillisecond (static)
        """
    def GetMilliseconds(self, A: FTimespan_in) -> int:
        """Returns the milliseconds component of A.

        Unreal: UKismetMathLibrary.GetMilliseconds (static)
        """
    def GetMinElement(self, A: FVector_in) -> float:
        """Finds the minimum element (X, Y or Z) of a vector.

        Unreal: UKismetMathLibrary.GetMinElement (static)
        """
    def GetMinute(self, A: FDateTime_in) -> int:
        """Returns the minute component, 0 to 59 of A.

        Unreal: UKismetMathLibrary.GetMinute (static)
        """
    def GetMinutes(self, A: FTimespan_in) -> int:
        """Returns the minutes component of A.

        Unreal: UKismetMathLibrary.GetMinutes (static)
        """
    def GetMonth(self, A: FDateTime_in) -> int:
        """Returns the month component, 1 to 12 of A.

        Unreal: UKismetMathLibrary.GetMonth (static)
        """
    def GetPI(self) -> float:
        """Returns the value of pi.

        Unreal: UKismetMathLibrary.GetPI (static)
        """
    def GetPointDistanceToLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> float:
        """Finds the distance from a point to the infinite line.

        Unreal: UKismetMathLibrary.GetPointDistanceToLine (static)
        """
    def GetPointDistanceToSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> float:
        """Finds the distance of Point to the closest point on the line segment.

        Unreal: UKismetMathLibrary.GetPointDistanceToSegment (static)
        """
    def GetReflectionVector(self, Direction: FVector_in, SurfaceNormal: FVector_in) -> FVector:
        """Given a direction vector and a surface normal, returns the vector reflected across the surface normal.

        Unreal: UKismetMathLibrary.GetReflectionVector (static)
        """
    def GetRightVector(self, InRot: FRotator_in) -> FVector:
        """Rotates the world right vector by the given rotation.

        Unreal: UKismetMathLibrary.GetRightVector (static)
        """
    def GetSecond(self, A: FDateTime_in) -> int:
        """Returns the second component, 0 to 59 of A.

        Unreal: UKismetMathLibrary.GetSecond (static)
        """
    def GetSeconds(self, A: FTimespan_in) -> int:
        """Returns the seconds component of A.

        Unreal: UKismetMathLibrary.GetSeconds (static)
        """
    def GetTAU(self) -> float:
        """Returns the value of tau (= 2 * pi).

        Unreal: UKismetMathLibrary.GetTAU (static)
        """
    def GetTimeOfDay(self, A: FDateTime_in) -> FTimespan:
        """Returns the time elapsed since midnight of A.

        Unreal: UKismetMathLibrary.GetTimeOfDay (static)
        """
    def GetTotalDays(self, A: FTimespan_in) -> float:
        """Returns the total number of days of A.

        Unreal: UKismetMathLibrary.GetTotalDays (static)
        """
    def GetTotalHours(self, A: FTimespan_in) -> float:
        """Returns the total number of hours of A.

        Unreal: UKismetMathLibrary.GetTotalHours (static)
        """
    def GetTotalMilliseconds(self, A: FTimespan_in) -> float:
        """Returns the total number of milliseconds of A.

        Unreal: UKismetMathLibrary.GetTotalMilliseconds (static)
        """
    def GetTotalMinutes(self, A: FTimespan_in) -> float:
        """Returns the total number of minutes of A.

        Unreal: UKismetMathLibrary.GetTotalMinutes (static)
        """
    def GetTotalSeconds(self, A: FTimespan_in) -> float:
        """Returns the total number of seconds of A.

        Unreal: UKismetMathLibrary.GetTotalSeconds (static)
        """
    def GetUpVector(self, InRot: FRotator_in) -> FVector:
        """Rotates the world up vector by the given rotation.

        Unreal: UKismetMathLibrary.GetUpVector (static)
        """
    def GetVectorArrayAverage(self, Vectors: Sequence[FVector_in] | Future[list[FVector]]) -> FVector:
        """Finds the average of an array of vectors; zero for an empty one.

        Unreal: UKismetMathLibrary.GetVectorArrayAverage (static)
        """
    def GetYawPitchFromVector(self, InVec: FVector_in) -> UKismetMathLibrary_GetYawPitchFromVector_Result:
        """Breaks a direction vector apart into Yaw and Pitch rotation values given in degrees.

        Unreal: UKismetMathLibrary.GetYawPitchFromVector (static)
        """
    def GetYear(self, A: FDateTime_in) -> int:
        """Returns the year component of A.

        Unreal: UKismetMathLibrary.GetYear (static)
        """
    def GreaterEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_ByteByte (static)
        """
    def GreaterEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_DateTimeDateTime (static)
        """
    def GreaterEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_DoubleDouble (static)
        """
    def GreaterEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_Int64Int64 (static)
        """
    def GreaterEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_IntInt (static)
        """
    def GreaterEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A >= B.

        Unreal: UKismetMathLibrary.GreaterEqual_TimespanTimespan (static)
        """
    def GreaterGreater_VectorRotator(self, A: FVector_in, B: FRotator_in) -> FVector:
        """Returns the result of rotating a vector by a rotator.

        Unreal: UKismetMathLibrary.GreaterGreater_VectorRotator (static)
        """
    def Greater_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_ByteByte (static)
        """
    def Greater_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_DateTimeDateTime (static)
        """
    def Greater_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_DoubleDouble (static)
        """
    def Greater_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_Int64Int64 (static)
        """
    def Greater_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_IntInt (static)
        """
    def Greater_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A > B.

        Unreal: UKismetMathLibrary.Greater_TimespanTimespan (static)
        """
    def HSVToRGB(self, H: float | Future[float], S: float | Future[float], V: float | Future[float], A: float | Future[float] = 1.0) -> FLinearColor:
        """Makes a colour from individual colour components (HSV space; hue is [0..360], saturation and value are
        [0..1]).

        Unreal: UKismetMathLibrary.HSVToRGB (static)
        """
    def Hypotenuse(self, Width: float | Future[float], Height: float | Future[float]) -> float:
        """Returns the hypotenuse of a right-angled triangle given the width and height.

        Unreal: UKismetMathLibrary.Hypotenuse (static)
        """
    def InRange_FloatFloat(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> bool:
        """Returns true if value is between Min and Max.

        Unreal: UKismetMathLibrary.InRange_FloatFloat (static)
        """
    def InRange_Int64Int64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> bool:
        """Returns true if value is between Min and Max.

        Unreal: UKismetMathLibrary.InRange_Int64Int64 (static)
        """
    def InRange_IntInt(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> bool:
        """Returns true if value is between Min and Max.

        Unreal: UKismetMathLibrary.InRange_IntInt (static)
        """
    def InverseTransformDirection(self, T: FTransform_in, Direction: FVector_in) -> FVector:
        """Transforms a direction vector by the inverse of the given transform: does not change its length.

        Unreal: UKismetMathLibrary.InverseTransformDirection (static)
        """
    def InverseTransformLocation(self, T: FTransform_in, Location: FVector_in) -> FVector:
        """Transforms a position by the inverse of the given transform: from world to local space.

        Unreal: UKismetMathLibrary.InverseTransformLocation (static)
        """
    def InverseTransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> FRotator:
        """Transforms a rotator by the inverse of the given transform.

        Unreal: UKismetMathLibrary.InverseTransformRotation (static)
        """
    def InvertTransform(self, T: FTransform_in) -> FTransform:
        """Returns the inverse of the given transform.

        Unreal: UKismetMathLibrary.InvertTransform (static)
        """
    def IsLeapYear(self, Year: int | Future[int]) -> bool:
        """Returns whether given year is a leap year.

        Unreal: UKismetMathLibrary.IsLeapYear (static)
        """
    def IsPointInBox(self, Point: FVector_in, BoxOrigin: FVector_in, BoxExtent: FVector_in) -> bool:
        """Determines whether the given point is in an axis-aligned box. Includes points on the box.

        Unreal: UKismetMathLibrary.IsPointInBox (static)
        """
    def IsPointInBox_Box(self, Point: FVector_in, Box: FBox_in) -> bool:
        """Determines whether the given point is in a box. Includes points on the box.

        Unreal: UKismetMathLibrary.IsPointInBox_Box (static)
        """
    def Lerp(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float]) -> float:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1).

        Unreal: UKismetMathLibrary.Lerp (static)
        """
    def LessEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_ByteByte (static)
        """
    def LessEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_DateTimeDateTime (static)
        """
    def LessEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_DoubleDouble (static)
        """
    def LessEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_Int64Int64 (static)
        """
    def LessEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_IntInt (static)
        """
    def LessEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A <= B.

        Unreal: UKismetMathLibrary.LessEqual_TimespanTimespan (static)
        """
    def LessLess_VectorRotator(self, A: FVector_in, B: FRotator_in) -> FVector:
        """Returns result of vector A rotated by the inverse of rotator B.

        Unreal: UKismetMathLibrary.LessLess_VectorRotator (static)
        """
    def Less_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_ByteByte (static)
        """
    def Less_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_DateTimeDateTime (static)
        """
    def Less_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_DoubleDouble (static)
        """
    def Less_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_Int64Int64 (static)
        """
    def Less_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_IntInt (static)
        """
    def Less_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A < B.

        Unreal: UKismetMathLibrary.Less_TimespanTimespan (static)
        """
    def LinearColorLerp(self, A: FLinearColor_in, B: FLinearColor_in, Alpha: float | Future[float]) -> FLinearColor:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1).

        Unreal: UKismetMathLibrary.LinearColorLerp (static)
        """
    def LinearColor_Black(self) -> FLinearColor:
        """Black linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Black (static)
        """
    def LinearColor_Blue(self) -> FLinearColor:
        """Blue linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Blue (static)
        """
    def LinearColor_Desaturated(self, InColor: FLinearColor_in, InDesaturation: float | Future[float]) -> FLinearColor:
        """Returns a desaturated colour, with 0 meaning no desaturation and 1 == full desaturation.

        Unreal: UKismetMathLibrary.LinearColor_Desaturated (static)
        """
    def LinearColor_Distance(self, C1: FLinearColor_in, C2: FLinearColor_in) -> float:
        """Euclidean distance between two colour points.

        Unreal: UKismetMathLibrary.LinearColor_Distance (static)
        """
    def LinearColor_GetLuminance(self, InColor: FLinearColor_in) -> float:
        """Computes the luminance of a linear colour.

        Unreal: UKismetMathLibrary.LinearColor_GetLuminance (static)
        """
    def LinearColor_Gray(self) -> FLinearColor:
        """Gray linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Gray (static)
        """
    def LinearColor_Green(self) -> FLinearColor:
        """Green linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Green (static)
        """
    def LinearColor_Quantize(self, InColor: FLinearColor_in) -> FColor:
        """Quantizes the linear colour and returns the result as an 8-bit colour. This bypasses the sRGB conversion.

        Unreal: UKismetMathLibrary.LinearColor_Quantize (static)
        """
    def LinearColor_Red(self) -> FLinearColor:
        """Red linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Red (static)
        """
    def LinearColor_Transparent(self) -> FLinearColor:
        """Transparent linear colour: black with alpha 0.

        Unreal: UKismetMathLibrary.LinearColor_Transparent (static)
        """
    def LinearColor_White(self) -> FLinearColor:
        """White linear colour.

        Unreal: UKismetMathLibrary.LinearColor_White (static)
        """
    def LinearColor_Yellow(self) -> FLinearColor:
        """Yellow linear colour.

        Unreal: UKismetMathLibrary.LinearColor_Yellow (static)
        """
    def Log(self, A: float | Future[float], Base: float | Future[float] = 1.0) -> float:
        """Returns log of A base B (if B^R == A, returns R). A base of 1 or less gives 0.

        Unreal: UKismetMathLibrary.Log (static)
        """
    def Loge(self, A: float | Future[float]) -> float:
        """Returns natural log of A (if e^R == A, returns R).

        Unreal: UKismetMathLibrary.Loge (static)
        """
    def MakeBox(self, Min: FVector_in, Max: FVector_in) -> FBox:
        """Makes an FBox from Min and Max and sets IsValid to true.

        Unreal: UKismetMathLibrary.MakeBox (static)
        """
    def MakeBoxWithOrigin(self, Origin: FVector_in, Extent: FVector_in) -> FBox:
        """Makes an FBox from Origin and Extent and sets IsValid to true.

        Unreal: UKismetMathLibrary.MakeBoxWithOrigin (static)
        """
    def MakeColor(self, R: float | Future[float], G: float | Future[float], B: float | Future[float], A: float | Future[float] = 1.0) -> FLinearColor:
        """Makes a colour from individual colour components (RGB space, linear).

        Unreal: UKismetMathLibrary.MakeColor (static)
        """
    def MakeDateTime(self, Year: int | Future[int], Month: int | Future[int], Day: int | Future[int], Hour: int | Future[int] = 0, Minute: int | Future[int] = 0, Second: int | Future[int] = 0, Millisecond: int | Future[int] = 0) -> FDateTime:
        """Makes a date and time; the zero one, with a warning in the log, where the parts are out of range.

        Unreal: UKismetMathLibrary.MakeDateTime (static)
        """
    def MakePulsatingValue(self, InCurrentTime: float | Future[float], InPulsesPerSecond: float | Future[float] = 1.0, InPhase: float | Future[float] = 0.0) -> float:
        """Makes a value that pulsates between 0 and 1 with the current time (seconds); a phase of 0 starts at 0.5 and
        rises.

        Unreal: UKismetMathLibrary.MakePulsatingValue (static)
        """
    def MakeRandomStream(self, InitialSeed: int | Future[int]) -> FRandomStream:
        """Makes a SRand-based random number generator.

        Unreal: UKismetMathLibrary.MakeRandomStream (static)
        """
    def MakeRelativeTransform(self, A: FTransform_in, RelativeTo: FTransform_in) -> FTransform:
        """Returns the given transform, converted to be relative to the given parent transform.

        Unreal: UKismetMathLibrary.MakeRelativeTransform (static)
        """
    def MakeRotFromX(self, X: FVector_in) -> FRotator:
        """Builds a rotator given only a XAxis. The remaining axes are unspecified but will be orthonormal.

        Unreal: UKismetMathLibrary.MakeRotFromX (static)
        """
    def MakeRotFromXY(self, X: FVector_in, Y: FVector_in) -> FRotator:
        """Builds a rotator with the given X axis and Y axis. X remains fixed; Y may be changed minimally to enforce
        orthogonality.

        Unreal: UKismetMathLibrary.MakeRotFromXY (static)
        """
    def MakeRotFromXZ(self, X: FVector_in, Z: FVector_in) -> FRotator:
        """Builds a rotator with the given X axis and Z axis. X remains fixed; Z may be changed minimally to enforce
        orthogonality.

        Unreal: UKismetMathLibrary.MakeRotFromXZ (static)
        """
    def MakeRotFromY(self, Y: FVector_in) -> FRotator:
        """Builds a rotator given only a YAxis. The remaining axes are unspecified but will be orthonormal.

        Unreal: UKismetMathLibrary.MakeRotFromY (static)
        """
    def MakeRotFromZ(self, Z: FVector_in) -> FRotator:
        """Builds a rotator given only a ZAxis. The remaining axes are unspecified but will be orthonormal.

        Unreal: UKismetMathLibrary.MakeRotFromZ (static)
        """
    def MakeRotationFromAxes(self, Forward: FVector_in, Right: FVector_in, Up: FVector_in) -> FRotator:
        """Builds a reference frame from three axes.

        Unreal: UKismetMathLibrary.MakeRotationFromAxes (static)
        """
    def MakeRotator(self, Roll: float | Future[float], Pitch: float | Future[float], Yaw: float | Future[float]) -> FRotator:
        """Makes a rotator {Roll, Pitch, Yaw} from rotation values supplied in degrees.

        Unreal: UKismetMathLibrary.MakeRotator (static)
        """
    def MakeTimespan(self, Days: int | Future[int], Hours: int | Future[int], Minutes: int | Future[int], Seconds: int | Future[int], Milliseconds: int | Future[int]) -> FTimespan:
        """Makes a time span.

        Unreal: UKismetMathLibrary.MakeTimespan (static)
        """
    def MakeTransform(self, Location: FVector_in, Rotation: FRotator_in, Scale: FVector_in = ...) -> FTransform:
        """Makes a transform from location, rotation and scale.

        Args:
            Scale: Default FVector(X=1.0, Y=1.0, Z=1.0).

        Unreal: UKismetMathLibrary.MakeTransform (static)
        """
    def MakeVector(self, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> FVector:
        """Makes a vector {X, Y, Z}.

        Unreal: UKismetMathLibrary.MakeVector (static)
        """
    def MakeVector2D(self, X: float | Future[float], Y: float | Future[float]) -> FVector2D:
        """Makes a 2D vector {X, Y}.

        Unreal: UKismetMathLibrary.MakeVector2D (static)
        """
    def MapRangeClamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> float:
        """Returns Value mapped from one range into another where the Value is clamped to the input range.

        Unreal: UKismetMathLibrary.MapRangeClamped (static)
        """
    def MapRangeUnclamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> float:
        """Returns Value mapped from one range into another.

        Unreal: UKismetMathLibrary.MapRangeUnclamped (static)
        """
    def Max(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the maximum value of A and B.

        Unreal: UKismetMathLibrary.Max (static)
        """
    def MaxInt64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the maximum value of A and B.

        Unreal: UKismetMathLibrary.MaxInt64 (static)
        """
    def MaxOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> UKismetMathLibrary_MaxOfFloatArray_Result:
        """Returns max of all array entries and the index at which it was found. Returns value of 0 and index of -1 if
        the supplied array is empty.

        Unreal: UKismetMathLibrary.MaxOfFloatArray (static)
        """
    def MaxOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> UKismetMathLibrary_MaxOfIntArray_Result:
        """Returns max of all array entries and the index at which it was found. Returns value of 0 and index of -1 if
        the supplied array is empty.

        Unreal: UKismetMathLibrary.MaxOfIntArray (static)
        """
    def Min(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the minimum value of A and B.

        Unreal: UKismetMathLibrary.Min (static)
        """
    def MinInt64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Returns the minimum value of A and B.

        Unreal: UKismetMathLibrary.MinInt64 (static)
        """
    def MinOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> UKismetMathLibrary_MinOfFloatArray_Result:
        """Returns min of all array entries and the index at which it was found. Returns value of 0 and index of -1 if
        the supplied array is empty.

        Unreal: UKismetMathLibrary.MinOfFloatArray (static)
        """
    def MinOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> UKismetMathLibrary_MinOfIntArray_Result:
        """Returns min of all array entries and the index at which it was found. Returns value of 0 and index of -1 if
        the supplied array is empty.

        Unreal: UKismetMathLibrary.MinOfIntArray (static)
        """
    def MirrorVectorByNormal(self, InVect: FVector_in, InNormal: FVector_in) -> FVector:
        """Mirrors a vector by a normal (a unit vector).

        Unreal: UKismetMathLibrary.MirrorVectorByNormal (static)
        """
    def MultiplyByPi(self, Value: float | Future[float]) -> float:
        """Multiplies the input value by pi.

        Unreal: UKismetMathLibrary.MultiplyByPi (static)
        """
    def MultiplyMultiply_FloatFloat(self, Base: float | Future[float], Exp: float | Future[float]) -> float:
        """Power (Base to the Exp-th power).

        Unreal: UKismetMathLibrary.MultiplyMultiply_FloatFloat (static)
        """
    def Multiply_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Multiplication (A * B), modulo 256.

        Unreal: UKismetMathLibrary.Multiply_ByteByte (static)
        """
    def Multiply_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> float:
        """Multiplication (A * B).

        Unreal: UKismetMathLibrary.Multiply_DoubleDouble (static)
        """
    def Multiply_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Multiplication (A * B); wraps on overflow.

        Unreal: UKismetMathLibrary.Multiply_Int64Int64 (static)
        """
    def Multiply_IntFloat(self, A: int | Future[int], B: float | Future[float]) -> float:
        """Multiplication (A * B).

        Unreal: UKismetMathLibrary.Multiply_IntFloat (static)
        """
    def Multiply_IntInt(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Multiplication (A * B); wraps on overflow.

        Unreal: UKismetMathLibrary.Multiply_IntInt (static)
        """
    def Multiply_LinearColorFloat(self, A: FLinearColor_in, B: float | Future[float]) -> FLinearColor:
        """Element-wise multiplication of a linear colour by a float.

        Unreal: UKismetMathLibrary.Multiply_LinearColorFloat (static)
        """
    def Multiply_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> FLinearColor:
        """Element-wise multiplication of two linear colours.

        Unreal: UKismetMathLibrary.Multiply_LinearColorLinearColor (static)
        """
    def Multiply_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> FQuat:
        """Gets the result of multiplying two quaternions (A * B). The order matters: (A * B) first applies B, then A.

        Unreal: UKismetMathLibrary.Multiply_QuatQuat (static)
        """
    def Multiply_RotatorFloat(self, A: FRotator_in, B: float | Future[float]) -> FRotator:
        """Returns rotator representing rotator A scaled by B.

        Unreal: UKismetMathLibrary.Multiply_RotatorFloat (static)
        """
    def Multiply_RotatorInt(self, A: FRotator_in, B: int | Future[int]) -> FRotator:
        """Returns rotator representing rotator A scaled by B.

        Unreal: UKismetMathLibrary.Multiply_RotatorInt (static)
        """
    def Multiply_TimespanFloat(self, A: FTimespan_in, Scalar: float | Future[float]) -> FTimespan:
        """Scalar multiplication (A * s).

        Unreal: UKismetMathLibrary.Multiply_TimespanFloat (static)
        """
    def Multiply_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float]) -> FVector2D:
        """Scales A by B.

        Unreal: UKismetMathLibrary.Multiply_Vector2DFloat (static)
        """
    def Multiply_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> FVector2D:
        """Element-wise multiplication.

        Unreal: UKismetMathLibrary.Multiply_Vector2DVector2D (static)
        """
    def Multiply_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> FVector:
        """Scales vector A by B.

        Unreal: UKismetMathLibrary.Multiply_VectorFloat (static)
        """
    def Multiply_VectorInt(self, A: FVector_in, B: int | Future[int]) -> FVector:
        """Scales vector A by B.

        Unreal: UKismetMathLibrary.Multiply_VectorInt (static)
        """
    def Multiply_VectorVector(self, A: FVector_in, B: FVector_in) -> FVector:
        """Element-wise vector multiplication (Result = {A.x*B.x, A.y*B.y, A.z*B.z}).

        Unreal: UKismetMathLibrary.Multiply_VectorVector (static)
        """
    def NearlyEqual_FloatFloat(self, A: float | Future[float], B: float | Future[float], ErrorTolerance: float | Future[float] = 1e-06) -> bool:
        """Returns true if A and B differ by no more than the tolerance.

        Unreal: UKismetMathLibrary.NearlyEqual_FloatFloat (static)
        """
    def NearlyEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in, LocationTolerance: float | Future[float] = 0.0001, RotationTolerance: float | Future[float] = 0.0001, Scale3DTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if transform A is nearly equal to B.

        Unreal: UKismetMathLibrary.NearlyEqual_TransformTransform (static)
        """
    def NegateRotator(self, A: FRotator_in) -> FRotator:
        """Negates a rotator: the inverse rotation.

        Unreal: UKismetMathLibrary.NegateRotator (static)
        """
    def NegateVector(self, A: FVector_in) -> FVector:
        """Negate a vector.

        Unreal: UKismetMathLibrary.NegateVector (static)
        """
    def Normal(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> FVector:
        """Gets a normalized unit vector; a zero vector when the length of A squared is smaller than the tolerance.

        Unreal: UKismetMathLibrary.Normal (static)
        """
    def Normal2D(self, A: FVector2D_in, Tolerance: float | Future[float] = 0.0) -> FVector2D:
        """Gets a normalized copy of the vector; zero when its squared length is below the tolerance.

        Unreal: UKismetMathLibrary.Normal2D (static)
        """
    def NormalizeAxis(self, Angle: float | Future[float]) -> float:
        """Clamps an angle to the range of [-180, 180].

        Unreal: UKismetMathLibrary.NormalizeAxis (static)
        """
    def NormalizeToRange(self, Value: float | Future[float], RangeMin: float | Future[float], RangeMax: float | Future[float]) -> float:
        """Returns Value normalized to the given range. (For example 20 normalized to the range 10-50 would result in
        0.25.)

        Unreal: UKismetMathLibrary.NormalizeToRange (static)
        """
    def NormalizedDeltaRotator(self, A: FRotator_in, B: FRotator_in) -> FRotator:
        """Normalized A-B: each angle between -180 and 180.

        Unreal: UKismetMathLibrary.NormalizedDeltaRotator (static)
        """
    def NotEqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> bool:
        """Returns true if vector A is not equal to vector B (A != B) exactly.

        Unreal: UKismetMathLibrary.NotEqualExactly_VectorVector (static)
        """
    def NotEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> bool:
        """Returns true if the values are not equal (A != B).

        Unreal: UKismetMathLibrary.NotEqual_BoolBool (static)
        """
    def NotEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A != B.

        Unreal: UKismetMathLibrary.NotEqual_ByteByte (static)
        """
    def NotEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> bool:
        """Returns true if A != B.

        Unreal: UKismetMathLibrary.NotEqual_DateTimeDateTime (static)
        """
    def NotEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> bool:
        """Returns true if A != B exactly.

        Unreal: UKismetMathLibrary.NotEqual_DoubleDouble (static)
        """
    def NotEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A != B.

        Unreal: UKismetMathLibrary.NotEqual_Int64Int64 (static)
        """
    def NotEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> bool:
        """Returns true if A != B.

        Unreal: UKismetMathLibrary.NotEqual_IntInt (static)
        """
    def NotEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> bool:
        """Returns true if A and B are not equal (A != B).

        Unreal: UKismetMathLibrary.NotEqual_NameName (static)
        """
    def NotEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> bool:
        """Returns true if A and B are not the same object.

        Unreal: UKismetMathLibrary.NotEqual_ObjectObject (static)
        """
    def NotEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if quaternion A is not equal to quaternion B (A != B) within a specified error tolerance.

        Unreal: UKismetMathLibrary.NotEqual_QuatQuat (static)
        """
    def NotEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if rotator A is not equal to rotator B (A != B) within a specified error tolerance.

        Unreal: UKismetMathLibrary.NotEqual_RotatorRotator (static)
        """
    def NotEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> bool:
        """Returns true if A != B.

        Unreal: UKismetMathLibrary.NotEqual_TimespanTimespan (static)
        """
    def NotEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> bool:
        """Returns true if vector A is not equal to vector B (A != B) within a specified error tolerance.

        Unreal: UKismetMathLibrary.NotEqual_VectorVector (static)
        """
    def Not_Int(self, A: int | Future[int]) -> int:
        """Bitwise NOT (~A).

        Unreal: UKismetMathLibrary.Not_Int (static)
        """
    def Not_Int64(self, A: int | Future[int]) -> int:
        """Bitwise NOT (~A).

        Unreal: UKismetMathLibrary.Not_Int64 (static)
        """
    def Not_PreBool(self, A: bool | Future[bool]) -> bool:
        """Returns the logical complement of the Boolean value (NOT A).

        Unreal: UKismetMathLibrary.Not_PreBool (static)
        """
    def Now(self) -> FDateTime:
        """Returns the local date and time on this computer.

        Unreal: UKismetMathLibrary.Now (static)
        """
    def Or_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise OR (A | B).

        Unreal: UKismetMathLibrary.Or_Int64Int64 (static)
        """
    def Or_IntInt(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise OR (A | B).

        Unreal: UKismetMathLibrary.Or_IntInt (static)
        """
    def Percent_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Modulo (A % B). Modulo zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Percent_ByteByte (static)
        """
    def Percent_FloatFloat(self, A: float | Future[float], B: float | Future[float] = 1.0) -> float:
        """Modulo (A % B), with the sign of A. Modulo zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Percent_FloatFloat (static)
        """
    def Percent_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Modulo (A % B). Modulo zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Percent_Int64Int64 (static)
        """
    def Percent_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Modulo (A % B). Modulo zero gives 0 and a warning in the log.

        Unreal: UKismetMathLibrary.Percent_IntInt (static)
        """
    def ProjectPointOnToPlane(self, Point: FVector_in, PlaneBase: FVector_in, PlaneNormal: FVector_in) -> FVector:
        """Projects a point onto a plane defined by a point on the plane and a plane normal.

        Unreal: UKismetMathLibrary.ProjectPointOnToPlane (static)
        """
    def ProjectVectorOnToPlane(self, V: FVector_in, PlaneNormal: FVector_in) -> FVector:
        """Projects a vector onto a plane defined by a normalized vector (PlaneNormal).

        Unreal: UKismetMathLibrary.ProjectVectorOnToPlane (static)
        """
    def ProjectVectorOnToVector(self, V: FVector_in, Target: FVector_in) -> FVector:
        """Projects one vector (V) onto another (Target) and returns the projected vector. A zero target gives a zero
        vector.

        Unreal: UKismetMathLibrary.ProjectVectorOnToVector (static)
        """
    def Quat_AngularDistance(self, A: FQuat_in, B: FQuat_in) -> float:
        """Finds the angular distance/difference between two rotation quaternions, in radians.

        Unreal: UKismetMathLibrary.Quat_AngularDistance (static)
        """
    def Quat_Euler(self, Q: FQuat_in) -> FVector:
        """Converts a quaternion into floating-point Euler angles (roll, pitch, yaw in degrees).

        Unreal: UKismetMathLibrary.Quat_Euler (static)
        """
    def Quat_GetAngle(self, Q: FQuat_in) -> float:
        """Gets the angle of this quaternion, in radians.

        Unreal: UKismetMathLibrary.Quat_GetAngle (static)
        """
    def Quat_GetAxisX(self, Q: FQuat_in) -> FVector:
        """Gets the X direction after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_GetAxisX (static)
        """
    def Quat_GetAxisY(self, Q: FQuat_in) -> FVector:
        """Gets the Y direction after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_GetAxisY (static)
        """
    def Quat_GetAxisZ(self, Q: FQuat_in) -> FVector:
        """Gets the Z direction after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_GetAxisZ (static)
        """
    def Quat_GetRotationAxis(self, Q: FQuat_in) -> FVector:
        """Gets the axis of rotation; forward for the identity.

        Unreal: UKismetMathLibrary.Quat_GetRotationAxis (static)
        """
    def Quat_Identity(self) -> FQuat:
        """Identity quaternion constant.

        Unreal: UKismetMathLibrary.Quat_Identity (static)
        """
    def Quat_Inversed(self, Q: FQuat_in) -> FQuat:
        """Returns an inversed copy of this quaternion.

        Unreal: UKismetMathLibrary.Quat_Inversed (static)
        """
    def Quat_IsFinite(self, Q: FQuat_in) -> bool:
        """Determines if all the values are finite (not NaN nor Inf) in this quaternion.

        Unreal: UKismetMathLibrary.Quat_IsFinite (static)
        """
    def Quat_IsIdentity(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> bool:
        """Checks whether this quaternion is an identity quaternion, within a tolerance.

        Unreal: UKismetMathLibrary.Quat_IsIdentity (static)
        """
    def Quat_IsNormalized(self, Q: FQuat_in) -> bool:
        """Returns true if this quaternion is normalized.

        Unreal: UKismetMathLibrary.Quat_IsNormalized (static)
        """
    def Quat_MakeFromEuler(self, Euler: FVector_in) -> FQuat:
        """Converts a vector of floating-point Euler angles (roll, pitch, yaw in degrees) into a quaternion.

        Unreal: UKismetMathLibrary.Quat_MakeFromEuler (static)
        """
    def Quat_Normalized(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> FQuat:
        """Gets a normalized copy of this quaternion; the identity if it is too small.

        Unreal: UKismetMathLibrary.Quat_Normalized (static)
        """
    def Quat_RotateVector(self, Q: FQuat_in, V: FVector_in) -> FVector:
        """Rotates a vector by this quaternion.

        Unreal: UKismetMathLibrary.Quat_RotateVector (static)
        """
    def Quat_Rotator(self, Q: FQuat_in) -> FRotator:
        """Converts a quaternion to a rotator.

        Unreal: UKismetMathLibrary.Quat_Rotator (static)
        """
    def Quat_Size(self, Q: FQuat_in) -> float:
        """Gets the length of this quaternion.

        Unreal: UKismetMathLibrary.Quat_Size (static)
        """
    def Quat_SizeSquared(self, Q: FQuat_in) -> float:
        """Gets the length squared of this quaternion.

        Unreal: UKismetMathLibrary.Quat_SizeSquared (static)
        """
    def Quat_Slerp(self, A: FQuat_in, B: FQuat_in, Alpha: float | Future[float]) -> FQuat:
        """Spherical interpolation between quaternions. The result is normalized.

        Unreal: UKismetMathLibrary.Quat_Slerp (static)
        """
    def Quat_UnrotateVector(self, Q: FQuat_in, V: FVector_in) -> FVector:
        """Rotates a vector by the inverse of this quaternion.

        Unreal: UKismetMathLibrary.Quat_UnrotateVector (static)
        """
    def Quat_VectorForward(self, Q: FQuat_in) -> FVector:
        """Gets the forward direction (X axis) after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_VectorForward (static)
        """
    def Quat_VectorRight(self, Q: FQuat_in) -> FVector:
        """Gets the right direction (Y axis) after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_VectorRight (static)
        """
    def Quat_VectorUp(self, Q: FQuat_in) -> FVector:
        """Gets the up direction (Z axis) after it has been rotated by this quaternion.

        Unreal: UKismetMathLibrary.Quat_VectorUp (static)
        """
    def REase(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> FRotator:
        """Eases between A and B using a specified easing function.

        Unreal: UKismetMathLibrary.REase (static)
        """
    def RGBToHSV(self, InColor: FLinearColor_in) -> UKismetMathLibrary_RGBToHSV_Result:
        """Breaks apart a colour into individual HSV components (as well as alpha) (hue is [0..360], saturation and value
        are [0..1]).

        Unreal: UKismetMathLibrary.RGBToHSV (static)
        """
    def RInterpTo(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FRotator:
        """Tries to reach Target rotation based on Current rotation, giving a nice smooth feeling when rotating to Target
        rotation. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.RInterpTo (static)
        """
    def RInterpTo_Constant(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FRotator:
        """Tries to reach Target rotation at a constant rate, in degrees per second for each angle. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.RInterpTo_Constant (static)
        """
    def RLerp(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool]) -> FRotator:
        """Linearly interpolates between A and B based on Alpha; optionally the shorter way round.

        Unreal: UKismetMathLibrary.RLerp (static)
        """
    def RadiansToDegrees(self, A: float | Future[float]) -> float:
        """Returns degrees value based on the input radians.

        Unreal: UKismetMathLibrary.RadiansToDegrees (static)
        """
    def RandomBool(self) -> bool:
        """Returns a uniformly distributed random bool.

        Unreal: UKismetMathLibrary.RandomBool (static)
        """
    def RandomBoolFromStream(self, Stream: FRandomStream_in) -> bool:
        """Returns a random bool.

        Unreal: UKismetMathLibrary.RandomBoolFromStream (static)
        """
    def RandomBoolWithWeight(self, Weight: float | Future[float]) -> bool:
        """Gets a random chance with the specified weight: 0 is never, 1 is always.

        Unreal: UKismetMathLibrary.RandomBoolWithWeight (static)
        """
    def RandomBoolWithWeightFromStream(self, RandomStream: FRandomStream_in, Weight: float | Future[float]) -> bool:
        """Gets a random chance with the specified weight: 0 is never, 1 is always.

        Unreal: UKismetMathLibrary.RandomBoolWithWeightFromStream (static)
        """
    def RandomFloat(self) -> float:
        """Returns a random float between 0 and 1.

        Unreal: UKismetMathLibrary.RandomFloat (static)
        """
    def RandomFloatFromStream(self, Stream: FRandomStream_in) -> float:
        """Returns a random float between 0 and 1.

        Unreal: UKismetMathLibrary.RandomFloatFromStream (static)
        """
    def RandomFloatInRange(self, Min: float | Future[float], Max: float | Future[float]) -> float:
        """Generates a random number between Min and Max.

        Unreal: UKismetMathLibrary.RandomFloatInRange (static)
        """
    def RandomFloatInRangeFromStream(self, Stream: FRandomStream_in, Min: float | Future[float], Max: float | Future[float]) -> float:
        """Generates a random number between Min and Max.

        Unreal: UKismetMathLibrary.RandomFloatInRangeFromStream (static)
        """
    def RandomInteger(self, Max: int | Future[int]) -> int:
        """Returns a uniformly distributed random number between 0 and Max - 1; 0 when Max is 0 or less.

        Unreal: UKismetMathLibrary.RandomInteger (static)
        """
    def RandomIntegerFromStream(self, Stream: FRandomStream_in, Max: int | Future[int]) -> int:
        """Returns a uniformly distributed random number between 0 and Max - 1.

        Unreal: UKismetMathLibrary.RandomIntegerFromStream (static)
        """
    def RandomIntegerInRange(self, Min: int | Future[int], Max: int | Future[int]) -> int:
        """Returns a random integer between Min and Max (>= Min and <= Max).

        Unreal: UKismetMathLibrary.RandomIntegerInRange (static)
        """
    def RandomIntegerInRangeFromStream(self, Stream: FRandomStream_in, Min: int | Future[int], Max: int | Future[int]) -> int:
        """Returns a random integer between Min and Max (>= Min and <= Max).

        Unreal: UKismetMathLibrary.RandomIntegerInRangeFromStream (static)
        """
    def RandomPointInBoundingBox(self, Center: FVector_in, HalfSize: FVector_in) -> FVector:
        """Returns a random point within the specified bounding box.

        Unreal: UKismetMathLibrary.RandomPointInBoundingBox (static)
        """
    def RandomRotator(self, bRoll: bool | Future[bool] = False) -> FRotator:
        """Generates a random rotation, with optional random roll.

        Unreal: UKismetMathLibrary.RandomRotator (static)
        """
    def RandomRotatorFromStream(self, Stream: FRandomStream_in, bRoll: bool | Future[bool]) -> FRotator:
        """Creates a random rotation, with optional random roll.

        Unreal: UKismetMathLibrary.RandomRotatorFromStream (static)
        """
    def RandomUnitVector(self) -> FVector:
        """Returns a random vector with length of 1, uniformly distributed over the sphere.

        Unreal: UKismetMathLibrary.RandomUnitVector (static)
        """
    def RandomUnitVectorFromStream(self, Stream: FRandomStream_in) -> FVector:
        """Returns a random vector with length of 1.0.

        Unreal: UKismetMathLibrary.RandomUnitVectorFromStream (static)
        """
    def ResetRandomStream(self, Stream: FRandomStream_in) -> None:
        """Resets a random stream to its initial seed.

        Unreal: UKismetMathLibrary.ResetRandomStream (static)
        """
    def RotateAngleAxis(self, InVect: FVector_in, AngleDeg: float | Future[float], Axis: FVector_in) -> FVector:
        """Returns result of vector InVect rotated by AngleDeg degrees around Axis (a unit vector).

        Unreal: UKismetMathLibrary.RotateAngleAxis (static)
        """
    def RotatorFromAxisAndAngle(self, Axis: FVector_in, Angle: float | Future[float]) -> FRotator:
        """Creates a rotation from an axis and an angle in degrees.

        Unreal: UKismetMathLibrary.RotatorFromAxisAndAngle (static)
        """
    def Round(self, A: float | Future[float]) -> int:
        """Rounds A to the nearest integer. A fraction of .5 rounds up: 1.5 gives 2, -1.5 gives -1.

        Unreal: UKismetMathLibrary.Round (static)
        """
    def Round64(self, A: float | Future[float]) -> int:
        """Rounds A to the nearest integer. A fraction of .5 rounds up.

        Unreal: UKismetMathLibrary.Round64 (static)
        """
    def SafeDivide(self, A: float | Future[float], B: float | Future[float]) -> float:
        """Scalar division (A / B) where a zero divisor gives 0.

        Unreal: UKismetMathLibrary.SafeDivide (static)
        """
    def SeedRandomStream(self, Stream: FRandomStream_in) -> UKismetMathLibrary_SeedRandomStream_Result:
        """Creates a new random seed for a random stream.

        Args:
            Stream: Also a result.

        Unreal: UKismetMathLibrary.SeedRandomStream (static)
        """
    def SelectClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass], bSelectA: bool | Future[bool]) -> UClass:
        """If bSelectA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectClass (static)
        """
    def SelectColor(self, A: FLinearColor_in, B: FLinearColor_in, bPickA: bool | Future[bool]) -> FLinearColor:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectColor (static)
        """
    def SelectFloat(self, A: float | Future[float], B: float | Future[float], bPickA: bool | Future[bool]) -> float:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectFloat (static)
        """
    def SelectInt(self, A: int | Future[int], B: int | Future[int], bPickA: bool | Future[bool]) -> int:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectInt (static)
        """
    def SelectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject], bSelectA: bool | Future[bool]) -> UObject:
        """If bSelectA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectObject (static)
        """
    def SelectRotator(self, A: FRotator_in, B: FRotator_in, bPickA: bool | Future[bool]) -> FRotator:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectRotator (static)
        """
    def SelectString(self, A: str | Future[str], B: str | Future[str], bPickA: bool | Future[bool]) -> str:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectString (static)
        """
    def SelectTransform(self, A: FTransform_in, B: FTransform_in, bPickA: bool | Future[bool]) -> FTransform:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectTransform (static)
        """
    def SelectVector(self, A: FVector_in, B: FVector_in, bPickA: bool | Future[bool]) -> FVector:
        """If bPickA is true, A is returned, otherwise B is.

        Unreal: UKismetMathLibrary.SelectVector (static)
        """
    def SetRandomStreamSeed(self, Stream: FRandomStream_in, NewSeed: int | Future[int]) -> UKismetMathLibrary_SetRandomStreamSeed_Result:
        """Sets the seed of a random stream to a specific number.

        Args:
            Stream: Also a result.

        Unreal: UKismetMathLibrary.SetRandomStreamSeed (static)
        """
    def SignOfFloat(self, A: float | Future[float]) -> float:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0).

        Unreal: UKismetMathLibrary.SignOfFloat (static)
        """
    def SignOfInteger(self, A: int | Future[int]) -> int:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0).

        Unreal: UKismetMathLibrary.SignOfInteger (static)
        """
    def SignOfInteger64(self, A: int | Future[int]) -> int:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0).

        Unreal: UKismetMathLibrary.SignOfInteger64 (static)
        """
    def Sin(self, A: float | Future[float]) -> float:
        """Returns the sine of A (expects Radians).

        Unreal: UKismetMathLibrary.Sin (static)
        """
    def Sqrt(self, A: float | Future[float]) -> float:
        """Returns the square root of A; 0 with a warning in the log when A is negative.

        Unreal: UKismetMathLibrary.Sqrt (static)
        """
    def Square(self, A: float | Future[float]) -> float:
        """Returns square of A (A * A).

        Unreal: UKismetMathLibrary.Square (static)
        """
    def Subtract_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Subtraction (A - B), modulo 256.

        Unreal: UKismetMathLibrary.Subtract_ByteByte (static)
        """
    def Subtract_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> FTimespan:
        """Subtraction (A - B).

        Unreal: UKismetMathLibrary.Subtract_DateTimeDateTime (static)
        """
    def Subtract_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> FDateTime:
        """Subtraction (A - B).

        Unreal: UKismetMathLibrary.Subtract_DateTimeTimespan (static)
        """
    def Subtract_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> float:
        """Subtraction (A - B).

        Unreal: UKismetMathLibrary.Subtract_DoubleDouble (static)
        """
    def Subtract_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Subtraction (A - B); wraps on overflow.

        Unreal: UKismetMathLibrary.Subtract_Int64Int64 (static)
        """
    def Subtract_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> int:
        """Subtraction (A - B); wraps on overflow.

        Unreal: UKismetMathLibrary.Subtract_IntInt (static)
        """
    def Subtract_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> FLinearColor:
        """Element-wise subtraction of two linear colours.

        Unreal: UKismetMathLibrary.Subtract_LinearColorLinearColor (static)
        """
    def Subtract_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> FQuat:
        """Returns subtraction of B from A, element by element.

        Unreal: UKismetMathLibrary.Subtract_QuatQuat (static)
        """
    def Subtract_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> FTimespan:
        """Subtraction (A - B).

        Unreal: UKismetMathLibrary.Subtract_TimespanTimespan (static)
        """
    def Subtract_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> FVector2D:
        """Subtraction (A - B).

        Unreal: UKismetMathLibrary.Subtract_Vector2DVector2D (static)
        """
    def Subtract_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> FVector:
        """Subtracts a float from each component of a vector.

        Unreal: UKismetMathLibrary.Subtract_VectorFloat (static)
        """
    def Subtract_VectorInt(self, A: FVector_in, B: int | Future[int]) -> FVector:
        """Subtracts an integer from each component of a vector.

        Unreal: UKismetMathLibrary.Subtract_VectorInt (static)
        """
    def Subtract_VectorVector(self, A: FVector_in, B: FVector_in) -> FVector:
        """Vector subtraction.

        Unreal: UKismetMathLibrary.Subtract_VectorVector (static)
        """
    def TEase(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> FTransform:
        """Eases between A and B using a specified easing function.

        Unreal: UKismetMathLibrary.TEase (static)
        """
    def TInterpTo(self, Current: FTransform_in, Target: FTransform_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FTransform:
        """Tries to reach a target transform. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.TInterpTo (static)
        """
    def TLerp(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], InterpMode: ELerpInterpolationMode_in = ELerpInterpolationMode.QuatInterp) -> FTransform:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1).

        Unreal: UKismetMathLibrary.TLerp (static)
        """
    def Tan(self, A: float | Future[float]) -> float:
        """Returns the tan of A (expects Radians).

        Unreal: UKismetMathLibrary.Tan (static)
        """
    def TimespanRatio(self, A: FTimespan_in, B: FTimespan_in) -> float:
        """Returns the ratio between two time spans (A / B), handles zero values.

        Unreal: UKismetMathLibrary.TimespanRatio (static)
        """
    def TimespanZeroValue(self) -> FTimespan:
        """Returns a zero time span value.

        Unreal: UKismetMathLibrary.TimespanZeroValue (static)
        """
    def ToUnixTimestamp(self, Time: FDateTime_in) -> int:
        """Returns this date and time as the number of seconds since the unix epoch.

        Unreal: UKismetMathLibrary.ToUnixTimestamp (static)
        """
    def Today(self) -> FDateTime:
        """Returns the local date on this computer.

        Unreal: UKismetMathLibrary.Today (static)
        """
    def TransformDirection(self, T: FTransform_in, Direction: FVector_in) -> FVector:
        """Transforms a direction vector by the given transform: does not change its length.

        Unreal: UKismetMathLibrary.TransformDirection (static)
        """
    def TransformLocation(self, T: FTransform_in, Location: FVector_in) -> FVector:
        """Transforms a position by the given transform, scale counted.

        Unreal: UKismetMathLibrary.TransformLocation (static)
        """
    def TransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> FRotator:
        """Transforms a rotator by the given transform.

        Unreal: UKismetMathLibrary.TransformRotation (static)
        """
    def Transform_Determinant(self, Transform: FTransform_in) -> float:
        """Computes the determinant of the transform converted to a matrix: the product of the scale.

        Unreal: UKismetMathLibrary.Transform_Determinant (static)
        """
    def UtcNow(self) -> FDateTime:
        """Returns the UTC date and time on this computer.

        Unreal: UKismetMathLibrary.UtcNow (static)
        """
    def VEase(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> FVector:
        """Eases between A and B using a specified easing function.

        Unreal: UKismetMathLibrary.VEase (static)
        """
    def VInterpTo(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FVector:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a
        position. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.VInterpTo (static)
        """
    def VInterpTo_Constant(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FVector:
        """Tries to reach Target at a constant rate.

        Unreal: UKismetMathLibrary.VInterpTo_Constant (static)
        """
    def VLerp(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float]) -> FVector:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1).

        Unreal: UKismetMathLibrary.VLerp (static)
        """
    def VSize(self, A: FVector_in) -> float:
        """Returns the length of the vector.

        Unreal: UKismetMathLibrary.VSize (static)
        """
    def VSize2D(self, A: FVector2D_in) -> float:
        """Returns the length of a 2D vector.

        Unreal: UKismetMathLibrary.VSize2D (static)
        """
    def VSize2DSquared(self, A: FVector2D_in) -> float:
        """Returns the squared length of a 2D vector.

        Unreal: UKismetMathLibrary.VSize2DSquared (static)
        """
    def VSizeSquared(self, A: FVector_in) -> float:
        """Returns the squared length of the vector.

        Unreal: UKismetMathLibrary.VSizeSquared (static)
        """
    def VSizeXY(self, A: FVector_in) -> float:
        """Returns the length of the vector's XY components.

        Unreal: UKismetMathLibrary.VSizeXY (static)
        """
    def VSizeXYSquared(self, A: FVector_in) -> float:
        """Returns the squared length of the vector's XY components.

        Unreal: UKismetMathLibrary.VSizeXYSquared (static)
        """
    def Vector2DInterpTo(self, Current: FVector2D_in, Target: FVector2D_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> FVector2D:
        """Tries to reach Target based on distance from Current position. A speed of 0 jumps.

        Unreal: UKismetMathLibrary.Vector2DInterpTo (static)
        """
    def Vector_Assign(self, A: FVector_in, InVector: FVector_in) -> UKismetMathLibrary_Vector_Assign_Result:
        """Assign the values of the supplied vector.

        Args:
            A: Also a result.

        Unreal: UKismetMathLibrary.Vector_Assign (static)
        """
    def Vector_Backward(self) -> FVector:
        """3D vector backward: (-1, 0, 0).

        Unreal: UKismetMathLibrary.Vector_Backward (static)
        """
    def Vector_ClampSizeMax(self, A: FVector_in, Max: float | Future[float]) -> FVector:
        """Creates a copy of this vector with its maximum magnitude clamped to Max.

        Unreal: UKismetMathLibrary.Vector_ClampSizeMax (static)
        """
    def Vector_Distance(self, V1: FVector_in, V2: FVector_in) -> float:
        """Distance between two points.

        Unreal: UKismetMathLibrary.Vector_Distance (static)
        """
    def Vector_Distance2D(self, V1: FVector_in, V2: FVector_in) -> float:
        """Distance between two points in the XY plane (ignoring Z).

        Unreal: UKismetMathLibrary.Vector_Distance2D (static)
        """
    def Vector_Distance2DSquared(self, V1: FVector_in, V2: FVector_in) -> float:
        """Squared distance between two points in the XY plane (ignoring Z).

        Unreal: UKismetMathLibrary.Vector_Distance2DSquared (static)
        """
    def Vector_DistanceSquared(self, V1: FVector_in, V2: FVector_in) -> float:
        """Squared distance between two points.

        Unreal: UKismetMathLibrary.Vector_DistanceSquared (static)
        """
    def Vector_Down(self) -> FVector:
        """3D vector down: (0, 0, -1).

        Unreal: UKismetMathLibrary.Vector_Down (static)
        """
    def Vector_Forward(self) -> FVector:
        """3D vector forward: (1, 0, 0).

        Unreal: UKismetMathLibrary.Vector_Forward (static)
        """
    def Vector_GetAbs(self, A: FVector_in) -> FVector:
        """Gets a copy of this vector with absolute value of each component.

        Unreal: UKismetMathLibrary.Vector_GetAbs (static)
        """
    def Vector_IsNAN(self, A: FVector_in) -> bool:
        """Determines if any component is not a number (NAN).

        Unreal: UKismetMathLibrary.Vector_IsNAN (static)
        """
    def Vector_IsNearlyZero(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> bool:
        """Checks whether the vector is near to zero within a specified tolerance.

        Unreal: UKismetMathLibrary.Vector_IsNearlyZero (static)
        """
    def Vector_IsNormal(self, A: FVector_in) -> bool:
        """Determines if vector is normalized / unit (length 1).

        Unreal: UKismetMathLibrary.Vector_IsNormal (static)
        """
    def Vector_IsUniform(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> bool:
        """Checks whether all components of the vector are the same, within a tolerance.

        Unreal: UKismetMathLibrary.Vector_IsUniform (static)
        """
    def Vector_IsUnit(self, A: FVector_in, SquaredLenthTolerance: float | Future[float] = 0.0001) -> bool:
        """Determines if vector is normalized / unit (length 1) within specified squared tolerance.

        Unreal: UKismetMathLibrary.Vector_IsUnit (static)
        """
    def Vector_IsZero(self, A: FVector_in) -> bool:
        """Checks whether all components of the vector are exactly zero.

        Unreal: UKismetMathLibrary.Vector_IsZero (static)
        """
    def Vector_Left(self) -> FVector:
        """3D vector left: (0, -1, 0).

        Unreal: UKismetMathLibrary.Vector_Left (static)
        """
    def Vector_Normal2D(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> FVector:
        """Gets a normalized unit vector of the XY components, with Z zero.

        Unreal: UKismetMathLibrary.Vector_Normal2D (static)
        """
    def Vector_One(self) -> FVector:
        """3D vector (1, 1, 1).

        Unreal: UKismetMathLibrary.Vector_One (static)
        """
    def Vector_Reciprocal(self, A: FVector_in) -> FVector:
        """Gets the reciprocal of this vector, avoiding division by zero: zero components give 3.4e38.

        Unreal: UKismetMathLibrary.Vector_Reciprocal (static)
        """
    def Vector_Right(self) -> FVector:
        """3D vector right: (0, 1, 0).

        Unreal: UKismetMathLibrary.Vector_Right (static)
        """
    def Vector_Set(self, A: FVector_in, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> UKismetMathLibrary_Vector_Set_Result:
        """Set the values of the vector directly.

        Args:
            A: Also a result.

        Unreal: UKismetMathLibrary.Vector_Set (static)
        """
    def Vector_Up(self) -> FVector:
        """3D vector up: (0, 0, 1).

        Unreal: UKismetMathLibrary.Vector_Up (static)
        """
    def Vector_Zero(self) -> FVector:
        """3D vector (0, 0, 0).

        Unreal: UKismetMathLibrary.Vector_Zero (static)
        """
    def Wrap(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> int:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min.

        Unreal: UKismetMathLibrary.Wrap (static)
        """
    def Xor_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise XOR (A ^ B).

        Unreal: UKismetMathLibrary.Xor_Int64Int64 (static)
        """
    def Xor_IntInt(self, A: int | Future[int], B: int | Future[int]) -> int:
        """Bitwise XOR (A ^ B).

        Unreal: UKismetMathLibrary.Xor_IntInt (static)
        """

class UKismetMathLibrary_async(UBlueprintFunctionLibrary_async):
    """UKismetMathLibrary under ``async_``: each function gives a future."""
    def Abs(self, A: float | Future[float]) -> Future[float]:
        """Returns the absolute (positive) value of A."""
    def Abs_Int(self, A: int | Future[int]) -> Future[int]:
        """Returns the absolute (positive) value of A."""
    def Abs_Int64(self, A: int | Future[int]) -> Future[int]:
        """Returns the absolute (positive) value of A."""
    def Acos(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arccos) of A (result is in Radians)."""
    def Add_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Addition (A + B), modulo 256."""
    def Add_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> Future[FDateTime]:
        """Addition (A + B)."""
    def Add_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> Future[float]:
        """Addition (A + B)."""
    def Add_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Addition (A + B); wraps on overflow."""
    def Add_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Addition (A + B); wraps on overflow."""
    def Add_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> Future[FLinearColor]:
        """Element-wise addition of two linear colours."""
    def Add_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> Future[FQuat]:
        """Returns addition of vector B to vector A, element by element."""
    def Add_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[FTimespan]:
        """Addition (A + B)."""
    def Add_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> Future[FVector2D]:
        """Addition (A + B)."""
    def Add_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> Future[FVector]:
        """Adds a float to each component of a vector."""
    def Add_VectorInt(self, A: FVector_in, B: int | Future[int]) -> Future[FVector]:
        """Adds an integer to each component of a vector."""
    def Add_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[FVector]:
        """Vector addition."""
    def And_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise AND (A & B)."""
    def And_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise AND (A & B)."""
    def Asin(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arcsin) of A (result is in Radians)."""
    def Atan(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arctan) of A (result is in Radians)."""
    def Atan2(self, Y: float | Future[float], X: float | Future[float]) -> Future[float]:
        """Returns the inverse tan (atan2) of Y/X (result is in Radians)."""
    def BMax(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the maximum value of A and B."""
    def BMin(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the minimum value of A and B."""
    def BooleanAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns the logical AND of two values (A AND B)."""
    def BooleanNAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns the logical NAND of two values (A NAND B)."""
    def BooleanNOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns the logical Not OR of two values (A NOR B)."""
    def BooleanOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns the logical OR of two values (A OR B)."""
    def BooleanXOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns the logical eXclusive OR of two values (A XOR B)."""
    def Box_Intersects(self, A: FBox_in, B: FBox_in) -> Future[bool]:
        """Checks whether bounding box A intersects bounding box B."""
    def Box_IsPointInside(self, Box: FBox_in, Point: FVector_in) -> Future[bool]:
        """Checks whether the given location is inside this box."""
    def BreakColor(self, InColor: FLinearColor_in) -> Future[UKismetMathLibrary_BreakColor_Result]:
        """Breaks apart a colour into individual RGB components (as well as alpha)."""
    def BreakDateTime(self, InDateTime: FDateTime_in) -> Future[UKismetMathLibrary_BreakDateTime_Result]:
        """Breaks a date and time into its components."""
    def BreakRandomStream(self, InRandomStream: FRandomStream_in) -> Future[UKismetMathLibrary_BreakRandomStream_Result]:
        """Breaks out a random number generator into its initial seed."""
    def BreakRotIntoAxes(self, InRot: FRotator_in) -> Future[UKismetMathLibrary_BreakRotIntoAxes_Result]:
        """Breaks apart a rotator into its component axes."""
    def BreakRotator(self, InRot: FRotator_in) -> Future[UKismetMathLibrary_BreakRotator_Result]:
        """Breaks apart a rotator into {Roll, Pitch, Yaw} angles in degrees."""
    def BreakTimespan(self, InTimespan: FTimespan_in) -> Future[UKismetMathLibrary_BreakTimespan_Result]:
        """Breaks a time span into its components."""
    def BreakTransform(self, InTransform: FTransform_in) -> Future[UKismetMathLibrary_BreakTransform_Result]:
        """Breaks apart a transform into location, rotation and scale."""
    def BreakVector(self, InVec: FVector_in) -> Future[UKismetMathLibrary_BreakVector_Result]:
        """Breaks a vector apart into X, Y, Z."""
    def BreakVector2D(self, InVec: FVector2D_in) -> Future[UKismetMathLibrary_BreakVector2D_Result]:
        """Breaks a 2D vector apart into X, Y."""
    def CInterpTo(self, Current: FLinearColor_in, Target: FLinearColor_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FLinearColor]:
        """Tries to reach a target colour."""
    def Clamp(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> Future[int]:
        """Returns Value clamped to be between Min and Max (inclusive)."""
    def ClampAngle(self, AngleDegrees: float | Future[float], MinAngleDegrees: float | Future[float], MaxAngleDegrees: float | Future[float]) -> Future[float]:
        """Clamps an arbitrary angle to be between the given angles."""
    def ClampAxis(self, Angle: float | Future[float]) -> Future[float]:
        """Clamps an angle to the range of [0, 360]."""
    def ClampInt64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> Future[int]:
        """Returns Value clamped to be between Min and Max (inclusive)."""
    def ClampVectorSize(self, A: FVector_in, Min: float | Future[float], Max: float | Future[float]) -> Future[FVector]:
        """Creates a copy of this vector with its magnitude clamped between Min and Max."""
    def ClassIsChildOf(self, TestClass: type[UObject] | UClass | str | Future[UClass], ParentClass: type[UObject] | UClass | str | Future[UClass]) -> Future[bool]:
        """Determines if a class is a child of another class."""
    def ComposeRotators(self, A: FRotator_in, B: FRotator_in) -> Future[FRotator]:
        """Combines 2 rotations to give you the resulting rotation of first applying A, then B."""
    def ComposeTransforms(self, A: FTransform_in, B: FTransform_in) -> Future[FTransform]:
        """Composes two transforms in order: A * B."""
    def Conv_BoolToByte(self, InBool: bool | Future[bool]) -> Future[int]:
        """Converts a bool to a byte."""
    def Conv_BoolToDouble(self, InBool: bool | Future[bool]) -> Future[float]:
        """Converts a bool to a float (0.0 or 1.0)."""
    def Conv_BoolToInt(self, InBool: bool | Future[bool]) -> Future[int]:
        """Converts a bool to an int."""
    def Conv_ByteToDouble(self, InByte: int | Future[int]) -> Future[float]:
        """Converts a byte to a float."""
    def Conv_ByteToInt(self, InByte: int | Future[int]) -> Future[int]:
        """Converts a byte to an integer."""
    def Conv_ByteToInt64(self, InByte: int | Future[int]) -> Future[int]:
        """Converts a byte to a 64 bit integer."""
    def Conv_ColorToLinearColor(self, InColor: FColor_in) -> Future[FLinearColor]:
        """Converts an sRGB-encoded colour to a linear one."""
    def Conv_DoubleToFloat(self, InDouble: float | Future[float]) -> Future[float]:
        """Converts a double-precision number to a single-precision one."""
    def Conv_DoubleToInt64(self, InDouble: float | Future[float]) -> Future[int]:
        """Converts a float to a 64 bit integer."""
    def Conv_DoubleToLinearColor(self, InDouble: float | Future[float]) -> Future[FLinearColor]:
        """Converts a float to a linear colour: grey, opaque."""
    def Conv_DoubleToVector(self, InDouble: float | Future[float]) -> Future[FVector]:
        """Converts a float to a vector, with the same value in every component."""
    def Conv_DoubleToVector2D(self, InDouble: float | Future[float]) -> Future[FVector2D]:
        """Converts a float to a 2D vector, with the same value in both components."""
    def Conv_FloatToDouble(self, InFloat: float | Future[float]) -> Future[float]:
        """Converts a single-precision number to a double-precision one."""
    def Conv_Int64ToDouble(self, InInt: int | Future[int]) -> Future[float]:
        """Converts a 64 bit integer to a float."""
    def Conv_Int64ToInt(self, InInt: int | Future[int]) -> Future[int]:
        """Converts a 64 bit integer to a 32 bit integer (the low 32 bits)."""
    def Conv_IntPointToVector2D(self, InIntPoint: FIntPoint_in) -> Future[FVector2D]:
        """Converts an integer point to a 2D vector."""
    def Conv_IntToBool(self, InInt: int | Future[int]) -> Future[bool]:
        """Converts an int to a bool."""
    def Conv_IntToByte(self, InInt: int | Future[int]) -> Future[int]:
        """Converts an integer to a byte (if the integer is too large, returns the low 8 bits)."""
    def Conv_IntToDouble(self, InInt: int | Future[int]) -> Future[float]:
        """Converts an integer to a float."""
    def Conv_IntToInt64(self, InInt: int | Future[int]) -> Future[int]:
        """Converts an integer to a 64 bit integer."""
    def Conv_IntToVector(self, InInt: int | Future[int]) -> Future[FVector]:
        """Converts an integer to a vector, with the same value in every component."""
    def Conv_IntVectorToVector(self, InIntVector: FIntVector_in) -> Future[FVector]:
        """Converts an integer vector to a vector."""
    def Conv_LinearColorToColor(self, InLinearColor: FLinearColor_in, InUseSRGB: bool | Future[bool] = True) -> Future[FColor]:
        """Converts a linear colour to a byte colour, with or without the sRGB gamma."""
    def Conv_LinearColorToVector(self, InLinearColor: FLinearColor_in) -> Future[FVector]:
        """Converts a linear colour to a vector (alpha is dropped)."""
    def Conv_RotatorToQuaternion(self, InRot: FRotator_in) -> Future[FQuat]:
        """Converts a rotator to a quaternion."""
    def Conv_RotatorToTransform(self, InRotator: FRotator_in) -> Future[FTransform]:
        """Converts a rotator to a transform."""
    def Conv_RotatorToVector(self, InRot: FRotator_in) -> Future[FVector]:
        """Gets the X direction vector after this rotation."""
    def Conv_Vector2DToVector(self, InVector2D: FVector2D_in, Z: float | Future[float] = 0.0) -> Future[FVector]:
        """Converts a 2D vector to a vector."""
    def Conv_VectorToLinearColor(self, InVec: FVector_in) -> Future[FLinearColor]:
        """Converts a vector to a linear colour, opaque."""
    def Conv_VectorToQuaternion(self, InVec: FVector_in) -> Future[FQuat]:
        """Returns the rotation that points along a direction."""
    def Conv_VectorToRotator(self, InVec: FVector_in) -> Future[FRotator]:
        """Returns the rotation that points along a direction: yaw and pitch, no roll."""
    def Conv_VectorToTransform(self, InLocation: FVector_in) -> Future[FTransform]:
        """Converts a vector to a transform: a translation."""
    def Conv_VectorToVector2D(self, InVector: FVector_in) -> Future[FVector2D]:
        """Converts a vector to a 2D vector by dropping Z."""
    def Cos(self, A: float | Future[float]) -> Future[float]:
        """Returns the cosine of A (expects Radians)."""
    def CreateVectorFromYawPitch(self, Yaw: float | Future[float], Pitch: float | Future[float], Length: float | Future[float] = 1.0) -> Future[FVector]:
        """Creates a directional vector from rotation values {Yaw, Pitch} supplied in degrees with specified Length."""
    def CrossProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> Future[float]:
        """Returns the cross product of two 2D vectors."""
    def Cross_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[FVector]:
        """Returns the cross product of two 3D vectors."""
    def DaysInMonth(self, Year: int | Future[int], Month: int | Future[int]) -> Future[int]:
        """Returns the number of days in the given year and month; 0 with a warning for a month out of range."""
    def DaysInYear(self, Year: int | Future[int]) -> Future[int]:
        """Returns the number of days in the given year."""
    def DegAcos(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arccos) of A (result is in Degrees)."""
    def DegAsin(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arcsin) of A (result is in Degrees)."""
    def DegAtan(self, A: float | Future[float]) -> Future[float]:
        """Returns the inverse function (arctan) of A (result is in Degrees)."""
    def DegAtan2(self, Y: float | Future[float], X: float | Future[float]) -> Future[float]:
        """Returns the inverse tan (atan2) of Y/X (result is in Degrees)."""
    def DegCos(self, A: float | Future[float]) -> Future[float]:
        """Returns the cos of A (expects Degrees)."""
    def DegSin(self, A: float | Future[float]) -> Future[float]:
        """Returns the sin of A (expects Degrees)."""
    def DegTan(self, A: float | Future[float]) -> Future[float]:
        """Returns the tan of A (expects Degrees)."""
    def DegreesToRadians(self, A: float | Future[float]) -> Future[float]:
        """Returns radians value based on the input degrees."""
    def Distance2D(self, V1: FVector2D_in, V2: FVector2D_in) -> Future[float]:
        """Distance between two 2D points."""
    def Divide_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Division (A / B)."""
    def Divide_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> Future[float]:
        """Division (A / B)."""
    def Divide_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Division (A / B), towards zero."""
    def Divide_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Division (A / B), towards zero."""
    def Divide_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float] = 1.0) -> Future[FVector2D]:
        """Division by a float."""
    def Divide_VectorFloat(self, A: FVector_in, B: float | Future[float] = 1.0) -> Future[FVector]:
        """Vector divide by a float."""
    def Divide_VectorInt(self, A: FVector_in, B: int | Future[int] = 1) -> Future[FVector]:
        """Vector divide by an integer."""
    def Divide_VectorVector(self, A: FVector_in, B: FVector_in = ...) -> Future[FVector]:
        """Element-wise vector division (Result = {A.x/B.x, A.y/B.y, A.z/B.z})."""
    def DotProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> Future[float]:
        """Returns the dot product of two 2D vectors."""
    def Dot_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[float]:
        """Returns the dot product of two 3D vectors."""
    def Ease(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> Future[float]:
        """Eases between A and B using a specified easing function."""
    def EqualEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns true if the values are equal (A == B)."""
    def EqualEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A == B."""
    def EqualEqual_ClassClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass]) -> Future[bool]:
        """Returns true if A and B are the same class."""
    def EqualEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A == B."""
    def EqualEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A == B exactly."""
    def EqualEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A == B."""
    def EqualEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A == B."""
    def EqualEqual_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> Future[bool]:
        """Returns true if linear colour A is equal to linear colour B exactly."""
    def EqualEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Returns true if A and B are equal (A == B); names compare without case."""
    def EqualEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> Future[bool]:
        """Returns true if A and B are the same object."""
    def EqualEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if quaternion A is equal to quaternion B (A == B) within a specified error tolerance; Q and -Q are the same rotation."""
    def EqualEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if rotator A is equal to rotator B (A == B) within a specified error tolerance; whole turns do not count."""
    def EqualEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A == B."""
    def EqualEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in) -> Future[bool]:
        """Returns true if transform A is equal to transform B, within a small tolerance."""
    def EqualEqual_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if A equals B within a specified error tolerance."""
    def EqualEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if vector A is equal to vector B (A == B) within a specified error tolerance."""
    def EqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[bool]:
        """Returns true if vector A is equal to vector B (A == B) exactly."""
    def Exp(self, A: float | Future[float]) -> Future[float]:
        """Returns exponential (e) to the power A (e^A)."""
    def FCeil(self, A: float | Future[float]) -> Future[int]:
        """Rounds A up towards positive infinity."""
    def FCeil64(self, A: float | Future[float]) -> Future[int]:
        """Rounds A up towards positive infinity."""
    def FClamp(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> Future[float]:
        """Returns Value clamped between Min and Max (inclusive)."""
    def FFloor(self, A: float | Future[float]) -> Future[int]:
        """Rounds A down towards negative infinity."""
    def FFloor64(self, A: float | Future[float]) -> Future[int]:
        """Rounds A down towards negative infinity."""
    def FInterpEaseInOut(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], Exponent: float | Future[float]) -> Future[float]:
        """Interpolates between A and B, applying an ease in/out function."""
    def FInterpTo(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[float]:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a position."""
    def FInterpTo_Constant(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[float]:
        """Tries to reach Target at a constant rate."""
    def FMax(self, A: float | Future[float], B: float | Future[float]) -> Future[float]:
        """Returns the maximum value of A and B."""
    def FMin(self, A: float | Future[float], B: float | Future[float]) -> Future[float]:
        """Returns the minimum value of A and B."""
    def FMod(self, Dividend: float | Future[float], Divisor: float | Future[float]) -> Future[UKismetMathLibrary_FMod_Result]:
        """Returns the number of times Divisor will go into Dividend and the remainder."""
    def FTrunc(self, A: float | Future[float]) -> Future[int]:
        """Rounds A towards zero, truncating the fractional part."""
    def FTrunc64(self, A: float | Future[float]) -> Future[int]:
        """Rounds A towards zero, truncating the fractional part."""
    def FWrap(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> Future[float]:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min."""
    def FindClosestPointOnLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> Future[FVector]:
        """Finds the closest point on an infinite line to a given point."""
    def FindClosestPointOnSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> Future[FVector]:
        """Finds the closest point on a line segment to a given point."""
    def FindLookAtRotation(self, Start: FVector_in, Target: FVector_in) -> Future[FRotator]:
        """Finds a rotation for an object at Start location to point at Target location."""
    def FixedTurn(self, InCurrent: float | Future[float], InDesired: float | Future[float], InDeltaRate: float | Future[float]) -> Future[float]:
        """Returns a new rotation component value: InCurrent moved towards InDesired the shorter way by no more than InDeltaRate, in degrees."""
    def Fraction(self, A: float | Future[float]) -> Future[float]:
        """Returns the fractional part of a float: A - floor(A)."""
    def FromDays(self, Days: float | Future[float]) -> Future[FTimespan]:
        """Returns a time span that represents the specified number of days."""
    def FromHours(self, Hours: float | Future[float]) -> Future[FTimespan]:
        """Returns a time span that represents the specified number of hours."""
    def FromMilliseconds(self, Milliseconds: float | Future[float]) -> Future[FTimespan]:
        """Returns a time span that represents the specified number of milliseconds."""
    def FromMinutes(self, Minutes: float | Future[float]) -> Future[FTimespan]:
        """Returns a time span that represents the specified number of minutes."""
    def FromSeconds(self, Seconds: float | Future[float]) -> Future[FTimespan]:
        """Returns a time span that represents the specified number of seconds."""
    def FromUnixTimestamp(self, UnixTime: int | Future[int]) -> Future[FDateTime]:
        """Returns a date and time from a unix timestamp (seconds since 1970-01-01 00:00 UTC)."""
    def GetAzimuthAndElevation(self, InDirection: FVector_in, ReferenceFrame: FTransform_in) -> Future[UKismetMathLibrary_GetAzimuthAndElevation_Result]:
        """Breaks a direction vector apart into azimuth (yaw) and elevation (pitch) rotation values given in degrees, in the frame of the transform."""
    def GetDate(self, A: FDateTime_in) -> Future[FDateTime]:
        """Returns the date component of A."""
    def GetDay(self, A: FDateTime_in) -> Future[int]:
        """Returns the day component, 1 to 31 of A."""
    def GetDayOfYear(self, A: FDateTime_in) -> Future[int]:
        """Returns the day of the year, 1 to 366 of A."""
    def GetDays(self, A: FTimespan_in) -> Future[int]:
        """Returns the days component of A."""
    def GetDirectionUnitVector(self, From: FVector_in, To: FVector_in) -> Future[FVector]:
        """Finds the unit direction vector from one position to another; a zero vector when they coincide."""
    def GetDuration(self, A: FTimespan_in) -> Future[FTimespan]:
        """Returns the absolute value of A."""
    def GetForwardVector(self, InRot: FRotator_in) -> Future[FVector]:
        """Rotates the world forward vector by the given rotation."""
    def GetHour(self, A: FDateTime_in) -> Future[int]:
        """Returns the hour of the day, 0 to 23 of A."""
    def GetHour12(self, A: FDateTime_in) -> Future[int]:
        """Returns the hour of the day in 12-hour format, 1 to 12 of A."""
    def GetHours(self, A: FTimespan_in) -> Future[int]:
        """Returns the hours component of A."""
    def GetMaxElement(self, A: FVector_in) -> Future[float]:
        """Finds the maximum element (X, Y or Z) of a vector."""
    def GetMillisecond(self, A: FDateTime_in) -> Future[int]:
        """Returns the millisecond component, 0 to 999 of A."""
    def GetMilliseconds(self, A: FTimespan_in) -> Future[int]:
        """Returns the milliseconds component of A."""
    def GetMinElement(self, A: FVector_in) -> Future[float]:
        """Finds the minimum element (X, Y or Z) of a vector."""
    def GetMinute(self, A: FDateTime_in) -> Future[int]:
        """Returns the minute component, 0 to 59 of A."""
    def GetMinutes(self, A: FTimespan_in) -> Future[int]:
        """Returns the minutes component of A."""
    def GetMonth(self, A: FDateTime_in) -> Future[int]:
        """Returns the month component, 1 to 12 of A."""
    def GetPI(self) -> Future[float]:
        """Returns the value of pi."""
    def GetPointDistanceToLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> Future[float]:
        """Finds the distance from a point to the infinite line."""
    def GetPointDistanceToSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> Future[float]:
        """Finds the distance of Point to the closest point on the line segment."""
    def GetReflectionVector(self, Direction: FVector_in, SurfaceNormal: FVector_in) -> Future[FVector]:
        """Given a direction vector and a surface normal, returns the vector reflected across the surface normal."""
    def GetRightVector(self, InRot: FRotator_in) -> Future[FVector]:
        """Rotates the world right vector by the given rotation."""
    def GetSecond(self, A: FDateTime_in) -> Future[int]:
        """Returns the second component, 0 to 59 of A."""
    def GetSeconds(self, A: FTimespan_in) -> Future[int]:
        """Returns the seconds component of A."""
    def GetTAU(self) -> Future[float]:
        """Returns the value of tau (= 2 * pi)."""
    def GetTimeOfDay(self, A: FDateTime_in) -> Future[FTimespan]:
        """Returns the time elapsed since midnight of A."""
    def GetTotalDays(self, A: FTimespan_in) -> Future[float]:
        """Returns the total number of days of A."""
    def GetTotalHours(self, A: FTimespan_in) -> Future[float]:
        """Returns the total number of hours of A."""
    def GetTotalMilliseconds(self, A: FTimespan_in) -> Future[float]:
        """Returns the total number of milliseconds of A."""
    def GetTotalMinutes(self, A: FTimespan_in) -> Future[float]:
        """Returns the total number of minutes of A."""
    def GetTotalSeconds(self, A: FTimespan_in) -> Future[float]:
        """Returns the total number of seconds of A."""
    def GetUpVector(self, InRot: FRotator_in) -> Future[FVector]:
        """Rotates the world up vector by the given rotation."""
    def GetVectorArrayAverage(self, Vectors: Sequence[FVector_in] | Future[list[FVector]]) -> Future[FVector]:
        """Finds the average of an array of vectors; zero for an empty one."""
    def GetYawPitchFromVector(self, InVec: FVector_in) -> Future[UKismetMathLibrary_GetYawPitchFromVector_Result]:
        """Breaks a direction vector apart into Yaw and Pitch rotation values given in degrees."""
    def GetYear(self, A: FDateTime_in) -> Future[int]:
        """Returns the year component of A."""
    def GreaterEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A >= B."""
    def GreaterGreater_VectorRotator(self, A: FVector_in, B: FRotator_in) -> Future[FVector]:
        """Returns the result of rotating a vector by a rotator."""
    def Greater_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A > B."""
    def Greater_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A > B."""
    def Greater_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A > B."""
    def Greater_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A > B."""
    def Greater_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A > B."""
    def Greater_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A > B."""
    def HSVToRGB(self, H: float | Future[float], S: float | Future[float], V: float | Future[float], A: float | Future[float] = 1.0) -> Future[FLinearColor]:
        """Makes a colour from individual colour components (HSV space; hue is [0..360], saturation and value are [0..1])."""
    def Hypotenuse(self, Width: float | Future[float], Height: float | Future[float]) -> Future[float]:
        """Returns the hypotenuse of a right-angled triangle given the width and height."""
    def InRange_FloatFloat(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> Future[bool]:
        """Returns true if value is between Min and Max."""
    def InRange_Int64Int64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> Future[bool]:
        """Returns true if value is between Min and Max."""
    def InRange_IntInt(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> Future[bool]:
        """Returns true if value is between Min and Max."""
    def InverseTransformDirection(self, T: FTransform_in, Direction: FVector_in) -> Future[FVector]:
        """Transforms a direction vector by the inverse of the given transform: does not change its length."""
    def InverseTransformLocation(self, T: FTransform_in, Location: FVector_in) -> Future[FVector]:
        """Transforms a position by the inverse of the given transform: from world to local space."""
    def InverseTransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> Future[FRotator]:
        """Transforms a rotator by the inverse of the given transform."""
    def InvertTransform(self, T: FTransform_in) -> Future[FTransform]:
        """Returns the inverse of the given transform."""
    def IsLeapYear(self, Year: int | Future[int]) -> Future[bool]:
        """Returns whether given year is a leap year."""
    def IsPointInBox(self, Point: FVector_in, BoxOrigin: FVector_in, BoxExtent: FVector_in) -> Future[bool]:
        """Determines whether the given point is in an axis-aligned box."""
    def IsPointInBox_Box(self, Point: FVector_in, Box: FBox_in) -> Future[bool]:
        """Determines whether the given point is in a box."""
    def Lerp(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float]) -> Future[float]:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def LessEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A <= B."""
    def LessEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A <= B."""
    def LessEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A <= B."""
    def LessEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A <= B."""
    def LessEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A <= B."""
    def LessEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A <= B."""
    def LessLess_VectorRotator(self, A: FVector_in, B: FRotator_in) -> Future[FVector]:
        """Returns result of vector A rotated by the inverse of rotator B."""
    def Less_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A < B."""
    def Less_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A < B."""
    def Less_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A < B."""
    def Less_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A < B."""
    def Less_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A < B."""
    def Less_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A < B."""
    def LinearColorLerp(self, A: FLinearColor_in, B: FLinearColor_in, Alpha: float | Future[float]) -> Future[FLinearColor]:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def LinearColor_Black(self) -> Future[FLinearColor]:
        """Black linear colour."""
    def LinearColor_Blue(self) -> Future[FLinearColor]:
        """Blue linear colour."""
    def LinearColor_Desaturated(self, InColor: FLinearColor_in, InDesaturation: float | Future[float]) -> Future[FLinearColor]:
        """Returns a desaturated colour, with 0 meaning no desaturation and 1 == full desaturation."""
    def LinearColor_Distance(self, C1: FLinearColor_in, C2: FLinearColor_in) -> Future[float]:
        """Euclidean distance between two colour points."""
    def LinearColor_GetLuminance(self, InColor: FLinearColor_in) -> Future[float]:
        """Computes the luminance of a linear colour."""
    def LinearColor_Gray(self) -> Future[FLinearColor]:
        """Gray linear colour."""
    def LinearColor_Green(self) -> Future[FLinearColor]:
        """Green linear colour."""
    def LinearColor_Quantize(self, InColor: FLinearColor_in) -> Future[FColor]:
        """Quantizes the linear colour and returns the result as an 8-bit colour."""
    def LinearColor_Red(self) -> Future[FLinearColor]:
        """Red linear colour."""
    def LinearColor_Transparent(self) -> Future[FLinearColor]:
        """Transparent linear colour: black with alpha 0."""
    def LinearColor_White(self) -> Future[FLinearColor]:
        """White linear colour."""
    def LinearColor_Yellow(self) -> Future[FLinearColor]:
        """Yellow linear colour."""
    def Log(self, A: float | Future[float], Base: float | Future[float] = 1.0) -> Future[float]:
        """Returns log of A base B (if B^R == A, returns R)."""
    def Loge(self, A: float | Future[float]) -> Future[float]:
        """Returns natural log of A (if e^R == A, returns R)."""
    def MakeBox(self, Min: FVector_in, Max: FVector_in) -> Future[FBox]:
        """Makes an FBox from Min and Max and sets IsValid to true."""
    def MakeBoxWithOrigin(self, Origin: FVector_in, Extent: FVector_in) -> Future[FBox]:
        """Makes an FBox from Origin and Extent and sets IsValid to true."""
    def MakeColor(self, R: float | Future[float], G: float | Future[float], B: float | Future[float], A: float | Future[float] = 1.0) -> Future[FLinearColor]:
        """Makes a colour from individual colour components (RGB space, linear)."""
    def MakeDateTime(self, Year: int | Future[int], Month: int | Future[int], Day: int | Future[int], Hour: int | Future[int] = 0, Minute: int | Future[int] = 0, Second: int | Future[int] = 0, Millisecond: int | Future[int] = 0) -> Future[FDateTime]:
        """Makes a date and time; the zero one, with a warning in the log, where the parts are out of range."""
    def MakePulsatingValue(self, InCurrentTime: float | Future[float], InPulsesPerSecond: float | Future[float] = 1.0, InPhase: float | Future[float] = 0.0) -> Future[float]:
        """Makes a value that pulsates between 0 and 1 with the current time (seconds); a phase of 0 starts at 0.5 and rises."""
    def MakeRandomStream(self, InitialSeed: int | Future[int]) -> Future[FRandomStream]:
        """Makes a SRand-based random number generator."""
    def MakeRelativeTransform(self, A: FTransform_in, RelativeTo: FTransform_in) -> Future[FTransform]:
        """Returns the given transform, converted to be relative to the given parent transform."""
    def MakeRotFromX(self, X: FVector_in) -> Future[FRotator]:
        """Builds a rotator given only a XAxis."""
    def MakeRotFromXY(self, X: FVector_in, Y: FVector_in) -> Future[FRotator]:
        """Builds a rotator with the given X axis and Y axis."""
    def MakeRotFromXZ(self, X: FVector_in, Z: FVector_in) -> Future[FRotator]:
        """Builds a rotator with the given X axis and Z axis."""
    def MakeRotFromY(self, Y: FVector_in) -> Future[FRotator]:
        """Builds a rotator given only a YAxis."""
    def MakeRotFromZ(self, Z: FVector_in) -> Future[FRotator]:
        """Builds a rotator given only a ZAxis."""
    def MakeRotationFromAxes(self, Forward: FVector_in, Right: FVector_in, Up: FVector_in) -> Future[FRotator]:
        """Builds a reference frame from three axes."""
    def MakeRotator(self, Roll: float | Future[float], Pitch: float | Future[float], Yaw: float | Future[float]) -> Future[FRotator]:
        """Makes a rotator {Roll, Pitch, Yaw} from rotation values supplied in degrees."""
    def MakeTimespan(self, Days: int | Future[int], Hours: int | Future[int], Minutes: int | Future[int], Seconds: int | Future[int], Milliseconds: int | Future[int]) -> Future[FTimespan]:
        """Makes a time span."""
    def MakeTransform(self, Location: FVector_in, Rotation: FRotator_in, Scale: FVector_in = ...) -> Future[FTransform]:
        """Makes a transform from location, rotation and scale."""
    def MakeVector(self, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> Future[FVector]:
        """Makes a vector {X, Y, Z}."""
    def MakeVector2D(self, X: float | Future[float], Y: float | Future[float]) -> Future[FVector2D]:
        """Makes a 2D vector {X, Y}."""
    def MapRangeClamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> Future[float]:
        """Returns Value mapped from one range into another where the Value is clamped to the input range."""
    def MapRangeUnclamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> Future[float]:
        """Returns Value mapped from one range into another."""
    def Max(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the maximum value of A and B."""
    def MaxInt64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the maximum value of A and B."""
    def MaxOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> Future[UKismetMathLibrary_MaxOfFloatArray_Result]:
        """Returns max of all array entries and the index at which it was found."""
    def MaxOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> Future[UKismetMathLibrary_MaxOfIntArray_Result]:
        """Returns max of all array entries and the index at which it was found."""
    def Min(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the minimum value of A and B."""
    def MinInt64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Returns the minimum value of A and B."""
    def MinOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> Future[UKismetMathLibrary_MinOfFloatArray_Result]:
        """Returns min of all array entries and the index at which it was found."""
    def MinOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> Future[UKismetMathLibrary_MinOfIntArray_Result]:
        """Returns min of all array entries and the index at which it was found."""
    def MirrorVectorByNormal(self, InVect: FVector_in, InNormal: FVector_in) -> Future[FVector]:
        """Mirrors a vector by a normal (a unit vector)."""
    def MultiplyByPi(self, Value: float | Future[float]) -> Future[float]:
        """Multiplies the input value by pi."""
    def MultiplyMultiply_FloatFloat(self, Base: float | Future[float], Exp: float | Future[float]) -> Future[float]:
        """Power (Base to the Exp-th power)."""
    def Multiply_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Multiplication (A * B), modulo 256."""
    def Multiply_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[float]:
        """Multiplication (A * B)."""
    def Multiply_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Multiplication (A * B); wraps on overflow."""
    def Multiply_IntFloat(self, A: int | Future[int], B: float | Future[float]) -> Future[float]:
        """Multiplication (A * B)."""
    def Multiply_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Multiplication (A * B); wraps on overflow."""
    def Multiply_LinearColorFloat(self, A: FLinearColor_in, B: float | Future[float]) -> Future[FLinearColor]:
        """Element-wise multiplication of a linear colour by a float."""
    def Multiply_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> Future[FLinearColor]:
        """Element-wise multiplication of two linear colours."""
    def Multiply_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> Future[FQuat]:
        """Gets the result of multiplying two quaternions (A * B)."""
    def Multiply_RotatorFloat(self, A: FRotator_in, B: float | Future[float]) -> Future[FRotator]:
        """Returns rotator representing rotator A scaled by B."""
    def Multiply_RotatorInt(self, A: FRotator_in, B: int | Future[int]) -> Future[FRotator]:
        """Returns rotator representing rotator A scaled by B."""
    def Multiply_TimespanFloat(self, A: FTimespan_in, Scalar: float | Future[float]) -> Future[FTimespan]:
        """Scalar multiplication (A * s)."""
    def Multiply_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float]) -> Future[FVector2D]:
        """Scales A by B."""
    def Multiply_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> Future[FVector2D]:
        """Element-wise multiplication."""
    def Multiply_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> Future[FVector]:
        """Scales vector A by B."""
    def Multiply_VectorInt(self, A: FVector_in, B: int | Future[int]) -> Future[FVector]:
        """Scales vector A by B."""
    def Multiply_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[FVector]:
        """Element-wise vector multiplication (Result = {A.x*B.x, A.y*B.y, A.z*B.z})."""
    def NearlyEqual_FloatFloat(self, A: float | Future[float], B: float | Future[float], ErrorTolerance: float | Future[float] = 1e-06) -> Future[bool]:
        """Returns true if A and B differ by no more than the tolerance."""
    def NearlyEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in, LocationTolerance: float | Future[float] = 0.0001, RotationTolerance: float | Future[float] = 0.0001, Scale3DTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if transform A is nearly equal to B."""
    def NegateRotator(self, A: FRotator_in) -> Future[FRotator]:
        """Negates a rotator: the inverse rotation."""
    def NegateVector(self, A: FVector_in) -> Future[FVector]:
        """Negate a vector."""
    def Normal(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> Future[FVector]:
        """Gets a normalized unit vector; a zero vector when the length of A squared is smaller than the tolerance."""
    def Normal2D(self, A: FVector2D_in, Tolerance: float | Future[float] = 0.0) -> Future[FVector2D]:
        """Gets a normalized copy of the vector; zero when its squared length is below the tolerance."""
    def NormalizeAxis(self, Angle: float | Future[float]) -> Future[float]:
        """Clamps an angle to the range of [-180, 180]."""
    def NormalizeToRange(self, Value: float | Future[float], RangeMin: float | Future[float], RangeMax: float | Future[float]) -> Future[float]:
        """Returns Value normalized to the given range."""
    def NormalizedDeltaRotator(self, A: FRotator_in, B: FRotator_in) -> Future[FRotator]:
        """Normalized A-B: each angle between -180 and 180."""
    def NotEqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[bool]:
        """Returns true if vector A is not equal to vector B (A != B) exactly."""
    def NotEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> Future[bool]:
        """Returns true if the values are not equal (A != B)."""
    def NotEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A != B."""
    def NotEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[bool]:
        """Returns true if A != B."""
    def NotEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> Future[bool]:
        """Returns true if A != B exactly."""
    def NotEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A != B."""
    def NotEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[bool]:
        """Returns true if A != B."""
    def NotEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> Future[bool]:
        """Returns true if A and B are not equal (A != B)."""
    def NotEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> Future[bool]:
        """Returns true if A and B are not the same object."""
    def NotEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if quaternion A is not equal to quaternion B (A != B) within a specified error tolerance."""
    def NotEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if rotator A is not equal to rotator B (A != B) within a specified error tolerance."""
    def NotEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[bool]:
        """Returns true if A != B."""
    def NotEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Returns true if vector A is not equal to vector B (A != B) within a specified error tolerance."""
    def Not_Int(self, A: int | Future[int]) -> Future[int]:
        """Bitwise NOT (~A)."""
    def Not_Int64(self, A: int | Future[int]) -> Future[int]:
        """Bitwise NOT (~A)."""
    def Not_PreBool(self, A: bool | Future[bool]) -> Future[bool]:
        """Returns the logical complement of the Boolean value (NOT A)."""
    def Now(self) -> Future[FDateTime]:
        """Returns the local date and time on this computer."""
    def Or_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise OR (A | B)."""
    def Or_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise OR (A | B)."""
    def Percent_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Modulo (A % B)."""
    def Percent_FloatFloat(self, A: float | Future[float], B: float | Future[float] = 1.0) -> Future[float]:
        """Modulo (A % B), with the sign of A."""
    def Percent_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Modulo (A % B)."""
    def Percent_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Modulo (A % B)."""
    def ProjectPointOnToPlane(self, Point: FVector_in, PlaneBase: FVector_in, PlaneNormal: FVector_in) -> Future[FVector]:
        """Projects a point onto a plane defined by a point on the plane and a plane normal."""
    def ProjectVectorOnToPlane(self, V: FVector_in, PlaneNormal: FVector_in) -> Future[FVector]:
        """Projects a vector onto a plane defined by a normalized vector (PlaneNormal)."""
    def ProjectVectorOnToVector(self, V: FVector_in, Target: FVector_in) -> Future[FVector]:
        """Projects one vector (V) onto another (Target) and returns the projected vector."""
    def Quat_AngularDistance(self, A: FQuat_in, B: FQuat_in) -> Future[float]:
        """Finds the angular distance/difference between two rotation quaternions, in radians."""
    def Quat_Euler(self, Q: FQuat_in) -> Future[FVector]:
        """Converts a quaternion into floating-point Euler angles (roll, pitch, yaw in degrees)."""
    def Quat_GetAngle(self, Q: FQuat_in) -> Future[float]:
        """Gets the angle of this quaternion, in radians."""
    def Quat_GetAxisX(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the X direction after it has been rotated by this quaternion."""
    def Quat_GetAxisY(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the Y direction after it has been rotated by this quaternion."""
    def Quat_GetAxisZ(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the Z direction after it has been rotated by this quaternion."""
    def Quat_GetRotationAxis(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the axis of rotation; forward for the identity."""
    def Quat_Identity(self) -> Future[FQuat]:
        """Identity quaternion constant."""
    def Quat_Inversed(self, Q: FQuat_in) -> Future[FQuat]:
        """Returns an inversed copy of this quaternion."""
    def Quat_IsFinite(self, Q: FQuat_in) -> Future[bool]:
        """Determines if all the values are finite (not NaN nor Inf) in this quaternion."""
    def Quat_IsIdentity(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Checks whether this quaternion is an identity quaternion, within a tolerance."""
    def Quat_IsNormalized(self, Q: FQuat_in) -> Future[bool]:
        """Returns true if this quaternion is normalized."""
    def Quat_MakeFromEuler(self, Euler: FVector_in) -> Future[FQuat]:
        """Converts a vector of floating-point Euler angles (roll, pitch, yaw in degrees) into a quaternion."""
    def Quat_Normalized(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> Future[FQuat]:
        """Gets a normalized copy of this quaternion; the identity if it is too small."""
    def Quat_RotateVector(self, Q: FQuat_in, V: FVector_in) -> Future[FVector]:
        """Rotates a vector by this quaternion."""
    def Quat_Rotator(self, Q: FQuat_in) -> Future[FRotator]:
        """Converts a quaternion to a rotator."""
    def Quat_Size(self, Q: FQuat_in) -> Future[float]:
        """Gets the length of this quaternion."""
    def Quat_SizeSquared(self, Q: FQuat_in) -> Future[float]:
        """Gets the length squared of this quaternion."""
    def Quat_Slerp(self, A: FQuat_in, B: FQuat_in, Alpha: float | Future[float]) -> Future[FQuat]:
        """Spherical interpolation between quaternions."""
    def Quat_UnrotateVector(self, Q: FQuat_in, V: FVector_in) -> Future[FVector]:
        """Rotates a vector by the inverse of this quaternion."""
    def Quat_VectorForward(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the forward direction (X axis) after it has been rotated by this quaternion."""
    def Quat_VectorRight(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the right direction (Y axis) after it has been rotated by this quaternion."""
    def Quat_VectorUp(self, Q: FQuat_in) -> Future[FVector]:
        """Gets the up direction (Z axis) after it has been rotated by this quaternion."""
    def REase(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> Future[FRotator]:
        """Eases between A and B using a specified easing function."""
    def RGBToHSV(self, InColor: FLinearColor_in) -> Future[UKismetMathLibrary_RGBToHSV_Result]:
        """Breaks apart a colour into individual HSV components (as well as alpha) (hue is [0..360], saturation and value are [0..1])."""
    def RInterpTo(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FRotator]:
        """Tries to reach Target rotation based on Current rotation, giving a nice smooth feeling when rotating to Target rotation."""
    def RInterpTo_Constant(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FRotator]:
        """Tries to reach Target rotation at a constant rate, in degrees per second for each angle."""
    def RLerp(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool]) -> Future[FRotator]:
        """Linearly interpolates between A and B based on Alpha; optionally the shorter way round."""
    def RadiansToDegrees(self, A: float | Future[float]) -> Future[float]:
        """Returns degrees value based on the input radians."""
    def RandomBool(self) -> Future[bool]:
        """Returns a uniformly distributed random bool."""
    def RandomBoolFromStream(self, Stream: FRandomStream_in) -> Future[bool]:
        """Returns a random bool."""
    def RandomBoolWithWeight(self, Weight: float | Future[float]) -> Future[bool]:
        """Gets a random chance with the specified weight: 0 is never, 1 is always."""
    def RandomBoolWithWeightFromStream(self, RandomStream: FRandomStream_in, Weight: float | Future[float]) -> Future[bool]:
        """Gets a random chance with the specified weight: 0 is never, 1 is always."""
    def RandomFloat(self) -> Future[float]:
        """Returns a random float between 0 and 1."""
    def RandomFloatFromStream(self, Stream: FRandomStream_in) -> Future[float]:
        """Returns a random float between 0 and 1."""
    def RandomFloatInRange(self, Min: float | Future[float], Max: float | Future[float]) -> Future[float]:
        """Generates a random number between Min and Max."""
    def RandomFloatInRangeFromStream(self, Stream: FRandomStream_in, Min: float | Future[float], Max: float | Future[float]) -> Future[float]:
        """Generates a random number between Min and Max."""
    def RandomInteger(self, Max: int | Future[int]) -> Future[int]:
        """Returns a uniformly distributed random number between 0 and Max - 1; 0 when Max is 0 or less."""
    def RandomIntegerFromStream(self, Stream: FRandomStream_in, Max: int | Future[int]) -> Future[int]:
        """Returns a uniformly distributed random number between 0 and Max - 1."""
    def RandomIntegerInRange(self, Min: int | Future[int], Max: int | Future[int]) -> Future[int]:
        """Returns a random integer between Min and Max (>= Min and <= Max)."""
    def RandomIntegerInRangeFromStream(self, Stream: FRandomStream_in, Min: int | Future[int], Max: int | Future[int]) -> Future[int]:
        """Returns a random integer between Min and Max (>= Min and <= Max)."""
    def RandomPointInBoundingBox(self, Center: FVector_in, HalfSize: FVector_in) -> Future[FVector]:
        """Returns a random point within the specified bounding box."""
    def RandomRotator(self, bRoll: bool | Future[bool] = False) -> Future[FRotator]:
        """Generates a random rotation, with optional random roll."""
    def RandomRotatorFromStream(self, Stream: FRandomStream_in, bRoll: bool | Future[bool]) -> Future[FRotator]:
        """Creates a random rotation, with optional random roll."""
    def RandomUnitVector(self) -> Future[FVector]:
        """Returns a random vector with length of 1, uniformly distributed over the sphere."""
    def RandomUnitVectorFromStream(self, Stream: FRandomStream_in) -> Future[FVector]:
        """Returns a random vector with length of 1.0."""
    def ResetRandomStream(self, Stream: FRandomStream_in) -> Future[None]:
        """Resets a random stream to its initial seed."""
    def RotateAngleAxis(self, InVect: FVector_in, AngleDeg: float | Future[float], Axis: FVector_in) -> Future[FVector]:
        """Returns result of vector InVect rotated by AngleDeg degrees around Axis (a unit vector)."""
    def RotatorFromAxisAndAngle(self, Axis: FVector_in, Angle: float | Future[float]) -> Future[FRotator]:
        """Creates a rotation from an axis and an angle in degrees."""
    def Round(self, A: float | Future[float]) -> Future[int]:
        """Rounds A to the nearest integer."""
    def Round64(self, A: float | Future[float]) -> Future[int]:
        """Rounds A to the nearest integer."""
    def SafeDivide(self, A: float | Future[float], B: float | Future[float]) -> Future[float]:
        """Scalar division (A / B) where a zero divisor gives 0."""
    def SeedRandomStream(self, Stream: FRandomStream_in) -> Future[UKismetMathLibrary_SeedRandomStream_Result]:
        """Creates a new random seed for a random stream."""
    def SelectClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass], bSelectA: bool | Future[bool]) -> Future[UClass]:
        """If bSelectA is true, A is returned, otherwise B is."""
    def SelectColor(self, A: FLinearColor_in, B: FLinearColor_in, bPickA: bool | Future[bool]) -> Future[FLinearColor]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectFloat(self, A: float | Future[float], B: float | Future[float], bPickA: bool | Future[bool]) -> Future[float]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectInt(self, A: int | Future[int], B: int | Future[int], bPickA: bool | Future[bool]) -> Future[int]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject], bSelectA: bool | Future[bool]) -> Future[UObject]:
        """If bSelectA is true, A is returned, otherwise B is."""
    def SelectRotator(self, A: FRotator_in, B: FRotator_in, bPickA: bool | Future[bool]) -> Future[FRotator]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectString(self, A: str | Future[str], B: str | Future[str], bPickA: bool | Future[bool]) -> Future[str]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectTransform(self, A: FTransform_in, B: FTransform_in, bPickA: bool | Future[bool]) -> Future[FTransform]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectVector(self, A: FVector_in, B: FVector_in, bPickA: bool | Future[bool]) -> Future[FVector]:
        """If bPickA is true, A is returned, otherwise B is."""
    def SetRandomStreamSeed(self, Stream: FRandomStream_in, NewSeed: int | Future[int]) -> Future[UKismetMathLibrary_SetRandomStreamSeed_Result]:
        """Sets the seed of a random stream to a specific number."""
    def SignOfFloat(self, A: float | Future[float]) -> Future[float]:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def SignOfInteger(self, A: int | Future[int]) -> Future[int]:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def SignOfInteger64(self, A: int | Future[int]) -> Future[int]:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def Sin(self, A: float | Future[float]) -> Future[float]:
        """Returns the sine of A (expects Radians)."""
    def Sqrt(self, A: float | Future[float]) -> Future[float]:
        """Returns the square root of A; 0 with a warning in the log when A is negative."""
    def Square(self, A: float | Future[float]) -> Future[float]:
        """Returns square of A (A * A)."""
    def Subtract_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Subtraction (A - B), modulo 256."""
    def Subtract_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> Future[FTimespan]:
        """Subtraction (A - B)."""
    def Subtract_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> Future[FDateTime]:
        """Subtraction (A - B)."""
    def Subtract_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> Future[float]:
        """Subtraction (A - B)."""
    def Subtract_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Subtraction (A - B); wraps on overflow."""
    def Subtract_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> Future[int]:
        """Subtraction (A - B); wraps on overflow."""
    def Subtract_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> Future[FLinearColor]:
        """Element-wise subtraction of two linear colours."""
    def Subtract_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> Future[FQuat]:
        """Returns subtraction of B from A, element by element."""
    def Subtract_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> Future[FTimespan]:
        """Subtraction (A - B)."""
    def Subtract_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> Future[FVector2D]:
        """Subtraction (A - B)."""
    def Subtract_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> Future[FVector]:
        """Subtracts a float from each component of a vector."""
    def Subtract_VectorInt(self, A: FVector_in, B: int | Future[int]) -> Future[FVector]:
        """Subtracts an integer from each component of a vector."""
    def Subtract_VectorVector(self, A: FVector_in, B: FVector_in) -> Future[FVector]:
        """Vector subtraction."""
    def TEase(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> Future[FTransform]:
        """Eases between A and B using a specified easing function."""
    def TInterpTo(self, Current: FTransform_in, Target: FTransform_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FTransform]:
        """Tries to reach a target transform."""
    def TLerp(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], InterpMode: ELerpInterpolationMode_in = ELerpInterpolationMode.QuatInterp) -> Future[FTransform]:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def Tan(self, A: float | Future[float]) -> Future[float]:
        """Returns the tan of A (expects Radians)."""
    def TimespanRatio(self, A: FTimespan_in, B: FTimespan_in) -> Future[float]:
        """Returns the ratio between two time spans (A / B), handles zero values."""
    def TimespanZeroValue(self) -> Future[FTimespan]:
        """Returns a zero time span value."""
    def ToUnixTimestamp(self, Time: FDateTime_in) -> Future[int]:
        """Returns this date and time as the number of seconds since the unix epoch."""
    def Today(self) -> Future[FDateTime]:
        """Returns the local date on this computer."""
    def TransformDirection(self, T: FTransform_in, Direction: FVector_in) -> Future[FVector]:
        """Transforms a direction vector by the given transform: does not change its length."""
    def TransformLocation(self, T: FTransform_in, Location: FVector_in) -> Future[FVector]:
        """Transforms a position by the given transform, scale counted."""
    def TransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> Future[FRotator]:
        """Transforms a rotator by the given transform."""
    def Transform_Determinant(self, Transform: FTransform_in) -> Future[float]:
        """Computes the determinant of the transform converted to a matrix: the product of the scale."""
    def UtcNow(self) -> Future[FDateTime]:
        """Returns the UTC date and time on this computer."""
    def VEase(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> Future[FVector]:
        """Eases between A and B using a specified easing function."""
    def VInterpTo(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FVector]:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a position."""
    def VInterpTo_Constant(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FVector]:
        """Tries to reach Target at a constant rate."""
    def VLerp(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float]) -> Future[FVector]:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def VSize(self, A: FVector_in) -> Future[float]:
        """Returns the length of the vector."""
    def VSize2D(self, A: FVector2D_in) -> Future[float]:
        """Returns the length of a 2D vector."""
    def VSize2DSquared(self, A: FVector2D_in) -> Future[float]:
        """Returns the squared length of a 2D vector."""
    def VSizeSquared(self, A: FVector_in) -> Future[float]:
        """Returns the squared length of the vector."""
    def VSizeXY(self, A: FVector_in) -> Future[float]:
        """Returns the length of the vector's XY components."""
    def VSizeXYSquared(self, A: FVector_in) -> Future[float]:
        """Returns the squared length of the vector's XY components."""
    def Vector2DInterpTo(self, Current: FVector2D_in, Target: FVector2D_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> Future[FVector2D]:
        """Tries to reach Target based on distance from Current position."""
    def Vector_Assign(self, A: FVector_in, InVector: FVector_in) -> Future[UKismetMathLibrary_Vector_Assign_Result]:
        """Assign the values of the supplied vector."""
    def Vector_Backward(self) -> Future[FVector]:
        """3D vector backward: (-1, 0, 0)."""
    def Vector_ClampSizeMax(self, A: FVector_in, Max: float | Future[float]) -> Future[FVector]:
        """Creates a copy of this vector with its maximum magnitude clamped to Max."""
    def Vector_Distance(self, V1: FVector_in, V2: FVector_in) -> Future[float]:
        """Distance between two points."""
    def Vector_Distance2D(self, V1: FVector_in, V2: FVector_in) -> Future[float]:
        """Distance between two points in the XY plane (ignoring Z)."""
    def Vector_Distance2DSquared(self, V1: FVector_in, V2: FVector_in) -> Future[float]:
        """Squared distance between two points in the XY plane (ignoring Z)."""
    def Vector_DistanceSquared(self, V1: FVector_in, V2: FVector_in) -> Future[float]:
        """Squared distance between two points."""
    def Vector_Down(self) -> Future[FVector]:
        """3D vector down: (0, 0, -1)."""
    def Vector_Forward(self) -> Future[FVector]:
        """3D vector forward: (1, 0, 0)."""
    def Vector_GetAbs(self, A: FVector_in) -> Future[FVector]:
        """Gets a copy of this vector with absolute value of each component."""
    def Vector_IsNAN(self, A: FVector_in) -> Future[bool]:
        """Determines if any component is not a number (NAN)."""
    def Vector_IsNearlyZero(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Checks whether the vector is near to zero within a specified tolerance."""
    def Vector_IsNormal(self, A: FVector_in) -> Future[bool]:
        """Determines if vector is normalized / unit (length 1)."""
    def Vector_IsUniform(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Checks whether all components of the vector are the same, within a tolerance."""
    def Vector_IsUnit(self, A: FVector_in, SquaredLenthTolerance: float | Future[float] = 0.0001) -> Future[bool]:
        """Determines if vector is normalized / unit (length 1) within specified squared tolerance."""
    def Vector_IsZero(self, A: FVector_in) -> Future[bool]:
        """Checks whether all components of the vector are exactly zero."""
    def Vector_Left(self) -> Future[FVector]:
        """3D vector left: (0, -1, 0)."""
    def Vector_Normal2D(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> Future[FVector]:
        """Gets a normalized unit vector of the XY components, with Z zero."""
    def Vector_One(self) -> Future[FVector]:
        """3D vector (1, 1, 1)."""
    def Vector_Reciprocal(self, A: FVector_in) -> Future[FVector]:
        """Gets the reciprocal of this vector, avoiding division by zero: zero components give 3.4e38."""
    def Vector_Right(self) -> Future[FVector]:
        """3D vector right: (0, 1, 0)."""
    def Vector_Set(self, A: FVector_in, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> Future[UKismetMathLibrary_Vector_Set_Result]:
        """Set the values of the vector directly."""
    def Vector_Up(self) -> Future[FVector]:
        """3D vector up: (0, 0, 1)."""
    def Vector_Zero(self) -> Future[FVector]:
        """3D vector (0, 0, 0)."""
    def Wrap(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> Future[int]:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min."""
    def Xor_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise XOR (A ^ B)."""
    def Xor_IntInt(self, A: int | Future[int], B: int | Future[int]) -> Future[int]:
        """Bitwise XOR (A ^ B)."""

class UKismetMathLibrary_send(UBlueprintFunctionLibrary_send):
    """UKismetMathLibrary under ``send_``: no function answers."""
    def Abs(self, A: float | Future[float]) -> None:
        """Returns the absolute (positive) value of A."""
    def Abs_Int(self, A: int | Future[int]) -> None:
        """Returns the absolute (positive) value of A."""
    def Abs_Int64(self, A: int | Future[int]) -> None:
        """Returns the absolute (positive) value of A."""
    def Acos(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arccos) of A (result is in Radians)."""
    def Add_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Addition (A + B), modulo 256."""
    def Add_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> None:
        """Addition (A + B)."""
    def Add_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> None:
        """Addition (A + B)."""
    def Add_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Addition (A + B); wraps on overflow."""
    def Add_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Addition (A + B); wraps on overflow."""
    def Add_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> None:
        """Element-wise addition of two linear colours."""
    def Add_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> None:
        """Returns addition of vector B to vector A, element by element."""
    def Add_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Addition (A + B)."""
    def Add_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> None:
        """Addition (A + B)."""
    def Add_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> None:
        """Adds a float to each component of a vector."""
    def Add_VectorInt(self, A: FVector_in, B: int | Future[int]) -> None:
        """Adds an integer to each component of a vector."""
    def Add_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Vector addition."""
    def And_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise AND (A & B)."""
    def And_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise AND (A & B)."""
    def Asin(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arcsin) of A (result is in Radians)."""
    def Atan(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arctan) of A (result is in Radians)."""
    def Atan2(self, Y: float | Future[float], X: float | Future[float]) -> None:
        """Returns the inverse tan (atan2) of Y/X (result is in Radians)."""
    def BMax(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the maximum value of A and B."""
    def BMin(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the minimum value of A and B."""
    def BooleanAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns the logical AND of two values (A AND B)."""
    def BooleanNAND(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns the logical NAND of two values (A NAND B)."""
    def BooleanNOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns the logical Not OR of two values (A NOR B)."""
    def BooleanOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns the logical OR of two values (A OR B)."""
    def BooleanXOR(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns the logical eXclusive OR of two values (A XOR B)."""
    def Box_Intersects(self, A: FBox_in, B: FBox_in) -> None:
        """Checks whether bounding box A intersects bounding box B."""
    def Box_IsPointInside(self, Box: FBox_in, Point: FVector_in) -> None:
        """Checks whether the given location is inside this box."""
    def BreakColor(self, InColor: FLinearColor_in) -> None:
        """Breaks apart a colour into individual RGB components (as well as alpha)."""
    def BreakDateTime(self, InDateTime: FDateTime_in) -> None:
        """Breaks a date and time into its components."""
    def BreakRandomStream(self, InRandomStream: FRandomStream_in) -> None:
        """Breaks out a random number generator into its initial seed."""
    def BreakRotIntoAxes(self, InRot: FRotator_in) -> None:
        """Breaks apart a rotator into its component axes."""
    def BreakRotator(self, InRot: FRotator_in) -> None:
        """Breaks apart a rotator into {Roll, Pitch, Yaw} angles in degrees."""
    def BreakTimespan(self, InTimespan: FTimespan_in) -> None:
        """Breaks a time span into its components."""
    def BreakTransform(self, InTransform: FTransform_in) -> None:
        """Breaks apart a transform into location, rotation and scale."""
    def BreakVector(self, InVec: FVector_in) -> None:
        """Breaks a vector apart into X, Y, Z."""
    def BreakVector2D(self, InVec: FVector2D_in) -> None:
        """Breaks a 2D vector apart into X, Y."""
    def CInterpTo(self, Current: FLinearColor_in, Target: FLinearColor_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach a target colour."""
    def Clamp(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> None:
        """Returns Value clamped to be between Min and Max (inclusive)."""
    def ClampAngle(self, AngleDegrees: float | Future[float], MinAngleDegrees: float | Future[float], MaxAngleDegrees: float | Future[float]) -> None:
        """Clamps an arbitrary angle to be between the given angles."""
    def ClampAxis(self, Angle: float | Future[float]) -> None:
        """Clamps an angle to the range of [0, 360]."""
    def ClampInt64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> None:
        """Returns Value clamped to be between Min and Max (inclusive)."""
    def ClampVectorSize(self, A: FVector_in, Min: float | Future[float], Max: float | Future[float]) -> None:
        """Creates a copy of this vector with its magnitude clamped between Min and Max."""
    def ClassIsChildOf(self, TestClass: type[UObject] | UClass | str | Future[UClass], ParentClass: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Determines if a class is a child of another class."""
    def ComposeRotators(self, A: FRotator_in, B: FRotator_in) -> None:
        """Combines 2 rotations to give you the resulting rotation of first applying A, then B."""
    def ComposeTransforms(self, A: FTransform_in, B: FTransform_in) -> None:
        """Composes two transforms in order: A * B."""
    def Conv_BoolToByte(self, InBool: bool | Future[bool]) -> None:
        """Converts a bool to a byte."""
    def Conv_BoolToDouble(self, InBool: bool | Future[bool]) -> None:
        """Converts a bool to a float (0.0 or 1.0)."""
    def Conv_BoolToInt(self, InBool: bool | Future[bool]) -> None:
        """Converts a bool to an int."""
    def Conv_ByteToDouble(self, InByte: int | Future[int]) -> None:
        """Converts a byte to a float."""
    def Conv_ByteToInt(self, InByte: int | Future[int]) -> None:
        """Converts a byte to an integer."""
    def Conv_ByteToInt64(self, InByte: int | Future[int]) -> None:
        """Converts a byte to a 64 bit integer."""
    def Conv_ColorToLinearColor(self, InColor: FColor_in) -> None:
        """Converts an sRGB-encoded colour to a linear one."""
    def Conv_DoubleToFloat(self, InDouble: float | Future[float]) -> None:
        """Converts a double-precision number to a single-precision one."""
    def Conv_DoubleToInt64(self, InDouble: float | Future[float]) -> None:
        """Converts a float to a 64 bit integer."""
    def Conv_DoubleToLinearColor(self, InDouble: float | Future[float]) -> None:
        """Converts a float to a linear colour: grey, opaque."""
    def Conv_DoubleToVector(self, InDouble: float | Future[float]) -> None:
        """Converts a float to a vector, with the same value in every component."""
    def Conv_DoubleToVector2D(self, InDouble: float | Future[float]) -> None:
        """Converts a float to a 2D vector, with the same value in both components."""
    def Conv_FloatToDouble(self, InFloat: float | Future[float]) -> None:
        """Converts a single-precision number to a double-precision one."""
    def Conv_Int64ToDouble(self, InInt: int | Future[int]) -> None:
        """Converts a 64 bit integer to a float."""
    def Conv_Int64ToInt(self, InInt: int | Future[int]) -> None:
        """Converts a 64 bit integer to a 32 bit integer (the low 32 bits)."""
    def Conv_IntPointToVector2D(self, InIntPoint: FIntPoint_in) -> None:
        """Converts an integer point to a 2D vector."""
    def Conv_IntToBool(self, InInt: int | Future[int]) -> None:
        """Converts an int to a bool."""
    def Conv_IntToByte(self, InInt: int | Future[int]) -> None:
        """Converts an integer to a byte (if the integer is too large, returns the low 8 bits)."""
    def Conv_IntToDouble(self, InInt: int | Future[int]) -> None:
        """Converts an integer to a float."""
    def Conv_IntToInt64(self, InInt: int | Future[int]) -> None:
        """Converts an integer to a 64 bit integer."""
    def Conv_IntToVector(self, InInt: int | Future[int]) -> None:
        """Converts an integer to a vector, with the same value in every component."""
    def Conv_IntVectorToVector(self, InIntVector: FIntVector_in) -> None:
        """Converts an integer vector to a vector."""
    def Conv_LinearColorToColor(self, InLinearColor: FLinearColor_in, InUseSRGB: bool | Future[bool] = True) -> None:
        """Converts a linear colour to a byte colour, with or without the sRGB gamma."""
    def Conv_LinearColorToVector(self, InLinearColor: FLinearColor_in) -> None:
        """Converts a linear colour to a vector (alpha is dropped)."""
    def Conv_RotatorToQuaternion(self, InRot: FRotator_in) -> None:
        """Converts a rotator to a quaternion."""
    def Conv_RotatorToTransform(self, InRotator: FRotator_in) -> None:
        """Converts a rotator to a transform."""
    def Conv_RotatorToVector(self, InRot: FRotator_in) -> None:
        """Gets the X direction vector after this rotation."""
    def Conv_Vector2DToVector(self, InVector2D: FVector2D_in, Z: float | Future[float] = 0.0) -> None:
        """Converts a 2D vector to a vector."""
    def Conv_VectorToLinearColor(self, InVec: FVector_in) -> None:
        """Converts a vector to a linear colour, opaque."""
    def Conv_VectorToQuaternion(self, InVec: FVector_in) -> None:
        """Returns the rotation that points along a direction."""
    def Conv_VectorToRotator(self, InVec: FVector_in) -> None:
        """Returns the rotation that points along a direction: yaw and pitch, no roll."""
    def Conv_VectorToTransform(self, InLocation: FVector_in) -> None:
        """Converts a vector to a transform: a translation."""
    def Conv_VectorToVector2D(self, InVector: FVector_in) -> None:
        """Converts a vector to a 2D vector by dropping Z."""
    def Cos(self, A: float | Future[float]) -> None:
        """Returns the cosine of A (expects Radians)."""
    def CreateVectorFromYawPitch(self, Yaw: float | Future[float], Pitch: float | Future[float], Length: float | Future[float] = 1.0) -> None:
        """Creates a directional vector from rotation values {Yaw, Pitch} supplied in degrees with specified Length."""
    def CrossProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> None:
        """Returns the cross product of two 2D vectors."""
    def Cross_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Returns the cross product of two 3D vectors."""
    def DaysInMonth(self, Year: int | Future[int], Month: int | Future[int]) -> None:
        """Returns the number of days in the given year and month; 0 with a warning for a month out of range."""
    def DaysInYear(self, Year: int | Future[int]) -> None:
        """Returns the number of days in the given year."""
    def DegAcos(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arccos) of A (result is in Degrees)."""
    def DegAsin(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arcsin) of A (result is in Degrees)."""
    def DegAtan(self, A: float | Future[float]) -> None:
        """Returns the inverse function (arctan) of A (result is in Degrees)."""
    def DegAtan2(self, Y: float | Future[float], X: float | Future[float]) -> None:
        """Returns the inverse tan (atan2) of Y/X (result is in Degrees)."""
    def DegCos(self, A: float | Future[float]) -> None:
        """Returns the cos of A (expects Degrees)."""
    def DegSin(self, A: float | Future[float]) -> None:
        """Returns the sin of A (expects Degrees)."""
    def DegTan(self, A: float | Future[float]) -> None:
        """Returns the tan of A (expects Degrees)."""
    def DegreesToRadians(self, A: float | Future[float]) -> None:
        """Returns radians value based on the input degrees."""
    def Distance2D(self, V1: FVector2D_in, V2: FVector2D_in) -> None:
        """Distance between two 2D points."""
    def Divide_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Division (A / B)."""
    def Divide_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> None:
        """Division (A / B)."""
    def Divide_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Division (A / B), towards zero."""
    def Divide_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Division (A / B), towards zero."""
    def Divide_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float] = 1.0) -> None:
        """Division by a float."""
    def Divide_VectorFloat(self, A: FVector_in, B: float | Future[float] = 1.0) -> None:
        """Vector divide by a float."""
    def Divide_VectorInt(self, A: FVector_in, B: int | Future[int] = 1) -> None:
        """Vector divide by an integer."""
    def Divide_VectorVector(self, A: FVector_in, B: FVector_in = ...) -> None:
        """Element-wise vector division (Result = {A.x/B.x, A.y/B.y, A.z/B.z})."""
    def DotProduct2D(self, A: FVector2D_in, B: FVector2D_in) -> None:
        """Returns the dot product of two 2D vectors."""
    def Dot_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Returns the dot product of two 3D vectors."""
    def Ease(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> None:
        """Eases between A and B using a specified easing function."""
    def EqualEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns true if the values are equal (A == B)."""
    def EqualEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A == B."""
    def EqualEqual_ClassClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Returns true if A and B are the same class."""
    def EqualEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A == B."""
    def EqualEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A == B exactly."""
    def EqualEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A == B."""
    def EqualEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A == B."""
    def EqualEqual_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> None:
        """Returns true if linear colour A is equal to linear colour B exactly."""
    def EqualEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Returns true if A and B are equal (A == B); names compare without case."""
    def EqualEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> None:
        """Returns true if A and B are the same object."""
    def EqualEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if quaternion A is equal to quaternion B (A == B) within a specified error tolerance; Q and -Q are the same rotation."""
    def EqualEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if rotator A is equal to rotator B (A == B) within a specified error tolerance; whole turns do not count."""
    def EqualEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A == B."""
    def EqualEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in) -> None:
        """Returns true if transform A is equal to transform B, within a small tolerance."""
    def EqualEqual_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if A equals B within a specified error tolerance."""
    def EqualEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if vector A is equal to vector B (A == B) within a specified error tolerance."""
    def EqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Returns true if vector A is equal to vector B (A == B) exactly."""
    def Exp(self, A: float | Future[float]) -> None:
        """Returns exponential (e) to the power A (e^A)."""
    def FCeil(self, A: float | Future[float]) -> None:
        """Rounds A up towards positive infinity."""
    def FCeil64(self, A: float | Future[float]) -> None:
        """Rounds A up towards positive infinity."""
    def FClamp(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> None:
        """Returns Value clamped between Min and Max (inclusive)."""
    def FFloor(self, A: float | Future[float]) -> None:
        """Rounds A down towards negative infinity."""
    def FFloor64(self, A: float | Future[float]) -> None:
        """Rounds A down towards negative infinity."""
    def FInterpEaseInOut(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float], Exponent: float | Future[float]) -> None:
        """Interpolates between A and B, applying an ease in/out function."""
    def FInterpTo(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a position."""
    def FInterpTo_Constant(self, Current: float | Future[float], Target: float | Future[float], DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target at a constant rate."""
    def FMax(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns the maximum value of A and B."""
    def FMin(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns the minimum value of A and B."""
    def FMod(self, Dividend: float | Future[float], Divisor: float | Future[float]) -> None:
        """Returns the number of times Divisor will go into Dividend and the remainder."""
    def FTrunc(self, A: float | Future[float]) -> None:
        """Rounds A towards zero, truncating the fractional part."""
    def FTrunc64(self, A: float | Future[float]) -> None:
        """Rounds A towards zero, truncating the fractional part."""
    def FWrap(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float]) -> None:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min."""
    def FindClosestPointOnLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> None:
        """Finds the closest point on an infinite line to a given point."""
    def FindClosestPointOnSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> None:
        """Finds the closest point on a line segment to a given point."""
    def FindLookAtRotation(self, Start: FVector_in, Target: FVector_in) -> None:
        """Finds a rotation for an object at Start location to point at Target location."""
    def FixedTurn(self, InCurrent: float | Future[float], InDesired: float | Future[float], InDeltaRate: float | Future[float]) -> None:
        """Returns a new rotation component value: InCurrent moved towards InDesired the shorter way by no more than InDeltaRate, in degrees."""
    def Fraction(self, A: float | Future[float]) -> None:
        """Returns the fractional part of a float: A - floor(A)."""
    def FromDays(self, Days: float | Future[float]) -> None:
        """Returns a time span that represents the specified number of days."""
    def FromHours(self, Hours: float | Future[float]) -> None:
        """Returns a time span that represents the specified number of hours."""
    def FromMilliseconds(self, Milliseconds: float | Future[float]) -> None:
        """Returns a time span that represents the specified number of milliseconds."""
    def FromMinutes(self, Minutes: float | Future[float]) -> None:
        """Returns a time span that represents the specified number of minutes."""
    def FromSeconds(self, Seconds: float | Future[float]) -> None:
        """Returns a time span that represents the specified number of seconds."""
    def FromUnixTimestamp(self, UnixTime: int | Future[int]) -> None:
        """Returns a date and time from a unix timestamp (seconds since 1970-01-01 00:00 UTC)."""
    def GetAzimuthAndElevation(self, InDirection: FVector_in, ReferenceFrame: FTransform_in) -> None:
        """Breaks a direction vector apart into azimuth (yaw) and elevation (pitch) rotation values given in degrees, in the frame of the transform."""
    def GetDate(self, A: FDateTime_in) -> None:
        """Returns the date component of A."""
    def GetDay(self, A: FDateTime_in) -> None:
        """Returns the day component, 1 to 31 of A."""
    def GetDayOfYear(self, A: FDateTime_in) -> None:
        """Returns the day of the year, 1 to 366 of A."""
    def GetDays(self, A: FTimespan_in) -> None:
        """Returns the days component of A."""
    def GetDirectionUnitVector(self, From: FVector_in, To: FVector_in) -> None:
        """Finds the unit direction vector from one position to another; a zero vector when they coincide."""
    def GetDuration(self, A: FTimespan_in) -> None:
        """Returns the absolute value of A."""
    def GetForwardVector(self, InRot: FRotator_in) -> None:
        """Rotates the world forward vector by the given rotation."""
    def GetHour(self, A: FDateTime_in) -> None:
        """Returns the hour of the day, 0 to 23 of A."""
    def GetHour12(self, A: FDateTime_in) -> None:
        """Returns the hour of the day in 12-hour format, 1 to 12 of A."""
    def GetHours(self, A: FTimespan_in) -> None:
        """Returns the hours component of A."""
    def GetMaxElement(self, A: FVector_in) -> None:
        """Finds the maximum element (X, Y or Z) of a vector."""
    def GetMillisecond(self, A: FDateTime_in) -> None:
        """Returns the millisecond component, 0 to 999 of A."""
    def GetMilliseconds(self, A: FTimespan_in) -> None:
        """Returns the milliseconds component of A."""
    def GetMinElement(self, A: FVector_in) -> None:
        """Finds the minimum element (X, Y or Z) of a vector."""
    def GetMinute(self, A: FDateTime_in) -> None:
        """Returns the minute component, 0 to 59 of A."""
    def GetMinutes(self, A: FTimespan_in) -> None:
        """Returns the minutes component of A."""
    def GetMonth(self, A: FDateTime_in) -> None:
        """Returns the month component, 1 to 12 of A."""
    def GetPI(self) -> None:
        """Returns the value of pi."""
    def GetPointDistanceToLine(self, Point: FVector_in, LineOrigin: FVector_in, LineDirection: FVector_in) -> None:
        """Finds the distance from a point to the infinite line."""
    def GetPointDistanceToSegment(self, Point: FVector_in, SegmentStart: FVector_in, SegmentEnd: FVector_in) -> None:
        """Finds the distance of Point to the closest point on the line segment."""
    def GetReflectionVector(self, Direction: FVector_in, SurfaceNormal: FVector_in) -> None:
        """Given a direction vector and a surface normal, returns the vector reflected across the surface normal."""
    def GetRightVector(self, InRot: FRotator_in) -> None:
        """Rotates the world right vector by the given rotation."""
    def GetSecond(self, A: FDateTime_in) -> None:
        """Returns the second component, 0 to 59 of A."""
    def GetSeconds(self, A: FTimespan_in) -> None:
        """Returns the seconds component of A."""
    def GetTAU(self) -> None:
        """Returns the value of tau (= 2 * pi)."""
    def GetTimeOfDay(self, A: FDateTime_in) -> None:
        """Returns the time elapsed since midnight of A."""
    def GetTotalDays(self, A: FTimespan_in) -> None:
        """Returns the total number of days of A."""
    def GetTotalHours(self, A: FTimespan_in) -> None:
        """Returns the total number of hours of A."""
    def GetTotalMilliseconds(self, A: FTimespan_in) -> None:
        """Returns the total number of milliseconds of A."""
    def GetTotalMinutes(self, A: FTimespan_in) -> None:
        """Returns the total number of minutes of A."""
    def GetTotalSeconds(self, A: FTimespan_in) -> None:
        """Returns the total number of seconds of A."""
    def GetUpVector(self, InRot: FRotator_in) -> None:
        """Rotates the world up vector by the given rotation."""
    def GetVectorArrayAverage(self, Vectors: Sequence[FVector_in] | Future[list[FVector]]) -> None:
        """Finds the average of an array of vectors; zero for an empty one."""
    def GetYawPitchFromVector(self, InVec: FVector_in) -> None:
        """Breaks a direction vector apart into Yaw and Pitch rotation values given in degrees."""
    def GetYear(self, A: FDateTime_in) -> None:
        """Returns the year component of A."""
    def GreaterEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A >= B."""
    def GreaterEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A >= B."""
    def GreaterEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A >= B."""
    def GreaterEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A >= B."""
    def GreaterEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A >= B."""
    def GreaterEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A >= B."""
    def GreaterGreater_VectorRotator(self, A: FVector_in, B: FRotator_in) -> None:
        """Returns the result of rotating a vector by a rotator."""
    def Greater_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A > B."""
    def Greater_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A > B."""
    def Greater_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A > B."""
    def Greater_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A > B."""
    def Greater_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A > B."""
    def Greater_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A > B."""
    def HSVToRGB(self, H: float | Future[float], S: float | Future[float], V: float | Future[float], A: float | Future[float] = 1.0) -> None:
        """Makes a colour from individual colour components (HSV space; hue is [0..360], saturation and value are [0..1])."""
    def Hypotenuse(self, Width: float | Future[float], Height: float | Future[float]) -> None:
        """Returns the hypotenuse of a right-angled triangle given the width and height."""
    def InRange_FloatFloat(self, Value: float | Future[float], Min: float | Future[float], Max: float | Future[float], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> None:
        """Returns true if value is between Min and Max."""
    def InRange_Int64Int64(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> None:
        """Returns true if value is between Min and Max."""
    def InRange_IntInt(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int], InclusiveMin: bool | Future[bool] = True, InclusiveMax: bool | Future[bool] = True) -> None:
        """Returns true if value is between Min and Max."""
    def InverseTransformDirection(self, T: FTransform_in, Direction: FVector_in) -> None:
        """Transforms a direction vector by the inverse of the given transform: does not change its length."""
    def InverseTransformLocation(self, T: FTransform_in, Location: FVector_in) -> None:
        """Transforms a position by the inverse of the given transform: from world to local space."""
    def InverseTransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> None:
        """Transforms a rotator by the inverse of the given transform."""
    def InvertTransform(self, T: FTransform_in) -> None:
        """Returns the inverse of the given transform."""
    def IsLeapYear(self, Year: int | Future[int]) -> None:
        """Returns whether given year is a leap year."""
    def IsPointInBox(self, Point: FVector_in, BoxOrigin: FVector_in, BoxExtent: FVector_in) -> None:
        """Determines whether the given point is in an axis-aligned box."""
    def IsPointInBox_Box(self, Point: FVector_in, Box: FBox_in) -> None:
        """Determines whether the given point is in a box."""
    def Lerp(self, A: float | Future[float], B: float | Future[float], Alpha: float | Future[float]) -> None:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def LessEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A <= B."""
    def LessEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A <= B."""
    def LessEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A <= B."""
    def LessEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A <= B."""
    def LessEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A <= B."""
    def LessEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A <= B."""
    def LessLess_VectorRotator(self, A: FVector_in, B: FRotator_in) -> None:
        """Returns result of vector A rotated by the inverse of rotator B."""
    def Less_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A < B."""
    def Less_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A < B."""
    def Less_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A < B."""
    def Less_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A < B."""
    def Less_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A < B."""
    def Less_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A < B."""
    def LinearColorLerp(self, A: FLinearColor_in, B: FLinearColor_in, Alpha: float | Future[float]) -> None:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def LinearColor_Black(self) -> None:
        """Black linear colour."""
    def LinearColor_Blue(self) -> None:
        """Blue linear colour."""
    def LinearColor_Desaturated(self, InColor: FLinearColor_in, InDesaturation: float | Future[float]) -> None:
        """Returns a desaturated colour, with 0 meaning no desaturation and 1 == full desaturation."""
    def LinearColor_Distance(self, C1: FLinearColor_in, C2: FLinearColor_in) -> None:
        """Euclidean distance between two colour points."""
    def LinearColor_GetLuminance(self, InColor: FLinearColor_in) -> None:
        """Computes the luminance of a linear colour."""
    def LinearColor_Gray(self) -> None:
        """Gray linear colour."""
    def LinearColor_Green(self) -> None:
        """Green linear colour."""
    def LinearColor_Quantize(self, InColor: FLinearColor_in) -> None:
        """Quantizes the linear colour and returns the result as an 8-bit colour."""
    def LinearColor_Red(self) -> None:
        """Red linear colour."""
    def LinearColor_Transparent(self) -> None:
        """Transparent linear colour: black with alpha 0."""
    def LinearColor_White(self) -> None:
        """White linear colour."""
    def LinearColor_Yellow(self) -> None:
        """Yellow linear colour."""
    def Log(self, A: float | Future[float], Base: float | Future[float] = 1.0) -> None:
        """Returns log of A base B (if B^R == A, returns R)."""
    def Loge(self, A: float | Future[float]) -> None:
        """Returns natural log of A (if e^R == A, returns R)."""
    def MakeBox(self, Min: FVector_in, Max: FVector_in) -> None:
        """Makes an FBox from Min and Max and sets IsValid to true."""
    def MakeBoxWithOrigin(self, Origin: FVector_in, Extent: FVector_in) -> None:
        """Makes an FBox from Origin and Extent and sets IsValid to true."""
    def MakeColor(self, R: float | Future[float], G: float | Future[float], B: float | Future[float], A: float | Future[float] = 1.0) -> None:
        """Makes a colour from individual colour components (RGB space, linear)."""
    def MakeDateTime(self, Year: int | Future[int], Month: int | Future[int], Day: int | Future[int], Hour: int | Future[int] = 0, Minute: int | Future[int] = 0, Second: int | Future[int] = 0, Millisecond: int | Future[int] = 0) -> None:
        """Makes a date and time; the zero one, with a warning in the log, where the parts are out of range."""
    def MakePulsatingValue(self, InCurrentTime: float | Future[float], InPulsesPerSecond: float | Future[float] = 1.0, InPhase: float | Future[float] = 0.0) -> None:
        """Makes a value that pulsates between 0 and 1 with the current time (seconds); a phase of 0 starts at 0.5 and rises."""
    def MakeRandomStream(self, InitialSeed: int | Future[int]) -> None:
        """Makes a SRand-based random number generator."""
    def MakeRelativeTransform(self, A: FTransform_in, RelativeTo: FTransform_in) -> None:
        """Returns the given transform, converted to be relative to the given parent transform."""
    def MakeRotFromX(self, X: FVector_in) -> None:
        """Builds a rotator given only a XAxis."""
    def MakeRotFromXY(self, X: FVector_in, Y: FVector_in) -> None:
        """Builds a rotator with the given X axis and Y axis."""
    def MakeRotFromXZ(self, X: FVector_in, Z: FVector_in) -> None:
        """Builds a rotator with the given X axis and Z axis."""
    def MakeRotFromY(self, Y: FVector_in) -> None:
        """Builds a rotator given only a YAxis."""
    def MakeRotFromZ(self, Z: FVector_in) -> None:
        """Builds a rotator given only a ZAxis."""
    def MakeRotationFromAxes(self, Forward: FVector_in, Right: FVector_in, Up: FVector_in) -> None:
        """Builds a reference frame from three axes."""
    def MakeRotator(self, Roll: float | Future[float], Pitch: float | Future[float], Yaw: float | Future[float]) -> None:
        """Makes a rotator {Roll, Pitch, Yaw} from rotation values supplied in degrees."""
    def MakeTimespan(self, Days: int | Future[int], Hours: int | Future[int], Minutes: int | Future[int], Seconds: int | Future[int], Milliseconds: int | Future[int]) -> None:
        """Makes a time span."""
    def MakeTransform(self, Location: FVector_in, Rotation: FRotator_in, Scale: FVector_in = ...) -> None:
        """Makes a transform from location, rotation and scale."""
    def MakeVector(self, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> None:
        """Makes a vector {X, Y, Z}."""
    def MakeVector2D(self, X: float | Future[float], Y: float | Future[float]) -> None:
        """Makes a 2D vector {X, Y}."""
    def MapRangeClamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> None:
        """Returns Value mapped from one range into another where the Value is clamped to the input range."""
    def MapRangeUnclamped(self, Value: float | Future[float], InRangeA: float | Future[float], InRangeB: float | Future[float], OutRangeA: float | Future[float], OutRangeB: float | Future[float]) -> None:
        """Returns Value mapped from one range into another."""
    def Max(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the maximum value of A and B."""
    def MaxInt64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the maximum value of A and B."""
    def MaxOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> None:
        """Returns max of all array entries and the index at which it was found."""
    def MaxOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> None:
        """Returns max of all array entries and the index at which it was found."""
    def Min(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the minimum value of A and B."""
    def MinInt64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns the minimum value of A and B."""
    def MinOfFloatArray(self, FloatArray: Sequence[float | Future[float]] | Buffer | Future[list[float]]) -> None:
        """Returns min of all array entries and the index at which it was found."""
    def MinOfIntArray(self, IntArray: Sequence[int | Future[int]] | Buffer | Future[list[int]]) -> None:
        """Returns min of all array entries and the index at which it was found."""
    def MirrorVectorByNormal(self, InVect: FVector_in, InNormal: FVector_in) -> None:
        """Mirrors a vector by a normal (a unit vector)."""
    def MultiplyByPi(self, Value: float | Future[float]) -> None:
        """Multiplies the input value by pi."""
    def MultiplyMultiply_FloatFloat(self, Base: float | Future[float], Exp: float | Future[float]) -> None:
        """Power (Base to the Exp-th power)."""
    def Multiply_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Multiplication (A * B), modulo 256."""
    def Multiply_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Multiplication (A * B)."""
    def Multiply_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Multiplication (A * B); wraps on overflow."""
    def Multiply_IntFloat(self, A: int | Future[int], B: float | Future[float]) -> None:
        """Multiplication (A * B)."""
    def Multiply_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Multiplication (A * B); wraps on overflow."""
    def Multiply_LinearColorFloat(self, A: FLinearColor_in, B: float | Future[float]) -> None:
        """Element-wise multiplication of a linear colour by a float."""
    def Multiply_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> None:
        """Element-wise multiplication of two linear colours."""
    def Multiply_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> None:
        """Gets the result of multiplying two quaternions (A * B)."""
    def Multiply_RotatorFloat(self, A: FRotator_in, B: float | Future[float]) -> None:
        """Returns rotator representing rotator A scaled by B."""
    def Multiply_RotatorInt(self, A: FRotator_in, B: int | Future[int]) -> None:
        """Returns rotator representing rotator A scaled by B."""
    def Multiply_TimespanFloat(self, A: FTimespan_in, Scalar: float | Future[float]) -> None:
        """Scalar multiplication (A * s)."""
    def Multiply_Vector2DFloat(self, A: FVector2D_in, B: float | Future[float]) -> None:
        """Scales A by B."""
    def Multiply_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> None:
        """Element-wise multiplication."""
    def Multiply_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> None:
        """Scales vector A by B."""
    def Multiply_VectorInt(self, A: FVector_in, B: int | Future[int]) -> None:
        """Scales vector A by B."""
    def Multiply_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Element-wise vector multiplication (Result = {A.x*B.x, A.y*B.y, A.z*B.z})."""
    def NearlyEqual_FloatFloat(self, A: float | Future[float], B: float | Future[float], ErrorTolerance: float | Future[float] = 1e-06) -> None:
        """Returns true if A and B differ by no more than the tolerance."""
    def NearlyEqual_TransformTransform(self, A: FTransform_in, B: FTransform_in, LocationTolerance: float | Future[float] = 0.0001, RotationTolerance: float | Future[float] = 0.0001, Scale3DTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if transform A is nearly equal to B."""
    def NegateRotator(self, A: FRotator_in) -> None:
        """Negates a rotator: the inverse rotation."""
    def NegateVector(self, A: FVector_in) -> None:
        """Negate a vector."""
    def Normal(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Gets a normalized unit vector; a zero vector when the length of A squared is smaller than the tolerance."""
    def Normal2D(self, A: FVector2D_in, Tolerance: float | Future[float] = 0.0) -> None:
        """Gets a normalized copy of the vector; zero when its squared length is below the tolerance."""
    def NormalizeAxis(self, Angle: float | Future[float]) -> None:
        """Clamps an angle to the range of [-180, 180]."""
    def NormalizeToRange(self, Value: float | Future[float], RangeMin: float | Future[float], RangeMax: float | Future[float]) -> None:
        """Returns Value normalized to the given range."""
    def NormalizedDeltaRotator(self, A: FRotator_in, B: FRotator_in) -> None:
        """Normalized A-B: each angle between -180 and 180."""
    def NotEqualExactly_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Returns true if vector A is not equal to vector B (A != B) exactly."""
    def NotEqual_BoolBool(self, A: bool | Future[bool], B: bool | Future[bool]) -> None:
        """Returns true if the values are not equal (A != B)."""
    def NotEqual_ByteByte(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A != B."""
    def NotEqual_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Returns true if A != B."""
    def NotEqual_DoubleDouble(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Returns true if A != B exactly."""
    def NotEqual_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A != B."""
    def NotEqual_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Returns true if A != B."""
    def NotEqual_NameName(self, A: str | Future[str], B: str | Future[str]) -> None:
        """Returns true if A and B are not equal (A != B)."""
    def NotEqual_ObjectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject]) -> None:
        """Returns true if A and B are not the same object."""
    def NotEqual_QuatQuat(self, A: FQuat_in, B: FQuat_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if quaternion A is not equal to quaternion B (A != B) within a specified error tolerance."""
    def NotEqual_RotatorRotator(self, A: FRotator_in, B: FRotator_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if rotator A is not equal to rotator B (A != B) within a specified error tolerance."""
    def NotEqual_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns true if A != B."""
    def NotEqual_VectorVector(self, A: FVector_in, B: FVector_in, ErrorTolerance: float | Future[float] = 0.0001) -> None:
        """Returns true if vector A is not equal to vector B (A != B) within a specified error tolerance."""
    def Not_Int(self, A: int | Future[int]) -> None:
        """Bitwise NOT (~A)."""
    def Not_Int64(self, A: int | Future[int]) -> None:
        """Bitwise NOT (~A)."""
    def Not_PreBool(self, A: bool | Future[bool]) -> None:
        """Returns the logical complement of the Boolean value (NOT A)."""
    def Now(self) -> None:
        """Returns the local date and time on this computer."""
    def Or_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise OR (A | B)."""
    def Or_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise OR (A | B)."""
    def Percent_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Modulo (A % B)."""
    def Percent_FloatFloat(self, A: float | Future[float], B: float | Future[float] = 1.0) -> None:
        """Modulo (A % B), with the sign of A."""
    def Percent_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Modulo (A % B)."""
    def Percent_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Modulo (A % B)."""
    def ProjectPointOnToPlane(self, Point: FVector_in, PlaneBase: FVector_in, PlaneNormal: FVector_in) -> None:
        """Projects a point onto a plane defined by a point on the plane and a plane normal."""
    def ProjectVectorOnToPlane(self, V: FVector_in, PlaneNormal: FVector_in) -> None:
        """Projects a vector onto a plane defined by a normalized vector (PlaneNormal)."""
    def ProjectVectorOnToVector(self, V: FVector_in, Target: FVector_in) -> None:
        """Projects one vector (V) onto another (Target) and returns the projected vector."""
    def Quat_AngularDistance(self, A: FQuat_in, B: FQuat_in) -> None:
        """Finds the angular distance/difference between two rotation quaternions, in radians."""
    def Quat_Euler(self, Q: FQuat_in) -> None:
        """Converts a quaternion into floating-point Euler angles (roll, pitch, yaw in degrees)."""
    def Quat_GetAngle(self, Q: FQuat_in) -> None:
        """Gets the angle of this quaternion, in radians."""
    def Quat_GetAxisX(self, Q: FQuat_in) -> None:
        """Gets the X direction after it has been rotated by this quaternion."""
    def Quat_GetAxisY(self, Q: FQuat_in) -> None:
        """Gets the Y direction after it has been rotated by this quaternion."""
    def Quat_GetAxisZ(self, Q: FQuat_in) -> None:
        """Gets the Z direction after it has been rotated by this quaternion."""
    def Quat_GetRotationAxis(self, Q: FQuat_in) -> None:
        """Gets the axis of rotation; forward for the identity."""
    def Quat_Identity(self) -> None:
        """Identity quaternion constant."""
    def Quat_Inversed(self, Q: FQuat_in) -> None:
        """Returns an inversed copy of this quaternion."""
    def Quat_IsFinite(self, Q: FQuat_in) -> None:
        """Determines if all the values are finite (not NaN nor Inf) in this quaternion."""
    def Quat_IsIdentity(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Checks whether this quaternion is an identity quaternion, within a tolerance."""
    def Quat_IsNormalized(self, Q: FQuat_in) -> None:
        """Returns true if this quaternion is normalized."""
    def Quat_MakeFromEuler(self, Euler: FVector_in) -> None:
        """Converts a vector of floating-point Euler angles (roll, pitch, yaw in degrees) into a quaternion."""
    def Quat_Normalized(self, Q: FQuat_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Gets a normalized copy of this quaternion; the identity if it is too small."""
    def Quat_RotateVector(self, Q: FQuat_in, V: FVector_in) -> None:
        """Rotates a vector by this quaternion."""
    def Quat_Rotator(self, Q: FQuat_in) -> None:
        """Converts a quaternion to a rotator."""
    def Quat_Size(self, Q: FQuat_in) -> None:
        """Gets the length of this quaternion."""
    def Quat_SizeSquared(self, Q: FQuat_in) -> None:
        """Gets the length squared of this quaternion."""
    def Quat_Slerp(self, A: FQuat_in, B: FQuat_in, Alpha: float | Future[float]) -> None:
        """Spherical interpolation between quaternions."""
    def Quat_UnrotateVector(self, Q: FQuat_in, V: FVector_in) -> None:
        """Rotates a vector by the inverse of this quaternion."""
    def Quat_VectorForward(self, Q: FQuat_in) -> None:
        """Gets the forward direction (X axis) after it has been rotated by this quaternion."""
    def Quat_VectorRight(self, Q: FQuat_in) -> None:
        """Gets the right direction (Y axis) after it has been rotated by this quaternion."""
    def Quat_VectorUp(self, Q: FQuat_in) -> None:
        """Gets the up direction (Z axis) after it has been rotated by this quaternion."""
    def REase(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> None:
        """Eases between A and B using a specified easing function."""
    def RGBToHSV(self, InColor: FLinearColor_in) -> None:
        """Breaks apart a colour into individual HSV components (as well as alpha) (hue is [0..360], saturation and value are [0..1])."""
    def RInterpTo(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target rotation based on Current rotation, giving a nice smooth feeling when rotating to Target rotation."""
    def RInterpTo_Constant(self, Current: FRotator_in, Target: FRotator_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target rotation at a constant rate, in degrees per second for each angle."""
    def RLerp(self, A: FRotator_in, B: FRotator_in, Alpha: float | Future[float], bShortestPath: bool | Future[bool]) -> None:
        """Linearly interpolates between A and B based on Alpha; optionally the shorter way round."""
    def RadiansToDegrees(self, A: float | Future[float]) -> None:
        """Returns degrees value based on the input radians."""
    def RandomBool(self) -> None:
        """Returns a uniformly distributed random bool."""
    def RandomBoolFromStream(self, Stream: FRandomStream_in) -> None:
        """Returns a random bool."""
    def RandomBoolWithWeight(self, Weight: float | Future[float]) -> None:
        """Gets a random chance with the specified weight: 0 is never, 1 is always."""
    def RandomBoolWithWeightFromStream(self, RandomStream: FRandomStream_in, Weight: float | Future[float]) -> None:
        """Gets a random chance with the specified weight: 0 is never, 1 is always."""
    def RandomFloat(self) -> None:
        """Returns a random float between 0 and 1."""
    def RandomFloatFromStream(self, Stream: FRandomStream_in) -> None:
        """Returns a random float between 0 and 1."""
    def RandomFloatInRange(self, Min: float | Future[float], Max: float | Future[float]) -> None:
        """Generates a random number between Min and Max."""
    def RandomFloatInRangeFromStream(self, Stream: FRandomStream_in, Min: float | Future[float], Max: float | Future[float]) -> None:
        """Generates a random number between Min and Max."""
    def RandomInteger(self, Max: int | Future[int]) -> None:
        """Returns a uniformly distributed random number between 0 and Max - 1; 0 when Max is 0 or less."""
    def RandomIntegerFromStream(self, Stream: FRandomStream_in, Max: int | Future[int]) -> None:
        """Returns a uniformly distributed random number between 0 and Max - 1."""
    def RandomIntegerInRange(self, Min: int | Future[int], Max: int | Future[int]) -> None:
        """Returns a random integer between Min and Max (>= Min and <= Max)."""
    def RandomIntegerInRangeFromStream(self, Stream: FRandomStream_in, Min: int | Future[int], Max: int | Future[int]) -> None:
        """Returns a random integer between Min and Max (>= Min and <= Max)."""
    def RandomPointInBoundingBox(self, Center: FVector_in, HalfSize: FVector_in) -> None:
        """Returns a random point within the specified bounding box."""
    def RandomRotator(self, bRoll: bool | Future[bool] = False) -> None:
        """Generates a random rotation, with optional random roll."""
    def RandomRotatorFromStream(self, Stream: FRandomStream_in, bRoll: bool | Future[bool]) -> None:
        """Creates a random rotation, with optional random roll."""
    def RandomUnitVector(self) -> None:
        """Returns a random vector with length of 1, uniformly distributed over the sphere."""
    def RandomUnitVectorFromStream(self, Stream: FRandomStream_in) -> None:
        """Returns a random vector with length of 1.0."""
    def ResetRandomStream(self, Stream: FRandomStream_in) -> None:
        """Resets a random stream to its initial seed."""
    def RotateAngleAxis(self, InVect: FVector_in, AngleDeg: float | Future[float], Axis: FVector_in) -> None:
        """Returns result of vector InVect rotated by AngleDeg degrees around Axis (a unit vector)."""
    def RotatorFromAxisAndAngle(self, Axis: FVector_in, Angle: float | Future[float]) -> None:
        """Creates a rotation from an axis and an angle in degrees."""
    def Round(self, A: float | Future[float]) -> None:
        """Rounds A to the nearest integer."""
    def Round64(self, A: float | Future[float]) -> None:
        """Rounds A to the nearest integer."""
    def SafeDivide(self, A: float | Future[float], B: float | Future[float]) -> None:
        """Scalar division (A / B) where a zero divisor gives 0."""
    def SeedRandomStream(self, Stream: FRandomStream_in) -> None:
        """Creates a new random seed for a random stream."""
    def SelectClass(self, A: type[UObject] | UClass | str | Future[UClass], B: type[UObject] | UClass | str | Future[UClass], bSelectA: bool | Future[bool]) -> None:
        """If bSelectA is true, A is returned, otherwise B is."""
    def SelectColor(self, A: FLinearColor_in, B: FLinearColor_in, bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectFloat(self, A: float | Future[float], B: float | Future[float], bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectInt(self, A: int | Future[int], B: int | Future[int], bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectObject(self, A: UObject | Future[UObject], B: UObject | Future[UObject], bSelectA: bool | Future[bool]) -> None:
        """If bSelectA is true, A is returned, otherwise B is."""
    def SelectRotator(self, A: FRotator_in, B: FRotator_in, bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectString(self, A: str | Future[str], B: str | Future[str], bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectTransform(self, A: FTransform_in, B: FTransform_in, bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SelectVector(self, A: FVector_in, B: FVector_in, bPickA: bool | Future[bool]) -> None:
        """If bPickA is true, A is returned, otherwise B is."""
    def SetRandomStreamSeed(self, Stream: FRandomStream_in, NewSeed: int | Future[int]) -> None:
        """Sets the seed of a random stream to a specific number."""
    def SignOfFloat(self, A: float | Future[float]) -> None:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def SignOfInteger(self, A: int | Future[int]) -> None:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def SignOfInteger64(self, A: int | Future[int]) -> None:
        """Sign (returns -1 if A < 0, 0 if A is zero, and +1 if A > 0)."""
    def Sin(self, A: float | Future[float]) -> None:
        """Returns the sine of A (expects Radians)."""
    def Sqrt(self, A: float | Future[float]) -> None:
        """Returns the square root of A; 0 with a warning in the log when A is negative."""
    def Square(self, A: float | Future[float]) -> None:
        """Returns square of A (A * A)."""
    def Subtract_ByteByte(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Subtraction (A - B), modulo 256."""
    def Subtract_DateTimeDateTime(self, A: FDateTime_in, B: FDateTime_in) -> None:
        """Subtraction (A - B)."""
    def Subtract_DateTimeTimespan(self, A: FDateTime_in, B: FTimespan_in) -> None:
        """Subtraction (A - B)."""
    def Subtract_DoubleDouble(self, A: float | Future[float], B: float | Future[float] = 1.0) -> None:
        """Subtraction (A - B)."""
    def Subtract_Int64Int64(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Subtraction (A - B); wraps on overflow."""
    def Subtract_IntInt(self, A: int | Future[int], B: int | Future[int] = 1) -> None:
        """Subtraction (A - B); wraps on overflow."""
    def Subtract_LinearColorLinearColor(self, A: FLinearColor_in, B: FLinearColor_in) -> None:
        """Element-wise subtraction of two linear colours."""
    def Subtract_QuatQuat(self, A: FQuat_in, B: FQuat_in) -> None:
        """Returns subtraction of B from A, element by element."""
    def Subtract_TimespanTimespan(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Subtraction (A - B)."""
    def Subtract_Vector2DVector2D(self, A: FVector2D_in, B: FVector2D_in) -> None:
        """Subtraction (A - B)."""
    def Subtract_VectorFloat(self, A: FVector_in, B: float | Future[float]) -> None:
        """Subtracts a float from each component of a vector."""
    def Subtract_VectorInt(self, A: FVector_in, B: int | Future[int]) -> None:
        """Subtracts an integer from each component of a vector."""
    def Subtract_VectorVector(self, A: FVector_in, B: FVector_in) -> None:
        """Vector subtraction."""
    def TEase(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> None:
        """Eases between A and B using a specified easing function."""
    def TInterpTo(self, Current: FTransform_in, Target: FTransform_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach a target transform."""
    def TLerp(self, A: FTransform_in, B: FTransform_in, Alpha: float | Future[float], InterpMode: ELerpInterpolationMode_in = ELerpInterpolationMode.QuatInterp) -> None:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def Tan(self, A: float | Future[float]) -> None:
        """Returns the tan of A (expects Radians)."""
    def TimespanRatio(self, A: FTimespan_in, B: FTimespan_in) -> None:
        """Returns the ratio between two time spans (A / B), handles zero values."""
    def TimespanZeroValue(self) -> None:
        """Returns a zero time span value."""
    def ToUnixTimestamp(self, Time: FDateTime_in) -> None:
        """Returns this date and time as the number of seconds since the unix epoch."""
    def Today(self) -> None:
        """Returns the local date on this computer."""
    def TransformDirection(self, T: FTransform_in, Direction: FVector_in) -> None:
        """Transforms a direction vector by the given transform: does not change its length."""
    def TransformLocation(self, T: FTransform_in, Location: FVector_in) -> None:
        """Transforms a position by the given transform, scale counted."""
    def TransformRotation(self, T: FTransform_in, Rotation: FRotator_in) -> None:
        """Transforms a rotator by the given transform."""
    def Transform_Determinant(self, Transform: FTransform_in) -> None:
        """Computes the determinant of the transform converted to a matrix: the product of the scale."""
    def UtcNow(self) -> None:
        """Returns the UTC date and time on this computer."""
    def VEase(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float], EasingFunc: EEasingFunc_in, BlendExp: float | Future[float] = 2.0, Steps: int | Future[int] = 2) -> None:
        """Eases between A and B using a specified easing function."""
    def VInterpTo(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target based on distance from Current position, giving a nice smooth feeling when tracking a position."""
    def VInterpTo_Constant(self, Current: FVector_in, Target: FVector_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target at a constant rate."""
    def VLerp(self, A: FVector_in, B: FVector_in, Alpha: float | Future[float]) -> None:
        """Linearly interpolates between A and B based on Alpha (100% of A when Alpha=0 and 100% of B when Alpha=1)."""
    def VSize(self, A: FVector_in) -> None:
        """Returns the length of the vector."""
    def VSize2D(self, A: FVector2D_in) -> None:
        """Returns the length of a 2D vector."""
    def VSize2DSquared(self, A: FVector2D_in) -> None:
        """Returns the squared length of a 2D vector."""
    def VSizeSquared(self, A: FVector_in) -> None:
        """Returns the squared length of the vector."""
    def VSizeXY(self, A: FVector_in) -> None:
        """Returns the length of the vector's XY components."""
    def VSizeXYSquared(self, A: FVector_in) -> None:
        """Returns the squared length of the vector's XY components."""
    def Vector2DInterpTo(self, Current: FVector2D_in, Target: FVector2D_in, DeltaTime: float | Future[float], InterpSpeed: float | Future[float]) -> None:
        """Tries to reach Target based on distance from Current position."""
    def Vector_Assign(self, A: FVector_in, InVector: FVector_in) -> None:
        """Assign the values of the supplied vector."""
    def Vector_Backward(self) -> None:
        """3D vector backward: (-1, 0, 0)."""
    def Vector_ClampSizeMax(self, A: FVector_in, Max: float | Future[float]) -> None:
        """Creates a copy of this vector with its maximum magnitude clamped to Max."""
    def Vector_Distance(self, V1: FVector_in, V2: FVector_in) -> None:
        """Distance between two points."""
    def Vector_Distance2D(self, V1: FVector_in, V2: FVector_in) -> None:
        """Distance between two points in the XY plane (ignoring Z)."""
    def Vector_Distance2DSquared(self, V1: FVector_in, V2: FVector_in) -> None:
        """Squared distance between two points in the XY plane (ignoring Z)."""
    def Vector_DistanceSquared(self, V1: FVector_in, V2: FVector_in) -> None:
        """Squared distance between two points."""
    def Vector_Down(self) -> None:
        """3D vector down: (0, 0, -1)."""
    def Vector_Forward(self) -> None:
        """3D vector forward: (1, 0, 0)."""
    def Vector_GetAbs(self, A: FVector_in) -> None:
        """Gets a copy of this vector with absolute value of each component."""
    def Vector_IsNAN(self, A: FVector_in) -> None:
        """Determines if any component is not a number (NAN)."""
    def Vector_IsNearlyZero(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Checks whether the vector is near to zero within a specified tolerance."""
    def Vector_IsNormal(self, A: FVector_in) -> None:
        """Determines if vector is normalized / unit (length 1)."""
    def Vector_IsUniform(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Checks whether all components of the vector are the same, within a tolerance."""
    def Vector_IsUnit(self, A: FVector_in, SquaredLenthTolerance: float | Future[float] = 0.0001) -> None:
        """Determines if vector is normalized / unit (length 1) within specified squared tolerance."""
    def Vector_IsZero(self, A: FVector_in) -> None:
        """Checks whether all components of the vector are exactly zero."""
    def Vector_Left(self) -> None:
        """3D vector left: (0, -1, 0)."""
    def Vector_Normal2D(self, A: FVector_in, Tolerance: float | Future[float] = 0.0001) -> None:
        """Gets a normalized unit vector of the XY components, with Z zero."""
    def Vector_One(self) -> None:
        """3D vector (1, 1, 1)."""
    def Vector_Reciprocal(self, A: FVector_in) -> None:
        """Gets the reciprocal of this vector, avoiding division by zero: zero components give 3.4e38."""
    def Vector_Right(self) -> None:
        """3D vector right: (0, 1, 0)."""
    def Vector_Set(self, A: FVector_in, X: float | Future[float], Y: float | Future[float], Z: float | Future[float]) -> None:
        """Set the values of the vector directly."""
    def Vector_Up(self) -> None:
        """3D vector up: (0, 0, 1)."""
    def Vector_Zero(self) -> None:
        """3D vector (0, 0, 0)."""
    def Wrap(self, Value: int | Future[int], Min: int | Future[int], Max: int | Future[int]) -> None:
        """Returns Value wrapped to be between Min and Max (inclusive); an empty range gives Min."""
    def Xor_Int64Int64(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise XOR (A ^ B)."""
    def Xor_IntInt(self, A: int | Future[int], B: int | Future[int]) -> None:
        """Bitwise XOR (A ^ B)."""

class UKismetMathLibrary(UKismetMathLibrary_members, UBlueprintFunctionLibrary):
    """Mathematics for scripts and remote programs. Angles are in degrees unless a name says radians; "float" in
    names and titles means double precision, as in UE 5. Division by zero gives zero and a warning in the log.
    Epic page: UKismetMathLibrary.

    Unreal: /Script/Engine.KismetMathLibrary
    """
    @property
    def async_(self) -> UKismetMathLibrary_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UKismetMathLibrary_send:
        """The same functions and variables, fire-and-forget."""

class UKismetMathLibrary_path(ObjectPath[UKismetMathLibrary, UKismetMathLibrary_async_path, UKismetMathLibrary_send], UKismetMathLibrary_members):
    """A variable that refers to an object of UKismetMathLibrary: its path."""

class UKismetMathLibrary_async_path(AsyncObjectPath[UKismetMathLibrary], UKismetMathLibrary_async):
    """The same under ``async_``."""
