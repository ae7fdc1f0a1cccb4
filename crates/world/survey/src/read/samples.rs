//! Stored numbers into heights: marks of voids, unit, scale, offset, radii.

use std::path::Path;

use landscape::LUNOID_RADIUS;

use super::doubts::{Marks, PICTURE};
use super::kind::Stored;
use super::options::ReadOptions;
use super::refusal::field;
use super::stretch::Window;
use super::words::seen;
use crate::error::SurveyError;

/// What a file says about its stored numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Said {
    /// Ranges of stored numbers that mark voids, both ends included.
    pub voids: Vec<[f64; 2]>,
    /// Stored numbers beyond these ends are voids; both ends are heights.
    pub valid: [f64; 2],
    /// Least and greatest stored number as the file states them, for comparison only.
    pub stated: [f64; 2],
    /// Metres a stored unit.
    pub scale: f64,
    /// Height of the stored number 0 (m).
    pub offset: f64,
    /// A unit of the heights that is not known: where it stands, and what it is. Scale and offset are then in that unit.
    pub unknown_unit: Option<[String; 2]>,
    /// Radius of the sphere that the file lies on (m).
    pub sphere: f64,
    /// Kind of the stored numbers.
    pub stored: Stored,
}

impl Default for Said {
    fn default() -> Self {
        let any = [f64::NEG_INFINITY, f64::INFINITY];
        Self {
            voids: Vec::new(),
            valid: any,
            stated: any,
            scale: 1.0,
            offset: 0.0,
            unknown_unit: None,
            sphere: LUNOID_RADIUS,
            stored: Stored::default(),
        }
    }
}

/// How a stored number becomes a height.
#[derive(Debug, Clone, PartialEq)]
pub struct Conversion {
    said: Said,
    scale: f64,
    offset: f64,
    /// Whether nobody says that samples of a picture's kind are heights.
    looks_like_picture: bool,
}

/// What a first look at the samples of a file counts.
#[derive(Debug, Default)]
struct Seen {
    /// Samples that are no voids.
    heights: usize,
    /// Of these, those that look like radii.
    radii: usize,
    /// Of these, those beyond [`Said::stated`].
    unstated: usize,
    /// Voids only for lying beyond [`Said::valid`].
    invalid: usize,
    /// Usual marks of voids that the file does not declare.
    marks: Marks,
}

/// Whether a number lies between two that a label prints, perhaps with few digits.
fn between(stored: f64, [low, high]: &[f64; 2]) -> bool {
    let slack = |end: f64| if end.is_finite() { ROUNDING * end.abs() } else { 0.0 };
    (low - slack(*low)..=high + slack(*high)).contains(&stored)
}

fn within(stored: f64, [low, high]: &[f64; 2]) -> bool {
    (*low..=*high).contains(&stored)
}

/// Relative difference of a printed number from the one that was meant.
const ROUNDING: f64 = 1e-6;

/// Relative distance from a sphere within which a number is taken as a radius.
const NEAR: f64 = 0.02;

fn is_radius(value: f64, sphere: f64) -> bool {
    (value / sphere - 1.0).abs() < NEAR
}

/// Radius from which heights count: that of the lunoid for files of the Moon, else that of the file's own sphere.
fn reference(sphere: f64) -> f64 {
    if is_radius(sphere, LUNOID_RADIUS) { LUNOID_RADIUS } else { sphere }
}

impl Conversion {
    /// From what the file says, where the user does not say otherwise. An offset near the radius of the sphere makes
    /// radii; heights count from the sphere, so its radius is taken off again.
    pub fn new(path: &Path, options: &ReadOptions, mut said: Said) -> Result<Self, SurveyError> {
        check_unit(path, options, &said)?;
        let scale = options.scale.unwrap_or(said.scale);
        let offset = options.offset.unwrap_or(said.offset);
        if !(scale.is_finite() && scale != 0.0 && offset.is_finite()) {
            return Err(field(
                path,
                "scale and offset",
                format!("{scale} and {offset}"),
                "finite numbers, the scale other than 0",
                "give --scale and --offset",
            ));
        }
        if !options.no_data.is_empty() {
            said.voids = options.no_data.iter().map(|value| [*value; 2]).collect();
            said.valid = Said::default().valid;
        }
        if said.stored == Stored::F32 {
            let rounded = |value: &mut f64| *value = f64::from(*value as f32);
            said.voids.iter_mut().chain([&mut said.valid, &mut said.stated]).flatten().for_each(rounded);
        }
        let offset = if is_radius(offset, said.sphere) { offset - reference(said.sphere) } else { offset };
        let is_plain = options.scale.is_none() && scale == 1.0 && offset == 0.0;
        let looks_like_picture = said.stored == Stored::Byte && is_plain;
        Ok(Self { said, scale, offset, looks_like_picture })
    }

    /// Stored numbers of a window of the file into heights (m), NaN for a void. Radii become heights. What is left must lie within
    /// half a lunar radius of the sphere, so that no mark of a void that the file forgot to declare is taken as ground.
    /// The notes say what was assumed.
    ///
    /// # Errors
    /// If a sample is no height: with its line, its column and its stored number.
    pub fn convert(
        &self,
        path: &Path,
        samples: &mut [f64],
        window: &Window,
    ) -> Result<Vec<String>, SurveyError> {
        let seen = self.look(samples);
        let are_radii = 2 * seen.radii > seen.heights;
        let base = if are_radii { reference(self.said.sphere) } else { 0.0 };
        for (index, sample) in samples.iter_mut().enumerate() {
            let height = if self.is_void(*sample) { f64::NAN } else { self.height(*sample) };
            let is_right = match are_radii {
                true => is_radius(height, self.said.sphere),
                false => height.abs() <= 0.5 * LUNOID_RADIUS,
            };
            if !height.is_nan() && !is_right {
                let columns = window.columns.len();
                let (line, column) =
                    (window.lines.start + index / columns, window.columns.start + index % columns);
                return Err(self.no_height(path, line, column, *sample));
            }
            *sample = height - base;
        }
        Ok(self.notes(&seen, base, samples))
    }

    /// Whether a stored number marks a void. Minus infinity does: exports write it where they mean "none".
    fn is_void(&self, stored: f64) -> bool {
        let is_marked = self.said.voids.iter().any(|range| within(stored, range));
        stored.is_nan() || stored == f64::NEG_INFINITY || is_marked || !between(stored, &self.said.valid)
    }

    /// Height (m) of a stored number that is no void, before radii are taken off.
    fn height(&self, stored: f64) -> f64 {
        stored * self.scale + self.offset
    }

    fn look(&self, samples: &[f64]) -> Seen {
        let mut seen = Seen::default();
        for &stored in samples {
            if self.is_void(stored) {
                seen.invalid += usize::from(stored.is_finite() && !between(stored, &self.said.valid));
                continue;
            }
            seen.heights += 1;
            seen.marks.meet(stored);
            seen.radii += usize::from(is_radius(self.height(stored), self.said.sphere));
            seen.unstated += usize::from(!between(stored, &self.said.stated));
        }
        seen
    }

    fn notes(&self, seen: &Seen, base: f64, heights: &[f64]) -> Vec<String> {
        let beyond = |count: usize, [low, high]: [f64; 2], what: &str| {
            (count > 0).then(|| format!("{count} samples lie beyond {low} to {high}, {what}"))
        };
        let valid = beyond(seen.invalid, self.said.valid, "the valid numbers of the file: they are voids");
        let stated = "the least and greatest number that the file states: if they mark voids, give --no-data";
        let stated = beyond(seen.unstated, self.said.stated, stated);
        let radii = (base != 0.0)
            .then(|| format!("the samples are radii: heights are what they have above {base} m"));
        let in_km = |height: &f64| height.is_nan() || (height - 1e-3 * LUNOID_RADIUS).abs() < 11.0;
        let in_km = (seen.heights > 0 && heights.iter().all(in_km))
            .then(|| "all heights lie near 1737.4 m: if they are radii in km, give --scale 1000".to_owned());
        let marks = seen.marks.note(&self.declared());
        let picture = self.looks_like_picture.then(|| PICTURE.to_owned());
        [valid, stated, radii, in_km, marks, picture].into_iter().flatten().collect()
    }

    /// Single marks of voids that are known already.
    fn declared(&self) -> Vec<f64> {
        self.said.voids.iter().filter(|[low, high]| low == high).map(|[value, _]| *value).collect()
    }

    /// The error for a stored number that is no height. Its advice keeps the marks of voids that are known already.
    fn no_height(&self, path: &Path, line: usize, column: usize, value: f64) -> SurveyError {
        let voids = [self.declared(), vec![value]].concat();
        SurveyError::NotFinite { path: path.to_path_buf(), line, column, value, voids }
    }
}

/// A unit that is not known needs a scale of the user, and an offset if there is one.
fn check_unit(path: &Path, options: &ReadOptions, said: &Said) -> Result<(), SurveyError> {
    let Some([place, found]) = &said.unknown_unit else { return Ok(()) };
    let needs_offset = said.offset != 0.0;
    if options.scale.is_some() && (options.offset.is_some() || !needs_offset) {
        return Ok(());
    }
    let offset = if needs_offset { " and --offset METRES" } else { "" };
    let advice = format!("give --scale METRES{offset}, metres a stored unit");
    Err(field(path, place, seen(found), "a unit of length that is known here", advice))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Conversion, ReadOptions, Said, Stored, Window};

    fn said(void: f64, offset: f64) -> Said {
        Said { voids: vec![[void; 2]], scale: 0.5, offset, ..Said::default() }
    }

    fn converted(said: Said, stored: &[f64]) -> Result<(Vec<f64>, Vec<String>), String> {
        let conversion = Conversion::new(Path::new("x"), &ReadOptions::default(), said).unwrap();
        let mut samples = stored.to_vec();
        let window = Window { lines: 0..stored.len().div_ceil(2), columns: 0..2 };
        let notes =
            conversion.convert(Path::new("x"), &mut samples, &window).map_err(|error| error.to_string())?;
        Ok((samples, notes))
    }

    fn heights(said: Said, stored: &[f64]) -> Vec<f64> {
        converted(said, stored).unwrap().0
    }

    #[test]
    fn no_data_is_compared_in_the_stored_type() {
        // The decimal text of an f32 no-data value is not the f64 that the sample converts to.
        let as_text = -3.4028226550889045e38;
        let stored = f64::from(as_text as f32);
        assert_ne!(stored, -3.40282265508890e38);
        let said = Said { stored: Stored::F32, ..said(-3.40282265508890e38, 0.0) };
        assert!(heights(said, &[stored, 1.0])[0].is_nan());
    }

    #[test]
    fn an_offset_of_a_radius_is_taken_off() {
        assert_eq!(heights(said(-1.0, 1_737_400.0), &[21_008.0]), [10_504.0]);
        assert_eq!(heights(said(-1.0, 100.0), &[10.0]), [105.0]);
        let mars = Said { sphere: 3_396_190.0, ..said(-1.0, 3_396_190.0) };
        assert_eq!(heights(mars, &[10.0]), [5.0]);
    }

    #[test]
    fn samples_that_are_radii_become_heights() {
        let stored = [3_470_100.0, -1.0, 3_474_000.0, 3_478_000.0];
        let (heights_of, notes) = converted(said(-1.0, 0.0), &stored).unwrap();
        assert_eq!([heights_of[0], heights_of[2], heights_of[3]], [-2350.0, -400.0, 1600.0]);
        assert!(heights_of[1].is_nan() && notes[0].contains("radii"), "{notes:?}");
        let earth = Said { sphere: 6_378_137.0, ..said(-1.0, 0.0) };
        assert_eq!(heights(earth, &[12_756_274.0 + 20.0; 4]), [10.0; 4]);
        let kilometres = converted(said(-1.0, 0.0), &[3470.1, 3474.8]).unwrap().1;
        assert!(kilometres[0].contains("--scale 1000"), "{kilometres:?}");
    }

    #[test]
    fn radii_with_an_undeclared_void_are_refused_with_a_way_out() {
        let error = converted(said(-1.0, 0.0), &[3_470_100.0, 3_470_200.0, -1.0, 7.1]).unwrap_err();
        assert!(error.contains("line 1, column 1") && error.contains("--no-data -1.0,7.1"), "{error}");
    }

    #[test]
    fn infinities() {
        assert!(heights(said(-1.0, 0.0), &[f64::NEG_INFINITY])[0].is_nan());
        assert!(converted(said(-1.0, 0.0), &[1.0, f64::INFINITY]).unwrap_err().contains("column 1"));
        assert!(heights(said(f64::INFINITY, 0.0), &[f64::INFINITY])[0].is_nan());
    }

    #[test]
    fn a_void_that_nothing_declares_is_no_height() {
        let error = converted(said(-1.0, 0.0), &[-3.4028234663852886e38, 1.0, 2.0, 3.0]).unwrap_err();
        assert!(error.contains("line 0, column 0"), "{error}");
        assert_eq!(heights(said(-1.0, 0.0), &[1_737_000.0; 2]), [868_500.0; 2]);
    }

    #[test]
    fn invalid_and_unstated_numbers_are_told() {
        let said = Said { valid: [0.0, 9.0], stated: [1.0, 8.0], ..said(-1.0, 0.0) };
        let (heights, notes) = converted(said, &[-3.0, 0.0, 9.0, 8.000_001]).unwrap();
        assert!(heights[0].is_nan() && heights[1..3] == [0.0, 4.5], "{heights:?}");
        assert!(notes[0].starts_with("1 samples lie beyond 0 to 9") && notes[1].starts_with("2 samples"));
    }

    #[test]
    fn a_second_mark_and_samples_of_a_picture_are_told() {
        let plain = |stored| Said { scale: 1.0, stored, ..said(-9999.0, 0.0) };
        let (heights, notes) = converted(plain(Stored::Other), &[1.0, -9999.0, -32768.0, 9.0]).unwrap();
        assert!(heights[1].is_nan() && heights[2] == -32768.0);
        assert!(notes.len() == 1 && notes[0].contains("--no-data -9999.0,-32768.0"), "{notes:?}");
        let (_, notes) = converted(plain(Stored::Byte), &[1.0, 2.0]).unwrap();
        assert!(notes.len() == 1 && notes[0].contains("as those of a picture"), "{notes:?}");
        assert!(converted(said(-1.0, 0.0), &[1.0, 2.0]).unwrap().1.is_empty());
        let options = ReadOptions { scale: Some(1.0), ..ReadOptions::default() };
        assert!(!Conversion::new(Path::new("x"), &options, plain(Stored::Byte)).unwrap().looks_like_picture);
    }

    #[test]
    fn an_unknown_unit_needs_a_scale() {
        let degrees = Some(["UNIT".to_owned(), "DEGREE".to_owned()]);
        let with = |scale, offset, said: Said| {
            let options = ReadOptions { scale, offset, ..ReadOptions::default() };
            Conversion::new(Path::new("x"), &options, said).map_err(|error| error.to_string())
        };
        let plain = Said { unknown_unit: degrees.clone(), ..Said::default() };
        assert!(with(None, None, plain.clone()).unwrap_err().contains("give --scale METRES,"));
        assert!(with(Some(2.0), None, plain).is_ok());
        let offset = Said { unknown_unit: degrees, ..said(-1.0, 5.0) };
        assert!(with(Some(2.0), None, offset.clone()).unwrap_err().contains("and --offset METRES"));
        assert!(with(Some(2.0), Some(0.0), offset).is_ok());
    }
}
