//! The way from a pixel to its sample.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use control_plane::{ControlPlane, Elaboration, FrameSweeps, MachineStage};
use exact::Columns;
use generator::{Fact, FrameError, Label, PlaneKind, Planes, Session, Shade};
use quantities::SweepTime;
use scenario::{Occlusion, Pose};
use serde::Serialize;
use signal::Probe;
use sweep_program::SweepProgram;

use crate::because::because;
use crate::column::{SIGNALS, SweepColumn};
use crate::facts::expect_pixel;
use crate::ground::GroundPoint;
use crate::late::{Late, late};

/// Where a pixel lies in what the sweeps wrote.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Place {
    /// Sweep and its fraction: the centre of sweep n is at n.
    pub between_sweeps: f64,
    /// Cell of the sweep and its fraction.
    pub between_cells: f64,
    /// Number of the nearest sweep.
    pub sweep: u32,
    /// The nearest cell, from the top.
    pub cell: usize,
    /// Cells of a sweep: lines of the picture, or finer ones under a yoke.
    pub cells: usize,
    /// Sweep whose set-up this one was drawn with: another one if its own came late.
    pub drawn_with: u32,
}

/// A sweep that the read beam passes, and its part of what is read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReadSweep {
    /// Number of the sweep, from 0 at the left.
    pub sweep: u32,
    /// Its weight, 0..=1: both are 1 together.
    pub weight: f64,
    /// What it left in the nearest cell.
    pub left: f64,
    /// Words of it that were late before the last sample that has a say there; of the whole sweep where it does not fill the cell.
    pub late: Vec<Late>,
}

/// A picture that is drawn straight between instants, beside the whole machine.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Between {
    /// Instants a step of the accumulators.
    pub instants: u32,
    /// What the sweeps of the whole machine leave at the pixel, before any tube: linear, 0..=1.
    pub whole: f64,
    /// Most that `intensity` and `whole` can differ by: an edge between two instants may lie on either side of the pixel.
    pub bound: f64,
}

/// Who left what the pixel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Writer {
    /// Terrain, with the features on it.
    Ground,
    /// A polyhedron, over whatever is behind.
    Body,
    /// A mountain of which only the outline is stored.
    Silhouette,
    /// Nobody: the pixel shows sky.
    Sky,
}

/// The same pixel by closed form.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExactPixel {
    /// Linear intensity under the pixel rule.
    pub intensity: f64,
    /// Ground range of the pixel's centre (m); none in the sky.
    pub range_m: Option<f64>,
    /// Height of the ground there (m).
    pub height_m: f64,
    /// Name of what is seen there.
    pub label: &'static str,
    /// How it is lit.
    pub shade: &'static str,
}

/// From a pixel to the wires that made it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Explanation {
    /// Frame of the pixel, counted at the update rate.
    pub frame: u64,
    /// Time of the frame since the start of the mission (s).
    pub time_s: f64,
    /// Column and line, from the top left.
    pub pixel: [usize; 2],
    /// What the picture shows there: linear, 0..=1.
    pub intensity: f64,
    /// How that was drawn, if not as the whole machine does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub between: Option<Between>,
    /// What the sweep left in the nearest cell, by the whole machine.
    pub left: f64,
    /// Place of the pixel in what the sweeps wrote.
    pub place: Place,
    /// The sweeps between which the pixel is read, the nearer one first; one where it lies on a sweep.
    pub read: Vec<ReadSweep>,
    /// Whether tubes with faults stand between what is written and what is shown: residue, spot, noise, the law of the display.
    pub has_tube: bool,
    /// Block that wrote what the pixel shows.
    pub writer: Writer,
    /// Reflectivity of the polyhedron that VS3 shows in the nearest cell.
    pub body: Option<f64>,
    /// Light points whose discs lie over it, near to far.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub lights: Vec<Fact>,
    /// The ground there, or behind the body that hides it.
    pub ground: Option<GroundPoint>,
    /// Highest line that the profile of the sweep reaches, and at which range (m).
    pub highest: Option<(f64, f64)>,
    /// Words of the sweep that were late before the last sample that has a say there; of the whole sweep where it does not fill the cell.
    pub late: Vec<Late>,
    /// The same pixel by closed form, if it was asked for.
    pub exact: Option<ExactPixel>,
    /// The same in words, most telling first.
    pub because: Vec<String>,
}

/// Why a pixel cannot be explained.
#[derive(Debug, thiserror::Error)]
pub enum InquiryError {
    /// The frame cannot be drawn.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// There is no such pixel.
    #[error("pixel {x},{y}: a picture has columns 0..{columns} and lines 0..{lines}; expected one of them")]
    Pixel {
        /// Column that was asked for.
        x: usize,
        /// Line that was asked for.
        y: usize,
        /// Columns of the picture.
        columns: u32,
        /// Lines of the picture.
        lines: u32,
    },
}

/// A machine that answers questions about its pictures.
pub struct Inquiry<'a> {
    stage: &'a MachineStage,
    session: &'a dyn Session,
    control: &'a ControlPlane,
    exact: Option<&'a Columns>,
    /// The picture that was asked about last: questions of one frame need one picture.
    last: Mutex<Option<Picture>>,
}

/// A picture, and what it is of.
struct Picture {
    frame: u64,
    pose: Pose,
    planes: Planes,
    /// Columns that are there.
    columns: Range<usize>,
}

impl<'a> Inquiry<'a> {
    /// The machine `session` that draws `stage`, and its digital side; `exact` if the error is to be told.
    pub fn new(
        stage: &'a MachineStage,
        session: &'a dyn Session,
        control: &'a ControlPlane,
        exact: Option<&'a Columns>,
    ) -> Self {
        Self { stage, session, control, exact, last: Mutex::new(None) }
    }

    /// Explains pixel (column, line) of a frame. Its picture is drawn by the threads of the current pool, as much of it
    /// as the pixel needs, and once for all pixels there that are asked about one after another.
    ///
    /// # Errors
    /// If there is no such pixel, or the pose cannot be drawn.
    pub fn explain(&self, frame: u64, pose: &Pose, [x, y]: [usize; 2]) -> Result<Explanation, InquiryError> {
        let raster = &self.stage.settings.raster;
        expect_pixel([x, y], [raster.columns, raster.lines])?;
        let sweeps = self.control.sweeps(frame, pose)?;
        let place = self.place(&sweeps, pose, [x, y]);
        let (shown, column) = self.look((frame, pose, [x, y]), place.sweep)?;
        let read = self.read(&sweeps, (frame, pose, [x, y]), &place, &column)?;
        let stroke = column.stroke_across(place.cell);
        let ground = stroke.map(|sample| self.ground(&sweeps, pose, (place.sweep, sample), &column));
        let mut explanation = Explanation {
            frame,
            time_s: pose.time,
            pixel: [x, y],
            intensity: f64::from(shown),
            between: self.between(&read),
            left: column.at("sm.write", place.cell),
            writer: writer(&column, place.cell, ground.is_some()),
            body: shown_body(&column, place.cell),
            lights: self.session.explain(frame, pose, [x, y])?,
            ground,
            highest: column.highest().map(|(line, sample)| (line, column.at("sweep.range", sample))),
            late: missed(&sweeps, place.sweep, &column, place.cell),
            place,
            read,
            has_tube: !self.stage.settings.analog.tubes_are_ideal(),
            exact: self.exact.map(|exact| exact_pixel(exact, frame, pose, [x, y])).transpose()?,
            because: Vec::new(),
        };
        explanation.because = because(&explanation);
        Ok(explanation)
    }

    /// What the sweeps of the whole machine leave at the pixel, where the picture is drawn straight between instants.
    fn between(&self, read: &[ReadSweep]) -> Option<Between> {
        let instants = Elaboration::new(self.stage).instants()?;
        let whole = read.iter().map(|read| read.weight * read.left).sum();
        Some(Between { instants, whole, bound: 1.0 })
    }

    /// The sweeps beside the pixel, with what each left there; `nearest` has the signals of the place's own sweep.
    fn read(
        &self,
        sweeps: &FrameSweeps<'_>,
        of: (u64, &Pose, [usize; 2]),
        place: &Place,
        nearest: &SweepColumn,
    ) -> Result<Vec<ReadSweep>, FrameError> {
        let beside = beside(place.between_sweeps, self.stage.settings.raster.sweeps);
        let told = |sweep, weight, column: &SweepColumn| {
            let late = missed(sweeps, sweep, column, place.cell);
            ReadSweep { sweep, weight, left: column.at("sm.write", place.cell), late }
        };
        let read = |(sweep, weight): (u32, f64)| {
            if sweep == place.sweep {
                return Ok(told(sweep, weight, nearest));
            }
            let (_, column) = self.look(of, sweep)?;
            Ok(told(sweep, weight, &column))
        };
        beside.into_iter().map(read).collect()
    }

    /// What the picture shows at a pixel, and the signals of a sweep. Where the picture is known the sweep alone is drawn.
    fn look(
        &self,
        (frame, pose, [x, y]): (u64, &Pose, [usize; 2]),
        sweep: u32,
    ) -> Result<(f32, SweepColumn), FrameError> {
        let raster = &self.stage.settings.raster;
        let [columns, lines] = [raster.columns, raster.lines].map(|count| count as usize);
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let is_there =
            |known: &Picture| known.frame == frame && known.pose == *pose && known.columns.contains(&x);
        let known = last.take().filter(is_there);
        let kinds: &[PlaneKind] = if known.is_some() { &[] } else { &[PlaneKind::Intensity] };
        let mut planes = Planes::new(columns, lines, kinds);
        let patterns = SIGNALS.iter().map(|name| (*name).to_owned()).collect();
        let mut probe = Probe::new(patterns, sweep..sweep + 1);
        let columns_drawn = self.session.column(frame, pose, x, &mut planes, &mut probe)?;
        let picture = known.unwrap_or(Picture { frame, pose: *pose, planes, columns: columns_drawn });
        let intensity = picture.planes.get(PlaneKind::Intensity);
        let shown = intensity.map_or(0.0, |plane| plane[y * columns + x]);
        *last = Some(picture);
        Ok((shown, SweepColumn::new(probe.waveforms)))
    }

    fn place(&self, sweeps: &FrameSweeps<'_>, pose: &Pose, pixel: [usize; 2]) -> Place {
        let [between_sweeps, between_cells] = sweeps.read_at(pose, pixel);
        let (last, cells) = (self.stage.settings.raster.sweeps - 1, sweeps.cells());
        let sweep = between_sweeps.round().clamp(0.0, f64::from(last)) as u32;
        let cell = between_cells.round().clamp(0.0, (cells - 1) as f64) as usize;
        Place { between_sweeps, between_cells, sweep, cell, cells, drawn_with: sweeps.set_up_of(sweep) }
    }

    fn ground(
        &self,
        sweeps: &FrameSweeps<'_>,
        pose: &Pose,
        (sweep, sample): (u32, usize),
        column: &SweepColumn,
    ) -> GroundPoint {
        let states = sweeps.registers(sweep, SweepTime(sample as f64));
        let fine = &sweeps.programs(sweep)[0];
        let way = (fine.end_range, fine.start.direction);
        let period_us = 1e6 / self.stage.settings.timebase.sample_rate().hertz();
        let by_derivative = self.stage.settings.laws.occlusion == Occlusion::Derivative;
        let ground =
            GroundPoint::at(sample, column, &states, way, &self.stage.landscape, pose.eye, period_us);
        let lacks = |crater: &u32| sweeps.lacks_crater(*crater, sweep);
        GroundPoint {
            elevation_change: by_derivative.then(|| column.at("dpp.derivative", sample)),
            craters_not_there: ground.craters.iter().copied().filter(lacks).collect(),
            shadows_not_there: sweeps.lacks_shadows(ground.place_m, sweep),
            ..ground
        }
    }
}

/// Late words of a sweep that have a say in a cell: all that were missed up to the last sample whose stroke leaves anything there. A word is
/// in force if the registers lack it at the sample that drew the middle of the cell.
fn missed(sweeps: &FrameSweeps<'_>, sweep: u32, column: &SweepColumn, cell: usize) -> Vec<Late> {
    let programs = sweeps.programs(sweep);
    let last = column.last_in(cell);
    let drawn = column.stroke_across(cell).unwrap_or(last);
    let of_level = |(level, program): (usize, &SweepProgram)| late(program, level, [drawn, last]);
    programs.iter().enumerate().flat_map(of_level).collect()
}

/// Sweeps on both sides of a place between them, of `count`, with their weights; the nearer one first.
fn beside(place: f64, count: u32) -> Vec<(u32, f64)> {
    let place = place.clamp(0.0, f64::from(count - 1));
    let (left, share) = (place.floor() as u32, place.fract());
    let mut both = vec![(left, 1.0 - share), ((left + 1).min(count - 1), share)];
    both.retain(|(_, weight)| *weight > 1e-9);
    both.sort_by(|a, b| b.1.total_cmp(&a.1));
    both
}

fn shown_body(column: &SweepColumn, cell: usize) -> Option<f64> {
    (column.at("pg.present", cell) > 0.0).then(|| column.at("pg.reflectivity", cell))
}

fn writer(column: &SweepColumn, cell: usize, is_ground: bool) -> Writer {
    match is_ground {
        _ if shown_body(column, cell).is_some() => Writer::Body,
        true => Writer::Ground,
        false if column.at("sm.write", cell) > 0.0 => Writer::Silhouette,
        false => Writer::Sky,
    }
}

fn exact_pixel(
    exact: &Columns,
    frame: u64,
    pose: &Pose,
    [x, y]: [usize; 2],
) -> Result<ExactPixel, FrameError> {
    let kinds =
        [PlaneKind::Intensity, PlaneKind::Range, PlaneKind::Height, PlaneKind::Label, PlaneKind::Shadow];
    let planes = exact.column(frame, pose, x, &kinds)?;
    let of = |kind| planes.get(kind).map_or(0.0, |plane| f64::from(plane[y]));
    let range = of(PlaneKind::Range);
    Ok(ExactPixel {
        intensity: of(PlaneKind::Intensity),
        range_m: range.is_finite().then_some(range),
        height_m: of(PlaneKind::Height),
        label: Label::of_code(of(PlaneKind::Label) as u8).map_or("unknown", Label::name),
        shade: Shade::of_code(of(PlaneKind::Shadow) as u8).map_or("unknown", Shade::name),
    })
}
