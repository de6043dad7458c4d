"""Pictures of data: once, again and again, all the way round."""

from __future__ import annotations

import inspect
import os
import threading
from collections.abc import Iterator, Sequence
from types import TracebackType
from typing import Any, Literal

from . import _native
from .arrays import Nan
from .data import Mesh, Volume
from .errors import InvalidValue
from .inputs import subject
from .picture import Picture
from .progress import Progress, told
from .scene import Scene, Settings, assignments

BackendName = Literal["auto", "cpu", "gpu"]
Quality = Literal["draft", "good", "best"]
Side = Literal["anterior", "posterior", "left", "right", "superior", "inferior"]


def _path_or_data(data: Any) -> tuple[str | None, Any]:
    return (os.fspath(data), None) if isinstance(data, (str, os.PathLike)) else (None, data)


class Session:
    """Data on a device, of which picture after picture is made; what a change leaves alone is not uploaded again.

    A session may be used by several threads, whose pictures are made one after the other; not by a process that was forked from the one that opened it.
    ``with Session(…) as session:`` gives the device back at its end.

    Parameters
    ----------
    data : array (z, y, x), Volume, Mesh, path, or data of another package
        NumPy arrays of any real type; images of nibabel, SimpleITK, PyVista, VTK; arrays of xarray and Dask; meshes of trimesh, PyVista, VTK; the path of a
        file or a folder; ``builtin:NAME``. ``None`` for a scene that names its data.
    spacing : float or (float, float, float), optional
        Distances between voxels in the array's order, z, y, x.
    affine : (4, 4) array, optional
        Of an array, in NIfTI's sense: from indices (x, y, z) to a patient's RAS+ world.
    nan : "error" or "nothing"
        Whether NaN is refused, or shown as nothing.
    scene : Scene, optional
        A scene that is complete already: no preset, size or setting is applied to it.
    preset : str, optional
        One of :func:`vitrum_render.presets`; without it, that which suits the data.
    medium : str, optional
        The medium that a mesh is put into, such as ``fog``.
    quality : "draft", "good" or "best", optional
        Viewing rays: one a pixel, more where pixels differ, four times as many.
    transfer : path, optional
        A file of transfer functions of 3D Slicer, ParaView or VTK.
    threshold : float, optional
        Values below are nothing.
    window, level : float, optional
        Width and middle of the values over which the transfer function changes, as in radiology; both or none.
    colormap : str, optional
        One of :func:`vitrum_render.colormaps`.
    isosurfaces : list, optional
        Values, or texts such as ``"300:ivory:0.4"``: value, colour, opacity.
    size : (int, int), optional
        Width and height in pixels.
    view : str, optional
        The patient's side from which the camera looks.
    settings : dict or list of str, optional
        Keys of the scene, applied last and in order: ``{"light.0.angular_radius": 3}``.
    backend : "auto", "cpu" or "gpu"
        ``auto`` takes a hardware GPU if there is one.
    adapter : str, optional
        A part of the GPU's name.
    threads : int, optional
        Threads of the processor; all without it.
    memory_limit : int, optional
        The most bytes of device memory for voxels at once; larger volumes are streamed.

    Raises
    ------
    InvalidValue, SceneError, FileError, DeviceError
        Each says what to do.

    Attributes
    ----------
    scene : Scene
        The scene as it was composed; change it, and render again.
    notes : list of str
        What a preset took for granted.
    """

    def __init__(
        self,
        data: Any = None,
        spacing: Any = None,
        *,
        affine: Any = None,
        nan: Nan = "error",
        scene: Scene | None = None,
        preset: str | None = None,
        medium: str | None = None,
        quality: Quality | None = None,
        transfer: str | os.PathLike[str] | None = None,
        threshold: float | None = None,
        window: float | None = None,
        level: float | None = None,
        colormap: str | None = None,
        isosurfaces: Sequence[float | str] = (),
        size: tuple[int, int] | None = None,
        view: Side | None = None,
        settings: Settings | None = None,
        backend: BackendName = "auto",
        adapter: str | None = None,
        threads: int | None = None,
        memory_limit: int | None = None,
    ) -> None:
        path, data = _path_or_data(data)
        if path is not None and (spacing is not None or affine is not None):
            raise InvalidValue("spacing and affine are for arrays", "give `vr.open(path, spacing=…)`, or the key `volume.spacing`")
        self._inside = threading.local()
        self._path = path
        self._data: Volume | Mesh | None = None if data is None else subject(data, spacing, affine, nan)
        look: dict[str, Any] = {
            "preset": preset,
            "medium": medium,
            "quality": quality,
            "transfer": transfer,
            "threshold": threshold,
            "window": window,
            "level": level,
            "colormap": colormap,
            "isosurfaces": isosurfaces,
            "size": size,
            "view": view,
            "settings": settings,
        }
        composed = self._complete(scene, look) if scene is not None else self._compose(**look)
        self.notes: list[str] = composed.notes
        self.scene: Scene = Scene._of(composed.scene)
        self._native = _native.Session(composed, backend, adapter, threads, memory_limit)

    def _complete(self, scene: Scene, look: dict[str, Any]) -> _native.Composed:
        given = [name for name, value in look.items() if name != "settings" and value is not None and value != ()]
        if given:
            raise InvalidValue(f"{given[0]} is given beside a scene, which is complete", f"leave out {given[0]}, or scene")
        scene = scene.copy().set(look["settings"] or {})
        if self._path is not None:
            raise InvalidValue("a path is given beside a scene, which names its data", "give `vr.open(path)`, or leave the path out")
        native = None if self._data is None else self._data._native
        return _native.load(scene._native, native)

    def _compose(
        self,
        preset: str | None = None,
        medium: str | None = None,
        quality: str | None = None,
        transfer: str | os.PathLike[str] | None = None,
        threshold: float | None = None,
        window: float | None = None,
        level: float | None = None,
        colormap: str | None = None,
        isosurfaces: Sequence[float | str] = (),
        size: tuple[int, int] | None = None,
        view: str | None = None,
        settings: Settings | None = None,
    ) -> _native.Composed:
        data = self._data
        if self._path is None and data is None:
            raise InvalidValue("there is nothing to render", "give an array, a path, `builtin:NAME`, or a scene that names its data")
        if (window is None) != (level is None):
            raise InvalidValue("window and level belong together", "give both, or none")
        return _native.compose(
            self._path if data is None else data.name,  # type: ignore[arg-type]
            None if data is None else data._native,
            preset,
            medium,
            quality,
            None if transfer is None else os.fspath(transfer),
            threshold,
            None if window is None or level is None else (window, level),
            colormap,
            [str(surface) for surface in isosurfaces],
            _size(size),
            view,
            assignments(settings),
        )

    @property
    def data(self) -> Volume | Mesh | None:
        """The volume or the mesh; ``None`` where a file or the scene names it."""
        return self._data

    @property
    def device(self) -> tuple[str, str]:
        """``cpu`` or ``gpu``, and the device's name."""
        return self._native.device()

    def render(
        self,
        scene: Scene | None = None,
        *,
        outputs: Sequence[str] | Literal["all"] = ("color",),
        progress: Progress = None,
        **look: Any,
    ) -> Picture:
        """Renders a picture.

        Parameters
        ----------
        scene : Scene, optional
            Instead of :attr:`scene`.
        outputs : sequence of str, or "all"
            Names of further outputs (:func:`vitrum_render.outputs`), such as ``("color", "depth")``.
        progress : bool or function, optional
            ``True`` shows a bar, where tqdm is installed; a function is called with the stage's name, the units done and all units. Ctrl-C, or an exception of
            the function, gives the picture up, and the session goes on.
        **look
            ``preset``, ``size``, ``settings`` and the others of :class:`Session`: the scene is composed anew with these alone. ``settings`` alone is applied
            to the scene, for this picture.
        """
        scene = self.composed(scene, **look)
        names = None if outputs == "all" else list(outputs)
        if getattr(self._inside, "progress", False):
            raise InvalidValue("the function of `progress` asks for a picture of the session that calls it", "use another session there")
        self._inside.progress = True
        try:
            with told(progress) as tell:
                return Picture(self._native.render(scene._native, names, tell))
        finally:
            self._inside.progress = False

    def composed(self, scene: Scene | None = None, **look: Any) -> Scene:
        """The scene that :meth:`render` renders for these arguments."""
        unknown = [name for name in look if name not in LOOK]
        if unknown:
            raise TypeError(f"there is no argument {unknown[0]!r}")
        if set(look) <= {"settings"}:
            scene = self.scene if scene is None else scene
            return scene.copy().set(look["settings"] or {}) if look else scene
        if scene is not None:
            raise InvalidValue("a scene is complete", "leave out " + ", ".join(look) + ", or scene")
        return Scene._of(self._compose(**look).scene)

    def turntable(
        self,
        frames: int = 72,
        *,
        turn: float = 360.0,
        scene: Scene | None = None,
        part: tuple[int, int] = (0, 1),
        progress: Progress = None,
    ) -> Iterator[Picture]:
        """Pictures of the camera going round, one after the other as they are made.

        Parameters
        ----------
        frames : int
            Pictures of the whole way.
        turn : float
            How far the camera goes, in degrees; negative to the left.
        part : (int, int)
            (i, n): every n-th picture alone, from the i-th, for work that is shared out.
        """
        for moment in frames_of(self.framed_all_round(scene), frames, turn)[part[0] :: part[1]]:
            yield self.render(moment, progress=progress)

    def framed_all_round(self, scene: Scene | None = None) -> Scene:
        """The scene with a camera that keeps its distance on its way round."""
        return Scene._of(self._native.framed_all_round((self.scene if scene is None else scene)._native))

    def close(self) -> None:
        """Gives device and memory back."""
        self._native.close()

    def __enter__(self) -> Session:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.close()


# What the look of a scene is composed of.
LOOK = frozenset(inspect.signature(Session._compose).parameters) - {"self"}


def frames_of(scene: Scene, frames: int, turn: float = 360.0) -> list[Scene]:
    """The scene at each frame of a turntable.

    Raises
    ------
    InvalidValue
        For a number of frames below 1, and a scene whose camera has a position, around which nothing turns.
    """
    if frames < 1:
        raise InvalidValue(f"{frames} frames", "give at least 1")
    if scene["camera.position"] is not None:
        raise InvalidValue("the scene sets camera.position, which a turntable cannot turn", "use camera.azimuth and camera.elevation instead")
    start = float(scene["camera.azimuth"])
    return [scene.copy().set({"camera.azimuth": start + turn * index / frames}) for index in range(frames)]


def _size(size: tuple[int, int] | None) -> tuple[int, int] | None:
    if size is None:
        return None
    try:
        width, height = (int(edge) for edge in size)
    except (TypeError, ValueError):
        raise InvalidValue(f"size={size!r}", "give (width, height) in pixels") from None
    if width < 1 or height < 1:
        raise InvalidValue(f"size={size!r}", "give a width and a height of at least one pixel")
    return width, height


def render(
    data: Any = None,
    spacing: Any = None,
    *,
    outputs: Sequence[str] | Literal["all"] = ("color",),
    progress: Progress = None,
    **arguments: Any,
) -> Picture:
    """Renders one picture of data; the arguments are those of :class:`Session`, ``outputs`` and ``progress`` those of :meth:`Session.render`.

    >>> import numpy as np
    >>> z, y, x = np.mgrid[-1:1:20j, -1:1:20j, -1:1:20j]
    >>> render(np.exp(-4 * (x * x + y * y + z * z)), preset="haze", size=(64, 48))
    <Picture 64 × 48: color>
    """
    with Session(data, spacing, **arguments) as session:
        return session.render(outputs=outputs, progress=progress)


def turntable(data: Any = None, frames: int = 72, *, turn: float = 360.0, progress: Progress = None, **arguments: Any) -> Iterator[Picture]:
    """Pictures of the camera going round data; the arguments are those of :class:`Session`.

    >>> len(list(turntable("builtin:ball", 2, size=(32, 32), settings={"volume.resolution": 16})))
    2
    """
    with Session(data, **arguments) as session:
        yield from session.turntable(frames, turn=turn, progress=progress)
