//! `[sea]`: a flat sea that moves by false normals.

use diagnostics::Reader;
use faces::{Mean, Pattern, SeaState, TwoSine};
use quantities::radians;
use wind_waves::{Wind, WindWaves};

use super::{area, part};
use crate::SeaWish;

/// Waters of the study's pictures: linear red, green, blue (chosen).
const COLOUR: [f64; 3] = [0.10, 0.24, 0.36];

/// The words of the patterns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Word {
    Random,
    TwoSine,
    MirrorRows,
    Swell,
    Travelling,
}

const WORDS: [(&str, Word); 5] = [
    ("random", Word::Random),
    ("two-sine", Word::TwoSine),
    ("mirror-rows", Word::MirrorRows),
    ("swell", Word::Swell),
    ("travelling", Word::Travelling),
];

impl Word {
    /// Keys that the pattern takes.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Random => &["seed"],
            Self::TwoSine => &["length_m", "second_length_m", "second_azimuth_deg"],
            Self::MirrorRows | Self::Swell | Self::Travelling => &["length_m"],
        }
    }
}

/// Keys of all patterns.
const KEYS: [&str; 4] = ["seed", "length_m", "second_length_m", "second_azimuth_deg"];

pub(super) fn sea(table: &Reader) -> Option<SeaWish> {
    let square = table.f64("square_m").between(0.01, 1e5).unit("m").required();
    let area = area(table);
    let height = table.f64("height_m").between(-1e5, 1e5).unit("m").default(0.0);
    let pattern = pattern(table);
    let normals = table.u32("normals").between(2, 65_536).default(16);
    let normal_elevation = table.f64("normals_deg").above(0.0).at_most(90.0).unit("degrees").map(radians);
    let normal_elevation = normal_elevation.default(radians(75.0));
    let state = table.u32("state").between(0, 3).default(2);
    let held = |mean: Option<f64>| mean.map_or(Mean::AsReported, Mean::Held);
    let mean =
        table.f64("mean").above(0.0).at_most(1.0).or_word("as-reported").map(held).default(Mean::USUAL);
    let colour = table.f64_array::<3>("colour").between(0.0, 1.0).default(COLOUR);
    let waves = part(table, "waves", waves);
    Some(SeaWish {
        square: square?,
        area: area?,
        height: height?,
        pattern: pattern?,
        normals: normals?,
        normal_elevation: normal_elevation?,
        state: SeaState::ALL[state? as usize],
        mean: mean?,
        colour: colour?,
        waves: waves?,
    })
}

/// `waves`: the wind over a sea of true waves.
fn waves(table: &Reader) -> Option<Wind> {
    let speed = table.f64("wind_m_s").between(0.5, 50.0).unit("m/s").required();
    let towards = table.f64("towards_deg").between(-360.0, 360.0).unit("degrees").map(radians).default(0.0);
    let seed = table.u64("seed").default(1);
    let components = table.u32("components").between(8, 1024).default(64);
    let shortest = table.f64("shortest_m").between(0.1, 1000.0).unit("m").default(5.0);
    let wind =
        Wind { speed: speed?, towards: towards?, seed: seed?, components: components?, shortest: shortest? };
    match WindWaves::new(&wind) {
        Ok(_) => Some(wind),
        Err(fault) => {
            let title = format!("`{}`: {fault}", table.path("shortest_m"));
            table.report(table.problem("shortest_m", title));
            None
        }
    }
}

fn pattern(table: &Reader) -> Option<Pattern> {
    let length = |key: &str, usual: f64| table.f64(key).above(0.0).at_most(1e6).unit("m").default(usual);
    let word = table.one_of("pattern", &WORDS).default(Word::Random);
    let (seed, first, second) =
        (table.u64("seed").default(1), length("length_m", 40.0), length("second_length_m", 25.0));
    let turned = table.f64("second_azimuth_deg").between(-360.0, 360.0).unit("degrees").map(radians);
    let turned = turned.default(radians(30.0));
    let (word, seed, first, second, turned) = (word?, seed?, first?, second?, turned?);
    let idle = KEYS.into_iter().find(|key| table.has(key) && !word.keys().contains(key));
    if let Some(key) = idle {
        let title = format!("`{}` says nothing about this pattern", table.path(key));
        table.report(table.problem(key, title).expected(format!("no key but {}", word.keys().join(", "))));
        return None;
    }
    Some(match word {
        Word::Random => Pattern::Random { seed },
        Word::TwoSine => Pattern::TwoSine(TwoSine { lengths: [first, second], turned }),
        Word::MirrorRows => Pattern::MirrorRows { length: first },
        Word::Swell => Pattern::Swell { length: first },
        Word::Travelling => Pattern::Travelling { length: first },
    })
}
