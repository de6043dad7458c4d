//! Procedural meshes and the scenes that show them.
//!
//! Meshes stand upright along +z around the world's origin, their longest edge about 2 world units. Their vertices are computed with
//! additions, multiplications, divisions and square roots only, so that every machine makes the same.

mod angel_ball;
mod gem;
mod glass_ball;
mod goblet;
mod growth;
mod parts;
mod patches;
mod revolve;
mod ring;
mod statue;
mod still_life;
mod surface;
mod torus;
mod tree;
mod vase;
mod waves;

use super::SceneEntry;
use crate::preset::surround_mesh;
use crate::scene::{Camera, Environment, EnvironmentKind, Medium, MeshSource, MethodName, Scene, Shading};
use vitrum_io::Mesh;

/// Name and maker of a mesh.
type MeshEntry = (&'static str, fn(&str) -> Mesh);

/// Name and maker of a mesh that moves: a moment in seconds, and how many metres the mesh's unit is.
type MovingEntry = (&'static str, fn(&str, f64, f64) -> Mesh);

pub(super) const SCENES: &[&[SceneEntry]] = &[
    vase::SCENES,
    angel_ball::SCENES,
    goblet::SCENES,
    still_life::SCENES,
    torus::SCENES,
    tree::SCENES,
    glass_ball::SCENES,
    ring::SCENES,
    gem::SCENES,
    waves::SCENES,
    statue::SCENES,
];

pub(super) const MESHES: &[MeshEntry] = &[
    ("vase", vase::mesh),
    ("angel-ball", angel_ball::mesh),
    ("goblet", goblet::mesh),
    ("still-life", still_life::mesh),
    ("torus", torus::mesh),
    ("tree", tree::mesh),
    ("ball", glass_ball::mesh),
    ("ring", ring::mesh),
    ("gem", gem::mesh),
    ("waves", waves::mesh),
    ("statue", statue::mesh),
];

/// The meshes of [`MESHES`] that move; there they are at 0 seconds.
pub(super) const MOVING: &[MovingEntry] = &[("waves", waves::at)];

#[cfg(test)]
/// Meshes whose bodies are not meant to be clear, and need not be closed.
const OPAQUE: [&str; 1] = ["tree"];

/// Rays through the procedural mesh of that name, in the surroundings that meshes have by default.
fn rays_through(name: &str) -> Scene {
    let mut scene = Scene {
        method: MethodName::Voxels,
        mesh: vec![MeshSource { builtin: Some(name.to_owned()), ..MeshSource::default() }],
        camera: Camera { azimuth: 0.0, elevation: 10.0, ..Camera::default() },
        ..Scene::default()
    };
    surround_mesh(&mut scene);
    scene
}

/// Beams of light around the procedural mesh of that name, in a medium and in the dark.
fn in_medium(name: &str, medium: Medium) -> Scene {
    Scene {
        method: MethodName::Beams,
        mesh: vec![MeshSource { builtin: Some(name.to_owned()), ..MeshSource::default() }],
        medium: Some(medium),
        environment: Environment { kind: EnvironmentKind::Color, color: [0.0; 3], ..Environment::default() },
        shading: Shading { ambient: [0.0; 3], ..Shading::default() },
        ..Scene::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::voxels::bodies;
    use glam::Vec3;

    #[test]
    fn bodies_are_closed_and_face_outwards() {
        for (name, make) in MESHES {
            let mesh = make(name);
            if OPAQUE.contains(name) {
                continue;
            }
            assert_eq!(mesh.degenerate_triangle_count(), 0, "{name}");
            for body in bodies(&mesh, &[]).unwrap() {
                let topology = body.mesh.topology();
                // Where the angel's surface all but touches itself, four triangles may share an edge.
                assert!(
                    topology.unpaired_edges == 0 && topology.edges > 0,
                    "{name}, {:?}: {topology:?}",
                    body.material
                );
                // Bodies are turned outwards as a whole; here they must be so from the start.
                let first = mesh.triangle_materials.iter().position(|material| Some(*material) == body.material);
                let corners = |mesh: &Mesh, index: usize| mesh.triangles[index].map(|at| mesh.positions[at as usize]);
                let expected = corners(&mesh, first.unwrap());
                assert_eq!(corners(&body.mesh, 0), expected, "{name}, {:?}", body.material);
            }
        }
    }

    #[test]
    fn normals_are_unit_vectors_that_face_outwards() {
        for (name, make) in MESHES {
            let mesh = make(name);
            let Some(normals) = &mesh.normals else { continue };
            assert_eq!(normals.len(), mesh.positions.len(), "{name}");
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|vertex| Vec3::from_array(mesh.positions[vertex as usize]));
                let flat = (b - a).cross(c - a).normalize();
                for vertex in triangle {
                    let normal = Vec3::from_array(normals[*vertex as usize]);
                    assert!((normal.length() - 1.0).abs() < 1e-5, "{name}: {normal}");
                    assert!(flat.dot(normal) > 0.99, "{name}: {flat} and {normal}");
                }
            }
        }
    }

    #[test]
    fn meshes_have_the_size_and_the_place_of_volumes() {
        for (name, make) in MESHES {
            let [low, high] = make(name).bounds();
            let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f32::max);
            assert!((1.5..3.0).contains(&longest), "{name}: {longest}");
            for axis in 0..2 {
                assert!((low[axis] + high[axis]).abs() < 0.3 * longest, "{name}");
            }
        }
    }

    /// FNV-1a of the vertices: they are the same on every machine.
    #[test]
    fn vertices_are_the_same_everywhere() {
        let fingerprint = |mesh: &Mesh| {
            let bytes = mesh.positions.iter().flatten().flat_map(|coordinate| coordinate.to_le_bytes());
            bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
        };
        let found: Vec<_> = MESHES.iter().map(|(name, make)| (*name, fingerprint(&make(name)))).collect();
        assert_eq!(found, FINGERPRINTS);
    }

    const FINGERPRINTS: [(&str, u64); 11] = [
        ("vase", 0x1aa4_d024_fddf_10d2),
        ("angel-ball", 0xa989_dc5d_3920_0e2c),
        ("goblet", 0xfda8_163f_a293_d318),
        ("still-life", 0x56ba_5299_03a5_8b73),
        ("torus", 0xd1f5_3093_de58_5ca5),
        ("tree", 0x4bc5_0515_ed77_e268),
        ("ball", 0x8e76_49fd_b83c_dbc5),
        ("ring", 0x093c_890f_5396_8285),
        ("gem", 0xb159_a9aa_6928_8c45),
        ("waves", 0xbde2_f338_1f09_a8f7),
        ("statue", 0xca51_88b8_6848_15b7),
    ];
}
