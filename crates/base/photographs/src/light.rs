//! What a file says about the light of its codes: sRGB, as they are taken here, or something else.

use crate::error::PhotographError;

/// Gamma of files that mean sRGB (PNG, 4.3.2.1): 1/2.2, as programs round it.
const SRGB_GAMMA: std::ops::RangeInclusive<f64> = 0.45..=0.46;
/// What the number of a chunk `gAMA` is divided by.
const GAMMA_UNIT: f64 = 100_000.0;
/// Descriptions of colour profiles whose codes are those of sRGB, or of its curve as gamma.
const SRGB_PROFILES: [&str; 2] = ["srgb", "gray gamma 2.2"];
/// Bytes of a profile before its table of tags.
const PROFILE_HEADER: usize = 128;
/// Most tags of a profile that are looked at.
const MOST_TAGS: usize = 200;
/// Most characters of a description that are told.
const MOST_CHARACTERS: usize = 60;

/// Sees that a colour profile is one of sRGB.
pub fn expect_profile(format: &'static str, profile: &[u8]) -> Result<(), PhotographError> {
    let name = description(profile).unwrap_or_else(|| "without a description".into());
    let lower = name.to_lowercase();
    if SRGB_PROFILES.iter().any(|known| lower.contains(known)) {
        return Ok(());
    }
    let shown: String = name.chars().take(MOST_CHARACTERS).collect();
    Err(PhotographError::Light { format, found: format!("a colour profile {shown}") })
}

/// Sees that a PNG's chunk `cICP`, or else `gAMA`, says sRGB (ITU-T H.273: primaries 1, transfer 13). Its chunk `sRGB` goes before `gAMA`, as the
/// format has it.
pub fn expect_chunks(format: &'static str, png: &[u8]) -> Result<(), PhotographError> {
    let refused = |found| Err(PhotographError::Light { format, found });
    match (chunk(png, b"cICP"), chunk(png, b"sRGB"), chunk(png, b"gAMA")) {
        (Some([1, 13, ..]), _, _) | (None, Some(_), _) | (None, None, None) => Ok(()),
        (Some(found), _, _) => refused(format!("code points {found:?}")),
        (None, None, Some(found)) => {
            let scaled = found.first_chunk().map(|bytes| u32::from_be_bytes(*bytes));
            let gamma = scaled.map_or(0.0, |scaled| f64::from(scaled) / GAMMA_UNIT);
            if SRGB_GAMMA.contains(&gamma) { Ok(()) } else { refused(format!("gamma {gamma}")) }
        }
    }
}

/// Data of the first chunk of a kind before the pixels of a PNG.
fn chunk<'a>(png: &'a [u8], kind: &[u8; 4]) -> Option<&'a [u8]> {
    let mut rest = png.get(8..)?;
    loop {
        let length = u32::from_be_bytes(*rest.first_chunk()?) as usize;
        let found = rest.get(4..8)?;
        if found == b"IDAT" {
            return None;
        }
        let data = rest.get(8..8_usize.checked_add(length)?)?;
        if found == kind {
            return Some(data);
        }
        rest = rest.get(length.checked_add(12)?..)?;
    }
}

/// Description of a colour profile (ICC.1, 9.2.41): text of its tag `desc`, of version 2 or 4.
fn description(profile: &[u8]) -> Option<String> {
    let number = |at: usize| Some(u32::from_be_bytes(*profile.get(at..)?.first_chunk()?) as usize);
    let tags = number(PROFILE_HEADER)?.min(MOST_TAGS);
    let tag = (0..tags)
        .map(|tag| PROFILE_HEADER + 4 + 12 * tag)
        .find(|at| profile.get(*at..at + 4) == Some(b"desc"))?;
    let at = number(tag + 4)?;
    match profile.get(at..at.checked_add(4)?)? {
        b"desc" => {
            let length = number(at + 8)?;
            let text = profile.get(at + 12..(at + 12).checked_add(length)?)?;
            Some(String::from_utf8_lossy(text).trim_end_matches('\0').to_owned())
        }
        b"mluc" => {
            let (length, from) = (number(at + 20)?, number(at + 24)?);
            let text = profile.get(at.checked_add(from)?..at.checked_add(from)?.checked_add(length)?)?;
            let units: Vec<u16> =
                text.as_chunks::<2>().0.iter().map(|unit| u16::from_be_bytes(*unit)).collect();
            Some(String::from_utf16_lossy(&units))
        }
        _ => None,
    }
}
