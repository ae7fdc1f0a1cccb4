//! Suns that turn: whole numbers, aliasing, warnings (acceptance test 4).

use faces::{FaceError, SunProgramme, Turn, TurningSun, Warning, sun_vector};
use glam::DVec3;
use quantities::{Rate, radians};

fn frames(above: u64, below: u64) -> Rate {
    Rate::new(above, below).expect("a frame rate")
}

#[test]
fn a_film_closes_to_the_bit_after_whole_turns() {
    for (rate, frames, period) in
        [([1, 4], frames(30, 1), 120), ([-3, 20], frames(30, 1), 200), ([1, 1], frames(30_000, 1001), 30_000)]
    {
        let turn = Turn::new(rate, frames).expect("a turn");
        assert_eq!(turn.period(), period);
        let sun = TurningSun::new(0.7, 0.3, turn).expect("a sun");
        for frame in [0, 1, 7, period - 1] {
            for rounds in [1, 2, 1_000_003] {
                let later = sun.vector(frame + rounds * period);
                assert_eq!(
                    later.to_array().map(f64::to_bits),
                    sun.vector(frame).to_array().map(f64::to_bits)
                );
            }
        }
        assert_ne!(sun.vector(period / 2), sun.vector(0));
    }
}

#[test]
fn turns_are_the_rate_over_the_frame_rate() {
    let turn = Turn::new([1, 4], frames(30, 1)).expect("a turn");
    assert_eq!((turn.at(0), turn.at(21), turn.at(119)), (0.0, 21.0 / 120.0, 119.0 / 120.0));
    let back = Turn::new([-1, 4], frames(30, 1)).expect("a turn");
    assert_eq!((back.at(0), back.at(1)), (0.0, 119.0 / 120.0));
    assert!((back.step() + radians(3.0)).abs() < 1e-15);
    assert_eq!(Turn::new([0, 7], frames(30, 1)), Ok(Turn::STILL));
    // The largest frame number there is does not overflow.
    let odd = Turn::new([999_983, 1_000_003], frames(1_000_033, 1)).expect("a turn");
    assert!((0.0..1.0).contains(&odd.at(u64::MAX)));
}

#[test]
fn a_sun_that_would_seem_to_turn_backwards_is_refused_with_the_rate_that_does() {
    let found = Turn::new([-16, 1], frames(30, 1)).expect_err("an aliased sun").to_string();
    assert_eq!(
        found,
        "the sun turns at -16 Hz, over half the frame rate, so it would seem to turn backwards: expected 15 Hz or less"
    );
    let ntsc = Turn::new([15, 1], frames(30_000, 1001)).expect_err("an aliased sun");
    assert!(ntsc.to_string().ends_with("expected 15000/1001 Hz or less"), "{ntsc}");
    assert!(Turn::new([15, 1], frames(30, 1)).is_ok());
    assert!(Turn::new([15_000, 1001], frames(30_000, 1001)).is_ok());
}

#[test]
fn figures_out_of_range() {
    assert!(matches!(Turn::new([1, 0], frames(30, 1)), Err(FaceError::Figure { .. })));
    assert!(matches!(Turn::new([1, i64::MAX], frames(1_000_003, 1)), Err(FaceError::Figure { .. })));
    for (elevation, azimuth) in [(1.6, 0.0), (f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        assert!(TurningSun::new(elevation, azimuth, Turn::STILL).is_err());
    }
}

#[test]
fn steps_that_show_and_suns_below_the_horizon_are_told() {
    let warnings = |rate, elevation| {
        TurningSun::new(elevation, 0.0, Turn::new(rate, frames(32, 1)).expect("a turn"))
            .expect("a sun")
            .warnings()
    };
    assert_eq!(warnings([2, 1], 0.5), []);
    let told = warnings([-21, 10], -0.1);
    assert!(matches!(told[..], [Warning::Stepping { .. }, Warning::SunBelow { .. }]), "{told:?}");
    assert!(told[0].to_string().contains("23.6 deg a frame"), "{}", told[0]);
}

#[test]
fn azimuths_run_from_north_to_east() {
    assert_eq!(sun_vector(0.0, 0.0), DVec3::X);
    assert_eq!(sun_vector(radians(90.0), 0.0), DVec3::Y);
    assert_eq!(sun_vector(1.0, radians(90.0)), DVec3::Z);
    assert_eq!(SunProgramme::Scenario.vector(9, DVec3::Y), DVec3::Y);
    let own = TurningSun::new(0.0, 0.0, Turn::new([1, 4], frames(1, 1)).expect("a turn")).expect("a sun");
    assert_eq!(SunProgramme::Turning(own).vector(1, DVec3::Z), DVec3::Y);
}
