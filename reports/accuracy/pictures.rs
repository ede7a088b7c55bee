//! The drawing of the accuracy report: plain pictures with axes placed by hand.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::path::Path;

#[path = "../common/palette.rs"]
mod palette;
// (each report uses some of them)
#[allow(unused_imports)]
pub use palette::{AMBER, BLUE, GREEN, PURPLE, SKY, VERMILION};

pub type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub type Drawn = Result<(), Box<dyn Error>>;

/// plotters rounds to whole pixels: draw this much larger, and let the file say the true size.
const SCALE: u32 = 8;

pub const INK: RGBColor = RGBColor(0x22, 0x22, 0x22);
pub const GREY: RGBColor = RGBColor(0x99, 0x99, 0x99);
pub const PALE: RGBColor = RGBColor(0xe4, 0xe4, 0xe4);

fn place(at: (f64, f64)) -> (i32, i32) {
    let scale = f64::from(SCALE);
    ((at.0 * scale).round() as i32, (at.1 * scale).round() as i32)
}

/// Where a text stands relative to its place; vertically it is centred.
#[derive(Clone, Copy)]
pub enum Align {
    Left,
    Centre,
    Right,
}

pub fn write(
    canvas: &Canvas, text: &str, at: (f64, f64), size: u32, align: Align, ink: RGBColor,
) -> Drawn {
    let side = match align {
        Align::Left => HPos::Left,
        Align::Centre => HPos::Center,
        Align::Right => HPos::Right,
    };
    // plotters writes four fifths of a size
    let style = TextStyle::from(("sans-serif", size * SCALE * 5 / 4).into_font())
        .color(&ink)
        .pos(Pos::new(side, VPos::Center));
    canvas.draw(&Text::new(text.to_owned(), place(at), style))?;
    Ok(())
}

pub fn line(canvas: &Canvas, points: &[(f64, f64)], ink: RGBColor, width: f64) -> Drawn {
    let width = (width * f64::from(SCALE)).round() as u32;
    let points: Vec<_> = points.iter().map(|at| place(*at)).collect();
    canvas.draw(&PathElement::new(points, ink.stroke_width(width)))?;
    Ok(())
}

/// A filled rectangle from the upper left to the lower right corner.
pub fn block(canvas: &Canvas, from: (f64, f64), to: (f64, f64), colour: RGBColor) -> Drawn {
    canvas.draw(&Rectangle::new([place(from), place(to)], colour.filled()))?;
    Ok(())
}

/// A dot, filled or open.
pub fn dot(canvas: &Canvas, at: (f64, f64), radius: f64, ink: RGBColor, filled: bool) -> Drawn {
    let radius = (radius * f64::from(SCALE)).round() as u32;
    let style = if filled { ink.filled() } else { ink.stroke_width(SCALE) };
    canvas.draw(&Circle::new(place(at), radius, style))?;
    Ok(())
}

/// Lets `draw` fill a picture of this size, and writes the file.
pub fn picture(path: &Path, (width, height): (u32, u32), draw: impl Fn(&Canvas) -> Drawn) -> Drawn {
    let (large_width, large_height) = (width * SCALE, height * SCALE);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (large_width, large_height));
        let canvas = canvas.into_drawing_area();
        canvas.fill(&WHITE)?;
        draw(&canvas)?;
        canvas.present()?;
    }
    let size = |w: u32, h: u32| format!("<svg width=\"{w}\" height=\"{h}\" viewBox");
    let (large, true_size) = (size(large_width, large_height), size(width, height));
    if !svg.contains(&large) {
        return Err("the picture does not begin as expected".into());
    }
    std::fs::write(path, svg.replacen(&large, &true_size, 1))?;
    Ok(())
}

/// One axis of a plot: its limits, whether it is logarithmic, and the labelled values.
#[derive(Clone)]
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pub logarithmic: bool,
    pub ticks: Vec<(f64, String)>,
}

impl Axis {
    pub fn linear(low: f64, high: f64, ticks: &[f64]) -> Self {
        let text = |tick: &f64| (*tick, tick.to_string().replace('-', "−"));
        Self { low, high, logarithmic: false, ticks: ticks.iter().map(text).collect() }
    }

    pub fn logarithmic(low: f64, high: f64, ticks: &[f64]) -> Self {
        let text = |tick: &f64| {
            let exponent = tick.log10().round() as i32;
            // powers of ten below a ten-thousandth in digits would be unreadable
            let text = if exponent < -4 { format!("1e−{}", -exponent) } else { tick.to_string() };
            (*tick, text)
        };
        Self { low, high, logarithmic: true, ticks: ticks.iter().map(text).collect() }
    }

    /// 0 at the low end, 1 at the high one.
    pub fn share(&self, value: f64) -> f64 {
        let (low, high, value) = if self.logarithmic {
            (self.low.log10(), self.high.log10(), value.max(self.low).log10())
        } else {
            (self.low, self.high, value)
        };
        (value - low) / (high - low)
    }
}

/// A rectangle with axes.
pub struct Plot {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
    pub x: Axis,
    pub y: Axis,
}

impl Plot {
    pub fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let right = self.left + self.x.share(x) * self.width;
        (right, self.top + (1.0 - self.y.share(y)) * self.height)
    }

    /// Grid, frame and numbers.
    pub fn frame(&self, canvas: &Canvas) -> Drawn {
        let (right, bottom) = (self.left + self.width, self.top + self.height);
        for (tick, text) in &self.x.ticks {
            let x = self.left + self.x.share(*tick) * self.width;
            line(canvas, &[(x, self.top), (x, bottom)], PALE, 1.0)?;
            write(canvas, text, (x, bottom + 12.0), 12, Align::Centre, INK)?;
        }
        for (tick, text) in &self.y.ticks {
            let y = self.top + (1.0 - self.y.share(*tick)) * self.height;
            line(canvas, &[(self.left, y), (right, y)], PALE, 1.0)?;
            write(canvas, text, (self.left - 6.0, y), 12, Align::Right, INK)?;
        }
        let corners = [
            (self.left, self.top),
            (right, self.top),
            (right, bottom),
            (self.left, bottom),
            (self.left, self.top),
        ];
        line(canvas, &corners, INK, 1.0)
    }

    pub fn title(&self, canvas: &Canvas, text: &str) -> Drawn {
        write(canvas, text, (self.left, self.top - 11.0), 13, Align::Left, INK)
    }

    pub fn curve(
        &self, canvas: &Canvas, points: &[(f64, f64)], ink: RGBColor, width: f64,
    ) -> Drawn {
        let points: Vec<_> = points.iter().map(|(x, y)| self.at(*x, *y)).collect();
        line(canvas, &points, ink, width)
    }
}

/// The colour of an error between `1e-3` (pale) and 1 (dark), on a logarithmic scale, and the ink
/// that is readable on it.
pub fn heat(error: f64) -> (RGBColor, RGBColor) {
    const STOPS: [(f64, [f64; 3]); 6] = [
        (0.0, [247.0, 252.0, 240.0]),
        (0.2, [204.0, 235.0, 197.0]),
        (0.4, [254.0, 227.0, 145.0]),
        (0.6, [253.0, 141.0, 60.0]),
        (0.8, [189.0, 30.0, 38.0]),
        (1.0, [70.0, 0.0, 30.0]),
    ];
    let share = ((error.max(1e-9).log10() + 3.0) / 3.0).clamp(0.0, 1.0);
    let next = STOPS.iter().position(|(stop, _)| share <= *stop).unwrap_or(5).max(1);
    let ((low, from), (high, to)) = (STOPS[next - 1], STOPS[next]);
    let t = (share - low) / (high - low);
    let [r, g, b] = std::array::from_fn(|i| (from[i] + t * (to[i] - from[i])).round() as u8);
    (RGBColor(r, g, b), if share > 0.66 { WHITE } else { INK })
}
