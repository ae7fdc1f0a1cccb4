//! The fade of a switch over a sweep: how much of its second input is through.
//!
//! **Law** (section 6: linear cross-fade t_vs). A toggle makes g run in a straight line from 0 to 1, or back, over the
//! transition, from wherever it is, and is the middle of it: the fade begins half a transition before.
//! **Parameters.** Transition in steps, 0 or more; an endless one never moves.
//! **State and timing.** A list of knots on the sweep clock, between which g is straight; of no transition two at one
//! instant. Its buffer is used again from sweep to sweep.
//! **Our choices.** The toggle as the middle: whatever a part needs from its command to there is in the delay that the
//! caller adds, so a switch that is slower displaces nothing.

/// g over one sweep.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Fade {
    start: f64,
    knots: Vec<[f64; 2]>,
}

impl Fade {
    /// Follows a gate that is `open` as the sweep begins and changes at `toggles` (steps, ascending).
    pub fn follow(&mut self, open: bool, toggles: impl Iterator<Item = f64>, transition: f64) {
        self.knots.clear();
        self.start = f64::from(u8::from(open));
        if transition == f64::INFINITY {
            return;
        }
        let (mut g, mut target) = (self.start, self.start);
        for toggle in toggles {
            let begin = toggle - 0.5 * transition;
            g = self.run(g, target, transition, begin);
            target = 1.0 - target;
            self.knots.push([begin, g]);
        }
        self.run(g, target, transition, f64::INFINITY);
    }

    /// Goes on from the last knot towards `target` until `end`; the value there.
    fn run(&mut self, g: f64, target: f64, transition: f64, end: f64) -> f64 {
        let Some(&[begin, _]) = self.knots.last() else { return g };
        let arrival = begin + (target - g).abs() * transition;
        if arrival <= end {
            self.knots.push([arrival, target]);
            return target;
        }
        g + (target - g).signum() * (end - begin) / transition
    }

    /// Instants (steps) and values between which g is straight, ascending; before the first and behind the last it stands.
    pub fn knots(&self) -> &[[f64; 2]] {
        &self.knots
    }

    /// g at the samples 0 to `samples - 1`, just after each.
    pub fn sample(&self, samples: usize, mut put: impl FnMut(usize, f64)) {
        let (mut next, mut from) = (0, [0.0, self.start]);
        for sample in 0..samples {
            let time = sample as f64;
            while let Some(&knot) = self.knots.get(next).filter(|knot| knot[0] <= time) {
                (next, from) = (next + 1, knot);
            }
            let [begin, g] = from;
            put(
                sample,
                match self.knots.get(next) {
                    Some(&[end, target]) if next > 0 => g + (target - g) * ((time - begin) / (end - begin)),
                    _ => g,
                },
            );
        }
    }

    /// g at `time` (steps) just before and just after it.
    pub fn at(&self, time: f64) -> [f64; 2] {
        self.before(self.knots.partition_point(|knot| knot[0] < time), time)
    }

    /// The same, `first` being the first knot that is not before `time`.
    fn before(&self, first: usize, time: f64) -> [f64; 2] {
        let on = self.knots[first..].iter().take_while(|knot| knot[0] <= time).count();
        if on > 0 {
            // On a knot: its own value, or of two at one instant one each.
            return [self.knots[first][1], self.knots[first + on - 1][1]];
        }
        let g = match (first.checked_sub(1).map(|last| self.knots[last]), self.knots.get(first)) {
            (None, _) => self.start,
            (Some([_, g]), None) => g,
            (Some([from, g]), Some(&[to, target])) => g + (target - g) * ((time - from) / (to - from)),
        };
        [g; 2]
    }
}

/// A fade as time goes on: what [`Fade::at`] finds, without a search.
#[derive(Debug, Clone)]
pub struct NearFade<'a> {
    fade: &'a Fade,
    /// Knots that have been passed.
    passed: usize,
}

impl<'a> NearFade<'a> {
    /// From the start of the sweep.
    pub fn new(fade: &'a Fade) -> Self {
        Self { fade, passed: 0 }
    }

    /// g at `time` (steps) just before and just after it; not earlier than it was asked for before.
    #[inline]
    pub fn at(&mut self, time: f64) -> [f64; 2] {
        while self.fade.knots.get(self.passed).is_some_and(|knot| knot[0] < time) {
            self.passed += 1;
        }
        self.fade.before(self.passed, time)
    }
}

#[cfg(test)]
mod tests {
    use super::{Fade, NearFade};

    fn fade(open: bool, toggles: &[f64], transition: f64) -> Fade {
        let mut fade = Fade::default();
        fade.follow(open, toggles.iter().copied(), transition);
        fade
    }

    #[test]
    fn the_toggle_is_the_middle_of_a_straight_line() {
        let fade = fade(false, &[20.5, 40.0], 6.0);
        assert_eq!(fade.knots(), [[17.5, 0.0], [23.5, 1.0], [37.0, 1.0], [43.0, 0.0]]);
        assert_eq!(
            [fade.at(0.0), fade.at(20.5), fade.at(30.0), fade.at(99.0)],
            [[0.0; 2], [0.5; 2], [1.0; 2], [0.0; 2]]
        );
        assert_eq!(fade.at(17.5), [0.0; 2]);
    }

    #[test]
    fn at_the_samples_it_is_what_it_is_just_after_them() {
        for (open, transition) in [(false, 6.0), (true, 0.0), (false, 2.5)] {
            let fade = fade(open, &[2.0, 7.25, 8.5, 12.0], transition);
            fade.sample(20, |sample, g| assert_eq!(g, fade.at(sample as f64)[1], "{sample} of {transition}"));
            let mut near = NearFade::new(&fade);
            for quarter in -4..80 {
                let time = f64::from(quarter) * 0.25;
                assert_eq!([near.at(time), near.at(time)], [fade.at(time); 2], "{time} of {transition}");
            }
        }
    }

    #[test]
    fn it_turns_round_in_the_middle_of_its_way() {
        let fade = fade(false, &[20.0, 21.0], 4.0);
        assert_eq!(fade.knots(), [[18.0, 0.0], [19.0, 0.25], [20.0, 0.0]]);
        let area: f64 =
            fade.knots().windows(2).map(|k| (k[1][0] - k[0][0]) * (k[0][1] + k[1][1]) / 2.0).sum();
        assert_eq!(area, 0.25);
    }

    #[test]
    fn no_transition_is_a_jump_and_an_endless_one_never_moves() {
        let jumps = fade(true, &[3.25, 5.0], 0.0);
        assert_eq!(jumps.at(3.25), [1.0, 0.0]);
        assert_eq!([jumps.at(3.0), jumps.at(4.0), jumps.at(5.0)], [[1.0; 2], [0.0; 2], [0.0, 1.0]]);
        assert_eq!(fade(true, &[3.0], f64::INFINITY).at(9.0), [1.0; 2]);
        assert_eq!(fade(false, &[], 2.0).at(1.0), [0.0; 2]);
    }
}
