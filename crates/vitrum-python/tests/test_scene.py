"""Scenes know their keys."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

import vitrum_render as vr


def test_keys_are_read_and_written_by_path_and_by_attribute() -> None:
    scene = vr.Scene({"camera.azimuth": 30})
    scene.camera.elevation = 12.5
    scene["light.0.azimuth"] = 40
    scene.light[0].elevation = 50
    scene.film.width = 320
    assert (scene["camera.azimuth"], scene["camera"]["elevation"]) == (30.0, 12.5)
    assert (scene.light[0]["azimuth"], scene.light[-1].elevation, len(scene.light)) == (40.0, 50.0, 1)
    assert scene.to_dict()["film"]["width"] == 320
    assert "camera.position" not in scene and "camera.azimuth" in scene
    scene.set("camera.azimuth=10", {"camera.elevation": -5}, method="beams")
    assert (scene.camera.azimuth, scene.camera.elevation, scene.method) == (10.0, -5.0, "beams")


def test_lists_and_none() -> None:
    scene = vr.Scene()
    scene["clip"] = [{"normal": [0, 0, 1], "offset": 2}]
    scene["clip.1.normal"] = (1, 0, 0)
    assert [clip["normal"] for clip in scene.clip] == [[0, 0, 1], [1, 0, 0]]
    scene["ground.height"] = 1.0
    del scene["ground"]
    assert scene["ground"] is None


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("camera.azimut", 3, "camera.azimuth"),
        ("zoom", 3, "camera.zoom"),
        ("light.7.azimuth", 3, "index"),
        ("camera.azimuth", "left", "camera.azimuth"),
        ("camera.azimuth", float("nan"), "finite"),
        ("camera.azimuth", float("inf"), "finite"),
        ("film.width", -1, "film.width"),
        ("film.width", 2.5, "film.width"),
    ],
)
def test_wrong_keys_and_values(key: str, value: object, said: str) -> None:
    scene = vr.Scene()
    before = scene.copy()
    with pytest.raises(vr.SceneError, match=said) as caught:
        scene[key] = value
    assert isinstance(caught.value, ValueError) and scene == before


def test_reading_a_wrong_key() -> None:
    with pytest.raises(KeyError, match="camera.azimuth"):
        vr.Scene()["camera.azimut"]
    with pytest.raises(vr.SceneError, match=r"vr.keys|vitrum_render.keys|did you mean"):
        _ = vr.Scene().nothing_like_it


def test_settings_are_all_or_none() -> None:
    scene = vr.Scene()
    before = scene.copy()
    with pytest.raises(vr.SceneError):
        scene.set({"camera.azimuth": 77, "camera.azimut": 1})
    assert scene == before


def test_scenes_go_through_text_files_and_pickles(tmp_path: Path) -> None:
    scene = vr.Scene({"volume.builtin": "ball", "camera.azimuth": 0.3, "light.0.color": "#ff8800"})
    assert vr.Scene.from_toml(scene.to_toml()) == scene
    assert pickle.loads(pickle.dumps(scene)) == scene
    assert pickle.loads(pickle.dumps(vr.Scene())) == vr.Scene()
    scene.save(tmp_path / "scene.toml")
    assert vr.Scene.load(tmp_path / "scene.toml") == scene
    scene.set({"volume.builtin": None, "volume.file": "scan.npy"}).save(tmp_path / "scene.toml")
    assert vr.Scene.load(tmp_path / "scene.toml").volume.file == str(tmp_path / "scan.npy")


def test_a_wrong_file_is_told_with_its_line() -> None:
    with pytest.raises(vr.SceneError, match=r"line 2|:2"):
        vr.Scene.from_toml('[camera]\nazimut = 3\n[volume]\nbuiltin = "ball"', "mine.toml")


def test_tables() -> None:
    assert "haze" in vr.presets() and "viridis" in vr.colormaps() and "glass" in vr.scenes() and "depth" in vr.outputs()
    assert vr.devices()[-1]["backend"] == "cpu"
    assert {key.path for key in vr.keys("camera.")} >= {"camera.azimuth", "camera.zoom"}
    assert "properties" in vr.schema()
