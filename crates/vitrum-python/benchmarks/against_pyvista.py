"""The same array by PyVista and by Vitrum, in turns: seconds for a picture, from the array to the PNG's pixels.

    python against_pyvista.py [volume] [--rounds 5]

Each program shows the values by its plain look: PyVista by an opacity that rises along the range, shaded by the gradient, without a window, by the mapper of VTK that
it chooses itself; Vitrum by its preset `plain`, "like it" with a ray a pixel, shaded by the gradient, without shadows; as a draft with shadows; as `good`, with more rays
where pixels differ, too.
"""

from __future__ import annotations

import argparse
import statistics
import time

import numpy as np

import vitrum_render as vr

SIZE = (512, 512)


def by_pyvista(array: np.ndarray, spacing: tuple[float, float, float]) -> np.ndarray:
    import pyvista

    # begin pyvista
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    image = pyvista.ImageData(dimensions=array.shape[::-1], spacing=spacing[::-1])
    image.point_data["values"] = array.ravel()
    plotter.add_volume(image, scalars="values", opacity="linear", cmap="bone", shade=True, show_scalar_bar=False)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    # end
    return picture


def by_vitrum(array: np.ndarray, spacing: tuple[float, float, float], quality: str, settings: dict[str, object]) -> np.ndarray:
    # begin vitrum
    picture = vr.render(array, spacing, preset="plain", size=SIZE, quality=quality, settings=settings, backend="cpu")
    # end
    return picture.to_srgb8()


def main() -> None:
    arguments = argparse.ArgumentParser()
    arguments.add_argument("volume", nargs="?")
    arguments.add_argument("--rounds", type=int, default=5)
    chosen = arguments.parse_args()
    if chosen.volume:
        volume = vr.open(chosen.volume)
        # As the scan has them: integers stay integers in both.
        array, spacing = np.array(volume.array), volume.spacing
    else:
        z, y, x = np.mgrid[-1:1:128j, -1:1:128j, -1:1:128j]
        array, spacing = np.exp(-4 * (x * x + y * y + z * z)).astype(np.float32), (1.0, 1.0, 1.0)
    ways = {
        "PyVista": lambda: by_pyvista(array, spacing),
        "Vitrum, like it": lambda: by_vitrum(array, spacing, "draft", {"light.0.shadows": False}),
        "Vitrum, draft": lambda: by_vitrum(array, spacing, "draft", {}),
        "Vitrum, good": lambda: by_vitrum(array, spacing, "good", {}),
    }
    times: dict[str, list[float]] = {name: [] for name in ways}
    for name, make in ways.items():
        make()
    for _ in range(chosen.rounds):
        for name, make in ways.items():
            start = time.perf_counter()
            make()
            times[name].append(time.perf_counter() - start)
    source = open(__file__, encoding="utf-8").read()
    lines = {name: source.split(f"# begin {name}\n")[1].split("# end")[0].strip().count("\n") + 1 for name in ("pyvista", "vitrum")}
    print(f"{array.shape} {array.dtype}, {SIZE[0]} × {SIZE[1]}; lines of code: {lines}")
    for name, measured in times.items():
        print(f"{name:17} median {statistics.median(measured):6.2f} s, {min(measured):.2f} to {max(measured):.2f}")


if __name__ == "__main__":
    main()
