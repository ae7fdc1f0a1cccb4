//! Run parameters of the generator, as `[panels]` and `--set panels.KEY=VALUE` give them.

use diagnostics::Reader;
use photo_drape::Choice;
use serde_json::Value;

use crate::program::ProgramKeys;

/// Run parameters that no other generator has, and those of sampling.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameters {
    /// How a scene is sampled.
    pub sampling: scene_sampler::Parameters,
    /// Distance of posts (m); `None` parts the longer side of the ground into 512 cells.
    pub spacing: Option<f64>,
    /// How finely cells are divided.
    pub fineness: Fineness,
    /// How cells are cut.
    pub diagonal: Diagonal,
    /// Pixels up to which coarser panels may lie beside the panels; 0 draws the panels themselves.
    pub coarser_px: f64,
    /// Where the light of a pixel comes from.
    pub shading: Shading,
    /// Which photograph rules where several see the ground.
    pub choice: Choice,
    /// Whether unseen ground has light from around.
    pub infers: bool,
    /// Light of ground beside the photographs, 0..=1.
    pub outside: f64,
    /// Whether the scenario's sun lights the ground anew.
    pub relights: bool,
    /// What the program of the thesis is asked for; it draws in place of the scene sampler if that is anything.
    pub program: ProgramKeys,
}

/// How finely cells are divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fineness {
    /// Into so many cells along each side.
    Cells(u32),
    /// Until a panel has at most so many pixels of the first photograph.
    Pixels(f64),
}

/// How cells are cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Diagonal {
    /// Along the diagonal that is shorter in space; of equals the stated one.
    Shorter,
    /// From the south-eastern to the north-western post, as the thesis states.
    Stated,
}

/// Where the light of a pixel comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shading {
    /// A look into the photographs, in the pixel's footprint.
    Texture,
    /// Vertices, mixed in space.
    Gouraud,
    /// One light a panel, as the thesis has it.
    Panel,
}

impl Default for Parameters {
    /// What its author wished for; the thesis has `panel` and `stated`.
    fn default() -> Self {
        Self {
            sampling: scene_sampler::Parameters::default(),
            spacing: None,
            fineness: Fineness::Cells(1),
            diagonal: Diagonal::Shorter,
            coarser_px: 0.0,
            shading: Shading::Texture,
            choice: Choice::Best,
            infers: true,
            outside: 0.0,
            relights: false,
            program: ProgramKeys::default(),
        }
    }
}

/// Words of the keys, with what they mean.
const DIAGONALS: [(&str, Diagonal); 2] = [("shorter", Diagonal::Shorter), ("stated", Diagonal::Stated)];
const SHADINGS: [(&str, Shading); 3] =
    [("texture", Shading::Texture), ("gouraud", Shading::Gouraud), ("panel", Shading::Panel)];
const CHOICES: [(&str, Choice); 2] = [("best", Choice::Best), ("blend", Choice::Blend)];

impl Parameters {
    /// The parameters of a `[panels]` table; the default where the table has no key.
    pub(crate) fn read(table: &Reader) -> Option<Self> {
        let usual = Self::default();
        let sampling = scene_sampler::Parameters::read(table);
        let spacing = table.f64("spacing_m").between(0.01, 1e6).unit("m").optional();
        let fineness = fineness(table);
        let diagonal = table.one_of("diagonal", &DIAGONALS).default(usual.diagonal);
        let shading = table.one_of("drape", &SHADINGS).default(usual.shading);
        let coarser_px = coarser(table, shading);
        let choice = table.one_of("choice", &CHOICES).default(usual.choice);
        let infers = table.bool("infer").default(usual.infers);
        let outside = table.f64("outside").between(0.0, 1.0).default(usual.outside);
        let relights = table.bool("relight").default(usual.relights);
        let program = ProgramKeys::read(table);
        Some(Self {
            sampling: sampling?,
            spacing: (spacing.is_some() || !table.has("spacing_m")).then_some(spacing)?,
            fineness: fineness?,
            diagonal: diagonal?,
            coarser_px: coarser_px?,
            shading: shading?,
            choice: choice?,
            infers: infers?,
            outside: outside?,
            relights: relights?,
            program: program?,
        })
    }

    /// All parameters for the record of a run.
    pub(crate) fn record(&self) -> Value {
        let mut record = self.sampling.record();
        let fineness = match self.fineness {
            Fineness::Cells(cells) => ("subdivide", cells.into()),
            Fineness::Pixels(pixels) => ("panel_pixels", pixels.into()),
        };
        let own = [
            ("spacing_m", self.spacing.into()),
            fineness,
            ("diagonal", word(&DIAGONALS, &self.diagonal).into()),
            ("drape", word(&SHADINGS, &self.shading).into()),
            ("choice", word(&CHOICES, &self.choice).into()),
            ("infer", self.infers.into()),
            ("outside", self.outside.into()),
            ("relight", self.relights.into()),
        ];
        own.into_iter().for_each(|(key, value): (&str, Value)| record[key] = value);
        // A run of all panels has the record that it always had.
        if self.coarser_px > 0.0 {
            record["coarser_px"] = self.coarser_px.into();
        }
        self.program.record(&mut record);
        record
    }
}

fn fineness(table: &Reader) -> Option<Fineness> {
    let cells = table.u32("subdivide").between(1, 64).default(1);
    let pixels = table.f64("panel_pixels").between(0.01, 1e6).unit("pixels").optional();
    match (table.has("subdivide"), table.has("panel_pixels")) {
        (true, true) => {
            let title = "`subdivide` and `panel_pixels` both say how small panels are";
            table.report(table.problem("panel_pixels", title).expected("one of the two"));
            None
        }
        (false, true) => pixels.map(Fineness::Pixels),
        _ => cells.map(Fineness::Cells),
    }
}

/// Coarser panels, which a light of their own would show.
fn coarser(table: &Reader, shading: Option<Shading>) -> Option<f64> {
    let pixels = table.f64("coarser_px").between(0.0, 100.0).unit("pixels").default(0.0)?;
    if pixels > 0.0 && shading.is_some_and(|shading| shading != Shading::Texture) {
        let title = "panels that have a light of their own cannot be coarser";
        table.report(table.problem("coarser_px", title).expected("`drape = \"texture\"`, or 0"));
        return None;
    }
    Some(pixels)
}

/// The word of a value.
fn word<T: PartialEq>(words: &[(&'static str, T)], value: &T) -> &'static str {
    words.iter().find(|(_, known)| known == value).map_or("", |(word, _)| word)
}
