// `read_photograph` on a file as a camera writes it.
#include "composites/photograph.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace seamline::renderer {
namespace {

/// A JPEG file of 16 x 8 pixels, its left half white, its right half black, whose EXIF orientation (6) says
/// that it was taken with the camera turned: it is to be turned clockwise.
constexpr std::string_view turned_jpeg =
    "ffd8ffe1002245786966000049492a0008000000010012010300010000000600000000000000ffdb004300100b0c0e0c"
    "0a100e0d0e1211101318281a181616183123251d283a333d3c3933383740485c4e404457453738506d51575f62676867"
    "3e4d71797064785c656763ffdb0043011112121815182f1a1a2f63423842636363636363636363636363636363636363"
    "6363636363636363636363636363636363636363636363636363636363636363ffc00011080008001003012200021101"
    "031101ffc4001f0000010501010101010100000000000000000102030405060708090a0bffc400b51000020103030204"
    "03050504040000017d01020300041105122131410613516107227114328191a1082342b1c11552d1f02433627282090a"
    "161718191a25262728292a3435363738393a434445464748494a535455565758595a636465666768696a737475767778"
    "797a838485868788898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3"
    "d4d5d6d7d8d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9faffc4001f0100030101010101010101010000000000"
    "000102030405060708090a0bffc400b51100020102040403040705040400010277000102031104052131061241510761"
    "711322328108144291a1b1c109233352f0156272d10a162434e125f11718191a262728292a35363738393a4344454647"
    "48494a535455565758595a636465666768696a737475767778797a82838485868788898a92939495969798999aa2a3a4"
    "a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3d4d5d6d7d8d9dae2e3e4e5e6e7e8e9eaf2f3f4f5f6f7"
    "f8f9faffda000c03010002110311003f00f40af9fe8a2803ffd9";

std::string bytes_of(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

TEST(Photograph, IsTurnedAsItsExifOrientationSays) {
  const auto folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / "photograph";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "turned.jpg", std::ios::binary) << bytes_of(turned_jpeg);
  const Photograph photograph = read_photograph(folder / "turned.jpg", std::nullopt);
  ASSERT_EQ(photograph.radiance.width_px, 8);
  ASSERT_EQ(photograph.radiance.height_px, 16);
  EXPECT_EQ(photograph.orientation, 6);
  EXPECT_GT(photograph.radiance.rgb(4, 2).minCoeff(), 0.9F);
  EXPECT_LT(photograph.radiance.rgb(4, 13).maxCoeff(), 0.1F);
}

}  // namespace
}  // namespace seamline::renderer
