# SPDX-License-Identifier: MIT
"""A running world: find, spawn, destroy.

Everything here but classes and worlds needs an open block. ``game.async_`` and ``game.send_`` have the same functions without waiting; their
classes are made from this file (``game_twins.py``, by ``python/make_game_twins.py``).

Where a class is taken, a class of ``spear.unreal`` makes the result one of it (``game.spawn_actor(AStaticMeshActor)`` is an
``AStaticMeshActor`` to type checkers); a name (``"AActor"``, ``"Actor"``, ``"/Script/Engine.Actor"``) or a class object gives an UnrealObject.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar, overload

from spear._native import ASYNC, SEND, SYNC, Future
from spear.unreal_object import ObjectBase, UnrealObject, class_argument

if TYPE_CHECKING:
    import numpy.typing as npt

    from spear._native import Session
    from spear.game_twins import AsyncGame, SendGame
    from spear.structs import FRotator, FVector

    #: Centimetres (or a scale): FVector, three numbers, a dictionary of X, Y, Z, an array.
    Vector = FVector | Sequence[float] | Mapping[str, float] | npt.NDArray[Any] | Future[FVector]
    #: Degrees: FRotator, pitch-yaw-roll, a dictionary of Pitch, Yaw, Roll, an array.
    Rotator = FRotator | Sequence[float] | Mapping[str, float] | npt.NDArray[Any] | Future[FRotator]

_T = TypeVar("_T", bound=ObjectBase)

#: A class without a Python class: by name, or as an object.
ClassLike = str | ObjectBase

_OPTIONS = ("location", "rotation", "scale", "name", "tags", "owner", "collision_handling")


class GameBase:
    """What a world and its twins share."""

    def __init__(self, session: Session, world: ObjectBase | None = None, mode: int = SYNC) -> None:
        self._session = session
        self._world = world
        self._mode = mode

    def _call(self, name: str, *args: Any) -> Any:
        return self._session.call("unreal_service." + name, args, {}, self._mode)


class Game(GameBase):
    """A world of the engine; ``instance.get_game()`` gives the primary one."""

    @property
    def async_(self) -> AsyncGame:
        """The same functions, each giving a Future at once."""
        from spear.game_twins import AsyncGame

        return AsyncGame(self._session, self._world, ASYNC)

    @property
    def send_(self) -> SendGame:
        """The same functions, fire-and-forget."""
        from spear.game_twins import SendGame

        return SendGame(self._session, self._world, SEND)

    # Actors -----------------------------------------------------------------------------------------------------------------------------
    @overload
    def spawn_actor(self, uclass: type[_T], *, location: Vector | None = None, rotation: Rotator | None = None, scale: Vector | None = None,
        name: str | None = None, tags: Sequence[str] | None = None, owner: ObjectBase | Future[Any] | None = None, collision_handling: str | None = None,
    ) -> _T: ...
    @overload
    def spawn_actor(self, uclass: ClassLike, *, location: Vector | None = None, rotation: Rotator | None = None, scale: Vector | None = None,
        name: str | None = None, tags: Sequence[str] | None = None, owner: ObjectBase | Future[Any] | None = None, collision_handling: str | None = None,
    ) -> UnrealObject: ...
    def spawn_actor(self, uclass: Any, *, location: Vector | None = None, rotation: Rotator | None = None, scale: Vector | None = None,
        name: str | None = None, tags: Sequence[str] | None = None, owner: ObjectBase | Future[Any] | None = None, collision_handling: str | None = None,
    ) -> Any:
        """Spawns an actor.

        ``location`` in centimetres (FVector, dict, three numbers), ``rotation`` in degrees (FRotator, dict, pitch-yaw-roll), ``scale``;
        ``name`` is the wanted object name; ``tags`` are set before BeginPlay. Raises UnknownClass, WrongType (no actor class), SpawnFailed.
        """
        given = (location, rotation, scale, name, tags, owner, collision_handling)
        options = {key: plain(value) for key, value in zip(_OPTIONS, given) if value is not None}
        return self._call("spawn_actor", self._world, class_argument(uclass), options)

    def destroy_actor(self, actor: ObjectBase | Future[Any]) -> bool:
        """Destroys an actor; using it afterwards raises StaleObject. Returns whether the engine did."""
        return self._call("destroy_actor", actor)  # type: ignore[no-any-return]

    @overload
    def find_actor_by_name(self, name: str, uclass: type[_T]) -> _T: ...
    @overload
    def find_actor_by_name(self, name: str, uclass: ClassLike | None = None) -> UnrealObject: ...
    def find_actor_by_name(self, name: str, uclass: Any = None) -> Any:
        """The actor of that name. Raises UnknownObject with the nearest names."""
        return self._call("find_actor_by_name", self._world, class_argument(uclass), name)

    @overload
    def find_actor_by_tag(self, tag: str, uclass: type[_T]) -> _T: ...
    @overload
    def find_actor_by_tag(self, tag: str, uclass: ClassLike | None = None) -> UnrealObject: ...
    def find_actor_by_tag(self, tag: str, uclass: Any = None) -> Any:
        """The only actor with the tag. Raises UnknownObject, AmbiguousName."""
        return self._call("find_actor_by_tag", self._world, class_argument(uclass), tag)

    @overload
    def find_actor_by_path(self, path: str, uclass: type[_T]) -> _T: ...
    @overload
    def find_actor_by_path(self, path: str, uclass: ClassLike | None = None) -> UnrealObject: ...
    def find_actor_by_path(self, path: str, uclass: Any = None) -> Any:
        """The actor of that object path."""
        return self._call("find_actor_by_path", self._world, class_argument(uclass), path)

    @overload
    def find_actor_by_class(self, uclass: type[_T]) -> _T: ...
    @overload
    def find_actor_by_class(self, uclass: ClassLike) -> UnrealObject: ...
    def find_actor_by_class(self, uclass: Any) -> Any:
        """The only actor of the class. Raises UnknownObject, AmbiguousName."""
        return self._call("find_actor_by_class", self._world, class_argument(uclass), "")

    @overload
    def find_actors_by_name(self, pattern: str, uclass: type[_T]) -> list[_T]: ...
    @overload
    def find_actors_by_name(self, pattern: str, uclass: ClassLike | None = None) -> list[UnrealObject]: ...
    def find_actors_by_name(self, pattern: str, uclass: Any = None) -> Any:
        """All actors whose name fits a pattern with ``*`` and ``?``."""
        return self._call("find_actors_by_name", self._world, class_argument(uclass), pattern)

    @overload
    def find_actors_by_tag(self, tag: str, uclass: type[_T]) -> list[_T]: ...
    @overload
    def find_actors_by_tag(self, tag: str, uclass: ClassLike | None = None) -> list[UnrealObject]: ...
    def find_actors_by_tag(self, tag: str, uclass: Any = None) -> Any:
        """All actors with the tag, in the world's order."""
        return self._call("find_actors_by_tag", self._world, class_argument(uclass), tag)

    @overload
    def find_actors_by_class(self, uclass: type[_T]) -> list[_T]: ...
    @overload
    def find_actors_by_class(self, uclass: ClassLike) -> list[UnrealObject]: ...
    def find_actors_by_class(self, uclass: Any) -> Any:
        """All actors of the class, in the world's order."""
        return self._call("find_actors_by_class", self._world, class_argument(uclass), "")

    @overload
    def find_actors_by_tag_as_map(self, tag: str, uclass: type[_T]) -> dict[str, _T]: ...
    @overload
    def find_actors_by_tag_as_map(self, tag: str, uclass: ClassLike | None = None) -> dict[str, UnrealObject]: ...
    def find_actors_by_tag_as_map(self, tag: str, uclass: Any = None) -> Any:
        """All actors with the tag, by name."""
        return self._call("find_actors_by_tag_as_map", self._world, class_argument(uclass), tag)

    @overload
    def find_actors_by_class_as_map(self, uclass: type[_T]) -> dict[str, _T]: ...
    @overload
    def find_actors_by_class_as_map(self, uclass: ClassLike) -> dict[str, UnrealObject]: ...
    def find_actors_by_class_as_map(self, uclass: Any) -> Any:
        """All actors of the class, by name."""
        return self._call("find_actors_by_class_as_map", self._world, class_argument(uclass), "")


    # Components -------------------------------------------------------------------------------------------------------------------------
    @overload
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: type[_T]) -> _T: ...
    @overload
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: ClassLike | None = None) -> UnrealObject: ...
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: Any = None) -> Any:
        """The actor's component of that name. Raises UnknownObject with the nearest names."""
        return self._call("find_component_by_name", actor, class_argument(uclass), name)

    @overload
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: type[_T]) -> _T: ...
    @overload
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: ClassLike | None = None) -> UnrealObject: ...
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: Any = None) -> Any:
        """The actor's only component with the tag."""
        return self._call("find_component_by_tag", actor, class_argument(uclass), tag)

    @overload
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> _T: ...
    @overload
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> UnrealObject: ...
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's only component of the class. (``actor.get_component(UCameraComponent)`` is the same.)"""
        return self._call("find_component_by_class", actor, class_argument(uclass), "")

    @overload
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> list[_T]: ...
    @overload
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> list[UnrealObject]: ...
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's components of the class."""
        return self._call("find_components_by_class", actor, class_argument(uclass), "")

    @overload
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> dict[str, _T]: ...
    @overload
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> dict[str, UnrealObject]: ...
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's components of the class, by name."""
        return self._call("find_components_by_class_as_map", actor, class_argument(uclass), "")


    # Objects ----------------------------------------------------------------------------------------------------------------------------
    @overload
    def new_object(self, uclass: type[_T], outer: ObjectBase | Future[Any] | None = None, name: str = "") -> _T: ...
    @overload
    def new_object(self, uclass: ClassLike, outer: ObjectBase | Future[Any] | None = None, name: str = "") -> UnrealObject: ...
    def new_object(self, uclass: Any, outer: ObjectBase | Future[Any] | None = None, name: str = "") -> Any:
        """Makes an object that the session keeps alive until release_object(). Actors are spawned instead."""
        return self._call("new_object", class_argument(uclass), outer, name)

    def release_object(self, unreal_object: ObjectBase | Future[Any]) -> None:
        """Lets go of an object made by new_object()."""
        self._call("release_object", unreal_object)

    @overload
    def load_object(self, path: str, uclass: type[_T]) -> _T: ...
    @overload
    def load_object(self, path: str, uclass: ClassLike = "UObject") -> UnrealObject: ...
    def load_object(self, path: str, uclass: Any = "UObject") -> Any:
        """Finds or loads an asset by path, e.g. ``/Engine/BasicShapes/Cube.Cube``. Raises UnknownObject, WrongType."""
        return self._call("load_object", class_argument(uclass), path)

    @overload
    def load_class(self, path: str, uclass: type[_T]) -> _T: ...
    @overload
    def load_class(self, path: str, uclass: ClassLike = "UObject") -> UnrealObject: ...
    def load_class(self, path: str, uclass: Any = "UObject") -> Any:
        """Loads a class by path, also one defined in content (``/Game/BP_X.BP_X_C``)."""
        return self._call("load_class", class_argument(uclass), path)


    # Many at once -----------------------------------------------------------------------------------------------------------------------
    def call_many(self, objects: Sequence[Any] | ObjectBase, function: str, /, *args: Any, **kwargs: Any) -> list[Any]:
        """Calls a function, by Unreal's name, for each of many objects, without a loop in Python.

        Each argument is one value for all calls, or, as a list, a tuple or an array, one for each call (of an array, a row):
        ``game.call_many(actors, "SetActorScale3D", NewScale3D=scales)`` with ``scales`` of shape (len(actors), 3). One object
        instead of a sequence is called again and again. The calls run in order, each on its own as if written out: all of them run, then the
        first that failed raises its error. Gives the results in order; ``game.async_`` a list of futures, ``game.send_`` nothing.
        Raises ValueError if the lengths differ.
        """
        return self._session.call_many(objects, function, args, kwargs, self._mode)  # type: ignore[no-any-return]


    # Classes: these work anywhere, also outside of blocks -------------------------------------------------------------------------------
    @overload
    def get_class(self, uclass: type[_T]) -> _T: ...
    @overload
    def get_class(self, uclass: ClassLike) -> UnrealObject: ...
    def get_class(self, uclass: Any) -> Any:
        """The class itself, for static functions: ``game.get_class(UGameplayStatics).SetGamePaused(bPaused=True)``."""
        return self._call("find_class", class_argument(uclass))

    @overload
    def get_default_object(self, uclass: type[_T]) -> _T: ...
    @overload
    def get_default_object(self, uclass: ClassLike) -> UnrealObject: ...
    def get_default_object(self, uclass: Any) -> Any:
        """The class default object."""
        return self._call("get_default_object", class_argument(uclass))

    def get_derived_classes(self, uclass: type[ObjectBase] | ClassLike, recursive: bool = True) -> list[UnrealObject]:
        """The classes that derive from a class."""
        return self._call("get_derived_classes", class_argument(uclass), recursive)  # type: ignore[no-any-return]

    @overload
    def get_unreal_object(self, uclass: type[_T]) -> _T: ...
    @overload
    def get_unreal_object(self, uclass: ClassLike) -> UnrealObject: ...
    def get_unreal_object(self, uclass: Any) -> Any:
        """The paper package's spelling of :meth:`get_class`."""
        return self._call("find_class", class_argument(uclass))


def plain(value: Any) -> Any:
    """Locations and the like as the wire takes them: NumPy arrays and tuples become lists."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, tuple) or (isinstance(value, Sequence) and not isinstance(value, str | bytes)):
        return list(value)
    if isinstance(value, Mapping):
        return dict(value)
    return value
