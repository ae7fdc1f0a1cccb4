//! Windows of files: the same samples as the whole file has, and no more read than they need.

use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::Path;

use proptest::prelude::{ProptestConfig, proptest};
use quantities::radians;
use survey::{Area, Elevation, Plane, ReadOptions, SurveyOptions, Window, open, survey};

use crate::labels::{ENVI, HEAD, ISIS, PDS4, PRJ, ascii, cube, envi, isis, pds4, replaced};
use crate::made::{Directory, Field, LABEL, Made, SIDE, floats, heights, quarters, tiff, words};

fn window(
    path: &Path,
    lines: std::ops::Range<usize>,
    columns: std::ops::Range<usize>,
) -> Result<Elevation, String> {
    let opened = open(path, &ReadOptions::default()).map_err(|error| error.to_string())?;
    opened.window(&Window { lines, columns }).map_err(|error| error.to_string())
}

/// A TIFF in tiles of 16 x 16, with a mask in tiles of its own.
fn tiled() -> Made {
    let tile = |down: usize, across: usize, sample: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
        (0..256)
            .map(|k| sample((down * 16 + k / 16).min(SIDE - 1), (across * 16 + k % 16).min(SIDE - 1)))
            .collect()
    };
    let blocks = |sample: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..4).map(|k| tile(k / 2, k % 2, sample)).collect()
    };
    let all = heights();
    let mut ground = Directory::ground();
    [273, 279, 278].iter().for_each(|tag| drop(ground.tags.remove(tag)));
    ground.place = [324, 325];
    ground.blocks =
        blocks(&|line, column| all[line * SIDE + column]).iter().map(|tile| floats(tile)).collect();
    let ground = ground.with(322, Field::Shorts(vec![16])).with(323, Field::Shorts(vec![16]));
    let side = SIDE as u16;
    let shorts =
        [(254, 4), (256, side), (257, side), (258, 8), (259, 1), (262, 4), (277, 1), (322, 16), (323, 16)];
    let bytes = |tile: &Vec<f64>| tile.iter().map(|sample| *sample as u8).collect();
    let mut mask = Directory::new(
        &shorts,
        blocks(&|line, column| f64::from((line + column) % 5 != 0)).iter().map(bytes).collect(),
    );
    mask.place = [324, 325];
    tiff(&[ground, mask])
}

/// Files of the made ground, one a format.
fn files() -> Vec<Made> {
    let interleaved = ENVI.replace("bsq", "bip").replace("bands = 1", "bands = 1\ndata ignore value = 201");
    let tiles = ISIS.replace("Format = BandSequential", "Format = Tile\n TileSamples = 5\n TileLines = 7");
    let padded = vec![7; 2 * 5 * 5 * 7 * 4];
    let label = LABEL.replace("LINES = 24", "LINES = 24\n  LINE_PREFIX_BYTES = 4");
    let lines: Vec<u8> = words(&quarters()).chunks(48).flat_map(|line| [&[0; 4], line].concat()).collect();
    vec![
        pds4(PDS4),
        isis(ISIS),
        Made::new(&[("made.cub", &cube(&tiles, &padded))]),
        envi(&interleaved),
        ascii(HEAD, PRJ),
        Made::new(&[("made.lbl", label.as_bytes()), ("made.img", &lines)]),
        Directory::ground().made(),
        tiled(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn a_window_has_the_samples_of_the_whole(a in 0..SIDE, b in 0..SIDE, c in 0..SIDE, d in 0..SIDE) {
        let (lines, columns) = (a.min(b)..a.max(b) + 1, c.min(d)..c.max(d) + 1);
        for made in files() {
            let whole = made.plain().unwrap();
            let held = lines.clone().any(|line| columns.clone().any(|column| whole.height(line, column).is_some()));
            let part = window(&made.path, lines.clone(), columns.clone());
            assert_eq!(part.is_ok(), held, "{:?}", part.map(|_| ()));
            let Ok(part) = part else { continue };
            assert_eq!((part.lines, part.columns), (lines.len(), columns.len()));
            assert_eq!((part.corner, part.file_size), ([lines.start, columns.start], [SIDE; 2]));
            for (line, column) in lines.clone().flat_map(|line| columns.clone().map(move |column| (line, column))) {
                let own = [line - lines.start, column - columns.start];
                assert_eq!(part.height(own[0], own[1]), whole.height(line, column));
                let (found, expected) = (part.place(own[0], own[1]), whole.place(line, column));
                assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 1e-9), "{found:?} {expected:?}");
            }
        }
    }
}

#[test]
fn windows_lie_in_their_files() {
    let made = pds4(PDS4);
    for (lines, columns) in [(0..25, 0..24), (0..24, 3..25), (5..5, 0..24), (0..24, 24..24), (30..31, 0..2)] {
        let said = window(&made.path, lines, columns).unwrap_err();
        assert!(said.contains("some of 24 lines and 24 columns"), "{said}");
    }
}

/// A globe in steps of 5 degrees, whose longitudes go from 0 to 360.
fn globe() -> Made {
    let place = "<cart:latitude_resolution>5</cart:latitude_resolution>
<cart:longitude_resolution>5</cart:longitude_resolution>
<cart:north_bounding_coordinate>90</cart:north_bounding_coordinate>
<cart:west_bounding_coordinate>0</cart:west_bounding_coordinate>";
    let label = replaced(PDS4, "<cart:map_projection_name>Equirectangular</cart:map_projection_name>", place)
        .replace("<axis_name>Line</axis_name><elements>24", "<axis_name>Line</axis_name><elements>36")
        .replace("<axis_name>Sample</axis_name><elements>24", "<axis_name>Sample</axis_name><elements>72");
    let heights: Vec<u8> = (0..36 * 72).flat_map(|index| (index as i16 % 97 * 31).to_le_bytes()).collect();
    Made::new(&[("made.xml", label.as_bytes()), ("made.dat", &heights)])
}

#[test]
fn a_window_goes_over_the_seam_of_a_globe() {
    let made = globe();
    let whole = made.plain().unwrap();
    let part = window(&made.path, 3..9, 68..80).unwrap();
    for (line, column) in (0..6).flat_map(|line| (0..12).map(move |column| (line, column))) {
        assert_eq!(part.height(line, column), whole.height(3 + line, (68 + column) % 72));
    }
    assert!((part.place(0, 11)[1] - radians(5.0 * 79.5)).abs() < 1e-12);
    assert!(window(&made.path, 0..2, 70..143).is_err() && window(&made.path, 0..2, 70..142).is_ok());
}

#[test]
fn a_survey_of_a_window_is_that_of_the_file() {
    let plain = |area, size| SurveyOptions { area, held_out: 0.1, ..SurveyOptions::new(size) };
    let centred = |latitude: f64, longitude: f64, size, plane| Area::Centred {
        latitude: radians(latitude),
        longitude: radians(longitude),
        size,
        plane,
    };
    let (flat, round) = (Plane::Equirectangular, Plane::Orthographic);
    let metres = Area::Metres { south: 19_800.0, west: 10_050.0, north: 19_910.0, east: 10_161.0 };
    let far = 150_000.0;
    let cases = [
        (pds4(PDS4), plain(metres, 37.0)),
        (tiled(), SurveyOptions { levels: vec![1, 2], ..plain(metres, 40.0) }),
        (Directory::ground().made(), plain(Area::Whole, 50.0)),
        (globe(), plain(centred(10.0, 3.0, [1.5e6, 1.6e6], flat), 4.0 * far)),
        (globe(), plain(centred(-20.0, -170.0, [1.5e6, 1.6e6], flat), 4.0 * far)),
        (globe(), plain(centred(30.0, -2.0, [1.4e6, 1.4e6], round), 4.0 * far)),
        (globe(), plain(centred(-89.0, 40.0, [1.4e6, 1.4e6], round), 4.0 * far)),
        (globe(), plain(Area::Whole, 8.0 * far)),
    ];
    for (made, options) in cases {
        let whole = survey(&made.plain().unwrap(), &options, &mut |_| {}).unwrap();
        let opened = open(&made.path, &ReadOptions::default()).unwrap();
        let window = options.window(&opened).unwrap();
        let size = opened.size();
        let elevation = opened.window(&window).unwrap();
        let is_smaller = elevation.lines * elevation.columns < size[0] * size[1];
        assert_eq!(is_smaller, options.area != Area::Whole, "{window:?} of {size:?}");
        let part = survey(&elevation, &options, &mut |_| {}).unwrap();
        let (a, b) = (&whole.report.levels[0], &part.report.levels[0]);
        assert_eq!((a.used, a.held_out, a.void), (b.used, b.held_out, b.void), "{options:?}");
        assert_eq!(a.worst.in_file, b.worst.in_file);
        assert_eq!(whole.fitted.values.len(), part.fitted.values.len());
        let pairs = whole.fitted.values.iter().zip(&part.fitted.values);
        let apart = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-6, "{apart} m, {options:?}");
        let outside =
            SurveyOptions { area: Area::Metres { south: 0.0, west: 0.0, north: 9.0, east: 9.0 }, ..options };
        assert!(outside.window(&open(&made.path, &ReadOptions::default()).unwrap()).is_err());
    }
}

/// Lines and columns of files that are larger than a memory.
const HUGE: [u64; 2] = [200_000, 100_000];

/// A file of so many bytes that the disk does not hold, with two heights (stored as 16-bit integers) at some places.
fn sparse(path: &Path, bytes: u64, places: [u64; 2]) {
    let mut file = File::create(path).unwrap();
    file.set_len(bytes).unwrap();
    for (place, height) in places.into_iter().zip([700_i16, -800]) {
        file.seek(SeekFrom::Start(place)).unwrap();
        file.write_all(&height.to_le_bytes()).unwrap();
    }
}

fn check_huge(path: &Path) {
    let read = window(path, 150_000..150_008, 70_000..70_010).unwrap();
    let corners = [read.height(0, 0), read.height(7, 9), read.height(3, 3)];
    assert_eq!(corners, [Some(700.0), Some(-800.0), Some(0.0)], "{}", path.display());
    assert_eq!(read.corner, [150_000, 70_000]);
}

#[test]
fn windows_of_forty_gigabytes() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let line = 2 * HUGE[1];
    let place = |line_bytes: u64| [(150_000, 70_000), (150_007, 70_009)].map(|(l, c)| l * line_bytes + 2 * c);
    sparse(&at("huge.dat"), HUGE[0] * line, place(line));
    let header = ENVI.replace("samples = 24", "samples = 100000").replace("lines = 24", "lines = 200000");
    std::fs::write(at("huge.hdr"), header.replace("{0.25}", "{1}")).unwrap();
    check_huge(&at("huge.hdr"));
    let label = PDS4
        .replace("<axis_name>Line</axis_name><elements>24", "<axis_name>Line</axis_name><elements>200000")
        .replace(
            "<axis_name>Sample</axis_name><elements>24",
            "<axis_name>Sample</axis_name><elements>100000",
        );
    std::fs::write(at("huge.xml"), label.replace("made.dat", "huge.dat").replace(">0.25<", ">1<")).unwrap();
    check_huge(&at("huge.xml"));
    let label =
        LABEL.replace("LINES = 24", "LINES = 200000").replace("LINE_SAMPLES = 24", "LINE_SAMPLES = 100000");
    std::fs::write(at("huge.lbl"), label.replace("made.img", "huge.dat").replace("0.25", "1")).unwrap();
    check_huge(&at("huge.lbl"));
    // Zeros of signed words are heights.
    let tile = |line: u64, column: u64| {
        let index = line / 128 * HUGE[1].div_ceil(128) + column / 128;
        index * 128 * 128 * 2 + (line % 128 * 128 + column % 128) * 2
    };
    let tiles = "StartByte = 1\n ^Core = core.dat\n TileLines = 128\n TileSamples = 128";
    let label = ISIS
        .replace("StartByte = 4097", tiles)
        .replace("BandSequential", "Tile")
        .replace("Samples = 24", "Samples = 100000")
        .replace("Lines = 24", "Lines = 200000");
    std::fs::write(at("tiles.lbl"), label.replace("Multiplier = 0.25", "Multiplier = 1")).unwrap();
    let bytes = HUGE[0].div_ceil(128) * HUGE[1].div_ceil(128) * 128 * 128 * 2;
    sparse(&at("core.dat"), bytes, [tile(150_000, 70_000), tile(150_007, 70_009)]);
    check_huge(&at("tiles.lbl"));
    std::fs::write(at("huge.tif"), []).unwrap();
    big_tiff(&at("huge.tif"));
    check_huge(&at("huge.tif"));
}

/// A BigTIFF of one strip a line, all of the same size, behind its directory.
fn big_tiff(path: &Path) {
    let (lines, columns) = (HUGE[0], HUGE[1]);
    let mut fields: Vec<(u16, u16, u64, u64)> =
        [(256, columns), (257, lines), (258, 16), (259, 1), (262, 1), (277, 1), (278, 1), (339, 2)]
            .map(|(tag, number)| (tag, 4, 1, number))
            .to_vec();
    let directory = 16;
    let entries = 12;
    let behind = directory + 8 + entries * 20 + 8;
    let (offsets, counts) = (behind + 6 * 8 + 3 * 8, behind + 6 * 8 + 3 * 8 + 8 * lines);
    let data = counts + 8 * lines;
    fields.extend([(273, 16, lines, offsets), (279, 16, lines, counts)]);
    fields.extend([(33550, 12, 3, behind + 48), (33922, 12, 6, behind)]);
    fields.sort_unstable();
    let mut bytes = [&b"II\x2b\0\x08\0\0\0"[..], &16_u64.to_le_bytes(), &entries.to_le_bytes()].concat();
    for (tag, kind, count, value) in fields {
        bytes.extend(
            [&tag.to_le_bytes()[..], &kind.to_le_bytes(), &count.to_le_bytes(), &value.to_le_bytes()]
                .concat(),
        );
    }
    bytes.extend(0_u64.to_le_bytes());
    for number in [0.0, 0.0, 0.0, 1000.0, 5000.0, 0.0, 10.0, 10.0, 0.0_f64] {
        bytes.extend(number.to_le_bytes());
    }
    (0..lines).for_each(|line| bytes.extend((data + line * 2 * columns).to_le_bytes()));
    (0..lines).for_each(|_| bytes.extend((2 * columns).to_le_bytes()));
    assert_eq!(bytes.len() as u64, data);
    let place = |line: u64, column: u64| data + (line * columns + column) * 2;
    sparse(path, data + 2 * lines * columns, [place(150_000, 70_000), place(150_007, 70_009)]);
    File::options().write(true).open(path).unwrap().write_all(&bytes).unwrap();
}
