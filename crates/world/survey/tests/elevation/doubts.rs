//! Numbers that may be no heights, pictures, and files that are no files: told or refused, in every format.

use std::fs::{self, File};
use std::io::{Seek, SeekFrom, Write};

use survey::{Frame, ReadOptions, SurveyOptions, Window, open, read, survey};

use crate::labels::{ENVI, HEAD, ISIS, PDS4, PRJ, ascii, cube, envi, numbers, pds4, replaced};
use crate::made::{Directory, Field, LABEL, Made, SIDE, against, floats, heights, quarters, words};

/// The made samples with two marks that nothing declares.
fn marked(mut samples: Vec<f64>) -> Vec<f64> {
    samples[5] = -32768.0;
    samples[77] = -32768.0;
    samples
}

#[test]
fn a_second_mark_of_voids_is_told() {
    let (stored, metres) = (words(&marked(quarters())), marked(heights()));
    let grid = numbers().replacen("61.5 61.75", "-32768 -32768", 1);
    let grid = format!("{HEAD}{grid}");
    for (made, known) in [
        (Made::new(&[("made.xml", PDS4.as_bytes()), ("made.dat", &stored)]), ""),
        (Made::new(&[("made.lbl", LABEL.as_bytes()), ("made.img", &stored)]), ""),
        (Made::new(&[("made.hdr", ENVI.as_bytes()), ("made.dat", &stored)]), ""),
        (Made::new(&[("made.asc", grid.as_bytes()), ("made.prj", PRJ.as_bytes())]), "-1.0,"),
        (Directory::of(floats(&metres), 32, 3).with(42113, Field::Text("-9999".into())).made(), "-9999.0,"),
    ] {
        let read = made.plain().unwrap();
        let told = format!("if they mark voids, give --no-data {known}-32768.0");
        let note =
            read.notes.iter().find(|note| note.starts_with("2 samples are -32768.0, far from the others"));
        assert!(note.is_some_and(|note| note.ends_with(&told)), "{}: {:?}", made.path.display(), read.notes);
        let declared = ReadOptions { no_data: vec![-9999.0, -1.0, -32768.0], ..ReadOptions::default() };
        let read = made.read(&declared).unwrap();
        assert_eq!(read.voids(), 2, "{}", made.path.display());
        assert!(!read.notes.iter().any(|note| note.contains("--no-data")), "{:?}", read.notes);
    }
    // An ISIS cube has its own marks, the type's least number among them.
    assert_eq!(Made::new(&[("made.cub", &cube(ISIS, &stored))]).plain().unwrap().voids(), 2);
}

#[test]
fn pictures_are_told_or_refused() {
    let bytes: Vec<u8> = heights().iter().map(|height| *height as u8).collect();
    let grey = || Directory::of(bytes.clone(), 8, 1);
    let is_told = |made: &Made| {
        let read = made.plain().unwrap_or_else(|said| panic!("{said}"));
        read.notes.iter().any(|note| note.contains("as those of a picture"))
    };
    assert!(is_told(&grey().made()) && !is_told(&Directory::ground().made()));
    assert!(!is_told(&grey().with_items(&[("SCALE", "0.5")]).made()));
    let scaled = ReadOptions { scale: Some(1.0), ..ReadOptions::default() };
    assert!(!grey().made().read(&scaled).unwrap().notes.iter().any(|note| note.contains("picture")));
    let envi = replaced(ENVI, "data type = 2", "data type = 1").replace("data gain values = {0.25}\n", "");
    assert!(is_told(&Made::new(&[("made.hdr", envi.as_bytes()), ("made.dat", &bytes)])));
    for (meaning, word) in [(0, "found 0"), (2, "found 2"), (3, "found 3"), (6, "found 6")] {
        let said = grey().with(262, Field::Shorts(vec![meaning])).made().refusal();
        assert!(said.contains("tag 262 (PhotometricInterpretation)") && said.contains(word), "{said}");
        assert!(said.contains("colours") && said.contains("palette"), "{said}");
    }
    let colours = [bytes.clone(), bytes.clone(), bytes.clone()].concat();
    let colours = Directory::of(colours, 8, 1)
        .with(258, Field::Shorts(vec![8; 3]))
        .with(262, Field::Shorts(vec![2]))
        .with(277, Field::Shorts(vec![3]));
    assert!(colours.made().refusal().contains("a picture"));
    let png = Made::new(&[("a.png", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")]);
    assert!(png.refusal().contains("starts with the mark of a PNG picture"), "{}", png.refusal());
}

#[test]
fn what_stands_twice_is_named_by_its_own_line() {
    let twice = format!("{ENVI}lines = 25\n");
    let said = Made::new(&[("made.hdr", twice.as_bytes()), ("made.dat", &words(&quarters()))]).refusal();
    assert!(said.contains("header line 12, lines: found 25; expected one value of a key"), "{said}");
    let cube = |label: &str| Made::new(&[("made.cub", &cube(label, &words(&quarters())))]).refusal();
    let group = "  Group = Pixels\n    Type = SignedWord\n  End_Group\nEnd_Object\nEnd";
    let said = cube(&ISIS.replace("End_Object\nEnd", group));
    assert!(said.contains("expected one GROUP PIXELS in a label"), "{said}");
    let said = cube(&ISIS.replace("Group = BandBin", "Group = Weather"));
    assert!(said.contains(", GROUP: found WEATHER"), "{said}");
}

/// The header of an array of float64, as NumPy writes it.
fn array(shape: &str, is_by_columns: bool) -> Vec<u8> {
    let order = if is_by_columns { "True" } else { "False" };
    let text = format!("{{'descr': '<f8', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    [&b"\x93NUMPY\x01\x00"[..], &(text.len() as u16).to_le_bytes(), text.as_bytes()].concat()
}

#[test]
fn windows_of_arrays_are_read_without_the_rest() {
    let options = ReadOptions { spacing: Some([10.0; 2]), ..ReadOptions::default() };
    let by_lines = heights();
    let by_columns: Vec<f64> =
        (0..SIDE * SIDE).map(|index| by_lines[index % SIDE * SIDE + index / SIDE]).collect();
    for (is_by_columns, samples) in [(false, &by_lines), (true, &by_columns)] {
        let values: Vec<u8> = samples.iter().flat_map(|height| height.to_le_bytes()).collect();
        let made = Made::new(&[("a.npy", &[array("(24, 24)", is_by_columns), values].concat())]);
        let part =
            open(&made.path, &options).unwrap().window(&Window { lines: 3..9, columns: 7..20 }).unwrap();
        let whole = made.read(&options).unwrap();
        for (line, column) in (0..6).flat_map(|line| (0..13).map(move |column| (line, column))) {
            assert_eq!(part.height(line, column), Some(by_lines[(3 + line) * SIDE + 7 + column]));
            assert_eq!(part.height(line, column), whole.height(3 + line, 7 + column));
        }
    }
}

/// 20 GB in a file that takes no room on the disk.
#[test]
fn more_than_fits_into_memory_is_refused_and_a_part_of_it_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.npy");
    let header = array("(50000, 50000)", false);
    let mut file = File::create(&path).unwrap();
    file.write_all(&header).unwrap();
    file.set_len(header.len() as u64 + 8 * 50_000 * 50_000).unwrap();
    file.seek(SeekFrom::Start(header.len() as u64 + 8 * (40_000 * 50_000 + 30_000))).unwrap();
    file.write_all(&7.5_f64.to_le_bytes()).unwrap();
    let options = ReadOptions { spacing: Some([10.0; 2]), ..ReadOptions::default() };
    let said = read(&path, &options).unwrap_err().to_string();
    assert!(said.contains("50000 x 50000 samples take 20000000000 bytes of memory"), "{said}");
    assert!(said.contains("survey a smaller area of it (--area, or --centre with --size-m); --raise elevation-bytes=N allows more"), "{said}");
    let window = Window { lines: 40_000..40_003, columns: 30_000..30_002 };
    let part = open(&path, &options).unwrap().window(&window).unwrap();
    assert_eq!((part.height(0, 0), part.height(0, 1)), (Some(7.5), Some(0.0)));
}

#[test]
fn what_is_no_file_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("a.tif")).unwrap();
    fs::create_dir(at("made.dat")).unwrap();
    fs::write(at("made.xml"), PDS4).unwrap();
    let said = |name: &str| read(at(name), &ReadOptions::default()).unwrap_err().to_string();
    assert!(
        said("a.tif").contains("a.tif: cannot read: this is a folder, expected a file"),
        "{}",
        said("a.tif")
    );
    assert!(said("made.xml").contains("made.dat: cannot read: this is a folder"), "{}", said("made.xml"));
    assert!(said("absent.tif").contains("absent.tif: no such file"), "{}", said("absent.tif"));
}

/// What two places of a file say of one thing must be the same, and text in pieces is no number.
#[test]
fn contradictions_are_refused() {
    let said = |made: &Made, part: &str| {
        let said = made.refusal();
        assert!(said.contains(part), "{said}");
    };
    let units = |units: &str| envi(&ENVI.replace("10, 10}", &format!("10, 10, units={units}}}")));
    assert!(units("Meters").read(&ReadOptions::default()).is_ok());
    said(&units("Feet"), "the unit that coordinate system string has");
    let split = PDS4.replace(">0.25<", ">0<!-- a comment -->.25<");
    said(&pds4(&split), "a value in one piece");
    let band = ReadOptions { band: Some(2), ..ReadOptions::default() };
    assert!(ascii(HEAD, PRJ).read(&band).unwrap_err().contains("band 2"));
}

/// GDAL goes by the band of an item, and other programs by its name.
#[test]
fn the_meaning_of_no_band_is_refused() {
    for (name, text) in [("SCALE", "0.5"), ("OFFSET", "1"), ("UNITTYPE", "ft"), ("scale", "0.5")] {
        let of = |sample: &str| {
            let items = format!("<GDALMetadata><Item name=\"{name}\"{sample}>{text}</Item></GDALMetadata>");
            Directory::ground().with(42112, Field::Text(items)).made()
        };
        assert!(of(" sample=\"0\"").plain().is_ok(), "{name}");
        let said = of("").refusal();
        assert!(said.contains(&format!("{name}: found an item of no band; expected <Item name")), "{said}");
    }
}

/// A name counts in the dictionary that it is from: another one may use it for something else.
#[test]
fn elements_of_other_dictionaries_are_refused() {
    let other = replaced(PDS4, "http://pds.nasa.gov/pds4/cart/v1", "http://example.org/maps");
    let said = pds4(&other).refusal();
    assert!(said.contains("Cartography") && said.contains("the namespace http://example.org/maps"), "{said}");
    assert!(said.contains("expected the namespace http://pds.nasa.gov/pds4/cart/v1"), "{said}");
    let factor = "<scaling_factor>0.25</scaling_factor>";
    let foreign = "<x:scaling_factor xmlns:x=\"http://example.org/x\">0.5</x:scaling_factor>";
    let said = pds4(&replaced(PDS4, factor, foreign)).refusal();
    assert!(said.contains("scaling_factor") && said.contains("example.org/x"), "{said}");
    // A label whose elements have no namespace at all, and one of a later version.
    let without = replaced(PDS4, " xmlns=\"http://pds.nasa.gov/pds4/pds/v1\"", "");
    let later = PDS4.replace("/v1\"", "/v2\"");
    for label in [&without, &later] {
        let (voids, worst) = against(&pds4(label).plain().unwrap(), 1.0, 0.0);
        assert!(voids == 0 && worst == 0.0, "{voids} voids, worst {worst}: {label}");
    }
}

/// A header of a datum of the Earth has the Earth's radius, one of another body none that is known.
#[test]
fn bodies_of_headers_without_a_system() {
    let degrees = |datum: &str| {
        let info = format!("Geographic Lat/Lon, 1, 1, 30, 20, 0.001, 0.001, {datum}units=Degrees}}");
        let lines = ENVI.lines().filter(|line| !line.starts_with("coordinate"));
        let text: String = lines.map(|line| format!("{line}\n")).collect();
        envi(&text.replace("Equirectangular, 1, 1, 10000, 20000, 10, 10}", &info))
    };
    let radius = |datum: &str| match degrees(datum).read(&ReadOptions::default()).unwrap().frame {
        Frame::Geographic { radius } => radius,
        other => panic!("{other:?}"),
    };
    assert_eq!(
        [radius("WGS-84, "), radius("D_Moon_2000, "), radius("")],
        [6_378_137.0, 1_737_400.0, 1_737_400.0]
    );
    assert!(degrees("Mars_2000, ").refusal().contains("another datum of the Earth"));
}

/// What no bank can hold is refused before anything is fitted, and before a file is written.
#[test]
fn maps_that_no_bank_can_hold() {
    let refused = |from: &str, to: &str, part: &str| {
        let made = ascii(HEAD, &PRJ.replace(from, to));
        let read = made.read(&ReadOptions::default()).unwrap();
        let said = survey(&read, &SurveyOptions::new(50.0), &mut |_| {}).unwrap_err().to_string();
        assert!(said.contains(part), "{said}");
    };
    refused("1737400.0", "0.5", "radius of the map: found 0.5; expected 1");
}
