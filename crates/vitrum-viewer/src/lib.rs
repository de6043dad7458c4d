//! The live window of Vitrum: open a volume, turn it, shape light and matter, keep the picture.
//!
//! [`Viewer`] is the window's contents, without a window: tests run it as it is. [`Worker`](worker::Worker) is the thread that renders; everything that its
//! pictures depend on is a [`vitrum::scene::Scene`], so that a saved scene gives the picture in the window, to the last bit.

mod chooser;
pub mod document;
mod history;
mod light_ball;
mod loader;
mod measure;
pub mod navigation;
pub mod panels;
mod scene_history;
mod session;
pub mod transfer_editor;
mod trouble;
pub mod viewer;
pub mod worker;

pub use loader::Request;
pub use measure::measure;
pub use session::Session;
pub use trouble::Trouble;
pub use viewer::{Options, Viewer};
