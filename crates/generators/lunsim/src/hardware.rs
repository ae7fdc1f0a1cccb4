//! What the program ran on: times of its computer and of its recorder, as `hardware-models/programs/lunsim.toml` has them.

use diagnostics::{ProblemList, Reader, TomlFile};

/// The file as the program carries it.
pub(crate) const SHIPPED: &str = include_str!("../../../../hardware-models/programs/lunsim.toml");

/// Nanoseconds in a microsecond and in a second.
const MICROSECOND: f64 = 1e3;
const SECOND: f64 = 1e9;

/// Times of the computer (an IBM 360/65) and of the recorder (a Stromberg-Carlson 4020), in whole nanoseconds, so that sums
/// of them are exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// Time of an addition or a subtraction (ns).
    pub add: u64,
    /// Time of a multiplication (ns).
    pub multiply: u64,
    /// Time of a division (ns).
    pub divide: u64,
    /// Time of a square root (ns).
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
        TomlFile::read_text("built-in programs/lunsim.toml", SHIPPED, Self::read)
    }

    /// The times of the tables `computer` and `recorder`; every key is needed.
    pub(crate) fn read(root: &Reader) -> Option<Self> {
        let [computer, recorder] = ["computer", "recorder"].map(|name| root.table_or_empty(name));
        let time = |key: &str| {
            let time = computer.f64(key).between(0.001, 1e4).unit("µs").required();
            time.map(|time| (time * MICROSECOND).round() as u64)
        };
        let keys = ["add_us", "multiply_us", "divide_us", "root_us", "instruction_us"];
        let [add, multiply, divide, root_time, instruction] = keys.map(time);
        let points = recorder.f64("points_s").between(1.0, 1e6).unit("points/s").required();
        Some(Self {
            add: add?,
            multiply: multiply?,
            divide: divide?,
            root: root_time?,
            instruction: instruction?,
            point: (SECOND / points?).round() as u64,
        })
    }
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
}
