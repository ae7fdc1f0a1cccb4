//! What the stacks of a sub-area show: layers, colours, surfaces, losses.

use crate::entry::Entry;
use crate::feature::Feature;
use crate::layers::{Layer, Merged};
use crate::loss::{Loss, Losses};
use crate::stack::{SIDE, Stack};

impl Stack {
    /// Whether a translucent feature was put before the opaque one of a pixel (0 to 63).
    pub fn is_layered(&self, pixel: usize) -> bool {
        self.layered >> pixel & 1 == 1
    }

    /// Features that a sampling point shows, near to far; the last one is opaque, or the background is seen.
    ///
    /// # Panics If the number of the sampling point is not below 64 times that of a pixel.
    pub fn layers(&self, sample: usize) -> impl Iterator<Item = Layer<'_>> {
        let shelves = match self.is_layered(sample / self.samples()) {
            true => [self.shelves[0].of(sample), self.shelves[1].of(sample)],
            false => [&[][..]; 2],
        };
        Merged::new(&self.features, shelves, self.opaque.of(sample), self.middle(sample))
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
        if self.is_alike(pixel) {
            return self.colour_of_alike(pixel, weights);
        }
        samples.zip(weights).fold([0.0; 3], |sum, (sample, weight)| {
            let colour = self.colour_at(sample);
            std::array::from_fn(|channel| sum[channel] + weight * colour[channel])
        })
    }

    /// Whether the sampling points of a pixel have the same translucent surfaces in the same order, no lights, and all of them before what is
    /// opaque or was lost. `false` where it is not plain to see.
    fn is_alike(&self, pixel: usize) -> bool {
        let first = pixel * self.samples();
        let [shelf, lights] = &self.shelves;
        let numbers = |sample: usize| shelf.of(sample).iter().map(|entry| entry.number);
        let is_plain = |sample: usize| {
            let kept = shelf.of(sample).last().map_or(f64::INFINITY, |last| last.q);
            let [surface, light] = [0, 1].map(|kind| self.lost[kind].q[sample]);
            let farthest = if surface == Entry::NONE.q { kept } else { surface };
            let is_dark = lights.of(sample).is_empty() && light == Entry::NONE.q;
            is_dark && kept >= farthest && farthest > self.opaque.q[sample]
        };
        (first..first + self.samples()).all(|sample| is_plain(sample) && numbers(sample).eq(numbers(first)))
    }

    /// Light of the translucent surfaces of a sampling point of such a pixel, and the share that they let through.
    fn front(&self, sample: usize) -> ([f64; 3], f64) {
        let middle = self.middle(sample);
        self.shelves[0].of(sample).iter().fold(([0.0; 3], 1.0), |(colour, through), entry| {
            let feature = &self.features[entry.number as usize];
            let light = feature.light_at(middle);
            let colour = std::array::from_fn(|channel| colour[channel] + through * light[channel]);
            (colour, through * feature.translucency())
        })
    }

    /// Light of an opaque feature in a pixel, or the background.
    fn behind(&self, number: u32, pixel: usize) -> [f64; 3] {
        let feature = self.features.get(number as usize);
        feature.map_or(self.background, |feature| feature.light_at(self.places.middle(pixel)))
    }

    /// Colour of a pixel whose sampling points differ by what is opaque alone, to the bit as it is point by point.
    fn colour_of_alike(&self, pixel: usize, weights: &[f64]) -> [f64; 3] {
        let first = pixel * self.samples();
        let (front, through) = self.front(first);
        let colour_before = |number: u32| -> [f64; 3] {
            let behind = self.behind(number, pixel);
            std::array::from_fn(|channel| front[channel] + through * behind[channel])
        };
        let numbers = &self.opaque.numbers[first..first + self.samples()];
        let (mut sum, mut last) = ([0.0; 3], (numbers[0], colour_before(numbers[0])));
        for (&number, weight) in numbers.iter().zip(weights) {
            if number != last.0 {
                last = (number, colour_before(number));
            }
            sum = std::array::from_fn(|channel| sum[channel] + weight * last.1[channel]);
        }
        sum
    }

    /// The same of a pixel without translucent features.
    fn colour_of_opaque(&self, pixel: usize, weights: &[f64]) -> [f64; 3] {
        let opaque = &self.opaque.numbers[pixel * self.samples()..(pixel + 1) * self.samples()];
        let light = |number: u32| self.behind(number, pixel);
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
        self.found(self.opaque.of(sample))
    }

    /// Nearest opaque feature of a pixel with its q (1/m): the nearest of all its sampling points. `None` over the background.
    ///
    /// # Panics If the number of the pixel is above 63.
    pub fn surface(&self, pixel: usize) -> Option<(&Feature, f64)> {
        let samples = pixel * self.samples()..(pixel + 1) * self.samples();
        let nearer = |best: Entry, other: Entry| {
            if !other.is_none() && other.is_nearer(best, &self.features) { other } else { best }
        };
        self.found(samples.map(|sample| self.opaque.of(sample)).fold(Entry::NONE, nearer))
    }

    /// What a sampling point lost to the limits; `None` if nothing that would be seen.
    ///
    /// # Panics As [`Stack::layers`] does.
    pub fn loss_at(&self, sample: usize) -> Option<Loss<'_>> {
        if !self.is_layered(sample / self.samples()) {
            return None;
        }
        let opaque = self.opaque.of(sample);
        let is_seen = |entry: &Entry| !entry.is_none() && entry.is_nearer(opaque, &self.features);
        let seen = [0, 1].map(|kind| Some(self.lost[kind].of(sample)).filter(is_seen));
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
            let samples = pixel * self.samples()..(pixel + 1) * self.samples();
            if self.is_alike(pixel) {
                self.take_losses_of_alike(pixel, &mut losses);
                continue;
            }
            for sample in samples {
                if let Some(loss) = self.loss_at(sample) {
                    losses.take_in(&loss);
                }
            }
        }
        losses
    }

    /// Losses of a pixel whose sampling points differ by what is opaque alone.
    fn take_losses_of_alike(&self, pixel: usize, losses: &mut Losses) {
        let mut of_last = None;
        for sample in pixel * self.samples()..(pixel + 1) * self.samples() {
            let lost = self.lost[0].of(sample);
            if lost.is_none() {
                continue;
            }
            let behind = self.opaque.numbers[sample];
            let bound = match of_last {
                Some((number, bound)) if number == behind => bound,
                _ => {
                    let (_, through) = self.front(sample);
                    self.brightest.with(self.behind(behind, pixel)).map(|channel| through * channel)
                }
            };
            of_last = Some((behind, bound));
            losses.take_in(&Loss { nearest: [self.found(lost), None], bound });
        }
    }

    /// Middle of the pixel of a sampling point (pixels on the screen).
    fn middle(&self, sample: usize) -> [f64; 2] {
        self.places.middle(sample / self.samples())
    }

    fn found(&self, entry: Entry) -> Option<(&Feature, f64)> {
        (!entry.is_none()).then(|| (&self.features[entry.number as usize], entry.q))
    }
}
