#include "page_commands_photographs.h"

#include <fmt/core.h>

#include <functional>
#include <vector>

#include "board_pictures.h"
#include "page_commands_files.h"
#include "run_program.h"

namespace seamline::page_commands {
namespace {

using test::write_text;

/// A floor and a wall in a photograph that is wide enough for the pixels that the page names.
constexpr PlainRoom street = {
    .focal_px = 700, .floor_m = 1.65, .wall_m = 20, .width_px = 1000, .height_px = 700};
constexpr PlainRoom desk = {.focal_px = 300, .floor_m = 1.2, .wall_m = 4, .width_px = 240, .height_px = 180};

DepthNumbers depth_numbers(const PlainRoom& room, const std::function<double(double)>& of_depth) {
  return {room.width_px, room.height_px, [room, of_depth](int, int y) { return of_depth(room.depth_m(y)); }};
}

}  // namespace

std::string street_photograph() {
  ByteImage picture{street.width_px, street.height_px, 3, {}};
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x)
      for (int channel = 0; channel < 3; ++channel)
        picture.values.push_back(static_cast<std::uint8_t>(90 + (x / 40 + y / 40) % 2 * 60 + 10 * channel));
  return jpeg_of(picture);
}

std::string street_camera() {
  return fmt::format("S_rect_02: {0} {1}\nP_rect_02: {2} 0 {3} 0 0 {2} {4} 0 0 0 1 0\n", street.width_px,
                     street.height_px, street.focal_px, 0.5 * street.width_px, 0.5 * street.height_px);
}

std::string desk_camera() {
  const auto camera = [](const char* name, int width_px, int height_px) {
    return fmt::format(
        "[{}]\nwidth_px = {}\nheight_px = {}\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = {}\n", name,
        width_px, height_px, desk.focal_px, desk.focal_px, 0.5 * width_px, 0.5 * height_px);
  };
  return "format = \"seamline camera 1\"\nconvention = \"planar\"\nmetres_per_step = 0.001\n" +
         camera("depth", desk.width_px, desk.height_px) + camera("colour", 320, 240) +
         "[colour_from_depth]\ntranslation_m = [-0.025, 0, 0]\n";
}

void make_board_pictures(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const test::Board board{.columns = 10, .rows = 7, .square_m = 0.03};
  const sensors::PinholeCamera depth = sensors::pinhole_of_field_of_view(desk.width_px, desk.height_px, 50),
                               colour = sensors::pinhole_of_field_of_view(320, 240, 54);
  const Eigen::Isometry3d pose = sensors::pose_of({-0.025, 0.002, 0}, {0, 1, 0}, 1.5);
  Random random(3);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Isometry3d place = test::next_board_place(board, random);
    write_png(folder / fmt::format("ir{}.png", i), test::chessboard_picture(board, depth, place));
    write_png(folder / fmt::format("rgb{}.png", i), test::chessboard_picture(board, colour, pose * place));
  }
}

void make_depth_frames(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (int i = 0; i < 3; ++i)
    write_text(folder / fmt::format("frame{}.png", i),
               png_of(depth_numbers(desk, [i](double depth_m) { return 1000 * depth_m + i; })));
}

void make_pairs(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  ByteImage picture{96, 54, 3, std::vector<std::uint8_t>(std::size_t{96} * 54 * 3, 99)};
  write_png(folder / "reference.png", picture);
  for (const auto& [name, code] : {std::pair("0064.png", 160), std::pair("0256.png", 130),
                                   std::pair("0512.png", 112), std::pair("1024.png", 104)}) {
    for (int x = 30; x < 45; ++x)
      for (std::size_t channel = 0; channel < 3; ++channel)
        picture.values[(std::size_t{20} * 96 + static_cast<std::size_t>(x)) * 3 + channel] =
            static_cast<std::uint8_t>(code);
    write_png(folder / name, picture);
  }
}

std::string street_depth() {
  return png_of(depth_numbers(street, [](double depth_m) { return 256 * depth_m; }));
}

std::string street_inverse_depth() {
  return png_of(depth_numbers(street, [](double depth_m) { return 60000 / depth_m; }));
}

std::string desk_depth() {
  return pgm_of(depth_numbers(desk, [](double depth_m) { return 1000 * depth_m; }));
}

}  // namespace seamline::page_commands
