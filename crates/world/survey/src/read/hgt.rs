//! SRTM tiles, `.hgt`: heights alone; the name of the file says where they lie (SRTM documentation, NASA/USGS, section 2).

use std::path::Path;

use quantities::radians;

use super::bands;
use super::earth;
use super::gate;
use super::kind::Kind;
use super::opened::Opened;
use super::options::ReadOptions;
use super::raw::Raw;
use super::refusal::field;
use super::samples::{Conversion, Said};
use super::words::{Decider, seen};
use crate::elevation::{Affine, Frame, Grid};
use crate::error::SurveyError;

/// Lines and columns that a tile of one degree may have: samples stand on its edges too.
const SIZES: [[usize; 2]; 3] = [[1201, 1201], [3601, 3601], [3601, 1801]];
/// Stored number of a void.
const VOID: f64 = -32768.0;

/// Whether a file is named as a tile is.
pub fn is_tile(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("hgt"))
}

/// Opens a tile: 16-bit integers, the highest byte first, the northernmost line first.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    bands::of_raw(path, options, 1)?;
    options.expect_no_place()?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let corner = corner(&name).ok_or_else(|| {
        let advice = "name the file by its south-west corner";
        field(path, "name of the file", seen(&name), "N45E006.hgt or the like", advice)
    })?;
    let (_, found) = gate::open(path)?;
    let [lines, columns] = size(path, found)?;
    let said = Said { voids: vec![[VOID; 2]], sphere: earth::RADIUS, ..Said::default() };
    let step = [lines, columns].map(|count| radians(1.0) / (count - 1) as f64);
    let affine = Affine { first: [radians(corner[0] + 1.0), radians(corner[1])], step: [-step[0], step[1]] };
    let frame = Frame::Geographic { radius: earth::RADIUS };
    Ok(Opened {
        grid: Grid { lines, columns, affine, frame },
        path: path.to_path_buf(),
        title: String::new(),
        sources: vec![path.to_path_buf()],
        notes: [vec![earth::note()], Decider::new(path, options).finish()?].concat(),
        conversion: Conversion::new(path, options, said)?,
        samples: Box::new(Raw::lines_of(path, [lines, columns], Kind::integer(2, true, false), 0)),
    })
}

/// Lines and columns of a tile of so many bytes.
fn size(path: &Path, found: u64) -> Result<[usize; 2], SurveyError> {
    let bytes = |[lines, columns]: [usize; 2]| (2 * lines * columns) as u64;
    SIZES.into_iter().find(|size| bytes(*size) == found).ok_or_else(|| {
        let expected = SIZES.map(|size| format!("{} ({} x {})", bytes(size), size[0], size[1])).join(", ");
        let advice = "it is truncated, or no tile of one degree: fetch it again";
        field(path, "size of the file", format!("{found} bytes"), expected, advice)
    })
}

/// Latitude and longitude (degrees) of the south-west corner by the name of a tile: `S05W120`, with more behind it.
fn corner(name: &str) -> Option<[f64; 2]> {
    let name = name.to_ascii_uppercase();
    let side = |text: &str, [positive, negative]: [char; 2]| match text.chars().next()? {
        letter if letter == positive => Some(1.0),
        letter if letter == negative => Some(-1.0),
        _ => None,
    };
    let degrees = |at: std::ops::Range<usize>, most: f64| {
        let digits = name.get(at)?;
        let is_number = digits.bytes().all(|byte| byte.is_ascii_digit());
        digits.parse().ok().filter(|degrees: &f64| is_number && *degrees <= most)
    };
    let latitude = side(&name, ['N', 'S'])? * degrees(1..3, 90.0)?;
    let longitude = side(name.get(3..)?, ['E', 'W'])? * degrees(4..7, 180.0)?;
    let ends = name.get(7..)?.starts_with(['.', '_']);
    ends.then_some([latitude, longitude])
}

#[cfg(test)]
mod tests {
    use super::corner;

    #[test]
    fn names_are_corners() {
        assert_eq!(corner("N45E006.hgt"), Some([45.0, 6.0]));
        assert_eq!(corner("s05w120.SRTMGL1.hgt"), Some([-5.0, -120.0]));
        assert_eq!(corner("S00E000.hgt"), Some([0.0, 0.0]));
        for name in [
            "tile.hgt",
            "N45E06.hgt",
            "N95E006.hgt",
            "N45E200.hgt",
            "N4xE006.hgt",
            "N45E006x.hgt",
            "\u{e9}45E006.hgt",
        ] {
            assert_eq!(corner(name), None, "{name}");
        }
    }
}
