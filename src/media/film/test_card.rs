//! Films that are made, for inputs whose film is not there, and for the camera.

use super::super::feed::{Feed, sane};
use super::super::{Format, site};
use super::painter::{Colour, Painter, Point};

/// Pictures a second.
const RATE: f64 = 30.0;
/// Seconds until everything begins again.
const SECONDS: f64 = 10.0;
/// What the figure of a film to be keyed out stands before.
const GREEN: Colour = [0.05, 0.62, 0.16];
const SKIN: Colour = [0.87, 0.66, 0.53];

/// A moving picture that needs no file. It depends on the time alone, in steps of a thirtieth of a second.
pub struct TestCard {
    scene: Scene,
    painter: Painter,
    shown: Option<u64>,
}

impl std::fmt::Debug for TestCard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TestCard")
            .field("scene", &self.scene)
            .finish_non_exhaustive()
    }
}

/// What is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scene {
    /// Somebody dances in coloured light.
    Stage,
    /// Somebody kicks, before a green wall that shaders key out.
    GreenWall,
    /// Coloured balls on white.
    Balls,
    /// A face in an old film without colours.
    OldFilm,
    /// A face before a camera.
    Camera,
}

impl TestCard {
    /// In place of one of the site's films, by its name there; 512 × 396 texels.
    pub fn film(name: &str) -> TestCard {
        let scene = match name {
            "Jean-Claude Van Damme" => Scene::GreenWall,
            "Google Logo" => Scene::Balls,
            "Lustre Creme" => Scene::OldFilm,
            _ => Scene::Stage,
        };
        TestCard::new(scene, [512, 396])
    }

    /// In place of one of the site's films.
    pub fn item(item: &site::Item) -> TestCard {
        TestCard::film(item.name)
    }

    /// In place of the camera; 640 × 360 texels.
    pub fn webcam() -> TestCard {
        TestCard::new(Scene::Camera, [640, 360])
    }

    fn new(scene: Scene, size: [u32; 2]) -> TestCard {
        TestCard {
            scene,
            painter: Painter::new(size),
            shown: None,
        }
    }
}

impl Feed for TestCard {
    fn size(&self) -> [u32; 2] {
        self.painter.size
    }

    fn format(&self) -> Format {
        Format::Rgba8
    }

    fn position(&self, time: f64) -> f64 {
        match self.scene {
            Scene::Camera => 0.0,
            _ => sane(time) % SECONDS,
        }
    }

    fn texels(&mut self, time: f64) -> Option<&[u8]> {
        let step = ((sane(time) % SECONDS) * RATE + 0.01) as u64;
        if self.shown == Some(step) {
            return None;
        }
        self.shown = Some(step);
        let turn = (step as f64 / (RATE * SECONDS)) as f32;
        let painter = &mut self.painter;
        match self.scene {
            Scene::Stage => stage(painter, turn),
            Scene::GreenWall => green_wall(painter, turn),
            Scene::Balls => balls(painter, turn),
            Scene::OldFilm => old_film(painter, turn),
            Scene::Camera => camera(painter, turn),
        }
        Some(&painter.texels)
    }
}

/// So many swings in the film's whole length: from −1 to 1.
fn swing(turn: f32, times: u32, ahead: f32) -> f32 {
    (std::f32::consts::TAU * (turn * times as f32 + ahead)).sin()
}

fn stage(p: &mut Painter, turn: f32) {
    let beat = 1.0 - (turn * 20.0).fract();
    let beams = [
        (0.3, 3, [0.9, 0.2, 0.6]),
        (0.65, 5, [0.2, 0.5, 1.0]),
        (1.0, 4, [1.0, 0.7, 0.2]),
    ];
    let beams = beams.map(|(x, times, colour)| (x, 0.35 * swing(turn, times, x), colour));
    p.fill(|x, y| {
        let floor = if y > 0.82 { 0.18 } else { 0.05 };
        let mut light: Colour = [floor + 0.1 * y, floor, floor + 0.12];
        for (from, slope, colour) in beams {
            let off = (x - from - slope * y).abs() / (0.05 + 0.12 * y);
            let strength = (1.0 - off).max(0.0) * (0.35 + 0.4 * beat);
            for channel in 0..3 {
                light[channel] += strength * colour[channel];
            }
        }
        light
    });
    let sway = 0.06 * swing(turn, 10, 0.0);
    let hip = [0.646 + sway, 0.58];
    let neck = [0.646 - 0.5 * sway, 0.36];
    let arms = [swing(turn, 10, 0.2), swing(turn, 10, 0.55)];
    figure(
        p,
        hip,
        neck,
        arms,
        [swing(turn, 10, 0.0), 0.0],
        [[0.9, 0.15, 0.35], [0.2, 0.2, 0.55]],
    );
}

fn green_wall(p: &mut Painter, turn: f32) {
    // A wall is lit a little more in its middle, and keys must stand that.
    p.fill(|x, y| {
        let light = 1.05 - 0.15 * ((x - 0.65).abs() + (y - 0.5).abs());
        GREEN.map(|channel| channel * light)
    });
    let kick = swing(turn, 5, 0.0).max(0.0);
    let hip = [0.6, 0.57];
    let neck = [0.6 - 0.12 * kick, 0.36 + 0.03 * kick];
    let arms = [swing(turn, 5, 0.1), -swing(turn, 5, 0.3)];
    figure(
        p,
        hip,
        neck,
        arms,
        [0.0, kick],
        [[0.75, 0.72, 0.7], [0.1, 0.1, 0.13]],
    );
}

fn balls(p: &mut Painter, turn: f32) {
    const COLOURS: [Colour; 4] = [
        [0.26, 0.52, 0.96],
        [0.92, 0.26, 0.21],
        [0.98, 0.74, 0.02],
        [0.2, 0.66, 0.33],
    ];
    p.fill(|_, _| [1.0; 3]);
    for ball in 0..6_u8 {
        let ahead = f32::from(ball) / 6.0;
        let x = 0.2 + 0.18 * f32::from(ball) + 0.05 * swing(turn, 3, ahead);
        let y = 0.7 - 0.4 * swing(turn, 5, 0.5 * ahead).abs();
        p.ellipse([x, 0.83], [0.05 + 0.05 * y, 0.012], [0.85; 3]);
        p.ellipse(
            [x, y],
            [0.085; 2],
            COLOURS[[0, 1, 2, 0, 3, 1][usize::from(ball)]],
        );
        p.ellipse([x - 0.03, y - 0.035], [0.018; 2], [1.0; 3]);
    }
}

fn old_film(p: &mut Painter, turn: f32) {
    let flicker = 1.0 + 0.05 * swing(turn, 70, 0.0);
    p.fill(|x, y| {
        let (dx, dy) = (x - 0.646, y - 0.5);
        [flicker * (0.62 - 0.7 * (dx * dx + dy * dy)); 3]
    });
    let grey = |light: f32| [flicker * light; 3];
    let x = 0.646 + 0.03 * swing(turn, 2, 0.0);
    p.ellipse([x, 0.42], [0.27, 0.33], grey(0.16));
    p.ellipse([x, 1.05], [0.4, 0.34], grey(0.8));
    p.capsule([x, 0.5], [x, 0.8], 0.09, grey(0.7));
    face(
        p,
        [x, 0.45 + 0.01 * swing(turn, 3, 0.0)],
        turn,
        [grey(0.8), grey(0.1), grey(0.35)],
    );
    // A scratch that wanders.
    let scratch = 0.2 + 0.9 * (turn * 7.0).fract();
    p.capsule([scratch, 0.0], [scratch + 0.01, 1.0], 0.0015, grey(0.9));
}

fn camera(p: &mut Painter, turn: f32) {
    p.fill(|x, y| {
        // A room with a window.
        let is_window = (1.25..1.6).contains(&x) && (0.1..0.55).contains(&y);
        match is_window {
            true => [0.8, 0.9, 1.0],
            false => [0.42 - 0.12 * y, 0.38 - 0.1 * y, 0.33 - 0.05 * x],
        }
    });
    let x = 0.889 + 0.08 * swing(turn, 2, 0.0) + 0.02 * swing(turn, 5, 0.3);
    let y = 0.45 + 0.02 * swing(turn, 3, 0.0);
    p.ellipse([0.5 * (x + 0.889), 1.1], [0.42, 0.34], [0.2, 0.3, 0.5]);
    p.capsule(
        [x, y + 0.1],
        [0.5 * (x + 0.889), 0.85],
        0.085,
        SKIN.map(|c| 0.85 * c),
    );
    p.ellipse([x, y - 0.06], [0.21, 0.26], [0.2, 0.13, 0.08]);
    face(
        p,
        [x, y],
        turn,
        [SKIN, [0.12, 0.1, 0.1], [0.65, 0.25, 0.25]],
    );
}

/// A face that blinks and talks; the colours are those of skin, eyes and mouth.
fn face(p: &mut Painter, [x, y]: Point, turn: f32, [skin, eyes, mouth]: [Colour; 3]) {
    p.ellipse([x, y], [0.17, 0.23], skin);
    let is_blinking = (turn * 4.0).fract() < 0.06;
    let open = if is_blinking { 0.003 } else { 0.017 };
    for side in [-0.065, 0.065] {
        p.ellipse([x + side, y - 0.04], [0.032, open * 1.2], [0.95; 3]);
        p.ellipse(
            [x + side + 0.01 * swing(turn, 3, 0.1), y - 0.04],
            [0.015, open],
            eyes,
        );
        p.capsule(
            [x + side - 0.03, y - 0.09],
            [x + side + 0.03, y - 0.09],
            0.007,
            eyes,
        );
    }
    p.capsule(
        [x, y - 0.02],
        [x - 0.012, y + 0.045],
        0.012,
        skin.map(|channel| 0.85 * channel),
    );
    let talk = 0.012 + 0.012 * swing(turn, 23, 0.0).abs();
    p.ellipse([x, y + 0.12], [0.055, talk], mouth);
}

/// Somebody of capsules. Arms and the legs' spread go from −1 to 1, the kick from 0 to 1; the colours are those of shirt and
/// trousers.
fn figure(
    p: &mut Painter,
    hip: Point,
    neck: Point,
    arms: [f32; 2],
    legs: [f32; 2],
    [shirt, trousers]: [Colour; 2],
) {
    let [spread, kick] = legs;
    let shoes = trousers.map(|channel| 0.5 * channel);
    for (side, kick) in [(-1.0, 0.0), (1.0, kick)] {
        let knee = [
            hip[0] + side * (0.06 + 0.12 * kick) + 0.03 * spread,
            hip[1] + 0.17 * (1.0 - 0.8 * kick),
        ];
        let foot = [
            knee[0] + side * (0.02 + 0.2 * kick),
            knee[1] + 0.17 * (1.0 - 1.6 * kick),
        ];
        p.capsule([hip[0] + side * 0.03, hip[1]], knee, 0.05, trousers);
        p.capsule(knee, foot, 0.038, trousers);
        p.capsule(foot, [foot[0] + side * 0.04, foot[1] + 0.01], 0.026, shoes);
    }
    p.capsule(hip, neck, 0.085, shirt);
    for (side, lift) in [(-1.0, arms[0]), (1.0, arms[1])] {
        let shoulder = [neck[0] + side * 0.085, neck[1] + 0.02];
        let elbow = [shoulder[0] + side * 0.09, shoulder[1] + 0.07 - 0.1 * lift];
        let hand = [elbow[0] + side * 0.05, elbow[1] - 0.04 - 0.1 * lift];
        p.capsule(shoulder, elbow, 0.036, shirt);
        p.capsule(elbow, hand, 0.03, SKIN);
    }
    let head = [neck[0], neck[1] - 0.15];
    p.capsule(neck, head, 0.035, SKIN);
    p.ellipse(
        [head[0], head[1] - 0.02],
        [0.078, 0.095],
        [0.25, 0.16, 0.08],
    );
    p.ellipse([head[0] + 0.008, head[1]], [0.066, 0.08], SKIN);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<TestCard> {
        let names = [
            "Britney Spears",
            "Jean-Claude Van Damme",
            "Google Logo",
            "Lustre Creme",
        ];
        names
            .map(TestCard::film)
            .into_iter()
            .chain([TestCard::webcam()])
            .collect()
    }

    #[test]
    fn they_move_and_depend_on_the_time_alone() {
        for (mut card, mut other) in all().into_iter().zip(all()) {
            let first = card.texels(0.0).unwrap().to_vec();
            let [width, height] = card.size();
            assert_eq!(first.len(), (4 * width * height) as usize);
            assert!(first.chunks_exact(4).all(|texel| texel[3] == 255));
            let later = card.texels(1.3).unwrap().to_vec();
            assert!(card.texels(1.31).is_none());
            assert_ne!(first, later, "{card:?}");
            assert_eq!(other.texels(11.3).unwrap(), later);
            assert_eq!(other.texels(f64::NAN).unwrap(), first);
        }
    }

    #[test]
    fn the_green_wall_can_be_keyed_out_and_the_figure_cannot() {
        let mut card = TestCard::film("Jean-Claude Van Damme");
        let texels = card.texels(0.5).unwrap();
        let green = texels
            .chunks_exact(4)
            .filter(|t| t[1] > t[0].max(t[2]).saturating_add(60))
            .count();
        let part = green as f64 / (512.0 * 396.0);
        assert!((0.6..0.93).contains(&part), "{part}");
    }

    #[test]
    fn only_films_have_a_position() {
        assert_eq!(TestCard::webcam().position(3.0), 0.0);
        assert!((TestCard::film("").position(13.0) - 3.0).abs() < 1e-9);
    }
}
