//! The order of the lines of a net, by the places where they cross curves.

use super::net_curve::CurvePlace;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort;
use std::cmp::Ordering;

/// The number of curves of which one gives the order.
const MAX_RULERS: usize = 3;

/// Returns the order in which curves cross lines: the given order if all curves that are not single
/// points cross the lines in this order or its reverse. Otherwise the lines are sorted along a curve,
/// in the direction in which most curves run. If curves contradict each other, the order is the one of
/// that curve among the first three with which most curves agree.
///
/// `place` returns the place on a curve where a line crosses it. `closed` tells whether the first line
/// follows the last one. O(curves x lines + lines log lines).
pub(super) fn order_of_lines(
    curves: &[bool],
    lines: usize,
    closed: bool,
    place: &dyn Fn(usize, usize) -> CurvePlace,
) -> Result<Vec<usize>> {
    let live = || curves.iter().enumerate().filter(|&(_, &is_point)| !is_point).map(|(k, _)| k);
    let directions = |order: &[usize]| {
        let mut count = [0; 2];
        for k in live() {
            match direction(order, closed, &|line| place(k, line)) {
                Some(Direction::Forwards) => count[0] += 1,
                Some(Direction::Backwards) => count[1] += 1,
                None => {}
            }
        }
        count
    };
    let given = alloc::collect(0..lines)?;
    if lines < 2 || directions(&given).iter().sum::<usize>() == live().count() {
        return Ok(given);
    }
    let (mut best, mut most) = (given, 0);
    for ruler in live().take(MAX_RULERS) {
        let mut order = alloc::collect(0..lines)?;
        let by_place = |&a: &usize, &b: &usize| {
            place(ruler, a).partial_cmp(&place(ruler, b)).unwrap_or(Ordering::Equal).then(a.cmp(&b))
        };
        sort::sort_stable(&mut order, &by_place);
        let [forwards, backwards] = directions(&order);
        if backwards > forwards {
            order[usize::from(closed)..].reverse();
        }
        if forwards + backwards > most {
            (best, most) = (order, forwards + backwards);
        }
    }
    Ok(best)
}

/// The direction of a curve relative to an order of lines.
enum Direction {
    Forwards,
    Backwards,
}

/// Returns the direction in which a curve crosses lines in order, or `None` if it does not.
fn direction(order: &[usize], closed: bool, place: &dyn Fn(usize) -> CurvePlace) -> Option<Direction> {
    let count = if closed { order.len() } else { order.len() - 1 };
    let (mut rises, mut falls) = (0, 0);
    for k in 0..count {
        match place(order[k]).partial_cmp(&place(order[(k + 1) % order.len()])) {
            Some(Ordering::Less) => rises += 1,
            Some(Ordering::Greater) => falls += 1,
            _ => return None,
        }
    }
    // Around a closed curve, the places wrap once.
    let allowed = usize::from(closed);
    match (falls == allowed, rises == allowed) {
        (true, _) => Some(Direction::Forwards),
        (_, true) => Some(Direction::Backwards),
        _ => None,
    }
}
