#include "renderer/estimators/fast/stimulus_assembly.h"

#include <algorithm>

#include "renderer/common/parallel.h"
#include "renderer/estimators/fast/filtered_bounce.h"

namespace seamline::renderer {
namespace {

class Assembly {
 public:
  explicit Assembly(const StimulusParts& parts)
      : truth_(parts.truth),
        recipe_(parts.recipe),
        answers_(parts.recipe.answers),
        depth_(parts.depth),
        order_(parts.order) {}

  /// The object's light, and what another layer than the kept one shows.
  void add_object(int x, int y, std::size_t half, const FilteredBounce& object, StimulusSums& out) const {
    const Pixel in = gather(x, y, half);
    const std::size_t i = truth_.layers.index(x, y);
    if (recipe_.keep == Keep::object_layer)
      out.from_reference = in.truth.sky + in.truth.with.total() + in.uncovers * in.truth.object.total();
    if (recipe_.keep == Keep::rest_layer)
      out.from_reference = in.truth.object.total() + in.covers * Rgb(in.truth.with.total() + in.truth.sky);
    else
      out.object =
          object_light(in, (1.0F - in.uncovers) * in.truth.covered, object.texel(i), object.surface(i), half)
              .total();
    if (adds_to_object(answers_)) out.object += added_to_object(x, y, half, in);
    if (recipe_.keep == Keep::everything) out.object += hidden_light(in).total();
  }
  void add_rest(int x, int y, std::size_t half, const FilteredBounce& rest, StimulusSums& out) const {
    const std::size_t i = truth_.layers.index(x, y);
    add_rest_of(gather(x, y, half), rest.texel(i), rest.surface(i), half, out);
  }

 private:
  /// Everything known of one pixel and half, in the layers' number of samples.
  struct Pixel {
    const TruthSums& truth;
    const ObjectSums& own;   ///< in the pixel's own number of samples
    const DepthSums& depth;  ///< in the depth pass's own number of samples
    float to_layers = 1;     ///< from the pixel's number of samples to the layers'
    float uncovers = 0;      ///< share of the truth's covered samples that the depth mesh uncovers
    float covers = 0;        ///< share of the truth's uncovered samples that it covers
    float newly_covered = 0;
  };

  [[nodiscard]] Pixel gather(int x, int y, std::size_t half) const {
    static const ObjectSums nothing;
    const TruthLayers& layers = truth_.layers;
    const std::size_t i = layers.index(x, y);
    const auto tile = static_cast<std::size_t>(truth_.sums.grid.square_of(x, y));
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const auto& object = truth_.sums.objects[static_cast<std::size_t>(truth_.object_index - 1)][tile];
    Pixel in{.truth = layers.halves[half][i],
             .own = object ? object->halves[half][place] : nothing,
             .depth = depth_.halves[half][i]};
    const auto samples_of_pixel = static_cast<float>(truth_.sums.samples_at(x, y));
    in.to_layers = static_cast<float>(layers.spp) / samples_of_pixel;
    if (order_.empty() || order_[tile][half].empty()) return in;
    const OrderSums& order = order_[tile][half][place];
    const float samples = 0.5F * samples_of_pixel;
    if (in.own.covered > 0) in.uncovers = order.truth_only / in.own.covered;
    if (samples > in.own.covered) in.covers = order.depth_only / (samples - in.own.covered);
    in.newly_covered = order.depth_only * in.to_layers;
    return in;
  }

  /// Light of `covered` samples of the object, without what the depth mesh adds to the truth's. `filtered`
  /// holds its bounce light in the depth mesh, or is null.
  [[nodiscard]] Split object_light(const Pixel& in, float covered, const BounceTexel* filtered,
                                   const Surface* surface, std::size_t half) const {
    if (covered <= 0.0F) return {};
    const Split truth = in.truth.covered > 0.0F ? covered / in.truth.covered * in.truth.object : Split{};
    if (answers_.bounce == Who::truth || in.depth.covered <= 0.0F) return truth;  // or no sample fell on it
    Split depth = covered / in.depth.covered * in.depth.object;
    if (filtered != nullptr && filtered->no_samples(half) > 0.0F)
      depth.bounce = filtered->no(half) * surface->albedo * (covered / filtered->no_samples(half));
    return {answers_.object_lit == Who::truth ? truth.direct : depth.direct, depth.bounce};
  }

  /// What sun and sky past the depth mesh add to those of the truth, below 0 where they take away. Where as
  /// many samples were asked as the truth has, they are the same ones, and the truth's sum of them is known.
  [[nodiscard]] Rgb added_to_object(int x, int y, std::size_t half, const Pixel& in) const {
    const auto block = static_cast<std::size_t>(depth_.blocks().square_of(x, y));
    const int asked = depth_.spp.object[block];
    if (asked == 0 || in.depth.covered <= 0.0F) return Rgb::Zero();
    const float to_layers = static_cast<float>(truth_.layers.spp) / static_cast<float>(asked);
    if (asked >= depth_.spp.photograph[block])
      return to_layers * in.depth.object.direct - in.truth.object.direct;
    return to_layers * (in.depth.object.direct - depth_.object_in_truth[half][truth_.layers.index(x, y)]);
  }

  /// Light of the object where the truth hides it and the depth mesh does not, likewise.
  [[nodiscard]] Split hidden_light(const Pixel& in) const {
    if (in.newly_covered <= 0.0F) return {};
    const bool from_depth = answers_.object_lit == Who::depth && answers_.bounce == Who::depth;
    if (from_depth && in.depth.covered > 0.0F) return in.newly_covered / in.depth.covered * in.depth.object;
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
    if (texel.no_samples(half) <= 0.0F) return;
    const Rgb to_rest = surface.albedo * (rest / texel.no_samples(half));
    no.bounce = texel.no(half) * to_rest;
    with.bounce = no.bounce + texel.change(half) * to_rest;
  }

  static void set_rest(float rest, const Rgb& background, const Split& no, const Split& with,
                       StimulusSums& out) {
    out.rest = rest;
    out.background = background;
    out.no = no.total();
    out.with = with.total();
  }

  const ObjectTruth& truth_;
  const Recipe& recipe_;
  const Answers& answers_;
  const DepthAnswers& depth_;
  const ObjectOrder& order_;
};

}  // namespace

StimulusLayers assemble_stimulus(const StimulusParts& parts, const DepthFilters& filters, int threads,
                                 std::optional<std::size_t> only_half) {
  const TruthLayers& truth = parts.truth.layers;
  StimulusLayers out{.width_px = truth.width_px, .height_px = truth.height_px, .spp = truth.spp};
  for (std::size_t half = 0; half < 2; ++half)
    if (half == only_half.value_or(half)) out.halves[half].resize(truth.guides.size());
  out.guides = truth.guides;
  out.depth_lights_rest = depth_lights_rest(parts.recipe.answers);
  out.rays = parts.depth.counts.traced;
  const Assembly assembly(parts);
  const FilteredBounce unfiltered;
  const auto each_pixel = [&](const FilteredBounce& filtered, auto add) {
    parallel_for(truth.height_px, threads, [&](int y) {
      for (int x = 0; x < truth.width_px; ++x) {
        const auto tile = static_cast<std::size_t>(parts.truth.sums.grid.square_of(x, y));
        const bool is_filtered = filters.tiles.empty() || filters.tiles[tile] != 0;
        for (std::size_t half = 0; half < 2; ++half)
          if (!out.halves[half].empty())
            (assembly.*add)(x, y, half, is_filtered ? filtered : unfiltered,
                            out.halves[half][truth.index(x, y)]);
      }
    });
  };
  {  // one after the other: each takes a hundred bytes a pixel
    const bool on_object = parts.recipe.answers.bounce == Who::depth && parts.recipe.keep != Keep::rest_layer;
    FilteredBounce object;
    if (on_object && filters.object.levels > 0)
      object = filtered_object(parts.truth, parts.depth, filters.object, threads);
    each_pixel(object, &Assembly::add_object);
  }
  FilteredBounce rest;
  if (!parts.depth.guides.empty())
    rest = filtered_rest(parts.truth, parts.depth, filters.ratio, threads, out.guides);
  if (parts.recipe.keep != Keep::object_layer) each_pixel(rest, &Assembly::add_rest);
  return out;
}

}  // namespace seamline::renderer
