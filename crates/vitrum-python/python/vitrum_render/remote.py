"""Pictures that were made by another process: plain arrays and bytes, which travel."""

from __future__ import annotations

import os
import struct
import tempfile
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import FileError, InvalidValue
from .picture import Picture
from .scene import Scene

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_BACKGROUND = 255


@dataclass(frozen=True)
class RemotePicture:
    """A finished picture, as :class:`vitrum_render.Picture` is one, but of arrays alone; in a notebook it shows itself.

    ``picture["depth"]`` is the output of that name: float32, (height, width) or (height, width, channels), row 0 on top.

    Attributes
    ----------
    size : (int, int)
        Width and height in pixels.
    scene : Scene
        The scene that the picture is of.
    statistics : dict
        Sizes, counts, times in milliseconds, device and memory in bytes; empty for a picture that was read from a file.
    encoded : dict of str to bytes
        The bytes of a file in each format that was asked for.
    """

    size: tuple[int, int]
    scene: Scene
    statistics: dict[str, Any] = field(repr=False)
    encoded: dict[str, bytes] = field(repr=False)
    arrays: dict[str, npt.NDArray[np.float32]] = field(repr=False)
    screen: npt.NDArray[np.uint8] | None = field(repr=False)

    @classmethod
    def of(cls, picture: Picture, formats: Sequence[str] = ("png",)) -> RemotePicture:
        """The same picture as arrays and as files of these formats."""
        arrays = {name: np.asarray(picture[name]) for name in picture.outputs}
        encoded = {name: picture.encode(name) for name in formats}
        return cls(picture.size, picture.scene, picture.statistics, encoded, arrays, picture.to_srgb8())

    @property
    def color(self) -> npt.NDArray[np.float32]:
        """Red, green, blue and coverage, (height, width, 4), linear; colours are multiplied by coverage."""
        return self["color"]

    @property
    def outputs(self) -> list[str]:
        """Names of the outputs that the picture has; none for a picture that was read from a file."""
        return list(self.arrays)

    def __getitem__(self, name: str) -> npt.NDArray[np.float32]:
        if name not in self.arrays:
            has = ", ".join(self.arrays) if self.arrays else "its file alone, which was there already"
            raise InvalidValue(f"the picture has no output {name!r}, but {has}", f'ask for it: `outputs=("color", "{name}")`, without `resume`')
        return self.arrays[name]

    def __contains__(self, name: object) -> bool:
        return name in self.arrays

    def to_srgb8(self) -> npt.NDArray[np.uint8]:
        """The picture as screens show it: uint8, (height, width, 4), the curve of sRGB, straight alpha."""
        if self.screen is not None:
            return self.screen
        import io

        import PIL.Image

        return np.asarray(PIL.Image.open(io.BytesIO(self.encode())).convert("RGBA"))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        return np.array(self.color, dtype=dtype)

    def encode(self, format: str = "png") -> bytes:
        """The bytes of a file of that format.

        Raises
        ------
        InvalidValue
            For a format that was not asked for.
        """
        if format not in self.encoded:
            raise InvalidValue(f"the picture was not encoded as {format!r}, but as {', '.join(self.encoded)}", f'ask for it: `formats=("png", "{format}")`')
        return self.encoded[format]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the picture, whole or not at all, in the format of the extension, which is one of :attr:`encoded`."""
        write(Path(path), self.encode(Path(path).suffix.lstrip(".").lower()))

    def _repr_png_(self) -> bytes:
        return self.encode("png")


class Grid(Mapping[tuple[Any, ...], RemotePicture]):
    """Pictures by the values that they were made with: ``grid[40, "haze"]``, in the order of the values, the last key's first.

    Attributes
    ----------
    keys_swept : tuple of str
        The names of the keys, in the order of the values.
    values_swept : tuple of tuples
        The values of each key.
    """

    def __init__(self, swept: Mapping[str, Sequence[Any]], pictures: Mapping[tuple[Any, ...], RemotePicture]) -> None:
        self.keys_swept = tuple(swept)
        self.values_swept = tuple(tuple(values) for values in swept.values())
        self._pictures = dict(pictures)

    def __getitem__(self, values: Any) -> RemotePicture:
        picture: RemotePicture = self._pictures[values if isinstance(values, tuple) else (values,)]
        return picture

    def __iter__(self) -> Iterator[tuple[Any, ...]]:
        return iter(self._pictures)

    def __len__(self) -> int:
        return len(self._pictures)

    def to_numpy(self) -> npt.NDArray[np.float32]:
        """Colours of all pictures: float32, (values of the first key, values of the second, …, height, width, 4), linear."""
        colors = np.stack([picture.color for picture in self.values()])
        return colors.reshape(*(len(values) for values in self.values_swept), *colors.shape[1:])

    def contact_sheet(self, gap: int = 4) -> npt.NDArray[np.uint8]:
        """The pictures side by side as screens show them: uint8, (height, width, 4). The last key changes from left to right, the others from top to bottom."""
        screens = [picture.to_srgb8() for picture in self.values()]
        columns = len(self.values_swept[-1])
        rows = len(screens) // columns
        height, width = (max(screen.shape[axis] for screen in screens) for axis in (0, 1))
        sheet = np.full((rows * (height + gap) - gap, columns * (width + gap) - gap, 4), _BACKGROUND, np.uint8)
        for index, screen in enumerate(screens):
            top, left = index // columns * (height + gap), index % columns * (width + gap)
            sheet[top : top + screen.shape[0], left : left + screen.shape[1]] = screen
        return sheet

    def _repr_png_(self) -> bytes:
        return png(self.contact_sheet())

    def __repr__(self) -> str:
        axes = " × ".join(f"{len(values)} {key}" for key, values in zip(self.keys_swept, self.values_swept, strict=True))
        return f"<Grid of {len(self)} pictures: {axes}>"


def write(path: Path, content: bytes) -> None:
    """Writes a file, whole or not at all.

    Raises
    ------
    FileError
        Where it cannot be written.
    """
    try:
        handle, name = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        try:
            with open(handle, "wb") as file:
                file.write(content)
            os.chmod(name, 0o666 & ~_umask())
            os.replace(name, path)
        except BaseException:
            os.unlink(name)
            raise
    except OSError as error:
        raise FileError(f"{path}: the picture cannot be written: {error}", "choose another folder") from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _chunk(kind: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def png(rgba: npt.NDArray[np.uint8]) -> bytes:
    """The bytes of a PNG of uint8, (height, width, 4)."""
    height, width, _ = rgba.shape
    rows = np.zeros((height, 1 + 4 * width), np.uint8)
    rows[:, 1:] = rgba.reshape(height, -1)
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return _SIGNATURE + _chunk(b"IHDR", header) + _chunk(b"IDAT", zlib.compress(rows.tobytes())) + _chunk(b"IEND", b"")


def marked(content: bytes, key: str, text: str) -> bytes:
    """A PNG with a text in its metadata, behind its header."""
    end = len(_SIGNATURE) + 12 + int.from_bytes(content[8:12], "big")
    return content[:end] + _chunk(b"iTXt", key.encode() + b"\0\0\0\0\0" + text.encode()) + content[end:]


def texts(content: bytes) -> tuple[tuple[int, int], dict[str, str]] | None:
    """Width and height of a whole PNG, and the texts in its metadata; ``None`` for other files and damaged ones."""
    if content[:8] != _SIGNATURE or content[12:16] != b"IHDR" or not content.endswith(_chunk(b"IEND", b"")):
        return None
    found: dict[str, str] = {}
    width, height = struct.unpack(">II", content[16:24])
    place = len(_SIGNATURE)
    while place + 12 <= len(content):
        length = int.from_bytes(content[place : place + 4], "big")
        kind, inside = content[place + 4 : place + 8], content[place + 8 : place + 8 + length]
        if kind == b"iTXt" and b"\0" in inside:
            found[inside.split(b"\0", 1)[0].decode("latin-1")] = inside.rsplit(b"\0", 1)[1].decode("utf-8", "replace")
        place += 12 + length
    return (width, height), found
