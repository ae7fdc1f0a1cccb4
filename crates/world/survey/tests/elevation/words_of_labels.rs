//! The tables of PDS4, ISIS, ENVI, Arc ASCII and well-known text are what the readers do: each row is tried in a file.

use survey::{Fate, ReadOptions, VOCABULARIES};

use crate::labels::{ENVI, HEAD, ISIS, PDS4, PRJ, ascii, envi, isis, pds4, replaced};
use crate::made::Made;
use crate::words::{Outcome, every_row, outcome};

fn plain(made: &Made) -> Outcome {
    outcome(made, &ReadOptions::default())
}

/// Lines of a text without those that begin with one of some words.
fn without(text: &str, words: &[String]) -> String {
    let is_kept = |line: &&str| !words.iter().any(|word| line.trim_start().starts_with(word.as_str()));
    text.lines().filter(is_kept).map(|line| format!("{line}\n")).collect()
}

/// Whether a row says that what stands inside its element is decided.
fn is_container(name: &str) -> bool {
    let rows = VOCABULARIES.iter().flat_map(|(_, table)| table.words);
    let marks = ["one by one", "their own", "spacing is in it", "as Array", "spheroid is in it", "a map;"];
    rows.filter(|word| word.name == name).any(|word| match word.fate {
        Fate::Used(why) => marks.iter().any(|mark| why.contains(mark)),
        _ => false,
    })
}

/// Labels with an element behind a line, in place of those of the same name.
fn elements(label: &str, behind: &str, name: &str) -> Vec<[Outcome; 2]> {
    let values: &[&str] = if is_container(name) { &["<Mystery>1</Mystery>"] } else { &["250", "@@", "7"] };
    let prefixes = ["<", "<cart:", "<disp:"].map(|prefix| format!("{prefix}{name}>"));
    let with_unit = ["<", "<cart:"].map(|prefix| format!("{prefix}{name} "));
    // The array and the file beside it have a name inside the label, each decided by its own table.
    let base = if is_container(name) || (name == "local_identifier" && behind != "<Array_2D_Image>") {
        label.to_owned()
    } else {
        without(label, &[prefixes.to_vec(), with_unit.to_vec()].concat())
    };
    let pair = |value: &&str| {
        let with = base.replace(behind, &format!("{behind}\n<{name}>{value}</{name}>"));
        [plain(&pds4(label)), plain(&pds4(&with))]
    };
    values.iter().map(pair).collect()
}

#[test]
fn every_row_of_pds4() {
    let sections = ["<Identification_Area>", "<Discipline_Area>", "<File_Area_Observational>", "<File>"];
    every_row("element of a PDS4 label", |_, name| {
        sections.iter().flat_map(|behind| elements(PDS4, behind, name)).collect()
    });
    let array = ["<Array_2D_Image>", "<Element_Array>", "<Special_Constants>", "<Object_Statistics>"];
    every_row("element of an array in a PDS4 label", |_, name| {
        let in_axis = name == "axis_name" || name == "elements" || name == "sequence_number";
        let axis = replaced(
            PDS4,
            "<axis_name>Line</axis_name><elements>24</elements><sequence_number>1</sequence_number>",
            "",
        );
        match in_axis {
            true => vec![[plain(&pds4(PDS4)), plain(&pds4(&axis))]],
            false => array.iter().flat_map(|behind| elements(PDS4, behind, name)).collect(),
        }
    });
    let radius = |name: &str| vec![format!("<cart:{name}")];
    let polar =
        PDS4.replace(">Equirectangular<", ">Polar Stereographic<").replace(">0</cart:lat", ">90</cart:lat");
    let scales =
        "<cart:pixel_scale_x>3000</cart:pixel_scale_x>\n<cart:pixel_scale_y>3000</cart:pixel_scale_y>";
    let scaled = without(PDS4, &radius("pixel_resolution"))
        .replace("<cart:Cartography>", &format!("<cart:Cartography>\n{scales}"));
    let alike = "<cart:pixel_scale>3000</cart:pixel_scale>";
    let alike = without(PDS4, &radius("pixel_resolution"))
        .replace("<cart:Cartography>", &format!("<cart:Cartography>\n{alike}"));
    let length = "<cart:pixel_resolution>10</cart:pixel_resolution>";
    let length = without(PDS4, &radius("pixel_resolution"))
        .replace("<cart:Cartography>", &format!("<cart:Cartography>\n{length}"));
    let degrees = "<cart:latitude_resolution>0.1</cart:latitude_resolution>
<cart:longitude_resolution>0.1</cart:longitude_resolution>
<cart:west_bounding_coordinate>5</cart:west_bounding_coordinate>
<cart:north_bounding_coordinate>6</cart:north_bounding_coordinate>";
    let degrees = without(PDS4, &radius("map_projection_name"))
        .replace("<cart:Cartography>", &format!("<cart:Cartography>\n{degrees}"));
    let ball = without(PDS4, &["<cart:b_axis".into(), "<cart:c_axis".into()]);
    let bodyless = without(&ball, &["<cart:a_axis".into()]);
    let turned = without(PDS4, &radius("longitude_of_central"));
    let bases = [PDS4, &polar, &scaled, &alike, &length, &degrees, &ball, &bodyless, &turned];
    every_row("element of Cartography in a PDS4 label", |_, name| {
        bases.iter().flat_map(|label| elements(label, "<cart:Cartography>", name)).collect()
    });
    every_row("element of Display_Settings in a PDS4 label", |_, name| {
        elements(PDS4, "<disp:Display_Settings>", name)
    });
}

/// Labels with a keyword behind a line, in place of one of the same name.
fn keywords(label: &str, behind: &str, name: &str) -> Vec<[Outcome; 2]> {
    let base = without(label, &[format!("{name} =")]);
    let pair = |value: &str| {
        let with = replaced(&base, behind, &format!("{behind}\n  {name} = {value}"));
        [plain(&isis(label)), plain(&isis(&with))]
    };
    ["250", "\"@@\"", "2"].map(pair).to_vec()
}

#[test]
fn every_row_of_isis() {
    let tiles =
        ISIS.replace("Format = BandSequential", "Format = Tile\n    TileSamples = 4\n    TileLines = 8");
    let polar = ISIS.replace("SimpleCylindrical", "PolarStereographic\n    CenterLatitude = 90");
    let flat = ISIS.replace("SimpleCylindrical", "Equirectangular");
    let scaled = ISIS.replace("PixelResolution = 10.0 <meters/pixel>", "Scale = 3000");
    let unitless = without(ISIS, &["Unit =".into()]);
    let bases = [ISIS, &tiles, &polar, &flat, &scaled, &unitless];
    for (kind, behind) in [
        ("keyword of an ISIS label", "Object = IsisCube"),
        ("keyword of Core in an ISIS label", "Object = Core"),
        ("keyword of Dimensions in an ISIS label", "Group = Dimensions"),
        ("keyword of Pixels in an ISIS label", "Group = Pixels"),
        ("keyword of BandBin in an ISIS label", "Group = BandBin"),
        ("keyword of Mapping in an ISIS label", "Group = Mapping"),
    ] {
        every_row(kind, |_, name| bases.iter().flat_map(|label| keywords(label, behind, name)).collect());
    }
    every_row("object or group of an ISIS label", |_, name| {
        let object = format!("Object = IsisCube\n  Object = {name}\n    Mystery = 7\n  End_Object");
        vec![[plain(&isis(ISIS)), plain(&isis(&replaced(ISIS, "Object = IsisCube", &object)))]]
    });
}

#[test]
fn every_row_of_envi() {
    every_row("key of an ENVI header", |_, name| {
        let base = without(ENVI, &[format!("{name} =")]);
        let pair = |value: &str| {
            let with = base.replacen("ENVI\n", &format!("ENVI\n{name} = {value}\n"), 1);
            [plain(&envi(ENVI)), plain(&envi(&with))]
        };
        ["250", "@@", "2"].map(pair).to_vec()
    });
}

#[test]
fn every_row_of_arc_ascii_and_of_coordinate_systems() {
    every_row("key of an Arc ASCII grid", |_, name| {
        let base = without(HEAD, &[format!("{name} ")]);
        let pair =
            |value: &str| [plain(&ascii(HEAD, PRJ)), plain(&ascii(&format!("{name} {value}\n{base}"), PRJ))];
        ["250", "@@", "50.25"].map(pair).to_vec()
    });
    every_row("element of well-known text", |_, name| {
        let inner = if is_container(name) { "MYSTERY[\"y\"]" } else { "250" };
        let element = format!("{name}[\"x\",{inner}],");
        let outside = replaced(PRJ, "PROJCS[\"m\",", &format!("PROJCS[\"m\",{element}"));
        let inside = replaced(PRJ, "GEOGCS[\"g\",", &format!("GEOGCS[\"g\",{element}"));
        let spheroid = replaced(PRJ, "SPHEROID[\"s\",1737400.0,0.0]", &element.replace("250],", "1737.0]"));
        let all = if name == "ELLIPSOID" { vec![spheroid] } else { vec![outside, inside] };
        all.iter().map(|prj| [plain(&ascii(HEAD, PRJ)), plain(&ascii(HEAD, prj))]).collect()
    });
    every_row("parameter of a map in well-known text", |_, name| {
        let parameter = format!("PROJCS[\"m\",PARAMETER[\"{name}\",250],");
        let polar = PRJ.replace("Equidistant_Cylindrical", "Polar_Stereographic");
        [PRJ, &polar]
            .map(|prj| {
                [plain(&ascii(HEAD, prj)), plain(&ascii(HEAD, &replaced(prj, "PROJCS[\"m\",", &parameter)))]
            })
            .to_vec()
    });
}

#[test]
fn unknown_names_are_refused_and_can_be_ignored() {
    let element = |behind: &str| pds4(&PDS4.replacen(behind, &format!("{behind}\n<Mystery>1</Mystery>"), 1));
    let keyword = |behind: &str| isis(&replaced(ISIS, behind, &format!("{behind}\nMystery = 1")));
    let files = [
        ("element:Mystery", element("<Discipline_Area>")),
        ("element:Mystery", element("<Element_Array>")),
        ("element:Mystery", element("<cart:Cartography>")),
        ("element:Mystery", element("<disp:Display_Settings>")),
        ("MYSTERY", keyword("Group = Pixels")),
        ("MYSTERY", keyword("Group = Mapping")),
        (
            "object:MYSTERY",
            isis(&replaced(ISIS, "Object = Core", "Group = Mystery\n A = 1\nEnd_Group\nObject = Core")),
        ),
        ("mystery", envi(&ENVI.replace("lines = 24", "lines = 24\nMystery = {1,\n2}"))),
        (
            "mystery",
            ascii(&format!("mystery 1\n{HEAD}").replace("mystery 1\nncols 24", "ncols 24\nmystery 1"), PRJ),
        ),
        ("wkt:MYSTERY", ascii(HEAD, &PRJ.replace("UNIT[\"Meter\"", "MYSTERY[\"x\",1],UNIT[\"Meter\""))),
        ("parameter:mystery", ascii(HEAD, &PRJ.replace("PARAMETER[", "PARAMETER[\"Mystery\",1],PARAMETER["))),
    ];
    for (name, made) in files {
        let refusal = made.refusal();
        assert!(refusal.contains(&format!("--ignore {name}")) && refusal.contains("made."), "{refusal}");
        let ignore = vec![name.to_owned()];
        let read = made.read(&ReadOptions { ignore, ..ReadOptions::default() }).unwrap();
        assert!(read.notes.iter().any(|note| note.starts_with(name)), "{name}: {:?}", read.notes);
    }
}
