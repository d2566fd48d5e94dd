// Data URIs and names of files, as other people's programs write them.
#include <gtest/gtest.h>

#include "raytracer/scene/gltf/gltf_uri.h"

namespace seamline::renderer {
namespace {

TEST(GltfUri, BytesAreTheSameHoweverTheUriIsWritten) {
  for (const char* uri : {"data:application/octet-stream;base64,AAECAwQ=", "DATA:image/PNG;BASE64,AAECAwQ=",
                          "data:;base64,AAECAwQ=", "data:image/png;charset=utf-8;base64,AAECAwQ=",
                          "data:image/jpg;base64,AAECAwQ", "data:image/png;base64,AAEC\r\n AwQ=\n",
                          "data:image/png;base64,AAECAwQ%3D", "data:image/png;base64,%41AECAwQ=",
                          "data:application/octet-stream,%00%01%02%03%04"})
    EXPECT_EQ(data_of_uri(uri), std::string("\0\1\2\3\4", 5)) << uri;
  EXPECT_EQ(data_of_uri("data:;base64,-_8"), data_of_uri("data:;base64,+/8="));
  EXPECT_EQ(data_of_uri("data:text/plain,a%20b"), "a b");
}

TEST(GltfUri, WhatIsNoDataSaysSo) {
  EXPECT_FALSE(is_data_uri("database.bin"));
  for (const char* uri : {"data:;base64,A*B=", "data:image/png;base64", "buffer.bin", ""})
    EXPECT_FALSE(data_of_uri(uri)) << uri;
}

TEST(GltfUri, NamesAreDecodedAndStepsUpAndDownLeftOut) {
  EXPECT_EQ(file_of_uri("right%20up.png"), "right up.png");
  EXPECT_EQ(file_of_uri("./tex%2Ftures/../a.png"), "tex/a.png");
  EXPECT_EQ(file_of_uri("textures\\a.png"), "textures/a.png");
  EXPECT_EQ(file_of_uri("100%.png"), "100%.png");
  EXPECT_EQ(file_of_uri("a/../../b.png"), "../b.png");
}

}  // namespace
}  // namespace seamline::renderer
