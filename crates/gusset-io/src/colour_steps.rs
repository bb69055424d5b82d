//! Colours in text: parts from 0 to 1, or 256 steps.

/// Largest distance of a colour's part from a step, in steps, that counts as rounding.
const MAX_STEP_ERROR: f32 = 1e-3;

/// Divides parts of colours by 255 if one exceeds 1. Missing parts, which are NaN, become 1.
pub(crate) fn scale_colours(colours: &mut [[f32; 4]]) {
    let largest = colours.iter().flatten().fold(0.0, |most: f32, &part| most.max(part));
    let full = if largest > 1.0 { 255.0 } else { 1.0 };
    for part in colours.iter_mut().flatten() {
        *part = if part.is_nan() { 1.0 } else { (*part / full).clamp(0.0, 1.0) };
    }
}

/// Returns the nearest step of a colour's part; 0 for NaN.
pub(crate) fn nearest_step(part: f32) -> u8 {
    (255.0 * part).round() as u8
}

/// Returns whether bytes hold the colours exactly, and a reader recognises them as bytes: one of them exceeds 1, or all are 0.
pub(crate) fn are_colours_exact_as_bytes(colours: &[[f32; 4]], has_opacity: bool) -> bool {
    let parts = || colours.iter().flat_map(|colour| &colour[..if has_opacity { 4 } else { 3 }]);
    let largest = parts().map(|&part| nearest_step(part)).max().unwrap_or(0);
    largest != 1 && parts().all(|part| (255.0 * part - f32::from(nearest_step(*part))).abs() <= MAX_STEP_ERROR)
}

/// Returns whether a colour is not opaque.
pub(crate) fn has_transparency(colours: &[[f32; 4]]) -> bool {
    colours.iter().any(|colour| colour[3] != 1.0)
}
