# SPDX-License-Identifier: MIT
# DO NOT EDIT: made from game.py by python/make_game_twins.py
"""``game.async_`` and ``game.send_``: the functions of a world, not waited for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeVar, overload

from spear._native import Future
from spear.game import _OPTIONS, ClassLike, GameBase, plain
from spear.unreal_object import ObjectBase, UnrealObject, class_argument

if TYPE_CHECKING:
    from spear.game import Rotator, Vector

_T = TypeVar("_T", bound=ObjectBase)


class AsyncGame(GameBase):
    """The functions of a world, each giving a Future at once."""

    @overload
    def spawn_actor(self, uclass: type[_T], *, location: Vector | None=None, rotation: Rotator | None=None, scale: Vector | None=None, name: str | None=None, tags: Sequence[str] | None=None, owner: ObjectBase | Future[Any] | None=None, collision_handling: str | None=None) -> Future[_T]: ...
    @overload
    def spawn_actor(self, uclass: ClassLike, *, location: Vector | None=None, rotation: Rotator | None=None, scale: Vector | None=None, name: str | None=None, tags: Sequence[str] | None=None, owner: ObjectBase | Future[Any] | None=None, collision_handling: str | None=None) -> Future[UnrealObject]: ...
    def spawn_actor(self, uclass: Any, *, location: Vector | None=None, rotation: Rotator | None=None, scale: Vector | None=None, name: str | None=None, tags: Sequence[str] | None=None, owner: ObjectBase | Future[Any] | None=None, collision_handling: str | None=None) -> Any:
        """Spawns an actor.

        ``location`` in centimetres (FVector, dict, three numbers), ``rotation`` in degrees (FRotator, dict, pitch-yaw-roll), ``scale``;
        ``name`` is the wanted object name; ``tags`` are set before BeginPlay. Raises UnknownClass, WrongType (no actor class), SpawnFailed.
        """
        given = (location, rotation, scale, name, tags, owner, collision_handling)
        options = {key: plain(value) for key, value in zip(_OPTIONS, given) if value is not None}
        return self._call('spawn_actor', self._world, class_argument(uclass), options)

    def destroy_actor(self, actor: ObjectBase | Future[Any]) -> Future[bool]:
        """Destroys an actor; using it afterwards raises StaleObject. Returns whether the engine did."""
        return self._call('destroy_actor', actor)  # type: ignore[no-any-return]

    @overload
    def find_actor_by_name(self, name: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def find_actor_by_name(self, name: str, uclass: ClassLike | None=None) -> Future[UnrealObject]: ...
    def find_actor_by_name(self, name: str, uclass: Any=None) -> Any:
        """The actor of that name. Raises UnknownObject with the nearest names."""
        return self._call('find_actor_by_name', self._world, class_argument(uclass), name)

    @overload
    def find_actor_by_tag(self, tag: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def find_actor_by_tag(self, tag: str, uclass: ClassLike | None=None) -> Future[UnrealObject]: ...
    def find_actor_by_tag(self, tag: str, uclass: Any=None) -> Any:
        """The only actor with the tag. Raises UnknownObject, AmbiguousName."""
        return self._call('find_actor_by_tag', self._world, class_argument(uclass), tag)

    @overload
    def find_actor_by_path(self, path: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def find_actor_by_path(self, path: str, uclass: ClassLike | None=None) -> Future[UnrealObject]: ...
    def find_actor_by_path(self, path: str, uclass: Any=None) -> Any:
        """The actor of that object path."""
        return self._call('find_actor_by_path', self._world, class_argument(uclass), path)

    @overload
    def find_actor_by_class(self, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def find_actor_by_class(self, uclass: ClassLike) -> Future[UnrealObject]: ...
    def find_actor_by_class(self, uclass: Any) -> Any:
        """The only actor of the class. Raises UnknownObject, AmbiguousName."""
        return self._call('find_actor_by_class', self._world, class_argument(uclass), '')

    @overload
    def find_actors_by_name(self, pattern: str, uclass: type[_T]) -> Future[list[_T]]: ...
    @overload
    def find_actors_by_name(self, pattern: str, uclass: ClassLike | None=None) -> Future[list[UnrealObject]]: ...
    def find_actors_by_name(self, pattern: str, uclass: Any=None) -> Any:
        """All actors whose name fits a pattern with ``*`` and ``?``."""
        return self._call('find_actors_by_name', self._world, class_argument(uclass), pattern)

    @overload
    def find_actors_by_tag(self, tag: str, uclass: type[_T]) -> Future[list[_T]]: ...
    @overload
    def find_actors_by_tag(self, tag: str, uclass: ClassLike | None=None) -> Future[list[UnrealObject]]: ...
    def find_actors_by_tag(self, tag: str, uclass: Any=None) -> Any:
        """All actors with the tag, in the world's order."""
        return self._call('find_actors_by_tag', self._world, class_argument(uclass), tag)

    @overload
    def find_actors_by_class(self, uclass: type[_T]) -> Future[list[_T]]: ...
    @overload
    def find_actors_by_class(self, uclass: ClassLike) -> Future[list[UnrealObject]]: ...
    def find_actors_by_class(self, uclass: Any) -> Any:
        """All actors of the class, in the world's order."""
        return self._call('find_actors_by_class', self._world, class_argument(uclass), '')

    @overload
    def find_actors_by_tag_as_map(self, tag: str, uclass: type[_T]) -> Future[dict[str, _T]]: ...
    @overload
    def find_actors_by_tag_as_map(self, tag: str, uclass: ClassLike | None=None) -> Future[dict[str, UnrealObject]]: ...
    def find_actors_by_tag_as_map(self, tag: str, uclass: Any=None) -> Any:
        """All actors with the tag, by name."""
        return self._call('find_actors_by_tag_as_map', self._world, class_argument(uclass), tag)

    @overload
    def find_actors_by_class_as_map(self, uclass: type[_T]) -> Future[dict[str, _T]]: ...
    @overload
    def find_actors_by_class_as_map(self, uclass: ClassLike) -> Future[dict[str, UnrealObject]]: ...
    def find_actors_by_class_as_map(self, uclass: Any) -> Any:
        """All actors of the class, by name."""
        return self._call('find_actors_by_class_as_map', self._world, class_argument(uclass), '')

    @overload
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: ClassLike | None=None) -> Future[UnrealObject]: ...
    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: Any=None) -> Any:
        """The actor's component of that name. Raises UnknownObject with the nearest names."""
        return self._call('find_component_by_name', actor, class_argument(uclass), name)

    @overload
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: ClassLike | None=None) -> Future[UnrealObject]: ...
    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: Any=None) -> Any:
        """The actor's only component with the tag."""
        return self._call('find_component_by_tag', actor, class_argument(uclass), tag)

    @overload
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> Future[UnrealObject]: ...
    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's only component of the class. (``actor.get_component(UCameraComponent)`` is the same.)"""
        return self._call('find_component_by_class', actor, class_argument(uclass), '')

    @overload
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> Future[list[_T]]: ...
    @overload
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> Future[list[UnrealObject]]: ...
    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's components of the class."""
        return self._call('find_components_by_class', actor, class_argument(uclass), '')

    @overload
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: type[_T]) -> Future[dict[str, _T]]: ...
    @overload
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: ClassLike) -> Future[dict[str, UnrealObject]]: ...
    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: Any) -> Any:
        """The actor's components of the class, by name."""
        return self._call('find_components_by_class_as_map', actor, class_argument(uclass), '')

    @overload
    def new_object(self, uclass: type[_T], outer: ObjectBase | Future[Any] | None=None, name: str='') -> Future[_T]: ...
    @overload
    def new_object(self, uclass: ClassLike, outer: ObjectBase | Future[Any] | None=None, name: str='') -> Future[UnrealObject]: ...
    def new_object(self, uclass: Any, outer: ObjectBase | Future[Any] | None=None, name: str='') -> Any:
        """Makes an object that the session keeps alive until release_object(). Actors are spawned instead."""
        return self._call('new_object', class_argument(uclass), outer, name)

    def release_object(self, unreal_object: ObjectBase | Future[Any]) -> Future[None]:
        """Lets go of an object made by new_object()."""
        return self._call('release_object', unreal_object)  # type: ignore[no-any-return]

    @overload
    def load_object(self, path: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def load_object(self, path: str, uclass: ClassLike='UObject') -> Future[UnrealObject]: ...
    def load_object(self, path: str, uclass: Any='UObject') -> Any:
        """Finds or loads an asset by path, e.g. ``/Engine/BasicShapes/Cube.Cube``. Raises UnknownObject, WrongType."""
        return self._call('load_object', class_argument(uclass), path)

    @overload
    def load_class(self, path: str, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def load_class(self, path: str, uclass: ClassLike='UObject') -> Future[UnrealObject]: ...
    def load_class(self, path: str, uclass: Any='UObject') -> Any:
        """Loads a class by path, also one defined in content (``/Game/BP_X.BP_X_C``)."""
        return self._call('load_class', class_argument(uclass), path)

    def call_many(self, objects: Sequence[Any] | ObjectBase, function: str, /, *args: Any, **kwargs: Any) -> list[Future[Any]]:
        """Calls a function, by Unreal's name, for each of many objects, without a loop in Python.

        Each argument is one value for all calls, or, as a list, a tuple or an array, one for each call (of an array, a row):
        ``game.call_many(actors, "SetActorScale3D", NewScale3D=scales)`` with ``scales`` of shape (len(actors), 3). One object
        instead of a sequence is called again and again. The calls run in order, each on its own as if written out: all of them run, then the
        first that failed raises its error. Gives the results in order; ``game.async_`` a list of futures, ``game.send_`` nothing.
        Raises ValueError if the lengths differ.
        """
        return self._session.call_many(objects, function, args, kwargs, self._mode)  # type: ignore[no-any-return]

    @overload
    def get_class(self, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_class(self, uclass: ClassLike) -> Future[UnrealObject]: ...
    def get_class(self, uclass: Any) -> Any:
        """The class itself, for static functions: ``game.get_class(UGameplayStatics).SetGamePaused(bPaused=True)``."""
        return self._call('find_class', class_argument(uclass))

    @overload
    def get_default_object(self, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_default_object(self, uclass: ClassLike) -> Future[UnrealObject]: ...
    def get_default_object(self, uclass: Any) -> Any:
        """The class default object."""
        return self._call('get_default_object', class_argument(uclass))

    def get_derived_classes(self, uclass: type[ObjectBase] | ClassLike, recursive: bool=True) -> Future[list[UnrealObject]]:
        """The classes that derive from a class."""
        return self._call('get_derived_classes', class_argument(uclass), recursive)  # type: ignore[no-any-return]

    @overload
    def get_unreal_object(self, uclass: type[_T]) -> Future[_T]: ...
    @overload
    def get_unreal_object(self, uclass: ClassLike) -> Future[UnrealObject]: ...
    def get_unreal_object(self, uclass: Any) -> Any:
        """The paper package's spelling of :meth:`get_class`."""
        return self._call('find_class', class_argument(uclass))


class SendGame(GameBase):
    """The functions of a world, fire-and-forget."""

    def spawn_actor(self, uclass: Any, *, location: Vector | None=None, rotation: Rotator | None=None, scale: Vector | None=None, name: str | None=None, tags: Sequence[str] | None=None, owner: ObjectBase | Future[Any] | None=None, collision_handling: str | None=None) -> None:
        """Spawns an actor.

        ``location`` in centimetres (FVector, dict, three numbers), ``rotation`` in degrees (FRotator, dict, pitch-yaw-roll), ``scale``;
        ``name`` is the wanted object name; ``tags`` are set before BeginPlay. Raises UnknownClass, WrongType (no actor class), SpawnFailed.
        """
        given = (location, rotation, scale, name, tags, owner, collision_handling)
        options = {key: plain(value) for key, value in zip(_OPTIONS, given) if value is not None}
        self._call('spawn_actor', self._world, class_argument(uclass), options)

    def destroy_actor(self, actor: ObjectBase | Future[Any]) -> None:
        """Destroys an actor; using it afterwards raises StaleObject. Returns whether the engine did."""
        self._call('destroy_actor', actor)

    def find_actor_by_name(self, name: str, uclass: Any=None) -> None:
        """The actor of that name. Raises UnknownObject with the nearest names."""
        self._call('find_actor_by_name', self._world, class_argument(uclass), name)

    def find_actor_by_tag(self, tag: str, uclass: Any=None) -> None:
        """The only actor with the tag. Raises UnknownObject, AmbiguousName."""
        self._call('find_actor_by_tag', self._world, class_argument(uclass), tag)

    def find_actor_by_path(self, path: str, uclass: Any=None) -> None:
        """The actor of that object path."""
        self._call('find_actor_by_path', self._world, class_argument(uclass), path)

    def find_actor_by_class(self, uclass: Any) -> None:
        """The only actor of the class. Raises UnknownObject, AmbiguousName."""
        self._call('find_actor_by_class', self._world, class_argument(uclass), '')

    def find_actors_by_name(self, pattern: str, uclass: Any=None) -> None:
        """All actors whose name fits a pattern with ``*`` and ``?``."""
        self._call('find_actors_by_name', self._world, class_argument(uclass), pattern)

    def find_actors_by_tag(self, tag: str, uclass: Any=None) -> None:
        """All actors with the tag, in the world's order."""
        self._call('find_actors_by_tag', self._world, class_argument(uclass), tag)

    def find_actors_by_class(self, uclass: Any) -> None:
        """All actors of the class, in the world's order."""
        self._call('find_actors_by_class', self._world, class_argument(uclass), '')

    def find_actors_by_tag_as_map(self, tag: str, uclass: Any=None) -> None:
        """All actors with the tag, by name."""
        self._call('find_actors_by_tag_as_map', self._world, class_argument(uclass), tag)

    def find_actors_by_class_as_map(self, uclass: Any) -> None:
        """All actors of the class, by name."""
        self._call('find_actors_by_class_as_map', self._world, class_argument(uclass), '')

    def get_component_by_name(self, actor: ObjectBase | Future[Any], name: str, uclass: Any=None) -> None:
        """The actor's component of that name. Raises UnknownObject with the nearest names."""
        self._call('find_component_by_name', actor, class_argument(uclass), name)

    def get_component_by_tag(self, actor: ObjectBase | Future[Any], tag: str, uclass: Any=None) -> None:
        """The actor's only component with the tag."""
        self._call('find_component_by_tag', actor, class_argument(uclass), tag)

    def get_component_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> None:
        """The actor's only component of the class. (``actor.get_component(UCameraComponent)`` is the same.)"""
        self._call('find_component_by_class', actor, class_argument(uclass), '')

    def get_components_by_class(self, actor: ObjectBase | Future[Any], uclass: Any) -> None:
        """The actor's components of the class."""
        self._call('find_components_by_class', actor, class_argument(uclass), '')

    def get_components_by_class_as_map(self, actor: ObjectBase | Future[Any], uclass: Any) -> None:
        """The actor's components of the class, by name."""
        self._call('find_components_by_class_as_map', actor, class_argument(uclass), '')

    def new_object(self, uclass: Any, outer: ObjectBase | Future[Any] | None=None, name: str='') -> None:
        """Makes an object that the session keeps alive until release_object(). Actors are spawned instead."""
        self._call('new_object', class_argument(uclass), outer, name)

    def release_object(self, unreal_object: ObjectBase | Future[Any]) -> None:
        """Lets go of an object made by new_object()."""
        self._call('release_object', unreal_object)

    def load_object(self, path: str, uclass: Any='UObject') -> None:
        """Finds or loads an asset by path, e.g. ``/Engine/BasicShapes/Cube.Cube``. Raises UnknownObject, WrongType."""
        self._call('load_object', class_argument(uclass), path)

    def load_class(self, path: str, uclass: Any='UObject') -> None:
        """Loads a class by path, also one defined in content (``/Game/BP_X.BP_X_C``)."""
        self._call('load_class', class_argument(uclass), path)

    def call_many(self, objects: Sequence[Any] | ObjectBase, function: str, /, *args: Any, **kwargs: Any) -> None:
        """Calls a function, by Unreal's name, for each of many objects, without a loop in Python.

        Each argument is one value for all calls, or, as a list, a tuple or an array, one for each call (of an array, a row):
        ``game.call_many(actors, "SetActorScale3D", NewScale3D=scales)`` with ``scales`` of shape (len(actors), 3). One object
        instead of a sequence is called again and again. The calls run in order, each on its own as if written out: all of them run, then the
        first that failed raises its error. Gives the results in order; ``game.async_`` a list of futures, ``game.send_`` nothing.
        Raises ValueError if the lengths differ.
        """
        self._session.call_many(objects, function, args, kwargs, self._mode)

    def get_class(self, uclass: Any) -> None:
        """The class itself, for static functions: ``game.get_class(UGameplayStatics).SetGamePaused(bPaused=True)``."""
        self._call('find_class', class_argument(uclass))

    def get_default_object(self, uclass: Any) -> None:
        """The class default object."""
        self._call('get_default_object', class_argument(uclass))

    def get_derived_classes(self, uclass: type[ObjectBase] | ClassLike, recursive: bool=True) -> None:
        """The classes that derive from a class."""
        self._call('get_derived_classes', class_argument(uclass), recursive)

    def get_unreal_object(self, uclass: Any) -> None:
        """The paper package's spelling of :meth:`get_class`."""
        self._call('find_class', class_argument(uclass))
