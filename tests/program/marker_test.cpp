// `seamline lab marker`: what it needs, said in one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "registration/calibration/aruco.h"
#include "run_program.h"

namespace seamline {
namespace {

using test::run_seamline;
using testing::HasSubstr;

TEST(Marker, SaysWhatItNeeds) {
  const std::string out = (test::fresh_folder("marker") / "out").string();
  const test::Outcome scanner = run_seamline("lab marker --sensor scanner_360 --out " + out);
  EXPECT_EQ(scanner.status, 1);
  EXPECT_THAT(scanner.output,
              HasSubstr(registration::has_aruco()
                            ? "--sensor: wanted a depth camera with a colour camera, found scanner_360"
                            : "marker: wanted a Seamline that was built with OpenCV's ArUco"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_NE(run_seamline("lab marker --side 3 --out " + out).status, 0);
}

}  // namespace
}  // namespace seamline
