// Opens HDF5 files and moves numbers in and out of their datasets.
#include "io/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "base/memory.hpp"
#include "io/hdf5_handle.hpp"
#include "io/input_file.hpp"

namespace fiberfate {
namespace {

constexpr std::uint64_t checksum_chunk_rows = 1 << 16;
constexpr unsigned deflate_level = 4;
constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max();

/// Prepares the library once: no messages of its own, no clean-up at exit that would retry a failed write.
void prepare_library() {
  static const bool prepared = [] {
    H5dont_atexit();
    H5open();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return true;
  }();
  static_cast<void>(prepared);
}

hid_t type_of(Element element) {
  switch (element) {
    case Element::float64:
      return H5T_NATIVE_DOUBLE;
    case Element::float32:
      return H5T_NATIVE_FLOAT;
    case Element::int64:
      return H5T_NATIVE_INT64;
    case Element::int32:
      return H5T_NATIVE_INT32;
    case Element::uint32:
      return H5T_NATIVE_UINT32;
    case Element::uint16:
      return H5T_NATIVE_UINT16;
    case Element::uint8:
      return H5T_NATIVE_UINT8;
  }
  return H5I_INVALID_HID;
}

Element element_of_type(hid_t type) {
  for (const Element element : {Element::float64, Element::float32, Element::int64, Element::int32,
                                Element::uint32, Element::uint16, Element::uint8}) {
    if (H5Tequal(type, type_of(element)) > 0) return element;
  }
  throw StorageError("an HDF5 dataset has an element type that this program does not write");
}

/// Makes the access list of all files: metadata with checksums, and no lock files, for a reader must not stop
/// a run.
Hdf5Handle access_list(const std::string& path) {
  const Hdf5Action action{"cannot open", path, path};
  Hdf5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, action);
  checked(H5Pset_libver_bounds(list, H5F_LIBVER_V18, H5F_LIBVER_V110), action);
  checked(H5Pset_file_locking(list, 0, 1), action);
  return list;
}

Hdf5Handle link_list(const Hdf5Action& action) {
  Hdf5Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose, action);
  checked(H5Pset_create_intermediate_group(list, 1), action);
  return list;
}

/// The first (rows) and second (columns) length of a dataset or of a part of it.
struct Lengths {
  std::array<hsize_t, 2> lengths{0, 1};
  int dimensions = 1;

  Lengths(hsize_t rows, int columns) : lengths{rows, static_cast<hsize_t>(std::max(columns, 1))} {
    dimensions = columns == 0 ? 1 : 2;
  }
  explicit Lengths(const Hdf5Handle& dataset, const Hdf5Action& action) {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose, action);
    dimensions = checked(H5Sget_simple_extent_ndims(space), action);
    if (dimensions > 2) throw hdf5_error(action);
    checked(H5Sget_simple_extent_dims(space, lengths.data(), nullptr), action);
  }
};

Hdf5Handle simple_space(const Lengths& lengths, const hsize_t* most, const Hdf5Action& action) {
  return {H5Screate_simple(lengths.dimensions, lengths.lengths.data(), most), H5Sclose, action};
}

Hdf5Handle open_dataset(hid_t file, const Hdf5Action& action) {
  return {H5Dopen2(file, action.name.c_str(), H5P_DEFAULT), H5Dclose, action};
}

Hdf5Handle select_rows(const Hdf5Handle& dataset, RowRange range, const Hdf5Action& action) {
  Lengths lengths(dataset, action);
  Hdf5Handle space(H5Dget_space(dataset), H5Sclose, action);
  const std::array<hsize_t, 2> start{range.first, 0};
  lengths.lengths[0] = range.count;
  checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, lengths.lengths.data(), nullptr),
          action);
  return space;
}

/// What the chunks, filters and caches of one file take; the library crashes where its own allocations fail.
constexpr std::size_t room_of_a_file = 16 << 20;

}  // namespace

Hdf5File::Hdf5File(std::int64_t id, std::string path) : id_(id), path_(std::move(path)) {}

Hdf5File Hdf5File::create(const std::string& path) {
  prepare_library();
  require_room(room_of_a_file);
  const Hdf5Handle access = access_list(path);
  return {checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), {"cannot create", path, {}}),
          path};
}

Hdf5File Hdf5File::open(const std::string& path, Access access) {
  prepare_library();
  require_room(room_of_a_file);
  // The library would wait for a pipe for ever.
  if (const std::string fault = reading_fault(path, any_size); !fault.empty())
    throw StorageError(fmt::format("cannot open {}: {}", path, fault));
  const Hdf5Handle list = access_list(path);
  const unsigned flags = access == Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
  return {checked(H5Fopen(path.c_str(), flags, list), {"cannot open", path, {}}), path};
}

Hdf5File::~Hdf5File() {
  if (id_ >= 0) H5Fclose(id_);
}

Hdf5File::Hdf5File(Hdf5File&& other) noexcept
    : id_(std::exchange(other.id_, -1)), path_(std::move(other.path_)) {}

Hdf5File& Hdf5File::operator=(Hdf5File&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(path_, other.path_);
  return *this;
}

void Hdf5File::close() {
  checked(H5Fflush(id_, H5F_SCOPE_GLOBAL), {"cannot write", path_, {}});
  checked(H5Fclose(std::exchange(id_, -1)), {"cannot write", path_, {}});
}

bool Hdf5File::contains(const std::string& name) const {
  // The library wants every group on the way to be asked for in turn.
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1)) {
    if (H5Lexists(id_, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(id_, name.c_str(), H5P_DEFAULT) > 0;
}

std::uint64_t Hdf5File::rows(const std::string& name) const {
  const Hdf5Action action{"cannot read", path_, name};
  const auto [rows, columns] = Lengths(open_dataset(id_, action), action).lengths;
  require_stored(id_, columns > 0 && rows > any_size / columns ? any_size : rows * columns, action);
  return rows;
}

std::uint64_t Hdf5File::columns(const std::string& name) const {
  const Hdf5Action action{"cannot read", path_, name};
  return Lengths(open_dataset(id_, action), action).lengths[1];
}

void Hdf5File::require_columns(const std::string& name, std::uint64_t wanted) const {
  const std::uint64_t found = columns(name);
  if (found != wanted)
    throw StorageError(fmt::format("cannot read {}: dataset {} has rows of {} numbers where {} belong", path_,
                                   name, found, wanted));
}

TableLayout Hdf5File::layout(const std::string& name) const {
  const Hdf5Action action{"cannot read", path_, name};
  const Hdf5Handle dataset = open_dataset(id_, action);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose, action);
  const Hdf5Handle plist(H5Dget_create_plist(dataset), H5Pclose, action);
  const Lengths lengths(dataset, action);
  std::array<hsize_t, 2> chunk{1, 1};
  checked(H5Pget_chunk(plist, lengths.dimensions, chunk.data()), action);
  TableLayout layout;
  layout.element = element_of_type(type);
  layout.columns = lengths.dimensions == 1 ? 0 : static_cast<int>(lengths.lengths[1]);
  layout.chunk_rows = chunk[0];
  layout.compression = checked(H5Pget_nfilters(plist), action) > 0 ? TableLayout::Compression::deflate
                                                                   : TableLayout::Compression::none;
  return layout;
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  const Hdf5Action action{"cannot list", path_, group};
  const Hdf5Handle handle(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose, action);
  std::vector<std::string> names;
  const auto visit = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  checked(H5Literate(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, visit, &names), action);
  return names;
}

void Hdf5File::make_group(const std::string& name) {
  const Hdf5Action action{"cannot make", path_, name};
  const Hdf5Handle links = link_list(action);
  const Hdf5Handle group(H5Gcreate2(id_, name.c_str(), links, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, action);
}

void Hdf5File::write_bytes(const std::string& name, const TableLayout& layout, std::uint64_t count,
                           const void* bytes) {
  const Hdf5Action action{"cannot write", path_, name};
  const Lengths lengths(count / static_cast<std::uint64_t>(std::max(layout.columns, 1)), layout.columns);
  const Hdf5Handle space = simple_space(lengths, nullptr, action);
  const Hdf5Handle links = link_list(action);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
  if (count > 0) {
    Lengths chunk = lengths;
    chunk.lengths[0] = std::min<hsize_t>(chunk.lengths[0], checksum_chunk_rows);
    checked(H5Pset_chunk(creation, chunk.dimensions, chunk.lengths.data()), action);
    checked(H5Pset_fletcher32(creation), action);
  }
  const hid_t type = type_of(layout.element);
  const Hdf5Handle dataset(H5Dcreate2(id_, name.c_str(), type, space, links, creation, H5P_DEFAULT), H5Dclose,
                           action);
  if (count > 0) checked(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes), action);
}

void Hdf5File::require_rows(const std::string& name, RowRange range) const {
  const std::uint64_t there = rows(name);
  if (range.first > there || range.count > there - range.first)
    throw StorageError("cannot read " + path_ + " (" + name + "): it has fewer rows than a frame counts");
}

void Hdf5File::read_bytes(const std::string& name, Element element, RowRange range, void* bytes) const {
  if (range.count == 0) return;
  const Hdf5Action action{"cannot read", path_, name};
  const Hdf5Handle dataset = open_dataset(id_, action);
  const Hdf5Handle rows = select_rows(dataset, range, action);
  Lengths lengths(dataset, action);
  lengths.lengths[0] = range.count;
  const Hdf5Handle memory = simple_space(lengths, nullptr, action);
  checked(H5Dread(dataset, type_of(element), memory, rows, H5P_DEFAULT, bytes), action);
}

void Hdf5File::make_table(const std::string& name, const TableLayout& layout) {
  const Hdf5Action action{"cannot make", path_, name};
  const Lengths lengths(0, layout.columns);
  const std::array<hsize_t, 2> most{H5S_UNLIMITED, lengths.lengths[1]};
  const std::array<hsize_t, 2> chunk{layout.chunk_rows, lengths.lengths[1]};
  const Hdf5Handle space = simple_space(lengths, most.data(), action);
  const Hdf5Handle links = link_list(action);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
  checked(H5Pset_chunk(creation, lengths.dimensions, chunk.data()), action);
  if (layout.compression == TableLayout::Compression::deflate) {
    checked(H5Pset_shuffle(creation), action);
    checked(H5Pset_deflate(creation, deflate_level), action);
  }
  checked(H5Pset_fletcher32(creation), action);
  const Hdf5Handle dataset(
      H5Dcreate2(id_, name.c_str(), type_of(layout.element), space, links, creation, H5P_DEFAULT), H5Dclose,
      action);
}

void Hdf5File::append_bytes(const std::string& name, Element element, std::uint64_t count,
                            const void* bytes) {
  if (count == 0) return;
  const Hdf5Action action{"cannot write", path_, name};
  const Hdf5Handle dataset = open_dataset(id_, action);
  Lengths lengths(dataset, action);
  assert(count % lengths.lengths[1] == 0);
  const RowRange range{lengths.lengths[0], count / lengths.lengths[1]};
  lengths.lengths[0] += range.count;
  checked(H5Dset_extent(dataset, lengths.lengths.data()), action);
  const Hdf5Handle rows = select_rows(dataset, range, action);
  lengths.lengths[0] = range.count;
  const Hdf5Handle memory = simple_space(lengths, nullptr, action);
  checked(H5Dwrite(dataset, type_of(element), memory, rows, H5P_DEFAULT, bytes), action);
}

void Hdf5File::write_attribute_bytes(const std::string& object, const std::string& name, Element element,
                                     std::uint64_t count, const void* bytes) {
  const Hdf5Action action{"cannot write", path_, name};
  if (H5Aexists_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0)
    checked(H5Adelete_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT), action);
  const hsize_t length = count;
  const Hdf5Handle space(count == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &length, nullptr), H5Sclose,
                         action);
  const hid_t type = type_of(element);
  const Hdf5Handle attribute(H5Acreate_by_name(id_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT,
                                               H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, action);
  checked(H5Awrite(attribute, type, bytes), action);
}

void Hdf5File::read_attribute_bytes(const std::string& object, const std::string& name, Element element,
                                    void* bytes) const {
  const Hdf5Action action{"cannot read", path_, name};
  const Hdf5Handle attribute(H5Aopen_by_name(id_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose, action);
  checked(H5Aread(attribute, type_of(element), bytes), action);
}

}  // namespace fiberfate
