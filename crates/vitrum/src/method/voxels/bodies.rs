//! Bodies: the triangles of a mesh, divided by material.

use crate::error::Error;
use crate::scene::{Material, Rgb, Scene};
use crate::unrenderable::Unrenderable;
use vitrum_io::Mesh;
use vitrum_kernels::abi::voxels::{AIR, material};

/// The specular reflectance of a mirror of which nothing is said.
const MIRROR: Rgb = [0.95; 3];

/// The triangles of one material, or of several that are alike.
#[derive(Debug, Clone)]
pub struct Body {
    /// Number of the material in the mesh, the lowest of several; `None` if the mesh has no materials.
    pub material: Option<u32>,
    /// Whether the body is opaque: light does not get into it. Mirrors are opaque.
    pub opaque: bool,
    /// Whether the body's surface mirrors.
    pub mirror: bool,
    /// The body's triangles; the surface of a clear body faces outwards as a whole.
    pub mesh: Mesh,
}

/// The numbers of the materials that triangles of the mesh have; `None` if it has no materials.
fn numbers(mesh: &Mesh) -> Vec<Option<u32>> {
    let mut numbers: Vec<Option<u32>> = mesh.triangle_materials.iter().copied().map(Some).collect();
    numbers.sort_unstable();
    numbers.dedup();
    if numbers.is_empty() {
        numbers.push(None);
    }
    numbers
}

/// Materials of a mesh that make one body.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Group {
    pub(super) opaque: bool,
    mirror: bool,
    /// Numbers of the materials; `None` if the mesh has no materials.
    numbers: Vec<Option<u32>>,
}

/// The groups of a mesh's materials: clear materials with the same constants together, each opaque or mirroring one by itself. `listed` are the
/// scene's materials.
pub(super) fn groups(mesh: &Mesh, listed: &[Material]) -> Vec<Group> {
    let mut groups: Vec<(Material, Group)> = Vec::new();
    for number in numbers(mesh) {
        let material = Material { name: None, ..chosen(listed, of_mesh(mesh, number)) };
        let mirror = material.mirror;
        let opaque = material.opaque || mirror;
        match groups.iter_mut().find(|(known, _)| !opaque && *known == material) {
            Some((_, group)) => group.numbers.push(number),
            None => groups.push((material, Group { opaque, mirror, numbers: vec![number] })),
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

/// The bodies of a mesh: one for all clear materials with the same constants, and one for each opaque or mirroring material. Clear bodies come
/// first, those of the least volume before others: where two overlap, the smaller body fills the space. `listed` are the scene's
/// materials.
///
/// # Errors
/// Where there are more clear materials than rays can tell apart.
pub fn bodies(mesh: &Mesh, listed: &[Material]) -> Result<Vec<Body>, Error> {
    are_opaque(mesh, listed)?;
    let split = |group: Group| body(mesh, &group);
    let (opaque, mut bodies): (Vec<Body>, Vec<Body>) =
        groups(mesh, listed).into_iter().map(split).partition(|body| body.opaque);
    bodies.sort_by(|a, b| a.mesh.signed_volume().total_cmp(&b.mesh.signed_volume()));
    bodies.extend(opaque);
    Ok(bodies)
}

/// Whether each body of a mesh is opaque, as [`bodies`] divides it, in no order. `listed` are the scene's materials.
///
/// # Errors
/// As [`bodies`].
pub(in crate::method) fn are_opaque(mesh: &Mesh, listed: &[Material]) -> Result<Vec<bool>, Error> {
    let opaque: Vec<bool> = groups(mesh, listed).iter().map(|group| group.opaque).collect();
    let count = opaque.iter().filter(|opaque| !**opaque).count();
    if count > AIR as usize {
        let name = mesh.name.clone();
        return Err(Unrenderable::TooManyMaterials { name, count, limit: AIR as usize }.into());
    }
    Ok(opaque)
}

/// Whether a clear body of a mesh bends colours differently. `listed` are the scene's materials.
pub(in crate::method) fn disperse(mesh: &Mesh, listed: &[Material]) -> bool {
    // A mesh's own materials do not.
    listed.iter().any(Material::disperses)
        && numbers(mesh).into_iter().any(|number| chosen(listed, of_mesh(mesh, number)).disperses())
}

fn body(mesh: &Mesh, &Group { opaque, mirror, ref numbers }: &Group) -> Body {
    let is_part = |index: &usize| numbers.contains(&mesh.triangle_materials.get(*index).copied());
    let triangles: Vec<[u32; 3]> =
        (0..mesh.triangles.len()).filter(is_part).map(|index| mesh.triangles[index]).collect();
    // Of the vertices those alone that it has: a mesh may have many materials.
    let mut places = vec![u32::MAX; mesh.positions.len()];
    triangles.as_flattened().iter().for_each(|&vertex| places[vertex as usize] = 0);
    for (number, place) in (0..).zip(places.iter_mut().filter(|place| **place == 0)) {
        *place = number;
    }
    fn kept<T: Copy>(values: &[T], places: &[u32]) -> Vec<T> {
        values.iter().zip(places).filter(|(_, place)| **place != u32::MAX).map(|(value, _)| *value).collect()
    }
    let mut part = Mesh {
        name: mesh.name.clone(),
        positions: kept(&mesh.positions, &places),
        triangles: triangles.iter().map(|triangle| triangle.map(|vertex| places[vertex as usize])).collect(),
        normals: mesh.normals.as_deref().map(|normals| kept(normals, &places)),
        colors: mesh.colors.as_deref().map(|colors| kept(colors, &places)),
        materials: Vec::new(),
        triangle_materials: Vec::new(),
        source: mesh.source.clone(),
    };
    if !opaque && part.signed_volume() < 0.0 {
        part.triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
        part.normals.iter_mut().flatten().for_each(|normal| *normal = normal.map(|component| -component));
    }
    Body { material: numbers.first().copied().flatten(), opaque, mirror, mesh: part }
}

/// Optical constants of a clear body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::method) struct Clear {
    /// Index of refraction over that of the surroundings.
    pub(in crate::method) ior: f32,
    /// Absorption coefficient, RGB, per world unit.
    pub(in crate::method) absorption: [f64; 3],
}

/// Optical constants of the bodies of a mesh, as if all were clear.
pub(in crate::method) fn clear(bodies: &[Body], mesh: &Mesh, scene: &Scene) -> Vec<Clear> {
    let longest = f64::from(longest_edge(mesh));
    let of_body = |body: &Body| {
        let found = chosen(&scene.material, of_mesh(mesh, body.material));
        let distance = found.attenuation_distance.map_or(longest, f64::from);
        let absorption = found.attenuation_color.map(|left| -libm::log(f64::from(left)) / distance);
        Clear { ior: found.ior / scene.surroundings.ior, absorption }
    };
    bodies.iter().map(of_body).collect()
}

/// The longest edge of a mesh's bounds.
pub(in crate::method) fn longest_edge(mesh: &Mesh) -> f32 {
    let [low, high] = mesh.bounds();
    (0..3).map(|axis| high[axis] - low[axis]).fold(f32::MIN_POSITIVE, f32::max)
}

/// The specular reflectance of a mirror, linear RGB, 0 to 1: the scene's, else that of the mesh's material, else [`MIRROR`].
fn reflectance(body: &Body, mesh: &Mesh, scene: &Scene) -> Rgb {
    let own = of_mesh(mesh, body.material);
    chosen(&scene.material, own).color.or_else(|| own?.base_color).unwrap_or(MIRROR)
}

/// The materials of bodies as kernels read them: the index of refraction, and the absorption per voxel of the length `voxel_size`. An
/// opaque body has the index 0, a mirror -1, and a mirror has its reflectance in the place of the absorption.
pub(in crate::method) fn materials(bodies: &[Body], mesh: &Mesh, scene: &Scene, voxel_size: f64) -> Vec<f32> {
    let mut floats = Vec::with_capacity(bodies.len() * material::SIZE);
    for (body, Clear { ior, absorption }) in bodies.iter().zip(clear(bodies, mesh, scene)) {
        if body.mirror {
            floats.push(-1.0);
            floats.extend(reflectance(body, mesh, scene));
            continue;
        }
        floats.push(if body.opaque { 0.0 } else { ior });
        floats.extend(absorption.map(|coefficient| (coefficient * voxel_size) as f32));
    }
    floats
}

/// The material of that number in the mesh's file.
pub(super) fn of_mesh(mesh: &Mesh, number: Option<u32>) -> Option<&vitrum_io::Material> {
    number.and_then(|number| mesh.materials.get(number as usize))
}

/// The material that applies: the scene's entry for its name, else the scene's entry for all, else the mesh's own, else glass. A mesh's
/// material that has opacity 1 and neither transmits nor attenuates is opaque.
pub(super) fn chosen(listed: &[Material], of_mesh: Option<&vitrum_io::Material>) -> Material {
    let named =
        listed.iter().find(|listed| listed.name.is_some() && listed.name.as_ref() == of_mesh.map(|own| &own.name));
    let of_all = || listed.iter().find(|listed| listed.name.is_none());
    if let Some(found) = named.or_else(of_all) {
        return found.clone();
    }
    let mut material = Material::default();
    if let Some(own) = of_mesh {
        // What says that all light ends at its surface; what says nothing of it is clear.
        let transmits = own.transmission.is_some_and(|share| share > 0.0) || own.attenuation_color.is_some();
        material.opaque = own.opacity == Some(1.0) && !transmits;
        // Writers of MTL put 1 there for what they do not know.
        material.ior = own.index_of_refraction.filter(|&ior| ior > 1.0).unwrap_or(material.ior).min(4.0);
        material.attenuation_color =
            own.attenuation_color.map_or(material.attenuation_color, |color| color.map(|c| c.clamp(1e-3, 1.0)));
        material.attenuation_distance = own.attenuation_distance;
    }
    material
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A triangle of each material.
    fn mesh(materials: Vec<vitrum_io::Material>) -> Mesh {
        let count = materials.len() as u32;
        Mesh {
            name: "triangles".to_owned(),
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2]; count as usize],
            normals: None,
            colors: None,
            materials,
            triangle_materials: (0..count).collect(),
            source: vitrum_io::Source::default(),
        }
    }

    #[test]
    fn a_surface_that_lets_nothing_through_is_opaque() {
        let opaque = |own: vitrum_io::Material| chosen(&[], Some(&own)).opaque;
        let solid = vitrum_io::Material { opacity: Some(1.0), ..Default::default() };
        assert!(opaque(solid.clone()));
        assert!(!opaque(vitrum_io::Material::default()), "nothing is said");
        assert!(!opaque(vitrum_io::Material { opacity: Some(0.5), ..Default::default() }));
        assert!(!opaque(vitrum_io::Material { transmission: Some(1.0), ..solid.clone() }));
        assert!(!opaque(vitrum_io::Material { attenuation_color: Some([0.5; 3]), ..solid }));
    }

    #[test]
    fn clear_materials_that_are_alike_are_one_body() {
        let water = || vitrum_io::Material { index_of_refraction: Some(1.33), ..Default::default() };
        let wood = || vitrum_io::Material { opacity: Some(1.0), ..Default::default() };
        let mesh = mesh([vec![water(); 20], vec![wood(); 2], vec![Default::default(); 2]].concat());
        let found = bodies(&mesh, &[]).unwrap();
        let sizes: Vec<(bool, usize)> = found.iter().map(|body| (body.opaque, body.mesh.triangles.len())).collect();
        assert_eq!(sizes, [(false, 20), (false, 2), (true, 1), (true, 1)]);
    }

    #[test]
    fn a_mirror_is_an_opaque_body_with_a_reflectance() {
        let silver = |name: &str| vitrum_io::Material { name: name.to_owned(), ..Default::default() };
        let mesh =
            mesh(vec![silver("a"), silver("b"), vitrum_io::Material { base_color: Some([0.5; 3]), ..silver("c") }]);
        let mirror =
            |name: &str, color| Material { name: Some(name.to_owned()), mirror: true, color, ..Material::default() };
        let listed = vec![mirror("a", Some([0.9, 0.8, 0.7])), mirror("b", None), mirror("c", None)];
        let found = bodies(&mesh, &listed).unwrap();
        assert!(found.len() == 3 && found.iter().all(|body| body.opaque && body.mirror));
        let scene = Scene { material: listed, ..Scene::default() };
        let expected = [[-1.0, 0.9, 0.8, 0.7], [-1.0, 0.95, 0.95, 0.95], [-1.0, 0.5, 0.5, 0.5]];
        assert_eq!(materials(&found, &mesh, &scene, 0.25), expected.as_flattened());
    }
}
