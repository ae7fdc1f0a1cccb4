//! One comparator, drawn from the figures of its kind (hardware section 3.6).

use parts::{ComparatorLaw, Spread, Tolerance, relative_sigma};

use super::AnalogParts;

/// The longest delay of a comparator, in delays and in seconds: 500 ns of 40 ns.
const LONGEST: [f64; 2] = [12.5, 500e-9];

impl AnalogParts {
    /// Comparator number `index` of those called `part`, without noise; `spread` is that of the model's seed. One deviate
    /// makes it slow and in need of overdrive, another puts it off.
    pub fn comparator_law(&self, spread: &Spread, part: &str, index: u64) -> ComparatorLaw {
        let figures = &self.comparator;
        let sigma = if self.spread { relative_sigma::SWITCH_DELAY } else { 0.0 };
        let draw = |nominal: f64| spread.figure(part, index, &Tolerance { nominal, sigma });
        let delay = draw(figures.delay);
        ComparatorLaw {
            offset: spread.error(&format!("{part}.offset"), index, figures.offset / self.full_scale),
            hysteresis: figures.hysteresis,
            delay,
            overdrive: draw(figures.overdrive / self.full_scale),
            longest: (LONGEST[0] * delay).min(LONGEST[1].max(delay)),
            noise: 0.0,
        }
    }
}
