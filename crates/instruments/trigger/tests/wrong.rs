//! Conditions that are none: one error each, at its place.

use signal::{Kind, Signal, Unit};
use trigger::{Condition, Machine, Trigger};

const TABLE: [Signal; 8] = [
    Signal::ground("tg.height", Unit::Metre, "", ""),
    Signal::ground("fg.height", Unit::Metre, "", ""),
    Signal::ground("dpp.blank", Unit::Gate, "", ""),
    Signal::digital("tg.red.hold", Unit::Corner, Kind::Bus, "", ""),
    Signal::digital("sweep.fold.x", Unit::Number, Kind::Event, "", ""),
    Signal::digital("sweep.fold.y", Unit::Number, Kind::Event, "", ""),
    Signal::digital("dpu.late", Unit::Number, Kind::Event, "", ""),
    Signal::display("sm.write", Unit::Reflectivity, "", ""),
];

/// The error of `text`: what it says, and the part of the text that is underlined.
fn error(text: &str) -> (String, String) {
    let error = Condition::parse(text, &TABLE).expect_err(text);
    let told = error.to_string();
    let lines: Vec<&str> = told.lines().collect();
    let [fault, written, mark] = lines[..] else { panic!("{told}") };
    assert_eq!(written, format!("  {text}"));
    let column = mark.find('^').unwrap();
    let meant = written.chars().skip(column).take(mark.matches('^').count()).collect();
    (fault.into(), meant)
}

#[test]
fn each_is_told_at_its_place() {
    for (text, place, words) in [
        ("tg.hight > 1700", "tg.hight", "did you mean `tg.height`?"),
        ("qqq > 1", "qqq", "no signal is called `qqq`; `lunoid signals`"),
        ("", "", "found the end, expected a signal"),
        ("tg.height", "", "found the end, expected a comparison"),
        ("tg.height >", "", "found the end, expected a number"),
        ("tg.height > high", "high", "found `high`, expected a number"),
        ("tg.height > 5 or blank", "or", "found `or`, expected `and` or the end"),
        ("tg.height > 5 and", "", "found the end, expected a signal"),
        ("tg.height > 5 and and blank", "and", "found `and`, expected a signal"),
        ("tg.height in 5", "", "expected `..` and the upper end"),
        ("tg.height in 7..5", "7..5", "the window 7..5 is empty"),
        ("tg.height in 7..", "", "expected the upper end"),
        ("rising tg.height", "", "found the end, expected a number"),
        ("rising tg.height 5 by -1", "-1", "found -1, expected a hysteresis of 0 or more"),
        ("rising sweep.fold.x 1", "sweep.fold.x", "is an event, expected a voltage, a gate or a bus"),
        ("slope tg.height > 5", "", "expected /sample, /m or /us"),
        ("slope tg.height > 5/km", "km", "found `km`, expected sample, m or us"),
        ("slope dpp.blank > 5/m", "dpp.blank", "is a gate, expected a voltage"),
        ("slope sm.write > 5/m", "/m", "found `/m`, expected /sample: a line of the display"),
        ("tg.height shorter 3", "tg.height", "is a voltage, expected a gate"),
        ("dpp.blank shorter -3", "-3", "expected a width of 0 or more"),
        ("dpp.blank shorter", "", "expected a width"),
        ("saturation dpp.blank", "dpp.blank", "is a gate, expected a voltage"),
        ("saturation tg.hoight", "tg.hoight", "did you mean `tg.height`?"),
        ("fold z", "z", "found `z`, expected x, y"),
        ("fold x = 7", "7", "found `7`, expected a stop, 0 or 1"),
        ("fold != 0.5", "0.5", "found `0.5`, expected a stop, 0 or 1"),
        (
            "tg.height > 5 and sm.write > 0.5",
            "sm.write",
            "runs down the display and `tg.height` along the ground",
        ),
        ("saturation and sm.write > 0.5", "saturation", "expected a signal of the display"),
        ("tg.height > 1e999", "1e999", "found `1e999`, expected a number"),
        ("tg.height > 5 §", "§", "found `§`, expected `and`"),
        ("µ.height > 5", "µ.height", "no signal is called `µ.height`"),
        ("5 < tg.height", "5", "found `5`, expected a signal"),
    ] {
        let (fault, meant) = error(text);
        assert!(fault.contains(words), "{text}: {fault}");
        assert_eq!(meant.trim(), place, "{text}: {fault}");
    }
}

#[test]
fn a_block_that_is_left_out_is_told() {
    let wires: Vec<signal::Wire> = TABLE
        .into_iter()
        .filter(|signal| signal.prefix() != "fg")
        .map(|signal| signal::Wire { signal, full_scale: 1.0, volts: 1.0, datum: 0.0 })
        .collect();
    let condition = Condition::parse("dpp.blank and fg.height > 0", &TABLE).unwrap();
    let machine = Machine { wires: &wires, saturation: None, sample_us: 1.0 };
    let error = Trigger::new(&condition, &machine).unwrap_err();
    assert!(
        error.to_string().starts_with("this machine has no `fg.height`: its feature-generator is left out")
    );
    assert_eq!(&error.text[error.place], "fg.height");
}
