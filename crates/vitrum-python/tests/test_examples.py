"""Every example runs, and writes pictures that show something."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import vitrum_render as vr

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("*.py"))

# Small pictures of one ray a pixel: the examples are tested here, not their looks.
SMALL = """
import runpy, sys
import vitrum_render as vr, vitrum_render.session as session
init = session.Session.__init__
def small(self, *data, **look):
    if look.get("scene") is None:
        look |= {"size": (64, 48), "quality": "draft", "backend": look.get("backend", "cpu")}
    init(self, *data, **look)
session.Session.__init__ = small
sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0], run_name="__main__")
"""


def test_there_are_six() -> None:
    assert len(EXAMPLES) >= 6


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_it_runs(example: Path, tmp_path: Path) -> None:
    if example.stem == "parameter_sweep":
        pytest.importorskip("distributed")
    code = example.read_text() if example.stem == "parameter_sweep" else None
    command = [sys.executable, str(example)] if code else [sys.executable, "-c", SMALL, str(example)]
    # A GPU that is none is as slow as it is careful.
    subprocess.run(command, cwd=tmp_path, check=True, timeout=300, env={**os.environ, "DASK_DISTRIBUTED__WORKER__DAEMON": "True"})
    pictures = sorted(tmp_path.glob("*.png"))
    assert pictures
    for picture in pictures:
        pil = pytest.importorskip("PIL.Image")
        pixels = np.asarray(pil.open(picture).convert("RGB"), dtype=float)
        assert pixels.std() > 2, f"{picture.name} is of one colour"
    assert vr
