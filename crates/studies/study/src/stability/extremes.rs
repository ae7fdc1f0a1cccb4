//! The extremes of geometry, light and data, each a small change of a scene.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use features::{Crater, Shape};
use quantities::radians;
use scenario::{FieldOfView, RangeLaw, RangeProgramme};

use super::cell::plain;
use super::scene::StabilityScene;

/// A value at the edge of what scenes may have, or beyond it.
#[derive(Debug, Clone)]
pub struct Extreme {
    /// Name of its dimension, a row of the matrix.
    pub row: &'static str,
    /// Name of the extreme.
    pub name: String,
    /// What it does to a scene.
    pub apply: Push,
    /// Whether the machine must refuse it, whatever else the scene is.
    pub refused: bool,
    /// How many roundings of the scalar the signals may be off by, in full scales.
    pub roundings: f64,
    /// How many times more than usual real parts may be off.
    pub shares: f64,
    /// Whether it takes many seconds, and `exact` far more: it is left to a whole study, and to ideal parts.
    pub long: bool,
}

/// A change of a scene by a figure.
#[derive(Debug, Clone, Copy)]
pub struct Push {
    figure: f64,
    change: fn(&mut StabilityScene, f64),
}

impl Push {
    /// Changes `scene` to the extreme.
    pub fn apply(&self, scene: &mut StabilityScene) {
        (self.change)(scene, self.figure);
    }
}

/// Roundings of a sum of 36 products and eleven powers, and of a root and a quotient behind it.
const USUAL: f64 = 2e3;

fn extreme(row: &'static str, name: String, figure: f64, change: fn(&mut StabilityScene, f64)) -> Extreme {
    Extreme {
        row,
        name,
        apply: Push { figure, change },
        refused: false,
        roundings: USUAL,
        shares: 1.0,
        long: false,
    }
}

/// All of them, in the order in which several are put on one scene: ground first, then where the eye stands on it.
pub fn extremes() -> Vec<Extreme> {
    [
        regions(),
        heights(),
        features(),
        light(),
        attitude(),
        azimuths(),
        corners(),
        eyes(),
        ranges(),
        rasters(),
        fields(),
    ]
    .concat()
}

fn light() -> Vec<Extreme> {
    let sun = |degrees: f64| {
        extreme("light", format!("sun at {} deg", plain(degrees)), degrees, |scene, degrees| {
            scene.sun.elevation = radians(degrees);
        })
    };
    let along = extreme("light", "sun along a slope of 10 deg".into(), 10.0, |scene, degrees| {
        let (angle, size) = (radians(degrees), scene.region_size);
        let rise = libm::tan(angle) * size;
        // A plane that rises to the north, lit from the south under its own angle.
        scene.set_words(|north, _| {
            let mut words = [0.0; 9];
            (words[0], words[3]) = (rise * north as f64, rise);
            words
        });
        (scene.sun.elevation, scene.sun.azimuth) = (angle, 0.0);
        scene.craters.clear();
    });
    [sun(0.0), sun(1e-6), sun(90.0), along].into()
}

fn attitude() -> Vec<Extreme> {
    let pitch = |degrees: f64| {
        extreme("attitude", format!("pitch {degrees} deg"), degrees, |scene, degrees| {
            scene.attitude.pitch = radians(degrees);
        })
    };
    let yoke = |degrees: f64| {
        extreme("attitude", format!("yoke at {degrees} deg"), degrees, |scene, degrees| {
            scene.yoke = radians(degrees);
        })
    };
    let pitches = [64.0, -64.0, 66.0, 90.0, -90.0].map(pitch);
    pitches.into_iter().chain([yoke(40.0), yoke(90.0), yoke(180.0)]).collect()
}

/// With an odd number of sweeps the one in the middle runs along the heading.
fn azimuths() -> Vec<Extreme> {
    let off_axis = |quarter: f64, off: f64| {
        let name = format!("heading {:.0} deg and {} rad", quarter * 90.0, plain(off));
        extreme("azimuth", name, quarter * std::f64::consts::FRAC_PI_2 + off, |scene, heading| {
            (scene.attitude.heading, scene.sweeps) = (heading, 47);
        })
    };
    let offs = [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3];
    offs.into_iter().flat_map(|off| [off_axis(0.0, off), off_axis(1.0, -off)]).collect()
}

/// A sweep that passes the next corner at a distance, in units of its region.
fn corners() -> Vec<Extreme> {
    let passing = |distance: f64| {
        extreme("corner", format!("corner at {} regions", plain(distance)), distance, |scene, distance| {
            let (corner, size) = (scene.corner(), scene.region_size);
            let (back, aside) = (0.3 * size, distance * size * FRAC_1_SQRT_2);
            scene.foot = [corner[0] + size - back - aside, corner[1] + size - back + aside];
            (scene.attitude.heading, scene.sweeps) = (FRAC_PI_4, 47);
        })
    };
    let mut all: Vec<Extreme> =
        [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3].into_iter().chain([-1e-12, -1e-6]).map(passing).collect();
    all.push(extreme("corner", "corner one unit in the last place away".into(), 0.0, |scene, _| {
        let (corner, size) = (scene.corner(), scene.region_size);
        let back = 0.3 * size;
        scene.foot = [(corner[0] + size - back).next_up(), corner[1] + size - back];
        (scene.attitude.heading, scene.sweeps) = (FRAC_PI_4, 47);
    }));
    all.push(extreme("corner", "eye on a corner".into(), 0.0, |scene, _| scene.foot = scene.corner()));
    all
}

/// The whole scene larger or smaller: ground, eye and ranges alike.
fn regions() -> Vec<Extreme> {
    let of = |size: f64| {
        extreme("region", format!("regions of {} m", plain(size)), size, |scene, size| {
            let factor = size / scene.region_size;
            let from_origin = [0, 1].map(|axis| scene.foot[axis] - scene.origin[axis]);
            scene.foot = [0, 1].map(|axis| scene.origin[axis] + factor * from_origin[axis]);
            scene.region_size = size;
            scene.scale_words(factor);
            scene.above *= factor;
            (scene.range.start, scene.range.end) = (scene.range.start * factor, scene.range.end * factor);
            scene.craters.clear();
        })
    };
    [of(0.01), of(1e5)].into()
}

fn heights() -> Vec<Extreme> {
    let of = |highest: f64| {
        extreme("height", format!("heights up to {} m", plain(highest)), highest, |scene, highest| {
            let factor = highest / scene.highest().max(f64::MIN_POSITIVE);
            scene.scale_words(factor);
            scene.craters.clear();
        })
    };
    // A rounding of a slope is one of the light wherever such ground is flat: so many times more as the wall is steep.
    let wall = |slope: f64| Extreme {
        roundings: USUAL.max(slope),
        ..extreme("height", format!("a wall of slope {}", plain(slope)), slope, |scene, slope| {
            let (size, rise) = (scene.region_size, slope * scene.region_size / 1.875);
            let foot = ((scene.foot[0] - scene.origin[0]) / size).floor() as usize;
            // From corner to corner without slope at both: steepest in the middle, 15/8 of the mean.
            scene.set_words(|north, _| {
                let mut words = [0.0; 9];
                words[0] = if north > foot + 3 { rise } else { 0.0 };
                words
            });
            scene.attitude.heading = 0.0;
            scene.craters.clear();
        })
    };
    // All 36 products are at full scale at once, and sums of six of them beyond it, where their amplifiers saturate.
    let alternating = Extreme {
        shares: 4.0,
        ..extreme("height", "words at full scale, signs alternating".into(), 100.0, |scene, full| {
            scene.set_words(|north, east| {
                std::array::from_fn(|word| if (north + east + word) % 2 == 0 { full } else { -full })
            });
            scene.craters.clear();
        })
    };
    [of(1e-9), of(1.0), of(1e6), wall(10.0), wall(1e3), wall(1e6), alternating].into()
}

fn eyes() -> Vec<Extreme> {
    let above = |metres: f64| {
        extreme("eye", format!("eye {} m above the ground", plain(metres)), metres, |scene, metres| {
            scene.above = metres;
        })
    };
    let ridge = extreme("eye", "eye on a ridge line, looking along it".into(), 50.0, |scene, height| {
        let row = ((scene.foot[0] - scene.origin[0]) / scene.region_size).round() as usize;
        scene.set_words(|north, _| {
            let mut words = [0.0; 9];
            words[0] = if north == row { height } else { 0.0 };
            words
        });
        scene.foot[0] = scene.origin[0] + row as f64 * scene.region_size;
        (scene.attitude.heading, scene.sweeps) = (std::f64::consts::FRAC_PI_2, 47);
        scene.craters.clear();
    });
    let under = Extreme { refused: true, ..above(-1.0) };
    let away = Extreme {
        refused: true,
        ..extreme("eye", "eye beyond the stored area".into(), -1e6, |scene, north| scene.foot[0] = north)
    };
    [above(1e-3), above(1e6), ridge, under, away].into()
}

fn ranges() -> Vec<Extreme> {
    let nearly = extreme("range", "ends of the programme a billionth apart".into(), 1e-9, |scene, share| {
        scene.range.law = RangeLaw::Geometric;
        scene.range.end = scene.range.start * (1.0 + share);
    });
    let decades =
        |name: &str, change: fn(&mut StabilityScene, f64)| extreme("range", name.to_owned(), 1e6, change);
    vec![
        nearly,
        decades("1e-3 m to 1e6 m, geometric", |scene, end| {
            scene.range = RangeProgramme { law: RangeLaw::Geometric, start: 1e-3, end };
        }),
        decades("1e-3 m to 1e6 m, constant elevation", |scene, end| {
            scene.range = RangeProgramme { law: RangeLaw::ConstantElevation, start: 1e-3, end };
        }),
        decades("1e-3 m to 1e6 m, constant rate", |scene, end| {
            scene.range = RangeProgramme { law: RangeLaw::ConstantRate, start: 1e-3, end };
        }),
    ]
}

fn features() -> Vec<Extreme> {
    let nested = |name: &str, count: f64| {
        extreme("features", format!("{name} nested craters"), count, |scene, count| {
            let centre = [scene.foot[0] + 60.0, scene.foot[1]];
            let crater = |k: u32| {
                let r1 = 1.0 + 20.0 * f64::from(k) / count;
                Crater::new(centre, Shape::RimmedBowl { r1, r2: 1.3 * r1 }, 1e-4 * r1, 1e-5 * r1)
            };
            scene.craters = (0..count as u32).filter_map(|k| crater(k).ok()).collect();
            scene.attitude.heading = 0.0;
        })
    };
    // Heights are sums over as many craters: their roundings add up.
    let many = Extreme { long: true, roundings: 10.0 * USUAL, ..nested("ten thousand", 1e4) };
    let tiny = extreme("features", "a crater of 1e-6 m".into(), 1e-6, |scene, r1| {
        let centre = [scene.foot[0] + 30.0, scene.foot[1]];
        scene.craters = Crater::new(centre, Shape::Bowl { r1 }, 0.2 * r1, 0.0).into_iter().collect();
    });
    let vast = extreme("features", "a crater larger than the ground".into(), 1e7, |scene, r1| {
        scene.craters = Crater::new(scene.foot, Shape::Bowl { r1 }, 10.0, 0.0).into_iter().collect();
    });
    [nested("three hundred", 300.0), many, tiny, vast].into()
}

fn rasters() -> Vec<Extreme> {
    let samples = |count: f64, refused: bool| Extreme {
        refused,
        ..extreme("samples", format!("{count} samples a sweep"), count, |scene, count| {
            scene.samples = count as u32;
            // The largest count takes its time.
            scene.sweeps = scene.sweeps.min(2);
        })
    };
    [samples(1.0, true), samples(2.0, false), samples(65_536.0, false), samples(1e6, true)].into()
}

/// A view-plane at distance 0 sees half the world, one at infinity a point.
fn fields() -> Vec<Extreme> {
    let of = |degrees: f64, refused: bool| Extreme {
        refused,
        ..extreme("field", format!("field of view {degrees} deg"), degrees, |scene, degrees| {
            let tan_half_width = libm::tan(radians(degrees / 2.0));
            scene.field =
                FieldOfView { tan_half_width, tan_half_height: tan_half_width.min(0.6 * tan_half_width) };
        })
    };
    [of(1e-9, false), of(0.1, false), of(120.0, false), of(170.0, true)].into()
}
