//! Values of the command line.

use std::convert::Infallible;
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A parser of whole numbers from the first to the last of `allowed`.
pub fn whole<T>(allowed: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: FromStr + PartialOrd + Display + Clone,
{
    move |text| {
        let found = text.parse().ok().filter(|number| allowed.contains(number));
        found.ok_or_else(|| format!("expected a whole number from {} to {}", allowed.start(), allowed.end()))
    }
}

/// A parser of whole numbers from `least` on.
pub fn at_least<T>(least: T) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: FromStr + PartialOrd + Display + Clone,
{
    move |text| {
        let found = text.parse().ok().filter(|number| *number >= least);
        found.ok_or_else(|| format!("expected a whole number of {least} or more"))
    }
}

/// Folders of the current one in which a scenario goes by its name.
const SCENARIOS: [&str; 2] = ["scenarios", "scenarios/real"];

/// A scenario: a path, or the name of a file in one of the folders of scenarios, with its ending or without.
pub fn scenario(text: &str) -> Result<PathBuf, Infallible> {
    let path = PathBuf::from(text);
    let name = text.strip_suffix(".toml").unwrap_or(text);
    if name.contains(['/', '\\', '.']) || path.exists() || !Path::new(SCENARIOS[0]).is_dir() {
        return Ok(path);
    }
    let named = SCENARIOS.map(|folder| Path::new(folder).join(format!("{name}.toml")));
    Ok(named.iter().find(|file| file.exists()).unwrap_or(&named[0]).clone())
}

/// Reads a setting `key=value`.
pub fn setting(text: &str) -> Result<(String, String), String> {
    let (key, value) = text.split_once('=').ok_or("expected part.key=value, as raster.sweeps=525")?;
    Ok((key.trim().to_owned(), value.trim().to_owned()))
}

/// A finite number above 0.
pub fn positive(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number > 0.0 { Ok(number) } else { Err("expected a number above 0".into()) }
}

/// Lengths on the Moon, whose circumference is 1.1e7 m; a millimetre is the least side of a region.
const LENGTHS: RangeInclusive<f64> = 1e-3..=1e7;
/// Farthest place from the origin of a plane, as banks have it.
const FARTHEST: f64 = 1e9;

/// A length on the Moon.
pub fn metres(text: &str) -> Result<f64, String> {
    let expected = || "expected metres from 0.001 to 1e7".into();
    finite(text).ok().filter(|length| LENGTHS.contains(length)).ok_or_else(expected)
}

/// Two lengths on the Moon.
pub fn two_metres(text: &str) -> Result<[f64; 2], String> {
    let expected = || "expected two lengths in metres, A,B, each from 0.001 to 1e7".into();
    numbers(text).filter(|both: &[f64; 2]| both.iter().all(|one| LENGTHS.contains(one))).ok_or_else(expected)
}

/// A place on a plane: metres along both axes.
pub fn place(text: &str) -> Result<[f64; 2], String> {
    let expected = || "expected two numbers of metres, A,B, each from -1e9 to 1e9".into();
    numbers(text).filter(|both: &[f64; 2]| both.iter().all(|one| one.abs() <= FARTHEST)).ok_or_else(expected)
}

/// A finite number of 0 or more.
pub fn not_negative(text: &str) -> Result<f64, String> {
    let number = finite(text)?;
    if number >= 0.0 { Ok(number) } else { Err("expected a number of 0 or more".into()) }
}

/// A share of a hundred.
pub fn percent(text: &str) -> Result<f64, String> {
    finite(text)
        .ok()
        .filter(|share| (0.0..=100.0).contains(share))
        .ok_or("expected a number from 0 to 100".into())
}

/// Reads a finite number.
pub fn finite(text: &str) -> Result<f64, String> {
    let number: f64 = text.trim().parse().map_err(|_| "expected a number")?;
    if number.is_finite() { Ok(number) } else { Err("expected a finite number".into()) }
}

/// Two finite numbers `A,B`.
pub fn pair(text: &str) -> Result<[f64; 2], String> {
    numbers(text).ok_or_else(|| "expected two numbers, A,B".into())
}

/// Azimuth and elevation of a sun that is up (degrees).
pub fn sun(text: &str) -> Result<[f64; 2], String> {
    let up = pair(text)?;
    if (0.0..=90.0).contains(&up[1]) { Ok(up) } else { Err("expected an elevation from 0 to 90".into()) }
}

/// Four places along the axes of a plane, `S,W,N,E`, the first two below the last two.
pub fn edges(text: &str) -> Result<[f64; 4], String> {
    let ascends = |&[south, west, north, east]: &[f64; 4]| south < north && west < east;
    let is_near = |edges: &[f64; 4]| edges.iter().all(|edge| edge.abs() <= FARTHEST);
    let expected = || {
        "expected four numbers from -1e9 to 1e9: south,west,north,east, south below north and west below east"
            .into()
    };
    numbers(text).filter(|edges| ascends(edges) && is_near(edges)).ok_or_else(expected)
}

/// Metres a stored unit, or metres added to heights: no file of the Moon has more.
pub fn of_heights(text: &str) -> Result<f64, String> {
    let expected = || "expected a number from -1e9 to 1e9".into();
    finite(text).ok().filter(|number| number.abs() <= FARTHEST).ok_or_else(expected)
}

fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(finite).collect();
    numbers.ok()?.try_into().ok()
}

/// A pixel: column and line.
pub fn pixel(text: &str) -> Result<[usize; 2], String> {
    let expected = || "expected column and line, as 500,300".to_owned();
    let (column, line) = text.split_once(',').ok_or_else(expected)?;
    let number = |word: &str| word.trim().parse::<usize>().map_err(|_| expected());
    Ok([number(column)?, number(line)?])
}

/// Column and line of a pixel, and the number of a sampling point within it.
pub fn sampling_point(text: &str) -> Result<[usize; 3], String> {
    let numbers: Result<Vec<usize>, _> = text.split(',').map(|word| word.trim().parse()).collect();
    let found = numbers.ok().and_then(|numbers| numbers.try_into().ok());
    found.ok_or_else(|| "expected column, line and number of the sampling point, as 500,300,2".into())
}

#[cfg(test)]
mod tests {
    use super::{at_least, edges, metres, of_heights, pair, percent, place, setting, sun, two_metres, whole};

    #[test]
    fn whole_numbers() {
        assert_eq!((whole(1..=8_u32)("8"), at_least(1_u64)("9")), (Ok(8), Ok(9)));
        for wrong in ["0", "9", "-3", "1e9", "1.5", ""] {
            assert_eq!(whole(1..=8_u32)(wrong), Err("expected a whole number from 1 to 8".into()), "{wrong}");
        }
        assert_eq!(at_least(0_u64)("-3"), Err("expected a whole number of 0 or more".into()));
    }

    #[test]
    fn lists_of_numbers() {
        assert_eq!(pair("1, -2.5"), Ok([1.0, -2.5]));
        assert_eq!(edges("0,1,2,3"), Ok([0.0, 1.0, 2.0, 3.0]));
        assert!(edges("2,1,0,3").is_err() && edges("0,3,2,1").is_err());
        assert!(edges("0,1,1e300,3").is_err() && edges("-2e9,1,0,3").is_err());
        assert_eq!(of_heights("-1737400"), Ok(-1_737_400.0));
        assert!(of_heights("1e300").is_err() && of_heights("nan").is_err());
        assert_eq!(sun("400,90"), Ok([400.0, 90.0]));
        assert!(sun("0,90.1").is_err() && sun("0,-1").is_err());
        assert_eq!(percent("100"), Ok(100.0));
        assert_eq!(metres("0.5"), Ok(0.5));
        assert_eq!((metres("0.001"), two_metres("1, 1e7")), (Ok(0.001), Ok([1.0, 1e7])));
        for wrong in ["0", "1e300", "1e-300", "-3", "inf"] {
            assert!(metres(wrong).is_err(), "{wrong}");
            assert!(two_metres(&format!("5,{wrong}")).is_err(), "{wrong}");
        }
        assert_eq!(place("-1e9,0"), Ok([-1e9, 0.0]));
        assert!(place("1e300,0").is_err() && place("0,-2e9").is_err() && place("0").is_err());
        assert!(percent("100.5").is_err() && percent("-1").is_err() && percent("nan").is_err());
        for wrong in ["", "1", "1,2,3", "1,nan", "1,inf", "1;2"] {
            assert!(pair(wrong).is_err(), "{wrong}");
        }
        assert_eq!(setting("a.b = 1=2"), Ok(("a.b".into(), "1=2".into())));
    }
}
