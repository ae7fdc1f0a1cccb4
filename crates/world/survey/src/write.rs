//! Rasters into GeoTIFF files, placed as an elevation file is (OGC GeoTIFF 1.1).

use std::io::Cursor;
use std::path::Path;

use landscape::projection::{Method, Projection};
use quantities::degrees;
use tiff::encoder::TiffEncoder;
use tiff::encoder::TiffValue;
use tiff::encoder::colortype::{ColorType, Gray8, Gray64Float};
use tiff::tags::Tag;
use tiff::{TiffError, TiffResult};

use crate::elevation::{Affine, Frame};
use crate::error::SurveyError;

/// Code of a thing whose figures stand in other keys.
const USER_DEFINED: u16 = 32767;
/// Tag of GDAL's with the value of samples that are none.
const NO_DATA: Tag = Tag::Unknown(42113);
const METRE: u16 = 9001;
const DEGREE: u16 = 9102;

/// Samples of a raster, line by line.
#[derive(Debug, Clone, PartialEq)]
pub enum RasterSamples {
    /// Codes; 255 is none.
    Codes(Vec<u8>),
    /// Numbers; NaN is none.
    Numbers(Vec<f64>),
}

/// A raster with the place of its samples.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedRaster {
    /// Lines, and samples of a line.
    pub size: [usize; 2],
    /// Place of the samples; line 0 is the northernmost.
    pub affine: Affine,
    /// Meaning of the places.
    pub frame: Frame,
    /// The samples, line by line.
    pub samples: RasterSamples,
}

/// Writes a raster as GeoTIFF of one band; the old file stays if it cannot.
///
/// # Errors
/// A raster without samples or with another number of them than its size says, or a file that cannot be written.
pub fn write_geotiff(path: &Path, raster: &PlacedRaster) -> Result<(), SurveyError> {
    let encoded = match &raster.samples {
        RasterSamples::Codes(codes) => encode::<Gray8>(raster, codes, "255"),
        RasterSamples::Numbers(numbers) => encode::<Gray64Float>(raster, numbers, "nan"),
    };
    let bytes = encoded.map_err(|source| SurveyError::Tiff {
        path: path.to_path_buf(),
        place: "samples to write".into(),
        source,
    })?;
    Ok(files::write_atomic(path, |out| out.write_all(&bytes))?)
}

fn encode<C: ColorType>(raster: &PlacedRaster, samples: &[C::Inner], no_data: &str) -> TiffResult<Vec<u8>>
where
    [C::Inner]: TiffValue,
{
    let mut bytes = Cursor::new(Vec::new());
    let [lines, columns] = raster.size;
    let side = |count: usize| u32::try_from(count).map_err(|_| TiffError::LimitsExceeded);
    let mut tiff = TiffEncoder::new(&mut bytes)?;
    let mut image = tiff.new_image::<C>(side(columns)?, side(lines)?)?;
    let Affine { first, step } = raster.affine;
    let unit = |value: f64| if matches!(raster.frame, Frame::Plane(_)) { value } else { degrees(value) };
    let scale = [unit(step[1]), unit(-step[0]), 0.0];
    let tie = [0.0, 0.0, 0.0, unit(first[1]), unit(first[0]), 0.0];
    let keys = Keys::of(&raster.frame);
    let directory = image.encoder();
    directory.write_tag(Tag::ModelPixelScaleTag, &scale[..])?;
    directory.write_tag(Tag::ModelTiepointTag, &tie[..])?;
    directory.write_tag(Tag::GeoKeyDirectoryTag, keys.directory().as_slice())?;
    if !keys.numbers.is_empty() {
        directory.write_tag(Tag::GeoDoubleParamsTag, keys.numbers.as_slice())?;
    }
    directory.write_tag(NO_DATA, no_data)?;
    image.write_data(samples)?;
    Ok(bytes.into_inner())
}

/// The keys of a place: numbers of a key are words of the directory, or stand in a list of their own.
#[derive(Debug, Default)]
struct Keys {
    entries: Vec<[u16; 4]>,
    numbers: Vec<f64>,
}

impl Keys {
    /// Keys of places that are centres of samples.
    fn of(frame: &Frame) -> Self {
        let mut keys = Self::default();
        let geographic = matches!(frame, Frame::Geographic { .. });
        keys.code(1024, if geographic { 2 } else { 1 });
        keys.code(1025, 2);
        if let Some(radius) = frame.sphere() {
            keys.code(2048, USER_DEFINED);
            keys.code(2050, USER_DEFINED);
            keys.code(2054, DEGREE);
            keys.code(2056, USER_DEFINED);
            keys.number(2057, radius);
            keys.number(2058, radius);
        }
        if let Frame::Plane(projection) = frame {
            keys.code(3072, USER_DEFINED);
            if let Some(projection) = projection {
                keys.projection(projection);
            } else {
                keys.code(3076, METRE);
            }
        }
        keys
    }

    fn projection(&mut self, projection: &Projection) {
        let [north, east] = projection.offset;
        let [latitude, longitude] = [projection.latitude, projection.longitude].map(degrees);
        self.code(3074, USER_DEFINED);
        let method = match projection.method {
            Method::PolarStereographic { .. } => 15,
            Method::Equirectangular { .. } => 17,
            Method::Orthographic => 21,
        };
        self.code(3075, method);
        self.code(3076, METRE);
        if let Method::Equirectangular { parallel } = projection.method {
            self.number(3078, degrees(parallel));
        }
        let is_polar = matches!(projection.method, Method::PolarStereographic { .. });
        if !is_polar {
            self.number(3080, longitude);
        }
        self.number(3081, latitude);
        self.number(3082, east);
        self.number(3083, north);
        if let Method::PolarStereographic { scale } = projection.method {
            self.number(3092, scale);
            self.number(3095, longitude);
        }
    }

    fn code(&mut self, key: u16, code: u16) {
        self.entries.push([key, 0, 1, code]);
    }

    fn number(&mut self, key: u16, number: f64) {
        self.entries.push([key, 34736, 1, self.numbers.len() as u16]);
        self.numbers.push(number);
    }

    fn directory(&self) -> Vec<u16> {
        [&[1, 1, 1, self.entries.len() as u16][..], &self.entries.concat()].concat()
    }
}
