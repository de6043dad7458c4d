"""The shared volumes, and files made of them."""

from dataclasses import replace

import pydicom
import vtk
import zstandard
from made import COMPRESSIONS
from reading import of_dicom, of_itk, of_nibabel, of_nrrd, of_raw, of_tiff, of_vtk


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
    folder = scratch / "slices of the head"
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
    yield path.name, path, [], lambda path=path: replace(of_itk(without_space(path, scratch)), affine=None)
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
    for name, change in COMPRESSIONS.items():
        folder = compressed(dicom, scratch / f"brain as {name}", change)
        yield f"dicom_brain as {name}", folder, [], lambda: of_dicom(dicom)
    packed = scratch / "stent.nrrd.zst"
    packed.write_bytes(zstandard.compress((volumes / "stent.nrrd").read_bytes()))
    yield "stent.nrrd in zstd", packed, [], lambda: of_nrrd(volumes / "stent.nrrd")
