//! Frames and grids.

use proptest::prelude::{prop_assert, proptest};
use quantities::{degrees, radians};
use terrain_builder::{Frame, FrameWarning, Grid};

use crate::{MOON, angles, apollo, near};

#[test]
fn the_area_of_the_check_table_comes_out() {
    let frame = apollo();
    near(frame.area(frame.longitude(), frame.latitude()) / 1e6, 206.169_218_612_745, 1e-9);
}

#[test]
fn the_sphere_drops_as_the_check_table_says() {
    near(apollo().drop(7580.0), 16.535_246, 5e-7);
    near(7580.0 * 7580.0 / (2.0 * MOON), 16.535_167, 5e-7);
    assert_eq!(apollo().drop(0.0), 0.0);
    assert_eq!(apollo().drop(2.0 * MOON), 4.0 * MOON);
}

#[test]
fn a_range_across_180_degrees_is_legal_however_it_is_written() {
    let over = Frame::new(MOON, angles([179.0, -179.0]), angles([-1.0, 1.0])).unwrap();
    let beyond = Frame::new(MOON, angles([179.0, 181.0]), angles([-1.0, 1.0])).unwrap();
    for (a, b) in over.size().into_iter().zip(beyond.size()) {
        near(a, b, 1e-6);
    }
    near(over.size()[1], MOON * radians(2.0), 1e-3);
    for longitude in [179.5, -180.5, 179.5 - 720.0] {
        near(over.forward(0.0, radians(longitude))[1], -MOON * radians(0.5), 1e-5);
    }
}

#[test]
fn bad_ranges_are_refused_by_their_key() {
    let refused = |radius, longitude, latitude| {
        Frame::new(radius, angles(longitude), angles(latitude)).expect_err("refused").key
    };
    assert_eq!(refused(0.0, [0.0, 1.0], [0.0, 1.0]), "radius_m");
    assert_eq!(refused(f64::NAN, [0.0, 1.0], [0.0, 1.0]), "radius_m");
    assert_eq!(refused(MOON, [0.0, 1.0], [1.0, 0.0]), "latitude_deg");
    assert_eq!(refused(MOON, [0.0, 1.0], [1.0, 1.0]), "latitude_deg");
    assert_eq!(refused(MOON, [0.0, 1.0], [89.0, 90.0]), "latitude_deg");
    assert_eq!(refused(MOON, [0.0, 1.0], [-90.0, -89.0]), "latitude_deg");
    assert_eq!(refused(MOON, [0.0, 1.0], [f64::NAN, 1.0]), "latitude_deg");
    assert_eq!(refused(MOON, [3.5, 3.0], [0.0, 1.0]), "longitude_deg");
    assert_eq!(refused(MOON, [3.0, 3.0], [0.0, 1.0]), "longitude_deg");
    assert_eq!(refused(MOON, [f64::NAN, 3.0], [0.0, 1.0]), "longitude_deg");
    let told = Frame::new(MOON, angles([0.0, 1.0]), angles([2.0, 1.0])).expect_err("refused").to_string();
    assert!(told.starts_with("`latitude_deg` is [2, 1]: expected south and north"), "{told}");
}

#[test]
fn wide_and_polar_ranges_are_warned_of() {
    assert_eq!(apollo().warnings(), []);
    let wide = Frame::new(MOON, angles([0.0, 6.0]), angles([0.0, 1.0])).unwrap().warnings();
    assert!(matches!(wide[..], [FrameWarning::Wide(span)] if (degrees(span) - 6.0).abs() < 1e-9));
    let polar = Frame::new(MOON, angles([0.0, 1.0]), angles([-61.0, -60.5])).unwrap().warnings();
    assert!(matches!(polar[..], [FrameWarning::Polar(latitude)] if (degrees(latitude) - 61.0).abs() < 1e-9));
    assert!(polar[0].to_string().contains("61.00 degrees"));
}

proptest! {
    #[test]
    fn places_come_back(
        west in -180.0..180.0f64, span in 0.01..20.0f64, south in -80.0..70.0f64, high in 0.01..10.0f64,
        share in 0.0..1.0f64, rise in 0.0..1.0f64,
    ) {
        let frame = Frame::new(MOON, angles([west, west + span]), angles([south, south + high])).unwrap();
        let place = [radians(south + rise * high), radians(west + share * span)];
        let found = frame.inverse(frame.forward(place[0], place[1]));
        prop_assert!((found[0] - place[0]).abs() < 1e-12 && (found[1] - place[1]).abs() < 1e-12);
    }
}

#[test]
fn the_last_tile_is_stretched_over_the_cells_that_are_left() {
    let side = degrees(15_200.0 / MOON);
    let frame =
        Frame::new(MOON, angles([-side / 2.0, side / 2.0]), angles([-side / 2.0, side / 2.0])).unwrap();
    let grid = Grid::new(&frame, 100.0, 5).unwrap();
    assert_eq!((grid.north.cells, grid.north.tiles(), grid.north.posts()), (152, 5, 161));
    assert_eq!([3, 4].map(|tile| grid.north.spacing_factor(tile)), [1.0, 0.75]);
    near(grid.north.place(129) - grid.north.place(128), 75.0, 1e-9);
    near(grid.north.place(128) - grid.north.place(127), 100.0, 1e-9);
    let [low, high] = grid.extent();
    near(high[0] - low[0], 15_200.0, 1e-6);
    assert_eq!(low, frame.corner());
}

#[test]
fn ground_smaller_than_a_tile_is_one_refined_tile() {
    let grid = Grid::new(&apollo(), 10_000.0, 5).unwrap();
    assert_eq!((grid.north.cells, grid.north.tiles(), grid.size()[0]), (2, 1, 33));
    near(grid.north.place(1) - grid.north.place(0), 10_000.0 * 2.0 / 32.0, 1e-9);
}

#[test]
fn bad_grids_are_refused() {
    for resolution in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Grid::new(&apollo(), resolution, 5).expect_err("refused").key, "resolution_m");
    }
    assert_eq!(Grid::new(&apollo(), 100.0, 13).expect_err("refused").key, "tile_exponent");
    let many = Grid::new(&apollo(), 0.1, 5).expect_err("refused");
    assert!(many.to_string().contains("posts"), "{many}");
}
