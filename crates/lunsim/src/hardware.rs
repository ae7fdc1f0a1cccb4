//! What the program ran on: times of its computer and of its recorder, as `hardware-models/programs/lunsim.toml` has them.

use diagnostics::{ProblemList, Problems, Reader, TomlFile};

/// The file as the program carries it.
const SHIPPED: &str = include_str!("../../../hardware-models/programs/lunsim.toml");

/// Nanoseconds in a microsecond and in a second.
const MICROSECOND: f64 = 1e3;
const SECOND: f64 = 1e9;

/// Times of the computer (an IBM 360/65) and of the recorder (a Stromberg-Carlson 4020), in whole nanoseconds, so that sums
/// of them are exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// Addition, subtraction.
    pub add: u64,
    /// Multiplication.
    pub multiply: u64,
    /// Division.
    pub divide: u64,
    /// Square root.
    pub root: u64,
    /// Any other instruction: fetch, compare, store, branch, shift.
    pub instruction: u64,
    /// One point on the film.
    pub point: u64,
}

impl Hardware {
    /// The shipped file.
    ///
    /// # Errors
    /// Every fault of it: a program that carries a faulty one.
    pub fn shipped() -> Result<Self, ProblemList> {
        Self::parse("built-in programs/lunsim.toml", SHIPPED)
    }

    /// The times of a file, which has all of them; `name` is how messages call it.
    ///
    /// # Errors
    /// Every fault of the text.
    pub fn parse(name: &str, text: &str) -> Result<Self, ProblemList> {
        read(name, text, None)
    }

    /// These times with what `lines` of TOML say instead; `origin` names where they come from.
    ///
    /// # Errors
    /// Every fault of the lines.
    pub fn with(self, origin: &str, lines: &str) -> Result<Self, ProblemList> {
        read(origin, lines, Some(self))
    }
}

fn read(origin: &str, text: &str, usual: Option<Hardware>) -> Result<Hardware, ProblemList> {
    let problems = Problems::new();
    let read = TomlFile::parse(origin, text, &problems).and_then(|file| {
        let root = file.root(&problems);
        let read = of_tables(&root, usual);
        root.finish();
        read
    });
    problems.resolve(read)
}

/// The times of both tables, `usual` where they are silent; without it every key is needed.
fn of_tables(root: &Reader, usual: Option<Hardware>) -> Option<Hardware> {
    let [computer, recorder] = ["computer", "recorder"].map(|name| root.table_or_empty(name));
    let time = |key: &str, usual: Option<u64>| {
        let time = computer.f64(key).between(0.001, 1e4).unit("µs");
        let usual = usual.map(|nanoseconds| nanoseconds as f64 / MICROSECOND);
        let time = if let Some(usual) = usual { time.default(usual) } else { time.required() };
        Some((time? * MICROSECOND).round() as u64)
    };
    let [add, multiply, divide, root_time, instruction] = [
        time("add_us", usual.map(|usual| usual.add)),
        time("multiply_us", usual.map(|usual| usual.multiply)),
        time("divide_us", usual.map(|usual| usual.divide)),
        time("root_us", usual.map(|usual| usual.root)),
        time("instruction_us", usual.map(|usual| usual.instruction)),
    ];
    let points = recorder.f64("points_s").between(1.0, 1e6).unit("points/s");
    let points = match usual {
        Some(usual) => points.default(SECOND / usual.point as f64),
        None => points.required(),
    };
    Some(Hardware {
        add: add?,
        multiply: multiply?,
        divide: divide?,
        root: root_time?,
        instruction: instruction?,
        point: (SECOND / points?).round() as u64,
    })
}

#[cfg(test)]
mod tests {
    use super::{Hardware, SHIPPED};

    #[test]
    fn the_shipped_file_has_whole_nanoseconds() {
        let hardware = Hardware::shipped().unwrap();
        let times = [hardware.add, hardware.multiply, hardware.divide, hardware.root, hardware.instruction];
        assert_eq!(times, [1300, 4500, 7000, 60_000, 1000]);
        assert_eq!(hardware.point, 100_000);
    }

    /// As in every file of `hardware-models/`.
    #[test]
    fn every_value_says_where_it_comes_from() {
        let values: Vec<&str> =
            SHIPPED.lines().filter(|line| line.contains(" = ") && !line.starts_with('#')).collect();
        assert_eq!(values.len(), 6);
        for line in values {
            let (_, comment) = line.split_once(" # ").unwrap_or_default();
            assert!(
                ["period", "unsourced", "chosen"].iter().any(|status| comment.starts_with(status)),
                "{line}"
            );
        }
    }

    #[test]
    fn lines_change_what_they_name_and_each_counts() {
        let shipped = Hardware::shipped().unwrap();
        let keys = ["add_us", "multiply_us", "divide_us", "root_us", "instruction_us"];
        let lines = keys.map(|key| format!("computer.{key} = 2.5"));
        let mut all = lines.into_iter().chain(["recorder.points_s = 4000".into()]).collect::<Vec<String>>();
        for line in &all {
            assert_ne!(shipped.with("--set", line).unwrap(), shipped, "{line}");
        }
        assert_eq!(
            shipped.with("--set", &all.swap_remove(5)).unwrap(),
            Hardware { point: 250_000, ..shipped }
        );
        for wrong in ["computer.add_us = 0", "computer.ad_us = 1", "recorder.points_s = \"fast\""] {
            let problems = shipped.with("--set", wrong).unwrap_err();
            assert_eq!(problems.iter().count(), 1, "{problems}");
        }
    }
}
