//! Colours: linear in glTF files, sRGB in the model.

/// Returns the linear intensity of an sRGB one.
pub(super) fn linear_from_srgb(part: f64) -> f64 {
    if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
}

/// Returns the sRGB intensity of a linear one. If one of 256 steps has this linear intensity except for rounding, returns the step.
pub(super) fn srgb_from_linear(linear: f64) -> f64 {
    let part = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    let step = (255.0 * part).round() / 255.0;
    if (linear_from_srgb(step) - linear).abs() <= 1.0 / 65535.0 { step } else { part }
}

/// Converts colours, and remembers the last one, because neighbours are often equal.
pub(super) struct ColourConverter {
    last_colour: [f32; 4],
    converted: [f32; 4],
    convert: fn(f64) -> f64,
}

impl ColourConverter {
    /// Creates a converter that applies `convert` to each intensity.
    pub(super) fn new(convert: fn(f64) -> f64) -> Self {
        Self { last_colour: [f32::NAN; 4], converted: [0.0; 4], convert }
    }

    /// Applies the function to red, green and blue. Keeps the opacity.
    pub(super) fn convert(&mut self, colour: [f32; 4]) -> [f32; 4] {
        if self.last_colour.map(f32::to_bits) != colour.map(f32::to_bits) {
            self.last_colour = colour;
            let [r, g, b] = [colour[0], colour[1], colour[2]].map(|part| (self.convert)(f64::from(part)) as f32);
            self.converted = [r, g, b, colour[3]];
        }
        self.converted
    }
}
