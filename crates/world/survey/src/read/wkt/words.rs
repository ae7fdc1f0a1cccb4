//! Elements of well-known text and parameters of maps, and what becomes of each.

use crate::read::words::Fate::{Harmless, Only, Refused, Used};
use crate::read::words::{Vocabulary, named};

/// Elements of well-known text.
pub const ELEMENTS: Vocabulary = Vocabulary {
    kind: "element of well-known text",
    prefix: "wkt:",
    words: &[
        named("PROJCS", Used("a map; its unit is the one directly inside")),
        named("GEOGCS", Used("the body; its unit is that of angles")),
        named("DATUM", Used("the spheroid is in it")),
        named("SPHEROID", Used("radius and flattening; a note tells of an ellipsoid")),
        named("ELLIPSOID", Used("as SPHEROID")),
        named("PRIMEM", Used("longitude of the prime meridian, which is added")),
        named("UNIT", Used("metres of a unit of the map, or radians of a unit of angles")),
        named(
            "PROJECTION",
            Used("kind of the map; the metres of an unknown one are taken as they are, with a note"),
        ),
        named("PARAMETER", Used("a figure of the map, decided by its own table")),
        named("AUTHORITY", Harmless("a code of the same system")),
        named(
            "AXIS",
            Harmless(
                "names of the axes, whose order is that of the file's format; directions west, south and down are refused, but around a pole",
            ),
        ),
        named("EXTENSION", Harmless("the same system in another language")),
        named("METADATA", Harmless("text")),
        named("TOWGS84", Harmless("a shift to another system of the Earth")),
        named("GEOCCS", Refused("coordinates from the centre of the body")),
        named("LOCAL_CS", Refused("axes that are tied to nothing")),
        named("COMPD_CS", Refused("a system of heights of its own")),
        named("VERT_CS", Refused("a system of heights of its own")),
        named("VERTCS", Refused("a system of heights of its own")),
        named("FITTED_CS", Refused("a system within another one")),
        named("PROJCRS", Refused("well-known text of version 2")),
        named("GEOGCRS", Refused("well-known text of version 2")),
        named("GEODCRS", Refused("well-known text of version 2")),
    ],
};

/// Parameters of a map, by the letters of their names.
pub const PARAMETERS: Vocabulary = Vocabulary {
    kind: "parameter of a map in well-known text",
    prefix: "parameter:",
    words: &[
        named("false_easting", Used("easting of the origin")),
        named("false_northing", Used("northing of the origin")),
        named("central_meridian", Used("longitude of the origin")),
        named("longitude_of_center", Used("longitude of the origin")),
        named("longitude_of_origin", Used("longitude of the origin")),
        named("longitude_of_natural_origin", Used("longitude of the origin")),
        named("latitude_of_origin", Used("latitude of the origin, or of true scale in a polar map")),
        named("latitude_of_center", Used("as latitude_of_origin")),
        named("latitude_of_natural_origin", Used("as latitude_of_origin")),
        named("standard_parallel_1", Used("parallel that is true to scale")),
        named("latitude_of_1st_standard_parallel", Used("as standard_parallel_1")),
        named("latitude_of_standard_parallel", Used("as standard_parallel_1")),
        named("standard_parallel_2", Used("refused if it is another than standard_parallel_1")),
        named("scale_factor", Used("scale at the pole; 1 in other maps, else refused")),
        named("scale_factor_at_natural_origin", Used("as scale_factor")),
        named("azimuth", Only(&["0", "90"], "a turned map")),
        named("rectified_grid_angle", Only(&["0", "90"], "a turned map")),
    ],
};
