//! The machine in time: when each sub-area is read out, and what the units of a frame are busy with.

use generator::Label;
use quantities::Rate;
use raster::Screen;
use scene_sampler::{Reading, Scene};
use timing::{Task, UnitUse};

use crate::drawn::Drawn;
use crate::hardware::Hardware;

/// The units, in the order in which a feature meets them.
pub const GEOMETRY: &str = "geometry";
pub const LISTS: &str = "lists";
pub const SAMPLER: &str = "sampler";
pub const STACK: &str = "stack";
pub const PIXELS: &str = "pixels";
pub const LIGHT_POINTS: &str = "light-points";
pub const BEAM: &str = "beam";

/// Nanoseconds in a second.
const SECOND: u128 = 1_000_000_000;

/// Ticks of a frame at `update` frames a second: whole ones, at least 1.
pub fn frame_ticks(hardware: &Hardware, update: Rate) -> u64 {
    update.period_ticks(hardware.sampler_hz)
}

/// Ticks in which the beam draws so many points: whole ones.
pub fn beam_ticks(hardware: &Hardware, points: u64) -> u64 {
    let each = u128::from(hardware.beam.jump_ns) + u128::from(hardware.beam.dwell_ns);
    let ticks = u128::from(points) * each * u128::from(hardware.sampler_hz) / SECOND;
    u64::try_from(ticks).unwrap_or(u64::MAX)
}

/// Tick at which a row of sub-areas is due, of `rows` in a frame of `frame` ticks: its share of the frame has gone by.
pub fn due(row: u32, rows: u32, frame: u64) -> u64 {
    (u128::from(frame) * (u128::from(row) + 1) / u128::from(rows)) as u64
}

/// Row of each sub-area in raster order, and the tick at which it is due in a frame of `frame` ticks.
pub fn dues(screen: &Screen, frame: u64) -> impl Iterator<Item = (u32, u64)> + use<> {
    let [columns, rows] = screen.counts();
    (0..rows).flat_map(move |row| (0..columns).map(move |_| (row, due(row, rows, frame))))
}

/// Fields that a frame takes whose last sub-area is read out at tick `end`: whole ones of `ticks`, at least 1.
pub fn fields(end: u64, ticks: u64) -> u64 {
    end.div_ceil(ticks).max(1)
}

/// The course of a frame through sampler and pixel writer.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Course {
    /// Tick at which each sub-area is read out and its pixels are written, from when the frame begins.
    pub read_out: Vec<u64>,
    /// Whether a sub-area ever waited for the pixel writer.
    pub has_waited: bool,
}

impl Course {
    /// Sub-area after sub-area in raster order. The pixels of one are written while the next is worked out. That one waits for
    /// the writer before it hands its own over.
    pub fn of(readings: &[Reading], hardware: &Hardware) -> Self {
        let (mut handed_over, mut written) = (0, 0);
        let mut course = Self { read_out: Vec::with_capacity(readings.len()), has_waited: false };
        for reading in readings {
            let done: u64 = handed_over + hardware.ticks(reading);
            course.has_waited |= done < written;
            handed_over = done.max(written);
            written = handed_over + hardware.pixel_ticks(reading);
            course.read_out.push(written);
        }
        course
    }

    /// Tick at which the last sub-area is read out; 0 without sub-areas.
    pub fn end(&self) -> u64 {
        self.read_out.last().copied().unwrap_or(0)
    }
}

/// Pieces of a frame's work that do not stand in the readings of its sub-areas.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Features that were transformed and held against the view: faces, light points, discs of the sky.
    pub features: u64,
    /// Corners of what clipping left of them.
    pub corners: u64,
    /// Pairs (feature, sub-area) that were found, whether they found a place or not.
    pub pairs: u64,
    /// Points that the beam drew.
    pub drawn: u64,
    /// Points for which it had no time.
    pub dropped: u64,
}

impl Work {
    /// The work of a scene and its picture.
    pub fn of(scene: &Scene, Drawn { picture, lost }: &Drawn, screen: &Screen) -> Self {
        let lights = scene.faces.labels.iter().filter(|label| **label == Label::Light).count();
        let listed: usize = (0..screen.sub_areas()).map(|area| scene.lights.of(area).len()).sum();
        Self {
            features: scene.faces.work.faces + (lights + scene.discs.len()) as u64,
            corners: scene.faces.work.corners,
            pairs: picture.entries + lost.len() as u64 + listed as u64,
            drawn: picture.beam.drawn.len() as u64,
            dropped: picture.beam.dropped.len() as u64,
        }
    }

    /// Ticks of geometry and lists, one after the other.
    pub fn before_frame(&self, hardware: &Hardware) -> u64 {
        self.features * hardware.feature_ticks + self.corners * hardware.corner_ticks + self.pairs
    }

    /// Tasks that had something to do, in the order of the units.
    pub fn tasks(&self, readings: &[Reading], hardware: &Hardware) -> Vec<Task> {
        let sum = |of: &dyn Fn(&Reading) -> u64| readings.iter().map(of).sum::<u64>();
        let entries = sum(&Reading::entries);
        let is_short = |reading: &Reading| reading.entries() < hardware.least_ticks;
        let short = sum(&|reading| u64::from(is_short(reading)));
        let deepest = sum(&|reading| u64::from(reading.depth));
        let discs = sum(&|reading| u64::from(reading.calligraphic));
        [
            (GEOMETRY, "features", self.features, self.features * hardware.feature_ticks),
            (GEOMETRY, "corners", self.corners, self.corners * hardware.corner_ticks),
            (LISTS, "pairs", self.pairs, self.pairs),
            (SAMPLER, "entries", entries, entries),
            (SAMPLER, "short-lists", short, sum(&|reading| hardware.list_ticks(reading)) - entries),
            (STACK, "insertions", deepest, sum(&|reading| hardware.stack_ticks(reading))),
            (
                PIXELS,
                "pixels",
                sum(&|reading| u64::from(reading.pixels)),
                sum(&|reading| hardware.pixel_ticks(reading)),
            ),
            (LIGHT_POINTS, "discs", discs, discs),
            (BEAM, "points", self.drawn, beam_ticks(hardware, self.drawn)),
        ]
        .into_iter()
        .filter(|(_, _, pieces, ticks)| *pieces > 0 && *ticks > 0)
        .map(|(unit, task, pieces, ticks)| Task { unit: unit.into(), task: task.into(), pieces, ticks })
        .collect()
    }

    /// Use of all units: each is busy for its `tasks`.
    pub fn units(&self, tasks: &[Task], course: &Course) -> Vec<UnitUse> {
        let busy = |unit: &str| {
            let ours = tasks.iter().filter(|task| task.unit == unit);
            ours.map(|task| task.ticks).sum::<u64>()
        };
        let queue = |unit: &str| match unit {
            PIXELS => u32::from(course.has_waited),
            BEAM => u32::try_from(self.drawn + self.dropped).unwrap_or(u32::MAX),
            _ => 0,
        };
        [GEOMETRY, LISTS, SAMPLER, STACK, PIXELS, LIGHT_POINTS, BEAM]
            .map(|unit| UnitUse { unit: unit.into(), busy: busy(unit), longest_queue: queue(unit) })
            .into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reading(triangles: u32, depth: u32, calligraphic: u32) -> Reading {
        Reading { triangles, depth, calligraphic, pixels: 64, ..Reading::default() }
    }

    fn rate(hertz: u64) -> Rate {
        Rate::new(hertz, 1).unwrap()
    }

    /// Section 11 of the specification: 40 MHz, 50 frames a second, 1000 x 1000 pixels.
    #[test]
    fn a_full_frame_has_51_entries_a_sub_area() {
        let hardware = Hardware::shipped().unwrap();
        let ticks = frame_ticks(&hardware, rate(50));
        let areas = Screen::new([1000, 1000], 8).unwrap().sub_areas();
        assert_eq!((ticks, areas), (800_000, 15_625));
        assert_eq!(ticks as f64 / areas as f64, 51.2);
        assert_eq!(frame_ticks(&hardware, Rate::new(30_000, 1001).unwrap()), 1_334_666);
    }

    /// With 4 + 6 µs a point 1666 fit a field of 60 Hz, and each of them is drawn before it ends.
    #[test]
    fn points_that_the_budget_lets_pass_are_drawn_within_the_field() {
        let hardware = Hardware::shipped().unwrap();
        assert_eq!(hardware.beam.most((1e9 / 60.0) as u64), 1666);
        let field = frame_ticks(&hardware, rate(60));
        assert_eq!((beam_ticks(&hardware, 1666), field), (666_400, 666_666));
        assert!(beam_ticks(&hardware, 1667) > field);
    }

    /// Three sub-areas: 10 entries; 3 entries, filled up to 8; 20 entries, 5 deep with 2 more ticks each, and 4 points.
    #[test]
    fn sub_areas_follow_one_another() {
        let hardware = Hardware { insert_ticks: 3, ..Hardware::shipped().unwrap() };
        let readings = [reading(10, 0, 0), reading(3, 0, 0), reading(20, 5, 4)];
        let course = Course::of(&readings, &hardware);
        assert_eq!(course, Course { read_out: vec![10 + 8, 18 + 8, 18 + 34 + 8], has_waited: false });
        let slow = Hardware { pixels_tick: 1, ..hardware };
        let course = Course::of(&readings, &slow);
        assert_eq!(course, Course { read_out: vec![74, 138, 202], has_waited: true });
    }

    #[test]
    fn tasks_are_pieces_times_ticks() {
        let hardware = Hardware { insert_ticks: 3, ..Hardware::shipped().unwrap() };
        let readings = [reading(10, 1, 0), reading(3, 0, 0), reading(20, 5, 4)];
        let work = Work { features: 7, corners: 11, pairs: 37, drawn: 2, dropped: 1 };
        let tasks = work.tasks(&readings, &hardware);
        let told: Vec<_> = tasks
            .iter()
            .map(|task| (task.unit.as_str(), task.task.as_str(), task.pieces, task.ticks))
            .collect();
        let expected = [
            ("geometry", "features", 7, 7),
            ("geometry", "corners", 11, 11),
            ("lists", "pairs", 37, 37),
            ("sampler", "entries", 33, 33),
            ("sampler", "short-lists", 1, 5),
            ("stack", "insertions", 6, 12),
            ("pixels", "pixels", 192, 24),
            ("light-points", "discs", 4, 4),
            ("beam", "points", 2, 800),
        ];
        assert_eq!(told, expected);
        assert_eq!(work.before_frame(&hardware), 7 + 11 + 37);
        let units = work.units(&tasks, &Course::of(&readings, &hardware));
        assert_eq!(units.iter().map(|unit| unit.busy).sum::<u64>(), 933);
        assert_eq!(units.last().map(|unit| unit.longest_queue), Some(3));
    }

    #[test]
    fn the_last_row_is_due_when_the_frame_ends() {
        assert_eq!([0, 1, 2].map(|row| due(row, 3, 800_000)), [266_666, 533_333, 800_000]);
    }
}
