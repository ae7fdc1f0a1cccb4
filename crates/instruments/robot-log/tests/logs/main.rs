//! A small run as a robot log and as OpenEXR files, read back and held against the run folder.

mod exr_files;
mod refusals;
mod robot_log;
mod scene;
