//! Labels of PDS3 as archives and people write them: units, records, objects, sizes.

use crate::made::{LABEL, Made, SIDE, against, heights, labelled, quarters, words};

fn image() -> Vec<u8> {
    words(&quarters())
}

/// Largest difference of what a label's image gives from `scale` times the made heights.
fn off(replace: &[(&str, &str)], scale: f64) -> f64 {
    let (voids, worst) = against(&labelled(replace, &image()).plain().unwrap(), scale, 0.0);
    assert_eq!(voids, 0);
    worst
}

fn refusal(replace: &[(&str, &str)]) -> String {
    labelled(replace, &image()).refusal()
}

#[test]
fn units_of_heights() {
    for (unit, metres) in [
        ("FEET", 0.3048),
        ("\"KILOMETRES\"", 1000.0),
        ("KM", 1000.0),
        ("CENTIMETER", 0.01),
        ("\"US SURVEY FEET\"", 1200.0 / 3937.0),
        ("Metres", 1.0),
    ] {
        let scale = format!("SCALING_FACTOR = {}", 0.25 / metres);
        let written = format!("UNIT = {unit}");
        let found = off(&[("UNIT = METER", &written), ("SCALING_FACTOR = 0.25", &scale)], 1.0);
        assert!(found < 1e-9, "{unit}: {found}");
    }
    // A factor or an offset may have a unit of its own.
    assert!(off(&[("0.25", "25 <CM>")], 1.0) < 1e-9);
    let offset = [("UNIT = METER", "UNIT = METER\n  OFFSET = 1737.4 <KM>")];
    assert!(off(&offset, 1.0) < 1e-6);
    let none = labelled(&[("  UNIT = METER\n", "")], &image()).plain().unwrap();
    assert!(none.notes[0].contains("does not name the unit of its heights"), "{:?}", none.notes);
    assert!(refusal(&[("UNIT = METER", "UNIT = DEGREE")]).contains("DEGREE"));
    assert!(refusal(&[("0.25", "0.25 <RODS>")]).contains("SCALING_FACTOR"));
}

#[test]
fn units_of_the_map() {
    for scale in
        ["10.0", "1000 <CM/PIXEL>", "0.010", "0.01 <km/pix>", "32.80839895013123 <FT/PIXEL>", "10 <M>"]
    {
        let text = format!("MAP_SCALE = {scale}");
        if scale == "10.0" {
            // Kilometres, as the data dictionary has it: 10 km a sample.
            let made = labelled(&[("MAP_SCALE = 10.0 <METERS/PIXEL>", &text)], &image());
            assert_eq!(made.plain().unwrap().affine.step, [-10_000.0, 10_000.0]);
            continue;
        }
        let read = labelled(&[("MAP_SCALE = 10.0 <METERS/PIXEL>", &text)], &image()).plain().unwrap();
        assert!((read.affine.step[1] - 10.0).abs() < 1e-9, "{scale}: {:?}", read.affine);
        assert!((read.affine.first[0] - 20_000.0).abs() < 1e-6);
    }
    let map = |written: &str| refusal(&[("10.0 <METERS/PIXEL>", written)]);
    assert!(map("10.0 <PARSEC/PIXEL>").contains("MAP_SCALE"));
    assert!(map("10.0 <METERS/DEGREE>").contains("MAP_SCALE"));
    // A length that a resolution contradicts is one of another unit.
    let both = refusal(&[("10.0 <METERS/PIXEL>", "10.0\n  MAP_RESOLUTION = 3032.33 <PIX/DEG>")]);
    assert!(
        both.contains("MAP_SCALE") && both.contains("10.000 <M/PIXEL>, as MAP_RESOLUTION says"),
        "{both}"
    );
    let both = |resolution: f64| {
        let resolution = format!("\"SIMPLE CYLINDRICAL\"\n  MAP_RESOLUTION = {resolution}");
        labelled(&[("\"EQUIRECTANGULAR\"", &resolution)], &image()).plain().map_err(|error| error.to_string())
    };
    assert!(both(3032.33).is_ok());
    assert!(both(303.0).unwrap_err().contains("as MAP_RESOLUTION says"), "a globe of other samples");
    for radius in ["1737400 <M>", "1737.4", "1737400 <METERS>"] {
        let made = labelled(&[("1737.4 <KM>", radius)], &image());
        assert_eq!(made.plain().unwrap().frame.sphere(), Some(1_737_400.0), "{radius}");
    }
    assert!(refusal(&[("1737.4 <KM>", "1737.4 <LEAGUE>")]).contains("A_AXIS_RADIUS"));
    assert!(refusal(&[("LONGITUDE = 0 <DEG>", "LONGITUDE = 0 <HOURS>")]).contains("CENTER_LONGITUDE"));
    assert!(refusal(&[("OFFSET = 2000.0", "OFFSET = 2000.0 <M>")]).contains("LINE_PROJECTION_OFFSET"));
}

#[test]
fn places_that_are_not_read_are_refused() {
    let map = |statement: &str| refusal(&[("  A_AXIS", &format!("  {statement}\n  A_AXIS"))]);
    for statement in [
        "MAP_PROJECTION_ROTATION = 90 <DEG>",
        "REFERENCE_LONGITUDE = 30 <DEG>",
        "REFERENCE_LATITUDE = -12",
        "POSITIVE_LONGITUDE_DIRECTION = WEST",
        "LINE_FIRST_PIXEL = 101",
        "COORDINATE_SYSTEM_TYPE = INERTIAL",
        "FIRST_STANDARD_PARALLEL = 30",
    ] {
        let keyword = statement.split(' ').next().unwrap();
        let said = map(statement);
        assert!(said.contains(&format!("label line 15, {keyword}")), "{said}");
    }
    let read = |statement: &str| {
        labelled(&[("  A_AXIS", &format!("  {statement}\n  A_AXIS"))], &image()).plain().unwrap()
    };
    read("MAP_PROJECTION_ROTATION = 0.00 <DEG>");
    read("POSITIVE_LONGITUDE_DIRECTION = \"East\"");
    let system = read("COORDINATE_SYSTEM_NAME = \"PRINCIPAL AXES\"").notes;
    assert!(system[0].contains("PRINCIPAL AXES"), "{system:?}");
    let flat = read("C_AXIS_RADIUS = 1735 <KM>").notes;
    assert!(flat[0].contains("C_AXIS_RADIUS is 1735000 m"), "{flat:?}");
    assert!(read("LINE_LAST_PIXEL = 48").notes[0].contains("LINE_LAST_PIXEL is 48"));
    let image = refusal(&[("UNIT = METER", "UNIT = METER\n  LINE_DISPLAY_DIRECTION = UP")]);
    assert!(image.contains("LINE_DISPLAY_DIRECTION"), "{image}");
    let packed = refusal(&[("UNIT = METER", "UNIT = METER\n  ENCODING_TYPE = \"JP2\"")]);
    assert!(packed.contains("ENCODING_TYPE"), "{packed}");
    let masked = refusal(&[("UNIT = METER", "UNIT = METER\n  SAMPLE_BIT_MASK = 2#0000111111111111#")]);
    assert!(masked.contains("SAMPLE_BIT_MASK"), "{masked}");
    assert!(off(&[("UNIT = METER", "UNIT = METER\n  SAMPLE_BIT_MASK = 2#1111111111111111#")], 1.0) < 1e-9);
}

/// A label around `files`, which replace the first statements about the file.
fn with_files(files: &str, image: &[u8]) -> Made {
    let old = "RECORD_TYPE = FIXED_LENGTH\nRECORD_BYTES = 48\n^IMAGE = \"made.img\"\n";
    labelled(&[(old, files)], image)
}

#[test]
fn records_are_those_of_the_file_of_the_image() {
    let packed = "OBJECT = COMPRESSED_FILE\n FILE_NAME = \"made.jp2\"\n RECORD_TYPE = UNDEFINED\n RECORD_BYTES = 100\n\
                  ENCODING_TYPE = \"JP2\"\nEND_OBJECT = COMPRESSED_FILE\n";
    let plain = "OBJECT = UNCOMPRESSED_FILE\n FILE_NAME = \"made.img\"\n RECORD_BYTES = 48 <BYTES>\n\
                 ^IMAGE = (\"made.img\", 3)\nEND_OBJECT = UNCOMPRESSED_FILE\n";
    let table =
        "OBJECT = INDEX_TABLE\n ROWS = 3\n ROW_BYTES = 7\n RECORD_BYTES = 7\nEND_OBJECT = INDEX_TABLE\n";
    let behind = [vec![0; 96], image()].concat();
    let right = |files: &str| {
        let (voids, worst) = against(&with_files(files, &behind).plain().unwrap(), 1.0, 0.0);
        assert_eq!((voids, worst), (0, 0.0), "{files}");
    };
    right(&[packed, plain].concat());
    right(&[plain, packed].concat());
    right(&[table, "RECORD_BYTES = 48\n^IMAGE = (\"made.img\", 3)\n"].concat());
    // The object of the file goes before the label; without one, the label's.
    right(&["RECORD_BYTES = 7\n", plain].concat());
    right("RECORD_BYTES = 48\nOBJECT = FILE\n ^IMAGE = (\"made.img\", 3)\nEND_OBJECT = FILE\n");
    right("OBJECT = FILE\n FILE_NAME = \"made.img\"\n RECORD_BYTES = 48\n ^IMAGE = 3\nEND_OBJECT = FILE\n");
    let absent = with_files(&[packed, "^IMAGE = (\"made.img\", 3)\n"].concat(), &behind).refusal();
    assert!(absent.contains("label, RECORD_BYTES: found nothing"), "{absent}");
    let two = with_files(&[plain, "^IMAGE = \"other.img\"\n"].concat(), &behind).refusal();
    assert!(two.contains("one ^IMAGE in a label"), "{two}");
}

#[test]
fn a_label_has_one_image_and_one_place() {
    let again = LABEL.replace(
        "END_OBJECT = IMAGE\n",
        "END_OBJECT = IMAGE\nOBJECT = IMAGE\n  LINES = 24\nEND_OBJECT = IMAGE\n",
    );
    let made = |label: &str| Made::new(&[("made.lbl", label.as_bytes()), ("made.img", &image())]);
    assert!(made(&again).refusal().contains("label line 14, LINES: found 24; expected one OBJECT IMAGE"));
    let twice = LABEL.replace("  LINES = 24\n", "  LINES = 24\n  LINES = 12\n");
    assert!(made(&twice).refusal().contains("expected one LINES in IMAGE"));
    // Another image beside it is another piece of data.
    let browse = "OBJECT = BROWSE_IMAGE\n  LINES = 12\n  SAMPLE_BITS = 8\nEND_OBJECT = BROWSE_IMAGE\nOBJECT = IMAGE\n  LINES";
    let read = made(&LABEL.replace("OBJECT = IMAGE\n  LINES", browse)).plain().unwrap();
    assert_eq!(read.lines, SIDE);
    let twice = LABEL.replace("  LINES = 24\n", "  LINES = 24\n  LINES = 24\n");
    assert_eq!(made(&twice).plain().unwrap().lines, SIDE);
}

#[test]
fn labels_as_archives_write_them() {
    for (old, new) in [
        ("^IMAGE", "EXPOSURE_DURATION = (1.0, 2.0) <SECOND>\n^IMAGE"),
        ("^IMAGE", "NOTE = 'single quotes'\n^IMAGE"),
        ("^IMAGE", "PRODUCT_ID =\n  NULL\n^IMAGE"),
        ("^IMAGE", "LRO:ORBIT = {1, (2, 3)}\n^IMAGE"),
        ("\nEND\n", "\nEND\0\0\0"),
        ("\nEND\n", "\nEND\r\n\u{fffd} binary = ("),
        ("\nOBJECT = IMAGE\n", "\nBEGIN_OBJECT = IMAGE\n"),
        ("^IMAGE", "/* a note = 3 */\n^IMAGE"),
    ] {
        assert!(off(&[(old, new)], 1.0) < 1e-9, "{new}");
    }
    for next in ["PRODUCT_ID = \"X\"\n^IMAGE", "OBJECT = FILE\nEND_OBJECT = FILE\n^IMAGE", "^IMAGE"] {
        let said = refusal(&[("^IMAGE", &format!("NOTE =\n{next}"))]);
        let words = ["label line 4: found NOTE without a value", "expected its value"];
        words.iter().for_each(|word| assert!(said.contains(word), "{said}"));
    }
    let said = refusal(&[("^IMAGE", "A\u{1}B = 3\n^IMAGE")]);
    assert!(!said.contains('\u{1}'), "{said:?}");
    let deep = "OBJECT = A\n".repeat(17) + &"END_OBJECT = A\n".repeat(17) + "^IMAGE";
    assert!(refusal(&[("^IMAGE", &deep)]).contains("at most 16"));
}

#[test]
fn sample_types_are_those_that_are_named() {
    for kind in ["ASCII_INTEGER", "UNSIGNED_PC_REAL", "VAX_REAL", "EBCDIC_CHARACTER"] {
        assert!(refusal(&[("LSB_INTEGER", kind)]).contains("label line 8, SAMPLE_TYPE"), "{kind}");
    }
    for bits in ["4", "12", "1", "64", "24"] {
        let said = refusal(&[("BITS = 16", &format!("BITS = {bits}"))]);
        assert!(said.contains(&format!("label line 9, SAMPLE_BITS: found {bits}")), "{said}");
    }
    for kind in ["VAX_INTEGER", "PC_UNSIGNED_INTEGER", "LSB_UNSIGNED_INTEGER"] {
        assert!(off(&[("LSB_INTEGER", kind)], 1.0) < 1e-9, "{kind}");
    }
}

#[test]
fn radii_are_no_heights() {
    let kilometres: Vec<u8> =
        heights().iter().flat_map(|height| (1737.4 + 1e-3 * height).to_le_bytes()).collect();
    let real = [
        ("LSB_INTEGER", "PC_REAL"),
        ("BITS = 16", "BITS = 64"),
        ("0.25", "1"),
        ("UNIT = METER", "UNIT = KM"),
    ];
    let read = labelled(&real, &kilometres).plain().unwrap();
    assert!(against(&read, 1.0, 0.0).1 < 1e-6);
    assert!(read.notes[0].contains("the samples are radii"), "{:?}", read.notes);
    // Mars: its own radius is taken off.
    let mars = [("UNIT = METER", "UNIT = METER\n  OFFSET = 3396000"), ("1737.4 <KM>", "3396.0 <KM>")];
    assert!(off(&mars, 1.0) < 1e-9);
    let scale =
        [("UNIT = METER", "UNIT = METER\n  OFFSET = 3396000"), ("  A_AXIS_RADIUS = 1737.4 <KM>\n", "")];
    assert!(refusal(&scale).contains("line 0, column 0"), "radii of a body that is not named");
}

#[test]
fn bands_have_their_own_factors() {
    let two = [("UNIT = METER", "UNIT = METER\n  BANDS = 2"), ("0.25", "(1.0, 0.25)")];
    let made = labelled(&two, &image().repeat(2));
    let band = |band| survey::ReadOptions { band: Some(band), ..survey::ReadOptions::default() };
    assert_eq!(against(&made.read(&band(2)).unwrap(), 1.0, 0.0), (0, 0.0));
    assert_eq!(against(&made.read(&band(1)).unwrap(), 4.0, 0.0), (0, 0.0));
    assert!(refusal(&[("0.25", "(1.0, 0.25)")]).contains("one number, or one for each band"));
}
