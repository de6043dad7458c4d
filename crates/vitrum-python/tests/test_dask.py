"""Pictures made by several processes are those of one, whatever happens to the processes."""

from __future__ import annotations

import os
import signal
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

distributed = pytest.importorskip("distributed", reason="the package `distributed` is not installed")

from conftest import ball  # noqa: E402

import vitrum_render as vr  # noqa: E402

LOOK: dict[str, Any] = {"preset": "plain", "size": (64, 48), "quality": "draft", "backend": "cpu"}
TURN = {**LOOK, "spacing": (2, 1, 1)}


class Renders(distributed.diagnostics.plugin.SchedulerPlugin):
    """Counts how often each picture came to be, by the scheduler's log."""

    def __init__(self) -> None:
        self.ends: Counter[int] = Counter()

    def transition(self, key: str, start: str, finish: str, *arguments: Any, **more: Any) -> None:
        if str(key).startswith("vitrum-") and (start, finish) == ("processing", "memory"):
            self.ends[int(str(key).split("-")[2])] += 1


@pytest.fixture(scope="module")
def cluster() -> Iterator[Any]:
    # Spawned workers may import the test's module, and inherit the path on which the package was found.
    source = str(Path(vr.__file__).parent.parent)
    os.environ["PYTHONPATH"] = os.pathsep.join([source, os.environ.get("PYTHONPATH", "")]).rstrip(os.pathsep)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster:
        yield cluster


@pytest.fixture
def client(cluster: Any) -> Iterator[Any]:
    with distributed.Client(cluster) as client:
        client.wait_for_workers(2, timeout=60)
        yield client


@pytest.fixture
def renders(cluster: Any) -> Iterator[Renders]:
    plugin = Renders()
    cluster.scheduler.add_plugin(plugin, name="renders")
    yield plugin
    cluster.scheduler.remove_plugin("renders")


@pytest.fixture(scope="module")
def alone() -> list[vr.Picture]:
    """The pictures of one process."""
    return list(vr.turntable(ball(), 12, **TURN))


def same(pictures: Any, others: Any) -> bool:
    pictures, others = list(pictures), list(others)
    return len(pictures) == len(others) and all(np.array_equal(a.color, b.color) for a, b in zip(pictures, others, strict=True))


def test_two_processes_make_the_pictures_of_one(client: Any, renders: Renders, alone: list[vr.Picture]) -> None:
    made = list(vr.dask.turntable(ball(), 12, client, outputs=("color", "depth"), **TURN))
    assert same(made, alone)
    assert [picture.scene for picture in made] == [picture.scene for picture in alone]
    assert renders.ends == Counter(range(12))
    assert made[3]["depth"].shape == (48, 64) and made[3].size == (64, 48)
    assert made[3].statistics["backend"] == "cpu" and made[3].statistics["adapter"].startswith("1 thread")
    assert np.array_equal(made[3].to_srgb8(), alone[3].to_srgb8())
    with pytest.raises(vr.InvalidValue, match="no output 'normal'"):
        made[3]["normal"]


def test_without_a_cluster_they_are_made_here(alone: list[vr.Picture], tmp_path: Path) -> None:
    made = list(vr.dask.turntable(ball(), 12, formats=("png", "exr"), **TURN))
    assert same(made, alone)
    made[0].save(tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes() == alone[0].encode("png")
    made[0].save(tmp_path / "a.exr")
    with pytest.raises(vr.InvalidValue, match="formats"):
        made[0].save(tmp_path / "a.jpg")


def test_a_scene_and_a_path_are_read_by_the_workers(client: Any, tmp_path: Path, file: Path) -> None:
    scene = vr.Session("builtin:ball", size=(48, 36), quality="draft", settings={"volume.resolution": 16}, backend="cpu").scene
    assert same(vr.dask.turntable(scene, 3, client, backend="cpu"), vr.turntable(None, 3, scene=scene, backend="cpu"))
    assert same(vr.dask.turntable(file, 2, client, **LOOK), vr.turntable(file, 2, **LOOK))


def test_frames_of_a_killed_worker_are_done_again(client: Any, renders: Renders, alone: list[vr.Picture]) -> None:
    made, killed = [], 0
    for picture in vr.dask.turntable(ball(), 12, client, in_flight=4, **TURN):
        made.append(picture)
        if len(made) in (3, 7):
            # The second time the other one, so that both are replaced.
            worker = sorted(client.run(os.getpid).values())[-1 if killed else 0]
            os.kill(worker, signal.SIGKILL)
            killed += 1
    assert killed == 2 and same(made, alone)
    # No picture is missing, and those alone are made twice that a killed worker still had.
    assert set(renders.ends) == set(range(12))
    assert sum(renders.ends.values()) <= 12 + 2 * 4


def test_data_is_sent_again_where_all_workers_end(client: Any, alone: list[vr.Picture]) -> None:
    made = []
    for picture in vr.dask.turntable(ball(), 12, client, in_flight=3, **TURN):
        made.append(picture)
        if len(made) == 2:
            for worker in client.run(os.getpid).values():
                os.kill(worker, signal.SIGKILL)
    assert same(made, alone)


def _slow(dask_worker: Any, slow: str | None) -> None:
    import vitrum_render.sharing as sharing

    quick = sharing.Result.of

    def later(self: Any, *arguments: Any) -> Any:
        time.sleep(0.3)
        return quick(self, *arguments)

    if dask_worker.address == slow:
        later.quick = quick  # type: ignore[attr-defined]
        sharing.Result.of = later  # type: ignore[method-assign]
    elif slow is None:
        sharing.Result.of = getattr(quick, "quick", quick)  # type: ignore[method-assign]


def test_a_slow_worker_changes_no_order(client: Any, renders: Renders, alone: list[vr.Picture]) -> None:
    client.run(_slow, slow=sorted(client.scheduler_info()["workers"])[0])
    try:
        assert same(vr.dask.turntable(ball(), 12, client, in_flight=5, **TURN), alone)
    finally:
        client.run(_slow, slow=None)
    assert renders.ends == Counter(range(12))


def test_a_folder_is_gone_on_with(client: Any, renders: Renders, tmp_path: Path, alone: list[vr.Picture]) -> None:
    turn = vr.dask.turntable(ball(), 12, client, in_flight=2, resume=tmp_path / "turn", **TURN)
    for _ in range(5):
        next(turn)
    turn.close()
    names = sorted(path.name for path in (tmp_path / "turn").iterdir())
    assert names == [f"frame-{index:05}.png" for index in range(5)]
    before = Counter(renders.ends)
    made = list(vr.dask.turntable(ball(), 12, client, resume=tmp_path / "turn", **TURN))
    assert same(made[5:], alone[5:])
    assert all((renders.ends - before)[index] == 0 for index in range(5))
    pixels = [np.asarray(pytest.importorskip("PIL.Image").open(path)) for path in sorted((tmp_path / "turn").glob("*.png"))]
    assert all(np.array_equal(of_file, picture.to_srgb8()) for of_file, picture in zip(pixels, alone, strict=True))
    assert np.array_equal(made[0].to_srgb8(), alone[0].to_srgb8()) and made[0].outputs == []
    for other in (ball() // 2, ball()):
        with pytest.raises(vr.InvalidValue, match="frame-00000.png: this picture is of another scene, or of other data; leave out resume"):
            vr.dask.turntable(other, 12, client, resume=tmp_path / "turn", **{**TURN, "size": (64, 48) if other.max() < 200 else (65, 48)})
    (tmp_path / "turn" / "frame-00007.png").write_bytes(b"text")
    with pytest.raises(vr.InvalidValue, match="frame-00007.png: nothing in this file"):
        vr.dask.turntable(ball(), 12, client, resume=tmp_path / "turn", **TURN)


def test_a_sweep_is_a_grid(client: Any) -> None:
    values = {"light.0.azimuth": [-40, 30], "preset": ["plain", "mip", "bone"]}
    look = {"size": (40, 30), "quality": "draft", "backend": "cpu"}
    grid = vr.dask.sweep(ball(), values, client, **look)
    assert list(grid) == [(azimuth, preset) for azimuth in values["light.0.azimuth"] for preset in values["preset"]]
    for (azimuth, preset), picture in grid.items():
        one = vr.render(ball(), preset=preset, settings={"light.0.azimuth": azimuth}, **look)
        assert np.array_equal(picture.color, one.color), (azimuth, preset)
    assert grid.to_numpy().shape == (2, 3, 30, 40, 4)
    assert grid.contact_sheet(gap=2).shape == (62, 124, 4)
    image = pytest.importorskip("PIL.Image")
    import io

    assert image.open(io.BytesIO(grid._repr_png_())).size == (128, 64)
    colors = vr.dask.sweep(ball(), {"light.0.color": [[1, 0, 0], [0, 0, 1]]}, client, preset="plain", **look)
    assert colors[(1, 0, 0),].color[..., 2].max() < colors[(0, 0, 1),].color[..., 2].max()
    with pytest.raises(vr.InvalidValue, match="sweep"):
        vr.dask.sweep(ball(), {}, client, **look)
    with pytest.raises(vr.SceneError, match="azimut"):
        vr.dask.sweep(ball(), {"light.0.azimut": [1]}, client, **look)


def test_points_in_time_are_computed_on_workers(client: Any) -> None:
    array = pytest.importorskip("dask.array")
    points = np.stack([np.roll(ball(), step, axis=2) for step in range(0, 10, 2)])
    scene = vr.Session(points[0], spacing=(2, 1, 1), **LOOK).scene
    expected = [vr.render(point, (2, 1, 1), scene=scene, backend="cpu") for point in points]
    lazy = array.from_array(points, chunks=(1, 12, -1, -1)).map_blocks(_on_a_worker, dtype=points.dtype)
    assert same(vr.dask.timeseries(lazy, (2, 1, 1), client, **LOOK), expected)
    assert same(vr.dask.timeseries(points, (2, 1, 1), client, scene=scene, backend="cpu"), expected)
    assert same(vr.dask.timeseries(points, (2, 1, 1), **LOOK), expected)
    with pytest.raises(vr.InvalidValue, match="t, z, y, x"):
        vr.dask.timeseries(points[0], client=client)


def _on_a_worker(block: np.ndarray) -> np.ndarray:
    from distributed import get_worker

    get_worker()
    return block


def test_workers_keep_few_sessions(client: Any) -> None:
    for step in range(4):
        next(vr.dask.turntable(np.roll(ball(), step, 0), 1, client, **TURN))
    assert max(client.run(lambda: len(__import__("vitrum_render.sharing").sharing._kept)).values()) <= 2


def test_errors_of_workers_arrive(client: Any) -> None:
    with pytest.raises(vr.VitrumError):
        list(vr.dask.turntable(ball(), 2, client, **{**TURN, "backend": "gpu", "adapter": "no such adapter"}))
