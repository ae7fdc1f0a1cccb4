//! Strokes of a group of sweeps, side by side: what [`Stroke::lit`], [`line_mean`] and [`centre`] do, eight at a time or, of two steps,
//! sixteen. In vectors, a lane whose `to` is not above its `from` draws nothing.

#[cfg(test)]
mod tests;

use fearless_simd::prelude::SimdSplit;
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, f32x8, f32x16, mask32x8};
use signal::{Comparable, LANES, Lanes, Number};

use crate::stroke::{Stroke, centre, integral, line_mean};

impl<F: Number> Stroke<F> {
    /// Returns the lanes that draw.
    #[inline(always)]
    pub fn draw<V: Simd>(&self) -> F::Mask
    where
        F: SimdFloat<V, Element = f32>,
    {
        self.to.simd_lt(self.from)
    }

    /// Those that lie in the picture, are lit, and touch at most two lines: nearly all.
    #[inline(always)]
    fn tell<V: Simd>(&self, simd: V, height: f32) -> Told<F, F::Mask>
    where
        F: SimdFloat<V, Element = f32>,
    {
        let Self { from, to, start, end } = *self;
        let splat = |value| F::splat(simd, value);
        let (zero, one, height) = (splat(0.0), splat(1.0), splat(height));
        let line = to.floor();
        let next = line + one;
        let inside = to.simd_ge(zero) & from.simd_le(height) & from.simd_le(next + one);
        let lit = start.simd_ge(zero) & end.simd_ge(zero);
        let draws = self.draw();
        let known = draws & inside & lit;
        Told { line, known, others: draws & !known & to.simd_lt(height) & from.simd_gt(zero) }
    }

    /// What strokes leave that are known.
    #[inline(always)]
    fn deposits<V: Simd>(&self, simd: V, Told { line, known, .. }: Told<F, F::Mask>) -> Deposits<F>
    where
        F: SimdFloat<V, Element = f32>,
    {
        let Self { from, to, start, end } = *self;
        let (zero, next) = (F::splat(simd, 0.0), line + F::splat(simd, 1.0));
        let crosses = from.simd_gt(next);
        let between = self.at(next);
        let whole = integral(start, end, from - to);
        // What the stroke is at its own end, rounding included.
        let upper = integral(between, start + (end - start), next - to);
        let lower = integral(start, between, from - next);
        Deposits {
            line,
            next,
            here: known.select(crosses.select(upper, whole), zero),
            below: (known & crosses).select(lower, zero),
        }
    }
}

impl<V: Simd> Stroke<f32x16<V>> {
    /// Adds the integrals of two steps side by side, the first of which is drawn first, as [`Stroke::leave_line_means`] does one
    /// after the other; `false`, and nothing is added, unless all lie in a few lines. So many lines are added to whatever lies
    /// in them: how many there are cannot be guessed.
    #[inline(always)]
    pub fn leave_both(&self, simd: V, lines: &mut [Lanes<f32>]) -> bool {
        let told = self.tell(simd, lines.len() as f32);
        if told.others.any_true() {
            return false;
        }
        let [first, last] = told.span(simd);
        if first > last {
            return true;
        }
        let few = if last - first > (FEW - 2) as f32 { None } else { lines.get_mut(first as usize..) };
        let Some(few) = few.and_then(|lines| lines.first_chunk_mut::<FEW>()) else { return false };
        let deposits = self.deposits(simd, told);
        let mut number = f32x16::splat(simd, first);
        for all in few {
            let (before, after) = deposits.on(simd, number).split();
            (f32x8::load_array(simd, all.0) + before + after).store_array(&mut all.0);
            number += 1.0;
        }
        true
    }
}

impl<V: Simd> Stroke<f32x8<V>> {
    /// The strokes of those lanes alone for which `keeps` is true.
    #[inline(always)]
    pub fn only(self, keeps: mask32x8<V>) -> Self {
        Self { to: keeps.select(self.to, self.from), ..self }
    }

    /// Adds each stroke's integral over each line that it touches to the lane of that line.
    #[inline(always)]
    pub fn leave_line_means(&self, simd: V, lines: &mut [Lanes<f32>]) {
        let told = self.tell(simd, lines.len() as f32);
        // Near ground is tall in all sweeps.
        if told.known.any_true() {
            self.deposits(simd, told).leave(simd, told.span(simd), lines);
        }
        if told.others.any_true() {
            let alone = self.leave_tall(simd, told.others, lines);
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
        let [zero, one, height] = [0.0, 1.0, lines.len() as f32].map(|value| f32x8::splat(simd, value));
        let lit = wanted & start.simd_ge(zero) & end.simd_ge(zero);
        let (bottom, top) = (height.at_most(from), to.at_least(zero));
        let first = lit.select(top, height).reduce_min().floor();
        let last = lit.select(bottom, zero).reduce_max();
        if last - first > TALL {
            return wanted;
        }
        // Where one line ends the next begins: one place and one intensity for both.
        let edge = |line: f32x8<V>| {
            let edge = line.at_least(top).at_most(bottom);
            (edge, self.at(edge))
        };
        let mut line = f32x8::splat(simd, first);
        let (mut upper, mut above) = edge(line);
        for all in lines[first as usize..].iter_mut().take((last - first).ceil() as usize) {
            line += one;
            let (lower, below) = edge(line);
            let value = (lit & lower.simd_gt(upper)).select(integral(below, above, lower - upper), zero);
            (f32x8::load_array(simd, all.0) + value).store_array(&mut all.0);
            (upper, above) = (lower, below);
        }
        wanted & !lit
    }

    /// Puts into each line whose centre a stroke passes, in the lane of the stroke, the intensity there.
    #[inline(always)]
    pub fn leave_centres(&self, simd: V, lines: &mut [Lanes<f32>]) {
        let Self { from, to, start, end } = *self;
        let [zero, half, height] = [0.0, 0.5, lines.len() as f32].map(|value| f32x8::splat(simd, value));
        let top = (to - half).ceil().at_least(zero);
        let passes = self.draw() & (top + half).simd_lt(from) & top.simd_lt(height);
        if !passes.any_true() {
            return;
        }
        let first = passes.select(top, height).reduce_min();
        let last = passes.select(from, zero).reduce_max();
        let together = passes & start.simd_ge(zero) & end.simd_ge(zero);
        let alone = if last - first < NEAR {
            let mut number = f32x8::splat(simd, first);
            for all in lines[first as usize..].iter_mut().take((last - first) as usize + 1) {
                let centre = number + half;
                let here = together & number.simd_ge(top) & centre.simd_lt(from);
                here.select(self.at(centre), f32x8::load_array(simd, all.0)).store_array(&mut all.0);
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

/// What is known of strokes before it is worked out what they leave.
#[derive(Clone, Copy)]
struct Told<F, M> {
    /// The line of the upper end.
    line: F,
    /// Strokes that leave something in that line and the one below it alone.
    known: M,
    /// Strokes that leave something and are not among them.
    others: M,
}

impl<F: Copy, M: Copy> Told<F, M> {
    /// The highest and the lowest line in which the upper end of a known stroke lies; infinite and below 0 without any.
    #[inline(always)]
    fn span<V: Simd>(&self, simd: V) -> [f32; 2]
    where
        F: SimdFloat<V, Element = f32, Mask = M>,
        M: Select<F>,
    {
        let bound = |value| F::splat(simd, value);
        let first = self.known.select(self.line, bound(f32::INFINITY)).reduce_min();
        [first, self.known.select(self.line, bound(-1.0)).reduce_max()]
    }
}

/// What strokes leave in the line of their upper end and in the one below it.
struct Deposits<F> {
    line: F,
    next: F,
    here: F,
    below: F,
}

impl<F: Copy> Deposits<F> {
    /// What they leave in the line of this number.
    #[inline(always)]
    fn on<V: Simd>(&self, simd: V, number: F) -> F
    where
        F: SimdFloat<V, Element = f32>,
    {
        let own = self.line.simd_eq(number).select(self.here, F::splat(simd, 0.0));
        self.next.simd_eq(number).select(self.below, own)
    }
}

/// Lines up to which neighbouring strokes are left line by line; if they lie farther apart, lane by lane.
const NEAR: f32 = 6.0;

/// The same of strokes that touch more than two lines: lane by lane they take longer.
const TALL: f32 = 40.0;

/// Lines that two steps of far ground mostly touch together.
const FEW: usize = 4;

impl<V: Simd> Deposits<f32x8<V>> {
    /// Leaves them, all lanes of a line together: neighbouring sweeps are mostly in the same line or nearly so.
    #[inline(always)]
    fn leave(self, simd: V, [first, last]: [f32; 2], lines: &mut [Lanes<f32>]) {
        if last - first >= NEAR {
            leave_apart([self.line, self.here, self.below].map(|part| part.to_array()), lines);
        } else {
            let mut number = f32x8::splat(simd, first);
            for all in lines[first as usize..].iter_mut().take((last - first) as usize + 2) {
                (f32x8::load_array(simd, all.0) + self.on(simd, number)).store_array(&mut all.0);
                number += 1.0;
            }
        }
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
