"""Efficiency of two workers against one: T1 / (2 T2) for the same turntable, one thread a worker, in interleaved runs.

    python benchmarks/dask_efficiency.py [FRAMES] [RUNS]

The machine needs two cores that nothing else uses: the load before each run is printed beside it.
"""

from __future__ import annotations

import os
import statistics
import sys
import time

import numpy as np
from distributed import Client, LocalCluster

import vitrum_render as vr


def seconds(client: Client, volume: np.ndarray, frames: int) -> float:
    """The time of a turntable; sessions and data are on the workers when it begins."""
    look = {"preset": "plain", "size": (320, 240), "backend": "cpu"}
    list(vr.dask.turntable(volume, 4, client, **look))
    begin = time.perf_counter()
    made = sum(1 for _ in vr.dask.turntable(volume, frames, client, **look))
    assert made == frames
    return time.perf_counter() - begin


def main() -> None:
    frames, runs = (int(word) for word in (sys.argv[1:] + ["64", "3"][len(sys.argv) - 1 :])[:2])
    z, y, x = np.mgrid[-1:1:64j, -1:1:64j, -1:1:64j]
    volume = (255 * np.clip(1.5 - 1.5 * np.sqrt(x * x + y * y + z * z), 0, 1)).astype(np.uint8)
    times: dict[int, list[float]] = {1: [], 2: []}
    clusters = {count: LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0") for count in times}
    clients = {count: Client(cluster) for count, cluster in clusters.items()}
    for run in range(runs):
        for count, client in clients.items():
            load = os.getloadavg()[0]
            times[count].append(seconds(client, volume, frames))
            print(f"run {run}: {count} worker(s), {frames} frames in {times[count][-1]:.2f} s, load {load:.1f} on {os.cpu_count()} cores", flush=True)
    middle = {count: statistics.median(found) for count, found in times.items()}
    print(f"efficiency {middle[1] / (2 * middle[2]):.2f}, of the medians {middle[1]:.2f} s and {middle[2]:.2f} s")
    for count in times:
        clients[count].close()
        clusters[count].close()


if __name__ == "__main__":
    main()
