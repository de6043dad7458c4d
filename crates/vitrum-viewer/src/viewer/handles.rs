//! Handles of the crop box and the clipping planes, over the picture.

use crate::navigation::Placed;
use eframe::egui::{Color32, CursorIcon, Pos2, Rect, Role, Sense, Stroke, Ui, Vec2, WidgetInfo, vec2};
use glam::DVec3;
use vitrum::scene::Scene;

/// Radius of a handle, in points.
const RADIUS: f32 = 6.0;

/// The thinnest crop box, in shares of the volume.
const THINNEST: f32 = 0.01;

/// Points of the picture that a step must take at least, so that a handle that points at the eye does not leap.
const SHORTEST: f32 = 20.0;

/// Names of the volume's axes.
const AXES: [&str; 3] = ["x", "y", "z"];

const LINE: Color32 = Color32::from_rgb(255, 176, 32);
const RIM: Color32 = Color32::from_black_alpha(200);

/// Draws the handles in the place of the picture, and changes the scene by those that are dragged.
pub fn show(ui: &mut Ui, placed: &Placed, picture: Rect, scene: &mut Scene) {
    crop_box(ui, placed, picture, scene);
    planes(ui, placed, picture, scene);
}

/// The place of a point of the world.
fn at(placed: &Placed, picture: Rect, world: DVec3) -> Option<Pos2> {
    let [x, y] = placed.share(world)?.map(|share| share as f32);
    Some(picture.min + vec2(x, y) * picture.size())
}

/// How many times `step` the hand has moved what lies at `from`.
fn moved(placed: &Placed, picture: Rect, [from, step]: [DVec3; 2], delta: Vec2) -> Option<f32> {
    /// A part of the step, so that perspective does not tell.
    const PART: f64 = 1e-3;
    let along = (at(placed, picture, from + step * PART)? - at(placed, picture, from)?) / PART as f32;
    (along.length() > SHORTEST).then(|| delta.dot(along) / along.length_sq())
}

/// A handle; how far it was dragged.
fn handle(ui: &mut Ui, place: Pos2, name: &str) -> Vec2 {
    let rect = Rect::from_center_size(place, Vec2::splat(3.0 * RADIUS));
    let response = ui.interact(rect, ui.scope_id().with(name), Sense::drag()).on_hover_cursor(CursorIcon::Grab);
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, name));
    let radius = if response.hovered() || response.dragged() { 1.3 * RADIUS } else { RADIUS };
    ui.painter().circle(place, radius, LINE, Stroke::new(1.5, RIM));
    response.drag_delta()
}

fn line(ui: &Ui, ends: [Option<Pos2>; 2]) {
    if let [Some(from), Some(to)] = ends {
        ui.painter().line_segment([from, to], Stroke::new(3.0, RIM));
        ui.painter().line_segment([from, to], Stroke::new(1.5, LINE));
    }
}

/// The edges of the crop box, and a handle in the middle of each face.
fn crop_box(ui: &mut Ui, placed: &Placed, picture: Rect, scene: &mut Scene) {
    let mut crop = scene.crop.clone().unwrap_or_default();
    let corners = placed.bounds.corners();
    let edges = [1, 2, 4].map(|corner| corners[corner] - corners[0]);
    let world = |shares: [f32; 3]| (0..3).fold(corners[0], |sum, axis| sum + edges[axis] * f64::from(shares[axis]));
    let ends = [crop.min, crop.max];
    let corner = |index: usize| world(std::array::from_fn(|axis| ends[index >> axis & 1][axis]));
    for axis in 0..3 {
        for index in (0..8).filter(|index| index >> axis & 1 == 0) {
            line(ui, [index, index | 1 << axis].map(|index| at(placed, picture, corner(index))));
        }
    }
    let mut is_dragged = false;
    for axis in 0..3 {
        for (end, side) in ["low", "high"].into_iter().enumerate() {
            let mut shares: [f32; 3] = std::array::from_fn(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
            shares[axis] = ends[end][axis];
            let face = world(shares);
            let Some(place) = at(placed, picture, face) else { continue };
            let delta = handle(ui, place, &format!("Crop {} {side}", AXES[axis]));
            if delta == Vec2::ZERO {
                continue;
            }
            let Some(moved) = moved(placed, picture, [face, edges[axis]], delta) else { continue };
            is_dragged = true;
            if end == 0 {
                crop.min[axis] = (crop.min[axis] + moved).min(crop.max[axis] - THINNEST).max(0.0);
            } else {
                crop.max[axis] = (crop.max[axis] + moved).max(crop.min[axis] + THINNEST).min(1.0);
            }
        }
    }
    if is_dragged {
        scene.crop = Some(crop);
    }
}

/// A handle of each clipping plane, which moves it along its normal.
fn planes(ui: &mut Ui, placed: &Placed, picture: Rect, scene: &mut Scene) {
    let corners = placed.bounds.corners();
    let centre = corners.iter().sum::<DVec3>() / 8.0;
    let size = (corners[7] - corners[0]).length();
    for (index, clip) in scene.clip.iter_mut().enumerate() {
        let Some(normal) = DVec3::from_array(clip.normal.map(f64::from)).try_normalize() else { continue };
        let middle = centre + normal * f64::from(clip.offset);
        // A cross in the plane, and its normal.
        let [across, along] = normal.any_orthonormal_pair().into();
        for direction in [across, along] {
            line(ui, [-0.25, 0.25].map(|share| at(placed, picture, middle + direction * (share * size))));
        }
        line(ui, [middle, middle + normal * (0.1 * size)].map(|end| at(placed, picture, end)));
        let Some(place) = at(placed, picture, middle) else { continue };
        let delta = handle(ui, place, &format!("Clipping plane {}", index + 1));
        if delta != Vec2::ZERO
            && let Some(moved) = moved(placed, picture, [middle, normal * size], delta)
        {
            let half = 0.5 * size as f32;
            clip.offset = (clip.offset + moved * size as f32).clamp(-half, half);
        }
    }
}
