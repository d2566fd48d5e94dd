#include "window/panorama_view.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <string>

#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::inline window {
namespace {

constexpr const char* vertex_shader = R"glsl(#version 130
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }
)glsl";

// As study/online/page/web/panorama.js has it.
constexpr const char* fragment_shader = R"glsl(#version 130
uniform sampler2D panorama;
uniform mat3 axes;
uniform vec2 half_tangents, corner_px, view_px;
out vec4 colour;
vec3 code(ivec2 at, ivec2 size) {
  return texelFetch(panorama, ivec2((at.x + size.x) % size.x, clamp(at.y, 0, size.y - 1)), 0).rgb;
}
void main() {
  vec3 d = axes * vec3(((gl_FragCoord.xy - corner_px) / view_px * 2.0 - 1.0) * half_tangents, -1.0);
  ivec2 size = textureSize(panorama, 0);
  vec2 turns = vec2(atan(d.x, -d.z) * 0.15915494309189535 + 0.5, 0.5 - atan(d.y, length(d.xz)) * 0.3183098861837907);
  vec2 p = turns * vec2(size) - 0.5, f = fract(p);
  ivec2 at = ivec2(floor(p));
  vec3 upper = mix(code(at, size), code(at + ivec2(1, 0), size), f.x);
  vec3 lower = mix(code(at + ivec2(0, 1), size), code(at + ivec2(1, 1), size), f.x);
  colour = vec4(mix(upper, lower, f.y), 1);
}
)glsl";

void add_shader(GLuint program, GLenum kind, const char* text) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // once the program goes
}

}  // namespace

PanoramaView::~PanoramaView() {
  if (program_ != 0) glDeleteProgram(program_);
  if (corners_ != 0) glDeleteVertexArrays(1, &corners_);
}

void PanoramaView::prepare() {
  program_ = glCreateProgram();
  add_shader(program_, GL_VERTEX_SHADER, vertex_shader);
  add_shader(program_, GL_FRAGMENT_SHADER, fragment_shader);
  glLinkProgram(program_);
  GLint linked = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    std::string said(500, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program_, static_cast<GLsizei>(said.size()), &length, said.data());
    said.resize(length);
    throw input_error({.field = "display",
                       .wanted = "OpenGL 3 with its shaders, which views of panoramas need",
                       .found = printable(said, 200)});
  }
  glGenVertexArrays(1, &corners_);
}

void PanoramaView::draw(const WindowTexture& panorama, const Rect& rect, Size framebuffer_px,
                        const PanoramaPose& pose) {
  if (program_ == 0) prepare();
  const int x_px = static_cast<int>(rect.x_px), width_px = static_cast<int>(rect.width_px),
            height_px = static_cast<int>(rect.height_px),
            y_px = static_cast<int>(framebuffer_px.height_px - rect.bottom_px());  // OpenGL counts from below
  std::array<float, 9> axes{};
  std::transform(pose.axes.begin(), pose.axes.end(), axes.begin(),
                 [](double value) { return static_cast<float>(value); });
  glViewport(x_px, y_px, width_px, height_px);
  for (const GLenum off : {GL_BLEND, GL_DITHER, GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE}) glDisable(off);
  glUseProgram(program_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, panorama.name());
  const auto at = [&](const char* name) { return glGetUniformLocation(program_, name); };
  glUniform1i(at("panorama"), 0);
  glUniformMatrix3fv(at("axes"), 1, GL_FALSE, axes.data());
  glUniform2f(at("half_tangents"), static_cast<float>(pose.half_tangents[0]),
              static_cast<float>(pose.half_tangents[1]));
  glUniform2f(at("corner_px"), static_cast<float>(x_px), static_cast<float>(y_px));
  glUniform2f(at("view_px"), static_cast<float>(width_px), static_cast<float>(height_px));
  glBindVertexArray(corners_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
}

}  // namespace seamline::inline window
