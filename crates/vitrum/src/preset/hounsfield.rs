//! Presets over fixed values: CT in Hounsfield units, with the control points of 3D Slicer's presets of the same names, and MR angiography.
//!
//! Slicer states opacities for a layer of a millimetre, and interpolates colours as they are displayed.

use super::Preset;
use super::subject::{Subject, color, opacity};
use crate::scene::{Environment, EnvironmentKind, Light, Scene, Shading, TransferFunction};
use vitrum_io::srgb_to_linear;
use vitrum_io::transfer::{ColorSpace, color_at};
use vitrum_io::{Orientation, Volume};

/// A look over Hounsfield units.
pub(super) struct Table {
    /// The window in which it is usually looked at: width and level.
    pub window: [f32; 2],
    /// Scalars and sRGB code values.
    color: &'static [(f32, [f64; 3])],
    opacity: &'static [(f32, f32)],
}

/// The world length that opacities are stated for: 1 mm, where the world's unit is known to be one.
const LAYER: f32 = 1.0;

/// The longest edge that a CT is taken to have where its unit is not known, in mm: that of a head with some air around it, or of half a chest.
const USUAL_EDGE: f32 = 300.0;

/// The longest edges that are taken for millimetres where no unit is known.
const LIKELY_EDGES: std::ops::RangeInclusive<f32> = 150.0..=700.0;

/// The world length that opacities are stated for, and what was taken for granted of it.
pub(super) fn layer(volume: &Volume) -> (f32, Option<String>) {
    let is_stated = volume.source.assumptions.stated().iter().any(|fact| fact.name == "unit");
    let longest = volume.extent().into_iter().fold(0.0, f32::max);
    if is_stated || volume.orientation == Orientation::Patient || LIKELY_EDGES.contains(&longest) {
        return (LAYER, None);
    }
    let note = format!(
        "no unit of length is known, and opacities hold for a millimetre: the longest edge, {longest}, was taken for {USUAL_EDGE} mm; \
         `transfer.reference_length` says how long a millimetre is"
    );
    (LAYER * longest / USUAL_EDGE, Some(note))
}

const BONE: Table = Table {
    window: [2000.0, 500.0],
    color: &[
        (-16.4458, [0.729412, 0.254902, 0.301961]),
        (641.385, [0.905882, 0.815686, 0.552941]),
        (3071.0, [1.0, 1.0, 1.0]),
    ],
    opacity: &[(-16.4458, 0.0), (641.385, 0.715686), (3071.0, 0.705882)],
};

/// Slicer's `CT-Coronary-Arteries-3`.
const ANGIO: Table = Table {
    window: [600.0, 300.0],
    color: &[
        (129.982, [0.615686, 0.0, 0.0156863]),
        (173.636, [0.909804, 0.454902, 0.0]),
        (255.884, [0.886275, 0.886275, 0.886275]),
        (584.878, [0.968627, 0.968627, 0.968627]),
        (3661.0, [1.0, 1.0, 1.0]),
    ],
    opacity: &[
        (128.643, 0.0),
        (129.982, 0.0982143),
        (173.636, 0.669643),
        (255.884, 0.857143),
        (584.878, 0.866071),
        (3661.0, 1.0),
    ],
};

/// Slicer's `CT-Muscle`: its `CT-Soft-Tissue` is opaque within 7 units, so that slices show as rings.
const SOFT: Table = Table {
    window: [400.0, 40.0],
    color: &[
        (-155.407, [0.54902, 0.25098, 0.14902]),
        (217.641, [0.882353, 0.603922, 0.290196]),
        (419.736, [1.0, 0.937033, 0.954531]),
        (3071.0, [0.827451, 0.658824, 1.0]),
    ],
    opacity: &[(-155.407, 0.0), (217.641, 0.676471), (419.736, 0.833333), (3071.0, 0.803922)],
};

const LUNG: Table = Table {
    window: [1500.0, -600.0],
    color: &[
        (-1000.0, [0.3, 0.3, 1.0]),
        (-600.0, [0.0, 0.0, 1.0]),
        (-530.0, [0.134704, 0.781726, 0.0724558]),
        (-460.0, [0.929244, 1.0, 0.109473]),
        (-400.0, [0.888889, 0.254949, 0.0240258]),
        (2952.0, [1.0, 0.3, 0.3]),
    ],
    opacity: &[(-600.0, 0.0), (-599.0, 0.15), (-400.0, 0.15), (-399.0, 0.0)],
};

/// Slicer's `MR-Angio`, whose scalars are those of one scanner: they are fitted to the volume.
const MR_ANGIO: Table = Table {
    window: [49.519, 176.1135],
    color: &[
        (151.354, [0.74902, 0.376471, 0.0]),
        (158.279, [0.74902, 0.376471, 0.0]),
        (190.112, [1.0, 0.866667, 0.733333]),
        (200.873, [0.937255, 0.937255, 0.937255]),
    ],
    opacity: &[(151.354, 0.0), (158.279, 0.4375), (190.112, 0.580357), (200.873, 0.732143)],
};

pub(super) const PRESETS: [Preset; 5] = [
    Preset::of_units("ct-bone", "CT in Hounsfield units: bone, in the colours of 3D Slicer's preset", ct_bone, &BONE),
    Preset::of_units("ct-angio", "CT in Hounsfield units: vessels with contrast agent, and bone", ct_angio, &ANGIO),
    Preset::of_units("ct-soft", "CT in Hounsfield units: skin and muscle before bone", ct_soft, &SOFT),
    Preset::of_units(
        "ct-lung",
        "CT in Hounsfield units: the border of air, with the lungs' inner surface",
        ct_lung,
        &LUNG,
    ),
    Preset::fitted(
        "mr-angio",
        "MR angiography: the brightest voxels, which are vessels; fitted to the volume",
        mr_angio,
    ),
];

/// Whether a volume's values may be Hounsfield units: they reach below fat's and beyond soft tissue's, and no farther than scanners write.
pub(super) fn may_be_hounsfield(volume: &Volume) -> bool {
    let [low, high] = volume.common_range();
    (-32768.0..=-100.0).contains(&low) && (100.0..=65536.0).contains(&high)
}

fn ct_bone(_: &Subject, scene: &mut Scene) {
    apply(&BONE, |value| value, scene);
}

fn ct_angio(_: &Subject, scene: &mut Scene) {
    apply(&ANGIO, |value| value, scene);
}

fn ct_soft(_: &Subject, scene: &mut Scene) {
    apply(&SOFT, |value| value, scene);
}

fn ct_lung(_: &Subject, scene: &mut Scene) {
    apply(&LUNG, |value| value, scene);
}

fn mr_angio(subject: &Subject, scene: &mut Scene) {
    let [low, high] = subject.brightest;
    let [width, level] = MR_ANGIO.window;
    let start = level - 0.5 * width;
    apply(&MR_ANGIO, |value| low + (value - start) / width * (high - low), scene);
    scene.transfer.reference_length = Some(subject.reference_length);
}

fn apply(table: &Table, value: impl Fn(f32) -> f32, scene: &mut Scene) {
    let mut colors = Vec::new();
    for (index, &(x, code)) in table.color.iter().enumerate() {
        if let Some(&(before, from)) = index.checked_sub(1).and_then(|before| table.color.get(before)) {
            // Straight between colours as they are displayed, which is bent in linear light.
            for part in 1..4_u8 {
                let t = f32::from(part) / 4.0;
                let between = color_at(ColorSpace::Rgb, from, code, f64::from(t));
                colors.push(color(value(before + (x - before) * t), linear(between)));
            }
        }
        colors.push(color(value(x), linear(code)));
    }
    scene.transfer = TransferFunction {
        reference_length: Some(LAYER),
        color: colors,
        opacity: table.opacity.iter().map(|&(x, share)| opacity(value(x), share)).collect(),
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    in_studio(scene);
}

fn linear(code: [f64; 3]) -> [f32; 3] {
    code.map(|value| srgb_to_linear(value as f32))
}

/// The surroundings of transfer functions that say nothing of them: soft white light before dark slate, as viewers have it.
pub(super) fn in_studio(scene: &mut Scene) {
    scene.light = vec![Light { angular_radius: 3.0, ..Light::default() }];
    scene.shading = Shading { ambient: [0.2, 0.2, 0.2], specular: 0.2, ..Shading::default() };
    scene.environment = Environment {
        kind: EnvironmentKind::Gradient,
        color: [0.02, 0.025, 0.035],
        horizon: [0.10, 0.12, 0.15],
        nadir: [0.02, 0.02, 0.025],
        ..Environment::default()
    };
    scene.ground = None;
    scene.wall = None;
}
