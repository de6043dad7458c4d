//! The live window of Vitrum.

pub mod panels;
pub mod transfer_editor;
