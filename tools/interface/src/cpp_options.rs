//! The options of the C interface as structs of C++, with their conversions.
//!
//! A member of C++ has the name, the comment and the default of its field, and one of these types:
//!
//! | field of C | member of C++ |
//! |---|---|
//! | a choice, `@flag` | its enum, `bool` |
//! | a number or an array of fixed size with `@when neighbour A` | `std::optional`: a value sets the neighbour to A |
//! | an array and its `_count`, `gusset_indices` | `std::vector`; of `Point3` if `@shape count 3` |
//! | a pointer to a struct of options | the struct of C++ by value |
//! | a pointer to a handle, a struct | the same |
//!
//! A struct of other inputs has its own struct of C++ for the fields with `@option`; its conversion leaves all else 0.
//! A `@flag` or a choice of two values that an optional member decides alone is not a member.

use crate::Generated;
use crate::comment::Comment;
use crate::cpp::{camel_case, enumerators};
use crate::headers::{comment_lines, sorted};
use crate::source::{Field, Item, Kind, Source};
use std::fmt::Write;

const SUFFIX: &str = "_options";

/// The member of a field.
enum Member<'a> {
    Flag,
    Choice,
    Number,
    Struct,
    Handle,
    Array(&'a str),
    Indices,
    /// A pointer to elements, and the field that counts them.
    Elements(Option<&'a str>),
    Options,
}

/// A field that only says whether an optional member has a value.
struct Decided<'a> {
    value: &'a str,
    otherwise: &'a str,
}

struct Writer<'a> {
    sources: &'a [Source],
}

/// The text of `gusset/<header>_options.hpp` for each header of C with options.
///
/// # Errors
///
/// A sentence about a field that no rule covers, or structs that need each other.
pub fn options(sources: &[Source]) -> Result<Vec<Generated>, String> {
    let writer = Writer { sources };
    let mut headers: Vec<&str> = sources.iter().map(|source| source.header.as_str()).collect();
    headers.dedup();
    let mut made = Vec::new();
    for header in headers {
        let items = sources.iter().filter(|source| source.header == header).flat_map(|source| &source.items);
        let structs: Vec<(&Item, &[Field])> = items.filter_map(as_options).collect();
        let place = |field: &Field| structs.iter().position(|(item, _)| item.name == field.kind.name);
        let needed: Vec<Vec<usize>> =
            structs.iter().map(|(_, fields)| fields.iter().filter_map(place).collect()).collect();
        let order = sorted(&needed).map_err(|at| format!("{} needs a struct that needs it", structs[at].0.name))?;
        if order.is_empty() {
            continue;
        }
        let guard = format!("GUSSET_{}_OPTIONS_HPP", header.to_uppercase());
        let mut text = format!(
            "/// @file\n/// The options of gusset/{header}.h. Where a comment says NULL, an empty list or options without changes are meant.\n\
             /// Generated from src/capi; do not edit. Include gusset.hpp, not this.\n\
             #ifndef {guard}\n#define {guard}\n\n#include <gusset/span.hpp>\n\nnamespace gusset {{\n",
        );
        let mut conversions = String::new();
        for at in order {
            let (item, fields) = structs[at];
            let failed = |what: String| format!("{}: {what}", item.name);
            text += &writer.declared(item, fields).map_err(failed)?;
            conversions += &writer.converted(item, fields).map_err(failed)?;
        }
        let _ = write!(
            text,
            "\nnamespace detail {{{conversions}}} // namespace detail\n\n}} // namespace gusset\n\n#endif // {guard}\n"
        );
        made.push((format!("include/gusset/{header}_options.hpp"), text));
    }
    Ok(made)
}

/// A struct of options, or of other inputs with options, and its fields.
fn as_options(item: &Item) -> Option<(&Item, &[Field])> {
    match &item.kind {
        Kind::Struct(fields) if item.name.ends_with(SUFFIX) || fields.iter().any(is_tagged) => Some((item, fields)),
        _ => None,
    }
}

fn is_tagged(field: &Field) -> bool {
    field.comment.tag("option").is_some()
}

/// The name of the struct of C++.
fn name_of(item: &Item) -> String {
    format!("{}Options", camel_case(item.name.trim_end_matches(SUFFIX)))
}

impl<'a> Writer<'a> {
    fn item(&self, name: &str) -> Option<&'a Item> {
        self.sources.iter().flat_map(|source| &source.items).find(|item| item.name == name)
    }

    /// The member of a field; none if the field has no own member.
    fn member(&self, field: &'a Field, fields: &'a [Field]) -> Result<Option<Member<'a>>, String> {
        if fields.iter().any(is_tagged) && !is_tagged(field)
            || ["struct_size", "reserved"].contains(&field.name.as_str())
            || fields.iter().any(|array| count_of(array, fields) == Some(field.name.as_str()))
            || fields.iter().any(|other| self.decided(other, fields).is_some_and(|(decided, _)| decided == field.name))
        {
            return Ok(None);
        }
        let kind = &field.kind;
        let declared = self.item(&kind.name).map(|item| (&item.kind, &item.comment));
        let member = match (kind.pointers.as_slice(), kind.sizes.as_slice(), declared) {
            ([true], [], _) if kind.name.ends_with(SUFFIX) => Member::Options,
            ([true], [], Some((Kind::Handle, _))) => Member::Handle,
            ([true], [], _) if kind.name != "void" => Member::Elements(count_of(field, fields)),
            ([], [size], None) => Member::Array(size),
            ([], [], _) if kind.name == "gusset_indices" => Member::Indices,
            ([], [], Some((Kind::Struct(_), _))) => Member::Struct,
            ([], [], _) if field.comment.tag("flag").is_some() => Member::Flag,
            ([], [], Some((Kind::Choice(_), comment))) if comment.tag("bits").is_none() => Member::Choice,
            ([], [], None | Some((Kind::Choice(_), _))) if kind.name != "callback" => Member::Number,
            _ => return Err(format!("{}: C++ has no rule for this field", field.name)),
        };
        Ok(Some(member))
    }

    /// The neighbour and the value that a field is read for, if it is a number or an array of them.
    fn condition(&self, field: &'a Field) -> Option<(&'a str, &'a str)> {
        let (neighbour, value) = field.comment.tag("when")?.split_once(' ')?;
        let plain = field.kind.pointers.is_empty() && self.item(&field.kind.name).is_none();
        (plain && field.comment.tag("flag").is_none() && !value.contains(',')).then_some((neighbour, value))
    }

    /// The neighbour that an optional member decides alone.
    fn decided(&self, field: &'a Field, fields: &'a [Field]) -> Option<(&'a str, Decided<'a>)> {
        let (name, value) = self.condition(field)?;
        let neighbour = fields.iter().find(|other| other.name == name)?;
        if neighbour.comment.tag("flag").is_some() {
            return Some((name, Decided { value, otherwise: "0" }));
        }
        let taken = neighbour.comment.tag("values").map(|names| names.split(", ").collect::<Vec<_>>());
        let mut others = enumerators(self.sources, &neighbour.kind.name)
            .filter(|(name, _)| *name != value && taken.as_ref().is_none_or(|taken| taken.contains(name)));
        match (others.next(), others.next()) {
            (Some((otherwise, "0")), None) => Some((name, Decided { value, otherwise })),
            _ => None,
        }
    }

    fn element(field: &Field) -> &str {
        let is_point = |shape: &str| shape.split_once(' ').is_some_and(|(_, size)| size == "3");
        if field.comment.tag("shape").is_some_and(is_point) { "Point3" } else { &field.kind.name }
    }

    /// The struct of C++.
    fn declared(&self, item: &Item, fields: &'a [Field]) -> Result<String, String> {
        let c = &item.name;
        let brief =
            if c.ends_with(SUFFIX) { item.comment.brief.clone() } else { format!("Options among the inputs of {c}.") };
        let mut text = format!("\n/// {brief} See ::{c}.\nstruct {} {{\n", name_of(item));
        for field in fields {
            let Some(member) = self.member(field, fields)? else { continue };
            text += &comment_lines(&self.comment(field, fields), "    ");
            let kind = match field.kind.name.as_str() {
                "size_t" => "std::size_t",
                name => name,
            };
            let whole = match &member {
                Member::Flag => format!("bool {} = false", field.name),
                Member::Choice => {
                    let choice = camel_case(kind);
                    let zero = self.zero(kind).map_or_else(|| "{}".to_owned(), |word| format!(" = {choice}::{word}"));
                    format!("{choice} {}{zero}", field.name)
                }
                Member::Number => {
                    let zero = if kind == "double" { "0.0" } else { "0" };
                    match self.condition(field) {
                        Some(_) => format!("std::optional<{kind}> {}", field.name),
                        None => format!("{kind} {} = {zero}", field.name),
                    }
                }
                Member::Array(size) => {
                    let array = if (kind, *size) == ("double", "3") {
                        "Point3".to_owned()
                    } else {
                        format!("std::array<{kind}, {size}>")
                    };
                    match self.condition(field) {
                        Some(_) => format!("std::optional<{array}> {}", field.name),
                        None => format!("{array} {}{{}}", field.name),
                    }
                }
                Member::Struct => format!("{kind} {}{{}}", field.name),
                Member::Handle => format!("const {kind} *{} = nullptr", field.name),
                Member::Indices => format!("std::vector<uint32_t> {}", field.name),
                Member::Elements(_) => format!("std::vector<{}> {}", Self::element(field), field.name),
                Member::Options => format!("{} {}", camel_case(kind), field.name),
            };
            let _ = writeln!(text, "    {whole};");
        }
        text += "};\n";
        Ok(text)
    }

    /// The enumerator of the default.
    fn zero(&self, choice: &str) -> Option<String> {
        crate::cpp::words(self.sources, choice).into_iter().find(|(_, value)| value == "0").map(|(word, _)| word)
    }

    /// The comment of a member: its field's, with tags as sentences.
    fn comment(&self, field: &'a Field, fields: &'a [Field]) -> Comment {
        let mut comment = field.comment.clone();
        let mut said = Vec::new();
        if let Some((_, Decided { value, otherwise })) = self.decided(field, fields) {
            let name = self.condition(field).map_or("", |(name, _)| name);
            said.push(format!("A value sets {name} of C to {value}; empty: {otherwise}."));
        } else if let Some((name, value)) = self.condition(field) {
            said.push(format!("A value sets {name} to {value}."));
        } else if let Some((name, values)) = comment.tag("when").and_then(|when| when.split_once(' ')) {
            said.push(format!("Read only if {name} is {values}."));
        }
        said.extend(comment.tag("values").map(|values| format!("Takes {values} only.")));
        comment.detail = format!("{} {}", comment.detail, said.join(" ")).trim().to_owned();
        comment.tags.clear();
        comment
    }

    /// The conversion to C.
    fn converted(&self, item: &Item, fields: &'a [Field]) -> Result<String, String> {
        let name = name_of(item);
        let (mut plain, mut optional, mut nested, mut borrows) = (String::new(), String::new(), Vec::new(), false);
        for field in fields {
            let Some(member) = self.member(field, fields)? else { continue };
            let (to, kind) = (&field.name, &field.kind.name);
            borrows |= matches!(member, Member::Elements(_) | Member::Indices | Member::Options);
            let line = match &member {
                Member::Flag => format!("given.{to} = options.{to} ? 1 : 0;"),
                Member::Choice => format!("given.{to} = static_cast<{kind}>(options.{to});"),
                Member::Number | Member::Array(_) => {
                    let (whole, from, inner) = match self.condition(field) {
                        Some(_) => (format!("*options.{to}"), format!("options.{to}->"), true),
                        None => (format!("options.{to}"), format!("options.{to}."), false),
                    };
                    let line = match member {
                        Member::Array(_) => format!("std::copy({from}begin(), {from}end(), given.{to});"),
                        _ => format!("given.{to} = {whole};"),
                    };
                    if let (true, Some((other, value))) = (inner, self.condition(field)) {
                        let _ = write!(
                            optional,
                            "    if (options.{to}) {{\n        {line}\n        given.{other} = {value};\n    }}\n"
                        );
                        continue;
                    }
                    line
                }
                Member::Struct | Member::Handle => format!("given.{to} = options.{to};"),
                Member::Indices => format!("given.{to} = {{first(options.{to}), options.{to}.size()}};"),
                Member::Elements(count) => {
                    let first = format!("first(options.{to})");
                    let first = if Self::element(field) == "Point3" { format!("numbers({first})") } else { first };
                    let counted = count.map(|count| format!("\n    given.{count} = options.{to}.size();"));
                    format!("given.{to} = {first};{}", counted.unwrap_or_default())
                }
                Member::Options => {
                    nested.push(format!("    {kind} {to};\n"));
                    format!("nested.{to} = as_c(options.{to});\n    given.{to} = &nested.{to};")
                }
            };
            let _ = writeln!(plain, "    {line}");
        }
        let (mut text, mut extra) = (String::from("\n"), String::new());
        if !nested.is_empty() {
            let _ = write!(
                text,
                "/// The options that {} points to.\nstruct {name}Nested {{\n{}}};\n",
                item.name,
                nested.concat()
            );
            extra = format!(", {name}Nested &nested");
        }
        let c = &item.name;
        let _ = write!(
            text,
            "inline {c} as_c(const {name} &options{extra}) {{\n    auto given = sized<{c}>();\n{plain}{optional}    return given;\n}}\n"
        );
        if borrows {
            let _ = writeln!(text, "{c} as_c(const {name} &&{}) = delete;", extra.replace("nested", ""));
        }
        Ok(text)
    }
}

/// The field that counts the elements that another points to.
fn count_of<'a>(array: &Field, fields: &'a [Field]) -> Option<&'a str> {
    let counts = |field: &&Field| {
        let stem = field.name.strip_suffix("_count");
        stem.is_some_and(|stem| [stem.to_owned(), format!("{stem}s"), format!("{stem}es")].contains(&array.name))
    };
    let pointed = !array.kind.pointers.is_empty();
    fields.iter().filter(|_| pointed).find(counts).map(|field| field.name.as_str())
}
