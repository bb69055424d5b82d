//! An option is written by hand at two places: in the core, and as a field in `src/capi`. All else follows from the field.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// Fields for the end of `gusset_fill_options`, one for each rule that a new option is likely to need.
const FIELDS: &str = "
    /// Greatest doubt of a patch, at least 0. 0: no limit.
    pub max_doubt: f64,
    /// 1: doubts nothing.
    /// @flag
    pub certain: u32,
    /// Share of the doubt that counts.
    /// @when certain 1
    pub share: f64,
    /// Loops to doubt.
    pub doubted: *const u32,
    /// Number of loops.
    pub doubted_count: usize,
";

/// The code of a host that sets each member once, and the C struct that it must give.
const PROGRAM: &str = r#"
#include <gusset/curve_options.hpp>
#include <gusset/mesh_options.hpp>
#include <gusset/net_options.hpp>
#include <cstdio>
#define HOLDS(what) do { if (!(what)) { std::printf("%s\n", #what); failed = 1; } } while (0)
int main() {
    int failed = 0;
    gusset::FillOptions fill;
    HOLDS(gusset::detail::as_c(fill).max_doubt == 0.0 && gusset::detail::as_c(fill).certain == 0);
    fill.max_doubt = 2.5;
    fill.share = 0.5;
    fill.doubted = {3, 4};
    fill.keep = gusset::FillKeep::borders;
    fill.plan_only = true;
    const gusset_fill_options filled = gusset::detail::as_c(fill);
    HOLDS(filled.struct_size == sizeof filled && filled.max_doubt == 2.5);
    HOLDS(filled.certain == 1 && filled.share == 0.5);
    HOLDS(filled.doubted_count == 2 && filled.doubted[1] == 4 && filled.groups == nullptr);
    HOLDS(filled.keep == GUSSET_KEEP_BORDERS && filled.plan_only == 1 && filled.weight == 0);

    gusset::JoinOptions join;
    join.max_gap = 0.0;
    join.weld_options.tolerance = 0.25;
    join.strip_options.row_count = 3;
    join.strip_options.arc_b = {5, 6};
    join.trim_options.viewpoints = {{0, 0, 1}, {0, 0, 7}};
    gusset::detail::JoinOptionsNested nested;
    const gusset_join_options joined = gusset::detail::as_c(join, nested);
    HOLDS(joined.gap == GUSSET_GAP_GIVEN && joined.max_gap == 0.0);
    HOLDS(joined.weld_options->tolerance_mode == GUSSET_TOLERANCE_GIVEN && joined.weld_options->tolerance == 0.25);
    HOLDS(joined.strip_options->rows == GUSSET_ROWS_COUNT && joined.strip_options->row_count == 3);
    HOLDS(joined.strip_options->extent == GUSSET_EXTENT_ARCS && joined.strip_options->arc_b[1] == 6);
    HOLDS(joined.strip_options->tolerance_mode == GUSSET_TOLERANCE_AUTO);
    HOLDS(joined.trim_options->viewpoint_count == 2 && joined.trim_options->viewpoints[5] == 7.0);
    HOLDS(joined.fill_options->struct_size == sizeof(gusset_fill_options));
    join.max_gap.reset();
    join.strip_options.row_count.reset();
    join.strip_options.rows = gusset::RowRule::mean_edge;
    const gusset_join_options plain = gusset::detail::as_c(join, nested);
    HOLDS(plain.gap == GUSSET_GAP_AUTO && plain.strip_options->rows == GUSSET_ROWS_MEAN_EDGE);

    gusset::FrameOptions frame;
    frame.reference = {1, 2, 3};
    frame.missing = {8};
    frame.along.max_steps = 9;
    gusset::detail::FrameOptionsNested curves;
    const gusset_frame_options framed = gusset::detail::as_c(frame, curves);
    HOLDS(framed.reference[2] == 3.0 && framed.missing.count == 1 && framed.missing.data[0] == 8);
    HOLDS(framed.along->max_steps == 9 && framed.across->max_steps == 0 && framed.axis_points == nullptr);

    gusset::ConcatenateOptions concatenate;
    concatenate.properties.user = 11;
    HOLDS(gusset::detail::as_c(concatenate).properties.user == 11);
    gusset::NetGridOptions grid;
    grid.face = 0;
    HOLDS(gusset::detail::as_c(grid).has_face == 1);
    return failed;
}
"#;

fn copied(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copied(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// A copy of what the interface is read from, with fields at the end of `gusset_fill_options`.
fn scratch(name: &str, fields: &str) -> PathBuf {
    let folder = env::temp_dir().join(format!("gusset-{name}-{}", std::process::id()));
    for part in ["src/capi", "crates/gusset-files/src/table", "include"] {
        copied(&Path::new(ROOT).join(part), &folder.join(part));
    }
    for file in ["cbindgen.toml", "cbindgen_files.toml", "cbindgen_plugin.toml"] {
        fs::copy(Path::new(ROOT).join(file), folder.join(file)).unwrap();
    }
    let path = folder.join("src/capi/mesh/fill.rs");
    let text = fs::read_to_string(&path).unwrap();
    let last = "    pub ignore_creases: u32,\n";
    assert!(text.contains(last));
    fs::write(&path, text.replace(last, &format!("{last}{}", fields.trim_start_matches('\n')))).unwrap();
    folder
}

#[test]
fn a_field_of_the_source_is_an_option_everywhere() {
    let folder = scratch("option", FIELDS);
    let version = env!("CARGO_PKG_VERSION");
    let made = gusset_interface::library_headers(&folder, version).unwrap();
    let text = |path: &str| made.iter().find(|(name, _)| name == path).map(|(_, text)| text.as_str()).unwrap();
    assert!(text("include/gusset/mesh.h").contains("    double max_doubt;\n"));
    // The comment is the field's, and nothing else changes.
    let options = text("include/gusset/mesh_options.hpp");
    let member = "    /// Greatest doubt of a patch, at least 0. 0: no limit.\n    double max_doubt = 0.0;\n";
    assert!(options.contains(member));
    let before = fs::read_to_string(Path::new(ROOT).join("include/gusset/mesh_options.hpp")).unwrap();
    let mut lines = options.lines();
    assert!(before.lines().all(|line| lines.any(|other| other == line)), "a line is gone");
    let description = gusset_interface::library_description(&folder, version).unwrap();
    assert!(description.contains(r#""name":"max_doubt""#));

    for (path, text) in &made {
        fs::write(folder.join(path), text).unwrap();
    }
    let (source, program) = (folder.join("options.cpp"), folder.join("options"));
    fs::write(&source, PROGRAM).unwrap();
    let mut compiler = Command::new("g++");
    compiler.args(["-std=c++17", "-Wall", "-Wextra", "-Wconversion", "-Werror", "-I"]).arg(folder.join("include"));
    for command in [compiler.arg(&source).arg("-o").arg(&program), &mut Command::new(&program)] {
        let output = command.output().unwrap();
        let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
        assert!(output.status.success(), "{command:?}: {}", said.concat());
    }
    fs::remove_dir_all(&folder).unwrap();
}

/// A field that no rule covers does not build, rather than be left out.
#[test]
fn a_field_without_a_rule_is_refused() {
    let folder = scratch("refused", "    /// Bytes.\n    pub bytes: *mut u8,\n");
    let sources = gusset_interface::sources(&folder).unwrap();
    let refused = gusset_interface::cpp_options::options(&sources).unwrap_err();
    assert_eq!(refused, "gusset_fill_options: bytes: C++ has no rule for this field");
    fs::remove_dir_all(&folder).unwrap();
}
