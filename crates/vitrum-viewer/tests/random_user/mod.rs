//! A user who does anything: drags, clicks, turns the wheel and presses keys at random, in a window without a display.

use eframe::egui::{
    Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Ui, vec2,
};
use egui_kittest::Harness;
use std::time::Duration;
use vitrum::backend::Choice;
use vitrum_viewer::worker::DeviceOptions;
use vitrum_viewer::{Options, Viewer};

/// Size of the window, in points.
const SIZE: [f32; 2] = [1000.0, 700.0];

/// Deeds after which another scene is opened, so that no slip goes on for ever.
const DEEDS: u32 = 300;

const INPUTS: [&str; 3] = ["builtin:ball", "builtin:head", "builtin:glass/wine"];

const KEYS: [Key; 18] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Plus,
    Key::Minus,
    Key::Comma,
    Key::Period,
    Key::Home,
    Key::F,
    Key::Num1,
    Key::Num3,
    Key::Num7,
    Key::P,
    Key::Z,
    Key::F1,
    Key::Tab,
    Key::Space,
];

/// Numbers that look random, the same for the same seed.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        // Marsaglia's xorshift.
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % end
    }

    fn place(&mut self) -> Pos2 {
        let [x, y] = SIZE.map(|edge| self.below(edge as u64) as f32);
        Pos2::new(x, y)
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }
}

/// The window and its user.
pub struct RandomUser {
    window: Harness<'static, Option<Viewer>>,
    random: Random,
    deeds: u32,
}

impl RandomUser {
    /// A user of a window with pictures of 64 × 48 pixels, whose deeds follow from `seed`.
    pub fn new(seed: u64) -> Self {
        let show = move |ui: &mut Ui, viewer: &mut Option<Viewer>| {
            let options = || Options {
                input: Some(INPUTS[0].to_owned()),
                backend: Choice::Cpu,
                device: DeviceOptions { threads: Some(1), ..DeviceOptions::default() },
                size: Some([64, 48]),
                ..Options::default()
            };
            viewer.get_or_insert_with(|| Viewer::new(options(), ui.ctx()).expect("a thread")).ui(ui);
        };
        let window = Harness::builder().with_size(vec2(SIZE[0], SIZE[1])).build_ui_state(show, None);
        Self { window, random: Random(seed | 1), deeds: 0 }
    }

    /// The window's contents.
    pub fn viewer(&mut self) -> &mut Viewer {
        self.window.state_mut().as_mut().expect("the first frame made it")
    }

    /// Opens a scene, and waits until its picture is complete.
    pub fn rest(&mut self, input: &str) {
        self.viewer().open(input);
        loop {
            self.window.step();
            let viewer = self.viewer();
            let is_open = viewer.document().is_some_and(|document| document.input == input);
            let is_complete = viewer.standing().is_some_and(|standing| standing.complete);
            if is_open && is_complete && !viewer.is_waiting() && !viewer.is_sketching() && !viewer.is_loading() {
                return;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// Does something.
    pub fn act(&mut self) {
        self.deeds += 1;
        let modifiers = self.random.of(&[Modifiers::NONE, Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND]);
        match self.random.below(8) {
            0..=2 => self.drag(modifiers),
            3..=4 => {
                let place = self.random.place();
                self.press(place, PointerButton::Primary, modifiers, true);
                self.press(place, PointerButton::Primary, modifiers, false);
            }
            5 => {
                let place = self.random.place();
                self.window.hover_at(place);
                let delta = vec2(0.0, self.random.below(200) as f32 - 100.0);
                let (unit, source, phase) = (MouseWheelUnit::Point, MouseWheelSource::Unknown, TouchPhase::Move);
                self.window.event(Event::MouseWheel { unit, source, delta, phase, modifiers });
                self.window.step();
            }
            _ => {
                let key = self.random.of(&KEYS);
                self.window.key_press_modifiers(modifiers, key);
                self.window.step();
            }
        }
        // No deed of this user in a dialog: it would write files.
        if self.viewer().has_dialog() {
            self.window.key_press(Key::Escape);
            self.window.step();
            self.viewer().close_dialog();
        }
        if self.deeds.is_multiple_of(DEEDS) || self.viewer().document().is_none() && !self.viewer().is_loading() {
            let input = self.random.of(&INPUTS);
            self.viewer().open(input);
            self.window.step();
        }
    }

    fn drag(&mut self, modifiers: Modifiers) {
        let button = self.random.of(&[PointerButton::Primary, PointerButton::Primary, PointerButton::Secondary]);
        let start = self.random.place();
        let by = vec2(self.random.below(240) as f32 - 120.0, self.random.below(240) as f32 - 120.0);
        self.press(start, button, modifiers, true);
        for part in 1..=4_u8 {
            self.window.hover_at(start + by * f32::from(part) / 4.0);
            self.window.step();
        }
        self.press(start + by, button, modifiers, false);
    }

    fn press(&mut self, pos: Pos2, button: PointerButton, modifiers: Modifiers, pressed: bool) {
        self.window.hover_at(pos);
        self.window.event_modifiers(Event::PointerButton { pos, button, pressed, modifiers }, modifiers);
        self.window.step();
    }
}
