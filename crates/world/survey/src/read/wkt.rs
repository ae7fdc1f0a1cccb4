//! Coordinate systems as well-known text, version 1 (OGC 01-009), as ENVI headers and `.prj` files have them.

use std::path::Path;

use super::map::{self, Kind, Map};
use super::refusal::field;
use super::words::Fate::{Harmless, Only, Refused, Used};
use super::words::{Decider, Met, Vocabulary, named, seen};
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;

/// Elements of well-known text.
pub const ELEMENTS: Vocabulary = Vocabulary {
    kind: "element of well-known text",
    prefix: "wkt:",
    words: &[
        named("PROJCS", Used("a map; its unit is the one directly inside")),
        named("GEOGCS", Used("the body; its unit is that of angles")),
        named("DATUM", Used("the spheroid is in it")),
        named("SPHEROID", Used("radius and flattening; a note tells of an ellipsoid")),
        named("ELLIPSOID", Used("as SPHEROID")),
        named("PRIMEM", Used("longitude of the prime meridian, which is added")),
        named("UNIT", Used("metres of a unit of the map, or radians of a unit of angles")),
        named(
            "PROJECTION",
            Used("kind of the map; the metres of an unknown one are taken as they are, with a note"),
        ),
        named("PARAMETER", Used("a figure of the map, decided by its own table")),
        named("AUTHORITY", Harmless("a code of the same system")),
        named("AXIS", Harmless("names of the axes; the order is that of the file's format")),
        named("EXTENSION", Harmless("the same system in another language")),
        named("METADATA", Harmless("text")),
        named("TOWGS84", Harmless("a shift to another system of the Earth")),
        named("GEOCCS", Refused("coordinates from the centre of the body")),
        named("LOCAL_CS", Refused("axes that are tied to nothing")),
        named("COMPD_CS", Refused("a system of heights of its own")),
        named("VERT_CS", Refused("a system of heights of its own")),
        named("VERTCS", Refused("a system of heights of its own")),
        named("FITTED_CS", Refused("a system within another one")),
        named("PROJCRS", Refused("well-known text of version 2")),
        named("GEOGCRS", Refused("well-known text of version 2")),
        named("GEODCRS", Refused("well-known text of version 2")),
    ],
};

/// Parameters of a map, by the letters of their names.
pub const PARAMETERS: Vocabulary = Vocabulary {
    kind: "parameter of a map in well-known text",
    prefix: "parameter:",
    words: &[
        named("false_easting", Used("easting of the origin")),
        named("false_northing", Used("northing of the origin")),
        named("central_meridian", Used("longitude of the origin")),
        named("longitude_of_center", Used("longitude of the origin")),
        named("longitude_of_origin", Used("longitude of the origin")),
        named("longitude_of_natural_origin", Used("longitude of the origin")),
        named("latitude_of_origin", Used("latitude of the origin, or of true scale in a polar map")),
        named("latitude_of_center", Used("as latitude_of_origin")),
        named("latitude_of_natural_origin", Used("as latitude_of_origin")),
        named("standard_parallel_1", Used("parallel that is true to scale")),
        named("latitude_of_1st_standard_parallel", Used("as standard_parallel_1")),
        named("latitude_of_standard_parallel", Used("as standard_parallel_1")),
        named("standard_parallel_2", Used("refused if it is another than standard_parallel_1")),
        named("scale_factor", Used("scale at the pole; 1 in other maps, else refused")),
        named("scale_factor_at_natural_origin", Used("as scale_factor")),
        named("azimuth", Only(&["0", "90"], "a turned map")),
        named("rectified_grid_angle", Only(&["0", "90"], "a turned map")),
    ],
};

/// Most elements within one another; those of coordinate systems have five.
const MOST_NESTED: usize = 16;
/// Most bytes of a text; those of coordinate systems have some thousand.
const MOST_BYTES: usize = 1 << 16;

/// An element: its keyword, its text and numbers in order, and the elements inside it.
#[derive(Debug, Clone, PartialEq, Default)]
struct Element {
    keyword: String,
    texts: Vec<String>,
    numbers: Vec<f64>,
    inside: Vec<Element>,
}

impl Element {
    fn child(&self, keyword: &str) -> Option<&Element> {
        self.inside.iter().find(|child| child.keyword == keyword)
    }

    /// The first element of a keyword at any depth, itself included.
    fn find(&self, keyword: &str) -> Option<&Element> {
        if self.keyword == keyword {
            return Some(self);
        }
        self.inside.iter().find_map(|child| child.find(keyword))
    }

    fn name(&self) -> &str {
        self.texts.first().map_or("", String::as_str)
    }
}

/// A coordinate system.
#[derive(Debug)]
pub struct System<'a> {
    path: &'a Path,
    /// What the text is, for messages.
    place: String,
    root: Element,
}

impl<'a> System<'a> {
    /// Reads and decides a text that stands in `place` of a file.
    ///
    /// # Errors
    /// If the text is damaged, or one of its elements or parameters is refused or unknown.
    pub fn of(path: &'a Path, place: &str, text: &str, decider: &mut Decider) -> Result<Self, SurveyError> {
        let damaged = |found: String, expected: &str| {
            field(path, place, seen(&found), expected, "write it again with gdal_translate")
        };
        if text.len() > MOST_BYTES {
            return Err(damaged(format!("{} bytes", text.len()), "at most 65536 bytes of well-known text"));
        }
        let mut reader = Reader { rest: text, depth: 0 };
        let root = reader.element().map_err(|found| damaged(found, "KEYWORD[\"NAME\", ...]"))?;
        if !reader.rest.trim().is_empty() {
            return Err(damaged(reader.rest.trim().to_owned(), "the end of the coordinate system"));
        }
        let system = Self { path, place: place.to_owned(), root };
        system.decide(&system.root, decider)?;
        Ok(system)
    }

    fn decide(&self, element: &Element, decider: &mut Decider) -> Result<(), SurveyError> {
        let keyword = &element.keyword;
        let place = format!("{}, {}", self.place, seen(keyword));
        let word = ELEMENTS.of_name(keyword);
        let fate = decider.decide(Met {
            of: &ELEMENTS,
            word,
            place: &place,
            name: keyword,
            value: element.name(),
        })?;
        if keyword == "PARAMETER" {
            let name = canonical(element.name());
            let value = element.numbers.first().map_or("nothing".into(), f64::to_string);
            let place = format!("{place} {}", seen(element.name()));
            let word = PARAMETERS.of_name(&name);
            decider.decide(Met { of: &PARAMETERS, word, place: &place, name: &name, value: &value })?;
        }
        match fate {
            Some(Used(_)) => element.inside.iter().try_for_each(|child| self.decide(child, decider)),
            _ => Ok(()),
        }
    }

    fn wrong(&self, what: &str, found: &str, expected: &str) -> SurveyError {
        let advice = "convert the file with gdalwarp -t_srs";
        field(self.path, format!("{}, {what}", self.place), seen(found), expected, advice)
    }

    /// A number of an element, which must be finite.
    fn number(&self, element: &Element, at: usize) -> Result<f64, SurveyError> {
        let number = element.numbers.get(at).copied().filter(|number| number.is_finite());
        number.ok_or_else(|| self.wrong(&element.keyword, element.name(), "a finite number behind its name"))
    }

    /// Size of the unit directly inside an element; `usual` where it has none.
    fn unit(&self, element: &Element, usual: f64) -> Result<f64, SurveyError> {
        let Some(unit) = element.child("UNIT") else { return Ok(usual) };
        let size = self.number(unit, 0)?;
        Some(size).filter(|size| *size > 0.0).ok_or_else(|| self.wrong("UNIT", &size.to_string(), "above 0"))
    }

    /// The place of samples on a grid in units of the system, and its frame. Notes tell of an ellipsoid and of a map that
    /// is not known.
    ///
    /// # Errors
    /// If the system has no body, or figures that cannot be used.
    pub fn place(&self, grid: Affine, notes: &mut Vec<String>) -> Result<(Affine, Frame), SurveyError> {
        let body = self.root.find("GEOGCS").ok_or_else(|| self.wrong("GEOGCS", "nothing", "a body"))?;
        let spheroid = body.find("SPHEROID").or_else(|| body.find("ELLIPSOID"));
        let spheroid = spheroid.ok_or_else(|| self.wrong("SPHEROID", "nothing", "a radius"))?;
        let radius = self.number(spheroid, 0)?;
        if radius <= 0.0 {
            return Err(self.wrong("SPHEROID", &radius.to_string(), "a radius above 0"));
        }
        let inverse = spheroid.numbers.get(1).copied().filter(|inverse| *inverse != 0.0);
        notes.extend(inverse.and_then(|inverse| map::flattened(radius, radius * (1.0 - inverse.recip()))));
        let angle = self.unit(body, quantities::radians(1.0))?;
        let meridian = body.child("PRIMEM").map_or(Ok(0.0), |meridian| self.number(meridian, 0))? * angle;
        let in_units = |unit: f64| Affine {
            first: grid.first.map(|value| value * unit),
            step: grid.step.map(|value| value * unit),
        };
        if self.root.keyword == "GEOGCS" {
            let mut affine = in_units(angle);
            affine.first[1] += meridian;
            return Ok((affine, Frame::Geographic { radius }));
        }
        let unit = self.unit(&self.root, 1.0)?;
        let name = self.root.child("PROJECTION").map_or("", Element::name);
        let map = Kind::named(name)
            .map(|kind| Ok::<_, SurveyError>((self.map(kind, unit, angle, radius, meridian)?, kind)));
        let projection = map.transpose()?.and_then(|(map, kind)| map.projection(kind));
        if projection.is_none() {
            notes.push(map::unknown(name));
        }
        Ok((in_units(unit), Frame::Plane(projection)))
    }

    /// The first of some parameters that is there.
    fn parameter(&self, names: &[&str]) -> Result<Option<f64>, SurveyError> {
        let is_one = |child: &&Element| {
            child.keyword == "PARAMETER" && names.contains(&canonical(child.name()).as_str())
        };
        let mut found = self.root.inside.iter().filter(is_one);
        let first = found.next().map(|parameter| self.number(parameter, 0)).transpose()?;
        match found.next() {
            Some(second) => Err(self.wrong("PARAMETER", second.name(), "one parameter of a meaning")),
            None => Ok(first),
        }
    }

    fn map(&self, kind: Kind, unit: f64, angle: f64, radius: f64, meridian: f64) -> Result<Map, SurveyError> {
        let parallel = self.parameter(&[
            "standard_parallel_1",
            "latitude_of_1st_standard_parallel",
            "latitude_of_standard_parallel",
        ])?;
        let second = self.parameter(&["standard_parallel_2"])?;
        if let Some(second) = second.filter(|second| parallel != Some(*second)) {
            return Err(self.wrong("standard_parallel_2", &second.to_string(), "standard_parallel_1"));
        }
        let scale = self.parameter(&["scale_factor", "scale_factor_at_natural_origin"])?.unwrap_or(1.0);
        if scale != 1.0 && !matches!(kind, Kind::Polar | Kind::Stereographic) {
            return Err(self.wrong("scale_factor", &scale.to_string(), "1 in this map"));
        }
        let longitudes =
            ["central_meridian", "longitude_of_center", "longitude_of_origin", "longitude_of_natural_origin"];
        let latitude =
            self.parameter(&["latitude_of_origin", "latitude_of_center", "latitude_of_natural_origin"])?;
        Ok(Map {
            latitude: latitude.map(|latitude| latitude * angle),
            longitude: self.parameter(&longitudes)?.unwrap_or(0.0) * angle + meridian,
            parallel: parallel.map(|parallel| parallel * angle),
            scale,
            radius,
            offset: [
                self.parameter(&["false_northing"])?.unwrap_or(0.0) * unit,
                self.parameter(&["false_easting"])?.unwrap_or(0.0) * unit,
            ],
        })
    }
}

/// The name of a parameter in small letters, with `_` for spaces.
fn canonical(name: &str) -> String {
    name.trim().to_ascii_lowercase().replace(' ', "_")
}

/// Reads elements from the front of a text.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    /// The next element; the error is what stands in place of one.
    fn element(&mut self) -> Result<Element, String> {
        let keyword = self.word();
        if keyword.is_empty() || !keyword.starts_with(|first: char| first.is_ascii_alphabetic()) {
            return Err(self.found(&keyword));
        }
        let mut element = Element { keyword: keyword.to_ascii_uppercase(), ..Element::default() };
        if !self.takes(&['[', '(']) {
            // A bare word, as the direction of an axis.
            element.texts.push(keyword);
            return Ok(element);
        }
        self.depth += 1;
        if self.depth > MOST_NESTED {
            return Err(format!("{} elements within one another", self.depth));
        }
        loop {
            self.value(&mut element)?;
            if self.takes(&[']', ')']) {
                self.depth -= 1;
                return Ok(element);
            }
            if !self.takes(&[',']) {
                return Err(self.found(&element.keyword));
            }
        }
    }

    fn value(&mut self, element: &mut Element) -> Result<(), String> {
        let rest = self.rest.trim_start();
        if let Some(quoted) = rest.strip_prefix('"') {
            let (text, after) = quoted.split_once('"').ok_or_else(|| self.found(&element.keyword))?;
            element.texts.push(text.to_owned());
            self.rest = after;
            return Ok(());
        }
        if rest.starts_with(|first: char| first.is_ascii_alphabetic()) {
            element.inside.push(self.element()?);
            return Ok(());
        }
        let word = self.word();
        element.numbers.push(word.parse().map_err(|_| self.found(&word))?);
        Ok(())
    }

    /// Letters, digits and what numbers are made of.
    fn word(&mut self) -> String {
        let rest = self.rest.trim_start();
        let is_part = |c: char| c.is_ascii_alphanumeric() || "_+-.".contains(c);
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        self.rest = &rest[end..];
        rest[..end].to_owned()
    }

    /// Whether one of these characters comes next, which is then taken.
    fn takes(&mut self, marks: &[char]) -> bool {
        let after = self.rest.trim_start().strip_prefix(marks);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    fn found(&self, before: &str) -> String {
        format!("{before}{}", self.rest.chars().take(40).collect::<String>())
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use quantities::{degrees, radians};

    use super::System;
    use crate::elevation::{Affine, Frame};
    use crate::projection::Method;
    use crate::read::options::ReadOptions;
    use crate::read::words::Decider;

    const BODY: &str = r#"GEOGCS["Moon",DATUM["D_Moon",SPHEROID["Moon",1737400.0,0.0]],PRIMEM["Reference",0],UNIT["Degree",0.0174532925199433]]"#;

    fn placed(text: &str) -> Result<(Affine, Frame, Vec<String>), String> {
        let options = ReadOptions::default();
        let (mut decider, mut notes) = (Decider::new(Path::new("x.prj"), &options), Vec::new());
        let grid = Affine { first: [2.0, 3.0], step: [-1.0, 1.0] };
        let system = System::of(Path::new("x.prj"), "text", text, &mut decider);
        let place =
            system.and_then(|system| system.place(grid, &mut notes)).map_err(|error| error.to_string())?;
        Ok((place.0, place.1, notes))
    }

    fn map(projection: &str, parameters: &str, unit: f64) -> String {
        format!("PROJCS[\"m\", {BODY}, PROJECTION[\"{projection}\"], {parameters} UNIT[\"u\", {unit}]]")
    }

    #[test]
    fn bodies_and_maps() {
        let (affine, frame, notes) = placed(BODY).unwrap();
        assert_eq!(frame, Frame::Geographic { radius: 1_737_400.0 });
        assert!((degrees(affine.first[1]) - 3.0).abs() < 1e-9 && notes.is_empty());
        let east = BODY.replace("\"Reference\",0", "\"Reference\",12.5");
        assert!((degrees(placed(&east).unwrap().0.first[1]) - 15.5).abs() < 1e-9);
        let flat = map(
            "Equidistant_Cylindrical",
            "PARAMETER[\"Standard_Parallel_1\",20],PARAMETER[\"False_Easting\",7],",
            1000.0,
        );
        let (affine, frame, _) = placed(&flat).unwrap();
        let Frame::Plane(Some(found)) = frame else { panic!("{frame:?}") };
        assert_eq!((affine.first, found.offset), ([2000.0, 3000.0], [0.0, 7000.0]));
        assert!(
            matches!(found.method, Method::Equirectangular { parallel } if (parallel - radians(20.0)).abs() < 1e-12)
        );
        let south =
            placed(&map("Stereographic_South_Pole", "PARAMETER[\"Standard_Parallel_1\",-90.0],", 1.0))
                .unwrap();
        assert!(matches!(south.1, Frame::Plane(Some(p)) if p.latitude < 0.0));
        let (_, frame, notes) = placed(&map("Sinusoidal", "", 1.0)).unwrap();
        assert!(frame == Frame::Plane(None) && notes[0].contains("Sinusoidal"), "{notes:?}");
    }

    #[test]
    fn what_is_not_understood_is_refused() {
        let unknown = |text: &str, part: &str| {
            let said = placed(text).unwrap_err();
            assert!(said.contains(part), "{said}");
        };
        unknown(&map("Orthographic", "PARAMETER[\"Skew\",1],", 1.0), "--ignore parameter:skew");
        unknown(&BODY.replace("PRIMEM", "PRIMUM"), "--ignore wkt:PRIMUM");
        unknown(&map("Orthographic", "PARAMETER[\"scale_factor\",2],", 1.0), "1 in this map");
        unknown("VERT_CS[\"h\"]", "a system of heights");
        unknown("PROJCS[\"m\",UNIT[\"u\",1]]", "a body");
        unknown(&map("Orthographic", "", 0.0), "above 0");
        unknown(&BODY.replace("1737400.0", "-1"), "a radius above 0");
    }

    #[test]
    fn damaged_texts_are_refused() {
        for text in [
            "",
            "GEOGCS",
            "GEOGCS[",
            "GEOGCS[\"a",
            "GEOGCS[\"a\"",
            "GEOGCS[\"a\",]",
            "[1]",
            "GEOGCS[\"a\",x1y,2 3]",
        ] {
            assert!(placed(text).is_err(), "{text}");
        }
        assert!(placed(&format!("{BODY}]")).unwrap_err().contains("the end"));
        assert!(placed(&"A[".repeat(100_000)).unwrap_err().contains("at most 65536"));
        assert!(placed(&"A[".repeat(30_000)).unwrap_err().contains("17 elements within one another"));
    }
}
