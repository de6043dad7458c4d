//! ParaView's colour maps in JSON: a list of maps, each with `RGBPoints` and perhaps `Points`, its opacities.

use serde_json::Value;

use super::color_space::ColorSpace;
use super::curve::{Colors, Opacities, Point};
use super::{Found, pick};
use crate::error::{Error, Place, Report, clip};
use crate::source::Assumptions;

/// Reads one of several maps.
pub(super) fn read(report: Report, maps: &[Value], name: Option<&str>) -> Result<Found, Error> {
    let has_functions =
        |map: &&Value| ["RGBPoints", "Points", "IndexedColors"].iter().any(|key| map.get(key).is_some());
    let maps: Vec<&Value> = maps.iter().filter(has_functions).collect();
    if maps.is_empty() {
        let problem = "there is neither a colour map of ParaView (`RGBPoints`) nor a volume property of 3D Slicer (`volumeProperties`) in it";
        return Err(report.invalid(Place::File, problem, "export the map by ParaView, or the property by 3D Slicer"));
    }
    let names: Vec<String> =
        maps.iter().map(|map| map.get("Name").and_then(Value::as_str).unwrap_or_default().to_owned()).collect();
    let mut found = Found { format: "ParaView colour map (JSON)", ..Found::default() };
    let index = pick(report, &names, name, &mut found.assumptions)?;
    let map = maps[index];
    found.name = names[index].clone();
    let values = numbers(report, map, "RGBPoints", 4)?;
    let points = values.chunks_exact(4).map(|point| Point::new(point[0], [point[1], point[2], point[3]], Place::File));
    let space = map.get("ColorSpace").and_then(Value::as_str).unwrap_or("RGB");
    found.colors = Colors { points: points.collect(), space: space_of(space, &mut found.assumptions) };
    let values = numbers(report, map, "Points", 4)?;
    let points =
        values.chunks_exact(4).map(|point| Point::new(point[0], [point[1]], Place::File).bent(point[2], point[3]));
    found.opacities = Opacities { points: points.collect() };
    found.unit_distance = map.get("ScalarOpacityUnitDistance").and_then(Value::as_f64);
    if map.get("UseLogScale").is_some_and(|log| log.as_i64() == Some(1) || log.as_bool() == Some(true)) {
        found
            .assumptions
            .push("left out: the logarithmic scale of the map, whose points were taken as they are".to_owned());
    }
    if found.colors.points.is_empty() && found.opacities.points.is_empty() {
        categories(report, map, &mut found)?;
    }
    Ok(found)
}

/// A map of categories: a colour for each annotated value, up to the middle of the way to the next.
fn categories(report: Report, map: &Value, found: &mut Found) -> Result<(), Error> {
    let colors = numbers(report, map, "IndexedColors", 3)?;
    let annotations = map.get("Annotations").and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
    let values = annotations.iter().step_by(2).map(|value| match value {
        Value::String(text) => text.trim().parse::<f64>().ok(),
        value => value.as_f64(),
    });
    let values: Vec<f64> = values.collect::<Option<Vec<_>>>().unwrap_or_default();
    let values = if values.is_empty() { (0..colors.len() / 3).map(|index| index as f64).collect() } else { values };
    let points = values.iter().zip(colors.chunks_exact(3).cycle());
    let mut points: Vec<_> =
        points.map(|(&x, color)| Point::new(x, [color[0], color[1], color[2]], Place::File)).collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    let middles: Vec<f64> = points.windows(2).map(|pair| f64::midpoint(pair[0].x, pair[1].x)).collect();
    points.iter_mut().skip(1).zip(middles).for_each(|(point, middle)| point.x = middle);
    found.colors = Colors { points, space: ColorSpace::Step };
    Ok(())
}

/// The space of a name; one that is not known is RGB, which is told.
pub(super) fn space_of(name: &str, assumptions: &mut Assumptions) -> ColorSpace {
    ColorSpace::named(name).unwrap_or_else(|| {
        assumptions.push(format!("`{}` is no known colour space: RGB was taken", clip(name)));
        ColorSpace::Rgb
    })
}

/// The numbers of a list, `of` of which make a point; empty where there is no such list.
fn numbers(report: Report, map: &Value, key: &str, of: usize) -> Result<Vec<f64>, Error> {
    let list = match map.get(key) {
        None | Some(Value::Null) => return Ok(Vec::new()),
        Some(Value::Array(list)) => list,
        Some(other) => {
            let problem = format!("`{key}` is no list: {}", clip(&other.to_string()));
            return Err(report.invalid(Place::File, problem, "write a list of numbers"));
        }
    };
    let number = |(index, value): (usize, &Value)| {
        value.as_f64().ok_or_else(|| {
            let problem = format!("`{key}[{index}]` is no number: {}", clip(&value.to_string()));
            report.invalid(Place::File, problem, "write a number")
        })
    };
    let numbers = list.iter().enumerate().map(number).collect::<Result<Vec<f64>, Error>>()?;
    if numbers.len() % of != 0 {
        let problem = format!("`{key}` has {} numbers, and a point has {of}", numbers.len());
        return Err(report.invalid(Place::File, problem, format!("write {of} numbers for each point")));
    }
    Ok(numbers)
}
