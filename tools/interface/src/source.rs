//! The items of the C interface, read from its Rust sources.

use crate::comment::Comment;
use std::path::Path;
use std::{fmt, fs};
use syn::{Attribute, Expr, Fields, FnArg, Item as Syntax, Pat, ReturnType, Type as Syn, Visibility};

/// The header of what lies in no folder.
pub const BASE: &str = "base";

/// A type as C sees it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Type {
    /// Its name in C, without pointers.
    pub name: String,
    /// From the inside out, for each star whether the target is constant.
    pub pointers: Vec<bool>,
    /// The sizes of an array, from the outside in: numbers or constants.
    pub sizes: Vec<String>,
}

impl fmt::Display for Type {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.pointers.first() == Some(&true) {
            out.write_str("const ")?;
        }
        write!(
            out,
            "{}{}{}",
            self.name,
            if self.pointers.is_empty() { "" } else { " " },
            "*".repeat(self.pointers.len())
        )
    }
}

/// A field of a struct, or a parameter.
#[derive(Debug, Clone)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Its type.
    pub kind: Type,
    /// Its comment; of a parameter, the text of its tag.
    pub comment: Comment,
    /// Types of the parameters and of the result, if it is a callback.
    pub called_with: Vec<Type>,
}

/// The kind of an item.
#[derive(Debug, Clone)]
pub enum Kind {
    /// A constant: its type and its value.
    Constant(Type, String),
    /// A name for a number: the constants of this type are its values.
    Choice(Type),
    /// A pointer to a function of the host: its parameters and its result.
    Callback(Vec<Field>, Option<Type>),
    /// A struct whose fields C sees.
    Struct(Vec<Field>),
    /// A struct that C knows by pointer only.
    Handle,
    /// An enum: names, values, comments.
    Enum(Vec<(String, i64, Comment)>),
    /// A function: its parameters and its result.
    Function(Vec<Field>, Option<Type>),
}

/// An item that C sees.
#[derive(Debug, Clone)]
pub struct Item {
    /// Its name in C.
    pub name: String,
    /// The kind of the item.
    pub kind: Kind,
    /// Its comment.
    pub comment: Comment,
}

/// The items of a file.
#[derive(Debug, Clone)]
pub struct Source {
    /// The path in the folder of the interface, without its ending: `mesh/weld`; of a `mod.rs` the
    /// folder.
    pub path: String,
    /// The folder, or `base`: the header that declares the items.
    pub header: String,
    /// The comment of the file.
    pub comment: Comment,
    /// In the order of the file.
    pub items: Vec<Item>,
}

/// Reads the modules of a folder in the order in which its `mod.rs` lists them, after the items of
/// `mod.rs` itself.
///
/// # Errors
///
/// A sentence with the file and the item that C would not understand.
pub fn read(folder: &Path, ignored: &[&str]) -> Result<Vec<Source>, String> {
    let mut sources = Vec::new();
    module(&folder.join("mod.rs"), "", ignored, &mut sources)?;
    sources.retain(|source| !source.items.is_empty());
    Ok(sources)
}

fn module(file: &Path, path: &str, ignored: &[&str], sources: &mut Vec<Source>) -> Result<(), String> {
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let syntax = syn::parse_file(&text).map_err(|error| format!("{}: {error}", file.display()))?;
    let failed = |name: &str, what: String| format!("{}: {name}: {what}", file.display());
    let folder = file.parent().unwrap_or(file);
    let in_folder = path.contains('/') || file.ends_with("mod.rs") && !path.is_empty();
    let header = if in_folder { path.split('/').next().unwrap_or(BASE) } else { BASE }.to_owned();
    let comment = Comment::parse(&lines(&syntax.attrs)).unwrap_or_default();
    let mut source = Source { path: path.to_owned(), header, comment, items: Vec::new() };
    let mut modules = Vec::new();
    for syntax in &syntax.items {
        if let Syntax::Mod(module) = syntax {
            let name = module.ident.to_string();
            if module.content.is_none() && !ignored.contains(&name.as_str()) {
                modules.push(name);
            }
        } else if let Some(item) = item(syntax).map_err(|(name, what)| failed(&name, what))? {
            source.items.push(item);
        }
    }
    sources.push(source);
    for name in modules {
        let inner = if path.is_empty() { name.clone() } else { format!("{path}/{name}") };
        let nested = folder.join(&name).join("mod.rs");
        let file = if nested.exists() { nested } else { folder.join(format!("{name}.rs")) };
        module(&file, &inner, ignored, sources)?;
    }
    Ok(())
}

type Failed = (String, String);

fn item(syntax: &Syntax) -> Result<Option<Item>, Failed> {
    let (name, attributes, kind) = match syntax {
        Syntax::Const(one) if public(&one.vis) => {
            let name = one.ident.to_string();
            if !name.starts_with("GUSSET_") {
                return Ok(None);
            }
            let value = value(&one.expr).map_err(|what| (name.clone(), what))?;
            (name.clone(), &one.attrs, Kind::Constant(kind(&one.ty).map_err(|what| (name, what))?, value))
        }
        Syntax::Type(one) if public(&one.vis) => {
            let name = one.ident.to_string();
            let kind = match callback(&one.ty) {
                Some(function) => {
                    let params = function.inputs.iter().map(|given| {
                        let name = given.name.as_ref().map(|(ident, _)| ident.to_string()).unwrap_or_default();
                        Ok(Field { name, kind: kind(&given.ty)?, comment: Comment::default(), called_with: Vec::new() })
                    });
                    let params = params.collect::<Result<_, _>>().map_err(|what| (name.clone(), what))?;
                    Kind::Callback(params, result(&function.output).map_err(|what| (name.clone(), what))?)
                }
                None => Kind::Choice(kind(&one.ty).map_err(|what| (name.clone(), what))?),
            };
            (name, &one.attrs, kind)
        }
        Syntax::Struct(one) if public(&one.vis) && one.ident.to_string().starts_with("gusset_") => {
            let name = one.ident.to_string();
            let seen = one.attrs.iter().any(|attribute| attribute.path().is_ident("repr"));
            let kind = if seen {
                Kind::Struct(fields(&one.fields).map_err(|what| (name.clone(), what))?)
            } else {
                Kind::Handle
            };
            (name, &one.attrs, kind)
        }
        Syntax::Enum(one) if public(&one.vis) && one.ident.to_string().starts_with("gusset_") => {
            let name = one.ident.to_string();
            let variants = one.variants.iter().map(|variant| {
                let number = variant.discriminant.as_ref().ok_or("a variant without a number")?;
                let number = value(&number.1)?.parse().map_err(|_| "a number that is none")?;
                Ok((variant.ident.to_string(), number, Comment::parse(&lines(&variant.attrs))?))
            });
            let variants = variants.collect::<Result<_, String>>().map_err(|what| (name.clone(), what))?;
            (name, &one.attrs, Kind::Enum(variants))
        }
        Syntax::Fn(one) if public(&one.vis) && one.sig.abi.is_some() => {
            let name = one.sig.ident.to_string();
            let comment = Comment::parse(&lines(&one.attrs)).map_err(|what| (name.clone(), what))?;
            let params = one.sig.inputs.iter().map(|given| {
                let FnArg::Typed(given) = given else { return Err("a receiver".to_owned()) };
                let Pat::Ident(ident) = &*given.pat else { return Err("a pattern".to_owned()) };
                let name = ident.ident.to_string();
                let text = comment.params.iter().find(|(param, _)| *param == name).map(|(_, text)| text.clone());
                let comment = Comment { brief: text.unwrap_or_default(), ..Comment::default() };
                Ok(Field { name, kind: kind(&given.ty)?, comment, called_with: Vec::new() })
            });
            let params = params.collect::<Result<Vec<_>, _>>().map_err(|what| (name.clone(), what))?;
            if let Some((unknown, _)) =
                comment.params.iter().find(|(named, _)| params.iter().all(|param| param.name != *named))
            {
                return Err((name, format!("@param {unknown} is not a parameter")));
            }
            let result = result(&one.sig.output).map_err(|what| (name.clone(), what))?;
            (name, &one.attrs, Kind::Function(params, result))
        }
        _ => return Ok(None),
    };
    let comment = Comment::parse(&lines(attributes)).map_err(|what| (name.clone(), what))?;
    Ok(Some(Item { name, kind, comment }))
}

fn public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn lines(attributes: &[Attribute]) -> Vec<String> {
    let texts = attributes.iter().filter(|attribute| attribute.path().is_ident("doc")).filter_map(|attribute| {
        let Ok(Expr::Lit(literal)) = attribute.meta.require_name_value().map(|pair| pair.value.clone()) else {
            return None;
        };
        let syn::Lit::Str(text) = literal.lit else { return None };
        Some(text.value())
    });
    // An empty line separates paragraphs.
    texts.flat_map(|text| text.split('\n').map(str::to_owned).collect::<Vec<_>>()).collect()
}

fn fields(fields: &Fields) -> Result<Vec<Field>, String> {
    let one = |field: &syn::Field| {
        let name = field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
        let comment = Comment::parse(&lines(&field.attrs)).map_err(|what| format!("{name}: {what}"))?;
        let failed = |what: String| format!("{name}: {what}");
        let Some(function) = callback(&field.ty) else {
            let kind = kind(&field.ty).map_err(failed)?;
            return Ok(Field { name, kind, comment, called_with: Vec::new() });
        };
        // A callback of a field lacks a name.
        let mut called_with = Vec::new();
        for given in &function.inputs {
            called_with.push(kind(&given.ty).map_err(failed)?);
        }
        called_with.extend(result(&function.output).map_err(failed)?);
        let kind = Type { name: "callback".to_owned(), pointers: Vec::new(), sizes: Vec::new() };
        Ok(Field { name, kind, comment, called_with })
    };
    fields.iter().map(one).collect()
}

/// The function of `Option<extern "C" fn(...)>`.
fn callback(given: &Syn) -> Option<&syn::TypeBareFn> {
    match given {
        Syn::BareFn(function) => Some(function),
        Syn::Path(path) => {
            let last = path.path.segments.last().filter(|last| last.ident == "Option")?;
            let syn::PathArguments::AngleBracketed(given) = &last.arguments else { return None };
            given.args.iter().find_map(|argument| match argument {
                syn::GenericArgument::Type(Syn::BareFn(function)) => Some(function),
                _ => None,
            })
        }
        _ => None,
    }
}

fn result(output: &ReturnType) -> Result<Option<Type>, String> {
    match output {
        ReturnType::Default => Ok(None),
        ReturnType::Type(_, given) => kind(given).map(Some),
    }
}

fn value(expression: &Expr) -> Result<String, String> {
    match expression {
        Expr::Lit(literal) => match &literal.lit {
            syn::Lit::Int(number) => Ok(number.base10_digits().to_owned()),
            _ => Err("a constant that is no whole number".to_owned()),
        },
        Expr::Path(path) if path.path.segments.last().is_some_and(|last| last.ident == "MAX") => {
            Ok("UINT32_MAX".to_owned())
        }
        Expr::Binary(binary) if matches!(binary.op, syn::BinOp::Shl(_)) => {
            let [left, right] = [&binary.left, &binary.right]
                .map(|side| value(side).and_then(|text| text.parse::<u64>().map_err(|error| error.to_string())));
            Ok((left? << right?).to_string())
        }
        _ => Err("a constant whose value is not written out".to_owned()),
    }
}

fn kind(given: &Syn) -> Result<Type, String> {
    match given {
        Syn::Ptr(pointer) => {
            let mut inner = kind(&pointer.elem)?;
            inner.pointers.push(pointer.mutability.is_none());
            Ok(inner)
        }
        Syn::Array(array) => {
            let mut inner = kind(&array.elem)?;
            let size = match &array.len {
                Expr::Path(path) => path.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default(),
                number => value(number)?,
            };
            inner.sizes.insert(0, size);
            Ok(inner)
        }
        Syn::Path(path) => {
            let name = path.path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
            let name = match name.as_str() {
                "u8" => "uint8_t",
                "u16" => "uint16_t",
                "u32" => "uint32_t",
                "u64" => "uint64_t",
                "i32" | "c_int" => "int32_t",
                "i64" => "int64_t",
                "f32" => "float",
                "f64" => "double",
                "usize" => "size_t",
                "c_void" => "void",
                "c_char" => "char",
                known if known.starts_with("gusset_") => known,
                _ => return Err(format!("{name} is not a type of C")),
            };
            Ok(Type { name: name.to_owned(), pointers: Vec::new(), sizes: Vec::new() })
        }
        _ => Err("a type that C has not".to_owned()),
    }
}
