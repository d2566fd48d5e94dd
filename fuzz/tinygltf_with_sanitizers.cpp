// The distribution's tinygltf knows no sanitizer; this one reads the same header and does.
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
