//! Vitrum's kernels, each written once: rust-gpu compiles them to SPIR-V, and the same functions run on the CPU.
//!
//! - [`abi`] is what host and kernels share: uniforms, record layouts, table layouts.
//! - [`math`], [`field`] and [`optics`] are the building blocks.
//! - [`sweep`] holds the kernels of Magnus & Bruckner 2017, one file a kernel.
//! - [`voxelize`] holds those that turn triangles into voxels.
//! - [`voxels`] holds those that follow rays through a mesh, clear and opaque, as voxels or as triangles.
//! - [`shadow`] holds those that find how much light gets to where in a mesh.
//! - [`beams`] holds those that follow light through meshes into a scattering medium (Hu et al. 2010).
//! - [`probe`] applies building blocks by themselves, for the conformance suite.
//! - [`kernel`] is the one place where a kernel is declared; the SPIR-V entry points and the CPU dispatch come from it.
//!
//! A kernel maps an index (x, y) to a record of floats. It reads uniforms and whole buffers, it has no side effects, and
//! its arithmetic is `+ − × ÷`, `sqrt`, comparisons and integers, so that both backends give the same bits.
#![cfg_attr(target_arch = "spirv", no_std)]

pub mod abi;
pub mod beams;
pub mod field;
pub mod kernel;
pub mod math;
pub mod optics;
pub mod probe;
pub mod shadow;
pub mod sweep;
pub mod voxelize;
pub mod voxels;

pub use spirv_std::glam;
