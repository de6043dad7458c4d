//! Rays through meshes, one by one: where they leave and which way they go.

use vitrum::backend::Backend;
use vitrum::method::voxels::{Rays, UploadedMesh};
use vitrum::method::{Tools, View};
use vitrum::scene::{MethodName, Scene, Voxels};
use vitrum::{Assets, Error, OutputRequest};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::path;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};

use crate::Failure;
use crate::case::Case;

/// A ray before and behind a mesh.
#[derive(Debug, Clone, Copy)]
pub struct Traced {
    /// A point on its way to the mesh, in the world.
    pub from: DVec3,
    /// Its unit direction there.
    pub towards: DVec3,
    /// A point behind the last surface.
    pub left: DVec3,
    /// Its unit direction there.
    pub direction: DVec3,
    /// The unit normal at its first surface, outwards; 0 if it met none.
    pub normal: DVec3,
    /// What is left of its light, green.
    pub transmittance: f64,
    /// Surfaces.
    pub bounces: u32,
    /// Its way inside, in world units.
    pub length: f64,
    /// One of [`vitrum_kernels::abi::record::fate`].
    pub status: f32,
}

/// A case that shows a mesh as a picture of `edge` × `edge` pixels, changed by `settings`.
///
/// # Errors
/// If a setting is wrong.
pub fn case(name: &str, mesh: Mesh, edge: u32, settings: &[&str]) -> Result<Case, Failure> {
    let mut scene = Scene { method: MethodName::Voxels, ..Scene::default() };
    (scene.film.width, scene.film.height) = (edge, edge);
    for setting in settings {
        scene.set(setting)?;
    }
    scene.check_settings()?;
    let name = [&[name], settings].concat().join(" ");
    Ok(Case { name, scene, assets: Assets::from(mesh), streamed: false, request: OutputRequest::default() })
}

/// Follows the rays of a case's pixels along their refracted ways.
///
/// # Errors
/// If the backend fails.
pub fn trace(case: &Case, backend: &mut dyn Backend) -> Result<Vec<Traced>, Failure> {
    let Case { scene, assets, .. } = case;
    let scene = &Scene { voxels: Voxels { branches: 1, ..scene.voxels.clone() }, ..scene.clone() };
    let uploaded = UploadedMesh::new(scene, assets, &mut Tools { backend: &mut *backend, progress: &mut |_| true })?;
    let rays = Rays::prepare(scene, assets, &uploaded, backend)?;
    let run = rays.run(backend, &mut |_| true).and_then(|()| rays.records(backend));
    let size = rays.rays;
    let grid = uploaded.grid;
    let records = run.map_err(Error::from)?;
    let count = size[0] as usize * size[1] as usize;
    let view = View::new(scene, &assets.subject);
    let traced = |index: usize| {
        let component = |c: usize| f64::from(records[c * count + index]);
        let vector = |c: usize| DVec3::new(component(c), component(c + 1), component(c + 2));
        let share = |at: usize, edge: u32| (at as f64 + 0.5) / f64::from(edge) * 2.0 - 1.0;
        let across = share(index % size[0] as usize, size[0]) * view.half_size[0];
        let up = -share(index / size[0] as usize, size[1]) * view.half_size[1];
        let side = view.axes.x_axis * across + view.axes.y_axis * up;
        let (from, towards) = if view.orthographic {
            (view.eye + side, view.axes.z_axis)
        } else {
            (view.eye, (view.axes.z_axis + side).normalize())
        };
        Traced {
            from,
            towards,
            left: DVec3::from_array(grid.origin) + vector(path::POSITION) * grid.voxel_size,
            direction: vector(path::DIRECTION).normalize(),
            normal: vector(path::NORMAL),
            transmittance: component(path::TRANSMITTANCE + 1),
            bounces: component(path::BOUNCES) as u32,
            length: component(path::LENGTH) * grid.voxel_size,
            status: component(path::STATUS) as f32,
        }
    };
    Ok((0..count).map(traced).collect())
}

/// The unit directions in the world that a plane sweep through the case's mesh gives the rays of its pixels; `None` where they did not
/// go through.
///
/// # Errors
/// If the scene is not valid for a sweep, or the backend fails.
pub fn sweep(case: &Case, backend: &mut dyn Backend) -> Result<Vec<Option<DVec3>>, Failure> {
    let scene = Scene { method: MethodName::Sweep, ..case.scene.clone() };
    let frame = vitrum::render(&scene, &case.assets, backend, &mut |_| true)?;
    let missing = |name: &str| Failure::Setup(format!("a frame has no `{name}`"));
    let channel = |name: &str, channel| frame.channel(name, channel).ok_or_else(|| missing(name));
    let [x, y, z] = [channel("direction", "X")?, channel("direction", "Y")?, channel("direction", "Z")?];
    let status = channel("status", "Y")?;
    let View { axes, .. } = View::new(&scene, &case.assets.subject);
    let direction = |pixel: usize| {
        let [right, up, back] = [x[pixel], y[pixel], z[pixel]].map(f64::from);
        axes * DVec3::new(right, up, -back)
    };
    let went_through = |pixel: usize| status[pixel] == vitrum_kernels::abi::record::status::ACTIVE;
    Ok((0..status.len()).map(|pixel| went_through(pixel).then(|| direction(pixel))).collect())
}

/// The direction of a ray behind a surface with outward normal `n`, from index `from` to `to`; `None` if all is reflected.
#[must_use]
pub fn refract(d: DVec3, n: DVec3, from: f64, to: f64) -> Option<DVec3> {
    let n = if d.dot(n) > 0.0 { -n } else { n };
    let (ratio, cosine) = (from / to, -d.dot(n));
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (squared > 0.0).then(|| (d * ratio + n * (ratio * cosine - squared.sqrt())).normalize())
}

/// What becomes of a ray that meets the unit ball around the origin: where it leaves and its direction there. No ray is reflected
/// totally on its way out of a ball that it got into.
#[must_use]
pub fn through_ball(from: DVec3, towards: DVec3, ior: f64) -> Option<[DVec3; 2]> {
    let middle = -from.dot(towards);
    let squared = 1.0 - (from + towards * middle).length_squared();
    let enters = (squared > 0.0).then(|| from + towards * (middle - squared.sqrt()))?;
    let inside = refract(towards, enters, 1.0, ior)?;
    let leaves = enters - inside * (2.0 * enters.dot(inside));
    Some([leaves, refract(inside, leaves, ior, 1.0)?])
}

/// The unit ball around the origin as a grid of longitudes and latitudes, with its normals.
///
/// # Panics
/// Never: the mesh is valid.
#[must_use]
pub fn ball(latitudes: u32) -> Mesh {
    let longitudes = 2 * latitudes;
    // No edge along an axis.
    let turned = DQuat::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    let mut positions = vec![DVec3::Z];
    for j in 1..latitudes {
        let (sin, cos) = (std::f64::consts::PI * f64::from(j) / f64::from(latitudes)).sin_cos();
        positions.extend((0..longitudes).map(|i| {
            let (s, c) = (std::f64::consts::TAU * f64::from(i) / f64::from(longitudes)).sin_cos();
            DVec3::new(sin * c, sin * s, cos)
        }));
    }
    positions.push(-DVec3::Z);
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
    let positions: Vec<[f32; 3]> = positions.iter().map(|p| (turned * *p).as_vec3().to_array()).collect();
    let mut mesh = Mesh::new("ball", positions, triangles).expect("a valid mesh");
    mesh.normals = Some(mesh.positions.clone());
    mesh
}

/// The faces of a box, outwards, by its corners: bit `a` of a corner's number says that it lies at the high end of axis `a`.
#[rustfmt::skip]
pub const BOX: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// A box around the origin, its half edges `half`, turned by `turned`.
///
/// # Panics
/// Never: the mesh is valid.
#[must_use]
pub fn cuboid(half: DVec3, turned: DQuat) -> Mesh {
    let sign = |bits: usize, axis: usize| if bits >> axis & 1 == 1 { 1.0 } else { -1.0 };
    let corner = |bits: usize| turned * (half * DVec3::new(sign(bits, 0), sign(bits, 1), sign(bits, 2)));
    let triangles = BOX.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let positions = (0..8).map(|bits| corner(bits).as_vec3().to_array()).collect();
    Mesh::new("box", positions, triangles).expect("a valid mesh")
}

/// A prism of 60° around the z axis, and the outward normals of the two faces that light along −y meets. Turned by −0.325, its least deviation.
///
/// # Panics
/// Never: the mesh is valid.
#[must_use]
pub fn prism(turned: f64) -> (Mesh, [DVec3; 2]) {
    let corner = |degrees: f64, z: f64| {
        let (sin, cos) = (degrees.to_radians() + turned).sin_cos();
        [cos as f32, sin as f32, z as f32]
    };
    let positions: Vec<[f32; 3]> =
        [-0.6, 0.6].iter().flat_map(|&z| [0.0, 120.0, 240.0].map(|degrees| corner(degrees, z))).collect();
    #[rustfmt::skip]
    let triangles = vec![
        [0, 2, 1], [3, 4, 5],
        [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5],
    ];
    let normal = |degrees: f64| {
        let (sin, cos) = (degrees.to_radians() + turned).sin_cos();
        DVec3::new(cos, sin, 0.0)
    };
    (Mesh::new("prism", positions, triangles).expect("a valid mesh"), [normal(60.0), normal(-60.0)])
}

/// Several meshes in one, each of a material of its own, `m0`, `m1`, and so on.
///
/// # Panics
/// Never: meshes that are valid make one that is.
#[must_use]
pub fn together(parts: &[Mesh]) -> Mesh {
    let (mut positions, mut triangles, mut materials) = (Vec::new(), Vec::new(), Vec::new());
    for (number, part) in (0..).zip(parts) {
        let base = positions.len() as u32;
        positions.extend(&part.positions);
        triangles.extend(part.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + base)));
        materials.resize(triangles.len(), number);
    }
    let mut mesh = Mesh::new("together", positions, triangles).expect("a valid mesh");
    mesh.materials =
        (0..parts.len()).map(|n| vitrum_io::Material { name: format!("m{n}"), ..Default::default() }).collect();
    mesh.triangle_materials = materials;
    mesh
}
