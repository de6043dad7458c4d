"""Vitrum's volume readers against independent ones: voxel for voxel, spacing and place in the world.

    python -m venv peers && peers/bin/pip install -r tests/peers/requirements.txt
    cargo build --release
    peers/bin/python tests/peers/volumes.py target/release/vitrum ../shared/data/volumes [docs/peers.md]

Prints a table, and with a third argument writes it into that page below the heading `## Volumes`. Exits 1 where anything
differs.
"""

import json
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path

import nibabel
import nrrd
import numpy
import pydicom
import SimpleITK
import tifffile
import vtk
import zstandard
from imagecodecs import ljpeg_encode
from pydicom.encaps import encapsulate
from pydicom.uid import JPEGLosslessSV1, RLELossless
from vtk.util.numpy_support import vtk_to_numpy

HEADING = "## Volumes"

# From the patient's left, posterior, superior to the right, anterior, superior.
TO_RAS = numpy.diag([-1.0, -1.0, 1.0, 1.0])


@dataclass
class Peer:
    """What an independent reader found: values by [x, y, z], the spacing, and the world of an index, where stated."""

    package: str
    values: numpy.ndarray
    spacing: list | None = None
    affine: numpy.ndarray | None = None
    # Whether the file says where the grid begins; where not, Vitrum centres it.
    placed: bool = True


def of_nibabel(path):
    image = nibabel.load(path)
    return Peer("nibabel", numpy.asarray(image.dataobj), image.header.get_zooms()[:3], image.affine)


def of_nrrd(path):
    values, header = nrrd.read(str(path))
    if "space directions" not in header:
        return Peer("pynrrd", values, header.get("spacings"))
    affine = numpy.eye(4)
    affine[:3, :3] = header["space directions"].T
    affine[:3, 3] = header["space origin"]
    flip = TO_RAS if header.get("space") == "left-posterior-superior" else numpy.eye(4)
    spacing = numpy.linalg.norm(header["space directions"], axis=1)
    return Peer("pynrrd", values, spacing, flip @ affine)


def of_itk_image(image):
    affine = numpy.eye(4)
    direction = numpy.array(image.GetDirection()).reshape(3, 3)
    affine[:3, :3] = direction * numpy.array(image.GetSpacing())
    affine[:3, 3] = image.GetOrigin()
    values = SimpleITK.GetArrayFromImage(image).transpose(2, 1, 0)
    return Peer("simpleitk", values, image.GetSpacing(), TO_RAS @ affine)


def of_itk(path):
    return of_itk_image(SimpleITK.ReadImage(str(path)))


def of_dicom(folder):
    reader = SimpleITK.ImageSeriesReader()
    reader.SetFileNames(reader.GetGDCMSeriesFileNames(str(folder)))
    peer = of_itk_image(reader.Execute())
    # The values once more, without ITK.
    slices = sorted((pydicom.dcmread(file) for file in folder.iterdir()), key=lambda file: file.ImagePositionPatient[2])
    values = numpy.stack([file.pixel_array.T for file in slices], axis=2)
    assert numpy.array_equal(values, peer.values), "pydicom and SimpleITK differ"
    peer.package = "simpleitk, pydicom"
    return peer


def of_vtk(path, reader):
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    array = image.GetPointData().GetScalars() or image.GetPointData().GetArray(0)
    values = vtk_to_numpy(array).reshape(image.GetDimensions(), order="F")
    affine = numpy.eye(4)
    matrix = image.GetIndexToPhysicalMatrix()
    for row in range(4):
        for column in range(4):
            affine[row, column] = matrix.GetElement(row, column)
    return Peer("vtk", values, image.GetSpacing(), affine)


def of_tiff(path):
    with tifffile.TiffFile(path) as file:
        notes = file.imagej_metadata or {}
        resolution = file.pages[0].tags["XResolution"].value
        values = file.asarray()
    values = values.reshape(-1, *values.shape[-2:]).transpose(2, 1, 0)
    pixel = resolution[1] / resolution[0] if notes else None
    return Peer("tifffile", values, [pixel, pixel, notes.get("spacing", 1.0)] if pixel else None)


def of_raw(path, dimensions, kind):
    import gzip

    data = (gzip.open if path.suffix == ".gz" else open)(path, "rb").read()
    return Peer("numpy", numpy.frombuffer(data, kind).reshape(dimensions, order="F"))


def of_legacy(path, volumes):
    """A legacy file of the head, written by VTK itself."""
    reader = vtk.vtkXMLImageDataReader()
    reader.SetFileName(str(volumes / "headsq.vti"))
    writer = vtk.vtkDataSetWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileTypeToBinary()
    writer.SetFileName(str(path))
    writer.Write()
    return of_vtk(path, vtk.vtkDataSetReader())


def without_space(path, scratch):
    """A copy of a NRRD header and its slices, without the space."""
    folder = scratch / "slices"
    folder.mkdir()
    for file in path.parent.iterdir():
        (folder / file.name).write_bytes(file.read_bytes())
    header = folder / path.name
    lines = path.read_text().splitlines(keepends=True)
    header.write_text("".join(line for line in lines if not line.startswith("space:")))
    return header


def compressed(folder, target, change):
    """A DICOM folder with its pixels compressed."""
    target.mkdir()
    for file in sorted(folder.iterdir()):
        data = pydicom.dcmread(file)
        change(data)
        data.save_as(target / file.name)
    return target


def lossless_jpeg(data):
    data.PixelData = encapsulate([ljpeg_encode(data.pixel_array.astype(numpy.uint16))])
    data["PixelData"].is_undefined_length = True
    data.file_meta.TransferSyntaxUID = JPEGLosslessSV1


def cases(volumes, scratch):
    """Name, path for Vitrum, its flags, and the independent reading."""
    dicom = volumes / "dicom_brain"
    for name in ["iguana_head_ct", "engine", "bonsai", "heptane"]:
        path = volumes / f"{name}.nii.gz"
        yield path.name, path, [], lambda path=path: of_nibabel(path)
    for name in ["stent.nrrd", "fuel.nhdr", "neghip.nhdr", "silicium.nhdr"]:
        path = volumes / name
        yield name, path, [], lambda path=path: of_nrrd(path)
    # pynrrd does not find its slices, VTK turns their rows round, and ITK refuses a space without directions.
    path = volumes / "headsq_nrrd/quarter.nhdr"
    yield path.name, path, [], lambda path=path: of_itk(without_space(path, scratch))
    path = volumes / "HeadMRVolume.mhd"
    yield path.name, path, [], lambda path=path: replace(of_itk(path), placed=False)
    for name in ["headsq.vti", "hydrogen.vti", "aneurism.vti"]:
        path = volumes / name
        yield name, path, [], lambda path=path: of_vtk(path, vtk.vtkXMLImageDataReader())
    legacy = scratch / "headsq.vtk"
    peer = of_legacy(legacy, volumes)
    yield "headsq.vtk, written by VTK", legacy, [], lambda: peer
    path = volumes / "tiff_banana/banana_stack_deflate.tif"
    yield path.name, path, [], lambda path=path: of_tiff(path)
    path = volumes / "bucky_32x32x32_uint8.raw"
    yield path.name, path, [], lambda path=path: of_raw(path, (32, 32, 32), "u1")
    path = volumes / "mrhead_256x256x109_uint8.raw.gz"
    yield path.name, path, ["--raw", "256x256x109:u8"], lambda path=path: of_raw(path, (256, 256, 109), "u1")
    yield "dicom_brain", dicom, [], lambda: of_dicom(dicom)
    for name, change in [("RLE", lambda data: data.compress(RLELossless)), ("lossless JPEG", lossless_jpeg)]:
        folder = compressed(dicom, scratch / name, change)
        yield f"dicom_brain as {name}", folder, [], lambda: of_dicom(dicom)
    packed = scratch / "stent.nrrd.zst"
    packed.write_bytes(zstandard.compress((volumes / "stent.nrrd").read_bytes()))
    yield "stent.nrrd in zstd", packed, [], lambda: of_nrrd(volumes / "stent.nrrd")
    four = scratch / "four.nii.gz"
    values = numpy.random.default_rng(1).integers(-9999, 9999, (9, 8, 7, 5), dtype=numpy.int16)
    affine = numpy.array([[0, -2.0, 0, 3], [1.5, 0, 0, 4], [0, 0, 2.5, -5], [0, 0, 0, 1]])
    nibabel.save(nibabel.Nifti1Image(values, affine), four)
    yield "a random 4D NIfTI at time 3", four, ["--time", "3"], lambda: Peer(
        "nibabel", nibabel.load(four).dataobj[..., 3], None, nibabel.load(four).affine
    )


def corners(affine, dimensions):
    ends = numpy.array(numpy.meshgrid(*[[0, size - 1] for size in dimensions])).reshape(3, -1)
    return (affine @ numpy.vstack([ends, numpy.ones(8)]))[:3]


def compare(program, path, flags, peer, scratch):
    """Differing voxels, the largest difference of spacings in percent, and that of corners in voxels."""
    out = scratch / "out.npy"
    subprocess.run([program, "convert", path, "-o", out, *flags], check=True)
    info = json.loads(subprocess.run([program, "info", path, "--json", *flags], check=True, capture_output=True).stdout)
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
    program, volumes, *page = sys.argv[1:]
    scratch = Path(tempfile.mkdtemp())
    rows, all_good = [], True
    try:
        for name, path, flags, read in cases(Path(volumes), scratch):
            peer = read()
            packages = ", ".join(f"{package} {version(package)}" for package in peer.package.split(", "))
            *found, good = compare(program, path, flags, peer, scratch)
            all_good &= good
            size = " × ".join(map(str, peer.values.shape))
            rows.append(f"| {name} | {size} | {packages} | {' | '.join(found)} | {'yes' if good else '**no**'} |")
            print(rows[-1], flush=True)
    finally:
        shutil.rmtree(scratch)
    head = "| file | voxels | read by | differing voxels | spacing off by | corners off by | agrees |"
    table = "\n".join([head, "|---|---|---|---|---|---|---|", *rows])
    if page:
        write(Path(page[0]), table)
    return 0 if all_good else 1


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
