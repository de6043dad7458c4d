//! The ground of a scene by itself, to which a ground that catches shadows is compared.

use crate::assets::Assets;
use crate::error::Error;
use crate::method::Bounds;
use crate::scene::{Light, MethodName, OpacityPoint, Scene, Surroundings, TransferFunction};
use vitrum_io::{Volume, Voxels};

/// The scene's ground with nothing on it: a clear volume takes the subject's place, so that camera and light are the same.
pub(crate) fn ground_alone(scene: &Scene, assets: &Assets) -> Result<(Scene, Assets), Error> {
    let [corner, x, y, z] = [0, 1, 2, 4].map(|index| Bounds::from(&assets.subject).corners()[index]);
    let edges = [x, y, z].map(|end| end - corner);
    let spacing = edges.map(|edge| 0.5 * edge.length());
    let mut clear = Volume::new("ground", [2; 3], spacing.map(|edge| edge as f32), Voxels::from(vec![0_u8; 8]))?;
    clear.axes = edges.map(|edge| edge.normalize().as_vec3().to_array());
    clear.origin = (corner + (edges[0] + edges[1] + edges[2]) * 0.25).as_vec3().to_array();
    let nothing = TransferFunction { opacity: vec![OpacityPoint { value: 0.0, opacity: 0.0 }], ..Default::default() };
    // Where nothing casts shadows, a light may stand anywhere.
    let light = scene.light.iter().map(|light| Light { shadows: false, ..light.clone() }).collect();
    let alone = Scene {
        method: MethodName::Sweep,
        light,
        transfer: nothing,
        mesh: Vec::new(),
        ior_volume: None,
        material: Vec::new(),
        clip: Vec::new(),
        wall: None,
        surroundings: Surroundings::default(),
        ..scene.clone()
    };
    Ok((alone, Assets { subject: clear.into(), ..assets.clone() }))
}
