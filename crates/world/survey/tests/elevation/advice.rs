//! Advice of refusals: what it says to give is given, and leads out.

use survey::{Area, Elevation, Plane, ReadOptions, SurveyOptions, survey};

use crate::made::{Directory, Field, Made, against, floats, heights, labelled, quarters, words};

/// The value that a refusal gives for an option, up to the next blank or comma and blank.
pub fn advised<'a>(refusal: &'a str, option: &str) -> &'a str {
    let (_, after) =
        refusal.split_once(&format!("{option} ")).unwrap_or_else(|| panic!("no {option}: {refusal}"));
    after.split(' ').next().unwrap_or_default()
}

/// Follows refusals that advise `--no-data` until the file is read; gives how many there were.
pub fn no_data(made: &Made) -> usize {
    let mut options = ReadOptions::default();
    for refusals in 0..10 {
        match made.read(&options) {
            Ok(_) => return refusals,
            Err(refusal) => {
                let values = advised(&refusal, "--no-data").split(',');
                options.no_data = values.map(|value| value.parse().unwrap()).collect();
            }
        }
    }
    panic!("the advice leads in a circle: {:?}", options.no_data);
}

/// What is read when a refusal's words are there and its advice is followed.
fn followed(made: &Made, words: &[&str], options: ReadOptions) -> Elevation {
    let refusal = made.refusal();
    words.iter().for_each(|word| assert!(refusal.contains(word), "no {word}: {refusal}"));
    made.read(&options).unwrap()
}

fn options() -> ReadOptions {
    ReadOptions::default()
}

#[test]
fn voids_that_nothing_declares() {
    let with = |marks: &[f64]| {
        let mut samples = heights();
        samples[7..7 + marks.len()].copy_from_slice(marks);
        Directory::of(floats(&samples), 32, 3)
    };
    assert_eq!(no_data(&with(&[f64::from(f32::MIN), 1e30, 1e30, f64::INFINITY]).made()), 3);
    assert_eq!(no_data(&with(&[f64::from(f32::MIN)]).with_items(&[("SCALE", "0.3")]).made()), 1);
    // What the file declares stays declared.
    let declared = with(&[-9999.0, f64::from(f32::MIN)]).with(42113, Field::Text("-9999".into())).made();
    assert!(declared.refusal().contains("--no-data -9999.0,-3.4"), "{}", declared.refusal());
    assert_eq!(no_data(&declared), 1);
    let radii = heights().iter().map(|height| 1_737_400.0 + height).chain([]).collect::<Vec<_>>();
    let mut radii: Vec<f64> = radii;
    radii[9] = 0.0;
    let bytes = radii.iter().flat_map(|radius| radius.to_le_bytes()).collect();
    assert_eq!(no_data(&Directory::of(bytes, 64, 3).made()), 1);
}

#[test]
fn text_in_place_of_numbers() {
    let void = Directory::ground().with(42113, Field::Text("none".into())).made();
    let read = followed(
        &void,
        &["GDAL_NODATA", "give --no-data VALUE"],
        ReadOptions { no_data: vec![-1.0], ..options() },
    );
    assert_eq!(against(&read, 1.0, 0.0), (0, 0.0));
    let scale = Directory::ground().with_items(&[("SCALE", "half"), ("OFFSET", "1")]).made();
    let read = followed(
        &scale,
        &["item SCALE", "give --scale METRES"],
        ReadOptions { scale: Some(1.0), ..options() },
    );
    assert_eq!(against(&read, 1.0, 1.0), (0, 0.0));
    let offset = Directory::ground().with_items(&[("OFFSET", "much")]).made();
    let read = followed(
        &offset,
        &["item OFFSET", "give --offset METRES"],
        ReadOptions { offset: Some(2.0), ..options() },
    );
    assert_eq!(against(&read, 1.0, 2.0), (0, 0.0));
    let list = Directory::ground().with_items(&[("NODATA_VALUES", "1 2 3")]).made();
    followed(
        &list,
        &["item NODATA_VALUES", "give --no-data"],
        ReadOptions { no_data: vec![1.0], ..options() },
    );
}

#[test]
fn units_that_are_not_known() {
    let scale = ReadOptions { scale: Some(0.25), ..options() };
    let label = labelled(&[("UNIT = METER", "UNIT = DEGREE")], &words(&quarters()));
    let read = followed(&label, &["label, UNIT", "DEGREE", "give --scale METRES"], scale.clone());
    assert_eq!(against(&read, 1.0, 0.0), (0, 0.0));
    let both = [("UNIT = METER", "UNIT = ROD\n  OFFSET = 2")];
    let label = labelled(&both, &words(&quarters()));
    let read = followed(
        &label,
        &["ROD", "give --scale METRES and --offset METRES"],
        ReadOptions { offset: Some(3.0), ..scale },
    );
    assert_eq!(against(&read, 1.0, 3.0), (0, 0.0));
    assert!(
        label.read(&ReadOptions { scale: Some(0.25), ..options() }).unwrap_err().contains("--offset METRES")
    );
    let item = Directory::ground().with_items(&[("UNITTYPE", "decibel")]).made();
    let read =
        followed(&item, &["UNITTYPE", "decibel", "--scale"], ReadOptions { scale: Some(2.0), ..options() });
    assert_eq!(against(&read, 2.0, 0.0), (0, 0.0));
    let code = Directory::ground().with_keys(&[(1024, 1.0), (3076, 9001.0), (4096, 5715.0)]).made();
    let read = followed(
        &code,
        &["VerticalGeoKey", "5715", "--scale"],
        ReadOptions { scale: Some(-1.0), ..options() },
    );
    assert_eq!(against(&read, -1.0, 0.0), (0, 0.0));
}

#[test]
fn heights_among_the_geo_tags() {
    let scale = Directory::ground().with(33550, Field::Doubles(vec![10.0, 10.0, 0.5])).made();
    let read = followed(
        &scale,
        &["ModelPixelScaleTag", "give --scale METRES"],
        ReadOptions { scale: Some(0.5), ..options() },
    );
    assert_eq!(against(&read, 0.5, 0.0), (0, 0.0));
    let tie = vec![0.0, 0.0, 0.0, 10_000.0, 20_000.0, 30.0];
    let level = Directory::ground().with(33922, Field::Doubles(tie)).made();
    let read = followed(
        &level,
        &["ModelTiepointTag", "give --offset METRES"],
        ReadOptions { offset: Some(30.0), ..options() },
    );
    assert_eq!(against(&read, 1.0, 30.0), (0, 0.0));
}

#[test]
fn places_and_bands_that_a_file_does_not_say() {
    let mut bare = Directory::ground();
    [33550, 33922, 34735, 34736].iter().for_each(|tag| drop(bare.tags.remove(tag)));
    let spacing = ReadOptions { spacing: Some([5.0; 2]), ..options() };
    let read = followed(&bare.made(), &["geo tags", "give --spacing-m METRES"], spacing.clone());
    assert_eq!(read.affine.step, [-5.0, 5.0]);
    let label = labelled(&[("MAP_PROJECTION_TYPE = \"EQUIRECTANGULAR\"", "")], &words(&quarters()));
    let read = followed(&label, &["MAP_PROJECTION_TYPE", "give --spacing-m METRES"], spacing.clone());
    assert_eq!(read.affine.step, [-5.0, 5.0]);
    // A place that the file has is not replaced.
    assert!(Directory::ground().made().read(&spacing).unwrap_err().starts_with("spacing: found 5,5"));
    let two = [("UNIT = METER", "UNIT = METER\n  BANDS = 2")];
    let label = labelled(&two, &words(&quarters()).repeat(2));
    let read = followed(
        &label,
        &["2 bands, none chosen", "give --band N"],
        ReadOptions { band: Some(2), ..options() },
    );
    assert_eq!(against(&read, 1.0, 0.0), (0, 0.0));
}

#[test]
fn radii_in_kilometres_without_a_unit() {
    let samples: Vec<f64> = heights().iter().map(|height| 1737.4 + 1e-3 * height).collect();
    let bytes = samples.iter().flat_map(|radius| radius.to_le_bytes()).collect();
    let made = Directory::of(bytes, 64, 3).made();
    let notes = made.plain().unwrap().notes.join("\n");
    assert_eq!(advised(&notes, "give --scale"), "1000", "{notes}");
    let read = made.read(&ReadOptions { scale: Some(1000.0), ..options() }).unwrap();
    assert!(against(&read, 1.0, 0.0).1 < 1e-6);
}

/// The error of a survey.
fn said(elevation: &Elevation, options: &SurveyOptions) -> String {
    survey(elevation, options, &mut |_| {}).unwrap_err().to_string()
}

#[test]
fn areas_that_do_not_go_with_the_file() {
    let metres = Area::Metres { south: 19_800.0, west: 10_050.0, north: 19_900.0, east: 10_150.0 };
    let centre = |size: f64| {
        let [latitude, longitude] = [0.656_f64, 0.334].map(quantities::radians);
        Area::Centred { latitude, longitude, size: [size; 2], plane: Plane::Equirectangular }
    };
    let with = |area: Area, region: f64| SurveyOptions { area, ..SurveyOptions::new(region) };
    let works = |elevation: &Elevation, options: &SurveyOptions| {
        survey(elevation, options, &mut |_| {}).unwrap_or_else(|error| panic!("{error}"));
    };
    let known = Directory::ground().made().plain().unwrap();
    let unknown = Directory::ground().with_keys(&[(1024, 1.0), (3076, 9001.0)]).made().plain().unwrap();
    assert!(said(&unknown, &with(centre(50.0), 25.0)).contains("give the area in metres"));
    works(&unknown, &with(metres, 25.0));
    assert!(said(&known, &with(centre(900.0), 25.0)).contains("give a smaller area"));
    works(&known, &with(centre(50.0), 25.0));
    assert!(said(&known, &with(Area::Whole, 300.0)).contains("at most the size of the area"));
    assert!(said(&known, &with(Area::Whole, 0.5)).contains("give larger regions"));
    works(&known, &with(Area::Whole, 25.0));
    // Degrees: an area by its centre, and a plane that is true where it is large.
    let degrees = Directory::ground()
        .with(33550, Field::Doubles(vec![0.5, 0.5, 0.0]))
        .with(33922, Field::Doubles(vec![0.0, 0.0, 0.0, 0.0, 60.0, 0.0]))
        .with_keys(&[(1024, 2.0), (2057, 1_737_400.0)]);
    let degrees = degrees.made().plain().unwrap();
    assert!(said(&degrees, &with(metres, 25.0)).contains("give the area by its centre and size"));
    let on = |plane: Plane| {
        let [latitude, longitude] = [54.0_f64, 6.0].map(quantities::radians);
        let area = Area::Centred { latitude, longitude, size: [200_000.0; 2], plane };
        survey(&degrees, &with(area, 50_000.0), &mut |_| {}).unwrap().report.warnings.join(" ")
    };
    assert!(on(Plane::Equirectangular).contains("use a smaller area or the orthographic plane"));
    assert!(!on(Plane::Orthographic).contains("off by up to"));
}
