#include "sets/sharing/set_running.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "support/files/atomic_file.h"
#include "support/files/held/byte_lock.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds between_marks{10};

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// Names the running kernel: processes that say the same see each other's locks on every file system.
std::string kernel_name() {
  try {
    return read_file("/proc/sys/kernel/random/boot_id", 64);
  } catch (const InputError&) {
    return {};
  }
}

fs::path marks_folder(const fs::path& set_folder) {
  return set_folder / "records" / "running";
}

/// Opens the file with the locks, which the claim of the set has made.
int open_locks(const fs::path& set_folder, int access) {
  return ::open((set_folder / "records" / "rendered-with").c_str(),
                access | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
}

/// The byte that bears a name: FNV-1a, far beyond the bytes of the claim.
ByteRange byte_of(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return {.begin = static_cast<off_t>(4096 + hash % (std::uint64_t{1} << 40U))};
}

/// A mark as its file says it, and which kernel would know whether its process lives.
struct MarkFile {
  FoundMark mark;
  std::string kernel;
  bool locked = false;
};

bool is_count(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || (found->is_number_unsigned() && *found <= 1'000'000'000);
}

template <class T>
T value_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end()) return {};
  return found->get<T>();
}

/// None where it is no mark, or was removed meanwhile.
std::optional<MarkFile> read_mark(const fs::path& path) {
  constexpr std::int64_t most_bytes = 1 << 16;
  try {
    const std::string text = read_file(path, most_bytes);
    require_bounded_json(text, path.string());
    const Json json = Json::parse(text);
    if (!json.is_object() || !is_count(json, "done") || !is_count(json, "of")) return std::nullopt;
    return MarkFile{.mark = {.name = path.stem().string(),
                             .host = value_of<std::string>(json, "host"),
                             .complaint = value_of<std::string>(json, "failed"),
                             .done = value_of<int>(json, "done"),
                             .of = value_of<int>(json, "of")},
                    .kernel = value_of<std::string>(json, "kernel"),
                    .locked = value_of<bool>(json, "locked")};
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

/// What the clock says that files of this folder get their times from: another computer's, on a network.
fs::file_time_type clock_of(const fs::path& folder) {
  try {
    const TemporaryFolder made_now(folder / "clock");
    return fs::last_write_time(made_now.path());
  } catch (const InputError&) {
    return fs::file_time_type::clock::now();  // a viewer who may not write there
  }
}

}  // namespace

RunningMark::RunningMark(const fs::path& set_folder, std::string name, int done, int stimuli)
    : path_(marks_folder(set_folder) / (name + ".json")),
      name_(std::move(name)),
      done_(done),
      stimuli_(stimuli),
      lock_(open_locks(set_folder, O_RDWR)),
      locked_(lock_ >= 0 && lock_bytes(lock_, byte_of(name_), F_WRLCK, F_OFD_SETLK) == Lock::taken) {
  prepare_output_folder(path_.parent_path());
  write();
}

RunningMark::~RunningMark() {
  std::error_code error;
  fs::remove(path_, error);
  if (lock_ >= 0) ::close(lock_);  // last: who sees no lock reads the mark once more
}

void RunningMark::finished_one() {
  ++done_;
  alive();
}

void RunningMark::alive() {
  if (std::chrono::steady_clock::now() - written_ >= between_marks) write();
}

void RunningMark::write() {
  const Json json = {{"element", name_},  {"host", host_name()}, {"kernel", kernel_name()},
                     {"locked", locked_}, {"done", done_},       {"of", stimuli_}};
  write_file_atomically(path_, json.dump() + "\n");
  written_ = std::chrono::steady_clock::now();
}

void leave_complaint(const fs::path& set_folder, const std::string& name, const std::string& complaint) {
  prepare_output_folder(marks_folder(set_folder));
  const Json json = {{"element", name}, {"host", host_name()}, {"failed", complaint}};
  write_file_atomically(marks_folder(set_folder) / (name + ".json"),
                        json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::vector<FoundMark> read_marks(const fs::path& set_folder) {
  std::vector<MarkFile> found;
  const fs::path folder = marks_folder(set_folder);
  const int locks = open_locks(set_folder, O_RDONLY);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path& path = entry.path();
    if (path.extension() != ".json" || path.stem().string().starts_with(".")) continue;
    if (!entry.is_regular_file(error)) continue;  // a pipe would be waited for
    std::optional<MarkFile> file = read_mark(path);
    if (!file) continue;
    if (locks >= 0 && is_locked(locks, byte_of(file->mark.name)))
      file->mark.life = FoundMark::Life::working;
    else
      file = read_mark(path);  // who ended in between has removed it, or left a complaint
    if (!file) continue;
    found.push_back(std::move(*file));
  }
  if (locks >= 0) ::close(locks);
  if (found.empty()) return {};
  const std::string here = kernel_name();
  // One lock of another machine that is seen shows that they are seen here.
  const bool sees_others = std::any_of(found.begin(), found.end(), [&](const MarkFile& file) {
    return file.mark.life == FoundMark::Life::working && file.kernel != here;
  });
  const fs::file_time_type now = clock_of(folder);
  std::vector<FoundMark> out;
  for (MarkFile& file : found) {
    FoundMark& mark = file.mark;
    if (mark.life == FoundMark::Life::not_known && file.locked &&
        (sees_others || (!here.empty() && file.kernel == here)))
      mark.life = FoundMark::Life::ended;
    const fs::file_time_type written = fs::last_write_time(folder / (mark.name + ".json"), error);
    if (!error) mark.age_s = std::chrono::duration<double>(now - written).count();
    out.push_back(std::move(mark));
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return out;
}

}  // namespace seamline::renderer
