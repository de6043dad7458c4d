//! 10: without absorption the flux through every plane is equal, until light leaves the grid.

use crate::setup::{backends, cube, light_on_planes, refracting};
use vitrum::method::sweep::Sweep;
use vitrum::scene::{IorPoint, Transport};
use vitrum::{Assets, OutputRequest};
use vitrum_conformance::closed_forms::table::{self, larger};

#[test]
fn every_plane_gets_the_same_flux() {
    let volume = cube(64, 2.0, |[x, y, z]| {
        let lens = (x * x + y * y + z * z) / (0.6 * 0.6);
        1.0 + 0.08 * (1.0 - lens).max(0.0)
    });
    let assets = Assets::from(volume.clone());
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for azimuth in [0.0f32, 30.0] {
            let mut scene = refracting(&volume, 128);
            scene.light[0].azimuth = azimuth;
            scene.sweep.light = Transport::Texels;
            scene.sweep.light_margin = 0.3;
            let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend.as_mut())
                .expect("the scene is sound");
            let (mut flux, mut at_plane) = (Vec::new(), Vec::new());
            let last = sweep.planes.count - 1;
            light_on_planes(
                &sweep,
                backend.as_mut(),
                |plane| plane % 16 == 15 || plane == last,
                |plane, light| {
                    flux.push(light.iter().map(|&e| f64::from(e)).sum::<f64>() / light.len() as f64);
                    at_plane.push(plane);
                },
            );
            let expected = f64::from(azimuth.to_radians()).cos();
            println!("{} at {azimuth}°: mean plane irradiance over {expected:.4}: {flux:.4?}", backend.name());
            // The last plane, and each sixteenth of some hundred.
            assert!(flux.len() > 4, "{} planes were looked at", flux.len());
            assert_eq!(at_plane.last(), Some(&last));
            worst = flux.iter().fold(worst, |worst, mean| larger(worst, (mean / expected - 1.0).abs()));
        }
        table::FLUX_TEXELS.hold(worst, backend.as_ref());
    }
}

/// Behind a focus light of several directions crosses a texel that can carry one: what the sweep shows there is not right, but it must
/// not be more light than there was.
#[test]
fn behind_a_focus_there_is_no_more_light_than_before() {
    let mut backend = vitrum::backend::CpuBackend::new(None).expect("the CPU backend opens");
    let mut most = 0.0f64;
    // Light of a ball of high index, on many texels a voxel, was once created behind its focus: almost as much again as there was.
    for (name, resolution, ior) in [("ball", 48, 1.5), ("glass", 64, 1.33), ("ball", 32, 2.4)] {
        for absorbs in [false, true] {
            let mut scene = vitrum::builtin::scene(name).expect("the scene exists");
            scene.sweep.light = Transport::Texels;
            // The narrower the texels, the more a map of points that light comes from folds.
            scene.film.width = if ior > 2.0 { 160 } else { 110 };
            scene.film.height = scene.film.width;
            scene.volume.resolution = Some(resolution);
            scene.sweep.light = Transport::Texels;
            if name == "ball" {
                scene.transfer.ior = vec![IorPoint::new(0.0, 1.0), IorPoint::new(1.0, ior)];
            }
            if !absorbs {
                scene.transfer.filter.clear();
            }
            let assets = Assets::load(&scene, std::path::Path::new("")).expect("the scene loads");
            let softnesses: &[f32] = if absorbs { &[0.5] } else { &[0.0, 0.25, 1.0, 2.0] };
            for &softness in softnesses {
                for distance in [0.5, 1.0, 2.0] {
                    scene.light[0].angular_radius = softness;
                    scene.sweep.sample_distance = distance;
                    let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), &mut backend)
                        .expect("the scene is sound");
                    let mut first = None;
                    let mut of_these = 0.0f64;
                    light_on_planes(
                        &sweep,
                        &mut backend,
                        |_| true,
                        |_, light| {
                            let flux = light.iter().map(|&e| f64::from(e)).sum::<f64>();
                            assert!(flux.is_finite());
                            of_these = of_these.max(flux / *first.get_or_insert(flux));
                        },
                    );
                    println!(
                        "{name} of index {ior}, {softness}°, planes every {distance} voxels: at most {of_these:.5}"
                    );
                    most = most.max(of_these);
                }
            }
        }
    }
    // Shares of a cell add up to 1 but for rounding: plane by plane it may add up to a millionth.
    table::FLUX_FOCUS.hold((most - 1.0 - 1e-6).max(0.0), &backend);
}

/// Light that is carried forward keeps it through a focus and behind it.
#[test]
fn all_light_is_carried_forward_through_a_focus() {
    let volume = cube(48, 2.0, |[x, y, z]| 1.0 + 0.3 * (1.0 - (x * x + y * y + z * z) / 0.5).max(0.0));
    let assets = Assets::from(volume.clone());
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for azimuth in [0.0f32, 30.0] {
            let mut scene = refracting(&volume, 96);
            scene.sweep.light = Transport::Forward;
            scene.light[0].azimuth = azimuth;
            let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend.as_mut())
                .expect("the scene is sound");
            let (mut brightest, mut first) = (0.0f32, None);
            let planes = sweep.light_planes();
            let middle = 0.5 * (planes.volume_depths[0] + planes.volume_depths[1]);
            light_on_planes(
                &sweep,
                backend.as_mut(),
                // Farther behind, light leaves the grid.
                |plane| planes.depth(plane) < middle + 1.5,
                |_, light| {
                    let flux = light.iter().map(|&e| f64::from(e)).sum::<f64>();
                    brightest = light.iter().copied().fold(brightest, f32::max);
                    worst = larger(worst, (flux / *first.get_or_insert(flux) - 1.0).abs());
                },
            );
            println!("{} at {azimuth}°: brightest {brightest:.1}", backend.name());
            assert!(brightest > 20.0, "{brightest}: there should be a focus");
        }
        // Each part of each cell is rounded to 2⁻²⁴ of a texel's light.
        table::FLUX_FORWARD.hold(worst, backend.as_ref());
    }
}
