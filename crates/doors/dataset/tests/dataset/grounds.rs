//! Blocks of ground: splits share none, by rule and as measured on the truth.

use dataset::{Maker, Split, Splits};
use drive::{Drive, Wishes};
use files::NpyData;

use crate::scene::{PLAN, Scene};

const SPLITS: Splits = Splits { block_m: 80.0, reach_m: 15.0, shares: [0.5, 0.25, 0.25] };

#[test]
fn a_block_has_one_split_and_blocks_have_the_shares() {
    let mut counts = [0_u64; 3];
    for block in 0..10_000_i32 {
        let [north, east] = [block / 100 - 50, block % 100 - 50].map(|at| f64::from(at) * 80.0);
        let split = SPLITS.of_place(7, [north + 0.001, east + 0.001]);
        assert_eq!(SPLITS.of_place(7, [north + 79.999, east + 79.999]), split);
        counts[split as usize] += 1;
    }
    // Four deviations of a share of 10 000.
    for (found, expected) in counts.into_iter().zip([0.5, 0.25, 0.25]) {
        assert!((found as f64 / 1e4 - expected).abs() < 0.02, "{counts:?}");
    }
    let differs = |at: i32| {
        let place = [f64::from(at) * 80.0 + 1.0, 1.0];
        SPLITS.of_place(7, place) != SPLITS.of_place(8, place)
    };
    assert!((0..100).any(differs), "the seed decides");
}

#[test]
fn a_split_without_a_share_has_no_ground() {
    let splits = Splits { shares: [0.0, 1.0, 0.0], ..SPLITS };
    assert!((0..1000).all(|at| splits.of_place(1, [f64::from(at) * 81.0, 5.0]) == Split::Validation));
    let none = [Splits { shares: [1.0, 0.0, 0.0], ..SPLITS }, Splits { shares: [0.3, 0.7, 0.0], ..SPLITS }];
    assert_eq!(none[0].of_share(0.999_999_999_999), Split::Train);
    assert_eq!(none[1].of_share(0.999_999_999_999_999_9), Split::Validation);
}

#[test]
fn the_reach_is_a_disc() {
    // Marching: every place of a fine lattice within the reach is of the split.
    let mut clear = 0;
    for number in 0..400 {
        let at = [f64::from(number % 20) * 13.0 + 3.0, f64::from(number / 20) * 13.0 + 3.0];
        let split = SPLITS.of_place(7, at);
        let places = (-30..=30).flat_map(|north| (-30..=30).map(move |east| [north, east]));
        let within = places.map(|step: [i32; 2]| step.map(|part| f64::from(part) * 0.5));
        let mut within = within.filter(|[north, east]| north * north + east * east <= 15.0 * 15.0);
        let all = within.all(|[north, east]| SPLITS.of_place(7, [at[0] + north, at[1] + east]) == split);
        let found = SPLITS.is_clear(7, at, split);
        // Between two places of the lattice the disc may touch another block.
        assert!(!found || all, "{at:?}");
        clear += u32::from(found);
    }
    assert!((20..380).contains(&clear), "{clear}");
}

/// The place under each pixel, from the picture's own geometry: the law `exact`, by the formulas of docs/truth-format.md.
fn places(row: &dataset::Row, range: &[f32]) -> Vec<Option<[f64; 2]>> {
    let [heading, pitch, yoke] =
        [row.pose.heading_deg, row.pose.pitch_deg, row.pose.yoke_deg].map(quantities::radians);
    let ((sh, ch), (sp, cp), (sy, cy)) =
        (quantities::sin_cos(heading), quantities::sin_cos(pitch), quantities::sin_cos(yoke));
    let (lines, columns) = (row.shape[0], row.shape[1]);
    let place = |(at, range): (usize, &f32)| {
        let x = row.tan_half_field[0] * ((2 * (at % columns) + 1) as f64 - columns as f64) / columns as f64;
        let y = row.tan_half_field[1] * ((2 * (at / columns) + 1) as f64 - lines as f64) / lines as f64;
        let (right, down) = (x * cy - y * sy, x * sy + y * cy);
        let forward = cp + down * sp;
        let (north, east) = (forward * ch - right * sh, forward * sh + right * ch);
        let over = (north * north + east * east).sqrt();
        let range = f64::from(*range);
        range.is_finite().then(|| [row.pose.x_m + range * north / over, row.pose.y_m + range * east / over])
    };
    range.iter().enumerate().map(place).collect()
}

#[test]
fn splits_share_no_ground_as_measured_on_the_truth() {
    let scene = Scene::new(PLAN);
    let plan = scene.plan();
    let maker = Maker::new(&plan);
    let (mut own, mut other) = (0, 0);
    for sample in 0..plan.samples() {
        let made = maker.make(sample).unwrap_or_else(|error| panic!("{error}"));
        let array = |name: &str| &made.arrays.iter().find(|(found, _)| *found == name).expect("there").1;
        let NpyData::F32(range) = array("range").data() else { panic!("ranges are numbers") };
        let NpyData::U8(split) = array("split").data() else { panic!("splits are codes") };
        for ((place, range), code) in places(&made.row, range).into_iter().zip(range).zip(split) {
            let Some(place) = place else {
                assert_eq!(*code, 0);
                continue;
            };
            let found = plan.splits.of_place(plan.seed, place);
            assert_eq!(*code, if found == made.row.split { 1 } else { 2 }, "sample {sample}, {place:?}");
            assert!(found == made.row.split || f64::from(*range) >= plan.splits.reach_m);
            own += u64::from(*code == 1);
            other += u64::from(*code == 2);
        }
        let ground = made.row.ground;
        assert_eq!(ground.own, split.iter().filter(|code| **code == 1).count() as u64);
        assert!(ground.nearest_other_m.is_none_or(|nearest| nearest >= plan.splits.reach_m), "{ground:?}");
    }
    // The scene is wider than a block: both are seen, or nothing was measured.
    assert!(own > 1000 && other > 100, "{own} {other}");
}

#[test]
fn a_place_is_that_of_the_path() {
    let scene = Scene::new(PLAN);
    let drive = Drive::open(&scene.path("scene.toml"), &Wishes::default(), 1).unwrap();
    let pose = drive.pose(0).unwrap();
    let place =
        drive::Place { at_m: [pose.eye_m[0], pose.eye_m[1]], heading_deg: pose.heading_deg, flight: None };
    let stood = drive.place(0, &place).unwrap();
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
    assert!(stood.eye_m.iter().zip(pose.eye_m).all(|(a, b)| near(*a, b)), "{stood:?} {pose:?}");
    assert!(near(stood.pitch_deg, pose.pitch_deg) && near(stood.roll_deg, pose.roll_deg));
}
