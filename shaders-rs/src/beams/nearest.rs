//! Where a viewing ray and the middle of a beam come nearest to each other.

use crate::math::{cross, dot, max};
use spirv_std::glam::Vec3;

/// The nearest points of two lines.
#[derive(Clone, Copy)]
pub struct Nearest {
    /// Distance along the viewing ray.
    pub t: f32,
    /// Distance along the beam.
    pub s: f32,
    /// Cosine of the angle between the lines.
    pub cosine: f32,
}

impl Nearest {
    /// The nearest points of a viewing ray along the unit vector `w` and a beam along the unit vector `d`, which begins at `offset` from where the
    /// ray begins.
    #[inline(always)]
    pub fn new(offset: Vec3, w: Vec3, d: Vec3) -> Self {
        let (along_view, along_light) = (dot(offset, w), dot(offset, d));
        let cosine = dot(w, d);
        let normal = cross(w, d);
        let inverse = 1.0 / max(dot(normal, normal), 1e-9);
        Self {
            t: (along_view - cosine * along_light) * inverse,
            s: (cosine * along_view - along_light) * inverse,
            cosine,
        }
    }
}
