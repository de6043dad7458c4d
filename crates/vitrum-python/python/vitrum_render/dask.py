"""Pictures on many machines, by Dask: animations, sweeps over parameters, time series.

Each worker opens its device itself, and keeps the session and the data. Pictures come in order, and a bounded number is on its way. What a worker that ended
had not handed over is done again by another one. Without a client, and where there is none (``distributed.get_client``), the pictures are made here.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from .data import Mesh, Volume
from .errors import InvalidValue
from .inputs import subject
from .remote import Grid, RemotePicture
from .resuming import Folder, digest
from .scene import Scene, assignments
from .session import LOOK, Session, frames_of
from .sharing import Device, Result, Series, Views, pictures

__all__ = ["Grid", "RemotePicture", "sweep", "timeseries", "turntable"]


def turntable(
    data: Any = None,
    frames: int = 72,
    client: Any = None,
    *,
    turn: float = 360.0,
    spacing: Any = None,
    outputs: Sequence[str] = ("color",),
    formats: Sequence[str] = ("png",),
    resume: str | os.PathLike[str] | None = None,
    in_flight: int | None = None,
    resources: Mapping[str, float] | None = None,
    backend: str = "auto",
    adapter: str | None = None,
    threads: int | None = None,
    memory_limit: int | None = None,
    **look: Any,
) -> Iterator[RemotePicture]:
    """Pictures of the camera going round, in order.

    Parameters
    ----------
    data : array (z, y, x), Volume, Mesh, path, Scene, or data of another package
        As :class:`vitrum_render.Session` takes it; arrays are sent to each worker once, and each worker reads a path itself. A scene names its data.
    frames : int
        Pictures of the whole way.
    client : distributed.Client, optional
        Whose workers make the pictures.
    turn : float
        How far the camera goes, in degrees; negative to the left.
    spacing : float or (float, float, float), optional
        Distances between voxels in the array's order, z, y, x.
    outputs : sequence of str
        Names of outputs that the pictures have (:func:`vitrum_render.outputs`).
    formats : sequence of str
        Formats as which the workers encode the pictures: png, exr, hdr, tif, jpg.
    resume : path, optional
        A folder into which the pictures are written, ``frame-00000.png`` and so on. Those that are there already are not rendered again: they come without
        their outputs.
    in_flight : int, optional
        The most pictures that are rendered or wait for their turn; four for each thread of the workers without it.
    resources : mapping, optional
        Of Dask, such as ``{"GPU": 1}``, for clusters whose workers have been started with them.
    backend, adapter, threads, memory_limit
        As :class:`vitrum_render.Session` takes them, on each worker; ``threads`` are the worker's without it.
    **look
        ``scene``, ``preset``, ``size``, ``settings``, ``affine``, ``nan`` and the others of :class:`vitrum_render.Session`.

    Raises
    ------
    InvalidValue, SceneError, FileError, DeviceError
        As :class:`vitrum_render.Session`; InvalidValue, too, where a picture in the folder is of another scene or of other data.
    """
    if resume is not None and "png" not in formats:
        raise InvalidValue("the pictures of a folder are PNG", 'add "png" to formats')
    data, look = _placed(data, spacing, look)
    with _composer(data, look) as session:
        moments = frames_of(session.framed_all_round(), frames, turn)
    token = digest(_sent(data), moments[0])
    folder = None if resume is None else Folder(Path(resume), token, moments)
    device = Device(backend, adapter, threads, memory_limit)
    job = Views(_sent(data), token, moments, Result(tuple(outputs), tuple(formats)), device)
    return pictures(job, frames, client, in_flight, resources, folder)


def sweep(
    data: Any,
    values: Mapping[str, Sequence[Any]],
    client: Any = None,
    *,
    spacing: Any = None,
    outputs: Sequence[str] = ("color",),
    formats: Sequence[str] = ("png",),
    in_flight: int | None = None,
    resources: Mapping[str, float] | None = None,
    backend: str = "auto",
    adapter: str | None = None,
    threads: int | None = None,
    memory_limit: int | None = None,
    **look: Any,
) -> Grid:
    """A picture for every combination of values.

    Parameters
    ----------
    data : array (z, y, x), Volume, Mesh, path, Scene, or data of another package
        As of :func:`turntable`.
    values : mapping of str to sequences
        Keys of the scene and arguments of :class:`vitrum_render.Session` that make the look, with the values of each:
        ``{"light.0.azimuth": [-40, 0, 40], "preset": ["haze", "plain"]}``. Values of keys are applied after ``settings``.
    client, spacing, outputs, formats, in_flight, resources, backend, adapter, threads, memory_limit, **look
        As of :func:`turntable`.

    Returns
    -------
    Grid
        The pictures by the tuples of values.
    """
    if not values or any(len(each) == 0 for each in values.values()):
        raise InvalidValue("a sweep without values", 'give some for each key, such as {"light.0.azimuth": [-40, 0, 40]}')
    data, look = _placed(data, spacing, look)
    given = assignments(look.pop("settings", None))
    combinations = list(itertools.product(*values.values()))
    with _composer(data, look) as session:
        scenes = []
        for combination in combinations:
            chosen = dict(zip(values, combination, strict=True))
            arguments = {key: value for key, value in chosen.items() if key in LOOK}
            keys = {key: value for key, value in chosen.items() if key not in LOOK}
            scenes.append(session.composed(**{**look, **arguments, "settings": [*given, *assignments(keys)]}))
    token = digest(_sent(data), scenes[0])
    device = Device(backend, adapter, threads, memory_limit)
    job = Views(_sent(data), token, scenes, Result(tuple(outputs), tuple(formats)), device)
    made = pictures(job, len(scenes), client, in_flight, resources)
    return Grid(values, dict(zip((tuple(map(_hashable, combination)) for combination in combinations), made, strict=True)))


def timeseries(
    series: Any,
    spacing: Any = None,
    client: Any = None,
    *,
    affine: Any = None,
    nan: Any = "error",
    outputs: Sequence[str] = ("color",),
    formats: Sequence[str] = ("png",),
    in_flight: int | None = None,
    resources: Mapping[str, float] | None = None,
    backend: str = "auto",
    adapter: str | None = None,
    threads: int | None = None,
    memory_limit: int | None = None,
    **look: Any,
) -> Iterator[RemotePicture]:
    """A picture for each point in time, in order.

    Parameters
    ----------
    series : array (t, z, y, x)
        Of Dask, whose points in time are computed on the workers, one after the other; of NumPy, or of xarray over either.
    spacing : float or (float, float, float), optional
        Distances between voxels along z, y and x.
    affine, nan
        As :class:`vitrum_render.Session` takes them.
    **look
        ``scene``, or what the look is made of, which is then fitted to the first point in time.
    client, outputs, formats, in_flight, resources, backend, adapter, threads, memory_limit
        As of :func:`turntable`.
    """
    array = series.data if hasattr(series, "dims") and hasattr(series, "coords") else series
    if getattr(array, "ndim", None) != 4 or len(array) == 0:
        shape = getattr(array, "shape", type(array).__name__)
        raise InvalidValue(f"{shape} is no series of volumes", "give an array (t, z, y, x)")
    arguments = {"spacing": spacing, "affine": affine, "nan": nan}
    device = Device(backend, adapter, threads, memory_limit)
    job = Series(array, arguments, dict(look), Result(tuple(outputs), tuple(formats)), device)
    return pictures(job, len(array), client, in_flight, resources)


def _placed(data: Any, spacing: Any, look: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """The data and the look, in which nothing depends on the folder that this process is in."""
    look = dict(look)
    if isinstance(data, Scene):
        return None, {"scene": data, **look}
    if isinstance(data, (str, os.PathLike)):
        if spacing is not None or "affine" in look:
            raise InvalidValue("spacing and affine are for arrays", "give `vr.open(path, spacing=…)`, or the key `volume.spacing`")
        path = os.fspath(data)
        if path.endswith(".toml"):
            return None, {"scene": Scene.load(os.path.abspath(path)), **look}
        return (path if path.startswith("builtin:") else os.path.abspath(path)), look
    if data is None:
        return None, look
    return subject(data, spacing, look.pop("affine", None), look.pop("nan", "error")), look


def _hashable(value: Any) -> Any:
    return tuple(value) if isinstance(value, list) else value


def _composer(data: Any, look: dict[str, Any]) -> Session:
    """A session of this process that composes scenes and renders none."""
    return Session(data, backend="cpu", threads=1, **look)


def _sent(data: Any) -> Volume | Mesh | None:
    """What is sent to the workers: they read a file that the scene names themselves."""
    return data if isinstance(data, (Volume, Mesh)) else None
