#include "sets/sharing/set_truths.h"

#include <array>
#include <fstream>

#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/limits.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t hash_digits = 64;
/// A file begins with two hashes: of what it was made from, and of what follows.
constexpr std::size_t head_bytes = 2 * hash_digits;

}  // namespace

fs::path SetTruths::path(const std::string& truth, int piece) const {
  return folder_ / (truth + "-" + std::to_string(piece) + ".pass");
}

void SetTruths::write(const std::string& truth, int piece, const std::string& inputs,
                      const std::string& bytes) const {
  prepare_output_folder(folder_);
  write_file_atomically(path(truth, piece), inputs + sha256(bytes) + bytes);
}

std::optional<std::string> SetTruths::read(const std::string& truth, int piece,
                                           const std::string& inputs) const {
  std::error_code error;
  if (!fs::is_regular_file(path(truth, piece), error)) return std::nullopt;
  std::string all;
  try {
    all = read_file(path(truth, piece), limits::largest_scene_file_bytes);
  } catch (const InputError&) {
    return std::nullopt;
  }
  if (all.size() < head_bytes || all.compare(0, hash_digits, inputs) != 0) return std::nullopt;
  const std::string expected = all.substr(hash_digits, hash_digits);
  all.erase(0, head_bytes);
  return sha256(all) == expected ? std::optional(std::move(all)) : std::nullopt;
}

void SetTruths::take(const std::string& truth, int piece, const std::string& inputs,
                     SceneEstimator& estimator) const {
  const std::optional<std::string> bytes = read(truth, piece, inputs);
  if (!bytes) return;
  ByteReader in(*bytes);
  if (!estimator.read_truth(piece, in))
    throw input_error({.file = folder_.string(),
                       .wanted = "truth passes of this program",
                       .found = "another's of " + truth + ": remove the folder"});
}

void SetTruths::leave(const std::string& truth, const std::string& inputs, SceneEstimator& estimator,
                      const ReportProgress& report) const {
  for (int piece = 1; piece <= estimator.truth_pieces(); ++piece) {
    if (has(truth, piece, inputs)) continue;
    ByteWriter out;
    estimator.write_truth(piece, out, report);
    write(truth, piece, inputs, out.bytes());
  }
}

bool SetTruths::has(const std::string& truth, int piece, const std::string& inputs) const {
  std::array<char, hash_digits> start{};
  std::ifstream in(path(truth, piece), std::ios::binary);
  in.read(start.data(), start.size());
  return in.gcount() == static_cast<std::streamsize>(start.size()) &&
         std::string_view(start.data(), start.size()) == inputs;
}

void SetTruths::remove_all() const {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(folder_, error))) fs::remove_all(folder_, error);
}

}  // namespace seamline::renderer
