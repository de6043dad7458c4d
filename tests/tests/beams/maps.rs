//! Light by maps of the bodies (`beams.tracer = "depth-map"`): the maps of a ball by its closed form, a ball's light by single scattering to nine digits, flux,
//! and what maps cannot do.

use super::ball::in_fog;
use super::ball_table::RAYS;
use super::flux::shares;
use super::map_table::REFRACTED;
use super::thin::Thin;
use super::{LAMP, SUN, case, on_both, on_the_cpu, red, rms};
use super::{mirror, mirror_table};
use vitrum::backend::Backend;
use vitrum::method::{PreparedFrame as _, beams};
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::refraction::{ball, cuboid, together};
use vitrum_conformance::{Failure, frames};
use vitrum_io::Mesh;
use vitrum_kernels::abi::beams::{BeamsUniforms, Lattice};
use vitrum_kernels::abi::light::kind;
use vitrum_kernels::abi::record::faces;
use vitrum_kernels::abi::vector::Vec3;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};

/// Light by maps.
const BY_MAPS: &str = "beams.tracer='depth-map'";

/// By how much the surface of a ball of 256 latitudes may lie within the sphere, in radii: (π / 256)² / 8 along each of two directions is 4 · 10⁻⁵.
const WITHIN: f64 = 5e-5;

/// By how much it may lie beyond, or a distance be off: f32's rounding of a distance of some hundred voxels.
const ROUNDING: f64 = 2e-6;

/// The largest error of a normal: rounding, since corners have their own positions for normals, and both are interpolated alike.
const TURNED: f64 = 2e-6;

fn vector(v: Vec3) -> DVec3 {
    DVec3::new(v.x.into(), v.y.into(), v.z.into())
}

/// The start and the direction of the ray of a texel.
fn ray(block: &BeamsUniforms, column: usize, row: usize) -> [DVec3; 2] {
    let Lattice { low_across, low_upwards, step_across, step_upwards, .. } = block.lattice;
    let along = |low: f32, step: f32, at: usize| f64::from(low) + (at as f64 + 0.5) * f64::from(step);
    let side = vector(block.lattice.across) * along(low_across, step_across, column)
        + vector(block.lattice.upwards) * along(low_upwards, step_upwards, row);
    let (origin, axis) = (vector(block.lattice.origin), vector(block.lattice.axis));
    if block.light.kind == kind::DISTANT { [origin + side, axis] } else { [origin, (axis + side).normalize()] }
}

/// The front of a ball and its back lie on the sphere, the one before the middle of the texel's ray and the other behind it, with the sphere's normal.
#[test]
fn maps_of_a_ball_are_a_spheres() -> Result<(), Failure> {
    const RAYS: usize = 48;
    on_both(|backend| {
        for light in [LAMP, SUN] {
            let case =
                case(ball(256), 8, &[light, "material=[{ior=1.5}]", "ground={height=-2}", "beams.rays=48", BY_MAPS])?;
            let frame = beams::prepare(&case.scene, &case.assets, backend).map_err(Failure::from)?;
            frame.run(backend, &mut |_, _| true)?;
            let records = frame.maps(backend)?;
            assert_eq!(records.len(), RAYS * RAYS * faces::SIZE);
            let pass = frame.passes.passes.iter().find(|pass| pass.kernel.declaration.name == "beams_map_faces");
            let block: BeamsUniforms = bytemuck::pod_read_unaligned(&pass.expect("maps are made").uniforms);
            let middle = 0.5 * (vector(block.low) + vector(block.high));
            let unit = f64::from(block.voxel);
            let (mut seen, mut worst) = (0, [0.0; 2]);
            for texel in 0..RAYS * RAYS {
                let of = |component: usize| f64::from(records[component * RAYS * RAYS + texel]);
                let [from, direction] = ray(&block, texel % RAYS, texel / RAYS);
                let nearest = (middle - from).dot(direction);
                let half = (1.0 - ((from + direction * nearest - middle) * unit).length_squared()).max(0.0).sqrt();
                let is_seen = of(faces::FRONT_TRIANGLE) >= 0.0;
                // The outline is that of the triangles.
                assert!((half > 0.0) == is_seen || half < 0.02, "{light}, texel {texel}: {half}");
                if !is_seen || half < 0.02 {
                    continue;
                }
                seen += 1;
                let sides = [
                    (-1.0, faces::FRONT_DISTANCE, faces::FRONT_NORMAL, faces::FRONT_MATERIAL),
                    (1.0, faces::BACK_DISTANCE, faces::BACK_NORMAL, faces::BACK_MATERIAL),
                ];
                for (side, distance, normal, material) in sides {
                    assert_eq!(of(material), 0.0, "{light}, texel {texel}");
                    let found = (of(distance) - nearest) * unit;
                    // Along the ray a surface is as much farther off as the ray is oblique to it.
                    let off = (half - side * found) * half;
                    let at = (from + direction * of(distance) - middle) * unit;
                    let turn = (DVec3::new(of(normal), of(normal + 1), of(normal + 2)) - at.normalize()).length();
                    assert!((-ROUNDING..=WITHIN).contains(&off), "{light}, texel {texel}: {found}, not {half}");
                    assert!(turn <= TURNED, "{light}, texel {texel}: a normal is off by {turn:.1e}");
                    worst = [larger(off, worst[0]), larger(turn, worst[1])];
                }
            }
            println!("{light}: {seen} texels, off by at most {:.1e}, turned by {:.1e}", worst[0], worst[1]);
            assert!(seen > RAYS * RAYS * 3 / 4, "{seen} texels");
        }
        Ok(())
    })
}

/// The largest error of the light that a ball refracts twice, along a ray, with 256 rays of light along an edge, and the largest root mean square: those
/// of light through triangles. All of it leaves the ball within 12° of its lower pole, where the back map is even and bends by 8 · 10⁻⁶ within a texel:
/// interpolation adds next to nothing.
const LARGEST: f64 = 0.02;
const LARGEST_RMS: f64 = 0.01;

/// The errors along the rays of the table above a brightness, as shares.
fn errors(light: &str, set: usize, backend: &mut dyn Backend) -> Result<Vec<f64>, Failure> {
    let mut case = in_fog(light, [0.0, 0.7][set % 2], 0.0, 256)?;
    // One piece: what the ball's front reflects is not in the table.
    for setting in [BY_MAPS, "beams.segments=1"] {
        case.scene.set(setting)?;
    }
    let mut thin = Thin::new(case, backend);
    let mut errors = Vec::new();
    for (row, expected) in RAYS.iter().zip(REFRACTED) {
        let expected = expected[set];
        if expected > 1e-4 {
            let seen = thin.look(DVec3::from_array(row.eye), DVec3::from_array(row.through))?;
            errors.push(seen.caustics[0] / expected - 1.0);
        }
    }
    Ok(errors)
}

/// Holds errors along rays; gives their root mean square.
fn hold(what: &str, errors: &[f64]) -> f64 {
    let mean = rms(errors.iter().copied());
    let worst = errors.iter().copied().map(f64::abs).fold(0.0, larger);
    println!("{what}: {mean:.2e}, {errors:.4?}");
    assert!(worst <= LARGEST, "{what}: off by {worst:.2e}");
    assert!(mean <= LARGEST_RMS, "{what}: off by {mean:.2e}");
    mean
}

#[test]
fn thin_rays_see_the_light_of_a_ball_by_maps() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        for (set, light, line) in [(0, LAMP, table::BEAMS_MAPS), (3, SUN, table::BEAMS_MAPS_FORWARD)] {
            line.hold(hold(light, &errors(light, set, backend)?), backend);
        }
        Ok(())
    })
}

/// A mirror's light by maps is that by triangles where it is mirrored once: single rays through the fog in the ring, to the same bounds.
#[test]
fn a_ring_throws_light_by_maps() -> Result<(), Failure> {
    on_the_cpu(|backend| {
        let case = mirror::scene(mirror::BY_SUN, 0.0, &[&mirror::fog(0.0), BY_MAPS])?;
        let mut thin = Thin::new(case, backend);
        let mut errors = Vec::new();
        for (through, expected) in mirror_table::SUN {
            let seen = thin.look(DVec3::from_array(mirror_table::EYE), DVec3::from_array(through))?;
            errors.push(seen.caustics[0] / expected[0] - 1.0);
        }
        hold("a ring", &errors);
        Ok(())
    })
}

/// Balls, each by its middle and its radius, in one mesh of one material; one of a negative radius is a hollow.
fn balls(parts: &[([f64; 3], f64)]) -> Mesh {
    let unit = ball(96);
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for &(middle, radius) in parts {
        let base = positions.len() as u32;
        let at = |p: &[f32; 3]| {
            (DVec3::from_array(middle) + DVec3::from_array(p.map(f64::from)) * radius.abs()).as_vec3().to_array()
        };
        let outwards = radius.signum() as f32;
        positions.extend(unit.positions.iter().map(at));
        normals.extend(unit.positions.iter().map(|p| p.map(|x| x * outwards)));
        let turned = |[a, b, c]: [u32; 3]| if radius < 0.0 { [a, c, b] } else { [a, b, c] };
        triangles.extend(unit.triangles.iter().map(|&triangle| turned(triangle).map(|corner| corner + base)));
    }
    let mut mesh = Mesh::new("balls", positions, triangles).expect("a valid mesh");
    mesh.normals = Some(normals);
    mesh
}

/// Two balls behind one another.
fn two() -> Mesh {
    balls(&[([0.0, 0.0, 0.0], 0.6), ([0.1, 0.0, -1.3], 0.5)])
}

/// A ball with two hollows.
fn hollow() -> Mesh {
    balls(&[([0.0, 0.0, 0.0], 1.0), ([0.4, 0.1, 0.1], -0.3), ([-0.4, 0.0, -0.2], -0.35)])
}

/// The largest error of the sum of a texel's shares: f32 rounds each of some Fresnel terms and exponentials.
const SHARES: f64 = 1e-5;

/// No light is gained, and what maps cannot follow is counted as lost.
#[test]
fn the_shares_of_a_texels_light_by_maps_add_up() -> Result<(), Failure> {
    let turned = DQuat::from_euler(EulerRot::XYZ, 0.4, 0.3, 0.7);
    let bodies: [(&str, Mesh, &str, [bool; 5]); 7] = [
        ("a ball", ball(96), "material=[{ior=1.5}]", [true, true, false, true, true]),
        (
            "a dense ball",
            ball(96),
            "material=[{ior=2.4,attenuation_color=[0.9,0.5,0.2]}]",
            [true, true, true, true, true],
        ),
        ("a box", cuboid(DVec3::splat(0.6), turned), "material=[{ior=1.5}]", [true, true, false, true, true]),
        ("a mirror", ball(96), "material=[{mirror=true,color=[0.9,0.8,0.7]}]", [true, true, true, true, false]),
        ("two balls", two(), "material=[{ior=1.5}]", [true, true, false, true, true]),
        ("a hollow ball", hollow(), "material=[{ior=1.5}]", [true, true, false, true, true]),
        (
            "an opaque ball in a clear box",
            together(&[cuboid(DVec3::splat(0.9), turned), balls(&[([0.0; 3], 0.5)])]),
            "material=[{name='m0',ior=1.4},{opaque=true}]",
            [true, true, false, true, true],
        ),
    ];
    on_both(|backend| {
        let mut largest = 0.0;
        for (what, mesh, material, has) in &bodies {
            for light in [LAMP, SUN] {
                for segments in ["beams.segments=1", "beams.segments=2", "beams.segments=8"] {
                    let settings = [
                        light,
                        material,
                        "medium={absorption=[0.02,0.05,0],scattering=[0.1,0.05,0.02],extent=6}",
                        "ground={height=-2}",
                        "beams.rays=48",
                        segments,
                        BY_MAPS,
                    ];
                    let shares = shares(&case(mesh.clone(), 8, &settings)?, backend)?;
                    assert!(shares.len() > 48 * 48 / 2, "{} texels", shares.len());
                    let worst = shares.iter().map(|shares| (shares.iter().sum::<f64>() - 1.0).abs()).fold(0.0, larger);
                    let means: [f64; 5] =
                        std::array::from_fn(|part| shares.iter().map(|of| of[part]).sum::<f64>() / shares.len() as f64);
                    println!("{what}, {light}, {segments}: {means:.4?}, off by at most {worst:.1e}");
                    assert!(shares.iter().flatten().all(|&share| share >= -SHARES), "{what}, {light}, {segments}");
                    assert!(worst <= SHARES, "{what}, {light}, {segments}: the shares' sum is off by {worst:.1e}");
                    if segments != "beams.segments=1" {
                        assert_eq!(means.map(|mean| mean > 1e-6), *has, "{what}, {light}, {segments}: {means:?}");
                    }
                    largest = larger(worst, largest);
                }
            }
        }
        table::BEAMS_MAPS_SHARES.hold(largest, backend);
        Ok(())
    })
}

/// A body's caustics in fog by both tracers, light straight down: the root mean square of the difference over the brightest pixel, and the sum by maps over
/// the other. Along more than two surfaces light is not followed by triangles either.
fn beside_triangles(mesh: Mesh, backend: &mut dyn Backend) -> Result<[f64; 2], Failure> {
    let settings = [
        SUN,
        "material=[{ior=1.5}]",
        "medium={absorption=[0.02,0.02,0.02],scattering=[0.1,0.1,0.1],extent=12}",
        "ground={height=-3,color=[0,0,0]}",
        "beams.rays=64",
        "beams.threshold=0.05",
        "camera.position=[0,-9,0.5]",
        "camera.target=[0,0,-0.3]",
        "camera.field_of_view=40",
    ];
    let mut case = case(mesh, 64, &settings)?;
    let by_triangles = red(&frames::render(&case, backend)?, "caustics");
    case.scene.set(BY_MAPS)?;
    let by_maps = red(&frames::render(&case, backend)?, "caustics");
    let brightest = by_triangles.iter().copied().fold(0.0, f64::max);
    let difference = rms(by_maps.iter().zip(&by_triangles).map(|(maps, triangles)| maps - triangles)) / brightest;
    Ok([difference, by_maps.iter().sum::<f64>() / by_triangles.iter().sum::<f64>()])
}

/// The largest difference of a ball's caustics, over the brightest pixel, and of their sum, as a share: by triangles there is light that is mirrored
/// within the ball near its outline, too. Found are 2.3 · 10⁻⁴ and 4.3 · 10⁻³.
const ALIKE: [f64; 2] = [1e-3, 0.01];

/// The least difference where maps mistake a body for another, and the most light that is left: theirs misses its focus. Found are 0.022 and 0.90, and more.
const UNLIKE: [f64; 2] = [0.01, 0.95];

/// A pair of surfaces is all that maps know: a ball is like itself, but two balls behind one another are one body of the upper front and the lower back to
/// them, and a hollow ball has no hollows.
#[test]
fn maps_know_a_pair_of_surfaces() -> Result<(), Failure> {
    on_both(|backend| {
        for (what, mesh) in [("a ball", ball(96)), ("two balls", two()), ("a hollow ball", hollow())] {
            let [difference, sum] = beside_triangles(mesh, backend)?;
            println!("{what}: {difference:.2e} of the brightest pixel, the sum {sum:.4}");
            if what == "a ball" {
                assert!(difference <= ALIKE[0], "{difference:.2e} of the brightest pixel");
                assert!((sum - 1.0).abs() <= ALIKE[1], "the sum is {sum:.4} of that by triangles");
            } else {
                assert!(difference >= UNLIKE[0] && sum <= UNLIKE[1], "{what}: {difference:.2e}, the sum {sum:.4}");
            }
        }
        Ok(())
    })
}
