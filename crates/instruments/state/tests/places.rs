//! Steps from place to place, over clocks of any ratio.

use proptest::prelude::*;
use quantities::{Rate, Timebase};
use state::{Clock, Gone, Place, PlaceError, Unit};

const FRAMES: u64 = 3;
const SWEEPS: u32 = 5;
const UNITS: [Unit; 4] = [Unit::Tick, Unit::Sample, Unit::Sweep, Unit::Frame];

/// Ticks from a seventh of a sample's to ten times as many.
fn clock() -> impl Strategy<Value = Clock> {
    (2..30_u32, 0..9_u32, 1..200_u64, 1..4_u64).prop_map(|(samples, retrace, master, update)| {
        let least = u64::from(SWEEPS) * u64::from(samples + retrace) / 7 + 10;
        let rate = |hertz| Rate::new(hertz, 1).unwrap();
        let timebase = Timebase::new(rate((least + master) * update), rate(update), SWEEPS, samples, retrace);
        Clock::new(timebase.unwrap(), FRAMES)
    })
}

fn start() -> impl Strategy<Value = Place> {
    (0..FRAMES, 0..SWEEPS).prop_map(|(frame, sweep)| Place::start(frame, sweep))
}

/// What comes first: a start before what lies behind it in its sweep.
fn order(clock: &Clock, place: Place) -> (u64, u32, bool, f64) {
    (place.frame, place.sweep, place.gone != Gone::Nothing, clock.time(place).0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn n_steps_and_n_back_lead_to_the_same_place(
        clock in clock(), start in start(), first in 0..4_usize, way in -60..60_i64, unit in 0..4_usize, count in -60..60_i64,
    ) {
        // A place of a kind, by some steps from a sweep's start, or the start itself.
        let place = if first == unit { clock.step(start, UNITS[first], way).unwrap_or(start) } else { start };
        clock.expect(place).unwrap();
        if let Ok(there) = clock.step(place, UNITS[unit], count) {
            clock.expect(there).unwrap();
            prop_assert_eq!(clock.step(there, UNITS[unit], -count), Ok(place));
        }
    }

    #[test]
    fn one_step_n_times_is_n_steps(clock in clock(), start in start(), other in -9..9_i64, unit in 0..4_usize, count in 1..40_i64, back in any::<bool>()) {
        // From between two places of the kind as well.
        let start = clock.step(start, UNITS[1 - unit.min(1)], other).unwrap_or(start);
        let sign = if back { -1 } else { 1 };
        let at_once = clock.step(start, UNITS[unit], sign * count);
        let one_by_one = (0..count).try_fold(start, |place, _| clock.step(place, UNITS[unit], sign));
        prop_assert_eq!(at_once, one_by_one);
    }

    #[test]
    fn a_step_leads_forwards_and_passes_no_place_of_its_kind(clock in clock(), start in start(), other in -9..9_i64, unit in 0..4_usize) {
        let start = clock.step(start, UNITS[1 - unit.min(1)], other).unwrap_or(start);
        if let Ok(next) = clock.step(start, UNITS[unit], 1) {
            prop_assert!(order(&clock, next) > order(&clock, start), "{} {}", start, next);
            let before = clock.step(next, UNITS[unit], -1);
            if let Ok(before) = before {
                prop_assert!(order(&clock, before) <= order(&clock, start), "{} {}", before, start);
            }
        }
    }

    #[test]
    fn every_tick_is_one_place(clock in clock(), tick in 0..100_000_u64) {
        if let Some(place) = clock.place_of(quantities::Tick(tick)) {
            clock.expect(place).unwrap();
            prop_assert_eq!(clock.tick(place).0, tick);
        }
    }
}

fn nominal() -> Clock {
    let rate = |hertz| Rate::new(hertz, 1).unwrap();
    Clock::new(Timebase::new(rate(20_000_000), rate(30), 525, 1000, 208).unwrap(), 90)
}

/// The worked example of docs/time.md: sweep 262 of frame 10 begins at tick 6 999 366 and has 1269 or 1270 ticks.
#[test]
fn places_of_525_sweeps_at_30_hertz() {
    let (clock, start) = (nominal(), Place::start(10, 262));
    assert_eq!(clock.tick(start).0, 6_999_366);
    let stop = clock.step(start, Unit::Tick, 48).unwrap();
    assert_eq!((stop.gone, clock.tick(stop).0), (Gone::Ticks(48), 6_999_414));
    // That tick is sample 46.54.
    let seen = clock.step(stop, Unit::Sample, 1).unwrap();
    assert_eq!(seen, Place { gone: Gone::Samples(47), ..start });
    assert_eq!(clock.step(start, Unit::Tick, 1269).unwrap(), Place::start(10, 263));
    assert_eq!(clock.step(start, Unit::Sample, 1000).unwrap(), Place::start(10, 263));
    assert_eq!(clock.step(start, Unit::Sweep, 263).unwrap(), Place::start(11, 0));
    assert_eq!(clock.step(start, Unit::Frame, -1).unwrap(), Place::start(9, 262));
    assert_eq!(clock.step(stop, Unit::Frame, -1).unwrap(), start);
    assert!((clock.seconds(start) - (10.0 + 262.0 / 525.0) / 30.0).abs() < 1e-12);
}

#[test]
fn the_mission_has_ends() {
    let (clock, first) = (nominal(), Place::start(0, 0));
    for unit in UNITS {
        assert_eq!(clock.step(first, unit, -1), Err(PlaceError::Before));
        assert_eq!(clock.step(first, unit, i64::MIN), Err(PlaceError::Before));
        assert_eq!(clock.step(first, unit, i64::MAX), Err(PlaceError::Behind { last: 89 }));
    }
    let last = clock.step(Place::start(89, 524), Unit::Sample, 999).unwrap();
    assert_eq!(clock.step(last, Unit::Sample, 1), Err(PlaceError::Behind { last: 89 }));
    for (wrong, words) in [
        (Place::start(90, 0), "frame 90: the mission has frames 0..90"),
        (Place::start(0, 525), "sweep 525: a frame has sweeps 0..525"),
        (Place { gone: Gone::Samples(1000), ..first }, "samples 1..1000 behind its start"),
        (Place { gone: Gone::Ticks(1270), ..first }, "ticks 1..1270 behind its start"),
        (Place { gone: Gone::Ticks(0), ..first }, "0 ticks in a sweep"),
    ] {
        let said = clock.expect(wrong).unwrap_err().to_string();
        assert!(said.contains(words), "{said}");
    }
}
