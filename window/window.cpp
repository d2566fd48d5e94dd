// The only file that includes GLFW.
#define GLFW_INCLUDE_GLEXT
#include "window/window.h"

#include <GLFW/glfw3.h>

#include <array>
#include <chrono>
#include <utility>

#include "support/text/error.h"

namespace seamline::inline window {
namespace {

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text == nullptr ? "none" : text;
}

constexpr std::array<std::pair<int, Key>, 13> named_keys = {{
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_DELETE, Key::remove},
}};

KeyPress key_press(int key, int modifiers, bool repeated) {
  KeyPress press{.shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                 .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                 .repeated = repeated};
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
    press.key = Key::digit;
    press.digit = key - GLFW_KEY_0;
  } else if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) {
    press.key = Key::digit;
    press.digit = key - GLFW_KEY_KP_0;
  } else if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
    press.key = Key::letter;
    press.letter = static_cast<char>('a' + (key - GLFW_KEY_A));
  }
  for (const auto& [code, name] : named_keys)
    if (code == key) press.key = name;
  return press;
}

using InputQueue = std::deque<RawInput>;

InputQueue& queue_of(GLFWwindow* window) {
  return *static_cast<InputQueue*>(glfwGetWindowUserPointer(window));
}

void on_key(GLFWwindow* window, int key, int /*scancode*/, int action, int modifiers) {
  if (action == GLFW_RELEASE) return;
  queue_of(window).emplace_back(KeyPressed{key_press(key, modifiers, action == GLFW_REPEAT), monotonic_ns()});
}

void on_character(GLFWwindow* window, unsigned character) {
  queue_of(window).emplace_back(CharacterTyped{static_cast<char32_t>(character)});
}

/// From the window system's units to framebuffer pixels.
void on_move(GLFWwindow* window, double x, double y) {
  int width = 0, height = 0, width_px = 0, height_px = 0;
  glfwGetWindowSize(window, &width, &height);
  glfwGetFramebufferSize(window, &width_px, &height_px);
  if (width <= 0 || height <= 0) return;
  queue_of(window).emplace_back(MouseMoved{{x * width_px / width, y * height_px / height}});
}

void on_button(GLFWwindow* window, int button, int action, int /*modifiers*/) {
  if (button != GLFW_MOUSE_BUTTON_LEFT && button != GLFW_MOUSE_BUTTON_RIGHT) return;
  const MouseButton which = button == GLFW_MOUSE_BUTTON_LEFT ? MouseButton::left : MouseButton::right;
  if (action == GLFW_PRESS)
    queue_of(window).emplace_back(MousePressed{monotonic_ns(), which});
  else
    queue_of(window).emplace_back(MouseReleased{which});
}

void on_scroll(GLFWwindow* window, double /*x*/, double y) {
  const bool shift = glfwGetKey(window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ||
                     glfwGetKey(window, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  queue_of(window).emplace_back(Scrolled{y, shift});
}

void on_focus(GLFWwindow* window, int focused) {
  queue_of(window).emplace_back(FocusChanged{focused == GLFW_TRUE, monotonic_ns()});
}

void on_size(GLFWwindow* window, int /*width*/, int /*height*/) {
  queue_of(window).emplace_back(WindowResized{monotonic_ns()});
}

void on_refresh(GLFWwindow* window) {
  queue_of(window).emplace_back(Exposed{});
}

void on_close(GLFWwindow* window) {
  glfwSetWindowShouldClose(window, GLFW_FALSE);  // whoever opened the window decides
  queue_of(window).emplace_back(CloseAsked{});
}

void set_hints(const GLFWvidmode* mode, const WindowRequest& request) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  glfwWindowHint(GLFW_RED_BITS, 8);
  glfwWindowHint(GLFW_GREEN_BITS, 8);
  glfwWindowHint(GLFW_BLUE_BITS, 8);
  glfwWindowHint(GLFW_ALPHA_BITS, 0);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SAMPLES, 0);                // nothing may mix neighbouring pixels
  glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_FALSE);  // nor encode codes that are encoded already
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);
  glfwWindowHint(GLFW_RESIZABLE, request.resizable ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
  if (request.fullscreen && mode != nullptr) glfwWindowHint(GLFW_REFRESH_RATE, mode->refreshRate);
}

}  // namespace

std::int64_t monotonic_ns() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

struct Window::Handles {
  std::deque<RawInput> queue;
  GLFWwindow* window = nullptr;
  Point mouse = {-1, -1};

  Handles() = default;
  ~Handles() {
    if (window != nullptr) glfwDestroyWindow(window);
    glfwTerminate();
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
};

void require_display() {
  if (glfwInit() == GLFW_TRUE) return;
  throw input_error({.field = "display",
                     .wanted = "a screen to show the pictures on",
                     .found = "none (" + last_glfw_error() + ")"});
}

Window::Window(const WindowRequest& request) {
  require_display();
  handles_ = std::make_unique<Handles>();
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (request.fullscreen && mode == nullptr)
    throw input_error({.field = "display", .wanted = "a monitor", .found = "none"});
  set_hints(mode, request);
  handles_->window =
      request.fullscreen
          ? glfwCreateWindow(mode->width, mode->height, request.title.c_str(), monitor, nullptr)
          : glfwCreateWindow(request.width_px, request.height_px, request.title.c_str(), nullptr, nullptr);
  if (handles_->window == nullptr)
    throw input_error({.field = "display",
                       .wanted = "a window with OpenGL 3",
                       .found = "none (" + last_glfw_error() + ")"});
  GLFWwindow* window = handles_->window;
  glfwSetWindowUserPointer(window, &handles_->queue);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_character);
  glfwSetCursorPosCallback(window, on_move);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetScrollCallback(window, on_scroll);
  glfwSetWindowFocusCallback(window, on_focus);
  glfwSetFramebufferSizeCallback(window, on_size);
  glfwSetWindowRefreshCallback(window, on_refresh);
  glfwSetWindowCloseCallback(window, on_close);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  glDisable(GL_DITHER);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

Window::~Window() = default;

FrameInput Window::next_input(std::optional<double> timeout_s) {
  InputQueue& queue = handles_->queue;
  if (!queue.empty() || (timeout_s && *timeout_s <= 0))
    glfwPollEvents();
  else if (timeout_s)
    glfwWaitEventsTimeout(*timeout_s);
  else
    glfwWaitEvents();
  FrameInput input = take_frame_input(queue, handles_->mouse, monotonic_ns());
  handles_->mouse = input.mouse;
  return input;
}

Size Window::framebuffer_px() const {
  int width_px = 0, height_px = 0;
  glfwGetFramebufferSize(handles_->window, &width_px, &height_px);
  return {static_cast<double>(width_px), static_cast<double>(height_px)};
}

bool Window::focused() const {
  return glfwGetWindowAttrib(handles_->window, GLFW_FOCUSED) == GLFW_TRUE;
}

DisplayInfo Window::display() const {
  DisplayInfo info;
  GLFWmonitor* monitor = glfwGetWindowMonitor(handles_->window);
  if (monitor == nullptr) monitor = glfwGetPrimaryMonitor();
  if (monitor != nullptr) {
    info.monitor = glfwGetMonitorName(monitor);
    int height_mm = 0;
    glfwGetMonitorPhysicalSize(monitor, &info.physical_width_mm, &height_mm);
    if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
      info.mode_width = mode->width;
      info.mode_height = mode->height;
      info.refresh_hz = mode->refreshRate;
    }
  }
  float scale = 1, scale_y = 1;
  glfwGetWindowContentScale(handles_->window, &scale, &scale_y);
  info.content_scale = static_cast<double>(scale);
  const Size size = framebuffer_px();
  info.framebuffer_width_px = static_cast<int>(size.width_px);
  info.framebuffer_height_px = static_cast<int>(size.height_px);
  if (const GLubyte* name = glGetString(GL_RENDERER)) info.graphics = reinterpret_cast<const char*>(name);
  return info;
}

void Window::clear(Colour colour) {
  const Size size = framebuffer_px();
  glViewport(0, 0, static_cast<int>(size.width_px), static_cast<int>(size.height_px));
  const auto unit = [](std::uint8_t code) { return static_cast<float>(code) / 255.0F; };
  glClearColor(unit(colour.red), unit(colour.green), unit(colour.blue), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

std::int64_t Window::show() {
  glfwSwapBuffers(handles_->window);
  glFinish();  // a swap may return before it is done
  return monotonic_ns();
}

ByteImage Window::read_back(int x_px, int y_px, int width_px, int height_px) const {
  ByteImage image{width_px, height_px, 3, {}};
  const std::size_t row = static_cast<std::size_t>(width_px) * 3;
  image.values.resize(row * static_cast<std::size_t>(height_px));
  const int buffer_height_px = static_cast<int>(framebuffer_px().height_px);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  for (int y = 0; y < height_px; ++y)  // OpenGL counts rows from below
    glReadPixels(x_px, buffer_height_px - 1 - (y_px + y), width_px, 1, GL_RGB, GL_UNSIGNED_BYTE,
                 image.values.data() + static_cast<std::size_t>(y) * row);
  return image;
}

}  // namespace seamline::inline window
