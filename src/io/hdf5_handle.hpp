// Owns identifiers of the HDF5 library and turns its errors into exceptions; only sources of io include it.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {

/// What was being done, for the message of an error.
struct Hdf5Action {
  const char* doing;        ///< "cannot write"
  const std::string& file;  ///< path
  const std::string& name;  ///< dataset, group or attribute; may be empty
};

/// Makes the error of a failed call: action, place, and the innermost reason that the library gives.
[[nodiscard]] StorageError hdf5_error(const Hdf5Action& action);

/// Raises StorageError where a file is too small to hold so many bytes, even if they are compressed: damage
/// must not ask for more memory than a file is worth.
void require_stored(hid_t file, std::uint64_t bytes, const Hdf5Action& action);

/// Raises the error of a call that returned a negative value; hands other values through.
template <class Result>
Result checked(Result result, const Hdf5Action& action) {
  if (result < 0) throw hdf5_error(action);
  return result;
}

/// Owns one identifier.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close close, const Hdf5Action& action) : id_(checked(id, action)), close_(close) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: stands for its identifier in every call of the library

 private:
  hid_t id_;
  Close close_;
};

}  // namespace fiberfate
