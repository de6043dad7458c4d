//! The light of a frame of beams, seen by other frames: it does not depend on the camera, and takes most of a frame's time.

use super::ball::in_fog;
use super::thin::{Look, Thin};
use super::{LAMP, SUN, on_the_cpu};
use bytemuck::NoUninit;
use vitrum::backend::{Backend, Buffer, Pass, PassList};
use vitrum::method::PreparedFrame;
use vitrum_conformance::Failure;
use vitrum_kernels::abi::beams::{BeamsUniforms, target};
use vitrum_kernels::glam::DVec3;
use vitrum_kernels::kernel::kernels;

/// The largest difference of two numbers that describe the same light, as a share: directions and planes are turned into each camera's frame and back.
const ROUNDING: f32 = 1e-5;

/// The largest difference of what is seen, as a share, where the light comes from a direction: it is rounded otherwise for each camera.
const LARGEST: f64 = 1e-4;

/// The light of a frame that has run; its buffers live as long as this.
pub struct Light {
    passes: Vec<Pass>,
    _frame: Box<dyn PreparedFrame>,
}

fn uniforms(pass: &Pass) -> BeamsUniforms {
    bytemuck::pod_read_unaligned(&pass.uniforms)
}

/// Whether a pass depends on the camera.
fn is_of_view(pass: &Pass) -> bool {
    let is = |name: &str| pass.kernel.declaration.name == name;
    is(kernels::beams_trace_view.declaration.name)
        || (is(kernels::beams_exchange_light.declaration.name) && uniforms(pass).dispatch.mode == target::EYE)
}

/// The passes of the light, which come first.
fn of_light(passes: &PassList) -> &[Pass] {
    assert!(passes.writes.is_empty(), "writes would have to be moved");
    let end = passes.passes.iter().position(is_of_view).expect("every frame has a view");
    &passes.passes[..end]
}

/// Traces the light of a frame, without its picture.
pub fn trace(frame: &dyn PreparedFrame, backend: &mut dyn Backend) -> Result<(), Failure> {
    let passes = of_light(frame.passes()).to_vec();
    Ok(backend.run(&PassList { passes, ..frame.passes().clone() }, &mut |_| true)?)
}

/// Whether two records are the same but for rounding.
fn is_near<T: NoUninit>(one: &T, other: &T) -> bool {
    let floats = |of: &T| bytemuck::pod_collect_to_vec::<u8, f32>(bytemuck::bytes_of(of));
    // Planes that are not there are infinitely far away.
    let is_near = |(one, other): (f32, f32)| one == other || (one - other).abs() <= ROUNDING * one.abs().max(1.0);
    floats(one).into_iter().zip(floats(other)).all(is_near)
}

impl Light {
    /// The light of a frame that has run.
    pub fn new(frame: Box<dyn PreparedFrame>) -> Self {
        Self { passes: of_light(frame.passes()).to_vec(), _frame: frame }
    }

    /// The passes of another frame of the same scene, with another camera, without those of its light: they read this light instead.
    pub fn seen_by(&self, other: &PassList) -> PassList {
        let passes = of_light(other);
        assert_eq!(passes.len(), self.passes.len(), "the scenes differ");
        let mut known: Vec<(&Buffer, &Buffer)> = Vec::new();
        for (pass, own) in passes.iter().zip(&self.passes) {
            let [found, right] = [pass, own].map(uniforms);
            assert_eq!(pass.kernel.declaration.name, own.kernel.declaration.name, "the scenes differ");
            let same = is_near(&found.light, &right.light) && is_near(&found.lattice, &right.lattice);
            assert!(same, "the light moves with the camera: {:?}, {:?}", found.light, right.light);
            assert!(is_near(&found.medium, &right.medium), "the media differ");
            assert!(is_near(&found.receivers, &right.receivers), "ground or wall moves with the camera");
            known.extend(pass.buffers.iter().zip(&own.buffers));
        }
        let rest = other.passes[passes.len()..].iter().map(|pass| Pass {
            buffers: pass.buffers.iter().map(|buffer| replaced(buffer, &known).clone()).collect(),
            ..pass.clone()
        });
        PassList { passes: rest.collect(), ..other.clone() }
    }
}

/// The buffer in a buffer's place.
fn replaced<'a>(buffer: &'a Buffer, known: &[(&Buffer, &'a Buffer)]) -> &'a Buffer {
    known.iter().find(|(other, _)| *other == buffer).map_or(buffer, |&(_, own)| own)
}

/// A look by the light of another one is that of a frame of its own: to the last bit, where the light has a place.
#[test]
fn all_looks_see_the_light_of_the_first() -> Result<(), Failure> {
    let looks = [
        (DVec3::new(0.0, -9.0, 0.5), DVec3::new(0.03, 0.0, -1.3)),
        (DVec3::new(4.0, 3.0, -2.2), DVec3::new(0.7, 0.2, -3.0)),
        (DVec3::new(0.35, -0.25, -2.9), DVec3::new(0.03, 0.0, -1.3)),
    ];
    on_the_cpu(|backend| {
        for (light, largest) in [(LAMP, 0.0), (SUN, LARGEST)] {
            let mut case = in_fog(light, 0.7, 1.0, 32)?;
            for setting in ["beams.orders=3", "beams.views=2"] {
                case.scene.set(setting)?;
            }
            let mut thin = Thin::new(case, backend);
            for (eye, point) in looks {
                let [found, right] = [thin.look(eye, point)?, thin.look_afresh(eye, point)?].map(Look::all);
                let brightest = right.iter().copied().fold(0.0, f64::max);
                let worst = found.iter().zip(&right).map(|(found, right)| (found - right).abs()).fold(0.0, f64::max);
                println!("{light}, from {eye}: {worst:.1e} of {brightest:.1e}");
                assert!(worst <= largest * brightest, "{light}, from {eye} through {point}: {found:?}, not {right:?}");
            }
        }
        Ok(())
    })
}
