//! Marks over the picture: annotations of the scene, switched on and off.

use eframe::egui::Ui;
use vitrum::scene::{Annotation, AnnotationKind, OrientationStyle, Scene};

/// A check box for each mark.
pub fn show(ui: &mut Ui, scene: &mut Scene) {
    use AnnotationKind::{Axes, BoundingBox, Legend, Orientation, ScaleBar};
    let has_transfer = !scene.shows_mesh();
    for (kind, style, name) in [
        (ScaleBar, None, "Scale bar"),
        (Orientation, Some(OrientationStyle::Cube), "Orientation cube"),
        (Orientation, Some(OrientationStyle::Letters), "Orientation letters"),
        (Legend, None, "Legend of colours"),
        (BoundingBox, None, "Bounding box"),
        (Axes, None, "Axes"),
    ] {
        if kind == Legend && !has_transfer {
            continue;
        }
        let is_it = |annotation: &Annotation| {
            let style_of = annotation.style.unwrap_or(OrientationStyle::Letters);
            annotation.kind == kind && style.is_none_or(|style| style == style_of)
        };
        let mut on = scene.annotation.iter().any(is_it);
        if ui.checkbox(&mut on, name).changed() {
            if on {
                scene.annotation.push(Annotation { kind, style, ..Annotation::default() });
            } else {
                scene.annotation.retain(|annotation| !is_it(annotation));
            }
        }
    }
}
