//! The page of the docs about names in elevation files, made from the tables that decide about them.

use super::dted;
use super::geotiff::{items, keys, tags};
use super::pds3::words;
use super::words::Vocabulary;

/// All tables of names, with their headings: those of GeoTIFF, then those of PDS3 labels, then that of DTED.
pub const VOCABULARIES: [(&str, &Vocabulary); 9] = [
    ("Tags of the first directory", &tags::TAGS),
    ("Geo keys", &keys::KEYS),
    ("Items of GDAL metadata (tag 42112)", &items::ITEMS),
    ("Domains of GDAL metadata other than the default one", &items::DOMAINS),
    ("Objects and groups", &words::OBJECTS),
    ("Keywords outside of IMAGE and IMAGE_MAP_PROJECTION", &words::FILE),
    ("Keywords of IMAGE", &words::IMAGE),
    ("Keywords of IMAGE_MAP_PROJECTION", &words::MAP),
    ("Fields of the headers and records", &dted::FIELDS),
];

/// How many of the tables are of GeoTIFF.
const OF_TIFF: usize = 4;
/// How many of the tables are of PDS3 labels.
const OF_PDS3: usize = 4;

const HEAD: &str = "# Names in elevation files

`lunoid survey` decides about every tag, key and keyword that it meets in a GeoTIFF, a PDS3 label or a DTED cell. The tables
below are the ones that the readers themselves ask. A test holds this page equal to them.

| fate | what it means |
|---|---|
| used | The value decides heights or their place. |
| harmless | The value changes neither heights nor their place. |
| only | The value must be one of those in the table. Any other value is refused. |
| refused | The name cannot be read here. The file is refused, with the name and its place. |

A name that stands in no table is refused too. If it changes neither heights nor their place, `--ignore NAME` lets the file
through, and the report of the survey names it. The refusal says what to give: `--ignore KEYWORD` or
`--ignore object:NAME` for a label, `--ignore tag:NUMBER`, `--ignore key:NUMBER`, `--ignore item:NAME` or
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
    let section = |(title, table): &(&str, &Vocabulary)| format!("\n### {title}\n\n{}", table.table());
    let (tiff, rest) = VOCABULARIES.split_at(OF_TIFF);
    let (pds3, dted) = rest.split_at(OF_PDS3);
    let [tiff, pds3, dted] = [tiff, pds3, dted].map(|tables| tables.iter().map(section).collect::<String>());
    let later = "\nLater directories are copies of less detail, which are not read; masks, whose zeros are voids; or other \
                 pictures,\nwhich are told. A file `NAME.msk` beside the TIFF is a mask too.\n";
    format!("{HEAD}\n## GeoTIFF\n{later}{tiff}\n## PDS3 labels\n{pds3}\n## DTED\n{dted}{HGT}")
}
