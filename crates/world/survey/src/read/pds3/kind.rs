//! How a PDS3 label says how its samples are stored.

use super::IMAGE;
use crate::error::SurveyError;
use crate::read::kind::{Kind, in_base};
use crate::read::label::Label;

/// From the keywords SAMPLE_TYPE, SAMPLE_BITS and SAMPLE_BIT_MASK.
pub fn of(label: &Label) -> Result<Kind, SurveyError> {
    let kind = label.find(IMAGE, "SAMPLE_TYPE").ok_or_else(|| label.missing("SAMPLE_TYPE"))?;
    let bits = label.count(IMAGE, "SAMPLE_BITS")?.ok_or_else(|| label.missing("SAMPLE_BITS"))?;
    let name = label.text(IMAGE, "SAMPLE_TYPE")?.unwrap_or_default().to_ascii_uppercase();
    let base = name.replacen("UNSIGNED_", "", 1);
    let signed = base == name;
    let (real, little) = match base.as_str() {
        "PC_REAL" if signed => (true, true),
        "IEEE_REAL" | "REAL" | "FLOAT" | "MAC_REAL" | "SUN_REAL" if signed => (true, false),
        "LSB_INTEGER" | "PC_INTEGER" | "VAX_INTEGER" => (false, true),
        "INTEGER" | "MSB_INTEGER" | "MAC_INTEGER" | "SUN_INTEGER" => (false, false),
        _ => {
            let expected = "LSB_INTEGER, MSB_INTEGER (also unsigned), PC_REAL or IEEE_REAL";
            return Err(label.wrong(kind, expected));
        }
    };
    let fits = if real { [32, 64].contains(&bits) } else { [8, 16, 32].contains(&bits) };
    if !fits {
        let statement = label.find(IMAGE, "SAMPLE_BITS").unwrap_or(kind);
        return Err(label.wrong(statement, "8, 16 or 32 for integers, 32 or 64 for reals"));
    }
    let kind = Kind { bytes: bits as usize / 8, real, signed, little };
    check_mask(kind, label)?;
    Ok(kind)
}

/// A mask must let all bits through: what other bits hold is not said.
fn check_mask(kind: Kind, label: &Label) -> Result<(), SurveyError> {
    let Some(mask) = label.text(IMAGE, "SAMPLE_BIT_MASK")? else { return Ok(()) };
    let all = u64::MAX >> (64 - 8 * kind.bytes);
    match label.find(IMAGE, "SAMPLE_BIT_MASK") {
        Some(statement) if in_base(mask).or_else(|| mask.parse().ok()) != Some(all) => {
            Err(label.wrong(statement, &format!("2#{}#, all bits", "1".repeat(8 * kind.bytes))))
        }
        _ => Ok(()),
    }
}
