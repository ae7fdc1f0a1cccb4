//! Elevation as a share of the field.

use signal::{LANES, Lanes, Real};

use crate::Deflection;

/// Largest share that leaves the divider: what lies further outside the picture is as good as there.
pub(crate) const LIMIT: f64 = 1.1;

/// A tangent below this is the end of the profile, and no ground.
const GONE: f64 = -1000.0;

/// Tangent of the elevation against its share of full scale, sweep by sweep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Field<S> {
    middle: Lanes<S>,
    half: Lanes<S>,
}

impl<S: Real> Field<S> {
    /// The field of a picture of `lines` lines.
    pub fn of(deflection: &[Deflection; LANES], lines: f64) -> Self {
        let spans = deflection.map(|deflection| span(&deflection, lines));
        let lanes = |part: usize| Lanes::from_fn(|lane| S::from_f64(spans[lane][part]));
        Self { middle: lanes(0), half: lanes(1) }
    }

    /// Turns tangents into shares, held within the limits, and says how many samples each profile has. Beyond its end
    /// a profile stays where it was.
    pub fn enter(&self, elevation: &mut [Lanes<S>]) -> [usize; LANES] {
        let ends = std::array::from_fn(|lane| {
            let gone = S::from_f64(GONE);
            elevation.iter().rposition(|value| value[lane] > gone).map_or(0, |last| last + 1)
        });
        for value in &mut *elevation {
            *value = ((*value - self.middle) / self.half).map(limited);
        }
        for (lane, &end) in ends.iter().enumerate() {
            let (profile, beyond) = elevation.split_at_mut(end);
            let last = profile.last().map_or(S::from_f64(-LIMIT), |last| last[lane]);
            beyond.iter_mut().for_each(|value| value[lane] = last);
        }
        ends
    }

    /// Turns shares into tangents.
    pub fn leave(&self, elevation: &mut [Lanes<S>]) {
        for value in elevation {
            *value = self.middle + self.half * *value;
        }
    }
}

/// Middle and half of the tangents between the edges of the picture: `Y = (a - b t) / (c + e t)` solved for t.
/// A sweep that does not run from the lower edge to the upper one (pitch beyond the zenith) has the plain tangent.
fn span(deflection: &Deflection, lines: f64) -> [f64; 2] {
    let Deflection { a, b, c, e } = *deflection;
    let tangent = |line: f64| (a - c * line) / (b + e * line);
    let (top, bottom) = (tangent(0.0), tangent(lines));
    let is_sound = top > bottom && top.is_finite() && bottom.is_finite();
    if is_sound { [0.5 * (top + bottom), 0.5 * (top - bottom)] } else { [0.0, 1.0] }
}

/// Within the limiter; what is not a number is at its lower end.
fn limited<S: Real>(share: S) -> S {
    let limit = S::from_f64(LIMIT);
    let share = share.at_least(-limit);
    if share > limit { limit } else { share }
}
