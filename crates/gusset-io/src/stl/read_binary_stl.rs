//! Binary STL files.

use super::stl_parts::{FACET_BYTES, FACETS_START, HEADER_BYTES, MeshAndNotes, mesh_from_parts, number_corners};
use crate::error::{Note, Place, ReadError, ReadErrorKind};
use crate::mesh::{Mesh, Positions};
use crate::options::ReadOptions;
use crate::parallel_fill::make_vector;
use crate::parallel_merging::merge_triangles;
use crate::scene::counted;
use std::sync::atomic::{AtomicU16, Ordering::Relaxed};

/// The bit of attribute bytes that VisCAM sets in facets with a colour, and Materialise Magics in those without.
const COLOUR_BIT: u16 = 1 << 15;
/// Precedes the colour of the whole part in the headers of Materialise Magics.
const MAGICS_COLOUR: &[u8] = b"COLOR=";

/// Returns whether the size of the file is what its count tells.
pub(super) fn is_whole_binary_stl(bytes: &[u8]) -> bool {
    announced_count(bytes).is_some_and(|count| bytes.len() as u64 == FACETS_START as u64 + FACET_BYTES as u64 * count)
}

/// Returns whether the file is as long as its count tells, and has a count.
pub(super) fn is_long_binary_stl(bytes: &[u8]) -> bool {
    announced_count(bytes)
        .is_some_and(|count| count > 0 && bytes.len() as u64 >= FACETS_START as u64 + FACET_BYTES as u64 * count)
}

fn announced_count(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(HEADER_BYTES..FACETS_START)?;
    Some(u64::from(u32::from_le_bytes(count.try_into().ok()?)))
}

pub(super) fn read_binary_stl(bytes: &[u8], options: &ReadOptions) -> Result<MeshAndNotes, ReadError> {
    let mut notes = Vec::new();
    let facets = facets_of_file(bytes, &mut notes)?;
    let count = facets.len() / FACET_BYTES;
    if count as u64 > u64::from(u32::MAX) / 3 {
        return Err(ReadError::new(
            ReadErrorKind::TooLarge,
            format!("the file has {count} facets; the limit is 2^32 / 3, so split it"),
        ));
    }
    let bits = AttributeBits::default();
    let mut mesh = if options.merge_repeated { merged_facets(facets, &bits)? } else { separate_facets(facets, &bits)? };
    read_colours(&bytes[..HEADER_BYTES], facets, &bits, &mut mesh, &mut notes)?;
    Ok((mesh, notes))
}

/// Returns the bytes of facets: as many as the header announces, or all if it announces fewer and nothing but facets follows.
fn facets_of_file<'a>(bytes: &'a [u8], notes: &mut Vec<Note>) -> Result<&'a [u8], ReadError> {
    let Some(announced) = announced_count(bytes) else {
        return Err(ReadError::malformed(
            Place::Line(1),
            "the file does not begin with \"solid\", and is too short for a binary STL file",
        ));
    };
    let body = &bytes[FACETS_START..];
    let held = body.len() / FACET_BYTES;
    let whole = body.len().is_multiple_of(FACET_BYTES);
    // Programs that write without knowing the count leave 0 or the largest number in its place.
    let is_unknown = (announced == 0 && held > 0) || (announced == u64::from(u32::MAX) && whole);
    if announced > held as u64 && !is_unknown {
        let message = if bytes[..FACETS_START].iter().all(|byte| matches!(byte, b' '..=b'~' | b'\t' | b'\r' | b'\n')) {
            "the file does not begin with \"solid\", and is not a binary STL file".into()
        } else {
            format!("facet {held}: the file ends; its header announces {announced} facets")
        };
        return Err(ReadError::malformed(Place::Byte((FACETS_START + held * FACET_BYTES) as u64), message));
    }
    let read = if is_unknown || whole { held } else { announced as usize };
    if read as u64 != announced {
        notes.push(Note::new(
            Place::Byte(HEADER_BYTES as u64),
            format!("the header announces {announced} facets; all {held} facets of the file are read"),
        ));
    }
    let rest = body.len() - read * FACET_BYTES;
    if rest > 0 {
        let verb = if rest == 1 { "follows" } else { "follow" };
        let place = Place::Byte((bytes.len() - rest) as u64);
        notes.push(Note::new(place, format!("{} {verb} the last facet, ignored", counted(rest, "byte", "bytes"))));
    }
    Ok(&body[..read * FACET_BYTES])
}

/// Returns the corners of a facet, which follow its normal.
fn facet_corners(facet: &[u8; FACET_BYTES]) -> [[f32; 3]; 3] {
    let mut corners = [[0.0; 3]; 3];
    for (corner, bytes) in corners.iter_mut().zip(facet[12..48].as_chunks::<12>().0) {
        for (coordinate, bytes) in corner.iter_mut().zip(bytes.as_chunks::<4>().0) {
            *coordinate = f32::from_le_bytes(*bytes);
        }
    }
    corners
}

/// Bits of the attribute bytes of facets, which several threads collect.
#[derive(Default)]
struct AttributeBits {
    /// Bits that a facet has.
    set: AtomicU16,
    /// Bits that a facet lacks.
    missing: AtomicU16,
}

impl AttributeBits {
    /// Adds the bits of a facet. Returns its corners.
    #[inline]
    fn add_and_take_corners(&self, facet: &[u8; FACET_BYTES]) -> [[f32; 3]; 3] {
        let bits = attribute(facet);
        for (collected, bits) in [(&self.set, bits), (&self.missing, !bits)] {
            // Most facets have no new bits, so that the threads only read.
            if bits & !collected.load(Relaxed) != 0 {
                collected.fetch_or(bits, Relaxed);
            }
        }
        facet_corners(facet)
    }
}

fn attribute(facet: &[u8; FACET_BYTES]) -> u16 {
    u16::from_le_bytes([facet[48], facet[49]])
}

fn separate_facets(facets: &[u8], bits: &AttributeBits) -> Result<Mesh, ReadError> {
    let (facets, _) = facets.as_chunks::<FACET_BYTES>();
    let positions: Vec<[[f32; 3]; 3]> = make_vector(facets.len(), |facet| bits.add_and_take_corners(&facets[facet]))?;
    let corners = number_corners(3 * facets.len())?;
    Ok(mesh_from_parts(Positions::F32(bytemuck::cast_vec(positions)), corners, triangle_offsets(facets.len())?))
}

fn merged_facets(facets: &[u8], bits: &AttributeBits) -> Result<Mesh, ReadError> {
    let (facets, _) = facets.as_chunks::<FACET_BYTES>();
    let (points, corners) = merge_triangles(facets.len(), |facet| bits.add_and_take_corners(&facets[facet]))?;
    Ok(mesh_from_parts(Positions::F32(points), corners, triangle_offsets(facets.len())?))
}

fn triangle_offsets(count: usize) -> Result<Vec<u32>, ReadError> {
    make_vector(count + 1, |face| 3 * face as u32)
}

/// Reads colours of facets from their attribute bytes, 5 bits for each part.
fn read_colours(
    header: &[u8],
    facets: &[u8],
    bits: &AttributeBits,
    mesh: &mut Mesh,
    notes: &mut Vec<Note>,
) -> Result<(), ReadError> {
    let (facets, _) = facets.as_chunks::<FACET_BYTES>();
    let (any, all) = (bits.set.load(Relaxed), !bits.missing.load(Relaxed));
    let part_colour = header.windows(MAGICS_COLOUR.len() + 4).find(|bytes| bytes.starts_with(MAGICS_COLOUR));
    let is_coloured = if part_colour.is_some() { all & COLOUR_BIT == 0 } else { any & COLOUR_BIT != 0 };
    if !is_coloured && part_colour.is_none() {
        if any != 0 {
            notes.push(Note::new(Place::Whole, "the attribute bytes of facets are not colours, left out"));
        }
        return Ok(());
    }
    let default = part_colour.map_or([1.0; 4], |bytes| {
        let parts = &bytes[MAGICS_COLOUR.len()..];
        [parts[0], parts[1], parts[2], parts[3]].map(|part| f32::from(part) / 255.0)
    });
    let fifth = |bytes: u16, shift: u32| f32::from((bytes >> shift) & 31) / 31.0;
    mesh.face_colours.try_reserve_exact(facets.len())?;
    mesh.face_colours.extend(facets.iter().map(attribute).map(|bytes| {
        match (part_colour.is_some(), bytes & COLOUR_BIT) {
            (true, 0) => [fifth(bytes, 0), fifth(bytes, 5), fifth(bytes, 10), 1.0],
            (false, COLOUR_BIT) => [fifth(bytes, 10), fifth(bytes, 5), fifth(bytes, 0), 1.0],
            _ => default,
        }
    }));
    Ok(())
}
