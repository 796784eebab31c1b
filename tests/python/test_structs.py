# SPDX-License-Identifier: MIT
"""Struct values: construction, equality, dictionaries, NumPy."""

import copy

import numpy as np
import pytest

import spear
from spear.structs import struct_class


def test_made_by_keyword_and_position() -> None:
    assert spear.FVector(X=1, Y=2, Z=3) == spear.FVector(1, 2, 3)
    assert spear.FVector(Y=2) == spear.FVector(0.0, 2, 0.0)
    assert spear.FTransform().Scale3D == spear.FVector(1, 1, 1)


def test_equal_to_and_made_from_dictionaries() -> None:
    vector = spear.FVector(1, 2, 3)
    assert vector == {"X": 1, "Y": 2, "Z": 3}
    assert vector != {"X": 1, "Y": 2}
    assert spear.FVector.from_dict({"X": 1, "Z": 3}) == spear.FVector(1, 0, 3)
    assert spear.FTransform().to_dict()["Rotation"] == {"X": 0, "Y": 0, "Z": 0, "W": 1}


@pytest.mark.parametrize("make", [lambda: spear.FVector(W=1), lambda: spear.FVector(1, 2, 3, 4), lambda: spear.FVector(1, X=1)])
def test_wrong_fields_are_named(make) -> None:
    with pytest.raises(TypeError, match="FVector.*"):
        make()


def test_defaults_are_not_shared() -> None:
    one, two = spear.FTransform(), spear.FTransform()
    one.Translation.X = 5
    assert two.Translation.X == 0
    assert copy.deepcopy(one) == one


def test_vectors_and_colours_are_arrays() -> None:
    assert np.array_equal(np.asarray(spear.FVector(1, 2, 3)), [1, 2, 3])
    assert spear.FVector.from_numpy(np.array([1, 2, 3])) == spear.FVector(1, 2, 3)
    assert spear.FColor(R=1, G=2, B=3, A=4).to_numpy().tolist() == [1, 2, 3, 4]
    assert spear.FColor.from_numpy([1, 2, 3, 4]) == spear.FColor(B=3, G=2, R=1, A=4)
    with pytest.raises(ValueError, match=r"\(3,\)"):
        spear.FVector.from_numpy([1, 2])


def test_rotator_turns_as_unreal_does() -> None:
    # Yaw 90 turns forward (X) to right (Y); pitch 90 turns forward to up (Z): left-handed, Z up.
    assert np.allclose(spear.FRotator(Yaw=90).to_matrix() @ [1, 0, 0], [0, 1, 0])
    assert np.allclose(spear.FRotator(Pitch=90).to_matrix() @ [1, 0, 0], [0, 0, 1])
    assert np.allclose(spear.FRotator(Roll=90).to_matrix() @ [0, 0, 1], [0, 1, 0])


def test_rotations_and_transforms_round_trip() -> None:
    generator = np.random.default_rng(7)
    for _ in range(200):
        rotator = spear.FRotator(*generator.uniform([-89, -180, -180], [89, 180, 180]))
        matrix = rotator.to_matrix()
        assert np.allclose(matrix @ matrix.T, np.eye(3))
        assert np.allclose(spear.FRotator.from_matrix(matrix).to_numpy(), rotator.to_numpy())
        assert np.allclose(spear.FQuat.from_matrix(matrix).to_matrix(), matrix)
        transform = spear.FTransform(spear.FQuat.from_matrix(matrix), spear.FVector(*generator.normal(size=3)), spear.FVector(*generator.uniform(0.1, 3, 3)))
        again = spear.FTransform.from_numpy(transform.to_numpy())
        assert np.allclose(again.to_numpy(), transform.to_numpy())


def test_unknown_structs_get_a_class_with_their_fields() -> None:
    made = struct_class("FSomething", ["Alpha", "Beta"])
    assert struct_class("FSomething", ["Alpha", "Beta"]) is made
    assert made(Alpha=1, Beta=2) == {"Alpha": 1, "Beta": 2}
    odd = struct_class("FOdd", ["a name with spaces"])
    assert odd(**{"a name with spaces": 3}).to_dict() == {"a name with spaces": 3}
