//! Size, area and volume, summed up in float64.

use glam::DVec3;

use super::Mesh;

impl Mesh {
    /// Smallest and largest coordinates of the vertices that triangles use.
    #[must_use]
    pub fn bounds(&self) -> [[f32; 3]; 2] {
        // Comparisons, not `f32::min`, which handles NaN in two more instructions; and for each of a triangle's corners bounds of their
        // own, which do not wait for each other.
        let smaller = |a: f32, b: f32| if b < a { b } else { a };
        let larger = |a: f32, b: f32| if b > a { b } else { a };
        let mut low = [[f32::INFINITY; 3]; 3];
        let mut high = [[f32::NEG_INFINITY; 3]; 3];
        for triangle in &self.triangles {
            for ((low, high), &vertex) in low.iter_mut().zip(&mut high).zip(triangle) {
                let position = self.positions[vertex as usize];
                for axis in 0..3 {
                    low[axis] = smaller(low[axis], position[axis]);
                    high[axis] = larger(high[axis], position[axis]);
                }
            }
        }
        let all = |corners: [[f32; 3]; 3], of_both: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|axis| of_both(of_both(corners[0][axis], corners[1][axis]), corners[2][axis]))
        };
        [all(low, smaller), all(high, larger)]
    }

    /// Sum of the triangles' areas, in square units.
    #[must_use]
    pub fn surface_area(&self) -> f64 {
        self.triangles.iter().map(|triangle| area(self.corners(triangle))).sum()
    }

    /// Volume that the surface encloses, in cubic units, below 0 where the triangles run clockwise seen from outside.
    ///
    /// It means something where [`Topology::unpaired_edges`](super::Topology::unpaired_edges) is 0; elsewhere it is
    /// that of the surface and the cone from its rims to the middle of the bounds.
    #[must_use]
    pub fn signed_volume(&self) -> f64 {
        // About the middle, so that no digits are lost far from the origin.
        let [low, high] = self.bounds();
        let middle = 0.5 * (DVec3::from(low.map(f64::from)) + DVec3::from(high.map(f64::from)));
        let volume = |triangle: &[u32; 3]| {
            let [a, b, c] = self.corners(triangle).map(|corner| corner - middle);
            a.dot(b.cross(c)) / 6.0
        };
        self.triangles.iter().map(volume).sum()
    }

    /// The number of triangles whose area is 0. They stay in the mesh: without one of them, the mesh might be open.
    #[must_use]
    pub fn degenerate_triangle_count(&self) -> usize {
        self.triangles.iter().filter(|triangle| area(self.corners(triangle)) == 0.0).count()
    }
}

fn area([a, b, c]: [DVec3; 3]) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}
