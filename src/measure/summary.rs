//! What a study's cells say of each variant, all moments together.

use serde::Serialize;

use super::run::{Cell, Errors, Findings};
use super::study;

/// A variant over all moments.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Its family.
    pub family: String,
    /// What tells it apart there.
    pub label: String,
    /// Which of the study's references it is held against.
    pub reference: usize,
    /// Milliseconds a frame: the mean over the moments of the median of the repetitions.
    pub milliseconds: Option<f64>,
    /// How far the repetitions lie apart, relatively: the largest of (highest − lowest) / median.
    pub spread: Option<f64>,
    /// Nanoseconds a pixel.
    pub nanoseconds: Option<f64>,
    /// Rounds of loops a pixel, the mean over the moments.
    pub rounds: f64,
    /// The most in one pixel, at any moment.
    pub most_rounds: f64,
    /// The largest error of any moment: the probe's median, or the picture's RMSE without a probe. `None` if
    /// at some moment no pixel is hit by both.
    pub error: Option<f64>,
    /// The same of the method alone.
    pub discretisation: Option<f64>,
    /// The same of rounding alone.
    pub rounding: Option<f64>,
    /// The probe's 99th percentile, the largest of any moment.
    pub p99: Option<f64>,
    /// Pixels at any moment that hit what the reference misses, or the other way round; their share.
    pub disagreements: Option<f64>,
    /// The picture's RMSE, the largest of any moment.
    pub rmse: f64,
    /// The picture's peak signal-to-noise ratio in decibels, the smallest of any moment; `None` where it is
    /// infinite.
    pub psnr: Option<f64>,
    /// The share of pixels that are off by more than 1/255, the largest of any moment.
    pub above_1: f64,
    /// The share of pixels that are off by more than 8/255, the largest of any moment.
    pub above_8: f64,
    /// How much the error changes from frame to frame, the most at any moment, if the study asks.
    pub flicker: Option<f64>,
    /// Whether no other variant that is held against the same reference at the same moments is both faster
    /// and nearer.
    pub is_best: bool,
}

impl Row {
    /// Family and label.
    pub fn name(&self) -> String {
        study::name(&self.family, &self.label)
    }
}

/// A row for each variant, in the study's order.
pub fn rows(findings: &Findings) -> Vec<Row> {
    let of_same = |a: &Cell, b: &Cell| a.family == b.family && a.label == b.label;
    let mut rows: Vec<Row> = findings
        .cells
        .chunk_by(of_same)
        .map(|cells| row(cells, findings.pixels))
        .collect();
    let points: Vec<_> = rows
        .iter()
        .map(|row| (row.reference, row.milliseconds.zip(row.error)))
        .collect();
    for row in &mut rows {
        let own = row.milliseconds.zip(row.error);
        row.is_best = own.is_some_and(|(time, error)| {
            !points.iter().any(|&(reference, other)| {
                reference == row.reference
                    && other.is_some_and(|other: (f64, f64)| {
                        (other.0 < time && other.1 <= error) || (other.0 <= time && other.1 < error)
                    })
            })
        });
    }
    rows
}

fn row(cells: &[Cell], pixels: u32) -> Row {
    let count = cells.len() as f64;
    let largest = |of: &dyn Fn(&Cell) -> Option<f64>| -> Option<f64> {
        let all: Option<Vec<f64>> = cells.iter().map(of).collect();
        all?.into_iter().reduce(f64::max)
    };
    let part = |errors: Option<Errors>| errors?.main();
    let medians: Option<Vec<f64>> = cells.iter().map(Cell::median_seconds).collect();
    let seconds = medians.map(|medians| medians.iter().sum::<f64>() / count);
    Row {
        family: cells[0].family.clone(),
        label: cells[0].label.clone(),
        reference: cells[0].reference,
        milliseconds: seconds.map(|seconds| seconds * 1e3),
        spread: largest(&|cell| {
            let (first, last) = (cell.seconds.first()?, cell.seconds.last()?);
            Some((last - first) / cell.median_seconds()?)
        }),
        nanoseconds: seconds.map(|seconds| seconds * 1e9 / f64::from(pixels)),
        rounds: cells.iter().map(|cell| cell.rounds).sum::<f64>() / count,
        most_rounds: largest(&|cell| Some(cell.most_rounds)).unwrap_or(0.0),
        error: largest(&|cell| cell.error()),
        discretisation: largest(&|cell| part(cell.discretisation)),
        rounding: largest(&|cell| part(cell.rounding)),
        p99: largest(&|cell| {
            let probe = cell.total.probe?;
            (probe.hits > 0).then_some(probe.p99)
        }),
        disagreements: largest(&|cell| {
            Some(cell.total.probe?.disagreements as f64 / f64::from(pixels))
        }),
        rmse: largest(&|cell| Some(cell.total.picture.rmse)).unwrap_or(0.0),
        psnr: largest(&|cell| Some(-cell.total.picture.psnr))
            .map(|least| -least)
            .filter(|least| least.is_finite()),
        above_1: largest(&|cell| Some(cell.total.picture.above_1)).unwrap_or(0.0),
        above_8: largest(&|cell| Some(cell.total.picture.above_8)).unwrap_or(0.0),
        flicker: largest(&|cell| cell.flicker),
        is_best: false,
    }
}

/// The cheapest variant whose error, and whose share of pixels that hit what the reference misses or the
/// other way round, are no more than this, of those that are held against the study's own
/// reference at its own moments: by time, or by rounds of loops where the device cannot tell its time.
pub fn cheapest(rows: &[Row], goal: f64) -> Option<&Row> {
    let cost = |row: &&Row| row.milliseconds.unwrap_or(row.rounds);
    rows.iter()
        .filter(|row| row.reference == 0 && row.error.is_some_and(|error| error <= goal))
        .filter(|row| row.disagreements.unwrap_or(0.0) <= goal)
        .min_by(|a, b| cost(a).total_cmp(&cost(b)))
}
