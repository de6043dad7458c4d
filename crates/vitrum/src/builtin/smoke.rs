//! A plume of smoke that rises from a narrow source, widens and thins out: the density of a medium.

use super::grid::Grid;
use super::noise::{fbm, vector};
use super::shapes::smoothstep;
use glam::{Vec2, Vec3};
use vitrum_io::{Error, Volume};

/// The box's size in world units; smoke rises along z.
const EXTENT: Vec3 = Vec3::new(1.5, 1.5, 2.0);

/// Density from 0, at the faces of the box, to at most 1.
pub(super) fn volume(name: &str, resolution: u32) -> Result<Volume, Error> {
    let grid = Grid::covering(name, EXTENT, resolution)?;
    let extent = Vec3::from_array(grid.dimensions().map(|size| size as f32)) * grid.spacing();
    grid.unit_volume(name, |position| {
        let inside = 0.5 * extent - position.abs();
        plume(position) * fade(position, inside - grid.spacing())
    })
}

fn plume(position: Vec3) -> f32 {
    let height = 0.5 + position.z / EXTENT.z;
    // Eddies grow with the height. Without the shift large ones would leave the middle, a point of the noise's lattice, in place.
    let eddies = 0.26 * vector(position * 1.7 + Vec3::new(0.37, 0.61, 0.23), 71) + 0.09 * vector(position * 4.9, 73);
    let folded = position + height * eddies;
    let width = 0.2 + 0.5 * height;
    let across = smoothstep(1.0, 0.25, Vec2::new(folded.x, folded.y).length() / width);
    let billows = 0.85 + 0.95 * fbm(Vec3::new(folded.x, folded.y, 0.7 * folded.z) * 3.6, 4, 83);
    // The same smoke fills a wider section.
    (across * billows.max(0.0) / (1.0 + 0.6 * height)).min(1.0)
}

/// Falls to 0 where `inside`, the distance from the faces, is 0: slowly at the top, where smoke dissolves.
fn fade(position: Vec3, inside: Vec3) -> f32 {
    let along = if position.z > 0.0 { 0.5 } else { 0.12 };
    smoothstep(0.0, 0.15, inside.x) * smoothstep(0.0, 0.15, inside.y) * smoothstep(0.0, along, inside.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_faces_are_clear() {
        for resolution in [16, 48] {
            let volume = volume("smoke", resolution).unwrap();
            let [width, height, depth] = volume.dimensions;
            let last = |index: u32, size: u32| index == 0 || index + 1 == size;
            for (x, y, z) in (0..width).flat_map(|x| (0..height).flat_map(move |y| (0..depth).map(move |z| (x, y, z))))
            {
                if last(x, width) || last(y, height) || last(z, depth) {
                    assert_eq!(volume.value(x, y, z), 0.0, "{resolution}: {x} {y} {z}");
                }
            }
        }
    }

    /// With an extinction of 1 to 2 per unit the plume is neither clear nor black.
    #[test]
    fn smoke_is_about_half_a_unit_thick() {
        let volume = volume("smoke", 48).unwrap();
        assert_eq!(volume.dimensions, [36, 36, 48]);
        assert!(volume.range == [0.0, 1.0], "{:?}", volume.range);
        for z in [8, 16, 24, 32] {
            let along = |y: u32| (0..36).map(|x| volume.value(x, y, z)).sum::<f32>() * volume.spacing[0];
            let densest = (0..36).map(along).fold(0.0, f32::max);
            assert!((0.3..0.7).contains(&densest), "{z}: {densest}");
        }
    }
}
