//! Digital wires of the drums over a sweep: what a drum does goes on from frame to frame, and a sweep sees a piece of it.

use std::ops::Range;
use std::sync::LazyLock;

use data_bank::{DrumSpell, DrumUnit, FrameSupply, Missing};
use signal::{Kind, Signal, Unit};

use crate::banks::Supplied;
use crate::data_kind::DataKind;
use crate::digital::DigitalFrame;
use crate::stretches::SweepTicks;
use crate::waveforms::Changes;

/// Drums whose wires can be told: those of fine terrain first, then those of each other kind that has its own.
pub(crate) const DRUMS: usize = 20;

/// Wires of each drum.
const WIRES: [(&str, Unit, Kind, &str); 6] = [
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
        "a record that the frame asks for is in the buffer: its first corner, or its square of other kinds of data",
    ),
    (
        "kind",
        Unit::Number,
        Kind::Event,
        "what that record holds: 0 fine terrain, 1 coarse terrain, 2 features, 3 shadow boundaries, 4 polyhedra",
    ),
    (
        "waiting",
        Unit::Number,
        Kind::Bus,
        "corners and squares that the frame asks for, which this drum has and has not brought yet",
    ),
    ("heads", Unit::Number, Kind::Bus, "what the drum is at: 0 idle, 1 turning to a record, 2 reading it"),
    (
        "reads",
        Unit::Number,
        Kind::Bus,
        "number of the record in its store that the drum turns to or reads; -1: none",
    ),
];

/// Wires of all drums, drum by drum.
pub(crate) static DRUM_WIRES: LazyLock<Vec<Signal>> = LazyLock::new(|| {
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
pub(crate) fn drum_of(name: &str) -> Option<(usize, &str)> {
    let (drum, wire) = name.strip_prefix("drum.")?.split_once('.')?;
    Some((drum.parse().ok()?, wire))
}

/// What the wire of this name does in a sweep. Nothing where the drum is not there.
pub(crate) fn drum_changes(name: &str, digital: &DigitalFrame, sweep: &SweepTicks) -> Changes {
    let mut changes = Changes::default();
    let of = drum_of(name).and_then(|(drum, wire)| Some((OneDrum::find(digital, drum)?, wire)));
    let Some((drum, wire)) = of else { return changes };
    let ticks = sweep.ticks.clone();
    let at = |tick: u64| sweep.at(tick);
    match wire {
        "heads" => return sweep.held(drum.heads(), 0.0),
        "reads" => return sweep.held(drum.reads(), -1.0),
        "index" => drum.turns(ticks).for_each(|(tick, turn)| changes.push(at(tick), turn)),
        "record" => {
            drum.records(ticks).into_iter().for_each(|(tick, _, piece)| changes.push(at(tick), piece))
        }
        "kind" => drum
            .records(ticks)
            .into_iter()
            .for_each(|(tick, kind, _)| changes.push(at(tick), kind as u8 as f64)),
        _ => {
            changes.becomes(0.0, drum.waiting(ticks.start));
            for (tick, ..) in drum.records(ticks.start + 1..ticks.end) {
                changes.becomes(at(tick), drum.waiting(tick));
            }
        }
    }
    changes
}

/// One of the drums or channels of a bank.
pub(crate) struct BankShare<'a> {
    /// Its number among those of its bank.
    pub number: usize,
    /// Drums of the banks before.
    pub drums_before: usize,
    /// The bank, by the kind after which it is called.
    pub bank: &'a Supplied,
    /// What each kind on the bank's drums gets.
    pub supplies: Vec<(DataKind, &'a FrameSupply)>,
}

impl<'a> BankShare<'a> {
    /// Number `number` over all banks, of which each has as many as `count` says.
    pub(crate) fn find(
        digital: &'a DigitalFrame,
        number: usize,
        count: impl Fn(&Supplied) -> usize,
    ) -> Option<Self> {
        let (mut number, mut drums_before) = (number, 0);
        for bank in digital.supplies.iter().filter(|supplied| supplied.names_drums()) {
            if number < count(bank) {
                let of_bank = digital.supplies.iter().filter(|supplied| supplied.drums == bank.kind);
                let supplies = of_bank.map(|supplied| (supplied.kind, supplied.supply())).collect();
                return Some(Self { number, drums_before, bank, supplies });
            }
            number -= count(bank);
            drums_before += bank.units.len();
        }
        None
    }
}

/// A drum, and what it brings in the frame.
struct OneDrum<'a> {
    unit: DrumUnit,
    /// What each kind on the drum gets.
    supplies: Vec<(DataKind, &'a FrameSupply)>,
    /// Its number among the drums of its bank.
    number: u32,
}

/// A record that comes: when, its kind, and its first piece.
type Coming = (u64, DataKind, f64);

impl<'a> OneDrum<'a> {
    fn find(digital: &'a DigitalFrame, drum: usize) -> Option<Self> {
        let BankShare { number, bank, supplies, .. } =
            BankShare::find(digital, drum, |supplied| supplied.units.len())?;
        Some(Self { unit: bank.units[number], supplies, number: number as u32 })
    }

    /// Its spells at records of all kinds, in order of time.
    fn spells(&self) -> Vec<DrumSpell> {
        let all = self.supplies.iter().flat_map(|(_, supply)| &supply.spells);
        let mut own: Vec<DrumSpell> = all.filter(|spell| spell.drum == self.number).copied().collect();
        own.sort_by_key(|spell| spell.begun);
        own
    }

    /// When it turns to a record (1) and reads it (2).
    fn heads(&self) -> impl Iterator<Item = (Range<u64>, f64)> {
        let spells = self.spells().into_iter();
        spells.flat_map(|spell| [(spell.begun..spell.under, 1.0), (spell.under..spell.until, 2.0)])
    }

    /// Which record it turns to or reads.
    fn reads(&self) -> impl Iterator<Item = (Range<u64>, f64)> {
        self.spells().into_iter().map(|spell| (spell.begun..spell.until, f64::from(spell.record)))
    }

    fn missing(&self) -> impl Iterator<Item = (DataKind, &'a Missing)> {
        let number = self.number;
        let of_kind = self
            .supplies
            .iter()
            .flat_map(|&(kind, supply)| supply.missing.iter().map(move |missing| (kind, missing)));
        of_kind.filter(move |(_, missing)| missing.drum == number)
    }

    /// When its origin passes the heads, and how often it has since tick 0.
    fn turns(&self, ticks: Range<u64>) -> impl Iterator<Item = (u64, f64)> {
        let DrumUnit { rotation, start_angle, .. } = self.unit;
        let first = (ticks.start + start_angle).div_ceil(rotation);
        (first..)
            .map(move |turn| ((turn * rotation).wrapping_sub(start_angle), turn as f64))
            .take_while(move |(tick, _)| *tick < ticks.end)
    }

    /// Records that come within these ticks, in order of time.
    fn records(&self, ticks: Range<u64>) -> Vec<Coming> {
        let arrived = self
            .missing()
            .filter_map(|(kind, missing)| Some((missing.arrival?.0, kind, f64::from(missing.item))));
        let mut records: Vec<Coming> = arrived.filter(|(tick, ..)| ticks.contains(tick)).collect();
        records.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        records.dedup_by_key(|(tick, kind, _)| (*tick, *kind));
        records
    }

    /// Pieces that are not in the buffer as `tick` has passed.
    fn waiting(&self, tick: u64) -> f64 {
        let waits = |missing: &Missing| missing.arrival.is_none_or(|arrival| arrival.0 > tick);
        self.missing().filter(|(_, missing)| waits(missing)).count() as f64
    }
}
