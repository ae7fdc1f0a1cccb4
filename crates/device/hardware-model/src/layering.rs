//! A model over its bases, under overlays and single settings.

use std::path::PathBuf;

use diagnostics::{Layers, Placed, Problem, Problems, TomlFile};
use scenario::words;

use crate::ModelSource;
use crate::source::advise;
use crate::written::FORMAT;

/// All layers, the lowest first, and what is known of the model before its parts are read.
pub(crate) struct Layered {
    pub name: String,
    pub layers: Layers,
    pub files: Vec<PathBuf>,
}

/// Puts all layers together; nothing where one of them cannot be read at all.
pub(crate) fn layered(
    source: &ModelSource,
    overlays: &[PathBuf],
    sets: &[(String, String)],
    problems: &Problems,
) -> Option<Layered> {
    let (name, mut files, mut sources) = chain(source, problems)?;
    for overlay in overlays {
        let overlay = ModelSource::overlay(overlay);
        files.push(read_overlay(&overlay, problems)?);
        sources.push(overlay);
    }
    for (key, value) in sets {
        files.push(read_set(key, value, problems)?);
    }
    let read = sources.into_iter().filter_map(|source| match source {
        ModelSource::File(path) => Some(path),
        ModelSource::BuiltIn(_) | ModelSource::Fault(_) => None,
    });
    Some(Layered { name, layers: Layers::new(files), files: read.collect() })
}

/// The model and its bases, the lowest base first.
fn chain(source: &ModelSource, problems: &Problems) -> Option<(String, Vec<TomlFile>, Vec<ModelSource>)> {
    let (file, head) = read_model(source, problems)?;
    let name = head.name;
    let (mut files, mut sources, mut base) = (vec![file], vec![source.clone()], head.base);
    while let Some(named) = base {
        let below = resolve_base(&sources, &named, problems)?;
        let (file, head) = read_model(&below, problems)?;
        files.push(file);
        sources.push(below);
        base = head.base;
    }
    files.reverse();
    sources.reverse();
    Some((name, files, sources))
}

fn resolve_base(sources: &[ModelSource], named: &Placed<String>, problems: &Problems) -> Option<ModelSource> {
    let upper = sources.last()?;
    let Some(base) = upper.base(&named.value) else {
        let problem = Problem::of(named, format!("unknown base `{}`", named.value));
        problems.push(advise(problem, &named.value, &upper.known_bases()));
        return None;
    };
    if sources.contains(&base) {
        let names: Vec<String> = sources.iter().chain([&base]).map(ModelSource::name).collect();
        let title = format!("a model is based on itself: {}", names.join(" on "));
        problems.push(Problem::of(named, title).expected("a base that does not lead back here"));
        return None;
    }
    Some(base)
}

struct Head {
    name: String,
    base: Option<Placed<String>>,
}

fn read_model(source: &ModelSource, problems: &Problems) -> Option<(TomlFile, Head)> {
    let file = source.parse(problems)?;
    let root = file.root(problems);
    let is_known = root.format_version(FORMAT) || !root.has("format");
    let name = words::model_name(&root, "name").required();
    let base = words::model_name(&root, "base").placed().optional();
    // Without its base, nothing can be said about the keys that are missing.
    if !is_known || (root.has("base") && base.is_none()) {
        return None;
    }
    // A fault in the name is recorded; reading goes on to list the others.
    Some((file, Head { name: name.unwrap_or_default(), base }))
}

fn read_overlay(overlay: &ModelSource, problems: &Problems) -> Option<TomlFile> {
    let file = overlay.found(problems)?.parse(problems)?;
    let root = file.root(problems);
    let is_known = root.format_version(FORMAT) || !root.has("format");
    for key in ["name", "base"].into_iter().filter(|key| root.has(key)) {
        let problem = root.problem(key, format!("`{key}` in an overlay"));
        root.report(problem.expected("differences only").help(format!("`{key}` belongs in a model file")));
    }
    is_known.then_some(file)
}

/// `--set part.key=value`; a value that is no TOML is taken as a word, so that words need no quotes.
fn read_set(key: &str, value: &str, problems: &Problems) -> Option<TomlFile> {
    const NAME: &str = "--set";
    let is_bare = |part: &str| {
        !part.is_empty() && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
    };
    if !key.contains('.') || !key.split('.').all(is_bare) {
        let problem = Problem::of_file(NAME, format!("`{key}` is no key of a part")).found(key);
        problems.push(problem.expected("part.key=value").help("for instance raster.sweeps=525"));
        return None;
    }
    let silent = Problems::new();
    let is_toml = !value.contains(['\n', '\r']);
    let plain = is_toml.then(|| TomlFile::parse(NAME, &format!("{key} = {value}\n"), &silent)).flatten();
    plain.or_else(|| TomlFile::parse(NAME, &format!("{key} = {}\n", quoted(value)), problems))
}

fn quoted(value: &str) -> String {
    let escaped = value.chars().map(|c| match c {
        '"' | '\\' => format!("\\{c}"),
        c if c.is_control() => format!("\\u{:04X}", c as u32),
        c => c.to_string(),
    });
    format!("\"{}\"", escaped.collect::<String>())
}
