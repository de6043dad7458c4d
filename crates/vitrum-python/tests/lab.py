"""A real JupyterLab and a real browser, without a screen."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import vitrum_render as vr

_SECONDS = 30.0


def missing() -> str | None:
    """Why there is no browser test here; ``None`` where there is one."""
    for name in ("anywidget", "jupyterlab", "jupyter_client", "selenium"):
        try:
            __import__(name)
        except ImportError:
            return f"the package {name} is not installed"
    if not (shutil.which("chromium") or shutil.which("google-chrome")) or not shutil.which("chromedriver"):
        return "Chromium and chromedriver are not installed"
    return None


def until(what: str, ask: Callable[[], Any]) -> Any:
    """The first true answer."""
    end = time.monotonic() + _SECONDS
    while time.monotonic() < end:
        if answer := ask():
            return answer
        time.sleep(0.1)
    raise AssertionError(f"{what} did not come in {_SECONDS:.0f} seconds")


def notebook(path: Path, *cells: str) -> None:
    """Writes a notebook of these cells."""
    made = [{"cell_type": "code", "id": f"c{index}", "metadata": {}, "execution_count": None, "outputs": [], "source": cell} for index, cell in enumerate(cells)]
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    path.write_text(json.dumps({"cells": made, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}))


@contextmanager
def server(folder: Path) -> Iterator[str]:
    """JupyterLab's address; the folder has its settings, too."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    own = {name: str(folder / name.lower()) for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")}
    source = str(Path(vr.__file__).parent.parent)
    path = os.pathsep.join([source, os.environ.get("PYTHONPATH", "")]).rstrip(os.pathsep)
    options = [f"--ServerApp.port={port}", "--ServerApp.ip=127.0.0.1", "--IdentityProvider.token=", f"--ServerApp.root_dir={folder}"]
    options += ["--no-browser", "--allow-root", "--expose-app-in-browser", "--ServerApp.port_retries=0"]
    with open(folder / "lab.log", "w") as log:
        lab = subprocess.Popen([sys.executable, "-m", "jupyterlab", *options], cwd=folder, env={**os.environ, **own, "PYTHONPATH": path}, stdout=log, stderr=log)
    address = f"http://127.0.0.1:{port}"

    def answers() -> bool:
        if lab.poll() is not None:
            raise AssertionError("JupyterLab ended: " + (folder / "lab.log").read_text()[-2000:])
        try:
            return bool(urllib.request.urlopen(f"{address}/api/status", timeout=5).status == 200)
        except (urllib.error.URLError, OSError):
            return False

    try:
        until("JupyterLab", answers)
        yield address
    finally:
        lab.terminate()
        lab.wait(30)


@contextmanager
def browser() -> Iterator[Any]:
    """Chromium."""
    from selenium import webdriver

    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium") or shutil.which("google-chrome") or ""
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--window-size=1200,1000", "--force-device-scale-factor=1"):
        options.add_argument(argument)
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(shutil.which("chromedriver")))
    try:
        yield driver
    finally:
        driver.quit()


@contextmanager
def kernel(folder: Path) -> Iterator[Callable[[str], Any]]:
    """A function that evaluates an expression in the notebook's kernel."""
    from jupyter_client.blocking import BlockingKernelClient

    files = until("the kernel", lambda: list((folder / "jupyter_runtime_dir").glob("kernel-*.json")))
    client = BlockingKernelClient(connection_file=str(files[0]))
    client.load_connection_file()
    client.start_channels()

    def evaluate(expression: str) -> Any:
        request = client.execute("", user_expressions={"it": f"__import__('json').dumps({expression})"}, store_history=False)
        while (reply := client.get_shell_msg(timeout=60))["parent_header"]["msg_id"] != request:
            pass
        found = reply["content"]["user_expressions"]["it"]
        assert found["status"] == "ok", found
        return json.loads(found["data"]["text/plain"][1:-1].encode().decode("unicode_escape"))

    try:
        client.wait_for_ready(timeout=60)
        yield evaluate
    finally:
        client.stop_channels()
