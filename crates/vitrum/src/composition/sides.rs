//! The sides from which a patient is looked at.

use super::CompositionError;
use crate::scene::Scene;
use crate::subject::Subject;
use std::str::FromStr;
use vitrum_io::Orientation;

/// A side of the patient from which the camera looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The front.
    Anterior,
    /// The back.
    Posterior,
    /// The patient's left.
    Left,
    /// The patient's right.
    Right,
    /// From above, the front upwards in the picture.
    Superior,
    /// From below, the front upwards in the picture: the patient's left is on the right, as in slices.
    Inferior,
}

impl Side {
    /// Every side.
    pub const ALL: [Self; 6] =
        [Self::Anterior, Self::Posterior, Self::Left, Self::Right, Self::Superior, Self::Inferior];

    /// Name of the side.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Anterior => "anterior",
            Self::Posterior => "posterior",
            Self::Left => "left",
            Self::Right => "right",
            Self::Superior => "superior",
            Self::Inferior => "inferior",
        }
    }

    /// Azimuth, and the direction that is up.
    fn camera(self) -> (f32, [f32; 3]) {
        const SUPERIOR: [f32; 3] = [0.0, 0.0, 1.0];
        const ANTERIOR: [f32; 3] = [0.0, 1.0, 0.0];
        match self {
            Self::Anterior => (0.0, SUPERIOR),
            Self::Posterior => (180.0, SUPERIOR),
            Self::Left => (90.0, SUPERIOR),
            Self::Right => (-90.0, SUPERIOR),
            Self::Superior => (0.0, ANTERIOR),
            Self::Inferior => (180.0, ANTERIOR),
        }
    }

    /// Turns the camera to the side, straight. From above and below there is no ground.
    pub fn look(self, scene: &mut Scene) {
        let camera = &mut scene.camera;
        (camera.azimuth, camera.up) = self.camera();
        (camera.elevation, camera.roll, camera.position) = (0.0, 0.0, None);
        // It would stand upright in the picture, as it lies across `camera.up`.
        if matches!(self, Self::Superior | Self::Inferior) {
            scene.ground = None;
        }
    }

    /// The settings of a camera that would look along this side's axis in a world that is no patient's.
    pub(super) fn settings(self) -> String {
        let (azimuth, [x, y, z]) = self.camera();
        format!("--set camera.azimuth={azimuth} --set camera.elevation=0 --set camera.up=[{x},{y},{z}]")
    }

    /// Fails where the subject is no patient whose sides are known.
    pub(super) fn check(self, subject: &Subject) -> Result<(), CompositionError> {
        let kind = match subject.volume().map(|volume| volume.orientation) {
            Some(Orientation::Patient) => return Ok(()),
            Some(Orientation::World) => "the volume lies in a world that is no patient's",
            Some(Orientation::Unknown) => "the file does not say how the patient lies",
            None => "a mesh is no patient with known sides",
        };
        Err(CompositionError::NoSides { side: self, kind })
    }
}

impl FromStr for Side {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|side| side.name() == text.to_ascii_lowercase());
        found.ok_or_else(|| format!("expected one of {}", Self::ALL.map(Self::name).join(", ")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::{Bounds, View};
    use glam::DVec3;

    /// Where the camera stands, and the world's directions to the right and up in the picture.
    #[test]
    fn each_side_is_seen_as_a_radiologist_expects() {
        let [right, anterior, superior] = [DVec3::X, DVec3::Y, DVec3::Z];
        for (side, from, across, up) in [
            (Side::Anterior, anterior, -right, superior),
            (Side::Posterior, -anterior, right, superior),
            (Side::Left, -right, -anterior, superior),
            (Side::Right, right, anterior, superior),
            (Side::Superior, superior, right, anterior),
            (Side::Inferior, -superior, -right, anterior),
        ] {
            let mut scene = Scene::default();
            side.look(&mut scene);
            let volume = vitrum_io::Volume::new("cube", [2; 3], [1.0; 3], vec![0_u8; 8].into()).expect("it is valid");
            let view = View::new(&scene, Bounds::from(&volume));
            let seen = [-view.axes.z_axis, view.axes.x_axis, view.axes.y_axis];
            for (seen, exact) in seen.into_iter().zip([from, across, up]) {
                assert!((seen - exact).length() < 1e-6, "{side:?}: {seen}");
            }
        }
    }
}
