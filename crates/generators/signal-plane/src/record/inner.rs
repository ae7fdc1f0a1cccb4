//! Wires that are worked out together, once a sweep: those inside the arrays, the words of their hold registers, the gates.

use std::borrow::Cow;
use std::collections::BTreeMap;

use control_plane::waveforms::{Changes, changes};
use landscape::{CornerWords, Level};
use mixing_unit::SwitchGates;
use signal::{Lanes, Probe, Real};
use sweep_program::SweepProgram;
use terrain_generator::{
    ArrayState, COARSE, FINE, InnerSignals, InnerWire, LIGHT, Logic, PartsArray, TerrainGenerator,
    held_words, light_wires,
};

use super::{Recorded, sampled};
use crate::signal_table::signals;

/// One level of the ground as a group has swept it.
struct Swept<'a, S> {
    signals: &'static InnerSignals,
    level: &'a Level,
    programs: &'a [SweepProgram; signal::LANES],
    /// Its array, where that is made of parts.
    array: Option<&'a PartsArray<S>>,
}

/// Such wires of one sweep by name.
pub(super) type Together = BTreeMap<&'static str, Changes>;

/// Gates of the switches, and how far these are open.
const GATES: [&str; 6] = ["fg.present", "sc.gate", "mu.vs1", "mu.vs2", "mu.vs1.fade", "mu.vs2.fade"];

impl<S: Real> Recorded<'_, S> {
    /// What `probe` wants of lane `lane`, which is sweep `sweep`, and is worked out together.
    pub(super) fn together(&self, probe: &Probe, lane: usize, sweep: u32) -> Together {
        let mut all = Together::new();
        for swept in self.swept() {
            all.extend(self.words(&swept, probe, lane));
            let wanted = swept.signals.wires.iter().filter(|(_, signal)| probe.wants(signal));
            let (wires, names): (Vec<InnerWire>, Vec<_>) =
                wanted.map(|(wire, signal)| (*wire, signal.name)).unzip();
            if !wires.is_empty() {
                let values = self.inside(&swept, lane, sweep, &wires).into_iter().map(sampled);
                all.extend(names.into_iter().zip(values));
            }
        }
        if signals().iter().any(|signal| GATES.contains(&signal.name) && probe.wants(signal)) {
            all.extend(GATES.into_iter().zip(self.gates(lane).map(sampled)));
        }
        if LIGHT.iter().any(|signal| probe.wants(signal)) {
            let wires = self.light(lane, sweep).into_iter().map(sampled);
            all.extend(LIGHT.iter().map(|signal| signal.name).zip(wires));
        }
        all.extend(self.sub_generators(probe, lane, sweep));
        all
    }

    /// Values of [`GATES`], behind their comparators where these are parts.
    fn gates(&self, lane: usize) -> [Vec<f64>; 6] {
        let (group, features) = (self.group, &self.work.feature_profile);
        let found = self.mixed(|inputs| match &group.parts.mixer {
            Some(mixer) => mixer.gates(&inputs, lane),
            None => {
                let gates = [inputs.vs1_gate(&group.mixing_unit().vs1, lane), inputs.vs2_gate(lane)];
                let present =
                    if group.blocks.features { of_lane(&features.present, lane) } else { Vec::new() };
                SwitchGates { present, fades: gates.clone(), gates }
            }
        });
        let SwitchGates { present, gates: [vs1, vs2], fades: [fade1, fade2] } = found;
        [present, vs2.clone(), vs1, vs2, fade1, fade2]
    }

    /// Wires of the stage that makes light of slopes, in the order of [`LIGHT`].
    fn light(&self, lane: usize, sweep: u32) -> [Vec<f64>; LIGHT.len()] {
        let Self { group, work, .. } = self;
        let sweeps = group.sweeps(sweep - lane as u32);
        let directions = group.directions(&sweeps);
        match group.parts.light() {
            None => light_wires(group.plan.sun.direction(), directions[lane], &work.profile, lane),
            Some(stage) => {
                let (light, ends) = (group.light(&sweeps), group.ends(work));
                stage.wires(&group.lit_group(&light, &directions, &ends), &work.profile, lane)
            }
        }
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

    /// Words of the hold registers of lane `lane` that `probe` wants.
    fn words(&self, swept: &Swept<'_, S>, probe: &Probe, lane: usize) -> Together {
        let words = swept.signals.words.iter().enumerate();
        let wanted: Vec<_> = words.filter(|(_, signal)| probe.wants(signal)).collect();
        if wanted.is_empty() {
            return Together::new();
        }
        let as_held = |words: &CornerWords| swept.array.map_or(*words, |array| array.as_held(words));
        let program = self.on_wires(swept, Logic::Registers, lane);
        let held: Vec<_> = held_words(&program, swept.level.words())
            .into_iter()
            .map(|(time, words)| (time, words.each_ref().map(as_held)))
            .collect();
        let of = |number: usize| {
            let mut changes = Changes::default();
            held.iter().for_each(|(time, words)| changes.becomes(*time, words[number / 9][number % 9]));
            changes
        };
        wanted.into_iter().map(|(number, signal)| (signal.name, of(number))).collect()
    }

    /// What a digital wire of the terrain path, of the coarse level or of the fine one, did in lane `lane`; nothing if there is no such
    /// level.
    pub(super) fn logic(&self, name: &str, lane: usize) -> Changes {
        let level = usize::from(name.contains(".coarse."));
        let swept = self.swept();
        if name.ends_with(".late") {
            // Told on the clock of the digital side, as in the trace: a fold is where the beam meets it.
            return swept
                .get(level)
                .map_or_else(Changes::default, |swept| changes(name, &swept.programs[lane]));
        }
        let logic = match name {
            _ if name.contains(".fold.") => Logic::Stops,
            _ if name.contains(".polarity.") => Logic::Polarity,
            _ => Logic::Registers,
        };
        swept
            .get(level)
            .map_or_else(Changes::default, |swept| changes(name, &self.on_wires(swept, logic, lane)))
    }

    /// The program of a level and lane, with the instants of these wires.
    fn on_wires<'p>(&self, swept: &Swept<'p, S>, logic: Logic, lane: usize) -> Cow<'p, SweepProgram> {
        let program = &swept.programs[lane];
        swept.array.map_or(Cow::Borrowed(program), |array| {
            Cow::Owned(array.on_wires(logic, &self.group.terrain(swept.level), program))
        })
    }
}

/// One lane of a wire.
pub(super) fn of_lane<S: Real>(values: &[Lanes<S>], lane: usize) -> Vec<f64> {
    values.iter().map(|value| value[lane].to_f64()).collect()
}
