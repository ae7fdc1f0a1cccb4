//! Dependencies run downwards only; `docs/architecture.md` names exactly the crates that exist, in their folders.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::metadata::{Package, metadata, root};

/// The floor of every room, counted from below.
pub type Plan = BTreeMap<String, u32>;
/// Names of a crate's dependencies within the workspace, of any kind.
pub type Workspace = BTreeMap<String, BTreeSet<String>>;

/// The floor table: the plan, and the folder of each crate.
type House = (Plan, BTreeMap<String, String>);

/// Reads the rows `| folder | crates | ... |` of the floor table, from the lowest folder to the highest. A semicolon in the second
/// cell begins the next floor of the folder. A row whose first cell is no name in backticks is no row of the table.
fn read_house(page: &str) -> Result<House, String> {
    let (mut plan, mut folders) = House::default();
    let mut floor = 0;
    let table =
        page.lines().skip_while(|line| !line.starts_with(HEAD)).take_while(|line| line.starts_with('|'));
    for line in table.skip(2) {
        let cells: Vec<_> = line.split('|').map(str::trim).collect();
        let ["", folder, rooms, .., ""] = cells[..] else {
            return Err(format!("floor table, `{line}`: expected three cells"));
        };
        let folder = in_backticks(folder)?;
        for level in rooms.split(';') {
            floor += 1;
            for name in level.split_whitespace() {
                let name = in_backticks(name)?.to_owned();
                folders.insert(name.clone(), folder.to_owned());
                if plan.insert(name.clone(), floor).is_some() {
                    return Err(format!("floor table: {name} stands there twice"));
                }
            }
        }
    }
    Ok((plan, folders))
}

/// How the floor table begins.
const HEAD: &str = "| folder | crates";

fn in_backticks(word: &str) -> Result<&str, String> {
    let name = word.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
    name.ok_or_else(|| format!("floor table, `{word}`: expected a name in backticks"))
}

/// Everything in which the workspace is not as planned.
pub fn faults(plan: &Plan, workspace: &Workspace) -> Vec<String> {
    let mut faults = Vec::new();
    for name in plan.keys().filter(|name| !workspace.contains_key(*name)) {
        faults.push(format!("{name} is in the floor table but not in the workspace"));
    }
    for (name, dependencies) in workspace {
        let Some(&floor) = plan.get(name) else {
            faults.push(format!("{name} is not in the floor table"));
            continue;
        };
        for (dependency, below) in dependencies.iter().filter_map(|d| Some((d, *plan.get(d)?))) {
            if below == floor {
                faults.push(format!("{name} depends sideways on {dependency}, floor {floor}"));
            } else if below > floor {
                faults
                    .push(format!("{name} (floor {floor}) depends upwards on {dependency} (floor {below})"));
            }
        }
    }
    faults
}

/// Crates that do not lie in the folder of their row. `paths` are those of the crates below the root.
fn misplaced(folders: &BTreeMap<String, String>, paths: &BTreeMap<String, String>) -> Vec<String> {
    let wrong = paths.iter().filter_map(|(name, path)| {
        let folder = folders.get(name)?;
        let expected = if folder == "tests" { folder.clone() } else { format!("{folder}/{name}") };
        (*path != expected).then(|| format!("{name} lies in {path}, expected {expected}"))
    });
    wrong.collect()
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

fn page() -> String {
    std::fs::read_to_string(root().join("docs/architecture.md")).expect("docs/architecture.md")
}

#[test]
fn every_crate_stands_on_lower_floors() {
    let (plan, _) = read_house(&page()).unwrap();
    assert!(!plan.is_empty(), "docs/architecture.md: no floor table found");
    let faults = faults(&plan, &workspace());
    assert!(faults.is_empty(), "docs/architecture.md against the workspace:\n  {}", faults.join("\n  "));
}

#[test]
fn folders_show_the_floors() {
    let house = root().canonicalize().expect("the house");
    let path = |package: &Package| {
        let folder = Path::new(&package.manifest_path).parent().expect("a manifest lies in a folder");
        let inside =
            folder.strip_prefix(&house).expect("a crate lies in the house").to_string_lossy().into_owned();
        (package.name.clone(), inside)
    };
    let packages = metadata(&["--no-deps"]).packages;
    let misplaced = misplaced(&read_house(&page()).unwrap().1, &packages.iter().map(path).collect());
    assert!(misplaced.is_empty(), "docs/architecture.md against the folders:\n  {}", misplaced.join("\n  "));
    let silent: Vec<_> =
        packages.iter().filter(|package| package.description.is_none()).map(|p| &p.name).collect();
    assert!(silent.is_empty(), "without a description in Cargo.toml: {silent:?}");
}

const TABLE: &str = "
| folder | crates, floor by floor | what lives there |
|---|---|---|
| `low` | `ground`; `left` `right` | ... |
| `high` | `roof` | ... |
";

fn checked(crates: &[(&str, &[&str])]) -> Vec<String> {
    let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    let workspace = crates.iter().map(|&(name, needs)| (name.to_owned(), owned(needs))).collect();
    faults(&read_house(TABLE).unwrap().0, &workspace)
}

#[test]
fn a_sound_house_has_no_faults() {
    let none: [String; 0] = [];
    let rooms: [(&str, &[&str]); 4] =
        [("ground", &[]), ("left", &["ground"]), ("right", &["ground"]), ("roof", &["left", "ground"])];
    assert_eq!(checked(&rooms), none);
}

#[test]
fn upward_and_sideways_dependencies_are_faults() {
    let upward = checked(&[("ground", &["left"]), ("left", &[]), ("right", &[]), ("roof", &[])]);
    assert_eq!(upward, ["ground (floor 1) depends upwards on left (floor 2)"]);
    let between_folders = checked(&[("ground", &[]), ("left", &["roof"]), ("right", &[]), ("roof", &[])]);
    assert_eq!(between_folders, ["left (floor 2) depends upwards on roof (floor 3)"]);
    let sideways = checked(&[("ground", &[]), ("left", &["right"]), ("right", &[]), ("roof", &[])]);
    assert_eq!(sideways, ["left depends sideways on right, floor 2"]);
}

#[test]
fn strangers_and_empty_rooms_are_faults() {
    let stranger =
        checked(&[("ground", &[]), ("left", &[]), ("right", &[]), ("roof", &[]), ("shed", &["ground"])]);
    assert_eq!(stranger, ["shed is not in the floor table"]);
    let empty = checked(&[("ground", &[]), ("left", &[]), ("roof", &[])]);
    assert_eq!(empty, ["right is in the floor table but not in the workspace"]);
}

#[test]
fn a_crate_in_another_folder_is_a_fault() {
    let (_, folders) = read_house(TABLE).unwrap();
    let paths =
        [("left", "low/left"), ("roof", "low/roof")].map(|(name, path)| (name.to_owned(), path.to_owned()));
    assert_eq!(misplaced(&folders, &paths.into()), ["roof lies in low/roof, expected high/roof"]);
}

#[test]
fn a_table_that_cannot_be_read_is_refused() {
    for (row, complaint) in [
        ("| low | `ground` | ... |", "backticks"),
        ("| `low` | `ground`, `left` | ... |", "backticks"),
        ("| `low` | `ground`; `ground` | ... |", "twice"),
        ("| `low` |", "three cells"),
    ] {
        let refused = read_house(&format!("{HEAD} | x |\n|---|---|---|\n{row}")).unwrap_err();
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
