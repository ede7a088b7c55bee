//! A patch that rolls forward or backward, with its model and its law of friction.

use crate::contact::creepage::Creepage;
use crate::forces::Model;
use crate::friction::SlipFriction;
use crate::motion::Rolling;
use crate::number::{Float, reverse};
use crate::patch::{Patch, PatchView};
use crate::status::Error;

/// The model of the creep forces, and the law of friction.
#[derive(Clone, Copy)]
pub struct Law<'a, F> {
    /// The model.
    pub model: Model,
    /// Falling friction; its own coefficient and rolling speed are ignored.
    pub falling: Option<&'a SlipFriction<F>>,
}

/// The law at a rolling speed.
pub(super) fn at_speed<F: Float>(law: Law<F>, speed: F) -> Option<SlipFriction<F>> {
    law.falling.map(|law| SlipFriction { friction: F::one(), rolling_speed: speed, ..*law })
}

/// A patch whose pressure has a factor, and memory for one that is turned.
pub(super) struct Pressed<'a, F> {
    pub patch: &'a Patch<F>,
    pub factor: F,
    pub room: &'a mut Patch<F>,
}

impl<F: Float> Pressed<'_, F> {
    /// The results of a patch that rolls forward, and of one that is turned by 180 degrees. The
    /// ends have the mismatch `±κ V/V_f`, of this ratio. The function learns
    /// whether the patch is turned.
    pub fn each_end<S: Copy>(
        &mut self, rolling: &Rolling<F>, ratio: F,
        solve: impl Fn(&PatchView<F>, &Creepage<F>, bool) -> Result<S, Error>,
    ) -> Result<[S; 2], Error> {
        rolling.each_end(|creepage, is_turned| {
            let patch = if is_turned || self.factor != F::one() {
                self.copied(is_turned)
            } else {
                self.patch
            };
            let mut view = patch.view()?;
            if patch.mismatch != F::zero() {
                let ratio = if is_turned { -ratio } else { ratio };
                view = view.with_mismatch(patch.mismatch * ratio)?;
            }
            solve(&view, creepage, is_turned)
        })
    }

    /// The patch, turned or with the friction that follows the pressure.
    fn copied(&mut self, is_turned: bool) -> &Patch<F> {
        *self.room = *self.patch;
        let count = self.room.count as usize;
        let used = self.room.strips.get_mut(..count).unwrap_or(&mut []);
        for strip in used.iter_mut() {
            strip.friction = strip.friction * self.factor;
        }
        if is_turned {
            reverse(used);
            for strip in used {
                (strip.y, strip.centre_x) = (-strip.y, -strip.centre_x);
            }
        }
        self.room
    }
}
