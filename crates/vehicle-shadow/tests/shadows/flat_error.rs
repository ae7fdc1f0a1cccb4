//! Section 19.7 measured: where flat ground has the edge of a shadow, and where true ground has it.

use std::sync::Arc;

use exact::{Ceilings, Outlook, Ray, Sight};
use glam::DVec3;
use landscape::Landscape;
use landscape::relief::{Relief, Undulation};
use landscape::{Attitude, Bank};
use quantities::{radians, unit_interval};
use scenario::{Curvature, FieldOfView, Scenery};
use solids::Solid;
use vehicle_shadow::{Shape, Shot, TrueGround, flat_error, small_flat_error};

use crate::scenes::{stage, sun, to_sun};

/// The report's vehicle: its top at 10 feet, the view port at 5.
const TOP: f64 = 3.048;
const EYE: f64 = 1.524;

fn relief(seed: u64) -> Arc<Landscape> {
    let undulation = Undulation { rms_height: 3.0, hurst: 0.8, longest: 300.0, shortest: 12.0, waves: 200 };
    let relief = Relief {
        seed,
        extent: [800.0, 800.0],
        region_size: 4.0,
        tilt: [0.0; 2],
        undulation: Some(undulation),
        craters: None,
        massifs: Vec::new(),
        rilles: Vec::new(),
    };
    Arc::new(Landscape::new(Bank::new("relief", vec![relief.build().unwrap()], None).unwrap(), 1.0))
}

/// One mast on true ground.
struct Mast<'a> {
    landscape: &'a Landscape,
    ceilings: &'a Ceilings,
    foot: DVec3,
    /// Over the ground, away from the sun.
    away: [f64; 2],
    /// Tangent of the sun's elevation.
    tangent: f64,
}

impl Mast<'_> {
    fn outlook(&self, height: f64) -> Outlook<'_> {
        let eye = [self.foot.x, self.foot.y, self.foot.z + height];
        Outlook::new(self.landscape, self.ceilings, eye, Curvature::None, [0.01, 200.0], None)
    }

    /// Edge of the shadow on true ground, if there is one and the view port sees it.
    fn edge(&self) -> Option<DVec3> {
        let outlook = self.outlook(TOP);
        let Sight::Ground(spot) = outlook.look(&Ray { direction: self.away, rise: -self.tangent }) else {
            return None;
        };
        let edge = DVec3::new(spot.place[0], spot.place[1], outlook.height(&spot));
        let port = self.outlook(EYE);
        let rise = (edge.z - self.foot.z - EYE) / spot.range;
        let Sight::Ground(seen) = port.look(&Ray { direction: self.away, rise }) else { return None };
        ((seen.range - spot.range).abs() < 1e-6).then_some(edge)
    }

    fn flat_edge(&self) -> DVec3 {
        let d = TOP / self.tangent;
        self.foot + DVec3::new(d * self.away[0], d * self.away[1], 0.0)
    }

    fn angle(&self) -> Option<(f64, f64)> {
        let port = self.foot + DVec3::Z * EYE;
        let edge = self.edge()?;
        let [a, b] = [edge, self.flat_edge()].map(|edge| (edge - port).normalize());
        Some((libm::atan2(a.cross(b).length(), a.dot(b)), edge.z - self.foot.z))
    }
}

/// The error that is measured is the formula's, to rounding, and the small-angle form is near it.
#[test]
fn the_formula_holds_on_a_seeded_relief() {
    let ground = |seed| {
        let landscape = relief(seed);
        let ceilings = Ceilings::new(&landscape);
        (seed, landscape, ceilings)
    };
    let grounds: Vec<_> = (1..4).map(ground).collect();
    println!(
        "sun deg | shadow m | mean |rise| m | mean error mrad | largest | mean by the small-angle form | places"
    );
    for elevation in [30.0, 16.7, 8.0] {
        let (mut errors, mut small, mut rises) = (Vec::new(), 0.0, 0.0);
        for (seed, landscape, ceilings) in &grounds {
            for index in 0..300 {
                let part = |k: u64| unit_interval(*seed, &[index, k]);
                let [x, y] = [100.0 + 600.0 * part(0), 100.0 + 600.0 * part(1)];
                let azimuth = std::f64::consts::TAU * part(2);
                let mast = Mast {
                    landscape,
                    ceilings,
                    foot: DVec3::new(x, y, landscape.height(x, y).unwrap()),
                    away: [libm::cos(azimuth), libm::sin(azimuth)],
                    tangent: libm::tan(radians(elevation)),
                };
                let Some((measured, rise)) = mast.angle() else { continue };
                let d = TOP / mast.tangent;
                let expected = flat_error(TOP, EYE, rise, d);
                assert!((measured - expected).abs() < 1e-9, "{elevation} deg: {measured}, not {expected}");
                small += small_flat_error(TOP, EYE, rise, d);
                rises += rise.abs();
                errors.push(measured);
            }
        }
        let count = errors.len() as f64;
        let (mean, largest) =
            (errors.iter().sum::<f64>() / count, errors.iter().copied().fold(0.0, f64::max));
        println!(
            "{elevation} | {:.2} | {:.3} | {:.2} | {:.1} | {:.2} | {}",
            TOP / libm::tan(radians(elevation)),
            rises / count,
            1e3 * mean,
            1e3 * largest,
            1e3 * small / count,
            errors.len()
        );
        assert!(errors.len() > 600 && mean > 1e-3, "{mean} of {}", errors.len());
        assert!((small / count / mean - 1.0).abs() < 0.35, "small angles: {} for {mean}", small / count);
    }
}

/// The edge that pictures of true ground show lies where the formula has it.
#[test]
fn pictures_of_true_ground_show_that_error() {
    let landscape = relief(9);
    let ceilings = Ceilings::new(&landscape);
    let (size, elevation) = ([4, 6000], 20.0);
    let mut checked = 0;
    for index in 0..12 {
        let [x, y] = [150.0 + 40.0 * f64::from(index), 420.0];
        let foot = DVec3::new(x, y, landscape.height(x, y).unwrap());
        let tangent = libm::tan(radians(elevation));
        let mast = Mast { landscape: &landscape, ceilings: &ceilings, foot, away: [1.0, 0.0], tangent };
        let Some((expected, _)) = mast.angle() else { continue };
        // A wide plate whose upper edge is square to the sun, the eye over its face.
        let plate = Solid::boxed(DVec3::new(-0.001, -1.0, 0.0), DVec3::new(0.0, 1.0, TOP), 1.0).unwrap();
        let field = FieldOfView { tan_half_width: 0.001, tan_half_height: 0.6 };
        let attitude = Attitude::default();
        let shot = Shot {
            time: 0.0,
            eye: [x, y, foot.z + EYE],
            height: EYE,
            vehicle: attitude,
            camera: attitude,
            field,
        };
        let truth = TrueGround::new(stage(&landscape, Scenery::still(sun(180.0, elevation)), [4, 6000]));
        let gates = truth
            .gates(&Shape::new(vec![plate], EYE), &shot, &[to_sun(180.0, elevation)], &[], size)
            .suns
            .remove(0);
        let Some(first) = gates.lines.iter().position(|gate| gate.holds(0.0003)) else { continue };
        let seen = 0.6 * (2.0 * first as f64 - 6000.0) / 6000.0;
        let flat = EYE * tangent / TOP;
        let measured = (libm::atan(seen) - libm::atan(flat)).abs();
        assert!((measured - expected).abs() < 3e-4, "{index}: {measured}, not {expected}");
        checked += 1;
    }
    assert!(checked >= 6, "{checked}");
}
