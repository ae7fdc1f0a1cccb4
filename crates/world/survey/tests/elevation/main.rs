//! Elevation files made here, each with something that programs read wrong: what is not understood is never passed over.

mod advice;
mod cases;
mod cells;
mod damage;
mod doubts;
mod formats;
mod gdal;
mod geotiff;
mod hostile;
mod labels;
mod made;
mod marks;
mod pds3;
mod place;
mod windows;
mod words;
mod words_of_labels;
