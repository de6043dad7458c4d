//! Common magnitudes of a volume's gradient.

use crate::shown::colors::magnitude_percentiles;
use vitrum_io::Volume;

/// The gradient magnitudes below which these shares of a volume's voxels are, as [`GradientPoint`](crate::scene::GradientPoint) takes them: changes of
/// the value over the mean edge of a voxel. Of large volumes a million voxels are looked at.
#[must_use]
pub fn gradient_percentiles<const N: usize>(volume: &Volume, shares: [f64; N]) -> [f32; N] {
    magnitude_percentiles(volume, shares)
}
