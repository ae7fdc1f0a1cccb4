//! One key of a table: its type, its bounds, and what happens when it is missing.

use crate::asked::{Shape, ShapeKind, note};
use crate::place::{Place, Placed};
use crate::problem::{Problem, Problems};
use crate::reader::{Reader, nearest};
use crate::tree::{Node, Value};

/// Why a value was refused; what was expected is known to the field.
#[derive(Debug)]
pub(crate) struct Fault {
    place: Place,
    found: String,
    help: Option<String>,
}

impl Fault {
    fn of(node: &Node) -> Self {
        Self { place: node.place.clone(), found: node.found(), help: None }
    }
}

type Convert<'a, T> = Box<dyn Fn(&Node) -> Result<T, Fault> + 'a>;

/// A key that was asked for. Bounds are added, then [`required`](Field::required),
/// [`optional`](Field::optional) or [`default`](Field::default) reads it.
#[must_use = "a field is read by required, optional or default"]
pub struct Field<'a, T> {
    at: Placed<Option<&'a Node>>,
    problems: &'a Problems,
    expected: String,
    shape: Shape,
    help: Option<String>,
    convert: Convert<'a, T>,
}

impl<'a, T: 'a> Field<'a, T> {
    pub(crate) fn new(
        at: Placed<Option<&'a Node>>,
        problems: &'a Problems,
        (expected, kind): (String, ShapeKind),
        convert: Convert<'a, T>,
    ) -> Self {
        Self { at, problems, expected, shape: Shape::of(kind), help: None, convert }
    }

    /// The value; a missing key is a problem.
    pub fn required(self) -> Option<T> {
        if self.at.value.is_none() {
            let title = format!("missing key `{}`", self.at.key);
            let expected = format!("`{}`, {}", self.at.key, self.expected);
            let problem = Problem::at(&self.at.place, title).key(&self.at.key).expected(expected);
            self.problems.push(Problem { help: self.help.clone(), ..problem });
        }
        self.read(true)
    }

    /// The value; nothing where the key is missing.
    pub fn optional(self) -> Option<T> {
        self.read(false)
    }

    fn read(self, is_required: bool) -> Option<T> {
        note(&self.at.key, is_required, || self.shape.clone());
        let node = self.at.value?;
        (self.convert)(node).map_err(|fault| self.refuse(fault)).ok()
    }

    /// The value, or `default` where the key is missing; nothing where it is wrong.
    pub fn default(self, default: T) -> Option<T> {
        let is_missing = self.at.value.is_none();
        let found = self.optional();
        if is_missing { Some(default) } else { found }
    }

    /// What to do when the key is missing or wrong.
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The one number that is right, which its reader checks itself.
    pub(crate) fn only_noted(mut self, number: u64) -> Self {
        let bound = Some((number as f64, true));
        (self.shape.low, self.shape.high) = (bound, bound);
        self
    }

    /// Names the unit in messages.
    pub fn unit(mut self, unit: &str) -> Self {
        self.expected = format!("{} {unit}", self.expected);
        self.shape.unit = Some(unit.to_owned());
        self
    }

    /// Turns the value into another, for instance degrees into radians.
    pub fn map<U: 'a>(self, meaning: impl Fn(T) -> U + 'a) -> Field<'a, U> {
        self.with_conversion(|convert| Box::new(move |node| Ok(meaning(convert(node)?))))
    }

    /// Keeps the place with the value.
    pub fn placed(self) -> Field<'a, Placed<T>> {
        let key = self.at.key.clone();
        self.with_conversion(|convert| {
            Box::new(move |node| {
                Ok(Placed { value: convert(node)?, place: node.place.clone(), key: key.clone() })
            })
        })
    }

    /// A rule of the caller's own; `rule` says in words what is allowed, as "a power of two".
    pub fn must(mut self, rule: &str, holds: impl Fn(&T) -> bool + 'a) -> Self {
        self.expected = format!("{}, {rule}", self.expected);
        self.shape.rules.push(rule.to_owned());
        self.with_conversion(|convert| {
            Box::new(move |node| {
                let value = convert(node)?;
                if holds(&value) { Ok(value) } else { Err(Fault::of(node)) }
            })
        })
    }

    /// Lets the word stand in place of the value, as `"ideal"`; it reads as `None`.
    pub fn or_word(mut self, word: &'a str) -> Field<'a, Option<T>> {
        self.expected = format!("{}, or the word {word:?}", self.expected);
        self.shape.or_words.push(word.to_owned());
        self.with_conversion(|convert| {
            Box::new(move |node| match &node.value {
                Value::String(text) if text == word => Ok(None),
                _ => convert(node).map(Some),
            })
        })
    }

    fn with_conversion<U>(self, wrap: impl FnOnce(Convert<'a, T>) -> Convert<'a, U>) -> Field<'a, U> {
        let Self { at, problems, expected, shape, help, convert } = self;
        Field { at, problems, expected, shape, help, convert: wrap(convert) }
    }

    fn refuse(&self, fault: Fault) {
        let title = format!("`{}` must be {}, not {}", self.at.key, self.expected, fault.found);
        let mut problem = Problem::at(&fault.place, title).key(&self.at.key);
        problem = problem.found(fault.found).expected(&self.expected);
        self.problems.push(Problem { help: fault.help.or(self.help.clone()), ..problem });
    }
}

/// Values whose numbers can be held to bounds: a number, or each number of an array.
pub trait Bounded {
    /// Type of the numbers, which can be compared and shown.
    type Number: PartialOrd + Copy + std::fmt::Display;
    /// All numbers, in the order of the file.
    fn numbers(&self) -> Vec<Self::Number>;
    /// A bound as a number of the file.
    fn bound(number: Self::Number) -> f64;
}

impl<'a, T: Bounded + 'a> Field<'a, T>
where
    T::Number: 'a,
{
    /// From `low` to `high`, both allowed.
    pub fn between(self, low: T::Number, high: T::Number) -> Self {
        let bounded =
            self.bounded(format!("from {low} to {high}"), move |number| low <= number && number <= high);
        bounded.with_low(low, true).with_high(high, true)
    }

    /// Requires every number to be `low` or more.
    pub fn at_least(self, low: T::Number) -> Self {
        self.bounded(format!("of at least {low}"), move |number| number >= low).with_low(low, true)
    }

    /// Requires every number to be `high` or less.
    pub fn at_most(self, high: T::Number) -> Self {
        self.bounded(format!("of at most {high}"), move |number| number <= high).with_high(high, true)
    }

    /// Requires every number to be more than `low`.
    pub fn above(self, low: T::Number) -> Self {
        self.bounded(format!("above {low}"), move |number| number > low).with_low(low, false)
    }

    /// Requires every number to be less than `high`.
    pub fn below(self, high: T::Number) -> Self {
        self.bounded(format!("below {high}"), move |number| number < high).with_high(high, false)
    }

    fn with_low(mut self, low: T::Number, is_allowed: bool) -> Self {
        self.shape.low = Some((T::bound(low), is_allowed));
        self
    }

    fn with_high(mut self, high: T::Number, is_allowed: bool) -> Self {
        self.shape.high = Some((T::bound(high), is_allowed));
        self
    }

    fn bounded(mut self, bounds: String, holds: impl Fn(T::Number) -> bool + 'a) -> Self {
        let is_bounded = self.shape.low.is_some() || self.shape.high.is_some();
        let and = if is_bounded { " and" } else { "" };
        self.expected = format!("{}{and} {bounds}", self.expected);
        self.with_conversion(|convert| {
            Box::new(move |node| {
                let value = convert(node)?;
                match value.numbers().into_iter().position(|number| !holds(number)) {
                    None => Ok(value),
                    Some(index) => Err(Fault::of(element(node, index))),
                }
            })
        })
    }
}

/// The element of an array that is at fault, or the value itself.
fn element(node: &Node, index: usize) -> &Node {
    match &node.value {
        Value::Array(elements) => elements.get(index).unwrap_or(node),
        _ => node,
    }
}

macro_rules! bounded_numbers {
    ($($number:ty)*) => { $(
        impl Bounded for $number {
            type Number = $number;
            fn numbers(&self) -> Vec<$number> {
                vec![*self]
            }
            fn bound(number: $number) -> f64 {
                number as f64
            }
        }

        impl Bounded for Vec<$number> {
            type Number = $number;
            fn numbers(&self) -> Vec<$number> {
                self.clone()
            }
            fn bound(number: $number) -> f64 {
                number as f64
            }
        }
    )* };
}

bounded_numbers!(f64 u32 u64 usize i64);

impl<const N: usize> Bounded for [f64; N] {
    type Number = f64;
    fn numbers(&self) -> Vec<f64> {
        self.to_vec()
    }
    fn bound(number: f64) -> f64 {
        number
    }
}

/// The types a key can have.
impl<'a> Reader<'a> {
    /// A finite number; a whole number will do.
    pub fn f64(&self, key: &str) -> Field<'a, f64> {
        self.field(key, ("a number", ShapeKind::Number), finite_number)
    }

    /// A whole number of 0 or more.
    pub fn u64(&self, key: &str) -> Field<'a, u64> {
        self.field(key, ("a whole number", ShapeKind::Count), whole_number)
    }

    /// A whole number of 0 or more that fits 32 bits.
    pub fn u32(&self, key: &str) -> Field<'a, u32> {
        self.field(key, ("a whole number", ShapeKind::Count), whole_number)
    }

    /// A whole number of 0 or more: a count.
    pub fn usize(&self, key: &str) -> Field<'a, usize> {
        self.field(key, ("a whole number", ShapeKind::Count), whole_number)
    }

    /// A whole number, negative ones too.
    pub fn i64(&self, key: &str) -> Field<'a, i64> {
        self.field(key, ("a whole number", ShapeKind::Whole), whole_number)
    }

    /// Reads a key whose value is `true` or `false`.
    pub fn bool(&self, key: &str) -> Field<'a, bool> {
        self.field(key, ("true or false", ShapeKind::Boolean), |node| match node.value {
            Value::Boolean(flag) => Ok(flag),
            _ => Err(Fault::of(node)),
        })
    }

    /// A text in quotes: one line that is not empty, without control characters.
    pub fn string(&self, key: &str) -> Field<'a, String> {
        self.field(key, ("one line of text in quotes", ShapeKind::Text), |node| match &node.value {
            // Lists and terminals show it as it is.
            Value::String(text) if !text.is_empty() && !text.contains(char::is_control) => Ok(text.clone()),
            _ => Err(Fault::of(node)),
        })
    }

    /// Exactly `N` finite numbers.
    pub fn f64_array<const N: usize>(&self, key: &str) -> Field<'a, [f64; N]> {
        self.field(key, (format!("an array of {N} numbers"), array(ShapeKind::Number, Some(N))), |node| {
            <[f64; N]>::try_from(elements(node, finite_number)?)
                .map_err(|wrong| Fault { found: format!("{} of them", wrong.len()), ..Fault::of(node) })
        })
    }

    /// One finite number, or two in an array: `50`, `[50, 30]`.
    pub fn f64_or_pair(&self, key: &str) -> Field<'a, Vec<f64>> {
        self.field(key, ("a number, or an array of 2 numbers,", ShapeKind::NumberOrArray(2)), |node| {
            let numbers = match node.value {
                Value::Array(_) => elements(node, finite_number)?,
                _ => return finite_number(node).map(|number| vec![number]),
            };
            match numbers.len() {
                2 => Ok(numbers),
                wrong => Err(Fault { found: format!("{wrong} of them"), ..Fault::of(node) }),
            }
        })
    }

    /// Any number of finite numbers.
    pub fn f64_list(&self, key: &str) -> Field<'a, Vec<f64>> {
        self.field(key, ("an array of numbers", array(ShapeKind::Number, None)), |node| {
            elements(node, finite_number)
        })
    }

    /// Any number of pairs of finite numbers: `[[1, 2], [3, 4]]`.
    pub fn f64_pairs(&self, key: &str) -> Field<'a, Vec<[f64; 2]>> {
        self.tuples(key, "an array of pairs of numbers")
    }

    /// Any number of triples of finite numbers: `[[1, 2, 3], [4, 5, 6]]`.
    pub fn f64_triples(&self, key: &str) -> Field<'a, Vec<[f64; 3]>> {
        self.tuples(key, "an array of triples of numbers")
    }

    fn tuples<const N: usize>(&self, key: &str, expected: &str) -> Field<'a, Vec<[f64; N]>> {
        self.field(key, (expected, array(array(ShapeKind::Number, Some(N)), None)), |node| {
            elements(node, |element| {
                let numbers = elements(element, finite_number)?;
                <[f64; N]>::try_from(numbers).map_err(|_| Fault::of(element))
            })
        })
    }

    /// Any number of whole numbers of 0 or more.
    pub fn u64_list(&self, key: &str) -> Field<'a, Vec<u64>> {
        self.field(key, ("an array of whole numbers", array(ShapeKind::Count, None)), |node| {
            elements(node, whole_number)
        })
    }

    /// Any number of texts.
    pub fn string_list(&self, key: &str) -> Field<'a, Vec<String>> {
        self.field(key, ("an array of texts", array(ShapeKind::Text, None)), |node| {
            elements(node, |element| match &element.value {
                Value::String(text) => Ok(text.clone()),
                _ => Err(Fault::of(element)),
            })
        })
    }

    /// One of several words, each with its meaning.
    pub fn one_of<T: Clone + 'a>(&self, key: &str, words: &[(&'a str, T)]) -> Field<'a, T> {
        let words = words.to_vec();
        let quoted: Vec<String> = words.iter().map(|(word, _)| format!("{word:?}")).collect();
        let kind = ShapeKind::Words(words.iter().map(|(word, _)| (*word).to_owned()).collect());
        self.field(key, (format!("one of {}", quoted.join(", ")), kind), move |node| {
            let Value::String(found) = &node.value else { return Err(Fault::of(node)) };
            let meaning = words.iter().find(|(word, _)| word == found).map(|(_, meaning)| meaning.clone());
            let known: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
            let help = nearest(found, &known).map(|word| format!("did you mean {word:?}?"));
            meaning.ok_or_else(|| Fault { help, ..Fault::of(node) })
        })
    }
}

fn array(of: ShapeKind, count: Option<usize>) -> ShapeKind {
    ShapeKind::Array(Box::new(of), count)
}

fn finite_number(node: &Node) -> Result<f64, Fault> {
    match node.value {
        Value::Float(number) if number.is_finite() => Ok(number),
        Value::Integer(number) => Ok(number as f64),
        _ => Err(Fault::of(node)),
    }
}

fn whole_number<T: TryFrom<i64>>(node: &Node) -> Result<T, Fault> {
    match node.value {
        Value::Integer(number) => T::try_from(number).map_err(|_| Fault::of(node)),
        _ => Err(Fault::of(node)),
    }
}

fn elements<T>(node: &Node, convert: impl Fn(&Node) -> Result<T, Fault>) -> Result<Vec<T>, Fault> {
    match &node.value {
        Value::Array(elements) => elements.iter().map(convert).collect(),
        _ => Err(Fault::of(node)),
    }
}
