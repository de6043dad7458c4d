"""What independent readers find in a file."""

import gzip
from dataclasses import dataclass

import nibabel
import nrrd
import numpy
import pydicom
import SimpleITK
import tifffile
from pydicom.pixels import apply_rescale
from vtk.util.numpy_support import vtk_to_numpy

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
    letters = [word[0] for word in header.get("space", "right-anterior-superior").split("-")]
    flip = numpy.diag([-1.0 if letter in "lpi" else 1.0 for letter in letters] + [1.0])
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
    values = numpy.stack([apply_rescale(file.pixel_array, file).T for file in slices], axis=2)
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
    data = (gzip.open if path.suffix == ".gz" else open)(path, "rb").read()
    return Peer("numpy", numpy.frombuffer(data, kind).reshape(dimensions, order="F"))
