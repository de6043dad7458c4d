"""Pictures, sessions, files, errors."""

from __future__ import annotations

import io
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import BACKENDS

import vitrum_render as vr

DRAFT = {"preset": "haze", "size": (48, 36), "quality": "draft"}


@pytest.mark.parametrize("backend", BACKENDS)
def test_three_lines_give_a_picture(volume: np.ndarray, tmp_path: Path, backend: str) -> None:
    picture = vr.render(volume, spacing=(2, 1, 1), preset="haze", size=(80, 60), backend=backend)
    picture.save(tmp_path / "scan.png")
    assert picture.color.shape == (60, 80, 4) and picture.color.dtype == np.float32
    assert np.isfinite(picture.color).all() and np.abs(picture.color[30, 40] - picture.color[0, 0]).max() > 0.05
    assert (tmp_path / "scan.png").read_bytes().startswith(b"\x89PNG")


def test_backends_give_the_same_bits(volume: np.ndarray) -> None:
    if len(BACKENDS) < 2:
        pytest.skip("there is no GPU here, by VITRUM_NO_GPU")
    pictures = [vr.render(volume, **DRAFT, backend=backend) for backend in BACKENDS]
    np.testing.assert_array_equal(pictures[0].color, pictures[1].color)
    assert [picture.statistics["backend"] for picture in pictures] == BACKENDS


def test_the_picture_is_the_programs(file: Path, tmp_path: Path) -> None:
    output = tmp_path / "program.exr"
    command = ["render", str(file), "-o", str(output), "--preset", "haze", "--size", "48x36", "--quality", "draft", "--backend", "cpu", "-q"]
    code = f"import sys; from vitrum_render._native import main; sys.exit(main(['vitrum', *{command!r}]))"
    subprocess.run([sys.executable, "-c", code], check=True)
    ours = tmp_path / "ours.exr"
    vr.render(file, **DRAFT, backend="cpu", outputs="all").save(ours)
    array = vr.render(np.load(file), **DRAFT, backend="cpu", outputs="all")
    compared = ["diff", str(output), str(ours), "--max-abs", "0"]
    code = f"import sys; from vitrum_render._native import main; sys.exit(main(['vitrum', *{compared!r}]))"
    subprocess.run([sys.executable, "-c", code], check=True)
    assert vr.diff(array, vr.render(file, **DRAFT, backend="cpu")).max_abs == 0


def test_outputs(small: vr.Session) -> None:
    picture = small.render(outputs=("depth", "direction", "light"))
    assert set(picture.outputs) == {"color", "depth", "direction", "light"}
    assert picture["depth"].shape == (36, 48) and picture["direction"].shape == (36, 48, 3)
    assert np.isfinite(picture["depth"]).all() and picture["depth"].max() > 0
    assert picture.channels("direction") == ["X", "Y", "Z"]
    with pytest.raises(ValueError, match="method `sweep` has no output"):
        small.render(outputs=("normal",))
    with pytest.raises(ValueError, match="did you mean"):
        small.render(outputs=("dept",))
    with pytest.raises(ValueError, match="depth"):
        small.render()["depth"]


def test_a_session_shows_change_after_change(small: vr.Session, volume: np.ndarray) -> None:
    first = small.render().color
    small.scene.camera.azimuth = 90
    turned = small.render().color
    small.scene.camera.azimuth = vr.Scene().camera.azimuth
    again = small.render(settings={"camera.azimuth": 0}).color
    fresh = vr.render(volume, **DRAFT, backend="cpu", settings={"camera.azimuth": 0}).color
    assert not np.array_equal(first, turned)
    np.testing.assert_array_equal(again, fresh)
    np.testing.assert_array_equal(small.render(preset="haze", size=(48, 36), quality="draft").color, first)
    assert small.render(preset="xray", size=(20, 10)).size == (20, 10)


def test_a_scene_is_taken_as_it_is(small: vr.Session, volume: np.ndarray) -> None:
    scene = small.scene.copy().set({"camera.azimuth": 17})
    np.testing.assert_array_equal(vr.render(volume, scene=scene, backend="cpu").color, small.render(scene).color)
    with pytest.raises(ValueError, match="preset"):
        vr.render(volume, scene=scene, preset="haze")
    alone = vr.Scene({"volume.builtin": "ball", "volume.resolution": 16, "film.width": 24, "film.height": 24})
    assert vr.render(scene=alone).size == (24, 24)


def test_keys_that_place_data_are_followed(small: vr.Session) -> None:
    before = small.render().color
    small.scene["volume.spacing"] = [1, 1, 4]
    stretched = small.render().color
    del small.scene["volume.spacing"]
    assert not np.array_equal(before, stretched)
    np.testing.assert_array_equal(small.render().color, before)


def test_turntables_go_round(small: vr.Session) -> None:
    frames = list(small.turntable(4))
    assert [round(frame.scene.camera.azimuth - frames[0].scene.camera.azimuth) for frame in frames] == [0, 90, 180, 270]
    parts = [list(small.turntable(4, part=(part, 2))) for part in range(2)]
    for index, frame in enumerate(frames):
        np.testing.assert_array_equal(frame.color, parts[index % 2][index // 2].color)
    with pytest.raises(ValueError, match="frames"):
        next(small.turntable(0))


def test_progress_is_told_and_gives_up(small: vr.Session) -> None:
    told: list[tuple[str, int, int]] = []
    small.render(progress=lambda *at: told.append(at))
    assert told and all(done <= total for _, done, total in told if total)

    def enough(*_: object) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        small.render(progress=enough, size=(400, 400))
    assert small.render().size == (48, 36)


def test_a_session_does_not_wait_for_itself(small: vr.Session) -> None:
    with pytest.raises(vr.InvalidValue, match="another session"):
        small.render(progress=lambda *_: small.render())


def test_ctrl_c_ends_a_picture_and_the_session_goes_on(volume: np.ndarray) -> None:
    code = """
import _thread, threading, time
import numpy as np, vitrum_render as vr
z, y, x = np.mgrid[-1:1:96j, -1:1:96j, -1:1:96j]
session = vr.Session(np.exp(-3 * (x * x + y * y + z * z)), preset="haze", size=(900, 900), quality="best", backend="cpu")
threading.Timer(0.5, _thread.interrupt_main).start()
try:
    session.render()
    print("whole")
except KeyboardInterrupt:
    print("interrupted")
print(session.render(size=(32, 32), preset="haze").size)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300)
    assert done.stdout.split("\n")[:2] == ["interrupted", "(32, 32)"], done


def test_other_threads_run_meanwhile(volume: np.ndarray) -> None:
    import threading

    with vr.Session(volume, preset="haze", size=(300, 300), backend="cpu") as session:
        pictures: list[vr.Picture] = []
        threads = [threading.Thread(target=lambda: pictures.append(session.render())) for _ in range(3)]
        for thread in threads:
            thread.start()
        counted = 0
        while any(thread.is_alive() for thread in threads):
            counted += 1
        for thread in threads:
            thread.join()
    assert counted > 100 and len(pictures) == 3
    for picture in pictures[1:]:
        np.testing.assert_array_equal(picture.color, pictures[0].color)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows forks nothing")
def test_forked_processes_render(volume: np.ndarray) -> None:
    code = """
import os, sys, numpy as np, vitrum_render as vr
volume = np.arange(24 ** 3, dtype=np.uint16).reshape(24, 24, 24)
session = vr.Session(volume, preset="haze", size=(32, 32), backend="cpu")
session.render()
child = os.fork()
if child == 0:
    try:
        session.render()
    except vr.InvalidValue as error:
        assert "forked" in str(error), error
        vr.render(volume, preset="haze", size=(32, 32), backend="cpu")
        os._exit(7)
    os._exit(1)
sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
"""
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", code], timeout=120, check=False)
    assert done.returncode == 7


def test_a_closed_session_says_so(volume: np.ndarray) -> None:
    with vr.Session(volume, **DRAFT, backend="cpu") as session:
        pass
    with pytest.raises(ValueError, match="closed"):
        session.render()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"preset": "haez"}, "haze"),
        ({"size": (0, 10)}, "size"),
        ({"size": 10}, "size"),
        ({"size": (10**9, 10**9)}, "film.width"),
        ({"quality": "nice"}, "draft, good"),
        ({"backend": "cuda"}, "auto"),
        ({"threads": 0}, "threads"),
        ({"window": 3}, "both"),
        ({"colormap": "virids"}, "viridis"),
        ({"view": "front"}, "anterior"),
        ({"settings": {"camera.azimut": 3}}, "camera.azimuth"),
        ({"settings": {"camera.zoom": float("nan")}}, "found nan"),
        ({"settings": {"volume.array": "a"}}, "in memory"),
        ({"isosurfaces": ["high"]}, "VALUE"),
        ({"transfer": "/no/such/file.json"}, "no/such"),
    ],
)
def test_wrong_arguments(volume: np.ndarray, arguments: dict[str, object], said: str) -> None:
    with pytest.raises(vr.VitrumError, match=said):
        vr.render(volume, **{"size": (16, 16), **arguments})


def test_nothing_to_render_and_missing_files(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="nothing to render"):
        vr.render()
    with pytest.raises(OSError, match="missing"):
        vr.open(tmp_path / "missing.nii")
    (tmp_path / "broken.nrrd").write_bytes(b"NRRD0004\nsizes: what\n\n")
    with pytest.raises(vr.FileError, match="broken"):
        vr.open(tmp_path / "broken.nrrd")
    with pytest.raises(ValueError, match="did you mean"):
        vr.render("builtin:glas")


def test_files_are_volumes_with_a_place(file: Path, volume: np.ndarray) -> None:
    opened = vr.open(file, spacing=(3, 2, 1))
    assert isinstance(opened, vr.Volume) and opened.spacing == (3.0, 2.0, 1.0) and opened.orientation == "unknown"
    np.testing.assert_array_equal(opened.values, volume)
    again = pickle.loads(pickle.dumps(opened))
    np.testing.assert_array_equal(again.values, volume)
    np.testing.assert_array_equal(again.affine, opened.affine)


def test_paged_volumes_look_like_whole_ones(file: Path) -> None:
    paged = vr.open(file, paged=True)
    assert isinstance(paged, vr.Volume) and paged.is_paged and paged.shape == vr.open(file).shape and "uint8" in repr(paged)
    with pytest.raises(vr.FileError, match="in memory"):
        _ = paged.values
    scene = vr.Session(file, **DRAFT, backend="cpu").scene
    pictures = [vr.render(volume, scene=scene, backend="cpu") for volume in (paged, vr.open(file))]
    np.testing.assert_array_equal(pictures[0].color, pictures[1].color)


def test_paged_volumes_are_framed_by_their_overview(tmp_path: Path) -> None:
    # More voxels than an overview has: every second one along each axis is looked at.
    z, y, x = np.mgrid[-1:1:136j, -1:1:136j, -1:1:136j]
    np.save(tmp_path / "large.npy", (255 * np.clip(4 - 16 * np.sqrt((x - 0.3) ** 2 + y * y + z * z), 0, 1)).astype(np.uint8))
    whole, paged = (vr.render(vr.open(tmp_path / "large.npy", paged=paged), **DRAFT, backend="cpu") for paged in (False, True))
    assert whole.color.std() > 0.05 and vr.diff(whole, paged).rmse < 0.05


def test_pictures_show_themselves(small: vr.Session) -> None:
    picture = small.render()
    png = picture._repr_png_()
    assert png.startswith(b"\x89PNG") and "48 × 36" in repr(picture)
    assert picture.to_srgb8().shape == (36, 48, 4)
    pil = pytest.importorskip("PIL.Image")
    np.testing.assert_array_equal(np.asarray(pil.open(io.BytesIO(png))), picture.to_srgb8())
    np.testing.assert_array_equal(np.asarray(picture.to_pil()), picture.to_srgb8())


def test_a_dataset_has_every_output(small: vr.Session) -> None:
    pytest.importorskip("xarray")
    data = small.render(outputs=("depth", "light")).to_xarray()
    assert data["color"].dims == ("y", "x", "color_channel") and data["depth"].shape == (36, 48)
    assert list(data["color_channel"].values) == ["R", "G", "B", "A"] and "light" not in data
    assert vr.Scene.from_toml(data.attrs["scene"].replace('file = "array"', 'builtin = "ball"')).film.width == 48


def test_annotations_are_drawn_and_lent(small: vr.Session) -> None:
    picture = small.render(settings={"annotation.0.kind": "scale_bar"})
    assert picture.annotations is not None and "<svg" in picture.annotations
    assert not np.array_equal(picture.to_srgb8(), small.render().to_srgb8())


def test_differences(small: vr.Session) -> None:
    a, b = small.render(), small.render(settings={"film.exposure": 1})
    assert vr.diff(a, a).max_abs == 0 and vr.diff(a, a).psnr == np.inf
    assert vr.diff(a, b).max_abs > 0.01 and vr.diff(a, b).worst_pixel is not None
    with pytest.raises(ValueError, match="no picture"):
        vr.diff(a, np.zeros((3, 3)))
    with pytest.raises(ValueError, match="size"):
        vr.diff(a, np.zeros((3, 3, 3)))


def test_meshes_are_shown_and_voxelized() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    mesh = vr.Mesh(corners, faces)
    np.testing.assert_array_equal(mesh.positions, corners.astype(np.float32))
    picture = vr.render(mesh, size=(32, 32), quality="draft", backend="cpu")
    assert picture.color[..., 3].max() > 0
    larger = vr.render(mesh, size=(32, 32), quality="draft", backend="cpu", settings={"mesh.0.rotation": [0, 0, 90]})
    assert not np.array_equal(picture.color, larger.color)
    voxels = vr.voxelize(mesh, 16, solid="nonzero", backend="cpu")
    # The tetrahedron's volume is 1/6.
    assert abs(voxels.values.sum() / 255 * np.prod(voxels.spacing) - 1 / 6) < 1e-3
    with pytest.raises(ValueError, match="vertex"):
        vr.Mesh(corners, [[0, 1, 4]])
    with pytest.raises(ValueError, match="voxels already"):
        vr.voxelize(voxels, 16)


def test_the_program_is_inside() -> None:
    code = "import sys; sys.argv = ['vitrum', 'presets']; from vitrum_render._program import main; main()"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and "haze" in done.stdout
    wrong = subprocess.run([sys.executable, "-c", code.replace("presets", "prests")], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2 and "presets" in wrong.stderr
