//! The Gregorian calendar as a count of days.

fn is_leap_year(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

/// Number of days in a month from 1 to 12.
pub(crate) fn days_of(year: i64, month: i64) -> i64 {
    match month {
        2 if is_leap_year(year) => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        _ => 31,
    }
}

/// Days from 2000-01-01 to a date of the Gregorian calendar.
pub fn days_from_civil([year, month, day]: [i64; 3]) -> i64 {
    let before = year - 1;
    let of_years = 365 * before + before.div_euclid(4) - before.div_euclid(100) + before.div_euclid(400);
    let of_months: i64 = (1..month).map(|month| days_of(year, month)).sum();
    // 730 119 days of whole years before the year 2000.
    of_years + of_months + day - 1 - 730_119
}

/// Year, month and day, so many days after 2000-01-01.
pub(crate) fn civil_from_days(days: i64) -> [i64; 3] {
    // Not after the right one, on either side of 2000.
    let mut year = 2000 + days.div_euclid(366).min(days.div_euclid(365));
    while days_from_civil([year + 1, 1, 1]) <= days {
        year += 1;
    }
    let month = (1..=12).rev().find(|month| days_from_civil([year, *month, 1]) <= days).unwrap_or(1);
    [year, month, days - days_from_civil([year, month, 1]) + 1]
}

#[cfg(test)]
mod tests {
    use super::{civil_from_days, days_from_civil};
    use proptest::prelude::{prop_assert, prop_assert_eq, proptest};

    #[test]
    fn julian_days_of_meeus() {
        // Astronomical Algorithms, 2nd ed., p. 62: Julian days of noon; J2000.0 is 2451545.
        for (date, julian) in [
            ([2000, 1, 1], 2_451_545),
            ([1987, 6, 19], 2_446_966),
            ([1999, 1, 1], 2_451_180),
            ([1600, 12, 31], 2_305_813),
        ] {
            assert_eq!(days_from_civil(date) + 2_451_545, julian, "{date:?}");
        }
    }

    proptest! {
        #[test]
        fn dates_and_days_are_inverse(day in -730_119..2_900_000_i64) {
            let date = civil_from_days(day);
            prop_assert_eq!(days_from_civil(date), day);
            prop_assert!((1..=12).contains(&date[1]) && (1..=31).contains(&date[2]));
        }
    }
}
