//! The named outputs of a method's frames, and their channels in its film records.

/// A named output of a frame.
#[derive(Debug, Clone, Copy)]
pub struct Output {
    /// Name of the output.
    pub name: &'static str,
    /// The quantity, with its unit and range.
    pub description: &'static str,
    /// Whether the output holds vectors, whose components may be negative.
    pub is_vector: bool,
    /// Whether the values are lengths or numbers, which go beyond 1 and are no light.
    pub is_measure: bool,
    /// The names of its channels with their components in the method's film records; none for an output whose size is not the
    /// picture's.
    pub(crate) channels: &'static [(&'static str, usize)],
    /// The rule for a pixel that several rays go through.
    pub(crate) pixel: PixelFilter,
    /// The rule for a sum of several exposures.
    pub(crate) blend: Blend,
}

/// The rule for the value of a pixel that several rays go through.
#[derive(Debug, Clone, Copy)]
pub(crate) enum PixelFilter {
    /// The mean.
    Mean,
    /// The mean, weighted by another component; 0 where the weights are 0.
    WeightedBy(usize),
    /// The mean of the rays whose value is not 0.
    Present,
    /// The unit vector of the mean's direction; 0 where the mean is 0.
    Direction,
    /// The value of the ray nearest to the pixel's centre, for categorical outputs, which have no mean.
    Nearest,
}

/// The rule for the value of a picture that is a sum of several exposures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Blend {
    /// The sum, weighted by the exposures' weights of the channel: red, green and blue; the mean of the three for other channels.
    Sum,
    /// The sum for red, green and blue; for coverage, the sum of the exposures of the part `Whole` alone: further lights add to the
    /// radiance alone.
    Radiance,
    /// The value of the exposure with the least distance.
    Nearest,
}

impl Output {
    /// The output of the picture's radiance and coverage.
    pub(crate) const fn color(channels: &'static [(&'static str, usize)]) -> Self {
        let description = "linear radiance and coverage (RGBA)";
        Self {
            name: "color",
            description,
            is_vector: false,
            is_measure: false,
            channels,
            pixel: PixelFilter::Mean,
            blend: Blend::Radiance,
        }
    }

    /// An output with a mean over a pixel's rays and over exposures.
    pub(crate) const fn mean(
        name: &'static str,
        channels: &'static [(&'static str, usize)],
        description: &'static str,
    ) -> Self {
        let pixel = PixelFilter::Mean;
        Self { name, description, is_vector: false, is_measure: false, channels, pixel, blend: Blend::Sum }
    }

    /// An output of radiance: the sum over exposures, those of further lights too.
    pub(crate) const fn radiance(
        name: &'static str,
        channels: &'static [(&'static str, usize)],
        description: &'static str,
    ) -> Self {
        Self { blend: Blend::Radiance, ..Self::mean(name, channels, description) }
    }

    /// An output of vectors, of which a pixel shows the mean direction.
    pub(crate) const fn directions(
        name: &'static str,
        channels: &'static [(&'static str, usize)],
        description: &'static str,
    ) -> Self {
        let blend = Blend::Nearest;
        let pixel = PixelFilter::Direction;
        Self { name, description, is_vector: true, is_measure: false, channels, pixel, blend }
    }

    /// An output of which a pixel shows the value of its central ray.
    pub(crate) const fn central(
        name: &'static str,
        channels: &'static [(&'static str, usize)],
        description: &'static str,
    ) -> Self {
        let blend = Blend::Nearest;
        let pixel = PixelFilter::Nearest;
        Self { name, description, is_vector: false, is_measure: true, channels, pixel, blend }
    }

    /// The output with another rule for a pixel that several rays go through, and with the value of the nearest exposure.
    pub(crate) const fn filtered(self, pixel: PixelFilter) -> Self {
        Self { pixel, blend: Blend::Nearest, ..self }
    }

    /// The output as one of lengths.
    pub(crate) const fn lengths(self) -> Self {
        Self { is_measure: true, ..self }
    }

    /// The output as one of vectors.
    pub(crate) const fn vectors(self) -> Self {
        Self { is_vector: true, is_measure: false, ..self }
    }
}

/// The channels of a colour whose components begin at `from`.
macro_rules! rgb {
    ($from:expr) => {
        &[("R", $from), ("G", $from + 1), ("B", $from + 2)]
    };
}

/// The channels of a colour and its coverage.
macro_rules! rgba {
    ($from:expr, $coverage:expr) => {
        &[("R", $from), ("G", $from + 1), ("B", $from + 2), ("A", $coverage)]
    };
}

/// The channels of a vector.
macro_rules! xyz {
    ($from:expr) => {
        &[("X", $from), ("Y", $from + 1), ("Z", $from + 2)]
    };
}

pub(crate) use {rgb, rgba, xyz};
