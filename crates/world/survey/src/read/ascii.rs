//! Arc ASCII grids: a head of keys, then all numbers as text, from north to south; a `.prj` beside it has the map (Esri, "ASCII
//! raster"; GDAL writes `dx` and `dy` where samples are no squares).

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

use landscape::LUNOID_RADIUS;

use super::bands;
use super::beside::with_ending;
use super::gate;
use super::opened::{Opened, Samples};
use super::options::ReadOptions;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::stretch::Window;
use super::wkt::System;
use super::words::Fate::{Used, Void};
use super::words::{Decider, Met, Vocabulary, named, seen};
use crate::elevation::{Affine, Frame, Grid};
use crate::error::SurveyError;

/// Keys of the head.
pub const KEYS: Vocabulary = Vocabulary {
    kind: "key of an Arc ASCII grid",
    prefix: "",
    words: &[
        named("ncols", Used("samples of a line")),
        named("nrows", Used("lines of samples")),
        named("xllcorner", Used("easting of the south-west corner of the south-west sample")),
        named("yllcorner", Used("northing of the south-west corner of the south-west sample")),
        named("xllcenter", Used("easting of the centre of the south-west sample")),
        named("yllcenter", Used("northing of the centre of the south-west sample")),
        named("cellsize", Used("spacing of the samples")),
        named("dx", Used("spacing to the east, as GDAL writes it")),
        named("dy", Used("spacing to the north, as GDAL writes it")),
        named("NODATA_value", Void("number that is a void; -9999 without it, with a note")),
    ],
};

/// Void of a grid that names none (Esri).
const USUAL_VOID: f64 = -9999.0;
/// Most characters of a number or key.
const MOST_CHARACTERS: usize = 400;
/// Most keys of a head.
const MOST_KEYS: usize = 32;
/// Most bytes of a `.prj`.
const MOST_PRJ: u64 = 1 << 16;

/// Whether a file begins like a grid.
pub fn is_grid(start: &[u8]) -> bool {
    let start = String::from_utf8_lossy(text::without_byte_order_mark(start)).to_ascii_lowercase();
    let key = start.split_whitespace().next().unwrap_or_default();
    ["ncols", "nrows", "xllcorner", "yllcorner", "xllcenter", "yllcenter"].contains(&key)
}

/// Opens a grid: reads its header.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    bands::of_raw(path, options, 1)?;
    options.expect_no_place()?;
    let (_, bytes) = gate::open(path)?;
    let mut decider = Decider::new(path, options);
    let head = Head::read(path, &mut decider)?;
    let [lines, columns] = [head.count("nrows")?, head.count("ncols")?];
    let count = check_raster(path, lines, columns)? as u64;
    let expected = count.saturating_mul(2).saturating_sub(1);
    if bytes < expected {
        let place = format!("{lines} lines of {columns} numbers");
        return Err(SurveyError::Truncated { path: path.to_path_buf(), place, found: bytes, expected });
    }
    let size = [lines as usize, columns as usize];
    let grid = head.grid(size[0])?;
    let mut notes = Vec::new();
    let mut sources = vec![path.to_path_buf()];
    let (affine, frame) = match with_ending(path, "prj")? {
        Some(prj) => {
            let text = gate::front(&prj, MOST_PRJ + 1)?;
            let text = String::from_utf8_lossy(text::without_byte_order_mark(&text));
            let place =
                System::of(&prj, "coordinate system", text.trim(), &mut decider)?.place(grid, &mut notes)?;
            sources.insert(0, prj);
            place
        }
        None => {
            notes.push(
                "there is no .prj beside the grid: its coordinates are taken as metres of an unknown map"
                    .into(),
            );
            (grid, Frame::Plane(None))
        }
    };
    notes.push("the grid does not name the unit of its heights: metres are assumed".into());
    let void = head.number("NODATA_value")?;
    if void.is_none() && options.no_data.is_empty() {
        notes.push(format!("the grid does not name its NODATA_value: {USUAL_VOID} is a void"));
    }
    notes.extend(decider.finish()?);
    let voids = vec![[void.unwrap_or(USUAL_VOID); 2]];
    let said = Said { voids, sphere: frame.sphere().unwrap_or(LUNOID_RADIUS), ..Said::default() };
    Ok(Opened {
        grid: Grid { lines: size[0], columns: size[1], affine, frame },
        path: path.to_path_buf(),
        title: String::new(),
        sources,
        notes,
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(Numbers { path: path.to_path_buf(), size, first: head.words }),
    })
}

/// The keys of a grid.
struct Head<'a> {
    path: &'a Path,
    /// Key, value and line of each.
    entries: Vec<(String, String, usize)>,
    /// Words of the file that are keys and their values.
    words: usize,
}

impl<'a> Head<'a> {
    fn read(path: &'a Path, decider: &mut Decider) -> Result<Self, SurveyError> {
        let (mut reader, mut entries) = (Words::open(path)?, Vec::<(String, String, usize)>::new());
        while let Some((key, at)) = reader.next()? {
            if !key.starts_with(|first: char| first.is_ascii_alphabetic()) || is_nan(&key) {
                break;
            }
            let damaged = |found: &str, expected: &str| {
                let advice = "the head is damaged: correct it or fetch it again";
                Err(field(path, format!("line {}, {}", at[0], seen(&key)), seen(found), expected, advice))
            };
            let Some((value, _)) = reader.next()? else { return damaged("the end of the file", "a value") };
            let (word, place) = (KEYS.of_name(&key), format!("line {}, {}", at[0], seen(&key)));
            decider.decide(Met { of: &KEYS, word, place: &place, name: &key, value: &value })?;
            if entries.iter().any(|(before, _, _)| before.eq_ignore_ascii_case(&key)) {
                return damaged(&value, "one value of a key");
            }
            if entries.len() == MOST_KEYS {
                return damaged("one more key", "at most 32 keys");
            }
            entries.push((key, value, at[0]));
        }
        let words = 2 * entries.len();
        Ok(Self { path, entries, words })
    }

    fn entry(&self, key: &str) -> Option<&(String, String, usize)> {
        self.entries.iter().find(|(found, _, _)| found.eq_ignore_ascii_case(key))
    }

    fn wrong(&self, key: &str, expected: &str) -> SurveyError {
        let (found, line) =
            self.entry(key).map_or(("nothing", 1), |(_, value, line)| (value.as_str(), *line));
        let advice = "the head is damaged or of a kind not read here";
        field(self.path, format!("line {line}, {key}"), seen(found), expected, advice)
    }

    fn number(&self, key: &str) -> Result<Option<f64>, SurveyError> {
        let Some((_, value, _)) = self.entry(key) else { return Ok(None) };
        let number = value.parse::<f64>().ok().filter(|number| number.is_finite() || is_nan(value));
        number.map(Some).ok_or_else(|| self.wrong(key, "a number"))
    }

    fn count(&self, key: &str) -> Result<u64, SurveyError> {
        let count = self.entry(key).and_then(|(_, value, _)| value.parse().ok());
        count.ok_or_else(|| self.wrong(key, "a whole number"))
    }

    /// The number of one of two keys, and whether it is the first; the other one must not be there.
    fn either(&self, keys: [&str; 2]) -> Result<(f64, bool), SurveyError> {
        match (self.number(keys[0])?, self.number(keys[1])?) {
            (Some(number), None) => Ok((number, true)),
            (None, Some(number)) => Ok((number, false)),
            (None, None) => Err(self.wrong(keys[0], &format!("{} or {}", keys[0], keys[1]))),
            (Some(_), Some(_)) => Err(self.wrong(keys[1], &format!("no {} beside {}", keys[1], keys[0]))),
        }
    }

    /// Centre of the first sample, the north-western one, and steps.
    fn grid(&self, lines: usize) -> Result<Affine, SurveyError> {
        let spacing = |name: &'static str| {
            let (step, is_cell) = self.either(["cellsize", name])?;
            let key = if is_cell { "cellsize" } else { name };
            Some(step).filter(|step| *step > 0.0).ok_or_else(|| self.wrong(key, "a spacing above 0"))
        };
        let (dy, dx) = (spacing("dy")?, spacing("dx")?);
        let centre =
            |(number, is_corner): (f64, bool), step: f64| number + if is_corner { 0.5 * step } else { 0.0 };
        let south = centre(self.either(["yllcorner", "yllcenter"])?, dy);
        let west = centre(self.either(["xllcorner", "xllcenter"])?, dx);
        Ok(Affine { first: [south + (lines - 1) as f64 * dy, west], step: [-dy, dx] })
    }
}

fn is_nan(word: &str) -> bool {
    word.eq_ignore_ascii_case("nan")
}

/// The words of a file, which white space parts, with their places.
struct Words {
    path: PathBuf,
    file: BufReader<File>,
    /// Line and column of the next byte, from 1.
    at: [usize; 2],
}

impl Words {
    fn open(path: &Path) -> Result<Self, SurveyError> {
        let (file, _) = gate::open(path)?;
        let mut file = BufReader::with_capacity(1 << 16, file);
        let start =
            file.fill_buf().map_err(|source| SurveyError::Read { path: path.to_path_buf(), source })?;
        let mark = start.len() - text::without_byte_order_mark(start).len();
        file.consume(mark);
        Ok(Self { path: path.to_path_buf(), file, at: [1; 2] })
    }

    /// The next word with its line and column.
    fn next(&mut self) -> Result<Option<(String, [usize; 2])>, SurveyError> {
        let (mut word, mut start) = (Vec::new(), self.at);
        loop {
            let failed = |source| SurveyError::Read { path: self.path.clone(), source };
            let buffer = self.file.fill_buf().map_err(failed)?;
            let (mut taken, mut is_whole) = (0, buffer.is_empty());
            for byte in buffer {
                let is_space = byte.is_ascii_whitespace();
                if is_space && !word.is_empty() {
                    is_whole = true;
                    break;
                }
                taken += 1;
                if is_space {
                    self.at = if *byte == b'\n' { [self.at[0] + 1, 1] } else { [self.at[0], self.at[1] + 1] };
                    start = self.at;
                    continue;
                }
                self.at[1] += 1;
                word.push(*byte);
                if word.len() > MOST_CHARACTERS {
                    let found = String::from_utf8_lossy(&word).into_owned();
                    return Err(damaged(&self.path, start, &found));
                }
            }
            self.file.consume(taken);
            if is_whole {
                let word = String::from_utf8_lossy(&word).into_owned();
                return Ok(Some((word, start)).filter(|(word, _)| !word.is_empty()));
            }
        }
    }
}

fn damaged(path: &Path, [line, column]: [usize; 2], found: &str) -> SurveyError {
    let advice = "the grid is damaged: correct it or fetch it again";
    field(path, format!("line {line}, column {column}"), seen(found), "a number", advice)
}

/// The numbers of a grid, line by line.
struct Numbers {
    path: PathBuf,
    /// Lines and columns of the grid.
    size: [usize; 2],
    /// Words in front of the first number.
    first: usize,
}

impl Samples for Numbers {
    /// Reads from the front on, and keeps the numbers of the window.
    fn read(&mut self, window: &Window, _: &mut Vec<String>) -> Result<Vec<f64>, SurveyError> {
        let mut words = Words::open(&self.path)?;
        for _ in 0..self.first {
            words.next()?;
        }
        let mut samples = Vec::with_capacity(window.count());
        let is_whole = window.lines.end == self.size[0];
        for line in 0..window.lines.end {
            for column in 0..self.size[1] {
                let Some((word, at)) = words.next()? else {
                    let found = format!("the end of the file in line {line}, column {column} (from 0)");
                    let expected = format!("{} lines of {} numbers", self.size[0], self.size[1]);
                    let advice = "the grid is truncated: fetch it again";
                    return Err(field(&self.path, "numbers", found, expected, advice));
                };
                let number = word.parse::<f64>().map_err(|_| damaged(&self.path, at, &word))?;
                if window.lines.contains(&line) && window.columns.contains(&column) {
                    samples.push(number);
                }
            }
        }
        match words.next()?.filter(|_| is_whole) {
            Some((word, [line, column])) => {
                let place = format!("line {line}, column {column}");
                let expected = format!("the end of {} lines of {} numbers", self.size[0], self.size[1]);
                Err(field(
                    &self.path,
                    place,
                    seen(&word),
                    expected,
                    "nrows or ncols is wrong, or the grid is damaged",
                ))
            }
            None => Ok(samples),
        }
    }
}
