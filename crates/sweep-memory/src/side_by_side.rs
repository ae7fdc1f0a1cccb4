//! Strokes of a group of sweeps, side by side: what [`Stroke::lit`], [`line_mean`] and [`centre`] do, eight at a time.

use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, f32x8, mask32x8};
use signal::{LANES, Lanes};

use crate::curve::CHORDS;
use crate::stroke::{Stroke, centre, line_mean};

/// A [`Stroke`] a lane; a lane whose `to` is not above its `from` draws nothing.
#[derive(Clone, Copy)]
pub(crate) struct Strokes<V: Simd> {
    pub from: f32x8<V>,
    pub to: f32x8<V>,
    pub start: f32x8<V>,
    pub end: f32x8<V>,
}

impl<V: Simd> Strokes<V> {
    /// Lanes that draw.
    #[inline(always)]
    pub fn draw(&self) -> mask32x8<V> {
        self.to.simd_lt(self.from)
    }

    /// The strokes of those lanes alone for which `keeps` is true.
    #[inline(always)]
    pub fn only(self, keeps: mask32x8<V>) -> Self {
        Self { to: keeps.select(self.to, self.from), ..self }
    }

    /// Adds each stroke's integral over each line that it touches to the lane of that line.
    #[inline(always)]
    pub fn leave_line_means(&self, simd: V, lines: &mut [Lanes<f32>]) {
        let others = self.deposits(simd, lines.len() as f32).leave(simd, lines);
        if others.any_true() {
            let alone = self.leave_tall(simd, others, lines);
            if alone.any_true() {
                self.each().leave_line_means(alone.to_bitmask(), lines);
            }
        }
    }

    /// The same line by line, for those of `wanted` that are lit as a whole; returns those that are not, or all if they lie too
    /// far apart.
    #[inline(always)]
    fn leave_tall(&self, simd: V, wanted: mask32x8<V>, lines: &mut [Lanes<f32>]) -> mask32x8<V> {
        let Self { from, to, start, end } = *self;
        let [zero, half, one, height] =
            [0.0, 0.5, 1.0, lines.len() as f32].map(|value| f32x8::splat(simd, value));
        let lit = wanted & start.simd_ge(zero) & end.simd_ge(zero);
        let bottom = height.simd_lt(from).select(height, from);
        let top = to.simd_gt(zero).select(to, zero);
        let first = lit.select(top, height).reduce_min().floor();
        let last = lit.select(bottom, zero).reduce_max();
        if last - first > TALL {
            return wanted;
        }
        let (whole, rise) = (from - to, end - start);
        let mut upper_end = f32x8::splat(simd, first);
        for all in lines[first as usize..].iter_mut().take((last - first).ceil() as usize) {
            let lower_end = upper_end + one;
            let lower = lower_end.simd_lt(bottom).select(lower_end, bottom);
            let upper = upper_end.simd_gt(top).select(upper_end, top);
            let below = start + (from - lower) / whole * rise;
            let above = start + (from - upper) / whole * rise;
            let value = (lit & lower.simd_gt(upper)).select(half * (below + above) * (lower - upper), zero);
            (f32x8::load_array(simd, all.0) + value).store_array(&mut all.0);
            upper_end = lower_end;
        }
        wanted & !lit
    }

    /// Puts into each line whose centre a stroke passes, in the lane of the stroke, the intensity there.
    #[inline(always)]
    pub fn leave_centres(&self, simd: V, lines: &mut [Lanes<f32>]) {
        let Self { from, to, start, end } = *self;
        let [zero, half, height] = [0.0, 0.5, lines.len() as f32].map(|value| f32x8::splat(simd, value));
        let top = (to - half).ceil();
        let top = top.simd_gt(zero).select(top, zero);
        let passes = self.draw() & (top + half).simd_lt(from) & top.simd_lt(height);
        if !passes.any_true() {
            return;
        }
        let first = passes.select(top, height).reduce_min();
        let last = passes.select(from, zero).reduce_max();
        let together = passes & start.simd_ge(zero) & end.simd_ge(zero);
        let alone = if last - first < NEAR {
            let (whole, rise) = (from - to, end - start);
            let mut number = f32x8::splat(simd, first);
            for all in lines[first as usize..].iter_mut().take((last - first) as usize + 1) {
                let centre = number + half;
                let here = together & number.simd_ge(top) & centre.simd_lt(from);
                let value = start + (from - centre) / whole * rise;
                here.select(value, f32x8::load_array(simd, all.0)).store_array(&mut all.0);
                number += f32x8::splat(simd, 1.0);
            }
            passes & !together
        } else {
            passes
        };
        if alone.any_true() {
            self.each().leave_centres(alone.to_bitmask(), lines);
        }
    }

    /// What strokes leave that lie in the picture, are lit, and touch at most two lines: nearly all.
    #[inline(always)]
    fn deposits(&self, simd: V, height: f32) -> Deposits<V> {
        let Self { from, to, start, end } = *self;
        let [zero, half, one, height] = [0.0, 0.5, 1.0, height].map(|value| f32x8::splat(simd, value));
        let line = to.floor();
        let next = line + one;
        let inside = to.simd_ge(zero) & from.simd_le(height) & from.simd_le(next + one);
        let lit = start.simd_ge(zero) & end.simd_ge(zero);
        let draws = self.draw();
        let known = draws & inside & lit;
        let crosses = from.simd_gt(next);
        let between = start + (from - next) / (from - to) * (end - start);
        let whole = half * (start + end) * (from - to);
        let upper = half * (between + (start + (end - start))) * (next - to);
        let lower = half * (start + between) * (from - next);
        Deposits {
            line,
            here: known.select(crosses.select(upper, whole), zero),
            below: (known & crosses).select(lower, zero),
            known,
            others: draws & !known & to.simd_lt(height) & from.simd_gt(zero),
        }
    }

    /// As they are lane by lane.
    #[inline(always)]
    fn each(&self) -> Each {
        let Self { from, to, start, end } = *self;
        Each([from, to, start, end].map(|part| part.to_array()))
    }
}

/// Strokes lane by lane: `from`, `to`, `start` and `end` of each.
struct Each([[f32; LANES]; 4]);

impl Each {
    /// The stroke of a lane, if it draws anything.
    fn lane(&self, lane: usize) -> Option<Stroke> {
        let [from, to, start, end] = self.0.map(|part| part[lane]);
        (to < from).then_some(Stroke { from, to, start, end })
    }

    /// The lit parts of those whose bit in `which` is 1, with their lanes.
    fn lit(&self, which: u64) -> impl Iterator<Item = (usize, Stroke)> {
        let wanted = (0..LANES).filter(move |lane| which >> lane & 1 == 1);
        wanted.filter_map(|lane| Some((lane, self.lane(lane)?.lit()?)))
    }

    #[inline(never)]
    fn leave_line_means(&self, which: u64, lines: &mut [Lanes<f32>]) {
        for (lane, stroke) in self.lit(which) {
            line_mean(stroke, lines.len(), |line, value| lines[line][lane] += value);
        }
    }

    #[inline(never)]
    fn leave_centres(&self, which: u64, lines: &mut [Lanes<f32>]) {
        for (lane, stroke) in self.lit(which) {
            centre(stroke, lines.len(), |line, value| lines[line][lane] = value);
        }
    }
}

/// What strokes leave in the line of their upper end and in the one below it.
struct Deposits<V: Simd> {
    line: f32x8<V>,
    here: f32x8<V>,
    below: f32x8<V>,
    /// Strokes that leave something and are among them.
    known: mask32x8<V>,
    /// Strokes that leave something and are not.
    others: mask32x8<V>,
}

/// Lines up to which neighbouring strokes are left line by line; if they lie farther apart, lane by lane.
const NEAR: f32 = 6.0;

/// The same of strokes that touch more than two lines: lane by lane they take longer.
const TALL: f32 = 40.0;

impl<V: Simd> Deposits<V> {
    /// Leaves them, all lanes of a line together: neighbouring sweeps are mostly in the same line or nearly so. Returns the
    /// others.
    #[inline(always)]
    fn leave(self, simd: V, lines: &mut [Lanes<f32>]) -> mask32x8<V> {
        let Self { line, here, below, known, others } = self;
        let bound = |value| f32x8::splat(simd, value);
        let first = known.select(line, bound(f32::INFINITY)).reduce_min();
        let last = known.select(line, bound(-1.0)).reduce_max();
        if last - first >= NEAR {
            leave_apart([line, here, below].map(|part| part.to_array()), lines);
        } else if first <= last {
            let mut number = bound(first);
            for all in lines[first as usize..].iter_mut().take((last - first) as usize + 2) {
                let own = line.simd_eq(number).select(here, bound(0.0));
                let add = (line + bound(1.0)).simd_eq(number).select(below, own);
                (f32x8::load_array(simd, all.0) + add).store_array(&mut all.0);
                number += bound(1.0);
            }
        }
        others
    }
}

#[inline(never)]
fn leave_apart([numbers, here, below]: [[f32; LANES]; 3], lines: &mut [Lanes<f32>]) {
    for lane in 0..LANES {
        let line = numbers[lane] as usize;
        for (line, value) in [(line, here[lane]), (line + 1, below[lane])] {
            if let Some(all) = lines.get_mut(line) {
                all[lane] += value;
            }
        }
    }
}

/// The cubic, in each lane, between the middle two of four equally spaced values whose slopes are those of their
/// neighbours.
#[derive(Clone, Copy)]
pub(crate) struct Cubic<V: Simd> {
    values: [f32x8<V>; 4],
}

impl<V: Simd> Cubic<V> {
    #[inline(always)]
    pub fn through(values: [f32x8<V>; 4]) -> Self {
        Self { values }
    }

    /// Largest second difference; not a number or infinite where a value is not finite.
    #[inline(always)]
    pub fn bend(&self, simd: V) -> f32x8<V> {
        let [a, b, c, d] = self.values;
        let [two, infinity] = [2.0, f32::INFINITY].map(|value| f32x8::splat(simd, value));
        let (first, last) = ((a - two * b + c).abs(), (b - two * c + d).abs());
        // A sum that is not finite is none, and greater than nothing.
        let largest = first.simd_gt(last).select(first, last);
        (first + last).simd_lt(infinity).select(largest, infinity)
    }

    /// Values at parts of the step, 0..=1.
    #[inline(always)]
    pub fn at(&self, simd: V, u: f32x8<V>) -> f32x8<V> {
        let [a, b, c, d] = self.values;
        let [half, two, three] = [0.5, 2.0, 3.0].map(|value| f32x8::splat(simd, value));
        let (first, last) = (half * (c - a), half * (d - b));
        let chord = c - b;
        b + u * (first + u * (three * chord - two * first - last + u * (first + last - two * chord)))
    }
}

/// Curved strokes as chords from the part `entry` of the step on; the beam never turns back.
#[inline(always)]
pub(crate) fn chords<V: Simd>(
    simd: V,
    position: &Cubic<V>,
    intensity: &Cubic<V>,
    whole: Strokes<V>,
    entry: f32x8<V>,
) -> [Strokes<V>; CHORDS as usize] {
    // A cubic overshoots at a step; no intensity is beyond full scale.
    let [least, most] = [-1.0, 1.0].map(|value| f32x8::splat(simd, value));
    let intensity = |u| within(intensity.at(simd, u), least, most);
    let way = most - entry;
    let (mut from, mut start) = (whole.from, intensity(entry));
    let mut chords = [whole; CHORDS as usize];
    for (number, chord) in (1..).zip(&mut chords) {
        if number < CHORDS {
            let u = entry + way * f32x8::splat(simd, number as f32) / f32x8::splat(simd, CHORDS as f32);
            chord.to = within(position.at(simd, u), whole.to, from);
            chord.end = intensity(u);
        }
        (chord.from, chord.start) = (from, start);
        (from, start) = (chord.to, chord.end);
    }
    chords
}

/// What is not a number stays so.
#[inline(always)]
fn within<V: Simd>(value: f32x8<V>, least: f32x8<V>, most: f32x8<V>) -> f32x8<V> {
    let above = value.simd_lt(least).select(least, value);
    above.simd_gt(most).select(most, above)
}

#[cfg(test)]
mod tests {
    use super::Strokes;
    use crate::stroke::{Stroke, centre, line_mean};
    use fearless_simd::{Level, SimdBase, dispatch, f32x8};
    use proptest::prelude::{Just, Strategy, any, prop_assert_eq, prop_oneof, proptest};
    use signal::{LANES, Lanes};

    const LINES: usize = 9;

    /// Lines in the picture and around it, some of them on a boundary of lines.
    fn line() -> impl Strategy<Value = f32> {
        prop_oneof![-3.0..12.0f32, (-2..12i32).prop_map(|line| line as f32), Just(-0.0)]
    }

    /// A stroke that is long, short or none.
    fn stroke() -> impl Strategy<Value = Stroke> {
        let way = prop_oneof![Just(0.0), 0.0..1.0f32, 0.0..4.0f32, Just(1.0), Just(2.0)];
        let light = || prop_oneof![0.0..1.0f32, -1.0..1.0f32, Just(0.0)];
        (line(), way, light(), light()).prop_map(|(to, way, start, end)| Stroke {
            from: to + way,
            to,
            start,
            end,
        })
    }

    proptest! {
        #[test]
        fn strokes_leave_what_each_leaves_alone(
            turns in proptest::collection::vec(proptest::collection::vec(stroke(), LANES), 1..6),
            near in any::<bool>(),
        ) {
            // Means, then centres.
            let mut together = [const { [[Lanes([0.0; LANES]); LINES]; 2] }; 2];
            let mut alone = vec![[[0.0; LINES]; 2]; LANES];
            for turn in &turns {
                // Neighbours are near one another, or anywhere.
                let stroke = |lane: usize| {
                    let Stroke { from, to, start, end } = turn[lane];
                    let shift = if near { turn[0].to.floor() - to.floor() } else { 0.0 };
                    Stroke { from: from + shift, to: to + shift, start, end }
                };
                let part = |of: fn(&Stroke) -> f32| std::array::from_fn(|lane| of(&stroke(lane)));
                let parts: [[f32; LANES]; 4] = [part(|s| s.from), part(|s| s.to), part(|s| s.start), part(|s| s.end)];
                for (vectors, lines) in [Level::new(), Level::baseline()].into_iter().zip(&mut together) {
                    dispatch!(vectors, simd => {
                        let [from, to, start, end] = parts.map(|part| f32x8::load_array(simd, part));
                        let strokes = Strokes { from, to, start, end };
                        strokes.leave_line_means(simd, &mut lines[0]);
                        strokes.leave_centres(simd, &mut lines[1]);
                    });
                }
                for (lane, [means, centres]) in alone.iter_mut().enumerate() {
                    if let Some(lit) = Some(stroke(lane)).filter(|s| s.to < s.from).and_then(Stroke::lit) {
                        line_mean(lit, LINES, |line, value| means[line] += value);
                        centre(lit, LINES, |line, value| centres[line] = value);
                    }
                }
            }
            for (lane, rows) in alone.iter().enumerate() {
                for (rule, row) in rows.iter().enumerate() {
                    for (line, value) in row.iter().enumerate() {
                        let found = together.map(|rules| rules[rule][line][lane].to_bits());
                        prop_assert_eq!(found, [value.to_bits(); 2]);
                    }
                }
            }
        }
    }
}
