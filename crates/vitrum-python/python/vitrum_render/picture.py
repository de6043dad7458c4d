"""Finished pictures."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._native import Frame
from .errors import InvalidValue
from .scene import Scene

if TYPE_CHECKING:
    import PIL.Image
    import xarray


class Picture:
    """A finished picture: linear radiance and coverage, further outputs, the scene that it is of. In a notebook it shows itself.

    ``picture["depth"]`` is the output of that name (:func:`vitrum_render.outputs`): float32, (height, width) or (height, width, channels), row 0 on top.
    """

    __slots__ = ("_native",)
    _native: Frame

    def __init__(self, native: Frame) -> None:
        self._native = native

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self._native.size

    @property
    def color(self) -> npt.NDArray[np.float32]:
        """Red, green, blue and coverage, (height, width, 4), linear; colours are multiplied by coverage."""
        return self["color"]

    @property
    def outputs(self) -> list[str]:
        """Names of the outputs that the picture has."""
        return self._native.outputs

    @property
    def scene(self) -> Scene:
        """The scene that the picture is of."""
        return Scene._of(self._native.scene)

    @property
    def statistics(self) -> dict[str, Any]:
        """Sizes, counts, times in milliseconds, device and memory in bytes."""
        found: dict[str, Any] = json.loads(self._native.statistics())
        return found

    @property
    def annotations(self) -> str | None:
        """The annotations as an SVG document; ``None`` where the scene has none."""
        return self._native.annotations()

    def __getitem__(self, name: str) -> npt.NDArray[np.float32]:
        found = self._native.output(name)
        if found is None:
            raise InvalidValue(
                f"the picture has no output {name!r}, but {', '.join(self.outputs)}",
                f'ask for it: `render(…, outputs=("color", "{name}"))`',
            )
        return found

    def __contains__(self, name: object) -> bool:
        return name in self.outputs

    def channels(self, name: str = "color") -> list[str]:
        """Names of an output's channels, such as R, G, B and A."""
        return self._native.channels(name) or []

    def to_srgb8(self) -> npt.NDArray[np.uint8]:
        """The picture as screens show it, with annotations: uint8, (height, width, 4), the curve of sRGB, straight alpha."""
        return self._native.to_srgb8()

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        return np.array(self.color, dtype=dtype)

    def save(self, path: str | os.PathLike[str], *, bits: int = 8) -> None:
        """Writes the picture, whole or not at all, in the format of the extension: .png (8 or 16 ``bits``), .exr (every output that was asked for), .hdr, .tif, .jpg.

        Raises
        ------
        FileError
            Where it cannot be written.
        """
        self._native.save(os.fspath(path), bits)

    def encode(self, format: str = "png") -> bytes:
        """The bytes of a file of that format."""
        return self._native.encode(format)

    def to_pil(self) -> PIL.Image.Image:
        """The picture as screens show it, as an image of PIL."""
        import PIL.Image

        return PIL.Image.fromarray(self.to_srgb8())

    def to_xarray(self) -> xarray.Dataset:
        """All outputs of the picture's size, as a dataset with the dimensions y, x and the channels of each."""
        import xarray

        width, height = self.size
        arrays = {}
        for name in self.outputs:
            values = self[name]
            if values.shape[:2] != (height, width):
                continue
            if values.ndim == 2:
                arrays[name] = xarray.DataArray(values, dims=("y", "x"))
            else:
                channel = f"{name}_channel"
                arrays[name] = xarray.DataArray(values, dims=("y", "x", channel), coords={channel: self.channels(name)})
        return xarray.Dataset(arrays, attrs={"scene": self.scene.to_toml()})

    def _repr_png_(self) -> bytes:
        return self.encode("png")

    def __repr__(self) -> str:
        width, height = self.size
        return f"<Picture {width} × {height}: {', '.join(self.outputs)}>"
