//! Sweeps as a fan ahead of the eye, and which of them a line crosses.

use fearless_simd::{Simd, SimdBase, SimdFloat, SimdMask, f64x8};
use remote_shadow::Segment;
use signal::{Comparable, Number};

/// Nearest place ahead of the eye that counts (m).
const NEAREST: f64 = 1e-6;

/// Lines that are looked at together.
pub(crate) const TOGETHER: usize = 8;

/// Lines that are told by the bits of a word: how many of eight may cross a sweep nobody can guess, of so many it matters less.
pub(crate) const WORD: usize = u64::BITS as usize;

/// A segment from the eye: north, east (m).
pub(crate) type Line = Segment;

/// Sweeps as they lie ahead: `tan` of the angle from the middle of the view.
pub(crate) struct Fan<'a> {
    directions: &'a [[f64; 2]],
    middle: [f64; 2],
    tangents: Vec<f64>,
    /// Sweeps for a unit of `tan`, on average: a first guess.
    density: f64,
    /// By how many sweeps the guess can be wrong, rounding included.
    doubt: f64,
}

/// Of corners, one after the other, what is known by a guess; used again from list to list.
#[derive(Debug, Default)]
pub(crate) struct Guesses {
    /// Where they are from the eye: north, east (m). Of a tile they are worked out but once.
    seen: [Vec<f64>; 2],
    /// How far ahead they are (m).
    ahead: Vec<f64>,
    /// Least and most sweeps to their left, where they are ahead.
    low: Vec<f64>,
    high: Vec<f64>,
}

/// What a guess is made of: see [`Fan`].
pub(crate) struct Guesser<V: Simd> {
    simd: V,
    middle: [f64x8<V>; 2],
    leftmost: f64x8<V>,
    density: f64x8<V>,
    doubt: f64x8<V>,
    /// None and all of them.
    sweeps: [f64x8<V>; 2],
}

/// What is known of a word of lines by a guess.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sifted {
    /// Those that may cross a sweep: a bit each.
    pub(crate) may_cross: u64,
    /// Those of which [`Guesses::left`] is known, and then whether they cross one: a bit each.
    pub(crate) known: u64,
}

impl<'a> Fan<'a> {
    /// `None` without sweeps, or if they open to half a turn or more.
    pub(crate) fn new(directions: &'a [[f64; 2]]) -> Option<Self> {
        let (first, last) = (directions.first()?, directions.last()?);
        let sum = [first[0] + last[0], first[1] + last[1]];
        let length = (sum[0] * sum[0] + sum[1] * sum[1]).sqrt();
        let middle = (length > NEAREST).then(|| sum.map(|part| part / length))?;
        let tangents: Vec<f64> = directions.iter().map(|&d| cross(middle, d) / dot(middle, d)).collect();
        let width = tangents[tangents.len() - 1] - tangents[0];
        let density = if width > 0.0 { (tangents.len() - 1) as f64 / width } else { 0.0 };
        let wrong = |(n, tangent): (usize, f64)| ((tangent - tangents[0]) * density - n as f64).abs();
        let doubt = tangents.iter().copied().enumerate().map(wrong).fold(0.0, f64::max) + 1e-6;
        Some(Self { directions, middle, tangents, density, doubt })
    }

    /// Who guesses where corners lie.
    #[inline(always)]
    pub(crate) fn guesser<V: Simd>(&self, simd: V) -> Guesser<V> {
        let splat = |value| f64x8::splat(simd, value);
        Guesser {
            simd,
            middle: self.middle.map(splat),
            leftmost: splat(self.tangents[0]),
            density: splat(self.density),
            doubt: splat(self.doubt),
            sweeps: [splat(0.0), splat(self.tangents.len() as f64)],
        }
    }

    /// Number of sweeps to the left of a place ahead.
    fn sweeps_left_of(&self, [ahead, across]: [f64; 2]) -> usize {
        let tangent = across / ahead;
        let guess = guess([ahead, across], self.tangents[0], self.density);
        let mut n = (guess.max(0.0) as usize).min(self.tangents.len());
        while n > 0 && self.tangents[n - 1] >= tangent {
            n -= 1;
        }
        while n < self.tangents.len() && self.tangents[n] < tangent {
            n += 1;
        }
        n
    }

    /// Sweeps to the left of the two ends, as far as the line lies ahead; `None` if it lies behind.
    pub(crate) fn span(&self, line: &Line) -> Option<[usize; 2]> {
        let [a, b] = [line.from, line.to].map(|end| [dot(self.middle, end), cross(self.middle, end)]);
        if a[0] < NEAREST && b[0] < NEAREST {
            return None;
        }
        Some([self.sweeps_left_of(clipped(a, b)), self.sweeps_left_of(clipped(b, a))])
    }

    /// Ground range at which a sweep crosses a line (m), at least 0.
    #[inline(always)]
    pub(crate) fn crossing(&self, sweep: usize, line: &Line) -> f64 {
        let direction = self.directions[sweep];
        let way = [line.to[0] - line.from[0], line.to[1] - line.from[1]];
        let range = cross(line.from, way) / cross(direction, way);
        let [a, b] = [line.from, line.to].map(|end| dot(direction, end));
        let [near, far] = if a < b { [a, b] } else { [b, a] };
        // A line almost along the sweep: rounding must not throw the crossing off it, nor that there is none.
        range.at_least(near).at_most(far).at_least(0.0)
    }
}

impl<V: Simd> Guesser<V> {
    /// Guesses at eight corners (north and east of the eye; m), of which the first is number `first`, into `out`.
    #[inline(always)]
    pub(crate) fn guess(&self, first: usize, seen: [[f64; TOGETHER]; 2], out: &mut Guesses) {
        let place = seen.map(|axis| f64x8::load_array(self.simd, axis));
        let (ahead, across) = (dot(self.middle, place), cross(self.middle, place));
        let guess = guess([ahead, across], self.leftmost, self.density);
        let (low, high) = ((guess - self.doubt).ceil(), (guess + self.doubt).ceil());
        let [none, all] = self.sweeps;
        for (axis, places) in out.seen.iter_mut().zip(seen) {
            axis[first..first + TOGETHER].copy_from_slice(&places);
        }
        ahead.store_slice(&mut out.ahead[first..first + TOGETHER]);
        low.max(none).min(all).store_slice(&mut out.low[first..first + TOGETHER]);
        high.max(none).min(all).store_slice(&mut out.high[first..first + TOGETHER]);
    }
}

impl Guesses {
    /// Makes room for `count` corners.
    pub(crate) fn make_room(&mut self, count: usize) {
        // Whoever looks at the last line looks at eight.
        let room = count.next_multiple_of(TOGETHER) + TOGETHER;
        let [north, east] = &mut self.seen;
        [north, east, &mut self.ahead, &mut self.low, &mut self.high]
            .into_iter()
            .for_each(|guesses| guesses.resize(room.max(guesses.len()), 0.0));
    }

    /// The line from corner `number` on.
    pub(crate) fn line(&self, number: usize) -> Line {
        let [from, to] = [number, number + 1].map(|n| [self.seen[0][n], self.seen[1][n]]);
        Line { from, to }
    }

    /// Sweeps to the left of where it begins and of where it ends, if that is known.
    pub(crate) fn left(&self, number: usize) -> [u32; 2] {
        [self.low[number] as u32, self.low[number + 1] as u32]
    }

    /// Of the `count` lines from corner `first` on, a word of them at most, each from one corner to the next, those that may cross
    /// a sweep.
    #[inline(always)]
    pub(crate) fn sift<V: Simd>(&self, simd: V, first: usize, count: usize) -> Sifted {
        let mut sifted = Sifted::default();
        for n in (0..count).step_by(TOGETHER) {
            let Sifted { may_cross, known } = self.sift_eight(simd, first + n);
            sifted.may_cross |= may_cross << n;
            sifted.known |= known << n;
        }
        sifted.may_cross &= !0 >> (WORD - count);
        sifted
    }

    #[inline(always)]
    fn sift_eight<V: Simd>(&self, simd: V, first: usize) -> Sifted {
        let ends =
            |guesses: &[f64]| [first, first + 1].map(|n| f64x8::from_slice(simd, &guesses[n..n + TOGETHER]));
        let ([from_ahead, to_ahead], [from_low, to_low]) = (ends(&self.ahead), ends(&self.low));
        let [from_high, to_high] = ends(&self.high);
        let nearest = f64x8::splat(simd, NEAREST);
        let ahead = from_ahead.simd_ge(nearest) & to_ahead.simd_ge(nearest);
        let behind = from_ahead.simd_lt(nearest) & to_ahead.simd_lt(nearest);
        let known = ahead & from_low.simd_eq(from_high) & to_low.simd_eq(to_high);
        let may_differ = from_low.simd_lt(to_high) | to_low.simd_lt(from_high);
        Sifted { may_cross: (!behind & (!ahead | may_differ)).to_bitmask(), known: known.to_bitmask() }
    }
}

/// `a` (ahead, across), or if it lies behind the place ahead where the line to `b` begins to count.
fn clipped(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    if a[0] >= NEAREST {
        return a;
    }
    let share = (NEAREST - a[0]) / (b[0] - a[0]);
    [NEAREST, a[1] + share * (b[1] - a[1])]
}

/// A first guess at the number of sweeps to the left of a place ahead, not rounded.
#[inline(always)]
fn guess<T: Number>([ahead, across]: [T; 2], leftmost: T, density: T) -> T {
    (across / ahead - leftmost) * density
}

#[inline(always)]
fn dot<T: Number>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

/// Above 0 if `b` lies to the right of `a`.
#[inline(always)]
fn cross<T: Number>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    use fearless_simd::{Level, dispatch};

    use super::{Fan, Guesses, Line, Sifted, TOGETHER, WORD};

    proptest! {
        /// The guess drops no line that a sweep crosses, in fans that are even in their tangents, in their angles or in neither.
        #[test]
        fn a_line_that_is_passed_by_crosses_no_sweep(
            sweeps in 1..60usize,
            half in 0.01..1.4f64,
            bend in -0.9..0.9f64,
            places in proptest::collection::vec([-9.0..9.0f64, -9.0..9.0f64, -1.5..1.5f64, -1.5..1.5f64], 50),
        ) {
            let direction = |n: usize| {
                let place = (2 * n) as f64 / (sweeps - 1).max(1) as f64 - 1.0;
                let (sin, cos) = quantities::sin_cos(half * (place + bend * (1.0 - place * place) * 0.5));
                [cos, sin]
            };
            let directions: Vec<[f64; 2]> = (0..sweeps).map(direction).collect();
            let fan = Fan::new(&directions).expect("less than half a turn");
            let corners: Vec<[f64; 2]> =
                places.iter().flat_map(|[x, y, way_x, way_y]| [[*x, *y], [x + way_x, y + way_y]]).collect();
            let seen = |first: usize| {
                let corner = |n: usize| corners[(first + n).min(corners.len() - 1)];
                [0, 1].map(|axis| std::array::from_fn(|n| corner(n)[axis]))
            };
            let by_force = |end: [f64; 2]| {
                let [ahead, across] = [super::dot(fan.middle, end), super::cross(fan.middle, end)];
                (ahead > 0.0).then(|| fan.tangents.iter().filter(|&&t| t < across / ahead).count())
            };
            for vectors in [Level::new(), Level::baseline()] {
                let mut guesses = Guesses::default();
                guesses.make_room(corners.len());
                for first in (0..corners.len()).step_by(TOGETHER) {
                    dispatch!(vectors, simd => fan.guesser(simd).guess(first, seen(first), &mut guesses));
                }
                for (number, line) in corners.windows(2).enumerate() {
                    let line = Line { from: line[0], to: line[1] };
                    let (Some(a), Some(b)) = (by_force(line.from), by_force(line.to)) else { continue };
                    prop_assert_eq!(fan.span(&line), Some([a, b]));
                    let (first, bit) = (number / WORD * WORD, number % WORD);
                    let count = WORD.min(corners.len() - 1 - first);
                    let Sifted { may_cross, known } =
                        dispatch!(vectors, simd => guesses.sift(simd, first, count));
                    prop_assert!(may_cross >> bit & 1 == 1 || a == b, "{line:?} crosses {a}..{b}");
                    let is_known = known >> bit & 1 == 1;
                    prop_assert!(!is_known || guesses.left(number) == [a as u32, b as u32]);
                    prop_assert!(!is_known || may_cross >> bit & 1 == u64::from(a != b));
                }
            }
        }
    }
}
