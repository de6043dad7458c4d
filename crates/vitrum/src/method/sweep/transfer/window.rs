//! The scalars over which transfer functions change.

use vitrum_io::Volume;
use vitrum_kernels::field::stencil::normalise;

/// The part of a volume's scalars that normalised scalars from 0 to 1 stand for: that over which the functions change, whatever else the volume
/// holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::method::sweep) struct Window {
    /// The physical value of the normalised scalar 0.
    pub(in crate::method::sweep) origin: f64,
    /// Physical values from 0 to 1; positive.
    pub(in crate::method::sweep) width: f64,
}

impl Window {
    /// The window of functions that change over `supports`, for `volume`.
    pub(in crate::method::sweep) fn new(supports: impl IntoIterator<Item = [f64; 2]>, volume: &Volume) -> Self {
        let whole = supports.into_iter().reduce(|[low, high], [lower, higher]| [low.min(lower), high.max(higher)]);
        let [low, high] = whole.unwrap_or_else(|| volume.range.map(f64::from));
        if high > low {
            return Self { origin: low, width: high - low };
        }
        // One step: the common values say how fine it is.
        let [lowest, highest] = volume.common_range().map(f64::from);
        Self { origin: low, width: if highest > lowest { highest - lowest } else { 1.0 } }
    }

    /// The normalised scalar of a physical value.
    pub(in crate::method::sweep) fn normalised(self, value: f64) -> f64 {
        (value - self.origin) / self.width
    }

    /// The stored value of the normalised scalar 0, and normalised scalars per stored value; see [`normalise`].
    pub(in crate::method::sweep) fn of_stored(self, volume: &Volume) -> [f32; 2] {
        let (scale, offset) = (f64::from(volume.value_scale), f64::from(volume.value_offset));
        [((self.origin - offset) / scale) as f32, ((scale / self.width) as f32).clamp(f32::MIN, f32::MAX)]
    }

    /// The normalised scalar of a stored value, as kernels compute it.
    pub(in crate::method::sweep) fn normalised_as_kernels_do(self, stored: f32, volume: &Volume) -> f32 {
        let [origin, scale] = self.of_stored(volume);
        normalise(stored, origin, scale)
    }
}
