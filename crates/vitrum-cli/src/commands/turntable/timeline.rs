//! The scene at each frame.

use super::Arguments;
use crate::failure::{Failure, Status};
use std::path::Path;
use vitrum::composition::read_text;
use vitrum::scene::{KeyFrames, Motion, Scene};
use vitrum::{Assets, MovingMeshes};

/// Pictures of a whole turn.
const TURN: u32 = 72;

/// The scene at each frame of an animation.
pub struct Timeline {
    start: Scene,
    frames: u32,
    motion: Motion,
}

/// Reads a file of key frames.
pub fn read_keys(path: &Path, rate: u16) -> Result<KeyFrames, Failure> {
    let text = read_text(path, "key frames")?;
    Ok(KeyFrames::from_toml(&text, &path.display().to_string(), f64::from(rate))?)
}

impl Timeline {
    /// Fails where a frame has no valid scene of these assets, so that no animation breaks off at it.
    pub fn new(
        arguments: &Arguments,
        start: Scene,
        assets: &Assets,
        meshes: &mut MovingMeshes,
        keys: Option<KeyFrames>,
        points_in_time: Option<u32>,
    ) -> Result<Self, Failure> {
        let (motion, frames) = match keys {
            Some(keys) => {
                let motion = Motion::Keys(keys);
                let frames = arguments.frames.or(motion.key_frames()).unwrap_or(TURN);
                (motion, frames)
            }
            None if points_in_time.is_some() && arguments.turn.is_none() => {
                (Motion::Turn(0.0), arguments.frames.or(points_in_time).unwrap_or(TURN))
            }
            None if start.camera.position.is_some() => {
                let message = "the scene sets camera.position, which a turntable cannot turn";
                let help = "use camera.azimuth and camera.elevation instead, or move the camera by --keys";
                return Err(Failure::new(Status::WrongUse, message, help));
            }
            None => {
                let turn = arguments.turn.unwrap_or(360.0);
                (Motion::Turn(turn), arguments.frames.or(points_in_time).unwrap_or(TURN))
            }
        };
        let timeline = Self { start, frames, motion };
        let mut assets = assets.clone();
        for index in 0..frames {
            let scene = timeline.scene(index)?;
            if timeline.moves_meshes() {
                assets.set_mesh(meshes.at(&scene.mesh)?);
            }
            vitrum::check(&scene, &assets)
                .map_err(|error| Failure::from(error).at(&format!("frame {index} of {frames}")))?;
        }
        Ok(timeline)
    }

    /// The scene that the animation is made of, whose size all frames have.
    pub fn start(&self) -> &Scene {
        &self.start
    }

    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// Whether the meshes of one frame are in other places than those of another.
    pub fn moves_meshes(&self) -> bool {
        self.motion.moves_meshes(&self.start)
    }

    pub fn scene(&self, index: u32) -> Result<Scene, Failure> {
        Ok(self.motion.at(&self.start, index, self.frames)?)
    }
}
