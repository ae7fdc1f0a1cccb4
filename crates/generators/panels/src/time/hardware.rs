//! What the program ran on: times of its computer, as `hardware-models/programs/panels.toml` has them.

use diagnostics::{ProblemList, Reader, TomlFile};

/// The file as the program carries it.
pub(crate) const SHIPPED: &str = include_str!("../../../../../hardware-models/programs/panels.toml");

/// Nanoseconds in a microsecond.
const MICROSECOND: f64 = 1e3;

/// Times of a minicomputer, in whole nanoseconds, so that sums of them are exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// Time of a number that is read or written by format (ns).
    pub formatted_number: u64,
    /// Time of a byte of a record (ns).
    pub record_byte: u64,
    /// Time of any other instruction (ns).
    pub instruction: u64,
    /// Time of a multiplication (ns).
    pub multiply: u64,
    /// Time of a division (ns).
    pub divide: u64,
    /// Time of a square root (ns).
    pub root: u64,
    /// Time of a sine or a cosine (ns).
    pub trig: u64,
    /// Time of an access to an element of an array (ns).
    pub cell: u64,
}

impl Hardware {
    /// The shipped file.
    ///
    /// # Errors
    /// Every fault of it: a program that carries a faulty one.
    pub fn shipped() -> Result<Self, ProblemList> {
        TomlFile::read_text("built-in programs/panels.toml", SHIPPED, Self::read)
    }

    /// The times of the table `minicomputer`; every key is needed.
    pub(crate) fn read(root: &Reader) -> Option<Self> {
        let table = root.table_or_empty("minicomputer");
        let time = |key: &str| {
            let time = table.f64(key).between(0.001, 1e6).unit("µs").required();
            time.map(|time| (time * MICROSECOND).round() as u64)
        };
        let keys = ["formatted_number_us", "record_byte_us", "instruction_us", "multiply_us"];
        let [formatted_number, record_byte, instruction, multiply] = keys.map(time);
        let [divide, root_time, trig, cell] = ["divide_us", "root_us", "trig_us", "cell_us"].map(time);
        Some(Self {
            formatted_number: formatted_number?,
            record_byte: record_byte?,
            instruction: instruction?,
            multiply: multiply?,
            divide: divide?,
            root: root_time?,
            trig: trig?,
            cell: cell?,
        })
    }
}
