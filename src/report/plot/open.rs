//! How large is each order over an open angle, and where is it exactly zero? Curves in floats, zeros from the verdicts.
