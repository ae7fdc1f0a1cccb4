//! A frame of the machine, from its pose to its planes.

use std::ops::Range;
use std::sync::Arc;

use control_plane::FramePlan;
use generator::{BeamEntry, Fact, FrameCounts, FrameError, Omission, PlaneKind, Planes, Session};
use picture_tube::PictureTube;
use scenario::Pose;
use signal::{Probe, Real, Waveform, Wire};
use signal_plane::{Look, Wanted, wires};
use sweep_memory::Tile;

use crate::counts::{MachineCounts, delivery_counts};
use crate::elaborated::{Begun, Elaborated};
use crate::omissions::omissions;

impl<S: Real> Elaborated<S> {
    /// One frame, and what `look` has seen of it.
    pub fn draw(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        look: &impl Look,
    ) -> Result<(FrameCounts, Vec<Waveform>), FrameError> {
        self.draw_columns((frame, 0..planes.columns()), pose, planes, look)
    }

    /// The same of some columns of the picture: all, or those of a tile where no tube keeps it.
    fn draw_columns(
        &self,
        (frame, columns): (u64, Range<usize>),
        pose: &Pose,
        planes: &mut Planes,
        look: &impl Look,
    ) -> Result<(FrameCounts, Vec<Waveform>), FrameError> {
        let settings = &self.stage.settings;
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        let picture = if planes.any() { self.sweeps_of(&plan, pose.yoke, &columns) } else { 0..0 };
        let wanted = Wanted { look, picture: &picture };
        let begun = self.begin_for(plan, pose.time, wanted)?;
        let mut nothing = [];
        let pixels = planes.get_mut(PlaneKind::Intensity).unwrap_or(&mut nothing);
        let mut groups = self.read(&begun, pose.yoke, wanted, pixels)?;
        if let Some(tube) = &self.parts.picture_tube {
            self.show(tube, [frame, tube.kept_showing()], Arc::new(pixels.to_vec()), pixels)?;
        }
        if self.has_beam() && picture == self.all_sweeps() {
            let list = self.beam_of(&begun, &mut groups);
            self.draw_spots(&list, pixels);
            self.keep_beam(frame, &list);
        }
        let Begun { plan, delivery, .. } = begun;
        let regions = plan.visible_regions(self.stage.landscape.level(), settings.range.end);
        let mut total = MachineCounts { regions: regions as u64, ..delivery_counts(&delivery) };
        self.deliveries.give_back(delivery);
        let mut waveforms = Vec::new();
        for group in groups {
            total.add(&group.counts);
            waveforms.extend(group.waveforms);
        }
        Ok((total.into(), waveforms))
    }

    /// Sweeps that some columns of the picture are read from.
    fn sweeps_of(&self, plan: &FramePlan, yoke: f64, columns: &Range<usize>) -> Range<u32> {
        let all = self.stage.settings.raster.columns as usize;
        if *columns == (0..all) {
            return self.all_sweeps();
        }
        let Range { start, end } = self.reading(plan, yoke, all).sweeps(columns);
        start as u32..end as u32
    }
}

impl<S: Real> Session for Elaborated<S> {
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let (counts, waveforms) = self.draw(frame, pose, planes, &*probe)?;
        probe.waveforms.extend(waveforms);
        Ok(counts)
    }

    fn column(
        &self,
        frame: u64,
        pose: &Pose,
        column: usize,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<Range<usize>, FrameError> {
        let takes_all = self.parts.tube.is_some() || self.parts.picture_tube.is_some() || self.has_beam();
        let all = planes.columns();
        let columns = if takes_all { 0..all } else { Tile::columns_beside(column, all) };
        let (_, waveforms) = self.draw_columns((frame, columns.clone()), pose, planes, &*probe)?;
        probe.waveforms.extend(waveforms);
        Ok(columns)
    }

    fn repeat(&self, frame: u64, pose: &Pose, showing: u64, planes: &mut Planes) -> Result<bool, FrameError> {
        let tube = self.parts.picture_tube.as_ref().filter(|tube| tube.repeats_differ());
        let (Some(tube), Some(pixels)) = (tube, planes.get_mut(PlaneKind::Intensity)) else {
            return Ok(false);
        };
        let read = self.pictures.get(frame).map_or_else(|| self.read_alone(frame, pose), Ok)?;
        self.show(tube, [frame, showing], read, pixels)?;
        self.draw_spots(&self.beam_alone(frame, pose)?, pixels);
        Ok(true)
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        FramePlan::new(frame, pose, &self.stage, &self.raster.field).map(drop)
    }

    fn omissions(&self) -> Vec<Omission> {
        omissions(&self.stage, &self.list)
    }

    fn wires(&self) -> Vec<Wire> {
        self.wires.get_or_init(|| wires(&self.stage, &self.blocks, &self.raster)).clone()
    }

    fn lines(&self, frame: u64, pose: &Pose, lines: Range<u32>) -> Result<Vec<Waveform>, FrameError> {
        let tube = PictureTube::of(&self.stage.settings);
        let read = self.read_alone(frame, pose)?;
        let there = lines.start..lines.end.min(tube.lines_scanned());
        let of_line = |line: u32| Waveform {
            signal: picture_tube::SIGNALS[0],
            frame,
            sweep: line,
            times: Vec::new(),
            values: tube.drive(frame, line, &read),
        };
        Ok(there.map(of_line).collect())
    }

    /// Light points alone: all else of a pixel is the instrument's to say.
    fn explain(&self, frame: u64, pose: &Pose, pixel: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        self.lights_over(frame, pose, pixel)
    }

    fn beam_list(&self, frame: u64, pose: &Pose) -> Result<Option<Vec<BeamEntry>>, FrameError> {
        Ok(Some(Arc::unwrap_or_clone(self.beam_alone(frame, pose)?)))
    }

    fn direction(&self, frame: u64, pose: &Pose, line: u32) -> Result<Option<[f64; 2]>, FrameError> {
        let plan = FramePlan::new(frame, pose, &self.stage, &self.raster.field)?;
        Ok(Some(plan.direction(line)))
    }
}
