//! Rendering methods: what becomes of a scene before a backend sees it.

pub mod sweep;
