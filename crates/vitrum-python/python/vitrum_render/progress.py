"""Progress of long work."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

Callback = Callable[[str, int, int], Any]
Progress = bool | Callback | None


@contextmanager
def told(progress: Progress) -> Iterator[Callback | None]:
    """The callback of an argument ``progress``: of ``True`` it is a bar of tqdm, where that is installed; a function is called with the stage's name, the units
    done and all units, and gives the work up by raising an exception."""
    if callable(progress):
        yield progress
        return
    bar = _bar() if progress else None
    if bar is None:
        yield None
        return

    def tell(stage: str, done: int, total: int) -> None:
        if (bar.desc or "") != f"{stage}: ":
            bar.set_description(stage, refresh=False)
        if bar.total != total:
            bar.reset(total)
        bar.update(done - bar.n)

    with bar:
        yield tell


def _bar() -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        return None
    return tqdm(total=1, leave=False)
