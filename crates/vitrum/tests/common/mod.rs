//! The CPU backend under watch: a test sees each call, and may fail it.

// Each test program uses a part of this.
#![allow(dead_code)]

use std::ops::Range;
use std::path::Path;
use vitrum::backend::{Backend, BackendError, Buffer, Contents, CpuBackend, PassList};
use vitrum::scene::Scene;
use vitrum::{Assets, builtin};

/// Sees the calls of a backend before they are carried out, and fails a call by an error.
pub trait Watch: Send {
    /// The most bytes that the card allows in one buffer.
    fn largest_buffer(&self) -> u64 {
        u64::MAX
    }

    /// A buffer is made.
    fn creates(&mut self, _contents: &Contents<'_>) -> Result<(), BackendError> {
        Ok(())
    }

    /// Called for a write of `_words` words to a buffer.
    fn writes(&mut self, _words: usize) -> Result<(), BackendError> {
        Ok(())
    }

    /// Passes run: with an error, only so many of them run before it.
    fn runs(&mut self, _passes: &PassList) -> Result<(), (usize, BackendError)> {
        Ok(())
    }

    /// A part of a buffer is read.
    fn reads(&mut self) -> Result<(), BackendError> {
        Ok(())
    }
}

/// A CPU backend in the role of a card, under watch.
pub struct Watched<W> {
    pub cpu: CpuBackend,
    pub watch: W,
}

impl<W> Watched<W> {
    pub fn new(watch: W) -> Self {
        Self { cpu: cpu(), watch }
    }
}

impl<W: Watch> Backend for Watched<W> {
    fn name(&self) -> &'static str {
        "gpu"
    }

    fn adapter(&self) -> String {
        "a card".to_owned()
    }

    fn largest_buffer(&self) -> u64 {
        self.cpu.largest_buffer().min(self.watch.largest_buffer())
    }

    fn create(&mut self, label: &str, contents: Contents<'_>) -> Result<Buffer, BackendError> {
        self.watch.creates(&contents)?;
        self.cpu.create(label, contents)
    }

    fn write(
        &mut self,
        buffer: &Buffer,
        words: usize,
        fill: &mut (dyn FnMut(&mut [u32]) + Send),
    ) -> Result<(), BackendError> {
        self.watch.writes(words)?;
        self.cpu.write(buffer, words, fill)
    }

    fn clear(&mut self, buffer: &Buffer) -> Result<(), BackendError> {
        self.cpu.clear(buffer)
    }

    fn run(&mut self, passes: &PassList, progress: &mut (dyn FnMut(usize) -> bool + Send)) -> Result<(), BackendError> {
        let Err((count, failure)) = self.watch.runs(passes) else { return self.cpu.run(passes, progress) };
        self.cpu.run(&passes.part(0, count), progress)?;
        Err(failure)
    }

    fn read(
        &mut self,
        buffer: &Buffer,
        range: Range<u64>,
        see: &mut (dyn FnMut(&[u8]) + Send),
    ) -> Result<(), BackendError> {
        self.watch.reads()?;
        self.cpu.read(buffer, range, see)
    }

    fn bytes(&self, buffer: &Buffer) -> Result<u64, BackendError> {
        self.cpu.bytes(buffer)
    }

    fn device_bytes(&self) -> Option<u64> {
        Some(self.cpu.buffer_bytes())
    }
}

pub fn cpu() -> CpuBackend {
    CpuBackend::new(Some(1)).expect("a thread")
}

pub fn lost() -> BackendError {
    BackendError::DeviceLost { adapter: "a card".to_owned(), reason: "the driver was reset".to_owned() }
}

/// A built-in scene, small enough to be quick in a debugger.
pub fn small(name: &str) -> (Scene, Assets) {
    let mut scene = builtin::scene(name).expect("it is built in");
    if scene.mesh.is_empty() {
        scene.volume.resolution = Some(16);
    }
    scene.voxelization.resolution = 16;
    scene.shadow.resolution = Some(16);
    (scene.film.width, scene.film.height) = (24, 16);
    let assets = Assets::load(&scene, Path::new("")).expect("it needs no file");
    (scene, assets)
}
