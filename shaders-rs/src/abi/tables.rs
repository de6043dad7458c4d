//! Layout of the transfer function tables: one buffer of words.
//!
//! First the preintegration table over (front scalar, back scalar), [`SEGMENT_SIZE`]² entries of four words, each word two
//! half floats; then η over the scalar: three floats ([`IOR_LEAST`], [`IOR_STEP`], [`IOR_RISE`]) and [`IOR_CELLS`] words; then the
//! abscissae of both, [`SEGMENT_ABSCISSA`] and [`IOR_ABSCISSA`]; then the isosurfaces, [`ISOSURFACES`] and [`SHEETS`].
//!
//! An abscissa turns a scalar into a place in a table, in entries: a sum of pieces, each of which rises in a straight line over its part of the
//! scalars, and is constant before and behind it. Three floats a piece: where it starts, entries per scalar, entries; then two floats,
//! [`EXTENT_WORDS`], where the first piece starts and the last one ends. Beyond, the functions are constant.

/// Entries along each axis of the preintegration table.
pub const SEGMENT_SIZE: u32 = 256;
/// Words in an entry: (κg, κb), (κr, τ), (m, qr), (qg, qb), the first of a pair in the low half. Light needs the first two words, or where there
/// is no medium the second one; a viewing ray where there is no medium the last three.
///
/// τ is the particles' optical depth over the reference length, κ the medium's for each colour, q = τ · colour, m the first moment of τ along the segment:
/// τ times the mean place of particles, 0 at the front and 1 at the back.
pub const SEGMENT_WORDS: u32 = 4;
/// The stored halves are multiplied by 2^[`SEGMENT_EXPONENT`]: keeps small optical depths out of the denormals.
pub const SEGMENT_EXPONENT: u32 = 10;
/// The largest optical depth that is stored (transmittance 2e-9).
pub const MAX_OPTICAL_DEPTH: f32 = 20.0;
/// Where the least η stands, in words.
pub const IOR_LEAST: u32 = SEGMENT_SIZE * SEGMENT_SIZE * SEGMENT_WORDS;
/// Where the unit of the levels stands: η at a cell's beginning is the least one and so many of them.
pub const IOR_STEP: u32 = IOR_LEAST + 1;
/// Where the unit of the rises stands: how much larger η is at a cell's end.
pub const IOR_RISE: u32 = IOR_LEAST + 2;
/// Where the η table starts, in words.
pub const IOR_OFFSET: u32 = IOR_LEAST + 3;
/// Cells of the η table, over its abscissa. One word each, since a scattered read takes longer than what takes it apart: the level
/// in the upper [`IOR_LEVEL_BITS`] bits, in the lower ones the rise plus [`IOR_NO_RISE`].
pub const IOR_CELLS: u32 = 1024;
/// Bits of a level.
pub const IOR_LEVEL_BITS: u32 = 20;
/// The number of a cell without any rise.
pub const IOR_NO_RISE: u32 = 1 << (31 - IOR_LEVEL_BITS);
/// Words of a piece of an abscissa.
pub const PIECE_WORDS: u32 = 3;
/// Words of the two ends of an abscissa.
pub const EXTENT_WORDS: u32 = 2;
/// Pieces of the abscissa of the preintegration table. Pieces that are not needed start at [`f32::MAX`] and add nothing.
pub const SEGMENT_PIECES: u32 = 8;
/// Pieces of the abscissa of the η table.
pub const IOR_PIECES: u32 = 4;
/// Where the abscissa of the preintegration table stands, in words.
pub const SEGMENT_ABSCISSA: u32 = IOR_OFFSET + IOR_CELLS;
/// Where the abscissa of the η table stands, in words. Its ends are a rounding farther apart than the pieces', so that the scalars at the
/// pieces' ends have the slopes of these.
pub const IOR_ABSCISSA: u32 = SEGMENT_ABSCISSA + SEGMENT_PIECES * PIECE_WORDS + EXTENT_WORDS;
/// The most isosurfaces.
pub const MOST_ISOSURFACES: u32 = 8;
/// Where the normalised scalars of the isosurfaces stand, in words, ascending; [`f32::MAX`] for those that there are not.
pub const ISOSURFACES: u32 = IOR_ABSCISSA + IOR_PIECES * PIECE_WORDS + EXTENT_WORDS;
/// Where the sheets of isosurfaces stand, in words: ([`MOST_ISOSURFACES`] + 1)² of them, by the number of isosurfaces with values up to the scalar at a segment's
/// front, and to that at its back.
pub const SHEETS: u32 = ISOSURFACES + MOST_ISOSURFACES;
/// Words of a sheet, floats: transmittance and optical depth of the isosurfaces between the two; then their colours' red, green and blue and their
/// scalar, means, each weighted by what is seen of it from the front.
pub const SHEET_WORDS: u32 = 6;
/// Words of the whole buffer.
pub const WORDS: u32 = SHEETS + (MOST_ISOSURFACES + 1) * (MOST_ISOSURFACES + 1) * SHEET_WORDS;
