//! Nets as bytes: compact streams (Deryagin, "transfer of information in various systems").
//!
//! A stream consists of these parts; all numbers are little-endian:
//!
//! | part | bytes | content |
//! |---|---|---|
//! | header | 128 | magic, version, mode, sizes, grid of levels, checksums ([`StreamInfo`]) |
//! | structure | as in the header | topology (sides in a byte, or contracted links in runs; seams) and bridges |
//! | table | 12 a block | size (8) and CRC-32 (4) of each block |
//! | blocks | as in the table | coordinates of some rows each |
//!
//! - [`StreamMode::Raw`]: X, Y and Z of the rows of a block, row after row without gaps, each at a
//!   multiple of 64 bytes of the stream. One block by default: the three matrices, ready for memory
//!   mapping.
//! - [`StreamMode::Quantised`]: each coordinate is the nearest level `origin + k * step`. Decoding
//!   computes exactly that number in double precision, by one multiplication and one addition, and
//!   rounds it to the scalar type. The step is the extent of the bounding box (its longest side, or
//!   each axis's own) over the number of levels minus one. If the coordinates have a larger
//!   intrinsic step, that one is used. The caller may give the levels instead, so that tiles coded
//!   apart stay equal where they meet ([`LevelBox`]). Missing nodes become three quiet NaN.
//! - [`StreamMode::Lossless`]: every bit is restored, including NaN payloads.
//!
//! The last two modes store only the smallest node of each class. Decoding copies it bit for bit
//! (in lossless mode only if the class is equal bit for bit). Coordinates are predicted linearly
//! from their neighbours and from the errors of the node's other coordinates. The weights are
//! fitted to each block and stored with it. Residuals are range coded by adaptive models in the
//! context of neighbouring residuals. Blocks are independent, so they can be coded in parallel,
//! sent one at a time, and decoded as they arrive ([`StreamDecoder`]).
//!
//! A scene has a stream of its own, which contains the streams of its nets ([`encode_scene`](crate::scene::encode_scene)).

mod block;
pub(crate) mod bytes;
mod coder;
mod coordinate_rows;
mod header;
mod levels;
mod predictor;
mod predictor_fit;
mod quantise;
mod raw_block;
mod read;
mod residuals;
mod row_coder;
mod stream_structure;
mod symbol_model;
mod write;

pub use header::{HEADER_SIZE, StreamInfo, StreamMode};
pub use quantise::LevelBox;
pub use read::{StreamDecoder, decode, decode_within};
pub use write::{StreamOptions, encode};
