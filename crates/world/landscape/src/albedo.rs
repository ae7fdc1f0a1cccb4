//! A map of the ground's albedo: the layer that lies over the one number of a landscape.

use picture::{AnyPicture, Curve};

/// Texels of a map, line by line from the north, each line from the west; linear, 0..=1.
#[derive(Debug, Clone, PartialEq)]
pub enum Texels {
    /// One albedo for all colours of light.
    Grey(Vec<f32>),
    /// Albedos for red, green and blue light, Rec. 709 primaries.
    Colour(Vec<[f32; 3]>),
}

/// Albedo over a rectangle of the ground, bilinear in linear light between the centres of its texels. Outside the centres of the
/// outermost texels these go on to the edge; outside the rectangle the map says nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct AlbedoMap {
    area: [f64; 4],
    size: [usize; 2],
    texels: Texels,
}

/// Why texels are no map.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum AlbedoMapError {
    /// An area without an extent.
    #[error("area x {}..{} m, y {}..{} m: expected south, west, north, east edge in ascending order",
        .0[0], .0[2], .0[1], .0[3])]
    Area([f64; 4]),
    /// Not as many texels as the size says.
    #[error("{found} texels: expected {columns} x {lines}, both 1 or more")]
    Count {
        /// Number of texels that were given.
        found: usize,
        /// Texels from west to east.
        columns: usize,
        /// Texels from north to south.
        lines: usize,
    },
    /// A number that is no albedo.
    #[error("texel {texel}: albedo {albedo}: expected 0 to 1")]
    Albedo {
        /// Which, from 0, line by line.
        texel: usize,
        /// Albedo that was found there.
        albedo: f32,
    },
}

impl AlbedoMap {
    /// A map of `columns` x `lines` texels over `area`: south, west, north, east edge (m).
    ///
    /// # Errors
    /// If the area has no extent, the texels are not as many as that, or one is not 0 to 1.
    pub fn new(area: [f64; 4], [columns, lines]: [usize; 2], texels: Texels) -> Result<Self, AlbedoMapError> {
        let [south, west, north, east] = area;
        if !(south < north && west < east && area.iter().all(|edge| edge.is_finite())) {
            return Err(AlbedoMapError::Area(area));
        }
        let found = texels.len();
        if columns.checked_mul(lines) != Some(found) || found == 0 {
            return Err(AlbedoMapError::Count { found, columns, lines });
        }
        match texels.first_fault() {
            Some((texel, albedo)) => Err(AlbedoMapError::Albedo { texel, albedo }),
            None => Ok(Self { area, size: [columns, lines], texels }),
        }
    }

    /// South, west, north, east edge (m).
    pub fn area(&self) -> [f64; 4] {
        self.area
    }

    /// Texels from west to east, and from north to south.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Returns the texels of the map, grey or coloured.
    pub fn texels(&self) -> &Texels {
        &self.texels
    }

    /// Albedo for red, green and blue light at (x, y) (m), equal channels for a grey map; `None` outside its area.
    pub fn at(&self, x: f64, y: f64) -> Option<[f64; 3]> {
        let [south, west, north, east] = self.area;
        if !(south <= x && x <= north && west <= y && y <= east) {
            return None;
        }
        let [columns, lines] = self.size;
        let (left, right) = between((y - west) / (east - west), columns);
        let (top, bottom) = between((north - x) / (north - south), lines);
        let line = |line: usize| mix(self.texel(line, left), self.texel(line, right.0), right.1);
        Some(mix(line(top), line(bottom.0), bottom.1))
    }

    fn texel(&self, line: usize, column: usize) -> [f64; 3] {
        let index = line * self.size[0] + column;
        match &self.texels {
            Texels::Grey(grey) => [f64::from(grey[index]); 3],
            Texels::Colour(colour) => colour[index].map(f64::from),
        }
    }
}

impl Texels {
    /// The texels of a picture: a code is light under the `curve`, and light goes in proportion from the albedo of black to that of white
    /// (`ends`, 0..=1).
    pub fn of_picture(picture: &AnyPicture, curve: Curve, [dark, bright]: [f64; 2]) -> Self {
        let white = picture.depth().white();
        let albedo = |code: u16| {
            let light = curve.light(f64::from(code) / f64::from(white));
            (dark + light * (bright - dark)).clamp(0.0, 1.0) as f32
        };
        let albedos: Vec<f32> = (0..=white).map(albedo).collect();
        let of = |code: u16| albedos[usize::from(code)];
        match picture {
            AnyPicture::Grey(grey) => Self::Grey(grey.codes().iter().map(|&code| of(code)).collect()),
            AnyPicture::Colour(colour) => {
                Self::Colour(colour.pixels().iter().map(|codes| codes.map(of)).collect())
            }
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::Grey(grey) => grey.len(),
            Self::Colour(colour) => colour.len(),
        }
    }

    /// Whether one of them has a colour.
    pub fn is_colourful(&self) -> bool {
        match self {
            Self::Grey(_) => false,
            Self::Colour(colour) => colour.iter().any(|[red, green, blue]| red != green || green != blue),
        }
    }

    fn first_fault(&self) -> Option<(usize, f32)> {
        let is_fault = |albedo: &f32| !(0.0..=1.0).contains(albedo);
        match self {
            Self::Grey(grey) => grey.iter().copied().enumerate().find(|(_, albedo)| is_fault(albedo)),
            Self::Colour(colour) => {
                let fault = |texel: &[f32; 3]| texel.iter().copied().find(is_fault);
                colour.iter().enumerate().find_map(|(index, texel)| Some((index, fault(texel)?)))
            }
        }
    }
}

/// The texel before a place (share of the extent), the one behind it, and how far the place is from the first to the second.
fn between(share: f64, count: usize) -> (usize, (usize, f64)) {
    let last = count - 1;
    let place = (share * count as f64 - 0.5).clamp(0.0, last as f64);
    let first = (place as usize).min(last);
    (first, ((first + 1).min(last), place - first as f64))
}

fn mix(from: [f64; 3], to: [f64; 3], share: f64) -> [f64; 3] {
    std::array::from_fn(|channel| from[channel] + share * (to[channel] - from[channel]))
}

#[cfg(test)]
mod tests {
    use super::{AlbedoMap, AlbedoMapError, Texels};

    /// Two lines of three texels over 30 m x 30 m from (100, 200): north above.
    fn map(texels: Texels) -> Result<AlbedoMap, AlbedoMapError> {
        AlbedoMap::new([100.0, 200.0, 120.0, 230.0], [3, 2], texels)
    }

    #[test]
    fn the_first_line_lies_in_the_north_and_the_first_column_in_the_west() {
        let map = map(Texels::Grey(vec![0.0, 0.25, 0.5, 0.5, 0.75, 1.0])).unwrap();
        for (line, x) in [115.0, 105.0].into_iter().enumerate() {
            for (column, y) in [205.0, 215.0, 225.0].into_iter().enumerate() {
                assert_eq!(map.at(x, y), Some([0.25 * column as f64 + 0.5 * line as f64; 3]));
            }
        }
    }

    #[test]
    fn between_centres_it_is_bilinear_and_beyond_them_level() {
        let map = map(Texels::Grey(vec![0.0, 0.25, 0.5, 0.5, 0.75, 1.0])).unwrap();
        assert_eq!(map.at(110.0, 210.0), Some([0.375; 3]));
        assert_eq!(map.at(120.0, 200.0), Some([0.0; 3]));
        assert_eq!(map.at(100.0, 230.0), Some([1.0; 3]));
        for [x, y] in [[99.9, 210.0], [120.1, 210.0], [110.0, 199.9], [110.0, 230.1], [f64::NAN, 210.0]] {
            assert_eq!(map.at(x, y), None);
        }
    }

    #[test]
    fn channels_are_apart() {
        let colour = |red| [red, 0.5, 1.0 - red];
        let map = map(Texels::Colour((0..6).map(|k| colour(0.125 * k as f32)).collect())).unwrap();
        assert!(map.texels().is_colourful());
        assert_eq!(map.at(115.0, 210.0), Some([0.0625, 0.5, 0.9375]));
        assert!(!Texels::Colour(vec![[0.5; 3]; 6]).is_colourful());
    }

    #[test]
    fn what_is_no_map_is_refused() {
        let grey = |albedo| Texels::Grey(vec![0.5, albedo]);
        let made = |area, size, texels| AlbedoMap::new(area, size, texels).unwrap_err().to_string();
        let area = [0.0, 0.0, 1.0, 1.0];
        assert!(made([0.0, 0.0, 0.0, 1.0], [2, 1], grey(0.5)).contains("ascending"));
        assert!(made(area, [3, 1], grey(0.5)).contains("2 texels: expected 3 x 1"));
        assert!(made(area, [2, 1], grey(1.5)).contains("texel 1: albedo 1.5"));
        assert!(made(area, [2, 1], grey(f32::NAN)).contains("NaN"));
        assert!(made(area, [0, 0], Texels::Grey(vec![])).contains("1 or more"));
    }
}
