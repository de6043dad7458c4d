//! Meshes with known volumes.

use vitrum_io::Mesh;

/// Vigna's xorshift64*, numbers from 0 to 1.
pub struct Random(pub u64);

impl Random {
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 40) as f64 / f64::from(1 << 24)
    }

    /// From −1 to 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }
}

pub fn mesh(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh::new("test", positions, triangles).expect("a valid mesh")
}

/// Several meshes in one.
pub fn together(parts: &[Mesh]) -> Mesh {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for part in parts {
        let base = positions.len() as u32;
        positions.extend(&part.positions);
        triangles.extend(part.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + base)));
    }
    mesh(positions, triangles)
}

/// The surface, facing the other way.
pub fn reversed(mesh: &Mesh) -> Mesh {
    let mut mesh = mesh.clone();
    mesh.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    mesh
}

/// A box from `low` to `high`, facing outwards.
pub fn cuboid(low: [f32; 3], high: [f32; 3]) -> Mesh {
    let corner = |bits: usize| std::array::from_fn(|axis| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] });
    #[rustfmt::skip]
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    mesh((0..8).map(corner).collect(), triangles)
}

/// A ball around the origin as a grid of longitudes and latitudes, facing outwards, turned so that no edge lies along an axis.
pub fn ball(radius: f64, latitudes: u32) -> Mesh {
    let longitudes = 2 * latitudes;
    let mut positions = vec![turn([0.0, 0.0, radius])];
    for j in 1..latitudes {
        let theta = std::f64::consts::PI * f64::from(j) / f64::from(latitudes);
        for i in 0..longitudes {
            let phi = std::f64::consts::TAU * f64::from(i) / f64::from(longitudes);
            let (across, up) = (radius * theta.sin(), radius * theta.cos());
            positions.push(turn([across * phi.cos(), across * phi.sin(), up]));
        }
    }
    positions.push(turn([0.0, 0.0, -radius]));
    let at = |j: u32, i: u32| 1 + (j - 1) * longitudes + i % longitudes;
    let south = positions.len() as u32 - 1;
    let mut triangles = Vec::new();
    for i in 0..longitudes {
        triangles.push([0, at(1, i), at(1, i + 1)]);
        for j in 1..latitudes - 1 {
            let (a, b, c, d) = (at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
        triangles.push([at(latitudes - 1, i), south, at(latitudes - 1, i + 1)]);
    }
    mesh(positions, triangles)
}

fn turn([x, y, z]: [f64; 3]) -> [f32; 3] {
    let rotation = vitrum_kernels::glam::DQuat::from_euler(vitrum_kernels::glam::EulerRot::XYZ, 0.3, 0.7, 1.1);
    (rotation * vitrum_kernels::glam::DVec3::new(x, y, z)).as_vec3().to_array()
}

/// Triangles all over a cube: small, large, slivers, needles, points, and some along the axes.
pub fn random(count: u32, seed: u64) -> Mesh {
    let mut random = Random(seed);
    let mut positions: Vec<[f32; 3]> = vec![[-1.0; 3], [1.0; 3], [-1.0, 1.0, -1.0]];
    for kind in 0..count {
        let centre: [f64; 3] = std::array::from_fn(|_| random.signed());
        let far: [f64; 3] = std::array::from_fn(|_| random.signed());
        let size = 10.0f64.powf(-4.0 * random.unit());
        for corner in 0..3 {
            let position = match kind % 8 {
                // Needles: two corners close together, one far away.
                0 if corner == 2 => far,
                0 => centre.map(|c| c + 1e-6 * size * random.signed()),
                // Nearly lines.
                1 => std::array::from_fn(|axis| {
                    let t = f64::from(corner) * 0.5;
                    centre[axis] + (far[axis] - centre[axis]) * t + 1e-7 * random.signed()
                }),
                // In a plane across an axis.
                2 => {
                    std::array::from_fn(|axis| if axis as u32 == kind / 8 % 3 { centre[axis] } else { random.signed() })
                }
                // Along an axis.
                3 => {
                    std::array::from_fn(|axis| if axis as u32 == kind / 8 % 3 { random.signed() } else { centre[axis] })
                }
                // Points.
                4 if kind % 3 == 0 => centre,
                // All over.
                5 => std::array::from_fn(|_| random.signed()),
                _ => centre.map(|c| c + size * random.signed()),
            };
            positions.push(position.map(|c| c.clamp(-1.0, 1.0) as f32));
        }
    }
    let triangles = (0..=count).map(|index| [3 * index, 3 * index + 1, 3 * index + 2]).collect();
    mesh(positions, triangles)
}
