//! The list of planes in a header.

use std::collections::BTreeSet;

use diagnostics::{Problem, ProblemList, Problems};
use serde_json::{Map, Value};

use crate::Dtype;
use crate::message::PLANES;
use crate::plane::byte_count;
use crate::wire::kind;

/// Most axes of a plane.
const MOST_AXES: usize = 8;

/// A plane of the list, whose bytes are still to come.
pub(crate) struct Listed {
    /// Name, which no other plane of the list has.
    pub name: String,
    /// Type of the numbers.
    pub dtype: Dtype,
    /// Length of each axis.
    pub shape: Vec<usize>,
    /// Bytes of the plane.
    pub count: u64,
}

/// Takes the list of planes out of `header`. Together they must have `bytes` bytes. Problems are told of `file`. Texts are no planes: with them
/// a request without planes names those of its answer, and they stay.
pub(crate) fn listed(
    file: &str,
    header: &mut Map<String, Value>,
    bytes: u64,
) -> Result<Vec<Listed>, ProblemList> {
    let problems = Problems::new();
    let tell = |key: String, title: &str, found: String, expected: String| {
        problems.push(Problem::of_file(file, title).key(key).found(found).expected(expected));
    };
    let rows = match header.remove(PLANES) {
        None => Vec::new(),
        Some(Value::Array(names)) if bytes == 0 && names.iter().all(Value::is_string) => {
            header.insert(PLANES.into(), names.into());
            Vec::new()
        }
        Some(Value::Array(rows)) => rows,
        Some(other) => {
            tell(PLANES.into(), "the planes are no list", kind(&other), "an array".into());
            Vec::new()
        }
    };
    let mut names = BTreeSet::new();
    let mut planes = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        let read = plane(row).and_then(|plane| match names.insert(plane.name.clone()) {
            true => Ok(plane),
            false => Err(("name", "two planes have one name", format!("`{}`", plane.name), "another name")),
        });
        match read {
            Ok(plane) => planes.push(plane),
            Err((key, title, found, expected)) => {
                tell(format!("{PLANES}[{index}].{key}"), title, found, expected.into());
            }
        }
    }
    let sum = planes.iter().try_fold(0_u64, |sum, plane| sum.checked_add(plane.count));
    if planes.len() == rows.len() && sum != Some(bytes) {
        let found = sum.map_or_else(|| "more than any number".into(), |sum| format!("{sum} bytes"));
        let expected = format!("{bytes} bytes, as the prefix says");
        tell(PLANES.into(), "the planes do not add up", found, expected);
    }
    problems.into_result()?;
    Ok(planes)
}

/// A fault of a row: key, title, what was found, what was expected.
type Fault = (&'static str, &'static str, String, &'static str);

fn plane(row: &Value) -> Result<Listed, Fault> {
    let of = |key: &str| row.get(key).unwrap_or(&Value::Null);
    let named = of("name").as_str().filter(|name| !name.is_empty());
    let name = named.ok_or_else(|| ("name", "a plane without a name", kind(of("name")), "a text"))?;
    let dtype = of("dtype").as_str().and_then(Dtype::of_name).ok_or_else(|| {
        ("dtype", "no type of numbers", kind(of("dtype")), "one of u8, u16, u32, i32, f32, f64")
    })?;
    let no_shape = || {
        (
            "shape",
            "no shape",
            of("shape").to_string(),
            "at most 8 whole numbers, of values that can be counted",
        )
    };
    let axes = of("shape").as_array().filter(|axes| axes.len() <= MOST_AXES).ok_or_else(no_shape)?;
    let axis = |axis: &Value| axis.as_u64().and_then(|axis| usize::try_from(axis).ok());
    let shape: Vec<usize> = axes.iter().map(axis).collect::<Option<_>>().ok_or_else(no_shape)?;
    let count = byte_count(dtype, &shape).ok_or_else(no_shape)?;
    Ok(Listed { name: name.into(), dtype, shape, count })
}
