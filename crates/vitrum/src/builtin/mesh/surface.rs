//! Surfaces where a signed distance is 0.

use super::parts::Part;
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::Vec3;
use ndshape::RuntimeShape;
use rayon::prelude::*;

/// Steps towards the surface; each leaves a small part of the way.
const STEPS: u32 = 4;

/// The surface between `low` and `high`, which it must not touch, from samples at distances of `edge`. Vertices lie on it.
pub(super) fn surface(low: Vec3, high: Vec3, edge: f32, distance: impl Fn(Vec3) -> f32 + Sync) -> Part {
    let counts = ((high - low) / edge).ceil().to_array().map(|count| count as u32 + 1);
    let [nx, ny, _] = counts;
    let at = |index: u32| {
        let (x, y, z) = (index % nx, index / nx % ny, index / (nx * ny));
        low + Vec3::new(x as f32, y as f32, z as f32) * edge
    };
    let samples: Vec<f32> =
        (0..counts.iter().product()).into_par_iter().map(|index: u32| distance(at(index))).collect();
    let mut net = SurfaceNetsBuffer::default();
    surface_nets(&samples, &RuntimeShape::<u32, 3>::new(counts), [0; 3], counts.map(|count| count - 1), &mut net);
    let positions = net.positions.par_iter().map(|position| {
        let start = low + Vec3::from_array(*position) * edge;
        (0..STEPS).fold(start, |position, _| nearer(position, edge, &distance)).to_array()
    });
    let triangles = net.indices.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect();
    Part { positions: positions.collect(), triangles }
}

/// A step towards the surface, at most half an edge.
fn nearer(position: Vec3, edge: f32, distance: &impl Fn(Vec3) -> f32) -> Vec3 {
    let reach = 0.1 * edge;
    let difference =
        |axis: Vec3| (distance(position + axis * reach) - distance(position - axis * reach)) / (2.0 * reach);
    let gradient = Vec3::new(difference(Vec3::X), difference(Vec3::Y), difference(Vec3::Z));
    let step = gradient * (-distance(position) / gradient.length_squared().max(0.1));
    position + step * (0.5 * edge / step.length().max(0.5 * edge))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_lie_on_the_surface() {
        let part = surface(Vec3::splat(-1.1), Vec3::splat(1.1), 0.1, |position| position.length() - 1.0);
        let farthest = part.positions.iter().map(|p| (Vec3::from_array(*p).length() - 1.0).abs()).fold(0.0, f32::max);
        assert!(farthest < 1e-5, "{farthest}");
        let mesh = part.into_mesh("ball");
        assert!(mesh.topology().is_closed() && mesh.signed_volume() > 4.1, "{}", mesh.signed_volume());
    }
}
