"""Volumes and files that tests share; all of them are made here."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

import vitrum_render as vr

# Tests measure no speed, and a software GPU is no device that `auto` takes: they say which one.
BACKENDS = ["cpu"] if os.environ.get("VITRUM_NO_GPU") else ["cpu", "gpu"]


def ball(size: int = 24) -> np.ndarray:
    """A soft ball, 0 to 255, whose three axes differ."""
    z, y, x = np.mgrid[-1 : 1 : size * 1j, -1 : 1 : (size - 2) * 1j, -1 : 1 : (size - 4) * 1j]
    return (255 * np.clip(1.6 - 1.6 * np.sqrt(x * x + y * y + z * z), 0, 1)).astype(np.uint8)


@pytest.fixture
def volume() -> np.ndarray:
    return ball()


@pytest.fixture
def small(volume: np.ndarray) -> vr.Session:
    with vr.Session(volume, preset="haze", size=(48, 36), quality="draft", backend="cpu") as session:
        yield session


@pytest.fixture
def file(tmp_path: Path, volume: np.ndarray) -> Path:
    path = tmp_path / "ball.npy"
    np.save(path, volume)
    return path
