#pragma once
#include <cstring>
#include <initializer_list>
#include <string>

namespace seamline::test {

/// Values as they lie in a buffer of glTF.
template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}

}  // namespace seamline::test
