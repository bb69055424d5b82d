//! The grids of the data folder: arrays of numbers in npz archives and csv files.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use crate::common::data;
use std::fs::File;
use std::io::Read;
use std::path::PathBuf;

/// Their positions.
pub fn folder() -> Option<PathBuf> {
    data::path("grids")
}

/// An array of an archive: its shape and its numbers, row after row.
pub fn npz(file: &str, array: &str) -> Option<(Vec<usize>, Vec<f64>)> {
    // An npz file is a zip archive of npy files: a magic number, the version, the length of the
    // header, the header, the numbers.
    let mut archive = zip::ZipArchive::new(File::open(folder()?.join(file)).unwrap()).unwrap();
    let mut npy = Vec::new();
    archive.by_name(&format!("{array}.npy")).unwrap().read_to_end(&mut npy).unwrap();
    assert!(npy.starts_with(b"\x93NUMPY\x01"), "{file}: no npy file of version 1");
    let (header, numbers) = npy[10..].split_at(usize::from(u16::from_le_bytes([npy[8], npy[9]])));
    let header = std::str::from_utf8(header).unwrap();
    assert!(header.contains("'fortran_order': False"), "{file}: {header}");
    let after = |start: &str| header.split_once(start).unwrap().1;
    let shape = after("'shape': (").split(')').next().unwrap();
    let shape = shape.split(',').filter_map(|n| n.trim().parse().ok()).collect();
    let numbers = match after("'descr': '").split('\'').next().unwrap() {
        "<f4" => numbers.chunks_exact(4).map(|x| f32::from_le_bytes(x.try_into().unwrap()).into()).collect(),
        "<f8" => numbers.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect(),
        "<i2" => numbers.chunks_exact(2).map(|x| i16::from_le_bytes(x.try_into().unwrap()).into()).collect(),
        other => panic!("{file}: numbers of type {other}"),
    };
    Some((shape, numbers))
}

/// A table of numbers without a header: its rows.
pub fn csv(file: &str) -> Option<Vec<Vec<f64>>> {
    let text = std::fs::read_to_string(folder()?.join(file)).unwrap();
    Some(text.lines().map(|line| line.split(',').map(|field| field.trim().parse().unwrap()).collect()).collect())
}
