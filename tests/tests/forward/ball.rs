//! A ball lens of index 1.5: the flux through discs of a wall behind its focus, against rays through the formula of its soft surface.

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::on_both;
use crate::shot::{Shot, vector};
use vitrum_conformance::rays::{Left, follow, follow_towards};

pub const IOR: f64 = 1.5;
const EDGE: f64 = 2.4;
const VOXELS: u32 = 64;
/// The depth of the surface, from the index of one side to that of the other: five voxels.
const SURFACE: f64 = 5.0 * EDGE / VOXELS as f64;
/// The wall's distance behind the centre; the focus of rays near the axis is at 1.5.
pub const WALL: f64 = 2.5;
/// The view's azimuth: from the side, so that no viewing ray of interest goes through the ball.
const AZIMUTH: f64 = 60.0;
/// Rays of the reference over the largest disc, each for an equal area.
const RAYS: u32 = 8000;
/// The radius of the beam of which the reference's rays are made.
const BEAM: f64 = 2.0;
/// The radius of the disc that has all the light but that of rays near the rim; no viewing ray of it goes through the ball.
pub const DISC: f64 = 1.75;

/// The index of refraction at a distance from the centre, and its slope.
fn ior(r: f64, depth: f64) -> (f64, f64) {
    let t = ((1.0 - r) / depth + 0.5).clamp(0.0, 1.0);
    (1.0 + (IOR - 1.0) * t * t * (3.0 - 2.0 * t), -(IOR - 1.0) * 6.0 * t * (1.0 - t) / depth)
}

/// The slope of η²/2 in a plane through the axis, with a surface of this depth.
fn slope([h, along]: [f64; 2], depth: f64) -> [f64; 2] {
    let r = h.hypot(along).max(1e-12);
    let (ior, steep) = ior(r, depth);
    [ior * steep * h / r, ior * steep * along / r]
}

/// Distances from the axis at which rays of equal flux meet the wall.
fn landed() -> Vec<f64> {
    let start = |ray| BEAM * ((f64::from(ray) + 0.5) / f64::from(RAYS)).sqrt();
    let left = (0..RAYS).filter_map(|ray| match start(ray) {
        h if h < 1.0 + SURFACE => follow(&|at| slope(at, SURFACE), h, [-1.3, 1.3], 0.005),
        h => Some(Left { across: h, at: 0.0, slope: 0.0 }),
    });
    left.map(|ray| ray.across_at(WALL).abs()).collect()
}

/// The widest angle of the reference's rays from a point.
const WIDEST: f64 = 0.5;

/// Distances from the axis at which rays of equal flux from a point at `distance` from the centre meet the wall.
pub fn landed_from(distance: f64) -> Vec<f64> {
    let left = (0..RAYS).filter_map(|ray| {
        let cosine = 1.0 - (1.0 - WIDEST.cos()) * (f64::from(ray) + 0.5) / f64::from(RAYS);
        let sine = (1.0 - cosine * cosine).sqrt();
        let (tangent, start) = (sine / cosine, -1.3);
        let straight = Left { across: 0.0, at: -distance, slope: tangent };
        if sine * distance < 1.0 + SURFACE {
            follow_towards(&|at| slope(at, SURFACE), straight.across_at(start), [sine, cosine], [start, 1.3], 0.005)
        } else {
            Some(straight)
        }
    });
    left.map(|ray| ray.across_at(WALL).abs()).collect()
}

/// The flux of a point of radiant intensity 1 through a disc, by [`landed_from`].
pub fn flux_from(landed: &[f64], radius: f64) -> f64 {
    let inside = landed.iter().filter(|distance| **distance < radius).count();
    std::f64::consts::TAU * (1.0 - WIDEST.cos()) * inside as f64 / f64::from(RAYS)
}

/// The flux through a disc by the reference.
fn flux(landed: &[f64], radius: f64) -> f64 {
    let inside = landed.iter().filter(|distance| **distance < radius).count();
    std::f64::consts::PI * BEAM * BEAM * inside as f64 / f64::from(RAYS)
}

#[test]
fn the_rays_of_a_thin_surface_are_those_of_snell() {
    // Rays at 0.3 of the radius of the ball, by Snell's law at both surfaces of a sphere.
    let turned = 2.0 * (0.3f64.asin() - (0.3 / IOR).asin());
    let expected = (0.3 - WALL * turned.sin()).abs() / turned.cos();
    let through = (1..=3).map(|layers| {
        let depth = SURFACE * 0.5f64.powi(layers);
        let ray = follow(&|at| slope(at, depth), 0.3, [-1.3, 1.3], 0.001).expect("it goes through");
        (ray.across_at(WALL).abs() - expected).abs()
    });
    let errors: Vec<f64> = through.collect();
    assert!(errors[2] < 0.01 && errors.is_sorted_by(|thick, thin| thick > thin), "{errors:?}");
}

/// The picture of the wall behind a ball of the index `ior` inside.
pub fn shot(inside: f64) -> Result<Shot, Failure> {
    let share = (inside - 1.0) / (IOR - 1.0);
    let volume =
        cube(VOXELS, EDGE as f32, |[x, y, z]| 1.0 + (ior((x * x + y * y + z * z).sqrt(), SURFACE).0 - 1.0) * share);
    let settings = [
        "transfer.opacity=[{value=1,opacity=0}]".to_owned(),
        format!("transfer.ior=[{{value=1,ior=1}},{{value={IOR},ior={IOR}}}]"),
        format!("wall={{distance={WALL},color=[1,1,1]}}"),
        format!("camera.azimuth={AZIMUTH}"),
        vector("camera.target", DVec3::new(0.0, -WALL, 0.0)),
        // The picture is twice as high as wide, and the wall in it as wide as high.
        "film.width=80".to_owned(),
        "film.height=160".to_owned(),
        format!("camera.zoom={}", 0.87 * 0.75f64.sqrt() * EDGE / 0.9),
        // Light that the ball spreads over all of the wall.
        "sweep.sample_distance=0.5".to_owned(),
    ];
    Shot::new(volume, 80, &settings)
}

/// The flux through a disc of the wall by the picture.
pub fn flux_of(shot: &Shot, red: &[f64], radius: f64) -> f64 {
    // A pixel's area on the wall, which is at right angles to the light.
    let area = shot.pixel_area() / AZIMUTH.to_radians().cos();
    let width = shot.scene.film.width as usize;
    // A pixel on the disc's outline counts by the share of its parts inside.
    let is_inside = |at: usize, part: u32| {
        let column = (at % width) as f64 + (f64::from(part % 8) + 0.5) / 8.0;
        let row = (at / width) as f64 + (f64::from(part / 8) + 0.5) / 8.0;
        let (from, along) = shot.ray(column, row);
        let end = from + along * ((-WALL - from.y) / along.y);
        end.x.hypot(end.z) < radius
    };
    let share = |at: usize| (0..64).filter(|part| is_inside(at, *part)).count() as f64 / 64.0;
    red.iter().enumerate().map(|(at, red)| red * area * share(at)).sum()
}

/// Where nothing bends light a disc has the flux of its area, to the 64 parts of each pixel.
#[test]
fn light_that_nothing_bends_has_the_flux_of_a_disc() -> Result<(), Failure> {
    let shot = shot(1.0)?;
    on_both(|backend, held| {
        let red = shot.render(backend)?.red;
        for radius in [0.5, DISC] {
            let found = flux_of(&shot, &red, radius) / (std::f64::consts::PI * radius * radius);
            held.at_most(
                backend,
                &format!("flux through a disc of radius {radius}, relative"),
                (found - 1.0).abs(),
                1e-3,
            );
        }
        Ok(())
    })
}

/// All light that went in comes out, to a percent: rays at the rim turn far, but the disc has all but the outermost of them. The voxels of a
/// surface five voxels deep turn its normal a little: rays that are followed through them in double precision bring 0.5 % less to the disc, and
/// 1.8 % more to within half a radius, which is held to three percent.
#[test]
fn light_behind_a_focus_is_all_there_and_in_its_place() -> Result<(), Failure> {
    let landed = landed();
    let shot = shot(IOR)?;
    on_both(|backend, held| {
        let red = shot.render(backend)?.red;
        for (radius, bound, what) in [(DISC, 0.015, "all light"), (0.5, 0.03, "light inside half a radius")] {
            let (found, expected) = (flux_of(&shot, &red, radius), flux(&landed, radius));
            println!("{}: {what}: {found:.4}, rays {expected:.4}", backend.name());
            let error = (found / expected - 1.0).abs();
            held.at_most(backend, &format!("{what} on a wall behind the focus, relative"), error, bound);
        }
        Ok(())
    })
}
