//! The camera's zoom is a magnification.

use super::on_both;
use vitrum_conformance::refraction::{ball, case};
use vitrum_conformance::{Failure, frames};

/// A picture with twice the zoom is the middle of one with twice as many pixels along each side. Where their number is a power of 2, the
/// pixels' centres are exact, and the rays are the same to the last bit.
#[test]
fn twice_the_zoom_shows_the_middle_twice_as_large() -> Result<(), Failure> {
    const EDGE: usize = 32;
    for projection in ["camera.projection=perspective", "camera.projection=orthographic"] {
        for surfaces in ["voxels.surfaces=exact", "voxels.surfaces=multi"] {
            on_both(|backend| {
                let mut picture = |edge: usize, zoom: &str| {
                    let settings = [projection, surfaces, zoom, "voxelization.resolution=32", "environment.kind=color"];
                    let case = case("zoom", ball(12), edge as u32, &settings)?;
                    let frame = frames::render(&case, backend)?;
                    Ok::<_, Failure>(frame.channel("depth", "Z").expect("a depth").to_vec())
                };
                let whole = picture(2 * EDGE, "camera.zoom=1")?;
                let middle = picture(EDGE, "camera.zoom=2")?;
                let mut seen = 0;
                for (row, depths) in middle.chunks_exact(EDGE).enumerate() {
                    let start = (row + EDGE / 2) * 2 * EDGE + EDGE / 2;
                    assert_eq!(depths, &whole[start..start + EDGE], "{projection}, {surfaces}, row {row}");
                    seen += depths.iter().filter(|&&depth| depth != 0.0).count();
                }
                assert!(seen > EDGE * EDGE / 2, "{seen} pixels of the ball");
                Ok(())
            })?;
        }
    }
    Ok(())
}

/// The nearest point of a ball is its radius in front of its middle, wherever the eye is.
#[test]
fn the_eye_is_at_its_distance() -> Result<(), Failure> {
    on_both(|backend| {
        for distance in [1.5, 4.0, 25.0] {
            let eye = format!("camera.distance={distance}");
            let case = case("distance", ball(64), 65, &[&eye, "voxels.surfaces=exact", "camera.zoom=6"])?;
            let frame = frames::render(&case, backend)?;
            let depth = frame.channel("depth", "Z").expect("a depth")[65 * 32 + 32];
            assert!((f64::from(depth) - (distance - 1.0)).abs() < 2e-3, "{depth} from {distance}");
        }
        Ok(())
    })
}
