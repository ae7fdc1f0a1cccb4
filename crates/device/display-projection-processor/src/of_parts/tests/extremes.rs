//! Whatever comes in, what goes out is finite and in order.

use hardware_model::AnalogParts;
use proptest::prelude::{any, prop_assert, prop_assert_eq, proptest};
use scenario::{Curvature, Projection};
use signal::{Breaks, LANES, Lanes};

use super::{BOTH, H, LINES, level, parts, run};
use crate::{Deflection, Driven, PartsProcessor, Scratch};

fn is_sound(out: &Driven<f64>, samples: usize) -> bool {
    let last = samples.saturating_sub(1) as f64;
    let signals = [&out.elevation, &out.hold, &out.position, &out.line];
    let finite = signals.iter().all(|signal| {
        signal.len() == samples && signal.iter().all(|value| value.0.iter().all(|value| value.is_finite()))
    });
    finite
        && out.on.iter().all(|on| {
            on.iter().all(|[begin, end]| 0.0 <= *begin && begin < end && *end <= last)
                && on.windows(2).all(|pair| pair[0][1] <= pair[1][0])
        })
}

fn awkward(pick: u8) -> f64 {
    match pick {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => f64::NEG_INFINITY,
        3 => -1_073_741_824.0,
        4 => 1e300,
        _ => f64::from(pick) / 128.0 - 1.0,
    }
}

fn figures(pick: usize) -> AnalogParts {
    let time = [0.0, 1e-15, 40e-9, 1.0, f64::INFINITY][pick % 5];
    parts(|parts| match pick / 5 {
        0 => parts.comparator.delay = time,
        1 => parts.sample_hold.acquire = time,
        2 => parts.projection.bandwidth = Some(1.0 / time.max(1e-300)),
        3 => {
            parts.comparator.hysteresis = 3.0;
            parts.sample_hold.pedestal = -0.5;
            parts.sample_hold.droop = 1.0 / time.max(1e-9);
        }
        _ => {
            parts.amplifier.noise = 0.1;
            parts.sample_hold.pedestal = -0.1;
            parts.comparator.delay = time.min(1.0);
            parts.projection.bandwidth = Some(1e7);
        }
    })
}

proptest! {
    #[test]
    fn nothing_comes_of_nothing(picks in proptest::collection::vec(any::<u8>(), 0..80), figure in 0..25_usize) {
        for occlusion in BOTH {
            let out = run(occlusion, &figures(figure), picks.len(), |k| awkward(picks[k as usize]));
            prop_assert!(is_sound(&out, picks.len()), "{:?}", out.on[0]);
        }
    }

    /// A lane has the bits it has alone, in f32 too.
    #[test]
    fn lanes_do_not_see_one_another(picks in proptest::collection::vec(any::<[u8; LANES]>(), 1..60), figure in 0..25_usize) {
        let ranges: Vec<f64> = (0..picks.len()).map(|k| 10.0 + k as f64).collect();
        for occlusion in BOTH {
            let law = (occlusion, Curvature::Parabolic);
            let processor = PartsProcessor::<f32>::new(law, &ranges, LINES, H, &figures(figure), 3);
            let run = |height: &[Lanes<f32>]| {
                let mut out = Driven::default();
                processor.run(height, (height, &Breaks::default()), &[level(); LANES], &[5; LANES], &mut Scratch::default(), &mut out);
                out
            };
            let value = |pick: u8| f32::from(pick) / 64.0 - 2.0;
            let group: Vec<_> = picks.iter().map(|picks| Lanes(picks.map(value))).collect();
            let together = run(&group);
            for lane in 0..LANES {
                let alone: Vec<_> = group.iter().map(|value| Lanes::splat(value[lane])).collect();
                let alone = run(&alone);
                prop_assert_eq!(&together.on[lane], &alone.on[0]);
                prop_assert!((0..picks.len()).all(|k| together.position[k][lane] == alone.position[k][0]));
                prop_assert!((0..picks.len()).all(|k| together.hold[k][lane] == alone.hold[k][0]));
            }
        }
    }
}

#[test]
fn the_end_of_a_profile_is_no_fall() {
    // A beam that followed would write down the whole picture.
    let late = parts(|parts| parts.comparator.delay = 400e-9);
    for occlusion in BOTH {
        let out = run(occlusion, &late, 60, |k| if k < 40.0 { 0.002 * k } else { -1e9 });
        assert_eq!(out.on[0], vec![[0.0, 39.0]]);
        assert!((out.position[59][0] - out.position[39][0]).abs() < 1e-9);
    }
}

#[test]
fn beyond_the_field_the_beam_waits_at_the_limiter() {
    for occlusion in BOTH {
        let out = run(occlusion, &AnalogParts::ideal(), 100, |k| -8.0 + 0.09 * k);
        assert!((out.position[0][0] - 525.0).abs() < 1e-9);
        assert_eq!(out.on[0], vec![[0.0, 99.0]]);
    }
}

#[test]
fn a_camera_that_looks_up_still_has_a_field() {
    let pitched = [-1.6, -1.2, 0.0, 1.2, 1.6, 3.1]
        .map(|pitch| Deflection::new(Projection::Exact, pitch, 0.3).in_lines(LINES, 0.25));
    let blind = Deflection { a: 1.0, b: 0.0, c: 1.0, e: 0.0 };
    for deflection in pitched.into_iter().chain([blind]) {
        let law = (BOTH[0], Curvature::None);
        let processor = PartsProcessor::new(law, &[1.0, 2.0, 3.0], LINES, H, &figures(24), 1);
        let height = [Lanes::splat(-1.0), Lanes::splat(f64::NAN), Lanes::splat(4.0)];
        let mut out = Driven::default();
        processor.run(
            &height,
            (&height, &Breaks::default()),
            &[deflection; LANES],
            &[0; LANES],
            &mut Scratch::default(),
            &mut out,
        );
        assert!(is_sound(&out, 3), "{deflection:?}: {:?}", out.position);
    }
}
