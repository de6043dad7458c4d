//! Transfer functions in JSON: 3D Slicer's volume properties and ParaView's colour maps, told apart by their keys.

use serde_json::Value;

use super::curve::{Colors, Opacities, Point};
use super::slicer::LEFT_OUT;
use super::{Found, paraview, pick};
use crate::error::{Error, Place, Report, clip};

/// Reads a JSON document.
pub(super) fn read(report: Report, value: &Value, name: Option<&str>) -> Result<Found, Error> {
    if let Some(properties) = value.get("volumeProperties").and_then(Value::as_array) {
        return slicer(report, properties, name);
    }
    match value {
        Value::Array(maps) => paraview::read(report, maps, name),
        map => paraview::read(report, std::slice::from_ref(map), name),
    }
}

fn slicer(report: Report, properties: &[Value], name: Option<&str>) -> Result<Found, Error> {
    let mut found = Found { format: "3D Slicer volume property (JSON)", ..Found::default() };
    let named = |(index, property): (usize, &Value)| match property.get("name").and_then(Value::as_str) {
        Some(name) => name.to_owned(),
        None => (index + 1).to_string(),
    };
    let names: Vec<String> = properties.iter().enumerate().map(named).collect();
    let index = pick(report, &names, name, &mut found.assumptions)?;
    let component = properties.get(index).and_then(|property| property.get("components")).and_then(Value::as_array);
    let component = component.and_then(|components| components.first().map(|first| (first, components.len())));
    let Some((component, count)) = component else {
        let problem = "there is no volume property with a component in it";
        return Err(report.invalid(Place::File, problem, "save the volume property by 3D Slicer"));
    };
    if count > 1 {
        found.assumptions.push(format!("left out: {} of {count} components, all but the first", count - 1));
    }
    found.name = names.get(index).cloned().unwrap_or_default();
    if let Some(opacity) = component.get("scalarOpacity") {
        found.opacities =
            Opacities { points: points(report, opacity, "scalarOpacity", |point| Some([number(point, "y")?]))? };
    }
    let gray = |point: &Value| number(point, "y").map(|gray| [gray; 3]);
    if let Some(color) = component.get("rgbTransferFunction") {
        let points = points(report, color, "rgbTransferFunction", |point| {
            let color: Vec<f64> = point.get("color")?.as_array()?.iter().filter_map(Value::as_f64).collect();
            color.try_into().ok()
        })?;
        found.colors = Colors { points, ..Colors::default() };
    } else if let Some(color) = component.get("grayTransferFunction") {
        found.colors = Colors { points: points(report, color, "grayTransferFunction", gray)?, ..Colors::default() };
    }
    found.unit_distance = component.get("scalarOpacityUnitDistance").and_then(Value::as_f64);
    let disabled = component.get("disableGradientOpacity").and_then(Value::as_bool).unwrap_or(false);
    if let Some(gradient) = component.get("gradientOpacity").filter(|_| !disabled) {
        let points = points(report, gradient, "gradientOpacity", |point| Some([number(point, "y")?]))?;
        found.gradients = Opacities { points };
    }
    found.assumptions.push(LEFT_OUT.to_owned());
    Ok(found)
}

fn points<const N: usize>(
    report: Report,
    function: &Value,
    name: &str,
    value: impl Fn(&Value) -> Option<[f64; N]>,
) -> Result<Vec<Point<N>>, Error> {
    let Some(points) = function.get("points").and_then(Value::as_array) else {
        let problem = format!("`{name}` has no list `points`");
        return Err(report.invalid(Place::File, problem, "save the volume property by 3D Slicer"));
    };
    let read = |(index, point): (usize, &Value)| {
        let whole = number(point, "x").zip(value(point));
        let Some((x, y)) = whole else {
            let problem = format!("`{name}.points[{index}]` is no point: {}", clip(&point.to_string()));
            return Err(report.invalid(Place::File, problem, "give it `x`, and `y` or `color`, as numbers"));
        };
        let bent = |key, default| number(point, key).unwrap_or(default);
        Ok(Point::new(x, y, Place::File).bent(bent("midpoint", 0.5), bent("sharpness", 0.0)))
    };
    points.iter().enumerate().map(read).collect()
}

fn number(value: &Value, key: &str) -> Option<f64> {
    value.get(key)?.as_f64()
}
