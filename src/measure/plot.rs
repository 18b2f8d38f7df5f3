//! Error against cost as SVG, both axes logarithmic.

use plotters::prelude::*;

use super::summary::Row;

/// What an error is plotted against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Milliseconds a frame.
    Time,
    /// Rounds of loops a pixel.
    Rounds,
}

impl Against {
    fn of(self, row: &Row) -> Option<f64> {
        match self {
            Against::Time => row.milliseconds,
            Against::Rounds => Some(row.rounds),
        }
    }

    fn label(self) -> &'static str {
        match self {
            Against::Time => "ms a frame",
            Against::Rounds => "loop rounds a pixel",
        }
    }
}

const SIZE: (u32, u32) = (980, 480);

/// How much of the width the chart has; the rest is for the families' names, so that they hide no point.
const CHART: u32 = 720;

/// What an error of 0 is drawn as.
const LEAST: f64 = 1e-9;

/// Draws a curve for each family, a ring around what no other variant beats; `None` if there is nothing
/// to draw.
pub fn plot(rows: &[Row], against: Against, title: &str, error: &str) -> Option<String> {
    let point = |row: &Row| Some((against.of(row).filter(|x| *x > 0.0)?, row.error?.max(LEAST)));
    let points: Vec<_> = rows.iter().filter_map(point).collect();
    if points.is_empty() {
        return None;
    }
    let range = |of: &dyn Fn(&(f64, f64)) -> f64| {
        let low = points.iter().map(of).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(of).fold(0.0, f64::max);
        around(low, high)
    };
    let mut svg = String::new();
    // An SVG in memory cannot fail to be written.
    draw(
        SVGBackend::with_string(&mut svg, SIZE),
        rows,
        &point,
        (range(&|point| point.0), range(&|point| point.1)),
        [title, against.label(), error],
    )
    .ok()?;
    Some(svg)
}

/// 1, 2 and 5 times powers of ten, from below `low` to above `high`.
fn around(low: f64, high: f64) -> Vec<f64> {
    let decades = low.log10().floor() as i32 - 1..=high.log10().ceil() as i32 + 1;
    let all: Vec<f64> = decades
        .flat_map(|decade| [1.0, 2.0, 5.0].map(|digit| digit * 10_f64.powi(decade)))
        .collect();
    let begin = all.iter().rposition(|&mark| mark < low * 0.95).unwrap_or(0);
    let end = all.iter().position(|&mark| mark > high * 1.05);
    all[begin..=end.unwrap_or(all.len() - 1)].to_vec()
}

type Point = (f64, f64);
/// The marks of the two axes, ascending; the first and last are their ends.
type Marks = (Vec<f64>, Vec<f64>);

fn draw(
    backend: SVGBackend<'_>,
    rows: &[Row],
    point: &dyn Fn(&Row) -> Option<Point>,
    (x, y): Marks,
    [title, x_label, y_label]: [&str; 3],
) -> Result<(), Box<dyn std::error::Error>> {
    let area = backend.into_drawing_area();
    area.fill(&WHITE)?;
    let axis = |marks: Vec<f64>| {
        let range = marks[0]..marks[marks.len() - 1];
        range.log_scale().with_key_points(marks)
    };
    let (left, legend) = area.split_horizontally(CHART);
    let mut chart = ChartBuilder::on(&left)
        .caption(title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(44)
        .y_label_area_size(72)
        .build_cartesian_2d(axis(x), axis(y))?;
    chart
        .configure_mesh()
        .x_desc(x_label)
        .y_desc(y_label)
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.15))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .x_label_formatter(&|x| {
            if *x < 10.0 {
                format!("{x:.1}")
            } else {
                format!("{x:.0}")
            }
        })
        .draw()?;
    let families = rows.chunk_by(|a, b| a.family == b.family);
    for (index, family) in families.enumerate() {
        let colour = Palette99::pick(index).to_rgba();
        let points: Vec<Point> = family.iter().filter_map(point).collect();
        chart.draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?;
        let y = 52 + 18 * index as i32;
        legend.draw(&PathElement::new([(4, y), (24, y)], colour.stroke_width(3)))?;
        let name = family[0].family.clone();
        legend.draw(&Text::new(name, (32, y - 6), ("sans-serif", 13)))?;
        let dots = points
            .iter()
            .map(|&point| Circle::new(point, 4, colour.filled()));
        chart.draw_series(dots)?;
        let best = family.iter().filter(|row| row.is_best).filter_map(point);
        let rings = best.map(|point| Circle::new(point, 8, BLACK.stroke_width(1)));
        chart.draw_series(rings)?;
    }
    area.present()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::around;

    #[test]
    fn marks_enclose_the_points() {
        assert_eq!(around(3.0, 40.0), [2.0, 5.0, 10.0, 20.0, 50.0]);
        assert_eq!(around(10.0, 10.0), [5.0, 10.0, 20.0]);
    }
}
