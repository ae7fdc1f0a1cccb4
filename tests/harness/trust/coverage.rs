//! Lines and branches of source files that tests reach: from the tracefile of `cargo llvm-cov --lcov`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

/// What tests reach of one file, its own tests left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileCoverage {
    /// The file, from the root of the workspace.
    pub file: String,
    /// Number of lines with code.
    pub lines: usize,
    /// Those that no test reaches.
    pub missed: Vec<u32>,
    /// Ways out of conditions: two of each that the compiler counts.
    pub branches: usize,
    /// Those that were taken.
    pub taken: usize,
}

impl FileCoverage {
    /// Lines reached, lines, branches taken, branches.
    pub fn counts(&self) -> [usize; 4] {
        [self.lines - self.missed.len(), self.lines, self.taken, self.branches]
    }
}

/// What a tracefile says of the sources below `house`, without tests: modules of a file and files of their own.
///
/// # Errors
/// If a file is not below `house`, cannot be read, or the tracefile is not whole.
pub fn coverage(tracefile: &str, house: &Path) -> Result<Vec<FileCoverage>, String> {
    let house = house.canonicalize().map_err(|error| format!("{}: {error}", house.display()))?;
    let mut files = Vec::new();
    for record in tracefile.split_terminator("end_of_record").map(str::trim).filter(|one| !one.is_empty()) {
        let name = record.lines().find_map(|line| line.strip_prefix("SF:"));
        let name = name.ok_or("a record without a line `SF:`; expected what cargo llvm-cov --lcov writes")?;
        let path = Path::new(name);
        let text = fs::read_to_string(path).map_err(|error| format!("{name}: {error}"))?;
        let file = path.strip_prefix(&house).map_err(|_| format!("{name}: outside the workspace"))?;
        if !is_of_tests(path) {
            let found = of_record(record, file.to_string_lossy().into_owned(), tests_begin(&text));
            files.push(found.ok_or_else(|| format!("{name}: a count that is no number"))?);
        }
    }
    files.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(files)
}

/// Lines that are there for tests alone, with their numbers: those behind `#[cfg(test)]`.
fn of_tests(text: &str) -> impl Iterator<Item = (u32, &str)> {
    let numbered = (2..).zip(text.lines().zip(text.lines().skip(1)));
    numbered.filter(|(_, (first, _))| first.trim() == "#[cfg(test)]").map(|(at, (_, second))| (at, second))
}

/// The line on which a file's module of tests begins; nothing stands behind it.
fn tests_begin(text: &str) -> u32 {
    of_tests(text).find(|(_, line)| line.ends_with('{')).map_or(u32::MAX, |(at, _)| at)
}

/// Whether a file, or a module that it is in, is there for tests alone.
fn is_of_tests(path: &Path) -> bool {
    path.ancestors().take_while(|module| !module.ends_with("src")).any(is_declared_for_tests)
}

fn is_declared_for_tests(module: &Path) -> bool {
    let (Some(name), Some(folder)) = (module.file_stem(), module.parent()) else { return false };
    let line = format!("mod {};", name.to_string_lossy());
    let roots = ["lib.rs", "main.rs", "mod.rs"].map(|root| folder.join(root));
    let declares = |text: String| of_tests(&text).any(|(_, second)| second.trim() == line);
    roots
        .into_iter()
        .chain([folder.with_extension("rs")])
        .any(|file| fs::read_to_string(file).is_ok_and(declares))
}

/// A file's record, up to the line on which its tests begin.
fn of_record(record: &str, file: String, tests: u32) -> Option<FileCoverage> {
    let mut lines: BTreeMap<u32, u64> = BTreeMap::new();
    let (mut branches, mut taken) = (0, 0);
    for line in record.lines() {
        let Some((what, rest)) = line.split_once(':') else { continue };
        let mut words = rest.split(',');
        match what {
            "DA" => {
                let (at, count) = (words.next()?.parse().ok()?, words.next()?.parse::<u64>().ok()?);
                *lines.entry(at).or_default() += count;
            }
            "BRDA" if words.next()?.parse::<u32>().ok()? < tests => {
                branches += 1;
                taken += usize::from(!matches!(words.next_back()?, "0" | "-"));
            }
            _ => {}
        }
    }
    let own = || lines.range(..tests);
    let missed = own().filter(|(_, count)| **count == 0).map(|(at, _)| *at).collect();
    Some(FileCoverage { file, lines: own().count(), missed, branches, taken })
}

/// Lines in ascending order as stretches: `3-5, 9`.
pub fn stretches(lines: &[u32]) -> String {
    let mut told: Vec<[u32; 2]> = Vec::new();
    for &line in lines {
        match told.last_mut() {
            Some([_, last]) if *last + 1 == line => *last = line,
            _ => told.push([line, line]),
        }
    }
    let words = told
        .iter()
        .map(|[first, last]| if first == last { first.to_string() } else { format!("{first}-{last}") });
    words.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::{coverage, stretches};

    #[test]
    fn tests_do_not_count_as_covered() {
        let house = tempfile::tempdir().unwrap();
        let folder = house.path().canonicalize().unwrap();
        let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
        std::fs::create_dir_all(folder.join("src/law/deep")).unwrap();
        // The file that declares a module of tests need have no code of its own.
        write("src/lib.rs", "mod law;\n#[cfg(test)]\nmod rig;\n");
        write(
            "src/law.rs",
            "#[cfg(test)]\nmod deep;\nfn law() {\n    1\n}\n\n#[cfg(test)]\nmod tests {\n}\n",
        );
        let helpers = ["src/rig.rs", "src/law/deep.rs", "src/law/deep/more.rs"];
        helpers.iter().chain(&["src/law/other.rs"]).for_each(|name| write(name, "fn code() {}\n"));
        let record =
            |name: &str, lines: &str| format!("SF:{}\n{lines}end_of_record\n", folder.join(name).display());
        let law = "BRDA:4,0,0,3\nBRDA:4,0,1,-\nBRDA:9,0,0,4\nDA:3,3\nDA:4,0\nDA:9,4\nLF:3\n";
        let helpers: String = helpers.iter().map(|name| record(name, "DA:1,1\n")).collect();
        let tracefile = record("src/law.rs", law) + &helpers + &record("src/law/other.rs", "DA:1,0\n");
        let found = coverage(&tracefile, &folder).unwrap();
        let told: Vec<_> = found.iter().map(|file| (&*file.file, file.counts(), &*file.missed)).collect();
        assert_eq!(told, [("src/law.rs", [1, 2, 1, 2], &[4][..]), ("src/law/other.rs", [0, 1, 0, 0], &[1])]);
        assert!(coverage("SF:/elsewhere/law.rs\nend_of_record\n", &folder).is_err());
        assert!(coverage(&record("src/law.rs", "DA:1,many\n"), &folder).is_err());
    }

    #[test]
    fn neighbours_are_one_stretch() {
        assert_eq!(stretches(&[3, 4, 5, 9, 11, 12]), "3-5, 9, 11-12");
        assert_eq!(stretches(&[]), "");
    }
}
