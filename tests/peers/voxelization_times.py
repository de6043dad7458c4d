"""Times of other voxelizers beside Vitrum's, in turns, on the same meshes: a table of medians for docs/benchmarks.md.

python3 voxelization_times.py VITRUM VOXELIZE_RS MESH... [--resolutions 128,256] [--rounds 3]

VITRUM is the program; VOXELIZE_RS the one of the folder `voxelize-rs` beside this file. Needs trimesh, scipy, open3d and vtk. All make the
surface: from the mesh in memory to the voxels in memory. VTK has no voxelizer of surfaces that is as quick; its stencil is a solid.
"""
import argparse, json, os, statistics, subprocess, tempfile, time

import numpy
import open3d
import trimesh
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

# Peers that take longer than this in the first round are left out of the others.
PATIENCE = 20.0


def vitrum(program, path, resolution, solid):
    out = os.path.join(tempfile.gettempdir(), "voxelization_times.nrrd")
    command = [program, "voxelize", path, "-r", str(resolution), "-o", out, "--backend", "cpu", "--runs", "5", "--json", "-q"]
    command += ["--solid"] if solid else []
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return statistics.median(json.loads(text)["voxelize_ms"])


def voxelize_rs(program, path, resolution):
    command = [program, path, str(resolution), "3"]
    lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\n")
    return statistics.median(float(line.split()[0]) for line in lines if line)


def timed(call):
    started = time.perf_counter()
    call()
    return (time.perf_counter() - started) * 1e3


def open3d_surface(mesh, pitch):
    vertices = open3d.utility.Vector3dVector(mesh.vertices)
    other = open3d.geometry.TriangleMesh(vertices, open3d.utility.Vector3iVector(mesh.faces))
    return timed(lambda: open3d.geometry.VoxelGrid.create_from_triangle_mesh(other, voxel_size=pitch))


def vtk_stencil(mesh, pitch):
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(mesh.vertices), deep=True))
    flat = numpy.column_stack([numpy.full(len(mesh.faces), 3), mesh.faces]).astype(numpy.int64).ravel()
    cells.SetCells(len(mesh.faces), numpy_to_vtkIdTypeArray(flat, deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    size = [int(numpy.ceil(extent / pitch)) for extent in mesh.extents]

    def run():
        stencil, image = vtk.vtkPolyDataToImageStencil(), vtk.vtkImageStencilToImage()
        stencil.SetInputData(data)
        stencil.SetOutputOrigin(*(mesh.bounds[0] + 0.5 * pitch))
        stencil.SetOutputSpacing(pitch, pitch, pitch)
        stencil.SetOutputWholeExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1)
        image.SetInputConnection(stencil.GetOutputPort())
        image.Update()

    return timed(run)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("vitrum")
    parser.add_argument("voxelize_rs")
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--resolutions", default="128,256")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    print("| mesh | triangles | N | Vitrum | voxelize-rs | trimesh | Open3D | Vitrum, solid | VTK, solid |")
    print("|---|---|---|---|---|---|---|---|---|")
    for path in arguments.meshes:
        mesh = trimesh.load(path, force="mesh", process=True)
        with tempfile.TemporaryDirectory() as folder:
            stl = os.path.join(folder, "mesh.stl")
            mesh.export(stl)
            for resolution in map(int, arguments.resolutions.split(",")):
                pitch = mesh.extents.max() / resolution
                peers = {
                    "Vitrum": lambda: vitrum(arguments.vitrum, stl, resolution, False),
                    "voxelize-rs": lambda: voxelize_rs(arguments.voxelize_rs, stl, resolution),
                    "trimesh": lambda: timed(lambda: trimesh.voxel.creation.voxelize(mesh, pitch, method="subdivide")),
                    "Open3D": lambda: open3d_surface(mesh, pitch),
                    "Vitrum, solid": lambda: vitrum(arguments.vitrum, stl, resolution, True),
                    "VTK, solid": lambda: vtk_stencil(mesh, pitch),
                }
                times = {name: [] for name in peers}
                for _ in range(arguments.rounds):
                    for name, peer in peers.items():
                        if not times[name] or times[name][0] < PATIENCE * 1e3:
                            times[name].append(peer())
                cells = [f"{statistics.median(found):.0f} ms" for found in times.values()]
                name = os.path.splitext(os.path.basename(path))[0]
                print(f"| `{name}` | {len(mesh.faces)} | {resolution} | {' | '.join(cells)} |", flush=True)


main()
