//! Every dependency that the root manifest names is used: a crate's manifest takes it, and the crate's code names it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::metadata::{Package, metadata, root};
use crate::sources::sources;

/// Which crates' manifests take each dependency.
type Taken = BTreeMap<String, BTreeSet<String>>;

/// Returns the names under `[workspace.dependencies]` of a manifest.
fn named(manifest: &str) -> Vec<String> {
    let document: toml::Table = manifest.parse().expect("the root manifest is TOML");
    let table = document["workspace"]["dependencies"].as_table().expect("[workspace.dependencies]");
    table.keys().cloned().collect()
}

/// Whether `code` names the crate of a package: at the head of a path, or in a `use`.
fn names(code: &str, package: &str) -> bool {
    let word = package.replace('-', "_");
    code.match_indices(&word).any(|(at, _)| {
        let before = code[..at].chars().next_back();
        let is_whole = !before.is_some_and(|c| c.is_alphanumeric() || c == '_');
        let after = &code[at + word.len()..];
        is_whole && [" as ", "::", ";", "!"].iter().any(|end| after.starts_with(end))
    })
}

/// Code of a crate: its Rust files, and those elsewhere that it takes in by `#[path]`.
fn code(folder: &Path) -> String {
    let mut files = Vec::new();
    sources(folder, &mut files);
    let mut code = String::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file in UTF-8");
        let beside = file.parent().unwrap_or(folder);
        let elsewhere = text.split("#[path = \"").skip(1).filter_map(|rest| rest.split('"').next());
        let taken = elsewhere.filter_map(|path| fs::read_to_string(beside.join(path)).ok());
        code.extend(taken);
        code += &text;
    }
    code
}

fn folder(package: &Package) -> PathBuf {
    Path::new(&package.manifest_path).parent().expect("a manifest lies in a folder").to_owned()
}

/// What is named and not used, in words.
fn faults(named: &[String], taken: &Taken, code: &BTreeMap<String, String>) -> Vec<String> {
    let mut faults = Vec::new();
    let none = BTreeSet::new();
    for name in named {
        let crates = taken.get(name).unwrap_or(&none);
        if crates.is_empty() {
            faults.push(format!("{name}: named in the root manifest, and no crate takes it"));
        }
        let idle = crates.iter().filter(|user| !names(&code[*user], name));
        faults.extend(idle.map(|user| format!("{name}: {user} takes it, and no code of {user} names it")));
    }
    faults
}

#[test]
fn every_named_dependency_is_used() {
    let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("Cargo.toml");
    let (mut taken, mut code_of) = (Taken::new(), BTreeMap::new());
    for package in metadata(&["--no-deps"]).packages {
        for dependency in &package.dependencies {
            taken.entry(dependency.name.clone()).or_default().insert(package.name.clone());
        }
        code_of.insert(package.name.clone(), code(&folder(&package)));
    }
    let faults = faults(&named(&manifest), &taken, &code_of);
    assert!(faults.is_empty(), "dependencies without use:\n  {}", faults.join("\n  "));
}

#[test]
fn what_is_named_and_not_used_is_told() {
    let manifest = "[workspace.dependencies]\nused = \"1\"\nidle = \"1\"\nin-manifest = \"1\"\n";
    let of = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<BTreeSet<_>>();
    let taken = Taken::from([("used".into(), of(&["a"])), ("in-manifest".into(), of(&["a"]))]);
    let code =
        BTreeMap::from([("a".to_owned(), "use used::Thing; // not in_manifest, not misused::".to_owned())]);
    assert_eq!(
        faults(&named(manifest), &taken, &code),
        [
            "idle: named in the root manifest, and no crate takes it",
            "in-manifest: a takes it, and no code of a names it",
        ]
    );
}
