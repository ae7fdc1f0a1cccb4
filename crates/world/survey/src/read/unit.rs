//! Units of lengths and angles, by the names and codes that files give them.

/// Metres of a US survey foot: 1200/3937 (Federal Register 59-5442, 1959).
const SURVEY_FOOT: f64 = 1200.0 / 3937.0;

/// Metres of a unit of length; `None` if the name is not known. Capitals, `_` and `-` do not matter.
pub fn length(name: &str) -> Option<f64> {
    let name = name.to_ascii_lowercase().replace(['_', '-', '.'], " ");
    let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
    Some(match name.as_str() {
        "m" | "meter" | "meters" | "metre" | "metres" => 1.0,
        "km" | "kilometer" | "kilometers" | "kilometre" | "kilometres" => 1000.0,
        "dm" | "decimeter" | "decimeters" | "decimetre" | "decimetres" => 0.1,
        "cm" | "centimeter" | "centimeters" | "centimetre" | "centimetres" => 0.01,
        "mm" | "millimeter" | "millimeters" | "millimetre" | "millimetres" => 0.001,
        "ft" | "foot" | "feet" | "international foot" | "international feet" => 0.3048,
        "us survey foot" | "us survey feet" | "survey foot" | "survey feet" | "us ft" | "ftus"
        | "us foot" | "us feet" | "foot us" | "sft" => SURVEY_FOOT,
        "yd" | "yard" | "yards" => 0.9144,
        "fathom" | "fathoms" => 1.8288,
        "mi" | "mile" | "miles" => 1609.344,
        "nmi" | "nautical mile" | "nautical miles" => 1852.0,
        _ => return None,
    })
}

/// Sizes of one unit are alike to this part: files round them.
pub const ALIKE: f64 = 1e-6;

/// Radians of a unit of angle; `None` if the name is not known. Capitals, `_` and `-` do not matter.
pub fn angle(name: &str) -> Option<f64> {
    let letters: String = name.chars().filter(char::is_ascii_alphabetic).collect();
    let degree = std::f64::consts::PI / 180.0;
    Some(match letters.to_ascii_lowercase().as_str() {
        "degree" | "degrees" | "deg" | "decimaldegree" | "decimaldegrees" => degree,
        "radian" | "radians" | "rad" => 1.0,
        "grad" | "grads" | "gon" | "gons" => 0.9 * degree,
        "arcminute" | "arcminutes" | "minute" | "minutes" => degree / 60.0,
        "arcsecond" | "arcseconds" | "second" | "seconds" => degree / 3600.0,
        _ => return None,
    })
}

/// Metres of a unit of length by its EPSG code; `None` if the code is not known.
pub fn length_of_code(code: u16) -> Option<f64> {
    Some(match code {
        9001 => 1.0,
        9002 => 0.3048,
        9003 => SURVEY_FOOT,
        9014 => 1.8288,
        9030 => 1852.0,
        9036 => 1000.0,
        9093 => 1609.344,
        9096 => 0.9144,
        1025 => 0.001,
        1033 => 0.01,
        _ => return None,
    })
}

/// Radians of a unit of angle by its EPSG code; `None` if the code is not known.
pub fn angle_of_code(code: u16) -> Option<f64> {
    let degree = std::f64::consts::PI / 180.0;
    Some(match code {
        9101 => 1.0,
        9102 | 9122 => degree,
        9103 => degree / 60.0,
        9104 => degree / 3600.0,
        9105 | 9106 => 0.9 * degree,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::{angle_of_code, length, length_of_code};

    #[test]
    fn feet_are_of_two_kinds() {
        assert_eq!(length("FEET"), Some(0.3048));
        assert_eq!(length("US survey foot"), length_of_code(9003));
        assert!((length("ftUS").unwrap() / 0.3048 - 1.000_002).abs() < 1e-9);
    }

    #[test]
    fn names_in_any_writing() {
        assert_eq!([length("Kilometres"), length("US_SURVEY-FOOT").map(|_| 1000.0)], [Some(1000.0); 2]);
        assert_eq!([length("degree"), length("")], [None; 2]);
    }

    #[test]
    fn whole_turns() {
        let turn = |code: u16, count: f64| angle_of_code(code).unwrap() * count / std::f64::consts::TAU;
        for (code, count) in [(9102, 360.0), (9103, 21_600.0), (9104, 1_296_000.0), (9105, 400.0)] {
            assert!((turn(code, count) - 1.0).abs() < 1e-14, "{code}");
        }
    }
}
