//! Placement of a grid in the world, from the direction columns that medical files give.

use glam::DVec3;

use crate::error::{Error, Place, Report};
use crate::options::OpenOptions;
use crate::orientation::Orientation;
use crate::samples::SampleType;
use crate::setting::Setting;
use crate::source::{Assumption, Assumptions};
use crate::stored::Stored;
use crate::tolerance;
use crate::volume::{IDENTITY, Volume, check_extent, check_spacing};

/// The assumption about formats and files that do not say how the grid lies in the world.
pub(crate) fn unoriented() -> Assumption {
    let fact = "the file says no orientation: its z was taken for up and its y for the front, and left and right may be \
                exchanged";
    Assumption::replaceable(fact, Setting::Up, "")
}

/// Spacing, axes and, where the file says it, origin.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Placement {
    pub spacing: [f32; 3],
    pub axes: [[f32; 3]; 3],
    /// `None` centres the grid on the world's origin.
    pub origin: Option<[f32; 3]>,
    pub orientation: Orientation,
}

impl Placement {
    /// From the world step of each index axis, in columns: spacing is a column's length.
    ///
    /// Fails, with the problem, where a number is not finite or the columns do not span space.
    pub fn from_columns(
        columns: [[f64; 3]; 3],
        origin: Option<[f64; 3]>,
        orientation: Orientation,
    ) -> Result<Self, String> {
        let lengths = columns.map(|[x, y, z]| libm::hypot(libm::hypot(x, y), z));
        let unit: [[f64; 3]; 3] = std::array::from_fn(|axis| columns[axis].map(|component| component / lengths[axis]));
        // Of unit columns: 1 at right angles, 0 where two or three fall together.
        let [a, b, c] = unit.map(DVec3::from);
        let volume = a.dot(b.cross(c)).abs();
        if lengths.iter().any(|&length| !(length > 0.0 && length.is_finite())) || volume < 1e-4 {
            return Err(format!(
                "the axis directions {} {} {} do not span space",
                vector(columns[0]),
                vector(columns[1]),
                vector(columns[2])
            ));
        }
        let origin = origin.map(narrow_origin).transpose()?;
        Ok(Self { spacing: lengths.map(|length| length as f32), axes: unit.map(narrow), origin, orientation })
    }

    /// As [`Self::from_columns`], mended by the rule of [`tolerance`]: an origin that is not finite is dropped; one column without a
    /// length takes the direction across the other two; and where the user says what is up, columns that do not span space are
    /// replaced by the world's.
    pub fn mended(
        mut columns: [[f64; 3]; 3],
        origin: Option<[f64; 3]>,
        orientation: Orientation,
        options: &OpenOptions,
        assumptions: &mut Assumptions,
    ) -> Result<Self, String> {
        let origin = tolerance::origin(origin, assumptions);
        let has_length = |column: &[f64; 3]| {
            let length = DVec3::from(*column).length() as f32;
            length > 0.0 && length.is_finite()
        };
        let bad: Vec<usize> = (0..3).filter(|&axis| !has_length(&columns[axis])).collect();
        if let [axis] = bad[..] {
            let other = |step: usize| DVec3::from(columns[(axis + step) % 3]).normalize();
            let across = other(1).cross(other(2)).normalize_or_zero();
            let fact = format!(
                "the direction {} of axis {} is none: it was taken to stand across the others, with the spacing 1",
                vector(columns[axis]),
                ["x", "y", "z"][axis]
            );
            columns[axis] = across.to_array();
            assumptions.push(Assumption::replaceable(fact, Setting::Spacing, ""));
        }
        match Self::from_columns(columns, origin, orientation) {
            Err(problem) if options.up.is_some() => {
                assumptions.push(format!("{problem}: the world's were taken instead, as what is up was given"));
                let length = |axis: usize| {
                    if has_length(&columns[axis]) { DVec3::from(columns[axis]).length() } else { 1.0 }
                };
                let columns = [0, 1, 2].map(|axis| IDENTITY[axis].map(|unit| f64::from(unit) * length(axis)));
                Self::from_columns(columns, origin, Orientation::World)
            }
            other => other,
        }
    }

    /// A sentence for [`crate::Source::assumptions`] where the axes are not at right angles.
    pub fn shear_note(&self) -> Option<String> {
        let [a, b, c] = self.axes.map(|axis| DVec3::from(axis.map(f64::from)));
        let skew = [a.dot(b), b.dot(c), c.dot(a)].into_iter().fold(0.0, |most, cosine| f64::max(most, cosine.abs()));
        (skew > 1e-3).then(|| {
            let degrees = 90.0 - libm::acos(skew.min(1.0)).to_degrees();
            format!("the axes are up to {degrees:.1}° off right angles, as the file says")
        })
    }

    /// The volume of a file's voxels, put here.
    pub fn volume(
        &self,
        name: &str,
        dimensions: [u32; 3],
        voxels: impl Into<Stored>,
        sample: SampleType,
    ) -> Result<Volume, Error> {
        let mut volume = Volume::of_samples(name.to_owned(), dimensions, self.spacing, voxels, sample)?;
        self.apply(&mut volume);
        Ok(volume)
    }

    /// Moves `volume`, which has this spacing already.
    pub fn apply(&self, volume: &mut Volume) {
        volume.axes = self.axes;
        volume.orientation = self.orientation;
        volume.origin = self.origin.unwrap_or_else(|| {
            // Step back from the world's origin by half of the grid along each axis.
            std::array::from_fn(|component| {
                -(0..3)
                    .map(|axis| {
                        let half = 0.5 * (volume.dimensions[axis] - 1) as f32;
                        half * self.spacing[axis] * self.axes[axis][component]
                    })
                    .sum::<f32>()
            })
        });
    }
}

impl Volume {
    /// The volume put in its place: `columns` are the world's steps along each index axis, whose lengths become the spacing; `origin` is the position of voxel
    /// (0, 0, 0), and without it the grid stays centred on the world's origin.
    ///
    /// # Errors
    ///
    /// [`Error::Invalid`] where a number is not finite, the columns do not span space, or an extent is above 1e18.
    pub fn with_placement(
        mut self,
        columns: [[f64; 3]; 3],
        origin: Option<[f64; 3]>,
        orientation: Orientation,
    ) -> Result<Self, Error> {
        let report = Report::new(&self.name);
        let placement = Placement::from_columns(columns, origin, orientation).map_err(|problem| {
            report.invalid(Place::File, problem, "correct the directions, spacings and the origin")
        })?;
        check_spacing(report, placement.spacing)?;
        check_extent(report, self.dimensions, placement.spacing)?;
        self.spacing = placement.spacing;
        self.source.assumptions.extend(placement.shear_note());
        placement.apply(&mut self);
        Ok(self)
    }
}

/// A world position in float32, or the problem with it.
pub(crate) fn narrow_origin(origin: [f64; 3]) -> Result<[f32; 3], String> {
    let narrowed = narrow(origin);
    if narrowed.iter().all(|value| value.is_finite()) {
        Ok(narrowed)
    } else {
        Err(format!("the origin {} is not finite in float32", vector(origin)))
    }
}

fn narrow(values: [f64; 3]) -> [f32; 3] {
    values.map(|value| value as f32)
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("({x:?}, {y:?}, {z:?})")
}

/// Millimetres per unit of length, where the name is known.
pub(crate) fn millimetres(unit: &str) -> Option<f64> {
    match unit.trim() {
        // By symbol: capitals tell them apart.
        "m" => Some(1e3),
        "cm" => Some(1e1),
        "mm" => Some(1.0),
        "um" | "µm" | "μm" | "\\u00B5m" | "\\u00b5m" => Some(1e-3),
        "nm" => Some(1e-6),
        "pm" => Some(1e-9),
        "Å" | "\u{212b}" => Some(1e-7),
        other => match other.to_lowercase().trim_end_matches('s') {
            "meter" | "metre" => Some(1e3),
            "cm" | "centimeter" | "centimetre" => Some(1e1),
            "mm" | "millimeter" | "millimetre" => Some(1.0),
            "um" | "µm" | "μm" | "micron" | "micrometer" | "micrometre" => Some(1e-3),
            "nm" | "nanometer" | "nanometre" => Some(1e-6),
            "angstrom" => Some(1e-7),
            "in" | "inch" | "inche" => Some(25.4),
            _ => None,
        },
    }
}
