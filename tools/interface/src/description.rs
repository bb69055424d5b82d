//! The description of the interface: one JSON document for whoever generates from it.

use crate::comment::{Cause, Comment};
use crate::source::{Field, Item, Kind, Source, Type};
use serde_json::{Map, Value, json};

/// Describes all items of the library, of the plugin's table and of the table of files.
pub fn describe(library: &[Source], plugin: &[Source], files: &[Source], version: &str) -> Value {
    let mut made = sections(library);
    made.insert("version".into(), version.into());
    made.insert("plugin".into(), Value::Object(sections(plugin)));
    made.insert("files".into(), Value::Object(sections(files)));
    Value::Object(made)
}

/// Whether an item belongs to a section.
type Wanted = fn(&Kind) -> bool;

fn sections(sources: &[Source]) -> Map<String, Value> {
    let all = || sources.iter().flat_map(|source| source.items.iter().map(move |item| (source, item)));
    let values = |choice: &str| {
        let constants = all().filter_map(|(_, item)| match &item.kind {
            Kind::Constant(kind, value) if kind.name == choice => Some(json!({
                "name": item.name, "value": number(value), "text": whole(&item.comment),
            })),
            _ => None,
        });
        constants.collect::<Vec<_>>()
    };
    let choices: Vec<&str> =
        all().filter(|(_, item)| matches!(item.kind, Kind::Choice(_))).map(|(_, item)| item.name.as_str()).collect();
    let kinds: [(&str, Wanted); 7] = [
        ("constants", |kind| matches!(kind, Kind::Constant(..))),
        ("choices", |kind| matches!(kind, Kind::Choice(_))),
        ("enums", |kind| matches!(kind, Kind::Enum(_))),
        ("callbacks", |kind| matches!(kind, Kind::Callback(..))),
        ("handles", |kind| matches!(kind, Kind::Handle)),
        ("structs", |kind| matches!(kind, Kind::Struct(_))),
        ("functions", |kind| matches!(kind, Kind::Function(..))),
    ];
    let section = |wanted: Wanted| -> Value {
        all()
            .filter(|(_, item)| wanted(&item.kind))
            .map(|(source, item)| described(source, item, &choices, &values))
            .collect()
    };
    kinds.into_iter().map(|(name, wanted)| (name.to_owned(), section(wanted))).collect()
}

fn described(source: &Source, item: &Item, choices: &[&str], values: &dyn Fn(&str) -> Vec<Value>) -> Value {
    let mut made = Map::new();
    made.insert("name".into(), item.name.clone().into());
    made.insert("header".into(), source.header.clone().into());
    made.insert("file".into(), source.path.clone().into());
    let fields = |fields: &[Field]| fields.iter().map(|one| field(one, choices)).collect::<Value>();
    let result = |result: &Option<Type>| result.as_ref().map_or_else(|| "void".into(), Type::to_string);
    match &item.kind {
        Kind::Constant(kind, value) => {
            made.insert("type".into(), kind.name.clone().into());
            made.insert("value".into(), number(value));
        }
        Kind::Choice(kind) => {
            made.insert("type".into(), kind.name.clone().into());
            made.insert("values".into(), values(&item.name).into());
        }
        Kind::Callback(params, output) | Kind::Function(params, output) => {
            made.insert("params".into(), fields(params));
            made.insert("result".into(), result(output).into());
        }
        Kind::Struct(given) => {
            made.insert("fields".into(), fields(given));
        }
        Kind::Enum(variants) => {
            let one = |(name, value, comment): &(String, i64, Comment)| json!({ "name": name, "value": value, "brief": comment.brief, "text": whole(comment) });
            made.insert("values".into(), variants.iter().map(one).collect());
        }
        Kind::Handle => {}
    }
    comment(&item.comment, &mut made);
    Value::Object(made)
}

fn field(field: &Field, choices: &[&str]) -> Value {
    let mut made = Map::new();
    made.insert("name".into(), field.name.clone().into());
    made.insert("type".into(), field.kind.name.clone().into());
    if !field.kind.pointers.is_empty() {
        made.insert(
            "pointers".into(),
            field.kind.pointers.iter().map(|constant| if *constant { "const" } else { "mut" }).collect(),
        );
    }
    if !field.kind.sizes.is_empty() {
        made.insert("sizes".into(), field.kind.sizes.iter().map(|size| number(size)).collect());
    }
    if choices.contains(&field.kind.name.as_str()) {
        made.insert("choice".into(), true.into());
    }
    comment(&field.comment, &mut made);
    Value::Object(made)
}

fn comment(comment: &Comment, made: &mut Map<String, Value>) {
    made.insert("brief".into(), comment.brief.clone().into());
    let mut text = Vec::new();
    text.extend((!comment.detail.is_empty()).then(|| comment.detail.clone()));
    text.extend(comment.text.iter().cloned());
    if !text.is_empty() {
        made.insert("text".into(), text.into());
    }
    if !comment.errors.is_empty() {
        let one = |cause: &Cause| match cause.status.strip_prefix("as ") {
            Some(other) => json!({ "as": other, "when": cause.when }),
            None => json!({ "status": cause.status, "when": cause.when }),
        };
        made.insert("errors".into(), comment.errors.iter().map(one).collect());
    }
    for (tag, content) in &comment.tags {
        made.insert(tag.clone(), if content.is_empty() { true.into() } else { content.clone().into() });
    }
}

fn whole(comment: &Comment) -> String {
    let mut text = vec![comment.brief.as_str(), comment.detail.as_str()];
    text.extend(comment.text.iter().map(String::as_str));
    text.retain(|part| !part.is_empty());
    text.join(" ")
}

fn number(text: &str) -> Value {
    text.parse::<u64>().map_or_else(|_| text.into(), Into::into)
}

/// A line for each item, so that changes can be read.
pub fn lines(description: &Value) -> String {
    let mut text = block(description);
    text.push('\n');
    text
}

fn block(value: &Value) -> String {
    let entries: Vec<String> = match value {
        Value::Object(map) if map.values().any(Value::is_array) => map
            .iter()
            .map(|(name, inner)| {
                format!(
                    "{}: {}",
                    Value::from(name.as_str()),
                    if inner.is_string() { inner.to_string() } else { section(inner) }
                )
            })
            .collect(),
        other => return other.to_string(),
    };
    format!("{{\n{}\n}}", entries.join(",\n"))
}

fn section(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            format!("[\n{}\n]", items.iter().map(ToString::to_string).collect::<Vec<_>>().join(",\n"))
        }
        other => block(other),
    }
}
