//! JUnit XML, held against the grammar of XML as far as the report uses it.

use proptest::prelude::{any, proptest};
use timing::{Tolerance, compare};

use crate::samples::{record, small};

/// An element: name, attributes, text directly in it, children.
#[derive(Debug, Default)]
struct Element {
    name: String,
    attributes: Vec<(String, String)>,
    text: String,
    children: Vec<Element>,
}

impl Element {
    fn attribute(&self, name: &str) -> &str {
        let found = self.attributes.iter().find(|(found, _)| found == name);
        &found.unwrap_or_else(|| panic!("{} has no {name}", self.name)).1
    }
}

/// Reads a whole document, or says at which rest of it that failed.
fn parse(document: &str) -> Result<Element, &str> {
    let rest = document.strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n").ok_or(document)?;
    let mut rest = rest;
    let root = element(&mut rest).ok_or(rest)?;
    if rest.trim().is_empty() { Ok(root) } else { Err(rest) }
}

fn element(rest: &mut &str) -> Option<Element> {
    *rest = rest.trim_start().strip_prefix('<')?;
    let mut element = Element { name: name(rest)?, ..Element::default() };
    loop {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix("/>") {
            *rest = after;
            return Some(element);
        }
        if let Some(after) = rest.strip_prefix('>') {
            *rest = after;
            return content(element, rest);
        }
        let key = name(rest)?;
        let (value, after) = rest.strip_prefix("=\"")?.split_once('"')?;
        *rest = after;
        element.attributes.push((key, unescaped(value)?));
    }
}

fn content(mut element: Element, rest: &mut &str) -> Option<Element> {
    loop {
        let (text, _) = rest.split_once('<')?;
        element.text += &unescaped(text)?;
        *rest = &rest[text.len()..];
        if let Some(after) = rest.strip_prefix("</") {
            *rest = after.strip_prefix(&element.name)?.strip_prefix('>')?;
            return Some(element);
        }
        element.children.push(self::element(rest)?);
    }
}

fn name(rest: &mut &str) -> Option<String> {
    let end = rest.find(|c: char| !c.is_ascii_alphanumeric())?;
    let (name, after) = rest.split_at(end);
    *rest = after;
    (!name.is_empty()).then(|| name.to_owned())
}

fn unescaped(text: &str) -> Option<String> {
    let is_character = |c: char| c >= ' ' && !matches!(c, '\u{FFFE}' | '\u{FFFF}') || "\t\n\r".contains(c);
    if text.contains(['<', '>']) || !text.chars().all(is_character) {
        return None;
    }
    let mut parts = text.split('&');
    let mut out = parts.next()?.to_owned();
    for part in parts {
        let (entity, after) = part.split_once(';')?;
        out.push(match entity {
            "amp" => '&',
            "lt" => '<',
            "gt" => '>',
            "quot" => '"',
            _ => return None,
        });
        out += after;
    }
    Some(out)
}

#[test]
fn one_case_a_frame_one_for_the_head_and_one_for_the_tasks_before() {
    let mut found = small();
    found.scenario = "mare & \"drive\" <2>\u{1}".into();
    found.frames[1].folds += 1;
    found.before_mission[1].ticks += 1;
    let comparison = compare(&small(), &found, &Tolerance::default());
    let document = comparison.junit(10);
    let root = parse(&document).expect("XML");
    assert_eq!((root.attribute("tests"), root.attribute("failures")), ("4", "3"));
    let suite = &root.children[0];
    assert_eq!(suite.attribute("name"), "timing mare & \"drive\" <2>\u{FFFD} pra-nominal");
    let names: Vec<_> = suite.children.iter().map(|case| case.attribute("name")).collect();
    assert_eq!(names, ["head", "before the mission", "frame 12", "frame 13"]);
    assert_eq!(
        suite.children[1].children[0].text,
        "-before_mission.drum.fine.first-sector.ticks: 350000\n\
         +before_mission.drum.fine.first-sector.ticks: 350001\n"
    );
    assert!(suite.children[2].children.is_empty());
    let failure = &suite.children[3].children[0];
    assert_eq!((failure.name.as_str(), failure.attribute("message")), ("failure", "differences: 1"));
    assert_eq!(failure.text, "-folds: 9400\n+folds: 9401\n");
    assert!(suite.children[0].children[0].text.contains("+scenario: mare & \"drive\" <2>\u{FFFD}"));
}

#[test]
fn a_long_failure_is_cut() {
    let mut found = small();
    found.frames[0].ticks += 1;
    found.frames[0].folds += 1;
    found.frames[0].events += 1;
    let document = compare(&small(), &found, &Tolerance::default()).junit(1);
    let root = parse(&document).expect("XML");
    let failure = &root.children[0].children[2].children[0];
    assert_eq!(failure.text, "-ticks: 666667\n+ticks: 666668\nand 2 more\n");
}

#[test]
fn the_reader_of_this_test_can_say_no() {
    let head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    for broken in ["<a>", "<a b=\"<\"/>", "<a>&x;</a>", "<a></b>", "<a/><b/>", "<a>\u{1}</a>", "<a b='1'/>"] {
        assert!(parse(&format!("{head}{broken}")).is_err(), "{broken}");
    }
}

proptest! {
    #[test]
    fn always_well_formed(baseline in record(), found in record(), limit in any::<u8>()) {
        let comparison = compare(&baseline, &found, &Tolerance::default());
        let document = comparison.junit(limit.into());
        let root = parse(&document).unwrap_or_else(|rest| panic!("stops before {rest:?}"));
        let suite = &root.children[0];
        assert_eq!(suite.children.len(), comparison.frames.len() + 2);
        let failures = suite.children.iter().filter(|case| !case.children.is_empty()).count();
        assert_eq!(suite.attribute("failures"), failures.to_string());
        assert_eq!(failures == 0, comparison.is_met());
    }
}
