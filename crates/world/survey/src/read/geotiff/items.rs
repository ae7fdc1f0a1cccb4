//! Items of GDAL's metadata in a TIFF (tag 42112, XML), and what becomes of each.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use roxmltree::{Document, Node, ParsingOptions};
use text::xml::{MOST_ATTRIBUTES, too_many_attributes};

use crate::error::SurveyError;
use crate::read::refusal::field;
use crate::read::words::Fate::{Harmless, Only, Refused, Used, Void};
use crate::read::words::{Decider, Met, Vocabulary, named};

/// Most elements, texts and comments of the metadata; those of GDAL have some hundred.
const MOST_NODES: u32 = 200_000;
/// Text for names and history.
const ORIGIN: &str = "origin of the file";
/// Text for how the samples are stored, which the tags say.
const STORED: &str = "how samples are stored, which the tags say";
/// Text for figures counted from the samples.
const STATISTICS: &str = "a figure counted from the samples";
/// Items that say what the samples of one band mean.
const OF_A_BAND: [&str; 3] = ["SCALE", "OFFSET", "UNITTYPE"];
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
            expect_band(path, &place, item)?;
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

/// Sees that a scale, an offset or a unit is that of a band. Of no band GDAL takes it for text, and other programs for the meaning of the samples.
fn expect_band(path: &Path, place: &str, item: &Item) -> Result<(), SurveyError> {
    let Item { name, band, domain, .. } = item;
    let is_meaning = OF_A_BAND.iter().any(|known| known.eq_ignore_ascii_case(name));
    if band.is_some() || !domain.is_empty() || !is_meaning {
        return Ok(());
    }
    let place = format!("{place}, {name}");
    let role = name.to_ascii_lowercase();
    let expected = format!("<Item name=\"{name}\" sample=\"0\" role=\"{role}\">");
    let advice =
        "GDAL and other programs read this differently: state it for a band, or remove it, by gdal_edit.py";
    Err(field(path, place, "an item of no band", expected, advice))
}

/// The items of a text in XML; the error is what stands in place of one.
fn parse(xml: &str) -> Result<Vec<Item>, String> {
    let xml = xml.trim_matches(['\0', ' ', '\n', '\r', '\t']);
    if xml.is_empty() {
        return Ok(Vec::new());
    }
    if too_many_attributes(xml).is_some() {
        return Err(format!("an element with more than {MOST_ATTRIBUTES} attributes"));
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(xml, options).map_err(|error| error.to_string())?;
    let root = document.root_element();
    if root.tag_name().name() != "GDALMetadata" {
        return Err(format!("<{}>", root.tag_name().name()));
    }
    let items: Vec<Item> = root.children().filter(Node::is_element).map(item).collect::<Result<_, _>>()?;
    let mut texts = BTreeMap::new();
    for Item { name, band, domain, text } in &items {
        let other = *texts.entry((name, band, domain)).or_insert(text);
        if other != text {
            return Err(format!("{name} twice, {other} and {text}"));
        }
    }
    Ok(items)
}

/// One item; the error is what is wrong with it.
fn item(node: Node) -> Result<Item, String> {
    let is_known = |name: &str| ["name", "sample", "role", "domain", "format"].contains(&name);
    if node.tag_name().name() != "Item" {
        return Err(format!("<{}>", node.tag_name().name()));
    }
    if let Some(other) = node.attributes().find(|attribute| !is_known(attribute.name())) {
        return Err(format!("an <Item> with {}=\"{}\"", other.name(), other.value()));
    }
    if let Some(inside) = node.children().find(Node::is_element) {
        return Err(format!("<{}> in an <Item>", inside.tag_name().name()));
    }
    let name = node.attribute("name").ok_or("an <Item> without a name")?.to_owned();
    // GDAL goes by the role of these, and a file by another program may contradict it.
    let goes_by_role = ["DESCRIPTION", "SCALE", "OFFSET", "UNITTYPE", "COLORINTERP"];
    if let Some(role) = node.attribute("role").filter(|role| !role.eq_ignore_ascii_case(&name))
        && goes_by_role.iter().any(|known| [&*name, role].iter().any(|said| said.eq_ignore_ascii_case(known)))
    {
        return Err(format!("{name} in the role of {role}"));
    }
    let sample = |band: &str| band.trim().parse().map_err(|_| format!("an <Item> with sample=\"{band}\""));
    let band = node.attribute("sample").map(sample).transpose()?;
    let domain = node.attribute("domain").unwrap_or_default().to_owned();
    let texts = node.children().filter(Node::is_text).filter_map(|piece| piece.text());
    Ok(Item { name, band, domain, text: texts.collect::<String>().trim().to_owned() })
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
                   <Item sample = '0' name='A &amp; B'> x &lt; <!-- -->2 </Item><Item name=\"E\"/>\
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
        let said = |items: &str| parse(&format!("<GDALMetadata>{items}</GDALMetadata>")).unwrap_err();
        assert!(said("<Item name='A' sample='x'>b</Item>").contains("sample=\"x\""));
        assert!(said("<Item>b</Item>").contains("without a name"));
        assert!(said("<Foo name='A'>1</Foo>").contains("<Foo>"));
        assert!(said("<Item name='A' unit='m'>1</Item>").contains("unit"));
        assert!(said("<Item name='A'><b/></Item>").contains("<b>"));
        assert!(
            said("<Item name='OFFSET' sample='0' role='scale'>2</Item>").contains("in the role of scale")
        );
        assert!(said("<Item name='Z' sample='0' role='scale'>2</Item>").contains("in the role of scale"));
        assert!(said("<Item name='SCALE'>2</Item><Item name='SCALE'>3</Item>").contains("twice, 2 and 3"));
        for xml in ["<Item name=\"A\"", "SCALE=2", "<GDALMetadata>", "<PAMDataset/>"] {
            assert!(parse(xml).is_err(), "{xml}");
        }
        let commented = "<GDALMetadata><!-- <Item name='SCALE'>2</Item> --></GDALMetadata>";
        assert_eq!([parse(""), parse("\0"), parse(commented)], [(); 3].map(|()| Ok(vec![])));
    }
}
