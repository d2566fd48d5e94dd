#include "renderer/fast_stimulus.h"

#include <algorithm>
#include <cmath>

#include "renderer/composite.h"
#include "renderer/parallel.h"

namespace seamline {
namespace {

/// Puts a stimulus together from the truth's sums and the depth mesh's answers, pixel by pixel: DESIGN
/// section 3's formula with sums of samples that truth and depth mesh sort alike.
class Assembly {
 public:
  Assembly(const ObjectTruth& truth, const Recipe& recipe, const DepthAnswers& depth,
           const ObjectOrder& order)
      : truth_(truth), recipe_(recipe), answers_(recipe.answers), depth_(depth), order_(order) {}

  /// `texels` and `surfaces` hold the depth mesh's filtered bounce light, or are empty.
  void pixel(int x, int y, std::size_t half, const BounceTexel* texel, const Surface* surface,
             StimulusSums& out) const {
    const Pixel in = gather(x, y, half);
    if (recipe_.keep == Keep::object_layer) {
      out.from_reference = in.truth.sky + in.truth.with.total() + in.uncovers * in.truth.object.total();
      out.object = object_light(in, (1.0F - in.uncovers) * in.truth.covered);
      return;
    }
    if (recipe_.keep == Keep::rest_layer) {
      out.from_reference = in.truth.object.total() + in.covers * Rgb(in.truth.with.total() + in.truth.sky);
    } else {
      out.object = object_light(in, (1.0F - in.uncovers) * in.truth.covered) + hidden_light(in);
    }
    add_rest_of(in, texel, surface, half, out);
  }

 private:
  /// Everything known of one pixel and half, in the layers' number of samples.
  struct Pixel {
    const TruthSums& truth;
    const ObjectSums& own;   ///< in the tile's own number of samples
    const DepthSums& depth;  ///< in the depth pass's own number of samples
    float to_layers = 1;     ///< from the tile's number of samples to the layers'
    float uncovers = 0;      ///< share of the truth's covered samples that the depth mesh uncovers
    float covers = 0;        ///< share of the truth's uncovered samples that it covers
    float newly_covered = 0;
  };

  [[nodiscard]] Pixel gather(int x, int y, std::size_t half) const {
    static const ObjectSums nothing;
    const TruthLayers& layers = truth_.layers;
    const std::size_t i = layers.index(x, y);
    const auto tile = static_cast<std::size_t>(truth_.sums.grid.tile_of(x, y));
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const auto& object = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][tile];
    Pixel in{.truth = layers.halves[half][i],
             .own = object ? object->halves[half][place] : nothing,
             .depth = depth_.halves[half][i]};
    in.to_layers = static_cast<float>(layers.spp) / static_cast<float>(truth_.sums.spp[tile]);
    if (order_.empty() || order_[tile][half].empty()) return in;
    const OrderSums& order = order_[tile][half][place];
    const float samples = 0.5F * static_cast<float>(truth_.sums.spp[tile]);
    if (in.own.covered > 0) in.uncovers = order.truth_only / in.own.covered;
    if (samples > in.own.covered) in.covers = order.depth_only / (samples - in.own.covered);
    in.newly_covered = order.depth_only * in.to_layers;
    return in;
  }

  /// Light of `covered` samples of the object.
  [[nodiscard]] Rgb object_light(const Pixel& in, float covered) const {
    if (covered <= 0.0F) return Rgb::Zero();
    const bool lit_by_truth = answers_.object_lit == Who::truth,
               bounced_by_truth = answers_.bounce == Who::truth;
    Rgb light = Rgb::Zero();
    if (in.truth.covered > 0.0F) {
      if (lit_by_truth) light += in.truth.object.direct * (covered / in.truth.covered);
      if (bounced_by_truth) light += in.truth.object.bounce * (covered / in.truth.covered);
    }
    if (lit_by_truth && bounced_by_truth) return light;
    if (in.depth.covered > 0.0F) return light + in.depth.object * (covered / in.depth.covered);
    return in.truth.object.total() * (covered / std::max(in.truth.covered, 1e-30F));  // no sample fell on it
  }

  /// Light of the object where the truth hides it and the depth mesh does not.
  [[nodiscard]] Rgb hidden_light(const Pixel& in) const {
    if (in.newly_covered <= 0.0F) return Rgb::Zero();
    if (answers_.object_lit == Who::depth && in.depth.covered > 0.0F)
      return in.depth.object * (in.newly_covered / in.depth.covered);
    return in.own.hidden.total() * (in.newly_covered / std::max(in.own.hidden_samples, 1.0F));
  }

  void add_rest_of(const Pixel& in, const BounceTexel* texel, const Surface* surface, std::size_t half,
                   StimulusSums& out) const {
    const float stays = 1.0F - in.covers;
    const bool uncovers = recipe_.keep == Keep::everything && in.uncovers > 0.0F;
    const float behind = uncovers ? in.uncovers * in.to_layers : 0.0F;
    Split no = stays * in.truth.no, with = stays * in.truth.with;
    float rest = stays * in.truth.rest;
    out.sky = stays * in.truth.sky;
    if (uncovers) {
      no += behind * in.own.behind;
      with += behind * in.own.behind_with;
      rest += behind * in.own.behind_surfaces;
      out.sky += behind * (in.own.covered - in.own.behind_surfaces) * truth_.scene.light.environment_radiance;
    }
    if (!asks_depth_for_rest(answers_)) {
      set_rest(rest, no.total(), no, with, out);
      return;
    }
    const float seen = in.depth.rest + in.depth.depth_sky;
    const float share = seen > 0.0F ? in.depth.rest / seen : 0.0F;
    out.sky += (1.0F - share) * no.total();
    if (share <= 0.0F) return;
    const Rgb background = share * no.total();
    rest *= share;
    const float to_rest = rest / in.depth.rest;
    Split depth_no = to_rest * in.depth.no, depth_with = to_rest * in.depth.with;
    if (texel != nullptr) filtered_bounce(*texel, *surface, half, rest, depth_no, depth_with);
    no = join(share * no, depth_no);
    with = join(share * with, depth_with);
    set_rest(rest, background, no, with, out);
  }

  /// Light of which the truth answers one part and the depth mesh the other.
  [[nodiscard]] Split join(const Split& truth, const Split& depth) const {
    const bool direct_from_truth = answers_.receiver == Who::truth && answers_.real_lit == Who::truth;
    if (answers_.bounce == Who::truth) return {depth.total(), truth.bounce};  // the sky is in depth.bounce
    return direct_from_truth ? Split{truth.direct, depth.bounce} : depth;
  }

  static void filtered_bounce(const BounceTexel& texel, const Surface& surface, std::size_t half, float rest,
                              Split& no, Split& with) {
    if (texel.no_samples[half] <= 0.0F) return;
    const Rgb to_rest = surface.albedo * (rest / texel.no_samples[half]);
    no.bounce = texel.no[half] * to_rest;
    with.bounce = no.bounce + texel.change[half] * to_rest;
  }

  static void set_rest(float rest, const Rgb& background, const Split& no, const Split& with,
                       StimulusSums& out) {
    out.rest = rest;
    out.background = background;
    out.no = no;
    out.with = with;
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const Answers& answers_;
  const DepthAnswers& depth_;
  const ObjectOrder& order_;
};

/// Renders one stimulus in rounds.
class StimulusRounds {
 public:
  StimulusRounds(const ObjectTruth& truth, const Geometry* depth, const Recipe& recipe,
                 const FastStimulusOptions& options)
      : truth_(truth),
        recipe_(recipe),
        options_(options),
        sampler_(truth.scene, truth.geometry, depth, recipe, options.seed, options.tail_every),
        depth_(empty_answers(truth.scene.camera, recipe.answers)) {
    const bool order_differs = recipe.answers.occlusion == Who::depth;
    if (order_differs)
      order_ = ask_order(truth.scene, truth.sums, truth.object_index, *depth, options.seed, options.threads);
  }

  FastStimulus run() {
    FastStimulus out;
    std::vector<int> wanted = first_samples();
    for (int round = 0;; ++round) {
      ask_depth(sampler_, wanted, options_.threads, round == 0 ? options_.progress : nullptr, depth_);
      out.layers = layers(options_.filter);
      out.error = error_of(out.layers);
      if (getenv("DBG")) {
        long n = 0;
        for (size_t t = 0; t < depth_.spp.size(); ++t) {
          n += depth_.spp[t];
        }
        fprintf(
            stderr,
            "round %d avg spp %.1f rays %.1fM est %.5f noise %.5f bias2 %.2e worst %.4f truth %.5f/%.4f\n",
            round, double(n) / depth_.spp.size(), depth_.rays / 1e6, out.error.rmse(),
            sqrt(out.error.image.noise), out.error.image.bias, out.error.worst_tile(), truth_.error.rmse(),
            truth_.error.worst_tile());
      }
      if (!options_.target || options_.target->met_by(out.error)) return out;
      const std::vector<TileState> tiles = states(out.error);
      wanted = next_samples(tiles, *options_.target);
      if (wanted == depth_.spp) return out;
    }
  }

 private:
  /// Whether the depth mesh has anything to say about the light in a tile.
  [[nodiscard]] bool concerns(std::size_t tile) const {
    const Answers& answers = recipe_.answers;
    if (recipe_.keep != Keep::object_layer && asks_depth_for_rest(answers)) return true;
    if (answers.object_lit == Who::truth && answers.bounce == Who::truth) return false;
    return truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][tile] != nullptr;
  }

  [[nodiscard]] std::vector<int> first_samples() const {
    constexpr int pilot = 4;
    std::vector<int> wanted(truth_.sums.spp.size());
    for (std::size_t t = 0; t < wanted.size(); ++t)
      if (concerns(t)) wanted[t] = options_.target ? std::min(pilot, truth_.sums.spp[t]) : truth_.sums.spp[t];
    return wanted;
  }

  [[nodiscard]] std::vector<TileState> states(const ErrorEstimate& error) const {
    std::vector<TileState> tiles(error.tiles.size());
    const double pixels = static_cast<double>(depth_.grid.width_px) * depth_.grid.height_px;
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      const TileGrid::Rectangle r = depth_.grid.rectangle(static_cast<int>(t));
      const double photograph = std::min(truth_.error.tiles[t].noise, error.tiles[t].noise);
      tiles[t] = {.noise = error.tiles[t].noise - photograph,
                  .rest = photograph + std::max(0.0, error.tiles[t].bias),
                  .spp = depth_.spp[t],
                  .share = (r.right - r.left) * (r.bottom - r.top) / pixels,
                  .most_spp = depth_.spp[t] > 0 ? truth_.sums.spp[t] : 0};
    }
    return tiles;
  }

  [[nodiscard]] StimulusLayers layers(const FilterStrength& filter) const {
    const TruthLayers& truth = truth_.layers;
    StimulusLayers out{.width_px = truth.width_px, .height_px = truth.height_px, .spp = truth.spp};
    for (auto& half : out.halves) half.resize(truth.guides.size());
    out.guides = truth.guides;
    out.depth_lights_rest = depth_lights_rest(recipe_.answers);
    out.rays = depth_.rays;
    std::vector<Surface> surfaces;
    std::vector<BounceTexel> texels;
    if (!depth_.guides.empty()) {
      collect_bounce(surfaces, texels, out.guides);
      filter_bounce(surfaces, truth.width_px, filter, options_.threads, texels);
    }
    const Assembly assembly(truth_, recipe_, depth_, order_);
    parallel_for(truth.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < truth.width_px; ++x) {
        const std::size_t i = truth.index(x, y);
        for (std::size_t half = 0; half < 2; ++half)
          assembly.pixel(x, y, half, texels.empty() ? nullptr : &texels[i],
                         texels.empty() ? nullptr : &surfaces[i], out.halves[half][i]);
      }
    });
    return out;
  }

  void collect_bounce(std::vector<Surface>& surfaces, std::vector<BounceTexel>& texels,
                      std::vector<Guide>& guides) const {
    const TruthLayers& truth = truth_.layers;
    surfaces.resize(truth.guides.size());
    texels.resize(truth.guides.size());
    parallel_for(truth.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < truth.width_px; ++x) {
        const std::size_t i = truth.index(x, y);
        const float samples = depth_.halves[0][i].rest + depth_.halves[1][i].rest;
        surfaces[i] = surface_of(depth_.guides[i], samples, truth_.scene.camera, x, y);
        surfaces[i].inverse_reach = std::max(surfaces[i].inverse_reach, truth_reach(i));
        guides[i] = {surfaces[i].normal, surfaces[i].distance_m};
        if (samples <= 0.0F) continue;
        for (std::size_t half = 0; half < 2; ++half) {
          const DepthSums& sums = depth_.halves[half][i];
          texels[i].no[half] = sums.no.bounce / surfaces[i].albedo;
          texels[i].change[half] = (sums.with.bounce - sums.no.bounce) / surfaces[i].albedo;
          texels[i].no_samples[half] = texels[i].change_samples[half] = sums.rest;
        }
      }
    });
  }

  /// Creases of the truth, in 1/m: the depth mesh has them where it has any.
  [[nodiscard]] float truth_reach(std::size_t pixel) const {
    const auto k = static_cast<std::size_t>(truth_.object_index);
    const float samples = truth_.sums.halves[0][pixel].surfaces[k] + truth_.sums.halves[1][pixel].surfaces[k];
    return samples > 0.0F ? truth_.sums.guides[k - 1][pixel].inverse_reach / samples : 0.0F;
  }

  /// Noise from the picture's halves; bias of the photograph's filter, and of the depth mesh's own.
  [[nodiscard]] ErrorEstimate error_of(const StimulusLayers& made) const {
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half) pictures.filtered[half] = compose_half(made, half).picture;
    if (depth_.guides.empty() || options_.filter.levels == 0) {
      pictures.sampled = pictures.filtered;
    } else {
      const StimulusLayers sampled = layers({.levels = 0});
      for (std::size_t half = 0; half < 2; ++half)
        pictures.sampled[half] = compose_half(sampled, half).picture;
    }
    ErrorEstimate error = estimate_error(pictures, truth_.scene.definition.exposure_ev, options_.threads);
    error.image.bias = std::max(0.0, error.image.bias) + std::max(0.0, truth_.error.image.bias);
    for (std::size_t t = 0; t < error.tiles.size(); ++t)
      error.tiles[t].bias = std::max(0.0, error.tiles[t].bias) + std::max(0.0, truth_.error.tiles[t].bias);
    return error;
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const FastStimulusOptions& options_;
  StimulusSampler sampler_;
  DepthAnswers depth_;
  ObjectOrder order_;
};

}  // namespace

FastStimulus render_fast_stimulus(const ObjectTruth& truth, const Geometry* depth, const Recipe& recipe,
                                  const FastStimulusOptions& options) {
  return StimulusRounds(truth, depth, recipe, options).run();
}

}  // namespace seamline
