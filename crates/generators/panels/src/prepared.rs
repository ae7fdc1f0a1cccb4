//! A stage made ready: posts, panels, photographs over them.

use std::fmt::Display;
use std::sync::Arc;

use generator::{PrepareError, Stage};
use photo_drape::{Drape, DrapeError, Footprint, Ground};

use crate::coarser::Bounds;
use crate::greys::{self, Grey, Source};
use crate::mesh::Mesh;
use crate::name::NAME;
use crate::parameters::{Fineness, Parameters, Shading};
use crate::relit::Relit;

/// Cells along the longer side of the ground where no spacing is asked for. Chosen: half a million panels.
const USUAL_CELLS: f64 = 512.0;

/// Everything of a run that frames share.
pub struct Prepared {
    pub stage: Stage,
    pub run: Parameters,
    pub drape: Arc<Drape>,
    pub mesh: Mesh,
    /// How far coarser panels lie beside these, where frames may have coarser ones.
    pub coarser: Option<Bounds>,
    /// Light of each post where no photograph shows the ground.
    pub unseen: Arc<[f32]>,
    /// Light of each panel; none where pixels are looked up one by one.
    pub greys: Vec<Grey>,
    /// Light of each vertex, where vertices are mixed.
    pub vertices: Vec<f32>,
    /// Ground lit anew, where it is asked for.
    pub relit: Option<Relit>,
}

/// A fault of the ground or of photographs, as generators tell it.
pub fn refused(what: &dyn Display, remedy: &str) -> PrepareError {
    PrepareError::Unsupported { generator: NAME, what: what.to_string(), remedy: remedy.into() }
}

impl Prepared {
    /// Lays the photographs of `stage` over its ground.
    ///
    /// # Errors
    /// If there is no photograph, one does not lie on the ground, or there are too many posts.
    pub fn new(stage: Stage, run: Parameters) -> Result<Self, PrepareError> {
        let drape = Arc::new(laid(&stage, &run)?);
        let mesh = Mesh::new(drape.shared_ground(), run.diagonal);
        let is_coarser = run.coarser_px > 0.0;
        let coarser = is_coarser.then(|| Bounds::new(&mesh, stage.view.laws.curvature));
        let unseen: Arc<[f32]> = unseen(&drape, &run)?.into();
        let relit = run.relights.then(|| Relit::new(&drape, &stage)).transpose()?;
        let needs_greys = run.shading != Shading::Texture && relit.is_none();
        let greys =
            if needs_greys { greys::of_panels(&drape, run.choice, &mesh, &unseen) } else { Vec::new() };
        let vertices = match run.shading {
            Shading::Gouraud if needs_greys => greys::of_vertices(&mesh, &greys),
            _ => Vec::new(),
        };
        Ok(Self { stage, run, drape, mesh, coarser, unseen, greys, vertices, relit })
    }

    /// Panels that no photograph sees, of those whose light is known.
    pub fn unseen_panels(&self) -> u64 {
        self.greys.iter().filter(|grey| grey.source == Source::Unseen).count() as u64
    }
}

/// Distance of posts (m) before cells are divided.
pub fn spacing(stage: &Stage, run: &Parameters) -> f64 {
    let [south, west, north, east] = stage.landscape.level().extent();
    run.spacing.unwrap_or((north - south).max(east - west) / USUAL_CELLS)
}

/// Photographs over posts as fine as a run asks for.
fn laid(stage: &Stage, run: &Parameters) -> Result<Drape, PrepareError> {
    let landscape = &stage.landscape;
    let [south, west, north, east] = landscape.level().extent();
    let spacing = spacing(stage, run);
    let of = |error: DrapeError| refused(&error, remedy(&error));
    let over = |spacing: f64| {
        let ground = Ground::new(landscape, [south, west, north, east], spacing)?;
        Drape::new(landscape, ground, run.choice)
    };
    match run.fineness {
        Fineness::Cells(1) => over(spacing).map_err(of),
        Fineness::Cells(cells) => over(spacing / f64::from(cells)).map_err(of),
        Fineness::Pixels(target) => {
            let first = over(spacing).map_err(of)?;
            match cells(&first, target) {
                1 => Ok(first),
                cells => over(spacing / f64::from(cells)).map_err(of),
            }
        }
    }
}

/// Into how many cells along its side a cell is divided, so that a panel has at most `target` pixels of a photograph in the middle of the ground.
fn cells(drape: &Drape, target: f64) -> u32 {
    let ground = drape.ground();
    let middle = ground.post(ground.size().map(|posts| posts / 2));
    let footprint = Footprint::square(ground.normal([middle.x, middle.y]), ground.spacing());
    let weight = drape.at(middle, &footprint).map_or(0.0, |shown| shown.weight);
    let pixels = weight * ground.spacing() * ground.spacing() / 2.0;
    (pixels / target).sqrt().ceil().clamp(1.0, 64.0) as u32
}

/// Light of each post where no photograph shows the ground.
fn unseen(drape: &Drape, run: &Parameters) -> Result<Vec<f32>, PrepareError> {
    let posts = drape.ground().heights().len();
    let lights = match run.infers {
        true => drape.lights().map_err(|error| refused(&error, remedy(&error)))?,
        false => vec![f64::NAN; posts],
    };
    Ok(lights
        .into_iter()
        .map(|light| if light.is_nan() { run.outside as f32 } else { light as f32 })
        .collect())
}

/// What helps against a fault.
fn remedy(error: &DrapeError) -> &'static str {
    match error {
        DrapeError::None => "name photographs in the scenario, or draw it with --machine exact",
        DrapeError::Posts { .. } => "ask for another panels.spacing_m or panels.subdivide",
        DrapeError::Hole { .. } => "give it a bank without holes",
        _ => "give it photographs of this ground",
    }
}
