// Doubles on a boundary of 64 bytes, where packs of eight of them can be loaded whole.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace fiberfate {

/// An array that kernels work on; it is not initialised.
class AlignedArray {
 public:
  /// Makes room for `count` doubles, a multiple of eight; what was there is lost when the array grows.
  void reserve(std::size_t count) {
    if (count <= capacity_) return;
    void* memory = std::aligned_alloc(64, count * sizeof(double));
    if (memory == nullptr) throw std::bad_alloc();
    memory_.reset(static_cast<double*>(memory));
    capacity_ = count;
  }
  [[nodiscard]] double* data() { return memory_.get(); }
  [[nodiscard]] const double* data() const { return memory_.get(); }

 private:
  struct Free {
    void operator()(double* memory) const { std::free(memory); }
  };
  std::size_t capacity_ = 0;
  std::unique_ptr<double[], Free> memory_;
};

}  // namespace fiberfate
