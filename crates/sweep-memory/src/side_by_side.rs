//! Strokes of a group of sweeps, side by side: what [`Stroke::lit`] and [`line_mean`] do, eight at a time.

use signal::{LANES, Lanes};

use crate::curve::CHORDS;
use crate::stroke::{Stroke, line_mean};

/// From here on the floats are the whole numbers: a smaller one added to it is rounded to a whole number, which then
/// stands in its lowest bits.
const WHOLE: f32 = 8_388_608.0;

/// A [`Stroke`] a lane; a lane whose `to` is not above its `from` draws nothing.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strokes {
    pub from: Lanes<f32>,
    pub to: Lanes<f32>,
    pub start: Lanes<f32>,
    pub end: Lanes<f32>,
}

impl Strokes {
    /// The stroke of a lane, if it draws anything.
    pub fn lane(&self, lane: usize) -> Option<Stroke> {
        let Self { from, to, start, end } = self;
        let stroke = Stroke { from: from[lane], to: to[lane], start: start[lane], end: end[lane] };
        (stroke.to < stroke.from).then_some(stroke)
    }

    /// The strokes of those lanes alone for which `keeps` is true.
    #[inline(always)]
    pub fn only(self, keeps: [bool; LANES]) -> Self {
        let to = Lanes::from_fn(|lane| if keeps[lane] { self.to[lane] } else { self.from[lane] });
        Self { to, ..self }
    }

    /// Adds each stroke's integral over each line that it touches to the row of its lane: `sweeps` rows of `lines` lines.
    #[inline(always)]
    pub fn leave_line_means(&self, [sweeps, lines]: [usize; 2], rows: &mut [f32]) {
        let Deposits { line, here, below, others } = self.deposits(lines as f32);
        for lane in 0..sweeps {
            let (row, line) = (lane * lines, line[lane] as usize);
            rows[row + line] += here[lane];
            rows[row + (line + 1).min(lines - 1)] += below[lane];
        }
        if others.contains(&true) {
            self.leave_others(others, lines, rows);
        }
    }

    /// What strokes leave that lie in the picture, are lit, and touch at most two lines: nearly all.
    #[inline(always)]
    fn deposits(&self, height: f32) -> Deposits {
        let mut out =
            Deposits { line: [0; LANES], here: [0.0; LANES], below: [0.0; LANES], others: [false; LANES] };
        for lane in 0..LANES {
            let [from, to] = [self.from[lane], self.to[lane]];
            let [start, end] = [self.start[lane], self.end[lane]];
            let nearest = to + WHOLE;
            let over = nearest - WHOLE > to;
            let line = nearest.to_bits().wrapping_sub(WHOLE.to_bits()).wrapping_sub(u32::from(over));
            let next = (nearest - WHOLE) + if over { 0.0 } else { 1.0 };
            let draws = to < from;
            let inside = (to >= 0.0) & (from <= height) & (from <= next + 1.0);
            let known = draws & inside & (start >= 0.0) & (end >= 0.0);
            let crosses = from > next;
            let between = start + (from - next) / (from - to) * (end - start);
            let whole = 0.5 * (start + end) * (from - to);
            let upper = 0.5 * (between + (start + (end - start))) * (next - to);
            let lower = 0.5 * (start + between) * (from - next);
            let here = if crosses { upper } else { whole };
            let below = if crosses { lower } else { 0.0 };
            out.line[lane] = if known { line } else { 0 };
            out.here[lane] = if known { here } else { 0.0 };
            out.below[lane] = if known { below } else { 0.0 };
            out.others[lane] = draws & !known;
        }
        out
    }

    #[inline(never)]
    fn leave_others(&self, others: [bool; LANES], lines: usize, rows: &mut [f32]) {
        for (lane, row) in rows.chunks_exact_mut(lines).enumerate() {
            let stroke = self.lane(lane).filter(|_| others[lane]);
            if let Some(stroke) = stroke.and_then(Stroke::lit) {
                line_mean(stroke, row);
            }
        }
    }
}

/// What strokes leave in the line of their upper end and in the one below it.
struct Deposits {
    line: [u32; LANES],
    here: [f32; LANES],
    below: [f32; LANES],
    /// Strokes that are not among them.
    others: [bool; LANES],
}

/// The cubic, in each lane, between the middle two of four equally spaced values whose slopes are those of their
/// neighbours.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cubic {
    values: [Lanes<f32>; 4],
}

impl Cubic {
    pub fn through(values: [Lanes<f32>; 4]) -> Self {
        Self { values }
    }

    /// Largest second difference; not a number or infinite where a value is not finite.
    #[inline(always)]
    pub fn bend(&self) -> Lanes<f32> {
        let [a, b, c, d] = self.values;
        Lanes::from_fn(|lane| {
            let [a, b, c, d] = [a, b, c, d].map(|value| value[lane]);
            let (first, last) = ((a - 2.0 * b + c).abs(), (b - 2.0 * c + d).abs());
            // A sum that is not finite is none, and greater than nothing.
            let largest = if first > last { first } else { last };
            if (first + last) < f32::INFINITY { largest } else { f32::INFINITY }
        })
    }

    /// Values at parts of the step, 0..=1.
    #[inline(always)]
    pub fn at(&self, u: Lanes<f32>) -> Lanes<f32> {
        let [a, b, c, d] = self.values;
        let [half, two, three] = [0.5, 2.0, 3.0].map(Lanes::splat);
        let (first, last) = (half * (c - a), half * (d - b));
        let chord = c - b;
        b + u * (first + u * (three * chord - two * first - last + u * (first + last - two * chord)))
    }
}

/// Curved strokes as chords from the part `entry` of the step on; the beam never turns back.
#[inline(always)]
pub(crate) fn chords(
    position: &Cubic,
    intensity: &Cubic,
    whole: Strokes,
    entry: Lanes<f32>,
    mut draw: impl FnMut(&Strokes),
) {
    // A cubic overshoots at a step; no intensity is beyond full scale.
    let intensity = |u| intensity.at(u).map(|value| value.clamp(-1.0, 1.0));
    let way = Lanes::splat(1.0) - entry;
    let (mut from, mut start) = (whole.from, intensity(entry));
    for chord in 1..=CHORDS {
        let u = entry + way * Lanes::splat(chord as f32) / Lanes::splat(CHORDS as f32);
        let (to, end) = if chord == CHORDS {
            (whole.to, whole.end)
        } else {
            let place = position.at(u);
            let held = |lane: usize| {
                let below = if place[lane] < whole.to[lane] { whole.to[lane] } else { place[lane] };
                if below > from[lane] { from[lane] } else { below }
            };
            (Lanes::from_fn(held), intensity(u))
        };
        draw(&Strokes { from, to, start, end });
        (from, start) = (to, end);
    }
}

#[cfg(test)]
mod tests {
    use super::Strokes;
    use crate::stroke::{Stroke, line_mean};
    use proptest::prelude::{Just, Strategy, prop_assert_eq, prop_oneof, proptest};
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
            sweeps in 1..=LANES,
        ) {
            let (mut together, mut alone) = (vec![0.0; sweeps * LINES], vec![0.0; sweeps * LINES]);
            for turn in &turns {
                let part = |of: fn(&Stroke) -> f32| Lanes::from_fn(|lane| of(&turn[lane]));
                let strokes = Strokes {
                    from: part(|s| s.from), to: part(|s| s.to), start: part(|s| s.start), end: part(|s| s.end),
                };
                strokes.leave_line_means([sweeps, LINES], &mut together);
                for (stroke, row) in turn.iter().zip(alone.chunks_exact_mut(LINES)) {
                    if let Some(lit) = Some(*stroke).filter(|s| s.to < s.from).and_then(Stroke::lit) {
                        line_mean(lit, row);
                    }
                }
            }
            let bits = |rows: &[f32]| rows.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&together), bits(&alone));
        }
    }
}
