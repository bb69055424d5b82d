/** @file
 * gusset as a plugin: what a host needs to know. Generated from src/capi/plugin; do not edit.
 *
 * A host loads the library, looks up the one symbol gusset_plugin_entry, and finds in the tables behind it filters with typed
 * parameters, each of which takes meshes or curves and gives meshes, curves or text:
 *     void *library = dlopen("libgusset.so.0.1", RTLD_NOW | RTLD_LOCAL);
 *     gusset_plugin_entry_fn entry = NULL;
 *     if (library) *(void **)&entry = dlsym(library, "gusset_plugin_entry");
 *     const gusset_plugin *plugin = entry ? entry(GUSSET_PLUGIN_ABI) : NULL;
 *     const gusset_filter *filter = plugin ? plugin->find("weld") : NULL;
 *
 * Structs begin with struct_size: in those that the host makes, sizeof the struct, all other fields 0 unless said otherwise. In
 * those that the plugin makes it tells which fields are there: a later version may append some. Counts are in elements,
 * strides in bytes, angles in radians, lengths in the unit of the positions, indices from 0. Statuses are those of gusset.h,
 * which a host does not need. C99 or later, C++11 or later.
 */

#ifndef GUSSET_PLUGIN_H
#define GUSSET_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_PLUGIN_MUST_USE __attribute__((warn_unused_result))
#else
#define GUSSET_PLUGIN_MUST_USE
#endif
#if defined(__GNUC__)
#define GUSSET_PLUGIN_API __attribute__((visibility("default")))
#else
#define GUSSET_PLUGIN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- The entry: One symbol leads to the tables of filters. Hosts need gusset_plugin.h alone, which is made from */
/* this folder. */

struct gusset_plugin;

/// The plugin's tables, or NULL if it cannot serve a host of this ABI. host_abi: the host's GUSSET_PLUGIN_ABI. The
/// tables are static: made at the first call, never freed; there is nothing to initialise or to shut down, and the
/// library stays loaded after dlclose. May be called from any thread, as often as one likes.
GUSSET_PLUGIN_API GUSSET_PLUGIN_MUST_USE const struct gusset_plugin *gusset_plugin_entry(uint32_t host_abi);

/* ---- Attributes: The extension that carries values of elements to outputs. */

/// Elements of a mesh: vertices.
#define GUSSET_PLUGIN_VERTICES 0
/// Elements of a mesh: corners of faces, in the order of face_corners.
#define GUSSET_PLUGIN_CORNERS 1
/// Elements of a mesh: faces.
#define GUSSET_PLUGIN_FACES 2
/// Values are 32-bit floats.
#define GUSSET_PLUGIN_VALUE_F32 1
/// Values are 64-bit floats.
#define GUSSET_PLUGIN_VALUE_F64 2
/// Values are 8-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U8 3
/// Values are 16-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U16 4
/// Values are 32-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U32 5
/// Several values become their weighted mean, as of colours; of integers rounded.
#define GUSSET_PLUGIN_RULE_LINEAR 0
/// Directions of three floats become their mean on the sphere, of length 1; those of faces that were turned over are
/// turned.
#define GUSSET_PLUGIN_RULE_NORMAL 1
/// Skin weights become their weighted mean, of which the max_influences largest are kept, with the sum 1, or of
/// integers the largest number of the type.
#define GUSSET_PLUGIN_RULE_SKIN_WEIGHTS 2
/// The value of the source that counts most is taken, as of materials and numbers.
#define GUSSET_PLUGIN_RULE_NEAREST 3
/// Texture coordinates: at the corners of new faces the mean where both sides are on one chart, and elsewhere each
/// side's chart goes on to a seam in the middle.
#define GUSSET_PLUGIN_RULE_TEXTURE 4

/// What the values of elements are, and how they are mixed. An element of one source has its value, bit for bit; one
/// without sources, or whose sources have no values, 0.
typedef struct gusset_plugin_channel {
    size_t struct_size;
    /// GUSSET_PLUGIN_VERTICES, GUSSET_PLUGIN_CORNERS or GUSSET_PLUGIN_FACES.
    uint32_t domain;
    /// GUSSET_PLUGIN_VALUE_...; zero is no valid value.
    uint32_t value_type;
    /// How many values an element has, 1 to 4096.
    uint32_t components;
    /// GUSSET_PLUGIN_RULE_...
    uint32_t rule;
    /// With GUSSET_PLUGIN_RULE_SKIN_WEIGHTS, how many are kept of elements with several sources; 0: all.
    uint32_t max_influences;
    uint32_t reserved;
} gusset_plugin_channel;

/// The values of one input's elements.
typedef struct gusset_plugin_channel_values {
    /// The components of each element at the start of every stride, at any alignment; NULL with count 0 if the input
    /// has no such values.
    const void *values;
    /// The number of elements: of the input's vertices, corners or faces, all.
    size_t count;
    /// Bytes from one element to the next; 0 if they are packed.
    size_t stride;
} gusset_plugin_channel_values;

/// Where elements of an output come from. The arrays live as long as the outputs.
typedef struct gusset_plugin_origins {
    size_t struct_size;
    /// The number of elements.
    size_t count;
    /// count + 1 entries: element k has the entries offsets[k] to offsets[k + 1] - 1 of sources and weights; none if it
    /// comes from nothing.
    const uint32_t *offsets;
    /// Elements of the inputs, numbered through all of them.
    const uint32_t *sources;
    /// How much each counts: more than 0, with the sum 1 for each element.
    const double *weights;
    /// The number of inputs.
    size_t input_count;
    /// input_count + 1 entries: the elements of input i are the sources starts[i] to starts[i + 1] - 1.
    const uint32_t *starts;
} gusset_plugin_origins;

struct gusset_failure;

struct gusset_host;

struct gusset_outputs;

/// What meshes carry beside positions, carried over to the outputs of a run whose host asked for origins:
/// extension("attributes/1"). The struct is static; the functions may be called from many threads at once.
typedef struct gusset_plugin_attributes {
    size_t struct_size;
    /// 1 if output index tells where its elements come from, else 0.
    uint32_t (*has_origins)(const struct gusset_outputs *outputs, uint32_t index);
    /// Fills origins, whose struct_size is set, with those of output index. domain: GUSSET_PLUGIN_VERTICES,
    /// GUSSET_PLUGIN_CORNERS or GUSSET_PLUGIN_FACES. Returns GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    int32_t (*origins)(const struct gusset_outputs *outputs,
                       uint32_t index,
                       uint32_t domain,
                       struct gusset_plugin_origins *origins);
    /// Writes the values of the elements of output index. host: NULL for no callbacks and automatic threads. channel:
    /// its struct_size is set. inputs: input_count structs, one for each input of the run, in their order. values: room
    /// for count elements, those of the output at least, stride bytes apart, 0 for packed ones, at any alignment; it
    /// must not overlap the inputs' values. failure: receives why there are none, the message of static texts, or NULL.
    /// O(elements and sources). Returns GUSSET_PLUGIN_DONE, GUSSET_PLUGIN_CANCELLED, or another gusset_status of
    /// gusset.h.
    int32_t (*apply)(const struct gusset_outputs *outputs,
                     uint32_t index,
                     const struct gusset_host *host,
                     const struct gusset_plugin_channel *channel,
                     const struct gusset_plugin_channel_values *inputs,
                     uint32_t input_count,
                     void *values,
                     size_t count,
                     size_t stride,
                     struct gusset_failure *failure);
} gusset_plugin_attributes;

/* ---- Filters: Structs and constants of the tables. */

/// The version of this header's tables, for gusset_plugin_entry.
#define GUSSET_PLUGIN_ABI 1

/// What run returns after success.
#define GUSSET_PLUGIN_DONE 0
/// What run returns when a parameter is out of its range, or an input is of the wrong kind.
#define GUSSET_PLUGIN_OUT_OF_RANGE 5
/// What run returns when memory could not be had.
#define GUSSET_PLUGIN_OUT_OF_MEMORY 2000
/// What run returns when the host's progress callback asked to stop.
#define GUSSET_PLUGIN_CANCELLED 2001

/// A polygon mesh: struct gusset_plugin_mesh.
#define GUSSET_KIND_MESH 1
/// Polylines: struct gusset_plugin_curves.
#define GUSSET_KIND_CURVES 2
/// Lines of text for a log window; an output only.
#define GUSSET_KIND_TEXT 3
/// Coordinates are 32-bit floats.
#define GUSSET_PLUGIN_F32 1
/// Coordinates are 64-bit floats.
#define GUSSET_PLUGIN_F64 2
/// 0 or 1.
#define GUSSET_PARAM_BOOL 1
/// A whole number.
#define GUSSET_PARAM_INT 2
/// A number without a unit.
#define GUSSET_PARAM_REAL 3
/// The place of one of the choices, from 0.
#define GUSSET_PARAM_CHOICE 4
/// A length, in the unit of the positions.
#define GUSSET_PARAM_LENGTH 5
/// An angle, in radians.
#define GUSSET_PARAM_ANGLE 6
/// A point: x, y, z.
#define GUSSET_PARAM_POINT 7
/// A direction: x, y, z, not all 0; its length means nothing.
#define GUSSET_PARAM_DIRECTION 8
/// A plane a x + b y + c z = d: a, b, c, d, the first three not all 0.
#define GUSSET_PARAM_PLANE 9
/// The first output is the first input, mended: an editor puts it in its place. Else outputs are new.
#define GUSSET_FILTER_REPLACES 1
/// The vertices, corners and faces of the first output, a mesh, come from those of the inputs, and
/// extension("attributes/1") carries over what they have.
#define GUSSET_FILTER_ORIGINS 2
/// gusset_failure.input, gusset_failure.param: none.
#define GUSSET_PLUGIN_NONE UINT32_MAX

/// The polygon mesh of an input or of an output; laid out like gusset_mesh_view of gusset.h, and under the same rules.
/// Arrays may have any alignment and are not copied on the way in.
typedef struct gusset_plugin_mesh {
    size_t struct_size;
    /// x, y, z at the start of every stride, of the type that scalar names. Finite where faces use them.
    const void *positions;
    /// Bytes from one position to the next; 0 if they are packed.
    size_t position_stride;
    /// The number of vertices; 1 to 2^32 - 2.
    size_t vertex_count;
    /// face_count + 1 32-bit entries from 0: face f has the corners face_offsets[f] to face_offsets[f + 1] - 1. NULL if
    /// face_size is given. Outputs have it.
    const void *face_offsets;
    /// The vertex at each corner, 32-bit, face after face.
    const void *face_corners;
    /// The number of faces; at least 1 in an input.
    size_t face_count;
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64. Zero is no valid value: it must be said.
    uint32_t scalar;
    /// 0: indices are 32-bit unsigned integers.
    uint32_t index;
    /// The number of corners of every face, or 0 if face_offsets is given.
    uint32_t face_size;
    uint32_t reserved;
    /// For each vertex the one that it is one with, itself or one that is one with itself; 32-bit; NULL if none is one
    /// with another. Vertices that are kept apart for their texture coordinates or normals leave no border then.
    const void *merge;
} gusset_plugin_mesh;

/// The polylines of an input or of an output. Curve c has the points offsets[c] to offsets[c + 1] - 1 and, if it is
/// closed, an edge from the last to the first.
typedef struct gusset_plugin_curves {
    size_t struct_size;
    /// x, y, z at the start of every stride, of the type that scalar names. Finite. Outputs are packed 64-bit floats.
    const void *points;
    /// Bytes from one point to the next; 0 if they are packed.
    size_t point_stride;
    /// The number of points; at most 2^32 - 2.
    size_t point_count;
    /// curve_count + 1 32-bit entries from 0 to point_count, none less than the one before. May be NULL if curve_count
    /// is 0.
    const void *offsets;
    /// For each curve a byte: 0 open, 1 closed. NULL if all are open.
    const uint8_t *closed;
    /// The number of curves; at most 2^32 - 2.
    size_t curve_count;
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64.
    uint32_t scalar;
    uint32_t reserved;
} gusset_plugin_curves;

/// One input of a filter.
typedef struct gusset_input {
    size_t struct_size;
    /// A struct gusset_plugin_mesh or gusset_plugin_curves, as kind says.
    const void *view;
    /// GUSSET_KIND_MESH or GUSSET_KIND_CURVES.
    uint32_t kind;
    uint32_t reserved;
} gusset_input;

/// How a host follows and steers a run. Callbacks come from the thread that called run, must not call into the plugin
/// for the same outputs, and must not throw.
typedef struct gusset_host {
    size_t struct_size;
    /// Handed to the callbacks.
    void *user;
    /// Called now and then during long work, or NULL. fraction: the part done, 0 to 1, never decreasing. stage: what is
    /// being done, valid during the callback only. Nonzero cancels: run returns GUSSET_PLUGIN_CANCELLED soon after:
    /// within a tenth of a second for a million faces or points that go in and come out; giving back the memory of many
    /// more takes longer.
    int32_t (*progress)(void *user, double fraction, const char *stage);
    /// Called with remarks that are no failures, or NULL; message is valid during the callback only.
    void (*log)(void *user, const char *message);
    /// 0 as many threads as the machine has, 1 the calling thread only. Results do not depend on it.
    uint32_t threads;
    /// 1: outputs tell where their elements come from, for extension("attributes/1"), if the filter has
    /// GUSSET_FILTER_ORIGINS. 0: they do not, which saves time and memory.
    uint32_t origins;
} gusset_host;

/// One choice of a parameter. Texts are UTF-8, static.
typedef struct gusset_choice {
    /// For menus.
    const char *label;
    /// What it does.
    const char *help;
} gusset_choice;

/// A parameter of a filter. Texts are UTF-8, static.
typedef struct gusset_param_info {
    size_t struct_size;
    /// Stable for ever: scripts and stored projects name it.
    const char *id;
    /// For dialogs.
    const char *label;
    /// What it does, in whole sentences.
    const char *help;
    /// One of GUSSET_PARAM_...
    uint32_t kind;
    /// How many values it has: 3 for points and directions, 4 for planes, else 1.
    uint32_t arity;
    /// The least value of each component.
    double min;
    /// The greatest value of each component.
    double max;
    /// arity values. What suggest says suits the inputs better.
    const double *default_values;
    /// What a spin box adds; 0 if the host may choose.
    double step;
    /// choice_count choices; NULL if kind is not GUSSET_PARAM_CHOICE.
    const struct gusset_choice *choices;
    /// The number of choices.
    uint32_t choice_count;
    /// Where its first value is among the values of the filter.
    uint32_t first_value;
} gusset_param_info;

/// One capability of the plugin. Texts are UTF-8, static; so is the struct. Its functions may be called from many
/// threads at once; filter is the struct that they are in.
typedef struct gusset_filter {
    size_t struct_size;
    /// Stable for ever: hosts store it.
    const char *id;
    /// For menus.
    const char *name;
    /// For scripts: lower case, words joined by underscores.
    const char *script_name;
    /// The group that a host shows it in.
    const char *category;
    /// What it does, in whole sentences.
    const char *help;
    /// Where the method comes from.
    const char *reference;
    /// The kind of each input, GUSSET_KIND_...; the last repeats. input_kind_count of them.
    const uint32_t *input_kinds;
    /// The kind of each output, in order; output_count of them.
    const uint32_t *output_kinds;
    /// The number of input_kinds; 0 for filters that make something of nothing.
    uint32_t input_kind_count;
    /// The least number of inputs.
    uint32_t min_inputs;
    /// The greatest number of inputs.
    uint32_t max_inputs;
    /// The number of outputs.
    uint32_t output_count;
    /// GUSSET_FILTER_... or 0.
    uint32_t flags;
    /// The number of parameters.
    uint32_t param_count;
    /// The number of values of all parameters.
    uint32_t value_count;
    uint32_t reserved;
    /// Parameter index, 0 to param_count - 1; NULL for any other.
    const struct gusset_param_info *(*param)(const struct gusset_filter *filter, uint32_t index);
    /// Writes the values that suit these inputs, one parameter after the other; values has room for value_count of
    /// them, and holds the plain defaults after a failure, of which suggest gives no account: run with the same inputs
    /// does. Inputs as for run. O(size of the inputs). Returns GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    int32_t (*suggest)(const struct gusset_filter *filter,
                       const struct gusset_input *inputs,
                       uint32_t input_count,
                       double *values);
    /// Runs the filter. host: NULL for no callbacks and automatic threads. inputs: input_count structs. values: the
    /// first value_count values of the parameters, one parameter after the other; the rest is as suggest has it.
    /// outputs: receives what came out, and after a failure an account of it (output_failure); give it to output_free
    /// in any case. NULL only if outputs itself is NULL or memory ran out. Returns GUSSET_PLUGIN_DONE,
    /// GUSSET_PLUGIN_CANCELLED, or another gusset_status of gusset.h.
    int32_t (*run)(const struct gusset_filter *filter,
                   const struct gusset_host *host,
                   const struct gusset_input *inputs,
                   uint32_t input_count,
                   const double *values,
                   uint32_t value_count,
                   struct gusset_outputs **outputs);
} gusset_filter;

/// Why a run failed.
typedef struct gusset_failure {
    size_t struct_size;
    /// What went wrong, an English sentence; empty after success. Lives as long as the outputs.
    const char *message;
    /// What run returned.
    int32_t status;
    /// The number of the parameter that is out of range, or GUSSET_PLUGIN_NONE.
    uint32_t param;
    /// The number of the input that is at fault, or GUSSET_PLUGIN_NONE.
    uint32_t input;
    /// What index counts, a GUSSET_ELEMENT_... of gusset.h: 0 nothing, 1 vertices, 2 faces, 3 corners, 4 entries of
    /// face_offsets, 5 places in a loop, 6 nothing either: index is itself a count of elements or bytes; 7 points of
    /// all curves, 8 constraints on an outline, 9 places on a curve or a surface, 12 sections or planes, 13 nodes of a
    /// net, row after row, 14 its links (twice the first node, and 1 if vertical), 15 its cells, row after row, 16
    /// seams, 17 bridges, 18 entries of a scene, 19 bytes of a stream, 20 places along the side of a net, 21 other
    /// items given, 30 knots, 31 rows of a net of curves. Later versions may have more.
    uint32_t element;
    /// The first offending element.
    uint64_t index;
    /// Its value where it has one.
    double value;
} gusset_failure;

/// What the plugin is and can do. Texts are UTF-8, static; so is the struct. Its functions may be called from many
/// threads at once.
typedef struct gusset_plugin {
    size_t struct_size;
    /// GUSSET_PLUGIN_ABI of the plugin.
    uint32_t abi;
    /// The number of filters.
    uint32_t filter_count;
    /// Stable for ever.
    const char *id;
    /// For people.
    const char *name;
    /// "major.minor.patch".
    const char *version;
    /// Who makes it.
    const char *vendor;
    /// One sentence.
    const char *description;
    /// An SPDX licence expression.
    const char *license;
    /// Filter index, 0 to filter_count - 1, in the order for menus; NULL for any other.
    const struct gusset_filter *(*filter)(uint32_t index);
    /// The filter of this id, or NULL.
    const struct gusset_filter *(*find)(const char *id);
    /// How many outputs there are: as many as the filter says after success, else 0.
    uint32_t (*output_count)(const struct gusset_outputs *outputs);
    /// The kind of output index, GUSSET_KIND_...; 0 if there is none.
    uint32_t (*output_kind)(const struct gusset_outputs *outputs, uint32_t index);
    /// Fills mesh, whose struct_size is set, with the arrays of output index, which live as long as the outputs.
    /// Returns GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    int32_t (*output_mesh)(const struct gusset_outputs *outputs, uint32_t index, struct gusset_plugin_mesh *mesh);
    /// The same for curves.
    int32_t (*output_curves)(const struct gusset_outputs *outputs, uint32_t index, struct gusset_plugin_curves *curves);
    /// The text of output index, UTF-8, which lives as long as the outputs; NULL if it is none.
    const char *(*output_text)(const struct gusset_outputs *outputs, uint32_t index);
    /// Why the run failed. failure: its struct_size is set. Returns GUSSET_PLUGIN_DONE or a gusset_status of gusset.h.
    int32_t (*output_failure)(const struct gusset_outputs *outputs, struct gusset_failure *failure);
    /// Frees the outputs of a run; NULL is allowed.
    void (*output_free)(struct gusset_outputs *outputs);
    /// Something beyond these tables, by name and version, or NULL: "values/1" is a gusset_plugin_values,
    /// "attributes/1" a gusset_plugin_attributes.
    const void *(*extension)(const char *name);
} gusset_plugin;

/// The numbers in a text under names, for programs: extension("values/1"). The struct is static; the functions may be
/// called from many threads at once.
typedef struct gusset_plugin_values {
    size_t struct_size;
    /// How many numbers output index has; 0 if it is no text or has none.
    uint32_t (*count)(const struct gusset_outputs *outputs, uint32_t index);
    /// The name of number which: lower case, words joined by underscores, the same in all versions; lives as long as
    /// the outputs. NULL if there is none.
    const char *(*name)(const struct gusset_outputs *outputs, uint32_t index, uint32_t which);
    /// Number which; NaN if there is none. Flags are 0 or 1, angles in radians.
    double (*value)(const struct gusset_outputs *outputs, uint32_t index, uint32_t which);
} gusset_plugin_values;

/// The type of gusset_plugin_entry, for dlsym.
typedef const struct gusset_plugin *(*gusset_plugin_entry_fn)(uint32_t host_abi);

/* ---- What becomes of a run: outputs, or why there are none. */

/// What a run left: its outputs, or why there are none. Opaque; may be read from many threads at once.
typedef struct gusset_outputs gusset_outputs;

#ifdef __cplusplus
}
#endif

#endif /* GUSSET_PLUGIN_H */
