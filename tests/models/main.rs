//! The models against CONTACT, their slopes, patches, friction and the inverse.

#[path = "../common/manchester.rs"]
mod manchester;
#[path = "../common/names.rs"]
mod names;
#[path = "../common/patch_reference.rs"]
mod patch_reference;
#[path = "../common/poison.rs"]
mod poison;
#[path = "../common/random.rs"]
mod random;
#[path = "../common/reference.rs"]
mod reference;
#[path = "../common/single.rs"]
mod single;
#[path = "../common/slopes.rs"]
mod slopes;
#[path = "../common/theory.rs"]
mod theory;

mod accuracy;
mod damping;
mod derivatives;
mod differences;
mod fit;
mod friction;
mod hard_cases;
mod hunting;
mod layer;
mod models;
mod motion;
mod patch;
mod patch_accuracy;
mod patch_friction;
mod patches;
mod prelude;
mod prepared_profile;
mod profile;
mod rig;
mod roller;
mod skew;
mod slender;
mod small_print;
mod special_motions;
mod total;
mod unlike;
mod warnings;
mod wheel_angle;
mod wheel_continuity;
mod wheel_curved;
mod wheel_plausibility;
mod wheel_positions;
mod wheel_rail;
mod wheelset;
