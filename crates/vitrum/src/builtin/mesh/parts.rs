//! Meshes that are assembled from parts.

use glam::Vec3;
use vitrum_io::{Material, Mesh};

/// A closed surface.
#[derive(Debug, Clone, Default)]
pub(super) struct Part {
    pub(super) positions: Vec<[f32; 3]>,
    /// Counterclockwise seen from outside.
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Part {
    /// The part with each vertex elsewhere; what moves it must not mirror it.
    pub(super) fn moved(mut self, to: impl Fn(Vec3) -> Vec3) -> Self {
        self.positions.iter_mut().for_each(|position| *position = to(Vec3::from_array(*position)).to_array());
        self
    }

    /// A mesh without materials.
    pub(super) fn into_mesh(self, name: &str) -> Mesh {
        Mesh::new(name, self.positions, self.triangles).expect("built-in meshes are valid")
    }
}

/// A clear material; `color` is its transmittance over a distance of `distance` world units.
pub(super) fn clear(name: &str, ior: f32, color: [f32; 3], distance: f32) -> Material {
    Material {
        name: name.to_owned(),
        index_of_refraction: Some(ior),
        attenuation_color: Some(color),
        attenuation_distance: Some(distance),
        transmission: Some(1.0),
        ..Material::default()
    }
}

/// One mesh of several parts, each of its material.
pub(super) fn assemble(name: &str, parts: Vec<(Part, Material)>) -> Mesh {
    let mut whole = Part::default();
    let (mut materials, mut triangle_materials) = (Vec::new(), Vec::new());
    for (number, (part, material)) in (0..).zip(parts) {
        let base = whole.positions.len() as u32;
        whole.positions.extend(part.positions);
        whole.triangles.extend(part.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + base)));
        triangle_materials.resize(whole.triangles.len(), number);
        materials.push(material);
    }
    Mesh { materials, triangle_materials, ..whole.into_mesh(name) }
}
