//! The colours of all pictures, after Okabe and Ito, which colour-blind readers can distinguish.
//! `kstrip.plot` and the browser demo have the same.
//!
//! TOTAL is blue, STRIP vermilion, STRIP_1967 green, its continuous twin purple, FASTSIM amber and
//! FaStrip sky blue. A right wheel is blue, a left wheel vermilion.

#![allow(dead_code)]

use plotters::prelude::RGBColor;

pub const BLUE: RGBColor = RGBColor(0x00, 0x72, 0xb2);
pub const VERMILION: RGBColor = RGBColor(0xd5, 0x5e, 0x00);
pub const GREEN: RGBColor = RGBColor(0x00, 0x9e, 0x73);
pub const PURPLE: RGBColor = RGBColor(0xcc, 0x79, 0xa7);
pub const AMBER: RGBColor = RGBColor(0xe6, 0x9f, 0x00);
pub const SKY: RGBColor = RGBColor(0x56, 0xb4, 0xe9);
