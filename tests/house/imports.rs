//! Which file of a crate imports which, by its `use` lines.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A file of a crate by the names of its module; none for the root.
pub type Module = Vec<String>;

/// Imports of the files of a crate. What only tests import does not count.
#[derive(Debug, Default)]
pub struct Imports {
    /// Paths of the `use` lines of each file, one for every name.
    uses: BTreeMap<Module, Vec<Vec<String>>>,
}

impl Imports {
    /// Those of the crate whose sources lie in `folder`.
    pub fn read(folder: &Path) -> Self {
        let mut files = Vec::new();
        gather(folder, &mut files);
        Self::new(files.into_iter().map(|file| {
            let text = fs::read_to_string(&file).expect("a source file in UTF-8");
            (file.strip_prefix(folder).expect("it lies there").to_owned(), text)
        }))
    }

    /// Those of files: paths within the folder of sources, and texts.
    pub fn new(files: impl IntoIterator<Item = (PathBuf, String)>) -> Self {
        let mut uses = BTreeMap::<Module, Vec<_>>::new();
        for (path, text) in files {
            if let Some(module) = module_of(&path) {
                uses.entry(module).or_default().extend(uses_of(&text));
            }
        }
        Self { uses }
    }

    /// Every file with the files that it imports from.
    pub fn edges(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let of = |module: &Module| {
            let paths = self.uses[module].iter().filter_map(|path| self.absolute(module, path));
            paths.map(|path| self.resolve(&path, 0)).filter(|other| other != module).collect()
        };
        self.uses.keys().map(|module| (module.clone(), of(module))).collect()
    }

    /// Circles: files that reach one another, in the order of their names.
    pub fn circles(&self) -> Vec<Vec<String>> {
        let mut edges = self.edges();
        // The root re-exports, and imports nothing for itself.
        edges.insert(Module::new(), BTreeSet::new());
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            edges.keys().map(|module| (module, reach(&edges, module))).collect();
        let mut circles = BTreeSet::new();
        for (module, others) in &reached {
            let circle: Vec<String> =
                others.iter().filter(|other| reached[*other].contains(module)).map(|m| m.join("/")).collect();
            if circle.len() > 1 {
                circles.insert(circle);
            }
        }
        circles.into_iter().collect()
    }

    fn has(&self, module: &[String]) -> bool {
        self.uses.contains_key(module)
    }

    /// The path of a `use` line from the root of the crate; `None` if it leads elsewhere.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Vec<String>> {
        let supers = path.iter().take_while(|name| *name == "super").count();
        let child = [module.clone(), path[..1].to_vec()].concat();
        match path[0].as_str() {
            "crate" => Some(path[1..].to_vec()),
            "self" => Some([module.as_slice(), &path[1..]].concat()),
            "super" => Some([&module[..module.len() - supers], &path[supers..]].concat()),
            _ if self.has(&child) => Some([module.as_slice(), path].concat()),
            _ => None,
        }
    }

    /// The file that a path from the root ends in, through names that modules pass on.
    fn resolve(&self, path: &[String], depth: u32) -> Module {
        let longest = (0..=path.len()).rev().find(|&length| self.has(&path[..length])).unwrap_or(0);
        let (module, rest) = (path[..longest].to_vec(), &path[longest..]);
        let Some(name) = rest.first().filter(|_| depth < 8) else { return module };
        let passed = self.uses.get(&module).into_iter().flatten().filter(|path| path.last() == Some(name));
        let onwards = passed.filter_map(|path| self.absolute(&module, path)).find(|path| path != rest);
        onwards.map_or(module, |path| self.resolve(&path, depth + 1))
    }
}

fn reach<'a>(edges: &'a BTreeMap<Module, BTreeSet<Module>>, from: &'a Module) -> BTreeSet<&'a Module> {
    let mut reached = BTreeSet::new();
    let mut waiting: Vec<&Module> = edges[from].iter().collect();
    while let Some(module) = waiting.pop() {
        if reached.insert(module) {
            waiting.extend(edges.get(module).into_iter().flatten());
        }
    }
    reached
}

fn gather(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("an entry of a folder").path();
        if path.is_dir() {
            gather(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// The module of a file; `None` for programs beside the library and for tests.
fn module_of(path: &Path) -> Option<Module> {
    let path = path.with_extension("");
    let mut names: Module = path.iter().map(|name| name.to_string_lossy().into_owned()).collect();
    if names.iter().any(|name| name == "tests") || names[0] == "bin" {
        return None;
    }
    names.pop_if(|name| name == "mod");
    if names == ["lib"] || names == ["main"] {
        names.clear();
    }
    Some(names)
}

/// Paths of all `use` lines of a text, one for every name.
fn uses_of(text: &str) -> Vec<Vec<String>> {
    let code: String = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default())
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .flat_map(|line| [line.trim(), " "])
        .collect();
    let lines = code.split(';').filter_map(|statement| {
        let at = statement.rfind("use ").filter(|&at| at == 0 || statement[..at].ends_with(' '))?;
        let is_plain = |c: char| c.is_alphanumeric() || " :{},_*".contains(c);
        Some(&statement[at + "use ".len()..]).filter(|path| path.chars().all(is_plain))
    });
    lines.flat_map(|line| names(line.trim())).collect()
}

/// `a::{b, c::{d, e}}` as `a::b`, `a::c::d`, `a::c::e`.
fn names(path: &str) -> Vec<Vec<String>> {
    let Some((stem, group)) = path.split_once('{') else {
        let path = path.split(" as ").next().unwrap_or_default();
        return vec![path.split("::").map(|name| name.trim().to_owned()).collect()];
    };
    let stem: Vec<String> =
        stem.split("::").map(str::trim).filter(|n| !n.is_empty()).map(String::from).collect();
    let inner = group.trim_end().strip_suffix('}').unwrap_or(group);
    let parts = members(inner).into_iter().filter(|part| !part.trim().is_empty());
    parts.flat_map(|part| names(part.trim())).map(|rest| [stem.clone(), rest].concat()).collect()
}

/// The members of a group, whose own groups are not divided.
fn members(group: &str) -> Vec<&str> {
    let mut depth = 0;
    let divides = |c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    };
    group.split(divides).collect()
}
