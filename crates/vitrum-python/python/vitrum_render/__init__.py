"""Vitrum for Python: pictures of light that bends in volumes and meshes.

>>> import numpy as np, vitrum_render as vr
>>> volume = np.random.default_rng(1).random((16, 20, 24), dtype=np.float32)
>>> picture = vr.render(volume, spacing=(2, 1, 1), preset="haze", size=(80, 60))
>>> picture.color.shape, picture.color.dtype
((60, 80, 4), dtype('float32'))

Arrays are (z, y, x): the last axis runs along the rows of voxels, and ``spacing`` is in the array's order, as in scikit-image. Pictures are (height, width,
channels), row 0 on top, linear; ``size`` is (width, height).
"""

from __future__ import annotations

import os as _os
import sys as _sys

# Mesa's layer that orders adapters complains at every start where there is no desktop session. It stays on where the user names an order.
_SESSION_OR_WISH = ("XDG_RUNTIME_DIR", "NODEVICE_SELECT", "MESA_VK_DEVICE_SELECT", "DRI_PRIME")
if _sys.platform == "linux" and not any(name in _os.environ for name in _SESSION_OR_WISH):
    _os.environ["NODEVICE_SELECT"] = "1"

from ._native import version as _version
from .compare import Difference, diff
from .data import Mesh, Volume, open
from .errors import Cancelled, DeviceError, FileError, InvalidValue, SceneError, VitrumError
from .picture import Picture
from .scene import Scene, Section
from .session import Session, render, turntable
from .tables import colormaps, devices, keys, outputs, presets, scenes, schema
from .voxels import voxelize

__version__ = _version()

__all__ = [
    "Cancelled",
    "DeviceError",
    "Difference",
    "FileError",
    "InvalidValue",
    "Mesh",
    "Picture",
    "Scene",
    "SceneError",
    "Section",
    "Session",
    "VitrumError",
    "Volume",
    "colormaps",
    "devices",
    "diff",
    "keys",
    "open",
    "outputs",
    "presets",
    "render",
    "scenes",
    "schema",
    "turntable",
    "view",
    "voxelize",
]


def __getattr__(name: str) -> object:
    # The widget needs packages that are there in a notebook alone, and `dask` those of a cluster.
    if name == "view":
        from .notebook import view

        return view
    if name == "dask":
        import importlib

        return importlib.import_module(".dask", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
