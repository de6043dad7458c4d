#!/usr/bin/env python3
"""Vitrum's volume readers against independent ones: voxel for voxel, spacing and place in the world.

    python3 -m venv target/peers
    target/peers/bin/pip install -r tests/peers/requirements.txt
    cargo build --release
    target/peers/bin/python tests/peers/volumes.py --vitrum target/release/vitrum ../shared/data/volumes

Reads files that independent writers make, and the shared volumes where their folder is given. Prints a table in Markdown;
`--page docs/peers.md` also writes it below the heading `## Volumes`. Exits 1 where anything differs. `cargo xtask peers`
does all of this.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
from importlib.metadata import version

import made
import numpy

HEADING = "## Volumes"


def corners(affine, dimensions):
    ends = numpy.array(numpy.meshgrid(*[[0, size - 1] for size in dimensions])).reshape(3, -1)
    return (affine @ numpy.vstack([ends, numpy.ones(8)]))[:3]


def compare(program, path, flags, peer, scratch):
    """Differing voxels, the largest difference of spacings in percent, and that of corners in voxels."""
    out = scratch / "out.npy"
    runs = [[program, "convert", path, "-o", out, *flags], [program, "info", path, "--json", *flags]]
    for run in runs:
        done = subprocess.run(run, check=False, capture_output=True, text=True)
        if done.returncode != 0:
            return f"exits {done.returncode}: {' '.join(done.stderr.split())}", "", "", False
    info = json.loads(done.stdout)
    ours = numpy.load(out).transpose(2, 1, 0)
    if ours.shape != peer.values.shape:
        return f"{ours.shape} is not {peer.values.shape}", "", "", False
    differing = int((ours != peer.values.astype(ours.dtype)).sum())
    good = differing == 0
    spacing = corner = "—"
    if peer.spacing is not None:
        off = float(numpy.abs(numpy.array(info["spacing"]) / numpy.array(peer.spacing, float) - 1).max())
        spacing, good = f"{100 * off:.1g} %" if off else "0", good and off < 1e-4
    stated = not any("no orientation" in note for note in info["assumptions"])
    if peer.affine is not None and stated:
        affine = numpy.eye(4)
        affine[:3, :3] = (numpy.array(info["axes"]) * numpy.array(info["spacing"])[:, None]).T
        affine[:3, 3] = info["origin"]
        off = corners(affine, ours.shape) - corners(peer.affine, ours.shape)
        if not peer.placed:
            off -= off.mean(axis=1, keepdims=True)
        off = float(numpy.linalg.norm(off, axis=0).max() / min(info["spacing"]))
        # ITK takes the normal of DICOM's slices for their axis, we their positions, which are rounded to 0.1 mm here.
        most = 0.1 if "pydicom" in peer.package else 1e-3
        corner, good = f"{off:.1g} voxels" if off else "0", good and off < most
    return str(differing), spacing, corner, good


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--vitrum", default="vitrum", help="the program")
    arguments.add_argument("--page", type=pathlib.Path, help="a page to write the table to")
    arguments.add_argument("volumes", nargs="?", type=pathlib.Path, help="the folder of the shared volumes")
    arguments = arguments.parse_args()
    rows, all_good = [], True
    with tempfile.TemporaryDirectory() as folder:
        for name, path, flags, read in cases(arguments.volumes, pathlib.Path(folder)):
            peer = read()
            packages = ", ".join(f"{package} {version(package)}" for package in peer.package.split(", "))
            *found, good = compare(arguments.vitrum, path, flags, peer, pathlib.Path(folder))
            all_good &= good
            size = " × ".join(map(str, peer.values.shape))
            rows.append(f"| {name} | {size} | {packages} | {' | '.join(found)} | {'yes' if good else '**no**'} |")
            print(rows[-1], flush=True)
    head = "| file | voxels | read by | differing voxels | spacing off by | corners off by | agrees |"
    table = "\n".join([head, "|---|---|---|---|---|---|---|", *rows])
    if arguments.page:
        write(arguments.page, table)
    return 0 if all_good else 1


def cases(volumes, scratch):
    yield from made.cases(scratch)
    if volumes:
        import shared

        yield from shared.cases(volumes, scratch)


def write(page, table):
    """Puts the table in place of the one below the heading."""
    text = page.read_text()
    before, rest = text.split(HEADING + "\n", 1)
    section, *others = rest.split("\n## ", 1)
    intro = section.split("\n| ", 1)[0].rstrip()
    after = f"\n\n## {others[0]}" if others else "\n"
    page.write_text(f"{before}{HEADING}\n{intro}\n\n{table}{after}")


if __name__ == "__main__":
    sys.exit(main())
