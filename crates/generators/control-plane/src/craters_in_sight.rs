//! Craters of a frame that can be told, group by group (economy `Instants`).

use crate::stage::MachineStage;
use features::{LeftOut, Outlook};
use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};
use signal::LANES;

use crate::frame_plan::FramePlan;
use crate::sight::pixels_a_cell;

/// Part of a line of the screen that a crater must be high to be drawn. Chosen: see docs/economy.md for what it does to a picture.
const LEAST: f64 = 0.5;

/// Craters by the groups of sweeps that may meet them.
#[derive(Debug, Default)]
pub struct CratersInSight {
    /// Where the craters of each group begin in `craters`; one more at the end.
    begins: Vec<u32>,
    /// Ascending within a group.
    craters: Vec<u32>,
    /// What cannot be told; its cells are pixels of the screen.
    pub left_out: LeftOut,
    found: Vec<u32>,
    /// First and last group that may meet each of `found`.
    reach: Vec<Option<[usize; 2]>>,
}

impl CratersInSight {
    /// Finds those of the frame of `plan`, up to the end of its sweeps.
    pub fn find(&mut self, stage: &MachineStage, plan: &FramePlan) {
        let features = stage.landscape.features();
        let origin = [plan.eye[0], plan.eye[1]];
        let outlook = outlook(stage, plan);
        let end = stage.settings.range.end;
        self.left_out = features.in_sight(origin, plan.edges(), end, &outlook, &mut self.found);
        self.left_out.cells *= pixels_a_cell(stage);
        let groups = plan.fan.sweeps.div_ceil(LANES as u32) as usize;
        let reach = |index: &u32| {
            let (centre, outer) = features.craters().circle(*index);
            let sweeps = plan.sweeps_of(centre, outer)?;
            Some(sweeps.map(|sweep| sweep as usize / LANES))
        };
        self.found.par_iter().map(reach).collect_into_vec(&mut self.reach);
        self.begins.clear();
        self.begins.resize(groups + 1, 0);
        for [first, last] in self.reach.iter().flatten() {
            self.begins[first + 1..=last + 1].iter_mut().for_each(|count| *count += 1);
        }
        (0..groups).for_each(|group| self.begins[group + 1] += self.begins[group]);
        self.craters.clear();
        self.craters.resize(self.begins[groups] as usize, 0);
        let mut ends = self.begins.clone();
        for (index, reach) in self.found.iter().zip(&self.reach) {
            let Some([first, last]) = reach else { continue };
            for end in &mut ends[*first..=*last] {
                self.craters[*end as usize] = *index;
                *end += 1;
            }
        }
    }

    /// Craters that some of `sweeps` may meet, ascending, into `found`.
    pub fn of(&self, sweeps: &[u32; LANES], found: &mut Vec<u32>) {
        found.clear();
        let mut groups = sweeps.map(|sweep| sweep as usize / LANES);
        groups.sort_unstable();
        for group in groups.chunk_by(|a, b| a == b).map(|same| same[0]) {
            found.extend_from_slice(
                &self.craters[self.begins[group] as usize..self.begins[group + 1] as usize],
            );
        }
        if groups[0] != groups[LANES - 1] {
            found.sort_unstable();
            found.dedup();
        }
    }
}

fn outlook(stage: &MachineStage, plan: &FramePlan) -> Outlook {
    let raster = stage.settings.raster;
    let cell = 2.0 * raster.field.tan_half_height / f64::from(raster.lines);
    let ground = stage.landscape.height(plan.eye[0], plan.eye[1]);
    // A frame is not planned with an eye that has no ground below it.
    let eye = ground.map_or(0.0, |ground| (plan.eye[2] - ground).max(0.0));
    Outlook { eye, least: LEAST * cell, cell }
}
