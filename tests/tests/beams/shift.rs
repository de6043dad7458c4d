//! A lattice of light that is moved by a part of a texel shows the same caustic: pictures do not flicker when a light or a body moves.

use super::{SUN, case, on_both, red, rms, sheet};
use vitrum_conformance::case::Case;
use vitrum_conformance::closed_forms::table;
use vitrum_conformance::refraction::{ball, together};
use vitrum_conformance::{Failure, frames};
use vitrum_io::Mesh;
use vitrum_kernels::glam::DVec3;

/// The largest change over the brightest pixel, root mean square, when a lattice of 64 × 64 texels is moved by a quarter of a texel.
const LARGEST: f64 = 1e-3;

/// Half the edge of the lattice: more than the ball's radius.
const HALF: f64 = 1.02;

/// A black triangle that is hardly to be seen.
fn speck(at: DVec3) -> Mesh {
    const EDGE: f64 = 1e-4;
    sheet(&[at, at + DVec3::X * EDGE, at + DVec3::Y * EDGE], &[[0, 1, 2]])
}

/// A ball in fog, with two specks that are the corners of the lattice: both are moved along x and y.
fn picture(by: f64) -> Result<Case, Failure> {
    let corner = DVec3::new(HALF, HALF, 0.0);
    let by = DVec3::new(by, by, 0.0);
    let mesh = together(&[ball(256), speck(by - corner), speck(by + corner)]);
    let settings = [
        SUN,
        "material=[{name='m0',ior=1.5},{opaque=true,color=[0,0,0]}]",
        "medium={absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],extent=12}",
        "ground={height=-3,color=[0,0,0]}",
        "beams.rays=64",
        "camera.position=[0,-9,0.5]",
        "camera.target=[0,0,-0.3]",
        "camera.field_of_view=40",
    ];
    case(mesh, 128, &settings)
}

#[test]
fn a_quarter_of_a_texel_changes_next_to_nothing() -> Result<(), Failure> {
    let cases = [picture(0.0)?, picture(2.0 * HALF / 64.0 / 4.0)?];
    on_both(|backend| {
        let mut caustics = |case: &Case| Ok::<_, Failure>(red(&frames::render(case, backend)?, "caustics"));
        let [before, after] = [caustics(&cases[0])?, caustics(&cases[1])?];
        let brightest = before.iter().copied().fold(0.0, f64::max);
        let change = rms(before.iter().zip(&after).map(|(before, after)| before - after)) / brightest;
        assert!(change <= LARGEST, "{change:.2e} of the brightest pixel");
        table::BEAMS_SHIFT.hold(change, backend);
        // The lattice was moved.
        assert!(change > 0.0);
        Ok(())
    })
}
