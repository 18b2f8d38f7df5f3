use super::*;
use crate::media::site::ITEMS;

#[test]
fn everything_but_films_and_music_has_a_stand_in() {
    for item in ITEMS {
        match item.kind {
            // The small ones whole, and of the others a reduced one: those take long without optimisation.
            Kind::Texture { size, .. } if size[0] * size[1] <= 256 * 256 => {
                assert!(make(item).is_some(), "{}", item.name);
            }
            Kind::Texture { format, .. } => {
                let made = bytes(item.name, [32, 32, 1]).unwrap();
                assert_eq!(made.len(), 32 * 32 * format.bytes(), "{}", item.name);
            }
            Kind::Cubemap { .. } => {
                let made = bytes(item.name, [4, 4, 6]).unwrap();
                assert_eq!(made.len(), 4 * 4 * 6 * 4, "{}", item.name);
            }
            Kind::Volume { size, format } => {
                let made = make(item).unwrap();
                assert_eq!((made.size, made.format), ([size; 3], format));
            }
            Kind::Video | Kind::Music => assert_eq!(make(item), None),
        }
    }
}

#[test]
fn things_that_repeat_do_so_without_a_seam() {
    let tiling = [
        "Abstract 1",
        "Abstract 2",
        "Abstract 3",
        "Lichen",
        "Organic 1",
        "Organic 2",
        "Organic 3",
        "Organic 4",
        "Pebbles",
        "Rock Tiles",
        "Rusty Metal",
        "Stars",
        "Wood",
    ];
    let n = 64;
    for name in tiling {
        let made = bytes(name, [n, n, 1]).unwrap();
        let step = made.len() / (n * n);
        // How much neighbours differ on the mean, from one column to the next and from one row to the next.
        let columns = |from: usize, to: usize| {
            let differs =
                |y: usize| made[(y * n + from) * step].abs_diff(made[(y * n + to) * step]);
            (0..n).map(|y| f32::from(differs(y))).sum::<f32>() / n as f32
        };
        let rows = |from: usize, to: usize| {
            let differs =
                |x: usize| made[(from * n + x) * step].abs_diff(made[(to * n + x) * step]);
            (0..n).map(|x| f32::from(differs(x))).sum::<f32>() / n as f32
        };
        let most = |inner: &dyn Fn(usize) -> f32| (0..n - 1).map(inner).fold(0.0, f32::max);
        let (across, down) = (columns(n - 1, 0), rows(n - 1, 0));
        assert!(
            across <= 1.2 * most(&|x| columns(x, x + 1)),
            "{name}: {across} across"
        );
        assert!(
            down <= 1.2 * most(&|y| rows(y, y + 1)),
            "{name}: {down} down"
        );
    }
}

#[test]
fn the_same_comes_out_each_time_and_everywhere() {
    // The mean byte, weighted by its place: robust against a last bit, not against another picture.
    let weighted = |name: &str| {
        let made = bytes(name, [48, 48, 1]).unwrap();
        let sum: f64 = (0_u32..)
            .zip(&made)
            .map(|(at, &byte)| f64::from(byte) * f64::from(at % 251))
            .sum();
        sum / made.len() as f64
    };
    let found: Vec<(&str, f64)> = EXPECTED
        .iter()
        .map(|(name, _)| (*name, weighted(name)))
        .collect();
    let is_near = |(one, other): (&(&str, f64), &(&str, f64))| (one.1 - other.1).abs() < 3.0;
    assert!(found.iter().zip(EXPECTED).all(is_near), "{found:.1?}");
}

const EXPECTED: &[(&str, f64)] = &[
    ("Abstract 1", 13758.4),
    ("Abstract 2", 17345.5),
    ("Abstract 3", 18945.7),
    ("Blue Noise", 15944.2),
    ("Gray Noise Small", 15297.5),
    ("Lichen", 15526.0),
    ("London", 20465.2),
    ("Nyancat", 22679.5),
    ("Organic 1", 18882.3),
    ("Organic 2", 14900.6),
    ("Organic 3", 18410.3),
    ("Organic 4", 19405.0),
    ("Pebbles", 11645.1),
    ("Rock Tiles", 20257.4),
    ("Rusty Metal", 19174.2),
    ("Stars", 14087.1),
    ("Wood", 16293.3),
];
