//! Materials as glTF and its extensions describe them.

use super::document::MaterialEntry;
use super::scene::Assembly;
use crate::error::Error;
use crate::mesh::Material;

impl Assembly<'_, '_> {
    /// The mesh's index of a material, or of the default one.
    pub fn material(&mut self, index: Option<usize>, name: &str) -> Result<u32, Error> {
        let default = MaterialEntry::default();
        let list = &self.files.document.materials;
        let entry = match index {
            Some(index) if index < list.len() => &list[index],
            Some(index) => {
                self.leave_out(format!("left out: {name} names the material {index}, and there are {}", list.len()));
                &default
            }
            None => &default,
        };
        let slot = index.unwrap_or(list.len()).min(list.len());
        if let Some(known) = self.materials[slot] {
            return Ok(known);
        }
        let mut material = convert(entry);
        for problem in leave_out_wrong(&mut material) {
            self.leave_out(format!("left out: materials[{slot}]: {problem}"));
        }
        let number = self.builder.materials.len() as u32;
        self.builder.budget.push(&mut self.builder.materials, material)?;
        self.materials[slot] = Some(number);
        Ok(number)
    }
}

/// The material of an entry, with the format's defaults for absent fields.
fn convert(entry: &MaterialEntry) -> Material {
    let [red, green, blue, alpha] = entry.pbr_metallic_roughness.base_color_factor.unwrap_or([1.0; 4]);
    let extensions = &entry.extensions;
    let volume = extensions.volume.as_ref();
    // Over an infinite distance, which is the default, no colour attenuates.
    let distance = volume.and_then(|volume| volume.attenuation_distance);
    Material {
        name: entry.name.clone(),
        base_color: Some([red, green, blue]),
        opacity: Some(match entry.alpha_mode.as_deref() {
            None | Some("OPAQUE") => 1.0,
            Some(_) => alpha,
        }),
        transmission: extensions.transmission.as_ref().map(|transmission| transmission.transmission_factor),
        index_of_refraction: extensions.ior.as_ref().map(|ior| ior.ior.unwrap_or(1.5)),
        attenuation_color: distance.and(volume).map(|volume| volume.attenuation_color.unwrap_or([1.0; 3])),
        attenuation_distance: distance,
        roughness: Some(entry.pbr_metallic_roughness.roughness_factor.unwrap_or(1.0)),
    }
}

/// Takes out what is out of range; the problems.
fn leave_out_wrong(material: &mut Material) -> Vec<String> {
    let mut problems = Vec::new();
    let mut drop = |name: &str, is_wrong: bool, expected: &str| {
        if is_wrong {
            problems.push(format!("{name} is not {expected}"));
        }
        is_wrong
    };
    let unit = |value: f32| (0.0..=1.0).contains(&value);
    let colors =
        [("the base colour", &mut material.base_color), ("the attenuation colour", &mut material.attenuation_color)];
    for (name, color) in colors {
        let is_wrong = color.is_some_and(|color| !color.into_iter().all(unit));
        *color = color.take_if(|_| !drop(name, is_wrong, "0 to 1"));
    }
    let numbers = [
        ("the alpha", &mut material.opacity),
        ("the transmission", &mut material.transmission),
        ("the roughness", &mut material.roughness),
    ];
    for (name, number) in numbers {
        let is_wrong = number.is_some_and(|number| !unit(number));
        *number = number.take_if(|_| !drop(name, is_wrong, "0 to 1"));
    }
    // 0 stands for an infinite one.
    let is_index = |ior: f32| ior == 0.0 || (1.0..=1e6).contains(&ior);
    if drop("the index of refraction", material.index_of_refraction.is_some_and(|ior| !is_index(ior)), "1 or more") {
        material.index_of_refraction = None;
    }
    let is_distance = |distance: f32| distance > 0.0 && distance.is_finite();
    let is_wrong = material.attenuation_distance.is_some_and(|distance| !is_distance(distance));
    if drop("the attenuation distance", is_wrong, "a finite number above 0") {
        (material.attenuation_distance, material.attenuation_color) = (None, None);
    }
    problems
}
