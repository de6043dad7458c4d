//! Shadows of meshes against closed forms and an exact caster of rays, on both backends.

mod backends;
mod coverage;
mod environment;
mod lights;
mod pictures;
mod points;
mod sheets;
mod spots;
mod surfaces;

use vitrum::Frame;
use vitrum::backend::{Backend, CpuBackend};
use vitrum_conformance::case::Case;
use vitrum_conformance::refraction;
use vitrum_conformance::{Failure, adapter};
use vitrum_io::Mesh;
use vitrum_kernels::glam::DVec3;

/// Calls `check` with each backend. Kernels write the same bits on both; the test's conclusions from them are checked on both all the
/// same.
fn on_both(check: impl Fn(&mut dyn Backend) -> Result<(), Failure>) -> Result<(), Failure> {
    check(&mut CpuBackend::new(None)?)?;
    adapter::for_test().map_or(Ok(()), |mut gpu| check(&mut gpu))
}

fn color(frame: &Frame) -> Vec<[f32; 3]> {
    frame.aov("color").expect("every frame has a colour").color()
}

/// A case whose bodies are opaque, in the light of the world.
fn case(mesh: Mesh, edge: u32, settings: &[&str]) -> Result<Case, Failure> {
    let usual = ["light.0.attachment=world", "material.0.opaque=true", "ground={}", "light.0.angular_radius=0"];
    refraction::case("shadow", mesh, edge, &[&usual, settings].concat())
}

/// Light from straight above.
const ABOVE: [&str; 2] = ["light.0.elevation=90", "light.0.azimuth=0"];

/// Quads of two triangles, by their middles and two half edges each.
fn quads(quads: impl IntoIterator<Item = [DVec3; 3]>) -> Mesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for [middle, e, f] in quads {
        let base = positions.len() as u32;
        let corners = [middle - e - f, middle + e - f, middle + e + f, middle - e + f];
        positions.extend(corners.map(|corner| corner.as_vec3().to_array()));
        triangles.extend([[base, base + 1, base + 2], [base, base + 2, base + 3]]);
    }
    Mesh::new("quads", positions, triangles).expect("a valid mesh")
}

/// Horizontal quads with half edges of 1, at these heights.
fn sheets(heights: impl IntoIterator<Item = f64>) -> Mesh {
    quads(heights.into_iter().map(|height| [DVec3::Z * height, DVec3::X, DVec3::Y]))
}

/// A sheet that is hardly to be seen: a picture of receivers needs a mesh.
fn speck() -> Mesh {
    quads([[DVec3::ZERO, DVec3::X * 0.02, DVec3::Y * 0.02]])
}

/// Numbers from 0 to 1, the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        // Knuth's constants of MMIX.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn within(&mut self, half: f64) -> f64 {
        (self.next() * 2.0 - 1.0) * half
    }
}
