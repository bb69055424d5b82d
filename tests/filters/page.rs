//! The filter reference, made from the table: `docs/filters.md` says what the table says.

use crate::editor::{Given, given};
use gusset::filters::data::{InputKind, OutputKind};
use gusset::filters::param::{Param, ParamKind};
use gusset::filters::{FILTERS, Filter};
use std::fmt::Write;
use std::{env, fs, path::Path};

const HEAD: &str = "# Filters

Every capability of the library that makes sense on meshes or curves in a host, as plugin hosts list it. This page is made from
the table in `crates/gusset-filters` by `GUSSET_UPDATE=1 cargo test --test filters page`.

Meshes are polygon meshes, curves are open or closed polylines, and text is for a log window. *Takes the place of its first
input* means that a host replaces the first input by the first output. A star marks a default that follows the inputs: the filter
suggests a value that suits them, and takes the value shown if it cannot. *Attributes are carried over* means that hosts can carry
attributes of vertices, corners and faces from the inputs to the first output ([Attributes](guides/attributes.md)).

Hosts may give fewer values than there are parameters: the rest are defaults. A value out of range is refused with the parameter's
name, and inputs of a wrong kind or number with the name `inputs`.
";

fn plain(value: f64) -> String {
    if value != 0.0 && !(1e-4..1e7).contains(&value.abs()) { format!("{value:e}") } else { format!("{value}") }
}

fn listed<T>(items: impl IntoIterator<Item = T>, name: impl Fn(T) -> String) -> String {
    items.into_iter().map(name).collect::<Vec<_>>().join(", ")
}

fn inputs(filter: &Filter) -> String {
    let kind = |kind: &InputKind| match kind {
        InputKind::Mesh => "mesh".to_owned(),
        InputKind::Curves => "curves".to_owned(),
    };
    let (least, most) = (filter.min_inputs, filter.max_inputs);
    match filter.inputs {
        [] => "none".to_owned(),
        kinds if least == most => listed(kinds.iter(), kind),
        kinds if kinds.iter().all(|k| *k == kinds[0]) && most > 2 => format!("{}, {least} or more", kind(&kinds[0])),
        kinds => {
            let all = (0..most).map(|k| kinds.get(k).unwrap_or(&kinds[kinds.len() - 1]));
            let name =
                |(k, of): (usize, &InputKind)| if k < least { kind(of) } else { format!("{} (optional)", kind(of)) };
            listed(all.enumerate(), name)
        }
    }
}

fn outputs(filter: &Filter) -> String {
    listed(filter.outputs, |kind| {
        match kind {
            OutputKind::Mesh => "mesh",
            OutputKind::Curves => "curves",
            OutputKind::Text => "text",
        }
        .to_owned()
    })
}

fn kind(param: &Param) -> &'static str {
    match param.kind {
        ParamKind::Bool => "yes or no",
        ParamKind::Int => "whole number",
        ParamKind::Real => "number",
        ParamKind::Choice => "choice",
        ParamKind::Length => "length",
        ParamKind::Angle => "angle, radians",
        ParamKind::Point => "point",
        ParamKind::Direction => "direction",
        ParamKind::Plane => "plane a x + b y + c z = d",
    }
}

/// Which parameters are suggested: those whose values change with the inputs.
fn suggested(filter: &Filter) -> Vec<bool> {
    let mut given = given(filter, 100);
    for input in &mut given {
        let points = match input {
            Given::Mesh(soup) => &mut soup.points,
            Given::Curves(curves) => &mut curves.points,
        };
        points.iter_mut().for_each(|p| *p = [1.7 * p[2] + 3.0, 1.7 * p[0] + 5.0, 1.7 * p[1] + 7.0]);
    }
    let mut values = filter.defaults(&crate::editor::inputs(&given)).into_iter();
    let mut own = |param: &Param| values.by_ref().take(param.default.len()).collect::<Vec<_>>();
    filter.params.iter().map(|param| own(param) != param.default).collect()
}

fn row(param: &Param, suggested: bool) -> String {
    let range = match param.kind {
        ParamKind::Choice | ParamKind::Bool => String::new(),
        _ => format!("{} to {}", plain(param.min), plain(param.max)),
    };
    let default = match param.kind {
        ParamKind::Choice => param.choices[param.default[0] as usize].label.to_owned(),
        ParamKind::Bool => ["no", "yes"][param.default[0] as usize].to_owned(),
        _ => listed(param.default, |&value| plain(value)),
    };
    let star = if suggested { "*" } else { "" };
    let mut help = format!("**{}.** {}", param.label, param.help);
    for (k, choice) in param.choices.iter().enumerate() {
        let _ = write!(help, "<br>{k} = *{}*: {}", choice.label, choice.help);
    }
    format!("| `{}` | {} | {range} | {default}{star} | {help} |\n", param.id, kind(param))
}

fn chapter(filter: &Filter) -> String {
    let place = if filter.replaces { " Takes the place of its first input." } else { "" };
    let carried = if filter.has_origins { " Attributes are carried over." } else { "" };
    let mut text = format!(
        "\n### {}\n\n`{}` (in scripts `{}`): {} -> {}.{place}{carried}\n\n{}\n\nReference: {}.\n",
        filter.name,
        filter.id,
        filter.script_name(),
        inputs(filter),
        outputs(filter),
        filter.help,
        filter.reference
    );
    if filter.params.is_empty() {
        text += "\nNo parameters.\n";
    } else {
        text += "\n| parameter | kind | range | default | |\n|---|---|---|---|---|\n";
        filter.params.iter().zip(suggested(filter)).for_each(|(param, star)| text += &row(param, star));
    }
    text
}

fn page() -> String {
    let mut categories: Vec<&str> = Vec::new();
    for filter in FILTERS {
        if !categories.contains(&filter.category) {
            categories.push(filter.category);
        }
    }
    let mut text = HEAD.to_owned();
    for category in categories {
        let _ = writeln!(text, "\n## {category}");
        FILTERS.iter().filter(|filter| filter.category == category).for_each(|filter| text += &chapter(filter));
    }
    text
}

#[test]
fn the_reference_says_what_the_table_says() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join("docs/filters.md");
    let page = page();
    if env::var_os("GUSSET_UPDATE").is_some() {
        fs::write(&path, &page).unwrap();
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == page, "docs/filters.md is not what the table says: run the test with GUSSET_UPDATE=1");
    // Cells of a table hold no bars.
    for line in page.lines().filter(|line| line.starts_with("| `")) {
        assert_eq!(line.matches('|').count(), 6, "{line}");
    }
}
