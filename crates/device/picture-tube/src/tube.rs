//! The display as a whole: from pictures that were read to the light of a showing.

use hardware_model::{AnalogParts, Settings};
use parts::{Spot, spot_sigma};
use quantities::{Timebase, TimebaseError};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::amplifier::{VideoAmplifier, VideoLine};
use crate::law::TubeLaw;
use crate::scans::Scans;

/// What the beam of the tube scans, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScanRaster {
    /// Pixels of a line.
    pub columns: usize,
    /// Lines of a picture.
    pub lines: usize,
    /// Width of the raster, in its heights.
    pub width: f64,
    /// Showings a second: each is a field.
    pub refresh: f64,
    /// Showings of a frame, 1 or more.
    pub showings: u64,
    /// Share of a line's period in which it is drawn, above 0; the rest is retrace.
    pub active: f64,
}

impl ScanRaster {
    /// Clocks of the lines that the beam scans, of which a frame has `lines`: lines as sweeps, columns as samples.
    ///
    /// # Errors
    /// If there are more lines or columns than clocks count.
    pub fn clocks(settings: &Settings, lines: u32) -> Result<Timebase, TimebaseError> {
        let (clocks, columns) = (&settings.timebase, settings.raster.columns);
        let Self { active, .. } = Self::of(settings);
        let retrace = (f64::from(columns) * (1.0 - active) / active).round() as u32;
        Timebase::new(clocks.master, clocks.update, lines, columns, retrace)
    }

    /// The raster of a machine of `settings`. Its lines have the share of retrace that the sweeps have.
    pub fn of(settings: &Settings) -> Self {
        let (raster, clocks) = (&settings.raster, &settings.timebase);
        let samples = f64::from(clocks.active_samples + clocks.retrace_samples);
        Self {
            columns: raster.columns as usize,
            lines: raster.lines as usize,
            width: raster.field.tan_half_width / raster.field.tan_half_height,
            refresh: raster.refresh.hertz(),
            showings: raster.refresh.whole_ratio(clocks.update).unwrap_or(1),
            active: f64::from(clocks.active_samples) / samples,
        }
    }
}

/// Video amplifier and picture tube.
#[derive(Debug, Clone)]
pub struct PictureTube {
    columns: usize,
    lines: usize,
    amplifier: VideoAmplifier,
    law: TubeLaw,
    scans: Scans,
    /// Along lines and across them.
    spot: Option<[Spot; 2]>,
}

impl PictureTube {
    /// The display of a machine of `settings`.
    pub fn of(settings: &Settings) -> Self {
        Self::new(&settings.analog, &ScanRaster::of(settings), settings.display.white, settings.seed)
    }

    /// The display of `parts`, on which the reflectivity `white` is white; `seed` is that of its noise.
    pub fn new(parts: &AnalogParts, raster: &ScanRaster, white: f64, seed: u64) -> Self {
        let ScanRaster { columns, lines, width, refresh, showings, active } = *raster;
        let tube = &parts.picture_tube;
        let lines_a_second = refresh * lines as f64 / f64::from(tube.fields);
        let step = active / (lines_a_second * columns as f64);
        let spot = |tv_lines| {
            let sigma = spot_sigma(tv_lines);
            let axis =
                |cells: usize, heights: f64| Spot::new(cells, sigma * cells as f64 / heights, |cell| cell);
            [axis(columns, width), axis(lines, 1.0)]
        };
        Self {
            columns,
            lines,
            amplifier: VideoAmplifier::new(parts, step, seed),
            law: TubeLaw::new(tube, white),
            scans: Scans::new(tube, showings, 1.0 / refresh),
            spot: tube.tv_lines.map(spot),
        }
    }

    /// The showing that is kept of a frame: its last, in which every field of a picture has been scanned, if any has.
    pub fn kept_showing(&self) -> u64 {
        self.scans.showings - 1
    }

    /// Frames before one that count in its showing `showing`.
    pub fn frames_before(&self, showing: u64) -> u64 {
        self.scans.frames_before(showing)
    }

    /// Whether showings of one frame differ.
    pub fn repeats_differ(&self) -> bool {
        self.amplifier.is_noisy() || self.scans.are_several()
    }

    /// Lines that the beam scans in a frame, all fields together.
    pub fn lines_scanned(&self) -> u32 {
        (self.scans.showings * self.scans.lines_of_field(self.lines as u64)) as u32
    }

    /// The drive of the tube along line `number` of frame `frame`, counted in the order of time: one value a column, 1 for white.
    /// `read` is the picture that was read; a field that has no such line is dark.
    pub fn drive(&self, frame: u64, number: u32, read: &[f32]) -> Vec<f64> {
        let (field, line) = self.scans.scanned(frame, u64::from(number), self.lines as u64);
        let Some(line) = line else { return vec![0.0; self.columns] };
        let mut video = VideoLine::new(self.columns);
        self.amplifier.amplify(
            &read[line as usize * self.columns..][..self.columns],
            self.address(field, line),
            &mut video,
        );
        video.video.iter().map(|&video| f64::from(self.law.drive(video))).collect()
    }

    /// Address of the noise of a line in a field.
    fn address(&self, field: u64, line: u64) -> u64 {
        field.wrapping_mul(self.lines as u64).wrapping_add(line)
    }

    /// The light of showing `showing` of frame `frame`, line by line, in the unit of reflectivity. `read` has the pictures that
    /// were read in this frame and in those before it, the nearest first, one at least: the last stands in for any that is
    /// missing. `scratch` holds nothing after.
    pub fn show(&self, frame: u64, showing: u64, read: &[&[f32]], light: &mut [f32], scratch: &mut Vec<f32>) {
        let rows = light.par_chunks_exact_mut(self.columns).enumerate();
        rows.for_each_init(
            || VideoLine::new(self.columns),
            |video, (line, light)| self.show_line([frame, showing, line as u64], read, video, light),
        );
        let Some([along, across]) = &self.spot else { return };
        scratch.resize(light.len(), 0.0);
        let rows = scratch.par_chunks_exact_mut(self.columns).zip(light.par_chunks_exact(self.columns));
        rows.for_each(|(out, row)| along.along(row, out));
        let rows = light.par_chunks_exact_mut(self.columns).enumerate();
        rows.for_each(|(line, row)| across.across(line, scratch, row));
    }

    fn show_line(
        &self,
        [frame, showing, line]: [u64; 3],
        read: &[&[f32]],
        video: &mut VideoLine,
        light: &mut [f32],
    ) {
        light.fill(0.0);
        for scan in self.scans.of_line(frame, showing, line) {
            let picture = read[scan.age.min(read.len() - 1)];
            let row = &picture[line as usize * self.columns..][..self.columns];
            self.amplifier.amplify(row, self.address(scan.field, line), video);
            let lit = light.iter_mut().zip(&video.video);
            lit.for_each(|(light, video)| *light += scan.share * self.law.light(*video));
        }
    }
}

#[cfg(test)]
mod tests;
