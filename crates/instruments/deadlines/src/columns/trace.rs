//! Which lines of the record reach a pixel.

use std::collections::BTreeSet;
use std::ops::RangeInclusive;

use hardware_model::Settings;
use parts::spot_sigma;
use picture_tube::PictureTube;
use sweep_generator::RangeTable;
use sweep_memory::{Tube, TubeRaster};
use timing::{Missed, TimingRecord};

use super::four::{Seen, pose};
use super::ground::GroundReach;
use super::lines::Lines;
use super::place::{Screen, Spot};
use super::verdict::{Pixel, Way};
use crate::{DeadlineError, Rehearsal};

/// Earlier frames that the tubes still show in `frame`, the nearest first.
pub fn remembered(settings: &Settings, frame: u64) -> Vec<u64> {
    let raster = TubeRaster { sweeps: 1, lines: 1, width: 1.0 };
    let stored = Tube::new(&settings.analog.memory, raster, settings.seed);
    let display = PictureTube::of(settings);
    let shown = (0..=display.frames_before(display.kept_showing())).map_while(|age| frame.checked_sub(age));
    let frames: BTreeSet<u64> = shown.flat_map(|shown| stored.earlier(shown).chain([shown])).collect();
    frames.into_iter().rev().filter(|earlier| *earlier < frame).collect()
}

/// The lines of a frame and of those before that the tube still shows, against one screen.
pub struct Trace<'a> {
    /// The ideal machine's picture.
    ground: GroundReach<'a>,
    screen: Screen,
    now: Lines<'a>,
    /// As the real parts show them: this frame, then the earlier ones, the nearest first.
    shown: Vec<(Screen, Lines<'a>)>,
    /// Sweeps on either side from which the real parts bring light to a pixel.
    spread: u32,
}

/// Where a pixel was read, and what reaches it.
pub struct Reached<'a> {
    /// Sweeps that have a share in it.
    pub sweeps: RangeInclusive<u32>,
    /// How far the ground reaches that it shows in the ideal picture (m); none where it shows sky, or where the
    /// difference comes through the parts.
    pub range_m: Option<f64>,
    /// Sweeps that are drawn with the set-up of another.
    pub drawn: Vec<[u32; 2]>,
    /// Lines, with their frames.
    pub lines: Vec<(u64, &'a Missed)>,
}

impl<'a> Trace<'a> {
    /// The trace of the last frame of `record`, before which it may have those that the tube still shows.
    pub fn new(
        rehearsal: &Rehearsal,
        record: &'a TimingRecord,
        table: &'a RangeTable,
        seen: &'a Seen,
    ) -> Result<Self, DeadlineError> {
        let settings = &rehearsal.stage.settings;
        let ground = GroundReach::new(table, seen);
        let [own, ideal] = &seen.poses;
        let refused = || DeadlineError::NoFan;
        let cells = ground.cells();
        let lines = |timing| Lines::of(timing, table, &settings.timebase, settings.raster.sweeps);
        let now = record.frames.last().ok_or_else(refused)?;
        let shown = record.frames.iter().rev().map(|timing| {
            let written = pose(rehearsal, settings, timing.frame)?;
            let screen = Screen::new(settings, &written, own.yoke, cells).ok_or_else(refused)?;
            Ok((screen, lines(timing)))
        });
        Ok(Self {
            screen: Screen::new(settings, ideal, ideal.yoke, cells).ok_or_else(refused)?,
            now: lines(now),
            shown: shown.collect::<Result<_, DeadlineError>>()?,
            spread: spread(settings),
            ground,
        })
    }

    /// Whether any line reaches the pixel.
    pub fn is_reached(&self, pixel: &Pixel, way: Way) -> bool {
        match way {
            Way::Straight => {
                let Spot { sweeps, top } = self.screen.spot(pixel.column, pixel.line);
                sweeps.into_iter().any(|sweep| {
                    let reach = self.ground.reach(sweep, top);
                    self.now.reaches(sweep, reach) || self.lacks_bodies(sweep, reach)
                })
            }
            Way::ThroughParts => self.shown.iter().any(|(screen, lines)| {
                let sweeps = self.around(screen, pixel);
                let is_late = |sweep| lines.reaches(sweep, f64::INFINITY);
                sweeps.clone().any(is_late) || (lines.has_late_bodies() && self.lack_bodies(sweeps))
            }),
        }
    }

    /// All that reach it.
    pub fn reached(&self, pixel: &Pixel, way: Way) -> Reached<'a> {
        match way {
            Way::Straight => self.straight(self.screen.spot(pixel.column, pixel.line)),
            Way::ThroughParts => self.through_parts(pixel),
        }
    }

    fn straight(&self, Spot { sweeps, top }: Spot) -> Reached<'a> {
        let (mut found, mut range, mut lacks_bodies) = (Vec::new(), 0.0_f64, false);
        for sweep in sweeps.clone() {
            let reach = self.ground.reach(sweep, top);
            range = range.max(reach);
            found.extend(self.now.of_sweep(sweep, reach));
            lacks_bodies |= self.lacks_bodies(sweep, reach);
        }
        let bodies = self.now.late_bodies().filter(|_| lacks_bodies);
        let lines = bodies.chain(in_order(found)).map(|missed| (self.now.frame, missed)).collect();
        let drawn = self.now.drawn_otherwise(&sweeps);
        Reached { sweeps, range_m: Some(range).filter(|range| range.is_finite()), drawn, lines }
    }

    /// Real parts move what they show, so the ground range at a pixel is not that of the ideal picture: every line of the
    /// sweeps around it counts.
    fn through_parts(&self, pixel: &Pixel) -> Reached<'a> {
        let mut lines = Vec::new();
        for (screen, of_frame) in self.shown.iter().rev() {
            let sweeps = self.around(screen, pixel);
            let lacks_bodies = of_frame.has_late_bodies() && self.lack_bodies(sweeps.clone());
            let ours = sweeps.flat_map(|sweep| of_frame.of_sweep(sweep, f64::INFINITY)).collect();
            let all = of_frame.late_bodies().filter(|_| lacks_bodies).chain(in_order(ours));
            lines.extend(all.map(|missed| (of_frame.frame, missed)));
        }
        let sweeps = self.around(&self.shown[0].0, pixel);
        Reached { drawn: self.now.drawn_otherwise(&sweeps), sweeps, range_m: None, lines }
    }

    fn lacks_bodies(&self, sweep: u32, reach: f64) -> bool {
        self.now.has_late_bodies() && self.ground.lacks_bodies(sweep, reach)
    }

    /// Whether late bodies can show in any of `sweeps`; in earlier frames they stood where they stand now, or nearly so.
    fn lack_bodies(&self, mut sweeps: RangeInclusive<u32>) -> bool {
        sweeps.any(|sweep| self.ground.lacks_bodies(sweep, f64::INFINITY))
    }

    /// Sweeps from which the real parts bring light to a pixel.
    fn around(&self, screen: &Screen, pixel: &Pixel) -> RangeInclusive<u32> {
        let sweeps = screen.spot(pixel.column, pixel.line).sweeps;
        let last = screen.last_sweep();
        sweeps.start().saturating_sub(self.spread)..=(sweeps.end() + self.spread).min(last)
    }
}

/// Lines by where they begin, those of one place in the order of the record.
fn in_order(mut found: Vec<(f64, &Missed)>) -> impl Iterator<Item = &Missed> {
    found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    found.into_iter().map(|(_, missed)| missed)
}

/// Deviations of the spot and of the registration beyond which nothing is looked for.
const SIGMAS: f64 = 3.0;

/// Sweeps over which the tubes move and blur what they show.
fn spread(settings: &Settings) -> u32 {
    let (stored, shown) = (&settings.analog.memory, &settings.analog.picture_tube);
    let spots: f64 = [stored.tv_lines, shown.tv_lines].into_iter().flatten().map(spot_sigma).sum();
    // Displacement, and half of the scale's error at the edge.
    let heights = SIGMAS * (spots + 1.5 * stored.registration);
    let field = settings.raster.field;
    let sweeps_a_height = f64::from(settings.raster.sweeps) * field.tan_half_height / field.tan_half_width;
    (heights * sweeps_a_height).ceil() as u32
}
