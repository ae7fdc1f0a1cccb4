//! The tables of names are what the readers do: each row is tried in a file, and the page of the docs is made from them.

use std::path::Path;

use survey::{Elevation, Fate, Frame, ReadOptions, VOCABULARIES, Vocabulary, words_page};

use crate::made::{Directory, Field, LABEL, Made, SIDE, floats, heights, quarters, words};

/// Everything that a reader gives, or its error.
pub type Outcome = Result<String, String>;

pub fn outcome(made: &Made, options: &ReadOptions) -> Outcome {
    let Elevation { affine, frame, title, notes, lines, columns, .. } = &made.read(options)?;
    let elevation = made.read(options)?;
    let samples: Vec<_> =
        (0..lines * columns).map(|index| elevation.height(index / columns, index % columns)).collect();
    Ok(format!("{affine:?} {frame:?} {title} {notes:?} {samples:?}"))
}

fn vocabulary(kind: &str) -> &'static Vocabulary {
    VOCABULARIES.iter().map(|(_, table)| *table).find(|table| table.kind == kind).unwrap()
}

/// Tries every row of a table. `files(word)` has pairs of files: without the name, and with it.
pub fn every_row(kind: &str, files: impl Fn(u16, &str) -> Vec<[Outcome; 2]>) {
    for word in vocabulary(kind).words {
        let name = word.name.replace('*', "X");
        let pairs = files(word.number, &name);
        let (mut differs, mut refused) = (0, 0);
        for [without, with] in &pairs {
            assert!(without.is_ok(), "{name}: {without:?}");
            differs += usize::from(without != with);
            let names_it = |said: &String| said.to_lowercase().contains(&name.to_lowercase());
            refused += usize::from(with.as_ref().is_err_and(names_it));
        }
        match word.fate {
            Fate::Used(_) | Fate::Void(_) => assert!(differs > 0, "{kind} {name} is not used: {pairs:?}"),
            Fate::Harmless(_) => assert_eq!(differs, 0, "{kind} {name} is not harmless: {pairs:?}"),
            Fate::Only(..) => assert!(refused > 0, "{kind} {name} takes every value: {pairs:?}"),
            Fate::Refused(_) => assert_eq!(refused, pairs.len(), "{kind} {name} is read: {pairs:?}"),
        }
    }
}

#[test]
fn every_row_of_tags() {
    let mut tiles = Directory::ground();
    [273, 279, 278].iter().for_each(|tag| drop(tiles.tags.remove(tag)));
    tiles.place = [324, 325];
    tiles.blocks = vec![floats(&heights()).repeat(2)];
    let tiles = tiles.with(322, Field::Shorts(vec![SIDE as u16])).with(323, Field::Shorts(vec![SIDE as u16]));
    let matrix =
        vec![10.0, 0.0, 0.0, 10_000.0, 0.0, -10.0, 0.0, 20_000.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let mut two = Directory::ground().with(277, Field::Shorts(vec![2])).with(284, Field::Shorts(vec![2]));
    two.blocks = [two.blocks.clone(), vec![floats(&[0.0; 4 * SIDE]); 6]].concat();
    let two = two.with(34264, Field::Doubles(matrix)).with(42112, Field::Text(String::new()));
    let options = ReadOptions { band: Some(1), ..ReadOptions::default() };
    every_row("TIFF tag", |tag, _| {
        let text = |text: &str| Field::Text(text.into());
        let values = [
            Field::Shorts(vec![2]),
            Field::Shorts(vec![3]),
            Field::Shorts(vec![77]),
            Field::Doubles(vec![77.0; 16]),
            text("<GDALMetadata><Item name=\"SCALE\" sample=\"0\">3</Item></GDALMetadata>"),
            text("50"),
        ];
        let fits = |value: &&Field| match tag {
            33550 | 33922 | 34264 | 34736 => matches!(value, Field::Doubles(_)),
            42112 | 42113 => matches!(value, Field::Text(_)),
            _ => matches!(value, Field::Shorts(_)),
        };
        let mut pairs = Vec::new();
        for base in [&Directory::ground(), &tiles, &two] {
            for value in values.iter().filter(fits) {
                let with = base.clone().with(tag, value.clone());
                pairs.push([base.clone(), with].map(|directory| outcome(&directory.made(), &options)));
            }
        }
        pairs
    });
}

#[test]
fn every_row_of_keys() {
    let usual = [(1024, 1.0), (1025, 1.0), (2057, 1_737_400.0), (3075, 17.0), (3076, 9001.0)];
    let polar = [(1024, 1.0), (2057, 1_737_400.0), (3075, 15.0), (3081, 89.0), (3095, 5.0)];
    let turned = [(1024, 1.0), (2057, 1_737_400.0), (3075, 17.0), (3080, 7.0)];
    every_row("geo key", |key, _| {
        let bases = [&usual[..], &polar, &turned];
        let with = |base: &[(u16, f64)], number: f64| {
            let mut keys: Vec<_> = base.iter().copied().filter(|(found, _)| *found != key).collect();
            keys.push((key, number));
            outcome(&Directory::ground().with_keys(&keys).made(), &ReadOptions::default())
        };
        let pair = |base: &[(u16, f64)], number: f64| {
            let base_of = Directory::ground().with_keys(base).made();
            [outcome(&base_of, &ReadOptions::default()), with(base, number)]
        };
        bases.iter().flat_map(|base| [2.0, 77.0].map(|number| pair(base, number))).collect()
    });
}

#[test]
fn every_row_of_items_and_domains() {
    let ground = || outcome(&Directory::ground().made(), &ReadOptions::default());
    let second = {
        let mut two = Directory::ground().with(277, Field::Shorts(vec![2])).with(284, Field::Shorts(vec![2]));
        two.blocks = [two.blocks.clone(), vec![floats(&[0.0; 4 * SIDE]); 6]].concat();
        two
    };
    every_row("item of GDAL metadata", |_, name| {
        let with = |value: &str| {
            let made = Directory::ground().with_items(&[(name, value)]).made();
            [ground(), outcome(&made, &ReadOptions::default())]
        };
        // An alpha band is one of several.
        let alpha = format!("<GDALMetadata><Item name=\"{name}\" sample=\"1\">Alpha</Item></GDALMetadata>");
        let options = ReadOptions { band: Some(1), ..ReadOptions::default() };
        let alpha = [second.clone(), second.clone().with(42112, Field::Text(alpha))];
        vec![with("2"), with("50"), alpha.map(|directory| outcome(&directory.made(), &options))]
    });
    every_row("domain of GDAL metadata", |_, name| {
        let xml = format!("<GDALMetadata><Item name=\"N\" domain=\"{name}\">2</Item></GDALMetadata>");
        let made = Directory::ground().with(42112, Field::Text(xml)).made();
        vec![[ground(), outcome(&made, &ReadOptions::default())]]
    });
}

/// Labels whose image stands in a file of its own, behind one record, with two bands.
fn labels() -> [String; 2] {
    let file =
        "OBJECT = FILE\n  FILE_NAME = \"made.img\"\n  RECORD_BYTES = 48\n^IMAGE = 2\nEND_OBJECT = FILE";
    let plane = LABEL
        .replace("RECORD_BYTES = 48\n^IMAGE = \"made.img\"", file)
        .replace("  UNIT = METER", "  BANDS = 2\n  BAND_STORAGE_TYPE = BAND_SEQUENTIAL\n  UNIT = METER");
    let globe = plane.replace("\"EQUIRECTANGULAR\"", "\"SIMPLE CYLINDRICAL\"\n  MAP_RESOLUTION = 3032.33");
    [plane, globe]
}

fn of_label(label: &str) -> Outcome {
    let image = [vec![0; 48], words(&quarters()).repeat(2)].concat();
    let made = Made::new(&[("made.lbl", label.as_bytes()), ("made.img", &image)]);
    outcome(&made, &ReadOptions { band: Some(1), ..ReadOptions::default() })
}

/// `label` with `KEYWORD = value` behind a line, and without another statement of that keyword.
fn stated(label: &str, behind: &str, keyword: &str, value: &str) -> String {
    let begins = |line: &str| line.trim_start().starts_with(&format!("{keyword} ="));
    let kept: Vec<&str> = label.lines().filter(|line| !begins(line)).collect();
    let statement = format!("{behind}\n  {keyword} = {value}\n");
    let text = kept.join("\n") + "\n";
    assert_eq!(text.matches(behind).count(), 1, "{behind}");
    text.replace(behind, &statement)
}

fn every_keyword(kind: &str, behind: &str) {
    every_row(kind, |_, keyword| {
        let pair =
            |label: &String, value: &str| [of_label(label), of_label(&stated(label, behind, keyword, value))];
        let values = ["250", "\"@@\""];
        labels().iter().flat_map(|label| values.map(|value| pair(label, value))).collect()
    });
}

#[test]
fn every_row_of_labels() {
    every_keyword("keyword of IMAGE in a PDS3 label", "\nOBJECT = IMAGE\n");
    every_keyword("keyword of IMAGE_MAP_PROJECTION in a PDS3 label", "\nOBJECT = IMAGE_MAP_PROJECTION\n");
    every_keyword("keyword of a PDS3 label", "\nOBJECT = FILE\n");
    every_row("object or group of a PDS3 label", |_, name| {
        let object =
            format!("OBJECT = {name}\n  RECORD_BYTES = 7\n  LINES = 7\n  A_AXIS_RADIUS = 7\n  END_OBJECT");
        let pair = |label: &String| {
            let inner = label.replace("\nOBJECT = FILE\n", &format!("\nOBJECT = FILE\n{object}\n"));
            [of_label(label), of_label(&inner)]
        };
        labels().iter().map(pair).collect()
    });
}

#[test]
fn the_page_is_made_from_the_tables() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../docs/elevation-words.md");
    if std::env::var_os("LUNOID_WRITE_PAGE").is_some() {
        std::fs::write(&path, words_page()).unwrap();
    }
    let page = std::fs::read_to_string(&path).unwrap();
    assert!(page == words_page(), "make it again: LUNOID_WRITE_PAGE=1 cargo test -p survey the_page");
}

#[test]
fn unknown_names_are_refused_and_can_be_ignored() {
    let item = "<GDALMetadata><Item name=\"BIAS\">2</Item></GDALMetadata>";
    let domain = "<GDALMetadata><Item name=\"N\" domain=\"CHARTS\">2</Item></GDALMetadata>";
    let label = |behind: &str, keyword: &str| {
        let [plane, _] = labels();
        let image = [vec![0; 48], words(&quarters()).repeat(2)].concat();
        Made::new(&[("made.lbl", stated(&plane, behind, keyword, "2").as_bytes()), ("made.img", &image)])
    };
    let object =
        LABEL.replace("\nOBJECT = IMAGE\n", "\nGROUP = CHART\nLINES = 2\nEND_GROUP\nOBJECT = IMAGE\n");
    let files = [
        ("tag:65000", Directory::ground().with(65000, Field::Shorts(vec![2])).made()),
        ("key:3200", Directory::ground().with_keys(&[(1024, 1.0), (3076, 9001.0), (3200, 2.0)]).made()),
        ("item:BIAS", Directory::ground().with(42112, Field::Text(item.into())).made()),
        ("domain:CHARTS", Directory::ground().with(42112, Field::Text(domain.into())).made()),
        ("PIXEL_BIAS", label("\nOBJECT = IMAGE\n", "PIXEL_BIAS")),
        ("MAP_SHEAR", label("\nOBJECT = IMAGE_MAP_PROJECTION\n", "MAP_SHEAR")),
        ("BYTE_SWAP", label("\nOBJECT = FILE\n", "BYTE_SWAP")),
        ("object:CHART", Made::new(&[("made.lbl", object.as_bytes()), ("made.img", &words(&quarters()))])),
    ];
    for (name, made) in files {
        let band = Some(1);
        let refusal = made.read(&ReadOptions { band, ..ReadOptions::default() }).unwrap_err();
        assert!(refusal.contains(&format!("--ignore {name}")) && refusal.contains("made."), "{refusal}");
        let ignore = |names: &[&str]| ReadOptions {
            band,
            ignore: names.iter().map(ToString::to_string).collect(),
            ..ReadOptions::default()
        };
        let read = made.read(&ignore(&[name])).unwrap();
        assert!(matches!(read.frame, Frame::Plane(_)));
        assert!(read.notes.iter().any(|note| note.starts_with(name)), "{name}: {:?}", read.notes);
        let absent = made.read(&ignore(&[name, "OTHER"])).unwrap_err();
        assert!(absent.starts_with("ignore: found OTHER"), "{absent}");
    }
}
