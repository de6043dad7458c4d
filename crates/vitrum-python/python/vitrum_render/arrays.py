"""Arrays of any type and layout as the three types that kernels take."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from .errors import InvalidValue

Nan = Literal["error", "nothing"]

_SIXTEEN_BITS = 0xFFFF


def stored(array: Any, nan: Nan = "error") -> tuple[npt.NDArray[Any], float, float]:
    """C-contiguous voxels of uint8, uint16 or float32, and scale and offset: ``value = voxel * scale + offset``.

    Integers keep every value where their range fits into 16 bits, and become float32 where it does not.

    Raises
    ------
    InvalidValue
        For an array that is not three-dimensional, is empty, or whose type holds no real numbers; for NaN where ``nan`` is ``"error"``.
    """
    if nan not in ("error", "nothing"):
        raise InvalidValue(f"nan={nan!r}", 'give "error" or "nothing"')
    array = np.asarray(array)
    if array.dtype.kind not in "buif":
        raise InvalidValue(f"an array of {array.dtype} holds no real numbers", "convert it, such as by `array.astype(np.float32)`")
    if array.ndim != 3:
        advice = {
            2: "a volume has three: stack slices by `np.stack`",
            4: "pick one channel or one point in time, such as `array[0]`; `vitrum_render.dask.timeseries` shows all points in time",
        }.get(array.ndim, "a volume has three: z, y, x")
        raise InvalidValue(f"an array of {array.ndim} dimensions, {array.shape}, is no volume", advice)
    if array.size == 0:
        raise InvalidValue(f"an array of shape {array.shape} has no voxels", "give at least one voxel along each axis")
    if not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        return np.ascontiguousarray(array).view(np.uint8), 1.0, 0.0
    if kind == "u" and size <= 2:
        return np.ascontiguousarray(array), 1.0, 0.0
    if kind == "i" and size <= 2:
        # Shifted, so that the least value is 0.
        unsigned = np.dtype(f"u{size}").type
        half = 1 << (8 * size - 1)
        return np.ascontiguousarray(array).view(unsigned) ^ unsigned(half), 1.0, -float(half)
    if kind in "iu":
        return _integers(array)
    return _floats(array, nan), 1.0, 0.0


def _integers(array: npt.NDArray[Any]) -> tuple[npt.NDArray[Any], float, float]:
    least, greatest = int(array.min()), int(array.max())
    if greatest - least <= _SIXTEEN_BITS and abs(least) < 1 << 24:
        shifted = (array - array.dtype.type(least)).astype(np.uint16)
        return np.ascontiguousarray(shifted), 1.0, float(least)
    return np.ascontiguousarray(array, dtype=np.float32), 1.0, 0.0


def _floats(array: npt.NDArray[Any], nan: Nan) -> npt.NDArray[np.float32]:
    count = int(np.isnan(array).sum())
    if count and nan == "error":
        advice = 'nan="nothing" shows them as nothing; `np.nan_to_num` replaces them'
        raise InvalidValue(f"{count} of {array.size} voxels are NaN", advice)
    with np.errstate(over="ignore"):
        narrow = np.ascontiguousarray(array, dtype=np.float32)
    infinite = int(np.isinf(narrow).sum())
    if infinite and nan == "error":
        advice = 'nan="nothing" gives them the ends of the finite range; `np.clip` replaces them'
        raise InvalidValue(f"{infinite} of {array.size} voxels are infinite or beyond float32", advice)
    return narrow


def spacing(value: Any) -> tuple[float, float, float]:
    """Spacing in the order x, y, z, from one number or from three in the array's order z, y, x.

    Raises
    ------
    InvalidValue
        Where a distance is not finite and above 0.
    """
    try:
        numbers = np.broadcast_to(np.asarray(value, dtype=np.float64), (3,))
    except (TypeError, ValueError):
        raise InvalidValue(f"spacing={value!r}", "give one distance, or three in the array's order: z, y, x") from None
    if not (np.isfinite(numbers).all() and (numbers > 0).all()):
        raise InvalidValue(f"spacing={value!r}", "distances are finite and above 0")
    z, y, x = (float(number) for number in numbers)
    return x, y, z


def columns(affine: Any) -> tuple[list[list[float]], list[float]]:
    """The world's steps along x, y and z, and the position of voxel (0, 0, 0), of a 4 × 4 matrix.

    Raises
    ------
    InvalidValue
        Where it is no affine matrix of finite numbers.
    """
    try:
        matrix = np.asarray(affine, dtype=np.float64)
    except (TypeError, ValueError):
        matrix = np.empty(0)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all() or not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise InvalidValue(f"affine={affine!r}", "give a 4 × 4 matrix of finite numbers whose last row is 0, 0, 0, 1")
    return matrix[:3, :3].T.tolist(), matrix[:3, 3].tolist()
