//! The device flags, and the renderer that they open.

use crate::complete;
use crate::failure::{Failure, Status};
use crate::volume::ByteCount;
use clap::{Args, ValueEnum};
use vitrum::backend::{self, Backend, BackendError, Choice, GpuOptions, Threads};
use vitrum::scene::Scene;
use vitrum::{Assets, Renderer};

/// Where the work is done.
#[derive(Debug, Args)]
pub struct DeviceArguments {
    /// Where to render; auto takes a hardware GPU if there is one, else the CPU
    #[arg(long, value_enum, default_value_t = BackendName::Auto)]
    pub backend: BackendName,

    /// Take the GPU whose name has this text in it (`vitrum devices` lists them), software or not
    #[arg(long, value_name = "SUBSTRING", add = complete::adapters())]
    pub adapter: Option<String>,

    /// On a GPU, translate the kernels by naga even where the driver takes their SPIR-V as it is, as Metal and Direct3D 12 always do
    #[arg(long)]
    pub translate_shaders: bool,

    /// CPU threads; all cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

/// What a volume may take of the device.
#[derive(Debug, Args)]
pub struct MemoryArguments {
    /// Most memory of the device for voxels at once, such as 512MiB; larger volumes are streamed, as are those that are larger than the device allows
    #[arg(long, value_name = "SIZE")]
    pub memory_limit: Option<ByteCount>,
}

impl MemoryArguments {
    /// Fails where a scene's voxels cannot be streamed.
    pub fn check(&self, scene: &Scene) -> Result<(), Failure> {
        if self.memory_limit.is_none() || scene.method.capabilities().streaming {
            return Ok(());
        }
        let message = "--memory-limit is for volumes, and rays go through a mesh whose voxels are all there at once";
        let help = "leave it out and lower `voxelization.resolution`, or set `method = \"sweep\"`";
        Err(Failure::new(Status::WrongUse, message.to_owned(), help))
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum BackendName {
    Auto,
    Cpu,
    Gpu,
}

impl From<BackendName> for Choice {
    fn from(name: BackendName) -> Self {
        match name {
            BackendName::Auto => Self::Auto,
            BackendName::Cpu => Self::Cpu,
            BackendName::Gpu => Self::Gpu,
        }
    }
}

/// Names of the GPUs that are here.
pub fn adapter_names() -> Vec<String> {
    backend::devices().into_iter().filter(|device| device.backend == "gpu").map(|device| device.name).collect()
}

impl DeviceArguments {
    /// Binds all of the program's work to `--threads`; to be called before any.
    pub fn limit_threads(&self) -> Result<(), Failure> {
        Ok(self.threads.map_or(Ok(()), |threads| Threads::limit_process(usize::from(threads)))?)
    }

    /// Opens the device.
    pub fn open(&self) -> Result<Box<dyn Backend>, BackendError> {
        let options = GpuOptions {
            adapter: self.adapter.clone(),
            translate_shaders: self.translate_shaders,
            ..GpuOptions::default()
        };
        backend::open(self.backend.into(), &options, self.threads.map(usize::from))
    }

    /// Opens the device for a renderer of `assets`, and says which it is unless `quiet`.
    ///
    /// Where `auto` chose a GPU by itself, the CPU takes over if that cannot be opened or fails.
    pub fn renderer(&self, assets: &Assets, memory: &MemoryArguments, quiet: bool) -> Result<Renderer, Failure> {
        let threads = self.threads.map(usize::from);
        let limit = memory.memory_limit.map(|ByteCount(bytes)| bytes);
        let by_itself = self.backend == BackendName::Auto && self.adapter.is_none();
        let take_over = move |failure: &BackendError| {
            let mut cpu = backend::open(Choice::Cpu, &GpuOptions::default(), threads)?;
            cpu.set_volume_limit(limit);
            if !quiet {
                eprintln!("warning: {failure}; rendering on {} ({}) instead", cpu.name(), cpu.adapter());
            }
            Ok(cpu)
        };
        let mut backend = match self.open() {
            Err(failure) if by_itself && failure.is_device_error() => take_over(&failure)?,
            opened => opened?,
        };
        backend.set_volume_limit(limit);
        if !quiet {
            eprintln!("rendering on {} ({})", backend.name(), backend.adapter());
        }
        let falls_back = by_itself && backend.name() != "cpu";
        let renderer = Renderer::new(backend, assets.clone());
        Ok(if falls_back { renderer.with_fallback(Box::new(take_over)) } else { renderer })
    }
}
