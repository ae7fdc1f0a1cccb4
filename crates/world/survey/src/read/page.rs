//! The page of the docs about names in elevation files, made from the tables that decide about them.

use super::geotiff::{items, keys, tags};
use super::pds3::words;
use super::words::Vocabulary;
use super::{ascii, dted, envi, isis, pds4, wkt};

/// All tables of names, with their headings, in the order of `SECTIONS`.
pub const VOCABULARIES: [(&str, &Vocabulary); 24] = [
    ("Tags of the first directory", &tags::TAGS),
    ("Geo keys", &keys::KEYS),
    ("Items of GDAL metadata (tag 42112)", &items::ITEMS),
    ("Domains of GDAL metadata other than the default one", &items::DOMAINS),
    ("Objects and groups", &words::OBJECTS),
    ("Keywords outside of IMAGE and IMAGE_MAP_PROJECTION", &words::FILE),
    ("Keywords of IMAGE", &words::IMAGE),
    ("Keywords of IMAGE_MAP_PROJECTION", &words::MAP),
    ("Elements outside of the array, Cartography and Display_Settings", &pds4::words::SECTIONS),
    ("Elements of the array", &pds4::words::ARRAY),
    ("Elements of Cartography", &pds4::words::CARTOGRAPHY),
    ("Elements of Display_Settings", &pds4::words::DISPLAY),
    ("Objects and groups of a cube", &isis::words::OBJECTS),
    ("Keywords outside of the groups below", &isis::words::CUBE),
    ("Keywords of Core", &isis::words::CORE),
    ("Keywords of Dimensions", &isis::words::DIMENSIONS),
    ("Keywords of Pixels", &isis::words::PIXELS),
    ("Keywords of BandBin", &isis::words::BAND_BIN),
    ("Keywords of Mapping", &isis::words::MAPPING),
    ("Keys of the header", &envi::words::KEYS),
    ("Keys of the head", &ascii::KEYS),
    ("Elements", &wkt::words::ELEMENTS),
    ("Parameters of a map", &wkt::words::PARAMETERS),
    ("Fields of the headers and records", &dted::FIELDS),
];

/// A format: its heading, how many of the tables are its own, and what the tables do not say.
const SECTIONS: [(&str, usize, &str); 8] = [
    (
        "GeoTIFF",
        4,
        "Later directories are copies of less detail, which are not read; masks, whose zeros are voids; or other pictures,\n\
         which are told. A file `NAME.msk` beside the TIFF is a mask too. Cloud-optimised files and BigTIFF are read as well.",
    ),
    ("PDS3 labels", 4, ""),
    (
        "PDS4 labels",
        4,
        "A label has one array with heights: lines and samples, or bands too. An element of another discipline that is not\n\
         listed is refused. A label with a document type definition is refused.",
    ),
    (
        "ISIS cubes",
        7,
        "Special pixels are voids: null, and saturations of the instrument and of the representation. Each kind of sample has\n\
         its own.",
    ),
    (
        "ENVI headers",
        1,
        "The samples stand in a file beside the header: `NAME`, or `NAME` with `.img`, `.dat`, `.bin`, `.raw`, `.bsq`, `.bil`,\n\
         `.bip` or `.dem` behind it.",
    ),
    (
        "Arc ASCII grids",
        1,
        "A file `NAME.prj` beside the grid has its coordinate system. Without it the coordinates are taken as metres, with a\n\
         note. Behind the head stand the numbers, from north to south.",
    ),
    (
        "Coordinate systems as well-known text",
        2,
        "ENVI headers and `.prj` files have them: version 1, as Esri and GDAL write it.",
    ),
    ("DTED", 1, ""),
];

const HEAD: &str = "# Names in elevation files

`lunoid survey` decides about every tag, key, keyword and element that it meets in an elevation file. The tables below are the
ones that the readers themselves ask. A test holds this page equal to them.

| fate | what it means |
|---|---|
| used | The value decides heights or their place. |
| harmless | The value changes neither heights nor their place. |
| only | The value must be one of those in the table. Any other value is refused. |
| refused | The name cannot be read here. The file is refused, with the name and its place. |

A name that stands in no table is refused too. If it changes neither heights nor their place, `--ignore NAME` lets the file
through, and the report of the survey names it. The refusal says what to give: `--ignore KEYWORD` or
`--ignore object:NAME` for a label or a header, `--ignore element:NAME` for PDS4, `--ignore wkt:NAME` or
`--ignore parameter:NAME` for a coordinate system, `--ignore tag:NUMBER`, `--ignore key:NUMBER`, `--ignore item:NAME` or
`--ignore domain:NAME` for a TIFF. A star stands for any characters.

Heights without a unit are taken as metres, with a note. A unit that is not known is refused until `--scale METRES` is
given. Units known by name are metre, kilometre, decimetre, centimetre, millimetre, foot, US survey foot, yard, fathom,
mile and nautical mile. If more than half of the samples lie within 2 % of the radius of the body, they are radii: the
radius is taken off, with a note.
";

const HGT: &str = "
The sum of a record must be that of its bytes; `--ignore checksum` reads a cell whose sums are wrong.

## SRTM tiles

A tile `.hgt` holds no names. Its own name is its south-west corner, as `S05W120.hgt`; its size must be that of 1201 x 1201,
3601 x 3601 or 3601 x 1801 samples. -32768 is a void.
";

/// The page `docs/elevation-words.md` as Markdown: a table for every kind of name, made from what the readers ask.
pub fn words_page() -> String {
    let mut tables = VOCABULARIES.iter();
    let mut page = HEAD.to_owned();
    for (title, count, about) in SECTIONS {
        page.push_str(&format!("\n## {title}\n"));
        page.extend((!about.is_empty()).then(|| format!("\n{about}\n")));
        for (heading, table) in tables.by_ref().take(count) {
            page.push_str(&format!("\n### {heading}\n\n{}", table.table()));
        }
    }
    page + HGT
}
