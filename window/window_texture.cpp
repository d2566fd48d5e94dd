#include "window/window_texture.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <cassert>
#include <utility>

namespace seamline::inline window {
namespace {

std::vector<std::uint8_t> as_rgb(const ByteImage& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.values.size() * 3);
  for (const std::uint8_t value : image.values) rgb.insert(rgb.end(), {value, value, value});
  return rgb;
}

void set_parameter(GLenum parameter, GLenum value) {
  glTexParameteri(GL_TEXTURE_2D, parameter, static_cast<GLint>(value));
}

/// Each pixel as it is.
void set_fixed_sampling() {
  set_parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  set_parameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  set_parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  set_parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

WindowTexture::~WindowTexture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

WindowTexture::WindowTexture(WindowTexture&& other) noexcept
    : name_(std::exchange(other.name_, 0)), width_px_(other.width_px_), height_px_(other.height_px_) {}

WindowTexture& WindowTexture::operator=(WindowTexture&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(width_px_, other.width_px_);
  std::swap(height_px_, other.height_px_);
  return *this;
}

void WindowTexture::upload(const ByteImage& image) {
  assert(image.channels == 1 || image.channels == 3);
  std::vector<std::uint8_t> expanded;
  if (image.channels == 1) expanded = as_rgb(image);
  const std::uint8_t* bytes = expanded.empty() ? image.values.data() : expanded.data();
  const bool fresh = name_ == 0;
  if (fresh) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  if (!fresh && width_px_ == image.width_px && height_px_ == image.height_px) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_px_, height_px_, GL_RGB, GL_UNSIGNED_BYTE, bytes);
    return;
  }
  width_px_ = image.width_px;
  height_px_ = image.height_px;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width_px_, height_px_, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes);
  set_fixed_sampling();
}

void WindowTexture::upload_coverage(int width_px, int height_px, std::span<const std::uint8_t> coverage) {
  if (width_px <= 0 || height_px <= 0) return;
  std::vector<std::uint8_t> white;
  white.reserve(coverage.size() * 4);
  for (const std::uint8_t alpha : coverage) white.insert(white.end(), {255, 255, 255, alpha});
  if (name_ == 0) glGenTextures(1, &name_);
  glBindTexture(GL_TEXTURE_2D, name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  width_px_ = width_px;
  height_px_ = height_px;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px_, height_px_, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
  set_fixed_sampling();
}

void WindowTexture::smooth(bool on) {
  glBindTexture(GL_TEXTURE_2D, name_);
  set_parameter(GL_TEXTURE_MIN_FILTER, on ? GL_LINEAR : GL_NEAREST);
  set_parameter(GL_TEXTURE_MAG_FILTER, on ? GL_LINEAR : GL_NEAREST);
}

}  // namespace seamline::inline window
