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
