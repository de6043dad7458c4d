//! The command that makes the picture in the window.

use vitrum::Assets;
use vitrum::composition::{Composition, CompositionError, shell_command};
use vitrum::scene::Scene;

/// The text of the `vitrum render` that makes the picture of `scene`, which was composed of `composition` and changed since, for a POSIX shell; `output` is
/// the picture's path.
///
/// # Errors
///
/// Those of [`Composition::leading_to`].
pub fn command(
    composition: &Composition,
    scene: &Scene,
    assets: &Assets,
    output: &str,
) -> Result<String, CompositionError> {
    let mut words = composition.leading_to(scene, assets)?.arguments();
    words.insert(1, format!("--output={output}"));
    Ok(shell_command("vitrum", "render", &words))
}
