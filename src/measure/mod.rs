//! Error against run time: draws variants of a scene, holds them against a reference, times them.
//!
//! A [`study::Study`] names them, [`run::run`] draws and compares them, [`summary::rows`] says what that
//! means for each variant, and [`report`] and [`plot`] show it.

pub mod compare;
pub mod plot;
pub mod report;
pub mod run;
pub mod stability;
pub mod study;
pub mod summary;
