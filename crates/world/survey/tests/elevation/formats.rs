//! PDS4 arrays, ISIS cubes, ENVI rasters and Arc ASCII grids: kinds of samples, voids, places, and what is refused.

use std::path::Path;

use quantities::degrees;
use survey::{Elevation, Frame, Method, ReadOptions};

use crate::labels::{ENVI, HEAD, ISIS, PDS4, PRJ, ascii, cube, envi, isis, numbers, pds4, replaced};
use crate::made::{Made, SIDE, against, height, quarters, words};

/// A file of 24 x 24 samples whose first ones are `first`, each stored in `bytes` bytes, and the others 7.
fn stored(first: &[Vec<u8>], other: &[u8]) -> Vec<u8> {
    let mut samples = first.concat();
    samples.extend(other.repeat(SIDE * SIDE - first.len()));
    samples
}

fn beginning(read: &Elevation, count: usize) -> Vec<Option<f64>> {
    (0..count).map(|column| read.height(0, column)).collect()
}

#[test]
fn all_formats_have_the_same_ground() {
    for made in [pds4(PDS4), isis(ISIS), envi(ENVI), ascii(HEAD, PRJ)] {
        let read = made.plain().unwrap();
        assert_eq!((read.lines, read.columns), (SIDE, SIDE));
        assert_eq!(against(&read, 1.0, 0.0), (0, 0.0), "{}", made.path.display());
        assert_eq!(read.affine.first, [19_995.0, 10_005.0], "{}", made.path.display());
        assert_eq!(read.affine.step, [-10.0, 10.0]);
        let Frame::Plane(Some(projection)) = read.frame else { panic!("{:?}", read.frame) };
        assert_eq!(
            (projection.radius, projection.method),
            (1_737_400.0, Method::Equirectangular { parallel: 0.0 })
        );
    }
}

#[test]
fn samples_lead_to_their_labels() {
    for (made, data) in [(pds4(PDS4), "made.dat"), (envi(ENVI), "made.dat")] {
        let read = survey::read(made.path.with_file_name(data), &ReadOptions::default()).unwrap();
        assert_eq!((against(&read, 1.0, 0.0), read.sources.len()), ((0, 0.0), 2));
    }
    let detached = replaced(ISIS, "StartByte = 4097", "StartByte = 1\n    ^Core = made.dat");
    let made = Made::new(&[("made.lbl", detached.as_bytes()), ("made.dat", &words(&quarters()))]);
    let read = survey::read(made.path.with_file_name("made.dat"), &ReadOptions::default()).unwrap();
    assert_eq!(against(&read, 1.0, 0.0), (0, 0.0));
}

#[test]
fn every_element_type_of_pds4() {
    let both = |bytes: Vec<u8>, name: &str| {
        let turned = bytes.iter().rev().copied().collect::<Vec<_>>();
        [(name.replace('*', "LSB"), bytes), (name.replace('*', "MSB"), turned)]
    };
    let mut kinds =
        vec![("SignedByte".to_owned(), vec![0xf9], -7.0), ("UnsignedByte".to_owned(), vec![0xf9], 249.0)];
    for (bytes, name, number) in [
        ((-700_i16).to_le_bytes().to_vec(), "Signed*2", -700.0),
        (60_000_u16.to_le_bytes().to_vec(), "Unsigned*2", 60_000.0),
        ((-70_000_i32).to_le_bytes().to_vec(), "Signed*4", -70_000.0),
        (70_000_u32.to_le_bytes().to_vec(), "Unsigned*4", 70_000.0),
        ((-70_001_i64).to_le_bytes().to_vec(), "Signed*8", -70_001.0),
        (70_001_u64.to_le_bytes().to_vec(), "Unsigned*8", 70_001.0),
        ((-1.5_f32).to_le_bytes().to_vec(), "IEEE754*Single", -1.5),
        ((-2.5_f64).to_le_bytes().to_vec(), "IEEE754*Double", -2.5),
    ] {
        kinds.extend(both(bytes, name).map(|(name, bytes)| (name, bytes, number)));
    }
    assert_eq!(kinds.len(), 18);
    for (name, bytes, number) in kinds {
        let label = PDS4.replace("SignedLSB2", &name).replace("<scaling_factor>0.25</scaling_factor>", "");
        let made = Made::new(&[("made.xml", label.as_bytes()), ("made.dat", &bytes.repeat(SIDE * SIDE))]);
        assert_eq!(made.plain().unwrap().range(), Some([number; 2]), "{name}");
    }
    for name in ["ComplexLSB8", "SignedBitString", "UnsignedMSB3"] {
        let said = pds4(&PDS4.replace("SignedLSB2", name)).refusal();
        assert!(said.contains("data_type") && said.contains(name), "{said}");
    }
}

#[test]
fn special_constants_of_pds4() {
    let constants = |text: &str| PDS4.replace("<Special_Constants>", &format!("<Special_Constants>{text}"));
    let read =
        pds4(&constants("<missing_constant>250</missing_constant><invalid_constant>0xFB</invalid_constant>"));
    assert_eq!(read.plain().unwrap().voids(), count(250.0) + count(251.0));
    let valid = pds4(&constants("<valid_minimum>210</valid_minimum>")).plain().unwrap();
    assert!(
        valid.range().unwrap()[0] >= 52.5 && valid.notes.iter().any(|note| note.contains("valid numbers"))
    );
    let said = pds4(&constants("<error_constant>none</error_constant>")).refusal();
    assert!(said.contains("error_constant: found none") && said.contains("16#DIGITS#"), "{said}");
}

/// Made samples that are stored as a number.
fn count(number: f64) -> usize {
    quarters().iter().filter(|quarter| **quarter == number).count()
}

#[test]
fn places_of_pds4() {
    let degrees_of = "<cart:latitude_resolution unit=\"deg\">0.5</cart:latitude_resolution>
<cart:longitude_resolution unit=\"deg\">0.25</cart:longitude_resolution>
<cart:north_bounding_coordinate unit=\"deg\">-10</cart:north_bounding_coordinate>
<cart:west_bounding_coordinate unit=\"deg\">-30</cart:west_bounding_coordinate>";
    let name = "<cart:map_projection_name>Equirectangular</cart:map_projection_name>";
    let read = pds4(&replaced(PDS4, name, degrees_of)).plain().unwrap();
    assert!(matches!(read.frame, Frame::Geographic { radius: 1_737_400.0 }));
    let first = read.affine.first.map(degrees);
    assert!((first[0] + 10.25).abs() < 1e-9 && (first[1] + 29.875).abs() < 1e-9, "{first:?}");
    let sinusoidal = pds4(&PDS4.replace(">Equirectangular<", ">Sinusoidal<")).plain().unwrap();
    assert!(sinusoidal.frame == Frame::Plane(None));
    assert!(
        sinusoidal.notes.iter().any(|note| note.starts_with("Sinusoidal is a projection that is not known"))
    );
    let beyond = replaced(PDS4, "unit=\"km\">10<", "unit=\"km\">9999910<");
    let beyond = pds4(&beyond).plain().unwrap();
    assert!(
        beyond.notes.iter().any(|note| note.starts_with("4 of the 4 corners lie beyond")),
        "{:?}",
        beyond.notes
    );
    let start = PDS4.find("<cart:Cartography>").unwrap();
    let end = PDS4.find("</cart:Cartography>").unwrap() + "</cart:Cartography>".len();
    let unplaced = pds4(&[&PDS4[..start], &PDS4[end..]].concat());
    assert!(unplaced.refusal().contains("--spacing-m METRES"));
    let spaced = ReadOptions { spacing: Some([10.0; 2]), ..ReadOptions::default() };
    assert_eq!(against(&unplaced.read(&spaced).unwrap(), 1.0, 0.0), (0, 0.0));
    for (old, new, part) in [
        ("Top to Bottom", "Bottom to Top", "vertical_display_direction"),
        ("unit=\"deg\">0</cart:standard", "unit=\"gon\">0</cart:standard", "found gon"),
        (
            "<cart:pixel_resolution_x unit=\"m/pixel\">10",
            "<cart:pixel_resolution_x unit=\"m/pixel\">0",
            "pixel_resolution_x",
        ),
        (
            "<cart:pixel_resolution_x",
            "<cart:pixel_scale_x>303.2</cart:pixel_scale_x>\n<cart:pixel_resolution_x",
            "the length of a sample that pixel_scale says",
        ),
        ("<axis_index_order>Last", "<axis_index_order>First", "axis_index_order"),
        ("<axes>2", "<axes>3", "axes"),
        ("<axis_name>Sample", "<axis_name>Line", "one axis of a name"),
        ("<sequence_number>2", "<sequence_number>1", "axes"),
        ("made.dat", "../made.dat", "in the folder of the label"),
        ("made.dat", "/etc/passwd", "in the folder of the label"),
        ("made.dat", "other.dat", "in the folder of the label"),
        ("<unit>m</unit>", "<unit>gallon</unit>", "--scale METRES"),
    ] {
        let said = pds4(&replaced(PDS4, old, new)).refusal();
        assert!(said.contains(part) && said.contains("label line"), "{new}: {said}");
    }
    let array = PDS4.find("<Array_2D_Image>").unwrap();
    let rest = PDS4.find("</File_Area_Observational>").unwrap();
    let two = format!("{}{}{}", &PDS4[..rest], &PDS4[array..rest], &PDS4[rest..]);
    assert!(pds4(&two).refusal().contains("a second array"));
}

#[test]
fn real_pds4_products_without_heights_are_refused() {
    for name in ["maven_iuvs_l1a.xml", "test_array_data_types.xml"] {
        let folders = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors();
        let path =
            folders.map(|folder| folder.join("shared/data/pds4").join(name)).find(|path| path.is_file());
        let Some(path) = path else {
            println!("SKIPPED: shared/data/pds4/{name} is not there");
            continue;
        };
        let said = survey::read(path, &ReadOptions::default()).unwrap_err().to_string();
        assert!(said.contains("Array_2D_Image") || said.contains("--ignore element:"), "{said}");
    }
}

#[test]
fn integers_of_cubes_have_special_pixels() {
    for (kind, little, marks, heights) in [
        ("SignedInteger", true, vec![-8_388_613_i64, -8_388_609], vec![-70_000, 70_000]),
        ("SignedInteger", false, vec![-8_388_613, -8_388_611], vec![-70_001, 1]),
        ("UnsignedInteger", true, vec![0, 1, 2, 4_294_967_295], vec![3, 70_000]),
        ("UnsignedInteger", false, vec![0, 4_294_967_294], vec![3, 80_000]),
    ] {
        let bytes = |number: &i64| {
            let word = (*number as u32).to_le_bytes();
            if little { word.to_vec() } else { word.iter().rev().copied().collect() }
        };
        let first: Vec<_> = marks.iter().chain(&heights).map(bytes).collect();
        let order = if little { "Lsb" } else { "Msb" };
        let label = ISIS
            .replace("SignedWord", kind)
            .replace("ByteOrder = Lsb", &format!("ByteOrder = {order}"))
            .replace("Multiplier = 0.25", "Multiplier = 1.0");
        let core = stored(&first, &bytes(&7));
        let read = Made::new(&[("made.cub", &cube(&label, &core))]).plain().unwrap();
        let expected = marks.iter().map(|_| None).chain(heights.iter().map(|height| Some(*height as f64)));
        assert_eq!(beginning(&read, first.len()), expected.collect::<Vec<_>>(), "{kind} {order}");
    }
}

#[test]
fn cubes_in_tiles_of_bands() {
    let tiles = ISIS
        .replace("Format = BandSequential", "Format = Tile\n    TileSamples = 10\n    TileLines = 7")
        .replace("Bands = 1", "Bands = 2");
    // 4 x 3 tiles a band; what lies beyond the image is a null.
    let tile = |down: usize, across: usize, band: usize| {
        (0..70).flat_map(move |index| {
            let (line, column) = (down * 7 + index / 10, across * 10 + index % 10);
            let is_inside = line < SIDE && column < SIDE;
            let number = if is_inside { (4.0 * height(line, column)) as i16 + band as i16 } else { -32768 };
            number.to_le_bytes()
        })
    };
    let core: Vec<u8> = (0..24).flat_map(|k| tile(k % 12 / 3, k % 3, k / 12)).collect();
    let made = Made::new(&[("made.cub", &cube(&tiles, &core))]);
    assert!(made.refusal().contains("give --band N"));
    for band in [1, 2] {
        let read = made.read(&ReadOptions { band: Some(band), ..ReadOptions::default() }).unwrap();
        assert_eq!(against(&read, 1.0, 0.25 * (band - 1) as f64), (0, 0.0));
    }
}

#[test]
fn cubes_that_are_refused() {
    for (old, new, part) in [
        ("BandSequential", "GeoTIFF", "BandSequential or Tile"),
        ("SignedWord", "Double", "TYPE: found Double"),
        ("ByteOrder = Lsb", "ByteOrder = Vax", "Lsb or Msb"),
        ("StartByte = 4097", "StartByte = 0", "counted from 1"),
        ("StartByte = 4097", "StartByte = 1\n ^Core = \"../made.cub\"", "in the folder of the label"),
        ("Format = BandSequential", "Format = Tile\n TileLines = 0\n TileSamples = 4", "TILELINES above 0"),
        ("PixelResolution = 10.0 <meters/pixel>", "PixelResolution = -10.0 <meters/pixel>", "above 0"),
        ("PixelResolution = 10.0 <meters/pixel>", "LatitudeType = Planetocentric", "PIXELRESOLUTION"),
        (
            "CenterLongitude = 0.0",
            "Scale = 303.2 <pixel/degree>",
            "3032.335 <PIXEL/DEGREE>, as PixelResolution says",
        ),
        ("CenterLongitude = 0.0", "scaleFactor = 2", "1 in this map"),
        ("Unit = METER", "Unit = DEGREE", "--scale METRES"),
    ] {
        let said = isis(&replaced(ISIS, old, new)).refusal();
        assert!(said.contains(part), "{new}: {said}");
    }
}

#[test]
fn envi_rasters_that_are_refused() {
    for (old, new, part) in [
        ("byte order = 0\n", "", "header, byte order"),
        ("byte order = 0", "byte order = 2", "0 or 1"),
        ("data type = 2", "data type = 6", "header line 6, data type"),
        ("interleave = bsq", "interleave = tile", "bsq, bil or bip"),
        ("10000, 20000, 10, 10}", "10000, 20000, 10, 10, rotation=30}", "gdalwarp"),
        ("10000, 20000, 10, 10}", "10000, 20000, 10, 10, units=Cubits}", "units that are known"),
        ("10000, 20000, 10, 10}", "10000, 20000, 10}", "two sizes of a sample"),
        ("10000, 20000, 10, 10}", "10000, 20000, 10, 10", "header line 10: found"),
        ("Equirectangular, 1", "Geographic Lat/Lon, 1", "the kind of coordinates"),
        ("lines = 24", "lines = 24\nlines = 24", "one value of a key"),
        ("lines = 24", "lines : 24", "KEY = VALUE"),
        ("header offset = 0", "header offset = -1", "a whole number"),
        ("data gain values = {0.25}", "data gain values = {0.25, 1}", "one for each band"),
    ] {
        let said = envi(&replaced(ENVI, old, new)).refusal();
        assert!(said.contains(part), "{new}: {said}");
    }
    let alone = Made::new(&[("made.hdr", ENVI.as_bytes())]).refusal();
    assert!(alone.contains("none in the folder of the header") && alone.contains("made.img"), "{alone}");
    let both = [("made.hdr", ENVI.as_bytes()), ("made", &[0; 4][..]), ("made.img", &[0; 4][..])];
    let both = Made::new(&both).refusal();
    assert!(both.contains("made, made.img") && both.contains("name the file of the samples"), "{both}");
    let plain = replaced(ENVI, &ENVI[ENVI.find("coordinate").unwrap()..], "");
    let read = envi(&plain).plain().unwrap();
    assert!(
        read.frame == Frame::Plane(None) && read.notes.iter().any(|note| note.contains("unit of its map"))
    );
}

#[test]
fn grids_as_people_write_them() {
    let centre = HEAD.replace("corner 10000", "center 10005").replace("corner 19760", "center 19765");
    let oblong = HEAD.replace("cellsize 10", "dx 10\ndy 10");
    let capitals = HEAD.to_uppercase().replace('\n', "\r\n");
    for head in [&centre, &oblong, &capitals] {
        let read = ascii(head, PRJ).plain().unwrap();
        assert_eq!((against(&read, 1.0, 0.0), read.affine.first), ((0, 0.0), [19_995.0, 10_005.0]), "{head}");
    }
    let wrapped = numbers().replace(' ', "\r\n\t");
    let read = Made::new(&[("made.asc", format!("{HEAD}{wrapped}").as_bytes())]).plain().unwrap();
    assert_eq!(against(&read, 1.0, 0.0), (0, 0.0));
    assert!(read.notes.iter().any(|note| note.contains("no .prj")), "{:?}", read.notes);
    let marked = ascii(&format!("\u{feff}{HEAD}"), &format!("\u{feff}{PRJ}")).plain().unwrap();
    assert_eq!((against(&marked, 1.0, 0.0), marked.affine.first), ((0, 0.0), [19_995.0, 10_005.0]));
    let unsaid = HEAD.replace("NODATA_value -1\n", "");
    let holed = numbers().replacen("61.5", "-9999", 1).replacen("61.75", "nan", 1);
    let read = Made::new(&[("made.asc", format!("{unsaid}{holed}").as_bytes())]).plain().unwrap();
    assert_eq!(read.voids(), 2);
    assert!(read.notes.iter().any(|note| note.contains("-9999 is a void")), "{:?}", read.notes);
}

#[test]
fn grids_that_are_refused() {
    let with = |head: &str, numbers: &str| {
        Made::new(&[("made.asc", format!("{head}{numbers}").as_bytes())]).refusal()
    };
    for (old, new, part) in [
        ("cellsize 10", "cellsize 10\ndx 10", "no dx beside cellsize"),
        ("cellsize 10\n", "", "cellsize or dy"),
        ("cellsize 10", "cellsize 0", "line 5, cellsize"),
        ("xllcorner 10000", "xllcorner east", "line 3, xllcorner: found east"),
        ("ncols 24", "ncols 24.5", "a whole number"),
        ("ncols 24", "ncols 24\nncols 24", "one value of a key"),
        ("ncols 24", "ncols 23", "the end of 24 lines of 23 numbers"),
        ("nrows 24", "nrows 25", "truncated"),
        ("nrows 24", "nrows 99999", "truncated"),
    ] {
        let said = with(&replaced(HEAD, old, new), &numbers());
        assert!(said.contains(part), "{new}: {said}");
    }
    let comma = with(HEAD, &numbers().replacen("61.75", "61,75", 1));
    assert!(comma.contains("line 7, column 6: found 61,75"), "{comma}");
    let said = ascii(HEAD, "Projection GEOGRAPHIC\nUnits DD\n").refusal();
    assert!(said.contains("made.prj") && said.contains("KEYWORD[\"NAME\""), "{said}");
}
