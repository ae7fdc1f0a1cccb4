//! The folder of a photograph: what its files hold, and that they agree with one another.

use std::fs;

use files::read_npy;
use photo_make::{ElevationGrid, FILES, make, record, write_folder};
use photograph::{Photograph, Placement};
use survey::ReadOptions;

use crate::{attitudes, bumps, craters, stage};

#[test]
fn the_files_of_a_photograph_agree() {
    let stage = stage(bumps(4.0), craters());
    let wishes = attitudes().remove(4);
    let made = make(&stage, &wishes).expect("a photograph");
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("new");
    let grid = ElevationGrid::over(&made, 2.0);
    let about = record("made.toml", &wishes, &made, &grid);
    write_folder(&out, &made, &grid, &about).expect("written");
    let mut names: Vec<_> =
        fs::read_dir(&out).expect("a folder").map(|entry| entry.expect("a file").file_name()).collect();
    names.sort();
    let mut expected = FILES.to_vec();
    expected.sort_unstable();
    assert_eq!(names, expected);

    let photo = Photograph::read(&out.join("photo.png"), &out.join("camera.json")).expect("a photograph");
    assert_eq!(photo.picture(), &made.picture);
    let Placement::Camera { camera, .. } = photo.placement() else { panic!("a camera") };
    assert_eq!(*camera, made.file.camera);
    let [azimuth, _] = photo.sun().expect("a sun");
    assert!((azimuth - made.sun.azimuth).abs() < 1e-15);

    let ground = read_npy(out.join("ground.npy"), 1_u64 << 30).expect("an array");
    assert_eq!(ground.shape(), [36, 48, 3]);
    let first = made.ground.iter().position(Option::is_some).expect("ground");
    assert_eq!(ground.data().to_f64()[3 * first], made.ground[first].expect("ground").x);

    // Posts stand where the file says, with the heights of the ground.
    let elevation = survey::read(out.join("elevation.asc"), &ReadOptions::default()).expect("elevations");
    assert_eq!([elevation.lines, elevation.columns], grid.posts);
    for [line, column] in [[0, 0], [3, 7], [elevation.lines - 1, elevation.columns - 1]] {
        let [north, east] = elevation.place(line, column);
        let expected = stage.landscape.height(north, east);
        match (elevation.height(line, column), expected) {
            (Some(found), Some(expected)) => {
                assert!((found - expected).abs() <= 5.1e-5, "{found} {expected}")
            }
            (found, expected) => assert_eq!(found.is_some(), expected.is_some()),
        }
    }
    let points = fs::read_to_string(out.join("points.csv")).expect("points");
    assert!(points.starts_with("name,east_m,north_m,height_m,i_px,j_px\np00,"), "{points}");
    assert!(points.lines().count() > 10);
    let written = fs::read_to_string(out.join("photo.json")).expect("a record");
    assert!(written.contains("\"schema\": \"lunoid.photo-made/1\"") && written.contains("\"residual_px\""));
}

#[test]
fn a_grid_covers_the_ground_that_is_seen() {
    let stage = stage(bumps(4.0), craters());
    for wishes in attitudes() {
        let made = make(&stage, &wishes).expect("a photograph");
        let grid = ElevationGrid::over(&made, 2.0);
        let [low, high] = [[0, 0], grid.posts.map(|count| count - 1)].map(|post| grid.place(post));
        for point in made.ground.iter().flatten() {
            assert!(low[0] <= point.y - 2.0 && point.y + 2.0 <= high[0] + 1e-9, "{point}");
            assert!(low[1] <= point.x - 2.0 && point.x + 2.0 <= high[1] + 1e-9, "{point}");
        }
    }
}
