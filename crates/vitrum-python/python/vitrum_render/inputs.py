"""Data of other packages, known by what it can do: none of them is needed, and none is imported unless its data is there."""

from __future__ import annotations

from typing import Any

import numpy as np

from .data import Mesh, Volume
from .errors import InvalidValue

_MILLIMETRES = {
    "m": 1e3, "meter": 1e3, "metre": 1e3, "meters": 1e3, "metres": 1e3,
    "cm": 10.0, "centimeter": 10.0, "centimetre": 10.0,
    "mm": 1.0, "millimeter": 1.0, "millimetre": 1.0,
    "um": 1e-3, "µm": 1e-3, "μm": 1e-3, "micron": 1e-3, "micrometer": 1e-3, "micrometre": 1e-3,
    "nm": 1e-6, "nanometer": 1e-6, "nanometre": 1e-6,
}  # fmt: skip


def has(data: Any, *names: str) -> bool:
    """Whether an object has all of these attributes, by its class: those of instances may be slow."""
    return all(hasattr(type(data), name) or hasattr(data, name) for name in names)


def subject(data: Any, spacing: Any = None, affine: Any = None, nan: Any = "error") -> Volume | Mesh:
    """The volume or the mesh of anything that :func:`vitrum_render.render` takes but the name of a file.

    Raises
    ------
    InvalidValue
        For data that is no volume and no mesh, and where a spacing or an affine matrix is given for data that has its own.
    """
    found = _placed_already(data, nan)
    if found is None:
        return Volume(data, spacing, affine=affine, nan=nan)
    if affine is not None:
        raise InvalidValue("affine is for arrays, and this data has its own", "leave it out, or pass the array alone")
    if spacing is not None:
        if isinstance(found, Mesh):
            raise InvalidValue("spacing is for volumes", "scale a mesh by the key `mesh.0.scale`")
        found = found.with_spacing(spacing)
    return found


def _placed_already(data: Any, nan: Any) -> Volume | Mesh | None:
    if isinstance(data, (Volume, Mesh)):
        return data
    if has(data, "GetDirection", "GetOrigin", "GetSpacing", "GetPixelIDTypeAsString"):
        return _of_simpleitk(data, nan)
    if has(data, "affine", "dataobj", "header"):
        return _of_nibabel(data, nan)
    if has(data, "GetDimensions", "GetSpacing", "GetPointData"):
        return _of_image_data(data, nan)
    if has(data, "GetPolys", "GetPoints"):
        return _of_poly_data(data)
    if has(data, "dims", "coords", "to_numpy"):
        return _of_xarray(data, nan)
    if has(data, "vertices", "faces"):
        colors = getattr(getattr(data, "visual", None), "vertex_colors", None)
        has_colors = colors is not None and getattr(data.visual, "kind", None) == "vertex"
        rgba = np.asarray(colors, dtype=np.float32) / 255 if has_colors else None
        return Mesh(data.vertices, data.faces, colors=None if rgba is None else _linear(rgba))
    if has(data, "compute", "chunks"):
        return Volume(data.compute(), nan=nan)
    return None


def _linear(rgba: Any) -> Any:
    """Colours of sRGB as linear ones; alpha stays."""
    rgb = rgba[..., :3]
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.concatenate([linear, rgba[..., 3:]], axis=-1)


def _of_nibabel(image: Any, nan: Any) -> Volume:
    """NIfTI's indices are (x, y, z), and its world is RAS+ in the header's unit."""
    array = np.asanyarray(image.dataobj)
    while array.ndim > 3 and array.shape[-1] == 1:
        array = array[..., 0]
    if array.ndim == 4:
        raise InvalidValue(f"an image of shape {array.shape} has several volumes", "pick one, such as `image.slicer[..., 0]`")
    header = image.header
    unit = header.get_xyzt_units()[0] if has(header, "get_xyzt_units") else "mm"
    matrix = image.affine if image.affine is not None else header.get_best_affine()
    affine = np.array(matrix, dtype=np.float64)
    affine[:3] *= _MILLIMETRES.get(unit, 1.0)
    codes = [header[name] for name in ("qform_code", "sform_code")] if "sform_code" in header else [1]
    volume = Volume(array.T, affine=affine, name="NIfTI image", nan=nan)
    return volume if any(int(code) > 0 for code in codes) else volume._with_orientation("unknown")


def _of_simpleitk(image: Any, nan: Any) -> Volume:
    """ITK's world is LPS."""
    import SimpleITK

    if image.GetDimension() != 3 or image.GetNumberOfComponentsPerPixel() != 1:
        raise InvalidValue("an image of SimpleITK that is no scalar volume", "extract one volume and one component")
    affine = np.eye(4)
    affine[:3, :3] = np.reshape(image.GetDirection(), (3, 3)) * np.asarray(image.GetSpacing())
    affine[:3, 3] = image.GetOrigin()
    affine[:2] *= -1
    return Volume(SimpleITK.GetArrayViewFromImage(image), affine=affine, name="SimpleITK image", nan=nan)


def _of_image_data(image: Any, nan: Any) -> Volume:
    """VTK's world is no patient's, unless its maker means it."""
    from vtkmodules.util import numpy_support

    vtk_to_numpy: Any = numpy_support.vtk_to_numpy

    shape = np.asarray(image.GetDimensions())
    scalars = image.GetPointData().GetScalars()
    if scalars is None:
        scalars, shape = image.GetCellData().GetScalars(), np.maximum(shape - 1, 1)
    if scalars is None or scalars.GetNumberOfComponents() != 1:
        raise InvalidValue("image data of VTK without active scalars of one component", "choose them by `set_active_scalars`")
    affine = np.eye(4)
    direction = image.GetDirectionMatrix()
    turn = np.array([[direction.GetElement(row, column) for column in range(3)] for row in range(3)])
    affine[:3, :3] = turn * np.asarray(image.GetSpacing())
    affine[:3, 3] = image.GetOrigin()
    array = vtk_to_numpy(scalars).reshape(shape[::-1])
    volume = Volume(array, affine=affine, name="VTK image data", nan=nan)
    return volume._with_orientation("world")


def _of_poly_data(data: Any) -> Mesh:
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter

    vtk_to_numpy: Any = numpy_support.vtk_to_numpy
    triangles = vtkTriangleFilter()
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.SetInputData(data)
    triangles.Update()
    made = triangles.GetOutput()
    if made.GetNumberOfPolys() == 0:
        raise InvalidValue("poly data of VTK without polygons", "give a surface")
    faces = vtk_to_numpy(made.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return Mesh(vtk_to_numpy(made.GetPoints().GetData()), faces, name="VTK poly data")


def _of_xarray(data: Any, nan: Any) -> Volume:
    """Coordinates give the spacing; where they fall, the axis is turned round."""
    array = np.asarray(data.to_numpy())
    if array.ndim != 3:
        return Volume(array, nan=nan)
    steps = []
    for axis, dim in enumerate(data.dims):
        if dim not in data.coords or data.sizes[dim] < 2:
            steps.append(1.0)
            continue
        coordinate = data.coords[dim]
        values = np.asarray(coordinate.to_numpy(), dtype=np.float64)
        differences = np.diff(values)
        step = float(differences.mean())
        if not np.isfinite(step) or step == 0 or np.abs(differences - step).max() > 1e-3 * abs(step):
            raise InvalidValue(f"the coordinates of {dim!r} are not evenly spaced", f"resample, such as by `data.interp({dim}=…)`")
        if step < 0:
            array = np.flip(array, axis)
        unit = str(coordinate.attrs.get("units", data.attrs.get("units", "mm")))
        steps.append(abs(step) * _MILLIMETRES.get(unit, 1.0))
    return Volume(array, steps, name=str(data.name or "DataArray"), nan=nan)
