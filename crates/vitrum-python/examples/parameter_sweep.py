# %% [markdown]
# # A sweep over parameters, on a cluster
#
# The cluster is Dask's: here two processes of this machine; `dask_jobqueue.SLURMCluster` makes one of many.

# %%
import numpy as np

import vitrum_render as vr

z, y, x = np.mgrid[-1:1:48j, -1:1:48j, -1:1:48j]
volume = (255 * np.clip(1.5 - 1.5 * np.sqrt(x * x + y * y + z * z), 0, 1)).astype(np.uint8)


def main() -> None:
    """Processes that are spawned read this file again: what starts them stands in a function."""
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as cluster, Client(cluster) as client:
        grid = vr.dask.sweep(volume, {"light.0.azimuth": [-40, 0, 40], "preset": ["haze", "plain"]}, client=client, size=(160, 120))
        for values, picture in grid.items():
            print(values, picture.size)
        with open("parameter_sweep.png", "wb") as file:
            file.write(grid._repr_png_())


if __name__ == "__main__":
    main()
