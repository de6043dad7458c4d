//! Checks of what makes a picture a figure: background and annotations.

use super::super::error::{Fault, Problem};
use super::super::paint::EXPECTED;
use super::super::{Annotation, AnnotationKind, Background, MethodName, Paint, Scene};

pub(super) fn check(scene: &Scene) -> Result<(), Fault> {
    if let Some(background) = scene.background.as_deref().filter(|text| Background::parse(text).is_none()) {
        return Err(wrong("background", background, format!("`transparent` or {EXPECTED}")));
    }
    check_catcher(scene)?;
    scene.annotation.iter().enumerate().try_for_each(|(index, item)| check_annotation(index, item))
}

fn check_catcher(scene: &Scene) -> Result<(), Fault> {
    if !scene.ground.as_ref().is_some_and(|ground| ground.shadow_catcher) {
        return Ok(());
    }
    let key = "ground.shadow_catcher";
    if scene.background.is_none() {
        let problem = "the shadow of a ground that is left out falls on a `background`, and there is none";
        return Err(Fault::contradiction(key, problem, "set `background`, such as white or transparent"));
    }
    if scene.method == MethodName::Beams {
        let advice = "leave it out, or take the method `voxels`";
        return Err(Fault::contradiction(key, "the method `beams` catches no shadows", advice));
    }
    Ok(())
}

fn check_annotation(index: usize, annotation: &Annotation) -> Result<(), Fault> {
    for (name, color) in [("color", &annotation.color), ("background", &annotation.background)] {
        if let Some(text) = color.as_deref().filter(|text| Paint::parse(text).is_none()) {
            return Err(wrong(&format!("annotation.{index}.{name}"), text, EXPECTED.to_owned()));
        }
    }
    let kind = annotation.kind.name();
    if let Some(foreign) = annotation.foreign_key() {
        let advice = format!("leave `{foreign}` out, or choose another `kind`");
        let problem = format!("a {kind} has no `{foreign}`");
        return Err(Fault::contradiction(&format!("annotation.{index}.{foreign}"), problem, advice));
    }
    if annotation.kind == AnnotationKind::Caption && annotation.text.as_ref().is_none_or(|text| text.trim().is_empty())
    {
        let advice = format!("give it words, such as `annotation.{index}.text = \"A head\"`");
        return Err(Fault::contradiction(&format!("annotation.{index}.text"), "a caption has a text", advice));
    }
    Ok(())
}

fn wrong(key: &str, found: &str, expected: String) -> Fault {
    let path: Vec<String> = key.split('.').map(str::to_owned).collect();
    let problem = Problem::WrongValue { found: format!("\"{found}\""), expected, nearest: None, default: None };
    Fault::at(&path, problem)
}
