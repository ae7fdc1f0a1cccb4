//! Paths of GPS receivers: a track of a GPX file (<https://www.topografix.com/GPX/1/1>).
//!
//! Places are latitudes and longitudes. Heights are used if the scenario says what they count from. Every element of a track
//! is used, harmless by name, or refused by name.

use std::path::Path as FilePath;
use std::sync::Arc;

use diagnostics::{LongList, Place, Placed, Problem, Problems, Reader, Source};
use quantities::radians;
use roxmltree::{Document, Node, ParsingOptions};
use tables::{Clock, Faulty, Time, read_text};
use text::xml::{MOST_ATTRIBUTES, too_many_attributes};

use super::coordinates::Coordinates;
use super::gpx_names::{BESIDE_TRACKS, NAMESPACES, OF_POINT, OF_SEGMENT, OF_TRACK, VERSIONS};
use super::points::{PlacedWaypoint, Points};
use super::scenery::MAX_COORDINATE;
use crate::{HeightOver, Waypoint};

/// Which track of a file is the path, and what its heights are.
#[derive(Debug, Clone, Copy)]
pub(super) struct TrackWishes {
    track: Option<usize>,
    segment: Option<usize>,
    heights: Option<Heights>,
}

/// What the heights of a track are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Heights {
    /// Not used: the vehicle stands on the ground.
    Unused,
    /// Heights of the eye.
    Eye(HeightOver),
}

impl TrackWishes {
    /// The keys `track`, `segment` and `heights` of `[path]`.
    pub fn read(table: &Reader) -> Option<Self> {
        let number = |key: &str| {
            let number = table.usize(key).between(1, 1_000_000).optional();
            if table.has(key) { number.map(Some) } else { Some(None) }
        };
        let words = [
            ("unused", Heights::Unused),
            ("above-ground", Heights::Eye(HeightOver::Ground)),
            ("above-datum", Heights::Eye(HeightOver::Datum)),
        ];
        let (track, segment) = (number("track"), number("segment"));
        let heights = table.one_of("heights", &words).optional();
        let heights = if table.has("heights") { heights.map(Some) } else { Some(None) };
        Some(Self { track: track?, segment: segment?, heights: heights? })
    }
}

/// The points of a track.
pub(super) fn read(path: &FilePath, wishes: &TrackWishes, problems: &Problems) -> Option<Points> {
    let source = read_text(path, problems)?;
    if let Some(at) = too_many_attributes(&source.text) {
        let place = Place { source: source.clone(), span: at..at + 1 };
        let title = format!("an element with more than {MOST_ATTRIBUTES} attributes");
        problems.push(Problem::at(&place, title).expected("a GPX file"));
        return None;
    }
    let options = ParsingOptions { allow_dtd: false, ..ParsingOptions::default() };
    let document = match Document::parse_with_options(&source.text, options) {
        Ok(document) => document,
        Err(error) => {
            let at = offset(&source.text, error.pos());
            let place = Place { source: source.clone(), span: at..at };
            problems.push(Problem::at(&place, format!("not XML: {error}")).expected("a GPX file"));
            return None;
        }
    };
    let mut reading =
        Reading { source: source.clone(), faults: LongList::new(&source.name), heights: wishes.heights };
    let waypoints = reading.waypoints(document.root_element(), wishes);
    let Reading { faults, .. } = reading;
    let (waypoints, notes) = faults.finish(waypoints, problems)??;
    notes.into_iter().for_each(|note| problems.note(format!("{}: {note}", source.name)));
    let height_over = match wishes.heights {
        Some(Heights::Eye(over)) => over,
        _ => HeightOver::Datum,
    };
    Some(Points { waypoints, coordinates: Coordinates::LonLat, height_over })
}

/// Byte of a line and column that the parser names.
fn offset(text: &str, at: roxmltree::TextPos) -> usize {
    let before =
        text.split_inclusive('\n').take((at.row as usize).saturating_sub(1)).map(str::len).sum::<usize>();
    let line = &text[before.min(text.len())..];
    let column = line.char_indices().nth((at.col as usize).saturating_sub(1));
    before + column.map_or(0, |(bytes, _)| bytes)
}

/// A file that is being read.
struct Reading {
    source: Arc<Source>,
    faults: LongList,
    heights: Option<Heights>,
}

impl Reading {
    /// Waypoints and notes of the track that is wished; `None` if there is none, with a fault.
    fn waypoints(&mut self, root: Node, wishes: &TrackWishes) -> Option<(Vec<PlacedWaypoint>, Vec<String>)> {
        self.expect_gpx(&root)?;
        let tracks = self.children(&root, "trk", BESIDE_TRACKS);
        let track = self.one_of(&root, &tracks, wishes.track, "track")?;
        let segments = self.children(&track, "trkseg", OF_TRACK);
        let segment = self.one_of(&track, &segments, wishes.segment, "segment")?;
        let points = self.children(&segment, "trkpt", OF_SEGMENT);
        if points.is_empty() {
            self.fault(&segment, "a track segment without points".into(), "at least one `trkpt`");
            return None;
        }
        let mut clock = Clock::from_first_row();
        let waypoints: Vec<_> = points.iter().filter_map(|point| self.point(point, &mut clock)).collect();
        let mut notes: Vec<String> = clock.note().into_iter().collect();
        if self.heights.is_none() && points.iter().any(|point| child(point, "ele").is_some()) {
            notes.push(
                "heights of the track are not used, the vehicle stands on the ground; `path.heights` says otherwise"
                    .into(),
            );
        }
        Some((waypoints, notes))
    }

    /// Whether the root is that of a GPX file of a version that is read; a fault if not.
    fn expect_gpx(&mut self, root: &Node) -> Option<()> {
        let (tag, version) = (root.tag_name(), root.attribute("version"));
        let namespace = tag.namespace().unwrap_or_default();
        if tag.name() != "gpx" {
            let title = format!("the element `{}`", tag.name());
            self.fault(root, title, "the element `gpx` around a GPX file");
        } else if !NAMESPACES.contains(&namespace) {
            let title = format!("a `gpx` of the namespace {}", shown(namespace));
            self.fault(root, title, &format!("xmlns=\"{}\", or that of GPX 1.0", NAMESPACES[0]));
        } else if let Some(version) = version.filter(|version| !VERSIONS.contains(version)) {
            self.fault(root, format!("GPX of version {}", shown(version)), "version 1.1 or 1.0");
        } else {
            return Some(());
        }
        None
    }

    /// Elements `name` of `parent`; others that are not harmless are faults.
    fn children<'a, 'i>(
        &mut self,
        parent: &Node<'a, 'i>,
        name: &str,
        harmless: &[&str],
    ) -> Vec<Node<'a, 'i>> {
        let mut found = Vec::new();
        for child in parent.children().filter(Node::is_element) {
            match name_in(parent, &child) {
                Some(tag) if tag == name => found.push(child),
                Some(tag) if harmless.contains(&tag) => {}
                _ => self.unknown(parent, &child, &format!("`{name}`, or one of {}", harmless.join(", "))),
            }
        }
        found
    }

    /// The element that is wished by its number from 1; without a wish the only one.
    fn one_of<'a, 'i>(
        &mut self,
        parent: &Node,
        all: &[Node<'a, 'i>],
        wish: Option<usize>,
        what: &str,
    ) -> Option<Node<'a, 'i>> {
        let chosen = match (wish, all) {
            (Some(number), _) => all.get(number - 1),
            (None, [only]) => Some(only),
            (None, _) => None,
        };
        if chosen.is_none() {
            let title = match (all.len(), wish) {
                (0, _) => format!("a GPX file without a {what}"),
                (count, Some(number)) => format!("`path.{what}` = {number}, but there are {count} {what}s"),
                (count, None) => format!("{count} {what}s: {}", listed(all)),
            };
            let expected = match all.len() {
                0 => format!("a {what} with points and times"),
                count => format!("`path.{what}`, 1 to {count}"),
            };
            self.fault(parent, title, &expected);
        }
        chosen.copied()
    }

    fn point(&mut self, point: &Node, clock: &mut Clock) -> Option<PlacedWaypoint> {
        let mut met = Vec::new();
        for child in point.children().filter(Node::is_element) {
            match name_in(point, &child) {
                Some(tag) if OF_POINT.contains(&tag) => {}
                Some(tag @ ("ele" | "time")) if met.contains(&tag) => {
                    self.fault(&child, format!("a second `{tag}` in a `trkpt`"), &format!("one `{tag}`"));
                }
                Some(tag @ ("ele" | "time")) => met.push(tag),
                _ => self.unknown(point, &child, &format!("ele, time, or one of {}", OF_POINT.join(", "))),
            }
        }
        let (latitude, longitude) = (self.angle(point, "lat", 90.0), self.angle(point, "lon", 180.0));
        let time = self.time(point, clock);
        let eye_height = self.eye_height(point);
        let at = [latitude?, longitude?].map(radians);
        let eye_height = eye_height.ok()?;
        let waypoint = Waypoint { time: time?, at, heading: None, eye_height, pitch: None, roll: None };
        Some(Placed { value: waypoint, place: self.place(&child(point, "time")?), key: "time".into() })
    }

    fn angle(&mut self, point: &Node, name: &str, most: f64) -> Option<f64> {
        let text = point.attribute(name).unwrap_or_default();
        let number = text.trim().parse().ok().filter(|angle: &f64| angle.abs() <= most);
        if number.is_none() {
            let expected = format!("a number of degrees from -{most} to {most}");
            self.fault(point, format!("`{name}` must be {expected}, not {}", shown(text)), &expected);
        }
        number
    }

    fn time(&mut self, point: &Node, clock: &mut Clock) -> Option<f64> {
        let Some(time) = child(point, "time") else {
            self.fault(point, "a track point without a time".into(), "`time` in every point");
            return None;
        };
        let text = value(&time);
        let counted = dates::read(&text)
            .map_err(|error| error.expected())
            .and_then(|date| clock.count(Time::Date(date)));
        counted
            .map_err(|expected| {
                self.fault(&time, format!("`time` must be {expected}, not {}", shown(&text)), &expected);
            })
            .ok()
    }

    /// Height of the eye (m), where the scenario uses heights. A height that is not used must be a number all the same.
    fn eye_height(&mut self, point: &Node) -> Result<Option<f64>, Faulty> {
        let is_used = matches!(self.heights, Some(Heights::Eye(_)));
        let Some(height) = child(point, "ele") else {
            if !is_used {
                return Ok(None);
            }
            let expected = "`ele`, or `path.heights = \"unused\"`";
            self.fault(point, "a track point without a height".into(), expected);
            return Err(Faulty);
        };
        let text = value(&height);
        match text.parse().ok().filter(|number: &f64| number.abs() <= MAX_COORDINATE) {
            Some(number) => Ok(is_used.then_some(number)),
            None => {
                let expected = format!("a number of metres from -{MAX_COORDINATE} to {MAX_COORDINATE}");
                self.fault(&height, format!("`ele` must be {expected}, not {}", shown(&text)), &expected);
                Err(Faulty)
            }
        }
    }

    fn unknown(&mut self, parent: &Node, child: &Node, expected: &str) {
        let (of, tag) = (parent.tag_name().name(), child.tag_name());
        let title = match name_in(parent, child) {
            Some(name) => format!("unknown element `{name}` in `{of}`"),
            None => format!("element `{}` of another namespace in `{of}`", tag.name()),
        };
        self.fault(child, title, expected);
    }

    fn place(&self, node: &Node) -> Place {
        // The opening tag is enough to find the element by.
        let range = node.range();
        let tag = self.source.text[range.clone()].find('>').map_or(range.end, |end| range.start + end + 1);
        Place { source: self.source.clone(), span: range.start..tag }
    }

    fn fault(&mut self, node: &Node, title: String, expected: &str) {
        let place = self.place(node);
        let found = shown(&self.source.text[place.span.clone()]);
        self.faults.push(Problem::at(&place, title).found(found).expected(expected));
    }
}

/// Text of an element without white space around it. A comment within it does not end it.
fn value(node: &Node) -> String {
    let texts = node.children().filter(Node::is_text).filter_map(|piece| piece.text());
    texts.collect::<String>().trim().to_owned()
}

/// The first element of this name and of the node's own namespace.
fn child<'a, 'i>(node: &Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|child| child.is_element() && name_in(node, child) == Some(name))
}

/// Name of an element in the namespace of the one around it; `None` in another one.
fn name_in<'a>(parent: &Node, child: &Node<'a, '_>) -> Option<&'a str> {
    let tag = child.tag_name();
    (tag.namespace() == parent.tag_name().namespace()).then_some(tag.name())
}

/// The first elements by their numbers, names and points.
fn listed(all: &[Node]) -> String {
    const MOST: usize = 8;
    let one = |(index, node): (usize, &Node)| {
        let points = node.descendants().filter(|child| child.tag_name().name() == "trkpt").count();
        let name = child(node, "name")
            .and_then(|name| name.text())
            .map(|name| format!(" \"{}\"", shown(name.trim())));
        format!("{}{} ({points} points)", index + 1, name.unwrap_or_default())
    };
    let mut parts: Vec<String> = all.iter().enumerate().take(MOST).map(one).collect();
    if all.len() > MOST {
        parts.push(format!("and {} more", all.len() - MOST));
    }
    parts.join(", ")
}

/// Text of a file in a message: cut where it is long.
fn shown(text: &str) -> String {
    const MOST: usize = 60;
    match text.char_indices().nth(MOST) {
        _ if text.is_empty() => "nothing".into(),
        None => text.to_owned(),
        Some((end, _)) => format!("{}...", &text[..end]),
    }
}

#[cfg(test)]
mod tests {
    use roxmltree::Document;

    use super::value;

    #[test]
    fn a_comment_does_not_end_a_value() {
        let of = |text: &str| value(&Document::parse(text).unwrap().root_element());
        assert_eq!(of("<ele> -24<!-- metres -->00 </ele>"), "-2400");
        assert_eq!(of("<time>2026-11-30<?x y?>T22:00:04.5Z</time>"), "2026-11-30T22:00:04.5Z");
        assert_eq!(of("<ele/>"), "");
    }
}
