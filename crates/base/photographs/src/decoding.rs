//! From the bytes of a file to a picture.

use std::io::Cursor;

use image::codecs::jpeg::JpegDecoder;
use image::codecs::png::PngDecoder;
use image::codecs::tiff::TiffDecoder;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageError, ImageFormat};
use picture::{AnyPicture, ColourPicture, Curve, Depth, GreyPicture, Limits, PictureError};

use crate::alpha::over_black;
use crate::error::PhotographError;
use crate::{jpeg, light};

/// Most bytes that a decoder takes for a pixel: four codes of 16 bits, as they are read and as they are kept.
const PIXEL_BYTES: u64 = 16;
/// Most decoded bytes a byte of a file: deflate packs 1032 into one, LZW 2600, a flat progressive JPEG some 500.
const MOST_EXPANSION: u64 = 4096;
/// Beside the pixels: tables, chunks, strips.
const TABLE_BYTES: u64 = 1 << 20;

/// A picture file as far as its header is read.
struct Opened<D> {
    format: &'static str,
    decoder: D,
    /// Of the whole file.
    bytes: u64,
}

/// What a picture is read for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Use {
    /// To be looked at: its codes are those of sRGB.
    Picture,
    /// As values over the ground, which its codes become by this curve.
    Map(Curve),
}

impl Use {
    /// Whether the file may say that its codes are no sRGB.
    fn states_light(self) -> bool {
        matches!(self, Self::Map(curve) if curve != Curve::Srgb)
    }
}

/// The picture that the bytes of a file hold.
///
/// # Errors
/// [`PhotographError`]; nothing is allocated for pixels beyond `limits`.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<AnyPicture, PhotographError> {
    decode_for(Use::Picture, bytes, limits)
}

/// The same for a use of its own.
///
/// # Errors
/// As [`decode`].
pub fn decode_for(wanted: Use, bytes: &[u8], limits: &Limits) -> Result<AnyPicture, PhotographError> {
    let (source, size) = (Cursor::new(bytes), bytes.len() as u64);
    match image::guess_format(bytes) {
        Ok(ImageFormat::Png) => {
            let format = "PNG";
            let held = image_limits(limits);
            let decoder = PngDecoder::with_limits(source, held).map_err(|error| damaged(format, error))?;
            if decoder.is_apng().map_err(|error| damaged(format, error))? {
                return Err(PhotographError::Animated);
            }
            if !wanted.states_light() {
                light::expect_chunks(format, bytes)?;
            }
            Opened { format, decoder, bytes: size }.picture(wanted, limits)
        }
        Ok(ImageFormat::Jpeg) => {
            let format = "JPEG";
            if jpeg::components(bytes) == Some(4) {
                return Err(PhotographError::Inks { format });
            }
            if !jpeg::is_whole(bytes) {
                return Err(PhotographError::Cut);
            }
            let decoder = JpegDecoder::new(source).map_err(|error| damaged(format, error))?;
            Opened { format, decoder, bytes: size }.picture(wanted, limits)
        }
        Ok(ImageFormat::Tiff) => {
            let format = "TIFF";
            let decoder = TiffDecoder::new(source).map_err(|error| damaged(format, error))?;
            Opened { format, decoder, bytes: size }.picture(wanted, limits)
        }
        _ => Err(PhotographError::Unknown { found: first_bytes(bytes) }),
    }
}

fn first_bytes(bytes: &[u8]) -> String {
    match bytes {
        [] => "nothing: the file is empty".to_owned(),
        _ => bytes.iter().take(8).map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" "),
    }
}

/// The program's limits as the decoders know them.
fn image_limits(limits: &Limits) -> image::Limits {
    let mut held = image::Limits::default();
    held.max_alloc = Some(limits.pixels.saturating_mul(PIXEL_BYTES).saturating_add(TABLE_BYTES));
    held
}

/// What a decoder refuses: another kind of picture, or bytes that do not fit each other.
fn damaged(format: &'static str, source: ImageError) -> PhotographError {
    match source {
        ImageError::Unsupported(error) => PhotographError::Kind { format, found: error.to_string() },
        source => PhotographError::Damaged { format, source },
    }
}

impl<D: ImageDecoder> Opened<D> {
    fn picture(mut self, wanted: Use, limits: &Limits) -> Result<AnyPicture, PhotographError> {
        let format = self.format;
        self.check(limits)?;
        let refused = |error| damaged(format, error);
        self.decoder.set_limits(image_limits(limits)).map_err(refused)?;
        if !wanted.states_light()
            && let Some(profile) = self.decoder.icc_profile().map_err(refused)?
        {
            light::expect_profile(format, &profile)?;
        }
        let orientation = self.decoder.orientation().map_err(refused)?;
        let mut image = DynamicImage::from_decoder(self.decoder).map_err(refused)?;
        image.apply_orientation(orientation);
        if matches!(wanted, Use::Map(_)) && !is_opaque(&image) {
            return Err(PhotographError::Clear { format });
        }
        of_image(format, image)
    }

    /// Whether the header tells of a picture that is read here.
    fn check(&self, limits: &Limits) -> Result<(), PhotographError> {
        let format = self.format;
        let (columns, lines) = self.decoder.dimensions();
        if u64::from(columns) * u64::from(lines) > limits.pixels {
            return Err(PhotographError::TooManyPixels { format, columns, lines, limit: limits.pixels });
        }
        if self.decoder.total_bytes() / MOST_EXPANSION > self.bytes {
            return Err(PhotographError::Hollow { format, columns, lines, bytes: self.bytes });
        }
        match self.decoder.original_color_type() {
            ExtendedColorType::Cmyk8 | ExtendedColorType::Cmyk16 => Err(PhotographError::Inks { format }),
            ExtendedColorType::Rgb32F | ExtendedColorType::Rgba32F => {
                Err(PhotographError::Kind { format, found: "in floating point".to_owned() })
            }
            _ => Ok(()),
        }
    }
}

/// Whether no pixel lets light through.
fn is_opaque(image: &DynamicImage) -> bool {
    match image {
        DynamicImage::ImageLumaA8(codes) => codes.pixels().all(|pixel| pixel.0[1] == u8::MAX),
        DynamicImage::ImageRgba8(codes) => codes.pixels().all(|pixel| pixel.0[3] == u8::MAX),
        DynamicImage::ImageLumaA16(codes) => codes.pixels().all(|pixel| pixel.0[1] == u16::MAX),
        DynamicImage::ImageRgba16(codes) => codes.pixels().all(|pixel| pixel.0[3] == u16::MAX),
        _ => true,
    }
}

fn of_image(format: &'static str, image: DynamicImage) -> Result<AnyPicture, PhotographError> {
    use Depth::{Eight, Sixteen};
    let size = (image.width() as usize, image.height() as usize);
    let wide = |codes: Vec<u8>| codes.into_iter().map(u16::from).collect::<Vec<_>>();
    let picture = match image {
        DynamicImage::ImageLuma8(codes) => grey(size, Eight, wide(codes.into_raw())),
        DynamicImage::ImageLuma16(codes) => grey(size, Sixteen, codes.into_raw()),
        DynamicImage::ImageLumaA8(codes) => {
            grey(size, Eight, over_black::<1, 2>(&wide(codes.into_raw()), Eight))
        }
        DynamicImage::ImageLumaA16(codes) => {
            grey(size, Sixteen, over_black::<1, 2>(&codes.into_raw(), Sixteen))
        }
        DynamicImage::ImageRgb8(codes) => colour(size, Eight, wide(codes.into_raw())),
        DynamicImage::ImageRgb16(codes) => colour(size, Sixteen, codes.into_raw()),
        DynamicImage::ImageRgba8(codes) => {
            colour(size, Eight, over_black::<3, 4>(&wide(codes.into_raw()), Eight))
        }
        DynamicImage::ImageRgba16(codes) => {
            colour(size, Sixteen, over_black::<3, 4>(&codes.into_raw(), Sixteen))
        }
        other => {
            let found = format!("of codes {:?}", other.color());
            return Err(PhotographError::Kind { format, found });
        }
    };
    Ok(picture?)
}

fn grey((columns, lines): (usize, usize), depth: Depth, codes: Vec<u16>) -> Result<AnyPicture, PictureError> {
    Ok(GreyPicture::new(columns, lines, depth, codes)?.into())
}

fn colour(
    (columns, lines): (usize, usize),
    depth: Depth,
    codes: Vec<u16>,
) -> Result<AnyPicture, PictureError> {
    Ok(ColourPicture::new(columns, lines, depth, codes)?.into())
}
