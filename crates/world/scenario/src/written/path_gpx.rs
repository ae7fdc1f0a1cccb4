//! Paths of GPS receivers: a track of a GPX file (<https://www.topografix.com/GPX/1/1>).
//!
//! Places are latitudes and longitudes. Heights are used if the scenario says what they count from. Every element of a track
//! is used, harmless by name, or refused by name.

use std::path::Path as FilePath;
use std::sync::Arc;

use diagnostics::{LongList, Place, Placed, Problem, Problems, Reader, Source};
use quantities::radians;
use roxmltree::{Document, Node, ParsingOptions};
use tables::{Clock, Time, date_time, read_text};

use super::coordinates::Coordinates;
use super::course::{PlacedWaypoint, Points};
use super::scenery::MAX_COORDINATE;
use crate::{HeightOver, Waypoint};

/// Elements beside tracks that a path does not need.
const BESIDE_TRACKS: &[&str] = &[
    "metadata",
    "extensions",
    "wpt",
    "rte",
    "name",
    "desc",
    "author",
    "email",
    "url",
    "urlname",
    "time",
    "keywords",
    "bounds",
];
/// Elements of a track beside its segments.
const OF_TRACK: &[&str] =
    &["name", "cmt", "desc", "src", "link", "url", "urlname", "number", "type", "extensions"];
/// Elements of a segment beside its points.
const OF_SEGMENT: &[&str] = &["extensions"];
/// Elements of a point beside its height and time: how good it is, and how fast and whither its receiver moved.
const OF_POINT: &[&str] = &[
    "magvar",
    "geoidheight",
    "name",
    "cmt",
    "desc",
    "src",
    "link",
    "url",
    "urlname",
    "sym",
    "type",
    "fix",
    "sat",
    "hdop",
    "vdop",
    "pdop",
    "ageofdgpsdata",
    "dgpsid",
    "course",
    "speed",
    "extensions",
];

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
        if root.tag_name().name() != "gpx" {
            let title = format!("the element `{}`", root.tag_name().name());
            self.fault(&root, title, "the element `gpx` around a GPX file");
            return None;
        }
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

    /// Elements `name` of `parent`; others that are not harmless are faults.
    fn children<'a, 'i>(
        &mut self,
        parent: &Node<'a, 'i>,
        name: &str,
        harmless: &[&str],
    ) -> Vec<Node<'a, 'i>> {
        let mut found = Vec::new();
        for child in parent.children().filter(Node::is_element) {
            match child.tag_name().name() {
                tag if tag == name => found.push(child),
                tag if harmless.contains(&tag) => {}
                tag => {
                    let title = format!("unknown element `{tag}` in `{}`", parent.tag_name().name());
                    self.fault(&child, title, &format!("`{name}`, or one of {}", harmless.join(", ")));
                }
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
        for child in point.children().filter(Node::is_element) {
            let tag = child.tag_name().name();
            if !["ele", "time"].contains(&tag) && !OF_POINT.contains(&tag) {
                let expected = format!("ele, time, or one of {}", OF_POINT.join(", "));
                self.fault(&child, format!("unknown element `{tag}` in `trkpt`"), &expected);
            }
        }
        let (latitude, longitude) = (self.angle(point, "lat", 90.0), self.angle(point, "lon", 180.0));
        let time = self.time(point, clock);
        let eye_height = match self.heights {
            Some(Heights::Eye(_)) => Some(self.height(point)?),
            _ => None,
        };
        let at = [latitude?, longitude?].map(radians);
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
        let text = time.text().unwrap_or_default().trim();
        let counted = match date_time(text) {
            Some(moment) => clock.count(Time::Date(moment)),
            None => Err("a date such as 2026-11-26T22:00:00Z".into()),
        };
        counted
            .map_err(|expected| {
                self.fault(&time, format!("`time` must be {expected}, not {}", shown(text)), &expected);
            })
            .ok()
    }

    fn height(&mut self, point: &Node) -> Option<f64> {
        let Some(height) = child(point, "ele") else {
            self.fault(
                point,
                "a track point without a height".into(),
                "`ele`, or `path.heights = \"unused\"`",
            );
            return None;
        };
        let text = height.text().unwrap_or_default().trim();
        let number = text.parse().ok().filter(|number: &f64| number.abs() <= MAX_COORDINATE);
        if number.is_none() {
            let expected = format!("a number of metres from -{MAX_COORDINATE} to {MAX_COORDINATE}");
            self.fault(&height, format!("`ele` must be {expected}, not {}", shown(text)), &expected);
        }
        number
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

fn child<'a, 'i>(node: &Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    node.children().find(|child| child.is_element() && child.tag_name().name() == name)
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
