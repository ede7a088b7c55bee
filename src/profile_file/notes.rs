//! Formats of profile files, and notes on their contents and on changes, as bits.

/// Format of a profile file: found from its beginning.
pub const KSTRIP_FORMAT_ANY: u32 = 0;
/// Format of a profile file: SIMPACK and CONTACT (.prw, .prr).
pub const KSTRIP_FORMAT_SIMPACK: u32 = 1;
/// Format of a profile file: MiniProf (.whl, .ban, .mpt).
pub const KSTRIP_FORMAT_MINIPROF: u32 = 2;
/// Format of a profile file: columns of numbers, text or CSV.
pub const KSTRIP_FORMAT_COLUMNS: u32 = 3;
/// May be added to a format: the file has the profile of a wheel.
pub const KSTRIP_FORMAT_WHEEL: u32 = 16;
/// May be added to a format: the file has the profile of a rail.
pub const KSTRIP_FORMAT_RAIL: u32 = 32;
/// May be added to a format: z points down, whatever the shape.
pub const KSTRIP_FORMAT_Z_DOWN: u32 = 64;
/// May be added to a format: the flange or the gauge side is at small y, whatever the shape.
pub const KSTRIP_FORMAT_SIDE: u32 = 128;

/// Note on a profile file: it is the profile of a wheel; without this note of a rail.
pub const KSTRIP_NOTE_WHEEL: u32 = 1;
/// Note on a profile file: the file has SIMPACK's format.
pub const KSTRIP_NOTE_SIMPACK: u32 = 2;
/// Note on a profile file: the file has MiniProf's format.
pub const KSTRIP_NOTE_MINIPROF: u32 = 4;
/// Note on a profile file: z pointed up and is turned.
pub const KSTRIP_NOTE_Z_TURNED: u32 = 8;
/// Note on a profile file: the flange or the gauge side was at large y, and y is mirrored.
pub const KSTRIP_NOTE_Y_MIRRORED: u32 = 16;
/// Note on a profile file: the points ran toward smaller y and are reversed.
pub const KSTRIP_NOTE_REVERSED: u32 = 32;
/// Note on a profile file: y and z of a wheel are moved from its flange back to its running circle.
pub const KSTRIP_NOTE_RUNNING_CIRCLE: u32 = 64;
/// Note on a profile file: shift, turn or mirrors of its header are applied.
pub const KSTRIP_NOTE_HEADER: u32 = 128;
/// Note on a profile file: lines or points are left out, such as marked or coincident ones.
pub const KSTRIP_NOTE_LEFT_OUT: u32 = 256;
/// Note on a profile file: a smoothing or weights of its header are not used.
pub const KSTRIP_NOTE_IGNORED: u32 = 512;
/// Note on a profile file: its header has another number of points.
pub const KSTRIP_NOTE_COUNT: u32 = 1024;
/// Note on a profile file: the unit is that of the width of the points.
pub const KSTRIP_NOTE_UNIT_OF_WIDTH: u32 = 2048;
/// Doubt about a profile file: it may be another kind, or header and shape differ.
pub const KSTRIP_NOTE_DOUBT_KIND: u32 = 4096;
/// Doubt about a profile file: z may point up by the shape, or is turned against its format.
pub const KSTRIP_NOTE_DOUBT_Z: u32 = 8192;
/// Doubt about a profile file: the side is against its format, or a rail has several heads.
pub const KSTRIP_NOTE_DOUBT_SIDE: u32 = 16384;
/// Doubt about a profile file: the unit is taken as inches or mm, by the size of the points.
pub const KSTRIP_NOTE_DOUBT_UNIT: u32 = 32768;
/// Doubt about a profile file: y = 0 of a wheel is not its running circle.
pub const KSTRIP_NOTE_DOUBT_ORIGIN: u32 = 65536;
/// Doubt about a profile file: no line follows the points, or the first of several is read.
pub const KSTRIP_NOTE_DOUBT_POINTS: u32 = 131_072;
/// Note on a profile file: its shape has no side, without a flange or of a symmetric head.
pub const KSTRIP_NOTE_SYMMETRIC: u32 = 262_144;

pub(super) const DOUBTS: u32 = KSTRIP_NOTE_DOUBT_KIND
    | KSTRIP_NOTE_DOUBT_Z
    | KSTRIP_NOTE_DOUBT_SIDE
    | KSTRIP_NOTE_DOUBT_UNIT
    | KSTRIP_NOTE_DOUBT_ORIGIN
    | KSTRIP_NOTE_DOUBT_POINTS;

/// Whether bits are those of a format.
pub(super) const fn is_known_format(format: u32) -> bool {
    let [kinds, more] =
        [KSTRIP_FORMAT_WHEEL | KSTRIP_FORMAT_RAIL, KSTRIP_FORMAT_Z_DOWN | KSTRIP_FORMAT_SIDE];
    format & kinds != kinds
        && format & 15 <= KSTRIP_FORMAT_COLUMNS
        && format & !(15 | kinds | more) == 0
}

/// Whether the format itself has z down, and flange or gauge side at small y.
pub(super) const fn has_convention(format: u32) -> bool {
    format & 15 == KSTRIP_FORMAT_SIMPACK
}

/// The same of points without the convention.
pub(super) const fn without_convention(format: u32) -> u32 {
    if has_convention(format) { format & !15 } else { format }
}
