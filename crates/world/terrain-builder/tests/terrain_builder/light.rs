//! Sun and light maps.

use glam::DVec3;
use quantities::{degrees, radians};
use terrain_builder::{Frame, Grid, Heights, Light, LightMap, Method};

use crate::{MOON, angles, built, file_of, near};

/// A square grid of about 8 km, 50 m apart; the last tile is finer.
fn grid() -> Grid {
    let side = degrees(8000.0 / MOON) / 2.0;
    let frame = Frame::new(MOON, angles([-side, side]), angles([-side, side])).unwrap();
    Grid::new(&frame, 50.0, 5).unwrap()
}

fn heights(of: impl Fn([f64; 2]) -> f64) -> Heights {
    let grid = grid();
    let [rows, columns] = grid.size();
    let values = (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column]));
    Heights::new(grid, values.map(|[row, column]| of(grid.place(row, column))).collect())
}

fn sun(elevation: f64, azimuth: f64) -> DVec3 {
    let (sin, cos) = quantities::sin_cos(radians(azimuth));
    let (up, level) = quantities::sin_cos(radians(elevation));
    DVec3::new(level * cos, level * sin, up)
}

#[test]
fn the_shadow_of_a_peak_is_as_long_as_its_height_over_the_tangent() {
    let cone = |[north, east]: [f64; 2]| (200.0 - (north * north + east * east).sqrt()).max(0.0);
    let heights = heights(cone);
    for (elevation, azimuth) in
        [(10.0, 0.0), (5.0, 90.0), (8.0, 180.0), (12.0, 270.0), (7.0, 33.0), (6.0, 214.0)]
    {
        let sun = sun(elevation, azimuth);
        let [_, highest] = heights.range();
        let expected = highest / libm::tan(radians(elevation));
        for method in [Method::Rays, Method::Sweep] {
            // Across the rows the tip of the shadow is narrower than the posts are apart, and the sweep's rays pass the peak.
            let slack = match method {
                _ if azimuth % 90.0 == 0.0 => 51.0,
                Method::Rays => 110.0,
                Method::Sweep => 200.0,
            };
            let map = LightMap::new(&heights, sun, method);
            let columns = heights.grid().size()[1];
            let dark = map.shadowed().iter().enumerate().filter(|(_, dark)| **dark);
            let lengths = dark.map(|(index, _)| {
                let [north, east] = heights.grid().place(index / columns, index % columns);
                (north * north + east * east).sqrt()
            });
            let longest = lengths.fold(0.0, f64::max);
            assert!(
                (longest - expected).abs() < slack,
                "{method:?}, {elevation}, {azimuth}: {longest} of {expected}"
            );
        }
    }
}

/// Marching along the ray in short steps over the triangles of the mesh.
fn marched(heights: &Heights, post: [usize; 2], sun: DVec3) -> bool {
    let grid = heights.grid();
    let from = grid.place(post[0], post[1]);
    let level = (sun.x * sun.x + sun.y * sun.y).sqrt();
    let locate = |axis: &terrain_builder::Axis, at: f64| {
        let low = (0..axis.posts() - 1).rev().find(|&k| axis.place(k) <= at)?;
        (at <= axis.place(axis.posts() - 1))
            .then(|| (low, (at - axis.place(low)) / (axis.place(low + 1) - axis.place(low))))
    };
    for step in 1..40_000 {
        let way = 0.37 * f64::from(step);
        let place = [from[0] + way * sun.x / level, from[1] + way * sun.y / level];
        let (Some((row, v)), Some((column, u))) =
            (locate(&grid.north, place[0]), locate(&grid.east, place[1]))
        else {
            return false;
        };
        let [a, b] = [heights.post(row, column), heights.post(row, column + 1)];
        let [c, d] = [heights.post(row + 1, column), heights.post(row + 1, column + 1)];
        let ground = if u + v <= 1.0 {
            a + u * (b - a) + v * (c - a)
        } else {
            d + (1.0 - u) * (c - d) + (1.0 - v) * (b - d)
        };
        if ground > heights.post(post[0], post[1]) + way * sun.z / level + 1e-6 {
            return true;
        }
    }
    false
}

#[test]
fn rays_see_what_marching_along_them_sees() {
    let hills = |[north, east]: [f64; 2]| {
        150.0 * libm::sin(north / 700.0) * libm::cos(east / 500.0)
            + 40.0 * libm::sin((north + 2.0 * east) / 230.0)
    };
    let heights = heights(hills);
    let size = heights.grid().size();
    let (mut dark, mut unequal) = (0, 0);
    for (elevation, azimuth) in [(6.0, 20.0), (12.0, 135.0), (4.0, 270.0), (9.0, 341.0)] {
        let sun = sun(elevation, azimuth);
        let map = LightMap::new(&heights, sun, Method::Rays);
        for number in 0..150 {
            let post = [number * 37 % size[0], number * 91 % size[1]];
            let found = map.shadowed()[post[0] * size[1] + post[1]];
            dark += usize::from(found);
            unequal += usize::from(found != marched(&heights, post, sun));
        }
    }
    assert!((100..500).contains(&dark), "{dark}");
    assert!(unequal <= 1, "{unequal} of 600 posts differ");
}

#[test]
fn the_sweep_sees_what_rays_see_but_at_edges() {
    let ground = built(&file_of(&[0, 1, 2]));
    let heights = ground.heights();
    for (elevation, azimuth) in [(5.0, 95.0), (10.0, 0.0), (10.0, 200.0), (20.0, 310.0), (3.0, 45.0)] {
        let sun = sun(elevation, azimuth);
        let rays = LightMap::new(&heights, sun, Method::Rays);
        let sweep = LightMap::new(&heights, sun, Method::Sweep);
        let apart = rays.apart(&sweep, 2);
        let dark = rays.shadowed().iter().filter(|dark| **dark).count();
        println!("elevation {elevation}, azimuth {azimuth}: {dark} dark, {apart:?}");
        assert_eq!(apart.beyond_edges, 0, "{elevation}, {azimuth}: {apart:?} of {dark}");
        assert!(apart.posts <= 40 + dark / 5, "{elevation}, {azimuth}: {apart:?} of {dark}");
    }
}

#[test]
fn level_ground_is_lit_by_the_sine_of_the_elevation_and_a_low_sun_lights_nothing() {
    let flat = heights(|_| 3.0);
    for method in [Method::Rays, Method::Sweep] {
        let map = LightMap::new(&flat, sun(30.0, 77.0), method);
        assert!(map.shares().iter().all(|share| (share - 0.5).abs() < 1e-12));
        let below = LightMap::new(&flat, sun(-1.0, 77.0), method);
        assert!(below.shadowed().iter().all(|dark| *dark));
        let overhead = LightMap::new(&flat, DVec3::Z, method);
        assert!(overhead.shares().iter().all(|share| *share == 1.0));
    }
}

#[test]
fn colours_are_ambient_in_shadow_and_more_in_light() {
    let cone = |[north, east]: [f64; 2]| (200.0 - (north * north + east * east).sqrt()).max(0.0);
    let map = LightMap::new(&heights(cone), sun(30.0, 0.0), Method::Rays);
    let light = Light { sub_solar: [0.0; 2], ambient: [0.1, 0.2, 0.3], diffuse: [0.5, 0.4, 0.2] };
    for (index, colour) in map.colours(&light).enumerate() {
        let share = map.shares()[index];
        assert!(share == 0.0 || !map.shadowed()[index]);
        for part in 0..3 {
            near(colour[part], light.ambient[part] + share * light.diffuse[part], 1e-15);
        }
    }
}

#[test]
fn slopes_of_a_plane_are_its_own_on_every_post() {
    let plane = heights(|[north, east]| 0.1 * north - 0.3 * east);
    let [rows, columns] = plane.grid().size();
    for post in [[0, 0], [rows - 1, columns - 1], [5, 7], [rows - 2, 40]] {
        let [north, east] = plane.slope(post[0], post[1]);
        near(north, 0.1, 1e-9);
        near(east, -0.3, 1e-9);
    }
    near(plane.normal(3, 3).length(), 1.0, 1e-15);
}
