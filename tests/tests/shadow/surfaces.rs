//! Shadows of bodies of several materials.

use super::{ABOVE, case, on_both, sheets};
use vitrum_conformance::Failure;
use vitrum_conformance::refraction::{self, ball, cuboid, together};
use vitrum_conformance::shadow::Map;
use vitrum_kernels::glam::{DQuat, DVec3};

#[test]
fn trunks_are_dark_and_leaves_let_light_through() -> Result<(), Failure> {
    // A bar in the middle of a sheet; the bar has a top and a bottom.
    let mesh = together(&[cuboid(DVec3::new(0.2, 0.2, 0.4), DQuat::IDENTITY), sheets([0.1])]);
    let settings = [
        "material=[{name=\"m0\",opaque=true},{opaque=true,density=0.5}]",
        "shadow.optical_depth=0.6",
        "shadow.resolution=100",
    ];
    let case = case(mesh, 8, &[&ABOVE[..], &settings].concat())?;
    on_both(|backend| {
        let map = Map::of(&case, backend)?;
        let at = |x: f64, z: f64| map.at(DVec3::new(x, 0.03, z))[0];
        assert!(at(0.0, -0.6) == 0.0, "{}", at(0.0, -0.6));
        // The default lets e^(−16 · 0.6) through each of the bar's faces.
        assert!((at(0.0, 0.3) - (-9.6f64).exp()).abs() < 1.2e-5, "{}", at(0.0, 0.3));
        assert!((at(0.6, -0.6) - (-0.3f64).exp()).abs() < 1.2e-5, "{}", at(0.6, -0.6));
        Ok(())
    })
}

/// Beer and Lambert: light behind a clear body has the transmittance of its material over the way through it, in its colour.
#[test]
fn clear_bodies_cast_coloured_shadows() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 0.8, 0.3), DQuat::IDENTITY);
    let material = "material=[{ior=1.5,attenuation_color=[0.9,0.5,0.2],attenuation_distance=1.2}]";
    for (elevation, cosine) in [("light.0.elevation=90", 1.0), ("light.0.elevation=60", 60f64.to_radians().sin())] {
        for resolution in ["shadow.resolution=40", "shadow.resolution=128"] {
            let settings = [material, elevation, resolution, "voxelization.resolution=32"];
            let case = case(mesh.clone(), 8, &settings)?;
            on_both(|backend| {
                let map = Map::of(&case, backend)?;
                for (depth, height) in [(0.6, -0.3 - 2.0 * map.edge()), (0.3, 0.0)] {
                    let middle = DVec3::new(0.03, 0.05, 0.0) + map.light() * (0.3 / cosine);
                    let point = if height < 0.0 {
                        middle + map.light() * map.edge() * 2.0
                    } else {
                        DVec3::new(0.03, 0.05, 0.0)
                    };
                    let found = map.at(point);
                    for (found, color) in found.iter().zip([0.9f64, 0.5, 0.2]) {
                        let expected = color.powf(depth / cosine / 1.2);
                        // Faces are known to 2⁻¹⁶ of a voxel; the middle lies anywhere between two faces, where it is linear.
                        assert!((found - expected).abs() < 2e-3, "{elevation}, {resolution}: {found}, not {expected}");
                    }
                }
                Ok(())
            })?;
        }
    }
    Ok(())
}

/// A grey body has one channel for all colours.
#[test]
fn grey_glass_is_grey() -> Result<(), Failure> {
    let mesh = cuboid(DVec3::new(1.0, 1.0, 0.5), DQuat::IDENTITY);
    let material = "material=[{attenuation_color=[0.25,0.25,0.25],attenuation_distance=2}]";
    let case = case(mesh, 8, &[&ABOVE[..], &[material, "voxelization.resolution=16"]].concat())?;
    on_both(|backend| {
        let map = Map::of(&case, backend)?;
        assert_eq!(map.block.shadow.channels, 1);
        assert!(map.at(DVec3::new(0.1, 0.2, -0.8)).iter().all(|left| (left - 0.5).abs() < 1e-4));
        Ok(())
    })
}

/// A convex body does not shade itself where it faces the light: no acne, at any resolution and any slope.
#[test]
fn a_ball_does_not_shade_itself() -> Result<(), Failure> {
    let turned = cuboid(DVec3::new(0.7, 0.5, 0.9), DQuat::from_rotation_x(0.4) * DQuat::from_rotation_y(0.9));
    for mesh in [ball(48), turned] {
        for softness in ["shadow.filter_radius=0", "shadow.filter_radius=0.1"] {
            for resolution in [16, 47, 128] {
                let setting = format!("shadow.resolution={resolution}");
                let settings = [
                    "light.0.attachment=world",
                    "light.0.elevation=35",
                    "light.0.azimuth=60",
                    "material.0.opaque=true",
                    "material.0.color=[1,0.5,0.25]",
                    "shading.ambient=[0,0,0]",
                    &setting,
                    softness,
                ];
                let case = refraction::case("ball", mesh.clone(), 64, &settings)?;
                on_both(|backend| {
                    let light = Map::of(&case, backend)?.light();
                    let frame = vitrum::render(&case.scene, &case.assets, backend, &mut |_| true)?;
                    let view = vitrum_conformance::shadow::view(&case);
                    let channel = |layer: &str, name: &str| frame.channel(layer, name).expect("it is an output");
                    let normals = ["X", "Y", "Z"].map(|name| channel("normal", name));
                    let (color, alpha) = (channel("color", "R"), channel("color", "A"));
                    let green = channel("color", "G");
                    // Outputs look along −z.
                    let light = view.direction(light);
                    let mut lit = 0;
                    for pixel in 0..color.len() {
                        let [x, y, z] = normals.map(|normal| f64::from(normal[pixel]));
                        let cosine = -(DVec3::new(x, y, -z).dot(light));
                        // Facets lean against the ball's normals by up to 2°; at a grazing light one may look away.
                        if f64::from(alpha[pixel]) < 1.0 || (x, y, z) == (0.0, 0.0, 0.0) || cosine < 0.04 {
                            continue;
                        }
                        lit += 1;
                        let found = f64::from(color[pixel]);
                        assert!((found - cosine).abs() < 1e-5, "{resolution}: {found}, expected {cosine} at {pixel}");
                        assert!((f64::from(green[pixel]) - 0.5 * cosine).abs() < 1e-5);
                    }
                    assert!(lit > 300, "{lit}");
                    Ok(())
                })?;
            }
        }
    }
    Ok(())
}
