//! Material libraries: names of files, colours, and what is kept.

use super::mtl_line::{file_range, with_renamed_file};
use super::read_obj;
use crate::document::Document;
use crate::error::{ReadError, ReadErrorKind};
use crate::material::{ImageData, NO_MATERIAL, NativeMaterial};
use crate::options::ReadOptions;
use crate::resources::Resources;
use std::collections::HashMap;

/// Files in memory.
pub(super) struct Files(pub(super) HashMap<&'static str, Vec<u8>>);

impl Resources for Files {
    fn load(&self, name: &str) -> Result<Vec<u8>, ReadError> {
        let missing = || ReadError::new(ReadErrorKind::Unreadable, "the file does not exist");
        self.0.get(name).cloned().ok_or_else(missing)
    }
}

fn read(text: &str, files: &[(&'static str, &str)]) -> Document {
    let files = Files(files.iter().map(|&(name, text)| (name, text.as_bytes().to_vec())).collect());
    read_obj(text.as_bytes(), &files, &ReadOptions::default()).expect("the file is valid")
}

#[test]
fn file_names_end_lines() {
    let cases = [
        ("map_Kd a.png", Some("a.png")),
        ("map_Kd  an image.png ", Some("an image.png")),
        ("map_Kd -s 1 1 1 an image.png", Some("an image.png")),
        ("map_Kd -o 0.5 -clamp on -mm 0 1 x y.png", Some("x y.png")),
        ("\tMAP_KD -s 2 2 3.png", Some("3.png")),
        ("map_Kd -s 1 2 3", Some("3")),
        ("map_Kd -unknown 4 x.png", Some("x.png")),
        ("bump -bm 0.3 b.png", Some("b.png")),
        ("norm n.png", Some("n.png")),
        ("refl -type sphere r.png", Some("r.png")),
        ("map_aat on", None),
        ("map_Kd", None),
        ("Kd 1 0 0", None),
        ("", None),
    ];
    for (line, name) in cases {
        assert_eq!(file_range(line).map(|range| &line[range]), name, "{line}");
    }
    assert_eq!(
        with_renamed_file("map_Kd -s 1 1 1 an image.png", |name| format!("red/{name}")).unwrap(),
        "map_Kd -s 1 1 1 red/an image.png"
    );
}

#[test]
fn libraries_are_found_by_all_kinds_of_names() {
    let document = read(
        "mtllib a.mtl b.mtl\nmtllib deeper\\c.mtl\nmtllib my own.mtl\nmtllib gone.mtl\nv 0 0 0\n\
         usemtl a\nf 1 1 1\nusemtl b\nf 1 1 1\nusemtl c\nf 1 1 1\nusemtl two words\nf 1 1 1\nusemtl else\nf 1 1 1\n",
        &[
            ("a.mtl", "# of a scanner\nnewmtl a\r\nKd 1 0 0\r\nNs 10\n\nmap_Kd missing a.png\n"),
            ("b.mtl", "newmtl b\nKd 0 1 0\nTr 0.25\nmap_Kd missing a.png\n"),
            ("deeper/c.mtl", "newmtl c\nKd 0 0 1\nTr 1\nd 0.5\nmap_Kd -s 1 1 1 ..\\c.png\nmap_Ks /abs.png"),
            ("my own.mtl", "newmtl unused\nKd 0 0 0\nnewmtl  two words \nKd 0.5\n"),
        ],
    );
    assert_eq!(document.meshes[0].face_materials, [0, 1, 2, 3, 4]);
    let colours: Vec<_> = document.materials.iter().map(|material| material.colour).collect();
    assert_eq!(
        colours,
        [[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.75], [0.0, 0.0, 1.0, 0.5], [0.5, 1.0, 1.0, 1.0], [1.0; 4]]
    );
    let lines = |index: usize| match &document.materials[index].native {
        Some(NativeMaterial::Mtl(lines)) => lines.clone(),
        _ => Vec::new(),
    };
    assert_eq!(lines(0), ["Kd 1 0 0", "Ns 10", "map_Kd missing a.png"]);
    assert_eq!(lines(2), ["Kd 0 0 1", "Tr 1", "d 0.5", "map_Kd -s 1 1 1 deeper/../c.png", "map_Ks /abs.png"]);
    assert!(document.materials[4].native.is_none());
    let images: Vec<_> = document.materials.iter().map(|material| material.image).collect();
    assert_eq!(images, [Some(0), Some(0), Some(1), None, None]);
    assert_eq!(document.images[1].data, ImageData::File("deeper/../c.png".into()));
    assert_eq!(document.images[0].media_type, "image/png");
    let notes: Vec<_> = document.notes.iter().map(|note| &*note.text).collect();
    assert_eq!(notes, ["material library gone.mtl: the file does not exist; its materials have names only"]);
}

#[test]
fn a_library_may_define_none_and_define_twice() {
    let document = read(
        "mtllib a.mtl\nv 0 0 0\nusemtl none\nf 1 1 1\nusemtl null\nf 1 1 1\n",
        &[("a.mtl", "newmtl none\nKd 1 1 1\nnewmtl none\nKd 0 0 0\n")],
    );
    assert_eq!(document.meshes[0].face_materials, [0, NO_MATERIAL]);
    assert_eq!(document.materials[0].colour, [0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn many_materials_take_linear_time() {
    use std::fmt::Write;
    const COUNT: usize = 400_000;
    let (mut text, mut library) = (String::from("mtllib a.mtl\nv 0 0 0\n"), String::new());
    for k in 0..COUNT {
        write!(text, "usemtl m{k}\nf 1 1 1\n").expect("memory suffices");
        write!(library, "newmtl m{k}\nKd 0 0 1\n").expect("memory suffices");
    }
    let files = Files([("a.mtl", library.into_bytes())].into());
    let start = std::time::Instant::now();
    let document = read_obj(text.as_bytes(), &files, &ReadOptions::default()).expect("the file is valid");
    assert_eq!(document.materials.len(), COUNT);
    assert_eq!(document.meshes[0].face_materials[COUNT - 1] as usize, COUNT - 1);
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}

#[test]
fn files_are_renamed_in_images_and_lines() {
    let mut document = read(
        "mtllib a.mtl\nv 0 0 0\nusemtl a\nf 1 1 1\n",
        &[("a.mtl", "newmtl a\nKd 1 0 0\nmap_Kd -clamp on an image.png\nbump b.png\n")],
    );
    document.rename_files(|name| format!("red/{name}")).unwrap();
    assert_eq!(document.images[0].data, ImageData::File("red/an image.png".into()));
    let lines = ["Kd 1 0 0", "map_Kd -clamp on red/an image.png", "bump red/b.png"].map(String::from).to_vec();
    assert_eq!(document.materials[0].native, Some(NativeMaterial::Mtl(lines)));
}
