#!/usr/bin/env python3
"""Compares what `vitrum info --json` says of meshes with what trimesh says.

    python3 -m venv target/peers
    target/peers/bin/pip install -r tests/peers/requirements.txt
    cargo build --release
    target/peers/bin/python tests/peers/meshes.py --vitrum target/release/vitrum ../shared/data/meshes

Reads files that trimesh writes, and those that are given. Prints a table in Markdown, and exits 1 where the two differ by
more than the bounds below. `cargo xtask peers` does all of this.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
import trimesh

# Vitrum keeps positions in float32, trimesh in float64: text with more digits than float32 has, and nodes that move
# vertices, are rounded once more. Half a unit in the last place of the largest coordinate, and a little for sums.
BOUNDS = 1e-6
# Relative. Areas and volumes of meshes of millimetres about a metre from the origin lose most.
MEASURES = 1e-5

# Nodes of glTF move vertices, and where float32 ends, the order of the products decides which of them stay apart: so
# many of a count, and 2 at least. Other formats have to be equal.
MOVED = 1e-4

SUFFIXES = {".obj", ".ply", ".stl", ".gltf", ".glb"}


def ours(vitrum, path):
    run = subprocess.run([vitrum, "info", "--json", path], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        raise SystemExit(f"{path}: vitrum exits {run.returncode}: {run.stderr}")
    return json.loads(run.stdout)


def theirs(path):
    """As trimesh reads it, and with the vertices at equal positions merged, which is what edges are counted on."""
    # With `process` it would merge vertices by itself, and without `maintain_order` renumber those of OBJ files.
    loaded = trimesh.load(path, process=False, maintain_order=True)
    mesh = loaded.to_geometry() if isinstance(loaded, trimesh.Scene) else loaded
    triangles = len(mesh.faces)
    positions = numpy.asarray(mesh.vertices, dtype=numpy.float32) + numpy.float32(0)
    distinct, number = numpy.unique(positions, axis=0, return_inverse=True)
    faces = number.reshape(-1)[mesh.faces]
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    merged = trimesh.Trimesh(distinct.astype(numpy.float64), faces[whole], process=False)
    uses = numpy.bincount(merged.edges_unique_inverse)
    used = mesh.vertices[numpy.unique(mesh.faces)]
    return {
        "triangles": triangles,
        "points": len(distinct),
        "edges": len(uses),
        "boundary_edges": int((uses == 1).sum()),
        "non_manifold_edges": int((uses > 2).sum()),
        "closed": bool(merged.is_watertight and merged.is_winding_consistent),
        "bounds": [used.min(axis=0).tolist(), used.max(axis=0).tolist()],
        "area": float(mesh.area),
        "volume": float(mesh.volume),
    }


COUNTS = ("points", "edges", "boundary_edges", "non_manifold_edges")


def compare(ours, theirs):
    """The names of what differs by more than it may."""
    wrong = [name for name in ("triangles", "closed") if ours[name] != theirs[name]]
    for name in COUNTS:
        allowed = max(2, MOVED * theirs[name]) if ours["format"] == "glTF" else 0
        if abs(ours[name] - theirs[name]) > allowed:
            wrong.append(name)
    scale = numpy.abs(theirs["bounds"]).max()
    if numpy.abs(numpy.subtract(ours["bounds"], theirs["bounds"])).max() > BOUNDS * scale:
        wrong.append("bounds")
    if difference(ours["area"], theirs["area"]) > MEASURES:
        wrong.append("area")
    # Of a mesh that is not balanced, trimesh has a number and Vitrum none.
    if ours["volume"] is not None and difference(ours["volume"], theirs["volume"]) > MEASURES:
        wrong.append("volume")
    return wrong


def difference(ours, theirs):
    return abs(ours - theirs) / abs(theirs) if theirs else abs(ours)


def verdict(ours, theirs, wrong):
    if wrong:
        return "differs: " + ", ".join(wrong)
    apart = [f"{name.replace('_', ' ')} {theirs[name]}" for name in COUNTS if ours[name] != theirs[name]]
    return "within bounds; trimesh: " + ", ".join(apart) if apart else "equal"


def row(path, ours, theirs, wrong):
    volume = "none" if ours["volume"] is None else f"{ours['volume']:.7g}"
    apart = "" if ours["volume"] is None else f"{difference(ours['volume'], theirs['volume']):.0e}"
    cells = [
        path.name,
        ours["triangles"],
        ours["points"],
        ours["boundary_edges"],
        ours["non_manifold_edges"],
        "yes" if ours["closed"] else "no",
        f"{ours['area']:.7g}",
        f"{difference(ours['area'], theirs['area']):.0e}",
        volume,
        apart,
        verdict(ours, theirs, wrong),
    ]
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--vitrum", default="vitrum", help="the program")
    arguments.add_argument("paths", nargs="*", type=pathlib.Path, help="mesh files, or folders of them")
    arguments = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        return compare_all(arguments, made(pathlib.Path(folder)))


def made(folder):
    """Shapes that are closed, open and apart, in every format that trimesh writes."""
    ball = trimesh.creation.icosphere(subdivisions=3, radius=2.5)
    tube = trimesh.creation.cylinder(1.0, 4.0, sections=24)
    tube.update_faces(numpy.abs(tube.face_normals[:, 2]) < 0.5)
    torus = trimesh.creation.torus(3.0, 0.5)
    apart = trimesh.util.concatenate([ball, torus.copy().apply_translation([9.0, -4.0, 1.5])])
    files = []
    for name, shape in {"ball": ball, "tube": tube, "apart": apart}.items():
        for suffix, options in [("obj", {}), ("ply", {"encoding": "ascii"}), ("ply", {}), ("stl", {}), ("glb", {})]:
            path = folder / f"{name}-{len(files)}.{suffix}"
            shape.export(path, **options)
            files.append(path)
    return files


def compare_all(arguments, files):
    for path in arguments.paths:
        files += sorted(path.iterdir()) if path.is_dir() else [path]
    files = [path for path in files if path.suffix.lower() in SUFFIXES]
    heads = ["file", "triangles", "positions", "boundary edges", "non-manifold edges", "closed", "area", "apart"]
    heads += ["volume", "apart", "counts and bounds"]
    print("| " + " | ".join(heads) + " |")
    print("|" + "---|" * len(heads))
    failed = False
    for path in files:
        found, expected = ours(arguments.vitrum, path), theirs(path)
        wrong = compare(found, expected)
        failed |= bool(wrong)
        print(row(path, found, expected, wrong))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
