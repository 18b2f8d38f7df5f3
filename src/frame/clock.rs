use std::str::FromStr;
use std::time::{Duration, Instant};

use glam::{UVec2, Vec4};
use jiff::civil::DateTime;

use super::{FrameInput, Keyboard};

/// The step that ShaderToy reports where there is no real one: the first frame after a start, reset
/// or resume, and every frame that is redrawn while paused.
const NOMINAL_STEP: f64 = 1.0 / 60.0;

/// How often `iFrameRate` is renewed.
const RATE_PERIOD: Duration = Duration::from_millis(500);

/// A calendar date and time of day without a time zone, as `iDate` gives it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Date(DateTime);

impl Date {
    /// The local date and time, to the millisecond.
    pub fn now() -> Self {
        Date(jiff::Zoned::now().datetime())
    }

    /// The date in an export, so that the same command gives the same picture on any day: noon of
    /// 1 January 2024. It stands still, since frames may be drawn at any pace.
    pub fn exported() -> Self {
        Date(jiff::civil::date(2024, 1, 1).at(12, 0, 0, 0))
    }

    /// The date and time this much later.
    fn after(self, time: Duration) -> Self {
        let time = jiff::SignedDuration::try_from(time).unwrap_or(jiff::SignedDuration::MAX);
        Date(self.0.saturating_add(time))
    }

    /// `iDate`: year, month counted from 0, day counted from 1, seconds since midnight.
    pub fn to_vec4(self) -> Vec4 {
        let midnight = self.0.date().to_datetime(jiff::civil::Time::midnight());
        let seconds = self.0.duration_since(midnight).as_millis() as f64 / 1000.0;
        Vec4::new(
            f32::from(self.0.year()),
            f32::from(self.0.month() - 1),
            f32::from(self.0.day()),
            seconds as f32,
        )
    }
}

impl Default for Date {
    /// The date in an export.
    fn default() -> Self {
        Date::exported()
    }
}

impl FromStr for Date {
    type Err = String;

    /// Reads `2026-11-25T12:00:00`, as `iDate` is to show it, or a moment with `Z` or an offset, which is shown in
    /// the system's own time zone.
    fn from_str(text: &str) -> Result<Self, String> {
        if let Ok(moment) = text.parse::<jiff::Timestamp>() {
            let zone = jiff::tz::TimeZone::system();
            return Ok(Date(moment.to_zoned(zone).datetime()));
        }
        let date = text.parse::<DateTime>();
        date.map(Date)
            .map_err(|_| "write it as 2026-11-25T12:00:00, or 2026-11-25 alone".to_owned())
    }
}

/// The clock of an export: what a frame sees depends on its number alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FixedClock {
    fps: f64,
    date: Date,
}

impl FixedClock {
    /// The same clock with another date, which stands still as well.
    pub fn on(self, date: Date) -> Self {
        FixedClock { date, ..self }
    }

    /// The input of frame `frame`: `iTime` = frame / fps, `iTimeDelta` = 1 / fps, `iFrame` = frame.
    pub fn at(&self, frame: u32, resolution: UVec2) -> FrameInput {
        self.input(f64::from(frame) / self.fps, frame, resolution)
    }

    /// The input of a single picture at `time` seconds; `iFrame` is the frame nearest to it.
    pub fn at_time(&self, time: f64, resolution: UVec2) -> FrameInput {
        let frame = (time * self.fps).round().clamp(0.0, f64::from(i32::MAX)) as u32;
        self.input(time, frame, resolution)
    }

    fn input(&self, time: f64, frame: u32, resolution: UVec2) -> FrameInput {
        FrameInput {
            time: time as f32,
            time_delta: (1.0 / self.fps) as f32,
            frame_rate: self.fps as f32,
            frame: i32::try_from(frame).unwrap_or(i32::MAX),
            resolution,
            mouse: Vec4::ZERO,
            keyboard: Keyboard::default(),
            date: self.date.to_vec4(),
        }
    }
}

/// The clock of a window: follows real time, can be paused, stepped and reset.
///
/// Rules from shadertoy.com: time stands still while paused, a paused redraw still counts a frame,
/// and the step is 1/60 s wherever no real step exists.
#[derive(Clone, Debug)]
pub struct Clock {
    time: f64,
    next_frame: i32,
    paused: bool,
    /// When the last frame was drawn; `None` until one was drawn since the start, reset or resume.
    last: Option<Instant>,
    rate: f64,
    rate_since: Option<Instant>,
    rate_frames: u32,
    /// The date that the first frame has, where it is not today's.
    first_date: Option<Date>,
    /// When the first frame was drawn.
    first: Option<Instant>,
}

impl Default for Clock {
    fn default() -> Self {
        Clock {
            time: 0.0,
            next_frame: 0,
            paused: false,
            last: None,
            rate: 60.0,
            rate_since: None,
            rate_frames: 0,
            first_date: None,
            first: None,
        }
    }
}

impl Clock {
    /// A clock whose first frame has this date; from there it runs on, also while time is paused, as the
    /// real one does. A reset goes back to it.
    pub fn from_date(date: Date) -> Self {
        Clock {
            first_date: Some(date),
            ..Clock::default()
        }
    }

    /// A clock with a fixed step of 1 / `fps` seconds; `fps` is positive and finite.
    pub fn fixed(fps: f64) -> FixedClock {
        FixedClock {
            fps,
            date: Date::exported(),
        }
    }

    /// The input of the next frame, drawn now. The mouse is left at rest for the caller to fill in.
    pub fn tick(&mut self, resolution: UVec2) -> FrameInput {
        self.tick_at(Instant::now(), Date::now(), resolution)
    }

    fn tick_at(&mut self, now: Instant, date: Date, resolution: UVec2) -> FrameInput {
        let delta = match self.last {
            Some(last) if !self.paused => {
                let delta = now.saturating_duration_since(last).as_secs_f64();
                self.time += delta;
                delta
            }
            _ => NOMINAL_STEP,
        };
        if !self.paused {
            self.last = Some(now);
            self.measure_rate(now);
        }
        let first = *self.first.get_or_insert(now);
        let date = match self.first_date {
            Some(first_date) => first_date.after(now.saturating_duration_since(first)),
            None => date,
        };
        let frame = self.next_frame;
        self.next_frame = frame.saturating_add(1);
        FrameInput {
            time: self.time as f32,
            time_delta: delta as f32,
            frame_rate: self.rate as f32,
            frame,
            resolution,
            mouse: Vec4::ZERO,
            keyboard: Keyboard::default(),
            date: date.to_vec4(),
        }
    }

    fn measure_rate(&mut self, now: Instant) {
        let since = *self.rate_since.get_or_insert(now);
        let elapsed = now.saturating_duration_since(since);
        if elapsed >= RATE_PERIOD {
            self.rate = f64::from(self.rate_frames) / elapsed.as_secs_f64();
            self.rate_since = Some(now);
            self.rate_frames = 0;
        }
        self.rate_frames += 1;
    }

    /// Whether time stands still.
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// Stops time, or lets it go on from where it stopped.
    pub fn set_paused(&mut self, paused: bool) {
        self.paused = paused;
        self.forget_real_time();
    }

    /// Pauses and moves by whole frames of 1/60 s, never before the first.
    pub fn step(&mut self, frames: i32) {
        self.set_paused(true);
        self.time = (self.time + f64::from(frames) * NOMINAL_STEP).max(0.0);
        self.next_frame = self.next_frame.saturating_add(frames - 1).max(0);
    }

    /// Back to time 0 and frame 0; a paused clock stays paused.
    pub fn reset(&mut self) {
        *self = Clock {
            paused: self.paused,
            first_date: self.first_date,
            ..Clock::default()
        };
    }

    fn forget_real_time(&mut self) {
        self.last = None;
        self.rate_since = None;
        self.rate_frames = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: UVec2 = UVec2::new(4, 3);

    struct Live {
        clock: Clock,
        now: Instant,
    }

    impl Live {
        fn new() -> Self {
            Live {
                clock: Clock::default(),
                now: Instant::now(),
            }
        }

        fn after(&mut self, seconds: f64) -> FrameInput {
            self.now += Duration::from_secs_f64(seconds);
            self.clock.tick_at(self.now, Date::exported(), SIZE)
        }
    }

    #[test]
    fn a_fixed_clock_knows_only_the_frame_number() {
        let input = Clock::fixed(25.0).at(50, SIZE);
        assert_eq!((input.time, input.time_delta, input.frame), (2.0, 0.04, 50));
        assert_eq!(input.frame_rate, 25.0);
        assert_eq!(input.date.to_array(), [2024.0, 0.0, 1.0, 43_200.0]);
    }

    #[test]
    fn a_single_time_has_the_nearest_frame_number() {
        let input = Clock::fixed(60.0).at_time(1.01, SIZE);
        assert_eq!((input.time, input.frame), (1.01, 61));
    }

    #[test]
    fn time_starts_at_zero_with_the_nominal_step() {
        let mut live = Live::new();
        let first = live.after(5.0);
        assert_eq!((first.time, first.frame), (0.0, 0));
        assert_eq!(first.time_delta, (1.0 / 60.0) as f32);
        let second = live.after(0.5);
        assert_eq!(
            (second.time, second.time_delta, second.frame),
            (0.5, 0.5, 1)
        );
    }

    #[test]
    fn a_pause_takes_no_time_but_redraws_count_frames() {
        let mut live = Live::new();
        live.after(0.0);
        live.after(1.0);
        live.clock.set_paused(true);
        let redraw = live.after(9.0);
        assert_eq!((redraw.time, redraw.frame), (1.0, 2));
        assert_eq!(redraw.time_delta, (1.0 / 60.0) as f32);
        live.clock.set_paused(false);
        let resumed = live.after(9.0);
        assert_eq!((resumed.time, resumed.frame), (1.0, 3));
        assert_eq!(live.after(0.25).time, 1.25);
    }

    #[test]
    fn steps_move_one_frame_each_way_and_stop_at_the_start() {
        let mut live = Live::new();
        live.after(0.0);
        live.clock.step(1);
        let forward = live.after(3.0);
        assert_eq!((forward.time, forward.frame), ((1.0 / 60.0) as f32, 1));
        live.clock.step(-1);
        let back = live.after(3.0);
        assert_eq!((back.time, back.frame), (0.0, 0));
        live.clock.step(-1);
        let start = live.after(3.0);
        assert_eq!((start.time, start.frame), (0.0, 0));
    }

    #[test]
    fn reset_begins_again_and_keeps_the_pause() {
        let mut live = Live::new();
        live.after(0.0);
        live.after(2.0);
        live.clock.set_paused(true);
        live.clock.reset();
        assert!(live.clock.is_paused());
        let input = live.after(2.0);
        assert_eq!((input.time, input.frame), (0.0, 0));
    }

    #[test]
    fn the_frame_rate_is_a_mean_over_half_a_second() {
        let mut live = Live::new();
        assert_eq!(live.after(0.0).frame_rate, 60.0);
        let mut rate = 60.0;
        for _ in 0..51 {
            rate = live.after(0.01).frame_rate;
        }
        assert!((rate - 100.0).abs() < 3.0, "{rate}");
    }

    #[test]
    fn dates_are_read_as_they_are_shown() {
        let shown = |text: &str| text.parse::<Date>().map(|date| date.to_vec4().to_array());
        assert_eq!(
            shown("2026-11-25T12:00:01.5"),
            Ok([2026.0, 10.0, 25.0, 43_201.5])
        );
        assert_eq!(shown("2026-11-25 00:00"), shown("2026-11-25"));
        assert!(shown("2026-11-25T12:00:00Z").is_ok());
        assert!(shown("2026-11-25T12:00:00+01:00").is_ok());
        for bad in [
            "",
            "today",
            "2026-13-01",
            "2026-11-25T25:00:00",
            "99999-01-01",
        ] {
            assert!(shown(bad).is_err(), "{bad}");
        }
        let last = "9999-12-31T23:59:59".parse::<Date>().expect("a date");
        assert_eq!(last.after(Duration::MAX).to_vec4().x, 9999.0);
    }

    #[test]
    fn a_given_date_runs_on_from_the_first_frame() {
        let mut live = Live::new();
        live.clock = Clock::from_date("2026-11-25T23:59:59".parse().expect("a date"));
        assert_eq!(
            live.after(7.0).date.to_array(),
            [2026.0, 10.0, 25.0, 86_399.0]
        );
        live.clock.set_paused(true);
        assert_eq!(live.after(2.0).date.to_array(), [2026.0, 10.0, 26.0, 1.0]);
        live.clock.reset();
        assert_eq!(live.after(3.0).date.w, 86_399.0);
        let still = Clock::fixed(1.0).on("2026-11-25".parse().expect("a date"));
        assert_eq!(still.at(9, SIZE).date.to_array(), [2026.0, 10.0, 25.0, 0.0]);
    }
}
