# %% [markdown]
# # A label map: parts in colours of their own
#
# Values of labels are names, not measurements: they are never interpolated.

# %%
import numpy as np

import vitrum_render as vr

z, y, x = np.mgrid[-1:1:64j, -1:1:64j, -1:1:64j]
labels = np.zeros(x.shape, np.uint8)
for number, (cx, cy, cz, radius) in enumerate([(0, 0, 0, 0.45), (0.45, 0.3, 0.2, 0.3), (-0.4, -0.3, 0.3, 0.3), (0.1, 0.35, -0.45, 0.3)], start=1):
    labels[(x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 < radius**2] = number

# %%
vr.render(labels, preset="labels", size=(640, 480)).save("label_map.png")

# %% [markdown]
# One part alone: the others' opacity is 0. `scene.transfer` is what the preset made, and any key of it can be changed.

# %%
with vr.Session(labels, preset="labels", size=(640, 480)) as session:
    for point in session.scene.transfer.opacity:
        if round(point["value"]) != 2:
            point["opacity"] = 0
    session.render().save("label_map_one.png")
