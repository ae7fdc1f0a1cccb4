//! Digital wires of the drums over a sweep: what a drum does goes on from frame to frame, and a sweep sees a piece of it.

use std::ops::Range;
use std::sync::LazyLock;

use data_bank::{DrumUnit, FrameSupply, Missing};
use quantities::{SweepClock, SweepTime, Tick};
use signal::{Kind, Signal, Unit};

use crate::digital::DigitalFrame;
use crate::waveforms::Changes;

/// Drums whose wires can be told: those of the fine level first, then those of the coarse one.
const DRUMS: usize = 16;

/// Wires of each drum.
const WIRES: [(&str, Unit, Kind, &str); 3] = [
    (
        "index",
        Unit::Number,
        Kind::Event,
        "the origin of the drum passes the heads: revolutions since the mission began",
    ),
    (
        "record",
        Unit::Corner,
        Kind::Event,
        "a record that the frame asks for is in the buffer: its first corner; a square of corners has one event",
    ),
    (
        "waiting",
        Unit::Number,
        Kind::Bus,
        "corners that the frame asks for, which this drum has and has not brought yet",
    ),
];

/// Wires of all drums, drum by drum.
pub static DRUM_WIRES: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    let of_drum = |drum: usize| {
        WIRES.map(|(wire, unit, kind, meaning)| {
            // Names of wires live as long as the program: the table is made once.
            let name = format!("drum.{drum}.{wire}").leak();
            Signal::digital(name, unit, kind, meaning, "fig. 15")
        })
    };
    (0..DRUMS).flat_map(of_drum).collect()
});

/// Number of the drum that a wire is of, and what it tells; none of another wire.
pub fn drum_of(name: &str) -> Option<(usize, &str)> {
    let (drum, wire) = name.strip_prefix("drum.")?.split_once('.')?;
    Some((drum.parse().ok()?, wire))
}

/// What the wire of this name does in a sweep of `samples` samples, retrace included, that sees the master clock as `clock` says.
/// Nothing where the drum is not there.
pub fn drum_changes(name: &str, digital: &DigitalFrame, clock: &SweepClock, samples: u32) -> Changes {
    let mut changes = Changes::default();
    let of = drum_of(name).and_then(|(drum, wire)| Some((OneDrum::find(digital, drum)?, wire)));
    let Some((drum, wire)) = of else { return changes };
    let ticks = ticks_of(clock, samples);
    let at = |tick: u64| clock.instant_of(Tick(tick)).0;
    match wire {
        "index" => drum.turns(ticks).for_each(|(tick, turn)| changes.push(at(tick), turn)),
        "record" => drum.records(ticks).into_iter().for_each(|(tick, corner)| changes.push(at(tick), corner)),
        _ => {
            changes.becomes(0.0, drum.waiting(ticks.start));
            for (tick, _) in drum.records(ticks.start + 1..ticks.end) {
                changes.becomes(at(tick), drum.waiting(tick));
            }
        }
    }
    changes
}

/// Ticks from the start of a sweep to that of the next.
fn ticks_of(clock: &SweepClock, samples: u32) -> Range<u64> {
    let [start, end] = [0.0, f64::from(samples)].map(|time| clock.tick_at_or_after(SweepTime(time)).0);
    start..end
}

/// A drum, and what its level is brought in the frame.
struct OneDrum<'a> {
    unit: &'a DrumUnit,
    supply: &'a FrameSupply,
    /// Its number on its level.
    number: u32,
}

impl<'a> OneDrum<'a> {
    fn find(digital: &'a DigitalFrame, drum: usize) -> Option<Self> {
        let mut number = drum;
        for (drums, supply) in digital.drums.iter().zip(&digital.supplies) {
            if let (Some(unit), Some(supply)) = (drums.get(number), supply) {
                return Some(Self { unit, supply, number: number as u32 });
            }
            number = number.checked_sub(drums.len())?;
        }
        None
    }

    fn missing(&self) -> impl Iterator<Item = &'a Missing> {
        let number = self.number;
        self.supply.missing.iter().filter(move |missing| missing.drum == number)
    }

    /// When its origin passes the heads, and how often it has since tick 0.
    fn turns(&self, ticks: Range<u64>) -> impl Iterator<Item = (u64, f64)> {
        let DrumUnit { rotation, start_angle, .. } = *self.unit;
        let first = (ticks.start + start_angle).div_ceil(rotation);
        (first..)
            .map(move |turn| ((turn * rotation).wrapping_sub(start_angle), turn as f64))
            .take_while(move |(tick, _)| *tick < ticks.end)
    }

    /// Records that come within these ticks: when, and the first of their corners.
    fn records(&self, ticks: Range<u64>) -> Vec<(u64, f64)> {
        let arrived =
            self.missing().filter_map(|missing| Some((missing.arrival?.0, f64::from(missing.corner))));
        let mut records: Vec<(u64, f64)> = arrived.filter(|(tick, _)| ticks.contains(tick)).collect();
        records.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        records.dedup_by_key(|(tick, _)| *tick);
        records
    }

    /// Corners that are not in the buffer as `tick` has passed.
    fn waiting(&self, tick: u64) -> f64 {
        self.missing().filter(|missing| missing.arrival.is_none_or(|arrival| arrival.0 > tick)).count() as f64
    }
}
