//! Coordinate systems as well-known text, version 1 (OGC 01-009), as ENVI headers and `.prj` files have them.

mod element;
pub mod words;

use std::path::Path;

use self::element::{Element, parse};
use self::words::{ELEMENTS, PARAMETERS};
use super::map::{self, Kind, Map};
use super::refusal::field;
use super::unit;
use super::words::Fate::Used;
use super::words::{Decider, Met, seen};
use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;

/// Directions of axes that would mirror the ground.
const TURNED: [&str; 3] = ["WEST", "SOUTH", "DOWN"];
/// Most bytes of a text; those of coordinate systems have some thousand.
const MOST_BYTES: usize = 1 << 16;

/// What a unit measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum UnitKind {
    Length,
    Angle,
}

/// A coordinate system as written.
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
        let (root, rest) = parse(text).map_err(|found| damaged(found, "KEYWORD[\"NAME\", ...]"))?;
        if root.inside.is_empty() {
            return Err(damaged(text.to_owned(), "KEYWORD[\"NAME\", ...]"));
        }
        if !rest.trim().is_empty() {
            return Err(damaged(rest.trim().to_owned(), "the end of the coordinate system"));
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
        if keyword == "AXIS"
            && !self.is_around_a_pole()
            && let Some(turned) = element.inside.iter().find(|child| TURNED.contains(&&*child.keyword))
        {
            return Err(self.wrong("AXIS", &turned.keyword, "EAST, NORTH or UP"));
        }
        match fate {
            Some(Used(_)) => element.inside.iter().try_for_each(|child| self.decide(child, decider)),
            _ => Ok(()),
        }
    }

    /// Whether both axes of the map lie along meridians, so that their directions are south or north both.
    fn is_around_a_pole(&self) -> bool {
        let kind = self.root.child("PROJECTION").and_then(|projection| Kind::named(projection.name()));
        matches!(kind, Some(Kind::Polar | Kind::Stereographic))
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

    /// Size of the unit directly inside an element; `usual` where it has none. A name that is known must be of a unit of this kind and of
    /// this size; another name is as good as its number.
    fn unit(&self, element: &Element, usual: f64, kind: UnitKind) -> Result<f64, SurveyError> {
        let Some(unit) = element.child("UNIT") else { return Ok(usual) };
        let size = self.number(unit, 0)?;
        if size <= 0.0 {
            return Err(self.wrong("UNIT", &size.to_string(), "above 0"));
        }
        let [length, angle] = [unit::length(unit.name()), unit::angle(unit.name())];
        let (own, other, expected) = match kind {
            UnitKind::Length => (length, angle, "a unit of length, of which this is the number of metres"),
            UnitKind::Angle => (angle, length, "a unit of angles, of which this is the number of radians"),
        };
        let is_another = own.is_some_and(|own| (size / own - 1.0).abs() > unit::ALIKE);
        if is_another || (own.is_none() && other.is_some()) {
            return Err(self.wrong("UNIT", &format!("{} of {size}", unit.name()), expected));
        }
        Ok(size)
    }

    /// Metres of the unit of the map; none of a system of angles.
    ///
    /// # Errors
    /// If the unit cannot be used.
    pub fn unit_of_map(&self) -> Result<Option<f64>, SurveyError> {
        if self.root.keyword == "GEOGCS" {
            return Ok(None);
        }
        self.unit(&self.root, 1.0, UnitKind::Length).map(Some)
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
        let angle = self.unit(body, quantities::radians(1.0), UnitKind::Angle)?;
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
        let unit = self.unit(&self.root, 1.0, UnitKind::Length)?;
        let name = self.root.child("PROJECTION").map_or("", Element::name);
        let map = Kind::named(name)
            .map(|kind| Ok::<_, SurveyError>((self.map(kind, unit, angle, radius, meridian)?, kind)));
        let projection = map.transpose()?.and_then(|(map, kind)| map.projection(kind));
        let is_at_another_pole = [("north_pole", 1.0), ("south_pole", -1.0)].iter().any(|(pole, side)| {
            canonical(name).ends_with(pole) && projection.is_some_and(|map| map.latitude * side < 0.0)
        });
        if is_at_another_pole {
            return Err(self.wrong("PROJECTION", name, "a pole on the side of its parallel and its origin"));
        }
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use quantities::{degrees, radians};

    use super::System;
    use crate::elevation::{Affine, Frame};
    use crate::read::options::ReadOptions;
    use crate::read::words::Decider;
    use landscape::projection::Method;

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
        unknown("VERT_CS[\"h\",UNIT[\"m\",1]]", "a system of heights");
        unknown("PROJCS[\"m\",UNIT[\"u\",1]]", "a body");
        unknown(&map("Orthographic", "", 0.0), "above 0");
        unknown(&BODY.replace("1737400.0", "-1"), "a radius above 0");
        let named = |unit: &str| map("Orthographic", "", 1.0).replace("UNIT[\"u\", 1]", unit);
        unknown(&named("UNIT[\"Degree\",0.0174532925199433]"), "a unit of length");
        unknown(&named("UNIT[\"Foot_US\",1.0]"), "a unit of length");
        assert!(placed(&named("UNIT[\"Foot_US\",0.304800609601219]")).is_ok());
        unknown(
            &BODY.replace("UNIT[\"Degree\",0.0174532925199433]", "UNIT[\"Meter\",1]"),
            "a unit of angles",
        );
        unknown(
            &BODY.replace("UNIT[\"Degree\",0.0174532925199433]", "UNIT[\"Degree\",1]"),
            "a unit of angles",
        );
        let other = map("Stereographic_North_Pole", "PARAMETER[\"Standard_Parallel_1\",-70],", 1.0);
        unknown(&other, "a pole on the side of its parallel");
        unknown(&map("Orthographic", "AXIS[\"x\",WEST],", 1.0), "EAST, NORTH or UP");
        assert!(placed(&map("Orthographic", "AXIS[\"x\",EAST],", 1.0)).is_ok());
        let polar = "PARAMETER[\"latitude_of_origin\",90],AXIS[\"Easting\",SOUTH],AXIS[\"Northing\",SOUTH],";
        assert!(placed(&map("Polar_Stereographic", polar, 1.0)).is_ok(), "as GDAL writes it");
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
