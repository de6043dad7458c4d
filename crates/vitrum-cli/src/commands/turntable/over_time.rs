//! A volume's points in time, one after the other.

use crate::failure::{Failure, Status};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use vitrum::scene::{Scene, VolumeSource};
use vitrum::{Assets, Subject, load_volume};

/// The volume of each frame.
pub struct OverTime {
    source: VolumeSource,
    base: PathBuf,
    assets: Assets,
    limit: Option<u64>,
    /// The number of points in time.
    count: u32,
}

impl OverTime {
    /// The points in time of `input`, each of at most `limit` bytes. Fails where there are none.
    pub fn new(
        (input, limit): (&str, Option<u64>),
        scene: &Scene,
        base: &Path,
        assets: &Assets,
    ) -> Result<Self, Failure> {
        let refuse = |message: String, help: &str| Err(Failure::new(Status::WrongUse, message, help));
        let Some(volume) = assets.subject.volume() else {
            return refuse(format!("{input}: a mesh has no points in time"), "leave out --over-time");
        };
        let count = volume.source.moments().map_or(1, |moments| moments.count);
        let Some(count) = u32::try_from(count).ok().filter(|&count| count > 1) else {
            return refuse(
                format!("{input}: there is one point in time in it"),
                "name a file with several, a collection (.pvd), or one of a numbered series of .vti files",
            );
        };
        let source = scene.volume.clone();
        Ok(Self { source, base: base.to_owned(), assets: assets.clone(), limit, count })
    }

    /// The number of pictures that shows each point once.
    pub fn frames(&self) -> u32 {
        self.count
    }

    /// The data of a frame of so many.
    pub fn at(&self, frame: u32, frames: u32) -> Result<Assets, Failure> {
        let point = u64::from(frame) * u64::from(self.count) / u64::from(frames.max(1));
        let time = u32::try_from(point).unwrap_or(u32::MAX).min(self.count - 1);
        let source = VolumeSource { time: Some(time), seconds: None, ..self.source.clone() };
        let shown = Arc::new(load_volume(&source, &self.base, self.limit)?);
        let subject = match &self.assets.subject {
            Subject::Volumes { ior, .. } => Subject::Volumes { shown, ior: ior.clone() },
            _ => Subject::Volume(shown),
        };
        Ok(Assets { subject, ..self.assets.clone() })
    }
}
