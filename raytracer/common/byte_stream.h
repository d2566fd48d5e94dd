#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::renderer {

/// Values one after another, as they lie in memory: for files that only this program on such a machine reads.
/// Of plain values without pointers and padding; the caller sees to that.
class ByteWriter {
 public:
  template <class Value>
  void put(const Value& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void put_all(const std::vector<Value>& values) {
    put(std::uint64_t{values.size()});
    if (!values.empty())
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// The same values back. What is read past the end, or of another size than is wanted, makes it fail; from
/// then on all values are zero.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  void get(Value& value) {
    take(&value, sizeof value);
  }
  /// As many values as are wanted; any other number fails.
  template <class Value>
  void get_all(std::vector<Value>& values, std::size_t wanted) {
    std::uint64_t count = 0;
    get(count);
    if (count != wanted || wanted > bytes_.size() / sizeof(Value)) {
      fail();
      return;
    }
    values.resize(wanted);
    if (wanted > 0) take(values.data(), wanted * sizeof(Value));
  }
  /// As many values as there are, at most `most`.
  template <class Value>
  void get_some(std::vector<Value>& values, std::size_t most) {
    std::uint64_t count = 0;
    if (bytes_.size() >= sizeof count) std::memcpy(&count, bytes_.data(), sizeof count);
    if (count > most) {
      fail();
      return;
    }
    get_all(values, static_cast<std::size_t>(count));
  }
  /// Whether all was there and nothing is left.
  [[nodiscard]] bool is_done() const { return !failed_ && bytes_.empty(); }
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  void fail() {
    failed_ = true;
    bytes_ = {};
  }
  void take(void* to, std::size_t count) {
    if (count > bytes_.size()) {
      fail();
      return;
    }
    std::memcpy(to, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }

  std::string_view bytes_;
  bool failed_ = false;
};

}  // namespace seamline::renderer
