//! The lines of the table of errors against closed forms, by the part of the program that they are errors of.

use super::table::ErrorBound;

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

const BLOCK: &str = "rays through a block that fills its box, by Snell's law at the faces";
const BLOCK_SETUP: &str = "40 × 32 × 24 voxels, n = 0.8 to 2.4, parallel and perspective rays";
const EMBEDDED_SETUP: &str = "n = 1.5 in surroundings of 1.33";
const EYE_SETUP: &str = "n = 1.33, the eye inside";
const CUT_SETUP: &str = "n = 1.5, one cut and three cuts";
const FILLED_SLAB: &str = "irradiance behind a slab η = 1 + 0.3 cos kx that fills its box: 1/(cos ωσ − Z ω sin ωσ)";
const FILLED_SLAB_SETUP: &str = "64 voxels a period, up to 0.4 of the focal distance";

const DENSE_BALL: &str = "ball lens n = 2.4: deviations below 80°, by Snell's law at both surfaces";
const DENSE_BALL_SETUP: &str = "128³ voxels, surface four voxels thick, planes every voxel";
const EATON: &str = "Eaton's lens η² = 2/r − 1 sends rays back to where they come from, mirrored at the axis";
const EATON_SETUP: &str = "192³ voxels, rays at 0.6 to 0.9 radii, followed beyond the sweep";

const SLAB: &str = "thin lens slab η = 1 + ε cos kx: irradiance 1/(1 ∓ Z/Z_f)";
const SLAB_SETUP: &str = "64 voxels and 49 light texels a period, planes every voxel";
const FINE_SLAB_SETUP: &str = "64 voxels and 98 light texels a period, planes every voxel";
const SHEAR: &str = "slab η = 1 + a·x·y shears light: irradiance 1/(1 − (Z/f)²)";
const FLUX: &str = "without absorption the flux is the same through all planes";
const SPOT: &str = "share of a ball lens's light inside a radius, light carried forward";
const PRISM: &str = "60° prism of crown glass (n = 1.5168, V = 64.17) at 486.1 and 656.3 nm";
const PRISM_SETUP: &str = "96³ voxels, faces twelve voxels thick";
const BEER: &str = "Beer–Lambert through a box at 0°, 30°, 45°";
const BEER_SETUP: &str = "32³ voxels, planes every 0.37, 1, 2.5 voxels";
const COMPOSITING: &str = "plain Porter–Duff against a fine integral in double precision";
const LIGHTS: &str = "light of several sources adds up";
const OUTLIER: &str = "one voxel of a million times the range, beside what is seen, changes nothing";
const PEAK: &str = "the opacity of a peak that is 10⁻⁴ of the range wide: 1 − exp(−∫τ)";
const PEAK_SETUP: &str = "64 voxels from end to end of the range, planes every voxel";
const MATTER: &str =
    "an opaque ball lit from 60° shades itself: ∫ τ e^(−∫τ) e^(−∫τ along the light) dt in double precision";
const CUT: &str = "the cut through an opaque block, lit at 60°: cos θ / (cos θ + cos θᵥ) (Seeliger)";
const LAMBERT: &str = "an opaque ball without shadows is shaded by its gradient: n · l";
const ISOSURFACE: &str = "isosurfaces of opacity 0.3 and 0.5, each crossed twice: 1 − (0.7 · 0.5)²";
const ISOSURFACE_SLOPES: &str = "48³ voxels, the ball's scalar rises over 4 and over 12 voxels";
const SEEN_ISOSURFACE: &str = "an opaque isosurface is seen where the scalar between voxels has its value";
const LIT_ISOSURFACES: &str =
    "isosurfaces of opacity 0.4 and 1, lit at 0°, 60° and 180°: Σ τ c e^(−t) e^(−t cos θᵥ / cos θ) over their layers";
const ISOSURFACE_SHADOWS: &str = "light behind an isosurface of opacity 0.3 that it crosses twice: 0.7²";
const ISOSURFACE_SEELIGER: &str = "an opaque isosurface, lit at 60°: cos θ / (cos θ + cos θᵥ) (Seeliger)";
const COLORS: &str = "a homogeneous cube whose voxels have a factor of extinction: 1 − (1 − α)^(factor · ℓ)";
const BODY: &str = "an opaque ball of triangles within a volume";
const BODY_SETUP: &str = "48³ voxels, the ball 34 voxels across, inside 0.9 radii";
const SURFACE: &str = "a layer from 1 to 1.5 mirrors light from all sides by Fresnel, at 0° and 60°";
const LENS: &str = "the ray step alone, exact gradients: Luneburg lens";
const FISHEYE: &str = "the ray step alone: Maxwell's fisheye η = 2/(1 + r²) images a point";
const FISHEYE_SETUP: &str = "256 planes across";

const PLATE: &str =
    "rays through a plate: to the side by t sin θ (1 − cos θ / √(n² − sin² θ)), t = 0.4, n = 1.5, θ = 20°, 40°, 60°";
const PLATE_SIDE: &str = "the distance to the side, world units";
const PLATE_TURN: &str = "the direction, radians";
const BOX: &str = "rays through a box: Beer–Lambert over 0.4";
const TRANSMITTANCE: &str = "the transmittance, relative";
const LENGTH: &str = "the length of the way, world units";
const BAR: &str = "rays in a square bar are reflected totally and leave at 90°";
const LENS_OF_TRIANGLES: &str =
    "rays through a ball of triangles, n = 1.5, cross the axis by Snell's law at both surfaces";
const CONTACT: &str = "rays through two slabs with a common face, n = 1.5 and 1.33, by Snell's law at three surfaces";
const CONTACT_SETUP: &str = "triangles themselves, gaps of −10⁻⁶ to 10⁻⁶ of the size, 0° to 60°";
const FLUSH: &str = "rays through a box flush with the face of another, n = 1.2 and 1.5";
const FLUSH_SETUP: &str = "triangles themselves, gaps of −10⁻⁶ to 10⁻⁶ of the size, 30°";
const SHELL: &str = "rays through a shell and its filling, n = 1.5 and 1.2, by Snell's law at four surfaces";
const SHELL_SETUP: &str = "triangles themselves, gaps of −10⁻⁶ to 10⁻⁶ of the size, 40°";
const THIN: &str = "rays through a gap and through a plate of 10⁻⁵ of the size";
const THIN_SETUP: &str = "triangles themselves, 0° to 45°";
const MIRROR: &str = "a ball and a wall mirrored in a plate, by Fresnel";
const FURNACE: &str = "clear bodies in light of radiance 1 from all sides have radiance 1, n = 1.33, 1.5, 1.8, 2.4";
const INTERREFLECTION: &str =
    "a plate that absorbs, straight on, in light from all sides: F + (1 − F)² t / (1 − F t), n = 1.33, 1.5, 1.8, 2.4";
const RADIANCE: &str = "the radiance of each pixel";
const EXACT: &str = "triangles themselves";

const AIRLIGHT: &str = "airlight of a lamp in fog, g = 0, ±0.7: σ_s I / h ∫ p(−sin q) exp(−σ_t (t + h / cos q)) dq";
const VOLUME_SHADOW: &str = "volumetric shadows: the same over the part of the ray that a body hides";
const SHARES: &str = "flux: escaped, received, absorbed, extinguished and lost light of a texel add up to 1, by Fresnel, and Beer and Lambert";
const PLATE_IN_FOG: &str = "flux: light that a plate and a mirror send through fog, summed over the picture";
const BALL_IN_FOG: &str = "single scattering behind a clear ball in fog, n = 1.5, along single rays, to nine digits";
const PICTURE_IN_FOG: &str = "single scattering behind a clear ball in fog, n = 1.5, as a picture of 32² blocks";
const RING: &str = "the nephroid of a mirroring ring on the floor: ρ E₀ sin e · R cos a / |R cos a − 2 s| for each ray";
const RING_IN_FOG: &str = "single scattering of a mirroring ring's light in fog, along single rays";
const RADIANCE_RMS: &str = "the radiance, relative, root mean square";
const OF_BRIGHTEST: &str = "the radiance over the brightest, root mean square";

#[rustfmt::skip]
lines! {
    PARABOLA_POSITION: PARABOLA, CURVES, POSITION, 3.2e-6, 6.4e-6, elsewhere 2e-3;
    PARABOLA_SLOPE: PARABOLA, CURVES, SLOPE, 2.16e-6, 4.3e-6, elsewhere 2e-3;
    CATENARY_POSITION: CATENARY, CURVES, POSITION, 5.6e-6, 1.1e-5, elsewhere 2e-3;
    CATENARY_SLOPE: CATENARY, CURVES, SLOPE, 7.0e-6, 1.4e-5;
    SINE_POSITION: SINE, CURVES, POSITION, 3.9e-5, 7.8e-5;
    SINE_SLOPE: SINE, CURVES, SLOPE, 2.9e-5, 5.8e-5;

    BLOCK_TURN: BLOCK, BLOCK_SETUP, PLATE_TURN, 1.5e-5, 3.0e-5;
    BLOCK_SIDE: BLOCK, BLOCK_SETUP, PLATE_SIDE, 8.1e-6, 1.6e-5;
    EMBEDDED_TURN: BLOCK, EMBEDDED_SETUP, PLATE_TURN, 1.6e-7, 3.2e-7;
    EMBEDDED_SIDE: BLOCK, EMBEDDED_SETUP, PLATE_SIDE, 1.06e-6, 2.1e-6;
    EYE_TURN: BLOCK, EYE_SETUP, PLATE_TURN, 4.8e-7, 9.6e-7;
    EYE_SIDE: BLOCK, EYE_SETUP, PLATE_SIDE, 3.1e-7, 6.2e-7;
    CUT_TURN: BLOCK, CUT_SETUP, PLATE_TURN, 1.05e-7, 2.1e-7;
    CUT_SIDE: BLOCK, CUT_SETUP, PLATE_SIDE, 1.24e-6, 2.4e-6;
    FILLED_SLAB_TEXELS: FILLED_SLAB, FILLED_SLAB_SETUP, "the irradiance on the axis, light on texels, relative", 0.026, 0.05;
    FILLED_SLAB_FORWARD: FILLED_SLAB, FILLED_SLAB_SETUP, "the irradiance on the axis, light carried forward, relative", 0.0088, 0.013;

    LUNEBURG_CENTRAL: LUNEBURG, "128³ voxels, central ∇η", MISS, 8.9e-4, 1.7e-3;
    LUNEBURG_CHAIN: LUNEBURG, "128³ voxels, ∇η by the chain rule", MISS, 8.2e-4, 1.6e-3;

    LAYER_EXIT: LAYER, "96³ voxels, 1 → 1.5 met at 10°, 30°, 60°; 1 → 1/1.5 at 20°, 35°", "the exit angle, degrees", 0.015, 0.03;
    LAYER_REFLECTION: LAYER, "96³ voxels, 1 → 1/1.5 met at 50°, beyond the critical angle", "the angle of reflection, degrees", 0.53, 1.0;

    LAYER_FOLLOWED: LAYER, "96³ voxels, 1 → 1/1.5 met at 43°: the ray deviates by 94°", "the angle of reflection, degrees", 0.0079, 0.0158;

    DENSE_BALL_WRONG: DENSE_BALL, DENSE_BALL_SETUP, "the share of rays that turn back or are off by more than 10°", 0.0, 0.0;
    DENSE_BALL_MEDIAN: DENSE_BALL, DENSE_BALL_SETUP, "the deviation of half the rays, degrees", 1.6, 3.2;
    EATON_TURN: EATON, EATON_SETUP, "the direction, degrees", 0.549, 1.0;
    EATON_SIDE: EATON, EATON_SETUP, "the place, radii", 0.0088, 0.0175;

    BALL_THIN: BALL, "64³ voxels, surface four voxels thick", CROSSING, 0.041, 0.05;
    BALL_THIN_FINE: BALL, "128³ voxels, surface four voxels thick", CROSSING, 0.025, 0.05;
    BALL_THICK: BALL, "64³ voxels, surface eight voxels thick", CROSSING, 0.032, 0.064;
    BALL_THICK_FINE: BALL, "128³ voxels, surface eight voxels thick", CROSSING, 0.019, 0.025;

    SLAB_QUARTER: SLAB, SLAB_SETUP, "the irradiance on axis at ¼ of the focal distance, relative", 0.0081, 0.01;
    SLAB_HALF: SLAB, SLAB_SETUP, "the irradiance on axis at ½, relative", 0.017, 0.03;
    SLAB_THREE_QUARTERS: SLAB, SLAB_SETUP, "the irradiance on axis at ¾, relative", 0.17, 0.2;
    SLAB_BESIDE: SLAB, SLAB_SETUP, "the irradiance half a period beside, relative", 0.012, 0.02;
    SLAB_MEAN: SLAB, SLAB_SETUP, "the mean over a period, relative", 6.2e-5, 1.2e-4;
    SLAB_COARSE: SLAB, "the same, planes every four voxels", "the irradiance on axis at ¾, relative", 0.13, 0.2;
    SLAB_UNCORRECTED: SLAB, "49 light texels a period, without intensity correction", "an irradiance of 1 everywhere", 0.0, 0.0, elsewhere 1e-3;
    SLAB_FINE_HALF: SLAB, FINE_SLAB_SETUP, "the irradiance on axis at ½, relative", 0.0040, 0.0078;
    SLAB_FINE_THREE_QUARTERS: SLAB, FINE_SLAB_SETUP, "the irradiance on axis at ¾, relative", 0.047, 0.06;

    SHEAR_WEAK: SHEAR, "64 voxels a unit, shear 0.031 from plane to plane", "the flux, relative", 2.1e-4, 4.2e-4;
    SHEAR_MIDDLE: SHEAR, "64 voxels a unit, shear 0.063", "the flux, relative", 8.8e-4, 1.4e-3;
    SHEAR_STRONG: SHEAR, "64 voxels a unit, shear 0.125", "the flux, relative", 4.5e-3, 8.3e-3;

    FLUX_TEXELS: FLUX, "64³ voxels, a weak lens, light at 0° and 30°", "the flux, relative", 9.7e-9, 1.9e-8, elsewhere 1e-5;
    FLUX_FOCUS: FLUX, "`glass`, `ball` and a ball of index 2.4, 110² and 160² pixels, all planes, sources of up to 2°, planes every ½, 1, 2 voxels", "the flux where it is more than there was by a millionth, relative", 0.0, 0.0;
    FLUX_FORWARD: FLUX, "48³ voxels, light carried forward at 0° and 30°, through a focus", "the flux, relative", 1.8e-6, 3.6e-6, elsewhere 1e-5;

    SPOT_FOCUS: SPOT, "192³ voxels, against rays through the surface, five voxels thick; z = 1.5, a = 0.05 to 0.5: its focus", "the share, relative", 0.014, 0.015;
    SPOT_BEHIND: SPOT, "the same; z = 2, a = 0.1 to 0.5", "the share, relative", 0.013, 0.015;
    SPOT_FAR: SPOT, "the same; z = 3, a = 0.25, 0.5", "the share, relative", 0.0035, 0.0052;

    PRISM_LEAST: PRISM, PRISM_SETUP, "the smallest deviation, degrees", 0.0088, 0.017;
    PRISM_TURNED: PRISM, PRISM_SETUP, "the deviation of light met 5° off, degrees", 0.036, 0.05;

    BEER_OPACITY: BEER, BEER_SETUP, "the opacity", 1.4e-5, 2.8e-5;
    BEER_TRANSMITTANCE: BEER, BEER_SETUP, "the transmittance, relative to 0.1 or more", 5.3e-4, 1.0e-3;
    BEER_AROUND_THE_EYE: "Beer–Lambert from an eye within a box", "32³ voxels, planes every 0.37, 1, 2.5 voxels", "the opacity", 1.02e-5, 2.0e-5;

    COMPOSITING_OPACITY: COMPOSITING, "48³ voxels, planes every eighth of a voxel", "the opacity", 5.3e-7, 1e-6, elsewhere 2e-3;
    COMPOSITING_COLOR: COMPOSITING, "48³ voxels, planes every eighth of a voxel", "the colour, relative", 4.955e-4, 9.0e-4;

    MATTER_SOFT_MEAN: MATTER, "48³ voxels, planes every voxel, a surface four voxels thick", "the mean radiance, relative", 0.01478, 0.029;
    MATTER_SOFT: MATTER, "48³ voxels, planes every voxel, a surface four voxels thick", RADIANCE_RMS, 0.02648, 0.04;
    MATTER_STEEP_MEAN: MATTER, "the same, opacity rises over four tenths of a voxel", "the mean radiance, relative", 0.008473, 0.0085;
    MATTER_STEEP: MATTER, "the same, opacity rises over four tenths of a voxel", RADIANCE_RMS, 0.01262, 0.015;
    MATTER_CUT: CUT, "48³ voxels, planes every voxel and every half, ten places of the cut", "the radiance, relative", 0.01489, 0.029;
    ISOSURFACE_OPACITY: ISOSURFACE, "the same slopes, planes every 1, ½, ¼ voxels", "the opacity", 9.5e-9, 1.9e-8, elsewhere 1e-6;
    ISOSURFACE_DEPTH: SEEN_ISOSURFACE, ISOSURFACE_SLOPES, "the depth, voxels", 1.9e-5, 3.7e-5, elsewhere 1e-3;
    ISOSURFACE_LIGHT: LIT_ISOSURFACES, "planes every 1, ½, ¼ voxels, seven voxels apart", "the radiance, relative", 1.161e-7, 2.3e-7, elsewhere 1e-4;
    ISOSURFACE_LIGHT_NEAR: LIT_ISOSURFACES, "the same, half a voxel apart", "the radiance, relative", 8.844e-3, 0.017;
    ISOSURFACE_SHADOW: ISOSURFACE_SHADOWS, "48³ voxels, planes every voxel and every half", "the irradiance", 2.027e-8, 4.0e-8, elsewhere 1e-5;
    ISOSURFACE_SHADING_MEAN: ISOSURFACE_SEELIGER, ISOSURFACE_SLOPES, "the mean radiance, relative", 2.892e-4, 5.7e-4;
    ISOSURFACE_SHADING: ISOSURFACE_SEELIGER, ISOSURFACE_SLOPES, RADIANCE_RMS, 6.083e-4, 1.2e-3;
    ISOSURFACE_GRADIENT: LAMBERT, "48³ voxels, an isosurface, inside 0.9 radii", "the radiance", 0.024, 0.048;
    MATTER_GRADIENT: LAMBERT, "48³ voxels, a surface four voxels thick, inside 0.9 radii", "the radiance", 0.038, 0.06;
    SURFACE_MIRROR: SURFACE, "48³ voxels, 1 to 8 voxels thick, linear and smooth, planes every ¼, ½, 1 voxel", "the radiance, relative", 0.0372, 0.05;
    SURFACE_HIGHLIGHT: "the highlight of a glass ball, surface four voxels thick, against planes every ¼ voxel", "48³ voxels, planes every ½, 1 voxel", "the radiance of the brightest pixel, relative", 0.022, 0.03;
    SURFACE_FURNACE: "a clear ball swept in light of radiance 1 from all sides has radiance 1, n = 1.3", "48³ voxels, surface four voxels thick", RADIANCE, 0.0016, 0.003;

    COLORS_OPACITY: COLORS, "32³ voxels of one colour, planes every 0.37, 1, 2.5 voxels, at 0°, 30°, 45°", "the opacity", 1.498e-5, 2.9e-5;
    GRADIENT_OPACITY: COLORS, "32³ voxels whose scalar rises evenly; a gradient opacity of 128/255", "the opacity", 1.498e-5, 2.9e-5;
    COLORS_LIGHT: COLORS, "the light behind it, planes every ½ and 1 voxel", "the irradiance, relative", 2.322e-4, 4.6e-4;
    COLORS_COLOR: "the colour of a voxel, of bytes in sRGB", "188, 100, 30", "the linear colour", 1.571e-3, 3.1e-3;

    BODY_DEPTH: BODY, BODY_SETUP, "the depth, voxels of the scan", 0.01327, 0.026;
    BODY_LIGHT: "an opaque ball of triangles within a volume, lit from 0° and 60°: n · l", BODY_SETUP, "the radiance", 6.881e-3, 0.013;
    BODY_IN_MATTER: "an opaque ball of triangles within a homogeneous cube: n · l e^(−2τ)", "32³ voxels, planes every ½ and 1 voxel, inside 0.8 radii", "the radiance, relative", 0.01799, 0.035;
    BODY_SHADOW: "the shadow of an opaque ball within a volume", "48³ voxels, on a wall, lit from 50°", "the area, relative", 0.01392, 0.027;
    BODY_LENS: "a clear ball of triangles within a volume, n = 1.5: Snell's law", "64³ voxels", CROSSING, 0.03255, 0.05;

    OUTLIER_FILM: OUTLIER, "48³ voxels of 8 bits, 16 bits and floats; texels, forward, pages, two volumes", "the film", 0.0, 0.0, elsewhere 1e-3;
    OUTLIER_TURN: OUTLIER, "32³ voxels, η = 1 + 0.05 x (1 − y²)", "the direction, degrees", 0.0, 0.0, elsewhere 1e-3;
    PEAK_ALONE: PEAK, PEAK_SETUP, "the opacity", 6.7e-6, 1.3e-5, elsewhere 1e-4;
    PEAK_BESIDE: PEAK, "the same, with a ramp at the end of the range", "the opacity", 2.2e-3, 4.4e-3;

    LIGHTS_WALL: LIGHTS, "a wall lit from 30° and −40°", "the radiance E = Σ cᵢ cos θᵢ, relative", 1.8e-8, 3.6e-8, elsewhere 2e-6;
    LIGHTS_HALVES: LIGHTS, "two lights of half the intensity against one", "the radiance", 3.0e-8, 6.0e-8, elsewhere 2e-7;
    LIGHTS_SHADOWS: LIGHTS, "two shadows of an opaque ball, each lit by the other light", "the radiance", 2.3e-8, 4.6e-8, elsewhere 1e-3;
    LIGHTS_AMBIENT: LIGHTS, "ambient light alone", "the radiance", 0.0, 0.0, elsewhere 1e-6;

    AMBIENT_FURNACE: "white matter, ground and wall vanish in ambient light of radiance 1", "32³ voxels", RADIANCE, 9.537e-6, 1.9e-5;
    AMBIENT_GRADIENT: "ground in the light of a gradient: h + 4/5 (c − h)", "harmonics to the second order", "the radiance, relative", 0.03148, 0.05;

    STEP: LENS, "512 planes across", "the place where rays at heights 0.1, 0.3, 0.5 meet, radii", 2.3e-7, 4.6e-7;
    FISHEYE_10: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 10°, radii", 2.3e-6, 4.6e-6;
    FISHEYE_30: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 30°, radii", 4.1e-6, 8.2e-6;
    FISHEYE_50: FISHEYE, FISHEYE_SETUP, "the image of rays that start at 50°, radii", 2.2e-5, 4.4e-5;

    PLATE_SIDE_EXACT: PLATE, EXACT, PLATE_SIDE, 1.7e-7, 3.4e-7, elsewhere 2e-5;
    PLATE_TURN_EXACT: PLATE, EXACT, PLATE_TURN, 3.0e-7, 6.0e-7, elsewhere 2e-5;
    PLATE_SIDE_VOXELS: PLATE, "192 voxels", PLATE_SIDE, 7.1e-5, 1.4e-4;
    PLATE_TURN_VOXELS: PLATE, "192 voxels", PLATE_TURN, 5.8e-5, 1.15e-4;
    TILTED_FACE: "the normal of a tilted face", "128 voxels, four faces", "the normal, degrees", 0.0034, 0.0068;
    PRISM_OF_VOXELS: "rays through a 60° prism, by Snell's law at both faces", "128 voxels, n = 1.5", "the direction, degrees", 0.0071, 0.0142;
    OCTAHEDRON: "rays through an octahedron, against those through its triangles", "256 voxels, n = 1.5", "the share of rays that are off by more than 0.5°", 0.034, 0.05;
    BOX_EXACT: BOX, EXACT, TRANSMITTANCE, 3.0e-8, 6.0e-8, elsewhere 0.01;
    BOX_LENGTH_EXACT: BOX, EXACT, LENGTH, 5.4e-8, 1.0e-7, elsewhere 4e-3;
    BOX_VOXELS: BOX, "128 voxels, two or many surfaces", TRANSMITTANCE, 4.2e-7, 8.4e-7, elsewhere 0.01;
    BOX_LENGTH_VOXELS: BOX, "128 voxels, two or many surfaces", LENGTH, 4.4e-7, 8.8e-7, elsewhere 4e-3;
    NESTED_EXACT: "rays through a box within a box: Beer–Lambert, each by its material", EXACT, TRANSMITTANCE, 2.1e-7, 4.2e-7, elsewhere 0.01;
    NESTED_VOXELS: "rays through a box within a box: Beer–Lambert, each by its material", "128 voxels", TRANSMITTANCE, 1.8e-6, 3.6e-6, elsewhere 0.01;
    FRESNEL: "rays through two faces at right angles: (1 − F)² is left", "64 voxels", "the transmittance", 4.4e-8, 8.8e-8, elsewhere 1e-4;
    BAR_EXACT: BAR, EXACT, PLATE_TURN, 4.8e-7, 9.6e-7, elsewhere 1e-4;
    BAR_VOXELS: BAR, "128 voxels", PLATE_TURN, 4.8e-7, 9.6e-7, elsewhere 0.02;
    CONTACT_SIDE: CONTACT, CONTACT_SETUP, PLATE_SIDE, 3.3e-7, 6.6e-7, elsewhere 2e-5;
    CONTACT_TURN: CONTACT, CONTACT_SETUP, PLATE_TURN, 3.6e-7, 7.2e-7, elsewhere 2e-5;
    CONTACT_LENGTH: CONTACT, CONTACT_SETUP, LENGTH, 4.3e-7, 8.6e-7, elsewhere 2e-5;
    CONTACT_FRESNEL: "rays through three faces at right angles, one of them common to two slabs", EXACT, "the transmittance", 2.3e-8, 4.6e-8, elsewhere 1e-5;
    FLUSH_SIDE: FLUSH, FLUSH_SETUP, PLATE_SIDE, 3.3e-7, 6.6e-7, elsewhere 2e-5;
    FLUSH_TRANSMITTANCE: FLUSH, FLUSH_SETUP, TRANSMITTANCE, 5.5e-6, 1.1e-5, elsewhere 0.01;
    SHELL_SIDE: SHELL, SHELL_SETUP, PLATE_SIDE, 7.4e-7, 1.4e-6, elsewhere 2e-5;
    SHELL_TRANSMITTANCE: SHELL, SHELL_SETUP, TRANSMITTANCE, 8.3e-6, 1.6e-5, elsewhere 0.01;
    THIN_SIDE: THIN, THIN_SETUP, PLATE_SIDE, 1.7e-7, 3.4e-7, elsewhere 2e-5;
    THIN_LENGTH: THIN, THIN_SETUP, LENGTH, 2.4e-7, 4.8e-7, elsewhere 2e-5;
    LENS_EXACT: LENS_OF_TRIANGLES, "triangles themselves, means over heights ± 0.02", CROSSING, 1.9e-3, 3.8e-3;
    LENS_VOXELS: LENS_OF_TRIANGLES, "256 voxels, means over heights ± 0.02", CROSSING, 0.0018, 0.0036;
    LENS_DIRECTIONS: LENS_OF_TRIANGLES, "triangles themselves, rays inside 0.95 radii", "the direction of 99 % of rays, degrees", 5.6e-3, 0.011;
    MIRROR_EXACT: MIRROR, EXACT, "the radiance", 4.0e-8, 8.0e-8, elsewhere 1e-5;
    MIRROR_VOXELS: MIRROR, "128 voxels, two or many surfaces", "the radiance", 4.0e-8, 8.0e-8, elsewhere 2e-3;
    MIRROR_LIGHT: MIRROR, "triangles themselves, light from one side", "the radiance, relative", 8.3e-4, 1.6e-3;
    MIRROR_SHADOW: MIRROR, "triangles themselves, light from one side", "the radiance beside and in a shadow", 4.0e-8, 8.0e-8, elsewhere 1e-4;
    FURNACE_EXACT: FURNACE, "triangles themselves: a ball, a cube, a shell", RADIANCE, 1.8e-7, 3.6e-7;
    FURNACE_VOXELS: FURNACE, "64 voxels: the same; two or many surfaces, or the paper's normals", RADIANCE, 1.8e-7, 3.6e-7;
    FURNACE_WITHIN: FURNACE, "64 voxels: a ball around the eye", RADIANCE, 6.0e-8, 1.2e-7;
    INTERREFLECTION_EXACT: INTERREFLECTION, EXACT, "the radiance, relative", 1.7e-7, 3.4e-7;
    INTERREFLECTION_VOXELS: INTERREFLECTION, "64 voxels", "the radiance, relative", 1.13e-5, 2.2e-5;
    SWEEP_BALL: "a ball swept as a volume bends rays by Snell's law", "96 voxels, rays inside 0.75 radii", "the direction of half the rays, degrees", 0.101, 0.2;
    SWEEP_BALL_MOST: "a ball swept as a volume bends rays by Snell's law", "96 voxels, rays inside 0.75 radii", "the direction of 98 % of rays, degrees", 0.788, 1.5;
    SWEEP_PLATES: "two plates swept as volumes: Beer–Lambert", "64 voxels", "the transmittance", 0.0044, 0.0083;

    BEAMS_AIRLIGHT: AIRLIGHT, "three rays of length 20, as near to the lamp as 1", "the radiance, relative", 3.1e-5, 6.1e-5, elsewhere 1e-4;
    BEAMS_SHADOW_OF_DISKS: VOLUME_SHADOW, "level and tilted disks, 256² rays of light", "what the shadow takes away, relative", 0.013, 0.015;
    BEAMS_SHADOW_OF_A_BALL: VOLUME_SHADOW, "a ball, 256² rays of light", "what the shadow takes away, relative", 0.0057, 0.011;
    BEAMS_SHARES: SHARES, "balls and a cube, clear, absorbing and mirroring, 48² rays of light", "the sum", 2.1e-7, 4.2e-7, elsewhere 1e-5;
    BEAMS_MAPS_SHARES: SHARES, "the same by depth maps, and balls behind one another, in a box, and with hollows", "the sum", 1.9e-7, 3.7e-7, elsewhere 1e-5;
    BEAMS_PLATE: PLATE_IN_FOG, "a plate of index 1.5, 64² rays of light, 384² pixels", "the flux, relative", 2.6e-4, 5.1e-4;
    BEAMS_MIRROR: PLATE_IN_FOG, "a tilted mirror, 64² rays of light, 384² pixels", "the flux, relative", 9.9e-5, 1.9e-4;
    BEAMS_BALL: BALL_IN_FOG, "g = 0, a lamp, 256² rays of light", RADIANCE_RMS, 0.0017, 0.0034;
    BEAMS_BALL_FORWARD: BALL_IN_FOG, "g = 0.7, a lamp, 256² rays of light", RADIANCE_RMS, 0.0044, 0.0088;
    BEAMS_MAPS: BALL_IN_FOG, "g = 0, a lamp, 256² rays of light by depth maps, light that is refracted twice", RADIANCE_RMS, 0.0019, 0.0038;
    BEAMS_MAPS_FORWARD: BALL_IN_FOG, "g = 0.7, light straight down, the same", RADIANCE_RMS, 0.0053, 0.01;
    BEAMS_PICTURE_32: PICTURE_IN_FOG, "32² rays of light", OF_BRIGHTEST, 8.5e-4, 1.7e-3;
    BEAMS_PICTURE_64: PICTURE_IN_FOG, "64² rays of light", OF_BRIGHTEST, 3.9e-4, 7.8e-4;
    BEAMS_NEPHROID: RING, "512² rays of light, viewing rays 10⁻⁴ wide", "the irradiance, relative", 0.027, 0.03;
    BEAMS_RING: RING_IN_FOG, "parallel light, g = 0, 512² rays of light", RADIANCE_RMS, 0.0051, 0.01;
    BEAMS_SHIFT: "a lattice of light that is moved by a quarter of a texel shows the same picture of a ball's caustic", "64² rays of light, 128² pixels", OF_BRIGHTEST, 1.7e-4, 3.3e-4;
}
