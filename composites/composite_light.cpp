#include "composites/composite_light.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "composites/fast_photo.h"
#include "composites/light/clipped_sources.h"
#include "composites/photo_light.h"
#include "raytracer/light/bright_patches.h"
#include "raytracer/scene/truth_scene.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

constexpr double least_likeness = 0.2;

bool shines(const Light& light) {
  return !light.suns.empty() || !light.lamps.empty() || light.environment != nullptr ||
         (light.environment_radiance > 0.0F).any();
}

std::string three(const Rgb& v) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", v[0], v[1], v[2]);
}

/// The light that was given, or the scene file's.
Light given_light(const CompositeRequest& request, const SeenPhoto& seen) {
  SceneDefinition definition = request.light.given;
  definition.name = "composite";
  definition.path = request.scene_file;
  definition.bounces = request.bounces;
  SceneFile file;
  file.suns = seen.scene.suns;
  file.lamps = seen.scene.lamps;
  return scene_light(definition, file, seen.centre_m);
}

/// Makes clipped sources of a panorama of codes as bright as its surfaces say, or as was asked.
void raise_clipped(const CompositeRequest& request, const Geometry& depth, float white, Image& panorama,
                   Notes& notes) {
  constexpr double worth_it = 1.05;
  if (request.light.clipped_factor) {
    raise_clipped_sources(panorama, white, *request.light.clipped_factor);
    return;
  }
  const ClippedSources found = find_clipped_sources(panorama, depth, white, request.threads);
  if (found.factor < worth_it) return;
  raise_clipped_sources(panorama, white, found.factor);
  std::string said = fmt::format(
      "what is white in the panorama ({:.2g} % of all directions) is taken as light sources {:.3g} "
      "times as bright, since surfaces there would be whiter than white otherwise",
      100 * found.share, found.factor);
  if (found.factor_of_grey > worth_it * found.factor)
    said += fmt::format(
        ". If these surfaces are grey (albedo 0.5) and not white, {} {:.3g} is right, and "
        "shadows are deeper",
        request_name("clipped_light"), found.factor_of_grey);
  notes.say(said);
}

/// The light that exists only with the objects; none where it does not shine.
std::optional<Light> added_light(const CompositeRequest& request, const SeenPhoto& seen) {
  SceneDefinition definition = request.light.added;
  definition.name = "virtual light";
  definition.environment_radiance = {0, 0, 0};
  definition.bounces = request.bounces;
  Light light = scene_light(definition, {}, seen.centre_m);
  const auto is_black = [](const Rgb& light_of) { return !(light_of > 0.0F).any(); };
  std::erase_if(light.suns, [&](const Sun& sun) { return is_black(sun.irradiance_w_m2); });
  std::erase_if(light.lamps, [&](const Lamp& lamp) { return is_black(lamp.intensity_w_sr); });
  light.skips_sky = true;
  if (light.suns.empty() && light.lamps.empty()) return std::nullopt;
  return light;
}

void describe(const Light& light, std::vector<std::string>& text) {
  for (const Sun& sun : light.suns)
    text.push_back(fmt::format("sun towards {:.3g} {:.3g} {:.3g}, {} W/m2, radius {:.3g} degrees",
                               sun.to_sun.x(), sun.to_sun.y(), sun.to_sun.z(), three(sun.irradiance_w_m2),
                               double{sun.angular_radius_rad} * 180 / std::numbers::pi));
  for (const Lamp& lamp : light.lamps)
    text.push_back(fmt::format("{} at {:.3g} {:.3g} {:.3g} m from the camera, {} W/sr",
                               lamp.is_spot ? "spot lamp" : "lamp", lamp.position_m.x(), lamp.position_m.y(),
                               lamp.position_m.z(), three(lamp.intensity_w_sr)));
  if (light.environment)
    text.push_back(fmt::format("environment map, {} W/m2 in all", three(light.environment->total_w_m2())));
  else if ((light.environment_radiance > 0.0F).any())
    text.push_back("environment of " + three(light.environment_radiance) + " W/m2/sr");
}

/// The panorama whose texels are light: the photograph's own, or one that was taken at its place, scaled to
/// it. `white`: where its codes end, if it has codes.
Image light_panorama(const CompositeRequest& request, const SeenPhoto& seen, std::optional<float>& white,
                     Notes& notes) {
  if (request.light.panorama.empty()) {
    if (seen.panorama.width_px > 0) {
      if (seen.photograph.was_codes) white = 1.0F;
      return seen.panorama;
    }
    throw input_error({.field = request_name("light_from_photograph"),
                       .wanted = "a panorama, which shows where light comes from; or " +
                                 request_name("light_panorama") + " FILE beside it",
                       .found = "a photograph of one view"});
  }
  Photograph around = read_photograph(request.light.panorama, Projection::panorama);
  for (const std::string& note : around.notes) notes.say(printable(request.light.panorama) + ": " + note);
  if (const std::string warning = codes_warning(around, request.light.panorama); !warning.empty())
    notes.say(warning);
  const ViewMatch match = match_view(seen.photograph.radiance, seen.camera, around.radiance);
  if (match.likeness < least_likeness)
    throw input_error(
        {.file = request.light.panorama,
         .wanted = fmt::format("a panorama that shows in the photograph's view what the photograph shows "
                               "(likeness {} and more; see {} and {})",
                               least_likeness, request_name("look_at"), request_name("fov")),
         .found = fmt::format("a likeness of {:.2f}", match.likeness)});
  notes.say(
      fmt::format("{} is taken {:.3g} times, to be as bright as the photograph in its view (likeness {:.2f})",
                  printable(request.light.panorama), match.scale, match.likeness));
  for (float& value : around.radiance.values) value *= static_cast<float>(match.scale);
  if (around.was_codes) white = static_cast<float>(match.scale);
  return std::move(around.radiance);
}

}  // namespace

namespace {

KnownLight real_light(const CompositeRequest& request, const SeenPhoto& seen, const Geometry& depth,
                      Notes& notes) {
  KnownLight known{.light = given_light(request, seen), .text = {}};
  const bool has_given = shines(known.light);
  const bool from_photograph = request.light.from_photograph || !request.light.panorama.empty() ||
                               (!has_given && seen.panorama.width_px > 0);
  if (!from_photograph) {
    if (!has_given)
      throw input_error(
          {.field = "light",
           .wanted = request_name("to_sun") + " with " + request_name("sun_irradiance") + ", " +
                     request_name("environment") + ", " + request_name("environment_map") + ", " +
                     request_name("lamp") + ", " + request_name("light_panorama") + ", or the lights of " +
                     request_name("scene") + " or " + request_name("objects"),
           .found = "none, and a photograph of one view does not show where its light comes from"});
    describe(known.light, known.text);
    return known;
  }
  if (known.light.environment || (known.light.environment_radiance > 0.0F).any())
    throw input_error({.field = request_name("light_from_photograph"),
                       .wanted = "no environment beside it: the panorama shows what is around",
                       .found = "an environment"});
  Image panorama = light_panorama(request, seen, known.panorama_white, notes);
  for (float& value : panorama.values) value = std::max(0.0F, value);
  if (known.panorama_white) raise_clipped(request, depth, *known.panorama_white, panorama, notes);
  known.photographed = true;
  describe(known.light, known.text);
  known.text.insert(known.text.begin(),
                    "the panorama itself: every surface sends what the panorama shows of it");
  if (request.light.splits_sun && known.light.suns.empty()) {
    const auto is_sky = [&](const Eigen::Vector3f& direction) {
      return !depth.occluded({Eigen::Vector3f::Zero(), direction});
    };
    if (const auto split = split_sun(panorama, is_sky)) {
      known.light.suns.push_back(split->sun);
      known.text.push_back("sun split off: " + sun_text(*split));
    } else {
      known.text.push_back("no sun stands out in the panorama's sky");
    }
  }
  known.light.environment = std::make_shared<EnvironmentMap>(std::move(panorama), 0.0F);
  return known;
}

}  // namespace

KnownLight known_light(const CompositeRequest& request, const SeenPhoto& seen, const Geometry& depth,
                       Notes& notes) {
  KnownLight known = real_light(request, seen, depth, notes);
  known.added = added_light(request, seen);
  if (known.added) {
    known.text.emplace_back("and virtual ones, which exist only with the objects:");
    describe(*known.added, known.text);
  }
  return known;
}

void require_way_in(const KnownLight& known, const Geometry& depth, Notes& notes) {
  if (known.photographed || !known.light.lamps.empty()) return;
  const double open = open_share(depth);
  if (!(open > 0))
    throw input_error(
        {.field = "light",
         .wanted = "light inside the room (" + request_name("lamp") +
                   "; or none at all with a panorama, which is light itself)",
         .found = "a depth map that is closed all round, through which no sun and no environment shines"});
  if (open < 0.01)
    notes.say(fmt::format(
        "sun and environment shine in through {:.2g} % of all directions alone: elsewhere the depth "
        "map is closed",
        100 * open));
}

void look_for_spots(std::span<const std::shared_ptr<const SurfaceMesh>> objects, const DepthMesh& mesh,
                    double albedo, Light& light) {
  if (light.lamps.empty()) return;
  std::vector<std::shared_ptr<const SurfaceMesh>> everything = {surface_of_depth(mesh, albedo)};
  everything.insert(everything.end(), objects.begin(), objects.end());
  add_bright_patches({}, Geometry(everything), light);
}

}  // namespace seamline::renderer
