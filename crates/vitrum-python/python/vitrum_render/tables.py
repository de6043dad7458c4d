"""What there is to choose from."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _native


class Key(NamedTuple):
    """A key of a scene.

    Attributes
    ----------
    path : str
        The dotted path, with 0 for the items of lists, such as ``light.0.azimuth``.
    unit, range, default, meaning : str
        For people to read; ``unit`` is empty where the value has none.
    """

    path: str
    unit: str
    range: str
    default: str
    meaning: str


def presets() -> dict[str, str]:
    """Names of the presets with their descriptions: those of volumes, then those of meshes.

    >>> "haze" in presets()
    True
    """
    return dict(_native.presets())


def colormaps() -> dict[str, str]:
    """Names of the maps of colours with their descriptions.

    >>> "viridis" in colormaps()
    True
    """
    return dict(_native.colormaps())


def scenes() -> dict[str, str]:
    """Names of the built-in scenes with their descriptions; ``vr.render("builtin:NAME")`` renders one.

    >>> "glass" in scenes()
    True
    """
    return dict(_native.scenes())


def outputs() -> dict[str, str]:
    """Names of the outputs of pictures with their quantities, units and ranges.

    >>> "depth" in outputs()
    True
    """
    return dict(_native.outputs())


def keys(prefix: str = "") -> list[Key]:
    """The keys of scenes whose path begins with ``prefix``.

    >>> [key.unit for key in keys("camera.azimuth")]
    ['degrees']
    """
    return [Key(*key) for key in _native.keys() if key[0].startswith(prefix)]


def schema() -> dict[str, Any]:
    """The JSON schema of scenes."""
    found: dict[str, Any] = json.loads(_native.schema())
    return found


def devices() -> list[dict[str, Any]]:
    """The devices that can render: name, backend (``cpu`` or ``gpu``), kind, driver, largest_buffer in bytes, passes_through, chosen_by_auto.

    >>> devices()[-1]["backend"]
    'cpu'
    """
    found: list[dict[str, Any]] = json.loads(_native.devices())
    return found
