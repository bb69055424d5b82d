//! The grids of the data folder: arrays of numbers in npz archives and csv files.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use npyz::{DType, NpyFile, TypeChar};
use std::fs::File;
use std::path::PathBuf;

/// Where the data are: the folder that GUSSET_DATA names, or its usual place. Says so if there is
/// none.
pub fn folder() -> Option<PathBuf> {
    let given = std::env::var_os("GUSSET_DATA").map(PathBuf::from);
    let folder = given.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/data"));
    let grids = folder.join("grids");
    if grids.is_dir() {
        return Some(grids);
    }
    eprintln!("skipped: there is no folder {}", grids.display());
    None
}

/// An array of an archive: its shape and its numbers, row after row.
pub fn npz(file: &str, array: &str) -> Option<(Vec<usize>, Vec<f64>)> {
    // An npz file is a zip archive of npy files.
    let mut archive = zip::ZipArchive::new(File::open(folder()?.join(file)).unwrap()).unwrap();
    let npy = NpyFile::new(archive.by_name(&format!("{array}.npy")).unwrap()).unwrap();
    let shape = npy.shape().iter().map(|&n| n as usize).collect();
    let DType::Plain(kind) = npy.dtype() else { panic!("{file}: a structured array") };
    let numbers = match (kind.type_char(), kind.size_field()) {
        (TypeChar::Float, 4) => npy.into_vec::<f32>().unwrap().into_iter().map(f64::from).collect(),
        (TypeChar::Float, 8) => npy.into_vec::<f64>().unwrap(),
        (TypeChar::Int, 2) => npy.into_vec::<i16>().unwrap().into_iter().map(f64::from).collect(),
        other => panic!("{file}: numbers of type {other:?}"),
    };
    Some((shape, numbers))
}

/// A table of numbers without a header: its rows.
pub fn csv(file: &str) -> Option<Vec<Vec<f64>>> {
    let text = std::fs::read_to_string(folder()?.join(file)).unwrap();
    Some(text.lines().map(|line| line.split(',').map(|field| field.trim().parse().unwrap()).collect()).collect())
}
