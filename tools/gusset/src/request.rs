//! Requests from the options of the command line.

use crate::commands::FilterCommand;
use crate::failure::Failure;
use crate::plugin::Filter;
use crate::reading::{FileName, Reading, expand_folders};
use crate::run::RunRequest;
use crate::steering::Steering;
use crate::values::slug;
use crate::writing::Writing;
use clap::ArgMatches;
use clap::parser::ValueSource;
use gusset_io::{Format, ReadOptions, WriteOptions};
use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// Returns whether a flag is given. Commands without the flag have it unset.
pub(crate) fn has_flag(options: &ArgMatches, name: &str) -> bool {
    options.try_get_one::<bool>(name).ok().flatten().copied().unwrap_or(false)
}

/// Returns an option of a type, if the command has it and it is given.
fn option<T: Clone + Send + Sync + 'static>(options: &ArgMatches, name: &str) -> Option<T> {
    options.try_get_one::<T>(name).ok().flatten().cloned()
}

fn all<T: Clone + Send + Sync + 'static>(options: &ArgMatches, name: &str) -> Vec<T> {
    options.try_get_many::<T>(name).ok().flatten().map(|values| values.cloned().collect()).unwrap_or_default()
}

/// Returns how inputs are read.
pub(crate) fn reading(options: &ArgMatches) -> Reading {
    let follow_outside = has_flag(options, "follow-outside");
    Reading {
        options: ReadOptions { follow_outside, ..ReadOptions::default() },
        from: option::<String>(options, "from").and_then(|word| Format::from_extension(&word)),
    }
}

/// Returns how outputs are written.
pub(crate) fn writing(options: &ArgMatches) -> Writing {
    Writing {
        options: WriteOptions {
            text: has_flag(options, "text"),
            lossy: has_flag(options, "lossy"),
            stop: Some(Arc::new(crate::steering::is_stopped)),
        },
        to: option::<String>(options, "to").and_then(|word| Format::from_extension(&word)),
    }
}

/// Returns the input files, with folders replaced by their mesh files.
pub(crate) fn inputs(options: &ArgMatches) -> Result<Vec<FileName>, Failure> {
    expand_folders(&all::<OsString>(options, "input"))
}

/// Returns the request of a command that runs a filter.
pub(crate) fn run_request(
    name: &str,
    options: &ArgMatches,
    filter: Filter,
    command: Option<&FilterCommand>,
) -> Result<RunRequest, Failure> {
    let mut params = all::<String>(options, "param");
    if let Some(command) = command {
        params.extend(given_params(options, filter));
        if has_flag(options, "smooth") {
            for set in command.smooth {
                let name = set.split('=').next().unwrap_or(set);
                if params.iter().any(|given| given.split('=').next() == Some(name)) {
                    return Err(Failure::usage(format!("--smooth sets {set}; leave out --smooth or --{}", slug(name))));
                }
                params.push((*set).to_owned());
            }
        }
    }
    Ok(RunRequest {
        command: name.to_owned(),
        inputs: inputs(options)?,
        params,
        outputs: all::<OsString>(options, "output").iter().map(FileName::new).collect(),
        is_dry: has_flag(options, "dry-run"),
        json: has_flag(options, "json"),
        reading: reading(options),
        writing: writing(options),
        threads: option(options, "threads").unwrap_or(0),
        progress: shows_progress(options),
        cancel_after: option::<Duration>(options, "cancel-after"),
        html: option::<OsString>(options, "html").map(PathBuf::from),
        certificate: option::<OsString>(options, "certificate").map(|word| FileName::new(&word)),
    })
}

fn shows_progress(options: &ArgMatches) -> bool {
    has_flag(options, "progress") || std::io::IsTerminal::is_terminal(&std::io::stderr())
}

/// Returns the number of threads, and what follows a run without a filter.
pub(crate) fn steering(options: &ArgMatches) -> (u32, Steering) {
    let steering = Steering::new(shows_progress(options), option::<Duration>(options, "cancel-after"));
    (option(options, "threads").unwrap_or(0), steering)
}

/// Parameters that are options of the command.
fn given_params(options: &ArgMatches, filter: Filter) -> Vec<String> {
    let given = |param: &crate::plugin::Param| {
        let name = slug(param.id());
        let is_given = options.try_contains_id(&name).unwrap_or(false)
            && options.value_source(&name) == Some(ValueSource::CommandLine);
        let value = if is_given { option::<String>(options, &name) } else { None };
        value.map(|value| format!("{}={value}", param.id()))
    };
    filter.params().iter().filter_map(given).collect()
}

/// How several files are worked on.
pub(crate) struct BatchOptions {
    pub(crate) out_dir: Option<PathBuf>,
    pub(crate) jobs: usize,
}

/// Returns how several files are worked on.
pub(crate) fn batch_options(options: &ArgMatches) -> BatchOptions {
    BatchOptions {
        out_dir: option::<OsString>(options, "out-dir").map(PathBuf::from),
        jobs: option::<u16>(options, "jobs").map_or(1, usize::from),
    }
}
