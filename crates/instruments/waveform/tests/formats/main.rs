//! Every format, opened by an independent reader or by the tool it is for, and compared value by value.

mod arrays;
mod changes;
mod failures;
mod sample;
mod sizes;
mod tables;
mod tools;
