//! The analog side of a group of sweeps: the generators, MU, DPP, SM in the order of section 24.

mod features;
mod grain;
mod lights;
mod lines;
mod mixing;
mod projection;
mod terrain;

use std::{array, slice};

use control_plane::{Blocks, Crossings, Delivery, DigitalFrame, FramePlan, MachineStage, WrittenRaster};
use display_projection_processor::Processor;
use landscape::{Level, SweepLight};
use light_point_generator::PointTable;
use polyhedron_generator::NearTable;
use signal::{LANES, Real};
use sweep_generator::RangeTable;
use terrain_generator::TerrainGenerator;

use crate::drawing::Drawing;
use crate::output_amplifiers::Ends;
use crate::real_parts::RealParts;
use crate::workspace::Workspace;

/// Everything that the groups of a frame share.
#[derive(Debug, Clone, Copy)]
pub struct Group<'a, S> {
    /// Ground, scenery and settings.
    pub stage: &'a MachineStage,
    /// Blocks that are there.
    pub blocks: &'a Blocks,
    /// Ground range of each step of the accumulators, by the ground-range programme.
    pub clock: &'a RangeTable,
    /// Samples a step at which signals are evaluated.
    pub instants: u32,
    /// Ground range of each sample.
    pub table: &'a RangeTable,
    /// Inverse range of each sample (1/m).
    pub near: &'a NearTable,
    /// The ideal projection processor.
    pub processor: &'a Processor<S>,
    /// Raster that the sweeps write.
    pub raster: WrittenRaster,
    /// Fan, eye and sun of the frame.
    pub plan: &'a FramePlan,
    /// What the I/O processors have brought.
    pub delivery: &'a Delivery,
    /// Light points of the frame, if any meets the picture.
    pub lights: Option<&'a PointTable>,
    /// Set-ups and corners that are ready.
    pub digital: &'a DigitalFrame,
    /// Blocks made of parts.
    pub parts: &'a RealParts<S>,
}

impl<S: Real> Group<'_, S> {
    /// Runs the group that begins at sweep `first` and leaves its lines in `rows`, one stretch a sweep.
    pub fn run(&self, first: u32, work: &mut Workspace<S>, rows: &mut [f32]) {
        let sweeps = self.sweeps(first);
        let light = self.light(&sweeps);
        self.draw_terrain(first, &sweeps, &light, work);
        if self.blocks.features {
            self.draw_features(first, &sweeps, &light, work);
        }
        if self.blocks.texture {
            let all = 0..self.table.ranges().len();
            self.find_grain(&sweeps, work);
            self.draw_texture(&sweeps, slice::from_ref(&all), work);
        }
        self.set_gates(&sweeps, work);
        self.mix(work);
        self.project(first, &sweeps, work);
        self.write(work, rows);
        let Workspace { projected, third, far, .. } = work;
        self.overlay(first, (&projected.line, far), third, rows);
        self.keep_words(rows);
    }

    /// The same group with its signals at the samples of `drawing`.
    pub fn at<'d>(&'d self, drawing: &'d Drawing<S>) -> Group<'d, S> {
        let Drawing { instants, table, near, processor } = drawing;
        Group { instants: *instants, table, near, processor, ..*self }
    }

    /// Set-ups of the sweeps of a group. Lanes beyond the last sweep repeat it; nothing of them is kept.
    pub fn sweeps(&self, first: u32) -> [u32; LANES] {
        let last = self.plan.fan.sweeps - 1;
        array::from_fn(|lane| self.digital.drawn((first + lane as u32).min(last)))
    }

    /// Returns the light in the axes of each sweep.
    pub fn light(&self, sweeps: &[u32; LANES]) -> [SweepLight; LANES] {
        let (landscape, sun) = (&self.stage.landscape, &self.plan.sun);
        sweeps.map(|sweep| {
            let direction = self.plan.direction(sweep);
            SweepLight::new(sun, landscape.albedo(), *landscape.photometry(), direction)
        })
    }

    /// The terrain generator of a level, set for the frame.
    pub fn terrain<'l>(&'l self, level: &'l Level) -> TerrainGenerator<'l> {
        TerrainGenerator {
            buffer: level.words(),
            region_size: level.region_size(),
            ranges: self.table.ranges(),
            datum: self.plan.eye[2],
        }
    }

    /// Directions of the sweeps over the ground: north, east.
    pub fn directions(&self, sweeps: &[u32; LANES]) -> [[f64; 2]; LANES] {
        sweeps.map(|sweep| self.plan.direction(sweep))
    }

    /// First samples beyond the profiles of the group.
    pub fn ends(&self, work: &Workspace<S>) -> Ends {
        array::from_fn(|lane| {
            let end = self.end_range(lane, work);
            self.table.ranges().partition_point(|&range| range <= end)
        })
    }

    /// The service of the crossings in the frame.
    pub fn crossings(&self) -> Crossings<'_> {
        Crossings {
            stage: self.stage,
            coarse: self.blocks.coarse.as_ref(),
            table: self.clock,
            plan: self.plan,
            missing: self.digital.missing(),
            held: &self.digital.held,
            absent_craters: &self.digital.absent_craters,
        }
    }

    /// Ground range at which the profile of a lane ends (m).
    pub fn end_range(&self, lane: usize, work: &Workspace<S>) -> f64 {
        let fine = work.programs[lane].end_range;
        if self.blocks.coarse.is_some() { work.coarse[lane].end_range.max(fine) } else { fine }
    }

    /// Number of a sweep over all frames: noise goes by it.
    fn address(&self, sweep: u32) -> u64 {
        self.plan.frame * u64::from(self.stage.settings.raster.sweeps) + u64::from(sweep)
    }
}
