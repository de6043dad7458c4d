//! Step 3: spirv-val and spirv-opt.

use anyhow::{Context, Result, anyhow};
use spirv_tools::TargetEnv;
use spirv_tools::opt::{Optimizer as _, Passes};
use spirv_tools::val::Validator as _;

/// Validates, optimises for speed, validates again.
pub fn optimise(words: &[u32]) -> Result<Vec<u32>> {
    validate(words).context("spirv-val refuses what rust-gpu made")?;
    let mut optimiser = spirv_tools::opt::create(Some(TargetEnv::Vulkan_1_2));
    // Debug information holds sources and paths: not reproducible from machine to machine.
    optimiser.register_pass(Passes::StripDebugInfo);
    optimiser.register_performance_passes();
    let mut messages = Vec::new();
    let optimised = optimiser
        .optimize(words, &mut |message: spirv_tools::error::Message| messages.push(message.message), None)
        .map_err(|error| anyhow!("spirv-opt: {error}; {messages:?}"))?;
    let optimised = optimised.as_words().to_vec();
    validate(&optimised).context("spirv-val refuses what spirv-opt made")?;
    Ok(optimised)
}

fn validate(words: &[u32]) -> Result<()> {
    spirv_tools::val::create(Some(TargetEnv::Vulkan_1_2)).validate(words, None).map_err(|error| anyhow!("{error}"))
}
