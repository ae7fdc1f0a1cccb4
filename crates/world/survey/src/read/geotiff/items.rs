//! Items of GDAL's metadata in a TIFF (tag 42112, XML), and what becomes of each.

use std::collections::BTreeSet;
use std::path::Path;

use crate::error::SurveyError;
use crate::read::refusal::field;
use crate::read::words::Fate::{Harmless, Only, Refused, Used, Void};
use crate::read::words::{Decider, Met, Vocabulary, named};

/// Text for names and history.
const ORIGIN: &str = "origin of the file";
/// Text for how the samples are stored, which the tags say.
const STORED: &str = "how samples are stored, which the tags say";
/// Text for figures counted from the samples.
const STATISTICS: &str = "a figure counted from the samples";
/// Names of the metre.
const METRES: &[&str] = &["m", "metre", "metres", "meter", "meters"];

/// Items of the default domain.
pub const ITEMS: Vocabulary = Vocabulary {
    kind: "item of GDAL metadata",
    prefix: "item:",
    words: &[
        named("DESCRIPTION", Used("name of a band")),
        named("SCALE", Used("units of height a stored unit")),
        named("OFFSET", Used("height of the stored number 0")),
        named("UNITTYPE", Used("unit of the heights; metres without it, with a note")),
        named("COLORINTERP", Used("`Alpha` makes a band a mask of the others")),
        named("NODATA_VALUES", Void("voids: one number, or one for each band")),
        named("_FillValue", Void("stored number that is a void")),
        named("missing_value", Void("stored number that is a void")),
        named("units", Only(METRES, "unit of the heights, which UNITTYPE says")),
        named("scale_factor", Only(&["1"], "scale, which SCALE says")),
        named("add_offset", Only(&["0"], "offset, which OFFSET says")),
        named("AREA_OR_POINT", Harmless("geo key 1025 says it")),
        named("STATISTICS_*", Harmless(STATISTICS)),
        named("ACTUAL_RANGE", Harmless(STATISTICS)),
        named("LAYER_TYPE", Harmless(STORED)),
        named("DataType", Harmless(STORED)),
        named("PIXELTYPE", Harmless(STORED)),
        named("NBITS", Harmless(STORED)),
        named("RepresentationType", Harmless(STORED)),
        named("PyramidResamplingType", Harmless("how copies of less detail were made")),
        named("OVERVIEW*", Harmless("how copies of less detail were made")),
        named("RESAMPLING", Harmless("how copies of less detail were made")),
        named("INTERNAL_MASK_FLAGS*", Harmless("kind of a mask, which its directory says")),
        named("TIFFTAG_*", Harmless(ORIGIN)),
        named("NC_GLOBAL#*", Harmless(ORIGIN)),
        named("*long_name", Harmless("text")),
        named("*standard_name", Harmless("text")),
        named("*TITLE", Harmless("text")),
        named("*AUTHOR", Harmless(ORIGIN)),
        named("*SOURCE", Harmless(ORIGIN)),
        named("*COPYRIGHT", Harmless(ORIGIN)),
        named("*DATE", Harmless(ORIGIN)),
        named("*TIME", Harmless(ORIGIN)),
        named("*NAME", Harmless("text")),
        named("*COMMENT", Harmless("text")),
        named("*DESCRIPTION", Harmless("text")),
    ],
};

/// Domains of items other than the default one, each decided as a whole.
pub const DOMAINS: Vocabulary = Vocabulary {
    kind: "domain of GDAL metadata",
    prefix: "domain:",
    words: &[
        named("IMAGE_STRUCTURE", Harmless(STORED)),
        named("DERIVED_SUBDATASETS", Harmless("what GDAL can compute")),
        named("SUBDATASETS", Harmless("other pictures of the file")),
        named("COLOR_PROFILE", Harmless("how a picture is shown or printed")),
        named("EXIF", Harmless(ORIGIN)),
        named("IMD", Harmless("how the picture was taken")),
        named("xml:*", Harmless("text")),
        named("json:*", Harmless("text")),
        named("RPC", Refused("a place of the samples of a kind that is not read")),
        named("GEOLOCATION", Refused("a place of the samples of a kind that is not read")),
    ],
};

/// One item of GDAL's metadata.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Item {
    /// Name of the item.
    pub name: String,
    /// Band that it is about, from 0; all if there is none.
    pub band: Option<usize>,
    /// Domain, empty for the default one.
    pub domain: String,
    /// Text that it holds.
    pub text: String,
}

/// The items of the default domain that a file has.
#[derive(Debug, Default)]
pub struct Items(Vec<Item>);

impl Items {
    /// Reads and decides the items of a text in XML.
    ///
    /// # Errors
    /// If the text is damaged, or an item is refused or unknown.
    pub fn of(path: &Path, xml: &str, decider: &mut Decider) -> Result<Self, SurveyError> {
        let place = super::tags::place(42112);
        let damaged = |found: String| {
            let advice = "the metadata are damaged: write the file again with gdal_translate";
            field(path, &place, found, "<Item name=\"NAME\">TEXT</Item>", advice)
        };
        let items = parse(xml).map_err(damaged)?;
        for item in &items {
            let (of, name, value) = match item.domain.as_str() {
                "" => (&ITEMS, &item.name, &item.text),
                domain => (&DOMAINS, &item.domain, &domain.to_owned()),
            };
            let place = format!("{place}, {}", item.name);
            decider.decide(Met { of, word: of.of_name(name), place: &place, name, value })?;
        }
        Ok(Self(items.into_iter().filter(|item| item.domain.is_empty()).collect()))
    }

    /// Text of an item for one band (from 0); one that is about all bands comes last.
    pub fn get(&self, name: &str, band: usize) -> Option<&str> {
        let of = |wanted| {
            let fits = |item: &&Item| item.name.eq_ignore_ascii_case(name) && item.band == wanted;
            self.0.iter().find(fits)
        };
        of(Some(band)).or_else(|| of(None)).map(|item| item.text.as_str())
    }

    /// Bands for which an item has a text. Capitals do not matter.
    pub fn bands_with(&self, name: &str, text: &str) -> BTreeSet<usize> {
        let fits =
            |item: &&Item| item.name.eq_ignore_ascii_case(name) && item.text.eq_ignore_ascii_case(text);
        self.0.iter().filter(fits).filter_map(|item| item.band).collect()
    }

    /// Items that mark voids, for one band or for all.
    pub fn voids(&self, band: usize) -> impl Iterator<Item = &Item> {
        let marks = |name: &str| ITEMS.of_name(name).is_some_and(|word| matches!(word.fate, Void(_)));
        self.0.iter().filter(move |item| item.band.is_none_or(|of| of == band) && marks(&item.name))
    }
}

/// The items of a text in XML; the error is what stands in place of one.
fn parse(xml: &str) -> Result<Vec<Item>, String> {
    let mut items = Vec::new();
    for rest in xml.split("<Item").skip(1) {
        let unfinished = || format!("<Item{}", rest.chars().take(40).collect::<String>());
        let (head, body) = rest.split_once('>').ok_or_else(unfinished)?;
        let (head, text) = match head.strip_suffix('/') {
            Some(head) => (head, ""),
            None => (head, body.split_once("</Item>").ok_or_else(unfinished)?.0),
        };
        let attribute = |name| attribute(head, name);
        let band = match attribute("sample") {
            Some(band) => Some(band.parse().map_err(|_| unfinished())?),
            None => None,
        };
        let name = attribute("name").ok_or_else(unfinished)?;
        items.push(Item { name, band, domain: attribute("domain").unwrap_or_default(), text: plain(text) });
    }
    Ok(items)
}

/// The value of an attribute in a tag of XML.
fn attribute(head: &str, name: &str) -> Option<String> {
    let mut rest = head;
    while let Some((key, after)) = rest.split_once('=') {
        let after = after.trim_start();
        let quote = after.chars().next().filter(|quote| ['"', '\''].contains(quote))?;
        let (value, next) = after[1..].split_once(quote)?;
        if key.trim() == name {
            return Some(plain(value));
        }
        rest = next;
    }
    None
}

/// Text without the escapes of XML.
fn plain(text: &str) -> String {
    let escapes = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
    escapes.iter().fold(text.trim().to_owned(), |text, (escape, is)| text.replace(escape, is))
}

#[cfg(test)]
mod tests {
    use super::{Item, parse};

    fn item(name: &str, band: Option<usize>, domain: &str, text: &str) -> Item {
        Item { name: name.into(), band, domain: domain.into(), text: text.into() }
    }

    #[test]
    fn items_in_every_writing() {
        let xml = "<GDALMetadata>\n<Item name=\"SCALE\" sample=\"1\" role=\"scale\">0.5</Item>\n\
                   <Item sample = '0' name='A &amp; B'> x &lt; 2 </Item><Item name=\"E\"/>\
                   <Item name=\"F\" domain=\"RPC\">1</Item></GDALMetadata>";
        let expected = [
            item("SCALE", Some(1), "", "0.5"),
            item("A & B", Some(0), "", "x < 2"),
            item("E", None, "", ""),
            item("F", None, "RPC", "1"),
        ];
        assert_eq!(parse(xml), Ok(expected.to_vec()));
    }

    #[test]
    fn damage_is_shown() {
        for xml in
            ["<Item name=\"A\"", "<Item name=\"A\">b", "<Item>b</Item>", "<Item name='A' sample='x'>b</Item>"]
        {
            assert!(parse(xml).unwrap_err().starts_with("<Item"), "{xml}");
        }
        assert_eq!(parse("no items"), Ok(vec![]));
    }
}
