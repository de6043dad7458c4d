//! A tree in leaf on the ground (Chang et al. 2010, Fig. 2).

use super::super::SceneEntry;
use super::growth::{Branch, Random, Wood};
use super::rays_through;
use crate::scene::{
    Camera, Coefficient, Environment, EnvironmentKind, Ground, Light, LightKind, Material as SceneMaterial, Scene,
    Shading,
};
use glam::Vec3;
use vitrum_io::{Material, Mesh};

pub(in super::super) const SCENES: &[SceneEntry] = &[
    ("tree", "the transparent shadow of a tree: dark under the trunk, airy under the leaves", scene),
    ("tree/lamp", "the tree at night, in the light of a lamp beside it and of a spot", lamp),
    ("tree/uniform", "the tree's shadow with one absorption coefficient for all voxels, for comparison", uniform),
];

fn scene() -> Scene {
    let opaque = |name: &str, density: f32| SceneMaterial {
        name: Some(name.to_owned()),
        opaque: true,
        density,
        ..SceneMaterial::default()
    };
    Scene {
        material: vec![opaque("bark", 16.0), opaque("leaves", 0.12)],
        camera: Camera { azimuth: 0.0, elevation: 13.0, target: Some([-0.5, 0.1, -0.16]), ..Camera::default() },
        light: vec![Light {
            azimuth: -62.0,
            elevation: 42.0,
            intensity: 1.05,
            color: [1.0, 0.96, 0.88],
            ..Light::default()
        }],
        shading: Shading { ambient: [0.16, 0.19, 0.24], ..Shading::default() },
        ground: Some(Ground { color: [0.72, 0.70, 0.64], ..Ground::default() }),
        environment: Environment {
            kind: EnvironmentKind::Gradient,
            color: [0.25, 0.42, 0.72],
            horizon: [0.80, 0.86, 0.92],
            nadir: [0.60, 0.58, 0.54],
            ..Environment::default()
        },
        ..rays_through("tree")
    }
}

fn uniform() -> Scene {
    let mut scene = scene();
    scene.shadow.coefficient = Coefficient::Uniform;
    scene.shadow.optical_depth = 0.15;
    scene
}

fn lamp() -> Scene {
    let mut scene = scene();
    scene.light = vec![
        Light {
            position: Some([1.25, 0.5, 0.35]),
            color: [1.0, 0.72, 0.42],
            intensity: 1.5,
            ..Light::of_kind(LightKind::Point)
        },
        Light {
            position: Some([-1.7, -1.3, 2.6]),
            direction: Some([1.6, 1.5, -3.2]),
            color: [0.55, 0.7, 1.0],
            intensity: 9.0,
            cone_angle: 16.0,
            penumbra: 0.4,
            ..Light::of_kind(LightKind::Spot)
        },
    ];
    scene.shading.ambient = [0.008, 0.012, 0.022];
    scene.environment.color = [0.002, 0.004, 0.012];
    scene.environment.horizon = [0.006, 0.008, 0.014];
    scene.environment.nadir = [0.01, 0.01, 0.012];
    scene
}

/// Linear colours between which leaves vary.
const LEAVES: [Vec3; 2] = [Vec3::new(0.10, 0.24, 0.03), Vec3::new(0.36, 0.46, 0.08)];
const BARK: Vec3 = Vec3::new(0.20, 0.13, 0.08);

/// Branches of each order: how many grow out of one of the order before, where the first of them does, as a part of its length,
/// how long they are compared with it, how much they keep of its direction, and how much they bend.
struct Order {
    count: u32,
    from: f32,
    length: f32,
    along: f32,
    bend: f32,
}

const ORDERS: [Order; 3] = [
    Order { count: 13, from: 0.42, length: 0.62, along: 0.75, bend: 0.25 },
    Order { count: 8, from: 0.30, length: 0.52, along: 0.9, bend: 0.4 },
    Order { count: 6, from: 0.25, length: 0.5, along: 0.9, bend: 0.5 },
];

/// Leaves of a twig.
const TWIG_LEAVES: u32 = 40;

pub(in super::super) fn mesh(name: &str) -> Mesh {
    let mut random = Random(1);
    let trunk = Branch { base: Vec3::new(0.0, 0.0, -1.0), direction: Vec3::Z, length: 1.5, radius: 0.075, bend: 0.10 };
    let mut wood = Wood::default();
    let mut twigs = Vec::new();
    grow(&trunk, 0, &mut random, &mut wood, &mut twigs);
    let bark_vertices = wood.part.positions.len();
    let bark_triangles = wood.part.triangles.len();
    let mut colors: Vec<[f32; 4]> = vec![BARK.extend(1.0).to_array(); bark_vertices];
    for twig in &twigs {
        for _ in 0..TWIG_LEAVES {
            let shade = random.next();
            leaf(twig, &mut random, &mut wood);
            let color = LEAVES[0] + (LEAVES[1] - LEAVES[0]) * shade;
            colors.resize(wood.part.positions.len(), color.extend(1.0).to_array());
        }
    }
    let triangles = wood.part.triangles.len();
    let mut mesh = wood.part.into_mesh(name);
    let material = |name: &str, color: Vec3| Material {
        name: name.to_owned(),
        base_color: Some(color.to_array()),
        ..Material::default()
    };
    mesh.materials = vec![material("bark", BARK), material("leaves", (LEAVES[0] + LEAVES[1]) * 0.5)];
    mesh.triangle_materials = (0..triangles).map(|index| u32::from(index >= bark_triangles)).collect();
    mesh.colors = Some(colors);
    mesh
}

/// A branch and all that grow out of it.
fn grow(branch: &Branch, order: usize, random: &mut Random, wood: &mut Wood, twigs: &mut Vec<Vec<Vec3>>) {
    let way = wood.add(branch, random);
    let Some(next) = ORDERS.get(order) else {
        twigs.push(way);
        return;
    };
    for number in 0..next.count {
        let part = next.from + (1.0 - next.from) * (number as f32 + 0.8 * random.next()) / next.count as f32;
        let (base, along) = branch.at(&way, part);
        // Around the branch, and a little upwards.
        let around = random.direction();
        let outwards = (around - along * around.dot(along)).normalize();
        let direction = (outwards + along * next.along + Vec3::Z * 0.15).normalize();
        // The crown is round: those that begin high are short.
        let length = branch.length * next.length * (0.75 + 0.5 * random.next()) * (1.15 - 0.6 * part * part);
        let radius = branch.radius_at(part) * 0.6;
        let child = Branch { base, direction, length, radius, bend: next.bend };
        grow(&child, order + 1, random, wood, twigs);
    }
}

/// A leaf somewhere along a twig: a rhombus.
fn leaf(twig: &[Vec3], random: &mut Random, wood: &mut Wood) {
    let along = random.next() * (twig.len() - 1) as f32 * 0.999;
    let joint = along as usize;
    let stem = twig[joint] + (twig[joint + 1] - twig[joint]) * (along - joint as f32);
    let direction = (random.direction() + Vec3::new(0.0, 0.0, 0.1)).normalize();
    let across = random.direction();
    let side = (across - direction * across.dot(direction)).normalize();
    let length = 0.045 + 0.03 * random.next();
    let base = stem + direction * (0.25 * length);
    let middle = base + direction * (0.45 * length);
    let width = 0.28 * length;
    let part = &mut wood.part;
    let first = part.positions.len() as u32;
    let corners = [base, middle + side * width, base + direction * length, middle - side * width];
    part.positions.extend(corners.map(|corner| corner.to_array()));
    part.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
}
