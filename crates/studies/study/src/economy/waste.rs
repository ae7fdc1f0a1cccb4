//! What is computed and touches nothing, counted over the sweeps of whole frames.

use control_plane::{ControlPlane, FrameSweeps};
use generator::{Planes, Session};
use landscape::Landscape;
use serde::Serialize;
use signal::{LANES, Probe, Waveform};
use sweep_program::{Colour, Event, PreloadRegister, SweepProgram, Target, WordMask};

use super::sample::{Fate, SweepSignals};
use crate::{StudyError, Subject};

const SIGNALS: [&str; 6] = ["sweep.range", "dpp.y", "dpp.blank", "pg.present", "fg.present", "sc.gate"];
/// A gate is open above this.
const OPEN: f64 = 0.5;

/// Work of one kind, and how much of it touched no pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Waste {
    /// Block that does it, by crate name.
    pub block: &'static str,
    /// What is of no use.
    pub what: &'static str,
    /// How much of it.
    pub wasted: u64,
    /// Amount of all work of this kind.
    pub of: u64,
    /// Why it is done all the same.
    pub why: &'static str,
}

impl Waste {
    /// Returns the wasted part (%); 0 where there is no work.
    pub fn percent(&self) -> f64 {
        if self.of == 0 { 0.0 } else { 100.0 * self.wasted as f64 / self.of as f64 }
    }
}

/// Some of a count.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Part {
    pub some: u64,
    pub all: u64,
}

impl Part {
    fn add(&mut self, is_some: bool) {
        self.some += u64::from(is_some);
        self.all += 1;
    }

    fn add_many(&mut self, some: usize, all: usize) {
        self.some += some as u64;
        self.all += all as u64;
    }
}

/// Counts over all frames.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct WasteCounts {
    /// Samples by fate: drawn, covered, outside, hidden, beyond.
    fates: [u64; 5],
    /// Samples of a crater that are not drawn.
    craters: Part,
    /// Samples without a crater.
    pub(super) without_crater: Part,
    /// Samples of texture that are not drawn.
    texture: Part,
    /// Samples beyond the reach of texture.
    pub(super) without_texture: Part,
    /// Edges of shadow that are not drawn.
    shadow: Part,
    /// Crossings of shadow boundaries that unite with others.
    united: Part,
    /// Loads of a register that no fold takes, and loads that are taken and replaced before a sample.
    untaken: Part,
    unseen: Part,
    /// Samples of a terrain level that a lane does not take.
    level: Part,
    /// Samples that a lane takes of one level only.
    pub(super) one_level: Part,
    /// Lanes without a sweep.
    lanes: Part,
}

/// Counts the waste of the frames of `subject`.
///
/// # Errors
/// If a frame cannot be drawn.
pub fn waste(subject: &Subject, session: &dyn Session) -> Result<WasteCounts, StudyError> {
    let stage = &subject.stage;
    let raster = stage.settings.raster;
    let control = ControlPlane::new(stage.clone());
    let mut counts = WasteCounts::default();
    for (frame, pose) in &subject.frames {
        let way = control.sweeps_with_gates(*frame, pose)?;
        let mut probe = Probe::new(SIGNALS.map(str::to_owned).into(), 0..raster.sweeps);
        let mut planes = Planes::new(raster.columns as usize, raster.lines as usize, &[]);
        session.frame(*frame, pose, &mut planes, &mut probe)?;
        let programs: Vec<Vec<SweepProgram>> = (0..raster.sweeps).map(|sweep| way.programs(sweep)).collect();
        for (waves, programs) in probe.waveforms.chunk_by(|a, b| a.sweep == b.sweep).zip(&programs) {
            counts.add_sweep(waves, programs, &way, &stage.landscape);
            programs.iter().for_each(|program| counts.add_loads(program));
        }
        counts.lanes.add_many(
            programs.len().next_multiple_of(LANES) - programs.len(),
            programs.len().next_multiple_of(LANES),
        );
        if let Some(switch) = stage.settings.levels.filter(|_| programs.iter().all(|levels| levels.len() > 1))
        {
            programs
                .chunks(LANES)
                .for_each(|group| counts.add_levels(group, way.table().ranges(), switch.blend));
        }
        let [edges, united] = way.shadow_edges();
        counts.united.add_many(united as usize, (edges + united) as usize);
    }
    Ok(counts)
}

impl WasteCounts {
    fn add_sweep(
        &mut self,
        waves: &[Waveform],
        programs: &[SweepProgram],
        way: &FrameSweeps<'_>,
        landscape: &Landscape,
    ) {
        let wave = |name: &str| {
            let found = waves.iter().find(|wave| wave.signal.name == name);
            found.map_or(&[][..], |wave| wave.values.as_slice())
        };
        let [range, line, blank, present, craters, shadow] = SIGNALS.map(wave);
        let end = programs.iter().map(|program| program.end_range).fold(0.0, f64::max);
        let fates = SweepSignals { range, line, blank, present }.fates(end, way.cells());
        let is_waste = |sample: usize| fates[sample] != Fate::Drawn;
        let reach = landscape.texture().map(|texture| texture.reach());
        for (sample, fate) in fates.iter().enumerate() {
            self.fates[*fate as usize] += 1;
            if !landscape.features().is_empty() {
                let has_crater = craters.get(sample).is_some_and(|present| *present > 0.0);
                self.without_crater.add(!has_crater);
                if has_crater {
                    self.craters.add(is_waste(sample));
                }
            }
            if let Some(reach) = reach {
                self.without_texture.add(range[sample] >= reach);
                if range[sample] < reach {
                    self.texture.add(is_waste(sample));
                }
            }
            let changes = |before: usize| (shadow[before] > OPEN) != (shadow[sample] > OPEN);
            if sample.checked_sub(1).is_some_and(|before| sample < shadow.len() && changes(before)) {
                self.shadow.add(is_waste(sample) && is_waste(sample - 1));
            }
        }
    }

    /// Follows the preload registers of a sweep. Words that wait since before its start are no loads of it.
    fn add_loads(&mut self, program: &SweepProgram) {
        let mut registers = Registers::default();
        let mut loads = 0;
        for step in program.events() {
            match step.kind {
                Event::Load(load) => {
                    registers.load(load.colour, load.target, load.words, step.sample);
                    loads += 1;
                }
                Event::Fold(fold) => {
                    let register = fold.axis.register();
                    let takes = |colour: &Colour| fold.axis.takes(fold.stop, *colour);
                    Colour::ALL.into_iter().filter(takes).for_each(|colour| {
                        registers.take(colour, register, step.sample);
                    });
                }
                Event::BareFold(_) => {}
            }
        }
        let (untaken, unseen) = registers.end();
        self.untaken.add_many(untaken, loads);
        self.unseen.add_many(unseen, loads);
    }

    /// Samples that the generators of two levels compute for a group (`ModifiedTerrainGenerator::run`).
    fn add_levels(&mut self, group: &[Vec<SweepProgram>], ranges: &[f64], blend: f64) {
        let samples = ranges.len();
        let switch = |levels: &Vec<SweepProgram>| {
            let [fine, coarse] = [0, 1].map(|level| levels[level].end_range);
            let range = if coarse <= fine { f64::INFINITY } else { fine };
            let before = |range: f64| ranges.partition_point(|z| *z <= range);
            [before(range - blend), before(range)]
        };
        let switches: Vec<[usize; 2]> = group.iter().map(switch).collect();
        let last_fine = switches.iter().map(|switch| switch[1]).max().unwrap_or(samples);
        let first_coarse = switches.iter().map(|switch| switch[0]).min().unwrap_or(samples);
        for [blended, beyond] in switches {
            let (computed, taken) = (last_fine + samples - first_coarse, beyond + samples - blended);
            self.level.add_many(computed - taken, computed);
            self.one_level.add_many(2 * samples - computed, 2 * samples);
        }
    }

    /// Samples by what becomes of them; their sum is all samples.
    fn samples(&self, fate: Fate) -> Part {
        Part { some: self.fates[fate as usize], all: self.fates.iter().sum() }
    }

    /// All that there is, in the order of the signal.
    pub fn rows(&self) -> Vec<Waste> {
        let row = |block, what, Part { some, all }, why| Waste { block, what, wasted: some, of: all, why };
        let rows = vec![
            row("machine", "lanes without a sweep", self.lanes, "eight sweeps run side by side"),
            row(
                "machine",
                "samples beyond the stored ground",
                self.samples(Fate::Beyond),
                "lanes of a group end where the last ends",
            ),
            row(
                "machine",
                "samples hidden by nearer ground",
                self.samples(Fate::Hidden),
                "that they are hidden is known behind the projection",
            ),
            row(
                "machine",
                "samples above or below the picture",
                self.samples(Fate::Outside),
                "lines are known behind the projection",
            ),
            row(
                "machine",
                "samples covered by bodies",
                self.samples(Fate::Covered),
                "bodies join behind the sweeps",
            ),
            row(
                "dpu",
                "loads that no fold takes",
                self.untaken,
                "words are fetched before the next stop is known",
            ),
            row("dpu", "loads replaced before a sample", self.unseen, "a sweep may cut a corner of a region"),
            row(
                "terrain-generator",
                "samples of a level that the lane does not take",
                self.level,
                "lanes of a group switch at different samples, and levels blend",
            ),
            row(
                "feature-generator",
                "samples of craters that are not drawn",
                self.craters,
                "sight is known behind the projection",
            ),
            row(
                "mixing-unit",
                "samples at which VS1 has no crater to choose",
                self.without_crater,
                "it follows the sweep clock",
            ),
            row(
                "shadow-controller",
                "crossings of boundaries that unite with others",
                self.united,
                "shadows of ground and bodies overlap",
            ),
            row(
                "shadow-controller",
                "edges of shadow that are not drawn",
                self.shadow,
                "sight is known behind the projection",
            ),
            row(
                "texture-generator",
                "samples of texture that are not drawn",
                self.texture,
                "sight is known behind the projection",
            ),
        ];
        rows.into_iter().filter(|row| row.of > 0).collect()
    }
}

/// Loads that wait in preload registers, and those in the hold registers that no sample has seen.
#[derive(Default)]
struct Registers {
    waiting: [[Vec<WordMask>; 2]; 4],
    /// Loads in hold, and the first sample that would see them.
    held: [(usize, usize); 4],
    untaken: usize,
    unseen: usize,
}

impl Registers {
    fn load(&mut self, colour: Colour, target: Target, words: WordMask, sample: usize) {
        match target {
            Target::Preload(register) => {
                let waiting = &mut self.waiting[colour as usize][register as usize];
                let before = waiting.len();
                waiting.retain(|held| !held.without(words).is_empty());
                self.untaken += before - waiting.len();
                waiting.push(words);
            }
            Target::Hold => {
                let (loads, since) = &mut self.held[colour as usize];
                (*loads, *since) = if *since == sample { (*loads + 1, sample) } else { (1, sample) };
            }
        }
    }

    fn take(&mut self, colour: Colour, register: PreloadRegister, sample: usize) {
        let waiting = &mut self.waiting[colour as usize][register as usize];
        let (loads, since) = self.held[colour as usize];
        if since == sample {
            self.unseen += loads;
        }
        self.held[colour as usize] = (waiting.len(), sample);
        waiting.clear();
    }

    /// Loads that were never taken, and those that were taken but never seen.
    fn end(self) -> (usize, usize) {
        let left: usize = self.waiting.iter().flatten().map(Vec::len).sum();
        (self.untaken + left, self.unseen)
    }
}
