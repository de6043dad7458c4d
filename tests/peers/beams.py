"""Beams of light beside Mitsuba 3: volume caustics, shadows and surface caustics, radiance against radiance, no exposure fitted.

Both programs get the same triangles with the same normals, the same lamp, medium and camera; Mitsuba's light by `single_scattering.py`,
and that of the opaque ball by Mitsuba's own `volpath` as well. Usage:

    beams.py --vitrum target/release/vitrum [--size 64] [--passes 8] [--only SCENE] [--pictures FOLDER]

It needs what `requirements.txt` lists, and an LLVM that Dr.Jit finds: 14 and 15 cannot compile these kernels, 19 can, and `DRJIT_LIBLLVM_PATH`
names it. It prints a table: for each scene and output the mean radiance of Vitrum over that of Mitsuba with the standard error that Mitsuba's
passes have, the root mean square of the difference over the mean radiance, and that of Mitsuba's noise, by the two halves of its passes.

Pixels that show a clear body or a mirror are left out, but for the soft lamp, where they are a row of their own: light traced from a
point is not seen through glass.
"""

import argparse
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import OpenEXR
from radiance import ball, mi, write_obj
from single_scattering import Lamp, Medium, Pinhole, traced_light, traced_views

FOG = Medium((0.02, 0.01, 0.0), (0.10, 0.08, 0.12), 0.4, (0, 0, 0), 4.0)
CLEAR = Medium((0, 0, 0), (0, 0, 0), 0.0, (0, 0, 0), 4.0)
# Radiant intensity of the lamp, W / sr.
BULB = Lamp(3.0, place=(0.3, 0.4, 3.5))
SILVER = 0.9


def band(radius=1.0, wall=0.02, height=0.7, around=512):
    """A closed band around z that stands on z = 0, with the normals of cylinders and crisp edges."""
    angles = np.linspace(0, 2 * np.pi, around + 1)
    turn = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    up = np.tile([0.0, 0.0, 1.0], (around + 1, 1))
    out = np.concatenate([turn, np.zeros((around + 1, 1))], axis=1)

    def row(r, z):
        return np.concatenate([r * turn, np.full((around + 1, 1), z)], axis=1)

    far = radius + wall
    sides = [
        (row(far, 0), row(far, height), out), (row(far, height), row(radius, height), up),
        (row(radius, height), row(radius, 0), -out), (row(radius, 0), row(far, 0), -up),
    ]
    positions = np.concatenate([np.concatenate([low, high]) for low, high, _ in sides])
    normals = np.concatenate([np.concatenate([normal, normal]) for _, _, normal in sides])
    here = np.arange(around)
    quads = np.concatenate([[here, here + 1, here + around + 2], [here, here + around + 2, here + around + 1]], axis=1).T
    faces = np.concatenate([quads + 2 * (around + 1) * side for side in range(4)])
    return positions, normals, faces


def scenes(size):
    """Name: body, what it is made of, the floor's height, the medium, the lamp, the camera, and a ball around the body."""
    from_front = Pinhole((0.0, -9.0, 0.5), (0.0, 0.0, -0.8), 34.0, size)
    from_above = Pinhole((0.0, -6.0, 2.0), (0.0, 0.0, -1.2), 40.0, size)
    over_ring = Pinhole((-1.7, -3.3, 2.6), (0.05, 0.0, 0.12), 36.0, size)
    sun = Lamp(np.pi, direction=(0.7660444, 0.0, -0.6427876))
    thin = Medium((0.002,) * 3, (0.03,) * 3, 0.0, (0, 0, 0.35), 3.0)
    # Half as many pixels, for as many samples a picture.
    softly = Pinhole((0.0, -9.0, 0.5), (0.0, 0.0, -0.8), 34.0, size // 2)
    soft = Lamp(3.0, place=(0.3, 0.4, 3.5), radius=0.4)
    return {
        "glass ball in fog": (ball(1.0), "glass", None, FOG, BULB, from_front, (0, 0, 0), 1.02),
        "glass ball in fog, soft lamp": (ball(1.0), "glass", None, FOG, soft, softly, (0, 0, 0), 1.02),
        "glass ball above a floor": (ball(1.0), "glass", -1.2, CLEAR, BULB, from_above, (0, 0, 0), 1.02),
        "glass ball, its focus on a floor": (ball(1.0), "glass", -2.0, CLEAR, BULB, from_above, (0, 0, 0), 1.02),
        "silver ring in fog": (band(), "silver", 0.0, thin, sun, over_ring, (0, 0, 0.35), 1.1),
        "opaque ball in fog": (ball(1.0), "clay", None, FOG, BULB, from_front, (0, 0, 0), 1.02),
    }


def bodies(body, made_of, floor, folder):
    """Mitsuba's shapes."""
    path = folder / "mitsuba.obj"
    write_obj(path, [body])
    made = {
        "glass": {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0},
        "silver": {"type": "conductor", "material": "none", "specular_reflectance": {"type": "rgb", "value": SILVER}},
        "clay": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.6}},
    }
    shapes = {"type": "scene", "body": {"type": "obj", "filename": str(path), "bsdf": made[made_of]}}
    if floor is not None:
        place = mi.ScalarTransform4f().translate([0, 0, floor]).scale(100)
        shapes["floor"] = {"type": "rectangle", "to_world": place, "bsdf": {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0.7}}}
    return shapes


def volpath(shapes, medium, lamp, camera, samples, seed):
    """The radiance by Mitsuba's own integrator; a path of two edges is scattered once, by the medium or by a surface."""
    transform = mi.ScalarTransform4f
    sigma = [a + s for a, s in zip(medium.absorption, medium.scattering)]
    fog = {
        "type": "homogeneous", "sigma_t": {"type": "rgb", "value": sigma}, "phase": {"type": "hg", "g": medium.g},
        "albedo": {"type": "rgb", "value": [s / t for s, t in zip(medium.scattering, sigma)]},
    }
    box = {"type": "cube", "to_world": transform().scale(medium.extent), "bsdf": {"type": "null"}, "interior": fog}
    scene = shapes | {
        "box": box,
        "integrator": {"type": "volpath", "max_depth": 2, "rr_depth": 64},
        "lamp": {"type": "point", "position": lamp.place, "intensity": {"type": "rgb", "value": lamp.strength}},
        "sensor": {
            "type": "perspective", "fov": camera.field, "fov_axis": "y",
            "to_world": transform().look_at(origin=camera.eye, target=camera.target, up=(0, 0, 1)),
            "film": {"type": "hdrfilm", "width": camera.size, "height": camera.size, "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": samples},
        },
    }
    scene["body"] = scene["body"] | {"exterior": fog}
    return np.array(mi.render(mi.load_dict(scene), seed=seed), dtype=np.float64)[:, :, :3]


def mitsuba(made_of, shapes, medium, lamp, camera, target, reach, passes, factor):
    """The outputs of each pass, and the pixels that show a clear body or a mirror."""
    scene = mi.load_dict(shapes)
    found, covered = [], np.zeros((camera.size, camera.size))
    for seed in range(passes):
        airlight, surfaces, caustics, specular = traced_views(scene, medium, lamp, camera, target, reach, int((1024 if lamp.radius else 64) * factor), 2 * seed)
        if not lamp.radius:
            caustics, lit = traced_light(scene, medium, lamp, camera, target, reach, int(factor * 2**21), 2 * seed + 1)
            surfaces = surfaces + lit
        parts = {"airlight − shadow": airlight, "surfaces": surfaces, "caustics": caustics, "color": airlight + surfaces + caustics}
        if made_of == "clay":
            parts["color by volpath"] = volpath(shapes, medium, lamp, camera, int(256 * factor), seed)
        found.append(parts)
        covered = np.maximum(covered, specular[:, :, 0])
    return {name: np.stack([parts[name] for parts in found]) for name in found[0]}, covered > 0


def vitrum(body, made_of, floor, medium, lamp, camera, folder, arguments):
    """The outputs by Vitrum."""
    write_obj(folder / "body.obj", [body])
    made = {"glass": "ior = 1.5", "silver": f"mirror = true\ncolor = {[SILVER] * 3}", "clay": "opaque = true\ncolor = [0.6, 0.6, 0.6]"}
    strength = lamp.strength / np.pi
    if lamp.place:
        light = f"kind = 'point'\nposition = {list(lamp.place)}\nradius = {lamp.radius}\n"
    else:
        light = f"attachment = 'world'\nangular_radius = 0\ndirection = {list(lamp.direction)}\n"
    text = f"""method = "beams"
[[mesh]]
file = "body.obj"
up = "z"
[[material]]
{made[made_of]}
[[light]]
{light}intensity = {strength}
[camera]
position = {list(camera.eye)}
target = {list(camera.target)}
field_of_view = {camera.field}
[environment]
kind = "color"
color = [0, 0, 0]
[shading]
ambient = [0, 0, 0]
specular = 0
[beams]
rays = {64 if lamp.radius else arguments.rays}
threshold = 0.0001
segments = 16
[shadow]
samples = {64 if lamp.radius else 1}
[film]
width = {camera.size}
height = {camera.size}
supersampling = {2 if lamp.radius else 4}
"""
    if any(medium.scattering):
        text += f"[medium]\nabsorption = {list(medium.absorption)}\nscattering = {list(medium.scattering)}\n"
        text += f"anisotropy = {medium.g}\nextent = {medium.extent}\n"
    if floor is not None:
        text += f"[ground]\nheight = {floor}\ncolor = [0.7, 0.7, 0.7]\n"
    (folder / "scene.toml").write_text(text)
    command = [str(Path(arguments.vitrum).resolve()), "render", str(folder / "scene.toml"), "-o", str(folder / "out.exr"), "-q"]
    subprocess.run(command, check=True)
    parts = {}
    for part in OpenEXR.File(str(folder / "out.exr"), separate_channels=True).parts:
        if "R" in part.channels:
            parts[part.header["name"]] = np.stack([part.channels[name].pixels.astype(np.float64) for name in "RGB"], axis=2)
    parts["airlight − shadow"] = parts["airlight"] - parts["shadow"]
    parts["color by volpath"] = parts["color"]
    return parts


def row(name, output, found, passes):
    """A row of the table, of the pixels given."""
    expected = passes.mean(axis=0)
    mean = expected.mean()
    if not mean > 0:
        return
    error = passes.mean(axis=(1, 2)).std(ddof=1) / np.sqrt(len(passes)) / mean
    half = 0.5 * (passes[0::2].mean(axis=0) - passes[1::2].mean(axis=0))
    rms, noise = np.sqrt(((found - expected) ** 2).mean()) / mean, np.sqrt((half**2).mean()) / mean
    print(f"| {name} | {output} | {mean:.3e} | {found.mean() / mean:.4f} ± {error:.4f} | {100 * rms:.2f} % | {100 * noise:.2f} % |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vitrum", default="target/release/vitrum")
    parser.add_argument("--size", type=int, default=64)
    parser.add_argument("--rays", type=int, default=256)
    parser.add_argument("--passes", type=int, default=8)
    parser.add_argument("--factor", type=float, default=1.0, help="samples of a pass over those by default")
    parser.add_argument("--only", default="", help="scenes whose names have this in them")
    parser.add_argument("--pictures", type=Path)
    arguments = parser.parse_args()
    print("| scene | output | mean radiance | Vitrum / Mitsuba | rms of the difference over the mean | noise of Mitsuba |\n|---|---|---|---|---|---|")
    for name, (body, made_of, floor, medium, lamp, camera, target, reach) in scenes(arguments.size).items():
        if arguments.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            begin = time.perf_counter()
            found = vitrum(body, made_of, floor, medium, lamp, camera, folder, arguments)
            middle = time.perf_counter()
            shapes = bodies(body, made_of, floor, folder)
            passes, covered = mitsuba(made_of, shapes, medium, lamp, camera, target, reach, arguments.passes, arguments.factor)
            end = time.perf_counter()
        # A medium that scatters nothing leaves its rows out.
        for output, pictures in passes.items():
            row(name, output, found[output][~covered], pictures[:, ~covered])
            if lamp.radius:
                row(name + ", through the ball", output, found[output][covered], pictures[:, covered])
            if arguments.pictures:
                keep(arguments.pictures, f"{name} {output}", found[output], pictures.mean(axis=0), covered)
        print(f"{name}: Vitrum {middle - begin:.1f} s, Mitsuba {end - middle:.1f} s", flush=True)


def keep(folder, name, found, expected, covered):
    """Writes the two pictures and their difference, ten times as bright, side by side."""
    folder.mkdir(parents=True, exist_ok=True)
    scale = 0.5 / max(np.quantile(expected, 0.98), 1e-9)
    pictures = scale * np.concatenate([found, expected, 0.05 / scale + 10 * (found - expected)], axis=1)
    mi.util.write_bitmap(str(folder / (name.replace(" ", "_").replace(",", "") + ".png")), pictures.astype(np.float32))
    np.savez(str(folder / (name.replace(" ", "_").replace(",", "") + ".npz")), found=found, expected=expected, covered=covered)


if __name__ == "__main__":
    main()
