#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/estimators/estimator.h"

namespace seamline::renderer {

/// Truth passes that one process made and others take instead of making them again:
/// `SET/truths/TRUTH-PIECE.pass`. Large (of a picture of 960 x 540 pixels about 200 MB), and removed when the
/// set is joined.
class SetTruths {
 public:
  explicit SetTruths(const std::filesystem::path& set_folder) : folder_(set_folder / "truths") {}

  /// `inputs` is the hash of what it was made from.
  void write(const std::string& truth, int piece, const std::string& inputs, const std::string& bytes) const;
  /// None when it is not there, not whole, or of other inputs: then it is made again.
  [[nodiscard]] std::optional<std::string> read(const std::string& truth, int piece,
                                                const std::string& inputs) const;
  /// Gives an estimator what `read` reads, where that is something. Throws InputError when the estimator
  /// cannot read it.
  void take(const std::string& truth, int piece, const std::string& inputs, SceneEstimator& estimator) const;
  /// Writes the pieces of an estimator's truth that are not there.
  void leave(const std::string& truth, const std::string& inputs, SceneEstimator& estimator,
             const ReportProgress& report) const;
  [[nodiscard]] bool has(const std::string& truth, int piece, const std::string& inputs) const;
  void remove_all() const;

 private:
  [[nodiscard]] std::filesystem::path path(const std::string& truth, int piece) const;
  std::filesystem::path folder_;
};

}  // namespace seamline::renderer
