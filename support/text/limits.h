#pragma once
#include <cstddef>
#include <cstdint>

/// How much a file from outside may ask for. Everything here is checked before memory is taken for it;
/// documentation/reference/limits.md says why each is what it is.
namespace seamline::limits {

/// A fuzzing build has smaller limits, so that small inputs reach them and each takes little time.
#ifdef SEAMLINE_FUZZING
inline constexpr std::int64_t fuzz_divisor = 4096;
#else
inline constexpr std::int64_t fuzz_divisor = 1;
#endif

inline constexpr std::int64_t mebibyte = std::int64_t{1} << 20;

// Files.
inline constexpr std::int64_t largest_study_file_bytes = 16 * mebibyte;
inline constexpr std::int64_t largest_text_file_bytes =
    256 * mebibyte;                                    ///< manifest, records, timings, SVG figure
inline constexpr std::int64_t most_stimuli = 200'000;  ///< of a study: a manifest holds a kilobyte of each
inline constexpr std::int64_t largest_csv_bytes = 64 * mebibyte;
inline constexpr std::int64_t largest_csv_rows = 1'000'000;
inline constexpr std::int64_t largest_csv_columns = 10'000;
inline constexpr std::int64_t largest_picture_file_bytes = 4096 * mebibyte;
inline constexpr std::int64_t largest_scene_file_bytes =
    4095 * mebibyte;  ///< glTF, and its buffers together; GLB's own lengths have 32 bits

// Pictures.
inline constexpr int largest_picture_side_px = 16384;
inline constexpr int largest_picture_channels = 16;
/// width * height * channels; as float 4 bytes each.
inline constexpr std::int64_t largest_picture_values = (std::int64_t{1} << 30) / fuzz_divisor;
/// Decoded bytes for each byte of the file. Deflate, the densest packing of EXR and PNG, has at most 1032.
inline constexpr std::int64_t largest_picture_expansion = 4096;

// Texts: recursive code needs stack for every level of nesting, and every value takes memory.
inline constexpr int deepest_text_nesting = 128;              ///< tables and arrays in JSON and TOML
inline constexpr int deepest_node_tree = 256;                 ///< glTF nodes
inline constexpr std::int64_t most_text_values = 10'000'000;  ///< in JSON and TOML; some 100 bytes each

// Logs.
inline constexpr int largest_log_value_bytes =
    64 << 20;  ///< a text or a row; a study file's text is the largest
inline constexpr int largest_log_sql_bytes = 1 << 20;  ///< of a statement, or of a table in the file's schema
inline constexpr std::size_t most_schema_entries = 1000;  ///< looked at; a log has some thirty

// What scenes are made of. In single precision sums, squares and areas of these are still finite.
inline constexpr double farthest_place_m = 1e9;  ///< of any coordinate, from the camera
inline constexpr double strongest_light =
    1e12;  ///< radiance W/m2/sr, irradiance W/m2, and pixels of photographs

// glTF.
inline constexpr std::int64_t largest_gltf_buffers = 1024;
inline constexpr std::int64_t most_gltf_pictures = 4096;  ///< and as many textures and samplers
inline constexpr std::int64_t largest_texture_file_bytes = 1024 * mebibyte;
inline constexpr std::int64_t largest_texture_bytes = 8192 * mebibyte / fuzz_divisor;  ///< of a file, decoded
/// Of a whole file, each mesh counted as often as nodes place it. W = 8192 at full density has 33,546,242.
inline constexpr std::int64_t largest_scene_vertices = 40'000'000 / fuzz_divisor;
inline constexpr std::int64_t largest_scene_triangles = 80'000'000 / fuzz_divisor;
inline constexpr std::int64_t largest_scene_meshes = 1'000'000 / fuzz_divisor;  ///< placed primitives

}  // namespace seamline::limits
