//! The sun that shadows tell: closed loops over hills, and photographs that tell none.

use landscape::Sun;
use photo_check::{FoundSun, Ground, Relief, SunError, find_sun};
use photograph::{Map, MapUnit, Photograph, Placement};
use picture::GreyPicture;
use quantities::{degrees, radians, unit_interval};
use survey::{Affine, Elevation, Frame};

use crate::{ground, map, picture};

/// Posts of the ground along its sides, 10 m apart.
const POSTS: usize = 90;

/// Round hills at random places, 10 to 40 m high.
fn hills(seed: u64) -> impl Fn(f64, f64) -> f64 {
    let hill = move |index: u64| {
        let part = |k: u64| unit_interval(seed, &[index, k]);
        ([0, 1].map(|axis| 890.0 * part(axis)), 10.0 + 30.0 * part(2), 25.0 + 35.0 * part(3))
    };
    let hills: Vec<_> = (0..60).map(hill).collect();
    move |north, east| {
        let height = |(at, height, radius): &([f64; 2], f64, f64)| {
            let [north, east] = [north - at[0], east - at[1]];
            height * libm::exp(-(north * north + east * east) / (radius * radius))
        };
        hills.iter().map(height).sum()
    }
}

/// The ground of `height` with posts `step` m apart, line 0 the northernmost.
fn posts(step: f64, height: impl Fn(f64, f64) -> f64) -> Elevation {
    let side = 10.0 * (POSTS - 1) as f64;
    let count = (side / step) as usize + 1;
    let heights = (0..count * count).map(|at| {
        let [line, column] = [at / count, at % count].map(|post| post as f64 * step);
        height(side - line, column)
    });
    let affine = Affine { first: [side, 0.0], step: [-step, step] };
    Elevation::new(count, count, heights.collect(), affine, Frame::Plane(None))
}

/// A map of the ground of `height`, four pixels a post each way, lit by `sun`: codes are `code(light)`.
fn photo(height: impl Fn(f64, f64) -> f64, sun: &Sun, code: impl Fn(f64) -> f64) -> Photograph {
    let step = 2.5;
    let fine = posts(step, height);
    let blank = map(picture([2, 2], |_, _| 0), MapUnit::Metre);
    let relief = Relief::new(&ground(&fine, &blank), sun);
    let light = |column: usize, line: usize| relief.light([line, column]).expect("known");
    let codes = |column: usize, line: usize| (65_535.0 * code(light(column, line))) as u16;
    placed(picture([fine.columns, fine.lines], codes), step)
}

/// A picture as a map, pixels of `step` m, its first centre at the first post.
fn placed(picture: GreyPicture, step: f64) -> Photograph {
    let north = 10.0 * (POSTS - 1) as f64 + 0.5 * step;
    let map = Map::new([step, 0.0, -0.5 * step], [0.0, -step, north], MapUnit::Metre).expect("a map");
    Photograph::new(picture, Placement::Map(map), Default::default()).expect("a photograph")
}

fn coarse(height: impl Fn(f64, f64) -> f64, photo: &Photograph) -> Ground {
    ground(&posts(10.0, height), photo)
}

fn sun(azimuth: f64, elevation: f64) -> Sun {
    Sun { azimuth: radians(azimuth), elevation: radians(elevation) }
}

/// Azimuth and elevation (deg) by which the found sun is off.
fn off(found: &FoundSun, sun: &Sun) -> [f64; 2] {
    let turn = degrees(found.sun.azimuth - sun.azimuth);
    [(turn + 180.0).rem_euclid(360.0) - 180.0, degrees(found.sun.elevation - sun.elevation)]
}

/// The suns of photographs come back within what is said of them, which is two standard errors: of eight angles one may lie beyond. All
/// come back within half a degree.
#[test]
fn the_sun_of_a_photograph_is_found() {
    let mut beyond = 0;
    for (seed, sun) in
        [(1, sun(40.0, 12.0)), (2, sun(200.0, 20.0)), (3, sun(331.0, 6.0)), (4, sun(359.8, 9.0))]
    {
        let photo = photo(hills(seed), &sun, |light| 0.02 + 0.8 * light);
        let found = find_sun(&coarse(hills(seed), &photo), &photo).expect("shadows");
        let off = off(&found, &sun);
        let said = found.uncertainty.map(degrees);
        for axis in [0, 1] {
            beyond += usize::from(off[axis].abs() > said[axis]);
            assert!(off[axis].abs() < 0.5 && said[axis] < 2.0, "{seed}: {off:?} deg off, {said:?} said");
        }
        assert!(found.overlap > 0.9 && found.common > 0.9, "{found:?}");
        assert!((found.dark[0] - found.dark[1]).abs() < 0.01, "{found:?}");
    }
    assert!(beyond <= 1, "{beyond} of 8 angles lie beyond what is said");
}

/// Threads change no bit of the sun.
#[test]
fn threads_change_no_bit_of_the_sun() {
    let photo = photo(hills(5), &sun(100.0, 15.0), |light| light);
    let ground = coarse(hills(5), &photo);
    let by = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| find_sun(&ground, &photo)).expect("shadows")
    };
    assert_eq!(by(1), by(3));
}

/// Light without shadow, one grey, black, ground without relief, another ground: each is refused for what it is.
#[test]
fn photographs_that_tell_no_sun_are_refused() {
    let low = sun(40.0, 12.0);
    let dark = photo(hills(1), &low, |light| light);
    let lit = photo(hills(1), &sun(40.0, 70.0), |light| light);
    let refused = |height: &dyn Fn(f64, f64) -> f64, photo: &Photograph| {
        find_sun(&coarse(height, photo), photo).expect_err("no sun")
    };
    assert!(matches!(refused(&hills(1), &lit), SunError::NoShadow { .. }));
    for grey in [0, 20_000] {
        let one = placed(picture([90, 90], |_, _| grey), 10.0);
        assert_eq!(refused(&hills(1), &one), SunError::NoShadow { share: 1.0, most: 0.3 });
    }
    assert!(matches!(refused(&|_, _| 5.0, &dark), SunError::NoOverlap { .. }));
    assert!(matches!(refused(&hills(9), &dark), SunError::NoOverlap { .. } | SunError::NoSummit));
    let speck = placed(picture([90, 90], |column, line| if column + line < 4 { 0 } else { 30_000 }), 10.0);
    assert!(matches!(refused(&hills(1), &speck), SunError::NoShadow { .. } | SunError::DarkShare { .. }));
    let small = placed(picture([20, 20], |column, _| 3000 * column as u16), 10.0);
    assert_eq!(refused(&hills(1), &small), SunError::Few { found: 400, expected: 1000 });
}
