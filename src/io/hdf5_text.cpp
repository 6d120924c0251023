// Stores texts in HDF5 files and explains the library's errors.
#include <cerrno>
#include <cstdlib>
#include <string_view>

#include "io/disk_faults.hpp"
#include "io/hdf5_file.hpp"
#include "io/hdf5_handle.hpp"

namespace fiberfate {
namespace {

/// Makes the type of a text of fixed length, which every reader understands (VTK reads no other in
/// attributes).
Hdf5Handle text_type(const std::string& text, const Hdf5Action& action) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, action);
  checked(H5Tset_size(type, text.empty() ? 1 : text.size()), action);
  checked(H5Tset_strpad(type, H5T_STR_NULLPAD), action);
  return type;
}

/// The error number in a reason of the file driver, "…, errno = 28, error message = 'No space left on
/// device', …"; 0 where there is none.
int error_number_in(const std::string& reason) {
  static const std::string mark = "errno = ";
  const std::size_t begin = reason.find(mark);
  return begin == std::string::npos ? 0 : std::atoi(reason.c_str() + begin + mark.size());
}

std::string innermost_reason() {
  std::string reason;
  const auto take_first = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t {
    auto& first = *static_cast<std::string*>(text);
    if (first.empty() && error->desc != nullptr) first = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &reason);
  return reason.empty() ? "the HDF5 library gives no reason" : reason;
}

}  // namespace

StorageError hdf5_error(const Hdf5Action& action) {
  std::string message = std::string(action.doing) + ' ' + action.file;
  if (!action.name.empty() && action.name != action.file) message += " (" + action.name + ')';
  const std::string reason = innermost_reason();
  int number = error_number_in(reason);
  // Where a dataset fails to write as it is closed, the library tells later, and not why.
  if (number == 0 && std::string_view(action.doing) != "cannot read" && is_disk_full(action.file))
    number = ENOSPC;
  return StorageError(message + ": " + (number != 0 ? reason_text(number) : reason));
}

void require_stored(hid_t file, std::uint64_t bytes, const Hdf5Action& action) {
  constexpr std::uint64_t most_inflation = 1032;  // of deflate: no stored byte becomes more
  hsize_t size = 0;
  checked(H5Fget_filesize(file, &size), action);
  if (bytes / most_inflation > size)
    throw StorageError(std::string(action.doing) + ' ' + action.file + " (" + action.name +
                       "): it says that it is larger than its file can hold; the file is damaged");
}

void Hdf5File::write_text(const std::string& name, const std::string& text) {
  const Hdf5Action action{"cannot write", path_, name};
  const Hdf5Handle type = text_type(text, action);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, action);
  const Hdf5Handle dataset(H5Dcreate2(id_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           H5Dclose, action);
  checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), action);
}

std::string Hdf5File::read_text(const std::string& name) const {
  const Hdf5Action action{"cannot read", path_, name};
  const Hdf5Handle dataset(H5Dopen2(id_, name.c_str(), H5P_DEFAULT), H5Dclose, action);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, action);
  require_stored(id_, H5Tget_size(type), action);
  std::string text(H5Tget_size(type), '\0');
  checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), action);
  return text.c_str();
}

void Hdf5File::write_text_attribute(const std::string& object, const std::string& name,
                                    const std::string& text) {
  const Hdf5Action action{"cannot write", path_, name};
  const Hdf5Handle type = text_type(text, action);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, action);
  const Hdf5Handle attribute(H5Acreate_by_name(id_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                               H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, action);
  checked(H5Awrite(attribute, type, text.c_str()), action);
}

std::string Hdf5File::read_text_attribute(const std::string& object, const std::string& name) const {
  const Hdf5Action action{"cannot read", path_, name};
  const Hdf5Handle attribute(H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, action);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose, action);
  require_stored(id_, H5Tget_size(type), action);
  std::string text(H5Tget_size(type), '\0');
  checked(H5Aread(attribute, type, text.data()), action);
  return text.c_str();
}

}  // namespace fiberfate
