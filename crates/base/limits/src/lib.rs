//! How much is read and made at most, by names with which a user allows more, or less where memory is short.
//!
//! Limits guard against a slip of the keyboard and against hostile files. They decide whether something is refused, never
//! what it comes to, so they are the process's: a command sets them before it reads anything.
//!
//! ```
//! use limits::Limit;
//! assert!(Limit::Rocks.allows(100_000) && !Limit::Rocks.allows(100_001));
//! assert_eq!(limits::raise("rocks=2000000"), Ok(()));
//! assert!(Limit::Rocks.allows(100_001));
//! ```

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};

/// Quantity that is limited, as one name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// Corners of a level that is generated.
    Corners,
    /// Craters that generated ground is made with.
    GroundCraters,
    /// Craters of one population.
    Craters,
    /// Rocks of a scenario.
    Rocks,
    /// Track patches of a scenario.
    Patches,
    /// Steps of a sun that moves.
    SunSteps,
    /// Frames of a scenario.
    Frames,
    /// Bytes of a scenario or a hardware model.
    TextBytes,
    /// Bytes of a list of craters or of a path.
    ListBytes,
    /// Bytes of a coefficient bank, or of the corners for one.
    BankBytes,
    /// Bytes that the heights of a survey take in memory, eight a sample.
    ElevationBytes,
    /// Bytes of a shape file, with the files that it names.
    ShapeBytes,
    /// Convex parts of one closed shape.
    ShapeParts,
    /// Bytes of a picture that is read.
    PictureBytes,
    /// Pixels of a picture that is read or drawn.
    Pixels,
    /// Objects of a scenario.
    Objects,
    /// Events of a scenario.
    Events,
    /// Convex bodies of all objects of a scenario.
    Bodies,
    /// Lamps of a scenario, each of a string for itself.
    Lights,
    /// Sheets of a scenario, and overlays as many.
    Sheets,
    /// Stars of a sky, of a file or of a seed.
    Stars,
    /// Massifs and rilles of generated ground.
    Landforms,
    /// Rows of a table.
    Rows,
    /// Signals that are recorded at once.
    Signals,
    /// Faults of a file that are listed.
    Faults,
    /// Bytes of the record or the journal of a run.
    RecordBytes,
    /// Bytes of the header of a message of a loop.
    HeaderBytes,
    /// Bytes of all planes of a message of a loop.
    PlaneBytes,
}

/// A row of the table of limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// Limit that the row is about.
    pub limit: Limit,
    /// Its name on the command line.
    pub name: &'static str,
    /// What it limits, in words.
    pub what: &'static str,
    /// Its value unless it is raised.
    pub usual: u64,
    /// Most that it can be raised to: what numbers inside can count, with room to spare.
    pub most: u64,
}

/// All limits, in the order of [`Limit`].
pub const ROWS: [Row; 28] = [
    row(Limit::Corners, "corners", "corners of a generated level", 4_000_000, 1 << 30),
    row(Limit::GroundCraters, "ground-craters", "craters in generated ground", 1_000_000, 1 << 28),
    row(Limit::Craters, "craters", "craters of a population", 4_000_000, 1 << 28),
    row(Limit::Rocks, "rocks", "rocks of a scenario", 100_000, 1 << 28),
    row(Limit::Patches, "patches", "track patches of a scenario", 1_000_000, 1 << 28),
    row(Limit::SunSteps, "sun-steps", "steps of a sun that moves", 100_000, 1 << 28),
    row(Limit::Frames, "frames", "frames of a scenario", 10_000_000, 1 << 40),
    row(Limit::TextBytes, "text-bytes", "bytes of a scenario or a hardware model", 16 << 20, 1 << 30),
    row(Limit::ListBytes, "list-bytes", "bytes of a list of craters or of a path", 1 << 28, 1 << 40),
    row(Limit::BankBytes, "bank-bytes", "bytes of a bank, or of the corners for one", 1 << 32, 1 << 44),
    row(
        Limit::ElevationBytes,
        "elevation-bytes",
        "bytes of the heights that a survey reads",
        16 << 30,
        1 << 44,
    ),
    row(Limit::ShapeBytes, "shape-bytes", "bytes of a shape file and what it names", 1 << 24, 1 << 30),
    row(Limit::ShapeParts, "shape-parts", "convex parts of one closed shape", 1_000, 1 << 20),
    row(Limit::PictureBytes, "picture-bytes", "bytes of a picture that is read", 256 << 20, 1 << 40),
    row(Limit::Pixels, "pixels", "pixels of a picture that is read or drawn", 64 << 20, 1 << 34),
    row(Limit::Objects, "objects", "objects of a scenario", 4_000, 1 << 28),
    row(Limit::Events, "events", "events of a scenario", 100_000, 1 << 28),
    row(Limit::Bodies, "bodies", "convex bodies of all objects of a scenario", 100_000, 1 << 28),
    row(Limit::Lights, "lights", "lamps of a scenario", 100_000, 1 << 28),
    row(Limit::Sheets, "sheets", "sheets, or overlays, of a scenario", 10_000, 1 << 28),
    row(Limit::Stars, "stars", "stars of a sky", 20_000, 1 << 28),
    row(Limit::Landforms, "landforms", "massifs and rilles of a generated level", 1_000, 1 << 28),
    row(Limit::Rows, "rows", "rows of a table", 10_000_000, 1 << 40),
    row(Limit::Signals, "signals", "signals that are recorded at once", 20_000, 1 << 28),
    row(Limit::Faults, "faults", "faults of one file that are listed", 100_000, 1 << 28),
    row(Limit::RecordBytes, "record-bytes", "bytes of the record or the journal of a run", 1 << 32, 1 << 44),
    row(Limit::HeaderBytes, "header-bytes", "bytes of the header of a message of a loop", 16 << 20, 1 << 30),
    row(Limit::PlaneBytes, "plane-bytes", "bytes of all planes of a message of a loop", 256 << 20, 1 << 40),
];

const fn row(limit: Limit, name: &'static str, what: &'static str, usual: u64, most: u64) -> Row {
    Row { limit, name, what, usual, most }
}

/// What each is set to; 0 where it is not.
static SET: [AtomicU64; ROWS.len()] = [const { AtomicU64::new(0) }; ROWS.len()];

impl Limit {
    /// The largest that is allowed now.
    pub fn value(self) -> u64 {
        match SET[self as usize].load(Ordering::Relaxed) {
            0 => self.row().usual,
            set => set,
        }
    }

    /// Whether so much is allowed now.
    pub fn allows(self, count: u64) -> bool {
        count <= self.value()
    }

    /// Its row of the table.
    pub fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }
}

/// What to do about it, for the end of a message.
impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "--raise {}=N allows more", self.row().name)
    }
}

/// Sets a limit to what `assignment` says, `NAME=VALUE`: a whole number, from 1 to the row's most.
///
/// # Errors
/// What is wrong with it, and what was expected.
pub fn raise(assignment: &str) -> Result<(), String> {
    let (name, value) =
        assignment.split_once('=').ok_or_else(|| format!("`{assignment}`: expected NAME=VALUE"))?;
    let row = ROWS.iter().find(|row| row.name == name).ok_or_else(|| {
        let names: Vec<_> = ROWS.iter().map(|row| row.name).collect();
        format!("{name}: there is no such limit; there are {}", names.join(", "))
    })?;
    let expected = || format!("{name}: expected a whole number from 1 to {}, found `{value}`", row.most);
    let value: u64 = value.replace('_', "").parse().map_err(|_| expected())?;
    if !(1..=row.most).contains(&value) {
        return Err(expected());
    }
    SET[row.limit as usize].store(value, Ordering::Relaxed);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Limit, ROWS, raise};

    #[test]
    fn rows_stand_where_their_limits_say() {
        for (place, row) in ROWS.iter().enumerate() {
            assert_eq!((row.limit as usize, row.limit.row().name), (place, row.name));
            assert!(row.usual <= row.most, "{}", row.name);
        }
    }

    #[test]
    fn what_is_raised_is_allowed() {
        assert!(Limit::Patches.allows(1_000_000) && !Limit::Patches.allows(1_000_001));
        assert_eq!(raise("patches=3_000_000"), Ok(()));
        assert!(Limit::Patches.allows(3_000_000) && !Limit::Patches.allows(3_000_001));
        assert_eq!(raise("patches=3"), Ok(()));
        assert!(Limit::Patches.allows(3) && !Limit::Patches.allows(4));
    }

    #[test]
    fn what_is_no_limit_is_refused_in_words() {
        for (wrong, word) in [
            ("craters", "expected NAME=VALUE"),
            ("holes=7", "holes: there is no such limit; there are corners, "),
            ("frames=few", "frames: expected a whole number from 1 to 1099511627776, found `few`"),
            ("frames=0", "found `0`"),
            ("frames=1099511627777", "found `1099511627777`"),
            ("frames=-1", "found `-1`"),
            ("frames=99999999999999999999", "whole number"),
        ] {
            let said = raise(wrong).expect_err(wrong);
            assert!(said.contains(word), "{said}");
        }
        assert_eq!(Limit::Frames.value(), 10_000_000);
    }
}
