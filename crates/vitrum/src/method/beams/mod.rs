//! Beams of light that clear and mirroring bodies send through a scattering medium (Hu et al. 2010).

use crate::assets::Assets;
use crate::error::Error;
use crate::film::{Output, rgba};
use crate::method::{Cache, Job, Method, PreparedFrame, Tools};
use crate::scene::{MethodName, Scene};
use crate::unrenderable::Unrenderable;

/// Beams of light in a medium.
#[derive(Debug, Clone, Copy)]
pub struct Beams;

const OUTPUTS: &[Output] = &[Output::color(rgba!(0, 3))];

impl Method for Beams {
    fn name(&self) -> MethodName {
        MethodName::Beams
    }

    fn outputs(&self) -> &'static [Output] {
        OUTPUTS
    }

    fn check(&self, scene: &Scene, assets: &Assets) -> Result<(), Error> {
        match assets.subject.mesh() {
            Some(_) => Ok(scene.check_for_mesh()?),
            None => Err(Unrenderable::NeedsMesh { method: self.name().as_str() }.into()),
        }
    }

    fn prepare(
        &self,
        _job: &Job<'_>,
        _cache: &mut Cache,
        _tools: &mut Tools<'_>,
    ) -> Result<Box<dyn PreparedFrame>, Error> {
        Err(Unrenderable::NeedsMesh { method: self.name().as_str() }.into())
    }
}
