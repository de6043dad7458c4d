//! The light on a ball, which is dragged.

use eframe::egui::{Color32, Pos2, Response, Role, Sense, Stroke, Ui, Vec2, WidgetInfo, epaint::Mesh, pos2, vec2};

/// Radius of the ball, in points.
const RADIUS: f32 = 44.0;

/// Circles of the ball's shading.
const RINGS: u16 = 14;

/// Corners of a circle.
const CORNERS: u16 = 40;

/// Shows a ball lit from `azimuth` and `elevation` in degrees, from the camera; the response's drag turns the light.
pub fn show(ui: &mut Ui, azimuth: f32, elevation: f32) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(2.0 * RADIUS + 4.0), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, "Direction of the light"));
    let [(sin_a, cos_a), (sin_e, cos_e)] = [azimuth, elevation].map(|angle| libm::sincosf(angle.to_radians()));
    // Towards the light: right, up, to the viewer.
    let light = [sin_a * cos_e, sin_e, cos_a * cos_e];
    ui.painter().add(ball(rect.center(), light));
    let dark = ui.visuals().dark_mode;
    let outline = if dark { Color32::from_gray(90) } else { Color32::from_gray(140) };
    let width = if response.hovered() || response.dragged() { 2.0 } else { 1.0 };
    ui.painter().circle_stroke(rect.center(), RADIUS, Stroke::new(width, outline));
    let spot = rect.center() + vec2(light[0], -light[1]) * RADIUS * 0.94;
    let filled = if light[2] >= 0.0 { Color32::from_rgb(255, 214, 90) } else { Color32::TRANSPARENT };
    ui.painter().circle(spot, 5.0, filled, Stroke::new(1.5, Color32::from_rgb(160, 110, 0)));
    response.on_hover_text("Drag to turn the light. A hollow mark shines from behind.")
}

/// The points that a drag moves over, in radii of the ball.
pub fn in_radii(delta: Vec2) -> [f32; 2] {
    [delta.x / RADIUS, delta.y / RADIUS]
}

/// A ball with diffuse shading.
fn ball(centre: Pos2, light: [f32; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    let shade = |normal: [f32; 3]| {
        let facing: f32 = normal.iter().zip(light).map(|(n, l)| n * l).sum();
        let value = 0.14 + 0.8 * facing.max(0.0).sqrt();
        Color32::from_gray((value.min(1.0) * 255.0) as u8)
    };
    mesh.colored_vertex(centre, shade([0.0, 0.0, 1.0]));
    for ring in 1..=RINGS {
        // Rings of equal angles: the ball's edge is as smooth as its middle.
        let (across, towards) = libm::sincosf(f32::from(ring) / f32::from(RINGS) * std::f32::consts::FRAC_PI_2);
        for corner in 0..CORNERS {
            let (y, x) = libm::sincosf(f32::from(corner) / f32::from(CORNERS) * std::f32::consts::TAU);
            let normal = [x * across, y * across, towards];
            let at = pos2(centre.x + normal[0] * RADIUS, centre.y - normal[1] * RADIUS);
            mesh.colored_vertex(at, shade(normal));
        }
    }
    let index = |ring: u16, corner: u16| match ring {
        0 => 0,
        _ => u32::from(1 + (ring - 1) * CORNERS + corner % CORNERS),
    };
    for ring in 0..RINGS {
        for corner in 0..CORNERS {
            let [a, b] = [index(ring, corner), index(ring, corner + 1)];
            let [c, d] = [index(ring + 1, corner), index(ring + 1, corner + 1)];
            mesh.add_triangle(a, c, d);
            if ring > 0 {
                mesh.add_triangle(a, d, b);
            }
        }
    }
    mesh
}
