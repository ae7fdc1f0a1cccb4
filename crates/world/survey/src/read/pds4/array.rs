//! The array of a PDS4 label: where its samples stand, and what they mean.

use std::path::{Path, PathBuf};

use roxmltree::Node;

use super::label::{Label, children, text};
use super::words::ARRAY;
use crate::error::SurveyError;
use crate::read::beside::{in_folder, is_plain};
use crate::read::kind::{Kind, in_base};
use crate::read::options::ReadOptions;
use crate::read::raw::Raw;
use crate::read::refusal::check_raster;
use crate::read::samples::Said;
use crate::read::words::Fate;
use crate::read::{bands, unit};

/// Names of the axes, in the order of [`Axes`].
const AXES: [&str; 3] = ["Line", "Sample", "Band"];

/// The file of the array, in the folder of the label.
pub fn file(label: &Label) -> Result<PathBuf, SurveyError> {
    let name = label.one(label.file, "file_name")?.ok_or_else(|| label.missing("file_name"))?;
    let found = if is_plain(text(name)) { in_folder(label.path, text(name))? } else { None };
    found.ok_or_else(|| label.wrong(name, "a file that is in the folder of the label"))
}

/// The samples of the only band, or of the chosen one.
pub fn raw(label: &Label, file: &Path, options: &ReadOptions) -> Result<Raw, SurveyError> {
    let (kind, axes) = (kind(label)?, Axes::of(label)?);
    let [lines, columns, bands] = axes.counts;
    check_raster(file, lines, columns)?;
    let band = bands::of_raw(file, options, usize::try_from(bands).unwrap_or(usize::MAX))?;
    let offset = label.one(label.array, "offset")?.ok_or_else(|| label.missing("offset"))?;
    let unit = offset.attribute("unit").unwrap_or("byte");
    if !unit.eq_ignore_ascii_case("byte") {
        return Err(label.wrong(offset, "a number of bytes"));
    }
    let [line_step, sample_step, band_step] = axes.steps.map(|step| step.saturating_mul(kind.bytes as u64));
    let first = label.count(offset)?.saturating_add(band_step.saturating_mul(band as u64));
    let raw = Raw::lines_of(file, [lines, columns].map(|count| count as usize), kind, first);
    let raw = Raw { block_step: line_step, sample_step, ..raw };
    raw.check()?;
    Ok(raw)
}

/// The axes of an array: lines, samples, bands.
struct Axes {
    counts: [u64; 3],
    /// Elements from one to the next.
    steps: [u64; 3],
}

impl Axes {
    fn of(label: &Label) -> Result<Self, SurveyError> {
        let mut axes: Vec<(u64, usize, u64)> = Vec::new();
        for axis in children(label.array, "Axis_Array") {
            let needed = |name: &'static str| label.one(axis, name)?.ok_or_else(|| label.missing(name));
            let name = needed("axis_name")?;
            let index = AXES.iter().position(|known| known.eq_ignore_ascii_case(text(name)));
            let index = index.ok_or_else(|| label.wrong(name, "Line, Sample or Band"))?;
            if axes.iter().any(|(_, other, _)| *other == index) {
                return Err(label.wrong(name, "one axis of a name"));
            }
            axes.push((label.count(needed("sequence_number")?)?, index, label.count(needed("elements")?)?));
        }
        let said = label.one(label.array, "axes")?.ok_or_else(|| label.missing("axes"))?;
        axes.sort_unstable();
        let is_ordered = axes.iter().enumerate().all(|(at, (number, _, _))| *number == at as u64 + 1);
        let has = |index: usize| axes.iter().any(|(_, found, _)| *found == index);
        if label.count(said)? != axes.len() as u64 || !is_ordered || !has(0) || !has(1) {
            return Err(
                label.wrong(said, "2 for Line and Sample, 3 with Band, in the order of sequence_number")
            );
        }
        let (mut out, mut step) = (Self { counts: [1; 3], steps: [0; 3] }, 1_u64);
        for (_, index, count) in axes.into_iter().rev() {
            (out.counts[index], out.steps[index]) = (count, step);
            step = step.saturating_mul(count);
        }
        Ok(out)
    }
}

fn kind(label: &Label) -> Result<Kind, SurveyError> {
    let kind = label.one(label.array, "data_type")?.ok_or_else(|| label.missing("data_type"))?;
    Ok(match text(kind) {
        "SignedByte" => Kind::integer(1, true, true),
        "UnsignedByte" => Kind::integer(1, false, true),
        "SignedLSB2" => Kind::integer(2, true, true),
        "SignedLSB4" => Kind::integer(4, true, true),
        "SignedLSB8" => Kind::integer(8, true, true),
        "SignedMSB2" => Kind::integer(2, true, false),
        "SignedMSB4" => Kind::integer(4, true, false),
        "SignedMSB8" => Kind::integer(8, true, false),
        "UnsignedLSB2" => Kind::integer(2, false, true),
        "UnsignedLSB4" => Kind::integer(4, false, true),
        "UnsignedLSB8" => Kind::integer(8, false, true),
        "UnsignedMSB2" => Kind::integer(2, false, false),
        "UnsignedMSB4" => Kind::integer(4, false, false),
        "UnsignedMSB8" => Kind::integer(8, false, false),
        "IEEE754LSBSingle" => Kind::real(4, true),
        "IEEE754LSBDouble" => Kind::real(8, true),
        "IEEE754MSBSingle" => Kind::real(4, false),
        "IEEE754MSBDouble" => Kind::real(8, false),
        _ => return Err(label.wrong(kind, "a signed or unsigned integer, or an IEEE 754 number")),
    })
}

/// What the label says about the stored numbers.
pub fn said(label: &Label, kind: Kind, sphere: f64, notes: &mut Vec<String>) -> Result<Said, SurveyError> {
    let array = label.array;
    let element = children(array, "Element_Array").next().ok_or_else(|| label.missing("Element_Array"))?;
    let unit = label.one(element, "unit")?;
    let known = unit.map_or(Some(1.0), |unit| unit::length(text(unit)));
    if unit.is_none() {
        notes.push("the label does not name the unit of its heights: metres are assumed".into());
    }
    let unknown_unit =
        unit.filter(|_| known.is_none()).map(|unit| [label.place(unit), text(unit).to_owned()]);
    let metres = known.unwrap_or(1.0);
    let plain = |unit: &str| unit.is_empty().then_some(1.0);
    let number =
        |name: &str, usual: f64| label.one(array, name)?.map_or(Ok(usual), |node| stored(label, node, kind));
    let [low, high] = [f64::NEG_INFINITY, f64::INFINITY];
    Ok(Said {
        voids: voids(label, kind, notes)?,
        valid: [number("valid_minimum", low)?, number("valid_maximum", high)?],
        stated: [number("minimum", low)?, number("maximum", high)?],
        scale: label.number_of(element, &["scaling_factor"], plain)?.unwrap_or(1.0) * metres,
        offset: label.number_of(element, &["value_offset"], plain)?.unwrap_or(0.0) * metres,
        unknown_unit,
        sphere,
        stored: kind.stored(),
    })
}

/// Stored numbers that mark voids. A note tells of a mark that no sample can hold.
fn voids(label: &Label, kind: Kind, notes: &mut Vec<String>) -> Result<Vec<[f64; 2]>, SurveyError> {
    let mut voids = Vec::new();
    for node in children(label.array, "Special_Constants").flat_map(|constants| constants.children()) {
        let word = ARRAY.of_name(node.tag_name().name());
        if !word.is_some_and(|word| matches!(word.fate, Fate::Void(_))) || text(node).is_empty() {
            continue;
        }
        let number = stored(label, node, kind)?;
        if !kind.can_hold(number) {
            notes.push(format!("{}: no sample can hold {}", label.place(node), text(node)));
        }
        voids.push([number; 2]);
    }
    Ok(voids)
}

/// A stored number: as a number, or by its bits.
fn stored(label: &Label, node: Node, kind: Kind) -> Result<f64, SurveyError> {
    let text = text(node);
    let hex = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"));
    let bits = hex.and_then(|digits| u64::from_str_radix(digits, 16).ok()).or_else(|| in_base(text));
    let number = bits.map(|bits| kind.number_of_bits(bits)).or_else(|| text.parse().ok());
    let expected = "a number, 16#DIGITS# or 0xDIGITS";
    number.filter(|number: &f64| !number.is_nan()).ok_or_else(|| label.wrong(node, expected))
}
