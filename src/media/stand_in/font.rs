//! "Font 1": 16 × 16 letters as signed distances, of the free font Hack.
//!
//! A letter's advance is half a cell, and its box stands in the cell's middle. Red says how much of a texel the letter
//! covers. Green and blue say where the distance grows, right and down, and alpha is the distance itself: 1 for each
//! cell's width, 127 on the outline and more outside.

use epaint_default_fonts::HACK_REGULAR;
use ttf_parser::{Face, OutlineBuilder};

use super::painting::each_texel;
use super::shape::{Outline, Point, Shape, to_nearest};
use super::symbols;

/// Cells in a row, and rows.
const CELLS: usize = 16;

/// The width and height of a cell in which [`GLYPH_WIDTH`] and the others are measured.
pub const CELL: f32 = 64.0;

/// How wide a letter's box is: from 16 to 48.
const GLYPH_WIDTH: f32 = 32.0;

/// How high an H is. Hack is a little higher by itself than the site's font.
const CAPITAL_HEIGHT: f32 = 37.0;

/// Hack's strokes are thinner than those of the site's font by twice this.
const WEIGHT: f32 = 0.4;

/// Where letters stand, from the cell's top.
const BASELINE: f32 = 50.0;

/// Greek and mathematics: rows 8 and 9. The rows before are ASCII, those behind Latin-1.
const ROWS_8_AND_9: &str = "αβγδεθλμξπρστφψωΓΔΘΛΠΣΦΨΩ∞ƒ∘∫∂∇√";

/// The whole picture, so many texels wide.
pub fn rgba(size: usize) -> Vec<u8> {
    let face = Face::parse(HACK_REGULAR, 0).expect("the font is whole");
    let glyphs: Vec<Vec<Shape>> = (0..CELLS * CELLS)
        .map(|code| symbols::shapes(code).unwrap_or_else(|| letter(&face, code)))
        .collect();
    let cell = size / CELLS;
    let step = CELL / cell as f32;
    // Distances reach one texel beyond each cell, for the differences at its edge.
    let wide = cell + 2;
    let distances = each_texel([CELLS * wide, CELLS * wide], |x, y| {
        let shapes = &glyphs[y / wide * CELLS + x / wide];
        to_nearest(
            shapes,
            [x % wide, y % wide].map(|at| (at as f32 - 0.5) * step),
        )
    });
    let texels = each_texel([size, size], |x, y| {
        let [x, y] = [x, y].map(|at| at / cell * wide + at % cell + 1);
        let at = |x: usize, y: usize| distances[y * CELLS * wide + x];
        let right = (at(x + 1, y) - at(x - 1, y)) / (2.0 * step);
        let down = (at(x, y + 1) - at(x, y - 1)) / (2.0 * step);
        texel(at(x, y), [right, down])
    });
    texels.into_iter().flatten().collect()
}

/// A texel so far from the outline, where the distance grows so fast to the right and down.
fn texel(distance: f32, [right, down]: [f32; 2]) -> [u8; 4] {
    if distance == f32::MAX {
        return [0, 128, 128, 255];
    }
    let byte = |value: f32| value.clamp(0.0, 255.0).round() as u8;
    [
        byte(255.0 * (0.5 - distance)),
        byte(127.5 + 127.0 * right),
        byte(127.5 + 127.0 * down),
        byte(127.0 + 255.0 / CELL * distance),
    ]
}

/// The character of a cell, if it is one of a font's.
fn character(code: usize) -> Option<char> {
    match code {
        0x20..=0x7e | 0xa1..=0xac | 0xae..=0xff => char::from_u32(code as u32),
        0x80..=0x9f => ROWS_8_AND_9.chars().nth(code - 0x80),
        _ => None,
    }
}

/// The outline of a character, or nothing of a space.
fn letter(face: &Face, code: usize) -> Vec<Shape> {
    let Some(glyph) = character(code).and_then(|c| face.glyph_index(c)) else {
        return Vec::new();
    };
    let advance = face.glyph_hor_advance(glyph).map_or(1233.0, f32::from);
    let capital = face.capital_height().map_or(1493.0, f32::from);
    let mut pen = Pen {
        scale: [GLYPH_WIDTH / advance, CAPITAL_HEIGHT / capital],
        at: [0.0; 2],
        begin: [0.0; 2],
        outline: Outline {
            lines: Vec::new(),
            grown: WEIGHT,
        },
    };
    face.outline_glyph(glyph, &mut pen);
    if pen.outline.lines.is_empty() {
        return Vec::new();
    }
    vec![Shape::Polygon(pen.outline)]
}

/// Turns a glyph's curves into lines in a cell.
struct Pen {
    scale: [f32; 2],
    at: Point,
    begin: Point,
    outline: Outline,
}

/// Lines for one curve: the error stays below a hundredth of a texel.
const LINES: usize = 8;

impl Pen {
    fn placed(&self, x: f32, y: f32) -> Point {
        [
            (CELL - GLYPH_WIDTH) / 2.0 + x * self.scale[0],
            BASELINE - y * self.scale[1],
        ]
    }

    fn line(&mut self, to: Point) {
        if to != self.at {
            self.outline.lines.push([self.at, to]);
            self.at = to;
        }
    }

    /// A Bézier curve through de Casteljau's points: those between the ends are its handles.
    fn curve<const N: usize>(&mut self, handles: [Point; N]) {
        for part in 1..=LINES {
            let share = part as f32 / LINES as f32;
            let mut points = handles;
            for degree in (1..N).rev() {
                for i in 0..degree {
                    points[i] =
                        [0, 1].map(|c| points[i][c] + share * (points[i + 1][c] - points[i][c]));
                }
            }
            self.line(points[0]);
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.at = self.placed(x, y);
        self.begin = self.at;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.line(self.placed(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.curve([self.at, self.placed(x1, y1), self.placed(x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let [first, second] = [self.placed(x1, y1), self.placed(x2, y2)];
        self.curve([self.at, first, second, self.placed(x, y)]);
    }

    fn close(&mut self) {
        self.line(self.begin);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_every_letter_but_the_four_empty_cells() {
        let face = Face::parse(HACK_REGULAR, 0).unwrap();
        let empty: Vec<usize> = (0x20..0x100)
            .filter(|&code| letter(&face, code).is_empty())
            .collect();
        assert_eq!(empty, [0x20, 0x7f, 0xa0, 0xad]);
    }

    #[test]
    fn an_h_stands_where_the_site_has_it() {
        let face = Face::parse(HACK_REGULAR, 0).unwrap();
        let shapes = letter(&face, usize::from(b'H'));
        let is_in = |x: f32, y: f32| to_nearest(&shapes, [x, y]) < 0.0;
        let inside: Vec<f32> = (0..64)
            .map(|y| y as f32 + 0.5)
            .filter(|&y| is_in(22.5, y))
            .collect();
        assert_eq!((inside[0], inside[inside.len() - 1]), (13.5, 49.5));
        assert!(is_in(22.5, 20.0) && is_in(41.5, 20.0) && !is_in(32.0, 20.0));
        assert!(is_in(32.0, 31.0) && !is_in(32.0, 49.0));
    }

    #[test]
    fn the_channels_say_coverage_direction_and_distance() {
        assert_eq!(texel(8.0, [-1.0, 0.0]), [0, 1, 128, 159]);
        assert_eq!(texel(-4.0, [-1.0, 0.0]), [255, 1, 128, 111]);
        assert_eq!(texel(0.0, [0.0, 1.0]), [128, 128, 255, 127]);
        assert_eq!(
            texel(to_nearest(&[], [32.0, 32.0]), [0.0; 2]),
            [0, 128, 128, 255]
        );
    }
}
