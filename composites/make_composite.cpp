#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "composites/change_probe.h"
#include "composites/composite_light.h"
#include "composites/composite_report.h"
#include "composites/composite_request.h"
#include "composites/fast_photo.h"
#include "composites/given_answers.h"
#include "composites/objects/placing.h"
#include "composites/photo_world.h"
#include "composites/seamless_width.h"
#include "raytracer/common/parallel.h"
#include "raytracer/common/stopwatch.h"
#include "raytracer/scene/seen_surface.h"
#include "renderer/depth/budget/budgeted_panorama.h"
#include "renderer/depth/budget/samples_picture.h"
#include "renderer/picture/rare_light.h"
#include "sets/set_layers.h"
#include "support/running/progress.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

/// Of objects of which the picture would show nothing: before it is rendered.
[[noreturn]] void refuse_without_effect(const ObjectSight& sight, bool shadows) {
  const std::string where =
      sight.pixels == 0 ? std::string("none: they are outside of the picture, or smaller than a pixel")
                        : fmt::format("none: they are hidden, {:.3g} m away, by real surfaces {:.3g} m away",
                                      sight.nearest_m, sight.scene_there_m);
  throw input_error(
      {.field = request_name("position"),
       .wanted = "objects that change the picture (" + request_name("look_at") +
                 " shows another part of a panorama; without " + request_name("position") +
                 " an object is put into the picture's middle)",
       .found = where +
                (shadows ? ", and of their shadow and light less than a ten-thousandth falls into it" : "")});
}

/// Says where objects are that are seen badly, and whether they can be seen at all.
void judge_sight(const ObjectSight& sight, Notes& notes) {
  if (sight.pixels == 0) {
    notes.say("no object is in the picture: only its shadow or its light could be seen");
  } else if (sight.visible_pixels == 0) {
    notes.say(
        fmt::format("the objects are hidden by the local scene: where they are nearest, {:.3g} m away, it is "
                    "{:.3g} m away",
                    sight.nearest_m, sight.scene_there_m));
  } else if (sight.behind_share > 0.25) {
    notes.say(fmt::format(
        "{:.0f} % of the objects' corners lie behind the surfaces of the depth map: inside a wall, a "
        "floor or a thing, or hidden by it",
        100 * sight.behind_share));
  }
}

std::string model_text(const PhotoObjects::Size& size) {
  const Eigen::Vector3d sides = size.high_m - size.low_m;
  Eigen::Vector3d middle = 0.5 * (size.high_m + size.low_m);
  middle = (middle.array().abs() < 1e-9 * sides.maxCoeff()).select(0.0, middle);  // what rounding leaves
  return fmt::format(
      "{}: {:.3g} x {:.3g} x {:.3g} m (right, up, back), its middle at {:.3g} {:.3g} {:.3g}, {} triangles",
      printable(size.file), sides.x(), sides.y(), sides.z(), middle.x(), middle.y(), middle.z(),
      size.triangles);
}

/// Rendered by the estimator that was asked for, or that can.
struct Rendered {
  PhotoEstimate estimate;
  Estimator by = Estimator::path;
  double seconds = 0;
};

Rendered render(const CompositeRequest& request, const PhotoScene& scene, const PhotoMeshes& meshes,
                const std::string& title) {
  const bool can_be_fast = fast_can_render(scene);
  Rendered out;
  out.by = request.estimator.value_or(can_be_fast ? Estimator::fast : Estimator::path);
  if (out.by == Estimator::fast && !can_be_fast)
    throw input_error(
        {.field = request_name("estimator"),
         .wanted = "path beside " + request_name("occlusion") +
                   " none, where nothing real shades the objects, beside " + request_name("shadows") +
                   " none, virtual light and beside a lens that leaves the picture's corners empty",
         .found = "fast"});
  std::optional<Progress> progress;  // its clock begins with the samples: what goes before would be scaled up
  const PassOptions pass{.spp = request.spp,
                         .seed = request.seed,
                         .threads = request.threads,
                         .progress = [&, last = 0.0](double share) mutable {
                           if (!progress) return void(progress.emplace(title, 1.0));
                           if (share > last) progress->advance(share - last, "");
                           last = std::max(last, share);
                         }};
  const Stopwatch watch;
  if (out.by == Estimator::fast) {
    out.estimate = photo_by_fast(scene, meshes, request.error, request.exposure_ev, pass);
  } else {
    PhotoScene traced = scene;
    const auto seen = seen_objects(scene, meshes, request.threads);
    traced.seen = seen.get();
    out.estimate = photo_by_path(traced, request.error, request.exposure_ev, pass);
  }
  out.seconds = watch.seconds();
  return out;
}

/// Pixels that differ from the photograph's by no more than adding up equal samples makes are the
/// photograph's own again; returns whether any do not.
bool keep_untouched(const Image& photograph, Image& picture) {
  constexpr float rounding = 2e-5F;
  bool changed = false;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const Rgb before = photograph.rgb(x, y);
      if (((picture.rgb(x, y) - before).abs() <= rounding * before.abs()).all())
        picture.set_rgb(x, y, before);
      else
        changed = true;
    }
  return changed;
}

/// Pixels that a screen shows otherwise than the photograph's: of other 8-bit codes.
std::size_t count_shown_otherwise(const Image& photograph, const Image& picture, double exposure_ev) {
  const ByteImage before = display_image(photograph, exposure_ev),
                  after = display_image(picture, exposure_ev);
  const auto channels = static_cast<std::size_t>(after.channels);
  std::size_t count = 0;
  for (std::size_t i = 0; i < after.values.size(); i += channels)
    count += std::equal(after.values.begin() + static_cast<std::ptrdiff_t>(i),
                        after.values.begin() + static_cast<std::ptrdiff_t>(i + channels),
                        before.values.begin() + static_cast<std::ptrdiff_t>(i))
                 ? 0
                 : 1;
  return count;
}

/// Light on the objects in the whole picture.
bool objects_are_lit(const StimulusSums& sums) {
  for (const auto& half : sums.halves)
    for (const StimulusPixel& pixel : half)
      if ((pixel.object > 0.0F).any()) return true;
  return false;
}

/// Distance of the local scene along each pixel's ray, 0 in holes.
Image depth_image(const Camera& camera, const Geometry& depth) {
  Image image(camera.width_px, camera.height_px, 1);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const auto hit = seen_surface(camera, depth, x, y);
      image.at(x, y) = hit ? hit->distance_m : 0.0F;
    }
  return image;
}

void write_layers(const CompositeRequest& request, const PhotoScene& scene, const StimulusSums& sums,
                  const Composite& composite) {
  const LayerImages images = layer_images(sums);
  const Image depth = depth_image(scene.camera, scene.depth);
  Image holes = depth;
  for (float& value : holes.values) value = value > 0.0F ? 0.0F : 1.0F;
  write_layers_exr(request.layers, {{"composite", &composite.picture},
                                    {"photograph", &scene.photograph},
                                    {"ratio", &composite.ratio},
                                    {"with_objects", &images.with_object},
                                    {"without_objects", &images.without_object},
                                    {"objects", &images.object},
                                    {"depth_m", &depth},
                                    {"holes", &holes}});
}

void write_picture(const CompositeRequest& request, const Image& picture, const ColourProfile* profile) {
  if (lower_case_ending(request.out) == ".exr")
    write_picture_exr(request.out, picture);
  else
    write_png(request.out, picture, request.exposure_ev, profile);
}

/// What decides the width of the panorama that the local scene is seen through, if anything does.
struct ChosenWidth {
  std::optional<int> width_px;
  std::optional<SeamlessWidth> by_thresholds;
};

/// The thresholds that were asked for; says which numbers of a report they are, and whether of people.
std::vector<SeamThresholds> thresholds_for(const CompositeRequest& request, Notes& notes) {
  if (request.thresholds.empty()) return paper_thresholds();
  StudyThresholds read = read_thresholds(request.thresholds, request.condition);
  const std::string file = printable(request.thresholds);
  const std::string source = read.source.empty() ? "" : ", of " + printable(read.source);
  notes.tell(fmt::format("thresholds of {}: {}{}", file,
                         read.joint ? "those of the joint model" : "the paper's way", source));
  if (read.simulated)
    notes.say(file + ": its answers are those of simulated people, so that its widths say nothing of people");
  return std::move(read.artifacts);
}

ChosenWidth choose_width(const CompositeRequest& request, const PhotoScene& scene, Notes& notes) {
  if (!request.seamless) return {request.depth_width_px, {}};
  const SeamlessWidth width =
      seamless_width(present_artifacts(scene, !request.occlusion_mask.empty(), !request.shadow_matte.empty()),
                     thresholds_for(request, notes));
  for (const WidthNeed& need : width.needs)
    notes.tell(fmt::format("{}: {} ({})", word(need.artifact),
                           need.width_px ? fmt::format("{} px", *need.width_px) : "no width", need.rule));
  if (width.needs.empty())
    notes.say("no artifact is present, so that the smallest width that was tested is enough");
  if (!width.width_px)
    notes.say("no width is known to be enough by the thresholds: the whole depth map is used");
  return {width.width_px, width};
}

/// Samples of the whole local scene, spent where wrong depth would show.
DepthMesh budgeted_mesh(const CompositeRequest& request, const PhotoScene& scene, MadeComposite& made) {
  ShownWeights weights =
      where_it_shows({scene.depth, scene.objects, scene.light, scene.camera, request.threads});
  BudgetedMesh spent = spend_samples(scene.depth, *request.depth_samples, &weights, 0, request.threads);
  made.depth_text +=
      fmt::format("; of it {} samples, spent where wrong depth would show", spent.measured + spent.holes);
  return std::move(spent.mesh);
}

}  // namespace

void make_composite(const CompositeRequest& asked, const CompositeListener& listener) {
  CompositeRequest request = asked;
  if (request.threads == 0) request.threads = default_thread_count();
  request.depth.threads = request.threads;
  Notes notes(listener);
  PhotoWorld world;
  world.seen = see(request, notes);
  const SeenPhoto& seen = world.seen;
  PhotoObjects objects = place_objects(request.objects, seen.centre_m);
  for (const std::string& sentence : objects.left_out) notes.say(sentence);
  MadeComposite made;
  made.photograph = &seen.photograph.radiance;

  read_photo_world(request, world, notes);
  const PhotoDepth& depth = world.depth;
  const KnownLight& known = world.known;
  PhotoLocalScene& local = world.local;
  std::vector<double> half_widths_m;
  for (const PhotoObjects::Size& size : objects.sizes) half_widths_m.push_back(half_width_m(size));
  const auto put = stand_in_view(request.objects, half_widths_m, seen.camera, *local.geometry, seen.centre_m);
  for (const PlacedModel& model : request.objects)
    if (!model.has_place)
      throw input_error({.field = request_name("position"),
                         .wanted = "the object's place, since the picture shows no depth around its middle "
                                   "to put it on",
                         .found = "none"});
  if (!put.empty() || std::any_of(request.objects.begin(), request.objects.end(),
                                  [](const PlacedModel& m) { return m.rest; }))
    objects = place_objects(request.objects, seen.centre_m, &local.mesh);
  for (const PhotoObjects::Size& size : objects.sizes) made.objects.push_back(model_text(size));
  made.light = known.text;
  for (const std::string& light : made.light) notes.tell("light: " + light);
  for (const std::string& object : made.objects) notes.tell("object " + object);
  for (const std::string& sentence : put) notes.tell(sentence);
  for (const std::string& sentence : objects.rests) notes.tell(sentence);

  const Geometry object_geometry(objects.meshes);
  const GivenAnswers given = given_answers(request, seen, depth);
  made.answers = answers_text(request);
  for (const std::string& answer : made.answers) notes.tell(answer);
  if (given.shadow_matte && known.light.suns.empty())
    throw input_error({.field = request_name("shadow_matte"),
                       .wanted = "a sun, whose shadow it shows",
                       .found = "light without one"});
  const auto photo_scene = [&](const PhotoLocalScene& scene) {
    return PhotoScene{.photograph = seen.photograph.radiance,
                      .camera = seen.camera,
                      .depth = *scene.geometry,
                      .objects = object_geometry,
                      .light = scene.light,
                      .occlusion = given.occlusion(request.occlusion),
                      .shadow_matte = given.shadow_matte ? &*given.shadow_matte : nullptr,
                      .added = known.added ? &*known.added : nullptr,
                      .shadows = request.shadows,
                      .compositing = request.additive ? Compositing::additive : Compositing::ratio};
  };
  const ObjectSight sight = look_at_objects(seen.camera, *local.geometry, object_geometry, objects);
  if (!may_change(photo_scene(local), sight, request.threads)) refuse_without_effect(sight, request.shadows);
  if (!objects.meshes.empty()) judge_sight(sight, notes);
  const ChosenWidth chosen = choose_width(request, photo_scene(local), notes);
  made.width = chosen.by_thresholds;
  made.depth_text = fmt::format(
      "{}, {} x {}, {:.1f} % holes", printable(request.depth.file), depth.width_px, depth.height_px,
      100.0 * static_cast<double>(depth.holes) / (double{1} * depth.width_px * depth.height_px));
  std::optional<PhotoLocalScene> finest;
  if (chosen.width_px && depth.map && *chosen.width_px >= depth.width_px) {
    notes.say(fmt::format("the depth map has {} texels a row, so that it is used as it is", depth.width_px));
  } else if (chosen.width_px || request.depth_samples) {
    const Stopwatch watch;
    DepthMesh mesh = request.depth_samples ? budgeted_mesh(request, photo_scene(local), made)
                                           : reduced_photo_mesh(local.mesh, *chosen.width_px, request.depth);
    if (mesh.triangles.empty())
      throw input_error(
          {.field = request.depth_samples ? request_name("depth_samples") : request_name("depth_width"),
           .wanted = "so much that something of the depth map is left",
           .found = std::to_string(request.depth_samples.value_or(chosen.width_px.value_or(0)))});
    if (chosen.width_px)
      made.depth_text += fmt::format("; of it a panorama of {} x {}", *chosen.width_px, *chosen.width_px / 2);
    std::shared_ptr<Geometry> geometry = geometry_of(mesh, request.albedo);
    PhotoLocalScene reduced =
        local_scene_of(std::move(mesh), std::move(geometry), known, request, watch.seconds());
    finest = std::move(local);
    local = std::move(reduced);
  }
  look_for_spots(objects.meshes, local.mesh, request.albedo, local.light);
  if (world.known.added) look_for_spots(objects.meshes, local.mesh, request.albedo, *world.known.added);
  const PhotoScene scene = photo_scene(local);
  const auto meshes_of = [&](const PhotoLocalScene& of) {
    return PhotoMeshes{surface_of_depth(of.mesh, request.albedo), objects.meshes};
  };
  const Compositing compositing = scene.compositing;
  Rendered rendered = render(request, scene, meshes_of(local), "composite");
  const PhotoSums& sums = rendered.estimate.sums;
  made.picture = compose_photo(sums, compositing, request.threads);
  if (!keep_untouched(*made.photograph, made.picture.picture))
    throw input_error({.field = request_name("position"),
                       .wanted = "objects that change the picture",
                       .found = "none: not one pixel is another than the photograph's"});
  made.changed_pixels = count_shown_otherwise(*made.photograph, made.picture.picture, request.exposure_ev);
  if (look_at_objects(seen.camera, *local.geometry, object_geometry, {}).visible_pixels > 0 &&
      !objects_are_lit(sums))
    notes.say("no light reaches the objects: they are black");
  made.estimator = word(rendered.by);
  made.taken = rendered.estimate.taken;
  if (!request.error && made.taken.most != request.spp)
    notes.say(fmt::format("the fast estimator takes samples in pairs: {} a pixel, where {} {} was asked for",
                          made.taken.most, request_name("spp"), request.spp));
  if (!rendered.estimate.error.tiles.empty()) {
    made.error = rendered.estimate.error.rmse();
    made.worst_tile = rendered.estimate.error.worst_tile();
    if (request.error && !(*made.error <= *request.error))
      notes.say(fmt::format("the error that was asked for, {:g}, was not reached", *request.error));
    if (request.error && sums.added[0].empty() &&
        rare_light_share(sums, made.picture.picture, request.exposure_ev, request.threads) > much_rare_light)
      notes.say(
          "a fifth or more of the estimated error is in one pixel of 500: rare bright light, which other "
          "pixels may not have met yet, so that the error may be larger");
  }
  made.triangles = local.mesh.triangles.size();
  made.mesh_seconds = local.seconds;
  made.picture_seconds = rendered.seconds;
  made.notes = notes.said;
  write_picture(request, made.picture.picture, seen.photograph.profile.get());
  if (!request.layers.empty()) write_layers(request, scene, sums, made.picture);
  if (!request.local_scene.empty())
    write_png(request.local_scene, display_image(shaded_picture(seen.camera, *local.geometry)));
  if (!request.samples_picture.empty())
    write_png(request.samples_picture,
              display_image(samples_picture(local.mesh, seen.camera, made.picture.picture, request.threads),
                            request.exposure_ev));
  if (!request.report.empty()) {
    made.local_scene = shaded_picture(seen.camera, *local.geometry);
    std::optional<FullDepth> full;
    if (finest) {
      Rendered finer = render(request, photo_scene(*finest), meshes_of(*finest), "full depth");
      full = FullDepth{compose_photo(finer.estimate.sums, compositing, request.threads),
                       finest->mesh.triangles.size(), finer.seconds + finest->seconds};
      keep_untouched(*made.photograph, full->picture.picture);
    }
    write_composite_report(request, made, full);
  }
  notes.tell(fmt::format("{}: {} x {} pixels, {} of them changed; {} triangles; {}, {}{}; {:.1f} s",
                         request.out, scene.camera.width_px, scene.camera.height_px, made.changed_pixels,
                         made.triangles, made.estimator, samples_text(made.taken),
                         made.error ? fmt::format(", estimated error {:.4f}", *made.error) : "",
                         made.mesh_seconds + made.picture_seconds));
  notes.tell(fmt::format("{} had too little light for a ratio, {} clamped",
                         counted(made.picture.tiny_denominators.floored_pixels, "pixel"),
                         counted(made.picture.tiny_denominators.clamped_pixels, "was", "were")));
}

}  // namespace seamline::renderer
