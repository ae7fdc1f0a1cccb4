//! Elevation files as a base.

use quantities::radians;
use survey::{Affine, Elevation, Frame as FileFrame, Method, Projection};
use terrain_builder::{Base, ElevationBase, Frame, Grid};

use crate::{MOON, angles, near};

/// 16 samples a degree from 2 to 5 east and 25 to 28 north, north first, centres half a sample inside.
fn file(height: impl Fn([f64; 2]) -> f64) -> Elevation {
    file_on(MOON, height)
}

/// The same on a sphere of a radius (m).
fn file_on(radius: f64, height: impl Fn([f64; 2]) -> f64) -> Elevation {
    let (side, step) = (48, radians(1.0 / 16.0));
    let first = [radians(28.0) - 0.5 * step, radians(2.0) + 0.5 * step];
    let place =
        |sample: usize| [first[0] - (sample / side) as f64 * step, first[1] + (sample % side) as f64 * step];
    let heights = (0..side * side).map(|sample| height(place(sample))).collect();
    Elevation::new(
        side,
        side,
        heights,
        Affine { first, step: [-step, step] },
        FileFrame::Geographic { radius },
    )
}

fn frame() -> Frame {
    Frame::new(MOON, angles([3.0, 3.5]), angles([26.0, 26.5])).unwrap()
}

/// A base on posts `resolution` (m) apart.
fn base(elevation: Elevation, resolution: f64) -> ElevationBase {
    let frame = frame();
    ElevationBase::new(elevation, frame, &Grid::new(&frame, resolution, 3).unwrap()).unwrap()
}

fn plane([latitude, longitude]: [f64; 2]) -> f64 {
    1000.0 + 4000.0 * (latitude - 0.45) - 7000.0 * (longitude - 0.06)
}

#[test]
fn a_plane_comes_back_exactly() {
    for resolution in [300.0, 1000.0, 3000.0] {
        let base = Base::Elevation(Box::new(base(file(plane), resolution)));
        for place in [[0.0, 0.0], [-3000.0, 2500.0], [6000.0, -5500.0]] {
            near(base.height(place), plane(frame().inverse(place)), 1e-8);
        }
    }
}

#[test]
fn a_bump_of_one_sample_keeps_its_place() {
    let flat = file(|_| 0.0);
    let [latitude, longitude] = flat.place(28, 20);
    let bump = file(|place| if place == [latitude, longitude] { 8.0 } else { 0.0 });
    let base = Base::Elevation(Box::new(base(bump, 300.0)));
    let at = frame().forward(latitude, longitude);
    near(base.height(at), 8.0, 1e-9);
    let sample = MOON * radians(1.0 / 16.0);
    near(base.height([at[0] + 0.5 * sample, at[1]]), 4.0, 1e-9);
    near(base.height([at[0] - 0.5 * sample, at[1]]), 4.0, 1e-9);
    near(base.height([at[0] + 1.01 * sample, at[1]]), 0.0, 1e-9);
}

#[test]
fn a_void_leaves_its_weight_to_the_others() {
    let flat = file(|_| 0.0);
    let [latitude, longitude] = flat.place(28, 20);
    let holed = file(|place| if place == [latitude, longitude] { f64::NAN } else { 5.0 });
    let found = Base::Elevation(Box::new(base(holed, 300.0)));
    let at = frame().forward(latitude, longitude);
    // At the void itself all weight is its own: the filled height counts.
    for shift in [0.0, 100.0, 900.0] {
        near(found.height([at[0] + shift, at[1] + 0.3 * shift]), 5.0, 1e-9);
    }
}

#[test]
fn a_coarser_grid_takes_the_mean_of_the_samples_in_its_cell() {
    // Stripes of one sample: bilinear heights would be 0 or 10 at the samples.
    let step = radians(1.0 / 16.0);
    let stripes = file(|[_, longitude]| if (longitude / step).floor() as i64 % 2 == 0 { 10.0 } else { 0.0 });
    let sample = MOON * step;
    let base = Base::Elevation(Box::new(base(stripes, 4.0 * sample)));
    for shift in [0.0, 0.3, 0.7] {
        near(base.height([0.0, shift * sample]), 5.0, 1.0);
    }
}

#[test]
fn the_sample_and_line_of_the_check_table_come_out() {
    // A simple cylindrical product of 16 samples a degree: line 1439.5 at the equator, sample 2879.5 at 180 east, from 0.
    let step = radians(1.0 / 16.0);
    let first = [step * 1439.5, radians(180.0) - step * 2879.5];
    let affine = Affine { first, step: [-step, step] };
    let globe =
        Elevation::new(2880, 5760, vec![0.0; 2880 * 5760], affine, FileFrame::Geographic { radius: MOON });
    let place = [26.132_22, 3.633_86].map(radians);
    let found = base(globe, 3000.0).sample(frame().forward(place[0], place[1])).unwrap();
    near(found[1] + 1.0, 58.641_76, 1e-8);
    near(found[0] + 1.0, 1_022.384_48, 1e-8);
}

#[test]
fn longitudes_may_count_from_another_turn() {
    let mut turned = file(plane);
    turned.affine.first[1] -= std::f64::consts::TAU;
    let turned = Base::Elevation(Box::new(base(turned, 300.0)));
    near(turned.height([10.0, 20.0]), plane(frame().inverse([10.0, 20.0])), 1e-8);
}

#[test]
fn a_projected_file_lies_under_its_place() {
    let method = Method::Equirectangular { parallel: radians(20.0) };
    let projection = Projection { method, latitude: 0.0, longitude: 0.0, radius: MOON, offset: [0.0; 2] };
    let middle = projection.forward(radians(26.25), radians(3.25)).unwrap();
    let affine = Affine { first: [middle[0] - 10_000.0, middle[1] - 10_000.0], step: [200.0, 200.0] };
    let heights = (0..101 * 101).map(|k| (k / 101) as f64 * 200.0 - 10_000.0).collect();
    let file = Elevation::new(101, 101, heights, affine, FileFrame::Plane(Some(projection)));
    let base = Base::Elevation(Box::new(base(file, 300.0)));
    near(base.height([1234.0, -321.0]), 1234.0, 1e-6);
}

#[test]
fn a_file_without_a_place_lies_in_the_middle() {
    let affine = Affine { first: [0.0; 2], step: [200.0, 200.0] };
    let heights = (0..101 * 101).map(|k| (k % 101) as f64).collect();
    let base = Base::Elevation(Box::new(base(
        Elevation::new(101, 101, heights, affine, FileFrame::Plane(None)),
        300.0,
    )));
    near(base.height([0.0, 0.0]), 50.0, 1e-9);
    near(base.height([500.0, 200.0]), 51.0, 1e-9);
}

/// An Arc ASCII grid in metres or degrees on the disk, with a description whose base it is.
fn on_disk(text: &str, area: &str) -> (tempfile::TempDir, terrain_builder::Description) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("base.asc"), text).unwrap();
    let head = format!("format = 1\n[area]\n{area}\nresolution_m = 100.0\n[base]\nfile = \"base.asc\"\n");
    let description = terrain_builder::Description::parse("ground.toml", &head, folder.path()).unwrap();
    (folder, description)
}

#[test]
fn a_file_of_the_disk_is_read_only_under_the_range() {
    let rows = (0..300)
        .map(|row| (0..400).map(|column| format!("{} ", 10 * row + column)).collect::<String>() + "\n");
    let head = "ncols 400\nnrows 300\nxllcorner 0\nyllcorner 0\ncellsize 100\nNODATA_value -9999\n";
    let area = "longitude_deg = [3.0, 3.1]\nlatitude_deg = [26.0, 26.1]";
    let (_folder, description) = on_disk(&(head.to_owned() + &rows.collect::<String>()), area);
    let base = Base::open(&description).unwrap();
    let Base::Elevation(elevation) = &base else { panic!("a file") };
    let read = elevation.elevation();
    assert!(read.lines < 60 && read.columns < 60, "{} x {}", read.lines, read.columns);
    // Middle of the file: line 149.5 from the north, column 199.5, although a window is read that lies elsewhere.
    near(base.height([0.0, 0.0]), 10.0 * 149.5 + 199.5, 1e-6);
    near(base.height([100.0, 300.0]), 10.0 * 148.5 + 202.5, 1e-6);
}

#[test]
fn a_missing_file_and_one_elsewhere_are_told_by_name() {
    let area = "longitude_deg = [3.0, 3.1]\nlatitude_deg = [26.0, 26.1]";
    let small = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n";
    let (folder, description) = on_disk(small, area);
    let told = Base::open(&description).expect_err("too small").to_string();
    assert!(told.contains("base.asc") && told.contains("reaches over the whole range"), "{told}");
    drop(folder);
    assert!(Base::open(&description).expect_err("missing").to_string().contains("base.asc"));
}

#[test]
fn a_file_that_does_not_reach_over_the_range_is_refused() {
    let frame = Frame::new(MOON, angles([4.8, 5.3]), angles([26.0, 26.5])).unwrap();
    let grid = Grid::new(&frame, 300.0, 3).unwrap();
    let refused = ElevationBase::new(file(plane), frame, &grid).expect_err("refused");
    assert_eq!(refused.key, "file");
}

#[test]
fn posts_much_closer_than_samples_are_warned_of() {
    let sample = MOON * radians(1.0 / 16.0);
    assert_eq!(base(file(plane), sample / 7.0).much_finer(), None);
    let finer = base(file(plane), sample / 10.0).much_finer().unwrap();
    // A degree of longitude is shorter than one of latitude.
    near(finer, 10.0 * libm::cos(radians(26.25)), 1e-3);
}

#[test]
fn a_file_of_another_body_is_refused() {
    let frame = frame();
    let over = |radius: f64| {
        ElevationBase::new(file_on(radius, |_| 0.0), frame, &Grid::new(&frame, 300.0, 3).unwrap())
    };
    let refused = over(3_396_190.0).unwrap_err().to_string();
    assert!(refused.contains("a body of 3396190 m") && refused.contains("`area.radius_m`"), "{refused}");
    assert!(over(1_737_000.0).is_ok(), "the Moon's radius is known to less than a thousandth");
}
