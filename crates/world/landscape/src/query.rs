//! The one query for height, slope and albedo.

use std::sync::Arc;

use features::{Features, Rise};
use photograph::Photograph;
use quantities::intensity;

use crate::{AlbedoMap, Bank, CraterGrain, Level, Photometry, Posts, Silhouette, Texture};

/// The ground at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Height above the lunoid's tangent plane (m).
    pub height: f64,
    /// Slopes `[hx, hy]`: rise to the north and to the east (m/m).
    pub slopes: [f64; 2],
    /// Share of the light that is returned, 0..=1; of a colour its luminance.
    pub albedo: f64,
}

impl SurfacePoint {
    /// The same with features on it.
    fn raised(self, rise: &Rise) -> Self {
        let slopes = std::array::from_fn(|axis| self.slopes[axis] + rise.slopes[axis]);
        Self { height: self.height + rise.height, slopes, ..self }
    }
}

/// Lunoid, terrain and features: what `exact`, truth, the vehicle, shadows and the machine's preparation ask.
#[derive(Debug, Clone, PartialEq)]
pub struct Landscape {
    bank: Bank,
    albedo: f64,
    albedo_map: Option<AlbedoMap>,
    features: Features,
    texture: Option<Texture>,
    crater_grain: Option<CraterGrain>,
    photometry: Photometry,
    silhouettes: Vec<Silhouette>,
    posts: Option<Posts>,
    photographs: Arc<[Photograph]>,
}

impl Landscape {
    /// The landscape of a bank, of one albedo (0..=1): terrain alone, Lambert's law.
    pub fn new(bank: Bank, albedo: f64) -> Self {
        let (features, photometry) = (Features::default(), Photometry::Lambert);
        Self {
            bank,
            albedo,
            albedo_map: None,
            features,
            texture: None,
            crater_grain: None,
            photometry,
            silhouettes: Vec::new(),
            posts: None,
            photographs: Arc::default(),
        }
    }

    /// The same with features on it.
    pub fn with_features(self, features: Features) -> Self {
        Self { features, ..self }
    }

    /// The same with a map of albedo over its one number.
    pub fn with_albedo_map(self, albedo_map: Option<AlbedoMap>) -> Self {
        Self { albedo_map, ..self }
    }

    /// The same with texture in the foreground.
    pub fn with_texture(self, texture: Option<Texture>) -> Self {
        Self { texture, ..self }
    }

    /// The same with craters that change its texture; without texture they change nothing.
    pub fn with_crater_grain(self, crater_grain: Option<CraterGrain>) -> Self {
        Self { crater_grain, ..self }
    }

    /// The same under another law of reflection.
    pub fn with_photometry(self, photometry: Photometry) -> Self {
        Self { photometry, ..self }
    }

    /// The same with mountains beyond the stored area.
    pub fn with_silhouettes(self, silhouettes: Vec<Silhouette>) -> Self {
        Self { silhouettes, ..self }
    }

    /// The same with its ground as posts too.
    pub fn with_posts(self, posts: Option<Posts>) -> Self {
        Self { posts, ..self }
    }

    /// The same with what cameras saw of it.
    pub fn with_photographs(self, photographs: Arc<[Photograph]>) -> Self {
        Self { photographs, ..self }
    }

    /// Photographs of the ground, in the order of the scenario.
    pub fn photographs(&self) -> &Arc<[Photograph]> {
        &self.photographs
    }

    /// The ground as posts in tiles, where it has them.
    pub fn posts(&self) -> Option<&Posts> {
        self.posts.as_ref()
    }

    /// Returns the terrain coefficients, all levels of them.
    pub fn bank(&self) -> &Bank {
        &self.bank
    }

    /// Returns the finest level of the terrain coefficients.
    pub fn level(&self) -> &Level {
        self.bank.finest()
    }

    /// Share of the light that is returned where no map lies, 0..=1.
    pub fn albedo(&self) -> f64 {
        self.albedo
    }

    /// The map of albedo, if there is one.
    pub fn albedo_map(&self) -> Option<&AlbedoMap> {
        self.albedo_map.as_ref()
    }

    /// Share of red, green and blue light that is returned at (x, y) (m), 0..=1: from the map, or outside it the one number.
    pub fn albedo_at(&self, x: f64, y: f64) -> [f64; 3] {
        let mapped = self.albedo_map.as_ref().and_then(|map| map.at(x, y));
        mapped.unwrap_or([self.albedo; 3])
    }

    /// Returns the craters that lie on the terrain.
    pub fn features(&self) -> &Features {
        &self.features
    }

    /// Small detail of the foreground, if there is any.
    pub fn texture(&self) -> Option<&Texture> {
        self.texture.as_ref()
    }

    /// What craters do to the texture, if they do anything: only where there are both.
    pub fn crater_grain(&self) -> Option<&CraterGrain> {
        self.crater_grain.as_ref().filter(|_| self.texture.is_some() && !self.features.is_empty())
    }

    /// What texture adds to reflectivity at (x, y) (m) seen from ground range `range` (m): 0 where there is none.
    pub fn texture_at(&self, x: f64, y: f64, range: f64) -> f64 {
        let added = self.texture.as_ref().map_or(0.0, |texture| texture.at(x, y, range));
        self.crater_grain().map_or(added, |grain| added * grain.gain(&self.features, x, y))
    }

    /// Returns the law by which the ground reflects light.
    pub fn photometry(&self) -> &Photometry {
        &self.photometry
    }

    /// Mountains beyond the stored area.
    pub fn silhouettes(&self) -> &[Silhouette] {
        &self.silhouettes
    }

    /// Terrain and features at (x, y) (m), from the finest level that has the place; `None` outside all.
    pub fn at(&self, x: f64, y: f64) -> Option<SurfacePoint> {
        Some(self.terrain_at(x, y)?.raised(&self.features.at(x, y)))
    }

    /// The same as samples of the ground `spacing` (m) apart can show it: small features are faded
    /// ([`Features::at_spacing`]). Terrain and albedo are whole.
    pub fn at_spacing(&self, x: f64, y: f64, spacing: f64) -> Option<SurfacePoint> {
        Some(self.terrain_at(x, y)?.raised(&self.features.at_spacing(x, y, spacing)))
    }

    /// The terrain alone at (x, y) (m), from the finest level that has the place; `None` outside all.
    pub fn terrain_at(&self, x: f64, y: f64) -> Option<SurfacePoint> {
        let found = |level: &Level| {
            let (region, local) = level.locate(x, y)?;
            let [height, hu, hv] = level.height_and_slopes(region, local);
            let d = level.region_size();
            Some(SurfacePoint { height, slopes: [hu / d, hv / d], albedo: intensity(self.albedo_at(x, y)) })
        };
        self.bank.levels().iter().find_map(found)
    }

    /// Whether the ground at (x, y) (m) rests on data; false outside the finest level.
    pub fn has_data(&self, x: f64, y: f64) -> bool {
        self.level().locate(x, y).is_some_and(|(region, _)| !self.bank.is_void(region))
    }

    /// Whether the survey had no data at (x, y) (m), so that the ground there is filled in; false outside the finest level.
    pub fn is_void(&self, x: f64, y: f64) -> bool {
        self.level().locate(x, y).is_some_and(|(region, _)| self.bank.is_void(region))
    }

    /// Height at (x, y) (m); `None` outside the problem area.
    pub fn height(&self, x: f64, y: f64) -> Option<f64> {
        self.at(x, y).map(|point| point.height)
    }
}

#[cfg(test)]
mod tests {
    use super::Landscape;
    use crate::texture::{Layer, Source};
    use crate::{AlbedoMap, Bank, Level, Photometry, Silhouette, Texels, Texture};
    use features::{Crater, Features, Shape};

    #[test]
    fn a_tilted_plane_is_exact() {
        // h = 5 + 0.1 x - 0.2 y on 250 m regions: words h, d hx, d hy.
        let plane = |m: f64, n: f64| {
            let mut words = [0.0; 9];
            words[0] = 5.0 + 25.0 * m - 50.0 * n;
            words[3] = 25.0;
            words[1] = -50.0;
            words
        };
        let words = (0..9).map(|k| plane(f64::from(k / 3), f64::from(k % 3))).collect();
        let level = Level::new(250.0, [0.0, 0.0], [3, 3], words).unwrap();
        let landscape = Landscape::new(Bank::new("plane", vec![level], None).unwrap(), 1.0);
        let point = landscape.at(123.0, 456.0).unwrap();
        assert!((point.height - (5.0 + 12.3 - 91.2)).abs() < 1e-12);
        assert!((point.slopes[0] - 0.1).abs() < 1e-14);
        assert!((point.slopes[1] + 0.2).abs() < 1e-14);
        assert_eq!(landscape.at(500.1, 0.0), None);
        assert_eq!(landscape.height(123.0, 456.0), Some(point.height));
        assert_eq!(landscape.height(0.0, -0.1), None);
    }

    /// A crater of radius 3 m on a slope: whole up to a spacing of 1.5 m, halved at 2 m, gone at 3 m.
    #[test]
    fn samples_far_apart_see_less_of_a_crater() {
        let mut words = [[0.0; 9]; 4];
        words.iter_mut().for_each(|corner| corner[3] = 1.0);
        (words[2][0], words[3][0]) = (1.0, 1.0);
        let level = Level::new(10.0, [0.0; 2], [2, 2], words.to_vec()).unwrap();
        let terrain = Landscape::new(Bank::new("", vec![level], None).unwrap(), 0.25);
        let crater = Crater::new([5.0, 5.0], Shape::Bowl { r1: 3.0 }, 1.0, 0.0).unwrap();
        let landscape = terrain.clone().with_features(Features::new(vec![crater]));
        let [whole, bare] = [&landscape, &terrain].map(|ground| ground.at(6.0, 5.0).unwrap());
        let seen = |spacing| landscape.at_spacing(6.0, 5.0, spacing).unwrap();
        assert_eq!((seen(0.0), seen(1.5), seen(3.0)), (whole, whole, bare));
        let half = seen(2.0);
        assert!((half.height - 0.5 * (whole.height + bare.height)).abs() < 1e-15);
        assert!((half.slopes[0] - 0.5 * (whole.slopes[0] + bare.slopes[0])).abs() < 1e-15);
        assert!(whole.height < bare.height - 0.8 && landscape.at_spacing(10.1, 0.0, 1.0).is_none());
    }

    #[test]
    fn a_map_of_albedo_lies_over_the_one_number() {
        let level = Level::new(10.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        let plain = Landscape::new(Bank::new("", vec![level], None).unwrap(), 0.3);
        assert_eq!((plain.albedo_at(5.0, 5.0), plain.at(5.0, 5.0).unwrap().albedo), ([0.3; 3], 0.3));
        let map = AlbedoMap::new([0.0, 0.0, 4.0, 4.0], [1, 1], Texels::Colour(vec![[1.0, 0.5, 0.25]]));
        let mapped = plain.with_albedo_map(Some(map.unwrap()));
        assert_eq!((mapped.albedo_at(3.0, 2.0), mapped.albedo_at(5.0, 2.0)), ([1.0, 0.5, 0.25], [0.3; 3]));
        let albedo = mapped.at(3.0, 2.0).unwrap().albedo;
        assert!((albedo - (0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25)).abs() < 1e-15);
        assert_eq!(mapped.at(5.0, 5.0).unwrap().albedo, 0.3);
    }

    #[test]
    fn ground_rests_on_data_where_the_survey_had_some() {
        let level = Level::new(10.0, [0.0; 2], [3, 3], vec![[0.0; 9]; 9]).unwrap();
        let bank = Bank::new("", vec![level], None).unwrap().with_voids(vec![[1, 0]]).unwrap();
        let landscape = Landscape::new(bank, 0.5);
        assert!(landscape.has_data(5.0, 5.0) && landscape.has_data(15.0, 15.0));
        assert!(!landscape.has_data(15.0, 5.0) && !landscape.has_data(25.0, 5.0));
        assert!(
            landscape.is_void(15.0, 5.0) && !landscape.is_void(5.0, 5.0) && !landscape.is_void(25.0, 5.0)
        );
        // It is drawn all the same.
        assert_eq!(landscape.height(15.0, 5.0), Some(0.0));
    }

    #[test]
    fn what_is_laid_over_the_terrain_leaves_the_rest_as_it_was() {
        let level = Level::new(10.0, [0.0; 2], [2, 2], vec![[0.0; 9]; 4]).unwrap();
        let terrain = Landscape::new(Bank::new("", vec![level], None).unwrap(), 0.25);
        let crater = Crater::new([5.0, 5.0], Shape::Bowl { r1: 2.0 }, 1.0, 0.0).unwrap();
        let layer = Layer { cell: 1.0, amplitude: 0.1, range: 10.0 };
        let texture = Texture::new(&[layer], Source::Random, 1, 10.0, [0.0; 2]).unwrap();
        let ridge = Silhouette::new(vec![[0.0, 0.1], [1.0, 0.2]], 0.75).unwrap();
        let whole = terrain
            .clone()
            .with_features(Features::new(vec![crater]))
            .with_texture(Some(texture.clone()))
            .with_photometry(Photometry::LunarLambert)
            .with_silhouettes(vec![ridge.clone()]);
        assert_eq!(whole.features().craters().iter().collect::<Vec<_>>(), [crater]);
        assert_eq!((whole.texture(), whole.photometry()), (Some(&texture), &Photometry::LunarLambert));
        assert_eq!(whole.silhouettes(), [ridge]);
        assert_eq!(
            (whole.silhouettes()[0].outline()[1], whole.silhouettes()[0].reflectivity()),
            ([1.0, 0.2], 0.75)
        );
        assert_eq!((whole.bank(), whole.albedo()), (terrain.bank(), 0.25));
        assert_eq!(whole.level(), &whole.bank().levels()[0]);
        assert_eq!((terrain.texture(), terrain.silhouettes().len()), (None, 0));
    }
}
