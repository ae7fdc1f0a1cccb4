//! Tracks of GPX: what they come to, and what is refused with its line.

use quantities::radians;
use scenario::{HeightOver, Scenario, Waypoint};

use crate::{RADIUS, bank, equator, notes, read_over};

const POINT: &str =
    "<trkpt lat=\"1.001\" lon=\"2.001\"><ele>12.5</ele><time>2026-11-26T22:00:00Z</time></trkpt>";
const NEXT: &str = "<trkpt lat=\"1.002\" lon=\"2.002\"><ele>13.5</ele><time>2026-11-26T22:00:10.5Z</time><hdop>2</hdop></trkpt>";

fn gpx(tracks: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<gpx xmlns=\"http://www.topografix.com/GPX/1/1\" version=\"1.1\">\n<metadata/>\n\
         <wpt lat=\"0\" lon=\"0\"/>\n{tracks}\n</gpx>\n"
    )
}

fn track(points: &str) -> String {
    format!("<trk><name>a walk</name><trkseg>{points}</trkseg></trk>")
}

fn over_equator(text: &str, keys: &str) -> Result<Scenario, Vec<String>> {
    read_over(Some(&bank(Some(equator()))), "walk.gpx", text.as_bytes(), keys)
}

#[test]
fn a_track_is_a_path() {
    let whole = gpx(&track(&format!("{POINT}{NEXT}")));
    let read = over_equator(&whole, "").unwrap();
    let [first, last] = [0, 1].map(|index: usize| read.path.waypoints()[index]);
    let degree = RADIUS * radians(1.0);
    for (waypoint, share) in [(first, 0.001), (last, 0.002)] {
        assert!(waypoint.at.iter().all(|place| (place - share * degree).abs() < 1e-6), "{waypoint:?}");
    }
    assert_eq!((first.time, last.time, first.eye_height, first.heading), (0.0, 10.5, None, None));
    assert!(
        notes(&read).iter().any(|note| note.contains("heights of the track are not used")),
        "{:?}",
        read.notes
    );
    let heights = |word: &str| {
        let path = over_equator(&whole, &format!("heights = \"{word}\"\n")).unwrap().path;
        (path.height_over(), path.waypoints()[1].eye_height)
    };
    assert_eq!(heights("unused"), (HeightOver::Datum, None));
    assert_eq!(heights("above-datum"), (HeightOver::Datum, Some(13.5)));
    assert_eq!(heights("above-ground"), (HeightOver::Ground, Some(13.5)));
    // Windows, a byte order mark, GPX 1.0, a prefix, no version, a point that stands there twice.
    let prefixed = whole.replace("xmlns=", "xmlns:g=").replace("</", "</g:").replace('<', "<g:");
    for text in [
        format!("\u{feff}{}", whole.replace('\n', "\r\n")),
        whole.replace("GPX/1/1", "GPX/1/0").replace("version=\"1.1\"", "version=\"1.0\""),
        prefixed.replace("<g:/g:", "</g:").replace("<g:?xml", "<?xml"),
        whole.replace(" version=\"1.1\"", ""),
        whole.replace(NEXT, &format!("{NEXT}{NEXT}")),
    ] {
        let waypoints: Vec<Waypoint> = over_equator(&text, "").unwrap().path.waypoints().to_vec();
        assert_eq!(waypoints, [first, last]);
    }
}

#[test]
fn tracks_and_segments_are_named() {
    let later = NEXT.replace("22:00:10.5", "23:00:00");
    let two = gpx(&format!("{}{}", track(&format!("{POINT}{NEXT}")), track(&format!("{NEXT}{later}"))));
    let said = over_equator(&two, "").unwrap_err();
    assert_eq!(said, ["2 2 tracks: 1 \"a walk\" (2 points), 2 \"a walk\" (2 points)"]);
    let first = |keys: &str, text: &str| over_equator(text, keys).map(|read| read.path.waypoints()[0].at);
    assert_eq!(first("track = 1\n", &two), first("", &gpx(&track(&format!("{POINT}{NEXT}")))));
    assert_eq!(first("track = 2\n", &two), first("", &gpx(&track(&format!("{NEXT}{later}")))));
    assert!(first("track = 3\n", &two).unwrap_err()[0].contains("`path.track` = 3, but there are 2 tracks"));
    let segments = gpx(&format!("<trk><trkseg>{POINT}</trkseg><trkseg>{NEXT}{later}</trkseg></trk>"));
    assert!(first("", &segments).unwrap_err()[0].contains("2 segments: 1 (1 points), 2 (2 points)"));
    assert!(first("segment = 2\n", &segments).is_ok());
}

#[test]
fn tracks_that_are_no_path_are_refused_with_their_line() {
    let cases = [
        (track(&POINT.replace("<time>2026-11-26T22:00:00Z</time>", "")), "5 a track point without a time"),
        (track(&POINT.replace("22:00:00Z", "25:00:00Z")), "5 `time` must be a date with hour 0 to 23"),
        (track(&POINT.replace("1.001", "91")), "5 `lat` must be a number of degrees from -90 to 90, not 91"),
        (
            track(&POINT.replace(" lon=\"2.001\"", "")),
            "5 `lon` must be a number of degrees from -180 to 180, not nothing",
        ),
        (track(&POINT.replace("ele>", "height>")), "5 unknown element `height` in `trkpt`"),
        (track(""), "5 a track segment without points"),
        (track(&format!("{NEXT}\n{POINT}")), "6 t = -10.5 s after t = 0 s"),
        (track(&format!("{POINT}\n{}", POINT.replace("1.001", "1.002"))), "6 t = 0 s after t = 0 s"),
        (track(&POINT.replace("12.5", "NaN")), "5 `ele` must be a number of metres"),
        (track(&POINT.replace("12.5", "1e9")), "5 `ele` must be a number of metres"),
        (track(&POINT.replace("<ele>", "<ele>1</ele><ele>")), "5 a second `ele` in a `trkpt`"),
        (track(&POINT.replace("<time>", "<time>2026-11-26T21:00:00Z</time><time>")), "5 a second `time`"),
        (
            track(&POINT.replace("<ele>", "<ele xmlns=\"urn:depth\">")),
            "5 element `ele` of another namespace in `trkpt`",
        ),
        (String::new(), "2 a GPX file without a track"),
        ("<trk><name>x</name></trk>".into(), "5 a GPX file without a segment"),
        ("<waypoint/>".into(), "5 unknown element `waypoint` in `gpx`"),
        ("<trk>".into(), "6 not XML"),
    ];
    for (tracks, said) in cases {
        let found = over_equator(&gpx(&tracks), "").expect_err(&tracks);
        assert!(found.iter().any(|title| title.starts_with(said)), "{tracks}: {found:?}");
    }
    let no_height = track(&POINT.replace("<ele>12.5</ele>", ""));
    assert!(
        over_equator(&gpx(&no_height), "heights = \"above-datum\"\n").unwrap_err()[0]
            .contains("without a height")
    );
    let document_type = "<!DOCTYPE gpx [<!ENTITY a \"b\">]><gpx>&a;</gpx>";
    assert!(over_equator(document_type, "").unwrap_err()[0].contains("not XML"));
    assert!(over_equator("<kml/>", "").unwrap_err()[0].contains("the element `kml`"));
    let whole = gpx(&track(POINT));
    for (text, said) in [
        (whole.replace("version=\"1.1\"", "version=\"2.0\""), "GPX of version 2.0"),
        (whole.replace("GPX/1/1", "GPX/2/0"), "a `gpx` of the namespace http://www.topografix.com/GPX/2/0"),
        (
            whole.replace(" xmlns=\"http://www.topografix.com/GPX/1/1\"", ""),
            "a `gpx` of the namespace nothing",
        ),
    ] {
        assert!(over_equator(&text, "").unwrap_err()[0].contains(said), "{said}");
    }
    assert!(
        over_equator(&gpx(&track(POINT)), "coordinates = \"bank\"\n").unwrap_err()[0]
            .contains("a GPX file has latitudes")
    );
}
