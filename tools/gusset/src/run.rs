//! A run of a filter from files to files.

use crate::carry::carry;
use crate::certificate::{check_files, refuse_replacing_mesh, write_certificate};
use crate::failure::{Exit, Failure, Refusal, counted};
use crate::html;
use crate::pieces::{Piece, attribute_names};
use crate::plugin::{Domain, Filter, Geometry, Inputs, OutputKind, Outputs, Param, ParamKind, RunError};
use crate::reading::{FileName, Reading};
use crate::report::{describe_curves, describe_geometry, describe_mesh, describe_named_value, describe_values};
use crate::steering::Steering;
use crate::values::{degrees, parse_values};
use crate::writing::{Writing, print};
use gusset_io::{Content, Document, Positions};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The inputs, outputs and choices of a command.
#[derive(Clone)]
pub(crate) struct RunRequest {
    pub(crate) command: String,
    pub(crate) inputs: Vec<FileName>,
    /// Parameters, each `name=value`.
    pub(crate) params: Vec<String>,
    pub(crate) outputs: Vec<FileName>,
    pub(crate) is_dry: bool,
    pub(crate) json: bool,
    pub(crate) reading: Reading,
    pub(crate) writing: Writing,
    pub(crate) threads: u32,
    pub(crate) progress: bool,
    pub(crate) cancel_after: Option<Duration>,
    /// Page that shows the result.
    pub(crate) html: Option<PathBuf>,
    /// File for the certificate of the result.
    pub(crate) certificate: Option<FileName>,
}

/// Runs a filter, prints its texts unless JSON is asked for, and writes its results. Returns the report.
pub(crate) fn run(filter: Filter, request: &RunRequest) -> Result<Value, Failure> {
    check_count(filter, request.inputs.len())?;
    let files = assign_outputs(filter, request)?;
    if request.certificate.is_some() {
        let result = request.outputs.first().filter(|_| !request.is_dry);
        let result = result.ok_or_else(|| Failure::usage("--certificate is about a file: name the result with -o"))?;
        check_files(&request.inputs, result)?;
    }
    let page = request.html.clone().map(FileName::Path);
    for written in request.certificate.iter().chain(&page) {
        refuse_replacing_mesh(written, request.inputs.iter().chain(&request.outputs))?;
    }
    // Wrong words are refused before files are read.
    parse_values(filter, filter.default_values(), &request.params)?;
    let loaded = Loaded::read(filter, request)?;
    // If the filter refuses these inputs, the run says why.
    let (suggested, _) = filter.suggest(&loaded.inputs);
    let values = parse_values(filter, suggested, &request.params)?;
    let geometry = loaded.inputs.geometry();
    let mut report = json!({
        "command": request.command,
        "filter": filter.id(),
        "inputs": loaded.names.iter().zip(geometry).map(|(name, one)| describe_geometry(name, one)).collect::<Vec<_>>(),
        "parameters": describe_values(filter, &values),
        "outputs": [],
    });
    let origins = filter.plugin().carries_attributes() && (loaded.carries_attributes() || request.html.is_some());
    let steering = Steering::new(request.progress, request.cancel_after);
    let outputs = filter.run(&loaded.inputs, &values, request.threads, origins, &steering);
    let late = steering.time_since_deadline();
    steering.finish();
    let outputs = outputs.map_err(|error| failure(error, filter, &loaded.names, late))?;
    write_outputs(&outputs, &files, &loaded, request, &mut report)?;
    if let Some(path) = &request.html {
        write_page(path, &outputs, &loaded, request, &report)?;
    }
    if let Some(file) = &request.certificate {
        let steering = Steering::new(request.progress, None);
        let files = [&request.inputs[..], &request.outputs[..1]];
        let done = write_certificate(filter.plugin(), files, file, &request.reading, request.threads, &steering);
        steering.finish();
        done?;
    }
    Ok(report)
}

/// Inputs that were read.
struct Loaded {
    inputs: Inputs,
    /// The name of each input.
    names: Vec<String>,
}

impl Loaded {
    fn read(filter: Filter, request: &RunRequest) -> Result<Self, Failure> {
        let (mut geometry, mut names) = (Vec::new(), Vec::new());
        for file in &request.inputs {
            if filter.input_kind(geometry.len()) == OutputKind::Curves {
                geometry.push(Geometry::Curves(request.reading.curves(file)?));
                names.push(file.shown());
                continue;
            }
            // A filter of one mesh takes a list of scans as one.
            let pieces = match filter.max_inputs() {
                Some(1) => vec![request.reading.mesh(file)?],
                _ => request.reading.pieces(file)?,
            };
            for piece in pieces {
                names.push(piece.path.clone());
                geometry.push(Geometry::Mesh(Box::new(piece)));
            }
        }
        check_count(filter, geometry.len())?;
        make_one_precision(&mut geometry);
        Ok(Self { inputs: Inputs::new(geometry), names })
    }

    fn meshes(&self) -> Vec<&Piece> {
        fn piece(geometry: &Geometry) -> Option<&Piece> {
            if let Geometry::Mesh(piece) = geometry { Some(piece) } else { None }
        }
        self.inputs.geometry().iter().filter_map(piece).collect()
    }

    fn carries_attributes(&self) -> bool {
        self.meshes().iter().any(|piece| !attribute_names(&piece.mesh).is_empty())
    }

    /// Returns whether all meshes have single precision.
    fn are_single(&self) -> bool {
        self.meshes().iter().all(|piece| matches!(piece.mesh.positions, Positions::F32(_)))
    }
}

/// Converts all meshes to double precision if one has it.
fn make_one_precision(geometry: &mut [Geometry]) {
    let is_double =
        |one: &Geometry| matches!(one, Geometry::Mesh(piece) if matches!(piece.mesh.positions, Positions::F64(_)));
    if geometry.iter().any(is_double) {
        for one in geometry {
            if let Geometry::Mesh(piece) = one
                && let Positions::F32(points) = &piece.mesh.positions
            {
                piece.mesh.positions = Positions::F64(points.iter().map(|point| point.map(f64::from)).collect());
            }
        }
    }
}

/// Refuses a wrong number of inputs.
pub(crate) fn check_count(filter: Filter, count: usize) -> Result<(), Failure> {
    let [least, most] = [Some(filter.min_inputs()), filter.max_inputs()];
    if count >= filter.min_inputs() && most.is_none_or(|most| count <= most) {
        return Ok(());
    }
    let range = match (least, most) {
        (Some(least), None) => format!("{least} or more inputs"),
        (Some(least), Some(most)) if least < most => format!("{least} to {most} inputs"),
        (_, most) => counted(most.unwrap_or(0), "input"),
    };
    Err(Failure::usage(format!("{} takes {range}, not {count}", filter.id())))
}

/// Assigns the named files to outputs that are not texts, and refuses formats that cannot hold them.
fn assign_outputs(filter: Filter, request: &RunRequest) -> Result<Vec<Option<FileName>>, Failure> {
    let kinds = filter.output_kinds();
    let mut rest = request.outputs.iter();
    let mut files = Vec::new();
    for &kind in &kinds {
        let file = if kind == OutputKind::Text { None } else { rest.next() };
        if let Some(file) = file {
            request.writing.check(file, if kind == OutputKind::Mesh { Content::Meshes } else { Content::Curves })?;
        }
        files.push(file.cloned());
    }
    let used = files.iter().flatten().count();
    if used < request.outputs.len() {
        return Err(Failure::usage(format!(
            "{} writes {}, and {} are named",
            filter.id(),
            counted(used, "file"),
            request.outputs.len()
        )));
    }
    let makes_mesh = kinds.contains(&OutputKind::Mesh);
    if request.outputs.is_empty() && !request.is_dry && (makes_mesh || !kinds.contains(&OutputKind::Text)) {
        let what = if makes_mesh { "a mesh" } else { "curves" };
        return Err(Failure::usage(format!(
            "{} makes {what}: name the file with -o, or print the report alone with --dry-run",
            request.command
        )));
    }
    Ok(files)
}

fn failure(error: RunError, filter: Filter, names: &[String], late: Option<Duration>) -> Failure {
    match error {
        RunError::Cancelled => {
            let late = late.map(|time| format!(", {} ms after the request", time.as_millis())).unwrap_or_default();
            Failure::new(Exit::Cancelled, format!("cancelled{late}"))
        }
        RunError::OutOfMemory(message) => Failure::new(Exit::Memory, format!("{}: {message}", filter.id())),
        RunError::Internal(message) => Failure::new(Exit::Plugin, format!("{}: {message}", filter.id())),
        RunError::Refused { message, status, parameter, input, element } => {
            // The library counts inputs from 0; people have files.
            let name = input.and_then(|input| names.get(input as usize));
            let named = name.zip(input.and_then(|input| message.strip_prefix(&format!("input {input}"))));
            let message = named.map_or_else(|| message.clone(), |(name, rest)| format!("{name}{rest}"));
            let mut text = format!("{}: {message} (status {status}", filter.id());
            if let Some(parameter) = parameter {
                text += &format!(", parameter {parameter}{}", range_in_degrees(filter, parameter));
            }
            if let Some(name) = name {
                text += &format!(", input {}: {name}", input.unwrap_or(0) + 1);
            }
            if let Some((element, index)) = element {
                text += &format!(", {element} {index}");
            }
            let refusal = Refusal { status: Some(status), parameter: parameter.map(str::to_owned), input, element };
            Failure { exit: Exit::Refused, message: text + ")", refusal }
        }
    }
}

/// Returns the range of an angle in degrees, as users type it. The library's message has radians.
fn range_in_degrees(filter: Filter, parameter: &str) -> String {
    let is_angle = |param: &Param| param.id() == parameter && param.kind() == ParamKind::Angle;
    let range = filter.params().into_iter().find(is_angle).map(|param| param.range().map(degrees));
    range.map(|[low, high]| format!(" from {low} to {high} degrees")).unwrap_or_default()
}

fn write_outputs(
    outputs: &Outputs,
    files: &[Option<FileName>],
    loaded: &Loaded,
    request: &RunRequest,
    report: &mut Value,
) -> Result<(), Failure> {
    for (index, file) in files.iter().enumerate() {
        let output = index as u32;
        match (outputs.kind(output), file) {
            (OutputKind::Text, _) => add_text(outputs, output, request, report)?,
            (OutputKind::Mesh, Some(file)) if !request.is_dry => {
                let made = write_mesh(outputs, output, file, loaded, request)?;
                push(report, "outputs", made);
            }
            (OutputKind::Curves, Some(file)) if !request.is_dry => {
                let curves = outputs
                    .curves(output)
                    .ok_or_else(|| Failure::new(Exit::Plugin, format!("output {output} is not curves")))?;
                let mut made = describe_curves(&file.shown(), &curves);
                let lost = request.writing.write(file, &Document { curves, ..Document::default() }, Vec::new())?;
                made["lost"] = json!(lost);
                push(report, "outputs", made);
            }
            _ => {}
        }
    }
    Ok(())
}

fn push(report: &mut Value, list: &str, item: Value) {
    if let Some(items) = report[list].as_array_mut() {
        items.push(item);
    } else {
        report[list] = json!([item]);
    }
}

/// Adds the lines of a text, and the numbers in it; prints the text unless JSON is asked for.
fn add_text(outputs: &Outputs, output: u32, request: &RunRequest, report: &mut Value) -> Result<(), Failure> {
    let text = outputs.text(output);
    for line in text.lines() {
        push(report, "report", json!(line));
    }
    for value in outputs.values(output) {
        report["values"][value.name] = describe_named_value(&value);
    }
    let is_piped = request.outputs.iter().any(|file| matches!(file, FileName::Standard));
    if request.json {
        Ok(())
    } else if is_piped {
        crate::writing::tell!("{}", text.trim_end());
        Ok(())
    } else {
        print(text)
    }
}

fn write_mesh(
    outputs: &Outputs,
    output: u32,
    file: &FileName,
    loaded: &Loaded,
    request: &RunRequest,
) -> Result<Value, Failure> {
    let mesh =
        outputs.mesh(output).ok_or_else(|| Failure::new(Exit::Plugin, format!("output {output} is not a mesh")))?;
    let metres_per_unit = loaded.meshes().first().and_then(|piece| piece.metres_per_unit);
    let mut piece = Piece { path: file.shown(), mesh, metres_per_unit, ..Piece::default() };
    let origins = outputs.origins(output);
    let lost = carry(&loaded.meshes(), origins.as_ref(), &mut piece)?;
    if loaded.are_single() {
        piece.mesh.positions = narrowed(std::mem::take(&mut piece.mesh.positions));
    }
    let mut made = describe_mesh(&file.shown(), &piece.mesh);
    made["lost"] = json!(request.writing.write(file, &piece.into_document(), lost)?);
    Ok(made)
}

/// Writes the page that shows the first output mesh beside the inputs.
fn write_page(
    path: &Path,
    outputs: &Outputs,
    loaded: &Loaded,
    request: &RunRequest,
    report: &Value,
) -> Result<(), Failure> {
    let index = (0..outputs.count()).find(|&index| outputs.kind(index) == OutputKind::Mesh);
    let mesh = index.and_then(|index| outputs.mesh(index));
    let (Some(index), Some(mesh)) = (index, mesh) else {
        return Err(Failure::usage(format!("{} makes no mesh for --html to show", request.command)));
    };
    let sources = outputs.origins(index).and_then(|origins| origins.sources(Domain::Faces));
    let input =
        |face: usize| sources.as_ref().map_or(Some(0), |sources| sources.single(face).map(|(input, _)| input as u32));
    let inputs = (0..mesh.face_count()).map(input).collect();
    let lines: Vec<&str> = report["report"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    let title = format!("{}: {}", request.command, loaded.names.join(", "));
    html::write_page(path, &title, &lines.join("; "), &loaded.meshes(), &html::Body { mesh: &mesh, inputs })
}

/// Returns points in single precision if that keeps all of them.
fn narrowed(positions: Positions) -> Positions {
    let Positions::F64(points) = &positions else { return positions };
    let is_single = |x: f64| f64::from(x as f32) == x || x.is_nan();
    if points.iter().flatten().all(|&x| is_single(x)) {
        return Positions::F32(points.iter().map(|point| point.map(|x| x as f32)).collect());
    }
    positions
}
