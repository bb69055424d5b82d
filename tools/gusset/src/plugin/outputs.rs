//! Results of runs: meshes, curves, texts with numbers, origins, or the reason of a failure.

use super::filter::{Filter, OutputKind};
use super::library::Plugin;
use super::table_text;
use gusset::capi::plugin::channels::*;
use gusset::capi::plugin::descriptor::*;
use gusset::capi::plugin::outcome::gusset_outputs;
use gusset_io::{Curves, Mesh, Positions};
use std::ffi::c_void;
use std::ptr;

/// Results of a run.
pub(crate) struct Outputs {
    plugin: Plugin,
    raw: *mut gusset_outputs,
}

impl Drop for Outputs {
    fn drop(&mut self) {
        // SAFETY: nothing refers to the outputs any more; NULL is allowed.
        unsafe { (self.plugin.tables().output_free)(self.raw) };
    }
}

/// A number of a report.
pub(crate) struct NamedValue<'a> {
    pub(crate) name: &'a str,
    pub(crate) number: f64,
    pub(crate) kind: ValueKind,
}

/// How a number of a report is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum ValueKind {
    Flag,
    /// In radians.
    Angle,
    Number,
}

/// Why a run has no results.
pub(crate) enum RunError {
    Cancelled,
    OutOfMemory(String),
    /// The plugin broke.
    Internal(String),
    Refused {
        message: String,
        status: i32,
        parameter: Option<&'static str>,
        input: Option<u32>,
        element: Option<(&'static str, u64)>,
    },
}

/// Plugins use this status, and larger ones, for their own defects.
const FIRST_INTERNAL_STATUS: i32 = 9999;

impl Outputs {
    pub(super) fn new(plugin: Plugin, raw: *mut gusset_outputs) -> Self {
        Self { plugin, raw }
    }

    /// Returns the reason of a failed run.
    pub(super) fn refusal(&self, filter: Filter, status: i32) -> RunError {
        let mut failure = gusset_failure {
            struct_size: size_of::<gusset_failure>(),
            message: ptr::null(),
            status,
            param: GUSSET_PLUGIN_NONE,
            input: GUSSET_PLUGIN_NONE,
            element: 0,
            index: 0,
            value: 0.0,
        };
        // SAFETY: outputs of a failed run, which may be NULL.
        let told = !self.raw.is_null()
            && unsafe { (self.plugin.tables().output_failure)(self.raw, &mut failure) } == GUSSET_PLUGIN_DONE;
        // SAFETY: the text lives as long as the outputs.
        let message = if told { unsafe { table_text(failure.message) }.to_owned() } else { format!("status {status}") };
        if status == GUSSET_PLUGIN_OUT_OF_MEMORY {
            return RunError::OutOfMemory(message);
        }
        if status >= FIRST_INTERNAL_STATUS {
            return RunError::Internal(message);
        }
        RunError::Refused {
            message,
            status,
            parameter: filter.params().get(failure.param as usize).map(|param| param.id()),
            input: (failure.input != GUSSET_PLUGIN_NONE).then_some(failure.input),
            element: element_name(failure.element).map(|name| (name, failure.index)),
        }
    }

    pub(crate) fn count(&self) -> u32 {
        // SAFETY: outputs of a run.
        unsafe { (self.plugin.tables().output_count)(self.raw) }
    }

    pub(crate) fn kind(&self, index: u32) -> OutputKind {
        // SAFETY: outputs of a run.
        OutputKind::from_code(unsafe { (self.plugin.tables().output_kind)(self.raw, index) })
    }

    /// Copies an output mesh.
    pub(crate) fn mesh(&self, index: u32) -> Option<Mesh> {
        // SAFETY: a struct of integers and pointers may be zero.
        let mut view: gusset_plugin_mesh = unsafe { std::mem::zeroed() };
        view.struct_size = size_of::<gusset_plugin_mesh>();
        // SAFETY: outputs of a run; so are the arrays of the view, which have the stated lengths.
        unsafe {
            if (self.plugin.tables().output_mesh)(self.raw, index, &mut view) != GUSSET_PLUGIN_DONE {
                return None;
            }
            let face_offsets = copied::<u32>(view.face_offsets, view.face_count + 1);
            let corners = copied(view.face_corners, face_offsets.last().map_or(0, |&end| end as usize));
            Some(Mesh {
                positions: copied_positions(view.positions, view.position_stride, view.vertex_count, view.scalar),
                face_offsets,
                corners,
                merge: if view.merge.is_null() { Vec::new() } else { copied(view.merge, view.vertex_count) },
                ..Mesh::default()
            })
        }
    }

    /// Copies output curves.
    pub(crate) fn curves(&self, index: u32) -> Option<Curves> {
        // SAFETY: a struct of integers and pointers may be zero.
        let mut view: gusset_plugin_curves = unsafe { std::mem::zeroed() };
        view.struct_size = size_of::<gusset_plugin_curves>();
        // SAFETY: as for meshes.
        unsafe {
            if (self.plugin.tables().output_curves)(self.raw, index, &mut view) != GUSSET_PLUGIN_DONE {
                return None;
            }
            let closed: Vec<u8> = if view.closed.is_null() {
                vec![0; view.curve_count]
            } else {
                copied(view.closed.cast(), view.curve_count)
            };
            Some(Curves {
                positions: copied_positions(view.points, view.point_stride, view.point_count, view.scalar),
                offsets: if view.curve_count == 0 { vec![0] } else { copied(view.offsets, view.curve_count + 1) },
                closed: closed.into_iter().map(|closed| closed != 0).collect(),
            })
        }
    }

    /// Returns an output text.
    pub(crate) fn text(&self, index: u32) -> &str {
        // SAFETY: the text lives as long as the outputs.
        unsafe { table_text((self.plugin.tables().output_text)(self.raw, index)) }
    }

    /// Returns the numbers of an output text.
    pub(crate) fn values(&self, index: u32) -> Vec<NamedValue<'_>> {
        let Some(values) = self.plugin.values() else { return Vec::new() };
        let tells_kind = values.struct_size >= size_of::<gusset_plugin_values>();
        // SAFETY: outputs of a run, indices below the count, and no function beyond the struct's size.
        unsafe {
            (0..(values.count)(self.raw, index))
                .map(|which| NamedValue {
                    name: table_text((values.name)(self.raw, index, which)),
                    number: (values.value)(self.raw, index, which),
                    kind: match if tells_kind { (values.kind)(self.raw, index, which) } else { 0 } {
                        GUSSET_VALUE_FLAG => ValueKind::Flag,
                        GUSSET_VALUE_ANGLE => ValueKind::Angle,
                        _ => ValueKind::Number,
                    },
                })
                .collect()
        }
    }

    /// Returns the origins of an output mesh, if the run was asked for them.
    pub(crate) fn origins(&self, index: u32) -> Option<Origins<'_>> {
        let attributes = self.plugin.attributes()?;
        // SAFETY: outputs of a run.
        (unsafe { (attributes.has_origins)(self.raw, index) } != 0).then_some(Origins {
            outputs: self,
            attributes,
            index,
        })
    }
}

/// Returns the word for a kind of element; `None` if the index does not point at one.
fn element_name(element: u32) -> Option<&'static str> {
    match element {
        0 | 6 => None,
        1 => Some("vertex"),
        2 => Some("face"),
        3 => Some("corner"),
        _ => Some("element"),
    }
}

unsafe fn copied<T: Copy>(from: *const c_void, count: usize) -> Vec<T> {
    if from.is_null() || count == 0 {
        return Vec::new();
    }
    // SAFETY: the plugin lends this many values.
    unsafe { std::slice::from_raw_parts(from.cast::<T>(), count) }.to_vec()
}

unsafe fn copied_positions(from: *const c_void, stride: usize, count: usize, scalar: u32) -> Positions {
    // SAFETY: the plugin lends this many points of this type at this stride.
    unsafe {
        if scalar == GUSSET_PLUGIN_F32 {
            Positions::F32(copied_points(from, stride, count))
        } else {
            Positions::F64(copied_points(from, stride, count))
        }
    }
}

unsafe fn copied_points<T: Copy>(from: *const c_void, stride: usize, count: usize) -> Vec<[T; 3]> {
    let stride = if stride == 0 { size_of::<[T; 3]>() } else { stride };
    // SAFETY: the caller's promise; points may be unaligned.
    (0..count).map(|index| unsafe { from.cast::<u8>().add(index * stride).cast::<[T; 3]>().read_unaligned() }).collect()
}

/// Elements that attributes belong to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Domain {
    Vertices,
    Corners,
    Faces,
}

/// How new elements get values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Rule {
    Linear,
    Normal,
    Nearest,
    Texture,
}

/// Values that are carried from inputs to an output.
#[derive(Clone, Copy)]
pub(crate) struct Channel {
    pub(crate) domain: Domain,
    pub(crate) rule: Rule,
    /// Numbers of an element.
    pub(crate) width: usize,
}

impl Domain {
    fn code(self) -> u32 {
        match self {
            Self::Vertices => GUSSET_PLUGIN_VERTICES,
            Self::Corners => GUSSET_PLUGIN_CORNERS,
            Self::Faces => GUSSET_PLUGIN_FACES,
        }
    }
}

/// Origins of an output mesh's elements.
pub(crate) struct Origins<'a> {
    outputs: &'a Outputs,
    attributes: &'static gusset_plugin_attributes,
    index: u32,
}

/// Sources of elements: element `k` has sources `offsets[k]` to `offsets[k + 1] - 1`, numbered through all inputs; input `i` has sources
/// `starts[i]` to `starts[i + 1] - 1`.
pub(crate) struct Sources<'a> {
    pub(crate) offsets: &'a [u32],
    pub(crate) sources: &'a [u32],
    pub(crate) starts: &'a [u32],
}

impl Sources<'_> {
    /// Returns the only source of an element as input and index; `None` for new elements.
    pub(crate) fn single(&self, element: usize) -> Option<(usize, usize)> {
        let [start, end] = [self.offsets[element], self.offsets[element + 1]];
        if end != start + 1 {
            return None;
        }
        let source = self.sources[start as usize];
        let input = self.starts.partition_point(|&first| first <= source) - 1;
        Some((input, (source - self.starts[input]) as usize))
    }
}

impl<'a> Origins<'a> {
    /// Returns the sources of the output's elements.
    pub(crate) fn sources(&self, domain: Domain) -> Option<Sources<'a>> {
        // SAFETY: a struct of integers and pointers may be zero.
        let mut raw: gusset_plugin_origins = unsafe { std::mem::zeroed() };
        raw.struct_size = size_of::<gusset_plugin_origins>();
        // SAFETY: outputs of a run, whose arrays live as long as they.
        unsafe {
            if (self.attributes.origins)(self.outputs.raw, self.index, domain.code(), &mut raw) != GUSSET_PLUGIN_DONE {
                return None;
            }
            let offsets = lent(raw.offsets, raw.count + 1);
            let sources = lent(raw.sources, offsets.last().map_or(0, |&end| end as usize));
            Some(Sources { offsets, sources, starts: lent(raw.starts, raw.input_count + 1) })
        }
    }

    /// Returns the values of the output's elements, from the values of each input's elements.
    pub(crate) fn apply(&self, channel: Channel, inputs: &[Vec<f64>]) -> Option<Vec<f64>> {
        let count = self.sources(channel.domain)?.offsets.len() - 1;
        let mut values = vec![0.0; count * channel.width];
        let raw = gusset_plugin_channel {
            struct_size: size_of::<gusset_plugin_channel>(),
            domain: channel.domain.code(),
            value_type: GUSSET_PLUGIN_VALUE_F64,
            components: channel.width as u32,
            rule: match channel.rule {
                Rule::Linear => GUSSET_PLUGIN_RULE_LINEAR,
                Rule::Normal => GUSSET_PLUGIN_RULE_NORMAL,
                Rule::Nearest => GUSSET_PLUGIN_RULE_NEAREST,
                Rule::Texture => GUSSET_PLUGIN_RULE_TEXTURE,
            },
            max_influences: 0,
            reserved: 0,
        };
        let given: Vec<gusset_plugin_channel_values> = inputs
            .iter()
            .map(|values| gusset_plugin_channel_values {
                values: values.as_ptr().cast(),
                count: values.len() / channel.width,
                stride: 0,
            })
            .collect();
        // SAFETY: arrays of the stated lengths, which are valid during the call.
        let status = unsafe {
            (self.attributes.apply)(
                self.outputs.raw,
                self.index,
                ptr::null(),
                &raw,
                given.as_ptr(),
                given.len() as u32,
                values.as_mut_ptr().cast(),
                count,
                0,
                ptr::null_mut(),
            )
        };
        (status == GUSSET_PLUGIN_DONE).then_some(values)
    }
}

unsafe fn lent<'a, T>(from: *const T, count: usize) -> &'a [T] {
    if from.is_null() || count == 0 {
        return &[];
    }
    // SAFETY: the plugin lends this many values.
    unsafe { std::slice::from_raw_parts(from, count) }
}
