#include "composites/objects/placing.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "composites/objects/objects_file.h"
#include "composites/view/standing_place.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/running/overloaded.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_steps_back = 200;
constexpr double steep = 0.5;                         ///< a normal that rises less is a wall's
constexpr double least_size = 1e-3, most_size = 1e3;  ///< height in metres, or scale
constexpr const char* object_header = "[[object]]";
constexpr const char* made_by_remark = "# made by: ";

/// Degrees in (-180, 180].
double within_a_turn(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  return turned <= -180 ? turned + 360 : turned;
}

Eigen::Vector3d foot_on(const StoodOn& stood) {
  if (stood.normal.y() >= steep) return stood.place_m;
  const Eigen::Vector3d out(stood.normal.x(), 0, stood.normal.z());
  if (!(out.norm() > 1e-6)) return stood.place_m;  // a ceiling
  return stood.place_m + stood.half_width_m * out.normalized();
}

void resize(PlacedModel& model, double factor) {
  double& size = model.height_m ? *model.height_m : model.scale;
  size = std::clamp(size * factor, least_size, most_size);
}

}  // namespace

bool act(Placing& placing, const PlaceAction& action) {
  const auto keep = [&] {
    placing.before.push_back(placing.objects);
    if (placing.before.size() > most_steps_back) placing.before.erase(placing.before.begin());
  };
  const auto chosen = [&]() -> PlacedModel& { return placing.objects[placing.chosen]; };
  return std::visit(
      Overloaded{
          [&](const Chosen& which) {
            placing.chosen = std::min(which.object, placing.objects.size() - 1);
            return false;
          },
          [&](const NextChosen&) {
            placing.chosen = (placing.chosen + 1) % placing.objects.size();
            return false;
          },
          [&](const StoodOn& stood) {
            if (!stood.goes_on) keep();
            chosen().position_m = foot_on(stood);
            return true;
          },
          [&](const Shifted& shifted) {
            keep();
            chosen().position_m += shifted.by_m;
            return true;
          },
          [&](const Turned& turned) {
            keep();
            chosen().rotation_deg.y() = within_a_turn(chosen().rotation_deg.y() + turned.yaw_deg);
            return true;
          },
          [&](const Resized& resized) {
            keep();
            resize(chosen(), resized.factor);
            return true;
          },
          [&](const Duplicated&) {
            keep();
            PlacedModel copy = chosen();
            copy.position_m.x() += 0.2;
            placing.objects.push_back(std::move(copy));
            placing.chosen = placing.objects.size() - 1;
            return true;
          },
          [&](const Removed&) {
            if (placing.objects.size() == 1) return false;
            keep();
            placing.objects.erase(placing.objects.begin() + static_cast<std::ptrdiff_t>(placing.chosen));
            placing.chosen = std::min(placing.chosen, placing.objects.size() - 1);
            return true;
          },
          [&](const TakenBack&) {
            if (placing.before.empty()) return false;
            placing.objects = std::move(placing.before.back());
            placing.before.pop_back();
            placing.chosen = std::min(placing.chosen, placing.objects.size() - 1);
            return true;
          },
      },
      action);
}

std::vector<std::string> stand_in_view(std::vector<PlacedModel>& objects,
                                       const std::vector<double>& half_widths_m, const Camera& camera,
                                       const Geometry& depth, const Eigen::Vector3d& centre_m) {
  constexpr std::array columns = {0.5, 0.35, 0.65, 0.2, 0.8};  // of the picture's width
  std::vector<std::string> put;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    PlacedModel& object = objects[i];
    if (object.has_place) continue;
    const auto real = place_in_view(camera, depth, centre_m, columns[put.size() % columns.size()]);
    if (!real) continue;
    object.position_m =
        foot_on({.place_m = real->place_m, .normal = real->normal, .half_width_m = half_widths_m[i]});
    object.has_place = true;
    const Eigen::Vector3d& at = object.position_m;
    put.push_back(fmt::format(
        "{} has no position: it is put at {:.3f},{:.3f},{:.3f}, onto the surface that the picture shows at "
        "{:.0f} % of its width and {:.0f} % of its height{}",
        printable(object.file), at.x(), at.y(), at.z(), 100 * real->across, 100 * real->down,
        real->normal.y() >= steep ? "" : ", which nothing can stand on"));
  }
  return put;
}

std::string placing_text(const PlacedModel& model) {
  const Eigen::Vector3d& at = model.position_m;
  return fmt::format("{}: {:.3f} {:.3f} {:.3f} m, turned {:.0f} degrees, {}", printable(model.file), at.x(),
                     at.y(), at.z(), model.rotation_deg.y(),
                     model.height_m ? fmt::format("{:.2f} m tall", *model.height_m)
                                    : fmt::format("scale {:.3g}", model.scale));
}

OpenedObjects open_objects(const fs::path& file, const fs::path& asset_root) {
  const std::string text = read_file(file);
  ObjectsFile read = parse_objects_file(text, file, asset_root);
  OpenedObjects opened{std::move(read.objects), {}};
  std::size_t from = 0;
  while (from < text.size() && text.compare(from, std::string(object_header).size(), object_header) != 0) {
    const std::size_t end = text.find('\n', from);
    from = end == std::string::npos ? text.size() : end + 1;
  }
  opened.head = text.substr(0, from);
  const std::string again = opened.head + objects_file_text(opened.objects);
  const ObjectsFile as_saved = parse_objects_file(again, file, asset_root);
  if (read.has_light != as_saved.has_light || read.added.has_value() != as_saved.added.has_value())
    throw input_error({.file = file.string(),
                       .field = "light",
                       .wanted = "light before the first [[object]], so that it stays when objects are moved",
                       .found = "light after it"});
  return opened;
}

PlacedModel new_object(const std::string& named) {
  PlacedModel model;
  model.path = resolve_named_file(named, request_name("add"));
  model.file = named;
  model.height_m = 0.5;
  model.stands = true;
  model.has_place = false;
  return model;
}

fs::path name_for(const fs::path& objects_file, std::vector<PlacedModel>& objects) {
  const fs::path folder = fs::weakly_canonical(fs::absolute(objects_file)).parent_path();
  std::optional<fs::path> common;
  for (PlacedModel& model : objects) {
    if (model.file.starts_with("builtin:")) continue;
    const fs::path whole = fs::weakly_canonical(fs::absolute(model.path));
    const fs::path relative = whole.lexically_relative(folder);
    const bool is_below = !relative.empty() && *relative.begin() != "..";
    model.file = is_below ? relative.generic_string() : whole.generic_string();
    if (is_below) continue;
    const fs::path in = whole.parent_path(), so_far = common.value_or(in);
    const auto end = std::mismatch(so_far.begin(), so_far.end(), in.begin(), in.end()).first;
    common.emplace();
    for (auto part = so_far.begin(); part != end; ++part) *common /= *part;
  }
  return common.value_or(fs::path());
}

void save_objects(const fs::path& file, const std::string& head, const std::string& command,
                  const std::vector<PlacedModel>& objects) {
  const bool has_remark = head.starts_with(made_by_remark);
  const std::size_t end = has_remark ? head.find('\n') : std::string::npos;
  const std::string rest = !has_remark ? head : end == std::string::npos ? "" : head.substr(end + 1);
  write_file_atomically(file, made_by_remark + command + "\n" + rest + objects_file_text(objects));
}

}  // namespace seamline::renderer
