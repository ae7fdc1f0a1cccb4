//! Elevation files made here, each with something that programs read wrong: what is not understood is never passed over.

mod advice;
mod cases;
mod cells;
mod damage;
mod gdal;
mod geotiff;
mod made;
mod marks;
mod pds3;
mod place;
mod words;
