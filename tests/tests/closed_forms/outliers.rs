//! Tables follow the transfer functions: one voxel of a million times the range changes nothing beside it, and a peak that is a ten-thousandth of
//! the range wide is seen.

use crate::setup::{backends, cube, end, refracting, straight_on};
use vitrum::backend::Backend;
use vitrum::io::{Volume, Voxels};
use vitrum::method::sweep::Sweep;
use vitrum::scene::{ColorPoint, Gradient, IorPoint, OpacityPoint, Scene, Transport};
use vitrum::{Assets, OutputRequest, Subject};
use vitrum_conformance::closed_forms::render;
use vitrum_conformance::closed_forms::table::{self, larger};

const PIXELS: u32 = 9;

/// The middle pixels' indices: what a corner of the volume holds is beside them.
fn middle() -> impl Iterator<Item = usize> {
    (3..6).flat_map(|y| (3..6).map(move |x| (y * PIXELS + x) as usize))
}

/// The same volume with another value in a corner.
fn with_outlier(volume: &Volume, value: f32) -> Volume {
    let mut voxels = volume.voxels.clone();
    match &mut voxels {
        Voxels::U8(voxels) => voxels.make_mut()[0] = value as u8,
        Voxels::U16(voxels) => voxels.make_mut()[0] = value as u16,
        Voxels::F32(voxels) => voxels.make_mut()[0] = value,
    }
    Volume::new("with an outlier", volume.dimensions, volume.spacing, voxels).expect("the value is finite")
}

/// The volume as whole numbers up to `most`.
fn whole(volume: &Volume, most: f32, of: impl Fn(Vec<f32>) -> Voxels) -> Volume {
    let Voxels::F32(voxels) = &volume.voxels else { panic!("cubes hold floats") };
    let [low, high] = volume.range;
    let stored = voxels.iter().map(|value| ((value - low) / (high - low) * most).round()).collect();
    Volume::new("whole numbers", volume.dimensions, volume.spacing, of(stored)).expect("the values are finite")
}

fn opacities(points: &[(f32, f32)]) -> Vec<OpacityPoint> {
    points.iter().map(|&(value, opacity)| OpacityPoint { value, opacity }).collect()
}

/// Depth makes opacity, colour, filter and η of a scalar between `low` and `high`; what is below a tenth is invisible.
fn everything([low, high]: [f32; 2]) -> Scene {
    let mut scene = straight_on(PIXELS);
    scene.sweep.light = Transport::Texels;
    let at = |share: f32| low + share * (high - low);
    scene.transfer.opacity = opacities(&[(at(0.1), 0.0), (at(0.6), 0.1), (at(0.7), 0.02), (at(0.9), 0.2)]);
    let color = |share: f32, color: [f32; 3]| ColorPoint { value: at(share), color };
    scene.transfer.color = vec![color(0.0, [1.0, 0.2, 0.1]), color(1.0, [0.1, 0.3, 1.0])];
    scene.transfer.filter = vec![color(0.2, [1.0; 3]), color(0.8, [0.95, 0.9, 0.97])];
    scene.transfer.ior = vec![IorPoint::new(at(0.15), 1.0), IorPoint::new(at(0.95), 1.2)];
    scene
}

/// The film of a scene, as it is held or in pages.
fn film(scene: &Scene, subject: Subject, streamed: bool, backend: &mut dyn Backend) -> Vec<f32> {
    let assets = Assets::from(subject);
    let prepare = if streamed { Sweep::prepare_streamed } else { Sweep::prepare };
    let sweep = prepare(scene, &assets, OutputRequest { light: false, ..OutputRequest::default() }, backend)
        .expect("the scene renders");
    sweep.run(backend, &mut |_| true).expect("the passes run");
    sweep.film(backend).expect("the film is read")
}

/// The largest difference of two films at the middle pixels.
fn difference(one: &[f32], other: &[f32]) -> f64 {
    let pixels = (PIXELS * PIXELS) as usize;
    let mut worst = 0.0;
    for component in 0..one.len() / pixels {
        for pixel in middle() {
            let at = component * pixels + pixel;
            worst = larger(worst, f64::from(one[at] - other[at]).abs());
        }
    }
    worst
}

#[test]
fn an_outlier_changes_nothing_beside_it() {
    let floats = cube(48, 2.0, |[x, y, _]| 0.5 + 0.4 * (3.0 * y + 0.4 * x).sin());
    let bytes =
        whole(&floats, 40.0, |stored| Voxels::from(stored.iter().map(|&value| value as u8).collect::<Vec<_>>()));
    let words =
        whole(&floats, 900.0, |stored| Voxels::from(stored.iter().map(|&value| value as u16).collect::<Vec<_>>()));
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for (volume, outlier) in [(&floats, 8e5), (&floats, -8e5), (&bytes, 255.0), (&words, 65_535.0)] {
            let changed = with_outlier(volume, outlier);
            let mut scenes = vec![everything(volume.range)];
            let mut texels = everything(volume.range);
            texels.sweep.light = Transport::Texels;
            texels.sweep.gradient = Gradient::Chain;
            let mut default = everything(volume.range);
            default.transfer.opacity.clear();
            let mut straight = everything(volume.range);
            straight.sweep.refraction = false;
            straight.transfer.filter.clear();
            scenes.extend([texels, default, straight]);
            for scene in scenes {
                for streamed in [false, true] {
                    let [one, other] = [volume, &changed]
                        .map(|volume| film(&scene, volume.clone().into(), streamed, backend.as_mut()));
                    worst = larger(worst, difference(&one, &other));
                }
            }
            let second = |ior: &Volume| Subject::Volumes { shown: volume.clone().into(), ior: ior.clone().into() };
            let scene = everything(volume.range);
            let [one, other] = [volume, &changed].map(|ior| film(&scene, second(ior), false, backend.as_mut()));
            worst = larger(worst, difference(&one, &other));
        }
        table::OUTLIER_FILM.hold(worst, backend.as_ref());
    }
}

#[test]
fn an_outlier_turns_no_ray() {
    let volume = cube(32, 2.0, |[x, y, _]| 1.0 + 0.05 * x * (1.0 - y * y));
    let changed = with_outlier(&volume, 1e6);
    for mut backend in backends() {
        let mut worst = 0.0f64;
        let scene = refracting(&volume, PIXELS);
        let [one, other] = [&volume, &changed].map(|volume| render(&scene, volume, backend.as_mut()));
        for pixel in middle() {
            let [a, b] = [&one, &other].map(|frame| end(frame, pixel as u32 % PIXELS, pixel as u32 / PIXELS).direction);
            assert!(a[0].abs() > 1e-3, "the ray is bent");
            let angle = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt().to_degrees();
            worst = larger(worst, angle);
        }
        table::OUTLIER_TURN.hold(worst, backend.as_ref());
    }
}

/// The optical depth of a peak of opacity `opacity` over scalars, or of one side of it, times the scalar's width: ∫ −ln(1 − α) over a ramp of α
/// from 0.
fn ramp_depth(opacity: f64, width: f64) -> f64 {
    let clear = 1.0 - opacity;
    width * (clear * clear.ln() + opacity) / opacity
}

#[test]
fn a_thin_peak_is_seen() {
    // The scalar is the depth: it rises by a half from front to back a unit of length.
    let volume = cube(64, 2.0, |[_, y, _]| 0.5 + 0.5 * y);
    let (half, reference) = (0.5e-4f32, 3e-4);
    for mut backend in backends() {
        let mut worst = [0.0f64; 2];
        for middle in [0.4f32, 0.5, 0.731] {
            let peak = [(middle - half, 0.0), (middle, 0.9), (middle + half, 0.0)];
            let behind = [(0.8, 0.0), (0.95, 1e-3)];
            let width = f64::from(peak[2].0) - f64::from(peak[0].0);
            // Behind 0.95 up to the last voxel's centre at 0.9922, and half a voxel of that.
            let depths =
                [ramp_depth(0.9, width), ramp_depth(0.9, width) + ramp_depth(1e-3, 0.15) - (1.0f64 - 1e-3).ln() * 0.05];
            for (case, points) in [peak.to_vec(), [&peak[..], &behind[..]].concat()].into_iter().enumerate() {
                let mut scene = straight_on(PIXELS);
                scene.transfer.opacity = opacities(&points);
                scene.transfer.reference_length = Some(reference);
                let frame = render(&scene, &volume, backend.as_mut());
                let expected = 1.0 - (-depths[case] * 2.0 / f64::from(reference)).exp();
                for pixel in self::middle() {
                    let opacity = f64::from(frame.channel("opacity", "Y").expect("opacity")[pixel]);
                    println!("{} {middle} {case}: {opacity:.5}, {expected:.5}", backend.name());
                    worst[case] = larger(worst[case], (opacity - expected).abs());
                }
            }
        }
        table::PEAK_ALONE.hold(worst[0], backend.as_ref());
        table::PEAK_BESIDE.hold(worst[1], backend.as_ref());
    }
}
