//! Closed forms: set-ups whose outcome physics knows, and their rendering by a backend.
//!
//! The tests in `tests/closed_forms` hold the outcomes to bounds, and `cargo xtask accuracy` draws how they converge
//! (`docs/accuracy.md`). A voxelized field is not the analytic one, so each set-up takes its grid.

pub mod ball;
pub mod border;
pub mod curve;
mod lines;
pub mod luneburg;
pub mod saddle;
pub mod slab;
pub mod step;
pub mod table;
pub mod turned;

use vitrum::backend::Backend;
use vitrum::io::{Volume, Voxels};
use vitrum::method::sweep::Sweep;
use vitrum::scene::{IorPoint, OpacityPoint, Projection, Scene};
use vitrum::{Frame, OutputRequest, render_requested};

/// A cube of `n`³ voxels with edge `size`, centred at the origin, holding `field` at the voxels' centres.
///
/// # Panics
/// If the field is not finite.
#[must_use]
pub fn cube(n: u32, size: f32, field: impl Fn([f64; 3]) -> f64) -> Volume {
    cuboid([n; 3], size / n as f32, field)
}

/// `dimensions` voxels with edge `spacing`, centred at the origin.
///
/// # Panics
/// If the field is not finite.
#[must_use]
pub fn cuboid(dimensions: [u32; 3], spacing: f32, field: impl Fn([f64; 3]) -> f64) -> Volume {
    let mut voxels = Vec::new();
    let at = |i: u32, n: u32| (f64::from(i) - (f64::from(n) - 1.0) * 0.5) * f64::from(spacing);
    for z in 0..dimensions[2] {
        for y in 0..dimensions[1] {
            for x in 0..dimensions[0] {
                voxels.push(field([at(x, dimensions[0]), at(y, dimensions[1]), at(z, dimensions[2])]) as f32);
            }
        }
    }
    Volume::new("closed form", dimensions, [spacing; 3], Voxels::from(voxels)).expect("the field is finite")
}

/// A scene in which parallel viewing rays and crisp light travel along −y; in the picture x points left, z up.
#[must_use]
pub fn straight_on(pixels: u32) -> Scene {
    let mut scene = Scene::default();
    scene.camera.projection = Projection::Orthographic;
    scene.camera.azimuth = 0.0;
    scene.camera.elevation = 0.0;
    scene.light[0].azimuth = 0.0;
    scene.light[0].elevation = 0.0;
    scene.light[0].angular_radius = 0.0;
    scene.shading.ambient = [0.0; 3];
    scene.film.width = pixels;
    scene.film.height = pixels;
    scene
}

/// [`straight_on`], showing nothing but refraction: the scalar is the index of refraction.
#[must_use]
pub fn refracting(volume: &Volume, pixels: u32) -> Scene {
    let mut scene = straight_on(pixels);
    let [low, high] = volume.range;
    scene.transfer.ior = vec![IorPoint::new(low, low), IorPoint::new(high, high)];
    scene.transfer.opacity = vec![OpacityPoint { value: low, opacity: 0.0 }];
    scene.shading.specular = 0.0;
    scene
}

/// The frame of a scene with this volume, without the light on the last plane, which takes far more time than small pictures.
///
/// # Panics
/// If the scene does not render.
pub fn render(scene: &Scene, volume: &Volume, backend: &mut dyn Backend) -> Frame {
    let request = OutputRequest { light: false, ..OutputRequest::default() };
    render_requested(scene, &volume.clone().into(), request, backend, &mut |_| true).expect("the scene renders")
}

/// As [`render`], with the light on the last plane.
///
/// # Panics
/// If the scene does not render.
pub fn render_with_light(scene: &Scene, volume: &Volume, backend: &mut dyn Backend) -> Frame {
    vitrum::render(scene, &volume.clone().into(), backend, &mut |_| true).expect("the scene renders")
}

/// A ray's end, in view space: position and unit direction.
#[derive(Debug, Clone, Copy)]
pub struct End {
    /// Position, world units.
    pub position: [f64; 3],
    /// Unit direction.
    pub direction: [f64; 3],
    /// One of [`vitrum_kernels::abi::record::status`].
    pub status: f32,
}

/// The end of the ray of pixel (x, y).
///
/// # Panics
/// If the frame has no such outputs.
#[must_use]
pub fn end(frame: &Frame, x: u32, y: u32) -> End {
    let at = (y * frame.width + x) as usize;
    let value = |layer: &str, channel: &str| f64::from(frame.channel(layer, channel).expect("the layer exists")[at]);
    let vector = |layer: &str| [value(layer, "X"), value(layer, "Y"), value(layer, "Z")];
    End {
        position: vector("position"),
        direction: vector("direction"),
        status: frame.channel("status", "Y").expect("the layer exists")[at],
    }
}

impl End {
    /// The point of the ray's straight continuation (or past) at view-space depth `z`.
    #[must_use]
    pub fn at_depth(&self, z: f64) -> [f64; 2] {
        let along = (z - self.position[2]) / self.direction[2];
        [self.position[0] + self.direction[0] * along, self.position[1] + self.direction[1] * along]
    }
}

/// The start of a pixel's ray, in view space: the picture spans `half` on each side.
#[must_use]
pub fn start(frame: &Frame, x: u32, y: u32, half: f64) -> [f64; 2] {
    let at = |i: u32, n: u32| (f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0;
    [at(x, frame.width) * half, -at(y, frame.height) * half]
}

/// Half the picture's edge for an orthographic camera with zoom 1 on a cube of edge `size`, as the camera documents it; and
/// the view-space depth of the cube's centre.
#[must_use]
pub fn orthographic_frame(size: f64) -> (f64, f64) {
    let radius = size * 0.75f64.sqrt();
    (0.87 * radius, -4.0 * radius)
}

/// The red plane irradiance of the texels on the planes that `at` chooses, in the course of a frame. Where a wavefront carries the light, it is that of
/// its cells on its own planes ([`Sweep::light_planes`]), and on up to [`BEYOND`] planes behind the last one, as it flies on.
///
/// # Panics
/// If the backend fails.
pub fn light_on_planes(
    sweep: &Sweep,
    backend: &mut dyn Backend,
    at: impl Fn(u32) -> bool,
    mut look: impl FnMut(u32, &[f32]),
) {
    let texels = (sweep.light_grid.size[0] * sweep.light_grid.size[1]) as usize;
    let forward = sweep.light_view().is_some();
    let ends = if forward { ["sweep_initialize_nodes", "sweep_advance_nodes"] } else { ["sweep_concentrate_light"; 2] };
    let passes = &sweep.passes.passes;
    let ends_plane = |pass: &usize| ends.contains(&passes[*pass].kernel.declaration.family);
    let last = sweep.light_planes().count - 1;
    let mut see = |plane: u32, backend: &mut dyn Backend| {
        if at(plane) {
            look(plane, &sweep.irradiance_on(plane, backend).expect("the light can be read")[..texels]);
        }
    };
    let mut done = 0;
    for (plane, pass) in (0..).zip((0..passes.len()).filter(ends_plane)) {
        if at(plane) || plane == last {
            backend.run(&sweep.passes.part(done, pass + 1), &mut |_| true).expect("the passes run");
            done = pass + 1;
        }
        see(plane, backend);
    }
    if forward {
        (last + 1..=last + BEYOND).for_each(|plane| see(plane, backend));
    }
}

/// Planes behind the last plane of a wavefront on which its light is looked at.
pub const BEYOND: u32 = 256;
