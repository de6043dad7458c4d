//! The kernels' SPIR-V in the languages of interfaces that take none: WGSL, Metal's and Direct3D's.
//!
//! The course is that of wgpu's own translation, and of crate `vitrum` where shaders are translated: naga reads SPIR-V, what the entry
//! point does not reach is removed, the rest is validated with no capability beyond those that every device has.

mod error;
mod shorten;

pub use error::TranslationError;

use naga::back::{hlsl, msl, wgsl};
use naga::compact::{KeepUnused, compact};
use naga::front::{spv, wgsl as wgsl_front};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, WithSpan};

/// A kernel's module in naga's intermediate representation, valid on every device.
#[derive(Debug)]
pub struct Translation {
    module: Module,
    info: ModuleInfo,
}

impl Translation {
    /// Reads a module of one entry point in SPIR-V.
    ///
    /// # Errors
    /// If naga cannot read it, or it needs a capability.
    pub fn of_spirv(bytes: &[u8]) -> Result<Self, TranslationError> {
        let options = spv::Options { adjust_coordinate_space: false, ..spv::Options::default() };
        let mut module = spv::parse_u8_slice(bytes, &options).map_err(|error| TranslationError::Read(chain(&error)))?;
        // rust-gpu leaves types behind that hold pointers, and naga allows none.
        compact(&mut module, KeepUnused::No);
        let info = validate(&module)?;
        Ok(Self { module, info })
    }

    /// The module in WGSL, which naga's reader of WGSL finds valid.
    ///
    /// # Errors
    /// If the module cannot be written in WGSL.
    pub fn wgsl(&self) -> Result<String, TranslationError> {
        let written = wgsl::write_string(&self.module, &self.info, wgsl::WriterFlags::empty());
        let text = shorten::shorten(&written.map_err(|error| TranslationError::Write("WGSL", error.to_string()))?);
        let read = wgsl_front::parse_str(&text).map_err(|error| TranslationError::Read(error.emit_to_string(&text)))?;
        validate(&read)?;
        Ok(text)
    }

    /// The module in the Metal Shading Language, version 2.4 (macOS 12, iOS 15).
    ///
    /// # Errors
    /// If the module cannot be written in that language.
    pub fn msl(&self) -> Result<String, TranslationError> {
        let options = msl::Options { lang_version: (2, 4), fake_missing_bindings: true, ..msl::Options::default() };
        let written = msl::write_string(&self.module, &self.info, &options, &msl::PipelineOptions::default());
        written.map(|(text, _)| text).map_err(|error| TranslationError::Write("MSL", error.to_string()))
    }

    /// The module in Direct3D's language, shader model 6.0.
    ///
    /// # Errors
    /// If the module cannot be written in that language.
    pub fn hlsl(&self) -> Result<String, TranslationError> {
        let options = hlsl::Options {
            shader_model: hlsl::ShaderModel::V6_0,
            fake_missing_bindings: true,
            ..hlsl::Options::default()
        };
        let mut text = String::new();
        let written = hlsl::Writer::new(&mut text, &options, &hlsl::PipelineOptions::default())
            .write(&self.module, &self.info, None)
            .map(|_| ());
        written.map(|()| text).map_err(|error| TranslationError::Write("HLSL", error.to_string()))
    }
}

/// Holds a module against what every device has.
fn validate(module: &Module) -> Result<ModuleInfo, TranslationError> {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(module)
        .map_err(|error: WithSpan<_>| TranslationError::Invalid(chain(error.as_inner())))
}

/// An error with its causes.
fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut cause = error.source();
    while let Some(inner) = cause {
        text += &format!(": {inner}");
        cause = inner.source();
    }
    text
}
