#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace seamline::study::online {

/// Something between the spaces of a file of results.
struct ResultValue {
  enum class Kind {
    whole,    ///< a JSON object from its first brace to its last
    foreign,  ///< whatever else there is
    cut       ///< the beginning of an object, and nothing after it
  };
  Kind kind = Kind::whole;
  std::string_view text;
  int line = 1;           ///< where it begins
  int last_line = 1;      ///< where it ends
  int value_in_line = 1;  ///< 1: the first that begins there
};

/// Takes a file of results apart: objects tell their own ends, so it does not matter what lies between them
/// (line ends, or none; an array's brackets and commas; byte order marks). What is no object ends with its
/// line, and nothing goes on into the next message. The time is linear in the bytes.
class ResultValues {
 public:
  /// `bytes` must outlive this and the values.
  explicit ResultValues(std::string_view bytes) : bytes_(bytes) {}

  /// False when there is nothing more.
  [[nodiscard]] bool next(ResultValue& value);

 private:
  void skip_space();
  /// Where the next message begins, from `from` on; the size of the file when there is none.
  std::size_t next_message(std::size_t from);
  void pass(std::size_t end);

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t known_message_ = 0;  ///< the last answer of `next_message`
  int line_ = 1, value_in_line_ = 0;
  bool in_array_ = false;
};

}  // namespace seamline::study::online
