"""Comparisons of pictures."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from .errors import InvalidValue
from .picture import Picture


@dataclass(frozen=True)
class Difference:
    """The differences of two pictures in linear RGB; the first is the reference.

    Attributes
    ----------
    max_abs, rmse : float
        The largest difference of a channel, and the root of the mean squared difference; infinite where a channel is NaN.
    psnr : float
        Decibels, 20 log10(peak / rmse); infinite for equal pictures.
    mean_flip : float
        The mean ꟻLIP error, 0 to 1, of what a screen shows.
    peak : float
        The largest finite magnitude in the reference.
    worst_pixel : (int, int) or None
        Column and row of the first pixel with the largest difference; ``None`` where none differs.
    """

    max_abs: float
    rmse: float
    psnr: float
    mean_flip: float
    peak: float
    worst_pixel: tuple[int, int] | None


def diff(a: Picture | npt.ArrayLike, b: Picture | npt.ArrayLike) -> Difference:
    """Compares two pictures, as ``vitrum diff`` does: pictures, or arrays (height, width, 3 or 4), linear.

    >>> diff(np.zeros((20, 20, 3)), np.zeros((20, 20, 3))).max_abs
    0.0
    """
    found: dict[str, Any] = json.loads(_native.diff(_pixels(a), _pixels(b)))
    infinite = {"max_abs": np.inf, "rmse": np.inf, "psnr": np.inf if found["rmse"] == 0 else -np.inf}
    numbers = {name: infinite[name] if found[name] is None else float(found[name]) for name in infinite}
    worst = found["worst_pixel"]
    return Difference(
        **numbers,
        mean_flip=float("nan") if found["mean_flip"] is None else float(found["mean_flip"]),
        peak=float(found["peak"]),
        worst_pixel=None if worst is None else (worst[0], worst[1]),
    )


def _pixels(picture: Picture | npt.ArrayLike) -> npt.NDArray[np.float32]:
    array = np.asarray(picture.color if isinstance(picture, Picture) else picture, dtype=np.float32)
    if array.ndim != 3 or array.shape[2] not in (3, 4) or array.size == 0:
        raise InvalidValue(f"an array of shape {array.shape} is no picture", "give (height, width, 3 or 4)")
    return np.ascontiguousarray(array[:, :, :3])
