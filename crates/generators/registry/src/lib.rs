//! The generators that are chosen by their own names, a row each.
//!
//! A new generator is a crate of its own and a row in [`ROWS`]: `docs/adding-a-generator.md`. The hybrid machine is not
//! among them: the name of a hardware model chooses it.
//!
//! - [`find`], [`names`]: rows by name. [`judge`]: the one that error is measured against.
//! - [`configure`], [`configure_told`]: run parameters and gear, layer by layer, into a generator.

use std::sync::Arc;

use diagnostics::{Layers, Origin, Problem, ProblemList, Problems, TomlFile};
use generator::{Generator, PrepareError, Role, Row, Session, Stage};

/// All rows, in the order in which they are listed.
pub static ROWS: &[&Row] =
    &[&exact::ROW, &lunsim::ROW, &sampled::ROW, &lod_mesh::ROW, &panels::ROW, &smooth_faces::ROW];

/// The row of that name.
pub fn find(name: &str) -> Option<&'static Row> {
    ROWS.iter().copied().find(|row| row.name == name)
}

/// Names of all rows.
pub fn names() -> Vec<&'static str> {
    ROWS.iter().map(|row| row.name).collect()
}

/// The generator that the pictures of the others are judged by.
///
/// # Panics
/// If no row has the role: a test holds that exactly one has.
pub fn judge() -> &'static Row {
    ROWS.iter().copied().find(|row| row.role == Role::Judge).expect("one row has the role of the judge")
}

/// The judge made ready for `stage`.
///
/// # Errors
/// If it cannot draw the stage.
pub fn judge_on(stage: Stage) -> Result<Box<dyn Session>, PrepareError> {
    let row = judge();
    let refused = |problems: ProblemList| PrepareError::Unsupported {
        generator: row.name,
        what: problems.to_string(),
        remedy: "mend its row".into(),
    };
    configure_with(row, &[]).map_err(refused)?.prepare(stage)
}

/// Tables of run parameters that a scenario may have.
pub fn parameter_tables() -> Vec<&'static str> {
    ROWS.iter().filter_map(|row| row.parameters).collect()
}

/// The row whose run parameters or gear `key`, a dotted key of `--set`, is among.
pub fn owner(key: &str) -> Option<&'static Row> {
    ROWS.iter().copied().find(|row| row.owns(key))
}

/// The generator of `row`. `layers` are files with its tables, the later over the earlier, and all of them over the gear
/// that ships; other tables of these files are passed over.
///
/// # Errors
/// Every fault of the tables.
pub fn configure(
    row: &Row,
    layers: impl IntoIterator<Item = TomlFile>,
) -> Result<Arc<dyn Generator>, ProblemList> {
    configure_told(row, layers).map(|configured| configured.generator)
}

/// A generator, and what its tables come to.
pub struct Configured {
    /// The generator with its run parameters and gear.
    pub generator: Arc<dyn Generator>,
    /// Each value of its tables that a file sets: dotted key, and where it stands.
    pub values: Vec<(String, Origin)>,
}

/// The same with the values of the tables.
///
/// # Errors
/// As [`configure`].
pub fn configure_told(
    row: &Row,
    layers: impl IntoIterator<Item = TomlFile>,
) -> Result<Configured, ProblemList> {
    let problems = Problems::new();
    let gear = row.gear.and_then(|gear| TomlFile::parse(gear.file, gear.text, &problems));
    let layers = Layers::new(gear.into_iter().chain(layers));
    let root = layers.root(&problems);
    let generator = (row.configure)(&root);
    row.tables().for_each(|table| root.table_or_empty(table).finish());
    let mut values = layers.origins();
    values.retain(|(key, _)| row.owns(key));
    problems.resolve(generator.map(|generator| Configured { generator, values }))
}

/// The same from keys of `--set` alone.
///
/// # Errors
/// Every fault of the keys.
pub fn configure_with(row: &Row, sets: &[(&str, &str)]) -> Result<Arc<dyn Generator>, ProblemList> {
    let problems = Problems::new();
    let lines = sets.iter().map(|(key, value)| set_line(key, value, &problems)).collect::<Option<Vec<_>>>();
    configure(row, problems.resolve(lines)?)
}

/// A key of `--set` as a file of one line. A word such as `drop-smallest` needs no quotes.
pub fn set_line(key: &str, value: &str, problems: &Problems) -> Option<TomlFile> {
    let line = if is_word(value) { format!("{key} = \"{value}\"") } else { format!("{key} = {value}") };
    TomlFile::parse("--set", &line, problems)
}

/// Whether a value is a word that can be nothing else in TOML.
fn is_word(value: &str) -> bool {
    let is_in_word = |letter: char| letter.is_ascii_alphanumeric() || letter == '-' || letter == '_';
    value.starts_with(|letter: char| letter.is_ascii_alphabetic())
        && value.chars().all(is_in_word)
        && !["true", "false", "inf", "nan"].contains(&value)
}

/// Format of an overlay over a generator.
const OVERLAY_FORMAT: u64 = 1;

/// Reads `text` as an overlay over run parameters and gear of `row`: `format`, and differences in its tables. `name` is how messages
/// call it.
///
/// # Errors
/// Every fault of the overlay.
pub fn overlay(row: &Row, name: &str, text: &str) -> Result<TomlFile, ProblemList> {
    let problems = Problems::new();
    if let Some(file) = TomlFile::parse(name, text, &problems) {
        let gear = row.gear.and_then(|gear| TomlFile::parse(gear.file, gear.text, &problems));
        let layers = Layers::new(gear.into_iter().chain([file]));
        let root = layers.root(&problems);
        root.format_version(OVERLAY_FORMAT);
        drop((row.configure)(&root));
        row.tables().for_each(|table| drop(root.table_or_empty(table)));
        root.finish();
    }
    problems.into_result()?;
    // Layers took the file; it has no fault.
    let problems = Problems::new();
    let again = TomlFile::parse(name, text, &problems);
    problems.resolve(again)
}

/// The row that `file` is an overlay of, by its tables.
pub fn overlay_owner(file: &TomlFile) -> Option<&'static Row> {
    let silent = Problems::new();
    let root = file.root(&silent);
    ROWS.iter().copied().find(|row| row.tables().any(|table| root.has(table)))
}

/// Reads `text` as the whole gear file of `row`; `name` is the path as the user gave it.
///
/// # Errors
/// Every fault of the file.
pub fn check_gear(row: &Row, name: &str, text: &str) -> Result<(), ProblemList> {
    let problems = Problems::new();
    let Some(gear) = row.gear else {
        return Err(Problem::of_file(name, format!("{} has no gear file", row.name)).into());
    };
    let read = TomlFile::parse(name, text, &problems).and_then(|file| {
        let root = file.root(&problems);
        let read = (row.configure)(&root);
        gear.tables.iter().for_each(|table| drop(root.table_or_empty(table)));
        root.finish();
        read
    });
    problems.resolve(read.map(drop))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    use generator::{Role, Row};

    use super::{ROWS, check_gear, configure_with, find, overlay, overlay_owner, owner};

    #[test]
    fn names_and_tables_are_of_one_row_and_one_row_judges() {
        let names: BTreeSet<_> = ROWS.iter().map(|row| row.name).collect();
        let tables: Vec<_> = ROWS.iter().flat_map(|row| row.tables()).collect();
        assert_eq!(names.len(), ROWS.len());
        assert_eq!(BTreeSet::from_iter(&tables).len(), tables.len());
        assert_eq!(ROWS.iter().filter(|row| row.role == Role::Judge).count(), 1);
    }

    #[test]
    fn every_row_is_configured_as_it_ships_and_has_its_name() {
        for row in ROWS {
            let generator = configure_with(row, &[]).unwrap_or_else(|problems| panic!("{problems}"));
            assert_eq!((generator.name(), generator.signals()), (row.name, row.signals));
            assert!(
                row.tables()
                    .all(|table| owner(&format!("{table}.key")).is_some_and(|own| own.name == row.name))
            );
            if let Some(gear) = row.gear {
                check_gear(row, gear.file, gear.text).unwrap_or_else(|problems| panic!("{problems}"));
            }
        }
    }

    /// What is carried is what is in the folder, and each overlay is known by its tables as one over its row.
    #[test]
    fn faults_of_a_row_are_overlays_over_it() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../hardware-models/faults");
        for row in ROWS {
            let faults = row.gear.map_or(&[][..], |gear| gear.faults);
            let files = fs::read_dir(folder.join(row.name)).into_iter().flatten().flatten();
            let names: BTreeSet<_> =
                files.map(|entry| entry.path().file_stem().unwrap().to_string_lossy().into_owned()).collect();
            assert_eq!(names, faults.iter().map(|(name, _)| (*name).to_owned()).collect());
            for (name, text) in faults {
                let file = overlay(row, name, text).unwrap_or_else(|problems| panic!("{problems}"));
                assert_eq!(overlay_owner(&file), Some(*row));
            }
        }
    }

    #[test]
    fn an_overlay_has_its_format_and_tables_of_its_generator_alone() {
        let row = find("sampled").unwrap();
        for (text, told) in [
            ("[sampled]\nnormalise = false\n", "format"),
            ("format = 2\n[sampled]\nnormalise = false\n", "format 2"),
            ("format = 1\n[sampled]\ntwinkle = true\n", "twinkle"),
            ("format = 1\n[sampled]\nnormalise = false\n[loader]\naccess_ns = 90\n", "loader"),
            ("format = 1\n[sampler]\nsampler_hz = -1\n", "sampler_hz"),
        ] {
            let problems = overlay(row, "mine.toml", text).unwrap_err().to_string();
            assert!(problems.contains(told), "{text}: {problems}");
        }
    }

    /// What the folder of a generator says of itself, by the doc of its crate.
    fn own_page(row: &Row) -> String {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(row.name);
        let source = fs::read_to_string(folder.join("src/lib.rs")).unwrap_or_default();
        let lines = source.lines().filter_map(|line| line.strip_prefix("//! "));
        lines.map(|line| format!("{line}\n")).collect()
    }

    /// Run parameters stand on the page of scenario files or in the doc of the generator's crate. Keys that a generator asks for
    /// are in its message about an unknown one.
    #[test]
    fn a_page_names_the_run_parameters() {
        let shared = include_str!("../../../../docs/scenario-format.md");
        for row in ROWS {
            let Some(table) = row.parameters else { continue };
            let page = format!("{shared}{}", own_page(row));
            let rows = page.lines().filter_map(|line| line.strip_prefix(&format!("| `{table}.")));
            let documented: BTreeSet<&str> = rows.filter_map(|row| row.split('`').next()).collect();
            let stray = configure_with(row, &[(&format!("{table}.stray"), "1")]).err().unwrap();
            let expected = stray.iter().next().unwrap().expected.clone().unwrap();
            let known: BTreeSet<&str> =
                expected.trim_start_matches("one of ").trim_start_matches("only ").split(", ").collect();
            assert_eq!(known, documented, "{table}");
        }
    }

    #[test]
    fn a_word_needs_no_quotes() {
        let row = find("sampled").unwrap();
        let record = |value: &str| {
            configure_with(row, &[("sampled.overload", value)])
                .map(|found| found.record()["overload"].clone())
        };
        assert_eq!(record("drop-farthest").unwrap(), record("\"drop-farthest\"").unwrap());
        for wrong in ["true", "nan", "4late", "late,", "late late", ""] {
            assert!(record(wrong).is_err(), "{wrong}");
        }
        assert_eq!(configure_with(row, &[("sampled.rotate", "true")]).unwrap().record()["rotate"], true);
    }

    #[test]
    fn a_set_changes_what_it_names_and_each_fault_is_told() {
        let row = find("lunsim").unwrap();
        let record = |sets: &[(&str, &str)]| configure_with(row, sets).map(|found| found.record());
        assert_eq!(record(&[("lunsim.grid", "64")]).unwrap()["grid"], 64);
        for (key, value) in [
            ("computer.add_us", "0"),
            ("computer.ad_us", "1"),
            ("recorder.points_s", "\"fast\""),
            ("lunsim.gird", "64"),
            ("lunsim.grid", "4"),
        ] {
            let problems = record(&[(key, value)]).unwrap_err();
            assert_eq!(problems.iter().count(), 1, "{problems}");
        }
    }
}
