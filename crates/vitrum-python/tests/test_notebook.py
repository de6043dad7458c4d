"""The widget: by its traits, and by hand in a browser."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import lab
import numpy as np
import pytest

import vitrum_render as vr

LOOK: dict[str, Any] = {"preset": "amber", "size": (200, 150), "backend": "cpu"}


def test_without_anywidget_there_is_advice(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "anywidget", None)
    with pytest.raises(ImportError, match=r"pip install vitrum-render\[notebook\]"):
        vr.view(np.zeros((4, 4, 4)))


@pytest.fixture
def viewer(volume: np.ndarray) -> Iterator[Any]:
    pytest.importorskip("anywidget")
    with_viewer = vr.view(volume, spacing=(2, 1, 1), **LOOK)
    yield with_viewer
    with_viewer.close()


def rested(viewer: Any) -> vr.Picture:
    """The whole picture of the scene as shown."""
    return lab.until("the whole picture", lambda: viewer.picture if viewer.picture is not None and viewer.picture.scene == viewer.scene else None)


def test_it_shows_what_render_makes(viewer: Any, volume: np.ndarray) -> None:
    picture = rested(viewer)
    assert picture.size == (200, 150)
    expected = vr.render(volume, (2, 1, 1), scene=viewer.scene, backend="cpu")
    assert np.array_equal(picture.color, expected.color) and np.array_equal(viewer.snapshot().color, expected.color)
    assert vr.Scene.from_toml(viewer.scene_toml) == viewer.scene
    assert viewer._image == picture.encode("png") and viewer._image_kind == "png"
    data = viewer._repr_mimebundle_()[0]
    assert data["image/png"] == viewer._image and "application/vnd.jupyter.widget-view+json" in data


def test_controls_change_the_scene(viewer: Any) -> None:
    first, base = rested(viewer), viewer.scene
    viewer.azimuth, viewer.elevation, viewer.zoom = 70, -10, 1.5
    viewer.light_azimuth, viewer.light_elevation = 20, 60
    scene = viewer.scene
    assert [scene[f"camera.{name}"] for name in ("azimuth", "elevation", "zoom")] == [70, -10, 1.5]
    assert [scene[f"light.0.{name}"] for name in ("azimuth", "elevation")] == [20, 60]
    assert not np.array_equal(rested(viewer).color, first.color)
    viewer.opacity = 2
    before, after = ([point["opacity"] for point in of["transfer.opacity"]] for of in (base, viewer.scene))
    assert after == pytest.approx([1 - (1 - opacity) ** 2 for opacity in before], abs=1e-6) and after != before
    viewer.eta = 0.5
    before, after = ([point["ior"] for point in of["transfer.ior"]] for of in (base, viewer.scene))
    assert after == pytest.approx([1 + (ior - 1) / 2 for ior in before], abs=1e-6) and after != before
    viewer.opacity = viewer.eta = 1
    assert viewer.scene["transfer"] == base["transfer"]


def test_a_preset_changes_the_look_alone(viewer: Any, volume: np.ndarray) -> None:
    viewer.azimuth = 70
    viewer.preset = "bone"
    bone = vr.Session(volume, (2, 1, 1), preset="bone", backend="cpu").scene
    assert viewer.scene["transfer"] == bone["transfer"] and viewer.scene["camera.azimuth"] == 70
    assert rested(viewer).size == (200, 150)
    shown = viewer.scene
    viewer.preset = "no such preset"
    assert "no such preset" in viewer._message and viewer.scene == shown
    assert "glass" not in viewer._presets and "haze" in viewer._presets


def test_without_points_there_are_no_sliders(volume: np.ndarray) -> None:
    pytest.importorskip("anywidget")
    viewer = vr.view(volume, **{**LOOK, "preset": "bone"})
    assert viewer._has == {"light": True, "opacity": True, "eta": False}
    viewer.close()


class Slow:
    """A session whose pictures take as many steps as the test lets them."""

    def __init__(self) -> None:
        self.begun: list[float] = []
        self.steps = threading.Semaphore(0)

    def render(self, scene: vr.Scene, progress: Any) -> Any:
        self.begun.append(scene["camera.azimuth"])
        while self.steps.acquire():
            progress("", 0, 1)
            if scene["film.width"] == 64:
                return scene
        raise AssertionError


def test_the_newest_request_is_rendered_and_a_whole_picture_is_given_up() -> None:
    from vitrum_render.newest import Newest, Request

    session, shown = Slow(), []
    newest = Newest(session, lambda picture, whole: shown.append((picture["camera.azimuth"], whole)), pytest.fail)
    scene = vr.Scene({"film.width": 64, "film.height": 48})

    def ask(azimuth: float, moves: bool) -> None:
        newest.ask(Request(scene.copy().set({"camera.azimuth": azimuth}), moves))

    ask(0, True)
    lab.until("the first", lambda: session.begun == [0])
    for azimuth in range(1, 6):
        ask(azimuth, True)
    session.steps.release()
    lab.until("the newest", lambda: session.begun == [0, 5])
    session.steps.release()
    lab.until("both", lambda: len(shown) == 2)
    assert shown == [(0, False), (5, False)]
    ask(6, False)
    session.steps.release()
    lab.until("the draft and the whole one", lambda: session.begun == [0, 5, 6, 6])
    ask(7, True)
    session.steps.release()
    lab.until("the whole one is given up", lambda: session.begun == [0, 5, 6, 6, 7])
    assert shown[2:] == [(6, False)]
    # The end gives up what is rendered.
    threading.Timer(0.1, session.steps.release).start()
    newest.end()
    assert not newest.thread.is_alive() and len(shown) == 3


def test_closing_ends_the_thread_and_the_session(volume: np.ndarray) -> None:
    pytest.importorskip("anywidget")
    viewer = vr.view(volume, **LOOK)
    thread = viewer._newest.thread
    assert thread.is_alive()
    viewer.close()
    viewer.close()
    assert not thread.is_alive()
    viewer.azimuth = 3
    with pytest.raises(vr.VitrumError):
        viewer.snapshot()


VIEW = """
import numpy as np, vitrum_render as vr
z, y, x = np.mgrid[-1:1:32j, -1:1:32j, -1:1:32j]
volume = (255 * np.clip(1.6 - 1.6 * np.sqrt(x * x + 2 * y * y + z * z), 0, 1)).astype(np.uint8)
viewer = vr.view(volume, preset="amber", size=(400, 300), backend="cpu")
viewer
"""


@pytest.mark.skipif(lab.missing() is not None, reason=str(lab.missing()))
def test_it_is_turned_by_hand_in_jupyterlab(tmp_path: Path) -> None:
    from selenium.webdriver import ActionChains
    from selenium.webdriver.common.action_chains import ScrollOrigin
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

    lab.notebook(tmp_path / "view.ipynb", VIEW)
    with lab.server(tmp_path) as address, lab.browser() as driver:
        driver.get(f"{address}/lab/tree/view.ipynb")
        ready = "return !!(window.jupyterapp && jupyterapp.shell.currentWidget && jupyterapp.shell.currentWidget.sessionContext?.session?.kernel?.status === 'idle')"
        lab.until("the notebook", lambda: driver.execute_script(ready))
        driver.execute_script("jupyterapp.commands.execute('notebook:run-all-cells')")
        lab.until("the widget", lambda: driver.find_elements(By.CSS_SELECTOR, ".vitrum-picture img"))
        root, picture, image = (driver.find_element(By.CSS_SELECTOR, name) for name in (".vitrum", ".vitrum-picture", ".vitrum-picture img"))

        def pictures() -> int:
            return int(root.get_attribute("data-pictures") or 0)

        def natural() -> list[int]:
            return list(driver.execute_script("return [arguments[0].naturalWidth, arguments[0].naturalHeight]", image))

        def whole() -> bool:
            return root.get_attribute("data-kind") == "png" and natural() == [400, 300]

        lab.until("the whole picture", whole)
        with lab.kernel(tmp_path) as evaluate:
            state = "[viewer.azimuth, viewer.elevation, viewer.zoom, viewer.light_azimuth, viewer.light_elevation]"
            start = evaluate(state)
            driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", picture)
            before, begin = pictures(), time.monotonic()
            moves = ActionChains(driver, duration=30).move_to_element(picture).click_and_hold()
            for _ in range(60):
                moves.move_by_offset(2, 1)
            moves.perform()
            seconds, made = time.monotonic() - begin, pictures() - before
            print(f"{made} pictures in {seconds:.1f} s of dragging: {made / seconds:.1f} a second; the last of {natural()} pixels")
            assert made > 3 and root.get_attribute("data-kind") == "jpg"
            ActionChains(driver).release().perform()
            lab.until("the whole picture", whole)
            turned = evaluate(state)
            assert turned[0] == pytest.approx(start[0] - 120 * 0.4) and turned[1] == pytest.approx(start[1] + 60 * 0.4)
            assert turned[2:] == start[2:]

            ActionChains(driver).key_down(Keys.SHIFT).drag_and_drop_by_offset(picture, 50, 0).key_up(Keys.SHIFT).perform()
            lab.until("the light moves", lambda: evaluate(state)[3] != start[3])
            assert evaluate(state)[:3] == turned[:3]
            ActionChains(driver).scroll_from_origin(ScrollOrigin.from_element(picture), 0, -100).perform()
            lab.until("it is nearer", lambda: evaluate("viewer.zoom") > 1)
            ActionChains(driver).send_keys(Keys.ARROW_LEFT).perform()
            lab.until("a key turns it", lambda: evaluate("viewer.azimuth") == pytest.approx(turned[0] + 5))

            slider = driver.find_element(By.CSS_SELECTOR, ".vitrum-opacity")
            ActionChains(driver).move_to_element_with_offset(slider, 25, 0).click().perform()
            lab.until("opacity changes", lambda: evaluate("viewer.opacity") > 1)
            menu = driver.find_element(By.CSS_SELECTOR, ".vitrum-preset")
            menu.send_keys("haze")
            lab.until("the preset changes", lambda: evaluate("viewer.preset") == "haze")
            lab.until("the whole picture", lambda: whole() and evaluate("viewer.picture.scene == viewer.scene"))
            driver.execute_script("jupyterapp.shell.activateById(jupyterapp.shell.currentWidget.id)")
            ActionChains(driver).click(picture).send_keys("0").perform()
            lab.until("the first view is back", lambda: evaluate(state) == pytest.approx(start))
            lab.until("the whole picture", lambda: whole() and evaluate("viewer.picture.scene == viewer.scene"))
            driver.save_screenshot(str(tmp_path / "lab.png"))
            driver.execute_async_script("jupyterapp.commands.execute('docmanager:save').then(arguments[0])")
        assert '"image/png"' in (tmp_path / "view.ipynb").read_text(), "a saved notebook has a picture of its own"
