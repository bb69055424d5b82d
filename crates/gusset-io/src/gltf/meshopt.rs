//! The decoder of `EXT_meshopt_compression` and `KHR_meshopt_compression`: attributes, triangles and index sequences.
//!
//! Bytes of attributes are differences to the previous element, packed by groups of 16. Triangles refer to recent edges and vertices.
//! Both extensions specify the bytes in their appendices. All reads are checked: `None` means that the bytes are not valid.

use super::meshopt_filters::{Filter, apply_filter};
use crate::error::ReadError;
use crate::json_tape::Value;

/// Content of a compressed view.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Attributes,
    Triangles,
    Indices,
}

/// How a view is compressed.
pub(super) struct Codec {
    mode: Mode,
    filter: Filter,
    pub(super) count: usize,
    /// Bytes of an element.
    pub(super) stride: usize,
}

impl Codec {
    /// Reads the extension's object. Returns `None` if it is not complete.
    pub(super) fn from_json(json: Value<'_>) -> Option<Self> {
        let mode = json.get("mode")?;
        let mode = [("ATTRIBUTES", Mode::Attributes), ("TRIANGLES", Mode::Triangles), ("INDICES", Mode::Indices)]
            .into_iter()
            .find_map(|(name, kind)| mode.equals_text(name).then_some(kind))?;
        let filter = json.get("filter").map_or(Some(Filter::None), Filter::from_json)?;
        let whole = |name| json.get(name).and_then(Value::whole_number).and_then(|value| usize::try_from(value).ok());
        let (count, stride) = (whole("count")?, whole("byteStride")?);
        let is_valid = match mode {
            Mode::Attributes => stride % 4 == 0 && (4..=256).contains(&stride),
            _ => matches!(stride, 2 | 4),
        };
        is_valid.then_some(Self { mode, filter, count, stride })
    }
}

/// Decodes a view. The caller has checked that memory for `count` elements may be taken.
pub(super) fn decode_view(source: &[u8], codec: &Codec) -> Result<Option<Vec<u8>>, ReadError> {
    let mut made = Vec::new();
    let size = codec.count.checked_mul(codec.stride).ok_or_else(ReadError::out_of_memory)?;
    made.try_reserve_exact(size)?;
    made.resize(size, 0);
    let decoded = match codec.mode {
        Mode::Attributes => decode_attributes(source, codec.stride, &mut made),
        Mode::Triangles => decode_triangles(source, codec.stride, &mut made),
        Mode::Indices => decode_indices(source, codec.stride, &mut made),
    };
    Ok(decoded.map(|()| {
        apply_filter(codec.filter, codec.stride, &mut made);
        made
    }))
}

/// Reads bytes one after the other.
struct Source<'a> {
    bytes: &'a [u8],
    offset: usize,
}

impl<'a> Source<'a> {
    fn read_byte(&mut self) -> Option<u8> {
        let &byte = self.bytes.get(self.offset)?;
        self.offset += 1;
        Some(byte)
    }

    fn take_bytes(&mut self, count: usize) -> Option<&'a [u8]> {
        let taken = self.bytes.get(self.offset..self.offset.checked_add(count)?)?;
        self.offset += count;
        Some(taken)
    }

    /// Reads a number of 7 bits a byte, the lowest ones first.
    fn read_variable_length_number(&mut self) -> Option<u32> {
        let mut value = 0;
        for shift in (0..35).step_by(7) {
            let byte = self.read_byte()?;
            value |= u32::from(byte & 0x7f).checked_shl(shift)?;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }
}

/// Undoes the coding of signed numbers as unsigned ones.
fn unzigzag(value: u32) -> u32 {
    (value >> 1) ^ (value & 1).wrapping_neg()
}

const GROUP: usize = 16;

/// Bits of packed differences for the 2 bits of each group's header.
const BITS: [[u8; 4]; 3] = [[0, 2, 4, 8], [0, 1, 2, 4], [1, 2, 4, 8]];

fn decode_attributes(bytes: &[u8], stride: usize, made: &mut [u8]) -> Option<()> {
    let &version = bytes.first().filter(|byte| matches!(byte, 0xa0 | 0xa1))?;
    let is_new = version == 0xa1;
    let tail_bytes = if is_new { stride + stride / 4 } else { stride };
    let tail = bytes.get(bytes.len().checked_sub(tail_bytes)?..)?;
    let (first, channels) = tail.split_at(stride);
    let mut previous = first.to_vec();
    let mut source = Source { bytes: &bytes[..bytes.len() - tail_bytes], offset: 1 };
    let block_elements = ((0x2000 / stride) & !(GROUP - 1)).min(0x100);
    let mut deltas = vec![0; block_elements * stride];
    for block in made.chunks_mut(block_elements * stride) {
        let count = block.len() / stride;
        let controls = source.take_bytes(if is_new { stride / 4 } else { 0 })?;
        for (byte, column) in deltas.chunks_mut(block_elements).enumerate() {
            let control = is_new.then(|| controls[byte / 4] >> (2 * (byte % 4)) & 3);
            decode_column(&mut source, control, count, column)?;
        }
        apply_deltas(&deltas, block_elements, channels, &mut previous, block)?;
    }
    Some(())
}

/// Decodes the differences of one byte of each element of a block.
fn decode_column(source: &mut Source<'_>, control: Option<u8>, count: usize, column: &mut [u8]) -> Option<()> {
    let bits = match control {
        None => BITS[0],
        Some(0) => BITS[1],
        Some(1) => BITS[2],
        Some(2) => {
            column.fill(0);
            return Some(());
        }
        Some(_) => {
            column[..count].copy_from_slice(source.take_bytes(count)?);
            return Some(());
        }
    };
    let groups = count.div_ceil(GROUP);
    let headers = source.take_bytes(groups.div_ceil(4))?;
    for (group, deltas) in column.chunks_mut(GROUP).take(groups).enumerate() {
        let width = bits[usize::from(headers[group / 4] >> (2 * (group % 4)) & 3)];
        decode_group(source, width, deltas)?;
    }
    Some(())
}

fn decode_group(source: &mut Source<'_>, width: u8, deltas: &mut [u8]) -> Option<()> {
    match width {
        0 => deltas.fill(0),
        8 => deltas.copy_from_slice(source.take_bytes(GROUP)?),
        _ => {
            let packed = source.take_bytes(GROUP * usize::from(width) / 8)?;
            let sentinel = (1 << width) - 1;
            let in_byte = 8 / width;
            for (place, delta) in deltas.iter_mut().enumerate() {
                let within = (place as u8 % in_byte) * width;
                // Single bits begin at the lowest one, wider numbers at the highest ones.
                let shift = if width == 1 { within } else { 8 - width - within };
                let value = packed[place / usize::from(in_byte)] >> shift & sentinel;
                *delta = if value == sentinel { source.read_byte()? } else { value };
            }
        }
    }
    Some(())
}

/// Adds differences to the elements before. Each group of 4 bytes has its own kind of difference.
fn apply_deltas(deltas: &[u8], column: usize, channels: &[u8], previous: &mut [u8], block: &mut [u8]) -> Option<()> {
    let stride = previous.len();
    for (row, element) in block.chunks_mut(stride).enumerate() {
        for start in (0..stride).step_by(4) {
            let delta = |byte: usize| deltas[(start + byte) * column + row];
            let channel = channels.get(start / 4).copied().unwrap_or(0);
            let old: &mut [u8] = &mut previous[start..start + 4];
            match channel & 3 {
                0 => {
                    for (byte, value) in old.iter_mut().enumerate() {
                        *value = value.wrapping_add(unzigzag(u32::from(delta(byte))) as u8);
                    }
                }
                1 => {
                    for half in [0, 2] {
                        let change = unzigzag(u32::from(u16::from_le_bytes([delta(half), delta(half + 1)]))) as u16;
                        let value = u16::from_le_bytes([old[half], old[half + 1]]).wrapping_add(change);
                        old[half..half + 2].copy_from_slice(&value.to_le_bytes());
                    }
                }
                2 => {
                    let change = u32::from_le_bytes([delta(0), delta(1), delta(2), delta(3)]);
                    let value = u32::from_le_bytes([old[0], old[1], old[2], old[3]])
                        ^ change.rotate_right(u32::from(channel >> 4));
                    old.copy_from_slice(&value.to_le_bytes());
                }
                _ => return None,
            }
            element[start..start + 4].copy_from_slice(old);
        }
    }
    Some(())
}

/// The last values of a stream.
struct Recent<T, const N: usize> {
    values: [T; N],
    next: usize,
}

impl<T: Copy + Default, const N: usize> Recent<T, N> {
    fn new() -> Self {
        Self { values: [T::default(); N], next: 0 }
    }

    fn push(&mut self, value: T) {
        self.values[self.next] = value;
        self.next = (self.next + 1) % N;
    }

    /// Returns the value that was pushed `ago + 1` pushes before.
    fn value_pushed_ago(&self, ago: usize) -> T {
        self.values[(self.next + 2 * N - 1 - ago) % N]
    }
}

/// State of the triangle decoder.
struct Triangles<'a> {
    data: Source<'a>,
    edges: Recent<[u32; 2], 16>,
    vertices: Recent<u32, 16>,
    next: u32,
    last: u32,
}

impl Triangles<'_> {
    fn new_vertex(&mut self) -> u32 {
        let vertex = self.next;
        self.next = self.next.wrapping_add(1);
        vertex
    }

    fn explicit_vertex(&mut self) -> Option<u32> {
        self.last = self.last.wrapping_add(unzigzag(self.data.read_variable_length_number()?));
        Some(self.last)
    }

    /// Returns the third vertex of a triangle at a recent edge.
    fn third_vertex(&mut self, code: u8) -> Option<u32> {
        let vertex = match code {
            0 => self.new_vertex(),
            1..=12 => return Some(self.vertices.value_pushed_ago(usize::from(code))),
            13 => {
                self.last = self.last.wrapping_sub(1);
                self.last
            }
            14 => {
                self.last = self.last.wrapping_add(1);
                self.last
            }
            _ => self.explicit_vertex()?,
        };
        self.vertices.push(vertex);
        Some(vertex)
    }

    /// Returns a triangle without a recent edge.
    fn separate(&mut self, code: u8, table: &[u8]) -> Option<[u32; 3]> {
        // The table gives no explicit vertices: 15 means the oldest one there.
        let may_be_explicit = code >= 14;
        let pair = if may_be_explicit { self.data.read_byte()? } else { *table.get(usize::from(code))? };
        if may_be_explicit && pair == 0 {
            self.next = 0;
        }
        let a = if code == 15 { self.explicit_vertex()? } else { self.new_vertex() };
        let mut other = |code: u8| -> Option<(u32, bool)> {
            Some(match code {
                0 => (self.new_vertex(), true),
                15 if may_be_explicit => (self.explicit_vertex()?, true),
                _ => (self.vertices.value_pushed_ago(usize::from(code) - 1), false),
            })
        };
        let (b, is_b_new) = other(pair >> 4)?;
        let (c, is_c_new) = other(pair & 15)?;
        for (vertex, is_new) in [(a, true), (b, is_b_new), (c, is_c_new)] {
            if is_new {
                self.vertices.push(vertex);
            }
        }
        Some([a, b, c])
    }
}

fn decode_triangles(bytes: &[u8], size: usize, made: &mut [u8]) -> Option<()> {
    const TABLE_BYTES: usize = 16;
    let count = made.len() / (3 * size);
    if bytes.first() != Some(&0xe1) || !made.len().is_multiple_of(3 * size) {
        return None;
    }
    let (rest, table) = bytes.split_at_checked(bytes.len().checked_sub(TABLE_BYTES)?)?;
    let codes = rest.get(1..count.checked_add(1)?)?;
    let data = Source { bytes: rest, offset: 1 + count };
    let mut state = Triangles { data, edges: Recent::new(), vertices: Recent::new(), next: 0, last: 0 };
    for (&code, triangle) in codes.iter().zip(made.chunks_mut(3 * size)) {
        let (edge, third) = (code >> 4, code & 15);
        let corners = if edge < 15 {
            let [a, b] = state.edges.value_pushed_ago(usize::from(edge));
            let c = state.third_vertex(third)?;
            state.edges.push([c, b]);
            state.edges.push([a, c]);
            [a, b, c]
        } else {
            let [a, b, c] = state.separate(third, table)?;
            state.edges.push([b, a]);
            state.edges.push([c, b]);
            state.edges.push([a, c]);
            [a, b, c]
        };
        for (corner, out) in corners.iter().zip(triangle.chunks_mut(size)) {
            out.copy_from_slice(&corner.to_le_bytes()[..size]);
        }
    }
    Some(())
}

fn decode_indices(bytes: &[u8], size: usize, made: &mut [u8]) -> Option<()> {
    if bytes.first() != Some(&0xd1) {
        return None;
    }
    let mut source = Source { bytes, offset: 1 };
    let mut last = [0_u32; 2];
    for out in made.chunks_mut(size) {
        let code = source.read_variable_length_number()?;
        let value = &mut last[(code & 1) as usize];
        *value = value.wrapping_add(unzigzag(code >> 1));
        out.copy_from_slice(&value.to_le_bytes()[..size]);
    }
    Some(())
}
