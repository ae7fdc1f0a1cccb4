//! A pattern of false normals in a list.

use diagnostics::Reader;
use quantities::radians;

use super::list::{report, report_at, turning};
use crate::board::Board;
use crate::cone::Cone;
use crate::error::FaceError;
use crate::face::Vertex;
use crate::mesh::Loaded;
use crate::pattern::{Pattern, TwoSine};
use crate::states::Mean;
use crate::sun::SunProgramme;
use crate::warning::Warning;

/// Keys of a list that a pattern stands in for.
const INSTEAD: [&str; 3] = ["vertices", "normals", "face"];

/// The squares of a pattern, and the factor that holds their mean.
pub(super) fn squares(
    table: &Reader,
    list: &str,
    sun: Option<SunProgramme>,
    most: usize,
    warnings: &mut Vec<Warning>,
) -> Option<(Loaded, f64)> {
    for key in INSTEAD {
        table.know(key);
        if table.has(key) {
            let title = format!("`{key}` beside a pattern, which makes its own faces");
            table.report(table.problem(key, title).expected("`pattern`, or `vertices` and `face`"));
        }
    }
    let written = table.table("pattern")?;
    let side = written.f64("side_m").above(0.0).required();
    let [rows, columns] = ["rows", "columns"].map(|key| range(&written, key));
    let colour = written.f64_array("colour").between(0.0, 1.0).required();
    let count = written.u32("normals").at_least(2).default(16);
    let alpha = written.f64("alpha_deg").above(0.0).at_most(90.0).default(75.0);
    let held = written.f64("hold_mean").above(0.0).at_most(1.0).optional();
    let is_ring = |ends: &[f64; 2]| ends[0] < ends[1];
    let ring = written.f64_array("ring_m").at_least(0.0).must("the second above the first", is_ring);
    let ring = ring.map(Some).default(None);
    let pattern = rule(&written);
    let (pattern, colour) = (pattern?, colour?);
    let refused = |error: FaceError| report_at(&written, &error);
    let cone = Cone::new(count?, radians(alpha?)).map_err(refused).ok()?;
    let board = Board::new(side?, rows?, columns?).map_err(refused).ok()?;
    let board = match ring? {
        Some([inner, outer]) => board.ring(inner, outer).map_err(refused).ok()?,
        None => board,
    };
    let gain = gain(&written, &cone, held, sun?, warnings)?;
    let vertex = |vertex: crate::board::GridVertex| {
        let [north, east] = vertex.place;
        let normal = cone.normal(pattern.number(vertex, cone.count()));
        Vertex { place: [north, east, 0.0].into(), normal: Some(normal) }
    };
    let loaded = board.squares(list, colour, most, vertex).map_err(refused).ok()?;
    Some((loaded, gain))
}

/// Factor of the brightness under the list's sun; a held mean needs a sun of the list's own.
fn gain(
    written: &Reader,
    cone: &Cone,
    held: Option<f64>,
    sun: SunProgramme,
    warnings: &mut Vec<Warning>,
) -> Option<f64> {
    let own = turning(sun);
    if let Some(own) = own {
        warnings.extend(cone.warnings(own.elevation()));
    }
    match (held, own) {
        (None, _) => (!written.has("hold_mean")).then_some(1.0),
        (Some(_), None) => {
            let problem =
                written.problem("hold_mean", "a held mean under the scenario's sun, which may change");
            written.report(problem.expected("a table `sun` in this list, or no key `hold_mean`"));
            None
        }
        (Some(held), Some(own)) => Mean::Held(held)
            .gain(cone, own.elevation())
            .map_err(|error| report(written, "hold_mean", &error))
            .ok(),
    }
}

/// Rows or columns of squares: `[from, to]`, whole numbers, `to` excluded.
fn range(written: &Reader, key: &str) -> Option<std::ops::Range<i64>> {
    let is_whole = |ends: &[f64; 2]| ends.iter().all(|end| end.fract() == 0.0) && ends[0] < ends[1];
    let field = written.f64_array::<2>(key).between(-1e6, 1e6);
    let [from, to] = field.must("whole, the second above the first", is_whole).required()?;
    Some(from as i64..to as i64)
}

fn rule(written: &Reader) -> Option<Pattern> {
    let words =
        ["random", "two-sine", "mirror-rows", "swell", "travelling", "radial"].map(|word| (word, word));
    let Some(word) = written.one_of("rule", &words).required() else {
        ["seed", "length_m", "second_length_m", "turned_deg"].iter().for_each(|key| written.know(key));
        return None;
    };
    if word == "random" {
        return Some(Pattern::Random { seed: written.u64("seed").default(1)? });
    }
    let length = written.f64("length_m").above(0.0).required();
    if word == "two-sine" {
        let second = written.f64("second_length_m").above(0.0).required();
        let turned = written.f64("turned_deg").between(-360.0, 360.0).default(30.0);
        return Some(Pattern::TwoSine(TwoSine { lengths: [length?, second?], turned: radians(turned?) }));
    }
    let length = length?;
    Some(match word {
        "mirror-rows" => Pattern::MirrorRows { length },
        "swell" => Pattern::Swell { length },
        "radial" => Pattern::Radial { length },
        _ => Pattern::Travelling { length },
    })
}
