/* Files of meshes, curves and points. Generated from crates/gusset-files/src/table.
 *
 * Functions read and write files in memory, as documents: JSON text and an array of bytes (docs/guides/files.md).
 *
 * Hosts set struct_size to sizeof the struct. Texts are UTF-8; parts and messages live until free; int32_t results are
 * statuses. C99 or later, C++11 or later. */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_FILES_MUST_USE __attribute__((warn_unused_result))
#define GUSSET_FILES_API __attribute__((visibility("default")))
#else
#define GUSSET_FILES_MUST_USE
#define GUSSET_FILES_API
#endif
