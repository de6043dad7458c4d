//! The light on receivers, in the buffer in which kernels look light up: the maps of what clear bodies refract onto them, behind these the shadow map.

use super::bodies::{Body, clear};
use super::shadow::ShadowMap;
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::method::sweep::caustics::Caustics;
use crate::scene::Scene;
use bytemuck::cast_slice;
use std::sync::Arc;
use vitrum_io::Mesh;
use vitrum_kernels::abi::wavefront::PLANE_ALIGNMENT;

/// The light that clear bodies have refracted onto receivers, on a backend.
pub(super) struct Received {
    pub(super) caustics: Arc<Caustics>,
    buffer: Buffer,
}

/// Whether a scene's receivers show the light that the bodies of `mesh` refract.
pub(super) fn has_caustics(scene: &Scene, mesh: &Mesh, bodies: &[Body]) -> bool {
    let light = scene.first_light();
    let receives = scene.ground.is_some() || scene.wall.is_some();
    let refracts =
        || bodies.iter().zip(clear(bodies, mesh, scene)).any(|(body, clear)| !body.opaque && clear.ior != 1.0);
    scene.voxels.caustics && receives && light.shadows && light.texture.is_none() && refracts()
}

/// Words that the maps take in front of a shadow map.
pub(super) fn words(caustics: &Caustics) -> u32 {
    (caustics.shares.len() as u32).next_multiple_of(PLANE_ALIGNMENT)
}

impl Received {
    /// The maps in front of a shadow map, or in a buffer of their own.
    ///
    /// # Errors
    /// If the backend fails or lacks the memory.
    pub(super) fn new(
        caustics: Arc<Caustics>,
        shadow: Option<&ShadowMap>,
        backend: &mut dyn Backend,
    ) -> Result<Self, Error> {
        let shares: &[u32] = cast_slice(&caustics.shares);
        let buffer = match shadow {
            None => backend.create("light on receivers", Contents::Bytes(cast_slice(shares)))?,
            Some(map) => {
                backend.write(&map.buffer, shares.len(), &mut |words| words.copy_from_slice(shares))?;
                map.buffer.clone()
            }
        };
        Ok(Self { caustics, buffer })
    }

    /// The buffer that has them.
    pub(super) fn buffer(&self) -> &Buffer {
        &self.buffer
    }
}
