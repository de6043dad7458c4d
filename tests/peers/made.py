"""Volumes of random numbers, written by independent writers."""

from dataclasses import replace

import nibabel
import nrrd
import numpy
import pydicom
import SimpleITK
import tifffile
import vtk
from imagecodecs import jpeg2k_encode, jpegls_encode, ljpeg_encode
from pydicom.encaps import encapsulate
from pydicom.uid import (
    CTImageStorage,
    ExplicitVRLittleEndian,
    ImplicitVRLittleEndian,
    JPEG2000Lossless,
    JPEGLosslessSV1,
    JPEGLSLossless,
    RLELossless,
    generate_uid,
)
from reading import Peer, of_dicom, of_itk, of_nibabel, of_nrrd, of_tiff, of_vtk
from vtk.util.numpy_support import numpy_to_vtk

# No two axes alike, so that a swap shows.
DIMENSIONS = (9, 8, 7)
SPACING = (0.5, 1.5, 2.5)
ORIGIN = (-3.0, 4.0, 50.0)

# A turn about an axis that is none of the grid's; columns are the directions of x, y and z.
DIRECTIONS = numpy.array([[2, -1, 2], [2, 2, -1], [-1, 2, 2]]) / 3


def values(kind, shape=DIMENSIONS):
    """Numbers of the whole range of a type by [x, y, z], the same ones each time."""
    random = numpy.random.default_rng(1)
    kind = numpy.dtype(kind)
    if kind.kind == "f":
        return random.normal(0, 100, shape).astype(kind)
    low, high = (0, 1) if kind.kind == "b" else (numpy.iinfo(kind).min, numpy.iinfo(kind).max)
    return random.integers(low, high, shape, kind.newbyteorder("="), endpoint=True).astype(kind)


def affine():
    placed = numpy.eye(4)
    placed[:3, :3] = DIRECTIONS * SPACING
    placed[:3, 3] = ORIGIN
    return placed


def nifti_files(scratch):
    for kind in [numpy.uint8, numpy.int16, numpy.float32, numpy.float64]:
        path = scratch / f"{kind.__name__}.nii.gz"
        nibabel.save(nibabel.Nifti1Image(values(kind), affine()), path)
        yield path.name, path, [], of_nibabel(path)
    pair = scratch / "pair.img"
    nibabel.save(nibabel.Nifti1Pair(values(numpy.int16), affine()), pair)
    yield "NIfTI pair", pair.with_suffix(".hdr"), [], of_nibabel(pair)
    second = scratch / "second.nii"
    nibabel.save(nibabel.Nifti2Image(values(numpy.uint16), affine()), second)
    yield "NIfTI-2", second, [], of_nibabel(second)
    four = scratch / "four.nii.gz"
    numbers = values(numpy.int16, (9, 8, 7, 5))
    nibabel.save(nibabel.Nifti1Image(numbers, affine()), four)
    yield "NIfTI at time 3", four, ["--time", "3"], Peer("nibabel", numbers[..., 3], None, affine())


def nrrd_files(scratch):
    header = {"space directions": (DIRECTIONS * SPACING).T, "space origin": ORIGIN}
    spaces = ["left-posterior-superior", "right-anterior-superior", "left-anterior-superior"]
    for encoding, space in zip(["raw", "gzip", "ascii"], spaces, strict=True):
        path = scratch / f"{encoding}.nrrd"
        nrrd.write(str(path), values(numpy.int16), {**header, "space": space, "encoding": encoding})
        yield f"NRRD, {encoding}, {space}", path, [], of_nrrd(path)
    path = scratch / "detached.nhdr"
    nrrd.write(str(path), values(numpy.float32), {"spacings": SPACING}, detached_header=True)
    yield "NRRD, detached", path, [], of_nrrd(path)


def itk_files(scratch):
    for name, compressed in [("itk.mha", True), ("itk.mhd", False), ("packed.mhd", True), ("itk.nrrd", True)]:
        path = scratch / name
        image = SimpleITK.GetImageFromArray(values(numpy.int16).transpose(2, 1, 0))
        image.SetSpacing(SPACING)
        image.SetOrigin(ORIGIN)
        image.SetDirection(DIRECTIONS.flatten())
        SimpleITK.WriteImage(image, str(path), useCompression=compressed)
        yield f"{name}, written by ITK", path, [], of_itk(path)


def vtk_files(scratch):
    image = vtk.vtkImageData()
    image.SetDimensions(DIMENSIONS)
    image.SetSpacing(SPACING)
    image.SetOrigin(ORIGIN)
    image.SetDirectionMatrix(DIRECTIONS.flatten())
    array = numpy_to_vtk(values(numpy.float32).flatten(order="F"), deep=True)
    array.SetName("density")
    image.GetPointData().SetScalars(array)
    modes = {"Ascii": [None], "Binary": [None, "ZLib"], "Appended": [None, "ZLib"]}
    for mode, packings in modes.items():
        for packing in packings:
            path = scratch / f"{mode}{packing}.vti"
            writer = vtk.vtkXMLImageDataWriter()
            writer.SetInputData(image)
            writer.SetFileName(str(path))
            getattr(writer, f"SetDataModeTo{mode}")()
            if packing:
                writer.SetCompressorTypeToZLib()
            else:
                writer.SetCompressorTypeToNone()
            writer.Write()
            name = f"VTI, {mode.lower()}{', zlib' if packing else ''}"
            yield name, path, [], of_vtk(path, vtk.vtkXMLImageDataReader())
    # The legacy format has no directions.
    image.SetDirectionMatrix(numpy.eye(3).flatten())
    for mode in ["ASCII", "Binary"]:
        path = scratch / f"{mode}.vtk"
        writer = vtk.vtkDataSetWriter()
        writer.SetInputData(image)
        writer.SetFileName(str(path))
        getattr(writer, f"SetFileTypeTo{mode}")()
        writer.Write()
        yield f"legacy VTK, {mode.lower()}", path, [], of_vtk(path, vtk.vtkDataSetReader())


def numpy_files(scratch):
    kinds = ["|u1", "|b1", ">i2", "<u4", "<i8", "<f2", ">f2", "<f4", "<f8"]
    for kind in kinds:
        path = scratch / "array.npy"
        numbers = values(numpy.float32).astype(kind)
        numpy.save(path, numpy.asfortranarray(numbers))
        order = ", big-endian" if kind[0] == ">" else ""
        yield f"NumPy, {numbers.dtype.name}{order}", path, [], Peer("numpy", numbers)
    first, second = values(numpy.uint8), values(numpy.float16)
    for save in [numpy.savez, numpy.savez_compressed]:
        path = scratch / f"{save.__name__}.npz"
        arrays = {"density": first, "heat": second}
        save(path, **{name: numpy.ascontiguousarray(array.transpose(2, 1, 0)) for name, array in arrays.items()})
        yield f"NumPy, {save.__name__}, the first array", path, [], Peer("numpy", first)
        yield f"NumPy, {save.__name__}, --array", path, ["--array", "heat"], Peer("numpy", second)


def tiff_files(scratch):
    numbers = values(numpy.uint16)
    pages = numbers.transpose(2, 1, 0)
    writings = {
        "uncompressed": {},
        "big-endian": {"byteorder": ">"},
        "BigTIFF": {"bigtiff": True},
        "deflate": {"compression": "zlib", "predictor": True},
        "LZW": {"compression": "lzw"},
        "tiles": {"tile": (16, 16)},
    }
    for name, options in writings.items():
        path = scratch / "pages.tif"
        tifffile.imwrite(path, pages, photometric="minisblack", **options)
        yield f"TIFF, {name}", path, [], Peer("tifffile", numbers)
    path = scratch / "imagej.tif"
    metadata = {"axes": "ZYX", "spacing": 2.5, "unit": "mm"}
    tifffile.imwrite(path, pages, imagej=True, resolution=(2, 0.5), metadata=metadata)
    peer = replace(of_tiff(path), spacing=[0.5, 2.0, 2.5])
    yield "TIFF, ImageJ", path, [], peer
    folder = scratch / "slices"
    folder.mkdir()
    for index, page in enumerate(pages):
        # 8, 9, 10, …: sorted as text, the last would come first.
        tifffile.imwrite(folder / f"slice{8 + index}.tif", page)
    yield "a folder of TIFF files", folder, [], Peer("tifffile", numbers)
    path = scratch / "hyperstack.tif"
    hyper = values(numpy.uint16, (3, 7, 2, 8, 9))
    tifffile.imwrite(path, hyper, imagej=True, metadata={"axes": "TZCYX"})
    yield "TIFF, ImageJ hyperstack, time 1, channel 2", path, ["--time", "1", "--array", "2"], Peer(
        "tifffile", hyper[1, :, 1].transpose(2, 1, 0)
    )


def dicom_slice(index, pixels, syntax, series):
    """A slice of an oblique CT series."""
    data = pydicom.Dataset()
    data.file_meta = pydicom.dataset.FileMetaDataset()
    data.file_meta.TransferSyntaxUID = syntax
    data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID = CTImageStorage
    data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID = generate_uid()
    data.Modality, data.SeriesInstanceUID, data.StudyInstanceUID = "CT", series, series
    data.InstanceNumber = index + 1
    data.ImagePositionPatient = list(map(str, numpy.round(ORIGIN + index * SPACING[2] * DIRECTIONS[:, 2], 6)))
    data.ImageOrientationPatient = list(map(str, numpy.round(DIRECTIONS[:, :2].T.flatten(), 8)))
    data.PixelSpacing, data.SliceThickness = [SPACING[1], SPACING[0]], SPACING[2]
    data.Rows, data.Columns = pixels.shape
    data.SamplesPerPixel, data.PhotometricInterpretation = 1, "MONOCHROME2"
    data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 16, 16, 15, 0
    data.RescaleSlope, data.RescaleIntercept = 1, -1024
    data.PixelData = pixels.tobytes()
    return data


def encapsulated(data, syntax, encode):
    """Puts a compressed picture in place of the pixels."""
    data.PixelData = encapsulate([encode(data.pixel_array.astype(numpy.uint16))])
    data["PixelData"].is_undefined_length = True
    data.file_meta.TransferSyntaxUID = syntax


COMPRESSIONS = {
    "RLE": lambda data: data.compress(RLELossless),
    "lossless JPEG": lambda data: encapsulated(data, JPEGLosslessSV1, ljpeg_encode),
    "lossless JPEG 2000": lambda data: encapsulated(data, JPEG2000Lossless, jpeg2000),
    "lossless JPEG-LS": lambda data: encapsulated(data, JPEGLSLossless, jpegls_encode),
}


def jpeg2000(pixels):
    return jpeg2k_encode(pixels, reversible=True, codecformat="j2k")


def dicom_files(scratch):
    pixels = values(numpy.uint16)
    writings = {"implicit": (ImplicitVRLittleEndian, None), "explicit": (ExplicitVRLittleEndian, None)}
    peer = None
    writings |= {name: (ExplicitVRLittleEndian, change) for name, change in COMPRESSIONS.items()}
    for name, (syntax, change) in writings.items():
        folder = scratch / name
        folder.mkdir()
        series = generate_uid()
        for index in range(DIMENSIONS[2]):
            data = dicom_slice(index, numpy.ascontiguousarray(pixels[:, :, index].T), syntax, series)
            if change:
                change(data)
            data.save_as(folder / f"{index}.dcm", enforce_file_format=True)
        # What is compressed here loses nothing.
        peer = peer if change else of_dicom(folder)
        yield f"DICOM, {name}", folder, [], peer


def cases(scratch):
    """Name, path for Vitrum, its flags, and the independent reading."""
    for files in [nifti_files, nrrd_files, itk_files, vtk_files, numpy_files, tiff_files, dicom_files]:
        for name, path, flags, peer in files(scratch):
            yield name, path, flags, lambda peer=peer: peer
