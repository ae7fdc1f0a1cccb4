//! The stack of every sampling point of a sub-area.

use raster::{DistancePlane, LARGEST_SIDE, Sampling, SubArea};

use crate::brightest::Brightest;
use crate::capacity::Capacity;
use crate::entry::Entry;
use crate::feature::{Feature, FeatureError, is_light};
use crate::layers::{Layer, Merged};
use crate::loss::{Loss, Losses};
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
    background: [f64; 3],
    places: Places,
    features: Vec<Feature>,
    brightest: Brightest,
    /// Nearest opaque features: q of each sampling point (1/m), and the number of the feature.
    distances: Vec<f64>,
    opaque: Vec<u32>,
    /// Pixels whose shelves hold something of this sub-area, as bits; all others hold what an earlier one left.
    layered: u64,
    shelves: [Shelf; 2],
    is_shared: bool,
    /// The nearest feature without a slot, by kind, for each sampling point.
    lost: [Vec<Entry>; 2],
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
            distances: vec![Entry::NONE.q; samples],
            opaque: vec![Entry::NONE.number; samples],
            layered: 0,
            shelves: slots.map(|capacity| Shelf::new(capacity, samples)),
            is_shared,
            lost: [vec![Entry::NONE; samples], vec![Entry::NONE; samples]],
        })
    }

    /// Empties all stacks for a sub-area.
    pub fn start(&mut self, area: &SubArea) {
        self.places.start(area);
        self.features.clear();
        self.brightest = Brightest::default();
        self.distances.fill(Entry::NONE.q);
        self.opaque.fill(Entry::NONE.number);
        self.layered = 0;
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
        if !feature.is_opaque() {
            self.brightest.take_in(&feature);
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
        let stored = &mut self.distances[first..first + N];
        let opaque = &mut self.opaque[first..first + N];
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
        for i in 0..N {
            let (sample, entry) = (pixel * N + i, Entry { q: distances[i], number });
            if !entry.is_nearer(self.opaque(sample), &self.features) {
                continue;
            }
            self.unroll(pixel);
            if let Some(lost) = self.shelves[shelf].insert(sample, entry, &self.features) {
                self.lose(sample, lost);
            }
        }
    }

    /// Empties the shelves of a pixel before its first use in this sub-area.
    fn unroll(&mut self, pixel: usize) {
        if !self.is_layered(pixel) {
            let samples = pixel * self.samples()..(pixel + 1) * self.samples();
            self.shelves.iter_mut().for_each(|shelf| shelf.clear(samples.clone()));
            self.lost.iter_mut().for_each(|lost| lost[samples.clone()].fill(Entry::NONE));
            self.layered |= 1 << pixel;
        }
    }

    /// Remembers the nearest of what found no slot.
    fn lose(&mut self, sample: usize, entry: Entry) {
        let kind = self.features[entry.number as usize].kind();
        let nearest = &mut self.lost[kind as usize][sample];
        if entry.is_nearer(*nearest, &self.features) {
            *nearest = entry;
        }
    }

    /// Whether a translucent feature was put before the opaque one of a pixel (0 to 63).
    pub fn is_layered(&self, pixel: usize) -> bool {
        self.layered >> pixel & 1 == 1
    }

    /// Nearest opaque feature of a sampling point, or none.
    fn opaque(&self, sample: usize) -> Entry {
        Entry { q: self.distances[sample], number: self.opaque[sample] }
    }

    /// Features that a sampling point shows, near to far; the last one is opaque, or the background is seen.
    ///
    /// # Panics If the number of the sampling point is not below 64 times that of a pixel.
    pub fn layers(&self, sample: usize) -> impl Iterator<Item = Layer<'_>> {
        let shelves = match self.is_layered(sample / self.samples()) {
            true => [self.shelves[0].of(sample), self.shelves[1].of(sample)],
            false => [&[][..]; 2],
        };
        Merged::new(&self.features, shelves, self.opaque(sample), self.middle(sample))
    }

    /// Share of light (0 to 1) of something at distance `q` (1/m) that reaches the eye at a sampling point: the product of nearer
    /// translucencies, 0 behind an opaque feature. `feature` says who is nearer at the same distance.
    ///
    /// # Panics As [`Stack::layers`] does.
    pub fn through(&self, sample: usize, q: f64, feature: &Feature) -> f64 {
        let is_before = |layer: &Layer<'_>| {
            let order = || layer.feature.order_at_one_distance(feature);
            layer.q > q || layer.q == q && order().is_lt()
        };
        self.layers(sample).take_while(is_before).fold(1.0, |_, layer| layer.rest())
    }

    /// Colour of a sampling point (linear red, green, blue).
    ///
    /// # Panics As [`Stack::layers`] does.
    pub fn colour_at(&self, sample: usize) -> [f64; 3] {
        let (mut colour, mut rest) = ([0.0; 3], 1.0);
        for layer in self.layers(sample) {
            let light = layer.light();
            colour = std::array::from_fn(|channel| colour[channel] + light[channel]);
            rest = layer.rest();
        }
        std::array::from_fn(|channel| colour[channel] + rest * self.background[channel])
    }

    /// Colour of the sampling points of a pixel, summed with weights: those of [`raster::Weights::of`], of the pixel itself or of the
    /// place that it has beside another. Of a pixel that is one opaque feature the bits are those of one point times all weights.
    ///
    /// # Panics If the number of the pixel is above 63, or the weights are not as many as the sampling points.
    pub fn colour(&self, pixel: usize, weights: &[f64]) -> [f64; 3] {
        let samples = pixel * self.samples()..(pixel + 1) * self.samples();
        assert_eq!(weights.len(), samples.len(), "a weight for each sampling point");
        if !self.is_layered(pixel) {
            return self.colour_of_opaque(pixel, weights);
        }
        samples.zip(weights).fold([0.0; 3], |sum, (sample, weight)| {
            let colour = self.colour_at(sample);
            std::array::from_fn(|channel| sum[channel] + weight * colour[channel])
        })
    }

    /// The same of a pixel without translucent features.
    fn colour_of_opaque(&self, pixel: usize, weights: &[f64]) -> [f64; 3] {
        let opaque = &self.opaque[pixel * self.samples()..(pixel + 1) * self.samples()];
        let middle = self.places.middle(pixel);
        let light = |number: u32| match self.features.get(number as usize) {
            Some(feature) => feature.light_at(middle),
            None => self.background,
        };
        let times = |weight: f64, [red, green, blue]: [f64; 3]| [weight * red, weight * green, weight * blue];
        if opaque.iter().all(|&number| number == opaque[0]) {
            return times(weights.iter().sum(), light(opaque[0]));
        }
        let (mut sum, mut last) = ([0.0; 3], (opaque[0], light(opaque[0])));
        for (&number, &weight) in opaque.iter().zip(weights) {
            if number != last.0 {
                last = (number, light(number));
            }
            let [red, green, blue] = times(weight, last.1);
            sum = [sum[0] + red, sum[1] + green, sum[2] + blue];
        }
        sum
    }

    /// Nearest opaque feature of a sampling point with its q (1/m); `None` over the background.
    ///
    /// # Panics As [`Stack::layers`] does.
    pub fn surface_at(&self, sample: usize) -> Option<(&Feature, f64)> {
        self.found(self.opaque(sample))
    }

    /// Nearest opaque feature of a pixel with its q (1/m): the nearest of all its sampling points. `None` over the background.
    ///
    /// # Panics If the number of the pixel is above 63.
    pub fn surface(&self, pixel: usize) -> Option<(&Feature, f64)> {
        let samples = pixel * self.samples()..(pixel + 1) * self.samples();
        let nearer = |best: Entry, other: Entry| {
            if !other.is_none() && other.is_nearer(best, &self.features) { other } else { best }
        };
        self.found(samples.map(|sample| self.opaque(sample)).fold(Entry::NONE, nearer))
    }

    /// What a sampling point lost to the limits; `None` if nothing that would be seen.
    ///
    /// # Panics As [`Stack::layers`] does.
    pub fn loss_at(&self, sample: usize) -> Option<Loss<'_>> {
        if !self.is_layered(sample / self.samples()) {
            return None;
        }
        let opaque = self.opaque(sample);
        let is_seen = |entry: &Entry| !entry.is_none() && entry.is_nearer(opaque, &self.features);
        let seen = [0, 1].map(|kind| Some(self.lost[kind][sample]).filter(is_seen));
        let nearer = |a: Entry, b: Entry| if a.is_nearer(b, &self.features) { a } else { b };
        let first = seen.into_iter().flatten().reduce(nearer)?;
        let behind = self.found(opaque).map(|(feature, _)| feature.light_at(self.middle(sample)));
        let behind = behind.unwrap_or(self.background);
        let through = self.through(sample, first.q, &self.features[first.number as usize]);
        let bound = self.brightest.with(behind).map(|channel| through * channel);
        Some(Loss { nearest: seen.map(|entry| entry.and_then(|entry| self.found(entry))), bound })
    }

    /// What the sub-area lost to the limits.
    pub fn losses(&self) -> Losses {
        let mut losses = Losses::default();
        for pixel in (0..SIDE * SIDE).filter(|&pixel| self.is_layered(pixel)) {
            for sample in pixel * self.samples()..(pixel + 1) * self.samples() {
                if let Some(loss) = self.loss_at(sample) {
                    losses.take_in(&loss);
                }
            }
        }
        losses
    }

    /// Middle of the pixel of a sampling point (pixels on the screen).
    fn middle(&self, sample: usize) -> [f64; 2] {
        self.places.middle(sample / self.samples())
    }

    fn found(&self, entry: Entry) -> Option<(&Feature, f64)> {
        (!entry.is_none()).then(|| (&self.features[entry.number as usize], entry.q))
    }
}
