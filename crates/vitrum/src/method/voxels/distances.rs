//! Signed distances of voxels' centres to the surface, near it.

use super::bodies::Body;
use crate::method::voxelize::Grid;
use glam::DVec3;
use rayon::prelude::*;
use vitrum_kernels::abi::voxels;

/// The largest stored distance, in voxels.
pub(in crate::method) const BAND: f64 = voxels::BAND as f64;
/// Layers of the grid that are computed together.
const LAYERS: usize = 4;
/// Least difference, in voxels, between the distances to points of two triangles that count as different.
const SAME: f64 = 1e-6;

/// The nearest point of a triangle.
#[derive(Clone, Copy)]
struct Nearest {
    distance: f64,
    /// Cosine of the angle between the way to the point and the triangle's normal: at an edge, the triangle with the largest one
    /// determines the side.
    facing: f64,
}

/// Distances of a body's surface to voxels' centres, from 0, [`BAND`] voxels or more outside, to 65535, as many inside.
///
/// Voxels that are wholly inside or outside by `coverage` are so whatever the nearest triangle says: it may lie within the body.
pub(super) fn distances(body: &Body, grid: Grid, coverage: &[u8]) -> Vec<u16> {
    let [nx, ny, nz] = grid.dimensions.map(|voxels| voxels as usize);
    let positions: Vec<DVec3> =
        body.mesh.positions.par_iter().map(|position| DVec3::from_array(grid.to_voxels(*position))).collect();
    let triangles: Vec<[DVec3; 3]> =
        body.mesh.triangles.par_iter().map(|triangle| triangle.map(|vertex| positions[vertex as usize])).collect();
    let mut slabs = vec![Vec::new(); nz.div_ceil(LAYERS)];
    for (index, [a, b, c]) in (0u32..).zip(&triangles) {
        let [first, last] = reach(a.z.min(b.z).min(c.z), a.z.max(b.z).max(c.z), BAND, nz);
        for slab in slabs.iter_mut().take(last / LAYERS + 1).skip(first / LAYERS) {
            slab.push(index);
        }
    }
    let mut field = vec![0u16; coverage.len()];
    let layer = nx * ny;
    let parts = field.par_chunks_mut(layer * LAYERS).zip(coverage.par_chunks(layer * LAYERS)).zip(&slabs).enumerate();
    parts.for_each(|(slab, ((field, coverage), indices))| {
        let mut nearest = vec![Nearest { distance: BAND, facing: 0.0 }; field.len()];
        let layers = field.len() / layer;
        for index in indices {
            approach(&mut nearest, triangles[*index as usize], [nx, ny, layers], slab * LAYERS);
        }
        for ((value, nearest), covered) in field.iter_mut().zip(&nearest).zip(coverage) {
            let inside = match covered {
                0 => false,
                255 => true,
                _ if nearest.facing == 0.0 => *covered > 127,
                _ => nearest.facing < 0.0,
            };
            let signed = if inside { nearest.distance } else { -nearest.distance };
            *value = ((signed / BAND * 0.5 + 0.5) * 65535.0).round() as u16;
        }
    });
    field
}

/// The voxels whose centres lie within a distance of low…high.
fn reach(low: f64, high: f64, distance: f64, count: usize) -> [usize; 2] {
    let limit = |at: f64| (at.max(0.0) as usize).min(count - 1);
    [limit((low - distance - 0.5).ceil()), limit((high + distance - 0.5).floor())]
}

/// Updates the nearest points of all voxels near a triangle in layers `first`… of the grid.
fn approach(nearest: &mut [Nearest], [a, b, c]: [DVec3; 3], [nx, ny, layers]: [usize; 3], first: usize) {
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let [y0, y1] = reach(low.y, high.y, BAND, ny);
    // How far a coordinate is from the triangle's box.
    let outside = |at: f64, low: f64, high: f64| (low - at).max(at - high).max(0.0);
    let squared = |length: f64| length * length;
    for z in 0..layers {
        let from_box_z = outside((first + z) as f64 + 0.5, low.z, high.z);
        if from_box_z > BAND {
            continue;
        }
        for y in y0..=y1 {
            let from_box = squared(outside(y as f64 + 0.5, low.y, high.y)) + squared(from_box_z);
            let left = BAND * BAND - from_box;
            if left < 0.0 {
                continue;
            }
            let [x0, x1] = reach(low.x, high.x, left.sqrt(), nx);
            for x in x0..=x1 {
                let centre = DVec3::new(x as f64 + 0.5, y as f64 + 0.5, (first + z) as f64 + 0.5);
                // The box or the plane alone is mostly too far: of many triangles that are near, few come nearer than those before.
                let least = nearest[(z * ny + y) * nx + x].distance + SAME;
                if squared(outside(centre.x, low.x, high.x)) + from_box > least * least
                    || (centre - a).dot(normal).abs() > least
                {
                    continue;
                }
                let away = centre - closest(centre, a, b, c);
                let distance = away.length();
                let facing = away.dot(normal) / distance.max(1e-300);
                let slot = &mut nearest[(z * ny + y) * nx + x];
                let nearer = distance < slot.distance - SAME;
                if nearer || (distance < slot.distance + SAME && facing.abs() > slot.facing.abs()) {
                    *slot = Nearest { distance: distance.min(slot.distance), facing };
                }
            }
        }
    }
}

/// The point of a triangle that is closest to `p` (Ericson, Real-Time Collision Detection, 5.1.5).
fn closest(p: DVec3, a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let inverse = 1.0 / (va + vb + vc);
    a + ab * (vb * inverse) + ac * (vc * inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_point_is_closer_than_any_other() {
        let corners = [DVec3::new(0.0, 0.1, 0.3), DVec3::new(2.0, 0.2, -0.4), DVec3::new(0.7, 1.8, 0.5)];
        let [a, b, c] = corners;
        for index in 0..125 {
            let along = |shift: u32| f64::from(index / 5u32.pow(shift) % 5) - 1.5;
            let p = DVec3::new(along(0), along(1), along(2));
            let found = closest(p, a, b, c);
            let mut least = f64::INFINITY;
            for i in 0..=60 {
                for j in 0..=60 - i {
                    let (u, v) = (f64::from(i) / 60.0, f64::from(j) / 60.0);
                    least = least.min((a + (b - a) * u + (c - a) * v - p).length());
                }
            }
            let distance = (found - p).length();
            assert!(distance <= least + 1e-12 && distance > least - 0.05, "{p}: {distance}, {least}");
        }
    }
}
