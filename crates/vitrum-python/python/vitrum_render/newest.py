"""A thread that renders what was asked for last."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from .errors import VitrumError
from .picture import Picture
from .scene import Scene
from .session import Session

# A picture while something moves takes so many seconds, and its longer edge has at least so many pixels.
_DRAFT_SECONDS = 0.07
_LEAST_EDGE = 160
_FIRST_EDGE = 320
_STEP = 16
# Where the smallest picture takes longer, its samples are so many times as far apart, and light has so many cells.
_COARSEST = 4.0
_COARSE_CELLS = 80


class _Superseded(Exception):
    """A newer picture is asked for."""


@dataclass(frozen=True)
class Request:
    """A picture to render: small ones while something moves, and then the whole one."""

    scene: Scene
    moves: bool


class Newest:
    """A thread that renders the newest request of all, and gives up a whole picture where there is a newer one.

    Parameters
    ----------
    session : Session
        Renders.
    deliver : function
        Takes each picture, and whether it is the whole one; it is called by the thread.
    fail : function
        Takes the exception that a request ended with.
    """

    def __init__(self, session: Session, deliver: Callable[[Picture, bool], None], fail: Callable[[VitrumError], None]) -> None:
        self._session, self._deliver, self._fail = session, deliver, fail
        self._changed = threading.Condition()
        self._wanted: Request | None = None
        self._ends = False
        self._edge = _FIRST_EDGE
        self._distance = 1.0
        self.thread = threading.Thread(target=self._run, name="vitrum-view", daemon=True)
        self.thread.start()

    def ask(self, request: Request) -> None:
        """Asks for a picture; requests that nobody began are forgotten."""
        with self._changed:
            self._wanted = request
            self._changed.notify()

    def end(self) -> None:
        """Gives up what is rendered, and ends the thread."""
        with self._changed:
            self._ends = True
            self._changed.notify()
        if threading.current_thread() is not self.thread:
            self.thread.join()

    def _run(self) -> None:
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._ends or self._wanted is not None)
                if self._ends or self._wanted is None:
                    return
                request, self._wanted = self._wanted, None
            try:
                self._make(request)
            except _Superseded:
                continue
            except VitrumError as error:
                self._fail(error)

    def _make(self, request: Request) -> None:
        draft = self._draft_of(request.scene)
        if draft is not None:
            self._time(draft)
        if not request.moves:
            self._deliver(self._session.render(request.scene, progress=self._whole_goes_on), True)

    def _time(self, draft: Scene) -> None:
        """Renders a small picture, and learns how large the next one may be."""
        edge = self._edge
        begin = time.monotonic()

        def goes_on(*_: object) -> None:
            # Where each were given up for the next, there would be none while something moves: only far too large ones are.
            late = time.monotonic() - begin > 3 * _DRAFT_SECONDS and edge > _LEAST_EDGE
            if self._ends or (late and self._wanted is not None):
                self._edge = max(_LEAST_EDGE, edge // 2)
                raise _Superseded

        picture = self._session.render(draft, progress=goes_on)
        seconds = max(time.monotonic() - begin, 1e-3)
        self._deliver(picture, False)
        # Samples come first: a picture gets larger only when they are as close as they should be.
        left = _DRAFT_SECONDS / seconds
        if edge <= _LEAST_EDGE or self._distance > 1:
            self._distance = min(max(self._distance / min(max(left, 0.5), 1.25), 1.0), _COARSEST)
        if self._distance == 1 or left < 1:
            factor = min(max(math.sqrt(left), 0.5), 1.25)
            self._edge = max(_LEAST_EDGE, int(edge * factor) // _STEP * _STEP)

    def _whole_goes_on(self, *_: object) -> None:
        if self._ends or self._wanted is not None:
            raise _Superseded

    def _draft_of(self, scene: Scene) -> Scene | None:
        """The scene of a small picture with one ray a pixel; ``None`` where the whole one is as small."""
        width, height = scene["film.width"], scene["film.height"]
        scale = self._edge / max(width, height)
        if scale >= 1:
            self._edge = max(width, height)
            scale = 1
        small = {"film.width": max(1, round(width * scale)), "film.height": max(1, round(height * scale))}
        coarse: dict[str, float] = {}
        if self._distance > 1:
            coarse = {"sweep.sample_distance": min(16.0, scene["sweep.sample_distance"] * self._distance), "sweep.light_cells": _COARSE_CELLS}
        return scene.copy().set({**small, **coarse, "film.supersampling": 1, "film.refinement": 1})
