//! What it costs to take the ground as flat (section 19.7), over the ground of a scenario.
//!
//! **Law.** At places along the path a mast casts its edge over true ground and over flat ground; the angle between the two
//! at the view port is measured in space and held against the report's formula with the height that was found.
//! **Our choices.** Places are spread evenly over the frames, the sun evenly around each place; beside suns of given
//! elevation there is the scenario's own, at each frame's time. The mast is upright. Ground is the finest level and its
//! craters: no bodies, no curvature.

use std::f64::consts::TAU;

use control_plane::MachineStage;
use exact::Ceilings;
use landscape::Sun;
use quantities::degrees;
use scenario::PoseRow;
use serde::Serialize;
use vehicle_shadow::{Mast, MastEdge, flat_error, small_flat_error};

/// How far the measured error may be off the formula's (rad): rounding.
pub const FLAT_ERROR_ROUNDING: f64 = 1e-9;

/// Which edges are looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatGroundPlan {
    /// Mast whose shadow has these edges.
    pub mast: Mast,
    /// Elevations of suns (rad), above 0.
    pub elevations: Vec<f64>,
    /// Places along the path, at most one a frame.
    pub places: usize,
    /// Azimuths of each of these suns at each place.
    pub azimuths: usize,
}

/// An edge that the view port sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeenEdge {
    /// Frame whose place the mast stands at.
    pub frame: u64,
    /// Direction of the sun that casts the shadow.
    pub sun: Sun,
    /// From the foot to the edge on flat ground (m): d.
    pub distance: f64,
    /// Height of the edge over the foot (m): z.
    pub rise: f64,
    /// Angle (rad) between the edges, measured.
    pub measured: f64,
    /// The same by the formula.
    pub formula: f64,
    /// By its form for small angles.
    pub small: f64,
}

/// Means and extremes over the edges that are seen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FlatGroundFigures {
    /// Mean of d (m).
    pub mean_distance_m: f64,
    /// Mean of the size of z (m).
    pub mean_rise_m: f64,
    /// Mean of the measured error (rad).
    pub mean_rad: f64,
    /// Largest measured error (rad).
    pub largest_rad: f64,
    /// Mean by the formula (rad).
    pub formula_mean_rad: f64,
    /// Mean by the form for small angles (rad).
    pub small_mean_rad: f64,
    /// Largest difference between measured and formula (rad).
    pub largest_difference_rad: f64,
}

/// What came of one sun.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FlatGroundOutcome {
    /// Its elevation (degrees); `None` is the scenario's own sun.
    pub elevation_deg: Option<f64>,
    /// Masts that were stood up.
    pub masts: usize,
    /// Of these without light.
    pub dark: usize,
    /// Of these whose ray meets no stored ground.
    pub off_ground: usize,
    /// Of these whose edge nearer ground hides.
    pub hidden: usize,
    /// Of these whose edge is seen.
    pub seen: usize,
    /// Over these; `None` if there are none.
    pub figures: Option<FlatGroundFigures>,
    /// These, in order of frames.
    #[serde(skip)]
    pub edges: Vec<SeenEdge>,
}

impl FlatGroundOutcome {
    /// Whether the measured error is the formula's at every edge, to rounding.
    pub fn holds(&self) -> bool {
        self.figures.is_none_or(|figures| figures.largest_difference_rad <= FLAT_ERROR_ROUNDING)
    }
}

/// Edges of `plan` over the ground of `stage`, along the poses `path`: the scenario's own sun first, then each elevation.
pub fn flat_ground(stage: &MachineStage, path: &[PoseRow], plan: &FlatGroundPlan) -> Vec<FlatGroundOutcome> {
    let ceilings = Ceilings::new(&stage.landscape);
    let chosen = spread(path, plan.places);
    let own = chosen.iter().map(|row| (*row, stage.scenery.sun(row.pose.time)));
    let around = |elevation: f64| {
        let azimuth = move |step: usize| TAU * step as f64 / plan.azimuths as f64;
        let suns =
            move |row| (0..plan.azimuths).map(move |step| (row, Sun { azimuth: azimuth(step), elevation }));
        chosen.iter().copied().flat_map(suns)
    };
    let cast = |row: &PoseRow, sun: Sun| {
        let [north, east, _] = row.pose.eye;
        plan.mast.edge(&stage.landscape, &ceilings, [north, east], sun)
    };
    let mut outcomes = vec![outcome(None, own, cast, plan.mast)];
    for &elevation in &plan.elevations {
        outcomes.push(outcome(Some(degrees(elevation)), around(elevation), cast, plan.mast));
    }
    outcomes
}

/// At most `count` rows, evenly chosen: each from the middle of its share.
fn spread(path: &[PoseRow], count: usize) -> Vec<&PoseRow> {
    let count = count.min(path.len());
    (0..count).map(|index| &path[(2 * index + 1) * path.len() / (2 * count)]).collect()
}

fn outcome<'a>(
    elevation_deg: Option<f64>,
    masts: impl Iterator<Item = (&'a PoseRow, Sun)>,
    cast: impl Fn(&PoseRow, Sun) -> MastEdge,
    mast: Mast,
) -> FlatGroundOutcome {
    let mut outcome = FlatGroundOutcome {
        elevation_deg,
        masts: 0,
        dark: 0,
        off_ground: 0,
        hidden: 0,
        seen: 0,
        figures: None,
        edges: Vec::new(),
    };
    for (row, sun) in masts {
        outcome.masts += 1;
        match cast(row, sun) {
            MastEdge::Dark => outcome.dark += 1,
            MastEdge::OffGround => outcome.off_ground += 1,
            MastEdge::Hidden => outcome.hidden += 1,
            MastEdge::Seen { distance, rise, angle } => outcome.edges.push(SeenEdge {
                frame: row.frame,
                sun,
                distance,
                rise,
                measured: angle,
                formula: flat_error(mast.top, mast.eye, rise, distance),
                small: small_flat_error(mast.top, mast.eye, rise, distance),
            }),
        }
    }
    outcome.seen = outcome.edges.len();
    outcome.figures = figures(&outcome.edges);
    outcome
}

fn figures(edges: &[SeenEdge]) -> Option<FlatGroundFigures> {
    let mean = |of: fn(&SeenEdge) -> f64| edges.iter().map(of).sum::<f64>() / edges.len() as f64;
    let most = |of: fn(&SeenEdge) -> f64| edges.iter().map(of).fold(0.0, f64::max);
    (!edges.is_empty()).then(|| FlatGroundFigures {
        mean_distance_m: mean(|edge| edge.distance),
        mean_rise_m: mean(|edge| edge.rise.abs()),
        mean_rad: mean(|edge| edge.measured),
        largest_rad: most(|edge| edge.measured),
        formula_mean_rad: mean(|edge| edge.formula),
        small_mean_rad: mean(|edge| edge.small),
        largest_difference_rad: most(|edge| (edge.measured - edge.formula).abs()),
    })
}

/// Rows of the outcomes for a reader, the first with the names of the columns; `line_rad` is the height of a line of the
/// picture, at its middle (rad).
pub fn table(outcomes: &[FlatGroundOutcome], line_rad: f64) -> Vec<Vec<String>> {
    let head = [
        "sun",
        "d (m)",
        "masts",
        "dark",
        "off ground",
        "hidden",
        "seen",
        "mean |z| (m)",
        "mean (mrad)",
        "largest (mrad)",
        "mean (lines)",
        "largest (lines)",
        "formula (mrad)",
        "small form (mrad)",
        "off formula (rad)",
    ];
    let row = |outcome: &FlatGroundOutcome| {
        let sun =
            outcome.elevation_deg.map_or_else(|| "own".to_owned(), |elevation| format!("{elevation:.1} deg"));
        let figure = |decimals: usize, of: &dyn Fn(&FlatGroundFigures) -> f64| {
            outcome.figures.map_or_else(|| "-".to_owned(), |figures| format!("{:.decimals$}", of(&figures)))
        };
        let mrad = |of: fn(&FlatGroundFigures) -> f64| figure(2, &|figures| 1e3 * of(figures));
        let lines = |of: fn(&FlatGroundFigures) -> f64| figure(1, &|figures| of(figures) / line_rad);
        let mut row = vec![sun, figure(2, &|figures| figures.mean_distance_m)];
        let counts = [outcome.masts, outcome.dark, outcome.off_ground, outcome.hidden, outcome.seen];
        row.extend(counts.map(|count| count.to_string()));
        row.extend([
            figure(3, &|figures| figures.mean_rise_m),
            mrad(|figures| figures.mean_rad),
            mrad(|figures| figures.largest_rad),
            lines(|figures| figures.mean_rad),
            lines(|figures| figures.largest_rad),
            mrad(|figures| figures.formula_mean_rad),
            mrad(|figures| figures.small_mean_rad),
            outcome.figures.map_or_else(|| "-".to_owned(), |f| format!("{:.1e}", f.largest_difference_rad)),
        ]);
        row
    };
    [head.map(str::to_owned).into()].into_iter().chain(outcomes.iter().map(row)).collect()
}

/// Every edge that is seen as a row of CSV.
pub fn csv(outcomes: &[FlatGroundOutcome]) -> String {
    let mut text =
        String::from("sun,frame,azimuth_deg,elevation_deg,d_m,z_m,measured_rad,formula_rad,small_rad\n");
    for outcome in outcomes {
        let name = if outcome.elevation_deg.is_none() { "own" } else { "given" };
        for edge in &outcome.edges {
            let [azimuth, elevation] = [edge.sun.azimuth, edge.sun.elevation].map(degrees);
            let numbers =
                [azimuth, elevation, edge.distance, edge.rise, edge.measured, edge.formula, edge.small];
            let cells = numbers.map(|number| number.to_string());
            text += &format!("{name},{},{}\n", edge.frame, cells.join(","));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use landscape::Sun;
    use vehicle_shadow::{Mast, MastEdge};

    use super::{FLAT_ERROR_ROUNDING, FlatGroundOutcome, csv, outcome, spread, table};

    fn rows(count: u64) -> Vec<scenario::PoseRow> {
        let pose =
            scenario::Pose { time: 0.0, eye: [0.0; 3], attitude: landscape::Attitude::default(), yoke: 0.0 };
        let row = |frame| scenario::PoseRow { frame, pose, speed: 0.0, turn_rate: 0.0, slope: 0.0 };
        (0..count).map(row).collect()
    }

    #[test]
    fn places_are_spread_evenly() {
        let path = rows(10);
        let chosen = |count| spread(&path, count).iter().map(|row| row.frame).collect::<Vec<_>>();
        assert_eq!(chosen(1), [5]);
        assert_eq!(chosen(3), [1, 5, 8]);
        assert_eq!(chosen(50), (0..10).collect::<Vec<_>>());
    }

    /// The report's example in metres: 10, 5, 2 and 20 ft; a mast of it and one on level ground.
    fn example(angle: f64) -> FlatGroundOutcome {
        let path = rows(5);
        let sun = Sun { azimuth: 0.0, elevation: 0.4 };
        let cast = |row: &scenario::PoseRow, _: Sun| match row.frame {
            0 => MastEdge::Dark,
            1 => MastEdge::OffGround,
            2 => MastEdge::Hidden,
            3 => MastEdge::Seen { distance: 6.096, rise: 0.6096, angle },
            _ => MastEdge::Seen { distance: 6.096, rise: 0.0, angle: 0.0 },
        };
        outcome(None, path.iter().map(|row| (row, sun)), cast, Mast::REPORT)
    }

    #[test]
    fn figures_are_those_of_the_edges() {
        let whole = 0.059_630_713_131_169_39;
        let outcome = example(whole);
        let counts = [outcome.masts, outcome.dark, outcome.off_ground, outcome.hidden, outcome.seen];
        assert_eq!(counts, [5, 1, 1, 1, 2]);
        let figures = outcome.figures.unwrap();
        assert_eq!([figures.mean_rise_m, figures.largest_rad], [0.3048, whole]);
        assert_eq!(figures.mean_rad, 0.5 * whole);
        assert!((figures.small_mean_rad - 0.025).abs() < 1e-15, "{figures:?}");
        assert!(outcome.holds() && !example(whole + 2.0 * FLAT_ERROR_ROUNDING).holds());
    }

    #[test]
    fn tables_have_what_was_found() {
        let outcome = example(0.06);
        let rows = table(std::slice::from_ref(&outcome), 1e-3);
        assert_eq!(rows[0].len(), rows[1].len());
        assert_eq!(rows[1][..7], ["own", "6.10", "5", "1", "1", "1", "2"]);
        assert_eq!(rows[1][7..12], ["0.305", "30.00", "60.00", "30.0", "60.0"]);
        let nothing =
            FlatGroundOutcome { figures: None, edges: vec![], elevation_deg: Some(8.0), ..outcome.clone() };
        assert_eq!(table(&[nothing], 1e-3)[1][7..], ["-"; 8]);
        let text = csv(&[outcome]);
        assert!(text.lines().nth(1).unwrap().starts_with("own,3,0,22.9"), "{text}");
        assert!(text.lines().nth(1).unwrap().contains(",6.096,0.6096,0.06,0.0596"), "{text}");
        assert_eq!(text.lines().count(), 3);
    }
}
