use super::FEW;
use crate::stroke::{Stroke, centre, line_mean};
use fearless_simd::prelude::SimdCombine;
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
                    let strokes = Stroke { from, to, start, end };
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

    /// Two steps together, or nothing of them where they are not few lines of known strokes.
    #[test]
    fn two_steps_leave_what_one_after_the_other_leaves(
        mut steps in proptest::collection::vec(proptest::collection::vec(stroke(), LANES), 2),
        near in any::<bool>(), lit in any::<bool>(), before in 0.0..1.0f32,
    ) {
        let place = steps[0][0].to.floor();
        for stroke in steps.iter_mut().flatten() {
            let shift = if near { place - stroke.to.floor() } else { 0.0 };
            (stroke.from, stroke.to) = (stroke.from + shift, stroke.to + shift);
            if lit {
                (stroke.start, stroke.end) = (stroke.start.abs(), stroke.end.abs());
            }
        }
        let draws = |s: &Stroke| s.to < s.from && s.to < LINES as f32 && s.from > 0.0;
        let is_known = |s: &Stroke| {
            let inside = s.to >= 0.0 && s.from <= (s.to.floor() + 2.0).min(LINES as f32);
            s.to < s.from && inside && s.start >= 0.0 && s.end >= 0.0
        };
        let lines = steps.iter().flatten().filter(|s| is_known(s)).map(|s| s.to.floor() as usize);
        let (first, last) = (lines.clone().min(), lines.max());
        let few = first.zip(last).is_none_or(|(first, last)| last - first <= FEW - 2 && first + FEW <= LINES);
        let expected = few && steps.iter().flatten().all(|s| is_known(s) || !draws(s));
        for vectors in [Level::new(), Level::baseline()] {
            let (mut both, mut each) = ([Lanes([before; LANES]); LINES], [Lanes([before; LANES]); LINES]);
            let told = dispatch!(vectors, simd => {
                let part = |of: fn(&Stroke) -> f32| {
                    [0, 1].map(|step| f32x8::load_array(simd, std::array::from_fn(|lane| of(&steps[step][lane]))))
                };
                let [from, to, start, end] = [part(|s| s.from), part(|s| s.to), part(|s| s.start), part(|s| s.end)];
                for step in 0..2 {
                    let strokes = Stroke { from: from[step], to: to[step], start: start[step], end: end[step] };
                    strokes.leave_line_means(simd, &mut each);
                }
                let [from, to, start, end] = [from, to, start, end].map(|[first, second]| first.combine(second));
                Stroke { from, to, start, end }.leave_both(simd, &mut both)
            });
            prop_assert_eq!(told, expected);
            let right = if told { each } else { [Lanes([before; LANES]); LINES] };
            prop_assert_eq!(both.map(|line| line.0.map(f32::to_bits)), right.map(|line| line.0.map(f32::to_bits)));
        }
    }
}
