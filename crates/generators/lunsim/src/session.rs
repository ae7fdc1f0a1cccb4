//! LUNSIM as a generator: from a stage and a pose to the planes of a frame, block by block.

use generator::{
    Along, Counter, Fact, FrameCounts, FrameError, Generator, Joined, Omission, PlaneKind, Planes,
    PrepareError, Scan, Session as GeneratorSession, Stage, Timed, check_eye, face_lists_beside,
    photographs_beside,
};
use scenario::{Pose, View};
use serde_json::{Value, json};
use signal::{Probe, Signal, Wire};

use crate::area::{self, ViewedArea};
use crate::explained;
use crate::film::{Film, IntensityCodes, PLANES};
use crate::grid::Grid;
use crate::light::{Lit, light};
use crate::observer::Observer;
use crate::projection::Plot;
use crate::shadow::March;
use crate::{Hardware, NAME, Parameters, Program, restrictions, rows};

/// The program of the report's appendix; see the crate's data sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lunsim {
    /// Run parameters of the program.
    pub parameters: Parameters,
    /// The machines it ran on.
    pub hardware: Hardware,
}

/// Points of the grid, and craters whose bounding squares meet the viewed area.
const COUNTERS: [Counter; 2] =
    [Counter { name: "samples", joined: Joined::Sum }, Counter { name: "features", joined: Joined::Sum }];

impl Generator for Lunsim {
    fn name(&self) -> &'static str {
        NAME
    }

    fn signals(&self) -> &'static [Signal] {
        &rows::SIGNALS
    }

    fn counters(&self) -> &'static [Counter] {
        &COUNTERS
    }

    fn planes(&self) -> &'static [PlaneKind] {
        PLANES
    }

    fn scan(&self, view: &View) -> Option<Scan> {
        let timebase = rows::timebase(view, self.parameters.grid)?;
        Some(Scan { line: "row", timebase, place: rows::ACROSS, along: Along::Across { ahead: rows::ALONG } })
    }

    fn record(&self) -> Value {
        let Parameters { grid, intensity_codes, restrictions } = self.parameters;
        json!({ "grid": grid, "intensity_codes": intensity_codes, "restrictions": restrictions })
    }

    fn prepare(&self, stage: Stage) -> Result<Box<dyn GeneratorSession>, PrepareError> {
        Ok(Box::new(Session::new(stage, self.parameters)?))
    }

    fn timed(&self, stage: Stage) -> Result<Option<Box<dyn Timed>>, PrepareError> {
        Ok(Some(Box::new(Program::new(stage, self)?)))
    }
}

/// The program made ready for one stage.
pub(crate) struct Session {
    stage: Stage,
    parameters: Parameters,
    heights: [f64; 2],
}

/// What the program worked out of one frame.
pub(crate) struct Picture {
    observer: Observer,
    area: ViewedArea,
    grid: Grid,
    light: Vec<Lit>,
    plot: Plot,
    codes: IntensityCodes,
    /// The march for remote shadow.
    pub march: March,
}

impl Picture {
    /// What is sent to the recorder.
    pub fn film(&self) -> Film<'_> {
        let Self { observer, grid, light, plot, codes, .. } = self;
        Film { plot, grid, light, observer, codes: *codes }
    }
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
        let size = self.parameters.grid as usize;
        let Some(picture) = self.picture(frame, pose)? else {
            planes.fill_sky();
            rows::record(frame, size, None, probe);
            return Ok(FrameCounts::of([("samples", 0), ("features", 0)]));
        };
        let film = picture.film();
        film.develop(self.stage.view.laws.pixel_rule, planes);
        rows::record(frame, size, Some(&film), probe);
        let features = self.craters(&picture.observer, &picture.area) as u64;
        Ok(FrameCounts::of([("samples", (size * size) as u64), ("features", features)]))
    }

    fn check(&self, frame: u64, pose: &Pose) -> Result<(), FrameError> {
        let Stage { landscape, view, .. } = &self.stage;
        check_eye(landscape, frame, pose)?;
        match self.parameters.restrictions {
            true => restrictions::check_pose(frame, pose, view.field),
            false => Ok(()),
        }
    }

    fn omissions(&self) -> Vec<Omission> {
        let mut omissions = restrictions::omissions(&self.stage);
        omissions.extend(photographs_beside(&self.stage.landscape, NAME));
        omissions.extend(face_lists_beside(&self.stage.scenery, NAME));
        omissions
    }

    /// The viewed area, which the program printed beside a picture, and the point of the grid in a pixel.
    fn explain(&self, frame: u64, pose: &Pose, [column, line]: [usize; 2]) -> Result<Vec<Fact>, FrameError> {
        let Some(picture) = self.picture(frame, pose)? else {
            return Ok(vec![Fact::new("viewed area", "no ground is in view")]);
        };
        let View { columns, lines, .. } = self.stage.view;
        let at = [[column, columns as usize], [line, lines as usize]];
        Ok(explained::facts(&picture.film(), &picture.area, at))
    }

    fn wires(&self) -> Vec<Wire> {
        rows::wires(&self.stage, self.parameters.intensity_codes, self.heights)
    }
}

impl Session {
    /// Makes ready for `stage`.
    ///
    /// # Errors
    /// If the program could not draw it.
    pub fn new(stage: Stage, parameters: Parameters) -> Result<Self, PrepareError> {
        restrictions::check_stage(&stage, &parameters)?;
        let heights = area::heights(&stage.landscape);
        Ok(Self { stage, parameters, heights })
    }

    /// Returns the run parameters of the session.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// What it is made ready for.
    pub fn stage(&self) -> &Stage {
        &self.stage
    }

    /// Works out a frame; `None` if no ground is in view.
    ///
    /// # Errors
    /// If the pose cannot be drawn.
    pub fn picture(&self, frame: u64, pose: &Pose) -> Result<Option<Picture>, FrameError> {
        let Stage { landscape, scenery, view } = &self.stage;
        self.check(frame, pose)?;
        let observer = Observer::new(pose, view.field);
        let curvature = view.laws.curvature;
        let (level, end) = (landscape.level(), view.ranges[1]);
        let Some(area) = area::viewed(&observer, level, self.heights, curvature, end) else {
            return Ok(None);
        };
        let grid = Grid::new(landscape, &observer, &area, self.parameters.grid as usize, curvature);
        let sun = scenery.sun(pose.time);
        let (light, march) = light(&grid, &observer, landscape, &sun, view.shadows.is_some());
        let plot = Plot::new(&grid, &observer);
        let codes = IntensityCodes { count: self.parameters.intensity_codes, white: view.display.white };
        Ok(Some(Picture { observer, area, grid, light, plot, codes, march }))
    }

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
