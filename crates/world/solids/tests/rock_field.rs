//! Fields of rocks against their law.

use proptest::prelude::{prop_assert, prop_assert_eq, proptest};
use solids::{Rock, RockField, RockFieldError, SizeLaw, rocks};

const LAW: SizeLaw = SizeLaw { smallest: 0.1, largest: 6.0, density: 0.01, slope: 2.1 };
const AREA: [[f64; 2]; 2] = [[-500.0, -200.0], [700.0, 900.0]];

fn field() -> RockField {
    RockField::new(42, AREA, LAW).unwrap()
}

#[test]
fn counts_follow_the_cumulative_law() {
    let [low, high] = [[-100.0, 0.0], [200.0, 300.0]];
    let rocks = field().rocks_in_box(low, high);
    let surface = 300.0 * 300.0;
    let above = |size: f64| LAW.density * libm::pow(size, -LAW.slope);
    for size in [0.1, 0.13, 0.2, 0.31, 0.4, 0.7, 1.0, 1.6, 3.0] {
        let expected = surface * (above(size) - above(LAW.largest));
        let found = rocks.iter().filter(|rock| rock.size >= size).count() as f64;
        // Poisson: within four standard deviations.
        assert!((found - expected).abs() < 4.0 * expected.sqrt(), "{size} m: {found}, expected {expected}");
        assert!((field().expected(low, high, size) - expected).abs() < 1e-9 * expected);
    }
}

#[test]
fn places_shapes_and_headings_are_spread_evenly() {
    let rocks = field().rocks_in_box([0.0, 0.0], [256.0, 256.0]);
    let mut counts = [[0f64; 4]; 4];
    let mut shapes = [0f64; rocks::SHAPES];
    for Rock { at, shape, heading, .. } in &rocks {
        counts[(at[0] / 64.0) as usize][(at[1] / 64.0) as usize] += 1.0;
        shapes[*shape] += 1.0;
        assert!((0.0..std::f64::consts::TAU).contains(heading));
    }
    let total = rocks.len() as f64;
    for count in counts.iter().flatten() {
        assert!((count - total / 16.0).abs() < 5.0 * (total / 16.0).sqrt(), "{count} of {total}");
    }
    assert!(shapes.iter().all(|count| (count - total / 12.0).abs() < 5.0 * (total / 12.0).sqrt()));
}

#[test]
fn fields_that_cannot_be_are_refused() {
    let with = |law: SizeLaw| RockField::new(1, AREA, law);
    assert_eq!(with(SizeLaw { largest: 0.1, ..LAW }), Err(RockFieldError::Sizes(0.1, 0.1)));
    assert!(matches!(with(SizeLaw { smallest: f64::NAN, ..LAW }), Err(RockFieldError::Sizes(..))));
    assert!(matches!(
        with(SizeLaw { density: -1.0, ..LAW }),
        Err(RockFieldError::Law { what: "density", .. })
    ));
    assert!(matches!(with(SizeLaw { slope: 0.0, ..LAW }), Err(RockFieldError::Law { what: "slope", .. })));
    assert!(matches!(
        with(SizeLaw { smallest: 0.001, density: 10.0, ..LAW }),
        Err(RockFieldError::Crowded(_))
    ));
    assert!(matches!(RockField::new(1, [[0.0; 2], [0.0, 1.0]], LAW), Err(RockFieldError::Area(..))));
    let empty = with(SizeLaw { density: 0.0, ..LAW }).unwrap();
    assert_eq!(empty.rocks_in_box(AREA[0], AREA[1]), []);
}

fn key(rock: &Rock) -> [u64; 3] {
    [rock.at[0].to_bits(), rock.at[1].to_bits(), rock.size.to_bits()]
}

proptest! {
    #[test]
    fn any_box_is_a_part_of_any_larger_one(
        corner in [-600.0..700.0f64, -300.0..900.0],
        sides in [1.0..120.0f64, 1.0..120.0],
        split in 0.0..1.0f64,
        at_least in 0.0..1.0f64,
    ) {
        let field = field();
        let high = [corner[0] + sides[0], corner[1] + sides[1]];
        let middle = corner[0] + split * sides[0];
        let mut whole: Vec<_> = field.rocks_in_box(corner, high).iter().map(key).collect();
        let south = field.rocks_in_box(corner, [middle, high[1]]);
        let north = field.rocks_in_box([middle, corner[1]], high);
        let mut parts: Vec<_> = south.iter().chain(&north).map(key).collect();
        whole.sort();
        parts.sort();
        prop_assert_eq!(whole, parts);
        let mut large = field.rocks_in_box(corner, high);
        prop_assert!(large.iter().all(|rock| (LAW.smallest..=LAW.largest).contains(&rock.size)));
        prop_assert!(large.iter().all(|rock| (0..2).all(|axis| rock.at[axis] >= AREA[0][axis] && rock.at[axis] < AREA[1][axis])));
        large.retain(|rock| rock.size >= at_least);
        prop_assert_eq!(field.larger_in_box(corner, high, at_least), large);
    }
}
