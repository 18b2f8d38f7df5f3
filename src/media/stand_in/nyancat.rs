//! "Nyancat": six pictures, 40 texels apart, of a running cat. It is another one than the site's: a ginger tabby in a
//! striped jersey, of the same size and in the same places.

/// How far one picture is from the next.
const STEP: usize = 40;

/// Pictures in the row; what is right of them is empty.
const FRAMES: usize = 6;

const NOTHING: [u8; 4] = [255, 255, 255, 0];

/// Everything has an outline of one texel in this colour, which the parts leave room for.
const OUTLINE: [u8; 4] = [0, 0, 0, 255];

/// What each letter of the drawings is.
fn colour(letter: u8) -> [u8; 4] {
    match letter {
        b'f' => [232, 150, 70, 255],
        b't' => [180, 96, 40, 255],
        b'k' => OUTLINE,
        b'w' => [255, 255, 255, 255],
        b'r' => [250, 190, 150, 255],
        b'c' => [240, 240, 220, 255],
        b'i' => [70, 150, 200, 255],
        _ => NOTHING,
    }
}

/// The head, without its outline.
const HEAD: [&str; 10] = [
    "  f        f  ",
    " fff      fff ",
    " ffftfttftfff ",
    "fffftfttftffff",
    "fffffffffffftf",
    "tffkkffffkkfft",
    "fffkkffffkkfff",
    "tffffrkkrfffft",
    " fffrrkkrrfff ",
    "   frrrrrrf   ",
];

/// The tail's height over the body's lower side, from its root outward, in each picture.
const TAIL: [[usize; 6]; FRAMES] = [
    [5, 6, 7, 8, 9, 9],
    [5, 5, 6, 7, 7, 8],
    [5, 5, 5, 4, 4, 4],
    [5, 4, 4, 3, 2, 2],
    [5, 5, 6, 6, 7, 7],
    [5, 6, 6, 7, 8, 8],
];

/// How far the paws are moved forward, and the head down, in each picture.
const PAWS: [usize; FRAMES] = [0, 1, 2, 2, 1, 0];
const NOD: [usize; FRAMES] = [0, 0, 1, 1, 1, 0];

/// The whole row.
pub fn rgba([width, height]: [usize; 2]) -> Vec<u8> {
    let mut row = vec![NOTHING; width * height];
    for frame in 0..FRAMES {
        let picture = picture(frame);
        for (y, line) in picture.iter().enumerate().take(height) {
            for (x, &texel) in line.iter().enumerate() {
                if frame * STEP + x < width {
                    row[y * width + frame * STEP + x] = texel;
                }
            }
        }
    }
    row.into_iter().flatten().collect()
}

type Picture = [[[u8; 4]; STEP]; 32];

fn picture(frame: usize) -> Picture {
    let mut picture = [[NOTHING; STEP]; 32];
    let mut tail = [[b' '; 6]; 9];
    for (out, &up) in TAIL[frame].iter().enumerate() {
        let fur = if out % 2 == 0 { b'f' } else { b't' };
        tail[9 - up][5 - out] = fur;
        tail[10 - up][5 - out] = fur;
    }
    part(&mut picture, [4, 11], &tail);
    for paw in [8, 14, 24, 29] {
        part(&mut picture, [paw + PAWS[frame], 22], &["fff"; 2]);
    }
    body(&mut picture, [10, 8]);
    part(&mut picture, [20, 11 + NOD[frame]], &HEAD);
    picture
}

/// The body in its jersey: stripes across a long rounded shape.
fn body(picture: &mut Picture, at: [usize; 2]) {
    let (width, height) = (20, 13);
    let lines: Vec<String> = (0..height)
        .map(|y| {
            let letter = |x: usize| {
                let from_side = x.min(width - 1 - x);
                let from_end = y.min(height - 1 - y);
                match (from_side, from_end) {
                    (side, end) if side + end < 3 => ' ',
                    _ if x < 3 => 'f',
                    _ if x % 4 < 2 => 'c',
                    _ => 'i',
                }
            };
            (0..width).map(letter).collect()
        })
        .collect();
    part(picture, at, &lines);
}

/// Draws a part over the others, with its outline.
fn part(picture: &mut Picture, [left, top]: [usize; 2], lines: &[impl AsRef<[u8]>]) {
    let filled = || {
        lines.iter().enumerate().flat_map(move |(y, line)| {
            let letters = line
                .as_ref()
                .iter()
                .copied()
                .enumerate()
                .filter(|&(_, letter)| letter != b' ');
            letters.map(move |(x, letter)| (left + x, top + y, letter))
        })
    };
    for (x, y, _) in filled() {
        picture[y - 1][x] = OUTLINE;
        picture[y + 1][x] = OUTLINE;
        picture[y][x - 1] = OUTLINE;
        picture[y][x + 1] = OUTLINE;
    }
    for (x, y, letter) in filled() {
        picture[y][x] = colour(letter);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_cats_move_and_the_rest_is_empty() {
        let row = rgba([256, 32]);
        let column = |x: usize| (0..32).filter(|y| row[4 * (y * 256 + x) + 3] > 0).count();
        assert!((0..6).all(|frame| column(frame * 40 + 20) > 12));
        assert!((240..256).all(|x| column(x) == 0));
        assert!((0..6).all(|frame| column(frame * 40) == 0));
        assert_ne!(picture(0), picture(3));
    }
}
