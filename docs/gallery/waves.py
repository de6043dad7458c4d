"""Waves of the sea that move: OBJ files of the closed slab of water that `builtin:waves` is, one for each picture of an animation that repeats.

    waves.py FOLDER [--frames 48] [--squares 96]

writes FOLDER/waves-000.obj, waves-001.obj, …: 2 wide along x and y, waves around z = 0 on top, the bottom at z = -0.75, with normals.
"""

import argparse
import math
from pathlib import Path

# Cycles per unit along x and y, phase in cycles, amplitude.
WAVES = [
    ((1.2, 0.5), 0.10, 0.014), ((-0.6, 1.4), 0.37, 0.012), ((1.9, -1.3), 0.62, 0.006), ((0.9, 2.3), 0.83, 0.005), ((3.1, 1.1), 0.20, 0.0022),
]
BOTTOM = -0.75


def surface(x, y, time):
    """Height and normal. In deep water a wave's frequency grows with the root of its cycles; whole periods make the animation repeat."""
    height, slope_x, slope_y = 0.0, 0.0, 0.0
    for (across, along), phase, amplitude in WAVES:
        periods = round(2 * math.sqrt(math.hypot(across, along)))
        angle = 2 * math.pi * (across * x + along * y + phase + 0.5 - periods * time)
        height += amplitude * math.sin(angle)
        slope_x += amplitude * 2 * math.pi * across * math.cos(angle)
        slope_y += amplitude * 2 * math.pi * along * math.cos(angle)
    length = math.sqrt(slope_x**2 + slope_y**2 + 1)
    return height, (-slope_x / length, -slope_y / length, 1 / length)


def slab(squares, time):
    """Points with normals, and squares of their numbers, counted from 1."""
    points, faces = [], []
    along = [2 * index / squares - 1 for index in range(squares + 1)]

    def grid(rows):
        first, wide = len(points) + 1, len(rows[0])
        points.extend(point for row in rows for point in row)
        for row in range(len(rows) - 1):
            for column in range(wide - 1):
                corner = first + row * wide + column
                faces.append((corner, corner + 1, corner + 1 + wide, corner + wide))

    top = {(x, y): surface(x, y, time) for x in along for y in along}
    grid([[((x, y, top[x, y][0]), top[x, y][1]) for x in along] for y in along])
    grid([[((x, y, BOTTOM), (0, 0, -1)) for y in along] for x in along])
    for edge, normal in [
        (lambda a: (a, -1.0), (0, -1, 0)), (lambda a: (1.0, a), (1, 0, 0)), (lambda a: (-a, 1.0), (0, 1, 0)), (lambda a: (-1.0, -a), (-1, 0, 0)),
    ]:
        places = [edge(a) for a in along]
        grid([[((*place, BOTTOM), normal) for place in places], [((*place, surface(*place, time)[0]), normal) for place in places]])
    return points, faces


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--frames", type=int, default=48)
    parser.add_argument("--squares", type=int, default=96)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for frame in range(arguments.frames):
        points, faces = slab(arguments.squares, frame / arguments.frames)
        lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for (x, y, z), _ in points]
        lines += [f"vn {x:.6f} {y:.6f} {z:.6f}" for _, (x, y, z) in points]
        lines += ["f " + " ".join(f"{corner}//{corner}" for corner in face) for face in faces]
        (arguments.folder / f"waves-{frame:03}.obj").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
