//! The inputs of `shared/cases` that are elevation files: each gives the values that its README calls right.

use std::path::{Path, PathBuf};

use quantities::degrees;
use survey::{Elevation, ReadOptions, SurveyOptions, read, survey};

/// File, lowest and highest sample (m), voids.
const READ: [(&str, [f64; 2], usize); 18] = [
    ("01-pds3-special-pixels/special.lbl", [50.0, 55.8], 20),
    ("02-pds3-special-real-circle/special_real.lbl", [50.0, 55.8], 8),
    ("03-pds3-list-of-voids/list.lbl", [50.0, 55.8], 8),
    ("04-pds3-record-bytes-of-another-file/nested.lbl", [50.0, 55.8], 0),
    ("06-pds3-units/scale_without_unit.lbl", [50.0, 55.8], 0),
    ("06-pds3-units/feet.lbl", [15.24, 17.0], 0),
    ("06-pds3-units/kilometres.lbl", [50.0, 55.8], 0),
    ("06-pds3-units/scale_in_cm.lbl", [50.0, 55.8], 0),
    ("07-pds3-labels-refused/begin_object.lbl", [50.0, 55.8], 0),
    ("07-pds3-labels-refused/list_unit.lbl", [50.0, 55.8], 0),
    ("07-pds3-labels-refused/east.lbl", [50.0, 55.8], 0),
    ("07-pds3-labels-refused/end_nul.img", [50.0, 55.8], 0),
    ("08-geotiff-mask/mask.tif", [50.0, 55.75], 16),
    ("09-geotiff-vertical-units/a_unittype_foot.tif", [50.0, 55.75], 0),
    ("09-geotiff-vertical-units/b_geokey_foot.tif", [50.0, 55.75], 0),
    ("09-geotiff-vertical-units/c_unittype_km.tif", [50.0, 55.75], 0),
    ("13-geotiff-radii/radius.tif", [-2350.0, -2344.25], 0),
    ("12-geotiff-longitude-0-360/lon360.tif", [50.0, 55.75], 0),
];

/// The path of a case, or a loud line that it was left out.
fn case(name: &str) -> Option<PathBuf> {
    let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
    let found = folders.map(|folder| folder.join("shared/cases").join(name)).find(|path| path.is_file());
    if found.is_none() {
        println!("SKIPPED: shared/cases/{name} is not there");
    }
    found
}

fn of(path: &Path) -> Elevation {
    read(path, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn cases_give_the_heights_that_are_right() {
    for (name, [low, high], voids) in READ {
        let Some(path) = case(name) else { continue };
        let read = of(&path);
        let [least, most] = read.range().unwrap();
        assert!((least - low).abs() < 0.06 && (most - high).abs() < 0.06, "{name}: {least} to {most}");
        assert_eq!(read.voids(), voids, "{name}");
        assert!((read.affine.step[1] - 10.0).abs() < 1e-6, "{name}: {:?}", read.affine);
    }
}

#[test]
fn a_label_without_a_value_names_it() {
    let Some(path) = case("07-pds3-labels-refused/empty.lbl") else { return };
    let said = read(path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(
        said.contains("label line 4: found NOTE without a value") && said.contains("its value"),
        "{said}"
    );
}

#[test]
fn a_file_of_the_earth_has_its_steps_and_a_note() {
    let Some(path) = case("10-geotiff-earth-by-code/wgs84.tif") else { return };
    let read = of(&path);
    let step = read.affine.step[1] * read.frame.sphere().unwrap();
    assert!((step - 30.92).abs() < 0.01, "{step}");
    assert!(read.notes.iter().any(|note| note.contains("4326, a code of the Earth, not of the Moon")));
}

#[test]
fn a_map_from_0_to_360_has_its_north() {
    let Some(path) = case("12-geotiff-longitude-0-360/lon360.tif") else { return };
    let found = survey(&of(&path), &SurveyOptions::new(40.0), &mut |_| {}).unwrap();
    assert!(degrees(found.report.true_north.unwrap()).abs() < 1e-6);
    assert!((degrees(found.bank.georeference().unwrap().longitude) + 169.996).abs() < 1e-3);
}

#[test]
fn samples_below_a_byte_are_all_there() {
    for (name, most) in [("bits1-fmt1", 1.0), ("bits4-fmt1", 15.0)] {
        let Some(path) = case(&format!("a05-geotiff-subbyte/{name}.tif")) else { continue };
        let read = of(&path);
        assert_eq!((read.voids(), read.range()), (0, Some([0.0, most])), "{name}");
    }
}
