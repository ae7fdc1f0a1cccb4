//! The stack of every sampling point of a sub-area.

use raster::{DistancePlane, LARGEST_SIDE, Sampling, SubArea};

use crate::brightest::Brightest;
use crate::capacity::Capacity;
use crate::entry::Entry;
use crate::feature::{Feature, FeatureError, is_light};
use crate::nearest::Nearest;
use crate::places::Places;
use crate::shelf::Shelf;

/// Pixels of a row of sub-areas, as the numbers of pixels count them.
pub(crate) const SIDE: usize = LARGEST_SIDE as usize;

/// Stacks of the sampling points of one sub-area, used for sub-area after sub-area.
///
/// Pixels have the numbers of [`raster::Coverage`]: 8 times the row in the sub-area plus the column in it, 0 to 63. The sampling
/// point `i` of a pixel has the number `pixel * samples + i`.
#[derive(Debug, Clone)]
pub struct Stack {
    pub(crate) background: [f64; 3],
    pub(crate) places: Places,
    pub(crate) features: Vec<Feature>,
    pub(crate) brightest: Brightest,
    /// Nearest opaque feature of each sampling point.
    pub(crate) opaque: Nearest,
    /// Pixels whose shelves hold something of this sub-area, as bits; all others hold what an earlier one left.
    pub(crate) layered: u64,
    pub(crate) shelves: [Shelf; 2],
    pub(crate) is_shared: bool,
    /// Pixels of the sub-area, as bits, and its first and its last corner on the screen (pixels).
    pub(crate) pixels: u64,
    pub(crate) corners: [[f64; 2]; 2],
    /// How near (q, 1/m) all sampling points have an opaque feature or a lost one of each kind, at least: nothing of that kind shows behind it.
    pub(crate) floors: [f64; 2],
    /// The nearest feature without a slot, by kind, for each sampling point.
    pub(crate) lost: [Nearest; 2],
}

impl Stack {
    /// Stacks of a capacity over a background (linear red, green, blue, at least 0), for no sub-area yet.
    ///
    /// # Errors If a channel of the background is below 0 or not finite.
    pub fn new(sampling: Sampling, capacity: Capacity, background: [f64; 3]) -> Result<Self, FeatureError> {
        if let Some(&channel) = background.iter().find(|channel| !is_light(**channel)) {
            return Err(FeatureError::Background(channel));
        }
        let samples = SIDE * SIDE * sampling.count();
        let (slots, is_shared) = match capacity {
            Capacity::Separate { translucent, lights } => ([translucent, lights], false),
            Capacity::Shared(both) => ([both, Some(0)], true),
        };
        Ok(Self {
            background,
            places: Places::new(sampling),
            features: Vec::new(),
            brightest: Brightest::default(),
            opaque: Nearest::new(samples),
            layered: 0,
            shelves: slots.map(|capacity| Shelf::new(capacity, samples)),
            is_shared,
            pixels: 0,
            corners: [[0.0; 2]; 2],
            floors: [f64::NEG_INFINITY; 2],
            lost: [Nearest::new(samples), Nearest::new(samples)],
        })
    }

    /// Empties all stacks for a sub-area.
    pub fn start(&mut self, area: &SubArea) {
        self.places.start(area);
        self.features.clear();
        self.brightest = Brightest::default();
        self.opaque.clear(0..self.opaque.q.len());
        self.layered = 0;
        let (columns, rows) = (area.columns(), area.rows());
        self.corners =
            [[columns.start, rows.start], [columns.end, rows.end]].map(|corner| corner.map(f64::from));
        let row = u64::MAX >> (SIDE * SIDE - columns.len());
        self.pixels = (0..rows.len()).fold(0, |pixels, number| pixels | row << (SIDE * number));
        self.floors = [f64::NEG_INFINITY; 2];
    }

    /// Sampling points of a pixel, 1 to 32.
    pub fn samples(&self) -> usize {
        self.places.samples
    }

    /// Adds a feature where it covers sampling points: `pixels` has numbers of pixels and their bits, as [`raster::Coverage::pixels`] gives
    /// them. `plane` is the feature's distance; q is constant for a disc, infinite for what is fixed to the eye. A feature is not stored
    /// where its distance is no number.
    ///
    /// # Panics If the number of a pixel is above 63.
    pub fn add(
        &mut self,
        feature: Feature,
        plane: &DistancePlane,
        pixels: impl IntoIterator<Item = (usize, u32)>,
    ) {
        if feature.is_invisible() {
            return;
        }
        let kind = (!feature.is_opaque()).then(|| feature.kind() as usize);
        if let Some(kind) = kind {
            self.brightest.take_in(&feature);
            if self.nearest_of(plane) < self.floors[kind] {
                return;
            }
        }
        self.features.push(feature);
        let pixels = pixels.into_iter();
        match self.samples() {
            1 => self.add_in::<1>(plane, pixels),
            4 => self.add_in::<4>(plane, pixels),
            8 => self.add_in::<8>(plane, pixels),
            16 => self.add_in::<16>(plane, pixels),
            _ => self.add_in::<32>(plane, pixels),
        }
        if let Some(kind) = kind
            && self.layered & self.pixels == self.pixels
        {
            self.floors[kind] = self.floor(kind);
        }
    }

    /// How near (q, 1/m) a plane is in the sub-area at most; more where rounding might make it so.
    fn nearest_of(&self, plane: &DistancePlane) -> f64 {
        let [low, high] = self.corners;
        let largest = |axis: usize| (plane.slope[axis] * low[axis]).max(plane.slope[axis] * high[axis]);
        let size = |axis: usize| plane.slope[axis].abs() * high[axis];
        let slack = 1e-14 * (size(0) + size(1) + plane.origin.abs());
        largest(0) + largest(1) + plane.origin + slack
    }

    /// What [`Stack::floors`] says of a kind, where all pixels have their shelves.
    fn floor(&self, kind: usize) -> f64 {
        let of_pixel = |pixel: usize| {
            let samples = pixel * self.samples()..(pixel + 1) * self.samples();
            let pairs = self.lost[kind].q[samples.clone()].iter().zip(&self.opaque.q[samples]);
            pairs.fold(f64::INFINITY, |least, (lost, opaque)| least.min(lost.max(*opaque)))
        };
        let pixels = (0..SIDE * SIDE).filter(|pixel| self.pixels >> pixel & 1 == 1);
        pixels.map(of_pixel).fold(f64::INFINITY, f64::min)
    }

    /// Adds the last of the features.
    fn add_in<const N: usize>(&mut self, plane: &DistancePlane, pixels: impl Iterator<Item = (usize, u32)>) {
        let number = self.features.len() as u32 - 1;
        let is_opaque = self.features[number as usize].is_opaque();
        for (pixel, mask) in pixels {
            let mut distances = self.places.distances::<N>(pixel, plane);
            if mask != u32::MAX >> (u32::BITS - N as u32) {
                // What is no number is nearer than nothing.
                for i in 0..N {
                    distances[i] = if mask >> i & 1 == 1 { distances[i] } else { f64::NAN };
                }
            }
            if is_opaque {
                self.cover(pixel, &distances, number);
            } else {
                self.lay(pixel, &distances, number);
            }
        }
    }

    /// Takes an opaque feature where it is nearer than the one stored. What it hides stays on the shelves: it is passed over when
    /// the stack is read, because the nearest of a set before a distance are the nearest of the whole set.
    fn cover<const N: usize>(&mut self, pixel: usize, distances: &[f64; N], number: u32) {
        let first = pixel * N;
        let stored = &mut self.opaque.q[first..first + N];
        let opaque = &mut self.opaque.numbers[first..first + N];
        let mut is_equal = false;
        for i in 0..N {
            let is_nearer = distances[i] > stored[i];
            is_equal |= distances[i] == stored[i];
            stored[i] = if is_nearer { distances[i] } else { stored[i] };
            opaque[i] = if is_nearer { number } else { opaque[i] };
        }
        if is_equal {
            for i in 0..N {
                let entry = Entry { q: distances[i], number };
                let before = Entry { q: stored[i], number: opaque[i] };
                if entry.is_nearer(before, &self.features) {
                    opaque[i] = number;
                }
            }
        }
    }

    /// Puts a translucent feature on its shelf where it lies before the opaque one that is stored by now.
    fn lay<const N: usize>(&mut self, pixel: usize, distances: &[f64; N], number: u32) {
        let kind = self.features[number as usize].kind();
        let shelf = if self.is_shared { 0 } else { kind as usize };
        if self.is_layered(pixel) && self.pass_over(pixel, distances, number, shelf) {
            return;
        }
        for i in 0..N {
            let (sample, entry) = (pixel * N + i, Entry { q: distances[i], number });
            if !entry.is_nearer(self.opaque.of(sample), &self.features) {
                continue;
            }
            self.unroll(pixel);
            if let Some(lost) = self.shelves[shelf].insert(sample, entry, &self.features) {
                let kind = self.features[lost.number as usize].kind();
                self.lost[kind as usize].offer(sample, lost, &self.features);
            }
        }
    }

    /// Loses a feature all over a pixel whose shelves are full of what is nearer; `false` where that takes a closer look: a shelf has a slot
    /// for it, or something is equally near.
    fn pass_over<const N: usize>(
        &mut self,
        pixel: usize,
        distances: &[f64; N],
        number: u32,
        shelf: usize,
    ) -> bool {
        let first = pixel * N;
        let farthest = &self.shelves[shelf].farthest()[first..first + N];
        let opaque = &self.opaque.q[first..first + N];
        let Nearest { q, numbers } = &mut self.lost[self.features[number as usize].kind() as usize];
        let (q, numbers) = (&mut q[first..first + N], &mut numbers[first..first + N]);
        let mut is_plain = true;
        for i in 0..N {
            // What is no number lies nowhere.
            let is_near = distances[i] >= farthest[i];
            is_plain &= !is_near & (distances[i] != opaque[i]) & (distances[i] != q[i]);
        }
        if is_plain {
            for i in 0..N {
                let is_nearest = (distances[i] > opaque[i]) & (distances[i] > q[i]);
                q[i] = if is_nearest { distances[i] } else { q[i] };
                numbers[i] = if is_nearest { number } else { numbers[i] };
            }
        }
        is_plain
    }

    /// Empties the shelves of a pixel before its first use in this sub-area.
    fn unroll(&mut self, pixel: usize) {
        if !self.is_layered(pixel) {
            let samples = pixel * self.samples()..(pixel + 1) * self.samples();
            self.shelves.iter_mut().for_each(|shelf| shelf.clear(samples.clone()));
            self.lost.iter_mut().for_each(|lost| lost.clear(samples.clone()));
            self.layered |= 1 << pixel;
        }
    }
}
