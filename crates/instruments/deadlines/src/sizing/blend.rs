//! Words of the stretch over which two levels blend: both generators are loaded there.

use machine::FrameSweeps;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use sweep_program::SweepProgram;

use super::report::{Row, row};
use crate::Rehearsal;
use crate::levels::{DrawnLevel, drawn_levels};
use crate::sets::{AskedSet, crossings, sets_of};

/// Words of a register set.
const SET: f64 = 9.0;
/// Words that a crossing asks for: four sets.
const CROSSING: f64 = 4.0 * SET;

/// What the sweeps of some frames load where both levels are shown, and what the formulas say.
pub struct BlendFigures {
    /// Where the levels are both shown at most (m).
    stretch: [f64; 2],
    /// Side of a region of the fine and of the coarse level (m).
    region_sizes: [f64; 2],
    /// Means of the sweeps of all frames.
    mean: SweepLoads,
    /// Number of sweeps a frame.
    sweeps: f64,
}

/// What one sweep loads; sums and means of them have the same form.
#[derive(Debug, Clone, Copy, Default)]
struct SweepLoads {
    /// Folds inside the blend, fine level and coarse level.
    crossings: [f64; 2],
    /// The same by formula, at the azimuth of the sweep.
    at_azimuth: [f64; 2],
    /// Words asked for inside the blend, fine level and coarse level.
    inside: [f64; 2],
    /// Words of the coarse level asked for nearer than the blend.
    nearer: f64,
    /// The crossings of these by formula.
    nearer_at_azimuth: f64,
}

impl BlendFigures {
    /// Runs all sweeps of the frames, by all threads of the current pool; `None` if the scenario has no blend.
    pub fn measure(rehearsal: &Rehearsal, frames: &[FrameSweeps<'_>]) -> Option<Self> {
        let levels = drawn_levels(&rehearsal.stage);
        let settings = &rehearsal.stage.settings;
        let switch = settings.levels.filter(|switch| switch.blend > 0.0)?;
        let [fine, coarse] = levels.as_slice() else { return None };
        let sweeps = settings.raster.sweeps;
        let of_sweep = |index: u32| {
            let frame = &frames[(index / sweeps) as usize];
            let programs = frame.programs(index % sweeps);
            SweepLoads::of(frame, [fine, coarse], [&programs[0], &programs[1]], switch.blend)
        };
        let count = sweeps * frames.len() as u32;
        // Collected first: sums do not depend on the threads.
        let all: Vec<SweepLoads> = (0..count).into_par_iter().map(of_sweep).collect();
        Some(Self {
            stretch: [switch.range - switch.blend, switch.range],
            region_sizes: [fine, coarse].map(|level| level.level.region_size()),
            mean: SweepLoads::mean(&all),
            sweeps: f64::from(sweeps),
        })
    }

    /// Returns the title of the table.
    pub fn title(&self) -> String {
        let ([from, to], [fine, coarse]) = (self.stretch, self.region_sizes);
        format!("blend of both levels: {from:.0} to {to:.0} m, regions of {fine} m and of {coarse} m")
    }

    /// Returns the figures, measured and by formula.
    pub fn rows(&self) -> Vec<Row> {
        let Self { mean, sweeps, .. } = self;
        let crossings_of = |key: &str, meaning: &str, level: usize| {
            let (found, formula) = (mean.crossings[level], mean.at_azimuth[level]);
            row(key, meaning, found, formula, "B (|cos| + |sin|)/d")
        };
        let words = |key: &str, meaning: &str, found: f64, crossings: f64, law: &'static str| {
            row(key, meaning, sweeps * found, sweeps * CROSSING * crossings, law)
        };
        vec![
            crossings_of("blend_crossings_fine", "crossings a sweep, fine level", 0),
            crossings_of("blend_crossings_coarse", "  coarse level", 1),
            words(
                "blend_words_fine",
                "words loaded a frame, fine level",
                mean.inside[0],
                mean.at_azimuth[0],
                "36 n a sweep",
            ),
            words(
                "blend_words_coarse",
                "  coarse level: what a blend takes and a switch does not",
                mean.inside[1],
                mean.at_azimuth[1],
                "36 n a sweep",
            ),
            words(
                "blend_words_nearer",
                "  coarse level before the blend, where it is not shown",
                mean.nearer,
                mean.nearer_at_azimuth,
                "36 z1 (|cos| + |sin|)/d a sweep",
            ),
        ]
    }
}

impl SweepLoads {
    fn of(
        frame: &FrameSweeps<'_>,
        levels: [&DrawnLevel<'_>; 2],
        [fine, coarse]: [&SweepProgram; 2],
        blend: f64,
    ) -> Self {
        let end = fine.end_range;
        if coarse.end_range <= end {
            // The coarse ground ends first: the sweep stays on the fine one.
            return Self::default();
        }
        let begin = (end - blend).max(0.0);
        let wired = frame.loader().is_wired_through();
        let mut sets = Vec::new();
        let mut loads = Self::default();
        for (number, program) in [fine, coarse].into_iter().enumerate() {
            let [cos, sin] = program.start.direction;
            let a_metre = (cos.abs() + sin.abs()) / levels[number].level.region_size();
            let is_inside = |range: f64| (begin..end).contains(&range);
            loads.crossings[number] =
                crossings(program).filter(|(range, _)| is_inside(*range)).count() as f64;
            loads.at_azimuth[number] = (end - begin) * a_metre;
            sets_of(program, wired, &mut sets);
            let words =
                |is: &dyn Fn(&AskedSet) -> bool| SET * sets.iter().filter(|set| is(set)).count() as f64;
            loads.inside[number] = words(&|set| is_inside(set.asked.range));
            if number == 1 {
                loads.nearer = words(&|set| set.asked.range < begin);
                loads.nearer_at_azimuth = begin * a_metre;
            }
        }
        loads
    }

    fn mean(all: &[Self]) -> Self {
        let count = all.len().max(1) as f64;
        let mean = |value: fn(&Self) -> f64| all.iter().map(value).sum::<f64>() / count;
        Self {
            crossings: [mean(|sweep| sweep.crossings[0]), mean(|sweep| sweep.crossings[1])],
            at_azimuth: [mean(|sweep| sweep.at_azimuth[0]), mean(|sweep| sweep.at_azimuth[1])],
            inside: [mean(|sweep| sweep.inside[0]), mean(|sweep| sweep.inside[1])],
            nearer: mean(|sweep| sweep.nearer),
            nearer_at_azimuth: mean(|sweep| sweep.nearer_at_azimuth),
        }
    }
}
