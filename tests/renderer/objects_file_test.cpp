// The file of objects that `place` writes and `composite` reads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "composites/objects/objects_file.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

TEST(ObjectsFile, IsReadAsItWasWrittenAndRefusesWhatItDoesNotKnow) {
  const fs::path path = fs::path(SEAMLINE_TEST_OUTPUT) / "objects.toml";
  PlacedModel model;
  model.file = "builtin:lion";
  model.position_m = {0.25, -1, -3.5};
  model.rotation_deg = {0, 30, 0};
  model.height_m = 0.75;
  model.stands = true;
  model.roughness = 0.25;
  const ObjectsFile read = parse_objects_file(objects_file_text({model}), path, {});
  ASSERT_EQ(read.objects.size(), 1U);
  EXPECT_EQ(objects_file_text(read.objects), objects_file_text({model}));
  EXPECT_FALSE(read.has_light);
  const auto said = [&](const std::string& text) {
    return complaint_of([&] { static_cast<void>(parse_objects_file(text, path, {})); });
  };
  const std::string object = "[[object]]\nfile = \"builtin:lion\"\nposition_m = [0, 0, -3]\n";
  EXPECT_EQ(said(object), "no complaint");
  EXPECT_THAT(said(object + "hight_m = 1\n"), AllOf(HasSubstr("object[0].hight_m"), HasSubstr("height_m")));
  EXPECT_THAT(said(object + "height_m = 1\nscale = 2\n"), HasSubstr("not both"));
  EXPECT_THAT(said(object + "materials = \"diffuse\"\nroughness = 0.2\n"), HasSubstr("roughness"));
  const auto unplaced = parse_objects_file("[[object]]\nfile = \"builtin:lion\"\n", path, {});
  EXPECT_FALSE(unplaced.objects.at(0).has_place);
  EXPECT_TRUE(unplaced.objects.at(0).stands);
  EXPECT_THAT(said("[[object]]\nfile = \"none.glb\"\nposition_m = [0, 0, 0]\n"), HasSubstr("none.glb"));
  EXPECT_THAT(said(""), HasSubstr("[[object]]"));
  EXPECT_THAT(said("albedo = 0.3\n" + object), HasSubstr("albedo, which the composite is asked with"));
  const ObjectsFile lit =
      parse_objects_file("suns = [{ to_sun = [0, 1, 0], irradiance_w_m2 = [1, 1, 1] }]\n" + object, path, {});
  EXPECT_TRUE(lit.has_light);
  EXPECT_EQ(lit.light.suns->size(), 1U);
}

}  // namespace
}  // namespace seamline::renderer
