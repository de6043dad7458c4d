//! Errors against closed forms: measured values, and the bounds that tests hold them to.
//!
//! This table is the source of the first table of `docs/accuracy.md` (`cargo xtask docs`). No bound is more than twice the measured value. To
//! refresh a value, take it from the failure's message, or list them all; nothing is held to the table then:
//! `VITRUM_MEASURE=1 cargo test --release -p vitrum-conformance --test closed_forms -- --nocapture | grep '^measured'`.

use std::fmt;

use vitrum::backend::Backend;

use crate::bounds;
use crate::left_out;

/// The environment variable by which errors are listed, and not held to the table.
const MEASURE: &str = "VITRUM_MEASURE";

/// How far a measured value may be from the table's on a backend that is held to the last bit: the table has two digits.
const ROUNDING: f64 = 0.05;

/// The error of a quantity whose true value is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorBound {
    /// The closed form.
    pub form: &'static str,
    /// The grid, and the part of the picture that is measured.
    pub setup: &'static str,
    /// The quantity with the error, and its unit.
    pub quantity: &'static str,
    /// The largest error measured, the same to the last bit on the CPU and on lavapipe; two digits.
    pub measured: f64,
    /// The largest error that a test allows, at most twice what was measured.
    pub bound: f64,
    /// The largest error allowed on adapters that are not held to the last bit, if it is another one: where the error is rounding alone.
    pub elsewhere: Option<f64>,
}

impl ErrorBound {
    /// Holds an error to the bound, and on a backend that is exact also to the measured value.
    ///
    /// # Panics
    /// If it is larger, or the table is out of date.
    pub fn hold(&self, error: f64, backend: &dyn Backend) {
        self.hold_on(error, backend.name(), bounds::is_exact(backend));
    }

    /// As [`Self::hold`], of a computation that needs no backend.
    ///
    /// # Panics
    /// As [`Self::hold`].
    pub fn hold_native(&self, error: f64) {
        self.hold_on(error, "native", true);
    }

    fn hold_on(&self, error: f64, place: &str, is_exact: bool) {
        println!("measured: {self}: {error:.3e} ({place})");
        if left_out::is_set(MEASURE) {
            return;
        }
        let bound = if is_exact { self.bound } else { self.elsewhere.unwrap_or(self.bound) };
        assert!(error <= bound, "{self}: {error:.3e} was measured ({place}), the bound is {bound:.1e}");
        assert!(
            !is_exact || (error - self.measured).abs() <= ROUNDING * self.measured,
            "{self}: {error:.3e} was measured ({place}), but tests/src/closed_forms/table.rs says {:.1e}; put the new value there and run \
             `cargo xtask docs`",
            self.measured
        );
    }

    fn cells(&self, before: Option<&Self>) -> [String; 5] {
        // Where a cell says what the one above it says, it stays empty.
        let form = if before.is_some_and(|before| before.form == self.form) { "" } else { self.form };
        let setup = if before.is_some_and(|before| (before.form, before.setup) == (self.form, self.setup)) {
            ""
        } else {
            self.setup
        };
        [form.to_owned(), setup.to_owned(), self.quantity.to_owned(), digits(self.measured), digits(self.bound)]
    }
}

impl fmt::Display for ErrorBound {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}; {}; {}", self.form, self.setup, self.quantity)
    }
}

/// The larger of two errors, and NaN if one of them is.
#[must_use]
pub fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || one > other { one } else { other }
}

/// A number with two digits, as people write it.
fn digits(value: f64) -> String {
    if value >= 1.0 {
        return format!("{value:.1}");
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{value:.1e}");
    if value < 1e-3 { text } else { text.parse::<f64>().map_or(text, |rounded| rounded.to_string()) }
}

/// The names of the table's columns.
pub const HEADER: [&str; 5] = ["closed form", "set-up", "error of", "measured", "bound"];

/// The cells of each line.
pub fn cells() -> impl Iterator<Item = [String; 5]> {
    let before = |index: usize| index.checked_sub(1).map(|before| &ALL[before]);
    ALL.iter().enumerate().map(move |(index, line)| line.cells(before(index)))
}

/// Declares the lines of the table, and the list of them.
macro_rules! lines {
    ($($name:ident: $form:expr, $setup:expr, $quantity:expr, $measured:expr, $bound:expr $(, elsewhere $elsewhere:expr)?;)*) => {
        $(
            /// A line of the table, by its name.
            pub const $name: ErrorBound = ErrorBound {
                form: $form,
                setup: $setup,
                quantity: $quantity,
                measured: $measured,
                bound: $bound,
                elsewhere: lines!(@option $($elsewhere)?),
            };
        )*

        /// Every line, in the order of the page.
        pub const ALL: &[ErrorBound] = &[$($name),*];
    };
    (@option) => { None };
    (@option $value:expr) => { Some($value) };
}

const CURVES: &str = "64³ voxels across a cube of edge 2";
const PARABOLA: &str = "rays in a linear η² are parabolas";
const CATENARY: &str = "rays in a linear η are catenaries";
const SINE: &str = "rays in a parabolic η² are sines";
const POSITION: &str = "the position, world units";
const SLOPE: &str = "the slope";

const LUNEBURG: &str = "Luneburg lens η² = 2 − r²: a parallel beam meets at the antipode";
const MISS: &str = "the place where rays inside 0.8 radii meet, radii";
const LAYER: &str = "Snell behind a layer of 14 voxels";
const BALL: &str = "ball lens n = 1.5: rays with 0.1 ≤ h ≤ 0.75 cross the axis by Snell's law at both surfaces";
const CROSSING: &str = "the distance of the crossing, relative";

const SLAB: &str = "thin lens slab η = 1 + ε cos kx: irradiance 1/(1 ∓ Z/Z_f)";
const SLAB_SETUP: &str = "64 voxels and 49 light texels a period, planes every voxel";
const FINE_SLAB_SETUP: &str = "64 voxels and 98 light texels a period, planes every voxel";
const SHEAR: &str = "slab η = 1 + a·x·y shears light: irradiance 1/(1 − (Z/f)²)";
const FLUX: &str = "without absorption the flux is the same through all planes";
const SPOT: &str = "share of a ball lens's light inside a radius, light as sheets";
const PRISM: &str = "60° prism of crown glass (n = 1.5168, V = 64.17) at 486.1 and 656.3 nm";
const PRISM_SETUP: &str = "96³ voxels, faces twelve voxels thick";
const BEER: &str = "Beer–Lambert through a box at 0°, 30°, 45°";
const BEER_SETUP: &str = "32³ voxels, planes every 0.37, 1, 2.5 voxels";
const COMPOSITING: &str = "plain Porter–Duff against a fine integral in double precision";
const LIGHTS: &str = "light of several sources adds up";
const LENS: &str = "the ray step alone, exact gradients: Luneburg lens";
const FISHEYE: &str = "the ray step alone: Maxwell's fisheye η = 2/(1 + r²) images a point";
const FISHEYE_SETUP: &str = "256 planes across";

#[rustfmt::skip]
lines! {
    PARABOLA_POSITION: PARABOLA, CURVES, POSITION, 2.2e-6, 4.4e-6, elsewhere 2e-3;
    PARABOLA_SLOPE: PARABOLA, CURVES, SLOPE, 2.0e-6, 4.0e-6, elsewhere 2e-3;
    CATENARY_POSITION: CATENARY, CURVES, POSITION, 1.0e-5, 2.0e-5, elsewhere 2e-3;
    CATENARY_SLOPE: CATENARY, CURVES, SLOPE, 6.2e-4, 1.2e-3;
    SINE_POSITION: SINE, CURVES, POSITION, 3.9e-5, 7.8e-5;
    SINE_SLOPE: SINE, CURVES, SLOPE, 3.9e-5, 7.8e-5;

    LUNEBURG_CENTRAL: LUNEBURG, "128³ voxels, central ∇η", MISS, 8.9e-4, 1.7e-3;
    LUNEBURG_CHAIN: LUNEBURG, "128³ voxels, ∇η by the chain rule", MISS, 8.2e-4, 1.6e-3;

    LAYER_EXIT: LAYER, "96³ voxels, 1 → 1.5 met at 10°, 30°, 60°; 1 → 1/1.5 at 20°, 35°", "the exit angle, degrees", 0.012, 0.024;
    LAYER_REFLECTION: LAYER, "96³ voxels, 1 → 1/1.5 met at 50°, beyond the critical angle", "the angle of reflection, degrees", 0.53, 1.0;

    BALL_THIN: BALL, "64³ voxels, surface four voxels thick", CROSSING, 0.041, 0.05;
    BALL_THIN_FINE: BALL, "128³ voxels, surface four voxels thick", CROSSING, 0.025, 0.05;
    BALL_THICK: BALL, "64³ voxels, surface eight voxels thick", CROSSING, 0.032, 0.064;
    BALL_THICK_FINE: BALL, "128³ voxels, surface eight voxels thick", CROSSING, 0.019, 0.025;

    SLAB_QUARTER: SLAB, SLAB_SETUP, "the irradiance on axis at ¼ of the focal distance, relative", 0.0074, 0.01;
    SLAB_HALF: SLAB, SLAB_SETUP, "the irradiance on axis at ½, relative", 0.02, 0.03;
    SLAB_THREE_QUARTERS: SLAB, SLAB_SETUP, "the irradiance on axis at ¾, relative", 0.18, 0.2;
    SLAB_BESIDE: SLAB, SLAB_SETUP, "the irradiance half a period beside, relative", 0.011, 0.02;
    SLAB_MEAN: SLAB, SLAB_SETUP, "the mean over a period, relative", 0.0084, 0.016;
    SLAB_COARSE: SLAB, "the same, planes every four voxels", "the irradiance on axis at ¾, relative", 0.14, 0.2;
    SLAB_UNCORRECTED: SLAB, "49 light texels a period, without intensity correction", "an irradiance of 1 everywhere", 0.0, 0.0, elsewhere 1e-3;
    SLAB_FINE_HALF: SLAB, FINE_SLAB_SETUP, "the irradiance on axis at ½, relative", 0.0028, 0.0056;
    SLAB_FINE_THREE_QUARTERS: SLAB, FINE_SLAB_SETUP, "the irradiance on axis at ¾, relative", 0.046, 0.06;

    SHEAR_WEAK: SHEAR, "64 voxels a unit, shear 0.031 from plane to plane", "the flux, relative", 2.6e-4, 5.2e-4;
    SHEAR_MIDDLE: SHEAR, "64 voxels a unit, shear 0.063", "the flux, relative", 1.2e-3, 1.4e-3;
    SHEAR_STRONG: SHEAR, "64 voxels a unit, shear 0.125", "the flux, relative", 7.1e-3, 8.3e-3;

    FLUX_TEXELS: FLUX, "64³ voxels, a weak lens, light at 0° and 30°", "the flux, relative", 5.4e-4, 1.0e-3;
    FLUX_FOCUS: FLUX, "`glass` and `ball`, 300² pixels, all planes, far behind their foci", "the flux where it is more than there was, relative", 0.0, 0.0;
    FLUX_SHEETS: FLUX, "48³ voxels, light as sheets at 0° and 30°, through a focus", "the flux, relative", 1.6e-8, 3.2e-8, elsewhere 1e-5;

    SPOT_FOCUS: SPOT, "192³ voxels, surface five voxels thick; z = 1.5, a = 0.05 to 0.5: its focus", "the share, relative", 0.036, 0.04;
    SPOT_BEHIND: SPOT, "the same; z = 2, a = 0.1 to 0.5", "the share, relative", 0.023, 0.03;
    SPOT_FAR: SPOT, "the same; z = 3, a = 0.25, 0.5", "the share, relative", 0.013, 0.026;

    PRISM_LEAST: PRISM, PRISM_SETUP, "the smallest deviation, degrees", 0.0088, 0.017;
    PRISM_TURNED: PRISM, PRISM_SETUP, "the deviation of light met 5° off, degrees", 0.036, 0.05;

    BEER_OPACITY: BEER, BEER_SETUP, "the opacity", 1.4e-5, 2.8e-5;
    BEER_TRANSMITTANCE: BEER, BEER_SETUP, "the transmittance, relative to 0.1 or more", 5.3e-4, 1.0e-3;

    COMPOSITING_OPACITY: COMPOSITING, "48³ voxels, planes every eighth of a voxel", "the opacity", 5.3e-7, 1e-6, elsewhere 2e-3;
    COMPOSITING_COLOR: COMPOSITING, "48³ voxels, planes every eighth of a voxel", "the colour, relative", 0.010, 0.012;

    LIGHTS_WALL: LIGHTS, "a wall lit from 30° and −40°", "the radiance E = Σ cᵢ cos θᵢ, relative", 1.0e-7, 2e-7, elsewhere 2e-6;
    LIGHTS_HALVES: LIGHTS, "two lights of half the intensity against one", "the radiance", 6.0e-8, 1.2e-7, elsewhere 2e-7;
    LIGHTS_SHADOWS: LIGHTS, "two shadows of an opaque ball, each lit by the other light", "the radiance", 8.2e-8, 1.6e-7, elsewhere 1e-3;
    LIGHTS_AMBIENT: LIGHTS, "ambient light alone", "the radiance", 0.0, 0.0, elsewhere 1e-6;

    STEP: LENS, "512 planes across", "the place where rays at heights 0.1, 0.3, 0.5 meet, radii", 2.3e-7, 4.6e-7;
    FISHEYE_10: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 10°, radii", 2.3e-6, 4.6e-6;
    FISHEYE_30: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 30°, radii", 4.1e-6, 8.2e-6;
    FISHEYE_50: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 50°, radii", 2.2e-5, 4.4e-5;
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::panic::catch_unwind;

    #[test]
    fn no_bound_is_more_than_twice_what_was_measured() {
        for line in ALL {
            assert!(line.measured >= 0.0 && line.measured <= line.bound, "{line}");
            assert!(
                line.bound <= 2.0 * line.measured * (1.0 + 1e-9),
                "{line}: {:.1e} for {:.1e}",
                line.bound,
                line.measured
            );
            assert!(line.elsewhere.is_none_or(|elsewhere| elsewhere > line.bound), "{line}");
        }
    }

    #[test]
    fn lines_have_different_names() {
        let mut names: Vec<String> = ALL.iter().map(ToString::to_string).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn an_error_beyond_its_bound_and_a_table_that_is_out_of_date_fail() {
        let holds = |line: ErrorBound, error: f64, is_exact: bool| {
            catch_unwind(|| line.hold_on(error, "test", is_exact)).is_ok()
        };
        let ErrorBound { measured, bound, .. } = LAYER_EXIT;
        assert!(holds(LAYER_EXIT, measured, true) && holds(LAYER_EXIT, bound, false) && holds(LAYER_EXIT, 0.0, false));
        assert!(!holds(LAYER_EXIT, 1.01 * bound, false) && !holds(LAYER_EXIT, f64::NAN, false));
        assert!(!holds(LAYER_EXIT, 1.1 * measured, true) && !holds(LAYER_EXIT, 0.9 * measured, true));
        assert!(holds(LIGHTS_AMBIENT, 0.0, true) && !holds(LIGHTS_AMBIENT, 1e-9, true));
        assert!(holds(LIGHTS_AMBIENT, 1e-9, false) && !holds(LIGHTS_AMBIENT, 2e-6, false));
    }

    #[test]
    fn an_error_that_is_no_number_is_the_largest() {
        assert_eq!((larger(1.0, 2.0), larger(2.0, 1.0)), (2.0, 2.0));
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
    }

    #[test]
    fn numbers_have_two_digits() {
        assert_eq!(
            [0.0, 1.44e-8, 0.000_62, 0.0114, 0.5, 1.0].map(digits),
            ["0", "1.4e-8", "6.2e-4", "0.011", "0.5", "1.0"]
        );
    }

    #[test]
    fn equal_cells_below_each_other_stay_empty() {
        let cells: Vec<[String; 5]> = cells().collect();
        assert_eq!(cells.len(), ALL.len());
        assert_eq!(cells.iter().filter(|cells| cells[0] == LUNEBURG).count(), 1);
        assert!(cells.iter().any(|cells| cells[0].is_empty() && !cells[1].is_empty()));
    }
}
