# %% [markdown]
# # Points in time
#
# A four-dimensional array (t, z, y, x) is a picture for each point in time. The look is fitted once: else every picture would have one of its own.

# %%
import numpy as np

import vitrum_render as vr

t, size = 8, 40
time, z, y, x = np.meshgrid(np.arange(t), *3 * [np.linspace(-1, 1, size)], indexing="ij")
angle = 2 * np.pi * time / t
heart = np.exp(-8 * ((x - 0.4 * np.cos(angle)) ** 2 + (y - 0.4 * np.sin(angle)) ** 2 + z**2))
series = (255 * (heart + 0.4 * np.exp(-3 * (x * x + y * y + z * z)))).clip(0, 255).astype(np.uint8)

# %%
first = vr.Session(series[0], preset="haze", size=(320, 240))
scene = first.scene
for index, volume in enumerate(series):
    vr.render(volume, scene=scene).save(f"time_series_{index:02}.png")

# %% [markdown]
# On a cluster the points in time are shared out, and the array stays where it is: `vr.dask.timeseries(array, client=client)`.
