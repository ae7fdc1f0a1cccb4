//! LUNSIM as a generator: from a stage and a pose to the planes of a frame, block by block.

use generator::{
    FrameCounts, FrameError, Generator, Omission, Planes, PrepareError, Session as GeneratorSession, Stage,
    check_eye,
};
use hardware_model::Settings;
use quantities::Timebase;
use scenario::{Curvature, Pose};
use signal::{Probe, Signal, Wire};

use crate::area::{self, ViewedArea};
use crate::film::{Film, IntensityCodes};
use crate::grid::Grid;
use crate::light::light;
use crate::observer::Observer;
use crate::projection::Plot;
use crate::{NAME, restrictions, rows};

/// The program of the report's appendix; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Lunsim;

impl Generator for Lunsim {
    fn name(&self) -> &'static str {
        NAME
    }

    fn signals(&self) -> &'static [Signal] {
        &rows::SIGNALS
    }

    fn timebase(&self, settings: &Settings) -> Timebase {
        rows::timebase(settings)
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        restrictions::check_stage(&stage)?;
        let heights = area::heights(&stage.landscape);
        Ok(Box::new(Session { stage, heights }))
    }
}

struct Session {
    stage: Stage,
    heights: [f64; 2],
}

impl GeneratorSession for Session {
    /// The raster is that of `planes`; a sweep of `probe` is a row of the grid.
    fn frame(
        &self,
        frame: u64,
        pose: &Pose,
        planes: &mut Planes,
        probe: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let Stage { landscape, scenery, settings } = &self.stage;
        self.check(frame, pose)?;
        let observer = Observer::new(pose, settings.raster.field);
        let is_curved = settings.laws.curvature == Curvature::Parabolic;
        let (level, end) = (landscape.level(), settings.range.end);
        let size = settings.lunsim.grid as usize;
        let Some(area) = area::viewed(&observer, level, self.heights, is_curved, end) else {
            planes.fill_sky();
            rows::record(frame, size, None, probe);
            return Ok(FrameCounts::default());
        };
        let grid = Grid::new(landscape, &observer, &area, size, is_curved);
        let lit = light(&grid, &observer, landscape, &scenery.sun(pose.time), settings.shadows.is_some());
        let plot = Plot::new(&grid, &observer);
        let codes = IntensityCodes { count: settings.lunsim.intensity_codes, white: settings.display.white };
        let film = Film { plot: &plot, grid: &grid, light: &lit, observer: &observer, codes };
        film.develop(settings.laws.pixel_rule, planes);
        rows::record(frame, size, Some(&film), probe);
        let features = self.craters(&observer, &area) as u64;
        Ok(FrameCounts { samples: (size * size) as u64, features, ..FrameCounts::default() })
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        let Stage { landscape, settings, .. } = &self.stage;
        check_eye(landscape, frame, pose)?;
        match settings.lunsim.restrictions {
            true => restrictions::check_pose(frame, pose, settings.raster.field),
            false => Ok(()),
        }
    }

    fn omissions(&self) -> Vec<Omission> {
        restrictions::omissions(&self.stage)
    }

    fn wires(&self) -> Vec<Wire> {
        rows::wires(&self.stage, self.heights)
    }
}

impl Session {
    /// Craters whose bounding squares meet the viewed area (block 7).
    fn craters(&self, observer: &Observer, area: &ViewedArea) -> usize {
        let corners = area.along.iter().flat_map(|&along| area.across.map(|across| [along, across]));
        let places: Vec<[f64; 2]> = corners.map(|corner| observer.on_map(corner)).collect();
        let edge = |axis: usize, of: fn(f64, f64) -> f64, from: f64| {
            places.iter().map(|place| place[axis]).fold(from, of)
        };
        let low = [0, 1].map(|axis| edge(axis, f64::min, f64::INFINITY));
        let high = [0, 1].map(|axis| edge(axis, f64::max, f64::NEG_INFINITY));
        let mut found = Vec::new();
        self.stage.landscape.features().in_box(low, high, &mut found);
        found.len()
    }
}
