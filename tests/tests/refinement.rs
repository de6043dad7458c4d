//! Pixels that differ from their neighbours get more rays, large pictures come in parts, and nothing else changes.

use vitrum::backend::{Backend, CpuBackend};
use vitrum::scene::Light;
use vitrum::{Frame, Layers, OutputRequest, Renderer, render};
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

/// The bits of all of a frame's outputs.
fn bits(frame: &Frame) -> Vec<(String, Vec<u32>)> {
    let light = frame.light.iter().flat_map(|light| &light.layers);
    let channels = frame.layers.iter().chain(light).flat_map(|layer| {
        layer.channels.iter().map(|channel| (format!("{} {}", layer.name, channel.name), &channel.data))
    });
    channels.map(|(name, data)| (name, data.iter().map(|value| value.to_bits()).collect())).collect()
}

/// A picture in parts of a few rays has the bits of the picture in one, whatever rays beside one another have in common: directions that tell how much of
/// an environment a pixel sees, pixels of several rays, lights and wavelengths, volumes that are streamed, the light as an output. Light is carried once.
#[test]
fn parts_make_the_whole_picture() -> Result<(), Failure> {
    let environment = &["environment.kind=checkerboard", "environment.visible=true"][..];
    for (scene, settings) in [
        ("ball", &[environment, &["film.refinement=3"]].concat()[..]),
        ("phantom", &["film.supersampling=2", "sweep.refraction=false"]),
        ("prism", &["film.supersampling=2"]),
        ("phantom", &["shading.blend_mode=maximum"]),
    ] {
        let mut case = Case::builtin(scene, EDGE, Some(32), settings)?;
        case.scene.film.height = EDGE - 5;
        let other = Light { azimuth: 20.0, ..case.scene.light[0].clone() };
        if scene == "phantom" {
            case.scene.light.push(other);
        }
        for backend in adapter::backends_for_test()? {
            let name = backend.name();
            let mut renderer = Renderer::new(backend, case.assets.clone());
            let mut with = |rays_at_once: u32| {
                let request = OutputRequest { rays_at_once, ..OutputRequest::default() };
                renderer.render(&case.scene, request, &mut |_| true)
            };
            let (parted, whole) = (with(600)?, with(u32::MAX)?);
            assert!(bits(&parted) == bits(&whole), "{name}: {scene}, {settings:?}");
            let told = |frame: &Frame| (frame.statistics.rays_terminated, frame.statistics.refined_pixels);
            assert_eq!(told(&parted), told(&whole), "{name}: {scene}");
            for kernel in &parted.statistics.kernels {
                let is_of_light = kernel.kernel.contains("advance_nodes");
                let lights = case.scene.light.len() as u32 * case.scene.sweep.wavelengths;
                let planes = 2 * 3 * parted.statistics.planes.unwrap_or_default();
                assert!(!is_of_light || kernel.passes <= lights * planes, "{kernel:?}: light was carried again");
            }
        }
    }
    Ok(())
}

/// A streamed volume's picture in parts is that in one, and the light that was carried for it stays.
#[test]
fn parts_of_a_streamed_volume_make_the_whole_picture() -> Result<(), Failure> {
    let settings = ["sweep.sample_distance=4", "sweep.follow_turned_rays=false", "camera.azimuth=37"];
    let case = Case::builtin("phantom", EDGE, Some(128), &settings)?;
    let mut pictures = Vec::new();
    for (limit, rays_at_once) in [(None, u32::MAX), (Some(case.volume().bytes() as u64 - 1), 600)] {
        let mut cpu = CpuBackend::new(None)?;
        cpu.set_volume_limit(limit);
        let mut renderer = Renderer::new(Box::new(cpu), case.assets.clone());
        let request = OutputRequest { light: false, rays_at_once, ..OutputRequest::default() };
        let frame = renderer.render(&case.scene, request, &mut |_| true)?;
        let light = frame.statistics.kernels.iter().filter(|kernel| kernel.kernel.contains("advance_nodes"));
        pictures.push((bits(&frame), light.map(|kernel| kernel.passes).sum::<u32>()));
    }
    assert!(pictures[0].0 == pictures[1].0, "the pictures differ");
    assert_eq!(pictures[0].1, pictures[1].1, "passes of light, whole and in parts");
    Ok(())
}

/// A frame has the outputs that are asked for, with the values that it has with all.
#[test]
fn outputs_that_are_not_asked_for_cost_nothing() -> Result<(), Failure> {
    let case = Case::builtin("ball", EDGE, Some(32), &["film.refinement=3", "background=white"])?;
    let mut renderer = Renderer::new(Box::new(CpuBackend::new(None)?), case.assets.clone());
    let mut with = |layers| {
        let request = OutputRequest { light: false, layers, ..OutputRequest::default() };
        renderer.render(&case.scene, request, &mut |_| true)
    };
    let (all, few) = (with(Layers::ALL)?, with(Layers::color().with("depth"))?);
    for layer in &few.layers {
        assert_eq!(Some(layer), all.layers.iter().find(|other| other.name == layer.name), "{}", layer.name);
    }
    let names: Vec<&str> = few.layers.iter().map(|layer| layer.name.as_str()).collect();
    // What is behind shines through clear matter in its colour.
    assert_eq!(names, ["color", "transmittance", "depth"]);
    Ok(())
}
