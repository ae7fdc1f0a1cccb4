//! Rows behind the header of a PLY file.

use diagnostics::{Problem, ProblemList};

use super::header::{Coding, Element, Header, Kind, Property};

/// The value of a property in a row.
pub(super) enum Value {
    One(f64),
    List(Vec<f64>),
}

/// What is wrong with a row: what was found, and what was expected.
pub(super) struct Fault {
    pub title: String,
    pub expected: &'static str,
}

impl Fault {
    pub fn new(title: impl Into<String>, expected: &'static str) -> Self {
        Self { title: title.into(), expected }
    }
}

/// Rows that are left.
pub(super) struct Body<'f> {
    name: &'f str,
    coding: Coding,
    left: &'f [u8],
}

impl<'f> Body<'f> {
    /// All rows of a file whose header takes so many bytes.
    pub fn new(name: &'f str, header: &Header, bytes: &'f [u8], header_bytes: usize) -> Self {
        Self { name, coding: header.coding, left: &bytes[header_bytes..] }
    }

    /// A problem of a row, by its number from 1.
    pub fn problem(&self, element: &Element, number: u64, fault: Fault) -> Problem {
        let title = format!("{} {number} of {}: {}", element.name, element.count, fault.title);
        Problem::of_file(self.name, title).expected(fault.expected)
    }

    /// The values of the next row.
    ///
    /// # Errors
    /// If the file ends, or a number is none.
    pub fn row(&mut self, element: &Element, number: u64) -> Result<Vec<Value>, ProblemList> {
        let read = match self.coding {
            Coding::Text => self.line().and_then(|line| text_row(line, &element.properties)),
            Coding::LittleEndian => self.binary_row(&element.properties, false),
            Coding::BigEndian => self.binary_row(&element.properties, true),
        };
        read.map_err(|fault| self.problem(element, number, fault).into())
    }

    /// Expects that nothing is left.
    ///
    /// # Errors
    /// If something is.
    pub fn finish(&self) -> Result<(), ProblemList> {
        let left = if self.coding == Coding::Text { self.left.trim_ascii() } else { self.left };
        if left.is_empty() {
            return Ok(());
        }
        let title = format!("{} bytes are left behind the last element", left.len());
        Err(Problem::of_file(self.name, title).expected("as many rows as the header counts").into())
    }

    /// The next line that is not empty.
    fn line(&mut self) -> Result<&'f [u8], Fault> {
        let left = self.left.trim_ascii_start();
        if left.is_empty() {
            return Err(ended());
        }
        let end = left.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(left.len());
        let (line, left) = left.split_at(end);
        self.left = left;
        Ok(line)
    }

    fn binary_row(&mut self, properties: &[Property], is_big: bool) -> Result<Vec<Value>, Fault> {
        let mut row = Vec::with_capacity(properties.len());
        for Property { kind, length, .. } in properties {
            row.push(match length {
                None => Value::One(self.number(*kind, is_big)?),
                Some(length) => {
                    let length = length_of(self.number(*length, is_big)?)?;
                    if self.left.len() / kind.size() < length {
                        return Err(ended());
                    }
                    let numbers = (0..length).map(|_| self.number(*kind, is_big));
                    Value::List(numbers.collect::<Result<_, _>>()?)
                }
            });
        }
        Ok(row)
    }

    fn number(&mut self, kind: Kind, is_big: bool) -> Result<f64, Fault> {
        let (number, left) = self.left.split_at_checked(kind.size()).ok_or_else(ended)?;
        self.left = left;
        let mut little = [0; 8];
        little[..number.len()].copy_from_slice(number);
        if is_big {
            little[..number.len()].reverse();
        }
        Ok(kind.number(little))
    }
}

fn ended() -> Fault {
    Fault::new("the file ends before it", "as many rows as the header counts")
}

fn length_of(number: f64) -> Result<usize, Fault> {
    match number >= 0.0 && number.fract() == 0.0 {
        true => Ok(number as usize),
        false => Err(Fault::new(format!("a list of {number} numbers"), "a whole number, 0 or more")),
    }
}

fn text_row(line: &[u8], properties: &[Property]) -> Result<Vec<Value>, Fault> {
    let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let mut words = words.map(|word| {
        let word = String::from_utf8_lossy(word);
        word.parse::<f64>().map_err(|_| Fault::new(format!("`{word}` is no number"), "a number"))
    });
    let short = || Fault::new("the line is too short", "a number for each property");
    let mut row = Vec::with_capacity(properties.len());
    for property in properties {
        let first = words.next().ok_or_else(short)??;
        row.push(match property.length {
            None => Value::One(first),
            Some(_) => {
                let list: Vec<f64> = words.by_ref().take(length_of(first)?).collect::<Result<_, _>>()?;
                if list.len() as f64 != first {
                    return Err(short());
                }
                Value::List(list)
            }
        });
    }
    match words.next() {
        None => Ok(row),
        Some(_) => Err(Fault::new("the line is too long", "a number for each property")),
    }
}
