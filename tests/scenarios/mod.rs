//! The shipped scenarios: they agree with `exact`, and each shows what it says (`scenarios/README.md`).

mod agreement_with_exact;
mod figures;
mod landscape_figures;
mod two_levels;
