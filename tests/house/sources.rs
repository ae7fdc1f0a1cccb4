//! What no source file may contain: a second gate behind clippy, which sees only what it is asked to build.

use std::fs;
use std::path::{Path, PathBuf};

use crate::metadata::root;

/// Functions of the system library whose bits differ between machines (`clippy.toml`).
const TRANSCENDENTAL: &[&str] = &[
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sin_cos", "sinh", "cosh", "tanh", "asinh",
    "acosh", "atanh", "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "cbrt",
    "hypot", "mul_add",
];

/// Jets (values with derivatives) have functions of the same names, made from libm; clippy, which knows types, still
/// guards their files.
const JETS: &str = "landscape/src/relief/";

/// Unfinished work and silenced lints, in two halves so that this file does not accuse itself.
const NEVER: &[(&str, &str)] = &[
    ("to", "do!("),
    ("unimple", "mented!("),
    ("#[ig", "nore"),
    ("allow(dead", "_code)"),
    ("allow(clippy::disallowed", "_methods)"),
    ("TO", "DO"),
    ("FIX", "ME"),
];

/// The one way to leave a test out of a plain run.
const LONG: &str = concat!("#[ig", "nore = \"long: .ci/long runs it\"]");

/// Rust files under `folder`.
pub fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the workspace") {
        let path = entry.expect("an entry of the workspace").path();
        if path.is_dir() && path.file_name().is_some_and(|name| name != "target") {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Accusations against one file, with line numbers.
fn accusations(text: &str, has_jets: bool) -> Vec<String> {
    let mut found = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let code = line.split("//").next().unwrap_or_default();
        for name in TRANSCENDENTAL {
            let paths = [format!("f64::{name}"), format!("f32::{name}")];
            let method = format!(".{name}(");
            if !has_jets && code.contains(&method) || paths.iter().any(|path| contains_word(code, path)) {
                found.push(format!("line {}: {name} of the system library; use libm", number + 1));
            }
        }
        for (head, tail) in NEVER {
            if line.contains(&format!("{head}{tail}")) && line.trim() != LONG {
                found.push(format!("line {}: {head}{tail}", number + 1));
            }
        }
    }
    found
}

/// Whether `path` occurs and is not the beginning of a longer one.
fn contains_word(code: &str, path: &str) -> bool {
    code.match_indices(path).any(|(at, _)| {
        let next = code[at + path.len()..].chars().next();
        !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
    })
}

#[test]
fn sources_are_clean() {
    let mut files = Vec::new();
    for folder in ["crates", "tests"] {
        sources(&root().join(folder), &mut files);
    }
    assert!(files.len() > 50, "only {} source files found", files.len());
    let mut found = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file in UTF-8");
        let has_jets = file.to_string_lossy().contains(JETS);
        found.extend(
            accusations(&text, has_jets)
                .into_iter()
                .map(|accusation| format!("{}: {accusation}", file.display())),
        );
    }
    assert!(found.is_empty(), "\n  {}", found.join("\n  "));
}

#[test]
fn clippy_knows_the_same_list() {
    let text = fs::read_to_string(root().join("clippy.toml")).expect("clippy.toml");
    for name in TRANSCENDENTAL {
        for scalar in ["f32", "f64"] {
            assert!(text.contains(&format!("\"{scalar}::{name}\"")), "clippy.toml lacks {scalar}::{name}");
        }
    }
}

#[test]
fn the_gate_catches_what_it_should() {
    let found = |text: &str| accusations(text, false).len();
    let dotted = |name: &str| format!("let y = x.{name}(2);");
    assert_eq!(found(&dotted("powi")), 1);
    assert_eq!(found(&dotted("cos")), 1);
    assert_eq!(accusations(&dotted("cos"), true).len(), 0);
    assert_eq!(accusations(&format!("values.map(f64::{})", "exp"), true).len(), 1);
    assert_eq!(found(&format!("    {}{})", "to", "do!(")), 1);
    assert_eq!(found(LONG), 0);
    assert_eq!(found(&LONG.replace(".ci/long runs it", "later")), 1);
    assert_eq!(found("libm::sin(x) + x.sqrt() // x.cos() differs\nlet t = f64::expand(x);"), 0);
}
