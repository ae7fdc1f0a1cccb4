//! Longitudes of every kind, seams, and maps that count past half a turn.

use quantities::{degrees, radians};
use survey::{Affine, Area, Elevation, Frame, Method, Plane, Projection, SurveyOptions, survey};

use crate::made::{Directory, Field, Made, quarters, words};

const MOON: f64 = 1_737_400.0;

/// The made ground with its west edge at a longitude (degrees) of an equirectangular map.
fn at(longitude: f64) -> Directory {
    let east = MOON * radians(longitude);
    Directory::ground().with(33922, Field::Doubles(vec![0.0, 0.0, 0.0, east, 20_000.0, 0.0]))
}

/// A survey of 100 m around a point (degrees).
fn around(elevation: &Elevation, latitude: f64, longitude: f64) -> Result<survey::Survey, String> {
    let [latitude, longitude] = [latitude, longitude].map(radians);
    let area = Area::Centred { latitude, longitude, size: [100.0; 2], plane: Plane::Equirectangular };
    let options = SurveyOptions { area, ..SurveyOptions::new(50.0) };
    survey(elevation, &options, &mut |_| {}).map_err(|error| error.to_string())
}

#[test]
fn maps_count_longitudes_from_0_to_360() {
    for edge in [190.0, 359.0, 180.5, -170.0, 10.0] {
        let read = at(edge).made().plain().unwrap();
        let whole = survey(&read, &SurveyOptions::new(40.0), &mut |_| {}).unwrap();
        assert!(whole.report.true_north.unwrap().abs() < 1e-9, "{edge}: {:?}", whole.report.true_north);
        let place = whole.bank.georeference().unwrap();
        assert_eq!(place.true_north, whole.report.true_north);
        let off = degrees(place.longitude) - edge - 0.004;
        assert!((off - 360.0 * (off / 360.0).round()).abs() < 1e-3, "{edge}: {off}");
        // The same place by either of its longitudes.
        for turn in [-360.0, 0.0] {
            let found =
                around(&read, 0.655, edge + 0.004 + turn).unwrap_or_else(|said| panic!("{edge}: {said}"));
            assert_eq!(found.report.levels[0].void, 0, "{edge}");
        }
        assert!(around(&read, 0.655, edge + 1.0).unwrap_err().contains("expected it inside"));
    }
    // A label of the same kind.
    let label = format!("{:.6}", -MOON * radians(190.0) / 10.0);
    let made: Made = crate::made::labelled(&[("-1000.0", &label)], &words(&quarters()));
    let read = made.plain().unwrap();
    assert!(around(&read, 0.655, -169.996).is_ok() && around(&read, 0.655, 190.004).is_ok());
}

/// Heights of a whole globe with a step of 10 degrees from a longitude on, and with so many columns.
fn globe(first: f64, columns: usize) -> Elevation {
    let step = radians(10.0);
    let height = |column: usize| (column % 36) as f64;
    let heights = (0..18 * columns).map(|index| height(index % columns)).collect();
    let affine = Affine { first: [radians(85.0), radians(first)], step: [-step, step] };
    Elevation::new(18, columns, heights, affine, Frame::Geographic { radius: MOON })
}

#[test]
fn one_seam_column_too_many_still_goes_around() {
    let size = [40.0, 60.0].map(|angle| MOON * radians(angle));
    let across = |elevation: &Elevation, longitude: f64, plane: Plane| {
        let area = Area::Centred { latitude: 0.0, longitude: radians(longitude), size, plane };
        let options = SurveyOptions { area, ..SurveyOptions::new(MOON * radians(20.0)) };
        survey(elevation, &options, &mut |_| {}).map_err(|error| error.to_string())
    };
    for (first, columns) in [(5.0, 36), (0.0, 37), (-180.0, 37), (-180.0, 36)] {
        let read = globe(first, columns);
        for longitude in [first, first + 180.0, first - 30.0, first + 370.0] {
            for plane in [Plane::Equirectangular, Plane::Orthographic] {
                let found = across(&read, longitude, plane);
                let found = found.unwrap_or_else(|said| panic!("{first}, {columns}, {longitude}: {said}"));
                assert_eq!(found.report.levels[0].void, 0, "{first}, {columns}, {longitude}, {plane:?}");
            }
        }
    }
    // Two columns too few are a gap.
    assert!(across(&globe(0.0, 34), -5.0, Plane::Equirectangular).is_err());
}

/// A TIFF in degrees of a whole globe, with a last column that stands for the first again.
fn seamed(last: f32) -> Made {
    let row = |line: usize| (0..37).map(move |column| if column == 36 { last } else { line as f32 });
    let bytes = (0..18).flat_map(row).flat_map(f32::to_le_bytes).collect();
    let (columns, lines) = (Field::Shorts(vec![37]), Field::Shorts(vec![18]));
    Directory::of(bytes, 32, 3)
        .with(256, columns)
        .with(257, lines.clone())
        .with(278, lines)
        .with(33550, Field::Doubles(vec![10.0, 10.0, 0.0]))
        .with(33922, Field::Doubles(vec![0.0, 0.0, 0.0, 0.0, 85.0, 0.0]))
        .with_keys(&[(1024, 2.0), (1025, 2.0), (2057, MOON)])
        .made()
}

#[test]
fn a_seam_that_differs_is_told() {
    let notes = seamed(-7.0).plain().unwrap().notes.join("\n");
    assert!(notes.contains("has other heights in 18 lines"), "{notes}");
    let notes = seamed(5.0).plain().unwrap().notes.join("\n");
    assert!(notes.contains("has other heights in 17 lines"), "{notes}");
}

#[test]
fn a_plane_of_another_body_is_told() {
    let keys = [(1024, 1.0), (2057, 6_378_137.0), (3075, 17.0), (3076, 9001.0)];
    let read = Directory::ground().with_keys(&keys).made().plain().unwrap();
    let found = survey(&read, &SurveyOptions::new(40.0), &mut |_| {}).unwrap();
    let warnings = found.report.warnings.join("\n");
    assert!(warnings.contains("sphere of radius 6378137 m, which is not the Moon"), "{warnings}");
    assert!(found.bank.georeference().is_none());
}

/// Near the south pole the x axis of a map points along the meridian of its projection, and the bank knows by how much.
#[test]
fn a_bank_keeps_the_direction_of_true_north() {
    let south = Projection {
        method: Method::PolarStereographic { scale: 1.0 },
        latitude: -radians(90.0),
        longitude: 0.0,
        radius: MOON,
        offset: [0.0; 2],
    };
    for (longitude, first) in
        [(90.0, [0.0, 50_000.0]), (-90.0, [0.0, -50_000.0]), (45.0, [40_000.0, 40_000.0])]
    {
        let affine = Affine { first, step: [-10.0, 10.0] };
        let read = Elevation::new(20, 20, vec![0.0; 400], affine, Frame::Plane(Some(south)));
        let found = survey(&read, &SurveyOptions::new(50.0), &mut |_| {}).unwrap();
        let place = found.bank.georeference().unwrap();
        // The pole lies behind: away from it is north.
        let [latitude, turn] = [place.latitude, place.true_north.unwrap()].map(degrees);
        assert!(latitude < -87.0 && (turn - longitude).abs() < 0.3, "{longitude}: {turn}");
        let read = landscape::bank_file::decode(&landscape::bank_file::encode(&found.bank)).unwrap();
        assert_eq!(read.georeference(), found.bank.georeference());
    }
}

#[test]
fn ground_of_the_earth_has_no_place_on_the_moon() {
    let step = radians(0.001);
    let affine = Affine { first: [radians(45.0), radians(7.0)], step: [-step, step] };
    let read = Elevation::new(20, 20, vec![100.0; 400], affine, Frame::Geographic { radius: 6_371_000.0 });
    let found = survey(&read, &SurveyOptions::new(400.0), &mut |_| {}).unwrap();
    assert!(found.bank.georeference().is_none());
    assert!(found.report.warnings.join("\n").contains("which is not the Moon"));
}

/// The bank keeps where its samples came from: a sample of the file lies in the bank where the survey took it.
#[test]
fn the_map_of_a_bank_leads_back_to_the_file() {
    let [latitude, longitude] = [8.03, 20.04].map(radians);
    let step = radians(0.002);
    let heights = (0..40 * 60).map(|index| f64::from(index % 7)).collect();
    let affine = Affine { first: [radians(8.08), radians(20.0)], step: [-step, step] };
    let degrees = Elevation::new(40, 60, heights, affine, Frame::Geographic { radius: MOON });
    let plane = at(10.0).made().plain().unwrap();
    let Frame::Plane(Some(projection)) = plane.frame else { panic!("{:?}", plane.frame) };
    let centred = |plane| Area::Centred { latitude, longitude, size: [1500.0; 2], plane };
    let [south, west, north, east] = plane.extent();
    let inner = Area::Metres { south: south + 21.0, west: west + 33.0, north: north - 11.0, east };
    for (elevation, area) in [
        (&degrees, Area::Whole),
        (&degrees, centred(Plane::Equirectangular)),
        (&plane, Area::Whole),
        (&plane, inner),
    ] {
        let options =
            SurveyOptions { area, held_out: 0.0, ..SurveyOptions::new(300.0_f64.min(0.4 * (north - south))) };
        let found = survey(elevation, &options, &mut |_| {}).unwrap_or_else(|error| panic!("{error}"));
        let map = found.bank.map().copied().expect("a survey keeps the map");
        let mut met = 0;
        for (line, column) in
            (0..elevation.lines).flat_map(|line| (0..elevation.columns).map(move |column| (line, column)))
        {
            let place = elevation.place(line, column);
            let [latitude, longitude] = match elevation.frame {
                Frame::Geographic { .. } => place,
                Frame::Plane(_) => projection.inverse(place).unwrap(),
            };
            let [x, y] = map.of_point(latitude, longitude).unwrap();
            // Samples of the survey lie at whole steps from the first.
            let steps = [x, y]
                .iter()
                .zip(map.first_sample)
                .zip(map.spacing)
                .map(|((at, first), step)| (at - first) / step);
            let steps: Vec<f64> = steps.collect();
            assert!(steps.iter().all(|step| (step - step.round()).abs() < 1e-3), "{area:?}: {steps:?}");
            met += usize::from(steps.iter().all(|step| step.round() == 0.0));
        }
        assert_eq!(met, 1, "{area:?}: one sample of the file is the south-west one");
        assert!(
            map.first_sample.iter().zip(map.spacing).all(|(first, step)| (0.0..step).contains(first)),
            "{map:?}"
        );
        let is_whole = matches!(area, Area::Whole);
        assert!(
            !is_whole || map.first_sample == [0.0; 2],
            "the origin is the centre of the south-west sample"
        );
    }
    let options = SurveyOptions { area: centred(Plane::Orthographic), ..SurveyOptions::new(300.0) };
    let map = survey(&degrees, &options, &mut |_| {}).unwrap().bank.map().copied().unwrap();
    let [x, y] = map.of_point(latitude, longitude).unwrap();
    assert!((x - 750.0).abs() < 1e-6 && (y - 750.0).abs() < 1e-6, "the middle of the area: {x} {y}");
}
