//! Populations: sizes by their law, places in their area, the same for the same seed.

use features::population::{Kind, Population, PopulationError, Primary, SizeLaw};
use features::{Crater, Shape};

const AREA: [f64; 4] = [-500.0, 100.0, 1500.0, 1600.0];

fn population(kind: Kind) -> Population {
    let sizes = SizeLaw { density: 0.02, reference: 1.0, slope: 2.0, smallest: 0.8, largest: 60.0 };
    Population { seed: 7, area: AREA, sizes, kind }
}

fn kinds() -> [Kind; 4] {
    let primaries =
        vec![Primary { centre: [0.0, 0.0], radius: 150.0 }, Primary { centre: [900.0, 800.0], radius: 90.0 }];
    [Kind::Fresh, Kind::Degraded, Kind::FlatFloored, Kind::Secondaries(primaries)]
}

/// Of the rim crest, or of the edge where there is no rim.
fn diameter(crater: &Crater) -> f64 {
    crater.foot() + crater.outer()
}

#[test]
fn sizes_follow_the_law() {
    for kind in kinds() {
        let population = population(kind);
        let craters = population.craters().unwrap();
        let surface = (AREA[2] - AREA[0]) * (AREA[3] - AREA[1]);
        // N(>1.6 m) - N(>120 m) = 0.02 (1 / 2.56 - 1 / 14400) a square metre.
        assert_eq!(craters.len() as f64, (surface * 0.02 * (1.0 / 2.56 - 1.0 / 14_400.0)).round());
        for least in [1.6, 2.0, 3.0, 5.0, 10.0, 20.0, 40.0, 80.0, 119.0] {
            let counted = craters.iter().filter(|crater| diameter(crater) >= least).count() as f64;
            let expected = surface * 0.02 * (1.0 / (least * least) - 1.0 / 14_400.0);
            assert!(
                (counted - expected).abs() <= 1.5,
                "{:?} > {least}: {counted}, {expected}",
                population.kind
            );
        }
    }
}

#[test]
fn craters_are_wholly_inside_the_area() {
    for kind in kinds() {
        for crater in population(kind).craters().unwrap() {
            let ([x, y], outer) = (crater.centre(), crater.outer() - 1e-9);
            assert!(x - outer >= AREA[0] && x + outer <= AREA[2], "{crater:?}");
            assert!(y - outer >= AREA[1] && y + outer <= AREA[3], "{crater:?}");
        }
    }
}

#[test]
fn a_seed_names_its_craters() {
    for kind in kinds() {
        let population = population(kind);
        assert_eq!(population.craters(), population.craters());
        let other = Population { seed: 8, ..population.clone() };
        assert_ne!(population.craters(), other.craters());
    }
    // Populations are named by their seed: these numbers never change.
    let first = population(Kind::Fresh).craters().unwrap()[0];
    assert_eq!(first.centre(), [158.98965953150633, 1282.7544287867624]);
    assert_eq!(first.shape(), Shape::RimmedBowl { r1: 46.22168108847401, r2: 64.7103535238636 });
}

#[test]
fn places_cover_the_area_evenly() {
    let craters = population(Kind::Degraded).craters().unwrap();
    let mut quarters = [0.0; 4];
    for crater in &craters {
        let [north, east] = [crater.centre()[0] > 500.0, crater.centre()[1] > 850.0];
        quarters[usize::from(north) * 2 + usize::from(east)] += 1.0;
    }
    let mean = craters.len() as f64 / 4.0;
    // Five standard deviations of a binomial count.
    assert!(quarters.iter().all(|count| (count - mean).abs() < 5.0 * (0.75 * mean).sqrt()), "{quarters:?}");
}

#[test]
fn each_kind_has_its_figures() {
    let shares = |kind: usize| -> Vec<[f64; 3]> {
        let craters = population(kinds()[kind].clone()).craters().unwrap();
        let share = |c: &Crater| [f64::from(c.type_number()), c.depth() / diameter(c), c.rim() / diameter(c)];
        craters.iter().map(share).collect()
    };
    let within = |found: f64, low: f64, high: f64| found > low - 1e-9 && found < high + 1e-9;
    assert!(shares(0).iter().all(|[kind, depth, rim]| {
        *kind == 2.0 && within(*depth, 0.144, 0.176) && within(rim / depth, 0.225, 0.225)
    }));
    let degraded = shares(1);
    assert!(degraded.iter().all(|[kind, depth, rim]| {
        within(*depth, 0.02, 0.12) && within(*rim, 0.0, 0.02) && (*kind == 2.0 || *kind == 1.0 && *rim == 0.0)
    }));
    let bowls = degraded.iter().filter(|share| share[0] == 1.0).count() as f64 / degraded.len() as f64;
    assert!((bowls - 1.0 / 3.0).abs() < 0.02, "{bowls}");
    assert!(shares(2).iter().all(|[kind, depth, _]| *kind == 3.0 && within(*depth, 0.06, 0.085)));
    assert!(shares(3).iter().all(|[kind, depth, _]| *kind == 2.0 && within(*depth, 0.04, 0.08)));
}

#[test]
fn flat_floored_walls_can_stand() {
    let craters = population(Kind::FlatFloored).craters().unwrap();
    let wall = |crater: &Crater| match crater.shape() {
        Shape::FlatFloor { r1, r2, .. } => 2.0 * crater.depth() / (r2 - r1),
        shape => panic!("{shape:?} among the flat-floored"),
    };
    // Tangent of 35 degrees, about the angle of repose.
    assert!(craters.iter().all(|crater| wall(crater) < 0.70));
}

#[test]
fn secondaries_lie_in_groups_around_their_primary() {
    let primary = Primary { centre: [500.0, 850.0], radius: 70.0 };
    let sizes = SizeLaw { density: 0.001, reference: 1.0, slope: 3.0, smallest: 0.5, largest: 2.0 };
    let population = Population { seed: 3, area: AREA, sizes, kind: Kind::Secondaries(vec![primary]) };
    let craters = population.craters().unwrap();
    let offset = |c: &Crater| [c.centre()[0] - 500.0, c.centre()[1] - 850.0];
    let distance = |[x, y]: [f64; 2]| (x * x + y * y).sqrt() / 70.0;
    assert!(craters.iter().all(|crater| (1.3..8.7).contains(&distance(offset(crater)))));
    // Neighbours are much nearer than in a uniform field of the same number over the ring.
    let nearest = |at: &Crater| {
        let others = craters.iter().filter(|other| other.centre() != at.centre());
        let apart = others
            .map(|other| distance([other.centre()[0] - at.centre()[0], other.centre()[1] - at.centre()[1]]));
        apart.fold(f64::INFINITY, f64::min)
    };
    let mean = craters.iter().map(nearest).sum::<f64>() / craters.len() as f64;
    let uniform = 0.5 / (craters.len() as f64 / (std::f64::consts::PI * 60.0)).sqrt();
    assert!(mean < 0.4 * uniform, "{mean} against {uniform}, {} craters", craters.len());
}

#[test]
fn impossible_populations_are_refused() {
    let good = population(Kind::Fresh);
    let sizes = |change: fn(&mut SizeLaw)| {
        let mut population = good.clone();
        change(&mut population.sizes);
        population.craters().unwrap_err()
    };
    assert!(matches!(sizes(|law| law.slope = f64::NAN), PopulationError::Range { what: "slope", .. }));
    assert!(matches!(sizes(|law| law.density = 0.0), PopulationError::Range { what: "density", .. }));
    assert!(matches!(sizes(|law| law.largest = 0.1), PopulationError::Range { .. }));
    assert!(matches!(sizes(|law| law.largest = 700.0), PopulationError::TooLarge { .. }));
    assert!(matches!(sizes(|law| law.density = 10.0), PopulationError::TooMany { .. }));
    let turned = Population { area: [1.0, 0.0, 0.0, 1.0], ..good.clone() };
    assert!(matches!(turned.craters(), Err(PopulationError::Area(_))));
    let none = Population { kind: Kind::Secondaries(Vec::new()), ..good.clone() };
    assert_eq!(none.craters(), Err(PopulationError::NoPrimaries));
    let far = Kind::Secondaries(vec![Primary { centre: [1e6, 0.0], radius: 10.0 }]);
    assert_eq!(Population { kind: far, ..good }.craters(), Err(PopulationError::NoRoom));
}
