//! The lattice of a light's rays over the bounds of all bodies (Hu et al. 2010, §5.1).

use crate::error::Error;
use crate::method::voxels::UploadedMesh;
use crate::method::voxels::shadow::frame::Frame;
use crate::method::voxels::shadow::source::Source;
use glam::DVec3;
use vitrum_kernels::abi::beams::Lattice;

/// Share of the bounds by which the lattice is wider than they are: rays along its edge then miss the bodies.
const MARGIN: f64 = 1e-4;

/// The lattice of `count` × `count` rays of a light.
///
/// # Errors
/// As [`Source::check`].
pub(super) fn lattice(source: &Source, uploaded: &UploadedMesh, count: u32) -> Result<Lattice, Error> {
    let grid = uploaded.grid;
    let corners = uploaded.bounds.map(|corner| glam::Vec3::from_array(corner).as_dvec3());
    let frame = Frame::new(source, corners)?;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for position in uploaded.bodies.iter().flat_map(|body| &body.mesh.positions) {
        let at = frame.turned(glam::Vec3::from_array(*position).as_dvec3());
        (low, high) = (low.min(at), high.max(at));
    }
    let [low, high] = frame.lit(source, [low, high]);
    let margin = (high - low) * MARGIN;
    let (low, high) = (low - margin, high + margin);
    let parallel = frame.unit_depth.is_none();
    let unit = if parallel { grid.voxel_size } else { 1.0 };
    let step = (high - low) / (unit * f64::from(count));
    let vector = |v: DVec3| v.as_vec3().into();
    Ok(Lattice {
        count,
        axis: vector(frame.axes.x_axis),
        across: vector(frame.axes.y_axis),
        upwards: vector(frame.axes.z_axis),
        origin: vector(grid.at(frame.origin)),
        low_across: (low.y / unit) as f32,
        low_upwards: (low.z / unit) as f32,
        step_across: step.y as f32,
        step_upwards: step.z as f32,
    })
}

/// The lattice with at most `most` rays along each edge, over the same bounds.
pub(super) fn coarser(lattice: Lattice, most: u32) -> Lattice {
    let count = lattice.count.min(most);
    let factor = lattice.count as f32 / count.max(1) as f32;
    Lattice { count, step_across: lattice.step_across * factor, step_upwards: lattice.step_upwards * factor, ..lattice }
}

/// The lattice with twice as many rays along each edge, over the same bounds.
pub(super) fn finer(lattice: Lattice) -> Lattice {
    let [step_across, step_upwards] = [lattice.step_across, lattice.step_upwards].map(|step| 0.5 * step);
    Lattice { count: 2 * lattice.count, step_across, step_upwards, ..lattice }
}
