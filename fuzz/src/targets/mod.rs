//! The targets: a file for each family of functions.

mod assemble;
mod attributes;
mod boundary_check;
mod curve_meet;
mod curve_net;
mod curve_ops;
mod develop;
mod fill;
mod filters;
mod frame;
mod gluing;
mod net_edit;
mod net_ops;
mod outline;
mod overlaps;
mod read_3mf;
mod read_dxf;
mod read_gltf;
mod read_obj;
mod read_off;
mod read_ply;
mod read_points;
mod read_scan_list;
mod read_stl;
mod read_svg;
mod repair;
mod scene;
mod sections;
mod sew;
mod stitch;
mod stream_decode;
mod surface_lines;
mod surface_nearest;
mod surface_paths;
mod weld_orient;

/// A target: its name, and what runs one case made of some bytes. It panics if an oracle fails.
pub type Target = (&'static str, fn(&[u8]));

/// All targets; `fuzz_targets` has a file for each of them, and the tests run each for a moment.
pub const TARGETS: &[Target] = &[
    ("assemble", assemble::run),
    ("attributes", attributes::run),
    ("boundary_check", boundary_check::run),
    ("curve_meet", curve_meet::run),
    ("curve_net", curve_net::run),
    ("curve_ops", curve_ops::run),
    ("develop", develop::run),
    ("fill", fill::run),
    ("filters", filters::run),
    ("frame", frame::run),
    ("gluing", gluing::run),
    ("net_edit", net_edit::run),
    ("net_ops", net_ops::run),
    ("outline", outline::run),
    ("overlaps", overlaps::run),
    ("read_3mf", read_3mf::run),
    ("read_dxf", read_dxf::run),
    ("read_gltf", read_gltf::run),
    ("read_obj", read_obj::run),
    ("read_off", read_off::run),
    ("read_ply", read_ply::run),
    ("read_points", read_points::run),
    ("read_scan_list", read_scan_list::run),
    ("read_stl", read_stl::run),
    ("read_svg", read_svg::run),
    ("repair", repair::run),
    ("scene", scene::run),
    ("sections", sections::run),
    ("sew", sew::run),
    ("stitch", stitch::run),
    ("stream_decode", stream_decode::run),
    ("surface_lines", surface_lines::run),
    ("surface_nearest", surface_nearest::run),
    ("surface_paths", surface_paths::run),
    ("weld_orient", weld_orient::run),
];

/// The first inputs of a target: its name, and what makes them.
pub type Seeds = (&'static str, fn() -> Vec<Vec<u8>>);

/// First inputs of the targets that read files: valid and hostile files. The other targets make valid cases of any bytes.
pub const SEEDS: &[Seeds] = &[
    ("read_3mf", read_3mf::seeds),
    ("read_dxf", read_dxf::seeds),
    ("read_gltf", read_gltf::seeds),
    ("read_obj", read_obj::seeds),
    ("read_off", read_off::seeds),
    ("read_ply", read_ply::seeds),
    ("read_points", read_points::seeds),
    ("read_scan_list", read_scan_list::seeds),
    ("read_stl", read_stl::seeds),
    ("read_svg", read_svg::seeds),
];
