//! Digital wires of channels, I/O processors of the banks, and storage buffers over a sweep.

use std::iter::repeat_n;
use std::ops::Range;
use std::sync::LazyLock;

use signal::{Kind, Signal, Unit};

use crate::data_kind::DataKind;
use crate::digital::DigitalFrame;
use crate::drum_waveforms::{BankShare, DRUMS};
use crate::stretches::SweepTicks;
use crate::waveforms::Changes;

/// Wires of channels, of the I/O processors that edit records, and of storage buffers.
pub(crate) static BANK_WIRES: LazyLock<Vec<Signal>> = LazyLock::new(|| {
    let wire = |name: String, meaning: &'static str| {
        // Names of wires live as long as the program: the table is made once.
        Signal::digital(name.leak(), Unit::Number, Kind::Bus, meaning, "fig. 15")
    };
    let channel = |number: usize| {
        wire(
            format!("channel.{number}.drum"),
            "number of the drum whose record this channel carries; -1: none",
        )
    };
    let editor = |kind: DataKind| {
        let meaning = "number of the record that the I/O processor of this kind of data edits; -1: none";
        wire(format!("editor.{}.record", kind.name()), meaning)
    };
    let buffer = |kind: DataKind| {
        let meaning =
            "corners or squares that the frame asks for and the storage buffer of this kind has not whole";
        wire(format!("buffer.{}.lacks", kind.name()), meaning)
    };
    let kinds = DataKind::ALL;
    (0..DRUMS).map(channel).chain(kinds.map(editor)).chain(kinds.map(buffer)).collect()
});

/// The number of the channel that a wire is of; none of another wire.
pub(crate) fn channel_of(name: &str) -> Option<usize> {
    name.strip_prefix("channel.")?.strip_suffix(".drum")?.parse().ok()
}

/// The kind of data that the wire of an I/O processor or of a storage buffer is of; none of another wire.
pub(crate) fn kind_of(name: &str) -> Option<DataKind> {
    let kind = name.strip_prefix("editor.").or_else(|| name.strip_prefix("buffer."))?.split('.').next()?;
    DataKind::ALL.into_iter().find(|known| known.name() == kind)
}

/// What the wire of this name does in a sweep. Nothing where the unit is not there.
pub(crate) fn bank_changes(name: &str, digital: &DigitalFrame, sweep: &SweepTicks) -> Changes {
    if let Some(channel) = channel_of(name) {
        return channel_changes(channel, digital, sweep).unwrap_or_default();
    }
    let Some(supplied) = kind_of(name).and_then(|kind| digital.supplied(kind)) else {
        return Changes::default();
    };
    let supply = supplied.supply();
    if name.starts_with("editor.") {
        let edits = supply.edits.iter().map(|edit| (edit.begun..edit.until, f64::from(edit.record)));
        return sweep.held(edits, -1.0);
    }
    let mut arrivals: Vec<u64> =
        supply.missing.iter().filter_map(|missing| Some(missing.arrival?.0)).collect();
    arrivals.sort_unstable();
    sweep.held(lacking(&arrivals, supply.missing.len()), 0.0)
}

/// How many pieces are lacking from each arrival to the next, of `all` that are lacking as the frame begins.
fn lacking(arrivals: &[u64], all: usize) -> impl Iterator<Item = (Range<u64>, f64)> {
    let begins = [0].into_iter().chain(arrivals.iter().copied());
    let ends = arrivals.iter().copied().chain(repeat_n(u64::MAX, 1));
    begins.zip(ends).enumerate().map(move |(came, (begin, end))| (begin..end, (all - came) as f64))
}

fn channel_changes(channel: usize, digital: &DigitalFrame, sweep: &SweepTicks) -> Option<Changes> {
    let share = BankShare::find(digital, channel, |supplied| supplied.supply().carried.len())?;
    let channels = share.supplies.first()?.1.carried.len();
    let all = share.supplies.iter().flat_map(|(_, supply)| &supply.spells);
    let own = all.filter(|spell| spell.drum as usize % channels == share.number);
    let mut carried: Vec<_> = own
        .map(|spell| (spell.under..spell.until, (share.drums_before + spell.drum as usize) as f64))
        .collect();
    carried.sort_by_key(|(ticks, _)| ticks.start);
    Some(sweep.held(carried, -1.0))
}

#[cfg(test)]
mod tests {
    use super::lacking;

    #[test]
    fn pieces_are_lacking_until_they_come() {
        let told: Vec<_> = lacking(&[10, 10, 30], 5).collect();
        assert_eq!(told, [(0..10, 5.0), (10..10, 4.0), (10..30, 3.0), (30..u64::MAX, 2.0)]);
        assert_eq!(lacking(&[], 0).collect::<Vec<_>>(), [(0..u64::MAX, 0.0)]);
    }
}
