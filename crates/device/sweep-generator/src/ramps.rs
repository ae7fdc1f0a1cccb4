//! Folded ramps: where they start, when they fold, where they are (sections 6.2 and 6.5).

use std::hint::select_unpredictable;

use sweep_program::{Fold, Ramp, RampAxis, Stop, SweepStart};

/// Start of a sweep whose foot is at `foot` (in regions from the corner lattice's origin) along `direction`
/// (cosine, sine of the azimuth against north): the start rule of 6.5, with absolute parity.
pub fn set_up(foot: [f64; 2], direction: [f64; 2]) -> SweepStart {
    let mut region = [0; 2];
    let ramps = std::array::from_fn(|axis| {
        let (k, ramp) = set_up_axis(foot[axis], direction[axis]);
        region[axis] = k;
        ramp
    });
    SweepStart { direction, region, ramps }
}

fn set_up_axis(foot: f64, cosine: f64) -> (i64, Ramp) {
    let floor = foot.floor();
    // On a boundary and moving down: the sweep starts at the far end of the region it moves into.
    let region = if foot == floor && cosine < 0.0 { floor - 1.0 } else { floor };
    let local = foot - region;
    let k = region as i64;
    let polarity = if k & 1 == 0 { 1.0 } else { -1.0 };
    let start = if k & 1 == 0 { local } else { 1.0 - local };
    (k, Ramp { start, rate: cosine * polarity, polarity })
}

/// Folds of one sweep in order of range, X before Y at one instant.
#[derive(Debug, Clone)]
pub(crate) struct Folds {
    x: AxisFolds,
    y: AxisFolds,
}

/// Folds of an axis that are placed together, so that none waits for a division: an even number.
const TOGETHER: usize = 8;

#[derive(Debug, Clone)]
struct AxisFolds {
    /// Way of the ramp to its first stop, 0..=1.
    first: f64,
    /// Magnitude of the rate.
    rate: f64,
    /// Whether a fold with an even number meets the stop at one.
    starts_at_one: bool,
    /// Folds before those of `ranges`.
    before: u32,
    /// Ranges of the next folds, in regions; infinite for a ramp that stands.
    ranges: [f64; TOGETHER],
    /// Folds of `ranges` that are past.
    past: usize,
}

impl Folds {
    /// Folds of a sweep that starts so.
    pub fn new(start: &SweepStart) -> Self {
        let [x, y] = &start.ramps;
        Self { x: AxisFolds::new(x), y: AxisFolds::new(y) }
    }

    /// The next fold and its range in regions: infinite if no ramp meets a stop any more.
    #[inline(always)]
    pub fn next_fold(&mut self) -> (f64, Fold) {
        let Self { x, y } = self;
        let (of_x, of_y) = (x.next_range(), y.next_range());
        // Chosen and added, not asked: nobody can guess which axis comes next.
        let is_y = of_y < of_x;
        let range = select_unpredictable(is_y, of_y, of_x);
        let is_at_one = select_unpredictable(is_y, y.is_at_one(), x.is_at_one());
        x.past += usize::from(!is_y);
        y.past += usize::from(is_y);
        let axis = [RampAxis::X, RampAxis::Y][usize::from(is_y)];
        (range, Fold { axis, stop: [Stop::Zero, Stop::One][usize::from(is_at_one)] })
    }
}

impl AxisFolds {
    fn new(ramp: &Ramp) -> Self {
        let (first, stop) = ramp.first_stop();
        let (rate, starts_at_one) = (ramp.rate.abs(), stop == Stop::One);
        let mut folds =
            Self { first, rate, starts_at_one, before: 0, ranges: [f64::INFINITY; TOGETHER], past: 0 };
        folds.place();
        folds
    }

    #[inline(always)]
    fn next_range(&mut self) -> f64 {
        if self.past >= TOGETHER {
            self.place_more();
        }
        self.ranges[self.past]
    }

    #[inline(always)]
    fn is_at_one(&self) -> bool {
        (self.past & 1 == 0) == self.starts_at_one
    }

    #[inline(never)]
    fn place_more(&mut self) {
        self.before += TOGETHER as u32;
        self.past = 0;
        self.place();
    }

    fn place(&mut self) {
        if self.rate != 0.0 {
            let before = f64::from(self.before);
            for (number, range) in self.ranges.iter_mut().enumerate() {
                *range = (self.first + (before + number as f64)) / self.rate;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::iter;

    use super::{Folds, set_up};
    use quantities::{radians, sin_cos};
    use sweep_program::{Fold, RampAxis, Stop, SweepStart};

    fn start(foot: [f64; 2], degrees: f64) -> SweepStart {
        let (sin, cos) = sin_cos(radians(degrees));
        set_up(foot, [cos, sin])
    }

    /// All folds and their ranges (in regions).
    fn placed(start: &SweepStart) -> impl Iterator<Item = (f64, Fold)> + use<> {
        let mut folds = Folds::new(start);
        iter::repeat_with(move || folds.next_fold()).take_while(|(range, _)| range.is_finite())
    }

    #[test]
    fn ramps_that_stand_never_fold() {
        assert_eq!(placed(&set_up([1.25, 2.5], [0.0, 0.0])).next(), None);
        let along_x: Vec<_> =
            placed(&set_up([1.25, 2.5], [1.0, 0.0])).take(2).map(|(range, _)| range).collect();
        assert_eq!(along_x, [0.75, 1.75]);
    }

    #[test]
    fn each_ramp_meets_its_stops_in_turns() {
        for degrees in [30.0, -160.0] {
            let mut last = [None; 2];
            for (_, Fold { axis, stop }) in placed(&start([2.3, 5.6], degrees)).take(100) {
                let before = last[axis as usize].replace(stop);
                assert_ne!(before, Some(stop), "{axis:?} at {degrees} degrees");
            }
        }
    }

    fn folds(start: &SweepStart, until: f64) -> Vec<(f64, RampAxis, Stop)> {
        placed(start)
            .take_while(|(range, _)| *range <= until)
            .map(|(range, fold)| (range, fold.axis, fold.stop))
            .collect()
    }

    /// On the lines x = 2 and y = 2, moving neither up nor down across them.
    #[test]
    fn along_a_boundary_the_region_is_the_one_beyond_it() {
        for way in [1.0, -1.0] {
            let found = [set_up([2.0, 3.5], [0.0, way]), set_up([3.5, 2.0], [way, 0.0])];
            assert_eq!(found.map(|start| start.region), [[2, 3], [3, 2]]);
            assert_eq!([found[0].ramps[0].start, found[1].ramps[1].start], [0.0; 2]);
        }
    }

    fn assert_folds(found: &[(f64, RampAxis, Stop)], expected: &[(f64, RampAxis, Stop)]) {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.0 - expected.0).abs() < 1e-11, "{found:?} against {expected:?}");
            assert_eq!((found.1, found.2), (expected.1, expected.2), "at {}", expected.0);
        }
    }

    use RampAxis::{X, Y};
    use Stop::{One, Zero};

    #[test]
    fn worked_fold_table_to_the_north_east() {
        let start = start([2.3, 5.6], 30.0);
        assert_eq!(start.region, [2, 5]);
        assert!((start.ramps[0].start - 0.3).abs() < 1e-15 && (start.ramps[1].start - 0.4).abs() < 1e-15);
        assert_eq!((start.ramps[0].polarity, start.ramps[1].polarity), (1.0, -1.0));
        let expected = [
            (0.8, Y, Zero),
            (0.808290376865, X, One),
            (1.962990915245, X, Zero),
            (2.8, Y, One),
            (3.117691453624, X, One),
            (4.272391992003, X, Zero),
        ];
        assert_folds(&folds(&start, 4.5), &expected);
    }

    #[test]
    fn worked_fold_table_to_the_south_west() {
        let start = start([13.75, 14.2], -160.0);
        let expected = [
            (0.584760880033, Y, Zero),
            (0.798133329357, X, One),
            (1.862311101833, X, Zero),
            (2.926488874309, X, One),
            (3.508565280196, Y, One),
            (3.990666646784, X, Zero),
        ];
        assert_folds(&folds(&start, 4.2), &expected);
    }

    #[test]
    fn through_corners_x_is_served_first() {
        let diagonal = (0.5f64).sqrt();
        let start = set_up([4.0, 4.0], [diagonal, diagonal]);
        let order: Vec<_> = folds(&start, 4.5).iter().map(|fold| (fold.1, fold.2)).collect();
        assert_eq!(order, [(X, One), (Y, One), (X, Zero), (Y, Zero), (X, One), (Y, One)]);
    }

    #[test]
    fn along_an_axis_the_other_stops_are_never_met() {
        let east = start([5.0, 7.0], 90.0);
        assert_eq!(east.ramps.map(|ramp| ramp.start), [1.0, 1.0]);
        assert_folds(&folds(&east, 3.5), &[(1.0, Y, Zero), (2.0, Y, One), (3.0, Y, Zero)]);
        let south = start([5.0, 7.5], 180.0);
        assert_eq!(south.region, [4, 7]);
        assert_folds(&folds(&south, 2.5), &[(1.0, X, Zero), (2.0, X, One)]);
    }

    #[test]
    fn ramps_are_the_triangle_of_the_place() {
        // Section 6.3: X is the distance of x/d to the nearest even integer.
        for (foot, degrees) in [([2.3, 5.6], 30.0), ([13.75, 14.2], -160.0), ([-3.2, 0.9], 251.0)] {
            let start = start(foot, degrees);
            for step in 0..400 {
                let lambda = f64::from(step) * 0.113;
                for axis in 0..2 {
                    let place = foot[axis] + lambda * start.direction[axis];
                    let triangle = (place - 2.0 * (place / 2.0).round()).abs();
                    let wanted = if axis == 0 { X } else { Y };
                    let passed = placed(&start).take_while(|(range, _)| *range < lambda);
                    let count = passed.filter(|(_, fold)| fold.axis == wanted).count() as u32;
                    let (value, _) = start.ramps[axis].at(count, lambda);
                    assert!((value - triangle).abs() < 1e-12, "{foot:?} {degrees} {lambda}");
                }
            }
        }
    }
}
