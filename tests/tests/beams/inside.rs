//! Eyes inside the light: under a clear ball in fog, where beams fill the picture. Single rays from such eyes are held to the values of
//! [`ball_table`](super::ball_table); these are whole pictures.

use super::ball::in_fog;
use super::{LAMP, on_both, red};
use vitrum::Frame;
use vitrum_conformance::{Failure, frames};

/// The largest difference of a picture's mean with the pyramid from the one without it, as a share: interpolation conserves the sum but at the picture's
/// edges, through which wide beams leave it, and where surfaces begin. Found are up to 1.6 · 10⁻³.
const PYRAMID: f64 = 0.005;

/// Eyes and the points that they look at: in the focus, in the light behind it, on the axis; across the light, against it, and along it.
const EYES: [[&str; 2]; 5] = [
    ["[0,0,-1.5]", "[1,0,-1.5]"],
    ["[0,0,-1.5]", "[0,0.01,-2.9]"],
    ["[0.35,-0.25,-2.9]", "[0.05,0.02,-1.2]"],
    ["[0.03,0.02,-2.95]", "[0.025,0.01,-2.2]"],
    ["[0,0,-2.5]", "[0,0.001,0]"],
];

/// No value of an output is less than 0, or is not finite; rounding of the sums may be a unit.
fn hold(frame: &Frame, what: &str) {
    for layer in frame.layers.iter().filter(|layer| layer.name != "normal") {
        for channel in &layer.channels {
            let wrong = channel.data.iter().find(|value| !(value.is_finite() && **value >= 0.0));
            assert!(wrong.is_none(), "{what}: {} has {wrong:?}", layer.name);
        }
    }
}

#[test]
fn eyes_inside_the_light_see_finite_radiance() -> Result<(), Failure> {
    for [eye, target] in EYES {
        let of = |pyramid: bool| {
            let mut case = in_fog(LAMP, 0.7, 0.5, 32)?;
            case.resize(48);
            let [eye, target] = [format!("camera.position={eye}"), format!("camera.target={target}")];
            for setting in [eye.as_str(), &target, "camera.field_of_view=90", &format!("beams.pyramid={pyramid}")] {
                case.scene.set(setting)?;
            }
            Ok::<_, Failure>(case)
        };
        let (with, without) = (of(true)?, of(false)?);
        on_both(|backend| {
            let (with, without) = (frames::render(&with, backend)?, frames::render(&without, backend)?);
            let what = format!("from {eye} to {target} ({})", backend.name());
            hold(&with, &what);
            hold(&without, &what);
            let mean = |frame: &Frame| red(frame, "caustics").iter().sum::<f64>();
            let difference = mean(&with) / mean(&without) - 1.0;
            println!("{what}: {difference:.2e}");
            assert!(difference.abs() <= PYRAMID, "{what}: the pyramid changes the light by {difference:.2e}");
            Ok(())
        })?;
    }
    Ok(())
}
