#include "commands/planning/planning_commands.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "analysis/foresight/predict.h"
#include "analysis/report/text/predict_text.h"
#include "support/text/number_option.h"

namespace seamline::analysis {
namespace {

struct PredictOptions {
  std::string set_folder, none_set_folder;
  double gain = 0;  ///< 0: the study's
  bool calibrate = false;
  double pixels_per_degree = 0;  ///< 0: the study's
  int threads = 0;
  bool finest_is_floor = false;
};

void predict(const PredictOptions& options) {
  PredictionRequest request{.set_folder = options.set_folder,
                            .none_set_folder = options.none_set_folder,
                            .gain = std::nullopt,
                            .calibrate = options.calibrate,
                            .pixels_per_degree = std::nullopt,
                            .threads = options.threads,
                            .finest_is_floor = options.finest_is_floor};
  if (options.gain > 0) request.gain = options.gain;
  if (options.pixels_per_degree > 0) request.pixels_per_degree = options.pixels_per_degree;
  std::printf("%s", prediction_text(predict_thresholds(request)).c_str());
}

}  // namespace

void add_predict_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("predict", "thresholds predicted from a set's pictures, before anyone is asked");
  const auto options = std::make_shared<PredictOptions>();
  command->add_option("set", options->set_folder, "folder of the rendered set")->required();
  command->add_option("--none", options->none_set_folder,
                      "a set of the same scenes and objects rendered with the artifact none: the floor");
  command
      ->add_flag("--finest-is-floor", options->finest_is_floor,
                 "take what each object still shows at the last level for the grain of rendering")
      ->excludes("--none");
  CLI::Option* gain = add_number(*command, "--gain", options->gain, {1e-9, 1e9},
                                 "instead of the study's observer.image_gain; without either, the gain of "
                                 "published detection thresholds");
  command
      ->add_flag("--calibrate", options->calibrate,
                 "choose the gain that makes the receiver's perceptual threshold the paper's 426 px")
      ->excludes(gain);
  add_number(*command, "--pixels-per-degree", options->pixels_per_degree, {1, 1000},
             "instead of the study's observer.pixels_per_degree: the same pictures from another distance");
  add_number(*command, "--threads", options->threads, {0, 1024}, "0: as many as the machine has")
      ->capture_default_str();
  command->callback([options] { predict(*options); });
}

}  // namespace seamline::analysis
