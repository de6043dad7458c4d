//! Step 2: arithmetic that no driver may change.
//!
//! A driver may contract `a · b + c` and an optimiser may turn `x / c` into `x · (1/c)`; rustc does neither. `NoContraction` on
//! every float operation forbids both, and spirv-opt respects it. The memory model becomes GLSL450, which is what wgpu
//! enables; the scope of atomic operations is then the device, where the Vulkan model says queue family.

use anyhow::{Result, anyhow};
use rspirv::binary::Assemble as _;
use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{AddressingModel, Capability, Decoration, MemoryModel, Op, Scope};
use vitrum_shaders::ENTRY_POINT;

/// Whether an operation's float result could be contracted or re-associated.
fn is_float_arithmetic(op: Op) -> bool {
    matches!(
        op,
        Op::FAdd
            | Op::FSub
            | Op::FMul
            | Op::FDiv
            | Op::FNegate
            | Op::FRem
            | Op::FMod
            | Op::VectorTimesScalar
            | Op::MatrixTimesScalar
            | Op::VectorTimesMatrix
            | Op::MatrixTimesVector
            | Op::MatrixTimesMatrix
            | Op::Dot
    )
}

/// The module with every float operation marked `NoContraction`, in the GLSL450 memory model, its entry point named [`ENTRY_POINT`].
pub fn pin(bytes: &[u8]) -> Result<Vec<u32>> {
    let mut module = rspirv::dr::load_bytes(bytes).map_err(|state| anyhow!("not a SPIR-V module: {state:?}"))?;
    module
        .capabilities
        .retain(|capability| !capability.operands.contains(&Operand::Capability(Capability::VulkanMemoryModel)));
    module.extensions.retain(|extension| {
        !extension.operands.contains(&Operand::LiteralString("SPV_KHR_vulkan_memory_model".to_owned()))
    });
    module.memory_model = Some(Instruction::new(
        Op::MemoryModel,
        None,
        None,
        vec![Operand::AddressingModel(AddressingModel::Logical), Operand::MemoryModel(MemoryModel::GLSL450)],
    ));
    widen_scopes(&mut module);
    for operand in module.entry_points.iter_mut().flat_map(|entry_point| &mut entry_point.operands) {
        if let Operand::LiteralString(name) = operand {
            ENTRY_POINT.clone_into(name);
        }
    }
    let results: Vec<u32> = module
        .functions
        .iter()
        .flat_map(|function| &function.blocks)
        .flat_map(|block| &block.instructions)
        .filter(|instruction| is_float_arithmetic(instruction.class.opcode))
        .filter_map(|instruction| instruction.result_id)
        .collect();
    module.annotations.extend(results.into_iter().map(|id| {
        Instruction::new(
            Op::Decorate,
            None,
            None,
            vec![Operand::IdRef(id), Operand::Decoration(Decoration::NoContraction)],
        )
    }));
    Ok(module.assemble())
}

/// Makes the device the scope of every atomic operation that kernels use.
fn widen_scopes(module: &mut Module) {
    let Some(header) = &mut module.header else { return };
    let device = header.bound;
    let mut integer = None;
    for instruction in
        module.functions.iter_mut().flat_map(|function| &mut function.blocks).flat_map(|block| &mut block.instructions)
    {
        use Op::{AtomicIAdd, AtomicLoad, AtomicOr, AtomicStore, AtomicUMax};
        if matches!(instruction.class.opcode, AtomicIAdd | AtomicLoad | AtomicOr | AtomicStore | AtomicUMax) {
            // Operands: pointer, scope, and others; a result has the type of a scope, a 32-bit unsigned integer.
            instruction.operands[1] = Operand::IdScope(device);
            integer = integer.or(instruction.result_type);
        }
    }
    if integer.is_some() {
        header.bound += 1;
        let value = vec![Operand::LiteralBit32(Scope::Device as u32)];
        module.types_global_values.push(Instruction::new(Op::Constant, integer, Some(device), value));
    }
}
