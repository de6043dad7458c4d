//! Beams of light in a medium, against single scattering to nine digits and closed forms, on both backends.

mod adaptive;
mod airlight;
mod ball;
mod ball_table;
mod density;
mod dispersion;
mod flux;
mod inside;
mod light;
mod lights;
mod map_table;
mod maps;
mod march;
mod medium;
mod mirror;
mod mirror_table;
mod moving;
mod multiple;
mod picture;
mod picture_table;
mod shift;
mod soft;
mod surfaces;
mod thin;

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

/// Runs a check of many frames on the CPU alone: kernels write the same bits on both backends, as the conformance suite holds, and a software adapter takes
/// minutes for them.
fn on_the_cpu(check: impl Fn(&mut dyn Backend) -> Result<(), Failure>) -> Result<(), Failure> {
    check(&mut CpuBackend::new(None)?)
}

/// A case in which nothing shines but its light. Viewing rays end at the first surface, whatever it is.
fn case(mesh: Mesh, edge: u32, settings: &[&str]) -> Result<Case, Failure> {
    let usual = [
        "method=beams",
        "beams.views=1",
        "environment.kind=color",
        "environment.color=[0,0,0]",
        "shading.ambient=[0,0,0]",
    ];
    refraction::case("beams", mesh, edge, &[&usual, settings].concat())
}

/// A lamp of 40 W that shines equally to all sides: its intensity is 40 W / 4π over π.
const LAMP: &str = "light.0={kind='point',position=[0,0,4],intensity=1.0132118364233778}";

/// Light straight down, of an irradiance of 1: its intensity is 1 over π.
const SUN: &str =
    "light.0={kind='distant',attachment='world',direction=[0,0,-1],intensity=0.3183098861837907,angular_radius=0}";

/// The red channel of an output.
fn red(frame: &Frame, output: &str) -> Vec<f64> {
    let channel = frame.channel(output, "R").expect("frames of beams have the output");
    channel.iter().copied().map(f64::from).collect()
}

/// The root of the mean square.
fn rms(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, count) = values.into_iter().fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
    (sum / count).sqrt()
}

/// Triangles, by their corners.
fn sheet(corners: &[DVec3], triangles: &[[u32; 3]]) -> Mesh {
    let positions = corners.iter().map(|corner| corner.as_vec3().to_array()).collect();
    Mesh::new("sheet", positions, triangles.to_vec()).expect("a valid mesh")
}
