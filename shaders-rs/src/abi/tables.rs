//! Layout of the transfer function tables: one buffer of words.
//!
//! First the preintegration table over (front scalar, back scalar), [`SEGMENT_SIZE`]² entries of four words, each word two
//! half floats; then η over the scalar, [`IOR_SIZE`] floats.

/// Entries along each axis of the preintegration table.
pub const SEGMENT_SIZE: u32 = 256;
/// Words in an entry: (τ, κr), (κg, κb), (qr, qg), (qb, τ), the first of a pair in the low half. Light needs the first two words,
/// a viewing ray where there is no medium the last two.
///
/// τ is the particles' optical depth over the reference length, κ the medium's for each colour, q = τ · colour.
pub const SEGMENT_WORDS: u32 = 4;
/// The stored halves are multiplied by 2^[`SEGMENT_EXPONENT`]: keeps small optical depths out of the denormals.
pub const SEGMENT_EXPONENT: u32 = 10;
/// The largest optical depth that is stored (transmittance 2e-9).
pub const MAX_OPTICAL_DEPTH: f32 = 20.0;
/// Entries of the η table.
pub const IOR_SIZE: u32 = 1025;
/// Where the η table starts, in words.
pub const IOR_OFFSET: u32 = SEGMENT_SIZE * SEGMENT_SIZE * SEGMENT_WORDS;
/// Words of the whole buffer.
pub const WORDS: u32 = IOR_OFFSET + IOR_SIZE;
