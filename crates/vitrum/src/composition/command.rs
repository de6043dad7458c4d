//! A composition as the command that renders it.

use super::{Composition, CompositionError, Quality};
use crate::Assets;
use crate::preset::{Adjustments, Surface};
use crate::scene::{Rgb, Scene};
use std::path::Path;

impl Composition {
    /// This composition with the settings that lead to `scene`, in every key; `assets` are the data of its input. The settings it had are replaced, and so
    /// are its size and side, which are keys of the scene.
    ///
    /// # Errors
    /// [`CompositionError`] where the composition is not valid without its settings, or `scene` is not one.
    pub fn leading_to(&self, scene: &Scene, assets: &Assets) -> Result<Self, CompositionError> {
        let size = Some([scene.film.width, scene.film.height]);
        let start = Self { settings: Vec::new(), size, side: None, ..self.clone() };
        let base = start.compose_again(assets)?.scene;
        Ok(Self { settings: scene.settings_from(&base)?, ..start })
    }

    /// The words behind `vitrum render` that compose the same scene.
    #[must_use]
    pub fn arguments(&self) -> Vec<String> {
        let mut words = vec![self.input.clone()];
        let mut flag = |name: &str, value: Option<String>| {
            if let Some(value) = value {
                words.push(format!("--{name}={value}"));
            }
        };
        let path = |path: &Path| path.display().to_string();
        let source = &self.source;
        flag("raw", source.raw.clone());
        flag("spacing", source.spacing.map(|spacing| joined(&spacing)));
        flag("array", source.array.clone());
        flag("time", source.time.map(|time| time.to_string()).or(source.seconds.map(|seconds| format!("{seconds}s"))));
        flag("up", source.up.clone());
        flag("max-bytes", self.max_bytes.map(|bytes| bytes.to_string()));
        if let Some(mask) = &source.mask {
            flag("mask", Some(path(&mask.file)));
            flag("mask-labels", (!mask.labels.is_empty()).then(|| joined(&mask.labels)));
        }
        flag("preset", self.preset.clone());
        flag("medium", self.medium.clone());
        flag("quality", self.quality.map(|quality| quality.name().to_owned()));
        flag("view", self.side.map(|side| side.name().to_owned()));
        flag("transfer", self.transfer.as_deref().map(path));
        let Adjustments { threshold, window, colormap, isosurfaces, gradient } = &self.adjustments;
        flag("threshold", threshold.map(|threshold| threshold.to_string()));
        flag("window", window.map(|[width, _]| width.to_string()));
        flag("level", window.map(|[_, level]| level.to_string()));
        flag("colormap", colormap.clone());
        isosurfaces.iter().for_each(|surface| flag("isosurface", Some(written(surface))));
        let points: Vec<String> =
            gradient.iter().map(|point| format!("{}:{}", point.magnitude, point.factor)).collect();
        flag("gradient-opacity", (!points.is_empty()).then(|| points.join(",")));
        flag("size", self.size.map(|[width, height]| format!("{width}x{height}")));
        self.settings.iter().for_each(|setting| flag("set", Some(setting.clone())));
        words
    }
}

impl Quality {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Draft => "draft",
            Self::Good => "good",
            Self::Best => "best",
        }
    }
}

/// The command `program subcommand arguments` for a POSIX shell, a line for each setting.
#[must_use]
pub fn shell_command(program: &str, subcommand: &str, arguments: &[String]) -> String {
    let mut text = format!("{} {}", quoted(program), quoted(subcommand));
    for argument in arguments {
        let separator = if argument.starts_with("--set=") { " \\\n  " } else { " " };
        text += separator;
        text += &quoted(argument);
    }
    text
}

/// A word as a POSIX shell takes it for one.
fn quoted(word: &str) -> String {
    let is_safe = |letter: char| letter.is_ascii_alphanumeric() || "-_./:=,+@%".contains(letter);
    if !word.is_empty() && word.chars().all(is_safe) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', r"'\''"))
}

fn joined(numbers: &[f32]) -> String {
    numbers.iter().map(f32::to_string).collect::<Vec<_>>().join(",")
}

/// An isosurface as `--isosurface` takes it, but for its colour: that is written in 8 bits, and exactly by the setting that follows from the difference.
fn written(surface: &Surface) -> String {
    let color = surface.color.map_or_else(String::new, hexadecimal);
    format!("{}:{color}:{}", surface.value, surface.opacity)
}

fn hexadecimal(color: Rgb) -> String {
    let code = |value: f32| (crate::io::linear_to_srgb(value).clamp(0.0, 1.0) * 255.0).round() as u8;
    let [r, g, b] = color.map(code);
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(all(test, feature = "builtin"))]
mod tests {
    use super::super::Composed;
    use super::*;

    #[test]
    fn words_that_a_shell_would_take_apart_are_quoted() {
        for (word, safe) in [
            ("a-b.toml", "a-b.toml"),
            ("", "''"),
            ("two words", "'two words'"),
            ("it's", r"'it'\''s'"),
            ("$HOME", "'$HOME'"),
            ("x=[1]", "'x=[1]'"),
        ] {
            assert_eq!(quoted(word), safe);
        }
    }

    #[test]
    fn a_changed_scene_is_composed_again_from_its_settings() -> Result<(), CompositionError> {
        for preset in [None, Some("haze"), Some("glass")] {
            let composition = Composition {
                input: "builtin:ball".to_owned(),
                preset: preset.map(str::to_owned),
                settings: vec!["volume.resolution=16".to_owned()],
                ..Composition::default()
            };
            let Composed { mut scene, assets, .. } = composition.compose()?;
            scene.camera.azimuth = 12.0;
            scene.film.width = 99;
            let leading = composition.leading_to(&scene, &assets)?;
            assert_eq!(leading.compose()?.scene, scene, "{:?}", leading.settings);
            assert!(leading.settings.len() == 2, "{:?}", leading.settings);
            let command = shell_command("vitrum", "render", &leading.arguments());
            assert!(command.contains("--size=99x") && command.contains("--set=camera.azimuth=12"), "{command}");
        }
        Ok(())
    }
}
