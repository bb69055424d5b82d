// The implementation of tinygltf, compiled once. The build defines which parts of it are left out.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
