//! Digital wires of the central processor over a sweep.

use signal::{Kind, Signal, Unit};

use crate::digital::DigitalFrame;
use crate::stage::MachineStage;
use crate::stretches::SweepTicks;
use crate::ticks::start_of;
use crate::waveforms::Changes;

/// Wires of the central processor.
pub(crate) const PROCESSOR_WIRES: &[Signal] = &[
    wire("cpu.set_up", "sweep of this frame whose set-up is in work, crossings apart; -1: none"),
    wire("cpu.drawn", "sweep whose set-up the sweep is drawn with: itself, or an earlier one"),
];

const fn wire(name: &'static str, meaning: &'static str) -> Signal {
    Signal::digital(name, Unit::Number, Kind::Bus, meaning, "fig. 15")
}

/// What the wire of this name does in sweep number `number` of frame `frame`. Nothing where the processor takes no time.
pub(crate) fn processor_changes(
    name: &str,
    (stage, digital): (&MachineStage, &DigitalFrame),
    (frame, number): (u64, u32),
    sweep: &SweepTicks,
) -> Changes {
    let Some(cpu) = &digital.cpu else { return Changes::default() };
    if name == "cpu.drawn" {
        return Changes { times: vec![0.0], values: vec![f64::from(digital.drawn(number))] };
    }
    let [first, last] = [0, stage.settings.raster.sweeps - 1].map(|sweep| start_of(stage, frame, sweep).0);
    let begins = cpu.begun.iter().map(|&(of, since)| (of, first.saturating_add_signed(since)));
    // One that is not made stays in work until another takes its place: with the last sweep that is the next frame's first.
    let next = begins.clone().skip(1).map(|(_, tick)| tick).chain([last]);
    let made = |of: u32, until: u64| {
        let slack = cpu.set_ups.iter().find(|(made, _)| *made == of).map(|&(_, slack)| slack);
        slack.map_or(until, |slack| start_of(stage, frame, of).0.saturating_add_signed(-slack))
    };
    let work = begins.zip(next).map(|((of, begin), until)| (begin..made(of, until), f64::from(of)));
    sweep.held(work, -1.0)
}
