//! Checks of a participating medium.

use super::super::error::Fault;
use super::super::{Medium, MethodName, Phase};

/// Refuses a medium that the method cannot render, or whose keys contradict each other.
pub(super) fn check(method: MethodName, medium: &Medium) -> Result<(), Fault> {
    if !method.capabilities().medium {
        let other = MethodName::that_renders(|shows| shows.medium);
        let other = other.map_or_else(String::new, |other| format!("set `method = \"{}\"`, or ", other.as_str()));
        return Err(Fault::contradiction(
            "medium",
            format!("the method `{}` renders no participating medium", method.as_str()),
            format!(
                "{other}leave `medium` out; a clear colour is `transfer.filter` of a volume, `attenuation_color` of a mesh's material"
            ),
        ));
    }
    check_phase(medium)?;
    if medium.density.is_some() && medium.extent.is_some() {
        return Err(Fault::contradiction(
            "medium.extent",
            "the medium fills the box of the volume `medium.density`, and an extent is given besides",
            "leave `medium.extent` out, or leave `medium.density` out",
        ));
    }
    check_density(method, medium)
}

/// Refuses a phase function that its keys do not describe, or describe twice.
fn check_phase(medium: &Medium) -> Result<(), Fault> {
    let has_own_mean = match medium.phase {
        Phase::HenyeyGreenstein => None,
        Phase::Rayleigh => Some("the phase function `rayleigh` has the mean cosine 0"),
        Phase::Tabulated => Some("the mean cosine of a `tabulated` phase function follows from its values"),
    };
    if let Some(why) = has_own_mean.filter(|_| medium.anisotropy != 0.0) {
        return Err(Fault::contradiction(
            "medium.anisotropy",
            format!("{why}, and {} is given", medium.anisotropy),
            "leave `medium.anisotropy` out, or set `medium.phase = \"henyey_greenstein\"`",
        ));
    }
    let values = &medium.phase_values;
    if medium.phase != Phase::Tabulated {
        return if values.is_empty() {
            Ok(())
        } else {
            Err(Fault::contradiction(
                "medium.phase_values",
                "values are given of a phase function that is not `tabulated`",
                "set `medium.phase = \"tabulated\"`, or leave `medium.phase_values` out",
            ))
        };
    }
    // NaN is not at least anything.
    if let Some(index) = values.iter().position(|&value| !(value >= 0.0 && value.is_finite())) {
        return Err(Fault::contradiction(
            &format!("medium.phase_values.{index}"),
            format!("a phase function is at least 0 everywhere, and here it is {}", values[index]),
            "give finite numbers that are not negative",
        ));
    }
    if values.len() < 2 || values.iter().all(|&value| value == 0.0) {
        return Err(Fault::contradiction(
            "medium.phase_values",
            "a tabulated phase function needs two values or more, for 0° and for 180°, of which one is not 0",
            "give its values at even steps of the angle",
        ));
    }
    Ok(())
}

/// Refuses a density that the method cannot render, and a window that makes none.
fn check_density(method: MethodName, medium: &Medium) -> Result<(), Fault> {
    if medium.density.is_some() && !method.capabilities().medium_density {
        let other = MethodName::that_renders(|shows| shows.medium_density);
        let other = other.map_or_else(String::new, |other| format!("set `method = \"{}\"`, or ", other.as_str()));
        return Err(Fault::contradiction(
            "medium.density",
            format!("the method `{}` renders a homogeneous medium, and a density is given", method.as_str()),
            format!("{other}leave `medium.density` out; `medium.extent` is the size of the medium"),
        ));
    }
    let Some([low, high]) = medium.density_window else { return Ok(()) };
    if medium.density.is_none() {
        return Err(Fault::contradiction(
            "medium.density_window",
            "it maps the values of a volume to densities, and `medium.density` is not given",
            "name a volume in `medium.density`, or leave `medium.density_window` out",
        ));
    }
    // NaN is not below anything.
    if !(low < high && low.is_finite() && high.is_finite()) {
        return Err(Fault::contradiction(
            "medium.density_window",
            format!("the density is 0 at {low} and 1 at {high}, and the first is not below the second"),
            "give two finite numbers, the lower one first",
        ));
    }
    Ok(())
}
