//! Opaque matter that shades itself: what is seen of it does not depend on where planes and samples of light lie.

use crate::setup::{backends, cube, render, straight_on};
use vitrum::io::{Volume, Voxels};
use vitrum::scene::{Clip, OpacityPoint, Scene};
use vitrum_conformance::closed_forms::table::{self, larger};

/// Voxels along an edge.
const VOXELS: u32 = 48;
/// Opacity of a layer one voxel thick.
const OPACITY: f32 = 0.95;

/// Parallel viewing rays along −y, and light from 60° on the right of them.
pub(crate) fn lit_from_the_side(points: &[(f32, f32)], pixels: u32) -> Scene {
    let mut scene = straight_on(pixels);
    scene.environment.visible = false;
    scene.light[0].azimuth = 60.0;
    scene.shading.specular = 0.0;
    scene.transfer.opacity = points.iter().map(|&(value, opacity)| OpacityPoint { value, opacity }).collect();
    scene
}

/// A ball whose scalar falls over `thickness` voxels.
pub(crate) fn ball(thickness: f64) -> Volume {
    let voxel = 2.0 / f64::from(VOXELS);
    cube(VOXELS, 2.0, |at| {
        let radius = at.iter().map(|x| x * x).sum::<f64>().sqrt();
        ((0.75 - radius) / (thickness * voxel) + 0.5).clamp(0.0, 1.0)
    })
}

/// The scalar of a volume between its voxels, in voxels from the middle.
pub(crate) fn scalar(volume: &Volume, at: [f64; 3]) -> f64 {
    let places = at.map(|x| x + (f64::from(VOXELS) - 1.0) * 0.5);
    if places.iter().any(|&x| !(0.0..=f64::from(VOXELS) - 1.0).contains(&x)) {
        return 0.0;
    }
    let low = places.map(|x| x.floor().min(f64::from(VOXELS) - 2.0));
    let mut sum = 0.0;
    for corner in 0..8_usize {
        let mut weight = 1.0;
        let mut index = 0;
        for axis in (0..3).rev() {
            let far = corner >> axis & 1;
            let fraction = places[axis] - low[axis];
            weight *= if far == 1 { fraction } else { 1.0 - fraction };
            index = index * VOXELS as usize + low[axis] as usize + far;
        }
        let Voxels::F32(voxels) = &volume.voxels else { unreachable!("the ball has floats") };
        sum += weight * f64::from(voxels[index]);
    }
    sum
}

/// The radiance of a pixel's ray, finely in double precision: ∫ τ e^(−∫τ) e^(−∫τ along the light) dt, per voxel edge. The ray starts at (x, z) voxels to the left
/// and above the middle.
fn radiance(volume: &Volume, [low, high]: [f64; 2], [x, z]: [f64; 2]) -> f64 {
    let extinction = |at: [f64; 3]| {
        let share = ((scalar(volume, at) - low) / (high - low)).clamp(0.0, 1.0);
        -(1.0 - f64::from(OPACITY) * share).ln()
    };
    let (step, light_step) = (1.0 / 32.0, 1.0 / 8.0);
    // To the light: from the right, which is −x, and from the camera, which is at +y.
    let towards = [-60.0f64.to_radians().sin(), 60.0f64.to_radians().cos(), 0.0];
    let (mut clear, mut seen) = (1.0f64, 0.0);
    let mut along = 24.0;
    while along > -24.0 && clear > 1e-4 {
        along -= step;
        let at = [x, along + 0.5 * step, z];
        let depth = extinction(at) * step;
        if depth > 0.0 {
            let shadow: f64 = (0..400)
                .map(|i| {
                    let far = (f64::from(i) + 0.5) * light_step;
                    extinction(std::array::from_fn(|axis| at[axis] + towards[axis] * far)) * light_step
                })
                .sum();
            let opacity = 1.0 - (-depth).exp();
            seen += clear * opacity * (-shadow).exp();
            clear *= 1.0 - opacity;
        }
    }
    seen
}

/// The largest and the root mean square error along the middle row of a picture of a ball, where it is lit, over the mean radiance there.
fn errors(volume: &Volume, ramp: [f64; 2], backend: &mut dyn vitrum::backend::Backend) -> [f64; 2] {
    let points = [(ramp[0] as f32, 0.0), (ramp[1] as f32, OPACITY)];
    let pixels = 129;
    let mut scene = lit_from_the_side(&points, pixels);
    // Voxels a pixel: the picture shows 0.87 radii of the cube's bounding sphere on either side, see `orthographic_frame`.
    let (half, _) = vitrum_conformance::closed_forms::orthographic_frame(f64::from(VOXELS));
    scene.camera.zoom = 1.0;
    let frame = render(&scene, volume, backend);
    let row = &frame.channel("color", "R").expect("color")[(pixels / 2 * pixels) as usize..][..pixels as usize];
    let mut all = Vec::new();
    for pixel in 0..pixels {
        // In the picture x points left.
        let right = ((f64::from(pixel) + 0.5) / f64::from(pixels) * 2.0 - 1.0) * half;
        all.push([radiance(volume, ramp, [-right, 0.0]), f64::from(row[pixel as usize])]);
    }
    let brightest = all.iter().fold(0.0, |most, [expected, _]| larger(most, *expected));
    let lit: Vec<[f64; 2]> = all.into_iter().filter(|[expected, _]| *expected > 0.3 * brightest).collect();
    let mean = lit.iter().map(|[expected, _]| expected).sum::<f64>() / lit.len() as f64;
    let square = lit.iter().map(|[expected, found]| (found - expected).powi(2)).sum::<f64>() / lit.len() as f64;
    let bias = lit.iter().map(|[expected, found]| found - expected).sum::<f64>() / lit.len() as f64;
    println!("{}: root mean square {:.4}, mean {:.4}", backend.name(), square.sqrt() / mean, bias / mean);
    [bias.abs() / mean, square.sqrt() / mean]
}

#[test]
fn a_ball_shades_itself_smoothly() {
    for mut backend in backends() {
        // Extinction that rises over four voxels, and a ramp of opacity over four tenths of a voxel, as presets for bone have it.
        let [bias, square] = errors(&ball(4.0), [0.0, 1.0], backend.as_mut());
        table::MATTER_SOFT_MEAN.hold(bias, backend.as_ref());
        table::MATTER_SOFT.hold(square, backend.as_ref());
        let [bias, square] = errors(&ball(4.0), [0.45, 0.55], backend.as_mut());
        table::MATTER_STEEP_MEAN.hold(bias, backend.as_ref());
        table::MATTER_STEEP.hold(square, backend.as_ref());
    }
}

/// Opaque everywhere, but for one voxel, which makes a range.
fn block() -> Volume {
    let voxel = 2.0 / f64::from(VOXELS);
    let corner = 1.0 - voxel;
    cube(VOXELS, 2.0, |at| if at.iter().all(|x| *x > corner) { 0.0 } else { 1.0 })
}

#[test]
fn a_cut_is_as_bright_wherever_it_lies_between_planes() {
    // Of a half-space that single scattering lights, cos θ / (cos θ + cos θᵥ) of the light is seen (Seeliger's law).
    let volume = block();
    let expected = 0.5 / 1.5;
    for mut backend in backends() {
        let mut worst = 0.0f64;
        for sample_distance in [1.0, 0.5] {
            for tenths in 0..10 {
                let mut scene = lit_from_the_side(&[(0.0, 0.0), (1.0, OPACITY)], 9);
                scene.sweep.sample_distance = sample_distance;
                let offset = 0.013 * tenths as f32 * 2.0 / 3.0;
                scene.clip = vec![Clip { normal: [0.0, 1.0, 0.0], offset, ..Clip::default() }];
                let frame = render(&scene, &volume, backend.as_mut());
                let found = f64::from(frame.channel("color", "R").expect("color")[4 * 9 + 4]);
                println!("{}: {found:.4} for {expected:.4} at {sample_distance}, {offset}", backend.name());
                worst = larger(worst, (found / expected - 1.0).abs());
            }
        }
        table::MATTER_CUT.hold(worst, backend.as_ref());
    }
}

#[test]
fn without_shadows_matter_is_shaded_by_its_gradient() {
    // An opaque ball: Lambert's cosine between the light and the normal, which is the way from the middle.
    let volume = ball(4.0);
    let pixels = 65;
    let mut scene = lit_from_the_side(&[(0.4, 0.0), (0.6, OPACITY)], pixels);
    scene.light[0].shadows = false;
    let (half, _) = vitrum_conformance::closed_forms::orthographic_frame(2.0);
    for mut backend in backends() {
        let frame = render(&scene, &volume, backend.as_mut());
        let color = frame.channel("color", "R").expect("color");
        let mut worst = 0.0f64;
        for pixel in 0..pixels {
            let right = ((f64::from(pixel) + 0.5) / f64::from(pixels) * 2.0 - 1.0) * half / 0.75;
            if right.abs() < 0.9 {
                let towards = (1.0 - right * right).sqrt();
                let cosine = right * 60.0f64.to_radians().sin() + towards * 60.0f64.to_radians().cos();
                let found = f64::from(color[(pixels / 2 * pixels + pixel) as usize]);
                worst = larger(worst, (found - cosine.max(0.0)).abs());
            }
        }
        table::MATTER_GRADIENT.hold(worst, backend.as_ref());
        // Of what is asked for alone the light tells.
        let mut flat = scene.clone();
        flat.shading.diffuse = Some(vitrum::scene::Diffuse::Light);
        let frame = render(&flat, &volume, backend.as_mut());
        let middle = frame.channel("color", "R").expect("color")[(pixels / 2 * pixels + pixels / 2) as usize];
        assert!((middle - 1.0).abs() < 2e-3, "unshaded white matter: {middle}");
    }
}
