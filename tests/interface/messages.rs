//! Sentences about mistakes of the caller's: which of several structs has the field.

#![allow(unsafe_code, reason = "calls the C functions")]

use glam::DVec3;
use gusset::capi::context::*;
use gusset::capi::curve::frame::*;
use gusset::capi::curve::outline::gusset_outlines;
use gusset::capi::curve::outline_options::gusset_outline_options;
use gusset::capi::mesh::fill::gusset_fill_options;
use gusset::capi::mesh::gusset_mesh_view;
use gusset::capi::mesh::join::gusset_join;
use gusset::capi::mesh::join_options::gusset_join_options;
use gusset::capi::mesh::stitch_options::gusset_stitch_options;
use gusset::capi::mesh::weld::gusset_weld_options;
use gusset::capi::status::gusset_status::{self, GUSSET_ERROR_NULL_ARGUMENT, GUSSET_ERROR_UNKNOWN_VALUE};
use gusset::capi::surface::gusset_surface_create;
use gusset::net::stream::StreamInfo;
use gusset::surface::line_intersection::Line;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};
use gusset::{Allowed, Error, Job};
use std::ffi::CStr;
use std::ptr;

/// All zeros but the size, with which it begins.
fn sized<T: Copy>() -> T {
    // SAFETY: the structs of the interface are plain numbers and pointers, and begin with a size.
    unsafe {
        let mut value: T = std::mem::zeroed();
        (&raw mut value).cast::<usize>().write(size_of::<T>());
        value
    }
}

/// The message of a call with an unknown value.
fn message(call: impl FnOnce(*const gusset_context) -> gusset_status) -> String {
    message_of(GUSSET_ERROR_UNKNOWN_VALUE, call)
}

/// The message of a call that returns a status.
fn message_of(status: gusset_status, call: impl FnOnce(*const gusset_context) -> gusset_status) -> String {
    let mut context = ptr::null_mut();
    // SAFETY: a context that lives until the end of the block.
    unsafe {
        assert_eq!(gusset_context_create(&raw mut context), gusset_status::GUSSET_OK);
        assert_eq!(call(context), status);
        let message = CStr::from_ptr(gusset_context_get_message(context)).to_str().unwrap().to_owned();
        gusset_context_destroy(context);
        message
    }
}

/// The message for options of joining, which are checked before the pieces.
fn join_message(options: &gusset_join_options) -> String {
    let mut out = ptr::null_mut();
    // SAFETY: options that live, and no pieces.
    message(|context| unsafe { gusset_join(context, ptr::null(), 0, options, &raw mut out) })
}

#[test]
fn a_field_of_options_within_options_is_named_by_its_path() {
    let plain = sized::<gusset_join_options>();
    let weld = gusset_weld_options { tolerance_mode: 7, ..sized() };
    let options = gusset_join_options { weld_options: &raw const weld, ..plain };
    assert_eq!(
        join_message(&options),
        "weld_options.tolerance_mode is 7; it must be GUSSET_TOLERANCE_AUTO or GUSSET_TOLERANCE_GIVEN or GUSSET_TOLERANCE_EXACT"
    );
    let strips = gusset_stitch_options { orientation: 9, ..sized() };
    let options = gusset_join_options { strip_options: &raw const strips, ..plain };
    assert!(join_message(&options).starts_with("strip_options.orientation is 9; it must be GUSSET_"));
    let strips = gusset_stitch_options { reserved: 1, ..sized() };
    let options = gusset_join_options { strip_options: &raw const strips, ..plain };
    assert_eq!(join_message(&options), "strip_options.reserved is 1; it must be 0");
    let fill = gusset_fill_options { keep: 4, ..sized() };
    let options = gusset_join_options { fill_options: &raw const fill, ..plain };
    assert!(join_message(&options).starts_with("fill_options.keep is 4; it must be GUSSET_KEEP_AUTO or "));
    // Its own fields have no path.
    assert_eq!(
        join_message(&gusset_join_options { orientation: 9, ..plain }),
        "orientation is 9; it must be GUSSET_ORIENTATION_FIX or GUSSET_ORIENTATION_KEEP"
    );
}

#[test]
fn an_item_of_an_array_is_named_by_its_index() {
    let pieces = [gusset_mesh_view { scalar: 77, ..sized() }];
    let mut out = ptr::null_mut();
    // SAFETY: pieces that live.
    let said = message(|context| unsafe { gusset_join(context, pieces.as_ptr(), 1, ptr::null(), &raw mut out) });
    assert_eq!(said, "pieces[0]: scalar is 77; it must be GUSSET_F32 or GUSSET_F64");
    let (sheets, mut surface) = ([ptr::null()], ptr::null_mut());
    // SAFETY: handles that live during the call, of which one is NULL.
    let said = message_of(GUSSET_ERROR_NULL_ARGUMENT, |context| unsafe {
        gusset_surface_create(context, sheets.as_ptr(), 1, ptr::null(), &raw mut surface)
    });
    assert_eq!(said, "sheets[0] is NULL; it must not be");
}

#[test]
fn the_curves_across_and_along_a_frame_have_options_each() {
    let given = gusset_outline_options { lock: 77, ..sized() };
    for (name, across, along) in [("across", &raw const given, ptr::null()), ("along", ptr::null(), &raw const given)] {
        let options = gusset_frame_options { across, along, ..sized() };
        let sections = sized::<gusset_outlines>();
        let mut out = ptr::null_mut();
        // SAFETY: options that live, and no sections.
        let said = message(|context| unsafe {
            gusset_frame_create(context, &raw const sections, &raw const options, &raw mut out)
        });
        assert!(said.starts_with(&format!("{name}.lock is 77; it must be GUSSET_LOCK_PARAMETER or ")), "{said}");
    }
}

#[test]
fn sentences_say_what_is_wrong() {
    let z = [[0.0, 0.0], [0.0, 1.0]];
    let node = |i: usize| [(i / 2) as f64, (i % 2) as f64, z[i / 2][i % 2]];
    let nodes: Vec<f64> = (0..4).flat_map(node).collect();
    let nodes = Nodes::strided(nodes, 2, 2, 0, 0).unwrap();
    let sheet = Sheet::Grid(Grid::new(nodes, [false; 2], Scheme::FourPoint).unwrap());
    let surface = Surface::new(vec![sheet], None, &Job::default()).unwrap();
    let said = |line: Line| surface.first_hits(&[line], &Job::default()).unwrap_err().to_string();
    let (origin, up) = (DVec3::ZERO, DVec3::Z);
    assert_eq!(said(Line::ray(origin, DVec3::ZERO)), "line 0 needs a direction with a length from 1e-150 to 1e150");
    assert_eq!(
        said(Line::ray(origin, DVec3::X * 1e-170)),
        "line 0 needs a direction with a length from 1e-150 to 1e150: 1e-170"
    );
    assert_eq!(said(Line::ray(DVec3::Y * -1e200, up)), "line 0 needs an origin with coordinates up to 1e150: -1e200");
    assert_eq!(said(Line { to: -1.0, ..Line::ray(origin, up) }), "line 0 needs `from` to be at most `to`");
    assert_eq!(
        said(Line { from: 2.5, to: 1.0, ..Line::new(origin, up) }),
        "line 0 needs `from` to be at most `to`: 2.5"
    );
    for (allowed, words) in [
        (Allowed::Phrase("finite"), "finite"),
        (Allowed::AtLeast(2.0), "at least 2"),
        (Allowed::AtMost(1e300), "at most 1e300"),
        ((0.0..=0.5).into(), "from 0 to 0.5"),
        ((7.0..=7.0).into(), "7"),
        (Allowed::Whole(0.0, 3.0), "a whole number from 0 to 3"),
        (Allowed::IndexBelow(4), "an index below 4"),
    ] {
        let said = Error::OptionOutOfRange { option: "gap", value: -1.0, allowed }.to_string();
        assert_eq!(said, format!("gap is -1; it must be {words}"));
    }
    let beyond = Error::IndexOutOfRange { face: 1, corner: 4, vertex: 17, count: 12 }.to_string();
    assert_eq!(beyond, "face 1, corner 4: vertex 17 does not exist (the mesh has 12)");
    let offsets = Error::BadOffsets { entry: 2, value: 4 }.to_string();
    assert_eq!(offsets, "offset 2 is 4: offsets must not decrease, and the last must be the number of elements");
    // Short texts and long ones.
    for text in [&b"solid part"[..], &[b'v'; 4096]] {
        let error = StreamInfo::read(text).unwrap_err();
        assert_eq!(
            error.to_string(),
            "the stream cannot be read at byte 0: it does not begin as a stream of a net does"
        );
    }
    assert_eq!(
        StreamInfo::read(b"\x8bTRN").unwrap_err().to_string(),
        "the stream cannot be read at byte 4: it is cut off"
    );
}
