//! Key frames: values of scene keys at some frames of an animation, and smooth curves between them.

mod curve;
mod read;
mod value;

use super::Scene;
use super::error::{Fault, Origin, SceneError};
use super::set::entry;
use curve::Curve;
use toml::Value;

/// Key frames: the values of a scene's keys over the frames of an animation.
///
/// Each key has a curve of its own through the key frames that name it, and rests before the first and after the last. Numbers,
/// vectors, colours and lists of points are interpolated number by number, along curves that never go beyond the values on both
/// sides; whole numbers are rounded; texts and switches step.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyFrames {
    name: String,
    tracks: Vec<Track>,
    last_frame: f64,
}

/// One key of the scene.
#[derive(Debug, Clone, PartialEq)]
struct Track {
    path: Vec<String>,
    interpolation: Interpolation,
}

#[derive(Debug, Clone, PartialEq)]
enum Interpolation {
    /// A curve through the numbers of a value that looks like `form`.
    Smooth { form: Value, curve: Curve, whole: bool },
    /// Values from their frame on.
    Steps(Vec<(f64, Value)>),
}

impl KeyFrames {
    /// The last key frame, counted from 0.
    #[must_use]
    pub fn last_frame(&self) -> f64 {
        self.last_frame
    }

    /// Whether any of them sets the key at this dotted path, or one inside.
    #[must_use]
    pub fn set(&self, path: &str) -> bool {
        let path: Vec<_> = path.split('.').collect();
        let starts =
            |track: &Track| track.path.len() >= path.len() && track.path.iter().zip(&path).all(|(a, b)| a == b);
        self.tracks.iter().any(starts)
    }

    /// The scene at a frame.
    ///
    /// # Errors
    ///
    /// Where the values of this frame contradict each other or the rest of the scene, as [`Scene::validate`] finds.
    pub fn at(&self, scene: &Scene, frame: u32) -> Result<Scene, SceneError> {
        let make = || {
            let mut table = scene.to_table()?;
            for track in &self.tracks {
                *entry(&mut table, &track.path)? = track.interpolation.at(f64::from(frame));
            }
            let scene = Scene::from_table(table)?;
            scene.check_consistency()?;
            Ok(scene)
        };
        let origin = || Origin::File { name: format!("{}, frame {frame}", self.name), line: None };
        make().map_err(|fault: Fault| fault.from(origin()))
    }
}

impl Interpolation {
    fn at(&self, frame: f64) -> Value {
        match self {
            Self::Smooth { form, curve, whole } => value::filled(form, &mut curve.at(frame).into_iter(), *whole),
            Self::Steps(steps) => {
                let index = steps.partition_point(|(place, _)| *place <= frame).saturating_sub(1);
                steps[index].1.clone()
            }
        }
    }
}
