//! 10: without absorption the flux through every plane is equal, until light leaves the grid.

use crate::setup::{backends, cube, refracting};
use vitrum::Inputs;
use vitrum::method::sweep::Sweep;

#[test]
fn every_plane_gets_the_same_flux() {
    let volume = cube(64, 2.0, |[x, y, z]| {
        let lens = (x * x + y * y + z * z) / (0.6 * 0.6);
        1.0 + 0.08 * (1.0 - lens).max(0.0)
    });
    for azimuth in [0.0f32, 30.0] {
        let mut scene = refracting(&volume, 128);
        scene.light.azimuth = azimuth;
        scene.light.margin = 0.3;
        let inputs = Inputs { volume: volume.clone(), ior_volume: None, environment: None };
        for mut backend in backends() {
            let mut sweep = Sweep::prepare(&scene, &inputs, backend.as_mut()).expect("the scene is sound");
            let all = std::mem::take(&mut sweep.passes.passes);
            let texels = (sweep.light_grid.size[0] * sweep.light_grid.size[1]) as usize;
            let mut flux = Vec::new();
            let (mut plane, mut at_plane) = (0, Vec::new());
            for pass in all {
                let name = pass.kernel.declaration.name;
                sweep.passes.passes.push(pass);
                if name == "sweep_concentrate_light" {
                    plane += 1;
                    if plane % 16 == 0 || plane == sweep.planes.count - 1 {
                        sweep.run(backend.as_mut(), &mut |_| true).expect("the passes run");
                        sweep.passes.passes.clear();
                        let records = sweep.irradiance(backend.as_mut()).expect("the light can be read");
                        flux.push(records[..texels].iter().map(|&e| f64::from(e)).sum::<f64>() / texels as f64);
                        at_plane.push(plane);
                    }
                }
            }
            let expected = f64::from(azimuth.to_radians()).cos();
            println!("{} at {azimuth}°: mean plane irradiance over {expected:.4}: {flux:.4?}", backend.name());
            for (mean, plane) in flux.iter().zip(at_plane) {
                assert!((mean / expected - 1.0).abs() < 5e-3, "plane {plane}: {mean} instead of {expected}");
            }
            sweep.free(backend.as_mut());
        }
    }
}

/// Behind a focus several sheets of light cross a texel that can carry one: what the sweep shows there is not right, but it must
/// not be more light than there was.
#[test]
fn behind_a_focus_there_is_no_more_light_than_before() {
    for name in ["glass", "ball"] {
        let mut scene = vitrum::builtin::scene(name).expect("the scene exists");
        (scene.film.width, scene.film.height) = (300, 300);
        let inputs = Inputs::load(&scene, std::path::Path::new("")).expect("the scene loads");
        let mut backend = vitrum::backend::CpuBackend::new(None).expect("the CPU backend opens");
        let mut sweep = Sweep::prepare(&scene, &inputs, &mut backend).expect("the scene is sound");
        let all = std::mem::take(&mut sweep.passes.passes);
        let texels = (sweep.light_grid.size[0] * sweep.light_grid.size[1]) as usize;
        let mut first = None;
        let mut most = 0.0f64;
        for pass in all {
            let name = pass.kernel.declaration.name;
            sweep.passes.passes.push(pass);
            if name == "sweep_concentrate_light" {
                sweep.run(&mut backend, &mut |_| true).expect("the passes run");
                sweep.passes.passes.clear();
                let light = sweep.irradiance(&mut backend).expect("the light can be read");
                let flux = light[..texels].iter().map(|&e| f64::from(e)).sum::<f64>();
                assert!(flux.is_finite());
                most = most.max(flux / *first.get_or_insert(flux));
            }
        }
        println!("{name}: at most {most:.4} of the light");
        // A focus is a few texels wide; differences between texels cannot tell its area to better than some percent.
        assert!(most < 1.02, "{most} of the light at some plane");
        sweep.free(&mut backend);
    }
}
