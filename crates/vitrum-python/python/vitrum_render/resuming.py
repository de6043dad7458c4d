"""Folders of pictures that are gone on with: a mark in each says which scene and which data it is of."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from .data import Mesh, Volume
from .errors import FileError, InvalidValue
from .remote import RemotePicture, marked, texts, write
from .scene import Scene

# Key of the mark in the metadata of a picture.
_KEY = "vitrum.frame"


def digest(data: Volume | Mesh | None, scene: Scene) -> str:
    """A hash of everything in the data; of the files that the scene names, where it names them."""
    found = hashlib.sha256()
    if isinstance(data, Volume):
        array = data.array
        found.update(repr((array.shape, array.dtype.str, data.scale, data.offset, data.affine.tolist(), data.orientation)).encode())
        found.update(array.data)
    elif isinstance(data, Mesh):
        found.update(data.positions.data)
        found.update(data.triangles.data)
    else:
        for path in _files(scene.to_dict()):
            _add_file(found, Path(path))
    return found.hexdigest()


def _files(value: Any) -> Iterator[str]:
    """The files that a scene names."""
    if isinstance(value, dict):
        for key, member in value.items():
            if key == "file" and isinstance(member, str):
                yield member
            else:
                yield from _files(member)
    elif isinstance(value, list):
        for member in value:
            yield from _files(member)


def _add_file(found: Any, path: Path) -> None:
    if path.is_dir():
        # A series of slices: their names and sizes tell it from another one.
        found.update(repr(sorted((entry.name, entry.stat().st_size) for entry in os.scandir(path))).encode())
    elif path.is_file():
        with open(path, "rb") as file:
            while block := file.read(1 << 20):
                found.update(block)


class Folder:
    """A folder of numbered pictures, one of each scene; it is made if it is missing.

    Raises
    ------
    FileError
        Where it cannot be made.
    """

    def __init__(self, path: Path, data: str, scenes: Sequence[Scene]) -> None:
        try:
            path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise FileError(f"{path}: the folder cannot be made: {error}", "choose another folder") from error
        self._path, self._data, self._scenes = path, data, scenes

    def _file(self, index: int) -> Path:
        return self._path / f"frame-{index:05}.png"

    def _mark(self, index: int) -> str:
        return hashlib.sha256(f"{self._data}\n{self._scenes[index].to_toml()}".encode()).hexdigest()

    def there(self) -> set[int]:
        """The pictures that are there already.

        Raises
        ------
        InvalidValue
            Where a file is of another scene, or of other data.
        """
        found = set()
        for index in range(len(self._scenes)):
            try:
                content = self._file(index).read_bytes()
            except FileNotFoundError:
                continue
            known = texts(content)
            mark = None if known is None else known[1].get(_KEY)
            if mark == self._mark(index):
                found.add(index)
                continue
            problem = "this picture is of another scene, or of other data" if mark else "nothing in this file says which scene it is of"
            raise InvalidValue(f"{self._file(index)}: {problem}", "leave out resume to render all pictures anew, or choose another folder")
        return found

    def read(self, index: int) -> RemotePicture:
        """The picture that is there already."""
        content = self._file(index).read_bytes()
        known = texts(content)
        size = (0, 0) if known is None else known[0]
        return RemotePicture(size, self._scenes[index], {}, {"png": content}, {}, None)

    def add(self, index: int, picture: RemotePicture) -> RemotePicture:
        """Writes a picture with its mark."""
        content = marked(picture.encode("png"), _KEY, self._mark(index))
        write(self._file(index), content)
        return replace(picture, encoded={**picture.encoded, "png": content})
