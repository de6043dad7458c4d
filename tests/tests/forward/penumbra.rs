//! The penumbra of a straight edge in light from a disc: the share of a disc that a chord cuts off.

use std::f64::consts::PI;

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::shot::{Cuboid, Shot, vector};
use crate::{is_tried, on_both};

const EDGE: f64 = 2.0;
const VOXEL: f64 = EDGE / 64.0;
/// Angular radius of the light, degrees.
const RADIUS: f32 = 5.0;
/// The plate hides all light at x > 0: two voxels thick, at the far end of the volume.
const FRONT: f64 = -26.0 * VOXEL;
const BACK: f64 = -28.0 * VOXEL;
const AZIMUTH: f64 = 50.0;

fn plate() -> Cuboid {
    Cuboid { low: DVec3::new(0.0, BACK, -1.0), high: DVec3::new(1.0, FRONT, 1.0) }
}

/// The share of a disc of radius 1 on the one side of a chord, which is `t` on the other side of the middle.
pub(crate) fn chord(t: f64) -> f64 {
    let t = t.clamp(-1.0, 1.0);
    0.5 + (t * (1.0 - t * t).sqrt() + t.asin()) / PI
}

/// The share of the light at `x`, `distance` behind the plate's back: in front of the edge rays are hidden by its front, else by its back.
fn visible(x: f64, distance: f64) -> f64 {
    let tangent = f64::from(RADIUS).to_radians().tan();
    let from = if x < 0.0 { distance + FRONT - BACK } else { distance };
    chord(-x / (from * tangent))
}

#[test]
pub(crate) fn chords_cut_discs() {
    assert!((chord(0.0) - 0.5).abs() < 1e-15 && chord(1.0) == 1.0 && chord(-2.0) == 0.0);
    // Half a radius beside the middle: a third of the circle less a triangle.
    assert!((chord(-0.5) - (1.0 / 3.0 - 3f64.sqrt() / (4.0 * PI))).abs() < 1e-12);
}

/// At 0.1 to 2 edges of the volume behind the plate, over one and a half widths of the penumbra and a voxel on either side. The nearest
/// penumbra is a voxel wide; what smooths it by half a voxel is off by some percent there, and less farther on.
#[test]
fn a_straight_edge_has_the_penumbra_of_a_disc() -> Result<(), Failure> {
    let body = plate();
    let volume = cube(64, EDGE as f32, |at| f64::from(u8::from(body.contains(DVec3::from_array(at)))));
    on_both(|backend, held| {
        for (number, sizes) in [0.1, 0.5, 2.0, 1.0].into_iter().enumerate() {
            if !is_tried(backend, number) {
                continue;
            }
            let distance = sizes * EDGE;
            let wall = distance - BACK;
            let width = 1.5 * distance * f64::from(RADIUS).to_radians().tan() + VOXEL;
            let half = width.max(0.25);
            let settings = [
                format!("light.0.angular_radius={RADIUS}"),
                format!("wall={{distance={wall},color=[1,1,1]}}"),
                "transfer.opacity=[{value=0.49,opacity=0},{value=0.51,opacity=1}]".to_owned(),
                "sweep.light_cells=320".to_owned(),
                // The edge is seen from its lit side.
                format!("camera.azimuth={AZIMUTH}"),
                format!("camera.zoom={}", 0.87 * 0.75f64.sqrt() * EDGE / half),
                vector("camera.target", DVec3::new(0.0, -wall, 0.0)),
            ];
            let shot = Shot::new(volume.clone(), 48, &settings)?;
            let pixels = shot.render(backend)?;
            let (mut squares, mut worst, mut count) = (0.0, 0.0f64, 0);
            for ((from, along), red) in shot.rays().zip(&pixels.red) {
                let seen = from + along * ((-wall - from.y) / along.y);
                if seen.x.abs() < width && seen.z.abs() < 0.5 && body.grown(VOXEL).crossing(from, along).is_none() {
                    let error = red - visible(seen.x, distance);
                    squares += error * error;
                    worst = worst.max(error.abs());
                    count += 1;
                }
            }
            assert!(count > 300, "{count} pixels of penumbra");
            let rmse = (squares / f64::from(count)).sqrt();
            println!("{}: {sizes} edges behind: RMSE {rmse:.4}, worst {worst:.3}, {count} pixels", backend.name());
            held.at_most(backend, &format!("penumbra {sizes} edges behind a straight edge, RMSE"), rmse, 0.03);
        }
        Ok(())
    })
}
