//! The storage tube between writing and reading: what is left of earlier pictures, spot, registration.

use std::iter::successors;

use hardware_model::MemoryParts;
use parts::{Spot, Spread, spot_sigma};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};

use crate::exposure::SATURATED;

/// Pictures that a tube remembers at most.
const MOST_FRAMES: usize = 16;

/// Residue that nobody sees: half a grey level of 255.
const UNSEEN: f64 = 0.5 / 255.0;

/// What is written on the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeRaster {
    /// Sweeps side by side.
    pub sweeps: usize,
    /// Cells of a sweep: values of a row.
    pub lines: usize,
    /// Width of the raster, in its heights.
    pub width: f64,
}

/// The tube, or the tubes that take turns.
#[derive(Debug, Clone)]
pub struct Tube {
    raster: TubeRaster,
    tubes: u64,
    residual: f64,
    memory_frames: usize,
    /// Across sweeps and along lines, of each tube; empty where reading is where writing was, and as fine.
    optics: Vec<[Spot; 2]>,
}

impl Tube {
    /// The tubes of `parts`; each has its registration error by `seed`.
    pub fn new(parts: &MemoryParts, raster: TubeRaster, seed: u64) -> Self {
        let tubes = u64::from(parts.tubes.max(1));
        let optics = |tube| optics(parts, &raster, &Spread::new(seed), tube);
        let is_sharp = parts.tv_lines.is_none() && parts.registration == 0.0;
        Self {
            raster,
            tubes,
            residual: parts.erase_residual,
            memory_frames: memory_frames(parts.erase_residual),
            optics: (0..tubes).filter(|_| !is_sharp).map(optics).collect(),
        }
    }

    /// Pictures before a frame's that count in it: what all others leave together is below half a grey level of 255,
    /// unless 16 are not enough for that.
    pub fn memory_frames(&self) -> usize {
        self.memory_frames
    }

    /// Frames whose pictures count in that of `frame`, nearest first: those before it in the same tube.
    pub fn earlier(&self, frame: u64) -> impl Iterator<Item = u64> + use<> {
        let tubes = self.tubes;
        successors(frame.checked_sub(tubes), move |frame| frame.checked_sub(tubes)).take(self.memory_frames)
    }

    /// Frames in whose pictures that of `frame` counts, the next first: those after it in the same tube.
    pub fn later(&self, frame: u64) -> impl Iterator<Item = u64> + use<> {
        let tubes = self.tubes;
        (1..=self.memory_frames as u64).map(move |number| frame + number * tubes)
    }

    /// Adds what erasing has left of `earlier`, without residue of their own, in the order of [`Tube::earlier`].
    pub fn combine(&self, store: &mut [f32], earlier: &[&[f32]]) {
        let mut left = 1.0;
        for picture in earlier {
            left *= self.residual;
            store.iter_mut().zip(*picture).for_each(|(value, before)| *value += left as f32 * before);
        }
    }

    /// What the reading beam finds of `store`, `lines` values a sweep, in its place; `scratch` holds nothing after.
    pub fn read(&self, frame: u64, store: &mut [f32], scratch: &mut Vec<f32>) {
        let Some([across, along]) = self.optics.get((frame % self.tubes) as usize) else { return };
        let lines = self.raster.lines;
        scratch.resize(store.len(), 0.0);
        let rows = scratch.par_chunks_exact_mut(lines).zip(store.par_chunks_exact(lines));
        rows.for_each(|(out, row)| along.along(row, out));
        let rows = store.par_chunks_exact_mut(lines).enumerate();
        rows.for_each(|(sweep, row)| across.across(sweep, scratch, row));
    }
}

impl TubeRaster {
    /// Where a tube of `parts` that is to be read at sweep and cell `place` in frame `frame` is read: beside it by the
    /// registration error that `seed` gives the tube. Centres are whole numbers.
    pub fn read_at(&self, parts: &MemoryParts, seed: u64, frame: u64, place: [f64; 2]) -> [f64; 2] {
        let tube = frame % u64::from(parts.tubes.max(1));
        let [across, along] = Registration::of(parts, self, &Spread::new(seed), tube);
        [across.at(place[0]), along.at(place[1])]
    }
}

/// Where one axis is read: beside where it was written.
#[derive(Debug, Clone, Copy)]
struct Registration {
    /// Of the middle (cells).
    shift: f64,
    /// Share of the way from the middle.
    scale: f64,
    middle: f64,
}

impl Registration {
    /// Across sweeps and along lines of tube `tube`.
    fn of(parts: &MemoryParts, raster: &TubeRaster, spread: &Spread, tube: u64) -> [Self; 2] {
        let axis = |names: [&str; 2], cells: usize, heights: f64| {
            let [shift, scale] = names.map(|part| spread.error(part, tube, parts.registration));
            Self { shift: shift * (cells as f64 / heights), scale, middle: 0.5 * (cells as f64 - 1.0) }
        };
        let [across, along] = REGISTRATION;
        [axis(across, raster.sweeps, raster.width), axis(along, raster.lines, 1.0)]
    }

    /// Where the beam reads that is to read `cell`.
    fn at(&self, cell: f64) -> f64 {
        cell + self.shift + self.scale * (cell - self.middle)
    }
}

/// Spot and registration of a tube.
fn optics(parts: &MemoryParts, raster: &TubeRaster, spread: &Spread, tube: u64) -> [Spot; 2] {
    let spot = parts.tv_lines.map_or(0.0, spot_sigma);
    let [across, along] = Registration::of(parts, raster, spread, tube);
    let axis = |cells: usize, heights: f64, registration: Registration| {
        Spot::new(cells, spot * (cells as f64 / heights), |cell| registration.at(cell))
    };
    [axis(raster.sweeps, raster.width, across), axis(raster.lines, 1.0, along)]
}

/// Shift and scale of the reading, across sweeps and along lines.
const REGISTRATION: [[&str; 2]; 2] = [
    ["sweep-memory.shift-across", "sweep-memory.scale-across"],
    ["sweep-memory.shift-along", "sweep-memory.scale-along"],
];

/// The fewest pictures beyond which all together leave less than [`UNSEEN`].
fn memory_frames(residual: f64) -> usize {
    if residual >= 1.0 {
        return MOST_FRAMES;
    }
    let mut left = f64::from(SATURATED) * residual / (1.0 - residual);
    let mut frames = 0;
    while left >= UNSEEN && frames < MOST_FRAMES {
        left *= residual;
        frames += 1;
    }
    frames
}

#[cfg(test)]
mod tests;
