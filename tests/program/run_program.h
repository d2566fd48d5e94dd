#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Runs the program as a person would.
namespace seamline::test {

struct Outcome {
  int status = -1;
  std::string output;  ///< standard output and standard error together
};

inline Outcome run_program(const std::string& program, const std::string& arguments) {
  const std::string command = program + " " + arguments + " 2>&1 </dev/null";
  Outcome outcome;
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
    outcome.output.append(block.data(), count);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

/// The program as it was built, started anew.
inline Outcome run_built(const std::string& arguments) {
  return run_program(SEAMLINE_PROGRAM, arguments);
}

/// What the caller gives the program for its two outputs; those that are not kept are in no Outcome.
enum class Outputs {
  kept,
  full,         ///< standard output leads to a disk without room
  closed,       ///< standard output is no open descriptor
  both_closed,  ///< nor is standard error
};

/// The program's own command line in a process that has loaded everything already (program_process.cpp): most
/// of what is asked of the program takes less time than its start.
Outcome run_seamline(const std::string& arguments, Outputs outputs = Outputs::kept);

inline void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A command as its words are typed: "lab bench" is two.
inline std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

inline std::string read_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// A fresh folder for one test's files.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

/// The study files that come with Seamline.
inline std::filesystem::path studies() {
  return std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli";
}

/// A text with some of it replaced, each once; throws when it is not there.
inline std::string with_replaced(std::string text,
                                 std::initializer_list<std::pair<std::string, std::string>> replacements) {
  for (const auto& [from, to] : replacements) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the text has no " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

inline std::string quick_study_with(std::initializer_list<std::pair<std::string, std::string>> replacements) {
  return with_replaced(read_text(studies() / "quick.toml"), replacements);
}

/// The quick study's scenes in a small picture, with coarse meshes and a cube for every object: a render
/// takes a moment.
inline std::string small_study_with(std::initializer_list<std::pair<std::string, std::string>> replacements) {
  std::string text = quick_study_with(replacements);
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  };
  replace("width_px = 480", "width_px = 96");
  replace("height_px = 270", "height_px = 54");
  replace("mesh_tolerance = 1e-4", "mesh_tolerance = 1e-2");
  for (const char* object : {"statue", "teapot", "creature", "beast", "lion", "dragon"})
    replace("builtin:" + std::string(object), "cube.gltf");
  return text;
}

/// A glTF file and its buffer, on the ground around the origin.
inline void write_cube(const std::filesystem::path& folder, float half_side_m = 0.3F) {
  std::string bytes;
  const auto put = [&](auto value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis)
      put((i >> axis & 1) != 0 ? half_side_m * (axis == 1 ? 2 : 1) : (axis == 1 ? 0 : -half_side_m));
  for (const int index : {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                          2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3})
    put(static_cast<std::uint16_t>(index));
  write_text(folder / "cube.bin", bytes);
  write_text(
      folder / "cube.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":168,"uri":"cube.bin"}],"bufferViews":[{"buffer":0,"byteLength":96},)"
      R"({"buffer":0,"byteOffset":96,"byteLength":72}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":8},)"
      R"({"bufferView":1,"componentType":5123,"type":"SCALAR","count":36}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},)"
      R"("indices":1}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})");
}

/// A study file and the cube that it names.
inline void write_small_study(const std::filesystem::path& folder, const std::string& text) {
  write_cube(folder);
  write_text(folder / "study.toml", text);
}

}  // namespace seamline::test
