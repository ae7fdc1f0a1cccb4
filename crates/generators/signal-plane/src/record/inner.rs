//! Wires inside the arrays, and the words of their hold registers.

use std::collections::BTreeMap;

use control_plane::waveforms::Changes;
use landscape::Level;
use signal::{Lanes, Probe, Real};
use sweep_program::SweepProgram;
use terrain_generator::{
    ArrayState, COARSE, FINE, InnerSignals, InnerWire, PartsArray, TerrainGenerator, held_words,
};

use super::Recorded;

/// One level of the ground as a group has swept it.
struct Swept<'a, S> {
    signals: &'static InnerSignals,
    level: &'a Level,
    programs: &'a [SweepProgram; signal::LANES],
    /// Its array, where that is made of parts.
    array: Option<&'a PartsArray<S>>,
}

/// Inner wires of one sweep by name, one value a sample.
pub(super) type InnerValues = BTreeMap<&'static str, Vec<f64>>;

impl<S: Real> Recorded<'_, S> {
    /// All that `probe` wants of the inner wires of lane `lane`, which is sweep `sweep`.
    pub(super) fn inner(&self, probe: &Probe, lane: usize, sweep: u32) -> InnerValues {
        let mut all = InnerValues::new();
        for swept in self.swept() {
            let wanted = swept.signals.wires.iter().filter(|(_, signal)| probe.wants(signal));
            let (wires, names): (Vec<InnerWire>, Vec<_>) =
                wanted.map(|(wire, signal)| (*wire, signal.name)).unzip();
            if !wires.is_empty() {
                all.extend(names.into_iter().zip(self.inside(&swept, lane, sweep, &wires)));
            }
        }
        all
    }

    /// The levels that the machine has.
    fn swept(&self) -> Vec<Swept<'_, S>> {
        let Self { group, work, .. } = self;
        let terrain = group.parts.terrain.as_ref();
        let mut levels = vec![Swept {
            signals: &FINE,
            level: group.stage.landscape.level(),
            programs: &work.programs,
            array: terrain.map(|terrain| &terrain.fine),
        }];
        let coarse = group.stage.landscape.bank().levels().get(1).filter(|_| group.blocks.coarse.is_some());
        levels.extend(coarse.map(|level| Swept {
            signals: &COARSE,
            level,
            programs: &work.coarse,
            array: terrain.and_then(|terrain| terrain.coarse.as_ref()),
        }));
        levels
    }

    fn inside(&self, swept: &Swept<'_, S>, lane: usize, sweep: u32, wires: &[InnerWire]) -> Vec<Vec<f64>> {
        let generator: TerrainGenerator<'_> = self.group.terrain(swept.level);
        match swept.array {
            None => generator.inside::<S>(swept.programs, lane, wires),
            Some(array) => {
                let (first, mut state) = (sweep - lane as u32, ArrayState::default());
                let mut parts = self.group.parts_terrain(array, first, &mut state);
                parts.inside(&generator, swept.programs, lane, wires)
            }
        }
    }

    /// What the word called `name` of a hold register is, if it is one.
    pub(super) fn word(&self, name: &str, lane: usize) -> Option<Changes> {
        let known = |swept: Swept<'_, S>| {
            let (colour, word) = swept.signals.find_word(name)?;
            let mut changes = Changes::default();
            for (time, words) in held_words(&swept.programs[lane], swept.level.words()) {
                let words = &words[colour as usize];
                let held = swept.array.map_or(*words, |array| array.as_held(words));
                changes.becomes(time, held[word]);
            }
            Some(changes)
        };
        self.swept().into_iter().find_map(known)
    }
}

/// One lane of a wire.
pub(super) fn of_lane<S: Real>(values: &[Lanes<S>], lane: usize) -> Vec<f64> {
    values.iter().map(|value| value[lane].to_f64()).collect()
}
