//! Wheel on rail: from two profiles and a position to the forces on the wheel.

use super::support::*;
use crate::wheel_rail::scene::Scene;
use crate::wheel_rail::wrench::Law;

pub(super) fn scene_of<'a, F: Float>(
    rail: Option<&'a Surface<F>>,
    wheel: Option<&'a Surface<F>>,
    pair: Option<&'a WheelPair<F>>,
    friction: Option<&'a SlipFriction<F>>,
) -> Result<Scene<'a, F>, Error> {
    let (rail, wheel, pair) = (given(rail)?, given(wheel)?, given(pair)?);
    let (strips, law) = (strip_count(pair.strips)?, law_of(pair.model, friction)?);
    Ok(Scene { rail, wheel, pair, strips, law })
}

pub(super) fn law_of<F: Float>(
    model: i32,
    falling: Option<&SlipFriction<F>>,
) -> Result<Law<'_, F>, Error> {
    let model = for_strips(Some(&kstrip_options { model, strips: 0 }))?.model;
    Error::NotInModel.unless(model != Model::Linear)?;
    falling.map_or(Ok(()), SlipFriction::check)?;
    Ok(Law { model, falling })
}
