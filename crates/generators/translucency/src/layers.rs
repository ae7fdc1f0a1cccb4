//! What a sampling point shows, from near to far.

use crate::entry::Entry;
use crate::feature::Feature;

/// One feature of a sampling point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layer<'a> {
    /// What covers the sampling point.
    pub feature: &'a Feature,
    /// How near it is: q = 1/w (1/m), infinite for what is fixed to the eye.
    pub q: f64,
    /// Light that it sends itself in the middle of the pixel (linear red, green, blue, at least 0).
    pub own_light: [f64; 3],
    /// Share of its light, 0 to 1, that nearer features let through: the product of their translucencies.
    pub through: f64,
}

impl Layer<'_> {
    /// Weight of the feature's colour in the claimed sum ("cumulative translucency"), 0 to 1.
    pub fn weight(&self) -> f64 {
        self.through * (1.0 - self.feature.translucency())
    }

    /// Share of light that this and all nearer features let through, 0 to 1.
    pub fn rest(&self) -> f64 {
        self.through * self.feature.translucency()
    }

    /// Light of it that reaches the eye (linear red, green, blue).
    pub fn light(&self) -> [f64; 3] {
        self.own_light.map(|light| self.through * light)
    }
}

/// Two shelves of a sampling point and its nearest opaque feature, in one order.
pub(crate) struct Merged<'a> {
    features: &'a [Feature],
    shelves: [&'a [Entry]; 2],
    opaque: Entry,
    /// Middle of the pixel (pixels on the screen).
    middle: [f64; 2],
    through: f64,
}

impl<'a> Merged<'a> {
    pub fn new(features: &'a [Feature], shelves: [&'a [Entry]; 2], opaque: Entry, middle: [f64; 2]) -> Self {
        Self { features, shelves, opaque, middle, through: 1.0 }
    }

    /// Takes the nearest entry that is left; what lies behind the opaque one is not seen.
    fn take(&mut self) -> Option<Entry> {
        let mut nearest = (self.opaque, None);
        for (number, shelf) in self.shelves.iter().enumerate() {
            if let Some(&first) = shelf.first()
                && first.is_nearer(nearest.0, self.features)
            {
                nearest = (first, Some(number));
            }
        }
        match nearest.1 {
            Some(number) => self.shelves[number] = &self.shelves[number][1..],
            None => (self.shelves, self.opaque) = ([&[][..]; 2], Entry::NONE),
        }
        (!nearest.0.is_none()).then_some(nearest.0)
    }
}

impl<'a> Iterator for Merged<'a> {
    type Item = Layer<'a>;

    fn next(&mut self) -> Option<Layer<'a>> {
        let entry = self.take()?;
        let feature = &self.features[entry.number as usize];
        let own_light = feature.light_at(self.middle);
        let layer = Layer { feature, q: entry.q, own_light, through: self.through };
        self.through = layer.rest();
        Some(layer)
    }
}
