//! Units of length by the variable `$INSUNITS`.

/// Metres of each unit, from number 1 on.
const METRES: [f64; 21] = [
    0.0254,
    0.3048,
    1609.344,
    1e-3,
    1e-2,
    1.0,
    1e3,
    0.0254e-6,
    0.0254e-3,
    0.9144,
    1e-10,
    1e-9,
    1e-6,
    0.1,
    10.0,
    100.0,
    1e9,
    149_597_870_700.0,
    9_460_730_472_580_800.0,
    3.085_677_581_491_367e16,
    1200.0 / 3937.0,
];

/// Returns the metres of a unit.
pub(super) fn metres_from_number(number: i64) -> Option<f64> {
    METRES.get(usize::try_from(number).ok()?.checked_sub(1)?).copied()
}

/// Returns the number of the unit that has a length in metres.
pub(super) fn number_from_metres(metres: f64) -> Option<usize> {
    const MAX_RELATIVE_ERROR: f64 = 1e-9;
    METRES.iter().position(|unit| (metres / unit - 1.0).abs() < MAX_RELATIVE_ERROR).map(|place| place + 1)
}
