//! Isosurfaces: what they take of light and of viewing rays, where they lie, and how they are lit, whatever the sample distance and the slope of the scalar.

use crate::matter::{ball, lit_from_the_side, scalar};
use crate::setup::{backends, cube, light_on_planes, render};
use vitrum::io::Volume;
use vitrum::method::sweep::Sweep;
use vitrum::scene::{Clip, Diffuse, IorPoint, Isosurface, Projection, Scene};
use vitrum::{Assets, OutputRequest};
use vitrum_conformance::closed_forms::orthographic_frame;
use vitrum_conformance::closed_forms::table::{self, larger};

/// Radius of the ball where its scalar is ½.
const RADIUS: f64 = 0.75;
/// Edge of a voxel.
const VOXEL: f64 = 2.0 / 48.0;

/// Parallel viewing rays along −y, light from `azimuth` degrees on the right of them, and nothing but isosurfaces of these values and opacities.
fn showing(surfaces: &[(f32, f32)], pixels: u32, azimuth: f32) -> Scene {
    let mut scene = lit_from_the_side(&[], pixels);
    scene.light[0].azimuth = azimuth;
    scene.isosurface =
        surfaces.iter().map(|&(value, opacity)| Isosurface { opacity, ..Isosurface::new(value) }).collect();
    scene
}

/// The pixels of a picture, each with its place right of the middle and above it, world units.
fn places(pixels: u32) -> impl Iterator<Item = (usize, [f64; 2])> {
    let (half, _) = orthographic_frame(2.0);
    let at = move |index: u32| ((f64::from(index) + 0.5) / f64::from(pixels) * 2.0 - 1.0) * half;
    (0..pixels * pixels).map(move |index| (index as usize, [at(index % pixels), -at(index / pixels)]))
}

#[test]
fn each_crossing_takes_the_same_share() {
    let pixels = 33;
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for thickness in [4.0, 12.0] {
            let volume = ball(thickness);
            // Where the scalar is 0.8.
            let inner = RADIUS - 0.3 * thickness * VOXEL;
            for (sample_distance, azimuth) in [(1.0, 0.0), (0.5, 30.0), (0.25, 0.0)] {
                let mut scene = showing(&[(0.8, 0.5), (0.5, 0.3)], pixels, 60.0);
                scene.sweep.sample_distance = sample_distance;
                // Opacity does not depend on light.
                scene.sweep.light_cells = Some(8);
                scene.camera.azimuth = azimuth;
                let frame = render(&scene, &volume, backend.as_mut());
                let opacity = frame.channel("opacity", "Y").expect("opacity");
                for (index, [right, up]) in places(pixels) {
                    let radius = right.hypot(up);
                    if (radius - RADIUS).abs() > 0.05 && (radius - inner).abs() > 0.05 {
                        let left = if radius < RADIUS { 0.7f64.powi(2) } else { 1.0 };
                        let left = if radius < inner { left * 0.25 } else { left };
                        worst = larger(worst, (f64::from(opacity[index]) - (1.0 - left)).abs());
                    }
                }
            }
        }
        table::ISOSURFACE_OPACITY.hold(worst, backend.as_ref());
    }
}

#[test]
fn a_ray_crosses_what_is_left_of_a_surface() {
    let volume = ball(4.0);
    let middle = 4 * 9 + 4;
    let surface = [(0.5, 0.3)];
    for mut backend in backends() {
        let mut opacity = |scene: &Scene, all: bool| {
            let frame = render(scene, &volume, backend.as_mut());
            let found = frame.channel("opacity", "Y").expect("opacity");
            if all { found.to_vec() } else { vec![found[middle]] }
        };
        let near = |found: &[f32], expected: f32| found.iter().all(|opacity| (opacity - expected).abs() < 1e-5);
        let mut cut = showing(&surface, 9, 60.0);
        cut.clip = vec![Clip { normal: [0.0, 1.0, 0.0], offset: 0.1, ..Clip::default() }];
        assert!(near(&opacity(&cut, false), 0.3));
        let mut inside = showing(&surface, 9, 60.0);
        inside.camera.projection = Projection::Perspective;
        (inside.camera.position, inside.camera.target) = (Some([0.1, 0.05, 0.0]), Some([0.0, -1.0, 0.3]));
        assert!(near(&opacity(&inside, true), 0.3));
        // A surface of glass.
        let mut glass = showing(&surface, 9, 60.0);
        glass.transfer.ior = vec![IorPoint::new(0.4, 1.0), IorPoint::new(0.6, 1.3)];
        assert!(near(&opacity(&glass, false), 0.51));
        // Whether or not bricks without a surface are skipped.
        let scene = showing(&[(0.5, 0.3), (0.9, 1.0)], 33, 60.0);
        let mut all = scene.clone();
        all.sweep.empty_space_skipping = false;
        let [skipping, all] = [scene, all].map(|scene| render(&scene, &volume, backend.as_mut()));
        for (layer, channel) in [("color", "R"), ("opacity", "Y"), ("depth", "Z")] {
            assert_eq!(skipping.channel(layer, channel), all.channel(layer, channel), "{layer}");
        }
    }
}

/// Where a ray along −y first meets the scalar ½, voxels from the middle.
fn met(volume: &Volume, [x, z]: [f64; 2]) -> f64 {
    let (mut outside, mut inside) = (24.0, 0.0);
    for _ in 0..60 {
        let middle = f64::midpoint(outside, inside);
        if scalar(volume, [x, middle, z]) < 0.5 { outside = middle } else { inside = middle }
    }
    inside
}

#[test]
fn an_opaque_surface_is_seen_where_the_scalar_has_its_value() {
    let pixels = 33;
    let (_, depth_of_middle) = orthographic_frame(2.0);
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for thickness in [4.0, 12.0] {
            let volume = ball(thickness);
            let frame = render(&showing(&[(0.5, 1.0)], pixels, 60.0), &volume, backend.as_mut());
            let depth = frame.channel("depth", "Z").expect("depth");
            for (index, [right, up]) in places(pixels).filter(|(_, [right, up])| right.hypot(*up) < 0.9 * RADIUS) {
                let along = met(&volume, [-right, up].map(|at| at / VOXEL));
                let found = (-depth_of_middle - f64::from(depth[index])) / VOXEL;
                worst = larger(worst, (found - along).abs());
            }
        }
        table::ISOSURFACE_DEPTH.hold(worst, backend.as_ref());
    }
}

/// What a stack of surfaces of these opacities sends back: the cosine to the view is `ratio` of that to the light, which comes from the same side.
fn sent_back(opacities: &[f64], ratio: f64) -> f64 {
    let mut left = 1.0;
    let each = opacities.iter().map(|opacity| {
        let clear = 1.0 - opacity;
        let sent = left * (1.0 - clear.powf(1.0 + ratio)) / (1.0 + ratio);
        left *= clear * clear;
        sent
    });
    each.sum()
}

#[test]
fn surfaces_behind_one_another_are_lit_by_what_is_left() {
    // The scalar rises along the viewing rays.
    let volume = cube(48, 2.0, |[_, y, _]| 0.5 - 0.5 * y);
    for mut backend in backends() {
        let (mut worst, mut worst_near) = (0.0f64, 0.0f64);
        for sample_distance in [1.0, 0.5, 0.25] {
            let mut error = |surfaces: &[(f32, f32)], azimuth: f32, expected: f64| {
                let mut scene = showing(surfaces, 9, azimuth);
                scene.sweep.sample_distance = sample_distance;
                let frame = render(&scene, &volume, backend.as_mut());
                let found = f64::from(frame.channel("color", "R").expect("color")[4 * 9 + 4]);
                println!("{}: {found:.4} for {expected:.4} at {azimuth}°, {sample_distance}", backend.name());
                (found / expected - 1.0).abs()
            };
            for (azimuth, ratio) in [(0.0, 1.0), (60.0, 2.0)] {
                let expected = sent_back(&[0.4, 1.0], ratio);
                worst = larger(worst, error(&[(0.4, 0.4), (0.55, 1.0)], azimuth, expected));
                // Half a voxel apart: samples of the light lie on both sides of the first one.
                worst_near = larger(worst_near, error(&[(0.4, 0.4), (0.41, 1.0)], azimuth, expected));
            }
            // From behind: the light falls towards the viewer as his view does away from him, τ e^(−τ).
            worst = larger(worst, error(&[(0.4, 0.4)], 180.0, -0.6 * 0.6f64.ln()));
        }
        table::ISOSURFACE_LIGHT.hold(worst, backend.as_ref());
        table::ISOSURFACE_LIGHT_NEAR.hold(worst_near, backend.as_ref());
    }
}

#[test]
fn a_surface_throws_the_shadow_of_its_crossings() {
    let assets = Assets::from(ball(4.0));
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for (sample_distance, azimuth) in [(1.0, 30.0), (0.5, 0.0)] {
            let mut scene = showing(&[(0.5, 0.3)], 17, azimuth);
            scene.sweep.sample_distance = sample_distance;
            let sweep = Sweep::prepare(&scene, &assets, OutputRequest::default(), backend.as_mut())
                .expect("the scene is sound");
            let last = sweep.light_planes().count - 1;
            let ([width, _], texel) = (sweep.light_grid.size, sweep.light_grid.texel);
            let size = sweep.light_grid.size.map(f64::from);
            light_on_planes(
                &sweep,
                backend.as_mut(),
                |plane| plane == last,
                |_, light| {
                    for (index, &found) in (0..).zip(light) {
                        let at = |index: u32, count: f64| (f64::from(index) + 0.5 - 0.5 * count) * texel;
                        let radius = at(index % width, size[0]).hypot(at(index / width, size[1]));
                        if (radius - RADIUS).abs() > 0.06 {
                            let expected = if radius < RADIUS { 0.49 } else { 1.0 };
                            worst = larger(worst, (f64::from(found) - expected).abs());
                        }
                    }
                },
            );
        }
        table::ISOSURFACE_SHADOW.hold(worst, backend.as_ref());
    }
}

#[test]
fn an_opaque_surface_is_shaded_as_a_steep_ramp_of_opacity() {
    // Seeliger's law: cos θ / (cos θ + cos θᵥ).
    let pixels = 65;
    for mut backend in backends() {
        let (mut bias, mut square) = (0.0f64, 0.0f64);
        for thickness in [4.0, 12.0] {
            let frame = render(&showing(&[(0.5, 1.0)], pixels, 60.0), &ball(thickness), backend.as_mut());
            let color = frame.channel("color", "R").expect("color");
            let mut all = Vec::new();
            for (index, [right, up]) in places(pixels) {
                let [right, up] = [right / RADIUS, up / RADIUS];
                let towards = (1.0 - right * right - up * up).max(0.0).sqrt();
                let cosine = right * 60.0f64.to_radians().sin() + towards * 60.0f64.to_radians().cos();
                if towards > 0.3 && cosine > 0.2 {
                    all.push([cosine / (cosine + towards), f64::from(color[index])]);
                }
            }
            let count = all.len() as f64;
            let mean = all.iter().map(|[expected, _]| expected).sum::<f64>() / count;
            let off = all.iter().map(|[expected, found]| found - expected).sum::<f64>() / count / mean;
            let squares = all.iter().map(|[expected, found]| (found - expected).powi(2)).sum::<f64>() / count;
            println!("{}: mean {off:.4}, root mean square {:.4}", backend.name(), squares.sqrt() / mean);
            (bias, square) = (larger(bias, off.abs()), larger(square, squares.sqrt() / mean));
        }
        table::ISOSURFACE_SHADING_MEAN.hold(bias, backend.as_ref());
        table::ISOSURFACE_SHADING.hold(square, backend.as_ref());
    }
}

#[test]
fn without_shadows_a_surface_is_shaded_by_its_gradient() {
    let pixels = 33;
    let mut scene = showing(&[(0.5, 1.0)], pixels, 60.0);
    scene.light[0].shadows = false;
    for mut backend in backends() {
        let frame = render(&scene, &ball(12.0), backend.as_mut());
        let color = frame.channel("color", "R").expect("color");
        let mut worst = 0.0f64;
        for (index, [right, up]) in places(pixels) {
            let [right, up] = [right / RADIUS, up / RADIUS];
            if right.hypot(up) < 0.9 {
                let towards = (1.0 - right * right - up * up).sqrt();
                let cosine = right * 60.0f64.to_radians().sin() + towards * 60.0f64.to_radians().cos();
                worst = larger(worst, (f64::from(color[index]) - cosine.max(0.0)).abs());
            }
        }
        table::ISOSURFACE_GRADIENT.hold(worst, backend.as_ref());
        let mut flat = scene.clone();
        flat.shading.diffuse = Some(Diffuse::Light);
        let frame = render(&flat, &ball(12.0), backend.as_mut());
        let middle = frame.channel("color", "R").expect("color")[(pixels * pixels / 2) as usize];
        assert!((middle - 1.0).abs() < 1e-5, "an unshaded white surface: {middle}");
    }
}
