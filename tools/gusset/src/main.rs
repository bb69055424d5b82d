//! The program `gusset` runs the filters of a plugin on files.
//!
//! `commands` declares the command line, `run` runs one filter, `batch` many files, `carry` brings attributes over, `certificate`
//! states facts about results, `reading` and `writing` open files by way of `gusset-io`, and `plugin` is the only part that calls a
//! library.

mod batch;
mod carry;
mod certificate;
mod commands;
mod failure;
mod filter_listing;
mod html;
mod info;
mod pages;
mod pieces;
mod plugin;
mod reading;
mod report;
mod request;
mod run;
mod steering;
mod values;
mod writing;

use clap::ArgMatches;
use commands::{FILTER_COMMANDS, command_line};
use failure::{Exit, Failure};
use filter_listing::{describe_filter, list_filters};
use plugin::{Filter, Geometry, Inputs, OutputKind, Plugin};
use serde_json::{Value, json};
use std::ffi::{OsStr, OsString};
use std::process::ExitCode;

fn main() -> ExitCode {
    steering::catch_size_limit();
    let words: Vec<OsString> = std::env::args_os().collect();
    let plugin = Plugin::load(plugin_name(&words).as_deref());
    let library = match &plugin {
        Ok(plugin) => plugin.title(),
        Err(failure) => format!("none: {failure}"),
    };
    let version = format!("{}\nlibrary: {library}", env!("CARGO_PKG_VERSION"));
    let matches = match command_line(plugin.as_ref().ok().copied(), version.clone(), false).try_get_matches_from(&words)
    {
        Ok(matches) => matches,
        Err(error) => return end_parsing(&error, plugin.as_ref().err()),
    };
    let Some((name, options)) = matches.subcommand() else { return ExitCode::from(Exit::Usage as u8) };
    let done = if name == "generate" {
        plugin
            .and_then(|plugin| pages::generate(command_line(Some(plugin), version, true), text(options, "what")))
            .map(Done::from)
    } else {
        dispatch(name, options, plugin)
    };
    match done {
        Ok(code) => code.into(),
        Err(failure) => end_failed(name, options, &failure),
    }
}

/// Successful ends of a command.
#[derive(Clone, Copy)]
enum Done {
    Well,
    WithDefects,
}

impl From<()> for Done {
    fn from((): ()) -> Self {
        Self::Well
    }
}

impl From<Done> for ExitCode {
    fn from(done: Done) -> Self {
        match done {
            Done::Well => Self::SUCCESS,
            Done::WithDefects => Self::from(Exit::Defects as u8),
        }
    }
}

fn text<'a>(options: &'a ArgMatches, name: &str) -> &'a str {
    options.get_one::<String>(name).map_or("", String::as_str)
}

/// Finds the value of `--plugin` before the rest is understood, because the options of commands depend on it.
fn plugin_name(words: &[OsString]) -> Option<OsString> {
    let place = words.iter().position(|word| word == "--plugin" || word.to_string_lossy().starts_with("--plugin="))?;
    let word = words[place].to_string_lossy();
    match word.strip_prefix("--plugin=") {
        Some(value) => Some(OsStr::new(value).to_owned()),
        None => words.get(place + 1).cloned(),
    }
}

/// Prints help, the version, or what is wrong with the words.
fn end_parsing(error: &clap::Error, no_library: Option<&Failure>) -> ExitCode {
    if error.use_stderr()
        && let Some(failure) = no_library
    {
        // Without a library, commands lack options.
        crate::writing::tell!("gusset: {failure}");
        return ExitCode::from(failure.exit as u8);
    }
    let is_told = error.print().is_ok();
    if !error.use_stderr() {
        return if is_told { ExitCode::SUCCESS } else { ExitCode::from(Exit::File as u8) };
    }
    if std::env::args_os().any(|word| word == "--json") {
        let failure = Failure::usage(error.to_string().trim_end());
        let _ = writing::print(&format!("{:#}\n", json!({ "error": report::describe_failure(&failure) })));
    }
    ExitCode::from(Exit::Usage as u8)
}

fn end_failed(name: &str, options: &ArgMatches, failure: &Failure) -> ExitCode {
    // Failures of several files have been told.
    if !failure.message.is_empty() {
        crate::writing::tell!("gusset: {failure}");
        if request::has_flag(options, "json") {
            let report = json!({ "command": name, "error": report::describe_failure(failure) });
            let _ = writing::print(&format!("{report:#}\n"));
        }
    }
    ExitCode::from(failure.exit as u8)
}

fn dispatch(name: &str, options: &ArgMatches, plugin: Result<Plugin, Failure>) -> Result<Done, Failure> {
    match name {
        "convert" => convert(options).map(Done::from),
        "info" => {
            let reading = request::reading(options);
            let files = request::inputs(options)?;
            let work = |place: usize| info::measure_file(&files[place], &reading);
            batch::run_all(&files, &request::batch_options(options), request::has_flag(options, "json"), work)?;
            Ok(Done::Well)
        }
        "certify" => certify(plugin?, options).map(Done::from),
        "filters" => show_filters(plugin?, options).map(Done::from),
        "run" => {
            let filter = find_filter(plugin?, text(options, "filter"))?;
            run_filter(filter, name, options, None)
        }
        _ => {
            let plugin = plugin?;
            let command = FILTER_COMMANDS.iter().find(|command| command.name == name);
            let filter = command.and_then(|command| command.filter(plugin));
            let filter = filter
                .ok_or_else(|| Failure::usage(format!("the plugin {} has no filter for {name}", plugin.title())))?;
            run_filter(filter, name, options, command)
        }
    }
}

fn find_filter(plugin: Plugin, name: &str) -> Result<Filter, Failure> {
    plugin.find(name).ok_or_else(|| {
        let filters = plugin.filters();
        let command = FILTER_COMMANDS.iter().find(|command| command.name == name);
        let near = match command.and_then(|command| command.filter(plugin)) {
            Some(filter) => Some(filter.id()),
            None => values::nearest_word(name, filters.iter().map(|filter| filter.id())),
        };
        let near = near.map(|near| format!("; did you mean {near}?")).unwrap_or_default();
        Failure::usage(format!("there is no filter {name}{near}; 'gusset filters' lists all"))
    })
}

/// Runs a filter once on all inputs, or on each of several files if it takes one.
fn run_filter(
    filter: Filter,
    name: &str,
    options: &ArgMatches,
    command: Option<&commands::FilterCommand>,
) -> Result<Done, Failure> {
    let request = request::run_request(name, options, filter, command)?;
    refuse_mixed_output(&request.outputs, request.json)?;
    let is_strict = request::has_flag(options, "strict");
    let batch = request::batch_options(options);
    let reports = if filter.max_inputs() == Some(1) && (request.inputs.len() > 1 || batch.out_dir.is_some()) {
        run_each(filter, &request, &batch)?
    } else {
        let report = run::run(filter, &request)?;
        if request.json {
            writing::print(&format!("{report:#}\n"))?;
        }
        vec![report]
    };
    Ok(if is_strict && reports.iter().any(has_defects) { Done::WithDefects } else { Done::Well })
}

/// Refuses a report and a mesh that would both go to standard output.
fn refuse_mixed_output(outputs: &[reading::FileName], json: bool) -> Result<(), Failure> {
    if json && outputs.iter().any(|file| matches!(file, reading::FileName::Standard)) {
        return Err(Failure::usage("--json and -o - would both write to standard output; leave out one"));
    }
    Ok(())
}

fn run_each(filter: Filter, request: &run::RunRequest, batch: &request::BatchOptions) -> Result<Vec<Value>, Failure> {
    let writes = filter.output_kinds().iter().any(|&kind| kind != OutputKind::Text);
    if request.html.is_some() {
        return Err(Failure::usage("--html shows the result of one file: name one input"));
    }
    if request.certificate.is_some() {
        return Err(Failure::usage("--certificate is about the result of one file: name it with -o"));
    }
    if !request.outputs.is_empty() || (writes && batch.out_dir.is_none() && !request.is_dry) {
        return Err(Failure::usage(format!(
            "{} works on one file at a time: name a folder for the results with --out-dir",
            request.command
        )));
    }
    let outputs = outputs_in_folder(&request.inputs, batch, request.writing.to)?;
    let work = |place: usize| {
        let inputs = vec![request.inputs[place].clone()];
        let outputs = outputs.get(place).cloned().into_iter().collect();
        let one = run::RunRequest { inputs, outputs, json: true, progress: false, ..request.clone() };
        let report = run::run(filter, &one)?;
        let lines = report["report"].as_array().into_iter().flatten().filter_map(Value::as_str);
        Ok((lines.map(|line| format!("{line}\n")).collect(), report))
    };
    batch::run_all(&request.inputs, batch, request.json, work)
}

/// Makes the folder of the results, and returns the result of each input; nothing without a folder.
fn outputs_in_folder(
    inputs: &[reading::FileName],
    batch: &request::BatchOptions,
    format: Option<gusset_io::Format>,
) -> Result<Vec<reading::FileName>, Failure> {
    let Some(folder) = &batch.out_dir else { return Ok(Vec::new()) };
    std::fs::create_dir_all(folder).map_err(|error| Failure::file(format!("{}: {error}", folder.display())))?;
    batch::outputs_in_folder(folder, inputs, format)
}

/// Numbers of the report of `check` that count defects of a surface.
const DEFECTS: [&str; 9] = [
    "boundary_edges",
    "non_manifold_edges",
    "orientation_conflicts",
    "non_manifold_vertices",
    "bow_ties",
    "duplicate_faces",
    "degenerate_faces",
    "zero_area_faces",
    "intersections",
];

fn has_defects(report: &Value) -> bool {
    DEFECTS.iter().any(|name| report["values"][*name].as_f64().is_some_and(|count| count > 0.0))
}

fn convert(options: &ArgMatches) -> Result<(), Failure> {
    let files = request::inputs(options)?;
    let (reading, writing, batch) =
        (request::reading(options), request::writing(options), request::batch_options(options));
    let output = options.get_one::<OsString>("output").map(reading::FileName::new);
    if output.is_some() == batch.out_dir.is_some() || (output.is_some() && files.len() != 1) {
        return Err(Failure::usage(
            "convert writes one file, named with -o, or several into the folder of --out-dir, in the format of --to",
        ));
    }
    let outputs = match output {
        Some(output) => {
            refuse_mixed_output(std::slice::from_ref(&output), request::has_flag(options, "json"))?;
            vec![output]
        }
        None => outputs_in_folder(&files, &batch, writing.to)?,
    };
    let is_dry = request::has_flag(options, "dry-run");
    let work = |place: usize| convert_file(&files[place], &outputs[place], &reading, &writing, is_dry);
    batch::run_all(&files, &batch, request::has_flag(options, "json"), work).map(|_| ())
}

fn convert_file(
    file: &reading::FileName,
    output: &reading::FileName,
    reading: &reading::Reading,
    writing: &writing::Writing,
    is_dry: bool,
) -> Result<batch::FileReport, Failure> {
    let document = reading.convertible(file)?;
    let content = reading::main_content(&document);
    writing.check(output, content)?;
    let mut described = reading::describe(&file.shown(), &document);
    described["notes"] = document.notes.iter().map(|note| note.text.as_str()).collect();
    let mut made = reading::describe(&output.shown(), &document);
    made["lost"] = json!(if is_dry { Vec::new() } else { writing.write(output, &document, Vec::new())? });
    Ok((String::new(), json!({ "command": "convert", "inputs": [described], "outputs": [made] })))
}

fn certify(plugin: Plugin, options: &ArgMatches) -> Result<(), Failure> {
    let files = request::inputs(options)?;
    if files.len() < 2 {
        return Err(Failure::usage("certify takes one or more inputs, then their result"));
    }
    let split = files.split_at(files.len() - 1);
    let output = options.get_one::<OsString>("output").map_or(reading::FileName::Standard, reading::FileName::new);
    certificate::refuse_replacing_mesh(&output, files.iter())?;
    let (threads, steering) = request::steering(options);
    certificate::write_certificate(plugin, split.into(), &output, &request::reading(options), threads, &steering)
}

fn show_filters(plugin: Plugin, options: &ArgMatches) -> Result<(), Failure> {
    let json = request::has_flag(options, "json");
    let Some(name) = options.get_one::<String>("filter") else {
        let filters = plugin.filters();
        return writing::print(&if request::has_flag(options, "ids") {
            filters.iter().map(|filter| format!("{}\n", filter.id())).collect()
        } else if json {
            format!(
                "{:#}\n",
                filters.iter().map(|&filter| report::describe_filter(filter, false, None)).collect::<Value>()
            )
        } else {
            list_filters(&filters)
        });
    };
    let filter = find_filter(plugin, name)?;
    let suggested = suggested_values(filter, options)?;
    writing::print(&if json {
        format!("{:#}\n", report::describe_filter(filter, true, suggested.as_deref()))
    } else {
        describe_filter(filter, suggested.as_deref())
    })
}

/// Returns the values that suit the inputs, if there are inputs.
fn suggested_values(filter: Filter, options: &ArgMatches) -> Result<Option<Vec<f64>>, Failure> {
    let files = request::inputs(options)?;
    if files.is_empty() {
        return Ok(None);
    }
    run::check_count(filter, files.len())?;
    let reading = request::reading(options);
    let read = |(place, file): (usize, &reading::FileName)| {
        Ok(if filter.input_kind(place) == OutputKind::Curves {
            Geometry::Curves(reading.curves(file)?)
        } else {
            Geometry::Mesh(Box::new(reading.mesh(file)?))
        })
    };
    let geometry: Vec<Geometry> = files.iter().enumerate().map(read).collect::<Result<_, Failure>>()?;
    let (values, is_accepted) = filter.suggest(&Inputs::new(geometry));
    if !is_accepted {
        return Err(Failure::new(
            Exit::Refused,
            format!("{} refuses these inputs; 'gusset run {} ...' says why", filter.id(), filter.id()),
        ));
    }
    Ok(Some(values))
}
