// Every room says what it offers in ROOM/ROOM.h, and each of these headers stands alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "analysis/analysis.h"
#include "composites/composites.h"
#include "laboratory/laboratory.h"
#include "live/live.h"
#include "physics/physics.h"
#include "raytracer/raytracer.h"
#include "registration/registration.h"
#include "renderer/renderer.h"
#include "scenes/scenes.h"
#include "sensors/sensors.h"
#include "sets/sets.h"
#include "stimuli/stimuli.h"
#include "study/study.h"
#include "support/support.h"
#include "tests/program/run_program.h"
#include "x3d/x3d.h"

namespace seamline {
namespace {

TEST(RoomHeaders, SayWhatARoomIsInTheWordsOfTheMap) {
  const std::filesystem::path root = SEAMLINE_SOURCE_DIR;
  int rooms = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root)) {
    const std::string room = entry.path().filename().string();
    const std::filesystem::path header = entry.path() / (room + ".h");
    if (room == "window" || !std::filesystem::exists(header)) continue;
    ++rooms;
    const std::string text = test::read_text(header);
    EXPECT_NE(text.find("// " + room + "/: "), std::string::npos) << header;
    EXPECT_LE(text.size(), 1500U) << header;
  }
  EXPECT_EQ(rooms, 15);  // all but window, whose header is a class, and commands
}

}  // namespace
}  // namespace seamline
