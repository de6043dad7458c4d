"""Whole pictures beside Mitsuba 3: clear bodies in an environment, radiance against radiance, no exposure fitted.

Both programs get the same triangles with the same normals, the same equirectangular environment and the same camera. Usage:

    radiance.py --vitrum target/release/vitrum [--size 160] [--samples 256] [--pictures FOLDER]

It needs numpy, OpenEXR, pynrrd and mitsuba, and prints a table: for each scene and each way to render it the root mean square of the
difference of radiance over all pixels whose ray meets the body or its box, that over the mean radiance there, and the median difference.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

import mitsuba as mi
import nrrd
import numpy as np
import OpenEXR

mi.set_variant("scalar_rgb")

# The eye looks along +y from in front, from a little above; z is up.
EYE, TARGET, FIELD = (0.4, -5.0, 1.1), (0.0, 0.0, 0.0), 32.0
# Extinction of the absorbing body, per world unit.
ABSORPTION = (0.3, 0.9, 1.6)


def lathe(profile, around=192):
    """A closed surface of revolution about z through the points (r, z) of a closed or pole-to-pole profile, with smooth normals."""
    profile = np.asarray(profile)
    angles = np.linspace(0, 2 * np.pi, around, endpoint=False)
    slope = np.gradient(profile, axis=0)
    normals = np.stack([slope[:, 1], -slope[:, 0]], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)

    def turned(pairs):
        r, z = pairs[:, 0][:, None], pairs[:, 1][:, None]
        return np.stack([r * np.cos(angles), r * np.sin(angles), z + 0 * angles], axis=2).reshape(-1, 3)

    rows = np.arange(len(profile) - 1)[:, None] * around
    here = np.arange(around)
    beside = (here + 1) % around
    a, b, c, d = rows + here, rows + beside, rows + around + beside, rows + around + here
    faces = np.concatenate([np.stack([a, b, c], axis=2).reshape(-1, 3), np.stack([a, c, d], axis=2).reshape(-1, 3)])
    positions = turned(profile)
    corners = positions[faces]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return positions, turned(normals), faces[area > 1e-12]


def ball(radius):
    """A ball around the origin."""
    angles = np.linspace(-np.pi / 2, np.pi / 2, 193)
    positions, normals, faces = lathe(radius * np.stack([np.cos(angles), np.sin(angles)], axis=1))
    return positions, positions / radius, faces


def vase():
    """A thick vase: outside from the foot to the lip, and back along the inside."""
    t = np.linspace(0, 1, 120)
    outer = np.stack([0.55 + 0.3 * np.sin(2.2 * np.pi * t + 0.3), 2.0 * t - 1.0], axis=1)
    wall = 0.16
    inner = outer[::-1] - np.array([wall, 0.0])
    inner = inner[inner[:, 1] > -0.8]
    lip = np.array([[outer[-1, 0] - 0.5 * wall * (1 - np.cos(a)), 1.0 + 0.5 * wall * np.sin(a)] for a in np.linspace(0.1, np.pi - 0.1, 16)])
    bottom = np.stack([np.linspace(inner[-1, 0], 0, 24)[1:], np.full(23, inner[-1, 1])], axis=1)
    foot = np.stack([np.linspace(0, outer[0, 0], 24)[:-1], np.full(23, -1.0)], axis=1)
    return lathe(np.concatenate([foot, outer, lip, inner, bottom]))


def write_obj(path, bodies):
    """Bodies as one OBJ file, a material each, named m0, m1 and so on."""
    lines, base = [], 1
    for number, (positions, normals, faces) in enumerate(bodies):
        lines.append(f"usemtl m{number}")
        lines += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in positions]
        lines += [f"vn {x:.9g} {y:.9g} {z:.9g}" for x, y, z in normals]
        lines += ["f " + " ".join(f"{v}//{v}" for v in face + base) for face in faces]
        base += len(positions)
    path.write_text("\n".join(lines) + "\n")


def environment():
    """Radiance by elevation alone, so that no convention for the azimuth matters: a bright horizon, a blue zenith, a dark ground."""
    height = 256
    elevation = np.pi / 2 - (np.arange(height) + 0.5) / height * np.pi
    glow = np.exp(-((elevation / 0.35) ** 2))
    sky = np.stack([0.25 + 0.9 * glow, 0.35 + 0.8 * glow, 0.6 + 0.6 * glow], axis=1)
    ground = np.stack([0.30 + 0.9 * glow, 0.22 + 0.8 * glow, 0.15 + 0.6 * glow], axis=1)
    rows = np.where((elevation > 0)[:, None], sky, ground)
    return np.repeat(rows[:, None, :], 2 * height, axis=1).astype(np.float32)


def write_exr(path, pixels):
    """An EXR picture of linear RGB."""
    OpenEXR.File({}, {"RGB": OpenEXR.Channel("RGB", pixels)}).write(str(path))


def read_exr(path):
    """The linear RGB of an EXR picture."""
    channels = OpenEXR.File(str(path), separate_channels=True).channels()
    return np.stack([channels[name].pixels.astype(np.float64) for name in "RGB"], axis=2)


def mitsuba(bodies, folder, arguments):
    """The radiance by Mitsuba: bodies as (mesh, index inside, index outside, extinction or None)."""
    transform = mi.ScalarTransform4f
    scene = {
        "type": "scene",
        "integrator": {"type": "volpath", "max_depth": 64, "rr_depth": 64},
        "sensor": {
            "type": "perspective", "fov": FIELD, "fov_axis": "y",
            "to_world": transform().look_at(origin=EYE, target=TARGET, up=(0, 0, 1)),
            "film": {"type": "hdrfilm", "width": arguments.size, "height": arguments.size, "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": arguments.samples},
        },
        # Its up is y.
        "sky": {"type": "envmap", "filename": str(folder / "sky.exr"), "to_world": transform().rotate([1, 0, 0], 90)},
    }
    for number, (mesh, inside, outside, extinction) in enumerate(bodies):
        path = folder / f"body{number}.obj"
        write_obj(path, [mesh])
        body = {"type": "obj", "filename": str(path), "bsdf": {"type": "dielectric", "int_ior": inside, "ext_ior": outside}}
        if extinction:
            largest = max(extinction)
            share = {"type": "rgb", "value": [sigma / largest for sigma in extinction]}
            body["interior"] = {"type": "homogeneous", "albedo": 0.0, "sigma_t": share, "scale": largest}
        scene[f"body{number}"] = body
    return np.array(mi.render(mi.load_dict(scene)), dtype=np.float64)[:, :, :3]


def vitrum(source, settings, folder, arguments):
    """The radiance by Vitrum, with a ray or more a pixel."""
    output = folder / "out.exr"
    common = [
        f"camera.position={list(EYE)}", f"camera.target={list(TARGET)}", f"camera.field_of_view={FIELD}", "light=[]",
        "environment.kind=map", f"environment.file={folder / 'sky.exr'}", "shading.ambient=[0,0,0]", "shading.specular=0",
        "film.supersampling=4",
    ]
    command = [str(Path(arguments.vitrum).resolve()), "render", str(source), "-o", str(output), "--size", f"{arguments.size}x{arguments.size}", "--quality", "draft"]
    for setting in common + settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, capture_output=True, text=True)
    return read_exr(output)


def absorbing_volume(path):
    """A ball of radius 1 as a volume of 192 voxels an edge: its surface is a step that is four voxels wide."""
    edge, count = 2.4, 192
    at = (np.arange(count) + 0.5) / count * edge - edge / 2
    x, y, z = np.meshgrid(at, at, at, indexing="ij")
    t = np.clip((1 - np.sqrt(x * x + y * y + z * z)) / (4 * edge / count) + 0.5, 0, 1)
    header = {"space": "right-anterior-superior", "space directions": np.eye(3) * edge / count, "space origin": [at[0]] * 3}
    nrrd.write(str(path), (t * t * (3 - 2 * t)).astype(np.float32), header)


def compare(name, way, found, expected):
    """Prints a row of the table, of pixels that differ from the environment behind."""
    difference = found - expected
    rms = np.sqrt((difference**2).mean())
    print(f"| {name} | {way} | {rms:.4f} | {100 * rms / expected.mean():.1f} % | {np.median(np.abs(difference)):.4f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--vitrum", default="target/release/vitrum")
    parser.add_argument("--size", type=int, default=160)
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--pictures", type=Path)
    arguments = parser.parse_args()
    ways = {
        "triangles": ["method=voxels", "voxels.surfaces=exact"],
        "256 voxels": ["method=voxels", "voxelization.resolution=256"],
        "plane sweep, 256 voxels": ["method=sweep", "voxelization.resolution=256"],
    }
    print("| scene | by | rms of the difference | over the mean radiance | median difference |")
    print("|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_exr(folder / "sky.exr", environment())
        nested = [(ball(1.0), 1.5, 1.0, None), (ball(0.6), 1.33, 1.5, None)]
        for scene, bodies in {
            "ball, n = 1.5": [(ball(1.0), 1.5, 1.0, None)],
            "vase, n = 1.5": [(vase(), 1.5, 1.0, None)],
            "ball of 1.33 in a ball of 1.5": nested,
        }.items():
            expected = mitsuba(bodies, folder, arguments)
            mesh = folder / "mesh.obj"
            write_obj(mesh, [body[0] for body in bodies])
            materials = ",".join(f"{{name='m{n}',ior={body[1]}}}" for n, body in enumerate(bodies))
            for way, settings in ways.items():
                found = vitrum(mesh, ["mesh.0.up=z", *settings, f"material=[{materials}]"], folder, arguments)
                compare(scene, way, found, expected)
                keep(arguments, f"{scene} {way}", found, expected)
        expected = mitsuba([(ball(1.0), 1.3, 1.0, ABSORPTION)], folder, arguments)
        volume = folder / "ball.nrrd"
        absorbing_volume(volume)
        left = [float(np.exp(-sigma)) for sigma in ABSORPTION]
        settings = [
            "transfer.reference_length=1", "transfer.opacity=[{value=0,opacity=0}]",
            "transfer.ior=[{value=0,ior=1},{value=1,ior=1.3}]",
            f"transfer.filter=[{{value=0,color=[1,1,1]}},{{value=1,color={left}}}]",
        ]
        # A file of its own, since a scan alone gets a ground.
        source = folder / "absorbing.toml"
        source.write_text('[volume]\nfile = "ball.nrrd"\n')
        found = vitrum(source, settings, folder, arguments)
        compare("absorbing ball, n = 1.3, a volume", "plane sweep, 192 voxels", found, expected)
        keep(arguments, "absorbing", found, expected)


def keep(arguments, name, found, expected):
    """Writes the two pictures and their difference side by side."""
    if arguments.pictures:
        arguments.pictures.mkdir(parents=True, exist_ok=True)
        row = np.concatenate([found, expected, np.abs(found - expected)], axis=1).astype(np.float32)
        mi.util.write_bitmap(str(arguments.pictures / (name.replace(" ", "_").replace(",", "") + ".png")), row)


if __name__ == "__main__":
    main()
