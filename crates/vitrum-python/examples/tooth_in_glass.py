# %% [markdown]
# # A tooth of glass, and the caustic that it throws
#
# `python tooth_in_glass.py [volume]`: any volume of a body in air; without one a molar is made of a few soft balls.

# %%
import sys

import numpy as np

import vitrum_render as vr


def molar(size: int = 96) -> np.ndarray:
    """A crown of four cusps on two roots; 0 outside, 1 inside, and a soft edge of some voxels."""
    z, y, x = np.mgrid[-1 : 1 : size * 1j, -1 : 1 : size * 1j, -1 : 1 : size * 1j]
    depth = np.full(x.shape, -np.inf)
    for cx, cy in [(-0.2, -0.2), (0.2, -0.2), (-0.2, 0.2), (0.2, 0.2)]:
        depth = np.maximum(depth, 0.34 - np.sqrt((x - cx) ** 2 + (y - cy) ** 2 + ((z - 0.35) / 1.2) ** 2))
    for side in (-1, 1):
        along = np.clip((z + 0.9) / 1.3, 0, 1)
        depth = np.maximum(depth, np.where(z < 0.4, 0.08 + 0.16 * along - np.sqrt((x - side * (0.34 - 0.14 * along)) ** 2 + y**2), -1))
    return np.clip(0.5 + depth * size / 8, 0, 1).astype(np.float32)


volume = vr.open(sys.argv[1]) if len(sys.argv) > 1 else vr.Volume(molar(), name="a molar")

# %% [markdown]
# The preset `glass` bends light by the scalar: its index of refraction is a transfer function like colour and opacity. The ground catches the light.

# %%
with vr.Session(volume, preset="glass", size=(640, 480)) as session:
    print(*session.notes, sep="\n")
    session.render().save("tooth_in_glass.png")

    # %% [markdown]
    # What an index of refraction does: the same light, from 1 (nothing bends) up to the preset's own.

    # %%
    for share in (0.0, 0.3, 1.0):
        scene = session.scene.copy()
        for point in scene.transfer.ior:
            point["ior"] = 1 + share * (point["ior"] - 1)
        session.render(scene).save(f"tooth_in_glass_{share:.1f}.png")
