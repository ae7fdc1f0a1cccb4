//! Numbers of normals, and which patterns travel (check values 8.4, acceptance tests 5 and 13).

use std::f64::consts::TAU;

use faces::{Board, GridVertex, Pattern, TwoSine};
use quantities::radians;

use crate::near;

const TWO: TwoSine = TwoSine { lengths: [40.0, 25.0], turned: std::f64::consts::PI / 6.0 };

fn vertex(row: i64, column: i64, place: [f64; 2]) -> GridVertex {
    GridVertex { row, column, place }
}

#[test]
fn two_sines_at_four_places() {
    assert!((radians(30.0) - TWO.turned).abs() < 1e-15);
    let expected = [
        ([7.0, 13.0], [0.891006524188368, -0.015626356215307], 11),
        ([-7.0, 13.0], [-0.891006524188368, 0.109814792777855], 4),
        ([10.0, 0.0], [1.0, 0.822067943874812], 15),
        ([123.0, -45.0], [0.453990499739547, 0.767118182973372], 12),
    ];
    for (place, sines, number) in expected {
        let found = TWO.sines(place);
        near(found[0], sines[0]);
        near(found[1], sines[1]);
        assert_eq!(Pattern::TwoSine(TWO).number(vertex(0, 0, place), 16), number, "{place:?}");
    }
}

#[test]
fn the_hash_of_rows_and_columns() {
    assert_eq!(quantities::mix(0), 16294208416658607535);
    for (row, column, number) in [(0, 0, 11), (0, 1, 6), (1, 0, 5), (-1, 2, 8)] {
        assert_eq!(Pattern::Random { seed: 1 }.number(vertex(row, column, [9.0; 2]), 16), number);
    }
}

#[test]
fn a_crest_of_both_sines_falls_on_the_first_normal() {
    let both = TwoSine { lengths: [40.0, 40.0], turned: 0.0 };
    assert_eq!(Pattern::TwoSine(both).number(vertex(0, 0, [10.0, 0.0]), 16), 0);
    assert_eq!(Pattern::TwoSine(both).number(vertex(0, 0, [30.0, 0.0]), 16), 0);
}

#[test]
fn rows_mirror_and_swell_does_not() {
    let number = |pattern: Pattern, row| pattern.number(vertex(row, 1, [5.0, 0.0]), 16);
    let (mirror, swell) = (Pattern::MirrorRows { length: 40.0 }, Pattern::Swell { length: 40.0 });
    // sin(45 deg) = 0.707: (2.707 / 4) 16 = 10.8, (1.293 / 4) 16 = 5.2.
    assert_eq!([-2, -1, 0, 1].map(|row| number(mirror, row)), [5, 10, 5, 10]);
    assert_eq!([-2, -1, 0, 1].map(|row| number(swell, row)), [10; 4]);
}

#[test]
fn travelling_phase_is_even_along_its_way() {
    let at = |pattern: Pattern, place| pattern.number(vertex(0, 0, place), 16);
    let along = Pattern::Travelling { length: 40.0 };
    assert_eq!([-2.5, 0.0, 2.5, 39.9, 40.0].map(|x| at(along, [x, 7.0])), [15, 0, 1, 15, 0]);
    let rings = Pattern::Radial { length: 40.0 };
    assert_eq!(at(rings, [3.0, 4.0]), 2);
    assert_eq!(at(rings, [0.0, -45.0]), 2);
}

/// Amplitude of order `order` of exp(i phi(x)) over a wave, by the mean over many places.
fn harmonic(phase: impl Fn(f64) -> f64, order: f64) -> f64 {
    let count = 4096;
    let mut sum = [0.0; 2];
    for k in 0..count {
        let turn = TAU * f64::from(k) / f64::from(count);
        let (sin, cos) = libm::sincos(phase(turn) - order * turn);
        sum = [sum[0] + cos, sum[1] + sin];
    }
    libm::hypot(sum[0], sum[1]) / f64::from(count)
}

/// Phase of the normals over a wave by the numbers of a pattern, of a table so long that steps do not matter.
fn phase_of(pattern: Pattern) -> impl Fn(f64) -> f64 {
    const COUNT: u32 = 1 << 24;
    move |turn| {
        let x = 40.0 * turn / TAU;
        TAU * f64::from(pattern.number(vertex(1, 0, [x, 0.0]), COUNT)) / f64::from(COUNT)
    }
}

#[test]
fn a_sine_has_waves_of_both_directions_and_an_even_phase_has_one() {
    let swell = phase_of(Pattern::Swell { length: 40.0 });
    let expected = [0.472001215768235, 0.566824088905874, 0.249701629135204, 0.069035888293596];
    for (order, amplitude) in expected.into_iter().enumerate() {
        for order in [order as f64, -(order as f64)] {
            let found = harmonic(&swell, order);
            assert!((found - amplitude).abs() < 1e-6, "order {order}: {found}");
        }
    }
    let travelling = phase_of(Pattern::Travelling { length: 40.0 });
    assert!((harmonic(&travelling, 1.0) - 1.0).abs() < 1e-6);
    assert!(harmonic(&travelling, -1.0) < 1e-6);
}

/// Columns by which the brightness of a row moves in one frame of 16 to a turn, summed over a turn.
fn drift(pattern: Pattern) -> i64 {
    let cone = faces::Cone::new(16, radians(75.0)).expect("a cone");
    let row = |frame: u32| -> Vec<f64> {
        let sun = faces::sun_vector(TAU * f64::from(frame) / 16.0, radians(60.0));
        let at = |column: i64| vertex(1, column, [column as f64 * 2.5, 2.5]);
        let normal = |column| cone.normal(pattern.number(at(column), 16));
        (0..320).map(|column| faces::brightness(normal(column), sun)).collect()
    };
    // The shift of a pattern of many waves is looked for within half a wave; ties count for nothing.
    let moved = |before: &[f64], after: &[f64]| -> i64 {
        let likeness = |shift: i64| -> f64 {
            (0..320_i64).map(|k| before[k as usize] * after[(k + shift).rem_euclid(320) as usize]).sum()
        };
        let best = (-7..=7).map(likeness).fold(f64::MIN, f64::max);
        let ties: Vec<i64> = (-7..=7).filter(|&shift| likeness(shift) > best - 1e-9).collect();
        if ties.len() == 1 { ties[0] } else { 0 }
    };
    (0..16).map(|frame| moved(&row(frame), &row(frame + 1))).sum()
}

#[test]
fn only_the_travelling_pattern_drifts() {
    // 16 frames make a turn, so the bands go one wavelength of 16 columns.
    assert_eq!(drift(Pattern::Travelling { length: 40.0 }), 16);
    assert_eq!(drift(Pattern::Swell { length: 40.0 }), 0);
    // Both sines along the row, so that the row closes on itself.
    assert_eq!(drift(Pattern::TwoSine(TwoSine { lengths: [40.0, 25.0], turned: 0.0 })), 0);
}

#[test]
fn patterns_do_not_depend_on_extent() {
    let patterns = [
        Pattern::Random { seed: 7 },
        Pattern::TwoSine(TWO),
        Pattern::MirrorRows { length: 37.0 },
        Pattern::Swell { length: 37.0 },
        Pattern::Travelling { length: 37.0 },
        Pattern::Radial { length: 37.0 },
    ];
    let small = Board::new(3.3, -2..4, 5..9).expect("a board");
    let large = Board::new(3.3, -50..40, -60..70).expect("a board");
    for pattern in patterns {
        pattern.check().expect("a pattern");
        let mut compared = 0;
        for here in small.grid() {
            let there = large.grid().find(|there| (there.row, there.column) == (here.row, here.column));
            let there = there.expect("a vertex of the larger board");
            assert_eq!(here.place.map(f64::to_bits), there.place.map(f64::to_bits));
            assert_eq!(pattern.number(here, 16), pattern.number(there, 16));
            compared += 1;
        }
        assert_eq!(compared, 7 * 5);
    }
}

#[test]
fn wavelengths_out_of_range_are_refused() {
    for length in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let two = |lengths| Pattern::TwoSine(TwoSine { lengths, turned: 0.0 });
        for pattern in [
            Pattern::MirrorRows { length },
            Pattern::Swell { length },
            Pattern::Travelling { length },
            Pattern::Radial { length },
            two([length, 25.0]),
            two([40.0, length]),
        ] {
            assert!(pattern.check().is_err(), "{pattern:?}");
        }
    }
    assert!(Pattern::TwoSine(TwoSine { turned: f64::NAN, ..TWO }).check().is_err());
}
