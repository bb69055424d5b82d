//! The commands: what each does, its filter, an example, and its arguments.

use crate::plugin::{Filter, OutputKind, Param, ParamKind, Plugin};
use crate::values::{print_value, slug};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, Command, ValueHint, value_parser};
use gusset_io::Format;
use std::ffi::OsString;

/// A command that runs one filter.
pub(crate) struct FilterCommand {
    pub(crate) name: &'static str,
    /// Ids of the filter; the plugin's first one counts.
    filters: &'static [&'static str],
    about: &'static str,
    example: &'static str,
    /// Parameters that `--smooth` sets, if the command has it.
    pub(crate) smooth: &'static [&'static str],
    /// Whether it has `--certificate`.
    certifies: bool,
}

impl FilterCommand {
    pub(crate) fn filter(&self, plugin: Plugin) -> Option<Filter> {
        self.filters.iter().find_map(|id| plugin.find(id))
    }
}

/// All commands that run one filter, in the order of the help.
pub(crate) const FILTER_COMMANDS: &[FilterCommand] = &[
    FilterCommand {
        name: "join",
        filters: &["join"],
        about: "Joins two or more open meshes where their borders coincide or face each other",
        example: "gusset join left.ply middle.ply right.ply -o whole.ply",
        smooth: &["finish=blend"],
        certifies: true,
    },
    FilterCommand {
        name: "stitch",
        filters: &["stitch"],
        about: "Joins two open meshes, or two rims of one mesh, by a strip of new faces",
        example: "gusset stitch left.obj right.obj -o joined.obj",
        smooth: &["finish=blend"],
        certifies: true,
    },
    FilterCommand {
        name: "fill",
        filters: &["fill"],
        about: "Closes the holes of a mesh",
        example: "gusset fill scan.obj --keep the-longest -o filled.obj",
        smooth: &["finish=blend"],
        certifies: true,
    },
    FilterCommand {
        name: "repair",
        filters: &["repair"],
        about: "Removes the defects of a mesh, to get a valid solid where possible",
        example: "gusset repair part.stl -o repaired.stl",
        smooth: &[],
        certifies: true,
    },
    FilterCommand {
        name: "unite",
        filters: &["unite"],
        about: "Replaces closed meshes by their union",
        example: "gusset unite handle.stl blade.stl -o tool.stl",
        smooth: &[],
        certifies: true,
    },
    FilterCommand {
        name: "weld",
        filters: &["weld"],
        about: "Merges borders whose vertices coincide",
        example: "gusset weld part.stl -o welded.ply",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "sew",
        filters: &["sew"],
        about: "Merges borders that lie on each other, and splits edges where their vertices differ",
        example: "gusset sew tiles.obj -o sheet.obj",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "orient",
        filters: &["orient"],
        about: "Reverses faces until neighbours agree",
        example: "gusset orient part.obj --outward outwards -o oriented.obj",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "align",
        filters: &["align"],
        about: "Moves overlapping pieces to where they fit",
        example: "gusset align scan1.ply scan2.ply -o aligned.ply",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "trim",
        filters: &["trim"],
        about: "Removes the faces of one piece where two overlap",
        example: "gusset trim scan1.ply scan2.ply -o trimmed.ply",
        smooth: &[],
        certifies: true,
    },
    FilterCommand {
        name: "section",
        filters: &["section", "smooth_sections"],
        about: "Cuts a mesh, or the smooth surface through a grid of quads, by planes",
        example: "gusset section foot.ply --number 20 -o sections.obj",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "loft",
        filters: &["loft"],
        about: "Makes a smooth surface through two or more curves",
        example: "gusset loft sections.obj -o surface.obj",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "flatten",
        filters: &["flatten", "develop"],
        about: "Unrolls a surface into the plane",
        example: "gusset flatten sail.obj -o pattern.obj",
        smooth: &[],
        certifies: false,
    },
    FilterCommand {
        name: "check",
        filters: &["check"],
        about: "Reports the defects of meshes, and counts their pieces, edges and genus",
        example: "gusset check part.stl --strict",
        smooth: &[],
        certifies: false,
    },
];

pub(crate) const SUMMARY: &str = "Joins, fills, mends and checks meshes in files.";

const EXPLANATION: &str = "\
Meshes are OBJ, PLY, STL, OFF, glTF, GLB or 3MF files, or .conf lists of scans. Curves are OBJ, glTF, GLB, SVG,
DXF, XYZ or CSV files. Colours, normals, texture coordinates and materials are kept if the format holds them.
Each loss is named on standard error.";

const HINT: &str =
    "'gusset COMMAND --help' shows the options of a command. 'gusset filters FILTER' explains its parameters.";

/// Builds the command line. `in_full` adds the full explanation of each parameter, for the manual.
pub(crate) fn command_line(plugin: Option<Plugin>, version: String, in_full: bool) -> Command {
    let builder = Builder { plugin, in_full };
    let mut statuses = String::from("Exit status:\n");
    for (status, meaning) in crate::failure::Exit::MEANINGS {
        statuses += &format!("  {status}  {meaning}\n");
    }
    Command::new("gusset")
        .about(SUMMARY)
        .before_help("Example: gusset join left.ply right.ply -o whole.ply")
        .long_about(SUMMARY)
        .version(version)
        .after_help(format!("{EXPLANATION}\n\n{statuses}\n{HINT}"))
        .subcommand_required(true)
        .arg_required_else_help(false)
        .disable_help_subcommand(true)
        .max_term_width(MAX_WIDTH)
        .arg(
            Arg::new("plugin")
                .long("plugin")
                .value_name("LIBRARY")
                .value_hint(ValueHint::FilePath)
                .value_parser(value_parser!(OsString))
                .global(true)
                .hide_short_help(false)
                .help("Runs the filters of this library instead"),
        )
        .subcommands(FILTER_COMMANDS.iter().map(|command| builder.filter_command(command)))
        .subcommands([
            builder.convert(),
            builder.info(),
            builder.certify(),
            builder.filters(),
            builder.run(),
            generate(),
        ])
}

/// Widest line of the help.
pub(crate) const MAX_WIDTH: usize = 100;

/// Example first, so that it is read first.
const TEMPLATE: &str = "{before-help}{about}\n\n{usage-heading} {usage}\n\n{all-args}{after-help}";

struct Builder {
    plugin: Option<Plugin>,
    in_full: bool,
}

impl Builder {
    fn subcommand(&self, name: &'static str, about: &'static str, example: &'static str) -> Command {
        Command::new(name).about(about).before_help(format!("Example: {example}")).help_template(TEMPLATE)
    }

    fn filter_command(&self, command: &'static FilterCommand) -> Command {
        let filter = self.plugin.and_then(|plugin| command.filter(plugin));
        let mut made = self
            .subcommand(command.name, command.about, command.example)
            .arg(inputs("Files or folders to read; - is standard input", 1));
        let writes = filter.is_none_or(|filter| filter.output_kinds().iter().any(|&kind| kind != OutputKind::Text));
        if writes {
            // All inputs of some filters make one result.
            let has_many_results = filter.is_none_or(|filter| filter.max_inputs() == Some(1));
            let is_offered =
                |option: &Arg| has_many_results || !["out-dir", "jobs"].contains(&option.get_id().as_str());
            made = made.args(output_options(false).into_iter().filter(is_offered));
            if !has_many_results {
                made = made
                    .mut_arg("output", |output| output.help("File to write; - is standard output"))
                    .mut_arg("to", |format| format.help("Format of standard output, such as ply"));
            }
        }
        if !command.smooth.is_empty() {
            made = made.arg(
                flag("smooth")
                    .help("Makes new faces continue the surfaces beside them (sets finish or inside)")
                    .help_heading(PARAMETERS),
            );
        }
        if command.certifies {
            let help = "Writes a certificate of the result, which verify.py checks";
            made = made.arg(file("certificate").value_name("FILE").help(help).help_heading(FILES));
        }
        if command.name == "check" {
            made = made
                .arg(flag("strict").help("Exits with 7 if the mesh has defects, open borders included"))
                .arg(jobs());
        }
        let taken: Vec<String> = made.get_arguments().map(|arg| arg.get_id().to_string()).collect();
        for param in filter.map(Filter::params).unwrap_or_default() {
            if !taken.contains(&slug(param.id())) {
                made = made.arg(self.parameter(param));
            }
        }
        made.args(run_options()).args(read_options())
    }

    /// An option for a parameter, with its label as help, or its whole explanation in the manual.
    fn parameter(&self, param: Param) -> Arg {
        let choices: Vec<String> = param.choices().iter().map(|(label, _)| slug(label)).collect();
        let mut help = if self.in_full { param.help().to_owned() } else { param.label().to_owned() };
        help = help.trim_end_matches('.').to_owned();
        let default = print_value(param, param.default_values());
        if param.kind() == ParamKind::Choice {
            let words: Vec<String> =
                choices.iter().map(|word| format!("{word}{}", if *word == default { "*" } else { "" })).collect();
            help += &format!(": {}", words.join(", "));
        } else if param.kind() != ParamKind::Bool || param.default_values()[0] != 0.0 {
            help += &format!(" [{default}]");
        }
        let made = Arg::new(slug(param.id()))
            .long(slug(param.id()))
            .help(help)
            .help_heading(PARAMETERS)
            .allow_hyphen_values(true);
        match param.kind() {
            ParamKind::Bool => made
                .num_args(0..=1)
                .value_name("BOOL")
                .require_equals(true)
                .default_missing_value("true")
                .value_parser(["true", "false"])
                .hide_possible_values(true),
            ParamKind::Choice => made
                .value_name("CHOICE")
                .value_parser(PossibleValuesParser::new(choices))
                .hide_possible_values(true)
                .ignore_case(true)
                .allow_hyphen_values(false),
            ParamKind::Integer => made.value_name("N"),
            ParamKind::Length => made.value_name("LENGTH"),
            ParamKind::Angle => made.value_name("DEGREES"),
            ParamKind::Point | ParamKind::Direction => made.value_name("X,Y,Z"),
            ParamKind::Plane => made.value_name("A,B,C,D"),
            ParamKind::Real | ParamKind::Unknown => made.value_name("NUMBER"),
        }
    }

    fn convert(&self) -> Command {
        self.subcommand("convert", "Writes meshes in another format", "gusset convert part.stl -o part.glb")
            .arg(inputs("Files or folders to read; - is standard input", 1))
            .args(output_options(false))
            .args(read_options())
            .arg(json())
    }

    fn info(&self) -> Command {
        self.subcommand("info", "Measures meshes: box, area, volume, centre, likely unit", "gusset info part.stl")
            .arg(inputs("Files or folders to read; - is standard input", 1))
            .args(read_options())
            .arg(json())
            .arg(jobs())
    }

    fn certify(&self) -> Command {
        let about = "States facts about a result and the files it was made from, for verify.py to check";
        let [_, threads, progress, cancel_after] = run_options();
        self.subcommand("certify", about, "gusset certify left.ply right.ply whole.ply -o whole.json")
            .arg(inputs("Files that the result was made from, then the result", 1))
            .arg(file("output").short('o').value_name("FILE").help("File to write instead of standard output"))
            .args([threads, progress, cancel_after])
            .args(read_options())
    }

    fn filters(&self) -> Command {
        self.subcommand("filters", "Lists all filters, or describes one and its parameters", "gusset filters fill")
            .arg(self.filter_argument("Filter to describe"))
            .arg(inputs("Shows the values that suit these files", 0))
            .arg(flag("ids").help("Lists only the names of the filters"))
            .arg(json())
            .args(read_options())
    }

    /// The name of a filter. Completions offer the ids; the plugin decides, and suggests.
    fn filter_argument(&self, help: &'static str) -> Arg {
        let made = Arg::new("filter").help(help);
        let Some(plugin) = self.plugin.filter(|_| self.in_full) else { return made };
        let ids = plugin.filters().into_iter().map(Filter::id);
        made.value_parser(PossibleValuesParser::new(ids)).hide_possible_values(true)
    }

    fn run(&self) -> Command {
        let filter = self.filter_argument("Filter, as 'gusset filters' names it").required(true);
        self.subcommand("run", "Runs any filter", "gusset run curve_resample outline.svg -p number=200 -o points.csv")
            .arg(filter)
            .arg(inputs("Files or folders to read; - is standard input", 0))
            .arg(Arg::new("param").short('p').long("param").value_name("NAME=VALUE").action(ArgAction::Append).help(
                "Sets a parameter, which 'gusset filters <filter>' lists; a choice by its word or number, \
                         a vector as x,y,z, an angle in degrees",
            ))
            .args(output_options(true))
            .args(run_options())
            .args(read_options())
    }
}

const PARAMETERS: &str = "Parameters (* and [] are defaults)";
const FILES: &str = "Files";

fn flag(name: &'static str) -> Arg {
    Arg::new(name).long(name).action(ArgAction::SetTrue)
}

fn inputs(help: &'static str, least: usize) -> Arg {
    Arg::new("input")
        .value_name("FILE")
        .help(help)
        .num_args(least..)
        .required(least > 0)
        .value_hint(ValueHint::FilePath)
        .value_parser(value_parser!(OsString))
}

fn file(name: &'static str) -> Arg {
    Arg::new(name).long(name).value_parser(value_parser!(OsString)).value_hint(ValueHint::FilePath)
}

fn output_options(repeats: bool) -> [Arg; 8] {
    let help = if repeats {
        "File to write; repeat it for the second output"
    } else {
        "File to write; - is standard output. For many inputs, use --out-dir"
    };
    let action = if repeats { ArgAction::Append } else { ArgAction::Set };
    [
        file("output").short('o').value_name("FILE").action(action).help(help),
        file("out-dir")
            .value_name("FOLDER")
            .help("Writes each result to this folder, under its input's name")
            .help_heading(FILES),
        file("html")
            .value_name("FILE")
            .help("Writes a web page that shows inputs and result in 3-D")
            .help_heading(FILES),
        flag("dry-run").short('n').help("Runs and prints the report, but writes no file"),
        flag("text").help("Writes PLY and STL files as text").help_heading(FILES),
        flag("lossy")
            .help("Permits rounding that moves points by over 0.001 of the mean edge length")
            .help_heading(FILES),
        format_option("to").help("Format of standard output and of files in --out-dir, such as ply"),
        jobs(),
    ]
}

fn format_option(name: &'static str) -> Arg {
    let words = Format::ALL.iter().map(|(format, _)| format.extension());
    Arg::new(name)
        .long(name)
        .value_name("FORMAT")
        .value_parser(PossibleValuesParser::new(words))
        .hide_possible_values(true)
        .help_heading(FILES)
}

fn read_options() -> [Arg; 2] {
    [
        format_option("from").help("Format of standard input; needed for xyz and csv"),
        flag("follow-outside").help("Also opens files outside of the input's folder that it names").help_heading(FILES),
    ]
}

fn jobs() -> Arg {
    Arg::new("jobs")
        .long("jobs")
        .value_name("N")
        .value_parser(value_parser!(u16).range(1..))
        .help("Files to work on at a time [default: 1]")
        .help_heading(FILES)
}

fn json() -> Arg {
    flag("json").help("Prints the report, or the error, as JSON")
}

fn run_options() -> [Arg; 4] {
    [
        json(),
        Arg::new("threads")
            .long("threads")
            .value_name("N")
            .value_parser(value_parser!(u32))
            .help("Most threads to use [default: all]"),
        flag("progress").help("Shows progress even if standard error is not a terminal"),
        Arg::new("cancel-after")
            .long("cancel-after")
            .value_name("SECONDS")
            .value_parser(parse_seconds)
            .help("Stops the filter after this time, with exit status 5"),
    ]
}

fn parse_seconds(text: &str) -> Result<std::time::Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| "not a number of seconds".to_owned())?;
    std::time::Duration::try_from_secs_f64(seconds).map_err(|_| "not a number of seconds from 0".to_owned())
}

fn generate() -> Command {
    Command::new("generate")
        .about("Prints the manual or the completions of a shell")
        .hide(true)
        .arg(Arg::new("what").required(true).value_parser(["man", "bash", "zsh", "fish", "powershell"]))
}
