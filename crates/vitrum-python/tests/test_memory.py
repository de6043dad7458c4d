"""Memory stays flat over a thousand pictures."""

from __future__ import annotations

import gc
from pathlib import Path

import numpy as np
import pytest

import vitrum_render as vr


def resident() -> int:
    """Bytes of the process's memory that are in use."""
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="this system does not say how much memory a process has")
def test_a_thousand_pictures_leave_memory_flat(volume: np.ndarray) -> None:
    with vr.Session(volume[::2, ::2, ::2], preset="plain", size=(16, 12), quality="draft", backend="cpu") as session:
        def some(count: int) -> None:
            # Three views: light is kept for each, up to half a gibibyte.
            for index in range(count):
                picture = session.render(settings={"camera.azimuth": index % 3})
                np.asarray(picture.color).sum()

        some(200)
        before = resident()
        some(1000)
        after = resident()
    # A leak of one picture's colour alone would be 1000 × 3 kB, and of its film 12 times that.
    assert after - before < 2_000_000, f"{before} bytes, then {after}"
