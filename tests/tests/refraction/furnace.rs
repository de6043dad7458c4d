//! White furnaces: where light of radiance 1 comes from all sides, clear bodies that absorb nothing have radiance 1, whatever their
//! surfaces reflect; and a plate that absorbs, with all reflections between its faces.

use super::on_both;
use vitrum::backend::Backend;
use vitrum_conformance::Failure;
use vitrum_conformance::closed_forms::table::{self, larger};
use vitrum_conformance::frames;
use vitrum_conformance::refraction::{ball, case, cuboid, together};
use vitrum_io::Mesh;
use vitrum_kernels::glam::{DQuat, DVec3, EulerRot};

const EDGE: u32 = 48;

/// Light of radiance 1 from all sides, and no other.
const WHITE: [&str; 4] =
    ["environment.kind=color", "environment.color=[1,1,1]", "light.0.intensity=0", "voxelization.resolution=64"];

/// Indices of refraction: water, glass, flint glass, diamond.
const INDICES: [f64; 4] = [1.33, 1.5, 1.8, 2.4];

fn scaled(mesh: &Mesh, scale: f32) -> Mesh {
    Mesh { positions: mesh.positions.iter().map(|at| at.map(|c| c * scale)).collect(), ..mesh.clone() }
}

/// A cube that no ray of a camera at the front meets straight on.
fn cube() -> Mesh {
    cuboid(DVec3::splat(0.8), DQuat::from_euler(EulerRot::XYZ, 0.4, 0.3, 0.7))
}

/// A picture's colours, and how many surfaces the ray of each pixel met.
fn picture(mesh: &Mesh, settings: &[&str], backend: &mut dyn Backend) -> Result<(Vec<[f32; 3]>, Vec<f32>), Failure> {
    let case = case("furnace", mesh.clone(), EDGE, &[&WHITE[..], settings].concat())?;
    let frame = frames::render(&case, backend)?;
    let bounces = frame.channel("bounces", "Y").expect("rays through meshes count them").to_vec();
    Ok((frame.aov("color").expect("every frame has a colour").color(), bounces))
}

/// The largest difference of a channel from 1.
fn worst(colors: &[[f32; 3]]) -> f64 {
    colors.iter().flatten().map(|channel| (f64::from(*channel) - 1.0).abs()).fold(0.0, larger)
}

/// Each pixel of a ball, a cube and a shell has radiance 1, for rays of every kind.
#[test]
fn clear_bodies_have_radiance_one_in_a_white_furnace() -> Result<(), Failure> {
    let shell = || together(&[ball(64), scaled(&ball(64), 0.7)]);
    for (kinds, of_radiance) in [
        (&["voxels.surfaces=multi", "voxels.surfaces=two", "voxels.normals=paper"][..], table::FURNACE_VOXELS),
        (&["voxels.surfaces=exact"], table::FURNACE_EXACT),
    ] {
        on_both(|backend| {
            let mut most = 0.0;
            for kind in kinds {
                for (name, mesh) in [("ball", ball(64)), ("cube", cube()), ("shell", shell())] {
                    for index in INDICES {
                        let material = match name {
                            "shell" => format!("material=[{{name=\"m0\",ior={index}}},{{name=\"m1\",ior=1}}]"),
                            _ => format!("material=[{{ior={index}}}]"),
                        };
                        let (colors, bounces) = picture(&mesh, &[kind, &material], backend)?;
                        let met = bounces.iter().filter(|&&bounces| bounces > 1.0).count();
                        assert!(met > colors.len() / 5, "{kind}, {name}: {met} pixels see a body");
                        most = larger(most, worst(&colors));
                    }
                }
            }
            of_radiance.hold(most, backend);
            Ok(())
        })?;
    }
    Ok(())
}

/// For an eye within the body, the surface that is seen first reflects inwards.
#[test]
fn an_eye_within_a_body_sees_radiance_one() -> Result<(), Failure> {
    // Beside the middle by more than a radius over the index of refraction.
    let settings = ["camera.position=[0.7,-0.5,0.3]", "camera.target=[1.2,0.2,0.3]", "camera.field_of_view=110"];
    on_both(|backend| {
        let mut most = 0.0;
        for index in INDICES {
            let material = format!("material=[{{ior={index}}}]");
            let (colors, bounces) = picture(&ball(64), &[&settings[..], &[&material]].concat(), backend)?;
            assert!(bounces.iter().all(|&bounces| bounces >= 1.0), "the eye is within the ball");
            assert!(bounces.iter().any(|&bounces| bounces > 1.0), "no ray is reflected totally");
            most = larger(most, worst(&colors));
        }
        table::FURNACE_WITHIN.hold(most, backend);
        Ok(())
    })
}

/// A plate whose ways have the transmittance t, met straight on by light of radiance 1 from both sides: F is reflected in front,
/// (1 − F)² t / (1 − F² t²) goes through and (1 − F)² F t² / (1 − F² t²) comes back, together F + (1 − F)² t / (1 − F t).
#[test]
fn a_plate_reflects_between_its_faces() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 0.2, 1.0), DQuat::IDENTITY);
    let straight = ["camera.projection=orthographic", "camera.azimuth=0", "camera.elevation=0"];
    for (kind, of_radiance) in [
        ("voxels.surfaces=multi", table::INTERREFLECTION_VOXELS),
        ("voxels.surfaces=exact", table::INTERREFLECTION_EXACT),
    ] {
        on_both(|backend| {
            let mut most = 0.0;
            for index in INDICES {
                let material =
                    format!("material=[{{ior={index},attenuation_color=[0.9,0.3,0.05],attenuation_distance=1}}]");
                let (colors, _) = picture(&mesh, &[&straight[..], &[kind, &material]].concat(), backend)?;
                let share = ((index - 1.0) / (index + 1.0)).powi(2);
                let expected = [0.9f64, 0.3, 0.05].map(|left| {
                    let t = left.powf(0.4);
                    share + (1.0 - share).powi(2) * t / (1.0 - share * t)
                });
                // Away from the edges, which voxels round off.
                let near = |at: usize| (EDGE as usize * 2 / 5..EDGE as usize * 3 / 5).contains(&at);
                let middle = |pixel: &usize| near(pixel % EDGE as usize) && near(pixel / EDGE as usize);
                for color in (0..colors.len()).filter(middle).map(|pixel| colors[pixel]) {
                    for (found, expected) in color.into_iter().zip(expected) {
                        most = larger(most, (f64::from(found) / expected - 1.0).abs());
                    }
                }
            }
            of_radiance.hold(most, backend);
            Ok(())
        })?;
    }
    Ok(())
}
