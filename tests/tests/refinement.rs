//! Pixels that differ from their neighbours get more rays, and nothing else changes.

use vitrum::backend::{Backend, CpuBackend};
use vitrum::scene::Light;
use vitrum::{Frame, render};
use vitrum_conformance::case::Case;
use vitrum_conformance::{Failure, adapter};

const EDGE: u32 = 48;

fn picture(
    scene: &str,
    edge: u32,
    settings: &[&str],
    change: impl Fn(&mut Case),
    backend: &mut dyn Backend,
) -> Result<Frame, Failure> {
    let mut case = Case::builtin(scene, edge, Some(32), settings)?;
    change(&mut case);
    Ok(render(&case.scene, &case.assets, backend, &mut |_| true)?)
}

/// A refined pixel has the values of as many rays everywhere, bit for bit, every other pixel those of one ray.
#[test]
fn refined_pixels_are_those_of_more_rays_everywhere() -> Result<(), Failure> {
    for mut backend in adapter::backends_for_test()? {
        for lights in [1, 2] {
            for scene in ["ball", "phantom"] {
                let mut with = |settings: &[&str]| {
                    let second = |case: &mut Case| {
                        let other = Light { azimuth: 20.0, ..case.scene.light[0].clone() };
                        case.scene.light.extend((1..lights).map(|_| other.clone()));
                    };
                    picture(scene, EDGE, settings, second, backend.as_mut())
                };
                let one = with(&[])?;
                let all = with(&["film.supersampling=3"])?;
                let refined = with(&["film.refinement=3"])?;
                let mut changed = vec![false; (EDGE * EDGE) as usize];
                for ((one, all), refined) in one.layers.iter().zip(&all.layers).zip(&refined.layers) {
                    for ((one, all), refined) in one.channels.iter().zip(&all.channels).zip(&refined.channels) {
                        for (pixel, &value) in refined.data.iter().enumerate() {
                            let (few, many) = (one.data[pixel], all.data[pixel]);
                            changed[pixel] |= value != few;
                            assert!(
                                [few.to_bits(), many.to_bits()].contains(&value.to_bits()),
                                "{}: {scene}, {}: {value}, of one ray {few}, of nine {many}",
                                backend.name(),
                                refined.name
                            );
                        }
                    }
                }
                let changed = changed.iter().filter(|&&changed| changed).count() as u64;
                let told = refined.statistics.refined_pixels.expect("the statistics tell it");
                println!("{}: {scene}, {lights} lights: {changed} pixels changed, {told} refined", backend.name());
                assert!(changed > 20 && changed <= told && told < u64::from(EDGE * EDGE) / 2, "{changed} of {told}");
            }
        }
    }
    Ok(())
}

/// Root mean square of the difference of displayed radiance from a picture of 64 rays a pixel.
fn error(frame: &Frame, reference: &Frame) -> f64 {
    let scale = (reference.width / frame.width) as usize;
    let (width, wide) = (frame.width as usize, reference.width as usize);
    let mut sum = 0.0;
    for channel in ["R", "G", "B"] {
        let shown = frame.channel("color", channel).expect("radiance is an output");
        let exact = reference.channel("color", channel).expect("radiance is an output");
        for (pixel, &value) in shown.iter().enumerate() {
            let (x, y) = (pixel % width * scale, pixel / width * scale);
            let within = (0..scale * scale).map(|i| exact[(y + i / scale) * wide + x + i % scale]);
            let mean = within.map(f64::from).sum::<f64>() / (scale * scale) as f64;
            sum += (f64::from(value).min(1.0) - mean.min(1.0)).powi(2);
        }
    }
    (sum / (3 * width * width) as f64).sqrt()
}

/// Edges of one ray are off by their whole contrast; nine rays leave a third of that, and what is not refined hardly counts.
#[test]
fn refined_pictures_are_nearer_to_those_of_many_rays() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let settings = ["film.refinement=3", "film.refinement_budget=100"];
    for (scene, most) in [("head", 0.45), ("glass", 0.55)] {
        let reference = picture(scene, 4 * EDGE, &["film.supersampling=2"], |_| {}, &mut cpu)?;
        let one = error(&picture(scene, EDGE, &[], |_| {}, &mut cpu)?, &reference);
        let refined = error(&picture(scene, EDGE, &settings, |_| {}, &mut cpu)?, &reference);
        println!("{scene}: {one:.4} with one ray a pixel, {refined:.4} refined, {:.2} of it", refined / one);
        assert!(refined < most * one, "{scene}: {refined} instead of {one}");
    }
    Ok(())
}
