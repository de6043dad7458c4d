//! Presets and transfer functions with a threshold, a window or a map of colours.

use super::hounsfield::{in_studio, layer, may_be_hounsfield};
use super::subject::Subject;
use super::surfaces::{self, Surface};
use super::{PresetError, find, forget_light_grid, labels, points};
use crate::scene::{ColorPoint, GradientFunction, GradientPoint, OpacityPoint, Scene, TransferFunction};
use vitrum_io::Volume;
use vitrum_io::transfer::TransferFile;

/// Changes of a transfer function, applied in the order window, threshold, map of colours, isosurfaces, gradients.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Adjustments {
    /// Everything below is nothing. A preset is fitted to the values above, without a window.
    pub threshold: Option<f32>,
    /// Width and level of the window over which the function changes: from level − width / 2 to level + width / 2.
    pub window: Option<[f32; 2]>,
    /// The name of a map of colours, one of [`colormap_names`](super::colormap_names).
    pub colormap: Option<String>,
    /// Isosurfaces beside the function.
    pub isosurfaces: Vec<Surface>,
    /// Factors of opacity at magnitudes of the gradient, for all values.
    pub gradient: Vec<GradientPoint>,
}

impl Adjustments {
    /// Whether nothing is changed.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Whether there are isosurfaces, and nothing else is changed.
    #[must_use]
    pub fn are_isosurfaces(&self) -> bool {
        !self.isosurfaces.is_empty() && *self == Self { isosurfaces: self.isosurfaces.clone(), ..Self::default() }
    }

    /// Whether the numbers are such, and the map is known; worth asking before reading a volume.
    ///
    /// # Errors
    ///
    /// [`PresetError::Adjustment`] and [`PresetError::UnknownColormap`].
    pub fn check(&self) -> Result<(), PresetError> {
        self.isosurfaces.iter().try_for_each(Surface::check)?;
        if let Some(threshold) = self.threshold.filter(|threshold| !threshold.is_finite()) {
            return Err(PresetError::Adjustment { problem: format!("the threshold {threshold} is not finite") });
        }
        if let Some([width, level]) = self.window {
            let [low, high] = ends([width, level]);
            if !(low < high && low.is_finite() && high.is_finite()) {
                let problem = format!("the width {width} and the level {level} are no window");
                return Err(PresetError::Adjustment { problem });
            }
        }
        match &self.colormap {
            Some(name) if super::colormap_names().iter().all(|(known, _)| known != name) => {
                Err(PresetError::UnknownColormap { name: name.clone() })
            }
            _ => Ok(()),
        }
    }

    fn apply(&self, volume: &Volume, usual: [f32; 2], threshold: Option<f32>, scene: &mut Scene) {
        let mut shown = usual;
        if let Some(window) = self.window {
            let window = ends(window);
            points::stretch(scene, usual, window);
            shown = window;
        }
        if let Some(threshold) = threshold {
            points::cut(scene, volume, threshold);
        }
        if let Some(name) = &self.colormap {
            let low = self.threshold.filter(|threshold| *threshold < shown[1]).unwrap_or(shown[0]);
            points::recolor(scene, name, [low, shown[1]]);
        }
        surfaces::add(&self.isosurfaces, scene);
        if !self.gradient.is_empty() {
            scene.transfer.gradient.push(GradientFunction::of_opacity(self.gradient.clone()));
        }
    }
}

fn ends([width, level]: [f32; 2]) -> [f32; 2] {
    [level - 0.5 * width, level + 0.5 * width]
}

/// Gives `scene` the look of the preset `name`, fitted to the values of `volume` and adjusted; statements about what was taken for granted.
///
/// # Errors
///
/// Those of [`check`](super::check) and of [`Adjustments::check`], and [`PresetError::NotHounsfield`] without a window; the scene is then
/// unchanged. [`PresetError::NoLabels`] as well.
pub fn fit(
    name: &str,
    volume: &Volume,
    adjustments: &Adjustments,
    scene: &mut Scene,
) -> Result<Vec<String>, PresetError> {
    let preset = find(name)?;
    adjustments.check()?;
    let mut notes = Vec::new();
    if let Some(table) = preset.table {
        let range = volume.common_range();
        if may_be_hounsfield(volume) {
            let [low, high] = range;
            notes.push(format!("the values, from {low} to {high}, were taken for Hounsfield units"));
        } else if adjustments.window.is_none() {
            return Err(PresetError::NotHounsfield { name: preset.name, range, window: table.window });
        }
    }
    let no_labels = PresetError::NoLabels { name: preset.name };
    let parts = if preset.of_labels { Some(labels::parts(volume).ok_or(no_labels)?) } else { None };
    let fits = preset.table.is_none() && adjustments.window.is_none();
    let (fitted, cut) = if fits { (adjustments.threshold, None) } else { (None, adjustments.threshold) };
    (preset.apply)(&Subject::above(volume, fitted), scene);
    if let Some(parts) = parts {
        labels::color_parts(&parts, scene);
    }
    if preset.table.is_some() {
        let (length, note) = layer(volume);
        scene.transfer.reference_length = Some(length);
        notes.extend(note);
    }
    forget_light_grid(scene);
    // Voxels with colours show their own.
    if volume.colors.is_some() {
        scene.transfer.color.clear();
    }
    let usual = preset.table.map_or_else(|| points::range(scene, volume), |table| ends(table.window));
    adjustments.apply(volume, usual, cut, scene);
    Ok(notes)
}

/// Adjusts the transfer function that `scene` has.
///
/// # Errors
///
/// Those of [`Adjustments::check`]; the scene is then unchanged.
pub fn adjust(volume: &Volume, adjustments: &Adjustments, scene: &mut Scene) -> Result<(), PresetError> {
    adjustments.check()?;
    if adjustments.is_empty() {
        return Ok(());
    }
    if !adjustments.are_isosurfaces() {
        points::spell_out(scene, volume);
    }
    let usual = points::range(scene, volume);
    adjustments.apply(volume, usual, adjustments.threshold, scene);
    Ok(())
}

/// Gives `scene` the transfer function of a file, adjusted; with `in_surroundings` also light and background, as viewers have them. Statements
/// about what was taken for granted.
///
/// # Errors
///
/// Those of [`Adjustments::check`]; the scene is then unchanged.
pub fn fit_file(
    file: &TransferFile,
    volume: &Volume,
    adjustments: &Adjustments,
    in_surroundings: bool,
    scene: &mut Scene,
) -> Result<Vec<String>, PresetError> {
    adjustments.check()?;
    let mut notes: Vec<String> = file.assumptions.iter().map(ToString::to_string).collect();
    scene.transfer = TransferFunction {
        // VTK's default.
        reference_length: Some(file.unit_distance.unwrap_or(1.0)),
        color: file.color.iter().map(|&(value, color)| ColorPoint { value, color }).collect(),
        opacity: file.opacity.iter().map(|&(value, opacity)| OpacityPoint { value, opacity }).collect(),
        ior: Vec::new(),
        filter: Vec::new(),
        ..TransferFunction::default()
    };
    if !file.gradient.is_empty() {
        let points =
            file.gradient.iter().map(|&(magnitude, factor)| GradientPoint { magnitude: magnitude.max(0.0), factor });
        scene.transfer.gradient = vec![GradientFunction::of_opacity(points.collect())];
    }
    if file.opacity.is_empty() {
        // A map of colours alone: the opacity rises with them.
        let [low, high] = file.range();
        let high = if low < high { high } else { low + 1.0 };
        scene.transfer.opacity =
            vec![OpacityPoint { value: low, opacity: 0.0 }, OpacityPoint { value: high, opacity: 1.0 }];
        scene.transfer.reference_length = Some(Subject::above(volume, None).reference_length);
        notes.push("the file has no opacities: a ramp over the range of its colours was taken".to_owned());
    }
    if in_surroundings {
        in_studio(scene);
        forget_light_grid(scene);
    }
    let usual = points::range(scene, volume);
    let [low, high] = volume.common_range();
    // A map without a unit, as collections of maps have them.
    if usual == [0.0, 1.0] && adjustments.window.is_none() && !(low >= -0.5 && high <= 1.5) && low < high {
        points::stretch(scene, usual, [low, high]);
        notes.push(format!("the function goes from 0 to 1: it was stretched over the values, from {low} to {high}"));
        adjustments.apply(volume, [low, high], adjustments.threshold, scene);
    } else {
        adjustments.apply(volume, usual, adjustments.threshold, scene);
    }
    Ok(notes)
}

/// The colours and opacities of a scene's transfer function as other programs take them, and statements about what they do not have.
#[must_use]
pub fn transfer_file(scene: &Scene, volume: &Volume) -> (TransferFile, Vec<String>) {
    let TransferFunction { reference_length, color, opacity, ior, filter, .. } = &scene.transfer;
    let [low, high] = volume.common_range();
    let mut colors: Vec<_> = color.iter().map(|point| (point.value, point.color)).collect();
    let mut opacities: Vec<_> = opacity.iter().map(|point| (point.value, point.opacity)).collect();
    // What empty lists stand for.
    if scene.has_usual_opacity() {
        opacities = vec![(low, 0.0), (high, 1.0)];
    } else if opacities.is_empty() {
        opacities = vec![(low, 0.0), (high, 0.0)];
    }
    if colors.is_empty() {
        colors = [opacities.first(), opacities.last()].into_iter().flatten().map(|point| (point.0, [1.0; 3])).collect();
    }
    let smallest = volume.finest_spacing();
    let mut left_out = Vec::new();
    if !ior.is_empty() {
        left_out.push("left out: indices of refraction, which other programs do not have".to_owned());
    }
    if !scene.isosurface.is_empty() {
        left_out.push("left out: isosurfaces, which a transfer function does not have".to_owned());
    }
    if !scene.transfer.gradient.is_empty() {
        left_out
            .push("left out: factors of opacity at the gradient's magnitude, which colour maps do not have".to_owned());
    }
    if !filter.is_empty() {
        left_out.push("left out: the filter of the clear medium, which other programs do not have".to_owned());
    }
    let unit_distance = Some(reference_length.unwrap_or(smallest));
    (TransferFile { color: colors, opacity: opacities, unit_distance, ..TransferFile::default() }, left_out)
}
