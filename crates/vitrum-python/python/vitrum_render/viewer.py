"""The widget of notebooks."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from .data import Mesh
from .errors import VitrumError
from .newest import Newest, Request
from .picture import Picture
from .scene import Scene
from .session import Session
from .tables import presets

_SIZE = (640, 480)
_FIRST_PICTURE_SECONDS = 60.0
# The traits that a scene is made of; people move them, or programs set them.
_CONTROLS = ("azimuth", "elevation", "zoom", "light_azimuth", "light_elevation", "opacity", "eta")


class Viewer(anywidget.AnyWidget):
    """Data in a notebook, turned by hand. See :func:`vitrum_render.view`.

    Attributes
    ----------
    azimuth, elevation, light_azimuth, light_elevation : float
        Of the camera and of the first light, in degrees.
    zoom : float
        Larger is nearer.
    opacity, eta : float
        Factors of the extinction, and of the index of refraction less 1.
    preset : str
        One of :func:`vitrum_render.presets`, or empty for the look that was given.
    scene_toml : str
        The text of the scene as shown.
    """

    _esm = Path(__file__).parent / "widget.js"

    azimuth = traitlets.Float(0.0).tag(sync=True)
    elevation = traitlets.Float(0.0).tag(sync=True)
    zoom = traitlets.Float(1.0, min=0.01, max=100.0).tag(sync=True)
    light_azimuth = traitlets.Float(0.0).tag(sync=True)
    light_elevation = traitlets.Float(0.0).tag(sync=True)
    opacity = traitlets.Float(1.0, min=0.0, max=100.0).tag(sync=True)
    eta = traitlets.Float(1.0, min=0.0, max=10.0).tag(sync=True)
    preset = traitlets.Unicode("").tag(sync=True)
    scene_toml = traitlets.Unicode("", read_only=True).tag(sync=True)

    _presets = traitlets.Dict(read_only=True).tag(sync=True)
    # What there is to change: lights that have a direction, points of opacity, indices of refraction.
    _has = traitlets.Dict(read_only=True).tag(sync=True)
    _size = traitlets.List(traitlets.Int(), read_only=True).tag(sync=True)
    _moves = traitlets.Bool(False).tag(sync=True)
    _message = traitlets.Unicode("", read_only=True).tag(sync=True)
    # The picture's file, and what it is.
    _image = traitlets.Bytes(b"", read_only=True).tag(sync=True)
    _image_kind = traitlets.Unicode("", read_only=True).tag(sync=True)

    def __init__(self, data: Any = None, spacing: Any = None, **look: Any) -> None:
        self._newest: Newest | None = None
        if look.get("scene") is None:
            look = {"size": _SIZE, **look}
        self._session = Session(data, spacing, **look)
        self._look = {key: look[key] for key in ("size", "settings") if look.get(key) is not None}
        self._picture: Picture | None = None
        self._whole = threading.Event()
        self._composes = False
        self._given = self._base = self._session.framed_all_round()
        super().__init__()
        with self.hold_sync():
            self._start(self._base)
            is_mesh = isinstance(self._session.data, Mesh)
            fitting = {name: text for name, text in presets().items() if text.startswith("of a mesh") == is_mesh}
            self.set_trait("_presets", fitting)
            self.set_trait("_size", [self._base["film.width"], self._base["film.height"]])
        self.observe(self._on_change, [*_CONTROLS, "_moves"])
        self.observe(self._on_preset, "preset")
        self._newest = Newest(self._session, self._show, self._fail)
        self._on_change()

    @property
    def scene(self) -> Scene:
        """The scene as shown, of the whole picture."""
        base = self._base
        settings: dict[str, Any] = {}
        if base["camera.position"] is None:
            settings |= {"camera.azimuth": self.azimuth, "camera.elevation": self.elevation, "camera.zoom": self.zoom}
        if self._has["light"]:
            settings |= {"light.0.azimuth": self.light_azimuth, "light.0.elevation": self.light_elevation}
        return base.copy().set(settings, _thicker(base, self.opacity), _bending(base, self.eta))

    @property
    def picture(self) -> Picture | None:
        """The last whole picture; ``None`` before the first."""
        return self._picture

    def snapshot(self) -> Picture:
        """Renders the whole picture of the scene as shown."""
        return self._session.render(self.scene)

    def close(self) -> None:
        """Ends the thread, and gives the device back."""
        newest, self._newest = getattr(self, "_newest", None), None
        if newest is not None:
            newest.end()
            self._session.close()
        super().close()

    def _repr_mimebundle_(self, **arguments: Any) -> Any:
        """The widget, and beside it a picture, which stays where a notebook is looked at without its kernel."""
        bundle = super()._repr_mimebundle_(**arguments)
        if bundle is None or self._newest is None:
            return bundle
        self._whole.wait(_FIRST_PICTURE_SECONDS)
        data, metadata = bundle if isinstance(bundle, tuple) else (bundle, {})
        return ({**data, "image/png": self._picture.encode("png")} if self._picture is not None else data), metadata

    def _start(self, base: Scene) -> None:
        """Begins with a scene, as it is."""
        self._base = base
        light = base.to_dict().get("light") or [{}]
        values = {
            "azimuth": base["camera.azimuth"],
            "elevation": base["camera.elevation"],
            "zoom": base["camera.zoom"],
            "light_azimuth": light[0].get("azimuth"),
            "light_elevation": light[0].get("elevation"),
        }
        for name, value in values.items():
            if value is not None:
                self.set_trait(name, float(value))
        has_light = values["light_azimuth"] is not None and values["light_elevation"] is not None
        self.set_trait("_has", {"light": has_light, "opacity": bool(_thicker(base, 0.5)), "eta": bool(_bending(base, 0.5))})

    def _on_change(self, _: Any = None) -> None:
        if self._newest is None or self._composes:
            return
        try:
            scene = self.scene
        except VitrumError as error:
            self._fail(error)
            return
        self.set_trait("scene_toml", scene.to_toml())
        if self._base is not None:
            self._whole.clear()
            self._newest.ask(Request(scene, self._moves))

    def _on_preset(self, change: Any) -> None:
        """Composes the look anew; the camera stays where it is."""
        if self._newest is None:
            return
        camera = {name: getattr(self, name) for name in ("azimuth", "elevation", "zoom")}
        try:
            base = self._given
            if change.new:
                base = self._session.framed_all_round(self._session.composed(preset=change.new, **self._look))
        except VitrumError as error:
            self._fail(error)
            return
        self._composes = True
        try:
            with self.hold_sync():
                self._start(base)
                for name, value in camera.items():
                    self.set_trait(name, value)
        finally:
            self._composes = False
        self._on_change()

    def _show(self, picture: Picture, is_whole: bool) -> None:
        """Sends a picture; called by the thread that renders."""
        kind = "png" if is_whole else "jpg"
        with self.hold_sync():
            self.set_trait("_message", "")
            self.set_trait("_image_kind", kind)
            self.set_trait("_image", picture.encode(kind))
        if is_whole:
            self._picture = picture
            self._whole.set()

    def _fail(self, error: VitrumError) -> None:
        self.set_trait("_message", str(error))
        self._whole.set()


def _thicker(scene: Scene, factor: float) -> dict[str, Any]:
    """The points of opacity with so many times the extinction; nothing where there are none or they stay."""
    points = scene.to_dict().get("transfer", {}).get("opacity") or []
    if factor == 1 or not any(point["opacity"] > 0 for point in points):
        return {}
    return {"transfer.opacity": [{**point, "opacity": 1 - (1 - point["opacity"]) ** factor} for point in points]}


def _bending(scene: Scene, factor: float) -> dict[str, Any]:
    """The indices of refraction so many times as far from 1; nothing where there are none or they stay."""

    def bent(ior: float) -> float:
        return min(max(1 + (ior - 1) * factor, 0.2), 5.0)

    if factor == 1:
        return {}
    found = scene.to_dict()
    settings: dict[str, Any] = {}
    points = found.get("transfer", {}).get("ior") or []
    if points:
        settings["transfer.ior"] = [{**point, "ior": bent(point["ior"])} for point in points]
    for index, material in enumerate(found.get("material") or []):
        if material.get("ior") is not None:
            settings[f"material.{index}.ior"] = bent(material["ior"])
    return settings
