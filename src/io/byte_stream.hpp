// Packs values into bytes for another process of the same program, and takes them out again.
#pragma once

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fiberfate {

/// Puts values one behind the other.
class ByteWriter {
 public:
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      put(value.size());
      bytes_ += value;
    } else {  // a list
      put(value.size());
      for (const auto& item : value) put(item);
    }
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Takes values out in the order in which they were put.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  /// Raises std::runtime_error where the bytes end too early.
  template <class T>
  void take(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      std::memcpy(static_cast<void*>(&value), piece(sizeof value).data(), sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
      value = piece(take<std::size_t>());
    } else {  // a list
      const auto count = take<std::size_t>();
      value.clear();
      for (std::size_t i = 0; i < count; ++i) take(value.emplace_back());
    }
  }
  template <class T>
  [[nodiscard]] T take() {
    T value{};
    take(value);
    return value;
  }

 private:
  std::string_view piece(std::size_t size) {
    if (size > rest_.size()) throw std::runtime_error("the other process ended in the middle of its answer");
    const std::string_view found = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return found;
  }
  std::string_view rest_;
};

}  // namespace fiberfate
