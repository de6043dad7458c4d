"""Meshes as voxels."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from . import _native
from .data import Mesh, Volume
from .errors import InvalidValue
from .inputs import subject
from .progress import Progress, told


def voxelize(
    mesh: Any,
    resolution: int,
    *,
    solid: Literal["nonzero", "even-odd"] | None = None,
    padding: int = 1,
    overlap: float = 0.0,
    backend: Literal["auto", "cpu", "gpu"] = "auto",
    progress: Progress = None,
) -> Volume:
    """Turns a mesh into voxels, as ``vitrum voxelize`` does.

    Parameters
    ----------
    mesh : Mesh, or a mesh of trimesh, PyVista or VTK
    resolution : int
        Voxels along the longest edge, 1 to 8192.
    solid : "nonzero", "even-odd" or None
        The rule by which the inside is filled: voxels are then how much of them is inside, 0 to 255. Without it they are 255 where a triangle meets them, else 0.
    padding : int
        Empty voxels around the mesh, 0 to 1024.
    overlap : float
        By how much a voxel reaches over its neighbours for the surface, 0 to 1 of its edge.

    Returns
    -------
    Volume
        Of uint8, at the mesh's place.
    """
    body = subject(mesh)
    if not isinstance(body, Mesh):
        raise InvalidValue("a volume is made of voxels already", "give a mesh")
    with told(progress) as tell:
        array, edge, first, _ = _native.voxelize(body._native, resolution, solid, padding, overlap, backend, tell)
    affine = np.diag([edge, edge, edge, 1.0])
    affine[:3, 3] = first
    return Volume(array, affine=affine, name=f"voxels of {body.name}")._with_orientation("world")
