#include "renderer/set_claim.h"

#include <gtest/gtest.h>

#include <optional>

#include "stimuli/support/error.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

TEST(SetClaim, IsSharedByEqualInputsAndRefusedToOthersUntilTheLastIsGone) {
  const fs::path set = fs::path(SEAMLINE_TEST_OUTPUT) / "claimed-set";
  fs::remove_all(set);
  fs::create_directories(set / "records");
  std::optional<SetClaim> one(std::in_place, set, "inputs a"), other(std::in_place, set, "inputs a");
  EXPECT_THROW(SetClaim(set, "inputs b"), InputError);
  one.reset();
  EXPECT_THROW(SetClaim(set, "inputs b"), InputError);
  other.reset();
  EXPECT_NO_THROW(SetClaim(set, "inputs b"));
  EXPECT_NO_THROW(SetClaim(set, "inputs a"));
}

}  // namespace
}  // namespace seamline
