//! Volumes whose contents are known, for tests.

/// Normal numbers: the mean is 0, the deviation 1.
#[derive(Debug)]
pub(crate) struct Normal(u64);

impl Default for Normal {
    fn default() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }
}

impl Normal {
    /// A number from 0 to 1.
    pub(crate) fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// The next number (Box and Muller 1958).
    pub(crate) fn next(&mut self) -> f32 {
        let (radius, angle) = ((-2.0 * libm::log(self.uniform())).sqrt(), std::f64::consts::TAU * self.uniform());
        (radius * libm::cos(angle)) as f32
    }
}

/// A ball of matter, 1000, with a smooth rim, in nothing, 0; its radius is 0.35 edges.
pub(crate) fn ball(size: u32) -> Vec<f32> {
    let radius = 0.35 * size as f32;
    let at = |index: u32| [index % size, index / size % size, index / (size * size)];
    let from_middle = |at: [u32; 3]| {
        let squares = at.map(|index| index as f32 - 0.5 * (size as f32 - 1.0)).map(|along| along * along);
        libm::sqrtf(squares.iter().sum())
    };
    (0..size.pow(3)).map(|index| 1000.0 * (radius - from_middle(at(index)) + 0.5).clamp(0.0, 1.0)).collect()
}
