//! Distributions: counts, laws of size, places, separation.

use proptest::prelude::{ProptestConfig, prop_assert_eq, proptest};
use quantities::degrees;
use terrain_builder::{Distribution, Frame, SizeLaw};

use crate::{MOON, angles, apollo, near};

const RADII: [f64; 2] = [5.0, 200.0];

fn boulders() -> Distribution {
    Distribution {
        seed: 7,
        longitude: angles([3.0, 3.5]),
        latitude: angles([26.0, 26.5]),
        radius: RADII,
        sizes: SizeLaw::ChiSquared,
        density: 0.8e-6,
        separation: 0.0,
        is_even_in_angle: false,
    }
}

/// Share below a radius of the truncated chi-squared distribution of 2 degrees of freedom.
fn chi_squared_below(radius: f64) -> f64 {
    let x = 12.0 * (radius - RADII[0]) / (RADII[1] - RADII[0]);
    (1.0 - libm::exp(-x / 2.0)) / (1.0 - libm::exp(-6.0))
}

/// Largest distance between the empirical distribution of samples and a law (Kolmogorov and Smirnov).
fn farthest(mut samples: Vec<f64>, below: impl Fn(f64) -> f64) -> f64 {
    samples.sort_by(f64::total_cmp);
    let count = samples.len() as f64;
    let apart = |(index, sample): (usize, &f64)| {
        let share = below(*sample);
        (share - index as f64 / count).abs().max(((index + 1) as f64 / count - share).abs())
    };
    samples.iter().enumerate().map(apart).fold(0.0, f64::max)
}

/// The distance that one in a hundred true samples passes.
fn one_per_cent(count: f64) -> f64 {
    1.628 / count.sqrt()
}

#[test]
fn the_count_and_the_median_latitude_of_the_check_table_come_out() {
    assert_eq!(boulders().count(&apollo()), Ok(165));
    near(degrees(boulders().latitude_at(0.5)), 26.249_731_031_633, 1e-11);
}

#[test]
fn the_laws_of_size_of_the_check_table_come_out() {
    let shares = [0.1, 0.5, 0.9, 0.99];
    let chi = [8.415_266_941_761, 27.446_823_601_222, 79.116_949_528_569, 147.535_778_469_109];
    let power = [5.270_279_774_299, 7.068_859_138_436, 15.767_105_501_978, 48.521_398_106_004];
    for ((share, chi), power) in shares.into_iter().zip(chi).zip(power) {
        near(SizeLaw::ChiSquared.radius(share, RADII), chi, 1e-10);
        near(SizeLaw::PowerLaw(2.0).radius(share, RADII), power, 1e-10);
    }
    let count = 1_000_000;
    let radii =
        (0..count).map(|k| SizeLaw::ChiSquared.radius((f64::from(k) + 0.5) / f64::from(count), RADII));
    near(radii.clone().sum::<f64>() / f64::from(count), 37.015_442_226_915, 1e-3);
    let share = |keep: fn(f64) -> bool| radii.clone().filter(|r| keep(*r)).count() as f64 / f64::from(count);
    near(share(|radius| radius < 5.0 + 195.0 / 4.0), 0.778_800_292_772, 1e-6);
    near(share(|radius| radius > 5.0 + 195.0 * 0.75), 0.008_651_689_756, 1e-6);
    for law in [SizeLaw::ChiSquared, SizeLaw::PowerLaw(2.0)] {
        assert_eq!(law.radius(0.0, RADII), 5.0);
        near(law.radius(1.0, RADII), 200.0, 1e-9);
    }
}

#[test]
fn a_hundred_thousand_boulders_follow_the_law_of_size() {
    let frame = apollo();
    let dense = Distribution { density: 1e5 / 206.169_218_612_745e6, ..boulders() };
    let items = dense.items(&frame).unwrap();
    assert_eq!(items.len(), 100_000);
    let radii = items.iter().map(|item| item.radius).collect();
    let found = farthest(radii, chi_squared_below);
    assert!(found < one_per_cent(1e5), "{found}");
}

#[test]
fn places_are_even_in_area_near_a_pole_and_crowd_it_as_reported() {
    let frame = Frame::new(MOON, angles([0.0, 30.0]), angles([60.0, 85.0])).unwrap();
    let area = frame.area(frame.longitude(), frame.latitude());
    let polar = Distribution {
        longitude: frame.longitude(),
        latitude: frame.latitude(),
        density: 1e5 / area,
        ..boulders()
    };
    let [low, high] = frame.latitude().map(libm::sin);
    let even = |latitude: f64| (libm::sin(latitude) - low) / (high - low);
    let latitudes = |of: &Distribution| of.items(&frame).unwrap().iter().map(|item| item.place[0]).collect();
    let found = farthest(latitudes(&polar), even);
    assert!(found < one_per_cent(1e5), "{found}");
    let crowded = Distribution { is_even_in_angle: true, ..polar };
    assert!(farthest(latitudes(&crowded), even) > 0.1);
    let longitudes = polar.items(&frame).unwrap().iter().map(|item| item.place[1]).collect();
    let [west, east] = frame.longitude();
    let found = farthest(longitudes, |longitude| (longitude - west) / (east - west));
    assert!(found < one_per_cent(1e5), "{found}");
}

#[test]
fn numbers_of_an_item_are_independent_of_each_other() {
    let items = Distribution { density: 5e-5, ..boulders() }.items(&apollo()).unwrap();
    let share = |keep: &dyn Fn(&&terrain_builder::Item) -> bool| {
        items.iter().filter(keep).count() as f64 / items.len() as f64
    };
    let is_north = |item: &&terrain_builder::Item| degrees(item.place[0]) > 26.25;
    let is_east = |item: &&terrain_builder::Item| degrees(item.place[1]) > 3.25;
    let is_large = |item: &&terrain_builder::Item| item.radius > 27.446;
    near(share(&|item| is_north(item) && is_east(item)), 0.25, 0.02);
    near(share(&|item| is_north(item) && is_large(item)), 0.25, 0.02);
    near(share(&|item| is_east(item) && is_large(item)), 0.25, 0.02);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn item_17_is_the_same_however_many_are_asked_for(seed: u64, density in 0.1..20.0f64, separation in 0.0..400.0f64) {
        let frame = apollo();
        let of = |density: f64| {
            Distribution { seed, separation, density: density * 1e-6, ..boulders() }.items(&frame).unwrap()
        };
        let (few, many) = (of(density), of(density * 2.0));
        prop_assert_eq!(&many[..few.len()], &few[..]);
    }
}

#[test]
fn items_keep_the_separation_and_those_without_room_are_left_out() {
    let frame = apollo();
    let apart = Distribution { separation: 600.0, ..boulders() };
    let items = apart.items(&frame).unwrap();
    for (index, item) in items.iter().enumerate() {
        for other in &items[..index] {
            let way = [item.at[0] - other.at[0], item.at[1] - other.at[1]];
            assert!((way[0] * way[0] + way[1] * way[1]).sqrt() >= 600.0);
        }
    }
    assert!(items.len() > 150, "{}", items.len());
    let crowded = Distribution { separation: 3000.0, ..boulders() }.items(&frame).unwrap();
    assert!((10..40).contains(&crowded.len()), "{}", crowded.len());
}

#[test]
fn bad_distributions_are_refused_by_their_key() {
    let refused = |distribution: Distribution| distribution.count(&apollo()).expect_err("refused");
    assert_eq!(refused(Distribution { radius: [5.0, 5.0], ..boulders() }).key, "radius_m");
    assert_eq!(refused(Distribution { radius: [f64::NAN, 5.0], ..boulders() }).key, "radius_m");
    assert_eq!(refused(Distribution { density: -1.0, ..boulders() }).key, "density_per_km2");
    assert_eq!(refused(Distribution { density: f64::NAN, ..boulders() }).key, "density_per_km2");
    assert_eq!(refused(Distribution { latitude: [0.2, 0.1], ..boulders() }).key, "latitude_deg");
    assert_eq!(refused(Distribution { longitude: [0.2, 0.1], ..boulders() }).key, "longitude_deg");
    assert_eq!(refused(Distribution { separation: -1.0, ..boulders() }).key, "min_separation_m");
    assert_eq!(refused(Distribution { sizes: SizeLaw::PowerLaw(0.0), ..boulders() }).key, "power");
    let many = refused(Distribution { density: 1.0, ..boulders() }).to_string();
    assert!(many.contains("206169219 items"), "{many}");
    assert_eq!(Distribution { density: 0.0, ..boulders() }.items(&apollo()), Ok(vec![]));
}
