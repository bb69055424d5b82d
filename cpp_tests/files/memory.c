/* Readers and writers of files where memory runs out: each allocation of each call fails in turn, alone and with all after it. The call
 * returns the file, or says that memory ran out, and leaves nothing behind. Three inputs: small ones; large arrays, of which only blocks
 * that no reserve serves fail; and thousands of names, where some allocations fail with all after them.
 *     memory LIBRARY */
#include "../torture/memory.h"
#include "gusset_files.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Texts of a file, which grow. */
typedef struct {
    char *bytes;
    size_t size, room;
} text;

static const gusset_files *files;
static size_t failures, refused, resolved;

static void add(text *to, const char *format, ...) {
    char line[200];
    va_list values;
    va_start(values, format);
    const size_t length = (size_t)vsnprintf(line, sizeof line, format, values);
    va_end(values);
    if (to->size + length + 1 > to->room) {
        to->room = 2 * to->room + length + 4096;
        to->bytes = realloc(to->bytes, to->room);
    }
    memcpy(to->bytes + to->size, line, length + 1);
    to->size += length;
}

/* The input of a call. */
typedef struct {
    const char *name, *document;
    const void *bytes;
    size_t size;
    uint32_t flags;
} call;

/* The library of materials, and the last written file, which lists of scans name. */
static text library;
static gusset_file *written;

static int32_t load(void *user, const char *name, const uint8_t **bytes, size_t *size) {
    (void)user;
    if (strcmp(name, "scan.ply") == 0 && written != NULL) {
        *bytes = files->part_bytes(written, 1, size);
        return 0;
    }
    *bytes = (const uint8_t *)library.bytes;
    *size = library.size;
    return strcmp(name, "all.mtl") != 0;
}

/* Runs a call of which allocations `first` to `last` fail; how many it asked for in `requests`. */
static int32_t run(const call *made, long long first, long long last, long long *requests, gusset_file **result) {
    gusset_files_folder folder = {sizeof folder, NULL, load, NULL};
    atomic_store(&memory_requests, 0);
    atomic_store(&memory_last, last);
    atomic_store(&memory_first, first);
    const int32_t status =
        made->document != NULL
            ? files->write(made->name, made->document, made->bytes, made->size, &folder, made->flags, result)
            : files->read(made->name, made->bytes, made->size, &folder, made->flags, result);
    atomic_store(&memory_first, 0);
    *requests = atomic_load(&memory_requests);
    return status;
}

static int is_same(const gusset_file *a, const gusset_file *b) {
    if (files->part_count(a) != files->part_count(b)) {
        return 0;
    }
    for (uint32_t part = 0; part < files->part_count(a); ++part) {
        size_t sizes[2];
        const uint8_t *bytes[2] = {files->part_bytes(a, part, &sizes[0]), files->part_bytes(b, part, &sizes[1])};
        if (sizes[0] != sizes[1] || (sizes[0] > 0 && memcmp(bytes[0], bytes[1], sizes[0]) != 0)) {
            return 0;
        }
    }
    return 1;
}

/* Refuses the allocations of a call of at least `least` bytes in turn, at most `most` of them. Returns the result without refusals. */
static gusset_file *check(const call *made, size_t least, long long most, int is_alone) {
    long long all, requests;
    gusset_file *expected, *result;
    atomic_store(&memory_least, least);
    const int32_t usual = run(made, 0, 0, &all, &expected);
    if (usual != GUSSET_FILES_DONE) {
        printf("%s: %s\n", made->name, files->message(expected));
        ++failures;
        return expected;
    }
    const long long step = all > most ? all / most + 1 : 1;
    for (long long nth = 1; nth <= all; nth += step) {
        for (int after = is_alone ? 0 : 1; after < 2; ++after) {
            const long long live = atomic_load(&memory_live);
            const int32_t status = run(made, nth, after ? LLONG_MAX : nth, &requests, &result);
            const int is_right = status == GUSSET_FILES_DONE ? is_same(result, expected)
                                                             : status == GUSSET_FILES_OUT_OF_MEMORY &&
                                                                   strstr(files->message(result), "out of memory") != NULL;
            *(status == GUSSET_FILES_DONE ? &resolved : &refused) += 1;
            if (!is_right) {
                printf("%s: allocation %lld of %lld%s: status %d, %s\n", made->name, nth, all, after ? " and later" : "",
                       status, files->message(result));
                ++failures;
            }
            files->free(result);
            if (atomic_load(&memory_live) != live) {
                printf("%s: allocation %lld: %lld blocks stay\n", made->name, nth, atomic_load(&memory_live) - live);
                ++failures;
            }
        }
    }
    return expected;
}

/* Writes the content of an OBJ file in each format, and reads it back as a scene and as one mesh. */
static void check_formats(const text *obj, size_t least, long long most, int is_alone) {
    static const struct {
        const char *name;
        uint32_t flags;
    } formats[] = {{"a.obj", 0}, {"a.ply", 0},  {"a.ply", GUSSET_FILES_TEXT}, {"a.stl", 0}, {"a.stl", GUSSET_FILES_TEXT},
                   {"a.off", 0}, {"a.gltf", 0}, {"a.glb", 0},                 {"a.3mf", 0}, {"a.svg", 0},
                   {"a.dxf", 0}, {"a.csv", 0},  {"a.xyz", 0}};
    const call first = {"a.obj", NULL, obj->bytes, obj->size, 0};
    gusset_file *document = check(&first, least, most, is_alone);
    text description = {0};
    size_t size, arrays_size, file_size;
    const uint8_t *bytes = files->part_bytes(document, 0, &size);
    description.bytes = calloc(size + 1, 1);
    memcpy(description.bytes, bytes, size);
    const uint8_t *arrays = files->part_bytes(document, 1, &arrays_size);
    for (size_t i = 0; i < sizeof formats / sizeof *formats; ++i) {
        const call write = {formats[i].name, description.bytes, arrays, arrays_size, formats[i].flags | GUSSET_FILES_LOSSY};
        gusset_file *file = check(&write, least, most, is_alone);
        const uint8_t *content = files->part_bytes(file, 1, &file_size);
        for (uint32_t flags = 0; flags <= GUSSET_FILES_JOINED; ++flags) {
            const call read = {formats[i].name, NULL, content, file_size, flags};
            files->free(check(&read, least, most, is_alone));
        }
        if (i == 1) {
            static const char list[] = "bmesh scan.ply 0 0 0 0 0 0 1\nbmesh scan.ply 1 2 3 0 0.6 0 0.8\n";
            const call read = {"a.conf", NULL, list, sizeof list - 1, GUSSET_FILES_JOINED};
            written = file;
            files->free(check(&read, least, most, is_alone));
            written = NULL;
        }
        files->free(file);
    }
    files->free(document);
    free(description.bytes);
}

/* Makes objects, each a grid of `side` by `side` squares with normals and texture coordinates, which have a seam. */
static text grids(int objects, int side) {
    text made = {0};
    const int row = side + 1, count = row * row;
    add(&made, "mtllib all.mtl\n");
    for (int object = 0; object < objects; ++object) {
        add(&made, "o object %d\nusemtl material %d\n", object, object % 3 == 0 ? object : object - 1);
        for (int vertex = 0; vertex < count; ++vertex) {
            add(&made, "v %d %d %g 0.5 0.25 %g\nvt %g %g\nvn 0 0 1\n", vertex % row + 2 * side * object, vertex / row,
                0.1 * vertex, 1.0 / (1 + vertex), 1.0 / (1 + vertex), 0.1 * vertex);
        }
        for (int face = 0; face < side * side; ++face) {
            const int a = object * count + face / side * row + face % side + 1, b = a + 1, c = a + row + 1, d = a + row;
            if (face % 2 == 0) {
                add(&made, "f %d/%d/%d %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, b, b, b, c, c, c, d, d, d);
            } else {
                add(&made, "f %d/%d/%d %d/%d/%d %d/%d/%d\nf %d/%d/%d %d/%d/%d %d/%d/%d\n", a, b, a, b, b, b, c, c, c, a,
                    a, a, c, c, c, d, d, d);
            }
        }
    }
    const int first = objects * count + 1;
    add(&made, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nl %d %d %d %d %d\nl %d %d\np %d\n", first, first + 1, first + 2,
        first + 3, first, first, first + 2, first + 4);
    return made;
}

int main(int argc, char **argv) {
    void *opened = argc == 2 ? dlopen(argv[1], RTLD_NOW) : NULL;
    gusset_files_entry_fn entry = NULL;
    if (opened != NULL) {
        *(void **)&entry = dlsym(opened, "gusset_files_entry");
    }
    files = entry != NULL ? entry(GUSSET_FILES_ABI) : NULL;
    if (files == NULL) {
        return 2;
    }
    for (int material = 0; material < 2000; material += 1) {
        add(&library, "newmtl material %d\nKd 0.1 0.2 %g\nd 0.5\nmap_Kd image%d.png\n", material, 1.0 / (1 + material), material);
    }
    setvbuf(stdout, NULL, _IONBF, 0);
    const char *given = getenv("TORTURE_ALLOCATIONS");
    const long long most = given != NULL ? atoll(given) : 100;
    const size_t larger_than_reserve = 1 << 17;
    text inputs[3] = {grids(3, 2), grids(2, 90), grids(2000, 1)};
    check_formats(&inputs[0], 0, most, 1);
    check_formats(&inputs[1], larger_than_reserve, most, 1);
    check_formats(&inputs[2], 0, most / 20, 0);
    for (int input = 0; input < 3; ++input) {
        free(inputs[input].bytes);
    }
    free(library.bytes);
    printf("%zu calls without memory said so, %zu did without\n", refused, resolved);
    return failures == 0 && refused > 0 ? 0 : 1;
}
