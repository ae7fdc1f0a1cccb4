//! Keys of a request: read with all faults at once.

use std::collections::BTreeMap;
use std::ops::Range;

use diagnostics::{Problem, Problems, nearest};
use drive::{DriveError, EyePose};
use serde_json::{Map, Value};

use crate::asked_pose::AskedPose;
use crate::requests::COMMON;
use crate::wire::kind;
use crate::{Message, RequestRow};

/// What a problem of a request names as its file.
pub(crate) const NAME: &str = "request";

/// What a request states sweeps by.
const SWEEPS: &str = "a sweep, or two: the first, and the one after the last, from 0 to 4294967295";
/// What a request states samples by.
const SAMPLES: &str = "a sample, or two: the first, and the one after the last, from 0 to 4294967295";

/// Keys of a pose: those that it must have, and those that it may have.
const POSE: [(&str, bool); 8] = [
    ("x_m", true),
    ("y_m", true),
    ("z_m", true),
    ("heading_deg", true),
    ("pitch_deg", true),
    ("roll_deg", true),
    ("time_s", false),
    ("yoke_deg", false),
];

/// The keys of one request.
pub(crate) struct Keys<'a> {
    map: &'a Map<String, Value>,
    problems: Problems,
}

impl<'a> Keys<'a> {
    /// The keys of `request`, a request of `row`; others are a fault.
    pub fn of(request: &'a Message, row: &RequestRow) -> Self {
        let keys = Self { map: &request.header, problems: Problems::new() };
        let known: Vec<&str> = COMMON.iter().chain(row.keys).copied().collect();
        keys.expect_known("", keys.map, &known);
        if !keys.map.get("id").is_some_and(Value::is_u64) {
            keys.wrong("id", "a whole number from 0 to 18446744073709551615");
        }
        keys
    }

    /// Sees that nothing was wrong.
    pub fn finish(self) -> Result<(), DriveError> {
        Ok(self.problems.into_result()?)
    }

    /// What `read` makes of the value of `key`; nothing if it is left out or `null`.
    pub fn optional<T>(&self, key: &str, expected: &str, read: impl Fn(&Value) -> Option<T>) -> Option<T> {
        let value = self.map.get(key).filter(|value| !value.is_null())?;
        let found = read(value);
        if found.is_none() {
            self.wrong(key, expected);
        }
        found
    }

    /// The same of a key that must be there.
    pub fn required<T>(&self, key: &str, expected: &str, read: impl Fn(&Value) -> Option<T>) -> Option<T> {
        if self.map.get(key).is_none_or(Value::is_null) {
            self.wrong(key, expected);
        }
        self.optional(key, expected, read)
    }

    /// A whole number from 0.
    pub fn whole(&self, key: &str) -> Option<u64> {
        self.optional(key, "a whole number from 0", Value::as_u64)
    }

    /// A whole number from 1.
    pub fn count(&self, key: &str) -> Option<u64> {
        self.optional(key, "a whole number from 1", |value| value.as_u64().filter(|count| *count > 0))
    }

    /// A place in a picture.
    pub fn place(&self, key: &str) -> Option<usize> {
        let read = |value: &Value| value.as_u64().and_then(|place| usize::try_from(place).ok());
        self.required(key, "a whole number from 0", read)
    }

    /// A number; 0 if it is left out.
    pub fn number(&self, key: &str) -> f64 {
        self.optional(key, "a number", Value::as_f64).unwrap_or(0.0)
    }

    /// A value that is text.
    pub fn text(&self, key: &str) -> Option<String> {
        self.optional(key, "a text", |value| value.as_str().map(str::to_owned))
    }

    /// Whether the request has the key.
    pub fn has(&self, key: &str) -> bool {
        self.map.contains_key(key)
    }

    /// A text over `before`, which `null` takes back.
    pub fn changed(&self, key: &str, before: Option<String>) -> Option<String> {
        if self.has(key) { self.text(key) } else { before }
    }

    /// Texts; none if they are left out.
    pub fn texts(&self, key: &str) -> Vec<String> {
        self.optional(key, "an array of texts", texts).unwrap_or_default()
    }

    /// A text that must be there.
    pub fn needed_text(&self, key: &str) -> Option<String> {
        self.required(key, "a text", |value| value.as_str().map(str::to_owned))
    }

    /// Sweeps: a number, or the first and the one after the last.
    pub fn sweeps(&self, key: &str) -> Option<Range<u32>> {
        self.span(key, SWEEPS)
    }

    /// Samples: a number, or the first and the one after the last.
    pub fn samples(&self, key: &str) -> Option<Range<u32>> {
        self.span(key, SAMPLES)
    }

    fn span(&self, key: &str, expected: &str) -> Option<Range<u32>> {
        let number = |value: &Value| value.as_u64().and_then(|number| u32::try_from(number).ok());
        self.optional(key, expected, |value| match value {
            Value::Array(ends) if ends.len() == 2 => Some(number(&ends[0])?..number(&ends[1])?),
            single => number(single).map(|place| place..place.saturating_add(1)),
        })
    }

    /// Sweeps that must be there.
    pub fn needed_sweeps(&self, key: &str) -> Option<Range<u32>> {
        if self.map.get(key).is_none_or(Value::is_null) {
            self.wrong(key, SWEEPS);
        }
        self.sweeps(key)
    }

    /// Settings: keys with their values; `null` takes a key back.
    pub fn settings(&self, key: &str) -> BTreeMap<String, Option<String>> {
        let read = |value: &Value| {
            let keys = value.as_object()?.iter();
            keys.map(|(key, value)| Some((key.clone(), setting(value)?))).collect()
        };
        self.optional(key, "an object whose values TOML can have", read).unwrap_or_default()
    }

    /// A pose that may be left out.
    pub fn pose(&self, key: &str) -> Option<AskedPose> {
        let map =
            self.optional(key, "an object with x_m, y_m, z_m, ...", |value| value.as_object().cloned())?;
        self.expect_known(&format!("{key}."), &map, &POSE.map(|(name, _)| name));
        let number = |(name, is_required): (&str, bool)| {
            let value = map.get(name).unwrap_or(&Value::Null);
            if value.is_null() && !is_required {
                return Some(0.0);
            }
            let number = value.as_f64();
            if number.is_none() {
                self.tell(&format!("{key}.{name}"), kind(value), "a number");
            }
            number
        };
        let numbers = POSE.map(number);
        let [x, y, z, heading_deg, pitch_deg, roll_deg, time_s, yoke_deg] = numbers;
        let eye_m = [x?, y?, z?];
        let (heading_deg, pitch_deg, roll_deg) = (heading_deg?, pitch_deg?, roll_deg?);
        let eye = EyePose { time_s: time_s?, eye_m, heading_deg, pitch_deg, roll_deg, yoke_deg: yoke_deg? };
        Some(AskedPose { eye, has_time: map.get("time_s").is_some_and(Value::is_number) })
    }

    /// A pose that must be there.
    pub fn needed_pose(&self, key: &str) -> Option<AskedPose> {
        if self.map.get(key).is_none_or(Value::is_null) {
            self.wrong(key, "an object with x_m, y_m, z_m, heading_deg, pitch_deg and roll_deg");
        }
        self.pose(key)
    }

    /// Adds a fault of the request.
    pub fn refuse(&self, problem: Problem) {
        self.problems.push(problem);
    }

    fn wrong(&self, key: &str, expected: &str) {
        let found = self.map.get(key).map_or_else(|| "nothing".into(), kind);
        self.tell(key, found, expected);
    }

    fn tell(&self, key: &str, found: String, expected: &str) {
        let problem = Problem::of_file(NAME, format!("`{key}` of the request is wrong")).key(key);
        self.problems.push(problem.found(found).expected(expected));
    }

    /// Refuses keys of `map` that are not `known`.
    fn expect_known(&self, above: &str, map: &Map<String, Value>, known: &[&str]) {
        for key in map.keys().filter(|key| !known.contains(&key.as_str())) {
            let problem =
                Problem::of_file(NAME, format!("no key `{above}{key}`")).key(format!("{above}{key}"));
            let problem = problem.found(key).expected(format!("one of {}", known.join(", ")));
            let meant = nearest(key, known).map(|meant| format!("did you mean `{meant}`?"));
            self.problems.push(match meant {
                Some(meant) => problem.help(meant),
                None => problem,
            });
        }
    }
}

fn texts(value: &Value) -> Option<Vec<String>> {
    value.as_array()?.iter().map(|text| text.as_str().map(str::to_owned)).collect()
}

/// A value as `--set` takes it; `Some(None)` takes a key back.
fn setting(value: &Value) -> Option<Option<String>> {
    match value {
        Value::Null => Some(None),
        value => Some(Some(toml::Value::try_from(value).ok()?.to_string())),
    }
}
