//! The participating medium of a frame: its uniforms, and the buffer that has the records of materials and its density behind them.

use super::density::{Density, density};
use super::exchange;
use super::phase::{self as tabulated, table};
use crate::assets::Assets;
use crate::backend::{Backend, Buffer, Contents};
use crate::error::Error;
use crate::method::Bounds;
use crate::method::cache::Memo;
use crate::method::voxelize::Grid;
use crate::scene::{self, Phase, Rgb, Scene};
use bytemuck::cast_slice;
use glam::DVec3;
use std::sync::Arc;
use vitrum_kernels::abi::beams::{Medium, phase};
use vitrum_kernels::abi::vector::Vec3;

/// Half the edge of the medium's cube over the radius of the sphere around the meshes, where the scene does not say.
const EXTENT: f64 = 12.0;

/// The density of the last frame, and the buffer of materials with it.
#[derive(Default)]
pub(super) struct MediumCache {
    density: Memo<Option<scene::Medium>, Option<Arc<Density>>>,
    materials: Memo<(Vec<f32>, Option<usize>), Buffer>,
    exchange: Memo<[Vec3; 3], Vec<f32>>,
}

/// A frame's medium.
pub(super) struct FrameMedium {
    pub(super) uniforms: Medium,
    /// Mean cosine of its phase function.
    pub(super) mean_cosine: f64,
    /// Floats in front of the table of what its cells exchange in the buffer of materials, where light is scattered more than once.
    pub(super) first_exchange: u32,
    /// Records of materials, and behind them a tabulated phase function, what cells exchange, and the density.
    pub(super) materials: Buffer,
}

impl MediumCache {
    /// The medium of a frame, in a grid's frame, behind the records of its materials.
    pub(super) fn medium(
        &mut self,
        scene: &Scene,
        assets: &Assets,
        (bounds, grid): (Bounds, Grid),
        mut materials: Vec<f32>,
        backend: &mut dyn Backend,
    ) -> Result<FrameMedium, Error> {
        // A cache belongs to one set of assets: what the scene says of the medium is all that can change.
        let medium = scene.medium.clone();
        let density = self.density.get(medium, || Ok::<_, Error>(density(scene, assets)?.map(Arc::new)))?.clone();
        let mut uniforms = uniforms(scene, density.as_deref(), bounds, grid);
        uniforms.first_phase = materials.len() as u32;
        let mut mean_cosine =
            if uniforms.phase == phase::HENYEY_GREENSTEIN { f64::from(uniforms.anisotropy) } else { 0.0 };
        if uniforms.phase == phase::TABULATED {
            let table = table(scene.medium.as_ref().map_or(&[], |medium| &medium.phase_values));
            mean_cosine = tabulated::mean_cosine(&table);
            materials.extend(table);
        }
        let first_exchange = materials.len() as u32;
        if scene.beams.orders > 1 && scene.medium.is_some() {
            let key = [uniforms.extinction, uniforms.low, uniforms.high];
            materials.extend(self.exchange.get(key, || Ok::<_, Error>(exchange::table(&uniforms)))?.iter());
        }
        uniforms.first = materials.len() as u32;
        let key = (materials, density.as_ref().map(|density| Arc::as_ptr(density).addr()));
        let records = key.0.clone();
        let buffer = self.materials.get(key, || match &density {
            None => backend.create("materials", Contents::Bytes(cast_slice(&records))),
            Some(density) => {
                let words = records.len() + density.values.len();
                let fill = &mut |all: &mut [u32]| {
                    let (front, behind) = all.split_at_mut(records.len());
                    front.copy_from_slice(cast_slice(&records));
                    behind.copy_from_slice(cast_slice(&density.values));
                };
                backend.create("materials and density", Contents::Written(words as u64 * 4, fill))
            }
        })?;
        Ok(FrameMedium { uniforms, mean_cosine, first_exchange, materials: buffer.clone() })
    }
}

/// The medium's uniforms.
fn uniforms(scene: &Scene, density: Option<&Density>, bounds: Bounds, grid: Grid) -> Medium {
    let (centre, radius) = bounds.sphere();
    let Some(medium) = &scene.medium else { return Medium::default() };
    let half = medium.extent.map_or(EXTENT * radius, f64::from);
    let voxel = grid.voxel_size as f32;
    let scattering = medium.scattering;
    let extinction: Rgb = std::array::from_fn(|channel| scattering[channel] + medium.absorption[channel]);
    let [low, high] = density.map_or([centre - half, centre + half], |density| [density.low, density.high]);
    let [columns, rows, layers] = density.map_or([1; 3], |density| density.size);
    let corner = |corner: DVec3| grid.at(corner).as_vec3().into();
    Medium {
        extinction: extinction.map(|coefficient| coefficient * voxel).into(),
        scattering: scattering.map(|coefficient| coefficient * voxel).into(),
        anisotropy: medium.anisotropy,
        phase: match medium.phase {
            Phase::HenyeyGreenstein => phase::HENYEY_GREENSTEIN,
            Phase::Rayleigh => phase::RAYLEIGH,
            Phase::Tabulated => phase::TABULATED,
        },
        low: corner(low),
        high: corner(high),
        nodes: density.map_or(0, |_| scene.beams.nodes),
        columns,
        rows,
        layers,
        first: 0,
        first_phase: 0,
    }
}
