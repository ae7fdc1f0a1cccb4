//! Modules of the planes import downwards; no crate has a wide circle of files.
//!
//! The order of the modules of a crate is a table in the doc of its `lib.rs`, one row a module.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use crate::floors::{Plan, Workspace, faults};
use crate::imports::Imports;
use crate::metadata::{metadata, root};

/// Crates whose modules have a written order.
const ORDERED: [&str; 3] = ["control-plane", "signal-plane", "machine"];

/// Files that may import one another in a circle.
const WIDEST_CIRCLE: usize = 4;

/// Reads the rows `| floor | module | ... |` of a table; whatever has no number in front is no row.
fn read_plan(table: &str) -> Result<Plan, String> {
    let mut plan = Plan::new();
    for line in table.lines() {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let ["", floor, module, .., ""] = cells[..] else { continue };
        let Ok(floor) = floor.parse() else { continue };
        let name = module.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
        let name = name.ok_or_else(|| format!("table of modules, `{line}`: expected a name in backticks"))?;
        if plan.insert(name.to_owned(), floor).is_some() {
            return Err(format!("table of modules: {name} stands there twice"));
        }
    }
    Ok(plan)
}

/// Which top-level module imports which.
fn modules(imports: &Imports) -> Workspace {
    let mut modules = Workspace::new();
    for (file, others) in imports.edges() {
        let Some(module) = file.first() else { continue };
        let others = others.iter().filter_map(|other| other.first()).filter(|other| *other != module);
        modules.entry(module.clone()).or_default().extend(others.cloned());
    }
    modules
}

/// The rows of the table in the doc of a crate.
fn table(doc: &str) -> String {
    let lines = doc.lines().filter_map(|line| line.strip_prefix("//!"));
    lines.map(|line| format!("{}\n", line.trim())).collect()
}

#[test]
fn modules_of_the_planes_import_downwards() {
    for name in ORDERED {
        let folder = root().join("crates/generators").join(name).join("src");
        let doc = fs::read_to_string(folder.join("lib.rs")).expect("lib.rs");
        let plan = read_plan(&table(&doc)).unwrap();
        assert!(!plan.is_empty(), "{name}: no table of modules in the doc of lib.rs");
        let faults = faults(&plan, &modules(&Imports::read(&folder)));
        assert!(faults.is_empty(), "{name}, doc of lib.rs against its modules:\n  {}", faults.join("\n  "));
    }
}

#[test]
fn circles_of_files_are_narrow() {
    let mut wide = Vec::new();
    for package in metadata(&["--no-deps"]).packages {
        let folder = Path::new(&package.manifest_path).with_file_name("src");
        for circle in Imports::read(&folder).circles() {
            if circle.len() > WIDEST_CIRCLE {
                wide.push(format!("{}: {}", folder.display(), circle.join(", ")));
            }
        }
    }
    assert!(wide.is_empty(), "circles of more than {WIDEST_CIRCLE} files:\n  {}", wide.join("\n  "));
}

fn imports(files: &[(&str, &str)]) -> Imports {
    Imports::new(files.iter().map(|&(path, text)| (Path::new(path).to_owned(), text.to_owned())))
}

#[test]
fn an_import_from_above_is_a_fault() {
    let files = [
        ("lib.rs", "mod low;\nmod high;\npub use high::Roof;"),
        ("low.rs", "use std::fmt;\n\nuse crate::Roof;"),
        ("high.rs", "// use crate::low::Comment;\nstruct Roof;"),
    ];
    let plan = read_plan("| 1 | `low` | |\n| 2 | `high` | |").unwrap();
    let found = faults(&plan, &modules(&imports(&files)));
    assert_eq!(found, ["low (floor 1) depends upwards on high (floor 2)"]);
    for (table, complaint) in [("| 1 | low | |", "backticks"), ("| 1 | `low` | |\n| 2 | `low` | |", "twice")]
    {
        assert!(read_plan(table).unwrap_err().contains(complaint), "{table}");
    }
}

#[test]
fn a_circle_is_found_through_groups_parents_and_names_of_the_root() {
    let files = [
        ("lib.rs", "mod a;\nmod b;\nmod c;\npub use c::Third;"),
        ("a/mod.rs", "mod inner;\nuse crate::{b::{self, Second}, b::More};"),
        ("a/inner.rs", "use super::First;\n#[cfg(test)]\nmod tests { use crate::c; }"),
        ("b.rs", "use crate::Third;"),
        ("c.rs", "pub(crate) use crate::a::inner::Deep as Other;"),
    ];
    let circles = imports(&files).circles();
    assert_eq!(circles, [["a", "a/inner", "b", "c"].map(String::from)]);
    let alone: BTreeMap<_, BTreeSet<_>> = modules(&imports(&files[3..4]));
    assert!(alone.values().all(BTreeSet::is_empty));
}
