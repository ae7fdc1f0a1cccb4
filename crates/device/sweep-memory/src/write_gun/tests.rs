//! Exposure in closed form, and extremes.

use hardware_model::{AnalogParts, MemoryParts, WriteCompensation};
use proptest::prelude::{Strategy, any, prop_assert, prop_oneof, proptest};
use proptest::sample::select;
use scenario::PixelRule;
use signal::{Break, Breaks, LANES, Lanes, Stretches};

use super::{Drive, GunWork, WriteGun};
use crate::exposure::SATURATED;
use crate::{Beam, FarStroke, Steps, write_group};

const H: f64 = 50e-9;
const LINES: usize = 100;

fn gun(compensation: WriteCompensation, deflection: Option<f64>, samples: usize) -> WriteGun<f64> {
    let memory = MemoryParts { write_compensation: compensation, deflection, ..MemoryParts::IDEAL };
    WriteGun::new(&AnalogParts { memory, ..AnalogParts::ideal() }, 1970, H, samples, LINES)
}

/// The row that one lane writes; the others write nothing.
fn row(gun: &WriteGun<f64>, position: &[f64], intensity: &[f64], on: &[[f64; 2]]) -> Vec<f32> {
    let lanes = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
    let mut stretches = Stretches::default();
    stretches[2] = on.to_vec();
    let drive = Drive {
        position: &lanes(position),
        intensity: &lanes(intensity),
        on: &stretches,
        breaks: None,
        far: None,
    };
    let (mut work, mut rows) = (GunWork::default(), vec![9.0; LANES * LINES]);
    gun.write_stretches(&drive, &mut work, &mut rows);
    assert!(rows.chunks(LINES).enumerate().all(|(lane, row)| lane == 2 || row.iter().all(|v| *v == 0.0)));
    rows[2 * LINES..][..LINES].to_vec()
}

/// A beam that climbs at `speed` lines a sample, on all the way, with constant intensity.
fn climb(gun: &WriteGun<f64>, speed: f64, intensity: f64, samples: usize) -> Vec<f32> {
    let position: Vec<f64> = (0..samples).map(|k| 90.0 - speed * k as f64).collect();
    row(gun, &position, &vec![intensity; samples], &[[0.0, (samples - 1) as f64]])
}

/// An edge between two samples is written where it is: two levels, and the line that it lies in by its shares.
#[test]
fn a_break_is_written_at_its_instant() {
    let gun = gun(WriteCompensation::Exact, None, 10);
    let position: Vec<_> = (0..10).map(|k| Lanes::splat(90.0 - 8.0 * k as f64)).collect();
    let intensity: Vec<_> = (0..10).map(|k| Lanes::splat(if k < 5 { 0.25 } else { 0.75 })).collect();
    let mut breaks = Breaks::<f64>::default();
    // 4.3 samples are 55.6 lines from the top.
    breaks[0].push(Break { sample: 5, share: 0.3, height: 0.0, before: 0.25, after: 0.75 });
    let mut on = Stretches::default();
    on[0] = vec![[0.0, 4.1], [4.1, 9.0]];
    let drive =
        Drive { position: &position, intensity: &intensity, on: &on, breaks: Some(&breaks), far: None };
    let mut rows = vec![0.0; LANES * LINES];
    gun.write_stretches(&drive, &mut GunWork::default(), &mut rows);
    for (line, expected) in [(89, 0.25), (56, 0.25), (55, 0.25 * 0.4 + 0.75 * 0.6), (54, 0.75), (30, 0.75)] {
        assert!((rows[line] - expected).abs() < 1e-5, "{line}: {}", rows[line]);
    }
}

/// Charge of a line that shows `value`, in charges of a white one.
fn charge(value: f32) -> f64 {
    -libm::log1p(-f64::from(value) / f64::from(SATURATED))
}

#[test]
fn white_is_white_and_no_charge_is_beyond_saturation() {
    assert!((f64::from(SATURATED) * (1.0 - libm::exp(-1.0)) - 1.0).abs() < 1e-7);
    let slow = climb(&gun(WriteCompensation::Off, None, 2), 0.02, 1.0, 200);
    assert!((slow[88] - SATURATED).abs() < 1e-6, "{}", slow[88]);
}

#[test]
fn without_compensation_the_charge_is_the_time_that_the_beam_stays() {
    // 101 samples for 100 lines: exposure is right at one line a sample.
    let gun = gun(WriteCompensation::Off, None, 101);
    for (speed, intensity) in [(1.0, 1.0), (0.5, 1.0), (0.25, 0.6), (2.0, 1.0), (8.0, 0.6), (0.37, 0.2)] {
        let rows = climb(&gun, speed, intensity, (80.0 / speed) as usize);
        let once = charge(intensity as f32);
        for line in 20..80 {
            let found = charge(rows[line]);
            assert!((found - once / speed).abs() < 1e-4 * once / speed, "{speed}, {line}: {found}, {once}");
        }
    }
}

#[test]
fn with_exact_compensation_the_intensity_is_what_it_is() {
    for deflection in [None, Some(3e6)] {
        let gun = gun(WriteCompensation::Exact, deflection, 101);
        for speed in [0.03, 0.5, 1.0, 7.0] {
            let rows = climb(&gun, speed, 0.3, (88.0 / speed) as usize);
            assert!(rows[30..80].iter().all(|value| (value - 0.3).abs() < 1e-5), "{speed}: {rows:?}");
        }
    }
}

#[test]
fn the_current_follows_within_its_ratio_alone() {
    let gun = gun(WriteCompensation::Ratio(100.0), None, 101);
    for (speed, expected) in [(0.02, 5.0), (0.05, 2.0), (0.1, 1.0), (1.0, 1.0), (9.9, 1.0), (20.0, 0.5)] {
        let rows = climb(&gun, speed, 0.05, (80.0 / speed) as usize);
        let found = charge(rows[50]) / charge(0.05);
        assert!((found - expected).abs() < 2e-3 * expected, "{speed}: {found}");
    }
}

#[test]
fn a_line_at_its_own_speed_shows_its_own_grey() {
    let gun = gun(WriteCompensation::Ratio(100.0), None, 101);
    for intensity in [0.0, 0.1, 0.5, 0.9, 1.0] {
        let rows = climb(&gun, 1.0, intensity, 80);
        assert!((f64::from(rows[50]) - intensity).abs() < 1e-5, "{intensity}: {}", rows[50]);
    }
}

#[test]
fn a_falling_beam_adds_to_charge_and_writes_over_levels() {
    // Up over lines 90 to 40 in 0.2, down again to 70 in 0.5.
    let position: Vec<f64> =
        (0..=80).map(|k| if k <= 50 { 90.0 - f64::from(k) } else { f64::from(k) - 10.0 }).collect();
    let intensity: Vec<f64> = (0..=80).map(|k| if k <= 50 { 0.2 } else { 0.5 }).collect();
    let on = [[0.0, 80.0]];
    let levels = row(&gun(WriteCompensation::Exact, None, 101), &position, &intensity, &on);
    let tube = row(&gun(WriteCompensation::Off, None, 101), &position, &intensity, &on);
    for line in 45..65 {
        assert!((levels[line] - 0.5).abs() < 1e-5, "{line}: {}", levels[line]);
        assert!((charge(tube[line]) - charge(0.2) - charge(0.5)).abs() < 1e-4, "{line}");
    }
    for line in 75..88 {
        assert!((levels[line] - 0.2).abs() < 1e-5 && (tube[line] - 0.2).abs() < 1e-5, "{line}");
    }
}

#[test]
fn the_beam_is_on_in_its_stretches_alone() {
    let gun = gun(WriteCompensation::Exact, None, 81);
    let position: Vec<f64> = (0..=80).map(|k| 90.0 - f64::from(k)).collect();
    let rows =
        row(&gun, &position, &vec![1.0; 81], &[[-4.0, 9.25], [20.5, 30.0], [30.0, 30.0], [77.5, 200.0]]);
    // Beam positions: 90 to 80.75, 69.5 to 60, 12.5 to 10.
    let expected = |line: usize| match line {
        81..90 | 60..69 | 10..12 => 1.0,
        80 => 0.25,
        69 | 12 => 0.5,
        _ => 0.0,
    };
    for (line, value) in rows.iter().enumerate() {
        assert!((value - expected(line)).abs() < 1e-5, "{line}: {value}");
    }
}

#[test]
fn local_shadow_writes_nothing() {
    let position: Vec<f64> = (0..=80).map(|k| 90.0 - f64::from(k)).collect();
    let intensity: Vec<f64> = (0..=80).map(|k| 0.4 - 0.01 * f64::from(k)).collect();
    for (compensation, off) in [(WriteCompensation::Exact, 1e-5), (WriteCompensation::Ratio(9.0), 2e-3)] {
        let rows = row(&gun(compensation, None, 101), &position, &intensity, &[[0.0, 80.0]]);
        for (line, value) in rows.iter().enumerate().filter(|(line, _)| (10..90).contains(line)) {
            let expected = (0.4 - 0.01 * (90.0 - (line as f32 + 0.5))).max(0.0);
            let at_its_end = f32::from(u8::from(line == 50 || line == 49)) * 2e-3;
            assert!((value - expected).abs() < off + at_its_end, "{line}: {value}, {expected}");
        }
    }
}

#[test]
fn silhouettes_rise_from_the_highest_place_written() {
    let lanes = |value: f64| vec![Lanes::splat(value); 2];
    let (mut position, intensity) = (lanes(60.0), lanes(0.5));
    position[1] = Lanes::splat(50.0);
    let far: [Vec<FarStroke>; LANES] = std::array::from_fn(|_| {
        vec![FarStroke { line: 40.0, intensity: 0.8 }, FarStroke { line: 45.0, intensity: 0.1 }]
    });
    let on = std::array::from_fn(|_| vec![[0.0, 1.0]]);
    let drive = Drive { position: &position, intensity: &intensity, on: &on, breaks: None, far: Some(&far) };
    for compensation in [WriteCompensation::Exact, WriteCompensation::Ratio(100.0)] {
        let mut rows = vec![0.0; LINES];
        gun(compensation, None, 11).write_stretches(&drive, &mut GunWork::default(), &mut rows);
        assert!(rows[50..60].iter().all(|value| (value - 0.5).abs() < 1e-5), "{rows:?}");
        assert!(rows[40..50].iter().all(|value| (value - 0.8).abs() < 1e-5), "{rows:?}");
        assert!(rows[..40].iter().chain(&rows[60..]).all(|value| *value == 0.0));
    }
}

#[test]
fn a_beam_that_stands_leaves_all_its_charge_in_one_line() {
    for (compensation, rate) in [(WriteCompensation::Off, 1.0), (WriteCompensation::Ratio(16.0), 0.25)] {
        let found = row(&gun(compensation, None, 101), &[50.5; 4], &[0.3; 4], &[[0.5, 2.0]]);
        assert!((charge(found[50]) - 1.5 * rate * charge(0.3)).abs() < 1e-6, "{}", found[50]);
        assert!(found.iter().enumerate().all(|(line, value)| line == 50 || *value == 0.0));
    }
}

/// Values that break arithmetic, among ordinary ones.
fn extreme() -> impl Strategy<Value = f64> {
    const EDGES: [f64; 10] =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 3e38, -3e38, 1.7e38, 1e-40, 0.0, -0.0];
    prop_oneof![select(&EDGES[..]), any::<f64>(), -50.0..200.0]
}

proptest! {
    /// The gun of no parts and the ideal beam leave the same of a profile in sight.
    #[test]
    fn a_gun_without_faults_is_the_ideal_beam(steps in proptest::collection::vec(0.02..2.0f64, 2..60)) {
        // Of even steps, so that neither draws a curve.
        let speed = steps[0];
        let intensity: Vec<f64> = (0..steps.len()).map(|k| 0.2 + 0.001 * k as f64).collect();
        let position: Vec<f64> = (0..steps.len()).map(|k| 95.3 - speed * k as f64).collect();
        let found = row(
            &gun(WriteCompensation::Exact, None, 101), &position, &intensity, &[[0.0, steps.len() as f64]],
        );
        let lanes = |values: &[f64]| values.iter().map(|&value| Lanes::splat(value)).collect::<Vec<_>>();
        let (line, intensity, entry) =
            (lanes(&position), lanes(&intensity), vec![Lanes::splat(0.0); steps.len()]);
        let beam =
            Beam { position: &line, line: &line, entry: &entry, intensity: &intensity, breaks: None, far: None };
        let mut expected = vec![0.0; LINES];
        write_group(&beam, Steps::Curved, PixelRule::LineMean, LINES, &mut Vec::new(), &mut expected);
        for (found, expected) in found.iter().zip(&expected) {
            prop_assert!((found - expected).abs() < 1e-5, "{found}, {expected}");
        }
    }

    #[test]
    fn whatever_comes_rows_hold_levels(
        wild in proptest::collection::vec([extreme(), extreme()], 0..30),
        mild in proptest::collection::vec([-50.0..200.0f64, -0.5..1.5f64], 0..30),
        on in proptest::collection::vec([extreme(), extreme()], 0..4),
        deflection in proptest::option::of(1e-3..1e9f64),
        ratio in 1.0..1e6f64,
    ) {
        use WriteCompensation::{Exact, Off, Ratio};
        let mut on = on;
        on.push([-1.0, 1000.0]);
        for samples in [&wild, &mild] {
            let column = |k: usize| samples.iter().map(|sample| sample[k]).collect::<Vec<_>>();
            for compensation in [Exact, Ratio(ratio), Off] {
                let gun = gun(compensation, deflection, samples.len());
                let rows = row(&gun, &column(0), &column(1), &on);
                let in_range = |value: &f32| match compensation {
                    Exact => value.is_finite() && *value >= 0.0,
                    _ => (0.0..=SATURATED).contains(value),
                };
                prop_assert!(rows.iter().all(in_range), "{rows:?}");
            }
        }
    }
}
