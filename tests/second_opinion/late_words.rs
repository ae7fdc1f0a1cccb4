//! One word comes too late: what happens is what the drawing says, and happens nowhere else (6.3, 6.4, 22 no. 8;
//! hardware sections 4.4, 4.5).
//!
//! The sweeps are those of the worked fold tables (6.6), so that every number below can be read off the page. While
//! the wrong word stands in the hold register of corner (m, n), the height is off by the corner's own weight in the
//! plain sum of 5.1: `g_ip(u) g_jq(v) (wrong word - right word)`.

use hardware_model::{LatePolicy, LoadDelay};
use landscape::basis::{derivatives, values};
use lunoid_tests::{ComparedScene, Dice, Drawn, level_of};
use quantities::radians;
use scenario::{RangeLaw, RangeProgramme};
use sweep_program::{Colour, PreloadRegister};

const SIZE: f64 = 200.0;
const CORNERS: usize = 20;
/// Ramps reach this far (regions), in steps of 1/200 region.
const END: f64 = 5.5;
const STEPS_A_REGION: f64 = 200.0;
const TICKS_A_STEP: f64 = 2.0;
/// The sweep that runs exactly along the heading; one on each side of it must not notice.
const SWEEP: u32 = 1;
const SIGNALS: [&str; 3] = ["tg.height", "tg.slope.u", "tg.slope.v"];

/// A word that waits for a fold, and the fold. Places along the sweep are in regions of ground range.
struct Case {
    foot: [f64; 2],
    degrees: f64,
    /// The fold that asks for the word: its number and place.
    asked: (u32, f64),
    colour: Colour,
    register: PreloadRegister,
    /// The fold that needs it.
    needed: f64,
    /// The next fold that gives this colour new words.
    relieved: f64,
    /// What the preload register held before, and what it should hold.
    stale: [usize; 2],
    right: [usize; 2],
    /// Region between `needed` and `relieved`.
    region: [usize; 2],
}

/// Red waits for X = 0 at 4.272; Y = 0 at 4.8 takes it next. Its XFIRST last held (5, 7).
const NORTH_EAST: Case = Case {
    foot: [2.3, 5.6],
    degrees: 30.0,
    asked: (2, 1.962990915245),
    colour: Colour::Red,
    register: PreloadRegister::XFirst,
    needed: 4.272391992003,
    relieved: 4.8,
    stale: [5, 7],
    right: [7, 7],
    region: [6, 7],
};

/// Green waits for Y = 1 at 3.509; X = 0 at 3.991 takes it next. Its YFIRST is still the home word of (13, 12):
/// the corner that was right before the X fold (6.5).
const SOUTH_WEST: Case = Case {
    foot: [13.75, 14.2],
    degrees: -160.0,
    asked: (2, 1.862311101833),
    colour: Colour::Green,
    register: PreloadRegister::YFirst,
    needed: 3.508565280196,
    relieved: 3.990666646784,
    stale: [13, 12],
    right: [11, 12],
    region: [10, 12],
};

/// Instant at which the sweep passes a place, in steps from its first sample.
fn time(place: f64) -> f64 {
    place * STEPS_A_REGION - 1.0
}

impl Case {
    fn scene(&self, policy: LatePolicy) -> ComparedScene {
        let mut dice = Dice::new(12);
        let words: Vec<[f64; 9]> =
            (0..CORNERS * CORNERS).map(|_| std::array::from_fn(|_| 4.0 * dice.normal())).collect();
        let level = level_of(SIZE, [0.0, 0.0], [CORNERS; 2], |m, n| words[m * CORNERS + n]);
        let mut scene = ComparedScene::over(level);
        scene.stand(self.foot[0] * SIZE, self.foot[1] * SIZE, 20.0);
        scene.heading = radians(self.degrees);
        scene.sweeps = 3;
        scene.samples = (END * STEPS_A_REGION) as u32;
        scene.range = RangeProgramme { law: RangeLaw::ConstantRate, start: 1.0, end: END * SIZE };
        let steps_a_frame = u64::from(scene.sweeps * (scene.samples + scene.retrace()));
        scene.master_hz = 30 * steps_a_frame * TICKS_A_STEP as u64;
        scene.loader.late_policy = policy;
        scene
    }

    /// Ticks of delay after which the word comes nearest to `place`, and the instant at which it does.
    fn delay(&self, place: f64) -> (u64, f64) {
        let seen = (time(self.asked.1) * TICKS_A_STEP).ceil();
        let ticks = (time(place) * TICKS_A_STEP - seen).round();
        (ticks as u64, (seen + ticks) / TICKS_A_STEP)
    }

    fn draw(&self, policy: LatePolicy, delayed: Option<(usize, u64)>) -> Drawn {
        let mut scene = self.scene(policy);
        scene.loader.delays = delayed.into_iter().map(|(word, ticks)| self.hold_back(word, ticks)).collect();
        scene.draw(0, &SIGNALS).unwrap()
    }

    fn hold_back(&self, word: usize, ticks: u64) -> LoadDelay {
        let (frame, crossing) = (None, self.asked.0);
        LoadDelay { frame, sweep: SWEEP, crossing, colour: self.colour, register: self.register, word, ticks }
    }

    /// Change of height and both slopes at a place while the stale word is in hold: one term of 5.1.
    fn predicted(&self, scene: &ComparedScene, word: usize, place: f64) -> [f64; 3] {
        let (sin, cos) = (libm::sin(scene.heading), libm::cos(scene.heading));
        let u = self.foot[0] + place * cos - self.region[0] as f64;
        let v = self.foot[1] + place * sin - self.region[1] as f64;
        let ip = 3 * (self.right[0] - self.region[0]) + word / 3;
        let jq = 3 * (self.right[1] - self.region[1]) + word % 3;
        let words = scene.level.words();
        let [stale, right] = [self.stale, self.right].map(|[m, n]| words[m * CORNERS + n][word]);
        let difference = stale - right;
        [
            values(u)[ip] * values(v)[jq] * difference,
            derivatives(u)[ip] * values(v)[jq] * difference / SIZE,
            values(u)[ip] * derivatives(v)[jq] * difference / SIZE,
        ]
    }

    /// One word late under a policy: predicted between the fold and `end` (an instant), as before elsewhere.
    fn check(&self, policy: LatePolicy, word: usize, ticks: u64, end: f64) {
        let what = format!("{policy:?}, {} deg, word {word}, {ticks} ticks", self.degrees);
        let scene = self.scene(policy);
        let (clean, late) = (self.draw(policy, None), self.draw(policy, Some((word, ticks))));
        assert_eq!((clean.counts["late_words"], late.counts["late_words"]), (0, 1), "{what}");
        for (before, after) in clean.waveforms.iter().zip(&late.waveforms) {
            if before.sweep != SWEEP {
                assert_eq!(before.values, after.values, "{what}: {} of another sweep", before.signal.name);
                continue;
            }
            let signal = SIGNALS.iter().position(|name| *name == before.signal.name).unwrap();
            let scale = before.values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            for (sample, (before, after)) in before.values.iter().zip(&after.values).enumerate() {
                let (now, change) = (sample as f64, after - before);
                let place = (now + 1.0) / STEPS_A_REGION;
                let at = format!("{what}: {}, sample {sample}, place {place}", SIGNALS[signal]);
                if now >= time(self.needed) && now < end {
                    let predicted = self.predicted(&scene, word, place)[signal];
                    assert!((change - predicted).abs() <= 1e-12 * scale, "{at}: {change}, not {predicted}");
                } else if now >= end && now < time(self.relieved) + 1e-9 {
                    // The polynomial starts anew when the word arrives: the same ground, but to rounding.
                    assert!(change.abs() <= 1e-12 * scale, "{at}: {change} after the word has come");
                } else {
                    assert_eq!(change, 0.0, "{at}");
                }
            }
        }
    }
}

#[test]
fn strobed_through_a_late_word_is_missed_until_it_comes() {
    for case in [NORTH_EAST, SOUTH_WEST] {
        for word in 0..9 {
            for lateness in [0.03, 0.2, 0.37] {
                let (ticks, arrival) = case.delay(case.needed + lateness);
                case.check(LatePolicy::StrobeThrough, word, ticks, arrival);
            }
        }
    }
}

#[test]
fn latched_a_late_word_is_missed_until_the_next_transfer_of_its_colour() {
    for case in [NORTH_EAST, SOUTH_WEST] {
        for word in 0..9 {
            let (ticks, _) = case.delay(case.needed + 0.03);
            case.check(LatePolicy::Latched, word, ticks, time(case.relieved));
        }
    }
}

#[test]
fn a_late_word_that_never_comes_before_the_next_transfer_is_overtaken() {
    for case in [NORTH_EAST, SOUTH_WEST] {
        let (ticks, _) = case.delay(case.relieved + 0.1);
        case.check(LatePolicy::StrobeThrough, 0, ticks, time(case.relieved));
    }
}

#[test]
fn a_word_in_time_changes_nothing() {
    for policy in [LatePolicy::StrobeThrough, LatePolicy::Latched] {
        for case in [NORTH_EAST, SOUTH_WEST] {
            let clean = case.draw(policy, None);
            let (ticks, arrival) = case.delay(case.needed - 0.01);
            assert!(arrival < time(case.needed) && ticks > 0);
            let delayed = case.draw(policy, Some((4, ticks)));
            assert_eq!(delayed.counts["late_words"], 0);
            assert_eq!(delayed.picture, clean.picture);
            assert_eq!(delayed.waveforms, clean.waveforms);
        }
    }
}

#[test]
fn a_late_word_shows_in_the_picture() {
    let (ticks, _) = NORTH_EAST.delay(NORTH_EAST.needed + 0.37);
    let clean = NORTH_EAST.draw(LatePolicy::Latched, None);
    let late = NORTH_EAST.draw(LatePolicy::Latched, Some((0, ticks)));
    let columns = 3;
    let differs = |column: usize| {
        (0..clean.picture.len() / columns)
            .any(|line| clean.picture[line * columns + column] != late.picture[line * columns + column])
    };
    assert!(differs(SWEEP as usize), "the late word cannot be seen");
}

#[test]
fn a_delay_of_another_frame_is_not_of_this_one() {
    let (ticks, _) = NORTH_EAST.delay(NORTH_EAST.needed + 0.2);
    let mut scene = NORTH_EAST.scene(LatePolicy::StrobeThrough);
    scene.loader.delays = vec![LoadDelay { frame: Some(3), ..NORTH_EAST.hold_back(0, ticks) }];
    let late_in = |frame| scene.draw(frame, &[]).unwrap().counts["late_words"];
    assert_eq!((late_in(0), late_in(3), late_in(4)), (0, 1, 0));
}
