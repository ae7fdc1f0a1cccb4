//! One axis of the design: where the samples fall in the regions, and the six weights of each.

use landscape::basis;

/// Samples along one axis of a level, ascending; the design of the fit is the product of two of these.
#[derive(Debug, Clone, Default)]
pub struct Axis {
    /// Samples of region r are `starts[r]..starts[r + 1]`.
    pub starts: Vec<usize>,
    /// `g_ip` at each sample, index `3 i + p`: weight of derivative p at corner i of its region.
    pub weights: Vec<[f64; 6]>,
    /// `d g_ip / dz` at each sample.
    pub slopes: Vec<[f64; 6]>,
}

impl Axis {
    /// The `count` places `first + k step` (m, from the first corner) that lie in `regions` regions of `size` m.
    ///
    /// A sample on the line between two regions belongs to the farther one; the last region has both its ends.
    pub fn new(regions: usize, size: f64, first: f64, step: f64, count: usize) -> Self {
        let mut axis = Self { starts: vec![0], ..Self::default() };
        for k in 0..count {
            let at = (first + k as f64 * step) / size;
            if at > regions as f64 + 1e-9 {
                break;
            }
            let region = (at.floor().max(0.0) as usize).min(regions - 1);
            axis.open_region(region);
            let local = (at - region as f64).clamp(0.0, 1.0);
            axis.weights.push(basis::values(local));
            axis.slopes.push(basis::derivatives(local));
        }
        axis.open_region(regions);
        axis
    }

    /// Regions along the axis.
    pub fn regions(&self) -> usize {
        self.starts.len() - 1
    }

    /// Samples along the axis that lie in the level.
    pub fn samples(&self) -> usize {
        self.weights.len()
    }

    /// Samples of one region.
    pub fn of_region(&self, region: usize) -> std::ops::Range<usize> {
        self.starts[region]..self.starts[region + 1]
    }

    fn open_region(&mut self, region: usize) {
        while self.starts.len() <= region {
            self.starts.push(self.weights.len());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    #[test]
    fn every_sample_has_one_region() {
        let axis = Axis::new(3, 10.0, 0.0, 2.5, 13);
        assert_eq!(axis.starts, [0, 4, 8, 13]);
        assert_eq!(axis.weights[4][0], 1.0);
        assert_eq!(axis.weights[12][3], 1.0);
    }

    #[test]
    fn regions_between_samples_are_empty_and_samples_beyond_are_left() {
        let axis = Axis::new(5, 1.0, 0.5, 2.0, 9);
        assert_eq!(axis.starts, [0, 1, 1, 2, 2, 3]);
        assert_eq!(axis.samples(), 3);
    }
}
