//! The interpreter itself against the worked tables of the report (6.6, 23.2b).

use lunoid_tests::lockstep::walk;
use lunoid_tests::{ComparedScene, level_of};
use quantities::radians;
use scenario::{RangeLaw, RangeProgramme};

/// Lattice of check table 23.2b.
fn lattice() -> ComparedScene {
    let word = |m: i64, n: i64, p: i64, q: i64| {
        (17 * m + 29 * n + 37 * p + 43 * q + 11 * m * p + 5 * n * q + 3 * p * q + 13 * m * n) % 23 - 11
    };
    let level = level_of(1.0, [0.0, 0.0], [24, 24], |m, n| {
        std::array::from_fn(|k| word(m as i64, n as i64, k as i64 / 3, k as i64 % 3) as f64)
    });
    let mut scene = ComparedScene::over(level);
    scene.sweeps = 1;
    scene.samples = 45;
    scene.range = RangeProgramme { law: RangeLaw::ConstantRate, start: 0.1, end: 4.5 };
    scene
}

/// One row of the table: lambda, X, Y, h, h_u, h_v.
type Row = [f64; 6];

fn check(foot: [f64; 2], degrees: f64, rows: &[Row]) {
    let mut scene = lattice();
    scene.stand(foot[0], foot[1], 5.0);
    scene.heading = radians(degrees);
    let record = walk(&scene);
    let names = ["sweep.x", "sweep.y", "tg.height", "tg.slope.u", "tg.slope.v"];
    for row in rows {
        let sample = (row[0] * 10.0).round() as usize - 1;
        for (name, expected) in names.iter().zip(&row[1..]) {
            let found = record.signals[*name][sample];
            assert!((found - expected).abs() < 2e-12, "{name} at {}: {found}, expected {expected}", row[0]);
        }
    }
}

#[test]
fn folded_evaluation_of_23_2b() {
    check(
        [2.3, 5.6],
        30.0,
        &[
            [0.5, 0.7330127018922193, 0.15, 13.0531939524914, 1.378730911527492, 3.348800031854315],
            [1.5, 0.400961894323342, 0.35, -2.533217697286623, -23.83061031610626, 24.64515149511407],
            [2.5, 0.4650635094610966, 0.85, -0.4655228807879507, -11.25982725128563, 0.5361735807303523],
            [4.0, 0.2358983848622454, 0.4, 1.740642251427979, -3.07782696675675, 27.22698583769006],
        ],
    );
    check(
        [13.75, 14.2],
        -160.0,
        &[
            [
                0.7,
                0.9077848345501359,
                0.03941410032796811,
                -6.451486601093369,
                14.03489066151824,
                -11.09012670173071,
            ],
            [
                1.5,
                0.3404610688211374,
                0.3130302149885031,
                -0.8582860079182124,
                -11.49719141309457,
                -0.2245129143301464,
            ],
            [
                3.7,
                0.273137303092139,
                0.9345254696950257,
                -4.413187291366016,
                6.253254775453433,
                7.176145515807664,
            ],
        ],
    );
}

#[test]
fn stops_of_6_6() {
    let mut scene = lattice();
    scene.stand(2.3, 5.6, 5.0);
    scene.heading = radians(30.0);
    let record = walk(&scene);
    let expected = [
        (0.8, 1),
        (0.808290376865, 0),
        (1.962990915245, 0),
        (2.8, 1),
        (3.117691453624, 0),
        (4.272391992003, 0),
    ];
    assert_eq!(record.stops.len(), expected.len(), "{:?}", record.stops);
    for (&(time, axis), (range, expected_axis)) in record.stops.iter().zip(expected) {
        // Step k is at range (k + 1) / 10.
        assert!(((time + 1.0) / 10.0 - range).abs() < 1e-11, "{time} against range {range}");
        assert_eq!(axis, expected_axis);
    }
}
