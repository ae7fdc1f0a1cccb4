//! Files that mean harm, by class: cut short, with sizes that overflow or that no file can hold, with names that lead
//! elsewhere, nested, or blown up by entities. Each is refused with one error, and memory follows the size of the file.

use std::fs;

use proptest::prelude::{ProptestConfig, any, proptest};
use survey::{ReadOptions, read};

use crate::labels::{ENVI, HEAD, ISIS, PDS4, PRJ, ascii, cube, envi, isis, numbers, pds4};
use crate::made::{Made, quarters, words};

/// Numbers that are too large for a file, a memory or a word.
const SIZES: [&str; 6] =
    ["100000", "4294967296", "9223372036854775807", "18446744073709551615", "99999999999999999999", "-24"];

fn refused(made: &Made) {
    let said = made.refusal();
    assert!(said.contains("made.") && said.len() < 2000 && !said.contains('\n'), "{said}");
}

#[test]
fn sizes_that_no_file_can_hold() {
    for size in SIZES {
        let element = |name: &str| PDS4.replacen(&format!("<{name}>24"), &format!("<{name}>{size}"), 1);
        refused(&pds4(&element("elements")));
        refused(&pds4(&PDS4.replace("<elements>24", &format!("<elements>{size}"))));
        refused(&pds4(&PDS4.replace("\"byte\">0", &format!("\"byte\">{size}"))));
        for keyword in ["Samples", "Lines"] {
            refused(&isis(&ISIS.replace(&format!("{keyword} = 24"), &format!("{keyword} = {size}"))));
        }
        let both = |text: &str| text.replace("= 24", &format!("= {size}"));
        refused(&isis(&both(ISIS)));
        refused(&isis(&ISIS.replace("Bands = 1", &format!("Bands = {size}"))));
        refused(&isis(&ISIS.replace("StartByte = 4097", &format!("StartByte = {size}"))));
        let tiles = format!("Format = Tile\n TileLines = {size}\n TileSamples = {size}");
        refused(&isis(&ISIS.replace("Format = BandSequential", &tiles)));
        refused(&envi(&both(ENVI)));
        refused(&envi(&ENVI.replace("bands = 1", &format!("bands = {size}"))));
        refused(&envi(&ENVI.replace("header offset = 0", &format!("header offset = {size}"))));
        refused(&ascii(&HEAD.replace("24", size), PRJ));
        refused(&ascii(&HEAD.replace("nrows 24", &format!("nrows {size}")), PRJ));
    }
}

#[test]
fn files_that_are_cut_short() {
    let (core, whole) = (words(&quarters()), cube(ISIS, &words(&quarters())));
    let cut = |bytes: &[u8], at: usize| bytes[..bytes.len() * at / 16].to_vec();
    for at in 0..16 {
        refused(&Made::new(&[("made.xml", PDS4.as_bytes()), ("made.dat", &cut(&core, at))]));
        refused(&Made::new(&[("made.xml", &cut(PDS4.as_bytes(), at)), ("made.dat", &core)]));
        refused(&Made::new(&[("made.cub", &cut(&whole[..whole.len() - 2048], at))]));
        refused(&Made::new(&[("made.hdr", ENVI.as_bytes()), ("made.dat", &cut(&core, at))]));
        refused(&Made::new(&[("made.asc", &cut(format!("{HEAD}{}", numbers()).as_bytes(), at))]));
        refused(&ascii(HEAD, &PRJ[..PRJ.len() * at / 16]));
    }
}

#[test]
fn names_that_lead_elsewhere() {
    for name in [
        "../made.dat",
        "/etc/passwd",
        "C:made.dat",
        "sub/made.dat",
        "..",
        ".",
        "made.dat/",
        "\\\\host\\made.dat",
    ] {
        refused(&pds4(&PDS4.replace("made.dat", name)));
        let pointer = format!("StartByte = 1\n ^Core = \"{name}\"");
        refused(&isis(&ISIS.replace("StartByte = 4097", &pointer)));
    }
    // A folder in place of the samples.
    let made = pds4(&PDS4.replace("made.dat", "folder.dat"));
    fs::create_dir(made.path.with_file_name("folder.dat")).unwrap();
    let said = made.refusal();
    assert!(said.contains("folder.dat: cannot read: this is a folder"), "{said}");
}

#[test]
fn labels_that_blow_up() {
    let body = &PDS4[PDS4.find("<Product").unwrap()..];
    let lol = |k: usize| format!("<!ENTITY lol{k} \"{}\">", format!("&lol{};", k - 1).repeat(10));
    let entities: String = (1..20).map(lol).collect();
    let bomb = format!("<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY lol0 \"lol\">{entities}]>{body}");
    for text in [
        bomb.replace(">Made<", ">&lol19;<"),
        format!("<?xml version=\"1.0\"?><!DOCTYPE x SYSTEM \"file:///etc/passwd\">{body}"),
        PDS4.replace(">Made<", ">&lol;<"),
        PDS4.replace("<Discipline_Area>", &"<Discipline_Area>".repeat(5000)),
        PDS4.replace("<title>", &"<title>".repeat(100_000)),
        format!(
            "<?xml version=\"1.0\"?>{}{}",
            "<Product_Observational>".repeat(3000),
            "</Product_Observational>".repeat(3000)
        ),
        PDS4.replace("<title>Made</title>", &"<title/>".repeat(250_000)),
    ] {
        refused(&pds4(&text));
    }
    refused(&isis(
        &ISIS.replace("Object = Core", &format!("{}Object = Core", "Object = IsisCube\n".repeat(5000))),
    ));
    refused(&isis(&ISIS.replace("Base = 0.0", &format!("Base = {}", "(".repeat(50_000)))));
    refused(&envi(&ENVI.replace("lines = 24", &format!("lines = 24\n{}", "x = {\n".repeat(50_000)))));
    refused(&ascii(HEAD, &"PROJCS[".repeat(5000)));
    refused(&ascii(&"cellsize 10\n".repeat(50_000), PRJ));
    refused(&ascii(&format!("ncols {}", "1".repeat(1 << 20)), PRJ));
}

fn survived(files: &[(&str, Vec<u8>)], at: usize, to: u8) {
    let folder = tempfile::tempdir().unwrap();
    for (index, (name, bytes)) in files.iter().enumerate() {
        let mut bytes = bytes.clone();
        if index == 0 {
            let at = at % bytes.len();
            bytes[at] = to;
        }
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    let said = match read(folder.path().join(files[files.len() - 1].0), &ReadOptions::default()) {
        Ok(read) => format!("{} {}", read.title, read.notes.join(" ")),
        Err(error) => error.to_string(),
    };
    assert!(!said.contains(char::is_control), "{said:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn a_damaged_byte_is_survived(at in any::<usize>(), to in any::<u8>()) {
        let core = words(&quarters());
        let text = |text: &str| text.as_bytes().to_vec();
        survived(&[("made.xml", text(PDS4)), ("made.dat", core.clone())], at, to);
        survived(&[("made.cub", cube(ISIS, &core))], at % ISIS.len(), to);
        survived(&[("made.hdr", text(ENVI)), ("made.dat", core)], at, to);
        let grid = text(&format!("{HEAD}{}", numbers()));
        survived(&[("made.asc", grid.clone())], at, to);
        survived(&[("made.prj", text(PRJ)), ("made.asc", grid)], at, to);
    }
}

/// A reader compares each attribute with all before it.
#[test]
fn labels_with_very_many_attributes() {
    let attributes: String = (0..60_000).map(|k| format!(" a{k}=\"1\"")).collect();
    refused(&pds4(&PDS4.replacen("<scaling_factor>", &format!("<scaling_factor{attributes}>"), 1)));
}
