"""Scenes: dicts that know their keys."""

from __future__ import annotations

import difflib
import json
import math
import os
import re
from collections.abc import Iterable, Iterator, Mapping, MutableMapping
from functools import lru_cache
from pathlib import Path
from typing import Any

from . import _native
from ._native import Scene as NativeScene
from .errors import SceneError

Settings = Mapping[str, Any] | Iterable[str]


@lru_cache(maxsize=1)
def _paths() -> frozenset[str]:
    """Every key and every section, with 0 for the items of lists."""
    paths: set[str] = set()
    for key in _native.keys():
        parts = key[0].split(".")
        paths.update(".".join(parts[: depth + 1]) for depth in range(len(parts)))
    return frozenset(paths)


def _check(path: str) -> None:
    """Raises for a path that no scene has."""
    general = re.sub(r"(?<=\.)\d+(?=\.|$)", "0", path)
    if general in _paths():
        return
    near = difflib.get_close_matches(general, _paths(), 1)
    last = general.rsplit(".", 1)[-1]
    behind = [known for known in sorted(_paths()) if known.endswith("." + last)]
    advice = f"did you mean `{(near or behind)[0]}`?" if near or behind else "`vitrum_render.keys()` lists the keys"
    raise SceneError(f"scenes have no key `{path}`", advice, path)


def toml_value(value: Any) -> str:
    """A value in the language of TOML, as ``Scene.set`` of the program takes it; ``none`` for ``None``."""
    if value is None:
        return "none"
    if isinstance(value, Section):
        value = value.to_python()
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else {True: "nan"}.get(math.isnan(value), "inf" if value > 0 else "-inf")
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, Mapping):
        members = (f"{json.dumps(str(key))} = {toml_value(member)}" for key, member in value.items() if member is not None)
        return "{ " + ", ".join(members) + " }"
    if isinstance(value, Iterable):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    raise SceneError(f"a {type(value).__name__} is no value of a scene", "give a number, a text, a list or a dict")


def assignments(settings: Settings | None) -> list[str]:
    """Settings as the program's ``KEY=VALUE``: of a mapping of keys to values, or of texts that are such already."""
    if settings is None:
        return []
    if isinstance(settings, str):
        return [settings]
    if isinstance(settings, Mapping):
        return [f"{key}={toml_value(value)}" for key, value in settings.items()]
    return list(settings)


class _Keys(MutableMapping[str, Any]):
    """Keys that are attributes, too."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __setattr__(self, name: str, value: Any) -> None:
        self[name] = value


class Section(_Keys):
    """A part of a scene, such as ``scene.camera`` or ``scene.light[0]``: reading and writing it reads and writes the scene."""

    __slots__ = ("_path", "_scene")

    def __init__(self, scene: Scene, path: str) -> None:
        object.__setattr__(self, "_scene", scene)
        object.__setattr__(self, "_path", path)

    def to_python(self) -> Any:
        """The section as dicts and lists of its own."""
        return self._scene._value(self._path)

    def __getitem__(self, key: str | int) -> Any:
        if isinstance(key, int):
            count = len(self)
            if not -count <= key < count:
                raise IndexError(f"`{self._path}` has {count} items")
            key %= count
        return self._scene[f"{self._path}.{key}"]

    def __setitem__(self, key: str | int, value: Any) -> None:
        self._scene[f"{self._path}.{key}"] = value

    def __delitem__(self, key: str | int) -> None:
        del self._scene[f"{self._path}.{key}"]

    def __iter__(self) -> Iterator[Any]:
        value = self.to_python()
        return iter(value) if isinstance(value, dict) else (self[index] for index in range(len(value)))

    def __len__(self) -> int:
        return len(self.to_python())

    def __dir__(self) -> list[str]:
        value = self.to_python()
        return [*super().__dir__(), *(value if isinstance(value, dict) else [])]

    def __eq__(self, other: object) -> bool:
        return bool(self.to_python() == (other.to_python() if isinstance(other, Section) else other))

    def __repr__(self) -> str:
        return f"{self._path}: {self.to_python()!r}"


class Scene(_Keys):
    """Everything that a picture is made of, but the data: camera, lights, transfer functions, film.

    Keys are those of scene files (``docs/scene.md``, :func:`vitrum_render.keys`), by dotted path or by attributes. A key that does not exist, a value of the
    wrong type and one out of its range raise :class:`SceneError`, with the nearest name.

    >>> scene = Scene()
    >>> scene["camera.azimuth"] = 30
    >>> scene.camera.azimuth
    30.0
    >>> scene.film.width = 320
    >>> scene.camera.azimut = 30
    Traceback (most recent call last):
    ...
    vitrum_render.errors.SceneError: ...

    Parameters
    ----------
    settings : mapping or list of str, optional
        Keys to set, as in :meth:`set`.
    """

    __slots__ = ("_native",)
    _native: NativeScene

    def __init__(self, settings: Settings | None = None) -> None:
        object.__setattr__(self, "_native", _native.Scene())
        if settings is not None:
            self.set(settings)

    @classmethod
    def _of(cls, native: NativeScene) -> Scene:
        scene = cls.__new__(cls)
        object.__setattr__(scene, "_native", native)
        return scene

    @classmethod
    def from_toml(cls, text: str, name: str = "scene") -> Scene:
        """The scene of a scene file's text; ``name`` stands for the file in messages.

        Raises
        ------
        SceneError
            With the line, where a key does not exist or its value is not valid.
        """
        return cls._of(_native.Scene(text, name))

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Scene:
        """The scene of a scene file. Relative paths in it start at the file's folder and are made absolute."""
        file = Path(path)
        scene = cls.from_toml(file.read_text(encoding="utf-8"), str(path))
        return cls._of(scene._native.free_of(str(file.parent)))

    def to_toml(self) -> str:
        """The text of a scene file, with every key that has a value."""
        return self._native.to_toml()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a scene file."""
        Path(path).write_text(self.to_toml(), encoding="utf-8")

    def to_dict(self) -> dict[str, Any]:
        """The scene as dicts and lists of its own."""
        found: dict[str, Any] = json.loads(self._native.to_json())
        return found

    def copy(self) -> Scene:
        """A scene of its own with the same keys."""
        return self._of(self._native.copy())

    def check(self) -> None:
        """Raises :class:`SceneError` where keys contradict each other."""
        self._native.check()

    def set(self, *settings: Settings, **sections: Any) -> Scene:
        """Sets keys, one after the other, all or none; the scene itself is returned.

        Parameters
        ----------
        *settings
            Mappings of keys to values, such as ``{"camera.azimuth": 30}``; texts such as ``"camera.azimuth=30"``. ``None`` removes an optional key.
        **sections
            Keys of the scene itself, such as ``method="beams"``.
        """
        native = self._native.copy()
        for setting in (*settings, sections):
            for assignment in assignments(setting):
                native.set(assignment)
        object.__setattr__(self, "_native", native)
        return self

    def _value(self, path: str) -> Any:
        value: Any = self.to_dict()
        for part in path.split("."):
            try:
                value = value[int(part)] if isinstance(value, list) else value.get(part)
            except (IndexError, ValueError, AttributeError):
                return None
        return value

    def __getitem__(self, key: str) -> Any:
        _check(key)
        value = self._value(key)
        is_section = isinstance(value, dict) or (isinstance(value, list) and any(isinstance(item, dict) for item in value))
        return Section(self, key) if is_section else value

    def __setitem__(self, key: str, value: Any) -> None:
        self.set({key: value})

    def __delitem__(self, key: str) -> None:
        self.set({key: None})

    def __iter__(self) -> Iterator[str]:
        return iter(self.to_dict())

    def __len__(self) -> int:
        return len(self.to_dict())

    def __contains__(self, key: object) -> bool:
        return isinstance(key, str) and self._value(key) is not None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.to_dict()]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self._native == other._native

    def __reduce__(self) -> tuple[Any, ...]:
        return (_of_json, (self._native.to_json(),))

    def __repr__(self) -> str:
        return self.to_toml()


def _of_json(text: str) -> Scene:
    return Scene._of(_native.Scene.of_json(text))
