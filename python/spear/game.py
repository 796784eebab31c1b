# SPDX-License-Identifier: MIT
"""A running world: find, spawn, destroy.

Everything here but classes and worlds needs an open block. ``game.async_`` and ``game.send_`` have the same functions without waiting.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from spear._native import ASYNC, SEND, SYNC
from spear.unreal_object import UnrealObject

if TYPE_CHECKING:
    from spear._native import Session

#: A class: by name ("AActor", "Actor", "/Script/Engine.Actor"), or as an object.
ClassLike = str | UnrealObject | type

_OPTIONS = ("location", "rotation", "scale", "name", "tags", "owner", "collision_handling")


def class_argument(value: ClassLike | None) -> Any:
    """What the wire takes for a class: an object, a name, or the Unreal name of a generated Python class."""
    if isinstance(value, type):
        name = getattr(value, "unreal_name", None)
        if not isinstance(name, str):
            raise TypeError(f"{value.__name__} is no class of Unreal: give a name (\"AActor\"), a class object, or a class of spear.unreal")
        return name
    return value


class GameBase:
    """The functions of a world; :class:`Game` is the synchronous one."""

    def __init__(self, session: Session, world: UnrealObject | None, mode: int) -> None:
        self._session = session
        self._world = world
        self._mode = mode

    def _call(self, name: str, *args: Any) -> Any:
        return self._session.call("unreal_service." + name, args, {}, self._mode)

    # Actors -------------------------------------------------------------------------------------------------------------

    def spawn_actor(
        self, uclass: ClassLike, *, location: Any = None, rotation: Any = None, scale: Any = None, name: str | None = None,
        tags: Sequence[str] | None = None, owner: Any = None, collision_handling: str | None = None,
    ) -> Any:
        """Spawns an actor.

        ``location`` in centimetres (FVector, dict, three numbers), ``rotation`` in degrees (FRotator, dict, pitch-yaw-roll), ``scale``;
        ``name`` is the wanted object name; ``tags`` are set before BeginPlay. Raises UnknownClass, WrongType (no actor class), SpawnFailed.
        """
        given = (location, rotation, scale, name, tags, owner, collision_handling)
        options = {key: _plain(value) for key, value in zip(_OPTIONS, given) if value is not None}
        return self._call("spawn_actor", self._world, class_argument(uclass), options)

    def destroy_actor(self, actor: Any) -> Any:
        """Destroys an actor; using it afterwards raises StaleObject. Returns whether the engine did."""
        return self._call("destroy_actor", actor)

    def find_actor_by_name(self, name: str, uclass: ClassLike | None = None) -> Any:
        """The actor of that name. Raises UnknownObject with the nearest names."""
        return self._call("find_actor_by_name", self._world, class_argument(uclass), name)

    def find_actor_by_tag(self, tag: str, uclass: ClassLike | None = None) -> Any:
        """The only actor with the tag. Raises UnknownObject, AmbiguousName."""
        return self._call("find_actor_by_tag", self._world, class_argument(uclass), tag)

    def find_actor_by_path(self, path: str, uclass: ClassLike | None = None) -> Any:
        """The actor of that object path."""
        return self._call("find_actor_by_path", self._world, class_argument(uclass), path)

    def find_actor_by_class(self, uclass: ClassLike) -> Any:
        """The only actor of the class. Raises UnknownObject, AmbiguousName."""
        return self._call("find_actor_by_class", self._world, class_argument(uclass), "")

    def find_actors_by_name(self, pattern: str, uclass: ClassLike | None = None) -> Any:
        """All actors whose name fits a pattern with ``*`` and ``?``."""
        return self._call("find_actors_by_name", self._world, class_argument(uclass), pattern)

    def find_actors_by_tag(self, tag: str, uclass: ClassLike | None = None) -> Any:
        """All actors with the tag, in the world's order."""
        return self._call("find_actors_by_tag", self._world, class_argument(uclass), tag)

    def find_actors_by_class(self, uclass: ClassLike) -> Any:
        """All actors of the class, in the world's order."""
        return self._call("find_actors_by_class", self._world, class_argument(uclass), "")

    def find_actors_by_tag_as_map(self, tag: str, uclass: ClassLike | None = None) -> Any:
        """All actors with the tag, by name."""
        return self._call("find_actors_by_tag_as_map", self._world, class_argument(uclass), tag)

    def find_actors_by_class_as_map(self, uclass: ClassLike) -> Any:
        """All actors of the class, by name."""
        return self._call("find_actors_by_class_as_map", self._world, class_argument(uclass), "")

    # Components ---------------------------------------------------------------------------------------------------------

    def get_component_by_name(self, actor: Any, name: str, uclass: ClassLike | None = None) -> Any:
        """The actor's component of that name. Raises UnknownObject with the nearest names."""
        return self._call("find_component_by_name", actor, class_argument(uclass), name)

    def get_component_by_tag(self, actor: Any, tag: str, uclass: ClassLike | None = None) -> Any:
        """The actor's only component with the tag."""
        return self._call("find_component_by_tag", actor, class_argument(uclass), tag)

    def get_component_by_class(self, actor: Any, uclass: ClassLike) -> Any:
        """The actor's only component of the class."""
        return self._call("find_component_by_class", actor, class_argument(uclass), "")

    def get_components_by_tag(self, actor: Any, tag: str, uclass: ClassLike | None = None) -> Any:
        """The actor's components with the tag."""
        return self._call("find_components_by_tag", actor, class_argument(uclass), tag)

    def get_components_by_class(self, actor: Any, uclass: ClassLike) -> Any:
        """The actor's components of the class."""
        return self._call("find_components_by_class", actor, class_argument(uclass), "")

    def get_components_by_class_as_map(self, actor: Any, uclass: ClassLike) -> Any:
        """The actor's components of the class, by name."""
        return self._call("find_components_by_class_as_map", actor, class_argument(uclass), "")

    # Objects ------------------------------------------------------------------------------------------------------------

    def new_object(self, uclass: ClassLike, outer: Any = None, name: str = "") -> Any:
        """Makes an object that the session keeps alive until release_object(). Actors are spawned instead."""
        return self._call("new_object", class_argument(uclass), outer, name)

    def release_object(self, unreal_object: Any) -> Any:
        """Lets go of an object made by new_object()."""
        return self._call("release_object", unreal_object)

    def load_object(self, path: str, uclass: ClassLike = "UObject") -> Any:
        """Finds or loads an asset by path, e.g. ``/Engine/BasicShapes/Cube.Cube``. Raises UnknownObject, WrongType."""
        return self._call("load_object", class_argument(uclass), path)

    def load_class(self, path: str, uclass: ClassLike = "UObject") -> Any:
        """Loads a class by path, also one defined in content (``/Game/BP_X.BP_X_C``)."""
        return self._call("load_class", class_argument(uclass), path)


class Game(GameBase):
    """A world of the engine; ``instance.get_game()`` gives the primary one."""

    def __init__(self, session: Session, world: UnrealObject | None = None) -> None:
        super().__init__(session, world, SYNC)

    @property
    def async_(self) -> GameBase:
        """The same functions, each giving a Future at once."""
        return GameBase(self._session, self._world, ASYNC)

    @property
    def send_(self) -> GameBase:
        """The same functions, fire-and-forget."""
        return GameBase(self._session, self._world, SEND)

    def get_class(self, uclass: ClassLike) -> UnrealObject:
        """The class itself, for static functions: ``game.get_class("UGameplayStatics").SetGamePaused(bPaused=True)``. Works anywhere."""
        result: UnrealObject = self._call("find_class", class_argument(uclass))
        return result

    def get_default_object(self, uclass: ClassLike) -> UnrealObject:
        """The class default object. Works anywhere."""
        result: UnrealObject = self._call("get_default_object", class_argument(uclass))
        return result

    def get_derived_classes(self, uclass: ClassLike, recursive: bool = True) -> list[UnrealObject]:
        """The classes that derive from a class. Works anywhere."""
        return list(self._call("get_derived_classes", class_argument(uclass), recursive))

    def get_unreal_object(self, uclass: ClassLike) -> UnrealObject:
        """The paper package's spelling of :meth:`get_class`."""
        return self.get_class(uclass)


def _plain(value: Any) -> Any:
    """Locations and the like as the wire takes them: NumPy arrays and tuples become lists."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, tuple) or (isinstance(value, Sequence) and not isinstance(value, str | bytes)):
        return list(value)
    if isinstance(value, Mapping):
        return dict(value)
    return value
