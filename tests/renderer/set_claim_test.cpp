#include "sets/sharing/set_claim.h"

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <thread>
#include <vector>

#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::renderer {
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

TEST(SetClaim, IsTakenByManyAtOnce) {
  const fs::path set = fs::path(SEAMLINE_TEST_OUTPUT) / "claimed-by-many";
  fs::remove_all(set);
  fs::create_directories(set / "records");
  std::atomic<int> refused = 0;
  std::vector<std::thread> shards;
  for (int shard = 0; shard < 64; ++shard)
    shards.emplace_back([&] {
      try {
        const SetClaim claim(set, "inputs a");
      } catch (const InputError&) {
        ++refused;
      }
    });
  for (std::thread& shard : shards) shard.join();
  EXPECT_EQ(refused, 0);
}

TEST(SetClaim, WritesNothingThroughALink) {
  const fs::path set = fs::path(SEAMLINE_TEST_OUTPUT) / "claimed-link";
  fs::remove_all(set);
  fs::create_directories(set / "records");
  write_file_atomically(set / "of somebody", "kept");
  fs::create_symlink("../of somebody", set / "records" / "rendered-with");
  EXPECT_THROW(SetClaim(set, "inputs a"), InputError);
  EXPECT_EQ(read_file(set / "of somebody"), "kept");
}

}  // namespace
}  // namespace seamline::renderer
