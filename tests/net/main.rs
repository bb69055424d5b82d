//! Nets of quads: gluing, shapes, fields, conversion, streams.

#[path = "../common/mod.rs"]
mod common;

mod analyse;
mod arrange;
mod bilinear;
mod closure;
mod complex;
mod complexes;
mod concat;
mod convert;
mod duplicates;
mod field;
mod golden;
mod grids;
mod measure;
mod morph;
mod nets;
mod normals;
mod occurrences;
mod oracle;
mod planarise;
mod primitive;
mod reformat;
mod resample;
mod roll;
mod scene;
mod scene_stream;
mod settle;
mod space;
mod stream;
mod stream_damage;
mod stream_tiles;
mod topology;
mod transform;
mod triangles;
mod validate;
