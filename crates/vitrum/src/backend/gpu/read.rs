//! Reading of buffers by the host.

use super::adapter::Opened;
use futures_channel::oneshot;

/// A part of a buffer on its way to the host.
pub(super) struct Reading {
    staging: wgpu::Buffer,
    mapped: oneshot::Receiver<Result<(), wgpu::BufferAsyncError>>,
    /// The copy, after which the part can be mapped.
    pub(super) submission: wgpu::SubmissionIndex,
}

impl Reading {
    /// Submits the copy of `bytes` bytes from byte `start` on, behind all that was submitted before.
    pub(super) fn submit(opened: &Opened, source: &wgpu::Buffer, start: u64, bytes: u64) -> Self {
        let staging = opened.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("read back"),
            size: bytes,
            usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let mut encoder = opened.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(source, start, &staging, 0, bytes);
        let submission = opened.queue.submit([encoder.finish()]);
        let (sender, mapped) = oneshot::channel();
        staging.slice(..).map_async(wgpu::MapMode::Read, move |result| {
            // The receiver is gone only if nobody waits for it any more.
            let _ = sender.send(result);
        });
        Self { staging, mapped, submission }
    }

    /// The contents of the part, once the device has been polled up to the submission; or the reason of a failure. A browser polls by
    /// itself.
    pub(super) async fn finish(self) -> Result<Vec<u8>, String> {
        let mapped = self.mapped.await.map_err(|error| error.to_string())?;
        mapped.map_err(|error| error.to_string())?;
        let view = self.staging.slice(..).get_mapped_range().map_err(|error| error.to_string())?;
        Ok(view.to_vec())
    }
}
