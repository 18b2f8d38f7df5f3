//! Error against run time: draws variants of a scene, holds them against a reference, times them.
//!
//! A [`Subject`] is one way to draw a scene: with some macros, in some precision, giving its colour or
//! a value from within.

pub mod compare;
mod subject;

pub use subject::{Drawn, MeasureError, Subject};
