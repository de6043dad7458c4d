//! The volumes that a picture is made of, where they are not those that were read: without noise, without specks, without what a mask hides, on a finer grid.

mod clear;
mod colors;
mod cubic;
mod halves;
mod mask;
pub(crate) mod runs;
mod slab;
mod smoothing;
mod specks;
mod spline;
pub(crate) mod visible;

use crate::assets::Assets;
use crate::error::Error;
use crate::preset::{self, Landmarks, Noise};
use crate::scene::{GradientFunction, Interpolation, Scene};
use crate::subject::{Subject, Volumes};
use crate::unrenderable::Unrenderable;
use clear::clear_ranges;
use colors::with_gradients;
use halves::{in_halves, told_apart};
use mask::{Hidden, masked};
use smoothing::smoothed;
use specks::without_specks;
use std::sync::Arc;
use visible::{By, Visible};
use vitrum_io::{Volume, Voxels};

/// How the volumes of a scene are changed before they are shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Changes {
    /// Radius of the filter of what colour, opacity and filter are looked up with, in voxels.
    opacity: u32,
    /// The same of what the index of refraction is looked up with.
    ior: u32,
    /// The least size of visible parts, and what is visible, where small ones are left out.
    specks: Option<(u32, Visible)>,
    /// What a mask hides.
    hidden: Option<Hidden>,
    /// The second dimension of the transfer functions.
    gradient: Vec<GradientFunction>,
    /// The ends of the values, where floats have colours.
    halves: Option<[f32; 2]>,
}

/// The noise that is taken for granted where a filter is asked for and no more is measured, as a share of the way from `air` to `soft`.
const LEAST_NOISE: f32 = 0.01;

/// The radius that suits noise, as a share of the way from `air` to `soft`: light is bent by differences of neighbours, and so by much less noise
/// than would be seen.
#[must_use]
pub(crate) fn radius_for(share: f32) -> u32 {
    match share {
        ..0.0075 => 0,
        ..0.02 => 1,
        ..0.05 => 2,
        _ => 3,
    }
}

/// Whether some matter of a scene bends light.
pub(crate) fn bends(scene: &Scene) -> bool {
    let around = scene.surroundings.ior;
    scene.sweep.refraction
        && scene.transfer.ior.iter().any(|point| point.ior != around || point.cauchy_coefficient() != 0.0)
}

impl Changes {
    /// The changes that a scene asks for. `noise` measures the noise of the volume that bends light; it is asked for only where the scene leaves
    /// the choice, and light is bent. Bodies within the volume are beside one scalar alone, of 16 bits. `range` gives the shown volume's range without outliers, for which all voxels are counted.
    pub(crate) fn of(
        scene: &Scene,
        (volumes, has_bodies): (Volumes<'_>, bool),
        noise: impl FnOnce() -> Option<Noise>,
        mut range: impl FnMut() -> [f32; 2],
    ) -> Self {
        let transfer = &scene.transfer;
        // What was computed or made in memory has the values that it should have.
        let bending = volumes.bending();
        // What stays in its file is not smoothed by itself.
        let measured = !bending.source.format.is_empty() && bending.paged.is_none();
        let ior = match transfer.ior_smoothing {
            _ if !bends(scene) => transfer.opacity_smoothing,
            Some(radius) => radius,
            None if measured => noise().map_or(0, |noise| radius_for(noise.share)).max(transfer.opacity_smoothing),
            None => transfer.opacity_smoothing,
        };
        let mut visible = || {
            let shown = volumes.shown;
            let finest = shown.finest_spacing();
            let by = if volumes.ior.is_some() { By::Absorption } else { By::Both };
            Visible::new(scene, by, (shown.extent(), range(), finest))
        };
        let specks = (transfer.speck_size > 1).then(|| (transfer.speck_size, visible()));
        let hidden = scene.volume.mask.as_ref().map(|mask| {
            let by = if volumes.ior.is_some() { [By::Absorption, By::Bending] } else { [By::Both; 2] };
            Hidden::new(mask, by.map(|by| clear_ranges(scene, by, &mut range)))
        });
        // With colours, or bodies, there is one scalar, in 16 bits.
        let colored = !transfer.gradient.is_empty() || volumes.shown.colors.is_some() || has_bodies;
        let opacity = if colored { transfer.opacity_smoothing.max(ior) } else { transfer.opacity_smoothing };
        let ior = if colored { opacity } else { ior };
        let floats = matches!(volumes.shown.voxels, Voxels::F32(_));
        let halves = (colored && floats).then(|| told_apart(scene, volumes.shown.range, range()));
        Self { opacity, ior, specks, hidden, gradient: transfer.gradient.clone(), halves }
    }

    /// The subject of `assets` with these changes; `None` where nothing changes.
    ///
    /// # Errors
    /// Where the memory does not suffice, or a mask does not suit the volume.
    pub(crate) fn made(&self, assets: &Assets) -> Result<Option<Subject>, Error> {
        if *self == Self::default() {
            return Ok(None);
        }
        for volume in assets.subject.volumes().iter().flat_map(|volumes| volumes.iter()) {
            volume.require_whole("smoothing, leaving out specks, a mask or colour by gradient")?;
        }
        let Some(smoothed) = self.whole(&assets.subject)? else { return Ok(None) };
        let subject = self.unhidden(assets, smoothed)?;
        let Subject::Volume(mut volume) = subject else { return Ok(Some(subject)) };
        if !self.gradient.is_empty() {
            volume = Arc::new(with_gradients(&volume, &self.gradient)?);
        }
        if let Some(ends) = self.halves {
            volume = Arc::new(in_halves(&volume, ends)?);
        }
        Ok(Some(Subject::Volume(volume)))
    }

    /// The smoothed subject without what a mask hides.
    fn unhidden(&self, assets: &Assets, smoothed: Subject) -> Result<Subject, Error> {
        let Some(hidden) = &self.hidden else { return Ok(smoothed) };
        let mask = assets.mask.as_ref().ok_or(Unrenderable::NoMask)?;
        // What is smoothed would blur the mask's edge: it is hidden afterwards.
        let without = |volume: &Volume, clear: &[[f32; 2]]| masked(volume, mask, hidden, clear).map(Arc::new);
        Ok(match &smoothed {
            Subject::Volumes { shown, ior } => {
                Subject::Volumes { shown: without(shown, &hidden.shown)?, ior: without(ior, &hidden.bending)? }
            }
            Subject::Volume(volume) => Subject::Volume(without(volume, &hidden.shown)?),
            Subject::Mesh(_) => smoothed,
        })
    }

    /// The subject without noise and specks; `None` of a mesh.
    fn whole(&self, subject: &Subject) -> Result<Option<Subject>, Error> {
        let whole = |volume: &Arc<Volume>| match &self.specks {
            Some((least, visible)) => Arc::new(without_specks(volume, visible, *least)),
            None => Arc::clone(volume),
        };
        Ok(match subject {
            Subject::Mesh(_) => None,
            Subject::Volume(volume) => {
                let volume = whole(volume);
                let shown = smooth(&volume, self.opacity)?;
                Some(if self.opacity == self.ior {
                    Subject::Volume(shown)
                } else {
                    Subject::Volumes { shown, ior: smooth(&volume, self.ior)? }
                })
            }
            Subject::Volumes { shown, ior } => {
                Some(Subject::Volumes { shown: smooth(&whole(shown), self.opacity)?, ior: smooth(ior, self.ior)? })
            }
        })
    }
}

/// A volume smoothed with a radius; the noise is its own.
fn smooth(volume: &Arc<Volume>, radius: u32) -> Result<Arc<Volume>, Error> {
    if radius == 0 {
        return Ok(Arc::clone(volume));
    }
    let Landmarks { air, soft, .. } = preset::landmarks(volume);
    let noise = preset::noise(volume).map_or(0.0, |noise| noise.deviation);
    Ok(Arc::new(smoothed(volume, radius, noise.max(LEAST_NOISE * (soft - air)), soft)?))
}

/// A statement about the mask of a scene's volume.
pub(crate) fn told_of_mask(scene: &Scene, assets: &Assets) -> Option<String> {
    scene.volume.mask.as_ref()?;
    let (volume, mask) = assets.subject.volume().zip(assets.mask.as_ref())?;
    mask::told(volume, mask)
}

/// The data of a scene as its picture is made of it.
///
/// # Errors
/// Where the memory does not suffice.
pub(crate) fn shown(scene: &Scene, assets: &Assets) -> Result<Option<Assets>, Error> {
    let Some(volumes) = assets.subject.volumes() else { return Ok(None) };
    let (noise, range) = (|| preset::noise(volumes.bending()), || volumes.shown.common_range());
    let changes = Changes::of(scene, (volumes, assets.bodies.is_some()), noise, range);
    Ok(changes.made(assets)?.map(|subject| Assets { subject, ..assets.clone() }))
}

/// How many times finer the grids of the shown volume and of the one that bends light become.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fineness([cubic::Factors; 2]);

impl Fineness {
    /// The fineness that a scene's picture asks for; `None` where its interpolation is not cubic.
    pub(crate) fn of(scene: &Scene, volumes: Volumes<'_>) -> Option<Self> {
        let is_cubic = scene.volume.interpolation == Interpolation::Cubic;
        is_cubic.then(|| Self([volumes.shown, volumes.bending()].map(|volume| cubic::factors(scene, volume))))
    }

    /// The subject on those grids.
    ///
    /// # Errors
    /// [`Unrenderable::CubicLabels`] where the values are labels, which have nothing between them; where the memory does not suffice.
    pub(crate) fn made(self, subject: &Subject) -> Result<Subject, Error> {
        let Self([shown_factors, ior_factors]) = self;
        let finer = |volume: &Volume, factors| {
            volume.require_whole("cubic interpolation")?;
            if preset::holds_labels(volume) {
                return Err(Unrenderable::CubicLabels { name: volume.name.clone() }.into());
            }
            cubic::refined(volume, factors).map(Arc::new)
        };
        Ok(match subject {
            Subject::Mesh(_) => subject.clone(),
            Subject::Volume(volume) => Subject::Volume(finer(volume, shown_factors)?),
            Subject::Volumes { shown, ior } => {
                Subject::Volumes { shown: finer(shown, shown_factors)?, ior: finer(ior, ior_factors)? }
            }
        })
    }
}

/// The scene of `volume` for the same volume on a finer grid: opacities stay what they were. Planes are nearer to one another, as a cubic field bends
/// between them.
pub(crate) fn on_finer(scene: &Scene, volume: &Volume) -> Scene {
    let mut scene = scene.clone();
    scene.transfer.reference_length = Some(scene.transfer.reference_length_in(volume));
    scene
}
