//! What faces make of an area: light that they send, and what comes through from behind.

/// Light and transmission, each times an area (pixels squared).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mean {
    /// Light of the faces (linear red, green, blue).
    pub light: [f64; 3],
    /// Share of the light from behind them that comes through: red, green, blue.
    pub through: [f64; 3],
}

impl Mean {
    /// Both multiplied with a share.
    pub(crate) fn times(self, share: f64) -> Self {
        let [light, through] = [self.light, self.through].map(|values| values.map(|value| share * value));
        Self { light, through }
    }

    /// The sum over two areas.
    pub(crate) fn add(self, other: Self) -> Self {
        let sum = |a: [f64; 3], b: [f64; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
        Self { light: sum(self.light, other.light), through: sum(self.through, other.through) }
    }
}
