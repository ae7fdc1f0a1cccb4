//! Surveys of real lunar files from the folder `shared/data` beside the repository, if it is there.

use std::path::{Path, PathBuf};

use landscape::Bank;
use quantities::{degrees, radians};
use survey::{Area, Plane, ReadOptions, Survey, SurveyOptions, read, survey};

/// The file, or a loud line that it was left out.
fn shared(name: &str) -> Option<PathBuf> {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let found = folders.map(|folder| folder.join("shared/data").join(name)).find(|path| path.is_file());
    if found.is_none() {
        println!("SKIPPED: shared/data/{name} is not there");
    }
    found
}

fn surveyed(path: &Path, read_options: &ReadOptions, options: &SurveyOptions) -> Survey {
    let elevation = read(path, read_options).unwrap();
    let found = survey(&elevation, options, &mut |_| {}).unwrap();
    println!("{:#?}", found.report);
    found
}

fn height(bank: &Bank, place: [f64; 2]) -> f64 {
    let (region, local) = bank.finest().locate(place[0], place[1]).unwrap();
    bank.finest().height_and_slopes(region, local)[0]
}

#[test]
fn south_pole_stereo() {
    let Some(path) = shared("lunar/nac_southpole_stereo_dem_1m.tif") else { return };
    let mut options = SurveyOptions::new(6.0);
    options.levels = vec![1, 4];
    let found = surveyed(&path, &ReadOptions::default(), &options);
    let report = &found.report;
    assert!((report.height[0] + 1112.55).abs() < 0.01 && (report.height[1] + 1065.92).abs() < 0.01);
    let place = found.bank.georeference().unwrap();
    assert!((degrees(place.latitude) + 85.006).abs() < 1e-3, "{}", degrees(place.latitude));
    assert!((degrees(place.longitude) + 5.768).abs() < 1e-3, "{}", degrees(place.longitude));
    assert!(report.levels[0].rms < 0.05 && report.levels[1].rms < 0.4);
    assert!(report.levels[0].held_out_rms.unwrap() < 0.05);
    let turn = degrees(report.true_north.unwrap());
    assert!((turn + 5.77).abs() < 0.01, "{turn}");
}

#[test]
fn kepler_by_lola() {
    let Some(path) = shared("lunar/kepler_lola_48m.tif") else { return };
    let half_metres = ReadOptions { scale: Some(0.5), ..ReadOptions::default() };
    let found = surveyed(&path, &half_metres, &SurveyOptions::new(240.0));
    let report = &found.report;
    assert_eq!(report.height, [-3072.5, 139.0]);
    assert!(report.levels[0].rms < 10.0);
    let place = found.bank.georeference().unwrap();
    assert!((degrees(place.latitude) - 8.12).abs() < 0.01 && (degrees(place.longitude) + 38.01).abs() < 0.01);
}

#[test]
fn herodotus_band_two() {
    let Some(path) = shared("lunar/herodotus_mons_hsr_54m.tif") else { return };
    let message = read(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("2 (qts_demstack)"), "{message}");
    let second = ReadOptions { band: Some(2), ..ReadOptions::default() };
    let found = surveyed(&path, &second, &SurveyOptions::new(300.0));
    let report = &found.report;
    assert!((report.height[0] + 1684.63).abs() < 0.01 && (report.height[1] + 297.43).abs() < 0.01);
    assert!(report.levels[0].rms < 5.0);
}

#[test]
fn global_grid_around_a_site_and_at_the_pole() {
    let Some(path) = shared("pds3/LDEM_4.LBL") else { return };
    let global = read(&path, &ReadOptions::default()).unwrap();
    assert_eq!((global.lines, global.columns), (720, 1440));
    assert_eq!(global.range(), Some([-8878.5, 10_504.0]));
    // Highest sample of the archive's description.
    let line = ((90.0 - 5.375) / 0.25) as usize;
    assert_eq!(global.height(line, (201.375 / 0.25) as usize), Some(10_504.0));

    let mut options = SurveyOptions::new(30_000.0);
    let at = |latitude: f64, longitude: f64, size: f64, plane| Area::Centred {
        latitude: radians(latitude),
        longitude: radians(longitude),
        size: [size; 2],
        plane,
    };
    // Across the meridian where the file begins.
    options.area = at(20.0, -1.0, 600_000.0, Plane::Equirectangular);
    let found = survey(&global, &options, &mut |_| {}).unwrap();
    let direct = global.height(((90.0 - 20.125) / 0.25) as usize, (358.875 / 0.25) as usize).unwrap();
    let metre = 1_737_400.0_f64.to_radians();
    let place = [300_000.0 + 0.125 * metre, 300_000.0 - 0.125 * metre * libm::cos(radians(20.0))];
    assert!((height(&found.bank, place) - direct).abs() < 300.0);
    println!("{:#?}", found.report);
    assert_eq!(found.report.levels[0].void, 0);

    options.area = at(20.0, -1.0, 600_000.0, Plane::Orthographic);
    let true_plane = survey(&global, &options, &mut |_| {}).unwrap();
    let centre = [300_000.0; 2];
    assert!((height(&true_plane.bank, centre) - height(&found.bank, centre)).abs() < 200.0);

    options.area = at(-89.9, 0.0, 400_000.0, Plane::Orthographic);
    let pole = survey(&global, &options, &mut |_| {}).unwrap();
    println!("{:#?}", pole.report);
    // Neighbouring samples of the file differ by up to 0.6 of their distance there.
    assert!(pole.report.levels[0].slope < 0.8);
    assert!(pole.report.levels[0].void < 5);
}

#[test]
fn a_file_with_a_third_of_voids() {
    let Some(path) = shared("photo_dem/craterlake-elev-16bit-30m.tif") else { return };
    let voids = ReadOptions { no_data: vec![-32767.0], ..ReadOptions::default() };
    let found = surveyed(&path, &voids, &SurveyOptions::new(150.0));
    let [low, high] = found.report.height;
    assert_eq!([low, high], [1289.0, 1880.0]);
    let level = &found.report.levels[0];
    let inside = level.in_voids.unwrap();
    let margin = 0.3 * (high - low);
    assert!(inside.height[0] > low - margin && inside.height[1] < high + margin, "{inside:?}");
    assert!(inside.slope < 2.0 * level.slope && level.iterations < 100, "{level:#?}");
    assert!(found.report.warnings.iter().any(|warning| warning.contains("not the Moon")));
}
