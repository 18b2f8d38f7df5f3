//! Bayer's matrix for ordered dither.

/// Width and height of the matrix.
pub const SIZE: usize = 8;

/// The 64 thresholds, row by row: four times their rank. 0 is in the corner, and the one half as great right of it.
pub fn bytes() -> Vec<u8> {
    (0..SIZE * SIZE)
        .map(|at| 4 * rank(at % SIZE, at / SIZE))
        .collect()
}

/// The bits of x ^ y and y take turns, those of the greatest weight in the result from the lowest of the place.
fn rank(x: usize, y: usize) -> u8 {
    (0..3).fold(0, |rank, bit| {
        let diagonal = (x ^ y) >> bit & 1;
        let row = y >> bit & 1;
        rank << 2 | (diagonal << 1 | row) as u8
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn it_is_the_usual_matrix() {
        let ranks: Vec<u8> = super::bytes().iter().map(|byte| byte / 4).collect();
        assert_eq!(ranks[..8], [0, 32, 8, 40, 2, 34, 10, 42]);
        assert_eq!(ranks[8..16], [48, 16, 56, 24, 50, 18, 58, 26]);
        assert_eq!(ranks[16..24], [12, 44, 4, 36, 14, 46, 6, 38]);
        assert_eq!(ranks[56..], [63, 31, 55, 23, 61, 29, 53, 21]);
        let mut all = ranks;
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..64));
    }
}
