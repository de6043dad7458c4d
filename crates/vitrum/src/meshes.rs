//! The meshes of a scene, each read, turned upright and placed, as one mesh.

use crate::assets::{made, syntax};
use crate::error::Error;
use crate::method::voxels::GREY;
use crate::scene::{MeshSource, Rgb};
use crate::unrenderable::Unrenderable;
use glam::{DMat3, DVec3};
use std::collections::HashMap;
use std::path::Path;
use vitrum_io::{Material, Mesh, OpenOptions, Up};

/// Reads the meshes that `sources` name and joins them, each at its place and none of them twisted. The bodies of each keep materials of
/// their own. A relative path starts at `base`.
///
/// # Errors
///
/// As [`load_mesh`] for each; where `sources` is empty, or there are more vertices than 32-bit indices tell apart.
pub fn load_meshes(sources: &[MeshSource], base: &Path, max_bytes: Option<u64>) -> Result<Mesh, Error> {
    let meshes = sources.iter().map(|source| load_mesh(source, base, max_bytes)).collect::<Result<Vec<_>, _>>()?;
    joined(meshes)
}

/// Reads the mesh that `source` names, turned upright and placed, but not twisted; a relative path starts at `base`.
///
/// # Errors
///
/// Those of [`vitrum_io::open_mesh`]; where `source` would not pass [`crate::scene::Scene::validate`], or its built-in mesh does not exist.
pub fn load_mesh(source: &MeshSource, base: &Path, max_bytes: Option<u64>) -> Result<Mesh, Error> {
    check_time(source)?;
    let (mesh, usual) = match (&source.file, &source.builtin) {
        (Some(file), None) => {
            let path = base.join(file);
            let options = OpenOptions { max_bytes, ..OpenOptions::default() };
            (vitrum_io::open_mesh(&path, &options)?, usual_up(&path))
        }
        (None, Some(name)) => {
            let seconds = f64::from(source.time.unwrap_or(0.0));
            (made::mesh_at(name, seconds, f64::from(source.scale))?, Up::Superior)
        }
        (Some(_), Some(_)) => return Err(Unrenderable::TwoSources { kind: "mesh" }.into()),
        (None, None) => return Err(Unrenderable::NoSource { kind: "mesh" }.into()),
    };
    arranged(mesh, usual, source)
}

/// A mesh that is in memory, turned upright, placed and of the material as `source` says; its z is up where `source` does not say.
pub(crate) fn arrange(mesh: Mesh, source: &MeshSource) -> Result<Mesh, Error> {
    check_time(source)?;
    arranged(mesh, Up::Superior, source)
}

fn arranged(mut mesh: Mesh, usual: Up, source: &MeshSource) -> Result<Mesh, Error> {
    let up = match &source.up {
        Some(text) => text.parse().map_err(syntax)?,
        None => usual,
    };
    let turn = |vector: &mut [f32; 3]| *vector = up.turn(*vector);
    mesh.positions.iter_mut().for_each(turn);
    mesh.normals.iter_mut().flatten().for_each(turn);
    if let Some(name) = &source.material {
        mesh.materials = vec![Material { name: name.clone(), ..Material::default() }];
        mesh.triangle_materials = vec![0; mesh.triangles.len()];
    }
    placed(mesh, source)
}

/// A moment that a mesh does not have would pass unnoticed.
fn check_time(source: &MeshSource) -> Result<(), Error> {
    let Some(time) = source.time else { return Ok(()) };
    let problem = if !time.is_finite() {
        format!("mesh.time = {time}, expected a finite number of seconds")
    } else if source.builtin.as_deref().is_some_and(made::may_move) {
        return Ok(());
    } else {
        "mesh.time is given, and the mesh does not move".to_owned()
    };
    Err(syntax(problem))
}

/// glTF says that y is up, OBJ files follow that; the others say nothing, and most come from makers for whom it is z.
fn usual_up(path: &Path) -> Up {
    let name = path.file_name().map(|name| name.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    // Wherever it stands: files may be packed, `.obj.gz`.
    if [".obj", ".gltf", ".glb"].iter().any(|extension| name.contains(extension)) { Up::Anterior } else { Up::Superior }
}

/// The mesh scaled and rotated about its origin, then moved. One that stays where it is keeps its coordinates to the bit.
fn placed(mut mesh: Mesh, source: &MeshSource) -> Result<Mesh, Error> {
    let MeshSource { scale, rotation, position, .. } = source;
    if (*scale, *rotation, *position) == (1.0, [0.0; 3], [0.0; 3]) {
        return Ok(mesh);
    }
    let rotation = rotation_of(*rotation);
    let wide = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from));
    let place = |p: &[f32; 3]| (wide(*position) + rotation * (f64::from(*scale) * wide(*p))).as_vec3().to_array();
    let positions = mesh.positions.iter().map(place).collect();
    // Coordinates that are too large are found here.
    let moved = Mesh::new(mesh.name.clone(), positions, mesh.triangles)?;
    mesh = Mesh { positions: moved.positions, triangles: moved.triangles, ..mesh };
    for normal in mesh.normals.iter_mut().flatten() {
        *normal = (rotation * wide(*normal)).normalize_or_zero().as_vec3().to_array();
    }
    for distance in mesh.materials.iter_mut().filter_map(|material| material.attenuation_distance.as_mut()) {
        *distance *= scale;
    }
    Ok(mesh)
}

/// The rotation about the x axis, then y, then z, by angles in degrees.
fn rotation_of(degrees: [f32; 3]) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.map(|angle| libm::sincos(f64::from(angle).to_radians()));
    DMat3::from_cols_array_2d(&[
        [cz * cy, sz * cy, -sy],
        [cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx],
        [cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx],
    ])
}

/// The meshes as one, whose materials are those of the first, then those of the second, and so on.
pub(crate) fn joined(meshes: Vec<Mesh>) -> Result<Mesh, Error> {
    let mut meshes = meshes;
    if meshes.len() < 2 {
        return meshes.pop().ok_or_else(|| Unrenderable::NoSource { kind: "mesh" }.into());
    }
    if meshes.iter().any(|mesh| mesh.colors.is_some()) {
        meshes = meshes.into_iter().map(with_colors).collect();
    }
    let has_normals = meshes.iter().any(|mesh| mesh.normals.is_some());
    let name = format!("{} and {} more", meshes[0].name, meshes.len() - 1);
    let source = meshes[0].source.clone();
    let vertices: usize = meshes.iter().map(|mesh| mesh.positions.len()).sum();
    if u32::try_from(vertices).is_err() {
        return Err(Unrenderable::TooManyVertices { name, vertices, limit: u32::MAX }.into());
    }
    let (mut positions, mut triangles) = (Vec::with_capacity(vertices), Vec::new());
    let (mut normals, mut colors) = (Vec::new(), Vec::new());
    let (mut materials, mut triangle_materials) = (Vec::new(), Vec::new());
    for mesh in meshes {
        let first = positions.len() as u32;
        let first_material = materials.len() as u32;
        if has_normals {
            // A vector of no length stands for a normal that nobody gave.
            normals.extend(mesh.normals.unwrap_or_else(|| vec![[0.0; 3]; mesh.positions.len()]));
        }
        colors.extend(mesh.colors.into_iter().flatten());
        positions.extend(mesh.positions);
        if mesh.materials.is_empty() {
            materials.push(Material::default());
            triangle_materials.resize(triangle_materials.len() + mesh.triangles.len(), first_material);
        } else {
            materials.extend(mesh.materials);
            triangle_materials.extend(mesh.triangle_materials.iter().map(|material| first_material + material));
        }
        triangles.extend(mesh.triangles.iter().map(|triangle| triangle.map(|vertex| first + vertex)));
    }
    let whole = Mesh::new(name, positions, triangles)?;
    Ok(Mesh {
        normals: has_normals.then_some(normals),
        colors: (!colors.is_empty()).then_some(colors),
        materials,
        triangle_materials,
        source,
        ..whole
    })
}

/// The mesh with a colour for each vertex; a vertex without a colour gets its material's. A vertex of triangles of several materials
/// becomes several vertices.
fn with_colors(mesh: Mesh) -> Mesh {
    if mesh.colors.is_some() {
        return mesh;
    }
    let mut known: HashMap<(u32, Option<u32>), u32> = HashMap::new();
    let mut sources: Vec<(u32, Rgb)> = Vec::new();
    let mut triangles = mesh.triangles.clone();
    for (index, triangle) in triangles.iter_mut().enumerate() {
        let material = mesh.triangle_materials.get(index).copied();
        let color = material.and_then(|number| mesh.materials.get(number as usize)?.base_color).unwrap_or(GREY);
        for vertex in triangle {
            *vertex = *known.entry((*vertex, material)).or_insert_with(|| {
                sources.push((*vertex, color));
                sources.len() as u32 - 1
            });
        }
    }
    let of = |values: &[[f32; 3]]| sources.iter().map(|(vertex, _)| values[*vertex as usize]).collect();
    Mesh {
        positions: of(&mesh.positions),
        normals: mesh.normals.as_deref().map(of),
        colors: Some(sources.iter().map(|(_, [red, green, blue])| [*red, *green, *blue, 1.0]).collect()),
        triangles,
        ..mesh
    }
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::*;
    use crate::builtin;

    fn source(builtin: &str) -> MeshSource {
        MeshSource { builtin: Some(builtin.to_owned()), ..MeshSource::default() }
    }

    fn load(sources: &[MeshSource]) -> Mesh {
        load_meshes(sources, Path::new(""), None).unwrap()
    }

    #[test]
    fn one_mesh_at_its_own_place_stays_as_it_is() {
        assert_eq!(load(&[source("torus")]), builtin::mesh("torus").unwrap());
        assert!(load_meshes(&[], Path::new(""), None).is_err());
    }

    /// x goes to y by a quarter of a turn about z; about x first, y goes to z.
    #[test]
    fn angles_turn_about_x_then_y_then_z() {
        let corner = |rotation| {
            let mesh = Mesh::new("corner", vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3]], vec![[0, 1, 2]]).unwrap();
            let source = MeshSource { rotation, scale: 2.0, position: [10.0, 20.0, 30.0], ..MeshSource::default() };
            let positions = placed(mesh, &source).unwrap().positions;
            positions.map_to_offsets([10.0, 20.0, 30.0])
        };
        assert_eq!(corner([0.0, 0.0, 90.0])[..2], [[0.0, 2.0, 0.0], [-2.0, 0.0, 0.0]]);
        assert_eq!(corner([90.0, 0.0, 0.0])[..2], [[2.0, 0.0, 0.0], [0.0, 0.0, 2.0]]);
        assert_eq!(corner([0.0, 90.0, 0.0])[..2], [[0.0, 0.0, -2.0], [0.0, 2.0, 0.0]]);
        // About x: x stays, y goes to z; then about z: x goes to y, z stays.
        assert_eq!(corner([90.0, 0.0, 90.0])[..2], [[0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]);
        // About x: y goes to z; then about y: z goes to x, x to -z.
        assert_eq!(corner([90.0, 90.0, 0.0])[..2], [[0.0, 0.0, -2.0], [2.0, 0.0, 0.0]]);
        assert_eq!(corner([0.0, 90.0, 90.0])[..2], [[0.0, 0.0, -2.0], [-2.0, 0.0, 0.0]]);
    }

    trait Offsets {
        fn map_to_offsets(self, from: [f32; 3]) -> Vec<[f32; 3]>;
    }

    impl Offsets for Vec<[f32; 3]> {
        fn map_to_offsets(self, from: [f32; 3]) -> Vec<[f32; 3]> {
            // Adding 0 turns -0 into 0.
            let offset = |p: [f32; 3]| std::array::from_fn(|axis| (p[axis] - from[axis]).round() + 0.0);
            self.into_iter().map(offset).collect()
        }
    }

    #[test]
    fn a_placed_mesh_has_the_volume_and_the_middle_that_its_place_says() {
        let plain = load(&[source("vase")]);
        let moved = load(&[MeshSource {
            scale: 2.0,
            rotation: [20.0, 40.0, 80.0],
            position: [3.0, -4.0, 5.0],
            ..source("vase")
        }]);
        assert!((moved.signed_volume() / plain.signed_volume() - 8.0).abs() < 1e-4);
        let far = load_meshes(&[MeshSource { position: [1e30, 0.0, 0.0], ..source("vase") }], Path::new(""), None);
        assert!(far.unwrap_err().to_string().contains("beyond"));
    }

    #[test]
    fn joined_meshes_keep_their_triangles_materials_and_colours() {
        let (torus, tree) = (builtin::mesh("torus").unwrap(), builtin::mesh("tree").unwrap());
        let whole = load(&[source("torus"), MeshSource { material: Some("gold".to_owned()), ..source("tree") }]);
        assert_eq!(whole.triangles.len(), torus.triangles.len() + tree.triangles.len());
        assert_eq!(whole.materials.len(), torus.materials.len() + 1);
        assert_eq!(whole.materials.last().unwrap().name, "gold");
        let counted = whole.triangle_materials.iter().filter(|number| **number == 1).count();
        assert_eq!((torus.materials.len(), counted), (1, tree.triangles.len()));
        assert!((whole.surface_area() / (torus.surface_area() + tree.surface_area()) - 1.0).abs() < 1e-6);
        for (mesh, number) in [(&torus, 0), (&tree, 1)] {
            // The first triangle of each has its corners where they were.
            let index = whole.triangle_materials.iter().position(|material| *material == number).unwrap();
            let corners = |mesh: &Mesh, index: usize| mesh.triangles[index].map(|v| mesh.positions[v as usize]);
            assert_eq!(corners(&whole, index), corners(mesh, 0));
        }
        assert_eq!(whole.colors.is_some(), tree.colors.is_some() || torus.colors.is_some());
    }

    #[test]
    fn vertices_of_several_materials_get_the_colour_of_each() {
        let mut mesh = Mesh::new(
            "two",
            vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            vec![[0, 1, 2], [0, 1, 3]],
        )
        .unwrap();
        let red = Material { base_color: Some([1.0, 0.0, 0.0]), ..Material::default() };
        mesh.materials = vec![red, Material::default()];
        mesh.triangle_materials = vec![0, 1];
        let colored = with_colors(mesh.clone());
        let colors = colored.colors.as_ref().unwrap();
        for (triangle, expected) in colored.triangles.iter().zip([[1.0, 0.0, 0.0], GREY]) {
            for vertex in triangle {
                assert_eq!(colors[*vertex as usize][..3], expected);
            }
        }
        assert_eq!(colored.positions.len(), 6);
        assert_eq!(colored.surface_area(), mesh.surface_area());
    }
}
