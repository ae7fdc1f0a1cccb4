//! Analog parts: lags, amplifiers, multipliers, converters, comparators, switches, each by its exact solution over a sample.
