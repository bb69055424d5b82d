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

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_PLUGIN_MUST_USE __attribute__((warn_unused_result))
#define GUSSET_PLUGIN_API __attribute__((visibility("default")))
#else
#define GUSSET_PLUGIN_MUST_USE
#define GUSSET_PLUGIN_API
#endif
