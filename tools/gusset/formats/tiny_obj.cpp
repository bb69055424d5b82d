// The implementation of tinyobjloader, compiled once. Whoever includes the header defines the same scalar.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
