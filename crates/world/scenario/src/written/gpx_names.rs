//! Names of a GPX file (<https://www.topografix.com/GPX/1/1>): versions, and elements that are harmless.

/// Namespaces of the versions that are read.
pub const NAMESPACES: [&str; 2] = ["http://www.topografix.com/GPX/1/1", "http://www.topografix.com/GPX/1/0"];
/// What the attribute `version` may say.
pub const VERSIONS: [&str; 2] = ["1.1", "1.0"];
/// Elements beside tracks that a path does not need.
pub const BESIDE_TRACKS: &[&str] = &[
    "metadata",
    "extensions",
    "wpt",
    "rte",
    "name",
    "desc",
    "author",
    "email",
    "url",
    "urlname",
    "time",
    "keywords",
    "bounds",
];
/// Elements of a track beside its segments.
pub const OF_TRACK: &[&str] =
    &["name", "cmt", "desc", "src", "link", "url", "urlname", "number", "type", "extensions"];
/// Elements of a segment beside its points.
pub const OF_SEGMENT: &[&str] = &["extensions"];
/// Elements of a point beside its height and time: how good it is, and how fast and whither its receiver moved.
pub const OF_POINT: &[&str] = &[
    "magvar",
    "geoidheight",
    "name",
    "cmt",
    "desc",
    "src",
    "link",
    "url",
    "urlname",
    "sym",
    "type",
    "fix",
    "sat",
    "hdop",
    "vdop",
    "pdop",
    "ageofdgpsdata",
    "dgpsid",
    "course",
    "speed",
    "extensions",
];
