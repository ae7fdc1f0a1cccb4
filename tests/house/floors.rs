//! Dependencies run downwards only; `docs/architecture.md` names exactly the crates that exist.

use std::collections::{BTreeMap, BTreeSet};

use crate::metadata::{metadata, root};

/// A row of the floor table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    floor: u32,
    /// Has its floor, need not exist yet.
    later: bool,
}

pub type Plan = BTreeMap<String, Room>;
/// Names of a crate's dependencies within the workspace, of any kind.
pub type Workspace = BTreeMap<String, BTreeSet<String>>;

/// Reads the rows `| floor | crate | ... |` of a page; whatever has no number in front is no row.
pub fn read_plan(page: &str) -> Result<Plan, String> {
    let mut plan = Plan::new();
    for line in page.lines() {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let ["", floor, room, .., ""] = cells[..] else { continue };
        let Ok(floor) = floor.parse() else { continue };
        let (name, mark) = room
            .strip_prefix('`')
            .and_then(|rest| rest.split_once('`'))
            .ok_or_else(|| format!("floor table, `{line}`: expected a crate's name in backticks"))?;
        let later = match mark.trim() {
            "" => false,
            "(later)" => true,
            other => {
                return Err(format!("floor table, {name}: found `{other}`, expected `(later)` or nothing"));
            }
        };
        if plan.insert(name.to_owned(), Room { floor, later }).is_some() {
            return Err(format!("floor table: {name} stands there twice"));
        }
    }
    Ok(plan)
}

/// Everything in which the workspace is not as planned.
pub fn faults(plan: &Plan, workspace: &Workspace) -> Vec<String> {
    let mut faults = Vec::new();
    for (name, room) in plan {
        if !room.later && !workspace.contains_key(name) {
            faults.push(format!("{name} is in the floor table but not in the workspace"));
        }
    }
    for (name, dependencies) in workspace {
        let Some(room) = plan.get(name) else {
            faults.push(format!("{name} is not in the floor table"));
            continue;
        };
        for (dependency, below) in dependencies.iter().filter_map(|d| Some((d, plan.get(d)?))) {
            if below.floor == room.floor {
                faults.push(format!("{name} depends sideways on {dependency}, floor {}", room.floor));
            } else if below.floor > room.floor {
                let (from, to) = (room.floor, below.floor);
                faults.push(format!("{name} (floor {from}) depends upwards on {dependency} (floor {to})"));
            }
        }
    }
    faults
}

fn workspace() -> Workspace {
    let packages = metadata(&["--no-deps"]).packages.into_iter();
    packages
        .map(|package| {
            let ours = package.dependencies.into_iter().filter(|dependency| dependency.path.is_some());
            (package.name, ours.map(|dependency| dependency.name).collect())
        })
        .collect()
}

#[test]
fn every_crate_stands_on_lower_floors() {
    let page = std::fs::read_to_string(root().join("docs/architecture.md")).expect("docs/architecture.md");
    let plan = read_plan(&page).unwrap();
    assert!(!plan.is_empty(), "docs/architecture.md: no floor table found");
    let faults = faults(&plan, &workspace());
    assert!(faults.is_empty(), "docs/architecture.md against the workspace:\n  {}", faults.join("\n  "));
}

const TABLE: &str = "
| floor | crate | what lives there |
|---|---|---|
| 1 | `ground` | ... |
| 2 | `left` | ... |
| 2 | `right` | ... |
| 3 | `roof` (later) | ... |
";

fn checked(crates: &[(&str, &[&str])]) -> Vec<String> {
    let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    let workspace = crates.iter().map(|&(name, needs)| (name.to_owned(), owned(needs))).collect();
    faults(&read_plan(TABLE).unwrap(), &workspace)
}

#[test]
fn a_sound_house_has_no_faults() {
    let none: [String; 0] = [];
    assert_eq!(checked(&[("ground", &[]), ("left", &["ground"]), ("right", &["ground"])]), none);
    let with_roof: [(&str, &[&str]); 4] =
        [("ground", &[]), ("left", &[]), ("right", &[]), ("roof", &["left", "ground"])];
    assert_eq!(checked(&with_roof), none);
}

#[test]
fn upward_and_sideways_dependencies_are_faults() {
    let upward = checked(&[("ground", &["left"]), ("left", &[]), ("right", &[])]);
    assert_eq!(upward, ["ground (floor 1) depends upwards on left (floor 2)"]);
    let sideways = checked(&[("ground", &[]), ("left", &["right"]), ("right", &[])]);
    assert_eq!(sideways, ["left depends sideways on right, floor 2"]);
}

#[test]
fn strangers_and_empty_rooms_are_faults() {
    let stranger = checked(&[("ground", &[]), ("left", &[]), ("right", &[]), ("shed", &["ground"])]);
    assert_eq!(stranger, ["shed is not in the floor table"]);
    let empty = checked(&[("ground", &[]), ("left", &[])]);
    assert_eq!(empty, ["right is in the floor table but not in the workspace"]);
}

#[test]
fn a_table_that_cannot_be_read_is_refused() {
    for (row, complaint) in [
        ("| 1 | ground | ... |", "backticks"),
        ("| 1 | `ground` (soon) | ... |", "(later)"),
        ("| 1 | `ground` | ... |\n| 2 | `ground` | ... |", "twice"),
    ] {
        let refused = read_plan(row).unwrap_err();
        assert!(refused.contains(complaint), "{refused}");
    }
}

/// Data, numbers and elementary functions: what a second engine may share with the first.
const DATA: [&str; 4] = ["features", "hardware-model", "landscape", "scenario"];

#[test]
fn the_second_engine_shares_data_alone() {
    let workspace = workspace();
    let shared: Vec<&str> = workspace["interpreter"].iter().map(String::as_str).collect();
    assert_eq!(shared, DATA, "the interpreter depends on more than data");
}
