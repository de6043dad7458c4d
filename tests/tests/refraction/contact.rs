//! Bodies that touch: slabs with a common face, a cube flush with the face of another, a shell and what fills it, and gaps between them.
//!
//! Distances between faces are shares of the mesh's longest edge. Rays run through the triangles themselves.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{BOX, Traced, case, together, trace};
use vitrum_io::Mesh;
use vitrum_kernels::abi::record::fate;
use vitrum_kernels::glam::{DQuat, DVec3};

/// Pixels along each side.
const EDGE: usize = 48;
/// Shares of the longest edge that are contact: gaps, and an overlap.
const IN_CONTACT: [f64; 4] = [0.0, 1e-7, 1e-6, -1e-6];
/// A share that is a gap, or a body.
const APART: f64 = 1e-5;

/// The triangles of a box, whose corners are counted by x, then y, then z; `faces_in`: they face inwards; `across`: each quadrilateral is cut
/// along its other diagonal.
fn triangles(faces_in: bool, across: bool) -> Vec<[u32; 3]> {
    let cut = |[a, b, c, d]: [u32; 4]| if across { [[b, c, d], [b, d, a]] } else { [[a, b, c], [a, c, d]] };
    let turned = |[a, b, c]: [u32; 3]| if faces_in { [a, c, b] } else { [a, b, c] };
    BOX.into_iter().flat_map(cut).map(turned).collect()
}

/// A box between two corners, turned around the origin.
fn block(low: DVec3, high: DVec3, turned: DQuat, faces_in: bool, across: bool) -> Mesh {
    let corner = |bits: usize| {
        let end = |axis: usize| if bits >> axis & 1 == 1 { high[axis] } else { low[axis] };
        (turned * DVec3::new(end(0), end(1), end(2))).as_vec3().to_array()
    };
    Mesh::new("block", (0..8).map(corner).collect(), triangles(faces_in, across)).expect("a valid mesh")
}

/// Two meshes of one material.
fn joined(one: &Mesh, other: &Mesh) -> Mesh {
    let base = one.positions.len() as u32;
    let mut both = one.clone();
    both.positions.extend(&other.positions);
    both.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|corner| corner + base)));
    both
}

/// The rays along −y that meet a mesh within `half` of the middle of the picture, or all.
fn rays(mesh: Mesh, settings: &[&str], half: f64, backend: &mut dyn Backend) -> Result<Vec<Traced>, Failure> {
    let along_y = [
        "camera.projection=orthographic",
        "camera.azimuth=0",
        "camera.elevation=0",
        "environment.kind=color",
        "voxels.surfaces=exact",
    ];
    let case = case("contact", mesh, EDGE as u32, &[&along_y[..], settings].concat())?;
    let mut found = trace(&case, backend)?;
    found.retain(|ray| ray.from.x.abs() < half && ray.from.z.abs() < half);
    assert!(found.len() > 20);
    Ok(found)
}

/// A layer that a ray goes through: its thickness and index of refraction.
type Layer = (f64, f64);

/// How far parallel layers move a ray to the side that meets them at an angle, and its way inside.
fn through_layers(layers: &[Layer], degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    layers.iter().fold([0.0; 2], |[side, length], &(thickness, ior)| {
        let cosine = (1.0 - (sin / ior).powi(2)).sqrt();
        // sin(θ − θ') by the difference of angles.
        [side + thickness * (sin * cosine - cos * sin / ior) / cosine, length + thickness / cosine]
    })
}

/// The largest errors of rays that meet parallel layers.
#[derive(Default)]
struct Errors {
    side: f64,
    turn: f64,
    length: f64,
}

impl Errors {
    fn add(&mut self, rays: &[Traced], layers: &[Layer], degrees: f64, bounces: u32, what: &str) {
        let [side, length] = through_layers(layers, degrees);
        for ray in rays {
            assert_eq!((ray.bounces, ray.status), (bounces, fate::LEFT), "{what} at {}", ray.from);
            let aside = ray.left - ray.from;
            let found = (aside - ray.towards * aside.dot(ray.towards)).length();
            self.side = larger(self.side, (found - side).abs());
            self.turn = larger(self.turn, ray.direction.angle_between(ray.towards));
            self.length = larger(self.length, (ray.length - length).abs());
        }
    }
}

const TWO: &str = "material=[{name=\"m0\",ior=1.5},{name=\"m1\",ior=1.33}]";

/// Slabs of glass and water, in either order and with faces either way, from contact to contact: three surfaces.
#[test]
fn slabs_with_a_common_face_refract_once_between_them() -> Result<(), Failure> {
    on_both(|backend| {
        let mut errors = Errors::default();
        for degrees in [0.0, 20.0, 45.0, 60.0] {
            let turned = DQuat::from_rotation_z(f64::to_radians(degrees));
            for share in IN_CONTACT {
                let gap = share * 2.0;
                for kind in 0..8 {
                    let [swapped, inwards, across] = [0, 1, 2].map(|bit| kind >> bit & 1 == 1);
                    let near = block(DVec3::new(-1.0, gap, -1.0), DVec3::new(1.0, 0.3, 1.0), turned, inwards, false);
                    let far = block(DVec3::new(-1.0, -0.3, -1.0), DVec3::new(1.0, 0.0, 1.0), turned, inwards, across);
                    let parts = if swapped { [far, near] } else { [near, far] };
                    let found = rays(together(&parts), &[TWO], 0.2, backend)?;
                    let what = format!("{degrees}°, gap {share}, kind {kind}");
                    errors.add(&found, &[(0.3, 1.5), (0.3, 1.33)], degrees, 3, &what);
                }
            }
        }
        table::CONTACT_SIDE.hold(errors.side, backend);
        table::CONTACT_TURN.hold(errors.turn, backend);
        table::CONTACT_LENGTH.hold(errors.length, backend);
        Ok(())
    })
}

/// Light is reflected at the face between two bodies by their ratio of indices: (1 − F₁)(1 − F₁₂)(1 − F₂) goes through at right angles.
#[test]
fn a_common_face_reflects_by_both_indices() -> Result<(), Failure> {
    let fresnel = |one: f64, other: f64| 1.0 - ((one - other) / (one + other)).powi(2);
    let expected = fresnel(1.0, 1.5) * fresnel(1.5, 1.33) * fresnel(1.33, 1.0);
    on_both(|backend| {
        let mut error = 0.0;
        for share in IN_CONTACT {
            let near =
                block(DVec3::new(-1.0, share * 2.0, -1.0), DVec3::new(1.0, 0.3, 1.0), DQuat::IDENTITY, false, false);
            let far = block(DVec3::new(-1.0, -0.3, -1.0), DVec3::new(1.0, 0.0, 1.0), DQuat::IDENTITY, false, true);
            for ray in rays(together(&[near, far]), &[TWO], 0.5, backend)? {
                error = larger(error, (ray.transmittance - expected).abs());
            }
        }
        table::CONTACT_FRESNEL.hold(error, backend);
        Ok(())
    })
}

const ABSORBING: &str = "material=[{name=\"m0\",ior=1.5,attenuation_color=[1,0.5,1],attenuation_distance=1},\
                         {name=\"m1\",ior=1.2,attenuation_color=[1,0.1,1],attenuation_distance=1}]";

/// A smaller box that is flush with the near or with the far face of a larger one: it fills its space up to that face.
#[test]
fn a_box_flush_with_the_face_of_another_is_behind_it() -> Result<(), Failure> {
    on_both(|backend| {
        let mut errors = Errors::default();
        let mut transmittance = 0.0;
        let (degrees, outer) = (30.0, DVec3::new(1.0, 0.5, 1.0));
        let turned = DQuat::from_rotation_z(f64::to_radians(degrees));
        for share in IN_CONTACT {
            let deep = share * 2.0;
            for kind in 0..4 {
                let [far, swapped] = [0, 1].map(|bit| kind >> bit & 1 == 1);
                let [low, high] = if far { [-0.5 + deep, 0.0] } else { [0.0, 0.5 - deep] };
                let inner = block(DVec3::new(-0.8, low, -0.8), DVec3::new(0.8, high, 0.8), turned, false, true);
                let whole = block(-outer, outer, turned, false, false);
                // The names of materials go with the order.
                let (parts, material) = if swapped {
                    ([inner, whole], ABSORBING.replace("m0", "m2").replace("m1", "m0").replace("m2", "m1"))
                } else {
                    ([whole, inner], ABSORBING.to_owned())
                };
                let settings = [&material[..], "voxels.reflection=false"];
                let found = rays(together(&parts), &settings, 0.2, backend)?;
                let what = format!("gap {share}, kind {kind}");
                errors.add(&found, &[(0.5, 1.5), (0.5, 1.2)], degrees, 3, &what);
                let [[_, first], [_, second]] = [(0.5, 1.5), (0.5, 1.2)].map(|layer| through_layers(&[layer], degrees));
                let expected = 0.5f64.powf(first) * 0.1f64.powf(second);
                for ray in found {
                    transmittance = larger(transmittance, (ray.transmittance / expected - 1.0).abs());
                }
            }
        }
        table::FLUSH_SIDE.hold(errors.side, backend);
        table::FLUSH_TRANSMITTANCE.hold(transmittance, backend);
        Ok(())
    })
}

/// A shell, whose cavity's walls face inwards, and what fills the cavity up to contact: four surfaces.
#[test]
fn a_shell_and_its_filling_are_met_one_behind_the_other() -> Result<(), Failure> {
    on_both(|backend| {
        let mut errors = Errors::default();
        let mut transmittance = 0.0;
        let (degrees, outer, inner) = (40.0, DVec3::new(1.0, 0.5, 1.0), DVec3::new(0.8, 0.3, 0.8));
        let turned = DQuat::from_rotation_z(f64::to_radians(degrees));
        let layers = [(0.2, 1.5), (0.6, 1.2), (0.2, 1.5)];
        let ways = layers.map(|layer| through_layers(&[layer], degrees)[1]);
        let expected = 0.5f64.powf(ways[0] + ways[2]) * 0.1f64.powf(ways[1]);
        for share in IN_CONTACT {
            for across in [false, true] {
                let shell =
                    joined(&block(-outer, outer, turned, false, false), &block(-inner, inner, turned, true, false));
                let filled = inner - DVec3::splat(share * 2.0);
                let filling = block(-filled, filled, turned, false, across);
                let settings = [ABSORBING, "voxels.reflection=false"];
                let found = rays(together(&[shell, filling]), &settings, 0.2, backend)?;
                errors.add(&found, &layers, degrees, 4, &format!("gap {share}, cut across: {across}"));
                for ray in found {
                    transmittance = larger(transmittance, (ray.transmittance / expected - 1.0).abs());
                }
            }
        }
        table::SHELL_SIDE.hold(errors.side, backend);
        table::SHELL_TRANSMITTANCE.hold(transmittance, backend);
        Ok(())
    })
}

/// A hundred-thousandth of the mesh's size is a gap of its own, and a plate of its own.
#[test]
fn gaps_and_plates_that_are_thin_have_two_faces() -> Result<(), Failure> {
    on_both(|backend| {
        let mut errors = Errors::default();
        let thin = APART * 2.0;
        for degrees in [0.0, 20.0, 45.0] {
            let turned = DQuat::from_rotation_z(f64::to_radians(degrees));
            let near = block(DVec3::new(-1.0, thin, -1.0), DVec3::new(1.0, 0.3, 1.0), turned, false, false);
            let far = block(DVec3::new(-1.0, -0.3, -1.0), DVec3::new(1.0, 0.0, 1.0), turned, false, true);
            let layers = [(0.3 - thin, 1.5), (0.3, 1.33)];
            errors.add(&rays(together(&[near, far]), &[TWO], 0.2, backend)?, &layers, degrees, 4, "a gap");
            let plate = block(DVec3::new(-1.0, 0.0, -1.0), DVec3::new(1.0, thin, 1.0), turned, false, false);
            errors.add(&rays(plate, &["material=[{ior=1.5}]"], 0.2, backend)?, &[(thin, 1.5)], degrees, 2, "a plate");
        }
        table::THIN_SIDE.hold(errors.side, backend);
        table::THIN_LENGTH.hold(errors.length, backend);
        Ok(())
    })
}

/// A box whose two large faces are grids with a corner at the middle of each pixel, so that every ray meets a corner, and the outermost the
/// edges of the box, as exactly as numbers have it. A ray goes straight through, or, along a side, past the box.
#[test]
fn no_ray_slips_through_an_edge_or_a_corner() -> Result<(), Failure> {
    // The picture shows 0.87 radii of the sphere around the box to each side.
    let (edge, thickness) = (1.0f64, 0.5);
    let half = 0.87 * (2.0 * edge * edge + 0.25 * thickness * thickness).sqrt();
    // An odd number of pixels has one in the middle, whose centre is 0; the last ones within the box are on its edge.
    let (pixels, last) = (33usize, 13i32);
    let pitch = 2.0 * half / pixels as f64;
    let exactly = f64::from(last) * pitch;
    let scale = edge / exactly;
    let side = 2 * last as u32 + 1;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for y in [-0.5 * thickness, 0.5 * thickness] {
        for k in -last..=last {
            positions.extend((-last..=last).map(|i| {
                DVec3::new(f64::from(i) * pitch * scale, y, f64::from(k) * pitch * scale).as_vec3().to_array()
            }));
        }
    }
    let at = |layer: u32, i: u32, k: u32| layer * side * side + k * side + i;
    let mut quad = |[a, b, c, d]: [u32; 4]| triangles.extend([[a, b, c], [a, c, d]]);
    for k in 0..side - 1 {
        for i in 0..side - 1 {
            quad([at(0, i, k), at(0, i + 1, k), at(0, i + 1, k + 1), at(0, i, k + 1)]);
            quad([at(1, i, k), at(1, i, k + 1), at(1, i + 1, k + 1), at(1, i + 1, k)]);
        }
        let (low, high) = (0, side - 1);
        quad([at(0, k, low), at(1, k, low), at(1, k + 1, low), at(0, k + 1, low)]);
        quad([at(0, k + 1, high), at(1, k + 1, high), at(1, k, high), at(0, k, high)]);
        quad([at(0, low, k + 1), at(1, low, k + 1), at(1, low, k), at(0, low, k)]);
        quad([at(0, high, k), at(1, high, k), at(1, high, k + 1), at(0, high, k + 1)]);
    }
    let mesh = Mesh::new("grid", positions, triangles).expect("a valid mesh");
    assert!(mesh.topology().is_closed() && mesh.signed_volume() > 0.0);
    on_both(|backend| {
        let settings = [
            "camera.projection=orthographic",
            "camera.azimuth=0",
            "camera.elevation=0",
            "environment.kind=color",
            "voxels.surfaces=exact",
            "voxels.normals=paper",
            // The picture's edge is that of pixels whose centres are corners.
            &format!("camera.zoom={}", 1.0 / scale),
        ];
        let case = case("corners", mesh.clone(), pixels as u32, &settings)?;
        let mut through = 0;
        for ray in trace(&case, backend)? {
            let (x, z) = (ray.from.x.abs(), ray.from.z.abs());
            let inside = x.max(z) < edge - 1e-5;
            let outside = x.max(z) > edge + 1e-5;
            let what = format!("at {}: {} surfaces, {} inside", ray.from, ray.bounces, ray.length);
            assert_eq!(ray.status, fate::LEFT, "{what}");
            let goes_through = ray.bounces == 2 && (ray.length - thickness).abs() < 1e-5;
            let passes = ray.bounces == 0 && ray.length == 0.0;
            assert!(if inside { goes_through } else { passes || !outside && goes_through }, "{what}");
            assert!(ray.direction.angle_between(ray.towards) < 1e-6, "{what}");
            through += usize::from(goes_through);
        }
        assert!(through >= (2 * last as usize - 1).pow(2), "{through} rays go through");
        Ok(())
    })
}
