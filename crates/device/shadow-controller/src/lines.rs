//! Which boundary segments of some lists the sweeps of a frame cross.

use std::ops::Range;

use fearless_simd::Simd;
use remote_shadow::Outlines;

use crate::crossing::Place;
use crate::crossings::{ROOM, Sighting};
use crate::fan::{Fan, Guesses, Line, Sifted, TOGETHER, WORD};

/// Corners that are looked at together, as many as the first-level cache holds guesses of: most lists are short, and each by
/// itself would end in the middle of a vector and of a word.
const CORNERS: usize = 1024;

/// A line, where it is from, and the number of sweeps to the left of its two ends, which differ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MetLine {
    pub(crate) line: Line,
    pub(crate) place: Place,
    pub(crate) left: [u32; 2],
}

impl MetLine {
    /// Sweeps that cross it.
    pub(crate) fn sweeps(&self) -> Range<usize> {
        let [a, b] = self.left;
        a.min(b) as usize..a.max(b) as usize
    }
}

/// Finds lines that sweeps cross; used again from lists to lists.
#[derive(Debug)]
pub(crate) struct Finder {
    met: Vec<MetLine>,
    guesses: Guesses,
    /// Corners that are guessed at.
    corners: usize,
    /// Those from which no line runs on, ascending.
    ends: Vec<u32>,
    /// Their lists, each with the number of its first corner.
    lists: Vec<Place>,
}

impl Finder {
    pub(crate) fn new() -> Self {
        let (met, guesses) = (Vec::with_capacity(ROOM), Guesses::default());
        Self { met, guesses, corners: 0, ends: Vec::new(), lists: Vec::new() }
    }

    /// Lines of some lists, the first of which is number `first`, that sweeps of the fan cross.
    #[inline(always)]
    pub(crate) fn of<V: Simd>(
        &mut self,
        simd: V,
        fan: &Fan<'_>,
        (first, lists): (usize, &[&Outlines]),
        sighting: &impl Sighting,
    ) -> &[MetLine] {
        self.met.clear();
        for (list, outlines) in (first..).zip(lists) {
            self.guess(simd, fan, list as u32, outlines, sighting);
            if self.corners >= CORNERS {
                self.sift(simd, fan);
            }
        }
        self.sift(simd, fan);
        &self.met
    }

    /// Adds the corners of a list.
    #[inline(always)]
    fn guess<V: Simd>(
        &mut self,
        simd: V,
        fan: &Fan<'_>,
        list: u32,
        outlines: &Outlines,
        sighting: &impl Sighting,
    ) {
        let (corners, guesser, begin) = (outlines.corners(), fan.guesser(simd), self.corners);
        let count = corners.len();
        if count == 0 {
            return;
        }
        self.guesses.make_room(begin + count);
        // A loop, no closure: it has the vectors of its caller.
        for first in (0..count).step_by(TOGETHER) {
            // The last eight, some of them once more.
            let first = first.min(count.saturating_sub(TOGETHER));
            guesser.guess(begin + first, sighting.all_seen(corners.some(first)), &mut self.guesses);
        }
        self.lists.push([list, begin as u32]);
        self.ends.extend(outlines.ends().iter().map(|end| begin as u32 + end));
        self.corners += count;
        self.ends.push(self.corners as u32 - 1);
    }

    /// Keeps those lines between the corners that sweeps cross, and has no corners then.
    #[inline(always)]
    fn sift<V: Simd>(&mut self, simd: V, fan: &Fan<'_>) {
        let count = self.corners.saturating_sub(1);
        let (mut ends, mut lists) = (self.ends.as_slice(), self.lists.as_slice());
        for first in (0..count).step_by(WORD) {
            let mut sifted = self.guesses.sift(simd, first, WORD.min(count - first));
            while let Some((&end, others)) = ends.split_first()
                && (end as usize) < first + WORD
            {
                sifted.may_cross &= !(1 << (end as usize - first));
                ends = others;
            }
            keep_met(fan, first as u32, sifted, &self.guesses, &mut lists, &mut self.met);
        }
        self.corners = 0;
        self.ends.clear();
        self.lists.clear();
    }
}

/// Keeps those of a word of lines, of which the first begins at corner `first`, that sweeps cross. `lists` begins with the list
/// of that corner or one before it, and then with that of the last line.
#[inline(always)]
fn keep_met(
    fan: &Fan<'_>,
    first: u32,
    Sifted { mut may_cross, known }: Sifted,
    guesses: &Guesses,
    lists: &mut &[Place],
    met: &mut Vec<MetLine>,
) {
    while may_cross != 0 {
        let n = may_cross.trailing_zeros();
        may_cross &= may_cross - 1;
        let corner = first + n;
        let left = if known >> n & 1 == 1 {
            guesses.left(corner as usize)
        } else {
            match fan.span(&guesses.line(corner as usize)) {
                Some([a, b]) if a != b => [a as u32, b as u32],
                _ => continue,
            }
        };
        while let Some([_, begin]) = lists.get(1)
            && *begin <= corner
        {
            *lists = &lists[1..];
        }
        let [list, begin] = lists[0];
        met.push(MetLine { line: guesses.line(corner as usize), place: [list, corner - begin], left });
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};
    use proptest::prelude::{prop_assert_eq, proptest};
    use quantities::{sin_cos, unit_interval};
    use remote_shadow::Outlines;

    use super::Finder;
    use crate::crossings::Sighting;
    use crate::fan::Fan;

    struct Here;

    impl Sighting for Here {
        fn seen(&self, place: [f64; 2]) -> [f64; 2] {
            place
        }
    }

    /// List `number`: as many closed outlines, of so many corners each.
    fn list(number: u64, outlines: u64, corners: u64) -> Outlines {
        let place = |outline: u64, corner: u64| {
            let at = |axis: u64, centre: u64| unit_interval(axis, &[number, outline, centre]);
            [30.0 * at(0, 0) - 6.0 + at(1, 1 + corner), 30.0 * at(2, 0) - 15.0 + at(3, 1 + corner)]
        };
        let outline = |outline| (0..corners).map(|corner| place(outline, corner)).collect::<Vec<_>>();
        Outlines::of(&(0..outlines).map(outline).collect::<Vec<_>>())
    }

    proptest! {
        /// Lists in any number and of any lengths, none among them: lines are found one by one as they are found together.
        #[test]
        fn lines_of_many_lists_are_those_of_each(
            sizes in proptest::collection::vec((0..4u64, 3..40u64), 0..60),
            first in 0..1000usize,
        ) {
            let direction = |n: i32| { let (sin, cos) = sin_cos(0.01 * f64::from(n)); [cos, sin] };
            let directions: Vec<[f64; 2]> = (-30..=30).map(direction).collect();
            let fan = Fan::new(&directions).expect("less than half a turn");
            let lists: Vec<Outlines> =
                (0..).zip(&sizes).map(|(number, &(outlines, corners))| list(number, outlines, corners)).collect();
            let (lists, mut finder): (Vec<&Outlines>, _) = (lists.iter().collect(), Finder::new());
            let mut expected = Vec::new();
            for (list, outlines) in (first as u32..).zip(&lists) {
                for number in (0..outlines.corners().len()).filter(|&n| n + 1 < outlines.corners().len()) {
                    let line = outlines.segment(number);
                    let left = fan.span(&line).filter(|[a, b]| a != b && !outlines.ends().contains(&(number as u32)));
                    expected.extend(left.map(|left| ([list, number as u32], left.map(|n| n as u32), line)));
                }
            }
            for _ in 0..2 {
                let found = dispatch!(Level::new(), simd => finder.of(simd, &fan, (first, &lists), &Here).to_vec());
                let found: Vec<_> = found.into_iter().map(|met| (met.place, met.left, met.line)).collect();
                prop_assert_eq!(&found, &expected);
            }
        }
    }
}
