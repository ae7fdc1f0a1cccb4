//! The reader of dates against known instants, and what it refuses.

use dates::{DateError, Moment, read};
use proptest::prelude::{prop_assert_eq, proptest};

fn moment(text: &str) -> Moment {
    read(text).unwrap_or_else(|error| panic!("{text}: {error}")).moment
}

/// Seconds since 1970 by `date -u -d TEXT +%s` of GNU coreutils, which counts no leap seconds.
#[test]
fn known_instants() {
    let origin = moment("1970-01-01T00:00:00Z").without_leaps();
    for (text, seconds) in [
        ("1970-01-01T00:00:00Z", 0.0),
        ("2023-11-14T22:13:20Z", 1_700_000_000.0),
        ("2000-02-29 12:00:00.25Z", 951_825_600.25),
        ("2000-02-29t12:00:00,25z", 951_825_600.25),
        ("1969-07-20T20:17:40Z", -14_182_940.0),
        ("2100-03-01T00:00:00Z", 4_107_542_400.0),
        ("2023-11-14T23:13:20+01:00", 1_700_000_000.0),
        ("2023-11-14T16:43:20-0530", 1_700_000_000.0),
        ("2023-11-14T23:13+01", 1_699_999_980.0),
        ("2023-11-14T22:13:20", 1_700_000_000.0),
    ] {
        assert_eq!(moment(text).without_leaps() - origin, seconds, "{text}");
    }
    assert!(read("2023-11-14T22:13:20Z").unwrap().has_zone && !read("2023-11-14T22:13:20").unwrap().has_zone);
}

#[test]
fn a_leap_second_is_a_second_of_its_own() {
    let texts = ["2016-12-31T23:59:59Z", "2016-12-31T23:59:60Z", "2017-01-01T00:00:00Z"];
    let [before, leap, after] = texts.map(moment);
    assert_eq!([leap.since(before), after.since(leap)], [1.0; 2]);
    assert_eq!([before, leap, after].map(|moment| moment.to_string()), texts);
    assert_eq!([before, leap, after].map(Moment::leap_seconds), [26, 26, 27]);
    assert_eq!([before, leap, after].map(Moment::year), [2016, 2016, 2017]);
    assert_eq!(moment("2017-01-01T00:59:60+01:00"), leap);
    assert_eq!(moment("2016-12-31T23:59:60.25Z").to_string(), "2016-12-31T23:59:60.250Z");
    assert_eq!(before.later(1.9996).to_string(), "2017-01-01T00:00:00Z");
    // All 27 lie between these.
    let whole = moment("2026-01-01T00:00:00Z").since(moment("1972-01-01T00:00:00Z"));
    assert_eq!(whole, 19_724.0 * 86_400.0 + 27.0);
}

#[test]
fn what_is_no_date() {
    for text in [
        "",
        "2023",
        "2023-11-14",
        "22:00:00Z",
        "72-12-11T22:00:00Z",
        "1972-1-11T22:00:00Z",
        "1972-12-11T2200Z",
        "2023-11-14T00:00:00.Z",
        "2023-11-14T01:00.5Z",
        "2023-11-14T1:00:00Z",
        "2023-11-14T01:00:00ZZ",
        "2023-11-14T01:00:00Zulu",
        "2023-11-14T01:00:00+1",
        "2023-11-14T01:00:00+01:0",
        "2023-11-14T01:00:00+\u{e9}1:00",
        "14.11.2023 22:13:20",
        "+023-11-14T01:00:00Z",
        "20\u{e4}3-11-14T01:00:00Z",
    ] {
        assert_eq!(read(text), Err(DateError::Form), "{text}");
    }
}

#[test]
fn days_and_times_that_do_not_exist() {
    for (text, what, found) in [
        ("0000-01-01T00:00:00Z", "year", 0),
        ("2023-13-01T00:00:00Z", "month", 13),
        ("2023-00-01T00:00:00Z", "month", 0),
        ("2023-02-29T00:00:00Z", "day", 29),
        ("1900-02-29T00:00:00Z", "day", 29),
        ("2023-11-14T24:00:00Z", "hour", 24),
        ("2023-11-14T00:60:00Z", "minute", 60),
        ("2023-11-14T00:00:61Z", "second", 61),
        ("2023-11-14T00:00:60Z", "second", 60),
        ("2017-12-31T23:59:60Z", "second", 60),
        ("2016-12-31T23:59:60+01:00", "second", 60),
        ("2023-11-14T00:00:00+99:00", "offset of hours", 99),
        ("2023-11-14T00:00:00+01:60", "offset of minutes", 60),
    ] {
        let error = read(text).unwrap_err();
        let is_right = matches!(&error, DateError::Calendar { what: part, found: number, .. } if (*part, *number) == (what, found));
        assert!(is_right && error.to_string().contains("expected a date with"), "{text}: {error}");
    }
    assert!(read("2017-12-31T23:59:60Z").unwrap_err().to_string().contains("no leap second"));
}

proptest! {
    #[test]
    fn what_is_written_reads_back(seconds in -60_000_000_000_i64..200_000_000_000) {
        let found = moment("2000-01-01T00:00:00Z").later(seconds as f64);
        prop_assert_eq!(moment(&found.to_string()), found);
    }

    #[test]
    fn no_text_panics(text in "\\PC{0,30}", digits in "[0-9TZ:.+-]{0,30}") {
        let _ = (read(&text), read(&digits));
    }
}
