//! Small programs, built by hand.
