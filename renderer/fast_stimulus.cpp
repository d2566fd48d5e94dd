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

  /// Bounce light after filtering, row by row; empty where nothing was filtered.
  struct Filtered {
    std::vector<Surface> surfaces;
    std::vector<BounceTexel> texels;
    [[nodiscard]] const Surface* surface(std::size_t i) const {
      return surfaces.empty() ? nullptr : &surfaces[i];
    }
    [[nodiscard]] const BounceTexel* texel(std::size_t i) const {
      return texels.empty() ? nullptr : &texels[i];
    }
  };

  void pixel(int x, int y, std::size_t half, const Filtered& rest, const Filtered& object,
             StimulusSums& out) const {
    const Pixel in = gather(x, y, half);
    const std::size_t i = truth_.layers.index(x, y);
    if (recipe_.keep == Keep::object_layer)
      out.from_reference = in.truth.sky + in.truth.with.total() + in.uncovers * in.truth.object.total();
    if (recipe_.keep == Keep::rest_layer)
      out.from_reference = in.truth.object.total() + in.covers * Rgb(in.truth.with.total() + in.truth.sky);
    else
      out.object =
          object_light(in, (1.0F - in.uncovers) * in.truth.covered, object.texel(i), object.surface(i), half);
    if (recipe_.keep == Keep::object_layer) return;
    if (recipe_.keep == Keep::everything) out.object += hidden_light(in);
    add_rest_of(in, rest.texel(i), rest.surface(i), half, out);
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

  /// Light of `covered` samples of the object. `filtered` holds its bounce light in the depth mesh, or is
  /// null.
  [[nodiscard]] Split object_light(const Pixel& in, float covered, const BounceTexel* filtered,
                                   const Surface* surface, std::size_t half) const {
    if (covered <= 0.0F) return {};
    const Split truth = in.truth.covered > 0.0F ? covered / in.truth.covered * in.truth.object : Split{};
    if (answers_.object_lit == Who::truth && answers_.bounce == Who::truth) return truth;
    if (in.depth.covered <= 0.0F) return truth;  // no sample fell on it
    Split depth = covered / in.depth.covered * in.depth.object;
    if (filtered != nullptr && filtered->no_samples[half] > 0.0F)
      depth.bounce = filtered->no[half] * surface->albedo * (covered / filtered->no_samples[half]);
    return {answers_.object_lit == Who::truth ? truth.direct : depth.direct,
            answers_.bounce == Who::truth ? truth.bounce : depth.bounce};
  }

  /// Light of the object where the truth hides it and the depth mesh does not.
  [[nodiscard]] Split hidden_light(const Pixel& in) const {
    if (in.newly_covered <= 0.0F) return {};
    if (answers_.object_lit == Who::depth && in.depth.covered > 0.0F)
      return in.newly_covered / in.depth.covered * in.depth.object;
    return in.newly_covered / std::max(in.own.hidden_samples, 1.0F) * in.own.hidden;
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
        sampler_(truth.scene, truth.geometry, depth, recipe, options.seed, {true, options.tail_every}),
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
      out.layers = layers(true);
      out.error = error_of(out.layers);
      if (!options_.target || options_.target->met_by(out.error)) break;
      const std::vector<TileState> tiles = states(out.error);
      wanted = next_samples(tiles, *options_.target);
      if (wanted == depth_.spp) {
        out.error = error_of(out.layers, LookForBias::always);
        break;
      }
    }
    out.saved = savings();
    if (!options_.omit.untouched_tiles) out.layers = with_untouched_tiles();
    return out;
  }

 private:
  /// Whether the depth mesh has anything to say about the light in a tile.
  [[nodiscard]] bool concerns(std::size_t tile) const {
    return lights_object(tile) ||
           (recipe_.keep != Keep::object_layer && asks_depth_for_rest(recipe_.answers));
  }

  /// Whether the depth mesh decides how an object in the tile is lit.
  [[nodiscard]] bool lights_object(std::size_t tile) const {
    const Answers& answers = recipe_.answers;
    if (recipe_.keep == Keep::rest_layer) return false;
    if (answers.object_lit == Who::truth && answers.bounce == Who::truth) return false;
    const auto& object = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][tile];
    if (object == nullptr || answers.occlusion == Who::depth) return object != nullptr;
    const auto covers = [](const ObjectSums& sums) { return sums.covered > 0.0F; };
    return std::any_of(object->halves[0].begin(), object->halves[0].end(), covers) ||
           std::any_of(object->halves[1].begin(), object->halves[1].end(), covers);
  }

  static constexpr int pilot = 4;
  /// A few where only a ratio is asked for; on the object as many as the truth has, because its noise must
  /// not give it away.
  [[nodiscard]] int first_samples_of(std::size_t tile) const {
    const int all = truth_.sums.spp[tile];
    return options_.target && options_.omit.ratio_samples && !lights_object(tile) ? std::min(pilot, all)
                                                                                  : all;
  }

  /// The picture with the omission turned off: the same, because nothing in these tiles uses the answers.
  /// They are asked last, so that they do not change how the other tiles are sampled.
  StimulusLayers with_untouched_tiles() {
    std::vector<int> wanted = depth_.spp;
    for (std::size_t t = 0; t < wanted.size(); ++t)
      if (wanted[t] == 0) wanted[t] = first_samples_of(t);
    ask_depth(sampler_, wanted, options_.threads, nullptr, depth_);
    return layers(true);
  }

  [[nodiscard]] Savings savings() const {
    Savings saved{.omitted = depth_.omitted, .depth_rays = depth_.rays, .stimuli = 1};
    std::int64_t asked = 0;
    for (std::size_t t = 0; t < depth_.spp.size(); ++t) {
      const TileGrid::Rectangle r = depth_.grid.rectangle(static_cast<int>(t));
      const std::int64_t pixels = std::int64_t{r.right - r.left} * (r.bottom - r.top);
      asked += pixels * depth_.spp[t];
      if (depth_.spp[t] > 0) {
        saved.ratio_samples += pixels * std::max(0, truth_.sums.spp[t] - depth_.spp[t]);
      } else if (options_.omit.untouched_tiles) {
        constexpr int geometries = 3;  // truth, object and depth mesh, a camera ray each
        ++saved.untouched_tiles;
        saved.untouched_rays += geometries * pixels * first_samples_of(t);
      }
    }
    if (asked > 0)
      saved.ratio_rays = static_cast<double>(saved.ratio_samples) * static_cast<double>(depth_.rays) /
                         static_cast<double>(asked);
    return saved;
  }

  [[nodiscard]] std::vector<int> first_samples() const {
    std::vector<int> wanted(truth_.sums.spp.size());
    for (std::size_t t = 0; t < wanted.size(); ++t)
      if (concerns(t)) wanted[t] = first_samples_of(t);
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
                  .most_spp = depth_.spp[t] > 0 ? 4 * truth_.sums.spp[t] : 0};
    }
    return tiles;
  }

  [[nodiscard]] StimulusLayers layers(bool filtered) const {
    const TruthLayers& truth = truth_.layers;
    StimulusLayers out{.width_px = truth.width_px, .height_px = truth.height_px, .spp = truth.spp};
    for (auto& half : out.halves) half.resize(truth.guides.size());
    out.guides = truth.guides;
    out.depth_lights_rest = depth_lights_rest(recipe_.answers);
    out.rays = depth_.rays;
    Assembly::Filtered rest, object;
    if (!depth_.guides.empty()) {
      collect_rest(rest, out.guides);
      filter_bounce(rest.surfaces, truth.width_px, filtered ? options_.ratio_filter : FilterStrength{0, 1.0F},
                    options_.threads, rest.texels);
    }
    if (filtered && recipe_.answers.bounce == Who::depth && recipe_.keep != Keep::rest_layer) {
      collect_object(object);
      filter_bounce(object.surfaces, truth.width_px, options_.filter, options_.threads, object.texels);
    }
    const Assembly assembly(truth_, recipe_, depth_, order_);
    parallel_for(truth.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < truth.width_px; ++x)
        for (std::size_t half = 0; half < 2; ++half)
          assembly.pixel(x, y, half, rest, object, out.halves[half][truth.index(x, y)]);
    });
    return out;
  }

  template <class Work>
  void each_pixel(const Work& work) const {
    parallel_for(truth_.layers.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < truth_.layers.width_px; ++x) work(x, y, truth_.layers.index(x, y));
    });
  }

  void collect_rest(Assembly::Filtered& rest, std::vector<Guide>& guides) const {
    rest.surfaces.resize(guides.size());
    rest.texels.resize(guides.size());
    each_pixel([&](int x, int y, std::size_t i) {
      const float samples = depth_.halves[0][i].rest + depth_.halves[1][i].rest;
      Surface& surface = rest.surfaces[i];
      surface = surface_of(depth_.guides[i], samples, truth_.scene.camera, x, y);
      surface.inverse_reach = std::max(surface.inverse_reach, truth_reach(i));
      guides[i] = {surface.normal, surface.distance_m};
      if (samples <= 0.0F) return;
      for (std::size_t half = 0; half < 2; ++half) {
        const DepthSums& sums = depth_.halves[half][i];
        BounceTexel& texel = rest.texels[i];
        texel.no[half] = sums.no.bounce / surface.albedo;
        texel.change[half] = (sums.with.bounce - sums.no.bounce) / surface.albedo;
        texel.no_samples[half] = texel.change_samples[half] = sums.rest;
      }
    });
  }

  void collect_object(Assembly::Filtered& object) const {
    object.surfaces.resize(truth_.layers.guides.size());
    object.texels.resize(truth_.layers.guides.size());
    const auto& tiles = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)];
    each_pixel([&](int x, int y, std::size_t i) {
      const ObjectTile* tile = tiles[static_cast<std::size_t>(truth_.sums.grid.tile_of(x, y))].get();
      if (tile == nullptr) return;
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      const float covered = tile->halves[0][place].covered + tile->halves[1][place].covered;
      if (covered <= 0.0F) return;
      object.surfaces[i] = surface_of(tile->guides[place], covered, truth_.scene.camera, x, y);
      for (std::size_t half = 0; half < 2; ++half) {
        const DepthSums& sums = depth_.halves[half][i];
        object.texels[i].no[half] = sums.object.bounce / object.surfaces[i].albedo;
        object.texels[i].no_samples[half] = sums.covered;
      }
    });
  }

  /// Creases of the truth, in 1/m: the depth mesh has them where it has any.
  [[nodiscard]] float truth_reach(std::size_t pixel) const {
    const auto k = static_cast<std::size_t>(truth_.object_index);
    const float samples = truth_.sums.halves[0][pixel].surfaces[k] + truth_.sums.halves[1][pixel].surfaces[k];
    return samples > 0.0F ? truth_.sums.guides[k - 1][pixel].inverse_reach / samples : 0.0F;
  }

  /// Noise from the picture's halves; bias of the photograph's filter, and of the depth mesh's own, which is
  /// only worth looking for when the noise is low enough.
  enum class LookForBias { when_noise_is_low, always };
  [[nodiscard]] ErrorEstimate error_of(const StimulusLayers& made,
                                       LookForBias look = LookForBias::when_noise_is_low) const {
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = compose_half(made, half, options_.threads).picture;
    pictures.sampled = pictures.filtered;
    const ErrorEstimate noise = with_bias_of_truth(pictures);
    const bool filtered = !depth_.guides.empty() || recipe_.answers.bounce == Who::depth;
    const bool too_noisy = options_.target && !options_.target->met_by(noise);
    if (!filtered || (too_noisy && look == LookForBias::when_noise_is_low)) return noise;
    const StimulusLayers sampled = layers(false);
    for (std::size_t half = 0; half < 2; ++half)
      pictures.sampled[half] = compose_half(sampled, half, options_.threads).picture;
    return with_bias_of_truth(pictures);
  }

  [[nodiscard]] ErrorEstimate with_bias_of_truth(const HalfPictures& pictures) const {
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
