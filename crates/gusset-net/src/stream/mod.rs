//! Nets as bytes: compact streams (Deryagin, "transfer of information in various systems").
//!
//! A stream consists of, all numbers little-endian:
//!
//! | part | bytes | what |
//! |---|---|---|
//! | header | 128 | magic, version, mode, sizes, grid of levels, checksums ([`StreamInfo`]) |
//! | stream_structure | as in the header | topology (sides in a byte, or contracted links in runs; seams) and bridges |
//! | table | 12 a block | size (8) and CRC-32 (4) of each block |
//! | blocks | as in the table | coordinates of some rows each |
//!
//! * [`Mode::Raw`]: X, Y and Z of the rows of a block, row after row without gaps, each at a
//!   multiple of 64 bytes of the stream. One block by default: the three matrices, ready for memory
//!   mapping.
//! * [`Mode::Quantised`]: each coordinate is the nearest level `origin + k * step`; decoding gives
//!   exactly that number, computed in double precision by one multiplication and one addition and
//!   rounded to the scalar type. The step is the extent of the bounding box (its longest side, or
//!   that of each axis) over the number of levels less one, or the larger intrinsic step of the
//!   coordinates. Missing nodes become three quiet NaN.
//! * [`Mode::Lossless`]: every bit is restored, those of NaN too.
//!
//! In the last two modes only the smallest node of each class is stored; decoding copies it bit for
//! bit (lossless: only if the class is equal bit for bit). Coordinates are predicted linearly from
//! their neighbours and from the errors of the node's other coordinates, with weights fitted to
//! each block and stored with it; residuals are range coded by adaptive models in the context of
//! neighbouring residuals. Blocks are independent, so that they can be coded in parallel, sent one
//! at a time, and decoded as they arrive ([`StreamDecoder`]).

mod block;
mod bytes;
mod coder;
mod fit;
mod header;
mod levels;
mod predict;
mod quantise;
mod raw;
mod read;
mod residuals;
mod rows;
mod stream_structure;
mod symbol_model;
mod write;

pub use header::{HEADER_SIZE, Mode, StreamInfo};
pub use read::{StreamDecoder, decode, decode_within};
pub use write::{StreamOptions, encode};
