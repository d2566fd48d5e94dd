#include "renderer/estimators/fast/fast_stimulus.h"

#include <algorithm>
#include <utility>

#include "raytracer/error/refined_errors.h"
#include "renderer/estimators/fast/changed_tiles.h"
#include "renderer/estimators/fast/next_round.h"
#include "renderer/estimators/fast/object_noise.h"
#include "renderer/estimators/fast/sample_response.h"
#include "renderer/estimators/fast/stimulus_assembly.h"
#include "renderer/picture/composite.h"
#include "renderer/views/view_picture.h"

namespace seamline::renderer {
namespace {

/// Gives sampled sums the denominator that filtered ones have, and changes their numerator by what the ratio
/// makes of the difference:
///   S_with + (F_with / F_no) (F_no - S_no) over F_no.
/// The change of the ratio by the filter is then linear in the samples. The quotient of the samples' own sums
/// is not: of few samples it is biased itself, in both halves alike, and the filter would be blamed for it.
void divide_alike(const std::vector<StimulusPixel>& filtered, std::vector<StimulusPixel>& sampled) {
  constexpr float most = 1e6F;  // what is beyond is clamped when it is composed
  for (std::size_t i = 0; i < sampled.size(); ++i) {
    const StimulusPixel& from = filtered[i];
    StimulusPixel& to = sampled[i];
    const Rgb ratio =
        (from.without_object > 0.0F).select((from.with_object / from.without_object).min(most), 1.0F);
    to.with_object += ratio * (from.without_object - to.without_object);
    to.without_object = from.without_object;
  }
}

/// Renders one stimulus in rounds.
class StimulusRounds {
 public:
  StimulusRounds(const ObjectTruth& truth, const DepthWorld& depth, const Recipe& recipe,
                 const EstimatorChoices& choices, const FastStimulusOptions& options)
      : truth_(truth),
        recipe_(recipe),
        choices_(choices),
        options_(options),
        sampler_(truth.scene, truth.geometry, depth, recipe, options.seed,
                 {.may_filter = true, .tail_every = choices.tail_every, .seen = truth.seen}),
        depth_(empty_answers(truth.scene.camera, recipe.answers, truth.scene_sums.spp,
                             truth.geometry.truth.is_glossy() || truth.geometry.object.is_glossy() ||
                                 (depth.mesh != nullptr && depth.mesh->is_glossy()))),
        shows_object_(pixels_with_object()),
        filtered_(static_cast<std::size_t>(depth_.grid.count()), 1),
        errors_(truth.scene.definition.exposure_ev, depth_.grid.wraps) {
    const bool order_differs = recipe.answers.occlusion == Who::depth && !truth.sorted_by_depth;
    if (order_differs)
      order_ = ask_order(truth.scene, truth.scene_sums, truth.object_index, truth.geometry.object, depth,
                         options.seed, options.threads);
  }

  FastStimulus run() {
    FastStimulus out;
    DepthSamples wanted = options_.decision != nullptr ? decided_samples() : first_samples();
    bool looks_for_bias = options_.decision != nullptr;
    if (options_.decision != nullptr) filtered_ = options_.decision->filtered;
    for (int round = 0;; ++round) {
      ask_depth(sampler_, wanted, shows_object_, options_.threads, round == 0 ? options_.progress : nullptr,
                depth_);
      if (round == 0)
        out.sums = assemble_stimulus(sources(), filters(), options_.threads);
      else
        assemble_again(sources(), filters(), changes_.since(depth_, filtered_), options_.threads, out.sums);
      changes_.take(depth_, filtered_);
      if (options_.decision != nullptr && !options_.judges) break;
      const Judged judged = judge(out.sums, looks_for_bias, round);
      looks_for_bias = judged.knows_bias;
      out.error = judged.judgement.error;
      wanted = depth_.spp;
      if (options_.target)
        wanted.object = samples_on_object(truth_, out.sums, wanted.object, choices_.most_object_variance,
                                          options_.threads);
      if (good_enough(out.error)) {
        if (wanted.object == depth_.spp.object) break;
        continue;
      }
      learn_response(out.error);
      const NextRound plan = plan_more(judged.judgement, round);
      for (const std::size_t tile : plan.unfiltered) {
        filtered_[tile] = 0;
        for (const int block : blocks_of(depth_.grid, static_cast<int>(tile)))
          response_.forget(static_cast<std::size_t>(block));
      }
      wanted = with_plan(plan, wanted);
      const bool gains = !plan.unfiltered.empty() || wanted.uncovered != depth_.spp.uncovered ||
                         wanted.object != depth_.spp.object;
      if (gains) continue;
      if (looks_for_bias) break;
      looks_for_bias = true;
    }
    out.saved = savings();
    out.taken = taken();
    out.decision = {depth_.spp.uncovered, depth_.spp.object, filtered_};
    out.pictures = std::move(kept_);
    if (choices_.asks_untouched_tiles) out.sums = with_untouched_tiles();
    return out;
  }

 private:
  /// Whether the depth mesh decides how an object in the block is lit.
  [[nodiscard]] bool lights_object(std::size_t block) const {
    const Answers& answers = recipe_.answers;
    if (recipe_.keep == Keep::all_but_object) return false;
    const bool mirrors = answers.mirrored == Who::depth && truth_.geometry.object.is_glossy();
    return (answers.object_lit == Who::depth || answers.bounce == Who::depth || mirrors) &&
           object_pixels(block) > 0;
  }
  [[nodiscard]] int object_pixels(std::size_t block) const {
    const BlockGrid::Rectangle r = truth_.scene_sums.blocks().rectangle(static_cast<int>(block));
    int pixels = 0;
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x)
        pixels += shows_object_[truth_.truth_sums.index(x, y)] != 0 ? 1 : 0;
    return pixels;
  }

  /// A flag a pixel: whether the object is seen through it, in the truth or in the depth mesh.
  [[nodiscard]] std::vector<char> pixels_with_object() const {
    const TruthSums& sums = truth_.truth_sums;
    const bool also_hidden = recipe_.answers.occlusion == Who::depth;
    const auto& tiles = truth_.scene_sums.objects[truth_.object_index - 1];
    std::vector<char> flags(sums.guides.size(), 0);
    for (int y = 0; y < sums.height_px; ++y)
      for (int x = 0; x < sums.width_px; ++x) {
        const ObjectTile* tile =
            tiles[static_cast<std::size_t>(truth_.scene_sums.grid.square_of(x, y))].get();
        if (tile == nullptr) continue;
        const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
        for (const auto& half : tile->halves)
          if (half[place].covered > 0.0F || (also_hidden && half[place].hidden_samples > 0.0F))
            flags[sums.index(x, y)] = 1;
      }
    return flags;
  }

  /// Whether the depth mesh has anything to say about the light off the object.
  [[nodiscard]] bool lights_uncovered() const {
    return recipe_.keep != Keep::object_only && asks_depth_off_object(recipe_.answers);
  }

  /// A few where only a ratio is asked for.
  [[nodiscard]] int first_uncovered_samples(std::size_t block) const {
    return samples_of_block(choices_.first_ratio_spp, block);
  }
  /// A few where only a difference is; else as many as the truth has, because noise must not give the object
  /// away.
  [[nodiscard]] int first_object_samples(std::size_t block) const {
    return adds_to_object(recipe_.answers) ? samples_of_block(choices_.first_difference_spp, block)
                                           : truth_.scene_sums.spp[block];
  }
  [[nodiscard]] int samples_of_block(const std::optional<int>& few, std::size_t block) const {
    const int all = truth_.scene_sums.spp[block];
    return std::min(few.value_or(all), all);
  }

  /// The picture with the omission turned off: the same, because nothing in these tiles uses the answers.
  /// They are asked last, so that they do not change how the other tiles are sampled.
  StimulusSums with_untouched_tiles() {
    DepthSamples wanted = depth_.spp;
    for (std::size_t b = 0; b < wanted.uncovered.size(); ++b) {
      if (wanted.uncovered[b] == 0) wanted.uncovered[b] = first_uncovered_samples(b);
      if (wanted.object[b] == 0) wanted.object[b] = first_object_samples(b);
    }
    ask_depth(sampler_, wanted, shows_object_, options_.threads, nullptr, depth_);
    return assemble_stimulus(sources(), filters(), options_.threads);
  }

  [[nodiscard]] SamplesTaken taken() const {
    SamplesTaken taken;
    double sum = 0, pixels = 0;
    for (std::size_t b = 0; b < depth_.spp.uncovered.size(); ++b) {
      const int most = std::max(depth_.spp.uncovered[b], depth_.spp.object[b]);
      taken.least = b == 0 ? most : std::min(taken.least, most);
      taken.most = std::max(taken.most, most);
      const auto of_block = static_cast<double>(depth_.blocks().pixels(static_cast<int>(b)));
      sum += of_block * most;
      pixels += of_block;
    }
    taken.mean = pixels > 0 ? sum / pixels : 0;
    return taken;
  }

  [[nodiscard]] Savings savings() const {
    Savings saved;
    saved.depth = depth_.counts;
    saved.stimuli = 1;
    std::int64_t asked = 0;
    for (std::size_t b = 0; b < depth_.spp.uncovered.size(); ++b) {
      const std::int64_t pixels = depth_.blocks().pixels(static_cast<int>(b));
      const auto count = [&](std::int64_t of_pixels, int spp) {
        asked += of_pixels * spp;
        if (spp > 0) saved.ratio_samples += of_pixels * std::max(0, truth_.scene_sums.spp[b] - spp);
      };
      count(pixels, depth_.spp.uncovered[b]);
      count(object_pixels(b), depth_.spp.object[b]);
      if (depth_.spp.uncovered[b] == 0 && depth_.spp.object[b] == 0 && !choices_.asks_untouched_tiles) {
        constexpr int geometries = 3;  // truth, object and depth mesh, a camera ray each
        ++saved.untouched_blocks;
        saved.untouched_rays += geometries * pixels * first_uncovered_samples(b);
      }
    }
    if (asked > 0)
      saved.ratio_rays = static_cast<double>(saved.ratio_samples) *
                         static_cast<double>(depth_.counts.traced) / static_cast<double>(asked);
    return saved;
  }

  [[nodiscard]] DepthSamples first_samples() const {
    DepthSamples wanted = depth_.spp;
    for (std::size_t b = 0; b < wanted.uncovered.size(); ++b) {
      if (lights_uncovered()) wanted.uncovered[b] = first_uncovered_samples(b);
      if (lights_object(b)) wanted.object[b] = first_object_samples(b);
    }
    return wanted;
  }

  /// As was decided; a block that the object was not in when it was has as many as the photograph on it.
  [[nodiscard]] DepthSamples decided_samples() const {
    DepthSamples wanted = first_samples();
    for (std::size_t b = 0; b < wanted.uncovered.size(); ++b) {
      const int uncovered = options_.decision->uncovered[b], object = options_.decision->object[b];
      if (wanted.uncovered[b] > 0) wanted.uncovered[b] = std::max(wanted.uncovered[b], uncovered);
      if (wanted.object[b] > 0) wanted.object[b] = object > 0 ? object : truth_.scene_sums.spp[b];
    }
    return wanted;
  }

  [[nodiscard]] bool good_enough(const ErrorEstimate& error) const {
    return !options_.target || options_.target->met_by(error);
  }

  [[nodiscard]] const std::vector<int>& asked_spp() const {
    return lights_uncovered() ? depth_.spp.uncovered : depth_.spp.object;
  }
  void learn_response(const ErrorEstimate& error) {
    std::vector<double> noise;
    for (std::size_t b = 0; b < error.blocks.size(); ++b)
      noise.push_back(std::max(0.0, error.blocks[b].noise - truth_.error.blocks[b].noise));
    response_.learn(asked_spp(), noise, truth_.scene_sums.spp);
  }

  /// What each block should have next, and which tiles go without the filter.
  [[nodiscard]] NextRound plan_more(const StimulusJudgement& judged, int round) const {
    return next_round({.grid = depth_.grid,
                       .photograph = truth_.error,
                       .photograph_spp = truth_.scene_sums.spp,
                       .asked_spp = asked_spp(),
                       .filtered = filtered_,
                       .judged = judged,
                       .target = *options_.target,
                       .choices = choices_,
                       .round = round,
                       .stays = &response_.stays()});
  }
  /// Samples are added off the object, and on it where nothing else is asked for.
  [[nodiscard]] DepthSamples with_plan(const NextRound& plan, DepthSamples wanted) const {
    for (std::size_t b = 0; b < plan.next_spp.size(); ++b) {
      if (lights_uncovered()) wanted.uncovered[b] = std::max(wanted.uncovered[b], plan.next_spp[b]);
      if (wanted.object[b] > 0) wanted.object[b] = std::max(wanted.object[b], plan.next_spp[b]);
    }
    if (!depth_.mirrored[0].empty()) even_out_mirrors(wanted.object);
    return wanted;
  }
  /// Where something is mirrored, a quarter of what a block beside it has: what a lamp or a sun throws off a
  /// curved mirror is rare and bright, and a block whose few samples met none seems to need no more.
  void even_out_mirrors(std::vector<int>& object_spp) const {
    const std::vector<int> planned = object_spp;
    const BlockGrid blocks = depth_.blocks();
    for (int block = 0; block < blocks.count(); ++block) {
      if (!mirrors(blocks.rectangle(block))) continue;
      int& spp = object_spp[block];
      each_neighbour(blocks, block,
                     [&](std::size_t neighbour) { spp = std::max(spp, planned[neighbour] / 8 * 2); });
    }
  }
  [[nodiscard]] bool mirrors(const BlockGrid::Rectangle& block) const {
    for (int y = block.top; y < block.bottom; ++y)
      for (int x = block.left; x < block.right; ++x)
        for (const auto& half : depth_.mirrored)
          if ((half[depth_.grid.index(x, y)].object > 0.0F).any()) return true;
    return false;
  }

  [[nodiscard]] DepthFilters filters() const {
    return {.ratio = choices_.ratio_filter, .object = options_.filter, .tiles = filtered_};
  }
  [[nodiscard]] StimulusSources sources() const {
    return {truth_,
            recipe_,
            depth_,
            order_,
            sampler_.is_dark_layer(),
            options_.compositing.value_or(sampler_.compositing())};
  }

  struct Judged {
    StimulusJudgement judgement;
    bool knows_bias = false;  ///< else the error is noise and the bias of the photograph alone
  };
  /// Whether the picture as a whole has little enough noise, and what is left are tiles with wells: what is
  /// wrong there is often the filter, and samples against noise only put that off.
  [[nodiscard]] bool may_be_wells(const StimulusSums& made, const ErrorEstimate& noise, int round) const {
    return round > 0 && options_.target && !made.light_as_sampled[0].empty() &&
           noise.rmse() <= options_.target->rmse;
  }

  /// Noise from the picture's halves; bias of the photograph's filter, and of the depth mesh's own. That one
  /// is looked for when the noise is low enough, or with `look_for_bias`: it takes twice as long, and needs
  /// samples itself.
  [[nodiscard]] Judged judge(const StimulusSums& made, bool look_for_bias, int round) {
    for (std::size_t half = 0; half < 2; ++half)
      errors_.take_filtered(half, as_shown(compose_half(made, half, options_.threads).picture));
    errors_.take_whole(as_shown(compose(made, made.compositing, options_.threads).picture));
    const bool filtered = !depth_.guides.empty() || recipe_.answers.bounce == Who::depth;
    if (!filtered || !look_for_bias) {
      ErrorEstimate noise = with_bias_of_truth(errors_.of_filtered(false, options_.threads));
      if (!filtered) {
        keep(false);
        return {{std::move(noise), {}}, true};
      }
      if (!good_enough(noise) && !may_be_wells(made, noise, round)) return {{std::move(noise), {}}, false};
    }
    for (std::size_t half = 0; half < 2; ++half) {  // one at a time in memory
      StimulusSums sampled = assemble_half_as_sampled(sources(), made, half, options_.threads);
      if (made.compositing == Compositing::ratio) divide_alike(made.halves[half], sampled.halves[half]);
      sampled.light_as_sampled[half] = made.light_as_sampled[half];
      errors_.take_sampled(half, as_shown(compose_half(sampled, half, options_.threads).picture));
    }
    keep(true);
    return {{with_bias_of_truth(errors_.of_filtered(true, options_.threads)),
             with_bias_of_truth(errors_.of_sampled(options_.threads))},
            true};
  }

  /// Errors are of what people see.
  [[nodiscard]] Image as_shown(Image picture) const {
    return shown_to_each_eye(truth_.scene.definition.view, std::move(picture));
  }

  void keep(bool with_sampled) {
    if (options_.keeps_pictures) kept_ = errors_.pictures(with_sampled);
  }

  [[nodiscard]] ErrorEstimate with_bias_of_truth(ErrorEstimate error) const {
    error.image.bias = std::max(0.0, error.image.bias) + std::max(0.0, truth_.error.image.bias);
    for (std::size_t t = 0; t < error.tiles.size(); ++t)
      error.tiles[t].bias = std::max(0.0, error.tiles[t].bias) + std::max(0.0, truth_.error.tiles[t].bias);
    return error;
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const EstimatorChoices& choices_;
  const FastStimulusOptions& options_;
  StimulusSampler sampler_;
  DepthAnswers depth_;
  ObjectOrder order_;
  std::vector<char> shows_object_;  ///< a flag a pixel
  TileSet filtered_;                ///< tiles where light of the depth mesh is filtered
  SampleResponse response_;
  ChangedTiles changes_;
  RefinedErrors errors_;
  HalfPictures kept_;  ///< of the last judgement
};

}  // namespace

FastStimulus render_fast_stimulus(const ObjectTruth& truth, const DepthWorld& depth, const Recipe& recipe,
                                  const EstimatorChoices& choices, const FastStimulusOptions& options) {
  return StimulusRounds(truth, depth, recipe, choices, options).run();
}

}  // namespace seamline::renderer
