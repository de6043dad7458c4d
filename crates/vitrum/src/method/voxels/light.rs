//! The light of an exposure, as kernels read it.

use super::shadow::source::Source;
use crate::assets::Assets;
use crate::error::Error;
use crate::method::lights;
use crate::method::view::light::upright;
use crate::method::view::pictures::Placed;
use crate::method::voxelize::Grid;
use crate::method::{Bounds, View};
use crate::scene::{Light, Scene};
use crate::unrenderable::Unrenderable;
use glam::DVec3;
use vitrum_io::Mesh;
use vitrum_kernels::abi::light::{Cone, LightSource, kind};

/// The light of a source in a grid of voxels; `picture` is the place of the picture that a spot projects.
pub(in crate::method) fn light_source(
    light: &Light,
    source: &Source,
    view: &View,
    grid: Grid,
    picture: Option<Placed>,
) -> LightSource {
    let vector = |v: DVec3| v.as_vec3().into();
    let at = |world: DVec3| vector(grid.at(world));
    // At a distance of one voxel.
    let near = light.color.map(|channel| {
        let strength = f64::from(channel) * f64::from(light.intensity);
        (strength / (grid.voxel_size * grid.voxel_size)) as f32
    });
    match *source {
        Source::Distant(direction) => LightSource {
            kind: kind::DISTANT,
            direction: vector(direction),
            color: light.color.map(|channel| channel * light.intensity).into(),
            ..LightSource::default()
        },
        Source::Point(position) => {
            LightSource { kind: kind::POINT, color: near.into(), position: at(position), ..LightSource::default() }
        }
        Source::Spot { position, axis, tangent } => {
            let [right, up] = upright(light, view, axis);
            let inner = libm::tan((f64::from(light.cone_angle) * (1.0 - f64::from(light.penumbra))).to_radians());
            // An edge that is crisp is a millionth of the cone wide.
            let slope = 1.0 / (tangent - inner).max(1e-6 * tangent);
            let Placed { first, width, height } = picture.unwrap_or_default();
            let cone = Cone {
                right: vector(right),
                up: vector(up),
                tangent: tangent as f32,
                slope: slope as f32,
                first,
                width,
                height,
            };
            LightSource { kind: kind::SPOT, direction: vector(axis), color: near.into(), position: at(position), cone }
        }
    }
}

/// Checks that each light of a scene can shine on its mesh.
///
/// # Errors
/// Where a light that casts shadows stands in the mesh's box, a light has no direction, or a spot's picture is not among the assets.
pub(in crate::method) fn check(scene: &Scene, assets: &Assets, mesh: &Mesh) -> Result<(), Error> {
    let bounds = Bounds::from(mesh);
    let view = View::new(scene, bounds);
    let corners = mesh.bounds().map(|corner| glam::Vec3::from_array(corner).as_dvec3());
    for (index, light) in scene.light.iter().enumerate() {
        Source::of(light, &view, bounds)?;
        if let Some(path) = light.texture.as_ref().filter(|path| !assets.textures.contains_key(*path)) {
            return Err(Unrenderable::NoTexture { index, path: path.clone() }.into());
        }
    }
    for (index, light) in scene.light.iter().enumerate().filter(|(_, light)| light.shadows) {
        for sample in &lights::crisp(scene, std::slice::from_ref(light), bounds) {
            Source::of(sample, &view, bounds)?.check(corners, Some(index))?;
        }
    }
    Ok(())
}
