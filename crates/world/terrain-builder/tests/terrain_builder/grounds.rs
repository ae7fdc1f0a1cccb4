//! Ground that is built: sums, orders, threads, boulders.

use proptest::prelude::{ProptestConfig, Strategy, prop_assert_eq, proptest};
use terrain_builder::{Ground, Warning};

use crate::{FEATURES, HEAD, built, file_of, near};

const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];

fn bits(ground: &Ground) -> Vec<u64> {
    ground.heights().values().iter().map(|height| height.to_bits()).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    /// Any subset in any order, by any way of adding and removing, has the bits of the subset that is built directly.
    #[test]
    fn any_order_of_adding_and_removing_gives_the_bits_of_building_directly(
        order in proptest::sample::subsequence(ALL.to_vec(), 0..=6).prop_shuffle(),
        others in proptest::sample::subsequence(ALL.to_vec(), 0..=6).prop_shuffle(),
    ) {
        let mut sorted = order.clone();
        sorted.sort_unstable();
        let direct = built(&file_of(&sorted));
        let mut text = file_of(&others);
        for &index in order.iter().filter(|index| !others.contains(index)) {
            text = terrain_builder::add(&text, FEATURES[index]).unwrap();
        }
        for index in others.into_iter().filter(|index| !order.contains(index)) {
            text = terrain_builder::remove(&text, name(index)).unwrap();
        }
        let edited = built(&text);
        prop_assert_eq!(bits(&edited), bits(&direct));
        prop_assert_eq!(edited.boulders(), direct.boulders());
    }
}

fn name(index: usize) -> &'static str {
    ["north-crater", "hill", "small-craters", "plain", "a-rock", "rocks"][index]
}

#[test]
fn heights_are_the_base_plus_every_relief() {
    let ground = built(&file_of(&ALL));
    let heights = ground.heights();
    let [rows, columns] = heights.grid().size();
    let mut changed = 0;
    for row in 0..rows {
        for column in 0..columns {
            let place = heights.grid().place(row, column);
            let sum = ground.reliefs().iter().fold(-100.0, |sum, relief| sum + relief.height(place));
            assert_eq!(heights.post(row, column).to_bits(), sum.to_bits(), "{place:?}");
            changed += u32::from(sum != -100.0);
        }
    }
    assert!(changed > 2000, "{changed}");
    // Outside the posts every relief is asked.
    let outside = [heights.grid().extent()[1][0] + 30.0, 0.0];
    let sum = ground.reliefs().iter().fold(-100.0, |sum, relief| sum + relief.height(outside));
    assert_eq!(ground.height(outside), sum);
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let text = file_of(&ALL);
    let of = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let ground = built(&text);
            (bits(&ground), ground.boulders().to_vec(), ground.told())
        })
    };
    let one = of(1);
    assert_eq!(one, of(2));
    assert_eq!(one, of(5));
}

#[test]
fn a_feature_that_is_not_enabled_is_not_built() {
    let without = FEATURES[0].replace("kind", "enabled = false\nkind");
    assert_eq!(bits(&built(&format!("{HEAD}{without}"))), bits(&built(HEAD)));
    let told = built(&format!("{HEAD}{without}")).told();
    assert_eq!((told[0].is_enabled, told[0].share, told[0].area), (false, 0.0, None));
}

#[test]
fn boulders_lie_on_the_ground_with_all_features() {
    let ground = built(&file_of(&ALL));
    assert!(ground.boulders().len() > 100, "{}", ground.boulders().len());
    for placed in ground.boulders() {
        assert_eq!(placed.ground, ground.height(placed.boulder.at()));
        near(placed.middle, placed.ground + placed.boulder.lift().unwrap(), 0.0);
    }
    // On the hill: 120 m high but for growth that stopped after three of its steps.
    let rock = ground.boulders()[0];
    let lowest = |object| {
        let body = rock.body(object).unwrap();
        body.vertices().map(|corner| corner.z).fold(f64::INFINITY, f64::min)
    };
    near(lowest(1), rock.ground, 1e-9);
    assert!(rock.ground > -100.0 + 50.0, "{}", rock.ground);
}

#[test]
fn a_feature_is_told_in_numbers() {
    let crater = FEATURES[0]
        .split("[feature.roughness]")
        .next()
        .unwrap()
        .replace("= 8.0", "= 90.0")
        .replace("500.0", "400.0");
    let ground = built(&format!("{HEAD}{crater}"));
    let told = &ground.told()[0];
    // Bowl: pi R^2 (W - D) / 2. Wall outside: the sum over rings of 1e-4 radii.
    let (radius, wall, depth) = (400.0, 16.0, 80.0);
    let bowl = std::f64::consts::PI * radius * radius * (wall - depth) / 2.0;
    let e = libm::exp(-4.0 * 1.5);
    let ring = (0..15_000).map(|k| {
        let q = 1.0 + (f64::from(k) + 0.5) * 1e-4;
        wall * (libm::exp(-4.0 * (q - 1.0)) - e) / (1.0 - e)
            * 2.0
            * std::f64::consts::PI
            * q
            * 1e-4
            * radius
            * radius
    });
    let volume = bowl + ring.sum::<f64>();
    assert!((told.volume / volume - 1.0).abs() < 0.02, "{} of {volume}", told.volume);
    near(told.range[0], -80.0, 1.0);
    near(told.range[1], 16.0, 2.0);
    let grid = &ground.description().grid;
    let [rows, columns] = grid.size();
    let (_, crater) = ground.craters().next().unwrap();
    let is_near = |row: usize, column: usize| crater.profile_distance(grid.place(row, column)) < 1000.0;
    let near_posts = (0..rows * columns).filter(|post| is_near(post / columns, post % columns)).count();
    near(told.share, near_posts as f64 / (rows * columns) as f64, 1e-3);
    assert_eq!((told.craters, told.boulders, told.kind), (1, 0, "crater"));
}

#[test]
fn what_the_author_should_know_is_told() {
    let far = FEATURES[0]
        .replace("26.06", "26.9")
        .replace("[feature.roughness]\nseeds = [4, 9]\nscale_m = 2.0\n", "");
    let warnings = built(&format!("{HEAD}{far}")).warnings();
    assert_eq!(warnings, [Warning::Outside("north-crater".into(), true)]);
    let small = FEATURES[0].replace("500.0", "20.0");
    let warnings = built(&format!("{HEAD}{small}")).warnings();
    assert_eq!(warnings, [Warning::Narrow("north-crater".into(), 1)]);
    let crowded = FEATURES[5].replace("= 30.0", "= 900.0");
    let warnings = built(&format!("{HEAD}{crowded}")).warnings();
    assert!(matches!(warnings[..], [Warning::LeftOut(_, count)] if count > 100), "{warnings:?}");
    let twice = FEATURES[1].replace("[3.03, 26.02]", "[3.05, 26.03]");
    let warnings = built(&format!("{HEAD}{twice}")).warnings();
    assert_eq!(warnings, [Warning::DroppedPoints("hill".into(), 1)]);
    assert_eq!(built(&file_of(&[1, 3])).warnings(), []);
}
