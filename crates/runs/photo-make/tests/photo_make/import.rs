//! Photographs out of rasters: values, place, edges, and what is refused.

use glam::DVec3;
use photo_camera::Light;
use photo_make::{ImportError, Imported, import, write_imported};
use photograph::Photograph;
use quantities::radians;
use survey::{Affine, Elevation, Frame};

/// A raster of 4 lines and 5 columns, line 0 the northernmost: 10 times the line and the column, void where `is_void` says so.
fn raster(frame: Frame, affine: Affine, is_void: impl Fn([usize; 2]) -> bool) -> Elevation {
    let places = (0..4).flat_map(|line| (0..5).map(move |column| [line, column]));
    let value = |[line, column]: [usize; 2]| (10 * line + column) as f64;
    let values = places.map(|place| if is_void(place) { f64::NAN } else { value(place) }).collect();
    Elevation::new(4, 5, values, affine, frame)
}

fn metres(is_void: impl Fn([usize; 2]) -> bool) -> Elevation {
    raster(Frame::Plane(None), Affine { first: [1000.0, 200.0], step: [-2.0, 3.0] }, is_void)
}

/// What `lunoid` reads of the written files.
fn read_back(imported: &Imported) -> Photograph {
    let folder = tempfile::tempdir().expect("a folder");
    write_imported(folder.path(), imported).expect("a folder to write in");
    Photograph::read(&folder.path().join("photo.png"), &folder.path().join("camera.json"))
        .expect("both files")
}

/// Light at a place (east, north).
fn light(photo: &Photograph, east: f64, north: f64) -> f64 {
    photo.light_at(DVec3::new(east, north, 0.0)).expect("inside")
}

#[test]
fn values_stand_where_the_raster_has_them() {
    let imported =
        import(&metres(|_| false), Some(40.0), &Light::new(Some([1.0, 0.2]), None).expect("a sun"))
            .expect("light");
    assert_eq!((imported.left_out, imported.cut), ([0; 4], 0));
    let photo = read_back(&imported);
    assert_eq!(photo.sun(), Some([1.0, 0.2]));
    for [line, column] in [[0, 0], [2, 3], [3, 4]] {
        let [east, north] = [200.0 + 3.0 * column as f64, 1000.0 - 2.0 * line as f64];
        let found = light(&photo, east, north);
        let value = (10 * line + column) as f64 / 40.0;
        assert!((found - value).abs() < 1.0 / 65_535.0, "{line}, {column}: {found}, not {value}");
    }
    // Above white all is white.
    let cut = import(&metres(|_| false), Some(20.0), &Light::default()).expect("light");
    assert_eq!((cut.cut, read_back(&cut).sun()), (9, None));
    assert_eq!(import(&metres(|_| false), None, &Light::default()).expect("light").white, 34.0);
}

/// White stands for the light that the grey curve says.
#[test]
fn light_is_scaled_by_the_grey_curve() {
    let light = Light::new(None, Some([0.05, 1.0])).expect("a curve");
    let photo = read_back(&import(&metres(|_| false), Some(40.0), &light).expect("light"));
    let found = photo.light_at(DVec3::new(203.0, 998.0, 0.0)).expect("inside");
    assert!((found - 0.05 * 11.0 / 40.0).abs() < 0.05 / 65_535.0, "{found}");
}

/// Lines and columns without any value are left out, and nothing moves.
#[test]
fn empty_edges_are_left_out() {
    let imported = import(&metres(|[line, column]| line == 0 || column > 2), Some(40.0), &Light::default())
        .expect("light");
    assert_eq!(imported.left_out, [1, 0, 0, 2]);
    assert_eq!([imported.picture.columns(), imported.picture.lines()], [3, 3]);
    let found = light(&read_back(&imported), 203.0, 996.0);
    assert!((found - 21.0 / 40.0).abs() < 1.0 / 65_535.0, "{found}");
}

#[test]
fn a_raster_in_degrees_makes_a_map_in_degrees() {
    let affine = Affine { first: [radians(10.0), radians(20.0)], step: [radians(-0.5), radians(0.25)] };
    let imported =
        import(&raster(Frame::Geographic { radius: 1e6 }, affine, |_| false), Some(40.0), &Light::default());
    let found = light(&read_back(&imported.expect("light")), 20.5, 9.5);
    assert!((found - 12.0 / 40.0).abs() < 1e-4, "{found}");
}

#[test]
fn what_makes_no_photograph_is_refused() {
    let hole = import(&metres(|place| place == [2, 1]), None, &Light::default()).expect_err("a hole");
    assert!(matches!(hole, ImportError::Holes { count: 1, line: 2, column: 1 }), "{hole}");
    let corner = import(&metres(|place| place == [0, 0] || place == [3, 4]), None, &Light::default())
        .expect_err("holes");
    assert!(matches!(corner, ImportError::Holes { count: 2, line: 0, column: 0 }), "{corner}");
    let dark =
        Elevation::new(2, 2, vec![-1.0; 4], Affine { first: [0.0; 2], step: [1.0; 2] }, Frame::Plane(None));
    assert!(
        matches!(import(&dark, None, &Light::default()), Err(ImportError::Dark { largest }) if largest == -1.0)
    );
    let void = Elevation::new(
        2,
        2,
        vec![f64::NAN; 4],
        Affine { first: [0.0; 2], step: [1.0; 2] },
        Frame::Plane(None),
    );
    assert!(matches!(import(&void, None, &Light::default()), Err(ImportError::Holes { count: 4, .. })));
}
