//! GeoTIFF: decoded by the `tiff` crate; every tag, geo key and item of metadata is decided by a table.

mod block;
mod directory;
mod file;
mod grid;
mod heights;
pub mod items;
pub mod keys;
mod layout;
mod mask;
mod place;
pub mod tags;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use landscape::LUNOID_RADIUS;
use tiff::tags::Tag;

use self::file::{Tiff, limits, text};
use self::grid::GeoTags;
use self::heights::Source;
use self::items::Items;
use self::keys::Keys;
use self::layout::Layout;
use self::mask::Mask;
use super::bands;
use super::opened::{Opened, Samples};
use super::options::ReadOptions;
use super::refusal::{check_raster, field};
use super::samples::{Conversion, Said};
use super::stretch::Window;
use super::words::Decider;
use crate::elevation::{Affine, Frame, Grid};
use crate::error::SurveyError;

/// Opens one band of the first picture.
pub fn open(path: &Path, options: &ReadOptions) -> Result<Opened, SurveyError> {
    let at = |place: &'static str| {
        move |source| SurveyError::Tiff { path: path.to_path_buf(), place: place.into(), source }
    };
    let (mut tiff, bytes) = file::open(path)?;
    let (columns, lines) = tiff.dimensions().map_err(at("header"))?;
    check_raster(path, lines.into(), columns.into())?;

    let mut decider = Decider::new(path, options);
    tags::decide(path, &mut tiff, &mut decider)?;
    let metadata = text(&mut tiff, Tag::Unknown(42112)).map_err(at("tag 42112"))?.unwrap_or_default();
    let items = Items::of(path, &metadata, &mut decider)?;
    let geo = GeoTags::of(&mut tiff).map_err(at("geo tags"))?;
    let keys = Keys::of(path, &geo.directory, &geo.numbers, &mut decider)?;
    let mut notes = decider.finish()?;
    if tiff.image_ifd().directory().contains(Tag::SubIfd) {
        notes.push(
            "the file has pictures below the first (SubIFDs), which are not read: they may mask it".into(),
        );
    }

    let layout = Layout::of(&mut tiff, limits(bytes)).map_err(at("header"))?;
    layout.check_samples(path)?;
    layout.check_size(path, bytes)?;
    geo.expect_no_heights(path, options)?;
    let (affine, frame) = placed(path, options, &geo, &keys, layout.lines, &mut notes)?;
    let band = Bands::of(path, &mut tiff, &layout, &items)?.chosen(path, options, &items)?;
    let source = Source { path, items: &items, keys: &keys, band: [band.heights, layout.bands], options };
    let said = source.said(&mut tiff, &mut notes)?;
    let unheld = said.voids.iter().filter(|[mark, _]| !layout.can_hold(*mark));
    notes.extend(unheld.map(|[mark, _]| format!("the no-data value is {mark}, which no sample can hold")));
    let sphere = frame.sphere().unwrap_or(LUNOID_RADIUS);
    let conversion = Conversion::new(path, options, Said { sphere, stored: layout.kind(), ..said })?;

    let size = [layout.lines, layout.columns];
    let masks = mask::masks(path, &mut tiff, bytes, size, &mut notes)?;
    tiff.seek_to_image(0).map_err(at("header"))?;
    Ok(Opened {
        grid: Grid { lines: layout.lines, columns: layout.columns, affine, frame },
        path: path.to_path_buf(),
        title: items.get("DESCRIPTION", band.heights).unwrap_or_default().to_string(),
        sources: vec![path.to_path_buf()],
        notes,
        conversion,
        samples: Box::new(Picture { path: path.to_path_buf(), tiff, layout, band, masks }),
    })
}

fn placed(
    path: &Path,
    options: &ReadOptions,
    geo: &GeoTags,
    keys: &Keys,
    lines: usize,
    notes: &mut Vec<String>,
) -> Result<(Affine, Frame), SurveyError> {
    match (place::place(path, geo, keys, notes)?, options.own_place(lines)) {
        (Some(place), _) => {
            options.expect_no_place()?;
            Ok(place)
        }
        (None, Some(affine)) => Ok((affine, Frame::Plane(None))),
        (None, None) => {
            let advice = "give --spacing-m METRES, or add a place with gdal_translate -a_ullr";
            Err(field(path, "geo tags", "none", "ModelPixelScaleTag and ModelTiepointTag", advice))
        }
    }
}

/// Which bands may hold heights, and which masks them.
struct Bands {
    heights: Vec<usize>,
    /// The alpha bands, each with whether heights are multiplied by it.
    alpha: Vec<(usize, bool)>,
    count: usize,
}

/// The band that is read, with the alpha band over it.
struct Band {
    heights: usize,
    alpha: Option<(usize, bool)>,
}

impl Bands {
    fn of(path: &Path, tiff: &mut Tiff, layout: &Layout, items: &Items) -> Result<Self, SurveyError> {
        let failed = |source| SurveyError::Tiff { path: path.into(), place: tags::place(338), source };
        let extra = tiff.find_tag_unsigned_vec::<u16>(Tag::ExtraSamples).map_err(failed)?.unwrap_or_default();
        let alpha = mask::alpha_bands(&extra, items, layout.bands);
        let hidden: BTreeSet<usize> = alpha.iter().map(|(band, _)| *band).collect();
        let heights = (0..layout.bands).filter(|band| !hidden.contains(band)).collect();
        Ok(Self { heights, alpha, count: layout.bands })
    }

    /// The band that the user chose, or the only one that is no alpha band. An alpha band masks all but itself.
    fn chosen(&self, path: &Path, options: &ReadOptions, items: &Items) -> Result<Band, SurveyError> {
        let name = |band| Some(items.get("DESCRIPTION", band).unwrap_or("no description").to_owned());
        let heights = bands::chosen(path, options, self.count, &self.heights, name)?;
        let alpha = self.alpha.first().copied().filter(|(band, _)| *band != heights);
        Ok(Band { heights, alpha })
    }
}

/// The picture of a band, with what masks it.
struct Picture {
    path: PathBuf,
    tiff: Tiff,
    layout: Layout,
    band: Band,
    masks: Vec<Mask>,
}

impl Samples for Picture {
    /// Stored numbers, NaN where a mask or the alpha band hides them or the file leaves them out.
    fn read(&mut self, window: &Window, notes: &mut Vec<String>) -> Result<Vec<f64>, SurveyError> {
        let mut band = self.layout.read(&self.path, &mut self.tiff, self.band.heights, window)?;
        if band.left_out > 0 {
            let left_out = band.left_out;
            notes.push(format!("the file leaves {left_out} strips or tiles out: their samples are voids"));
        }
        if let Some((alpha, is_multiplied)) = self.band.alpha {
            let alpha = self.layout.read(&self.path, &mut self.tiff, alpha, window)?;
            mask::apply_alpha(&self.path, &mut band.samples, &alpha.samples, is_multiplied)?;
        }
        for mask in &mut self.masks {
            mask.apply(window, &mut band.samples)?;
        }
        Ok(band.samples)
    }
}
