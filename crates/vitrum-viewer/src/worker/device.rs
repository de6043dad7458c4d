//! Opening the device that pictures are made on.

use super::Reply;
use super::request::Wake;
use std::sync::mpsc::Sender;
use vitrum::backend::{self, Backend, BackendError, Choice, GpuOptions};
use vitrum::{Assets, Renderer};

/// Options of the rendering device.
#[derive(Debug, Clone, Default)]
pub struct DeviceOptions {
    /// A part of the graphics adapter's name; the best one if absent.
    pub adapter: Option<String>,
    /// Threads on the CPU; all of them if absent.
    pub threads: Option<usize>,
}

impl DeviceOptions {
    /// Opens a renderer of `assets`. Where the device fails later, or `Auto` finds one that cannot be opened, the CPU takes over, and a note says so.
    ///
    /// # Errors
    /// Where the device that is asked for cannot be opened.
    pub(super) fn renderer(
        &self,
        choice: Choice,
        assets: &Assets,
        notes: (Sender<Reply>, Wake),
    ) -> Result<Renderer, BackendError> {
        let threads = self.threads;
        let take_over = move |failure: &BackendError| -> Result<Box<dyn Backend>, BackendError> {
            let cpu = backend::open(Choice::Cpu, &GpuOptions::default(), threads)?;
            let (replies, wake) = &notes;
            // Without a window there is nobody to tell.
            let _ = replies.send(Reply::Note(format!("{failure}; the CPU renders instead")));
            wake();
            Ok(cpu)
        };
        let options = GpuOptions::new(self.adapter.as_deref());
        let backend = match backend::open(choice, &options, threads) {
            Err(failure) if choice == Choice::Auto && failure.is_device_error() => take_over(&failure)?,
            opened => opened?,
        };
        let falls_back = backend.name() != "cpu";
        let renderer = Renderer::new(backend, assets.clone());
        Ok(if falls_back { renderer.with_fallback(Box::new(take_over)) } else { renderer })
    }
}
