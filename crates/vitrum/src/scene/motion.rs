//! The motion of an animation: the scene at each of its frames.

use super::error::SceneError;
use super::{KeyFrames, Scene};

/// The motion of an animation.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// The camera goes round by so many degrees.
    Turn(f32),
    /// Scene keys change along key frames.
    Keys(KeyFrames),
}

impl Motion {
    /// The scene at one of `frames` frames of an animation of `start`.
    ///
    /// # Errors
    /// Those of [`KeyFrames::at`].
    pub fn at(&self, start: &Scene, index: u32, frames: u32) -> Result<Scene, SceneError> {
        match self {
            Self::Keys(keys) => keys.at(start, index),
            Self::Turn(turn) => {
                let mut scene = start.clone();
                scene.camera.azimuth += turn * index as f32 / frames as f32;
                Ok(scene)
            }
        }
    }

    /// The number of frames up to the last key frame; `None` for a turn, which may have any.
    #[must_use]
    pub fn key_frames(&self) -> Option<u32> {
        match self {
            Self::Keys(keys) => Some(keys.last_frame().floor() as u32 + 1),
            Self::Turn(_) => None,
        }
    }

    /// Whether meshes of one frame of `scene` are in other places than those of another.
    #[must_use]
    pub fn moves_meshes(&self, scene: &Scene) -> bool {
        let Self::Keys(keys) = self else { return false };
        (0..scene.mesh.len()).any(|index| keys.set(&format!("mesh.{index}.time")))
    }
}
