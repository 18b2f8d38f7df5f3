use std::ops::Range;
use std::path::PathBuf;

/// Where frames are written: a path with a place for the frame number, as in `frames/%05d.png`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutPattern {
    before: String,
    number: Option<usize>,
    after: String,
}

/// Why a text is no pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PatternError {
    /// Nothing to write to.
    #[error("the output path is empty")]
    Empty,
    /// A `%` that is neither `%d`, `%05d` nor `%%`.
    #[error("`%` must be followed by `d`, as in `%d` or `%05d`; a plain percent sign is `%%`")]
    Percent,
    /// More than one place for the number.
    #[error("the frame number can stand in one place only")]
    TwoNumbers,
    /// More digits than any number has.
    #[error("frame numbers have at most 20 digits")]
    Width,
    /// Pictures are written as PNG or EXR.
    #[error("the output path must end in `.png` or `.exr`")]
    Format,
}

impl OutPattern {
    /// Reads a pattern: `%d` or `%0Nd` stands for the frame number, `%%` for a percent sign.
    pub fn parse(text: &str) -> Result<Self, PatternError> {
        if text.is_empty() {
            return Err(PatternError::Empty);
        }
        let mut pattern = OutPattern {
            before: String::new(),
            number: None,
            after: String::new(),
        };
        let mut rest = text;
        while let Some((plain, behind)) = rest.split_once('%') {
            pattern.tail().push_str(plain);
            if let Some(behind) = behind.strip_prefix('%') {
                pattern.tail().push('%');
                rest = behind;
                continue;
            }
            let (digits, behind) = behind.split_once('d').ok_or(PatternError::Percent)?;
            if !digits.bytes().all(|b| b.is_ascii_digit()) {
                return Err(PatternError::Percent);
            }
            if pattern.number.is_some() {
                return Err(PatternError::TwoNumbers);
            }
            let width = match digits {
                "" => 0,
                digits => digits.parse().map_err(|_| PatternError::Width)?,
            };
            if width > 20 {
                return Err(PatternError::Width);
            }
            pattern.number = Some(width);
            rest = behind;
        }
        pattern.tail().push_str(rest);
        let ending = text.to_ascii_lowercase();
        if !ending.ends_with(".png") && !ending.ends_with(".exr") {
            return Err(PatternError::Format);
        }
        Ok(pattern)
    }

    /// Whether the files are EXR, which hold floats and named channels.
    pub fn is_exr(&self) -> bool {
        let end = match self.number {
            None => &self.before,
            Some(_) => &self.after,
        };
        end.to_ascii_lowercase().ends_with(".exr")
    }

    fn tail(&mut self) -> &mut String {
        match self.number {
            None => &mut self.before,
            Some(_) => &mut self.after,
        }
    }

    /// Whether different frames get different paths.
    pub fn is_numbered(&self) -> bool {
        self.number.is_some()
    }

    /// Which of these frames have a file already, in ascending order. Looks at the files that there
    /// are, not at every frame: a range may have billions.
    pub fn existing(&self, frames: Range<u32>) -> Vec<u32> {
        // The folder whose entries carry the number, and what surrounds it in their names.
        let is_separator = |c: char| std::path::is_separator(c);
        let (folder, prefix) = match self.before.rfind(is_separator) {
            Some(at) => self.before.split_at(at + 1),
            None => (".", self.before.as_str()),
        };
        let suffix = self.after.split(is_separator).next().unwrap_or_default();
        let Ok(entries) = std::fs::read_dir(folder) else {
            return Vec::new();
        };
        let mut existing: Vec<u32> = entries
            .filter_map(|entry| {
                let name = entry.ok()?.file_name().into_string().ok()?;
                let digits = name.strip_prefix(prefix)?.strip_suffix(suffix)?;
                let frame = digits.parse().ok()?;
                (frames.contains(&frame) && self.path(frame).exists()).then_some(frame)
            })
            .collect();
        existing.sort_unstable();
        existing.dedup();
        existing
    }

    /// The path of one frame.
    pub fn path(&self, frame: u32) -> PathBuf {
        let OutPattern {
            before,
            number,
            after,
        } = self;
        match number {
            None => before.into(),
            Some(width) => format!("{before}{frame:0width$}{after}").into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(pattern: &str, frame: u32) -> String {
        let pattern = OutPattern::parse(pattern).expect("a pattern");
        pattern.path(frame).display().to_string()
    }

    #[test]
    fn the_number_stands_where_it_is_asked_for() {
        assert_eq!(path("a/%05d.png", 42), "a/00042.png");
        assert_eq!(path("a%d_b.PNG", 7), "a7_b.PNG");
        assert_eq!(path("%3d.png", 12345), "12345.png");
        assert_eq!(path("100%%.png", 1), "100%.png");
        assert_eq!(path("%%d%d%%.png", 1), "%d1%.png");
    }

    #[test]
    fn existing_frames_are_found_by_their_names() {
        let folder = tempfile::tempdir().unwrap();
        let base = folder.path().to_str().unwrap().to_owned();
        for name in [
            "f007.png",
            "f12.png",
            "f0009.png",
            "fx.png",
            "f1000.png",
            "f-01.png",
        ] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let existing = |pattern: &str, range| {
            OutPattern::parse(&format!("{base}/{pattern}"))
                .unwrap()
                .existing(range)
        };
        assert_eq!(existing("f%03d.png", 0..2_000_000_000), [7, 1000]);
        assert_eq!(existing("f%d.png", 0..100), [12]);
        assert!(existing("none/%d.png", 0..100).is_empty());
        std::fs::create_dir(folder.path().join("3")).unwrap();
        assert!(
            existing("%d/a.png", 0..100).is_empty(),
            "a folder is no frame"
        );
        std::fs::write(folder.path().join("3/a.png"), "").unwrap();
        assert_eq!(existing("%d/a.png", 0..100), [3]);
    }

    #[test]
    fn what_is_no_pattern_says_why() {
        for (text, error) in [
            ("", PatternError::Empty),
            ("%s.png", PatternError::Percent),
            ("a%.png", PatternError::Percent),
            ("%-3d.png", PatternError::Percent),
            ("%d%d.png", PatternError::TwoNumbers),
            ("%99999999999999999999d.png", PatternError::Width),
            ("%999d.png", PatternError::Width),
            ("%d.jpg", PatternError::Format),
            ("frames", PatternError::Format),
        ] {
            assert_eq!(OutPattern::parse(text), Err(error), "{text}");
        }
    }

    #[test]
    fn only_numbered_patterns_tell_frames_apart() {
        assert!(OutPattern::parse("%d.png").unwrap().is_numbered());
        assert!(!OutPattern::parse("a%%d.png").unwrap().is_numbered());
    }
}
