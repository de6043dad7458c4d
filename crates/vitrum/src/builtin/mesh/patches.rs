//! Closed surfaces of patches with normals: smooth within a patch, with a crease between two.

use super::parts::Part;
use glam::Vec3;
use vitrum_io::{Material, Mesh};

/// A surface of one material. Vertices on a crease are there several times, each with the normal of its patch.
#[derive(Default)]
pub(super) struct Patches {
    part: Part,
    normals: Vec<Vec3>,
}

impl Patches {
    /// Adds rows of vertices, place and unit normal, of one length each, which quads join: a row's next vertex, then the next row, run
    /// counterclockwise seen from outside.
    pub(super) fn grid(&mut self, rows: &[Vec<(Vec3, Vec3)>]) {
        let first = self.part.positions.len() as u32;
        let length = rows[0].len() as u32;
        for (place, normal) in rows.iter().flatten() {
            self.part.positions.push(place.to_array());
            self.normals.push(*normal);
        }
        for row in 1..rows.len() as u32 {
            for index in 1..length {
                let below = first + (row - 1) * length + index;
                let above = below + length;
                self.part.triangles.extend([[below - 1, below, above], [below - 1, above, above - 1]]);
            }
        }
    }

    /// Adds a flat, convex polygon; its corners run counterclockwise seen from outside.
    pub(super) fn polygon(&mut self, corners: &[Vec3]) {
        let first = self.part.positions.len() as u32;
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        for corner in corners {
            self.part.positions.push(corner.to_array());
            self.normals.push(normal);
        }
        self.part.triangles.extend((2..corners.len() as u32).map(|index| [first, first + index - 1, first + index]));
    }

    /// The surface as a mesh.
    pub(super) fn into_mesh(self, name: &str, material: Material) -> Mesh {
        with_normals(self.part, self.normals, name, material)
    }
}

/// A part with a normal for each of its vertices, as a mesh.
pub(super) fn with_normals(part: Part, normals: Vec<Vec3>, name: &str, material: Material) -> Mesh {
    let normals = normals.into_iter().map(|normal| normal.to_array()).collect();
    let mesh = super::parts::assemble(name, vec![(part, material)]);
    Mesh { normals: Some(normals), ..mesh }
}
