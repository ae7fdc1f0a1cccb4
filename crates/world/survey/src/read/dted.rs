//! DTED of levels 0 to 2 (MIL-PRF-89020B): three headers in text, then one record a meridian, from west to east.

use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use quantities::radians;

use super::bands;
use super::earth;
use super::gate;
use super::opened::{Opened, Samples};
use super::options::ReadOptions;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::stretch::Window;
use super::words::Fate::{Harmless, Only, Used};
use super::words::{Decider, Met, Vocabulary, numbered, seen};
use crate::elevation::{Affine, Frame, Grid};
use crate::error::SurveyError;

/// Bytes of the three headers: user header label, data set identification, accuracy.
const HEADERS: usize = 80 + 648 + 2700;
/// Bytes of a label of a tape that may stand in front.
const LABEL: usize = 80;
/// Most labels of a tape.
const MOST_LABELS: usize = 4;
/// Bytes of a record around its heights: eight in front, a sum of four behind.
const AROUND: usize = 12;
/// First byte of a record.
const SENTINEL: u8 = 0xaa;
/// Stored number of a void: all bits set.
const VOID: f64 = -32767.0;
/// Heights that the format allows (m): numbers beyond them are written in another way, or damaged.
const HEIGHTS: std::ops::RangeInclusive<f64> = -12_000.0..=9_000.0;

/// Text for fields that two headers have.
const AGAIN: &str = "must be that of the user header";

/// Fields by their first byte, from that of the user header on.
pub const FIELDS: Vocabulary = Vocabulary {
    kind: "first byte and field of DTED",
    prefix: "",
    words: &[
        numbered(4, "UHL longitude of origin", Used("longitude of the first meridian; W is negative")),
        numbered(
            12,
            "UHL latitude of origin",
            Used("latitude of the first sample of a record; S is negative"),
        ),
        numbered(20, "UHL longitude interval", Used("from meridian to meridian, in tenths of a second")),
        numbered(
            24,
            "UHL latitude interval",
            Used("from sample to sample of a record, in tenths of a second"),
        ),
        numbered(28, "UHL vertical accuracy", Harmless("accuracy of the heights")),
        numbered(32, "UHL security code", Harmless("who may have the file")),
        numbered(35, "UHL unique reference", Harmless("a number of the producer")),
        numbered(47, "UHL number of longitude lines", Used("records")),
        numbered(51, "UHL number of latitude points", Used("samples of a record")),
        numbered(55, "UHL multiple accuracy", Harmless("accuracy of the heights")),
        numbered(83, "DSI security classification", Harmless("who may have the file")),
        numbered(139, "DSI series designator", Used("title of the bank")),
        numbered(144, "DSI unique reference", Harmless("a number of the producer")),
        numbered(167, "DSI data edition", Harmless("age of the file")),
        numbered(182, "DSI producer code", Harmless("origin of the file")),
        numbered(206, "DSI product specification", Harmless("origin of the file")),
        numbered(
            221,
            "DSI vertical datum",
            Harmless("from where heights count; a bank counts from there too"),
        ),
        numbered(224, "DSI horizontal datum", Used("WGS84; a note tells of another one")),
        numbered(229, "DSI digitizing system", Harmless("origin of the file")),
        numbered(265, "DSI latitude of origin", Used(AGAIN)),
        numbered(274, "DSI longitude of origin", Used(AGAIN)),
        numbered(284, "DSI corners", Harmless("outline of the cell, which follows from the origin")),
        numbered(344, "DSI orientation angle", Only(&["0"], "a turned grid")),
        numbered(353, "DSI latitude interval", Used(AGAIN)),
        numbered(357, "DSI longitude interval", Used(AGAIN)),
        numbered(361, "DSI number of latitude points", Used(AGAIN)),
        numbered(365, "DSI number of longitude lines", Used(AGAIN)),
        numbered(
            369,
            "DSI partial cell indicator",
            Harmless("share of the cell that is held; voids say which"),
        ),
        numbered(731, "ACC accuracy", Harmless("accuracy of the heights")),
        numbered(3428, "record sentinel", Used("must be 170")),
        numbered(3429, "record data block count", Used("must count from 0 on")),
        numbered(3432, "record longitude count", Used("must count from 0 on")),
        numbered(3434, "record latitude count", Used("must be 0: a record begins in the south")),
        numbered(3436, "record heights", Used("sign and magnitude; all bits set is a void")),
    ],
};

/// Whether a file begins like DTED, with or without labels of a tape.
pub fn is_dted(start: &[u8]) -> bool {
    ["UHL1", "VOL1", "HDR1"].iter().any(|word| start.starts_with(word.as_bytes()))
}

/// Opens a cell: three headers, then a record a meridian.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    bands::of_raw(path, options, 1)?;
    options.expect_no_place()?;
    let (file, bytes) = gate::open(path)?;
    let mut file = BufReader::new(file);
    let mut decider = Decider::new(path, options);
    let headers = Headers::of(path, &mut file)?;
    headers.decide(&mut decider)?;
    let cell = headers.cell()?;
    cell.check_size(path, headers.start, bytes)?;
    let said = Said { voids: vec![[VOID; 2]], sphere: earth::RADIUS, ..Said::default() };
    let affine = Affine { first: cell.origin, step: cell.step };
    let frame = Frame::Geographic { radius: earth::RADIUS };
    let grid = Grid { lines: cell.points, columns: cell.meridians, affine, frame };
    let (title, notes) = (headers.text(139, 5), headers.notes());
    let records = Records {
        path: path.to_path_buf(),
        first: (headers.start + HEADERS) as u64,
        bytes: cell.record(),
        forgives: decider.forgives("checksum"),
    };
    Ok(Opened {
        grid,
        path: path.to_path_buf(),
        title,
        sources: vec![path.to_path_buf()],
        notes: [notes, decider.finish()?].concat(),
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(records),
    })
}

/// The three headers of a file.
struct Headers<'a> {
    path: &'a Path,
    /// First byte of the user header label.
    start: usize,
    bytes: Vec<u8>,
}

/// What the headers say about the cell.
struct Cell {
    /// Records, from west to east.
    meridians: usize,
    /// Samples of a record, from south to north.
    points: usize,
    /// Latitude and longitude of the first sample (rad).
    origin: [f64; 2],
    /// From sample to sample and from record to record (rad).
    step: [f64; 2],
}

impl<'a> Headers<'a> {
    /// Reads the headers, behind the labels of a tape if there are any.
    fn of(path: &'a Path, file: &mut BufReader<File>) -> Result<Self, SurveyError> {
        let failed = |source| SurveyError::Read { path: path.to_path_buf(), source };
        for start in (0..=MOST_LABELS).map(|labels| labels * LABEL) {
            let mut bytes = Vec::new();
            file.seek(SeekFrom::Start(start as u64)).map_err(failed)?;
            file.take(HEADERS as u64).read_to_end(&mut bytes).map_err(failed)?;
            if bytes.starts_with(b"UHL") {
                if bytes.len() < HEADERS {
                    let (place, expected) = ("headers".into(), (start + HEADERS) as u64);
                    let found = (start + bytes.len()) as u64;
                    return Err(SurveyError::Truncated { path: path.to_path_buf(), place, found, expected });
                }
                return Ok(Self { path, start, bytes });
            }
        }
        let advice = "the file is damaged: fetch it again";
        Err(field(path, "headers", "no user header label", "UHL1 behind at most 4 labels", advice))
    }

    /// Text of a field.
    fn text(&self, at: usize, length: usize) -> String {
        String::from_utf8_lossy(&self.bytes[at..at + length]).trim().to_string()
    }

    fn wrong(&self, at: usize, length: usize, expected: &str) -> SurveyError {
        let name = FIELDS.of_number(at as u16).map_or("field", |word| word.name);
        let found = seen(&self.text(at, length));
        field(self.path, name, found, expected, "the header is damaged: fetch the file again")
    }

    /// Decides the fields that must have one value.
    fn decide(&self, decider: &mut Decider) -> Result<(), SurveyError> {
        let (word, value) = (FIELDS.of_number(344), self.text(344, 9));
        let name = "DSI orientation angle";
        decider.decide(Met { of: &FIELDS, word, place: name, name, value: &value }).map(drop)
    }

    fn count(&self, at: usize) -> Result<usize, SurveyError> {
        self.text(at, 4).parse().map_err(|_| self.wrong(at, 4, "a whole number"))
    }

    /// An interval in tenths of a second, in radians.
    fn interval(&self, at: usize) -> Result<f64, SurveyError> {
        let tenths = self.count(at)?;
        if tenths == 0 {
            return Err(self.wrong(at, 4, "tenths of a second, above 0"));
        }
        Ok(radians(tenths as f64 / 36_000.0))
    }

    fn angle(&self, at: usize, length: usize, letters: [char; 2]) -> Result<f64, SurveyError> {
        let expected = format!("degrees, minutes, seconds, then {} or {}", letters[0], letters[1]);
        angle(&self.text(at, length), letters).ok_or_else(|| self.wrong(at, length, &expected))
    }

    /// The cell; what two headers say must be the same.
    fn cell(&self) -> Result<Cell, SurveyError> {
        let (north, east) = (['N', 'S'], ['E', 'W']);
        let cell = Cell {
            meridians: self.count(47)?,
            points: self.count(51)?,
            origin: [self.angle(12, 8, north)?, self.angle(4, 8, east)?],
            step: [self.interval(24)?, self.interval(20)?],
        };
        let again = [
            (265, 9, self.angle(265, 9, north)? == cell.origin[0]),
            (274, 10, self.angle(274, 10, east)? == cell.origin[1]),
            (353, 4, self.interval(353)? == cell.step[0]),
            (357, 4, self.interval(357)? == cell.step[1]),
            (361, 4, self.count(361)? == cell.points),
            (365, 4, self.count(365)? == cell.meridians),
        ];
        match again.iter().find(|(_, _, is_same)| !is_same) {
            Some((at, length, _)) => Err(self.wrong(*at, *length, "the value of the user header label")),
            None => Ok(cell),
        }
    }

    fn notes(&self) -> Vec<String> {
        let datum = self.text(224, 5);
        let other =
            (datum != "WGS84").then(|| format!("the horizontal datum is {}, not WGS84", seen(&datum)));
        other.into_iter().chain([earth::note()]).collect()
    }
}

/// An angle (rad) as `DDDMMSSH` or `DDMMSS.SH`; the second letter makes it negative.
fn angle(text: &str, [positive, negative]: [char; 2]) -> Option<f64> {
    let letter = text.chars().last()?;
    let digits = text.strip_suffix(letter)?;
    let (whole, tenths) = digits.split_once('.').unwrap_or((digits, "0"));
    let is_number = [whole, tenths].iter().all(|text| text.bytes().all(|byte| byte.is_ascii_digit()));
    if !is_number || whole.len() < 6 || ![positive, negative].contains(&letter) {
        return None;
    }
    let (rest, seconds) = whole.split_at(whole.len() - 2);
    let (degrees, minutes) = rest.split_at(rest.len() - 2);
    let seconds = format!("{seconds}.{tenths}").parse::<f64>().ok()?;
    let (degrees, minutes) = (degrees.parse::<f64>().ok()?, minutes.parse::<f64>().ok()?);
    if minutes >= 60.0 || seconds >= 60.0 || degrees > 180.0 {
        return None;
    }
    let angle = radians(degrees + minutes / 60.0 + seconds / 3600.0);
    Some(if letter == negative { -angle } else { angle })
}

impl Cell {
    fn record(&self) -> usize {
        AROUND + 2 * self.points
    }

    fn check_size(&self, path: &Path, start: usize, found: u64) -> Result<(), SurveyError> {
        check_raster(path, self.points as u64, self.meridians as u64)?;
        let expected = (start + HEADERS + self.meridians * self.record()) as u64;
        if found < expected {
            let place = format!("{} records of {} bytes", self.meridians, self.record());
            return Err(SurveyError::Truncated { path: path.to_path_buf(), place, found, expected });
        }
        Ok(())
    }
}

/// The records of a cell, one a meridian.
struct Records {
    path: PathBuf,
    /// Byte of the first record.
    first: u64,
    /// Bytes of a record.
    bytes: usize,
    /// Whether wrong sums are let through.
    forgives: bool,
}

impl Samples for Records {
    /// Reads the records of the meridians that the window has; the southernmost line is the first.
    fn read(&mut self, window: &Window, _: &mut Vec<String>) -> Result<Vec<f64>, SurveyError> {
        let failed = |source| SurveyError::Read { path: self.path.clone(), source };
        let mut file = BufReader::new(gate::open(&self.path)?.0);
        let before = window.columns.start as u64 * self.bytes as u64;
        file.seek(SeekFrom::Start(self.first + before)).map_err(failed)?;
        let (mut record, columns) = (vec![0; self.bytes], window.columns.len());
        let mut samples = vec![f64::NAN; window.count()];
        for (across, meridian) in window.columns.clone().enumerate() {
            file.read_exact(&mut record).map_err(failed)?;
            check_record(&self.path, &record, meridian, self.forgives)?;
            for (down, point) in window.lines.clone().enumerate() {
                let at = 8 + 2 * point;
                samples[down * columns + across] =
                    self.height([record[at], record[at + 1]], meridian, point)?;
            }
        }
        Ok(samples)
    }
}

impl Records {
    /// The stored height of a sample, which must be one that the format allows.
    fn height(&self, bytes: [u8; 2], meridian: usize, point: usize) -> Result<f64, SurveyError> {
        let height = sign_and_magnitude(bytes);
        if height == VOID || HEIGHTS.contains(&height) {
            return Ok(height);
        }
        let place = format!("record {meridian}, sample {point} (from 0)");
        let expected = "-12000 to 9000 m, as sign and magnitude";
        let advice = "the file counts in two's complement, or is damaged: convert it with gdal_translate";
        Err(field(&self.path, place, height.to_string(), expected, advice))
    }
}

/// A number whose highest bit is its sign.
fn sign_and_magnitude(bytes: [u8; 2]) -> f64 {
    let word = u16::from_be_bytes(bytes);
    let magnitude = f64::from(word & 0x7fff);
    if word & 0x8000 != 0 { -magnitude } else { magnitude }
}

/// A record must be the next one, and its bytes must have their sum.
fn check_record(path: &Path, record: &[u8], meridian: usize, forgives: bool) -> Result<(), SurveyError> {
    let number = |bytes: &[u8]| bytes.iter().fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
    let (held, sum) = record.split_at(record.len() - 4);
    let wrong = |what: &str, found: u64, expected: u64, advice: &str| {
        let place = format!("record {meridian} (from 0), {what}");
        Err(field(path, place, found.to_string(), expected.to_string(), advice))
    };
    let damaged = "the file is damaged: fetch it again";
    let counts = [
        ("sentinel", &held[..1], u64::from(SENTINEL)),
        ("data block count", &held[1..4], meridian as u64),
        ("longitude count", &held[4..6], meridian as u64),
        ("latitude count", &held[6..8], 0),
    ];
    if let Some((what, bytes, expected)) =
        counts.iter().find(|(_, bytes, expected)| number(bytes) != *expected)
    {
        return wrong(what, number(bytes), *expected, damaged);
    }
    let expected = held.iter().map(|byte| u64::from(*byte)).sum();
    if !forgives && number(sum) != expected {
        let advice = "the file is damaged: fetch it again, or give --ignore checksum";
        return wrong("checksum", number(sum), expected, advice);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use quantities::degrees;

    use super::{angle, sign_and_magnitude};

    #[test]
    fn angles_of_all_hemispheres() {
        let found = |text: &str, letters: [char; 2]| angle(text, letters).map(degrees);
        let near =
            |text: &str, letters, expected: f64| (found(text, letters).unwrap() - expected).abs() < 1e-12;
        assert!(near("0063000E", ['E', 'W'], 6.5) && near("1203000W", ['E', 'W'], -120.5));
        assert!(near("431536.0S", ['N', 'S'], -43.26));
        for text in ["0066000E", "0060000N", "1900000E", "E", "00600E", "006000xE", "0060060E"] {
            assert_eq!(found(text, ['E', 'W']), None, "{text}");
        }
    }

    #[test]
    fn the_highest_bit_is_the_sign() {
        assert_eq!(sign_and_magnitude([0x80, 0x07]), -7.0);
        assert_eq!(sign_and_magnitude([0xff, 0xff]), super::VOID);
        assert_eq!(sign_and_magnitude([0x07, 0xbb]), 1979.0);
        assert_eq!(sign_and_magnitude([0x80, 0x00]), 0.0);
    }
}
