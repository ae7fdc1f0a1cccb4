//! A PDS4 label: its elements, decided name by name, and the values that they hold.

use std::path::Path;

use roxmltree::{Document, Node, ParsingOptions};

use text::xml::{MOST_ATTRIBUTES, too_many_attributes};

use super::words::{ARRAY, CARTOGRAPHY, DISPLAY, SECTIONS};
use crate::error::SurveyError;
use crate::read::refusal::field;
use crate::read::words::{Decider, Fate, Met, Vocabulary, seen};

/// Most elements, texts and comments of a label; those of the archives have some thousand.
const MOST_NODES: u32 = 200_000;
/// Most elements within one another; those of the archives have a dozen.
const MOST_NESTED: usize = 64;

/// Namespaces of dictionaries, before their name and version.
const DICTIONARIES: &str = "http://pds.nasa.gov/pds4/";
/// Name of the dictionary that all labels have.
const CORE: &str = "pds";

/// Arrays that may hold heights.
const ARRAYS: [&str; 5] = ["Array_2D", "Array_2D_Image", "Array_2D_Map", "Array_3D", "Array_3D_Image"];

/// The text of a label as a tree. Entities of its own are refused: they serve only to blow it up.
///
/// # Errors
/// If the text is no XML, or has too many elements.
pub fn parse<'a>(path: &Path, text: &'a str) -> Result<Document<'a>, SurveyError> {
    if let Some(at) = too_many_attributes(text) {
        let place = format!("label line {}", text[..at].matches('\n').count() + 1);
        let expected = format!("at most {MOST_ATTRIBUTES} attributes of an element");
        return Err(field(path, place, "more attributes", expected, "the label is damaged: fetch it again"));
    }
    let options = ParsingOptions { allow_dtd: false, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let place = format!("label line {}, column {}", error.pos().row, error.pos().col);
        let advice = "the label is damaged: correct it or fetch it again";
        let expected = format!("XML without entities of its own, of at most {MOST_NODES} elements");
        field(path, place, seen(&error.to_string()), expected, advice)
    })
}

fn too_deep(path: &Path, line: usize) -> SurveyError {
    let expected = format!("at most {MOST_NESTED} elements within one another");
    let advice = "the label is damaged: fetch it again";
    field(path, format!("label line {line}"), "one more element within others", expected, advice)
}

/// A label whose elements are decided.
pub struct Label<'a> {
    /// Path of the file with the label.
    pub path: &'a Path,
    /// The array of the samples.
    pub array: Node<'a, 'a>,
    /// The element File beside it.
    pub file: Node<'a, 'a>,
    /// Its place, if the label has it.
    pub cartography: Option<Node<'a, 'a>>,
    root: Node<'a, 'a>,
    /// First byte of each line of the text.
    lines: Vec<usize>,
}

impl<'a> Label<'a> {
    /// Decides every element.
    ///
    /// # Errors
    /// If an element is refused or unknown, or the label has no array with heights, or more than one.
    pub fn of(
        path: &'a Path,
        document: &'a Document<'a>,
        decider: &mut Decider,
    ) -> Result<Self, SurveyError> {
        let text = document.input_text();
        let lines = [0].into_iter().chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let root = document.root_element();
        let mut label = Self { path, array: root, file: root, cartography: None, root, lines };
        let met = label.decide(decider)?;
        let mut arrays = met.iter().filter(|node| ARRAYS.contains(&node.tag_name().name()));
        let array = *arrays.next().ok_or_else(|| label.missing("Array_2D_Image"))?;
        if let Some(second) = arrays.next() {
            let advice =
                "a label with several arrays cannot be read here: cut it to the array with the heights";
            return Err(field(path, label.place(*second), "a second array", "one array", advice));
        }
        let area = array.parent().unwrap_or(root);
        label.array = array;
        label.file = children(area, "File").next().ok_or_else(|| label.missing("File"))?;
        label.cartography = label.about_array(&met, "Cartography")?;
        Ok(label)
    }

    /// The elements that count, each decided by its table. The tables of arrays, places and displays are their own.
    fn decide(&self, decider: &mut Decider) -> Result<Vec<Node<'a, 'a>>, SurveyError> {
        let (mut met, mut open) = (Vec::new(), vec![(self.root, &SECTIONS, 1)]);
        while let Some((node, table, depth)) = open.pop() {
            let name = node.tag_name().name();
            if depth > MOST_NESTED {
                return Err(too_deep(self.path, self.line(node)));
            }
            let (word, place, value) = (table.of_name(name), self.place(node), text(node));
            let decided = decider.decide(Met { of: table, word, place: &place, name, value })?;
            if !matches!(decided, Some(Fate::Used(_) | Fate::Void(_))) {
                continue;
            }
            self.expect_dictionary(node, table)?;
            if node.children().filter(Node::is_text).count() > 1
                && !node.children().any(|child| child.is_element())
            {
                return Err(
                    self.wrong(node, "a value in one piece, without a comment or an instruction within it")
                );
            }
            met.push(node);
            let inner = self.table_inside(name, table);
            open.extend(node.children().filter(Node::is_element).map(|child| (child, inner, depth + 1)));
        }
        met.sort_by_key(|node| node.range().start);
        Ok(met)
    }

    /// Sees that an element is of the dictionary that its table is made from. One without a namespace is taken for such.
    fn expect_dictionary(&self, node: Node, table: &Vocabulary) -> Result<(), SurveyError> {
        let discipline = match node.tag_name().name() {
            "Cartography" => "cart",
            "Display_Settings" => "disp",
            _ if table.kind == CARTOGRAPHY.kind => "cart",
            _ if table.kind == DISPLAY.kind => "disp",
            _ => CORE,
        };
        let found = node.tag_name().namespace().unwrap_or_default();
        let is_of = |name: &str| found.starts_with(&format!("{DICTIONARIES}{name}/v"));
        if found.is_empty() || is_of(CORE) || is_of(discipline) {
            return Ok(());
        }
        let advice = "the element is of a dictionary that is not read here";
        let expected = format!("the namespace {DICTIONARIES}{discipline}/v1");
        Err(field(self.path, self.place(node), format!("the namespace {}", seen(found)), expected, advice))
    }

    fn table_inside(&self, name: &str, table: &'static Vocabulary) -> &'static Vocabulary {
        match name {
            "Cartography" => &CARTOGRAPHY,
            "Display_Settings" => &DISPLAY,
            name if ARRAYS.contains(&name) => &ARRAY,
            _ => table,
        }
    }

    /// The only element of a name that is about the array, or about none.
    fn about_array(&self, met: &[Node<'a, 'a>], name: &str) -> Result<Option<Node<'a, 'a>>, SurveyError> {
        let own = children(self.array, "local_identifier").next().map(text);
        let is_about = |node: &&Node<'a, 'a>| {
            let of = find(**node, "local_identifier_reference").map(text);
            node.tag_name().name() == name && (of.is_none() || of == own)
        };
        let mut about = met.iter().filter(is_about);
        let first = about.next().copied();
        match about.next() {
            Some(second) => Err(self.wrong(*second, &format!("one {name} of an array"))),
            None => Ok(first),
        }
    }

    /// Line of an element, from 1.
    fn line(&self, node: Node) -> usize {
        self.lines.partition_point(|start| *start <= node.range().start)
    }

    /// Where an element stands, for messages.
    pub fn place(&self, node: Node) -> String {
        format!("label line {}, {}", self.line(node), seen(node.tag_name().name()))
    }

    /// The only element of a name at any depth in another one, unless it says that it has no value.
    ///
    /// # Errors
    /// If there are two with different values.
    pub fn one(&self, inside: Node<'a, 'a>, name: &str) -> Result<Option<Node<'a, 'a>>, SurveyError> {
        let mut found = inside.descendants().filter(|node| node.tag_name().name() == name);
        let Some(first) = found.next() else { return Ok(None) };
        match found.find(|other| text(*other) != text(first)) {
            Some(other) => Err(self.wrong(other, &format!("one {name}"))),
            None => Ok(Some(first).filter(|node| !is_nothing(text(*node)))),
        }
    }

    /// The first element of some names that has a value.
    pub fn any(&self, inside: Node<'a, 'a>, names: &[&str]) -> Result<Option<Node<'a, 'a>>, SurveyError> {
        for name in names {
            if let Some(found) = self.one(inside, name)? {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// The number of an element times that of its unit, which is empty where it has none.
    pub fn number(&self, node: Node, unit: impl Fn(&str) -> Option<f64>) -> Result<f64, SurveyError> {
        let number = text(node).parse::<f64>().ok().filter(|number| number.is_finite());
        let number = number.ok_or_else(|| self.wrong(node, "a finite number"))?;
        let name = node.attribute("unit").unwrap_or_default();
        let factor = unit(name.trim()).ok_or_else(|| {
            let advice = "the label is damaged or of a kind not read here";
            field(self.path, self.place(node), seen(name), "a unit that is known here", advice)
        })?;
        Ok(number * factor)
    }

    /// The number of the first of some elements that is there, as [`Label::number`].
    pub fn number_of(
        &self,
        inside: Node<'a, 'a>,
        names: &[&str],
        unit: impl Fn(&str) -> Option<f64>,
    ) -> Result<Option<f64>, SurveyError> {
        self.any(inside, names)?.map(|node| self.number(node, unit)).transpose()
    }

    /// A whole number, 0 or more.
    pub fn count(&self, node: Node) -> Result<u64, SurveyError> {
        text(node).parse().map_err(|_| self.wrong(node, "a whole number, 0 or more"))
    }

    /// The error for a value that cannot be used.
    pub fn wrong(&self, node: Node, expected: &str) -> SurveyError {
        let advice = "the label is damaged or of a kind not read here";
        field(self.path, self.place(node), seen(text(node)), expected, advice)
    }

    /// The error for an element that is not there.
    pub fn missing(&self, name: &str) -> SurveyError {
        let advice = "the label is incomplete or of a kind not read here";
        field(self.path, format!("label, {name}"), "nothing", "a value", advice)
    }

    /// Title of the product.
    pub fn title(&self) -> Result<&'a str, SurveyError> {
        let own = children(self.array, "name").next().map(text).filter(|name| !name.is_empty());
        match own {
            Some(name) => Ok(name),
            None => Ok(self.one(self.root, "title")?.map(text).unwrap_or_default()),
        }
    }
}

/// Elements of a name directly inside another one.
pub fn children<'a>(inside: Node<'a, 'a>, name: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    inside.children().filter(move |node| node.tag_name().name() == name)
}

/// The first element of a name at any depth in another one.
fn find<'a>(inside: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    inside.descendants().find(|node| node.tag_name().name() == name)
}

/// Text of an element without white space around it.
pub fn text<'a>(node: Node<'a, 'a>) -> &'a str {
    node.text().unwrap_or_default().trim()
}

fn is_nothing(text: &str) -> bool {
    ["", "N/A", "UNK", "inapplicable", "unknown"].contains(&text)
}
