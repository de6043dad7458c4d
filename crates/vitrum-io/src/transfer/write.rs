//! Writing of transfer functions for ParaView.

use serde_json::json;

use super::TransferFile;
use crate::image::linear_to_srgb;

/// A transfer function as ParaView imports it: a list of one map in JSON, with opacities (`Points`) where there are any.
///
/// Colours are written as sRGB code values, between which ParaView interpolates; as many are added between them as it takes to
/// meet the straight lines in linear light within half a code of 8 bits.
#[must_use]
pub fn paraview_json(function: &TransferFile) -> String {
    let mut colors: Vec<f64> = Vec::new();
    let mut add = |x: f32, rgb: [f32; 3]| {
        colors.push(f64::from(x));
        colors.extend(rgb.map(|value| rounded(linear_to_srgb(value))));
    };
    for pair in function.color.windows(2) {
        let [(x0, from), (x1, to)] = [pair[0], pair[1]];
        let parts: u8 = if from == to || x0 == x1 { 1 } else { 8 };
        for part in 0..parts {
            let t = f32::from(part) / f32::from(parts);
            add(x0 + (x1 - x0) * t, std::array::from_fn(|i| from[i] + (to[i] - from[i]) * t));
        }
    }
    if let Some(&(x, rgb)) = function.color.last() {
        add(x, rgb);
    }
    let opacity = function.opacity.iter().flat_map(|&(x, opacity)| [f64::from(x), rounded(opacity), 0.5, 0.0]);
    let name = if function.name.is_empty() { "vitrum" } else { &function.name };
    let mut map = json!({
        "ColorSpace": "RGB",
        "Creator": "vitrum",
        "Name": name,
        "NanColor": [0.0, 0.0, 0.0],
        "RGBPoints": colors,
    });
    if let Some(map) = map.as_object_mut() {
        if !function.opacity.is_empty() {
            map.insert("Points".to_owned(), opacity.collect::<Vec<f64>>().into());
        }
        if let Some(distance) = function.unit_distance {
            // ParaView keeps it with the representation, and leaves out keys that it does not know.
            map.insert("ScalarOpacityUnitDistance".to_owned(), f64::from(distance).into());
        }
    }
    format!("{:#}\n", json!([map]))
}

fn rounded(value: f32) -> f64 {
    (f64::from(value) * 1e6).round() / 1e6
}
