use glam::{IVec2, Vec4};

/// ShaderToy's `iMouse` as a state machine (`docs/ARCHITECTURE.md` names the rules).
///
/// Positions are whole pixels from the bottom left of the picture. Before any click all is zero. A
/// press sets position and press point; dragging moves the position; releasing moves nothing. The
/// signs carry the button: z is positive while it is down, w only in the one frame that first sees
/// the press. Hovering does nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mouse {
    position: IVec2,
    pressed_at: IVec2,
    down: bool,
    /// The press has not been seen by any frame yet.
    fresh: bool,
}

impl Mouse {
    /// The button went down.
    pub fn press(&mut self, at: IVec2) {
        *self = Mouse {
            position: at,
            pressed_at: at,
            down: true,
            fresh: true,
        };
    }

    /// The pointer moved, with the button up or down.
    pub fn moved(&mut self, to: IVec2) {
        if self.down {
            self.position = to;
        }
    }

    /// The button went up.
    pub fn release(&mut self) {
        self.down = false;
    }

    /// Whether the button is down.
    pub fn is_down(&self) -> bool {
        self.down
    }

    /// What `iMouse` is in the frame about to be drawn. Does not change the state: call
    /// [`Mouse::frame_drawn`] once that frame was handed to the GPU.
    pub fn frame_value(&self) -> Vec4 {
        let (x, y) = (self.pressed_at.x as f32, self.pressed_at.y as f32);
        Vec4::new(
            self.position.x as f32,
            self.position.y as f32,
            if self.down { x } else { -x },
            if self.fresh { y } else { -y },
        )
    }

    /// A frame has seen the present state.
    pub fn frame_drawn(&mut self) {
        self.fresh = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(mouse: &mut Mouse) -> [f32; 4] {
        let value = mouse.frame_value();
        mouse.frame_drawn();
        value.to_array()
    }

    #[test]
    fn nothing_before_the_first_click() {
        let mut mouse = Mouse::default();
        mouse.moved(IVec2::new(5, 6));
        assert_eq!(frame(&mut mouse), [0.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn press_drag_release() {
        let mut mouse = Mouse::default();
        mouse.press(IVec2::new(10, 20));
        assert_eq!(frame(&mut mouse), [10.0, 20.0, 10.0, 20.0]);
        assert_eq!(frame(&mut mouse), [10.0, 20.0, 10.0, -20.0], "w only once");
        mouse.moved(IVec2::new(30, 40));
        assert_eq!(frame(&mut mouse), [30.0, 40.0, 10.0, -20.0]);
        mouse.release();
        assert_eq!(frame(&mut mouse), [30.0, 40.0, -10.0, -20.0]);
        mouse.moved(IVec2::new(1, 1));
        assert_eq!(frame(&mut mouse), [30.0, 40.0, -10.0, -20.0], "no hover");
    }

    #[test]
    fn a_press_and_release_between_two_frames_is_still_a_click() {
        let mut mouse = Mouse::default();
        mouse.press(IVec2::new(10, 20));
        mouse.release();
        assert_eq!(frame(&mut mouse), [10.0, 20.0, -10.0, 20.0]);
        assert_eq!(frame(&mut mouse), [10.0, 20.0, -10.0, -20.0]);
    }

    #[test]
    fn the_second_click_counts_like_the_first() {
        let mut mouse = Mouse::default();
        mouse.press(IVec2::new(10, 20));
        frame(&mut mouse);
        mouse.release();
        mouse.press(IVec2::new(3, 4));
        assert_eq!(frame(&mut mouse), [3.0, 4.0, 3.0, 4.0]);
    }
}
