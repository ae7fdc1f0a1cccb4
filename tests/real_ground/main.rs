//! Drives over real elevation files: survey, poses, frames against the closed form. The files lie in `shared/data`
//! beside the repository; without them nothing is tested, and one line says so.
//!
//! `LUNOID_REAL_GROUND_SWEEPS=1000 cargo test --release -p lunoid-tests --test real_ground -- --nocapture` prints the
//! figures that stand in `docs/real-ground.md`.

mod apollo;
mod catalogue;
mod drive;
mod photo;
mod photo_drive;
mod shared;

use quantities::radians;
use study::shadow::table;
use survey::{Area, Plane, ReadOptions, SurveyOptions};

use crate::drive::{Agreement, Drive};

/// Part of the pixels outside the ridge mask that may be off by more than two levels.
const SHARE: f64 = 0.005;

/// Height of a line of 575 over 30 degrees (rad), at the middle of the picture.
const LINE_OF_575: f64 = 0.932e-3;

/// Part by which a figure may be off the one in the docs.
const ROUNDING: f64 = 0.01;

fn with_tenth_held_out(region_size: f64) -> SurveyOptions {
    SurveyOptions { held_out: 0.1, ..SurveyOptions::new(region_size) }
}

/// Two figures of a survey (m) are those of the docs.
fn expect_figures(drive: &Drive, rms: f64, held_out: f64) {
    let level = &drive.report.levels[0];
    let found = [level.rms, level.held_out_rms.expect("a tenth is held out")];
    for (found, documented) in found.into_iter().zip([rms, held_out]) {
        assert!(
            (found - documented).abs() <= ROUNDING * documented,
            "{found} m, docs/real-ground.md says {documented} m"
        );
    }
}

/// Two frames are the closed form's, but for few pixels, and the lit horizon to `most` lines.
fn expect_agreement(drive: &Drive, frames: [u64; 2], most: usize) {
    for frame in frames {
        let Agreement { off, off_anywhere, horizon } = drive.agreement(frame);
        let (name, lines) = (drive.name, horizon.percentile_99);
        println!(
            "{name} frame {frame}: {:.3} % off by more than 2 levels outside the ridge mask, {:.3} % anywhere; \
             horizon, where it is lit, off by {lines} lines in 99 % of {} columns, {} at most",
            100.0 * off,
            100.0 * off_anywhere,
            horizon.compared,
            horizon.maximum
        );
        assert!(off <= SHARE, "{name} frame {frame}: {:.3} % of the pixels are off", 100.0 * off);
        assert!(lines <= most, "{name} frame {frame}: the horizon is off: {horizon:?}");
    }
}

#[test]
fn a_drive_near_the_south_pole_agrees_with_the_closed_form() {
    let Some(data) = shared::data() else { return };
    let file = data.join("lunar/nac_southpole_stereo_dem_1m.tif");
    let drive = Drive::over("south-pole", &file, &ReadOptions::default(), &with_tenth_held_out(6.0));
    expect_figures(&drive, 0.0088, 0.0130);
    drive.expect_upright(12.0);
    expect_agreement(&drive, [0, 159], 1);
}

/// Section 19.7 on real ground: the formula at every edge, and the mean errors (mrad) that stand in
/// docs/blocks/vehicle-shadow.md.
fn expect_flat_ground_formula(drive: &Drive, documented: [f64; 4]) {
    let suns = drive.shadow_edges();
    for row in table(&suns, LINE_OF_575) {
        println!("{}: {}", drive.name, row.join(" | "));
    }
    assert_eq!(suns.len(), documented.len());
    for (sun, documented) in suns.into_iter().zip(documented) {
        let figures = sun.figures.unwrap_or_else(|| panic!("{}: no edge is seen: {sun:?}", drive.name));
        let place = format!("{}, sun at {:?}", drive.name, sun.elevation_deg);
        let off = figures.largest_difference_rad;
        assert!(off < 1e-9, "{place}: {off} rad off the formula");
        let found = 1e3 * figures.mean_rad;
        assert!(
            (found - documented).abs() <= ROUNDING * documented,
            "{place}: {found} mrad, docs/blocks/vehicle-shadow.md says {documented}"
        );
    }
}

#[test]
fn a_shadow_on_flat_ground_is_off_by_the_formula() {
    let Some(data) = shared::data() else { return };
    let file = data.join("lunar/nac_southpole_stereo_dem_1m.tif");
    let drive = Drive::over("south-pole", &file, &ReadOptions::default(), &with_tenth_held_out(6.0));
    expect_flat_ground_formula(&drive, [20.74, 16.30, 14.93, 13.44]);
    let options = ReadOptions { scale: Some(0.5), ..ReadOptions::default() };
    let file = data.join("lunar/kepler_lola_48m.tif");
    let drive = Drive::over("kepler", &file, &options, &with_tenth_held_out(240.0));
    expect_flat_ground_formula(&drive, [4.34, 75.62, 68.55, 110.21]);
}

#[test]
fn a_flight_through_kepler_agrees_with_the_closed_form() {
    let Some(data) = shared::data() else { return };
    let options = ReadOptions { scale: Some(0.5), ..ReadOptions::default() };
    let file = data.join("lunar/kepler_lola_48m.tif");
    let drive = Drive::over("kepler", &file, &options, &with_tenth_held_out(240.0));
    expect_figures(&drive, 0.114, 0.190);
    drive.expect_upright(10.0);
    // Samples lie 70 m apart at the far wall: its crest may fall between two, and be 2 lines higher.
    expect_agreement(&drive, [0, 99], 2);
}

#[test]
fn the_apollo_17_stops_lie_where_their_rule_puts_them() {
    let Some(data) = shared::data() else { return };
    let (latitude, longitude) = (radians(20.19), radians(30.77));
    let area =
        Area::Centred { latitude, longitude, size: [210_000.0, 210_000.0], plane: Plane::Equirectangular };
    let options = SurveyOptions { area, ..with_tenth_held_out(15_000.0) };
    let drive = Drive::over("apollo17", &data.join("pds3/LDEM_4.LBL"), &ReadOptions::default(), &options);
    expect_figures(&drive, 0.588, 249.9);
    drive.expect_upright(12.0);
    expect_agreement(&drive, [0, 300], 1);
    let georeference = drive.georeference().expect("a global file has a place on the Moon");
    let stops = apollo::read(&data.join("traverse/apollo17_eva_stops.csv"));
    let committed =
        std::fs::read_to_string(shared::scenario("apollo17.csv")).expect("the path of the scenario");
    assert_eq!(apollo::rows(&stops, georeference), shared::without_comments(&committed));
}
