//! What a control plane does in a frame, counted.

use control_plane::{ControlPlane, MachineStage};
use scenario::Pose;
use sweep_program::{Event, SweepProgram, Target};

/// Counts of a frame, both levels together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Stops that a ramp met.
    pub folds: u64,
    /// Sets of nine words that were asked for.
    pub wanted: u64,
    /// Sets that a bank began to fetch.
    pub served: u64,
    /// Sets that came to a register before the profile ended.
    pub loads: u64,
    /// Sets that came after the fold that needed them.
    pub late: u64,
    /// Sum of the corners of all sets that came.
    pub corners: u64,
    /// Sum of the corners that folds moved into hold registers.
    pub held: u64,
    /// Most sets that waited for one bank.
    pub longest: u64,
}

impl Work {
    /// What our control plane does in frame 0 of `stage`.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn ours(stage: &MachineStage, plane: &ControlPlane, pose: &Pose) -> Result<Self, String> {
        let sweeps = plane.sweeps(0, pose).map_err(|error| error.to_string())?;
        let settings = &stage.settings;
        let mut work = Self::default();
        for sweep in 0..settings.raster.sweeps {
            sweeps.programs(sweep).iter().for_each(|program| work.add(program));
        }
        let timing = plane.frame(0, pose).map_err(|error| error.to_string())?;
        work.wanted = timing.sets.wanted;
        let banks = || timing.units.iter().filter(|unit| unit.unit.starts_with("loader."));
        let a_set = settings.loader.pointer + settings.loader.access;
        work.served = banks().map(|bank| bank.busy).sum::<u64>() / a_set;
        work.longest = banks().map(|bank| u64::from(bank.longest_queue)).max().unwrap_or(0);
        Ok(work)
    }

    fn add(&mut self, program: &SweepProgram) {
        let mut waiting = program.registers.map(|set| [set.x_first, set.y_first]);
        self.late += program.misses.len() as u64;
        for step in program.events() {
            match step.kind {
                Event::Fold(fold) => {
                    self.folds += 1;
                    let register = fold.axis.register() as usize;
                    let taken = fold.colours().map(|colour| u64::from(waiting[colour as usize][register]));
                    self.held += taken.iter().sum::<u64>();
                }
                Event::BareFold(_) => self.folds += 1,
                Event::Load(load) => {
                    self.loads += 1;
                    self.corners += u64::from(load.corner);
                    if let Target::Preload(register) = load.target {
                        waiting[load.colour as usize][register as usize] = load.corner;
                    }
                }
            }
        }
    }

    /// The words of a line, in the order of the fields.
    pub(super) fn read(words: &[&str]) -> Option<Self> {
        let [folds, wanted, served, loads, late, corners, held, longest] = words else { return None };
        let number = |word: &str| word.parse().ok();
        Some(Self {
            folds: number(folds)?,
            wanted: number(wanted)?,
            served: number(served)?,
            loads: number(loads)?,
            late: number(late)?,
            corners: number(corners)?,
            held: number(held)?,
            longest: number(longest)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Work;

    #[test]
    fn a_line_of_counts_is_read_in_order() {
        let words = ["1", "2", "3", "4", "5", "6", "7", "8"];
        let work = Work::read(&words).unwrap();
        assert_eq!((work.folds, work.wanted, work.late, work.longest), (1, 2, 5, 8));
        assert_eq!(Work::read(&words[..7]), None);
        assert_eq!(Work::read(&["1", "2", "3", "4", "5", "6", "x", "8"]), None);
    }
}
