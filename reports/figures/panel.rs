//! A panel of a picture: two axes with ticks, linear or logarithmic, and curves in it.

use super::{Canvas, Drawn, INK, Kind, dashes, font, line, number, place, write};
use plotters::prelude::*;

pub struct Axis {
    pub label: &'static str,
    pub limits: (f64, f64),
    pub ticks: Vec<f64>,
    pub decimals: usize,
    pub logarithmic: bool,
}

impl Axis {
    /// Where a value stands between the limits, 0 to 1.
    fn share(&self, value: f64) -> f64 {
        let scale = |x: f64| if self.logarithmic { x.log10() } else { x };
        let (low, high) = (scale(self.limits.0), scale(self.limits.1));
        (scale(value) - low) / (high - low)
    }
}

/// `left, top` and size are in pixels of the finished picture.
pub struct Panel {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
    pub x: Axis,
    pub y: Axis,
}

impl Panel {
    /// Pixels of a point.
    pub fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.left + self.x.share(x) * self.width, self.top + (1.0 - self.y.share(y)) * self.height)
    }

    fn path(&self, points: &[(f64, f64)]) -> Vec<(i32, i32)> {
        points
            .iter()
            .map(|point| {
                let (h, v) = self.at(*point);
                place(h, v)
            })
            .collect()
    }

    /// Grid, frame, ticks and labels.
    pub fn draw(&self, canvas: &Canvas) -> Drawn {
        let grid = line(RGBColor(0xdd, 0xdd, 0xdd), 1);
        let (x, y) = (&self.x, &self.y);
        for tick in &x.ticks {
            let ends = [(*tick, y.limits.0), (*tick, y.limits.1)];
            canvas.draw(&PathElement::new(self.path(&ends), grid))?;
            let text = number(*tick, x.decimals);
            let (h, _) = self.at((*tick, y.limits.0));
            let half = 3.9 * text.chars().count() as f64;
            write(canvas, &text, (h - half, self.top + self.height + 8.0), 14)?;
        }
        for tick in &y.ticks {
            let ends = [(x.limits.0, *tick), (x.limits.1, *tick)];
            canvas.draw(&PathElement::new(self.path(&ends), grid))?;
            let text = number(*tick, y.decimals);
            let (_, v) = self.at((x.limits.0, *tick));
            let width = 7.8 * text.chars().count() as f64;
            write(canvas, &text, (self.left - 8.0 - width, v - 8.0), 14)?;
        }
        let corners =
            [place(self.left, self.top), { place(self.left + self.width, self.top + self.height) }];
        canvas.draw(&Rectangle::new(corners, line(INK, 1)))?;
        let middle = self.left + 0.5 * self.width - 3.7 * x.label.chars().count() as f64;
        write(canvas, x.label, (middle, self.top + self.height + 30.0), 16)?;
        let upright = font(16).transform(FontTransform::Rotate270);
        let middle = self.top + 0.5 * self.height + 3.7 * y.label.chars().count() as f64;
        canvas.draw(&Text::new(y.label.to_owned(), place(self.left - 66.0, middle), upright))?;
        Ok(())
    }

    pub fn curve(
        &self, canvas: &Canvas, points: &[(f64, f64)], colour: RGBColor, kind: Kind,
    ) -> Drawn {
        let path = self.path(points);
        match kind {
            Kind::Line => {
                canvas.draw(&PathElement::new(path, line(colour, 2)))?;
            }
            Kind::Dashed => {
                let scale = f64::from(super::SCALE);
                for piece in dashes(&path, 7.0 * scale, 5.0 * scale) {
                    canvas.draw(&PathElement::new(piece, line(colour, 1)))?;
                }
            }
            Kind::Circles | Kind::Joined => {
                if kind == Kind::Joined {
                    canvas.draw(&PathElement::new(path.clone(), line(colour, 1)))?;
                }
                for at in path {
                    canvas.draw(&Circle::new(at, 5 * super::SCALE, colour.filled()))?;
                }
            }
        }
        Ok(())
    }

    /// A name for a curve, beside one of its points.
    pub fn name(
        &self, canvas: &Canvas, text: &str, point: (f64, f64), (right, down): (f64, f64),
        colour: RGBColor,
    ) -> Drawn {
        let (h, v) = self.at(point);
        let style = font(14).color(&colour);
        canvas.draw(&Text::new(text.to_owned(), place(h + right, v + down), style))?;
        Ok(())
    }
}
