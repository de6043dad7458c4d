"""Arrays of every type and layout show the same picture."""

from __future__ import annotations

import numpy as np
import pytest

import vitrum_render as vr

TYPES = ["?", "u1", "i1", "<u2", ">u2", "<i2", ">i2", "<u4", ">i4", "<i8", "<u8", "<f2", "<f4", ">f4", "<f8", ">f8"]


@pytest.mark.parametrize("name", TYPES)
def test_values_are_kept_for_every_type(volume: np.ndarray, name: str) -> None:
    dtype = np.dtype(name)
    values = volume > 100 if dtype.kind == "b" else volume // 2 - (40 if dtype.kind == "i" else 0)
    array = values.astype(dtype)
    made = vr.Volume(array)
    np.testing.assert_array_equal(made.values, array.astype(np.float32))
    assert made.range == (float(array.min()), float(array.max()))


@pytest.mark.parametrize(
    "layout",
    [
        np.asfortranarray,
        lambda array: array.copy()[::-1, ::-1, ::-1][::-1, ::-1, ::-1],
        lambda array: np.repeat(array, 2, axis=2)[:, :, ::2],
        lambda array: np.pad(array, 3)[3:-3, 3:-3, 3:-3],
        lambda array: array.transpose(2, 1, 0).copy().transpose(2, 1, 0),
    ],
)
def test_strides_do_not_matter(volume: np.ndarray, layout: object) -> None:
    arranged = layout(volume)  # type: ignore[operator]
    assert not arranged.flags.c_contiguous or arranged.base is not None
    np.testing.assert_array_equal(vr.Volume(arranged).array, volume)


def test_integers_beyond_16_bits_become_float32() -> None:
    array = np.array([0, 7, 1_000_000], np.int64).reshape(1, 1, 3)
    assert vr.Volume(array).array.dtype == np.float32
    assert vr.Volume(array + np.int64(5_000_000) - np.array([0, 0, 990_000])).array.dtype == np.uint16


def test_the_array_is_lent_without_a_copy(volume: np.ndarray) -> None:
    made = vr.Volume(volume)
    lent = made.array
    assert np.shares_memory(lent, made.array) and not lent.flags.writeable
    with pytest.raises(ValueError, match="read-only"):
        lent[0, 0, 0] = 1
    del made
    np.testing.assert_array_equal(lent, volume)


@pytest.mark.parametrize(
    ("array", "said"),
    [
        (np.zeros((4, 4)), "np.stack"),
        (np.zeros((2, 4, 4, 4)), "pick one"),
        (np.zeros((1, 2, 4, 4, 4)), "5 dimensions"),
        (np.zeros(0), "1 dimensions"),
        (np.zeros((0, 4, 4)), "no voxels"),
        (np.array([[[None]]]), "holds no real numbers"),
        (np.zeros((2, 2, 2), complex), "holds no real numbers"),
        (np.array([[["a"]]]), "holds no real numbers"),
        (np.array([[[1.0, np.nan]]]), "1 of 2 voxels are NaN"),
        (np.array([[[1.0, np.inf]]]), "infinite"),
        (np.array([[[1.0, 1e300]]]), "beyond float32"),
    ],
)
def test_arrays_that_are_no_volumes(array: np.ndarray, said: str) -> None:
    with pytest.raises(ValueError, match=said) as caught:
        vr.render(array, size=(8, 8))
    assert isinstance(caught.value, vr.InvalidValue) and caught.value.advice


def test_nan_is_nothing_where_asked_for() -> None:
    array = np.array([[[1.0, np.nan, np.inf, 3.0]]])
    made = vr.Volume(array, nan="nothing")
    np.testing.assert_array_equal(made.values, np.float32([[[1, 1, 3, 3]]]))
    assert len(made.notes) == 2
    with pytest.raises(vr.VitrumError, match="NaN"):
        vr.Volume(np.full((2, 2, 2), np.nan), nan="nothing")


@pytest.mark.parametrize("spacing", [0, -1, (1, 0, 1), (1, 2), float("nan"), (1, 1, float("inf")), "wide", (1, 2, 3, 4)])
def test_spacings_that_are_none(volume: np.ndarray, spacing: object) -> None:
    with pytest.raises(ValueError, match="spacing"):
        vr.Volume(volume, spacing)


def test_spacing_is_in_the_arrays_order(volume: np.ndarray) -> None:
    made = vr.Volume(volume, (3, 2, 1))
    assert made.spacing == (3.0, 2.0, 1.0) and made.shape == volume.shape
    np.testing.assert_allclose(made.affine[:3, :3], np.diag([1, 2, 3]))


def test_an_affine_matrix_goes_through(volume: np.ndarray) -> None:
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]) * [1.5, 2.0, 3.0]
    affine = np.eye(4)
    affine[:3, :3], affine[:3, 3] = turn, [10, -20, 30]
    made = vr.Volume(volume, affine=affine)
    np.testing.assert_allclose(made.affine, affine, atol=1e-5)
    assert made.orientation == "patient" and made.spacing == (3.0, 2.0, 1.5)
    for wrong in (np.eye(3), np.zeros((4, 4)), np.full((4, 4), np.nan), "x"):
        with pytest.raises(vr.VitrumError):
            vr.Volume(volume, affine=wrong)


def test_histograms_count_every_voxel(volume: np.ndarray) -> None:
    counts, edges = vr.Volume(volume).histogram(16)
    assert counts.sum() == volume.size and (edges[0], edges[-1]) == (0, volume.max())
    with pytest.raises(ValueError, match="bins"):
        vr.Volume(volume).histogram(0)
