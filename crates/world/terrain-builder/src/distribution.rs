//! Items over a range of longitude and latitude, by density and a law of size.
//!
//! Item 17 is the same however many are asked for: each number is a hash of seed, item and use. With a least separation, an item
//! depends on the items before it, never on those after it.

mod spread;

use quantities::degrees;

use crate::draw::{Use, draw};
use crate::frame::{Frame, told};
use crate::refused::{Refused, expect};
use crate::size_law::SizeLaw;

/// Most items of one distribution.
pub const MOST_ITEMS: f64 = 1e7;

/// How many items lie where, and how large they are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distribution {
    /// Seed of all numbers.
    pub seed: u64,
    /// West and east edge (rad), the east above the west.
    pub longitude: [f64; 2],
    /// South and north edge (rad).
    pub latitude: [f64; 2],
    /// Smallest and largest radius (m).
    pub radius: [f64; 2],
    /// Law of the radii between them.
    pub sizes: SizeLaw,
    /// Items a square metre.
    pub density: f64,
    /// Least distance between two items (m); 0 where any will do.
    pub separation: f64,
    /// Whether latitudes are drawn evenly in angle, which crowds the poles (as reported), not evenly in area.
    pub is_even_in_angle: bool,
}

/// A place and a size that a distribution drew.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Item {
    /// Number of the item in its distribution, from 0.
    pub number: u64,
    /// Latitude and longitude (rad).
    pub place: [f64; 2],
    /// Place: north, east (m).
    pub at: [f64; 2],
    /// Radius of the item (m).
    pub radius: f64,
}

impl Distribution {
    /// Number of items: density times area on the sphere, rounded.
    ///
    /// # Errors
    /// If a range does not ascend, a number is out of range, or the items are more than 10 million.
    pub fn count(&self, frame: &Frame) -> Result<u64, Refused> {
        self.sizes.check(self.radius)?;
        let [west, east] = self.longitude;
        let expected = "west and east in ascending order";
        expect(east > west && east - west <= 7.0, "longitude_deg", told(self.longitude), expected)?;
        let [south, north] = self.latitude;
        let is_sound = south < north && degrees(south) >= -90.0 && degrees(north) <= 90.0;
        expect(is_sound, "latitude_deg", told(self.latitude), "south and north in ascending order")?;
        let per_km2 = 1e6 * self.density;
        expect((0.0..=1e15).contains(&per_km2), "density_per_km2", per_km2, "a number of 0 or more")?;
        let is_length = (0.0..=1e7).contains(&self.separation);
        expect(is_length, "min_separation_m", self.separation, "a length of 0 m or more")?;
        let count = (self.density * frame.area(self.longitude, self.latitude)).round();
        let found = format!("{per_km2}, {count} items,");
        expect(count <= MOST_ITEMS, "density_per_km2", found, "at most 10 million items")?;
        Ok(count as u64)
    }

    /// All items in order of their numbers. With a least separation, an item that finds no room is left out; its number is not
    /// given to another.
    ///
    /// # Errors
    /// As those of [`count`](Self::count).
    pub fn items(&self, frame: &Frame) -> Result<Vec<Item>, Refused> {
        let count = self.count(frame)?;
        if self.separation > 0.0 {
            return Ok(spread::apart(self, frame, count));
        }
        Ok((0..count).map(|number| self.item(frame, number, 0)).collect())
    }

    /// One item, at its `attempt`th place.
    fn item(&self, frame: &Frame, number: u64, attempt: u64) -> Item {
        let share = |purpose, attempt| draw(self.seed, number, purpose, attempt);
        let [west, east] = self.longitude;
        let longitude = west + share(Use::Longitude, attempt) * (east - west);
        let latitude = self.latitude_at(share(Use::Latitude, attempt));
        let at = frame.forward(latitude, longitude);
        let radius = self.sizes.radius(share(Use::Radius, 0), self.radius);
        Item { number, place: [latitude, longitude], at, radius }
    }

    /// Latitude (rad) below which a share of the items lies.
    pub fn latitude_at(&self, share: f64) -> f64 {
        let [south, north] = self.latitude;
        if self.is_even_in_angle {
            return south + share * (north - south);
        }
        let [low, high] = self.latitude.map(libm::sin);
        libm::asin((low + share * (high - low)).clamp(-1.0, 1.0))
    }
}
