//! Error against run time: draws variants of a scene, holds them against a reference, times them.
//!
//! A [`Subject`] is one way to draw a scene: with some macros, in some precision, giving its colour or
//! a value from within.

pub mod compare;
pub mod plot;
pub mod report;
pub mod run;
pub mod study;
mod subject;
pub mod summary;

pub use subject::{Drawn, MeasureError, Subject};
