//! From the arguments of a C function to a wheel on a rail, and to where its results go.

use super::F;
use crate::ffi::support::{Output, for_strips, given, input, strip_count, with_requested};
use crate::ffi::types::{kstrip_options, kstrip_table};
use crate::forces::Model;
use crate::friction::SlipFriction;
use crate::number::are_finite;
use crate::status::{Error, Warning};
use crate::wheel_rail::forces::wrench::{Law, Wrench, WrenchByPosition, WrenchDerivatives};
use crate::wheel_rail::profile::PreparedProfile;
use crate::wheel_rail::scene::{Scene, TableSource};
use crate::wheel_rail::{BodyState, Position, Requested, Velocity, WheelPair};

/// Where the results of a wheel go.
pub(super) struct WheelOutputs<'a> {
    pub wrench: Output<'a, Wrench<F>>,
    pub derivatives: Output<'a, WrenchDerivatives<F>>,
    pub by_position: Output<'a, WrenchByPosition<F>>,
}

impl WheelOutputs<'_> {
    /// Writes the wrench and the derivatives that are requested, if all their numbers are finite.
    pub fn write(
        self,
        solve: impl FnOnce(
            Requested<WrenchDerivatives<F>, WrenchByPosition<F>>,
        ) -> Result<Wrench<F>, Error>,
    ) -> Result<Warning, Error> {
        let Self { wrench, derivatives, by_position } = self;
        let out = given(wrench)?;
        let fits = |WrenchByPosition { lateral, vertical, yaw, roll }: &_| {
            [lateral, vertical, yaw, roll].into_iter().all(|column: &[F; 6]| are_finite(column))
        };
        let found = with_requested(derivatives, by_position, fits, solve)?;
        out.write(found);
        Ok(found.warning)
    }
}

/// A position with a velocity; both are required.
pub(super) fn state_of(
    position: Option<&Position<F>>, velocity: Option<&Velocity<F>>,
) -> Result<BodyState<F>, Error> {
    Ok(BodyState { position: *given(position)?, velocity: *given(velocity)? })
}

pub(super) fn scene_of<'a>(
    rail: Option<&'a PreparedProfile<F>>, wheel: Option<&'a PreparedProfile<F>>,
    pair: Option<&'a WheelPair<F>>, friction: Option<&'a SlipFriction<F>>,
) -> Result<Scene<'a, F>, Error> {
    let (rail, wheel, pair) = (given(rail)?, given(wheel)?, given(pair)?);
    let (strips, law) = (strip_count(pair.strips)?, law_of(pair.model, friction)?);
    Ok(Scene { rail, wheel, pair, strips, law, table: None })
}

/// The same scene with contacts from a table, if there is one.
///
/// # Safety
/// The memory of the table is NULL or valid for its bytes, and nobody writes it.
pub(super) unsafe fn with_table<'a>(
    scene: Scene<'a, F>, table: Option<&'a kstrip_table>,
) -> Result<Scene<'a, F>, Error> {
    let is_any = |table: &&kstrip_table| table.bytes > 0 || !table.data.is_null();
    let Some(table) = table.filter(is_any) else { return Ok(scene) };
    // SAFETY: the promise of this function.
    let bytes = unsafe { input(table.data, table.bytes)? };
    Ok(Scene { table: Some(source_of(bytes, table.only != 0)?), ..scene })
}

#[cfg(feature = "tables")]
fn source_of(bytes: &[u8], only: bool) -> Result<TableSource<'_, F>, Error> {
    Ok(crate::table::source(bytes, only))
}

/// This build of the library has no tables.
#[cfg(not(feature = "tables"))]
fn source_of(_: &[u8], _: bool) -> Result<TableSource<'_, F>, Error> {
    Err(Error::Table)
}

pub(super) fn law_of(model: i32, falling: Option<&SlipFriction<F>>) -> Result<Law<'_, F>, Error> {
    let model = for_strips(Some(&kstrip_options { model, strips: 0 }))?.model;
    Error::NotInModel.unless(model != Model::Linear)?;
    if let Some(law) = falling {
        // These two members are ignored.
        SlipFriction { friction: 1.0, rolling_speed: 0.0, ..*law }.check()?;
    }
    Ok(Law { model, falling })
}
