"""Data of other packages: the same volume by each of them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import vitrum_render as vr
from vitrum_render.inputs import subject

AFFINE = np.array([[-1.5, 0, 0, 10], [0, 2, 0, -20], [0, 0, 3, 5], [0, 0, 0, 1.0]])


def test_nibabel(volume: np.ndarray, tmp_path: Path) -> None:
    nibabel = pytest.importorskip("nibabel")
    image = nibabel.Nifti1Image(volume.T, AFFINE)
    made = subject(image)
    np.testing.assert_array_equal(made.values, volume)
    np.testing.assert_allclose(made.affine, AFFINE)
    assert made.orientation == "patient"
    nibabel.save(image, tmp_path / "image.nii.gz")
    # The reader of files, an independent way, places it alike.
    opened = vr.open(tmp_path / "image.nii.gz")
    np.testing.assert_allclose(opened.affine, made.affine, atol=1e-4)
    look = {"preset": "haze", "size": (40, 30), "quality": "draft", "backend": "cpu"}
    np.testing.assert_array_equal(vr.render(opened, **look).color, vr.render(image, **look).color)
    metres = nibabel.Nifti1Image(volume.T, AFFINE)
    metres.header.set_xyzt_units("meter")
    assert subject(metres).spacing == (3000.0, 2000.0, 1500.0)
    bare = nibabel.Nifti1Image(volume.T, None)
    bare.header["sform_code"] = bare.header["qform_code"] = 0
    assert subject(bare).orientation == "unknown"
    with pytest.raises(ValueError, match="several volumes"):
        subject(nibabel.Nifti1Image(np.zeros((4, 4, 4, 3), np.uint8), AFFINE))
    np.testing.assert_array_equal(subject(nibabel.Nifti1Image(volume.T[..., None], AFFINE)).values, volume)


def test_simpleitk(volume: np.ndarray, tmp_path: Path) -> None:
    itk = pytest.importorskip("SimpleITK")
    image = itk.GetImageFromArray(volume)
    image.SetSpacing((1.5, 2.0, 3.0))
    image.SetOrigin((10.0, 20.0, 30.0))
    image.SetDirection((0, -1, 0, 1, 0, 0, 0, 0, 1))
    made = subject(image)
    itk.WriteImage(image, str(tmp_path / "image.nrrd"))
    opened = vr.open(tmp_path / "image.nrrd")
    np.testing.assert_array_equal(made.values, opened.values)
    np.testing.assert_allclose(made.affine, opened.affine, atol=1e-4)


def test_pyvista(volume: np.ndarray, tmp_path: Path) -> None:
    pyvista = pytest.importorskip("pyvista")
    image = pyvista.ImageData(dimensions=volume.shape[::-1], spacing=(1.5, 2.0, 3.0), origin=(1, 2, 3))
    image.point_data["values"] = volume.ravel()
    image.set_active_scalars("values")
    made = subject(image)
    np.testing.assert_array_equal(made.values, volume)
    assert made.spacing == (3.0, 2.0, 1.5) and made.orientation == "world"
    np.testing.assert_allclose(made.affine[:3, 3], [1, 2, 3])
    cells = pyvista.ImageData(dimensions=np.array(volume.shape[::-1]) + 1)
    cells.cell_data["values"] = volume.ravel()
    np.testing.assert_array_equal(subject(cells).values, volume)
    mesh = subject(pyvista.Cube())
    assert isinstance(mesh, vr.Mesh) and len(mesh.triangles) == 12
    with pytest.raises(ValueError, match="set_active_scalars"):
        subject(pyvista.ImageData(dimensions=(2, 2, 2)))


def test_xarray(volume: np.ndarray) -> None:
    xarray = pytest.importorskip("xarray")
    z, y, x = volume.shape
    coords = {"z": np.arange(z) * 0.3, "y": 5 - np.arange(y) * 0.2, "x": np.arange(x) * 0.1}
    array = xarray.DataArray(volume, dims=("z", "y", "x"), coords=coords)
    made = subject(array)
    # A coordinate that falls turns its axis round.
    np.testing.assert_array_equal(made.values, volume[:, ::-1, :])
    np.testing.assert_allclose(made.spacing, (0.3, 0.2, 0.1), rtol=1e-6)
    array["z"] = array["z"].assign_attrs(units="cm")
    assert abs(subject(array).spacing[0] - 3.0) < 1e-6
    with pytest.raises(ValueError, match="evenly"):
        subject(array.assign_coords(x=np.arange(x) ** 2))
    bare = xarray.DataArray(volume)
    assert subject(bare).spacing == (1.0, 1.0, 1.0)


def test_dask_arrays_are_computed(volume: np.ndarray) -> None:
    array = pytest.importorskip("dask.array")
    np.testing.assert_array_equal(subject(array.from_array(volume, chunks=8)).values, volume)


def test_trimesh() -> None:
    trimesh = pytest.importorskip("trimesh")
    made = subject(trimesh.creation.icosphere(2))
    assert isinstance(made, vr.Mesh) and len(made.triangles) == 320


def test_data_with_a_place_takes_no_other(volume: np.ndarray) -> None:
    made = vr.Volume(volume)
    assert subject(made, spacing=2).spacing == (2.0, 2.0, 2.0)
    with pytest.raises(ValueError, match="affine"):
        subject(made, affine=np.eye(4))
    with pytest.raises(ValueError, match="both given"):
        vr.Volume(volume, 1, affine=np.eye(4))
