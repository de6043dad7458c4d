//! The penumbra of a straight edge on matter of the same volume: the share of a disc that a chord cuts off.

use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::cube;
use vitrum_kernels::glam::DVec3;

use crate::on_both;
use crate::penumbra::chord;
use crate::shot::{Cuboid, Shot};

const EDGE: f64 = 2.0;
const VOXELS: u32 = 64;
const VOXEL: f64 = EDGE / VOXELS as f64;
/// Angular radius of the light, degrees.
const RADIUS: f64 = 12.0;
/// The plate hides all light at x > 0.
const PLATE: [f64; 2] = [24.0 * VOXEL, 26.0 * VOXEL];
/// The front of the matter on which its shadow falls.
const SCREEN: f64 = -16.0 * VOXEL;
const AZIMUTH: f64 = 55.0;

/// Light diffuses from plane to plane, so that an edge's profile is near to a normal distribution of the disc's variance: at most 0.022 from the chord's,
/// 0.014 in the mean of squares over the penumbra. The rest is the voxels of the plate's edge, half a voxel over a penumbra of 17.
///
/// 0.0287 was measured: inside dense matter light is looked up three samples nearer to its source, where the penumbra is narrower by their distance; with one
/// sample and a half it was below 0.025.
const BOUND: f64 = 0.03;

#[test]
fn a_straight_edge_throws_a_disc_s_penumbra_on_matter_of_its_volume() -> Result<(), Failure> {
    let plate = Cuboid { low: DVec3::new(0.0, PLATE[0], -1.0), high: DVec3::new(1.0, PLATE[1], 1.0) };
    let screen = Cuboid { low: DVec3::new(-1.0, -1.0, -1.0), high: DVec3::new(1.0, SCREEN, 1.0) };
    let settings = [
        format!("light.0.angular_radius={RADIUS}"),
        "transfer.opacity=[{value=0.49,opacity=0},{value=0.51,opacity=1}]".to_owned(),
        format!("camera.azimuth={AZIMUTH}"),
    ];
    let shot = |with_plate: bool| {
        let is_there = |at: DVec3| (with_plate && plate.contains(at)) || screen.contains(at);
        let volume = cube(VOXELS, EDGE as f32, |at| f64::from(u8::from(is_there(DVec3::from_array(at)))));
        Shot::new(volume, 128, &settings)
    };
    let (shaded, open) = (shot(true)?, shot(false)?);
    let distance = PLATE[0] - SCREEN;
    let radius = distance * RADIUS.to_radians().tan();
    on_both(|backend, held| {
        // How bright the screen is varies with where its surface lies between two planes: the plate's shadow is what it takes of that.
        let (dark, bright) = (shaded.render(backend)?.red, open.render(backend)?.red);
        let on_screen = shaded.rays().zip(dark.iter().zip(&bright)).filter_map(|((from, along), (red, open))| {
            let seen = from + along * ((SCREEN - from.y) / along.y);
            let is_seen = plate.grown(VOXEL).crossing(from, along).is_none() && seen.z.abs() < 0.5;
            (is_seen && seen.x.abs() < 1.2 * radius).then_some((seen.x, red / open))
        });
        let (mut squares, mut count) = (0.0, 0);
        for (x, share) in on_screen {
            let error = share - chord(-x / radius);
            squares += error * error;
            count += 1;
        }
        assert!(count > 300, "{count} pixels of penumbra");
        let rmse = (squares / f64::from(count)).sqrt();
        println!("{}: inside: RMSE {rmse:.4}, {count} pixels", backend.name());
        held.at_most(backend, "penumbra of a straight edge on matter of its volume, RMSE", rmse, BOUND);
        Ok(())
    })
}
