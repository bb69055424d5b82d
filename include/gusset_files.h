/* Files of meshes, curves and points. Generated from crates/gusset-files/src/table.
 *
 * Functions read and write files in memory, as documents: JSON text and an array of bytes (docs/guides/files.md).
 *
 * Hosts set struct_size to sizeof the struct. Texts are UTF-8; parts and messages live until free; int32_t results are
 * statuses. C99 or later, C++11 or later. */

#ifndef GUSSET_FILES_H
#define GUSSET_FILES_H
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GUSSET_FILES_MUST_USE __attribute__((warn_unused_result))
#define GUSSET_FILES_API __attribute__((visibility("default")))
#else
#define GUSSET_FILES_MUST_USE
#define GUSSET_FILES_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*** Entry */

struct gusset_files;

/// Returns the functions, or NULL if the library cannot serve host_abi, the host's GUSSET_FILES_ABI.
GUSSET_FILES_API GUSSET_FILES_MUST_USE const struct gusset_files *gusset_files_entry(uint32_t host_abi);

/*** Functions */

/// Version of the table.
#define GUSSET_FILES_ABI 1

/// Success.
#define GUSSET_FILES_DONE 0
/// An argument is NULL, or a text is not UTF-8.
#define GUSSET_FILES_BAD_ARGUMENT 1
/// The file or document breaks a rule, or the format is unknown or too narrow.
#define GUSSET_FILES_BAD_FILE 2
/// Memory ran out.
#define GUSSET_FILES_OUT_OF_MEMORY 3
/// An internal error.
#define GUSSET_FILES_INTERNAL 4

/// Flag of read: joins all meshes of a scene into one.
#define GUSSET_FILES_JOINED 1
/// Flag of read: keeps vertices of STL, DXF and glTF files at equal points apart.
#define GUSSET_FILES_UNMERGED 2
/// Flag of write: PLY and STL files as text.
#define GUSSET_FILES_TEXT 1
/// Flag of write: permits moves of over 0.001 mean edges by rounding.
#define GUSSET_FILES_LOSSY 2

/// Files that a file names: materials, buffers, images, scans.
typedef struct gusset_files_folder {
    size_t struct_size;
    /// First argument of load.
    void *user;
    /// Gets the bytes of a file beside it, until the next call or the function's end. Nonzero: none, or not to be read.
    int32_t (*load)(void *user, const char *name, const uint8_t **bytes, size_t *size);
    /// Path from a written file's folder to this one, such as "../scans", by which it names images. NULL: both are one.
    const char *seen_as;
} gusset_files_folder;

struct gusset_file;

/// Table of functions, for any thread.
typedef struct gusset_files {
    size_t struct_size;
    /// Reads a file of size bytes. name: its extension is the format. folder: may be NULL. flags: GUSSET_FILES_JOINED,
    /// GUSSET_FILES_UNMERGED or 0. Part 0 is the document's JSON text, part 1 its arrays; after a failure, *result has
    /// the message. O(size) time; memory at most 32 times all files.
    int32_t (*read)(const char *name,
                    const uint8_t *bytes,
                    size_t size,
                    const struct gusset_files_folder *folder,
                    uint32_t flags,
                    struct gusset_file **result);
    /// Writes a document, whose arrays have size bytes. flags: GUSSET_FILES_TEXT, GUSSET_FILES_LOSSY or 0. Part 0 is a
    /// JSON list of losses, part 1 the file, the rest files beside it.
    int32_t (*write)(const char *name,
                     const char *document,
                     const uint8_t *arrays,
                     size_t size,
                     const struct gusset_files_folder *folder,
                     uint32_t flags,
                     struct gusset_file **result);
    /// Returns the number of parts; 0 after a failure.
    uint32_t (*part_count)(const struct gusset_file *result);
    /// Returns the name of part which; NULL if it does not exist.
    const char *(*part_name)(const struct gusset_file *result, uint32_t which);
    /// Lends the bytes of part which; NULL if it does not exist or is empty.
    const uint8_t *(*part_bytes)(const struct gusset_file *result, uint32_t which, size_t *size);
    /// Returns the reason of a failure; empty after success.
    const char *(*message)(const struct gusset_file *result);
    /// Frees a result; NULL is allowed.
    void (*free)(struct gusset_file *result);
} gusset_files;

/// Type of gusset_files_entry, for dlsym.
typedef const struct gusset_files *(*gusset_files_entry_fn)(uint32_t host_abi);

/*** Results */

/// Parts of a file that was read or written, or the reason of a failure.
typedef struct gusset_file gusset_file;

#ifdef __cplusplus
}
#endif
#endif
