use glam::UVec2;

/// What the title bar tells.
pub(super) struct Title<'a> {
    pub name: &'a str,
    pub fps: f32,
    pub time: f32,
    pub resolution: UVec2,
    pub paused: bool,
    /// The first line of what is wrong with the scene's latest state.
    pub problem: Option<&'a str>,
}

impl Title<'_> {
    pub fn text(&self) -> String {
        let UVec2 { x, y } = self.resolution;
        let rate = match self.paused {
            true => "paused".to_owned(),
            false => format!("{:.1} fps", self.fps),
        };
        let facts = format!("{} — {rate} — {:.2} s — {x}×{y}", self.name, self.time);
        match self.problem {
            Some(problem) => format!("ERROR {problem} — {facts}"),
            None => facts,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_comes_first() {
        let mut title = Title {
            name: "Sea",
            fps: 59.94,
            time: 12.345,
            resolution: UVec2::new(640, 360),
            paused: false,
            problem: None,
        };
        assert_eq!(title.text(), "Sea — 59.9 fps — 12.35 s — 640×360");
        title.paused = true;
        title.problem = Some("a.glsl:3: no");
        assert_eq!(
            title.text(),
            "ERROR a.glsl:3: no — Sea — paused — 12.35 s — 640×360"
        );
    }
}
