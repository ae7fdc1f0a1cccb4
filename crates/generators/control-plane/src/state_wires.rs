//! What the units of the digital side are at over a sweep: processor, service of the crossings, drums, channels, I/O processors of the
//! banks, storage buffers. Whoever does not ask pays nothing: a wire is worked out when it is looked at.

use std::sync::LazyLock;

use signal::Signal;

use crate::bank_waveforms::{BANK_WIRES, bank_changes, channel_of, kind_of};
use crate::banks::{channel_count, drum_count};
use crate::blocks::Blocks;
use crate::crossings::Crossings;
use crate::demand::has_bank;
use crate::digital::{DigitalFrame, processor_takes_time};
use crate::drum_waveforms::{DRUM_WIRES, drum_changes, drum_of};
use crate::loader_waveforms::{LOADER_WIRES, loader_changes};
use crate::processor_waveforms::{PROCESSOR_WIRES, processor_changes};
use crate::stage::MachineStage;
use crate::stretches::SweepTicks;
use crate::waveforms::Changes;

/// Wires of all units of the digital side that are states of a frame, unit by unit.
pub static STATE_WIRES: LazyLock<Vec<Signal>> =
    LazyLock::new(|| [PROCESSOR_WIRES, &LOADER_WIRES, &DRUM_WIRES, &BANK_WIRES].concat());

/// First words of the names of those wires.
const UNITS: [&str; 6] = ["cpu", "loader", "drum", "channel", "editor", "buffer"];

/// Whether a signal is the state of a unit of the digital side.
pub fn is_state(signal: &Signal) -> bool {
    UNITS.contains(&signal.prefix())
}

/// Whether the machine of `stage` has the unit of such a signal.
pub fn has_state(signal: &Signal, stage: &MachineStage, blocks: &Blocks) -> bool {
    let name = signal.name;
    match signal.prefix() {
        "cpu" => processor_takes_time(&stage.settings),
        "loader" => blocks.coarse.is_some() || !name.contains(".coarse."),
        "drum" => drum_of(name).is_some_and(|(drum, _)| drum < drum_count(stage, blocks)),
        "channel" => channel_of(name).is_some_and(|channel| channel < channel_count(stage, blocks)),
        _ => {
            let has_drums = stage.settings.data_banks.drum.is_some();
            has_drums && kind_of(name).is_some_and(|kind| has_bank(stage, blocks, kind))
        }
    }
}

/// What the wire of such a signal does in sweep `sweep`, retrace included.
pub fn state_changes(
    signal: &Signal,
    crossings: &Crossings<'_>,
    digital: &DigitalFrame,
    sweep: u32,
) -> Changes {
    let (stage, frame, name) = (crossings.stage, crossings.plan.frame, signal.name);
    let ticks = SweepTicks::new(stage, frame, sweep);
    match signal.prefix() {
        "cpu" => processor_changes(name, (stage, digital), (frame, sweep), &ticks),
        "loader" => loader_changes(name, crossings, [digital.drawn(sweep), sweep], &ticks),
        "drum" => drum_changes(name, digital, &ticks),
        _ => bank_changes(name, digital, &ticks),
    }
}
