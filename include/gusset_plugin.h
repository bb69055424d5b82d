/* gusset as a plugin. Generated from src/capi/plugin.
 *
 * gusset_plugin_entry leads to filters with typed parameters, from meshes or curves to meshes, curves or text:
 *     void *library = dlopen("libgusset.so.0.1", RTLD_NOW | RTLD_LOCAL);
 *     gusset_plugin_entry_fn entry = NULL;
 *     if (library) *(void **)&entry = dlsym(library, "gusset_plugin_entry");
 *     const gusset_plugin *plugin = entry ? entry(GUSSET_PLUGIN_ABI) : NULL;
 *     const gusset_filter *filter = plugin ? plugin->find("weld") : NULL;
 *
 * The host sets struct_size to sizeof the struct, and unused fields to 0. In the plugin's structs, struct_size tells
 * which fields exist: later versions may append some.
 * Counts are in elements, strides in bytes (0: packed), angles in radians, lengths in the unit of the positions.
 * Indices begin at 0. Part k of an array has the elements offsets[k] to offsets[k + 1] - 1; there is one offset more
 * than parts. Arrays of meshes, curves and channels may have any alignment.
 * Tables are static, texts UTF-8, ids permanent. Any thread may call functions and read outputs.
 * Arrays and texts of outputs live until output_free. Functions return NULL for an unknown index or name.
 * int32_t results are GUSSET_PLUGIN_DONE or another gusset_status of gusset.h, which a host does not need.
 * C99 or later, C++11 or later. */

#ifndef GUSSET_PLUGIN_H
#define GUSSET_PLUGIN_H
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_PLUGIN_MUST_USE __attribute__((warn_unused_result))
#define GUSSET_PLUGIN_API __attribute__((visibility("default")))
#else
#define GUSSET_PLUGIN_MUST_USE
#define GUSSET_PLUGIN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*** Entry */

struct gusset_plugin;

/// Returns the plugin's tables, or NULL if it cannot serve host_abi, the host's GUSSET_PLUGIN_ABI. The first call makes
/// them; any thread may call it. Nothing needs initialisation or release; the library stays loaded after dlclose.
GUSSET_PLUGIN_API GUSSET_PLUGIN_MUST_USE const struct gusset_plugin *gusset_plugin_entry(uint32_t host_abi);

/*** Attributes */

/// Vertices.
#define GUSSET_PLUGIN_VERTICES 0
/// Corners, as in face_corners.
#define GUSSET_PLUGIN_CORNERS 1
/// Faces.
#define GUSSET_PLUGIN_FACES 2
/// 32-bit floats.
#define GUSSET_PLUGIN_VALUE_F32 1
/// 64-bit floats.
#define GUSSET_PLUGIN_VALUE_F64 2
/// 8-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U8 3
/// 16-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U16 4
/// 32-bit unsigned integers.
#define GUSSET_PLUGIN_VALUE_U32 5
/// Weighted mean; integers are rounded.
#define GUSSET_PLUGIN_RULE_LINEAR 0
/// Directions of three floats: mean on the sphere, of length 1. Faces turned over negate theirs.
#define GUSSET_PLUGIN_RULE_NORMAL 1
/// Skin weights: weighted mean; the max_influences largest, scaled to sum 1 or an integer type's largest value.
#define GUSSET_PLUGIN_RULE_SKIN_WEIGHTS 2
/// Value of the source with the largest weight.
#define GUSSET_PLUGIN_RULE_NEAREST 3
/// Texture coordinates. Corners of new faces get the mean if both sides are on one chart; else charts continue to a
/// seam in the middle.
#define GUSSET_PLUGIN_RULE_TEXTURE 4

/// Type of values, and rule that combines them. A single source's value stays bit for bit; elements without valued
/// sources get 0.
typedef struct gusset_plugin_channel {
    size_t struct_size;
    /// GUSSET_PLUGIN_VERTICES, _CORNERS or _FACES.
    uint32_t domain;
    /// GUSSET_PLUGIN_VALUE_...; 0 is invalid.
    uint32_t value_type;
    /// Values of an element, 1 to 4096.
    uint32_t components;
    /// GUSSET_PLUGIN_RULE_...
    uint32_t rule;
    /// Weights that GUSSET_PLUGIN_RULE_SKIN_WEIGHTS keeps; 0: all.
    uint32_t max_influences;
    uint32_t reserved;
} gusset_plugin_channel;

/// Values of one input's elements.
typedef struct gusset_plugin_channel_values {
    /// Components of each element; NULL with count 0 if lacking.
    const void *values;
    /// Vertices, corners or faces of the input.
    size_t count;
    size_t stride;
} gusset_plugin_channel_values;

/// Origins of an output's elements.
typedef struct gusset_plugin_origins {
    size_t struct_size;
    size_t count;
    /// Offsets into sources and weights, by element.
    const uint32_t *offsets;
    /// Elements, numbered through all inputs.
    const uint32_t *sources;
    /// Weight of each source, above 0, in all 1.
    const double *weights;
    size_t input_count;
    /// Offsets of inputs in this numbering.
    const uint32_t *starts;
} gusset_plugin_origins;

struct gusset_failure;

struct gusset_host;

struct gusset_outputs;

/// extension("attributes/1"): transfers attributes to outputs of runs with origins.
typedef struct gusset_plugin_attributes {
    size_t struct_size;
    /// Returns 1 if the output has origins, else 0.
    uint32_t (*has_origins)(const struct gusset_outputs *outputs, uint32_t index);
    /// Gets the origins of the output's elements of a domain.
    int32_t (*origins)(const struct gusset_outputs *outputs,
                       uint32_t index,
                       uint32_t domain,
                       struct gusset_plugin_origins *origins);
    /// Writes the values of the output's elements in O(elements and sources). host: as for run. inputs: one for each
    /// input of the run. values: room for count elements, at least the output's, apart from inputs. failure: receives
    /// the reason, with a static message; may be NULL.
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

/*** Filters */

/// Version of the tables.
#define GUSSET_PLUGIN_ABI 1

/// Success.
#define GUSSET_PLUGIN_DONE 0
/// A parameter is outside its range, or an input of the wrong kind.
#define GUSSET_PLUGIN_OUT_OF_RANGE 5
/// Memory ran out.
#define GUSSET_PLUGIN_OUT_OF_MEMORY 2000
/// The progress callback cancelled the run.
#define GUSSET_PLUGIN_CANCELLED 2001

/// Polygon mesh: gusset_plugin_mesh.
#define GUSSET_KIND_MESH 1
/// Polylines: gusset_plugin_curves.
#define GUSSET_KIND_CURVES 2
/// Lines of text for a log window; outputs only.
#define GUSSET_KIND_TEXT 3
/// Coordinates as 32-bit floats.
#define GUSSET_PLUGIN_F32 1
/// Coordinates as 64-bit floats.
#define GUSSET_PLUGIN_F64 2
/// 0 or 1.
#define GUSSET_PARAM_BOOL 1
/// Whole number.
#define GUSSET_PARAM_INT 2
/// Number without unit.
#define GUSSET_PARAM_REAL 3
/// Index of a choice.
#define GUSSET_PARAM_CHOICE 4
/// Length.
#define GUSSET_PARAM_LENGTH 5
/// Angle.
#define GUSSET_PARAM_ANGLE 6
/// Point x, y, z.
#define GUSSET_PARAM_POINT 7
/// Direction x, y, z, not all 0, of any length.
#define GUSSET_PARAM_DIRECTION 8
/// Plane a x + b y + c z = d: a, b, c (not all 0), d.
#define GUSSET_PARAM_PLANE 9
/// Report value: whole.
#define GUSSET_VALUE_COUNT 1
/// Report value: 0 or 1.
#define GUSSET_VALUE_FLAG 2
/// Report value: without unit, or in its own.
#define GUSSET_VALUE_NUMBER 3
/// Report value: length in the unit of the positions.
#define GUSSET_VALUE_LENGTH 4
/// Report value: area in the square of that unit.
#define GUSSET_VALUE_AREA 5
/// Report value: volume in the cube of that unit.
#define GUSSET_VALUE_VOLUME 6
/// Report value: angle in radians.
#define GUSSET_VALUE_ANGLE 7
/// The first output replaces the first input, else outputs are new.
#define GUSSET_FILTER_REPLACES 1
/// The first output, a mesh, has elements of the inputs, for extension("attributes/1").
#define GUSSET_FILTER_ORIGINS 2
/// No input or parameter.
#define GUSSET_PLUGIN_NONE UINT32_MAX

/// Polygon mesh, with the rules of gusset_mesh_view in gusset.h. Inputs are not copied.
typedef struct gusset_plugin_mesh {
    size_t struct_size;
    /// x, y, z; finite at vertices of faces.
    const void *positions;
    size_t position_stride;
    /// 1 to 2^32 - 2.
    size_t vertex_count;
    /// Offsets into face_corners, by face. NULL with face_size, not in outputs.
    const void *face_offsets;
    /// Vertex of each corner, face by face.
    const void *face_corners;
    /// At least 1 in an input.
    size_t face_count;
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64, not 0.
    uint32_t scalar;
    /// 0: corners, offsets and merge are 32-bit unsigned integers.
    uint32_t index;
    /// Corners of every face, or 0 with face_offsets.
    uint32_t face_size;
    uint32_t reserved;
    /// Representative of each vertex, itself or one that represents itself; NULL: all are separate. Vertices with one
    /// representative are one, so that seams are not borders.
    const void *merge;
} gusset_plugin_mesh;

/// Polylines. If closed, the last point joins the first.
typedef struct gusset_plugin_curves {
    size_t struct_size;
    /// Finite x, y, z. Outputs are packed 64-bit floats.
    const void *points;
    size_t point_stride;
    /// At most 2^32 - 2.
    size_t point_count;
    /// 32-bit offsets into points, by curve; may be NULL without curves.
    const void *offsets;
    /// For each curve, 1 if closed; NULL: all open.
    const uint8_t *closed;
    /// At most 2^32 - 2.
    size_t curve_count;
    /// GUSSET_PLUGIN_F32 or GUSSET_PLUGIN_F64.
    uint32_t scalar;
    uint32_t reserved;
} gusset_plugin_curves;

/// Input of a filter. All inputs of a call have one struct_size.
typedef struct gusset_input {
    size_t struct_size;
    /// A gusset_plugin_mesh or gusset_plugin_curves.
    const void *view;
    /// GUSSET_KIND_MESH or GUSSET_KIND_CURVES.
    uint32_t kind;
    uint32_t reserved;
} gusset_input;

/// Callbacks and settings of a call. Callbacks run on the calling thread, with texts valid meanwhile. They must not
/// throw, or pass the call's outputs to the plugin.
typedef struct gusset_host {
    size_t struct_size;
    /// First argument of the callbacks.
    void *user;
    /// Receives the part done, 0 to 1, nondecreasing, at last 1 if the run succeeds, and the current work; may be NULL.
    /// A nonzero return cancels: run ends within 0.1 s for 1,000,000 input and output faces or points; freeing more
    /// takes longer.
    int32_t (*progress)(void *user, double fraction, const char *stage);
    /// Receives remarks that are not failures; may be NULL.
    void (*log)(void *user, const char *message);
    /// 0: all of the machine; 1: the calling thread. Results do not depend on it.
    uint32_t threads;
    /// 1: outputs get origins, with GUSSET_FILTER_ORIGINS; 0 saves time and memory.
    uint32_t origins;
} gusset_host;

/// Choice of a parameter.
typedef struct gusset_choice {
    /// Menu text.
    const char *label;
    /// Its effect.
    const char *help;
} gusset_choice;

/// Parameter of a filter.
typedef struct gusset_param_info {
    size_t struct_size;
    /// Identifier for scripts and projects.
    const char *id;
    /// Dialog text.
    const char *label;
    /// Description in whole sentences.
    const char *help;
    /// GUSSET_PARAM_...
    uint32_t kind;
    /// Points, directions: 3; planes: 4; else 1.
    uint32_t arity;
    /// Least value of each component.
    double min;
    /// Greatest value of each component.
    double max;
    /// arity values; suggest adapts them to the inputs.
    const double *default_values;
    /// Spin box increment; 0: the host's choice.
    double step;
    /// NULL unless kind is GUSSET_PARAM_CHOICE.
    const struct gusset_choice *choices;
    uint32_t choice_count;
    /// Its first value among the filter's values.
    uint32_t first_value;
} gusset_param_info;

/// Filter. Its functions take this struct.
typedef struct gusset_filter {
    size_t struct_size;
    /// Identifier, for hosts to store.
    const char *id;
    /// Menu text.
    const char *name;
    /// Name for scripts, in snake_case.
    const char *script_name;
    /// Menu group.
    const char *category;
    /// Description in whole sentences.
    const char *help;
    /// Source of the method.
    const char *reference;
    /// GUSSET_KIND_... of each input; the last repeats.
    const uint32_t *input_kinds;
    /// GUSSET_KIND_... of each output.
    const uint32_t *output_kinds;
    /// 0 for filters without inputs.
    uint32_t input_kind_count;
    /// Least inputs.
    uint32_t min_inputs;
    /// Most inputs.
    uint32_t max_inputs;
    uint32_t output_count;
    /// GUSSET_FILTER_... or 0.
    uint32_t flags;
    uint32_t param_count;
    /// Values of all parameters.
    uint32_t value_count;
    uint32_t reserved;
    /// Returns a parameter by its index.
    const struct gusset_param_info *(*param)(const struct gusset_filter *filter, uint32_t index);
    /// Writes value_count defaults that suit the inputs, in O(their size). After a failure, writes plain defaults; run
    /// tells the reason.
    int32_t (*suggest)(const struct gusset_filter *filter,
                       const struct gusset_input *inputs,
                       uint32_t input_count,
                       double *values);
    /// Runs the filter. host: NULL for no callbacks and all threads. values: the first value_count; suggest gives the
    /// rest. outputs: receives the outputs or the reason of a failure, to be freed by output_free; NULL only if memory
    /// ran out.
    int32_t (*run)(const struct gusset_filter *filter,
                   const struct gusset_host *host,
                   const struct gusset_input *inputs,
                   uint32_t input_count,
                   const double *values,
                   uint32_t value_count,
                   struct gusset_outputs **outputs);
} gusset_filter;

/// Reason of a failure.
typedef struct gusset_failure {
    size_t struct_size;
    /// English sentence; empty after success.
    const char *message;
    /// Status of the run.
    int32_t status;
    /// Parameter outside its range, or GUSSET_PLUGIN_NONE.
    uint32_t param;
    /// Faulty input, or GUSSET_PLUGIN_NONE.
    uint32_t input;
    /// Kind of element, GUSSET_ELEMENT_... of gusset.h: 0 none, 1 vertex, 2 face, 3 corner, 4 offset, 5 place in a
    /// loop, 6 none (index is a count), 7 point of all curves, 8 constraint on an outline, 9 place on a curve or
    /// surface, 12 section or plane, 13 net node by rows, 14 net link (twice its first node, plus 1 if vertical), 15
    /// net cell by rows, 16 seam, 17 bridge, 18 scene entry, 19 stream byte, 20 place along a net side, 21 other given
    /// item, 30 knot, 31 row of a net of curves, 32 edge of a winged-edge table. Later versions may add kinds.
    uint32_t element;
    /// First faulty element.
    uint64_t index;
    /// Its value, if any.
    double value;
} gusset_failure;

/// Tables and functions of the plugin.
typedef struct gusset_plugin {
    size_t struct_size;
    /// GUSSET_PLUGIN_ABI of the plugin.
    uint32_t abi;
    uint32_t filter_count;
    /// Identifier.
    const char *id;
    /// Name for people.
    const char *name;
    /// "major.minor.patch".
    const char *version;
    /// Its makers.
    const char *vendor;
    /// One sentence.
    const char *description;
    /// SPDX licence expression.
    const char *license;
    /// Returns a filter by its index, in menu order.
    const struct gusset_filter *(*filter)(uint32_t index);
    /// Returns a filter by its id.
    const struct gusset_filter *(*find)(const char *id);
    /// Returns the filter's output_count after success, else 0.
    uint32_t (*output_count)(const struct gusset_outputs *outputs);
    /// Returns GUSSET_KIND_..., or 0.
    uint32_t (*output_kind)(const struct gusset_outputs *outputs, uint32_t index);
    /// Lends the arrays of an output mesh.
    int32_t (*output_mesh)(const struct gusset_outputs *outputs, uint32_t index, struct gusset_plugin_mesh *mesh);
    /// Lends the arrays of output curves.
    int32_t (*output_curves)(const struct gusset_outputs *outputs, uint32_t index, struct gusset_plugin_curves *curves);
    /// Returns the text, or NULL.
    const char *(*output_text)(const struct gusset_outputs *outputs, uint32_t index);
    /// Gets the reason of the run's failure.
    int32_t (*output_failure)(const struct gusset_outputs *outputs, struct gusset_failure *failure);
    /// Frees outputs; NULL is allowed.
    void (*output_free)(struct gusset_outputs *outputs);
    /// Returns gusset_plugin_values for "values/1", gusset_plugin_attributes for "attributes/1".
    const void *(*extension)(const char *name);
} gusset_plugin;

/// extension("values/1"): named numbers of a text output.
typedef struct gusset_plugin_values {
    size_t struct_size;
    /// Returns the number of numbers; 0 for other outputs.
    uint32_t (*count)(const struct gusset_outputs *outputs, uint32_t index);
    /// Returns the name of number which, in snake_case, equal in all versions.
    const char *(*name)(const struct gusset_outputs *outputs, uint32_t index, uint32_t which);
    /// Returns number which, or NaN; flags are 0 or 1.
    double (*value)(const struct gusset_outputs *outputs, uint32_t index, uint32_t which);
    /// Returns GUSSET_VALUE_... of number which, or 0. Later versions may add kinds. Plugins whose struct_size ends
    /// before it lack it.
    uint32_t (*kind)(const struct gusset_outputs *outputs, uint32_t index, uint32_t which);
} gusset_plugin_values;

/// Type of gusset_plugin_entry, for dlsym.
typedef const struct gusset_plugin *(*gusset_plugin_entry_fn)(uint32_t host_abi);

/*** Outputs */

/// Outputs of a run, or the reason of its failure.
typedef struct gusset_outputs gusset_outputs;

#ifdef __cplusplus
}
#endif
#endif
