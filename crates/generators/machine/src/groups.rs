//! The groups of a frame: who runs them, into what.

use std::sync::Arc;

use control_plane::FramePlan;
use light_points::Share;
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
use rayon::slice::ParallelSliceMut;
use signal::{LANES, Real, Waveform};
use signal_plane::{Group, Look, Recorded, Wanted, Workspace};

use crate::counts::{MachineCounts, terrain_counts};
use crate::elaborated::{Begun, Elaborated};
use crate::picture::Picture;

/// What a group has to say beside its lines.
#[derive(Default)]
pub(crate) struct GroupResult {
    pub counts: MachineCounts,
    pub waveforms: Vec<Waveform>,
    /// What its sweeps see of calligraphic points: sweep, number of the point, share.
    pub shares: Vec<(u32, u32, Share)>,
}

impl<S: Real> Elaborated<S> {
    /// Runs the group `index` if anyone wants it, and leaves its lines in `rows`.
    fn run_group(
        &self,
        group: &Group<'_, S>,
        wanted: Wanted<'_, impl Look>,
        index: usize,
        rows: &mut [f32],
    ) -> GroupResult {
        let first = (index * LANES) as u32;
        if !wanted.group(first) {
            return GroupResult::default();
        }
        let mut work = self.workspaces.take();
        let result = self.draw_group(group, wanted, first, &mut work, rows);
        self.workspaces.give_back(work);
        result
    }

    /// Draws a group as the economy has it. Who looks at signals sees those of the whole machine, whatever has drawn the
    /// picture.
    fn draw_group(
        &self,
        group: &Group<'_, S>,
        wanted: Wanted<'_, impl Look>,
        first: u32,
        work: &mut Workspace<S>,
        rows: &mut [f32],
    ) -> GroupResult {
        let Some(drawing) = &self.drawing else {
            group.run(first, work, rows);
            let shares = work.third.lights.take_shares();
            return GroupResult { shares, ..self.look_at(group, wanted.look, first, work, rows) };
        };
        group.at(drawing).run_preview(first, work, rows);
        let shares = work.third.lights.take_shares();
        let mut result = GroupResult { shares, ..self.look_at(group, &(), first, work, rows) };
        if wanted.look.wants_any_of(first..first + LANES as u32) {
            let mut rows = rows.to_vec();
            group.run(first, work, &mut rows);
            result.waveforms = self.look_at(group, wanted.look, first, work, &rows).waveforms;
            // The picture is the preview's, and so is what its sweeps see.
            work.third.lights.take_shares();
        }
        result
    }

    fn look_at(
        &self,
        group: &Group<'_, S>,
        look: &impl Look,
        first: u32,
        work: &Workspace<S>,
        rows: &[f32],
    ) -> GroupResult {
        let sweeps = rows.len() / self.raster.lines;
        let mut result = GroupResult::default();
        for lane in 0..sweeps {
            result.counts.add(&self.counts(work, lane));
            let recorded = Recorded { group, work, rows };
            look.look(&recorded, lane, first + lane as u32, &mut result.waveforms);
        }
        result
    }

    /// Work that a sweep was: the same for any number of threads.
    fn counts(&self, work: &Workspace<S>, lane: usize) -> MachineCounts {
        let mut counts = terrain_counts(&work.programs[lane]);
        if self.blocks.coarse.is_some() {
            counts.add(&terrain_counts(&work.coarse[lane]));
            counts.level_step_mm = (work.step * 1000.0).ceil() as u64;
        }
        if self.blocks.features {
            let program = &work.features[lane];
            let drawn =
                if self.blocks.instants.is_some() { work.passings.count(lane) } else { program.loads.len() };
            counts.features = drawn as u64;
            counts.dropped_features = u64::from(program.dropped);
        }
        MachineCounts { sweeps: 1, samples: self.table.ranges().len() as u64, ..counts }
    }

    /// All sweeps of a frame that has begun, by `plan`, into `store`.
    pub(crate) fn write(
        &self,
        plan: &FramePlan,
        begun: &Begun,
        wanted: Wanted<'_, impl Look>,
        store: &mut Vec<f32>,
    ) -> Vec<GroupResult> {
        store.resize(self.stage.settings.raster.sweeps as usize * self.raster.lines, 0.0);
        let group = self.group(plan, begun);
        let rows = store.par_chunks_mut(LANES * self.raster.lines).enumerate().with_max_len(1);
        rows.map(|(index, rows)| self.run_group(&group, wanted, index, rows)).collect()
    }

    /// All sweeps of a frame, into a picture that no tube keeps: tiles are read while others are written.
    pub(crate) fn write_and_read(
        &self,
        begun: &Begun,
        wanted: Wanted<'_, impl Look>,
        picture: &Picture<'_>,
    ) -> Vec<GroupResult> {
        let sweeps = self.stage.settings.raster.sweeps as usize;
        let groups = sweeps.div_ceil(LANES);
        let group = self.group(&begun.plan, begun);
        // From both ends inwards: where threads meet, cells have not waited since the frame began.
        let inwards = |n: usize| if n < groups / 2 { n } else { groups - 1 - (n - groups / 2) };
        let run = |index: usize| {
            let mut cells = self.cells.take();
            let rows = Arc::get_mut(&mut cells).expect("nobody else has it");
            rows.resize((sweeps - index * LANES).min(LANES) * self.raster.lines, 0.0);
            let result = self.run_group(&group, wanted, index, rows);
            picture.take(index, cells, &self.cells);
            result
        };
        let turns = (0..groups).into_par_iter().with_max_len(1);
        let mut results: Vec<_> = turns.map(inwards).map(run).collect();
        results[groups / 2..].reverse();
        results
    }
}
