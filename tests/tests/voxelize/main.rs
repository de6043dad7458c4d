//! Voxelization: against an exact test of triangles and boxes, against closed forms, both backends against each other.

mod backends;
mod exact;
mod planted;
mod shapes;
mod solid;
mod surface;

use vitrum::backend::{Backend, CpuBackend};
use vitrum::method::Tools;
use vitrum::method::voxelize::{Settings, Voxelization, voxelize};
use vitrum_io::Mesh;

fn cpu() -> CpuBackend {
    CpuBackend::new(Some(2)).expect("threads can be started")
}

/// Voxelizes a mesh; `goes_on` says whether the work is not cancelled.
fn try_on(
    mesh: &Mesh,
    settings: &Settings,
    backend: &mut dyn Backend,
    goes_on: bool,
) -> Result<Voxelization, vitrum::Error> {
    voxelize(mesh, settings, &mut Tools { backend, progress: &mut |_| goes_on })
}

fn run_on(mesh: &Mesh, settings: &Settings, backend: &mut dyn Backend) -> Voxelization {
    try_on(mesh, settings, backend, true).unwrap_or_else(|error| panic!("{}: {error}", mesh.name))
}

fn run(mesh: &Mesh, settings: &Settings) -> Voxelization {
    run_on(mesh, settings, &mut cpu())
}
