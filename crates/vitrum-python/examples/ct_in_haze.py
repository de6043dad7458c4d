# %% [markdown]
# # A CT scan in haze
#
# `python ct_in_haze.py [scan]` takes any file or folder that `vr.open` reads; without one a phantom stands in: a skull with a brain, in Hounsfield units.

# %%
import sys

import numpy as np

import vitrum_render as vr


def phantom(size: int = 96) -> vr.Volume:
    """A head of ellipsoids, after Shepp and Logan: skin, skull, brain, two ventricles, one bleeding."""
    z, y, x = np.mgrid[-1 : 1 : size * 1j, -1 : 1 : size * 1j, -1 : 1 : size * 1j]

    def inside(centre: tuple[float, float, float], radii: tuple[float, float, float]) -> np.ndarray:
        distance = sum(((axis - c) / r) ** 2 for axis, c, r in zip((x, y, z), centre, radii, strict=True))
        # The edge is as wide as a voxel, as a scanner's is.
        return np.clip((1 - np.sqrt(distance)) * min(radii) * size / 2 + 0.5, 0, 1)

    hounsfield = np.full(x.shape, -1000.0)
    for value, centre, radii in [
        (20, (0, 0, 0), (0.75, 0.92, 0.9)),
        (900, (0, 0, 0.02), (0.69, 0.87, 0.84)),
        (35, (0, 0, 0.02), (0.62, 0.8, 0.77)),
        (8, (-0.16, 0.1, 0.1), (0.1, 0.3, 0.15)),
        (8, (0.16, 0.1, 0.1), (0.1, 0.3, 0.15)),
        (75, (0.3, -0.3, 0.2), (0.14, 0.14, 0.14)),
    ]:
        share = inside(centre, radii)
        hounsfield = hounsfield * (1 - share) + value * share
    step = 180 / size
    affine = np.diag([step, step, step, 1.0])
    affine[:3, 3] = -90
    return vr.Volume(np.round(hounsfield).astype(np.int16), affine=affine, name="a phantom of a head")


scan = vr.open(sys.argv[1]) if len(sys.argv) > 1 else phantom()
print(scan)

# %% [markdown]
# Three lines: the look is fitted to the scan's own values.

# %%
picture = vr.render(scan, preset="haze", size=(640, 480))
picture.save("ct_in_haze.png")

# %% [markdown]
# From the patient's left, cut open, with a scale bar.

# %%
cut = vr.render(
    scan,
    preset="haze",
    size=(640, 480),
    view="left" if scan.orientation == "patient" else None,
    settings={"clip.0.normal": [0, 0, 1], "clip.0.offset": 20, "annotation.0.kind": "scale_bar"},
)
cut.save("ct_in_haze_cut.png")
