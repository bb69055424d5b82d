//! Files on the disk: complete or unchanged, links, permissions, pipes, and names in other folders.

use crate::document::Document;
use crate::files::{read_file, write_file};
use crate::material::ImageData;
use crate::mesh::{Mesh, Positions};
use crate::options::{ReadOptions, WriteOptions};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn triangle(size: f64) -> Document {
    Document::from_mesh(Mesh {
        positions: Positions::F64(vec![[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]]),
        face_offsets: vec![0, 3],
        corners: vec![0, 1, 2],
        ..Mesh::default()
    })
}

fn write(path: &Path, size: f64) {
    write_file(path, &triangle(size), &WriteOptions::default()).expect("the file is written");
}

fn write_error(path: &Path) -> String {
    write_file(path, &triangle(9.0), &WriteOptions::default()).expect_err("the file is not written").to_string()
}

fn size(path: &Path) -> f64 {
    let document = read_file(path, &ReadOptions::default()).expect("the file is valid");
    document.meshes[0].positions.get(1)[0]
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder exists");
    let mut names: Vec<_> = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_file_is_replaced_by_itself() {
    let folder = tempfile::tempdir().expect("a folder is made");
    let path = folder.path().join("a.obj");
    write(&path, 1.0);
    let mut document = read_file(&path, &ReadOptions::default()).expect("the file is valid");
    let Positions::F64(points) = &mut document.meshes[0].positions else { panic!("OBJ files have doubles") };
    points[1][0] = 2.0;
    write_file(&path, &document, &WriteOptions::default()).expect("the file is written");
    assert_eq!(size(&path), 2.0);
    assert_eq!(names(folder.path()), ["a.obj"]);
}

#[test]
fn a_stopped_or_failed_file_stays_as_it_was() {
    let folder = tempfile::tempdir().expect("a folder is made");
    let path = folder.path().join("a.obj");
    write(&path, 1.0);
    let options = WriteOptions { stop: Some(Arc::new(|| true)), ..WriteOptions::default() };
    assert!(write_file(&path, &triangle(2.0), &options).is_err());
    assert_eq!((size(&path), names(folder.path())), (1.0, vec!["a.obj".to_owned()]));
    assert_eq!(write_error(&folder.path().join("none/a.obj")), "the folder does not exist");
    fs::create_dir(folder.path().join("b.obj")).expect("a folder is made");
    assert_eq!(write_error(&folder.path().join("b.obj")), "this is a folder");
    assert!(write_error(&folder.path().join("a.xyzzy")).contains("the extension .xyzzy is unknown"));
    assert!(write_error(&folder.path().join("a")).contains("lacks an extension"));
    assert!(write_error(&folder.path().join("a.obj/b.obj")).len() > 5);
    assert_eq!(names(folder.path()), ["a.obj", "b.obj"]);
}

#[test]
fn reading_refuses_what_is_not_a_file() {
    let folder = tempfile::tempdir().expect("a folder is made");
    let error = |name: &str| {
        read_file(&folder.path().join(name), &ReadOptions::default()).expect_err("it is not a file").to_string()
    };
    fs::create_dir(folder.path().join("b.obj")).expect("a folder is made");
    assert_eq!(error("a.obj"), "the file does not exist");
    assert_eq!(error("b.obj"), "this is not a regular file");
    assert!(error("a.obj.gz").contains("gunzip"), "{}", error("a.obj.gz"));
    assert!(error("a.fbx").contains("Blender"));
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).expect("the file exists").permissions().mode() & 0o7777
    }

    #[test]
    fn permissions_stay() {
        let folder = tempfile::tempdir().expect("a folder is made");
        let path = folder.path().join("a.obj");
        write(&path, 1.0);
        fs::write(folder.path().join("plain"), "").expect("a file is written");
        assert_eq!(mode(&path), mode(&folder.path().join("plain")));
        for bits in [0o666, 0o600, 0o640] {
            fs::set_permissions(&path, fs::Permissions::from_mode(bits)).expect("the file is ours");
            write(&path, 2.0);
            assert_eq!(mode(&path), bits);
        }
        assert_eq!(size(&path), 2.0);
    }

    #[test]
    fn links_are_followed() {
        let folder = tempfile::tempdir().expect("a folder is made");
        let inner = folder.path().join("inner");
        fs::create_dir(&inner).expect("a folder is made");
        let [link, far] = ["a.obj", "b.obj"].map(|name| folder.path().join(name));
        write(&inner.join("real.obj"), 1.0);
        symlink("inner/second.obj", &link).expect("a link is made");
        symlink("real.obj", inner.join("second.obj")).expect("a link is made");
        write(&link, 2.0);
        assert_eq!(size(&inner.join("real.obj")), 2.0);
        symlink("inner/new.obj", &far).expect("a link is made");
        write(&far, 3.0);
        assert_eq!(size(&inner.join("new.obj")), 3.0);
        assert!(fs::symlink_metadata(&far).expect("the link exists").is_symlink());
        assert_eq!(names(&inner), ["new.obj", "real.obj", "second.obj"]);
        symlink("loop.obj", folder.path().join("loop.obj")).expect("a link is made");
        assert!(write_error(&folder.path().join("loop.obj")).len() > 5);
    }

    #[test]
    fn hard_links_stay_one_file() {
        let folder = tempfile::tempdir().expect("a folder is made");
        let [path, other] = ["a.obj", "b.obj"].map(|name| folder.path().join(name));
        write(&path, 1.5);
        fs::hard_link(&path, &other).expect("a link is made");
        write(&path, 2.0);
        assert_eq!((size(&path), size(&other)), (2.0, 2.0));
    }

    #[test]
    fn pipes_get_the_bytes_at_once() {
        let folder = tempfile::tempdir().expect("a folder is made");
        let path = folder.path().join("pipe.obj");
        let made = std::process::Command::new("mkfifo").arg(&path).status();
        if !made.is_ok_and(|status| status.success()) {
            return;
        }
        let reader = std::thread::spawn({
            let path = path.clone();
            move || fs::read_to_string(path).expect("the pipe is read")
        });
        write(&path, 1.0);
        assert!(reader.join().expect("the reader ends").starts_with("v 0 0 0\n"));
        assert_eq!(names(folder.path()), ["pipe.obj"]);
        assert_eq!(write_error(&path), "no program reads this pipe");
        let error = read_file(&path, &ReadOptions::default()).expect_err("it is a pipe");
        assert_eq!(error.to_string(), "this is not a regular file");
        // A link to a device leads to no folder where files can be made.
        let null = folder.path().join("null.obj");
        symlink("/dev/null", &null).expect("a link is made");
        write(&null, 1.0);
        assert!(!fs::metadata(&null).expect("the device stays").is_file());
    }

    /// Returns whether permissions bind this user: they do not bind root.
    fn is_bound(folder: &Path) -> bool {
        let probe = folder.join("probe");
        fs::write(&probe, "").expect("a file is written");
        fs::set_permissions(&probe, fs::Permissions::from_mode(0o400)).expect("the file is ours");
        let is_bound = fs::OpenOptions::new().write(true).open(&probe).is_err();
        fs::remove_file(&probe).expect("the file is ours");
        is_bound
    }

    #[test]
    fn what_may_not_be_written_stays() {
        let folder = tempfile::tempdir().expect("a folder is made");
        let path = folder.path().join("a.obj");
        write(&path, 1.0);
        if !is_bound(folder.path()) {
            return;
        }
        fs::set_permissions(&path, fs::Permissions::from_mode(0o444)).expect("the file is ours");
        assert_eq!(write_error(&path), "permission denied");
        assert_eq!(size(&path), 1.0);
        // In a folder where no file can be made, a file that may be written gets the bytes.
        fs::set_permissions(&path, fs::Permissions::from_mode(0o644)).expect("the file is ours");
        fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o555)).expect("the folder is ours");
        let inode = fs::metadata(&path).expect("the file exists").ino();
        write(&path, 2.0);
        assert_eq!((size(&path), fs::metadata(&path).expect("the file exists").ino()), (2.0, inode));
        assert_eq!(write_error(&folder.path().join("new.obj")), "permission denied");
        fs::set_permissions(folder.path(), fs::Permissions::from_mode(0o755)).expect("the folder is ours");
    }

    #[test]
    fn links_do_not_lead_images_out_of_the_folder() {
        let folder = tempfile::tempdir().expect("a folder is made");
        fs::write(folder.path().join("secret.png"), "\u{89}PNG").expect("a file is written");
        let inner = textured(folder.path(), "linked.png");
        symlink("../secret.png", inner.join("linked.png")).expect("a link is made");
        let document = read_file(&inner.join("a.obj"), &ReadOptions::default()).expect("the file is valid");
        assert!(matches!(&document.images[0].data, ImageData::Bytes(bytes) if bytes.is_empty()));
        let options = ReadOptions { follow_outside: true, ..ReadOptions::default() };
        let document = read_file(&inner.join("a.obj"), &options).expect("the file is valid");
        assert!(matches!(&document.images[0].data, ImageData::File(_)));
    }
}

/// Makes a folder `inner` with an OBJ file, and a library in `inner/lib` that names an image.
fn textured(folder: &Path, image: &str) -> PathBuf {
    let inner = folder.join("inner");
    fs::create_dir_all(inner.join("lib")).expect("a folder is made");
    fs::write(inner.join("a.obj"), "mtllib lib/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n")
        .expect("a file is written");
    fs::write(inner.join("lib/a.mtl"), format!("newmtl a\nKd 1 0 0\nmap_Kd -s 1 1 1 ../{image}\n"))
        .expect("a file is written");
    inner
}

#[test]
fn names_of_images_follow_the_file() {
    let folder = tempfile::tempdir().expect("a folder is made");
    let inner = textured(folder.path(), "an image.png");
    let document = read_file(&inner.join("a.obj"), &ReadOptions::default()).expect("the file is valid");
    assert!(document.notes.is_empty(), "{:?}", document.notes);
    fs::create_dir(folder.path().join("other")).expect("a folder is made");
    for (file, name) in [
        ("inner/b", "an image.png"),
        ("c", "inner/an image.png"),
        ("inner/lib/d", "../an image.png"),
        ("other/e", "../inner/an image.png"),
    ] {
        let path = folder.path().join(file).with_extension("obj");
        write_file(&path, &document, &WriteOptions::default()).expect("the file is written");
        let library = fs::read_to_string(path.with_extension("mtl")).expect("the library is written");
        assert_eq!(library, format!("newmtl a\nKd 1 0 0\nmap_Kd -s 1 1 1 {name}\n"));
        let options = ReadOptions { follow_outside: true, ..ReadOptions::default() };
        assert_eq!(read_file(&path, &options).expect("the file is valid").images, document.images);
    }
}

#[test]
fn images_outside_of_the_folder_are_left_out() {
    let folder = tempfile::tempdir().expect("a folder is made");
    let inner = textured(folder.path(), "../secret.png");
    fs::write(folder.path().join("secret.png"), "\u{89}PNG").expect("a file is written");
    let document = read_file(&inner.join("a.obj"), &ReadOptions::default()).expect("the file is valid");
    assert!(matches!(&document.images[0].data, ImageData::Bytes(bytes) if bytes.is_empty()));
    assert!(document.notes[0].text.contains("outside of the folder"), "{:?}", document.notes);
    // The lines of the library still name it.
    write_file(&inner.join("b.obj"), &document, &WriteOptions::default()).expect("the file is written");
    let library = fs::read_to_string(inner.join("b.mtl")).expect("the library is written");
    assert!(library.ends_with("map_Kd -s 1 1 1 ../secret.png\n"), "{library}");
    // So is a library outside.
    fs::write(inner.join("lib/c.obj"), "mtllib ../lib/a.mtl\nv 0 0 0\nusemtl a\nf 1 1 1\n").expect("a file is written");
    let document = read_file(&inner.join("lib/c.obj"), &ReadOptions::default()).expect("the file is valid");
    assert!(document.notes[0].text.contains("outside of the folder") && document.materials[0].native.is_none());
}
