"""Volumes and meshes."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native, arrays
from ._native import Mesh as NativeMesh
from ._native import Volume as NativeVolume
from .arrays import Nan
from .errors import InvalidValue


class Volume:
    """A scalar volume in memory, with its place in the world.

    Parameters
    ----------
    array : array (z, y, x)
        Any NumPy type of real numbers, any strides.
    spacing : float or (float, float, float), optional
        Distances between voxel centres in the array's order, z, y, x; 1 if absent.
    affine : (4, 4) array, optional
        In NIfTI's sense, instead of ``spacing``: from indices (x, y, z), the last axis of the array first, to a patient's RAS+ world in millimetres.
    name : str
        For messages.
    nan : "error" or "nothing"
        Whether NaN is refused, or shown as nothing; the same holds of infinities, which take the ends of the finite range.

    Raises
    ------
    InvalidValue
        For an array that is no volume, or a spacing that is none.

    >>> volume = Volume(np.zeros((4, 5, 6), np.int16), spacing=(2, 1, 1))
    >>> volume.shape, volume.spacing
    ((4, 5, 6), (2.0, 1.0, 1.0))
    """

    __slots__ = ("_native",)
    _native: NativeVolume

    def __init__(
        self,
        array: npt.ArrayLike,
        spacing: Any = None,
        *,
        affine: Any = None,
        name: str = "array",
        nan: Nan = "error",
    ) -> None:
        if spacing is not None and affine is not None:
            raise InvalidValue("spacing and affine are both given", "an affine matrix has the spacing in it")
        steps = arrays.spacing(1.0 if spacing is None else spacing)
        placement = None if affine is None else arrays.columns(affine)
        voxels, scale, offset = arrays.stored(array, nan)
        native = _native.Volume(voxels, name, steps, scale, offset)
        self._native = native if placement is None else native.placed(*placement, "patient")

    @classmethod
    def _of(cls, native: NativeVolume) -> Volume:
        volume = cls.__new__(cls)
        volume._native = native
        return volume

    def _columns(self) -> npt.NDArray[np.float64]:
        return np.asarray(self._native.axes, dtype=np.float64) * np.asarray(self._native.spacing, dtype=np.float64)[:, None]

    def _with_orientation(self, orientation: str) -> Volume:
        native = self._native
        return self._of(native.placed(self._columns().tolist(), list(native.origin), orientation))

    def with_spacing(self, spacing: Any) -> Volume:
        """The volume with other distances between voxels, in the array's order; the middle stays where it is."""
        return self._of(self._native.with_spacing(arrays.spacing(spacing)))

    @property
    def name(self) -> str:
        """The file's path, or the name that was given."""
        return self._native.name

    @property
    def array(self) -> npt.NDArray[Any]:
        """The stored voxels, (z, y, x), read-only, without a copy: uint8, uint16 or float32. :attr:`values` has the physical values."""
        return self._native.array

    @property
    def scale(self) -> float:
        """``values = array * scale + offset``."""
        return self._native.value_mapping[0]

    @property
    def offset(self) -> float:
        """See :attr:`scale`."""
        return self._native.value_mapping[1]

    @property
    def values(self) -> npt.NDArray[np.float32]:
        """The physical values, (z, y, x), float32; a copy, unless the stored voxels are these."""
        if self.array.dtype == np.float32 and (self.scale, self.offset) == (1.0, 0.0):
            return self.array
        scaled: npt.NDArray[np.float32] = self.array * np.float32(self.scale) + np.float32(self.offset)
        return scaled

    @property
    def shape(self) -> tuple[int, int, int]:
        """Voxels along z, y and x."""
        x, y, z = self._native.dimensions
        return z, y, x

    @property
    def is_paged(self) -> bool:
        """Whether the voxels stay in their file, of which pages are read as planes come to them; :attr:`array` and :attr:`values` raise then."""
        return self._native.is_paged

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Distances between voxel centres along z, y and x, in millimetres where the file knows its unit."""
        x, y, z = self._native.spacing
        return z, y, x

    @property
    def affine(self) -> npt.NDArray[np.float64]:
        """The 4 × 4 matrix from indices (x, y, z), the array's last axis first, to the world: RAS+ where :attr:`orientation` is ``patient``."""
        affine = np.eye(4)
        affine[:3, :3] = self._columns().T
        affine[:3, 3] = self._native.origin
        return affine

    @property
    def orientation(self) -> str:
        """``patient``, ``world`` or ``unknown``."""
        return self._native.orientation

    @property
    def range(self) -> tuple[float, float]:
        """The least and the greatest physical value."""
        low, high = self._native.range
        return low, high

    @property
    def labels(self) -> dict[float, str] | None:
        """Values of labels with their names, empty where the file names none; ``None`` where the values are measurements."""
        found = self._native.labels
        return None if found is None else {value: name for value, name, _ in found}

    @property
    def notes(self) -> list[str]:
        """What the reader took for granted, and what it left out."""
        return self._native.notes

    def histogram(
        self, bins: int = 256, range: tuple[float, float] | None = None
    ) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.float64]]:
        """Counts and edges of equal parts of a range of values, as ``np.histogram`` gives them; values outside count to the first and the last part."""
        low, high = self.range if range is None else range
        counts = np.asarray(self._native.histogram(bins, (low, high)), dtype=np.int64)
        return counts, np.linspace(low, high, bins + 1)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        return np.array(self.values, dtype=dtype, copy=True if copy is None else copy)

    def __reduce__(self) -> tuple[Any, ...]:
        native = self._native
        placement = (self._columns().tolist(), list(native.origin), native.orientation)
        return (_volume, (np.array(self.array), native.name, native.spacing, native.value_mapping, placement))

    def __repr__(self) -> str:
        z, y, x = self.shape
        low, high = self.range
        spacing = " × ".join(f"{step:g}" for step in self.spacing)
        return f"<Volume {self.name!r}: {z} × {y} × {x} {self._native.dtype}, spacing {spacing} (z, y, x), values {low:g} to {high:g}>"


def _volume(array: Any, name: str, spacing: Any, mapping: Any, placement: Any) -> Volume:
    return Volume._of(_native.Volume(array, name, spacing, *mapping).placed(*placement))


class Mesh:
    """A triangle mesh in memory.

    Parameters
    ----------
    positions : array (n, 3)
        Vertices.
    triangles : array (m, 3)
        Indices of vertices; seen from outside they run counterclockwise.
    colors : array (n, 3) or (n, 4), optional
        Linear RGB, 0 to 1, and alpha.

    Raises
    ------
    InvalidValue, FileError
        Where an index names no vertex, or a coordinate is not finite.
    """

    __slots__ = ("_native",)
    _native: NativeMesh

    def __init__(self, positions: npt.ArrayLike, triangles: npt.ArrayLike, *, colors: npt.ArrayLike | None = None, name: str = "mesh") -> None:
        vertices = _rows(positions, np.float32, (3,), "positions")
        faces = np.asarray(triangles)
        if faces.dtype.kind not in "iu" or faces.ndim != 2 or faces.shape[1] != 3:
            raise InvalidValue(f"triangles of shape {faces.shape} and type {faces.dtype}", "give whole numbers, (m, 3)")
        if faces.size and not (0 <= int(faces.min()) and int(faces.max()) < len(vertices)):
            raise InvalidValue("a triangle names a vertex that is not there", f"indices go from 0 to {len(vertices) - 1}")
        rgba = None
        if colors is not None:
            rgba = _rows(colors, np.float32, (3, 4), "colors")
            if len(rgba) != len(vertices):
                raise InvalidValue(f"{len(rgba)} colours for {len(vertices)} vertices", "give one for each vertex")
            if rgba.shape[1] == 3:
                rgba = np.concatenate([rgba, np.ones((len(rgba), 1), np.float32)], axis=1)
        self._native = _native.Mesh(name, vertices, np.ascontiguousarray(faces, dtype=np.uint32), rgba)

    @classmethod
    def _of(cls, native: NativeMesh) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._native = native
        return mesh

    @property
    def name(self) -> str:
        """The file's path, or the name that was given."""
        return self._native.name

    @property
    def positions(self) -> npt.NDArray[np.float32]:
        """Vertices, (n, 3), read-only, without a copy."""
        return self._native.positions

    @property
    def triangles(self) -> npt.NDArray[np.uint32]:
        """Indices of vertices, (m, 3), read-only, without a copy."""
        return self._native.triangles

    @property
    def bounds(self) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
        """The low and the high corner of the smallest box around the vertices."""
        low, high = (tuple(corner) for corner in self._native.bounds)
        return low, high  # type: ignore[return-value]

    @property
    def materials(self) -> list[str]:
        """Names of the materials."""
        return self._native.materials

    @property
    def notes(self) -> list[str]:
        """What the reader took for granted, and what it left out."""
        return self._native.notes

    def __reduce__(self) -> tuple[Any, ...]:
        return (_mesh, (np.array(self.positions), np.array(self.triangles), self.name))

    def __repr__(self) -> str:
        return f"<Mesh {self.name!r}: {len(self.positions)} vertices, {len(self.triangles)} triangles>"


def _mesh(positions: Any, triangles: Any, name: str) -> Mesh:
    return Mesh(positions, triangles, name=name)


def _rows(values: npt.ArrayLike, dtype: Any, widths: tuple[int, ...], what: str) -> npt.NDArray[Any]:
    array = np.ascontiguousarray(values, dtype=dtype)
    if array.ndim != 2 or array.shape[1] not in widths:
        raise InvalidValue(f"{what} of shape {array.shape}", f"give (n, {' or '.join(str(width) for width in widths)})")
    return array


def open(
    path: str | os.PathLike[str],
    *,
    spacing: Any = None,
    up: str | None = None,
    array: str | None = None,
    time: int | None = None,
    seconds: float | None = None,
    raw: str | None = None,
    max_bytes: int | None = None,
    paged: bool = False,
) -> Volume | Mesh:
    """Reads the volume or the mesh of a file or a folder: NRRD, NIfTI, MetaImage, VTK, NumPy, TIFF, DICOM, raw; OBJ, PLY, STL, glTF.

    Parameters
    ----------
    path : path
        The file, or a folder of DICOM or TIFF files.
    spacing : float or (float, float, float), optional
        Distances between voxels, z, y, x, instead of the file's.
    up : str, optional
        The direction that is turned upwards, such as ``superior`` or ``-y``.
    array : str, optional
        The name of one of several arrays, or the number of a channel, from 1.
    time, seconds : int, float, optional
        The point in time of a file with several, by index from 0 or by time.
    raw : str, optional
        The layout of a file without a header, such as ``256x256x109:u8``, x first.
    max_bytes : int, optional
        The most memory that the data may take; the machine's without it.
    paged : bool
        Whether the voxels stay in the file even where the memory has room for them; those that it has no room for stay there anyway. For uncompressed
        volumes in one file.

    Raises
    ------
    FileError
        Where the file cannot be read or is damaged.
    """
    steps = None if spacing is None else arrays.spacing(spacing)
    found = _native.open(os.fspath(path), raw, array, time, seconds, up, steps, max_bytes, paged)
    return Volume._of(found) if isinstance(found, _native.Volume) else Mesh._of(found)
