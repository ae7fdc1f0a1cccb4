//! The image of the south pole over both of its elevation models: the sun that its shadows tell. Voids knocked out of real grids.

use std::path::Path;

use photo_camera::Light;
use photo_camera::voids::{Border, Fill, Wishes, fill};
use photo_check::{FoundSun, Ground, fill_voids, find_sun};
use photo_make::{import, write_imported};
use photograph::Photograph;
use quantities::{degrees, unit_interval};
use survey::{Elevation, ReadOptions};

use crate::shared;

fn read(file: &Path) -> Elevation {
    survey::read(file, &ReadOptions::default()).expect("a readable file")
}

/// The sun of the image over one of the elevation models.
fn sun_over(data: &Path, model: &str) -> FoundSun {
    let image = read(&data.join("lunar/nac_southpole_image_M139939938LE_1m.tif"));
    let folder = tempfile::tempdir().expect("a folder");
    let imported = import(&image, Some(400.0), &Light::default()).expect("light");
    write_imported(folder.path(), &imported).expect("a folder to write in");
    let [photo, camera] = ["photo.png", "camera.json"].map(|name| folder.path().join(name));
    let photo = Photograph::read(&photo, &camera).expect("a photograph");
    let elevation = read(&data.join(format!("lunar/nac_southpole_{model}_dem_1m.tif")));
    let filling = fill_voids(&elevation, Wishes::default()).expect("a grid");
    find_sun(&Ground::new(&elevation, filling, &photo).expect("one map"), &photo).expect("shadows")
}

/// Azimuth from the grid's north, elevation, and two standard errors of both (degrees), and the correlation of dark posts: as docs/real-ground.md
/// has them.
#[test]
#[ignore = "long: .ci/long runs it"]
fn shadows_of_the_image_tell_its_sun() {
    let Some(data) = shared::data() else { return };
    for (model, documented) in
        [("stereo", [332.7, 2.4, 7.5, 0.9, 0.339]), ("sfs", [349.5, 4.9, 1.5, 0.1, 0.208])]
    {
        let found = sun_over(&data, model);
        let angles = [found.sun.azimuth, found.sun.elevation, found.uncertainty[0], found.uncertainty[1]];
        let [azimuth, elevation, a, e] = angles.map(degrees);
        let figures = [azimuth, elevation, a, e, found.overlap];
        println!("{model}: {figures:.3?}; {:.3} in both of either; dark {:.4?}", found.common, found.dark);
        for ((figure, documented), rounding) in
            figures.into_iter().zip(documented).zip([0.06, 0.06, 0.06, 0.06, 6e-4])
        {
            assert!(
                (figure - documented).abs() < rounding,
                "{model}: {figures:?}, docs/real-ground.md says {documented}"
            );
        }
    }
}

/// The posts of a square around the highest post of a file, NaN where it is void.
fn square(file: &Path, side: usize) -> Vec<f64> {
    // The file of Crater Lake marks its voids without saying so.
    let options = ReadOptions { no_data: vec![-32_767.0], ..ReadOptions::default() };
    let elevation = survey::read(file, &options).expect("a readable file");
    let all = (0..elevation.lines).flat_map(|line| (0..elevation.columns).map(move |column| [line, column]));
    let height = |[line, column]: [usize; 2]| elevation.height(line, column).unwrap_or(f64::NAN);
    let known = all.filter(|post| !height(*post).is_nan());
    let [line, column] = known.max_by(|a, b| height(*a).total_cmp(&height(*b))).expect("a known post");
    let first = |at: usize, count: usize| at.saturating_sub(side / 2).min(count - side);
    let [line, column] = [first(line, elevation.lines), first(column, elevation.columns)];
    (0..side * side).map(|post| height([line + post / side, column + post % side])).collect()
}

/// Root mean square (m) by which a fill misses the known posts that are knocked out.
fn missed(known: &[f64], side: usize, is_out: &dyn Fn(usize) -> bool, way: Fill) -> f64 {
    let heights: Vec<f64> = known
        .iter()
        .enumerate()
        .map(|(post, height)| if is_out(post) { f64::NAN } else { *height })
        .collect();
    let wishes = Wishes { fill: way, border: Border::Filled, allow_large_holes: true };
    let filled = fill([side, side], &heights, wishes).expect("a grid").heights;
    let out = (0..known.len()).filter(|post| is_out(*post) && !known[*post].is_nan());
    let squares: Vec<f64> =
        out.map(|post| (filled[post] - known[post]) * (filled[post] - known[post])).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Voids knocked out of real grids, 1, 5 and 20 % of the posts, scattered and as one lake: the harmonic fill misses less than the mean of the
/// thesis.
#[test]
fn harmonic_fill_is_better_than_the_mean_on_real_grids() {
    let Some(data) = shared::data() else { return };
    for (file, side) in [("dted/n00_e006_3arc_v2.dt1", 300), ("photo_dem/craterlake-elev-16bit-30m.tif", 200)]
    {
        let known = square(&data.join(file), side);
        let relief = known.iter().copied().filter(|height| !height.is_nan());
        let [low, high] = [relief.clone().fold(f64::MAX, f64::min), relief.fold(f64::MIN, f64::max)];
        assert!(high - low > 100.0, "{file}: ground without relief, {low} to {high} m");
        for share in [0.01, 0.05, 0.2] {
            let scattered = |post: usize| unit_interval(7, &[post as u64]) < share;
            let half = 0.5 * side as f64;
            let radius = half * (share * 4.0 / std::f64::consts::PI).sqrt();
            let lake = |post: usize| {
                let [line, column] = [post / side, post % side].map(|at| at as f64 + 0.5 - half);
                libm::hypot(line, column) < radius
            };
            for (name, is_out) in [("scattered", &scattered as &dyn Fn(usize) -> bool), ("a lake", &lake)] {
                let [harmonic, mean] =
                    [Fill::Harmonic, Fill::WrittenMean].map(|way| missed(&known, side, is_out, way));
                println!("{file}: {} % {name}: harmonic {harmonic:.2} m, mean {mean:.2} m", 100.0 * share);
                assert!(harmonic < mean, "{file}, {share}, {name}: {harmonic} m, not below {mean} m");
            }
        }
    }
}
