#include "renderer/set/sharing/set_running.h"

#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds between_marks{10};

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

}  // namespace

RunningMark::RunningMark(const fs::path& set_folder, std::string name, int stimuli)
    : path_(set_folder / "records" / "running" / (name + ".json")),
      name_(std::move(name)),
      stimuli_(stimuli) {
  prepare_output_folder(path_.parent_path());
  write({});
}

RunningMark::~RunningMark() {
  std::error_code error;
  if (!failed_) fs::remove(path_, error);
}

void RunningMark::finished_one() {
  ++done_;
  alive();
}

void RunningMark::alive() {
  if (std::chrono::steady_clock::now() - written_ >= between_marks) write({});
}

void RunningMark::failed(const std::string& complaint) {
  write(complaint);
  failed_ = true;
}

void RunningMark::write(const std::string& complaint) {
  nlohmann::ordered_json json = {
      {"element", name_}, {"host", host_name()}, {"done", done_}, {"of", stimuli_}};
  if (!complaint.empty()) json["failed"] = complaint;
  write_file_atomically(path_, json.dump() + "\n");
  written_ = std::chrono::steady_clock::now();
}

}  // namespace seamline::renderer
