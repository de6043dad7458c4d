//! A ball: Snell's law at two surfaces in closed form.

use super::on_both;
use vitrum::backend::CpuBackend;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{Traced, ball, case, through_ball, trace};
use vitrum_conformance::{Failure, adapter};

const PARALLEL: [&str; 3] = ["camera.projection=orthographic", "camera.azimuth=0", "camera.elevation=0"];

fn rays(settings: &[&str], backend: &mut dyn vitrum::backend::Backend) -> Result<Vec<Traced>, Failure> {
    let case = case("ball", ball(256), 64, &[&PARALLEL[..], settings].concat())?;
    trace(&case, backend)
}

fn height(ray: &Traced) -> f64 {
    (ray.from - ray.towards * ray.from.dot(ray.towards)).length()
}

/// The angles by which rays within `h` of the middle miss the direction that Snell's law gives them, in degrees, in order.
fn errors(rays: &[Traced], h: f64) -> Vec<f64> {
    let inner = rays.iter().filter(|ray| height(ray) < h);
    let error = |ray: &Traced| {
        let [_, expected] = through_ball(ray.from, ray.towards, 1.5).expect("the ray meets the ball");
        ray.direction.angle_between(expected).to_degrees()
    };
    let mut errors: Vec<f64> = inner.map(error).collect();
    errors.sort_by(f64::total_cmp);
    errors
}

/// The point at which rays cross the axis behind a ball lens of radius 1 and index 1.5, by the height at which they meet it.
#[test]
fn a_ball_lens_focuses() -> Result<(), Failure> {
    let truth = [(0.1, 1.4958), (0.25, 1.4737), (0.5, 1.3916), (0.75, 1.2410), (0.9, 1.1044)];
    for (settings, of_crossing) in
        [("voxels.surfaces=exact", table::LENS_EXACT), ("voxelization.resolution=256", table::LENS_VOXELS)]
    {
        on_both(|backend| {
            let mut worst = 0.0;
            let rays = rays(&[settings], backend)?;
            for (h, expected) in truth {
                // The mean over the rays near that height.
                let near: Vec<f64> = rays
                    .iter()
                    .filter(|ray| (height(ray) - h).abs() < 0.02)
                    .map(|ray| {
                        let away = ray.left - ray.towards * ray.left.dot(ray.towards);
                        let across = ray.direction - ray.towards * ray.direction.dot(ray.towards);
                        let distance = -away.dot(across) / across.length_squared();
                        ray.left.dot(ray.towards) + distance * ray.direction.dot(ray.towards)
                    })
                    .collect();
                assert!(near.len() > 3, "{} rays at {h}", near.len());
                let mean = near.iter().sum::<f64>() / near.len() as f64;
                // Heights are 0.02 to either side, over which the crossing changes by up to 0.03.
                worst = larger(worst, (mean / expected - 1.0).abs());
            }
            of_crossing.hold(worst, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// The triangles' rays are off by what a ball of triangles is; those of voxels converge.
#[test]
fn directions_converge_with_the_resolution() -> Result<(), Failure> {
    let mut cpu = CpuBackend::new(None)?;
    let exact = errors(&rays(&["voxels.surfaces=exact"], &mut cpu)?, 0.95);
    table::LENS_DIRECTIONS.hold(exact[exact.len() * 99 / 100], &cpu);
    let mut before = f64::INFINITY;
    // From 64 voxels on what is left is the triangles' own: their normals are off by up to 0.35°.
    for resolution in [16, 32, 64, 128, 256] {
        let setting = format!("voxelization.resolution={resolution}");
        let found = errors(&rays(&[&setting], &mut cpu)?, 0.95);
        let median = found[found.len() / 2];
        println!("{resolution}: median {median:.3}°, 95 % below {:.3}°", found[found.len() * 95 / 100]);
        assert!(median < (0.5 * before).max(0.2), "{resolution}: {median}° behind {before}°");
        before = median;
        // The paper's do worse, though each is the mean of exact normals: they are those of a voxel's middle.
        let paper = errors(&rays(&[&setting, "voxels.normals=paper"], &mut cpu)?, 0.95);
        println!("paper: {:.3}°", paper[paper.len() / 2]);
        assert!(paper[paper.len() / 2] > median, "{resolution}: {}", paper[paper.len() / 2]);
    }
    Ok(())
}

/// Transmittance of the two surfaces of a ball of index 1.5 for a ray at height `h`: (1 − F)², since it meets both at the same angles.
fn let_through(h: f64) -> f64 {
    let (outside, inside) = ((1.0 - h * h).sqrt(), (1.0 - (h / 1.5).powi(2)).sqrt());
    let across = (outside - 1.5 * inside) / (outside + 1.5 * inside);
    let along = (1.5 * outside - inside) / (1.5 * outside + inside);
    (1.0 - 0.5 * (across * across + along * along)).powi(2)
}

#[test]
fn less_light_is_left_at_the_rim() -> Result<(), Failure> {
    assert!((let_through(0.0) - 0.9216).abs() < 1e-12 && (let_through(0.9) - 0.7847).abs() < 1e-4);
    on_both(|backend| {
        let rays = rays(&["voxels.surfaces=exact"], backend)?;
        let inner: Vec<_> = rays.iter().filter(|ray| height(ray) < 0.97).collect();
        assert!(inner.len() > 1000 && inner.iter().any(|ray| height(ray) > 0.96), "{} rays", inner.len());
        for ray in inner {
            let (h, found) = (height(ray), ray.transmittance);
            let expected = let_through(h);
            // Normals between corners are those of the ball, but triangles lie within it: by an eighth of the square of their longest
            // edge, √2 π / 256, in the middle. A ray meets them at the angle that belongs to a height so much greater.
            let bound = 2.0 * (expected - let_through(h * (1.0 + 3.8e-5))) + 1e-6;
            assert!((found - expected).abs() < bound, "h = {h}: {found}, expected {expected} ± {bound}");
        }
        Ok(())
    })
}

/// Lanes that a block does not fill, and every ray of a picture: the same bits.
#[test]
fn backends_agree_on_every_ray() -> Result<(), Failure> {
    let Some(mut gpu) = adapter::exact_for_test() else { return Ok(()) };
    let mut cpu = CpuBackend::new(None)?;
    for surfaces in ["two", "multi", "exact"] {
        let surfaces = format!("voxels.surfaces={surfaces}");
        let case = case("ball", ball(96), 53, &[&surfaces, "voxelization.resolution=96"])?;
        let (expected, found) = (trace(&case, &mut cpu)?, trace(&case, &mut gpu)?);
        for (expected, found) in expected.iter().zip(&found) {
            assert_eq!((expected.left, expected.direction), (found.left, found.direction), "{surfaces}");
            assert_eq!((expected.transmittance, expected.bounces), (found.transmittance, found.bounces), "{surfaces}");
        }
    }
    Ok(())
}
