/* Files of meshes, curves and points. Generated from crates/gusset-files/src/table; do not edit.
 *
 * gusset_files_entry leads to functions that read and write files in memory, as a document: one JSON text and one
 * array of bytes. docs/guides/files.md describes the text. The library is for hosts in Python and WebAssembly.
 *
 * The host sets struct_size to sizeof the struct. Texts are UTF-8. Parts and messages live until free. int32_t results
 * are GUSSET_FILES_DONE or another status. C99 or later, C++11 or later. */

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_FILES_MUST_USE __attribute__((warn_unused_result))
#define GUSSET_FILES_API __attribute__((visibility("default")))
#else
#define GUSSET_FILES_MUST_USE
#define GUSSET_FILES_API
#endif
