//! stub
use crate::assets::Assets;
use crate::error::Error;
use crate::scene::Scene;
use glam::DVec3;
pub(super) struct Density {
    pub(super) size: [u32; 3],
    pub(super) low: DVec3,
    pub(super) high: DVec3,
    pub(super) values: Vec<f32>,
}
pub(super) fn density(_scene: &Scene, _assets: &Assets) -> Result<Option<Density>, Error> {
    Ok(None)
}
