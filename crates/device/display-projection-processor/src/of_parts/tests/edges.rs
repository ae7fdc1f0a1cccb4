//! Where the beam goes off and on: A13, A14, A15.

use hardware_model::AnalogParts;
use parts::{Spread, time_constant};
use proptest::prelude::{prop_assert, proptest};
use scenario::{Curvature, Occlusion};
use signal::{Break, Breaks, LANES, Lanes};

use super::{BOTH, Driven, H, HALF, LINES, PartsProcessor, Scratch, hollow, level, parts, run, share_at};
use crate::of_parts::falls::lateness;
use crate::of_parts::figures::DERIVATIVE;

const BEND: f64 = 0.002;

/// A crest at sample `top`, of a parabola.
fn crest(top: f64) -> impl Fn(f64) -> f64 {
    move |k| 0.5 - BEND * (k - top) * (k - top)
}

/// A comparator of this delay, which takes twice as long at 3.75e-4 of full scale: 3.75 mV of 10 V.
fn late(parts: &mut AnalogParts, seconds: f64) {
    (parts.comparator.delay, parts.comparator.overdrive) = (seconds, 3.75e-4 * seconds * parts.full_scale);
}

/// Delay of such a comparator (steps) against an input that leaves its threshold at `slope` shares a step.
fn delay(seconds: f64, slope: f64) -> f64 {
    let charge = 3.75e-4 * seconds / H;
    let most = (12.5 * seconds).min(seconds.max(500e-9)) - seconds;
    seconds / H + (2.0 * charge / slope).sqrt().min(most / H)
}

fn first_off(out: &Driven<f64>) -> f64 {
    out.on[0][0][1]
}

fn slow(seconds: f64) -> AnalogParts {
    parts(|parts| late(parts, seconds))
}

proptest! {
    /// A13: the derivative's slope is `2 bend tau_d / h` a step.
    #[test]
    fn a_crest_is_cut_late_by_the_comparators_delay(top in 20.0..30.0_f64, seconds in 0.0..500e-9_f64) {
        let out = run(Occlusion::Derivative, &slow(seconds), 60, crest(top));
        let expected = top + delay(seconds, 2.0 * BEND * DERIVATIVE / H);
        prop_assert!((first_off(&out) - expected).abs() < 1e-7, "{} {expected}", first_off(&out));
    }
}

#[test]
fn the_edge_moves_in_proportion_to_the_delay() {
    // So bent that overdrive does not count: in steps of h = 50 ns, 95 m/us are 4.75 m a step.
    for occlusion in BOTH {
        let at = |seconds: f64| first_off(&run(occlusion, &slow(seconds), 80, hollow(40.0, 60.0, 0.02)));
        let clean = at(0.0);
        assert!((clean - 40.0).abs() < 1e-9, "{clean}");
        let [one, two] = [at(40e-9) - clean, at(80e-9) - clean];
        // 3.8 m of 40 ns at 95 m/us, and the overdrive's share.
        assert!(one * 4.75 >= 3.8 - 1e-9 && one * 4.75 < 3.8 * 1.6, "{one}");
        assert!(two > 1.7 * one && two < 2.01 * one, "{occlusion:?}: {one} {two}");
    }
}

#[test]
fn the_beam_writes_on_downwards_behind_a_crest() {
    // A14: t_c / h samples more, eta'' t_c^2 / 2 deep.
    let out = run(Occlusion::Derivative, &slow(100e-9), 60, crest(25.0));
    let late = first_off(&out) - 25.0;
    let depth = 0.5 - share_at(&out, first_off(&out));
    assert!(late > 2.0);
    let blank = out.blank(0);
    assert!((0..60).all(|k| (blank[k] == 1.0) == (k as f64 > 25.0 + late)));
    assert!((depth - BEND * late * late).abs() < 0.3 * BEND, "{depth} {late}");
}

#[test]
fn nominal_delays_are_trimmed_out() {
    // The same ground goes off as without lags: seen on the clock of the intensity, which is 2 tau late.
    for bandwidth in [8e6, 1e6] {
        let lagged = parts(|parts| parts.projection.bandwidth = Some(bandwidth));
        let out = run(Occlusion::Derivative, &lagged, 400, |k| 0.5 - 2e-5 * (k - 200.3) * (k - 200.3));
        let late = 2.0 * time_constant(bandwidth) / H;
        assert!((first_off(&out) - 200.3 - late).abs() < 1e-6, "{bandwidth}: {}", first_off(&out));
        let ground = 400.0 * out.intensity[300][0];
        assert!((ground - (300.0 - late)).abs() < 1e-9, "{ground}");
    }
}

#[test]
fn position_lags_as_long_as_the_intensity() {
    let lagged = parts(|parts| parts.projection.bandwidth = Some(2e6));
    for occlusion in BOTH {
        let out = run(occlusion, &lagged, 300, |k| -0.9 + 0.005 * k);
        let late = 2.0 * time_constant(2e6) / H;
        let line = 250.0 - 250.0 * (-0.9 + 0.005 * (250.0 - late));
        assert!((out.position[250][0] - line).abs() < 1e-6, "{}", out.position[250][0]);
        assert_eq!(out.on[0], vec![[0.0, 299.0]]);
    }
}

#[test]
fn slow_video_needs_less_of_the_delay_line() {
    let lagged = parts(|parts| {
        parts.projection.bandwidth = Some(2e6);
        parts.video_bandwidth = Some(4e6);
    });
    let out = run(Occlusion::PeakHold, &lagged, 100, |k| 0.001 * k);
    let late = (2.0 * time_constant(2e6) - time_constant(4e6)) / H;
    assert!((100.0 * out.intensity[60][0] - (60.0 - late)).abs() < 1e-9);
}

#[test]
fn hidden_ground_returns_at_the_crest_with_the_errors_of_the_hold() {
    // A15: V_p - D t, droop counted positive where the hold sinks.
    for (pedestal, droop) in [(0.0, 0.0), (0.02, 0.0), (0.0, 2e4), (0.02, 2e4), (0.01, -1e4)] {
        let faulty = parts(|parts| {
            parts.full_scale = 10.0;
            parts.sample_hold.pedestal = 10.0 * pedestal;
            parts.sample_hold.droop = 10.0 * droop;
        });
        for occlusion in BOTH {
            let out = run(occlusion, &faulty, 200, hollow(40.0, 90.0, 0.005));
            let [[_, off], [on, end]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
            assert_eq!(end, 199.0);
            let error = share_at(&out, on) - 0.3;
            let expected = pedestal - droop * (on - off) * H;
            assert!((error - expected).abs() < 1e-9, "{occlusion:?} {error} {expected}");
            // Bodies and silhouettes see the highest that was held.
            assert!(out.line.windows(2).all(|pair| pair[1][0] <= pair[0][0]));
            assert!((out.line[41][0] - 250.0 * (0.7 - pedestal)).abs() < 0.3);
        }
    }
}

#[test]
fn a_late_return_is_late_by_delay_and_hysteresis() {
    let rate = 0.005;
    let slow = parts(|parts| {
        parts.comparator.hysteresis = 0.004;
        late(parts, 100e-9);
    });
    let out = run(Occlusion::PeakHold, &slow, 200, hollow(40.0, 90.0, rate));
    let [[_, off], [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
    let held = 0.002 / rate + delay(100e-9, rate);
    assert!((off - (40.0 + held)).abs() < 1e-9, "{off}");
    assert!((on - (140.0 + held)).abs() < 1e-9, "{on}");
}

/// An offset moves the thresholds together: on a ramp of slope s by `o / s`, down and up alike.
#[test]
fn an_offset_moves_the_edges_by_itself_over_the_slope() {
    let rate = 0.005;
    for volts in [0.5e-3, 2e-3] {
        let off_by = parts(|parts| {
            parts.comparator.hysteresis = 0.02;
            parts.comparator.offset = volts;
        });
        let offset = Spread::new(1970).error("dpp.hold.comparator.offset", 0, volts);
        assert!(offset.abs() > 1e-4 && offset.abs() < 0.01);
        let out = run(Occlusion::PeakHold, &off_by, 200, hollow(40.0, 90.0, rate));
        let [[_, off], [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
        assert!((off - (40.0 + (0.01 - offset) / rate)).abs() < 1e-9, "{off}");
        assert!((on - (140.0 + (0.01 + offset) / rate)).abs() < 1e-9, "{on}");
    }
}

/// The comparator behind the differentiator: on a parabola the derivative's slope is `2 bend tau_d / h` a step.
#[test]
fn an_offset_finds_a_fall_sooner_or_later() {
    for volts in [0.5e-3, 2e-3] {
        let off_by = parts(|parts| parts.comparator.offset = volts);
        let offset = Spread::new(1970).error("dpp.derivative.comparator.offset", 0, volts);
        let out = run(Occlusion::Derivative, &off_by, 60, crest(25.3));
        let expected = 25.3 + offset / (2.0 * BEND * DERIVATIVE / H);
        assert!(offset != 0.0 && (first_off(&out) - expected).abs() < 1e-9, "{} {expected}", first_off(&out));
    }
}

#[test]
fn noise_makes_the_return_jitter_by_sigma_over_slope() {
    let (rate, sigma) = (0.005, 0.0005);
    let noisy = parts(|parts| parts.amplifier.noise = sigma);
    let out = run(Occlusion::PeakHold, &noisy, 200, hollow(40.0, 90.0, rate));
    let off: Vec<f64> = out.on.iter().map(|on| on.last().unwrap()[0] - 140.0).collect();
    let spread = (off.iter().map(|at| at * at).sum::<f64>() / off.len() as f64).sqrt();
    assert!(spread > 0.3 * sigma / rate && spread < 3.0 * sigma / rate, "{spread}");
}

#[test]
fn a_dip_shorter_than_the_delay_still_leaves_its_gap() {
    // The peak detector has followed the rise when the blank comes.
    let rate = 0.02;
    let out = run(Occlusion::PeakHold, &slow(200e-9), 80, hollow(40.0, 41.0, rate));
    let [[_, off], [on, end]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
    let held = delay(200e-9, rate);
    assert!((off - 40.0 - held).abs() < 1e-9, "{off}");
    assert!(on > off && on - off <= 500e-9 / H && end == 79.0, "{on}");
}

#[test]
fn a_slow_sample_and_hold_holds_what_it_has_tracked() {
    // Acquisition 400 ns: tau = 400 / 6.9 = 57.9 ns, a ramp is tracked that much late.
    let slow = parts(|parts| parts.sample_hold.acquire = 400e-9);
    let rate = 0.005;
    let out = run(Occlusion::Derivative, &slow, 200, hollow(80.0, 120.0, rate));
    let [_, [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
    let tau = 400e-9 / libm::log(1000.0) / H;
    assert!((share_at(&out, on) - (0.3 - rate * tau)).abs() < 1e-7, "{}", share_at(&out, on));
    // The peak detector is met by the elevation on its way down: `rate tau (1 - e^-x) = rate x`.
    let out = run(Occlusion::PeakHold, &slow, 200, hollow(80.0, 120.0, rate));
    let [[_, off], [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
    assert!(off > 80.0 && off < 81.0, "{off}");
    let below = 0.3 - share_at(&out, on);
    assert!(below > 0.0 && below < rate * tau, "{below}");
}

#[test]
fn a_sample_and_hold_goes_on_from_where_it_held() {
    // One that never acquires: what the first sample left, a pedestal and a droop.
    let stuck = parts(|parts| {
        parts.sample_hold.acquire = f64::INFINITY;
        parts.sample_hold.pedestal = 0.02;
        parts.sample_hold.droop = 3e3;
    });
    let out = run(Occlusion::Derivative, &stuck, 200, hollow(80.0, 120.0, 0.005));
    let [[_, off], [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
    let left = -0.1 + 0.02 - 3e3 * (on - off) * H;
    assert!((out.hold[199][0] - HALF * left).abs() < 1e-12, "{}", out.hold[199][0]);
    assert_eq!((off, on), (80.0, 120.0));
}

#[test]
fn the_differentiators_lateness_is_that_of_a_parabola() {
    for lag in [1e-9, 20e-9, 50e-9, 400e-9] {
        let part = parts::Differentiator::<f64>::new(H, H, lag);
        let mut state = parts::SecondOrderState { y: 0.0, rate: 0.0 };
        let square = |k: i32| 0.5 * f64::from(k * k);
        let rate = (1..=2000).map(|k| part.step(&mut state, square(k - 1), square(k))).last();
        let late = 2000.0 - rate.unwrap();
        assert!((late - lateness(H, lag)).abs() < 1e-7, "{lag}: {late} {}", lateness(H, lag));
    }
    assert_eq!(lateness(H, 0.0), 0.5);
    assert!((lateness(H, 1e-3) * H / 2e-3 - 1.0).abs() < 1e-3);
}

/// A15: what is held is as old as the aperture says: hidden ground returns lower by its rise in that time.
#[test]
fn an_aperture_takes_what_there_was() {
    let rate = 0.005;
    for aperture in [10e-9, 20e-9, 100e-9, 210e-9] {
        let late = parts(|parts| parts.sample_hold.aperture = aperture);
        let out = run(Occlusion::Derivative, &late, 200, hollow(40.0, 90.0, rate));
        let [[_, off], [on, _]] = out.on[0][..] else { panic!("{:?}", out.on[0]) };
        let held = share_at(&out, off) - rate * aperture / H;
        assert!((share_at(&out, on) - held).abs() < 1e-9, "{aperture:e}: {held}");
    }
}

/// A peak detector has had its peak for as long as its comparator takes: an aperture shorter than that takes nothing away.
#[test]
fn a_peak_detector_does_not_mind_a_short_aperture() {
    let late = |aperture: f64| {
        let parts = parts(|parts| {
            late(parts, 100e-9);
            parts.sample_hold.aperture = aperture;
        });
        run(Occlusion::PeakHold, &parts, 200, hollow(40.0, 90.0, 0.005)).on
    };
    assert_eq!(late(0.0), late(60e-9));
}

/// Jitter: the held values of many sweeps spread by the rise of the elevation in it.
#[test]
fn jitter_spreads_what_is_held() {
    let (rate, jitter) = (0.005, 5e-9);
    let shaky = parts(|parts| {
        parts.sample_hold.aperture = 100e-9;
        parts.sample_hold.jitter = jitter;
    });
    let out = run(Occlusion::Derivative, &shaky, 200, hollow(40.0, 90.0, rate));
    let off = |lane: usize| out.hold[60][lane] / HALF - (0.3 - rate * 100e-9 / H);
    let sigma = ((0..LANES).map(|lane| off(lane) * off(lane)).sum::<f64>() / LANES as f64).sqrt();
    let expected = rate * jitter / H;
    assert!(sigma > 0.3 * expected && sigma < 2.0 * expected, "{sigma} {expected}");
    assert_eq!(run(Occlusion::Derivative, &shaky, 200, hollow(40.0, 90.0, rate)).on, out.on);
}

/// Breaks of the light are as late as its samples, and no straight line goes across one.
#[test]
fn breaks_are_delayed_like_their_samples() {
    let slow = parts(|parts| parts.projection.bandwidth = Some(2e6));
    let late = 2.0 * time_constant(2e6) / H;
    let ranges: Vec<f64> = (0..60).map(|k| 1.0 + 1e-6 * f64::from(k)).collect();
    let light = |time: f64| if time < 20.4 { 0.1 + 0.01 * time } else { 0.9 - 0.01 * time };
    let samples: Vec<Lanes<f64>> = (0..60).map(|k| Lanes::splat(light(f64::from(k)))).collect();
    let mut breaks = Breaks::<f64>::default();
    breaks[3].push(Break { sample: 21, share: 0.4, height: 0.0, before: 0.304, after: 0.696 });
    let processor =
        PartsProcessor::new((Occlusion::PeakHold, Curvature::None), &ranges, LINES, H, &slow, 1970);
    let mut out = Driven::default();
    let height: Vec<Lanes<f64>> = ranges.iter().map(|z| Lanes::splat(0.1 * z)).collect();
    processor.run(
        &height,
        (&samples, &breaks),
        &[level(); LANES],
        &[0; LANES],
        &mut Scratch::default(),
        &mut out,
    );
    for k in 10..60 {
        let expected = light(k as f64 - late);
        assert!((out.intensity[k][3] - expected).abs() < 1e-9, "{k}: {} {expected}", out.intensity[k][3]);
    }
    let [moved] = out.breaks[3][..] else { panic!("{:?}", out.breaks[3]) };
    assert!((moved.sample as f64 - 1.0 + moved.share - 20.4 - late).abs() < 1e-9);
    assert_eq!((moved.before, moved.after), (0.304, 0.696));
}
