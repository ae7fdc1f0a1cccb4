//! Loads that take time: which craters come late, and from where they are drawn.

use feature_generator::{
    CRATER_WORDS, FeatureGenerator, FeatureMiss, FeatureProfile, FeatureProgram, Schedule,
};
use features::{Crater, Features};
use hardware_model::Organisation::{self, ByRegion, Scheduled};
use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
use quantities::{Rate, SweepTime, Timebase};
use sweep_program::{LoadLine, LoadTiming, MissCause};

use crate::common::{bowl, parts, scene, sweeps};

const SAMPLES: u32 = 1000;
/// Master ticks of a sample, in which a sweep passes a metre.
const TICKS: u64 = 10;

/// One sweep a second of 1000 samples without retrace.
fn timebase() -> Timebase {
    let rate = |hertz| Rate::new(hertz, 1).unwrap();
    Timebase::new(rate(u64::from(SAMPLES) * TICKS), rate(1), 1, SAMPLES, 0).unwrap()
}

/// A line on which the words of a crater take as long as the sweep for `metres`.
fn timing(
    metres: f64,
    strobes_through: bool,
    on_time: Option<u32>,
) -> LoadTiming<impl Fn(f64) -> SweepTime, impl Fn(SweepTime) -> f64> {
    let rate = f64::from(CRATER_WORDS) * f64::from(SAMPLES) / metres;
    LoadTiming {
        line: LoadLine::new(&timebase(), (0, 0), CRATER_WORDS, rate),
        strobes_through,
        time_of: SweepTime,
        range_at: |SweepTime(time)| time,
        on_time,
    }
}

struct Loads {
    organisation: Organisation,
    limit: Option<u32>,
    metres: f64,
    strobes_through: bool,
    on_time: Option<u32>,
}

impl Loads {
    fn program(&self, features: &Features, eye: [f64; 2], direction: [f64; 2]) -> FeatureProgram {
        let parts = parts(self.organisation, self.limit);
        let schedule = Schedule {
            features,
            parts,
            region_origin: [0.0; 2],
            region_size: 100.0,
            among: None,
            absent: &[],
        };
        let mut program = FeatureProgram::default();
        let timing = timing(self.metres, self.strobes_through, self.on_time);
        schedule.write_by(eye, direction, [0.0, f64::from(SAMPLES - 1)], Some(timing), &mut program);
        program
    }

    /// Of a sweep to the north.
    fn north(&self, craters: &[Crater]) -> FeatureProgram {
        self.program(&Features::new(craters.to_vec()), [0.0, 50.0], [1.0, 0.0])
    }
}

/// A bowl that the sweep is in from one range to another.
fn chord(from: f64, to: f64) -> Crater {
    bowl([0.5 * (from + to), 50.0], 0.5 * (to - from))
}

fn slacks(program: &FeatureProgram) -> Vec<i64> {
    program.arrivals.iter().map(|arrival| arrival.load.slack).collect()
}

/// Range of the edge and of the arrival (m), and why.
fn late(program: &FeatureProgram) -> Vec<(f64, Option<f64>, Option<MissCause>)> {
    let of = |miss: &FeatureMiss| (miss.range, miss.arrival.map(|arrival| arrival.0), miss.cause);
    program.misses.iter().map(of).collect()
}

const ONE: Loads =
    Loads { organisation: Scheduled, limit: Some(1), metres: 10.0, strobes_through: true, on_time: None };

#[test]
fn words_come_one_crater_after_another() {
    let craters = [chord(5.0, 15.0), chord(30.0, 40.0)];
    let program = Loads { limit: Some(2), ..ONE }.north(&craters);
    // The first set out with the sweep and came at 10 m, the second at 20.
    assert_eq!(late(&program), [(5.0, Some(10.0), Some(MissCause::Access))]);
    assert_eq!((slacks(&program), program.load_ticks), (vec![-50, 100], 200));
    assert_eq!(program.loads.iter().map(|load| load.from).collect::<Vec<_>>(), [10.0, f64::NEG_INFINITY]);
}

#[test]
fn the_next_crater_waits_for_its_sub_generator_or_for_the_line() {
    let craters = [chord(12.0, 22.0), chord(23.0, 50.0)];
    assert_eq!(late(&ONE.north(&craters)), [(23.0, Some(32.0), Some(MissCause::Access))]);
    assert_eq!(late(&Loads { limit: Some(2), ..ONE }.north(&craters)), []);
    let slow = Loads { limit: Some(2), metres: 12.0, ..ONE };
    assert_eq!(late(&slow.north(&craters)), [(23.0, Some(24.0), Some(MissCause::Queue))]);
}

#[test]
fn by_region_the_words_set_out_at_its_edge() {
    let craters = [chord(112.0, 130.0), chord(114.0, 140.0)];
    let by_region = Loads { organisation: ByRegion, limit: None, ..ONE };
    assert_eq!(late(&by_region.north(&craters)), [(114.0, Some(120.0), Some(MissCause::Queue))]);
    assert_eq!(late(&Loads { limit: None, ..ONE }.north(&craters)), []);
}

#[test]
fn what_comes_too_late_is_not_drawn_and_what_could_not_set_out_is_given_up() {
    // The first comes when the sweep has left it, the second could not set out before.
    let craters = [chord(2.0, 8.0), chord(3.0, 9.0), chord(20.0, 60.0)];
    let program = Loads { limit: None, ..ONE }.north(&craters);
    let words = [(2.0, Some(10.0), Some(MissCause::Access)), (3.0, None, Some(MissCause::Queue))];
    assert_eq!(late(&program), words);
    assert_eq!(program.loads.iter().map(|load| load.crater).collect::<Vec<_>>(), [2]);
    assert!(slacks(&program)[1] < 0 && program.load_ticks == 200, "{program:?}");
    // Without a free sub-generator there is no load at all.
    let dropped = ONE.north(&[chord(12.0, 40.0), chord(20.0, 30.0)]);
    assert_eq!((late(&dropped), dropped.dropped), (vec![(20.0, None, None)], 1));
}

/// Craters every `apart` metres from 100 m on, of which each load takes `metres`: number k is late if `(k + 1) metres` is
/// more than `100 + k apart`.
#[test]
fn as_many_are_late_as_the_arithmetic_says() {
    let craters: Vec<Crater> =
        (0..40).map(|k| chord(100.0 + 20.0 * f64::from(k), 119.0 + 20.0 * f64::from(k))).collect();
    for (metres, late) in [(10.0, 0), (22.0, 0), (22.1, 2), (25.0, 24), (29.0, 32), (38.0, 36)] {
        let is_late = |k: &i32| f64::from(k + 1) * metres > 100.0 + 20.0 * f64::from(*k);
        assert_eq!((0..40).filter(is_late).count(), late);
        // Once late they stay late, although those that could not set out in time leave the line to the next.
        let found = Loads { limit: None, metres, ..ONE }.north(&craters);
        assert_eq!(found.misses.len(), late, "{metres} m a load");
    }
}

fn drawn(features: &Features, program: &FeatureProgram) -> FeatureProfile<f64> {
    let ranges: Vec<f64> = (0..SAMPLES).map(f64::from).collect();
    let programs: [FeatureProgram; 8] = std::array::from_fn(|_| program.clone());
    let mut profile = FeatureProfile::default();
    FeatureGenerator { ranges: &ranges }.run(features, &programs, &mut profile);
    profile
}

#[test]
fn a_late_crater_is_drawn_from_where_its_words_come() {
    let features = Features::new(vec![chord(5.0, 25.0)]);
    let at = |loads: &Loads| drawn(&features, &loads.program(&features, [0.0, 50.0], [1.0, 0.0]));
    let whole = at(&Loads { metres: 0.1, ..ONE });
    let strobed = at(&ONE);
    for sample in 0..SAMPLES as usize {
        let expected = if sample > 10 { whole.height[sample] } else { Default::default() };
        assert_eq!(strobed.height[sample], expected, "at {sample} m");
        let present = f64::from(u8::from((11..25).contains(&sample)));
        assert_eq!(strobed.present[sample][0], present, "at {sample} m");
    }
    // What is left are the kinks behind that place.
    assert_eq!(strobed.kinks[0][..], whole.kinks[0][1..]);
    let latched = at(&Loads { strobes_through: false, ..ONE });
    assert!(latched.height.iter().all(|sample| sample[0] == 0.0) && latched.kinks[0].is_empty());
}

/// The first comes when the sweep has left it, the second could not set out, the third is in time.
#[test]
fn a_crater_whose_words_are_on_time_is_drawn_whole_and_no_other_moves() {
    let craters = [chord(2.0, 8.0), chord(3.0, 9.0), chord(20.0, 60.0)];
    for strobes_through in [true, false] {
        let program = |on_time| Loads { limit: None, strobes_through, on_time, ..ONE }.north(&craters);
        let (as_it_is, whole) = (program(None), f64::NEG_INFINITY);
        for (crater, drawn) in [(0, vec![0, 2]), (1, vec![1, 2]), (2, vec![2])] {
            let again = program(Some(crater));
            let loads: Vec<_> = again.loads.iter().map(|load| (load.crater, load.from)).collect();
            assert_eq!(loads, drawn.iter().map(|&crater| (crater, whole)).collect::<Vec<_>>(), "{crater}");
            assert_eq!(again.load_ticks, as_it_is.load_ticks);
            let missed = |program: &FeatureProgram| -> Vec<u32> {
                program.misses.iter().map(|miss| miss.crater).collect()
            };
            let expected: Vec<u32> =
                missed(&as_it_is).into_iter().filter(|missed| *missed != crater).collect();
            assert_eq!(missed(&again), expected, "{crater}");
        }
    }
}

proptest! {
    /// Craters that are in time are drawn whole, late ones from where they come: the sum of both, to the bit.
    #[test]
    fn a_late_sweep_is_the_sum_of_what_has_come(
        features in scene(), sweeps in sweeps(), limit in 1..4u32, metres in 1.0..40.0f64,
    ) {
        for (eye, angle) in sweeps {
            let (sin, cos) = quantities::sin_cos(angle);
            let loads = Loads { limit: Some(limit), metres, ..ONE };
            let program = loads.program(&features, eye, [cos, sin]);
            let lost = program.misses.iter().filter(|miss| miss.arrival.is_none()).count();
            prop_assert!(program.dropped as usize <= lost);
            // Each load took the line once, one after another.
            let brought = program.arrivals.len() - (lost - program.dropped as usize);
            let each = (10.0 * metres - 1e-8 * metres).ceil() as u64;
            prop_assert!(program.load_ticks.abs_diff(brought as u64 * each) <= brought as u64);
            let missed = program.arrivals.iter().filter(|arrival| arrival.load.slack < 0).count();
            prop_assert_eq!(missed, program.misses.len() - program.dropped as usize);
            let profile = drawn(&features, &program);
            for sample in (0..SAMPLES as usize).step_by(37) {
                let range = sample as f64;
                let at = [eye[0] + range * cos, eye[1] + range * sin];
                let one = |load: &feature_generator::FeatureLoad| {
                    let crater = &features.crater(load.crater);
                    let alone = Features::new(vec![*crater]);
                    if range > load.from { alone.at(at[0], at[1]).height } else { 0.0 }
                };
                let height: f64 = program.loads.iter().map(one).sum();
                prop_assert!((profile.height[sample][0] - height).abs() < 1e-9 * (1.0 + height.abs()));
            }
        }
    }
}
