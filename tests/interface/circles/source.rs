//! Reads which module of the library uses items of which other: declarations, imports and paths
//! from the tokens of the sources.
//!
//! A name leads to the file that defines it, through every `use` on the way, so that a `mod.rs`
//! that lends the names of its children is not a hub. `#[cfg(test)]` items do not count, nor do
//! methods, which are reached without a path.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// Arrows between files, each with a name that it is drawn for.
pub(crate) type Arrows = BTreeMap<(String, String), String>;

/// A module: the file it is written in, and the names that can be reached through it.
#[derive(Default)]
struct Module {
    file: String,
    items: BTreeSet<String>,
    imports: Vec<Import>,
    globs: Vec<Vec<String>>,
    /// Paths in its code, of two segments or more.
    paths: BTreeSet<Vec<String>>,
    /// Names that stand alone in its code.
    names: BTreeSet<String>,
}

struct Import {
    name: String,
    path: Vec<String>,
    public: bool,
}

/// The modules of a crate by their paths, the crate's own being empty.
#[derive(Default)]
pub(crate) struct Crate {
    modules: BTreeMap<Vec<String>, Module>,
    /// Macros that modules lend to the crate's root.
    exported: Vec<Import>,
}

impl Crate {
    /// Reads `lib.rs` and every file that is declared from there.
    pub(crate) fn read(source: &dyn Fn(&str) -> Option<String>) -> Self {
        let mut found = Self::default();
        found.read_file(Vec::new(), "lib.rs", source);
        let exported = std::mem::take(&mut found.exported);
        found.modules.entry(Vec::new()).or_default().imports.extend(exported);
        found
    }

    fn read_file(&mut self, path: Vec<String>, file: &str, source: &dyn Fn(&str) -> Option<String>) {
        let text = source(file).unwrap_or_else(|| panic!("{file} is declared and cannot be read"));
        let tokens: TokenStream = text.parse().unwrap_or_else(|error| panic!("{file}: {error}"));
        self.read_module(path, file, tokens, source);
    }

    fn read_module(
        &mut self,
        path: Vec<String>,
        file: &str,
        tokens: TokenStream,
        source: &dyn Fn(&str) -> Option<String>,
    ) {
        let mut module = Module { file: file.to_owned(), ..Module::default() };
        let tokens = without_tests(tokens);
        for (k, token) in tokens.iter().enumerate() {
            let after_quote = k > 0 && matches!(&tokens[k - 1], TokenTree::Punct(mark) if mark.as_char() == '\'');
            let keyword = ident(Some(token)).filter(|_| !after_quote).unwrap_or_default();
            let name = ident(tokens.get(k + 1)).unwrap_or_default();
            match keyword.as_str() {
                "fn" | "struct" | "enum" | "trait" | "type" | "static" | "const" => drop(module.items.insert(name)),
                "macro_rules" => {
                    let name = ident(tokens.get(k + 2)).unwrap_or_default();
                    // An exported macro can be reached through the crate's root.
                    if k > 0 && tokens[k - 1].to_string().contains("macro_export") {
                        let path = ["crate"].iter().map(ToString::to_string).chain(path.clone()).chain([name.clone()]);
                        self.exported.push(Import { name: name.clone(), path: path.collect(), public: true });
                    }
                    module.items.insert(name);
                }
                "mod" => {
                    let child: Vec<_> = path.iter().cloned().chain([name]).collect();
                    match tokens.get(k + 2) {
                        Some(TokenTree::Group(body)) => self.read_module(child, file, body.stream(), source),
                        _ => {
                            let files = [child.join("/") + ".rs", child.join("/") + "/mod.rs"];
                            let file = files.iter().find(|file| source(file).is_some()).unwrap_or(&files[0]);
                            self.read_file(child, file, source);
                        }
                    }
                }
                _ => {}
            }
        }
        module.scan(&tokens, true);
        self.modules.insert(path, module);
    }

    /// The file that defines what a path in `module` leads to: nothing for modules themselves and
    /// for other crates.
    fn definition(&self, module: &[String], path: &[String], depth: usize) -> Option<&str> {
        let (mut at, mut rest) = (module.to_vec(), path);
        while let Some(first) = rest.first() {
            match first.as_str() {
                "crate" => at.clear(),
                "super" => drop(at.pop()),
                "self" => {}
                _ => break,
            }
            rest = &rest[1..];
        }
        while let [name, more @ ..] = rest {
            let here = &self.modules[&at];
            let child: Vec<_> = at.iter().chain([name]).cloned().collect();
            let is_module = self.modules.contains_key(&child);
            if is_module && !more.is_empty() {
                (at, rest) = (child, more);
                continue;
            }
            if here.items.contains(name) {
                return Some(&here.file);
            }
            if depth > 16 || is_module && !here.imports.iter().any(|import| import.name == *name) {
                return None;
            }
            let direct = here.imports.iter().filter(|import| import.name == *name).map(|import| import.path.clone());
            let lent = here.globs.iter().map(|glob| glob.iter().chain([name]).cloned().collect());
            let mut ways = direct.map(|path| [path, more.to_vec()].concat()).chain(lent);
            return ways.find_map(|path| self.definition(&at, &path, depth + 1));
        }
        None
    }

    /// The modules that its `lib.rs` declares.
    pub(crate) fn children(&self) -> BTreeSet<String> {
        self.modules.keys().filter(|path| path.len() == 1).map(|path| path[0].clone()).collect()
    }

    /// All arrows from one file to another.
    pub(crate) fn arrows(&self) -> Arrows {
        let mut arrows = Arrows::new();
        for (path, module) in &self.modules {
            let used = |import: &&Import| !import.public || module.names.contains(&import.name);
            let imports = module.imports.iter().filter(used).map(|import| &import.path);
            let through_globs = module.names.iter().filter(|_| !module.globs.is_empty());
            let lone: Vec<_> = through_globs.map(|name| vec![name.clone()]).collect();
            for used in imports.chain(&module.paths).chain(&lone) {
                if let Some(file) = self.definition(path, used, 0).filter(|file| *file != module.file) {
                    arrows.entry((module.file.clone(), file.to_owned())).or_insert_with(|| used.join("::"));
                }
            }
        }
        arrows
    }

    /// Paths into the crate that lead nowhere: this reader is blind to them.
    pub(crate) fn unresolved(&self) -> Vec<String> {
        let mut lost = Vec::new();
        for (path, module) in &self.modules {
            for used in module.imports.iter().map(|import| &import.path).chain(&module.paths) {
                let inside = ["crate", "super", "self"].contains(&used[0].as_str());
                let is_found = || self.is_module(path, used) || self.definition(path, used, 0).is_some();
                if inside && !is_found() && !self.leads_outside(path, used) {
                    lost.push(format!("{}: {}", module.file, used.join("::")));
                }
            }
        }
        lost
    }

    /// True if a path leads to a name that one of the modules on its way lends from another crate.
    fn leads_outside(&self, module: &[String], path: &[String]) -> bool {
        let mut at = module.to_vec();
        for name in path {
            match name.as_str() {
                "crate" => at.clear(),
                "super" => drop(at.pop()),
                "self" => {}
                _ => {
                    let leads_outside = |import: &Import| {
                        import.path[0].starts_with("gusset_")
                            || import.path.len() > 1 && self.leads_outside(&at, &import.path)
                    };
                    let mut lent = self.modules[&at].imports.iter().filter(|import| import.name == *name);
                    if lent.any(leads_outside) {
                        return true;
                    }
                    at.push(name.clone());
                    if !self.modules.contains_key(&at) {
                        return false;
                    }
                }
            }
        }
        false
    }

    fn is_module(&self, module: &[String], path: &[String]) -> bool {
        let mut at = module.to_vec();
        for name in path {
            match name.as_str() {
                "crate" => at.clear(),
                "super" => drop(at.pop()),
                "self" => {}
                _ => at.push(name.clone()),
            }
        }
        self.modules.contains_key(&at)
    }
}

impl Module {
    /// Collects imports, paths and names, `outermost` where imports are the module's and not a
    /// function's.
    fn scan(&mut self, tokens: &[TokenTree], outermost: bool) {
        let mut k = 0;
        while k < tokens.len() {
            if let TokenTree::Group(group) = &tokens[k] {
                self.scan(&group.stream().into_iter().collect::<Vec<_>>(), false);
            }
            let Some(name) = ident(tokens.get(k)) else {
                k += 1;
                continue;
            };
            if name == "mod" && matches!(tokens.get(k + 2), Some(TokenTree::Group(_))) {
                k += 3;
                continue;
            }
            if name == "use" {
                let end = (k..tokens.len()).find(|&end| is_mark(tokens.get(end), ';')).unwrap_or(tokens.len());
                let before = k.checked_sub(1).and_then(|before| tokens.get(before));
                let public =
                    ident(before).is_some_and(|word| word == "pub") || matches!(before, Some(TokenTree::Group(_)));
                self.read_use(&tokens[k + 1..end], &[], public && outermost);
                k = end;
                continue;
            }
            let no_use = k > 0
                && (is_mark(tokens.get(k - 1), '.') || ident(tokens.get(k - 1)).is_some_and(|word| word == "mod"));
            let mut path = vec![name];
            while is_mark(tokens.get(k + 1), ':') && is_mark(tokens.get(k + 2), ':') {
                let Some(next) = ident(tokens.get(k + 3)) else { break };
                path.push(next);
                k += 3;
            }
            k += 1;
            if path.len() > 1 {
                self.names.insert(path[0].clone());
                self.paths.insert(path);
            } else if !no_use {
                self.names.extend(path);
            }
        }
    }

    fn read_use(&mut self, tokens: &[TokenTree], prefix: &[String], public: bool) {
        for tree in tokens.split(|token| is_mark(Some(token), ',')) {
            let mut path = prefix.to_vec();
            let mut name = None;
            for (k, token) in tree.iter().enumerate() {
                match token {
                    TokenTree::Ident(word) if word == "as" => {
                        name = ident(tree.get(k + 1));
                        break;
                    }
                    TokenTree::Ident(word) if word == "self" && !path.is_empty() => {}
                    TokenTree::Ident(word) => path.push(word.to_string()),
                    TokenTree::Punct(mark) if mark.as_char() == '*' => return self.globs.push(path),
                    TokenTree::Group(group) => {
                        return self.read_use(&group.stream().into_iter().collect::<Vec<_>>(), &path, public);
                    }
                    _ => {}
                }
            }
            if let Some(name) = name.or_else(|| path.last().cloned()) {
                self.imports.push(Import { name, path, public });
            }
        }
    }
}

fn ident(token: Option<&TokenTree>) -> Option<String> {
    if let Some(TokenTree::Ident(name)) = token { Some(name.to_string()) } else { None }
}

fn is_mark(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(found)) if found.as_char() == mark)
}

/// The tokens of a module less the items that only tests or the documentation see.
fn without_tests(tokens: TokenStream) -> Vec<TokenTree> {
    let tokens: Vec<_> = tokens.into_iter().collect();
    let (mut kept, mut k) = (Vec::new(), 0);
    while k < tokens.len() {
        if let (true, Some(TokenTree::Group(group))) = (is_mark(tokens.get(k), '#'), tokens.get(k + 1)) {
            let text: String = group.stream().to_string().split_whitespace().collect();
            if text == "cfg(test)" || text == "cfg(doc)" {
                let import = (k + 2..k + 5).any(|at| ident(tokens.get(at)).is_some_and(|word| word == "use"));
                let ends = |token: &TokenTree| match token {
                    TokenTree::Group(group) => !import && group.delimiter() == Delimiter::Brace,
                    token => is_mark(Some(token), ';'),
                };
                k += 2 + tokens[k + 2..].iter().position(ends).map_or(tokens.len(), |end| end + 1);
                continue;
            }
        }
        kept.push(tokens[k].clone());
        k += 1;
    }
    kept
}
