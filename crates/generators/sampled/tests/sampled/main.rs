//! Pictures of `sampled` against closed forms, an evaluator of their own, and the specification's acceptance tests.

mod any_order;
mod any_pose;
mod bad_parameters;
mod beacons;
mod beam_list;
mod bodies;
mod dust;
mod eye;
mod faults;
mod filters;
mod flux;
mod ground;
mod judged;
mod overlays;
mod overload;
mod rows_of_lamps;
mod screen_edge;
mod second_evaluator;
mod shots;
mod sky;
mod stacks;
mod tall;
mod twinkle;
