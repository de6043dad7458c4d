//! Up: the direction of a volume that points to +z, for files that do not name it, or that are to be shown otherwise.

use std::fmt;
use std::str::FromStr;

use crate::orientation::Orientation;
use crate::volume::Volume;

/// A direction along a world axis. World x is a patient's right, y anterior, z superior.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Up {
    /// +x, the right.
    Right,
    /// -x, the left.
    Left,
    /// +y, anterior.
    Anterior,
    /// -y, posterior.
    Posterior,
    /// +z, superior: as the file has it.
    Superior,
    /// -z, inferior.
    Inferior,
}

impl Up {
    /// Each direction by its two names: the axis and the patient's.
    pub const NAMES: [(&'static str, &'static str, Self); 6] = [
        ("x", "right", Self::Right),
        ("-x", "left", Self::Left),
        ("y", "anterior", Self::Anterior),
        ("-y", "posterior", Self::Posterior),
        ("z", "superior", Self::Superior),
        ("-z", "inferior", Self::Inferior),
    ];

    /// The vector, turned so that this direction points to +z. The front (+y) stays the front; where it is the direction that goes up
    /// or down, +z becomes the front.
    #[must_use]
    pub fn turn(self, vector: [f32; 3]) -> [f32; 3] {
        self.rotation().map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
    }

    /// The rows of the rotation, never of a reflection: this direction turns to +z, and the front (+y) stays the front, or +z becomes
    /// it.
    fn rotation(self) -> [[f32; 3]; 3] {
        match self {
            Self::Superior => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Self::Inferior => [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
            Self::Anterior => [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
            Self::Posterior => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
            Self::Right => [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
            Self::Left => [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]],
        }
    }
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = Self::NAMES.iter().find(|(_, _, up)| up == self).map_or("", |(axis, _, _)| axis);
        f.write_str(name)
    }
}

impl FromStr for Up {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let lower = text.trim().to_ascii_lowercase();
        let plain = lower.strip_prefix('+').unwrap_or(&lower);
        let found = Self::NAMES.iter().find(|(axis, name, _)| plain == *axis || plain == *name);
        found.map(|&(_, _, up)| up).ok_or_else(|| {
            let names = Self::NAMES.map(|(axis, name, _)| format!("{axis} ({name})"));
            format!("`{text}` is no direction; expected one of {}", names.join(", "))
        })
    }
}

impl Volume {
    /// The volume, turned around the world's origin so that `up` points to +z. See [`Up`].
    #[must_use]
    pub fn turned(mut self, up: Up) -> Self {
        let rotation = up.rotation();
        let turn = |vector: [f32; 3]| -> [f32; 3] {
            // Each row has one entry, so that nothing is rounded; 0 is added so that no zero is negative.
            rotation.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2] + 0.0)
        };
        self.axes = self.axes.map(turn);
        self.origin = turn(self.origin);
        if up != Up::Superior {
            // The axes are no longer along the patient's.
            if self.orientation == Orientation::Patient {
                self.orientation = Orientation::World;
            }
            self.source.assumptions.push(format!("the volume was turned so that {up} points up, as was asked for"));
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::Voxels;

    #[test]
    fn every_direction_goes_up_by_a_rotation() {
        for (axis, name, up) in Up::NAMES {
            assert_eq!((axis.parse(), name.parse(), up.to_string()), (Ok(up), Ok(up), axis.to_owned()));
            let sign = if axis.starts_with('-') { -1.0 } else { 1.0 };
            let direction = ["x", "y", "z"].map(|letter| if axis.ends_with(letter) { sign } else { 0.0 });
            let mut volume = Volume::new("a", [2, 1, 1], [1.0; 3], Voxels::U8(vec![0, 1].into())).expect("a volume");
            volume.origin = direction;
            let volume = volume.turned(up);
            assert_eq!(volume.origin, [0.0, 0.0, 1.0], "{axis}");
            let [a, b, c] = volume.axes;
            let determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]);
            assert_eq!(determinant, 1.0, "{axis}");
        }
        assert!("w".parse::<Up>().unwrap_err().contains("z (superior)"));
        assert_eq!("+Z".parse(), Ok(Up::Superior));
    }
}
