"""Work that is shared out to the workers of Dask, and comes back in order."""

from __future__ import annotations

import itertools
import threading
import uuid
from collections import OrderedDict, deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from .errors import DeviceError
from .remote import RemotePicture
from .resuming import Folder
from .scene import Scene
from .session import Session

# Sessions that a worker keeps.
_KEPT = 2
# Times that a task is done again after an exception, and data is sent again after the only workers that had it ended.
_RETRIES = 2
_FLIGHTS_A_THREAD = 4


@dataclass(frozen=True)
class Device:
    """The device that each worker opens, as :class:`vitrum_render.Session` takes it."""

    backend: Any
    adapter: str | None
    threads: int | None
    memory_limit: int | None

    def arguments(self) -> dict[str, Any]:
        """Arguments of a session; without a number of threads those that Dask lets the worker have."""
        threads = _threads_of_worker() if self.threads is None else self.threads
        return {"backend": self.backend, "adapter": self.adapter, "threads": threads, "memory_limit": self.memory_limit}


@dataclass(frozen=True)
class Result:
    """What a picture is to have."""

    outputs: tuple[str, ...]
    formats: tuple[str, ...]

    def of(self, session: Session, scene: Scene | None = None) -> RemotePicture:
        return RemotePicture.of(session.render(scene, outputs=self.outputs), self.formats)


class Job(Protocol):
    """Pictures that are asked for, by their index."""

    def here(self, indices: Iterable[int]) -> Iterator[RemotePicture]:
        """Makes pictures in this process."""

    def send(self, client: Any) -> None:
        """Sends what the workers need."""

    def submit(self, client: Any, index: int, **options: Any) -> Any:
        """The future of a picture."""


class Views(Job):
    """Scenes of the same data. ``token`` tells it from other data."""

    def __init__(self, data: Any, token: str, scenes: Sequence[Scene], result: Result, device: Device) -> None:
        self._data, self._scenes, self._result, self._device = data, scenes, result, device
        self._key = (token, scenes[0].to_toml(), device)
        self._sent: Any = None

    def here(self, indices: Iterable[int]) -> Iterator[RemotePicture]:
        with Session(self._data, scene=self._scenes[0], **self._device.arguments()) as session:
            for index in indices:
                yield self._result.of(session, self._scenes[index])

    def send(self, client: Any) -> None:
        self._sent = None if self._data is None else client.scatter(self._data, broadcast=True, hash=False)

    def submit(self, client: Any, index: int, **options: Any) -> Any:
        return client.submit(_view, self._sent, self._key, self._scenes[0], self._scenes[index], self._result, **options)


class Series(Job):
    """Points in time, each with data of its own. The look is fitted to the first."""

    def __init__(self, array: Any, arguments: dict[str, Any], look: dict[str, Any], result: Result, device: Device) -> None:
        self._array, self._arguments, self._look, self._result, self._device = array, arguments, look, result, device
        self._scene: Scene | None = look["scene"] if set(look) == {"scene"} else None

    def here(self, indices: Iterable[int]) -> Iterator[RemotePicture]:
        if self._scene is None:
            self._scene = _look(self._volume(0), self._arguments, self._look)
        for index in indices:
            yield _point(self._volume(index), self._arguments, self._scene, self._result, self._device)

    def send(self, client: Any) -> None:
        if self._scene is None:
            self._scene = client.submit(_look, self._point(client, 0), self._arguments, self._look, pure=False, retries=_RETRIES).result()

    def submit(self, client: Any, index: int, **options: Any) -> Any:
        return client.submit(_point, self._point(client, index), self._arguments, self._scene, self._result, self._device, **options)

    def _volume(self, index: int) -> Any:
        point = self._array[index]
        return point.compute() if hasattr(point, "compute") else np.asarray(point)

    def _point(self, client: Any, index: int) -> Any:
        point = self._array[index]
        return client.compute(point) if hasattr(point, "compute") else client.scatter(np.asarray(point), hash=False)


def pictures(
    job: Job,
    count: int,
    client: Any = None,
    in_flight: int | None = None,
    resources: Mapping[str, float] | None = None,
    folder: Folder | None = None,
) -> Iterator[RemotePicture]:
    """The pictures of a job in order. A folder keeps them, and those that are there already are not made again."""
    # Before any work: a picture of another scene may be the last one.
    there = folder.there() if folder is not None else {}
    return _merged(job, [index for index in range(count) if index not in there], count, _client(client), in_flight, resources, folder)


def _merged(
    job: Job, missing: list[int], count: int, client: Any, in_flight: int | None, resources: Mapping[str, float] | None, folder: Folder | None
) -> Iterator[RemotePicture]:
    made = job.here(missing) if client is None else _in_order(job, missing, client, in_flight, resources)
    wanted = set(missing)
    for index in range(count):
        if index not in wanted and folder is not None:
            yield folder.read(index)
            continue
        picture = next(made)
        yield picture if folder is None else folder.add(index, picture)


def _in_order(job: Job, indices: list[int], client: Any, in_flight: int | None, resources: Mapping[str, float] | None) -> Iterator[RemotePicture]:
    from distributed import as_completed

    if not indices:
        return
    limit = in_flight or _FLIGHTS_A_THREAD * max(1, sum(client.nthreads().values()))
    run = uuid.uuid4().hex
    waiting, order = iter(indices), deque[int]()
    ready: dict[int, RemotePicture] = {}
    flying: dict[str, tuple[int, int, Any]] = {}
    completed: Any = as_completed()  # type: ignore[no-untyped-call, unused-ignore]
    sendings = 0

    def submit(index: int) -> None:
        key = f"vitrum-{run}-{index}-{sendings}"
        options: dict[str, Any] = {"resources": dict(resources)} if resources else {}
        future = job.submit(client, index, key=key, pure=False, retries=_RETRIES, **options)
        flying[key] = (index, sendings, future)
        completed.add(future)

    def fill() -> None:
        for index in itertools.islice(waiting, max(0, limit - len(order))):
            order.append(index)
            submit(index)

    job.send(client)
    fill()
    try:
        while order:
            while order[0] not in ready:
                future = next(completed)
                index, sent, _ = flying.pop(future.key)
                picture = _result(future)
                if picture is None:
                    # The workers that had the data ended, all of them.
                    if sent == sendings:
                        if sendings == _RETRIES:
                            raise DeviceError("the workers that had the data ended again and again", "give them more memory; the cluster's log says more")
                        sendings += 1
                        job.send(client)
                    submit(index)
                else:
                    ready[index] = picture
            picture = ready.pop(order.popleft())
            fill()
            yield picture
    finally:
        client.cancel([future for _, _, future in flying.values()])


def _result(future: Any) -> RemotePicture | None:
    """The picture; ``None`` where it was lost with its worker, also on the way here."""
    from distributed import CancelledError

    if future.cancelled() or future.status == "lost":
        return None
    try:
        picture: RemotePicture = future.result()
    except CancelledError:
        return None
    return picture


def _client(client: Any) -> Any:
    if client is not None:
        return client
    try:
        from distributed import get_client

        return get_client()
    except (ImportError, ValueError):
        return None


def _threads_of_worker() -> int | None:
    try:
        from distributed import get_worker

        return int(get_worker().state.nthreads)
    except (ImportError, ValueError):
        return None


class _Kept:
    """A session of a worker, and who may use it."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.session: Session | None = None
        self.is_closed = False


_kept: OrderedDict[Any, _Kept] = OrderedDict()
_kept_lock = threading.Lock()


def _take(key: Any) -> _Kept:
    """The session's place, newest first; the oldest is closed as soon as nobody uses it."""
    with _kept_lock:
        kept = _kept.setdefault(key, _Kept())
        _kept.move_to_end(key)
        old = [_kept.popitem(last=False)[1] for _ in range(len(_kept) - _KEPT)]
    for each in old:
        with each.lock:
            each.is_closed = True
            if each.session is not None:
                each.session.close()
    return kept


def _view(data: Any, key: tuple[str, str, Device], base: Scene, scene: Scene, result: Result) -> RemotePicture:
    while True:
        kept = _take(key)
        with kept.lock:
            if kept.is_closed:
                continue
            if kept.session is None:
                kept.session = Session(data, scene=base, **key[2].arguments())
            return result.of(kept.session, scene)


def _look(volume: Any, arguments: dict[str, Any], look: dict[str, Any]) -> Scene:
    with Session(volume, backend="cpu", threads=1, **arguments, **look) as session:
        return session.scene


def _point(volume: Any, arguments: dict[str, Any], scene: Scene, result: Result, device: Device) -> RemotePicture:
    with Session(volume, scene=scene, **arguments, **device.arguments()) as session:
        return result.of(session)
