//! Light points of a frame, and what a second beam draws of them.

use std::sync::Arc;

use control_plane::{FramePlan, view_plane};
use generator::{BeamEntry, Fact, FrameError};
use light_point_generator::{Optics, Point, PointTable, beam_entries, draw_beam};
use scenario::Pose;
use signal::Real;
use signal_plane::Wanted;

use crate::elaborated::{Begun, Elaborated};
use crate::groups::GroupResult;

/// Frames whose lists are kept for their repeats, beside one for each thread.
const MORE_LISTS: usize = 4;

impl<S: Real> Elaborated<S> {
    /// Light points of the frame of `plan` at `time` (s); `None` if none meets the picture.
    pub(crate) fn lights(&self, plan: &FramePlan, time: f64) -> Option<PointTable> {
        if self.stage.scenery.all_effects().is_empty() {
            return None;
        }
        let lights = self.stage.scenery.effects(time).lights;
        let columns = self.stage.settings.raster.columns as usize;
        let (view, reading) =
            (view_plane(&self.stage, plan, &self.raster), self.reading(plan, plan.yoke, columns));
        let table = PointTable::new(&lights, &Optics { view: &view, reading: &reading });
        (!table.is_empty()).then_some(table)
    }

    /// Whether any light of the mission is calligraphic: its fading takes all sweeps of a frame.
    pub(crate) fn has_beam(&self) -> bool {
        let all = self.stage.scenery.all_effects().iter();
        all.flat_map(|carried| &carried.effects.lights).any(|light| light.calligraphic)
    }

    /// The list of the second beam for a frame that has begun, from its groups: all that were drawn.
    pub(crate) fn beam_of(&self, begun: &Begun, groups: &mut [GroupResult]) -> Arc<Vec<BeamEntry>> {
        let shares = groups.iter_mut().flat_map(|group| std::mem::take(&mut group.shares)).collect();
        let list = begun.lights.as_ref().map(|table| beam_entries(table, shares));
        Arc::new(list.unwrap_or_default())
    }

    /// The list of the second beam for a frame, without its picture.
    pub(crate) fn beam_alone(&self, frame: u64, pose: &Pose) -> Result<Arc<Vec<BeamEntry>>, FrameError> {
        if !self.has_beam() {
            return Ok(Arc::default());
        }
        if let Some(list) = self.beams.get(frame) {
            return Ok(list);
        }
        let begun = self.begin(frame, pose)?;
        let mut store = self.stores.take();
        let wanted = Wanted { look: &(), picture: &self.all_sweeps() };
        let mut groups = self.write(&begun.plan, &begun, wanted, &mut store);
        self.stores.give_back(store);
        let list = self.beam_of(&begun, &mut groups);
        self.deliveries.give_back(begun.delivery);
        self.keep_beam(frame, &list);
        Ok(list)
    }

    /// Keeps a list for the repeats of its frame.
    pub(crate) fn keep_beam(&self, frame: u64, list: &Arc<Vec<BeamEntry>>) {
        self.beams.keep(frame, Arc::clone(list), rayon::current_num_threads() + MORE_LISTS);
    }

    /// Light points whose discs lie over the middle of a pixel (column and line) of a frame, hidden or not, near to far.
    pub(crate) fn lights_over(
        &self,
        frame: u64,
        pose: &Pose,
        pixel: [usize; 2],
    ) -> Result<Vec<Fact>, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let Some(table) = self.lights(&plan, pose.time) else { return Ok(Vec::new()) };
        let list = self.beam_alone(frame, pose)?;
        let middle = pixel.map(|at| at as f64 + 0.5);
        let over = table.points().iter().filter(|point| point.covers(middle));
        Ok(over.map(|point| Fact::new(format!("light point {}", point.light), told(point, &list))).collect())
    }

    /// Adds the spots of a list to a picture, if that has any pixels.
    pub(crate) fn draw_spots(&self, list: &[BeamEntry], pixels: &mut [f32]) {
        let raster = &self.stage.settings.raster;
        if !pixels.is_empty() {
            draw_beam(list, [raster.columns, raster.lines], pixels);
        }
    }
}

/// Who draws a light point, and how bright.
fn told(point: &Point, list: &[BeamEntry]) -> String {
    let Point { disc, light, .. } = point;
    let disc = format!("disc of {:.2} pixels, intensity {:.4}", disc.diameter, disc.intensity);
    let entry = list.iter().find(|entry| entry.light == *light);
    match (point.is_calligraphic, entry) {
        (false, _) => format!("VS3 draws it where it is seen: {disc}, adds {:.4}", point.added),
        (true, Some(entry)) => {
            format!(
                "the second beam draws it: {disc}, fading {:.4}",
                entry.display_intensity / entry.intensity
            )
        }
        (true, None) => format!("the second beam does not draw it, because no sweep sees it: {disc}"),
    }
}
