"""Times of VTK's ray caster on the CPU beside Vitrum's sweep, in turns: a table of medians for docs/benchmarks.md.

python3 rendering_times.py VITRUM [--volume FILE] [--size 512] [--voxels 256] [--rounds 3] [--frames 7] [--pictures FOLDER]

VITRUM is the program. Needs numpy and vtk, and a machine where VTK finds a window to render off screen in (EGL or X). Both use all
processors, the same voxels, transfer functions and camera, and a light from the same side; VTK's sample distance is a voxel. The voxels are
those of `builtin:phantom`; or those of FILE, a cube of bytes that Vitrum reads, with x to the right, z up and the least y in front, and the
phantom's transfer functions. FOLDER is where the pictures go, to compare what the programs show.
"""
import argparse, json, os, statistics, subprocess, tempfile, time

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

COLORS = ((0, (0, 0, 0)), (70, (0.9, 0.6, 0.5)), (100, (0.8, 0.3, 0.2)), (170, (1, 1, 0.9)), (255, (1, 1, 1)))
LOW = ((0, 0), (20, 0), (60, 0.01), (75, 0.015), (110, 0.05))
OPACITIES = {
    "phantom": LOW + ((170, 0.25), (190, 0.4), (255, 0.6)),
    "phantom/translucent": LOW + ((170, 0.01), (190, 0.02), (255, 0.03)),
}
PLAIN = ["light.0.shadows=false", "sweep.refraction=false"]
VITRUM = {
    "Vitrum, `light.0.shadows=false`, `sweep.refraction=false`": PLAIN,
    "Vitrum, everything on": [],
    "Vitrum, everything on, light kept from the frame before": [],
    "Vitrum, everything on, `sweep.light_cells=160`": ["sweep.light_cells=160"],
    "Vitrum, everything on, `sweep.light=texels`": ["sweep.light=texels"],
}


def phantom(n):
    """The voxels, z slowest, as docs/benchmarks.md defines them."""
    axis = (numpy.arange(n, dtype=numpy.float32) + 0.5) / n * 2 - 1
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")

    def smooth(a, b, t):
        s = numpy.clip((t - a) / (b - a), 0, 1)
        return s * s * (3 - 2 * s)

    r = numpy.sqrt((x / 0.80) ** 2 + (y / 0.90) ** 2 + (z / 0.95) ** 2)
    v = 70 * (1 - smooth(0.97, 1.0, r)) + 120 * smooth(0.78, 0.80, r) * (1 - smooth(0.86, 0.88, r))
    for k in range(8):
        a = 2 * numpy.pi * k / 8
        c = 0.45 * numpy.cos(a), 0.45 * numpy.sin(a), 0.3 * numpy.sin(3 * a)
        v += 100 * (1 - smooth(0.12, 0.15, numpy.sqrt((x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2)))
    return numpy.clip(v, 0, 255).astype(numpy.uint8)


class Caster:
    """VTK's picture of a volume, whose camera goes 3° further for each frame, so that nothing is kept from the last one."""

    def __init__(self, voxels, opacities, size, shaded):
        n = voxels.shape[0]
        image = vtk.vtkImageData()
        image.SetDimensions(n, n, n)
        image.GetPointData().SetScalars(numpy_to_vtk(voxels.ravel(), deep=True, array_type=vtk.VTK_UNSIGNED_CHAR))
        color, opacity = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        for value, rgb in COLORS:
            color.AddRGBPoint(value, *rgb)
        for value, alpha in opacities:
            opacity.AddPoint(value, alpha)
        look = vtk.vtkVolumeProperty()
        look.SetColor(color)
        look.SetScalarOpacity(opacity)
        look.SetInterpolationTypeToLinear()
        look.SetAmbient(0.2)
        look.SetDiffuse(0.7)
        look.SetSpecular(0.3)
        look.SetSpecularPower(20)
        look.SetShade(shaded)
        mapper = vtk.vtkFixedPointVolumeRayCastMapper()
        mapper.SetAutoAdjustSampleDistances(0)
        mapper.SetSampleDistance(1.0)
        mapper.SetImageSampleDistance(1.0)
        mapper.SetNumberOfThreads(os.cpu_count())
        mapper.SetInputData(image)
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(look)
        light = vtk.vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(n * 1.5, n * 2, n * 2.5)
        light.SetFocalPoint(n / 2, n / 2, n / 2)
        self.renderer = vtk.vtkRenderer()
        self.renderer.SetBackground(0.1, 0.1, 0.15)
        self.renderer.AddVolume(volume)
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(light)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetFocalPoint(n / 2, n / 2, n / 2)
        self.camera.SetPosition(n / 2, n / 2, n / 2 + 2.6 * n)
        self.camera.SetViewUp(0, 1, 0)
        self.camera.SetViewAngle(30)
        self.window.Render()

    def frames(self, count):
        times = []
        for _ in range(count):
            self.camera.Azimuth(3.0)
            self.renderer.ResetCameraClippingRange()
            started = time.perf_counter()
            self.window.Render()
            times.append((time.perf_counter() - started) * 1e3)
        return statistics.median(times)


    def picture(self, path):
        grabbed = vtk.vtkWindowToImageFilter()
        grabbed.SetInput(self.window)
        grabbed.ReadFrontBufferOff()
        writer = vtk.vtkPNGWriter()
        writer.SetFileName(path)
        writer.SetInputConnection(grabbed.GetOutputPort())
        writer.Write()


def of_file(program, path, folder):
    """The voxels of a file, z slowest, turned so that z is towards the viewer and y up, and a file of them that Vitrum shows so."""
    converted = os.path.join(folder, "volume.npy")
    subprocess.run([program, "convert", path, "-o", converted], check=True, capture_output=True)
    voxels = numpy.load(converted)
    n = voxels.shape[0]
    if voxels.dtype != numpy.uint8 or voxels.shape != (n, n, n):
        raise SystemExit(f"{path}: {voxels.shape} voxels of {voxels.dtype}; a cube of uint8 is needed")
    seen = numpy.ascontiguousarray(voxels.transpose(1, 0, 2)[::-1])
    stored = os.path.join(folder, "volume.nrrd")
    # As large as the phantom. Vitrum looks from +y.
    s = 2 / n
    with open(stored, "wb") as file:
        header = f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {n} {n} {n}\nencoding: raw\nspace dimension: 3\n"
        header += f"space directions: ({-s},0,0) (0,0,{s}) (0,{s},0)\n\n"
        file.write(header.encode() + seen.tobytes())
    return seen, stored


def scene_of(program, name, file, folder):
    """A scene file as the built-in scene, of the volume in `file`."""
    text = subprocess.run([program, "scene", f"builtin:{name}"], check=True, capture_output=True, text=True).stdout
    path = os.path.join(folder, "scene.toml")
    with open(path, "w") as scene:
        scene.write(text.replace('builtin = "phantom"', f"file = {json.dumps(file)}"))
    return path


def vitrum(program, scene, settings, size, frames, out, kept):
    """The median of frames that keep the light of the frame before, or the time of the first frame, which carries it."""
    command = [program, "render", scene, "-o", out, "--size", f"{size}x{size}", "--backend", "cpu", "--json", "-q", "--quality", "draft"]
    command += ["--frames", str(frames)]
    for setting in settings:
        command += ["--set", setting]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    times = json.loads(text)["frame_ms"]
    return statistics.median(times[1:]) if kept else times[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vitrum")
    parser.add_argument("--volume")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--voxels", type=int, default=256)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--frames", type=int, default=7)
    parser.add_argument("--pictures")
    arguments = parser.parse_args()
    program, size, frames = arguments.vitrum, arguments.size, arguments.frames
    rubbish = tempfile.TemporaryDirectory()
    folder = arguments.pictures or rubbish.name
    os.makedirs(folder, exist_ok=True)
    if arguments.volume:
        voxels, file = of_file(program, arguments.volume, folder)
    else:
        voxels, file = phantom(arguments.voxels), None
    times = {}
    for name, opacities in OPACITIES.items():
        scene = scene_of(program, name, file, folder) if file else f"builtin:{name}"
        resolution = [] if file else [f"volume.resolution={arguments.voxels}"]
        casters = {
            "VTK, unshaded": Caster(voxels, opacities, size, False),
            "VTK, shaded by gradients": Caster(voxels, opacities, size, True),
        }
        column = name.replace("/", "-")
        for caster, look in zip(casters.values(), ("plain", "shaded")):
            caster.picture(os.path.join(folder, f"{column}-vtk-{look}.png"))
        for _ in range(arguments.rounds):
            for row, caster in casters.items():
                times.setdefault(row, {}).setdefault(name, []).append(caster.frames(frames))
            for index, (row, settings) in enumerate(VITRUM.items()):
                out = os.path.join(folder, f"{column}-vitrum-{index}.png")
                kept = row.endswith("kept from the frame before")
                found = vitrum(program, scene, resolution + settings, size, frames, out, kept)
                times.setdefault(row, {}).setdefault(name, []).append(found)
    print(f"| | {' | '.join(OPACITIES)} |")
    print("|---|---|---|")
    for row, found in times.items():
        print(f"| {row} | {' | '.join(f'{statistics.median(found[name]):.0f}' for name in OPACITIES)} |")


main()
