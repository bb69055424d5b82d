//! Nets as bytes: compact streams (study of the paper's model, "transfer of information in various systems").
//!
//! A stream is, all numbers little-endian:
//!
//! | part | bytes | what |
//! |---|---|---|
//! | header | 128 | magic, version, mode, sizes, grid of levels, checksums ([`StreamInfo`]) |
//! | structure | as said in the header | topology (sides in a byte, or contracted links in runs; seams) and bridges |
//! | table | 12 a block | size (8) and CRC-32 (4) of each block |
//! | blocks | as said in the table | coordinates of some rows each |
//!
//! * [`Mode::Raw`]: X, Y and Z of the rows of a block, each row after row without gaps, each beginning at a multiple of 64 bytes
//!   of the stream. By default there is one block: the three matrices, for whoever maps the file into memory.
//! * [`Mode::Quantised`]: each coordinate is the level k of `origin + k * step` nearest to it; decoding gives exactly that number,
//!   computed in double precision by one multiplication and one addition, rounded to the type of the coordinates. The step is
//!   the extent of the bounding box (its longest side, or each axis' own) by the number of levels less one, or the larger step
//!   that the coordinates have of their own. Missing nodes become three quiet NaN.
//! * [`Mode::Lossless`]: every bit comes back, those of NaN too.
//!
//! In the last two modes nodes that are glued to others are not stored; decoding gives them the coordinates of the smallest
//! node of their class, bit for bit (lossless: only if they have them). Coordinates are predicted linearly from their neighbours and
//! from how wrong the predictions of the node's other coordinates were, with weights fitted to each block and stored with
//! it; residuals are coded by a range coder with adaptive models chosen by the residuals around. Blocks are coded independently
//! of each other, so that they can be coded in parallel, sent one at a time, and decoded as they come ([`StreamDecoder`]).

mod block;
mod bytes;
mod coder;
mod fit;
mod header;
mod levels;
mod model;
mod predict;
mod quantise;
mod raw;
mod read;
mod rows;
mod structure;
mod write;

pub use header::{HEADER_SIZE, Mode, StreamInfo};
pub use read::{StreamDecoder, decode};
pub use write::{StreamOptions, encode};
