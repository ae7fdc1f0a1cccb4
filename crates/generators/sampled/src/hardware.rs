//! What the generator runs on, as `hardware-models/programs/sampled.toml` has it: clock and ticks, memories, beam.

use diagnostics::{ProblemList, Reader, TomlFile};
use light_points::BeamBudget;
use scene_sampler::Reading;
use serde_json::{Value, json};

/// The file as the program carries it.
pub(crate) const SHIPPED: &str = include_str!("../../../../hardware-models/programs/sampled.toml");

/// Nanoseconds in a microsecond.
const MICROSECOND: f64 = 1e3;

/// Most ticks of a piece of work. Chosen: sums over a frame then fit 64 bits with room.
const MOST_TICKS: u32 = 1_000_000;

/// Clock, memories and beam of the generator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Hardware {
    /// Ticks of the sampler in a second, 1000 to 10^12.
    pub sampler_hz: u64,
    /// Ticks for a feature that is transformed and held against the view.
    pub feature_ticks: u64,
    /// Ticks for a corner that clipping left.
    pub corner_ticks: u64,
    /// Least ticks of a sub-area in the sampler.
    pub least_ticks: u64,
    /// Ticks of an insertion into a stack, at least 1. The tick of the entry is one of these.
    pub insert_ticks: u64,
    /// Pixels that are written in a tick, at least 1.
    pub pixels_tick: u64,
    /// Limits of its memories.
    pub memory: Memory,
    /// Time that its beam takes for a calligraphic point.
    pub beam: BeamBudget,
}

/// Places of the memories of a frame; `None` is without limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Memory {
    /// Entries of all lists together.
    pub list_entries: Option<u32>,
    /// Entries of the list of one sub-area.
    pub list_depth: Option<u32>,
    /// Light points of the light point store.
    pub points: Option<u32>,
}

impl Hardware {
    /// The figures of the file that ships.
    ///
    /// # Errors
    /// Every fault of it: a program that carries a faulty one.
    pub fn shipped() -> Result<Self, ProblemList> {
        TomlFile::read_text("built-in programs/sampled.toml", SHIPPED, Self::read)
    }

    /// Ticks of the sampler for the list of a sub-area.
    pub(crate) fn list_ticks(&self, reading: &Reading) -> u64 {
        reading.entries().max(self.least_ticks)
    }

    /// Ticks for which the slowest sampling point of a sub-area holds the sampler up, beyond one an entry.
    pub(crate) fn stack_ticks(&self, reading: &Reading) -> u64 {
        u64::from(reading.depth) * (self.insert_ticks - 1)
    }

    /// Ticks of a sub-area from its first entry to its last calligraphic point.
    pub(crate) fn ticks(&self, reading: &Reading) -> u64 {
        self.list_ticks(reading) + self.stack_ticks(reading) + u64::from(reading.calligraphic)
    }

    /// Ticks in which the pixels of a sub-area are written.
    pub(crate) fn pixel_ticks(&self, reading: &Reading) -> u64 {
        u64::from(reading.pixels).div_ceil(self.pixels_tick)
    }

    /// What decides when a sub-area is read out, for the record of a run whose pictures depend on it.
    pub(crate) fn sampler_record(&self) -> Value {
        json!({
            "sampler_hz": self.sampler_hz,
            "least_ticks": self.least_ticks,
            "insert_ticks": self.insert_ticks,
            "pixels_tick": self.pixels_tick,
        })
    }

    /// The figures of the tables `sampler`, `memory` and `beam`; every key is needed.
    pub(crate) fn read(root: &Reader) -> Option<Self> {
        let [sampler, memory, beam] = ["sampler", "memory", "beam"].map(|name| root.table_or_empty(name));
        let whole = |hertz: &f64| hertz.fract() == 0.0;
        let clock = sampler.f64("sampler_hz").between(1e3, 1e12).unit("Hz").must("a whole number", whole);
        let sampler_hz = clock.required();
        let ticks = |key: &str, least: u32| {
            sampler.u32(key).between(least, MOST_TICKS).unit("ticks").required().map(u64::from)
        };
        let [feature, corner, shortest] =
            ["feature_ticks", "corner_ticks", "least_ticks"].map(|key| ticks(key, 0));
        let insert = ticks("insert_ticks", 1);
        let pixels = sampler.u32("pixels_tick").between(1, MOST_TICKS).unit("pixels").required();
        let limits = ["list_entries", "list_depth", "points"].map(|key| limit(&memory, key));
        let times = ["jump_us", "dwell_us"].map(|key| {
            let time = beam.f64(key).between(0.0, 1e6).unit("µs").required();
            time.map(|time| (time * MICROSECOND).round() as u64)
        });
        let [list_entries, list_depth, points] = limits;
        let [jump, dwell] = times;
        Some(Self {
            sampler_hz: sampler_hz? as u64,
            feature_ticks: feature?,
            corner_ticks: corner?,
            least_ticks: shortest?,
            insert_ticks: insert?,
            pixels_tick: u64::from(pixels?),
            memory: Memory { list_entries: list_entries?, list_depth: list_depth?, points: points? },
            beam: BeamBudget { jump_ns: jump?, dwell_ns: dwell? },
        })
    }
}

/// Places of a memory; 0 is without limit.
fn limit(memory: &Reader, key: &str) -> Option<Option<u32>> {
    let places = memory.u32(key).help("0 is without limit").required()?;
    Some((places > 0).then_some(places))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_file_is_without_limits() {
        let hardware = Hardware::shipped().unwrap();
        assert_eq!((hardware.sampler_hz, hardware.memory), (40_000_000, Memory::default()));
        assert_eq!(hardware.beam, BeamBudget { jump_ns: 4000, dwell_ns: 6000 });
    }

    /// As in every file of `hardware-models/`.
    #[test]
    fn every_value_says_where_it_comes_from() {
        let values: Vec<&str> =
            SHIPPED.lines().filter(|line| line.contains(" = ") && !line.starts_with('#')).collect();
        assert_eq!(values.len(), 11);
        for line in values {
            let (_, comment) = line.split_once(" # ").unwrap_or_default();
            assert!(["unsourced", "chosen"].iter().any(|status| comment.starts_with(status)), "{line}");
        }
    }

    #[test]
    fn values_out_of_range_are_refused_by_name() {
        for (written, wrong) in [
            ("sampler_hz = 40e6", "sampler_hz = 40000000.5"),
            ("insert_ticks = 1", "insert_ticks = 0"),
            ("list_depth = 0", "list_depth = -1"),
            ("jump_us = 4", "jump_us = -4"),
        ] {
            let text = SHIPPED.replace(written, wrong);
            let told = TomlFile::read_text("a file", &text, Hardware::read).unwrap_err().to_string();
            assert!(told.contains(wrong.split(' ').next().unwrap()), "{told}");
        }
    }
}
