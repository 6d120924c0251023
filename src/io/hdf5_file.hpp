// Reads and writes HDF5 files; every error becomes a StorageError that names the file, the dataset and the
// reason.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace fiberfate {

/// The kinds of numbers that datasets hold.
enum class Element { float64, float32, int64, int32, uint32, uint16, uint8 };

template <class T>
[[nodiscard]] constexpr Element element_of() {
  if constexpr (std::is_same_v<T, double>) return Element::float64;
  if constexpr (std::is_same_v<T, float>) return Element::float32;
  if constexpr (std::is_same_v<T, std::int64_t>) return Element::int64;
  if constexpr (std::is_same_v<T, std::int32_t>) return Element::int32;
  if constexpr (std::is_same_v<T, std::uint32_t>) return Element::uint32;
  if constexpr (std::is_same_v<T, std::uint16_t>) return Element::uint16;
  if constexpr (std::is_same_v<T, std::uint8_t>) return Element::uint8;
}

/// Describes a dataset that rows are appended to.
struct TableLayout {
  Element element = Element::float64;
  int columns = 0;                ///< numbers a row; 0 makes the dataset one-dimensional
  std::uint64_t chunk_rows = 64;  ///< rows that are stored together
  enum class Compression { none, deflate } compression = Compression::none;
};

/// A run of rows.
struct RowRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// An open HDF5 file. Datasets are named by path, "VTKHDF/Steps/Values"; missing groups are made.
class Hdf5File {
 public:
  enum class Access { read, read_write };

  /// Makes a new file, over an existing one.
  [[nodiscard]] static Hdf5File create(const std::string& path);
  [[nodiscard]] static Hdf5File open(const std::string& path, Access access);
  ~Hdf5File();
  Hdf5File(Hdf5File&& other) noexcept;
  Hdf5File& operator=(Hdf5File&& other) noexcept;

  /// Writes what is still in memory and closes; raises StorageError when that fails.
  void close();
  [[nodiscard]] const std::string& path() const { return path_; }

  [[nodiscard]] bool contains(const std::string& name) const;
  /// The length of a dataset's first dimension.
  [[nodiscard]] std::uint64_t rows(const std::string& name) const;
  /// The numbers in a row: 1 for a one-dimensional dataset.
  [[nodiscard]] std::uint64_t columns(const std::string& name) const;
  /// Raises StorageError unless every row has so many numbers.
  void require_columns(const std::string& name, std::uint64_t wanted) const;
  /// Describes a dataset as make_table() would have made it.
  [[nodiscard]] TableLayout layout(const std::string& name) const;
  /// Lists the names directly inside a group, sorted.
  [[nodiscard]] std::vector<std::string> members(const std::string& group) const;

  /// Writes a new dataset, guarded by a checksum; columns as in TableLayout.
  template <class T>
  void write(const std::string& name, std::span<const T> values, int columns = 0) {
    write_bytes(name, {element_of<T>(), columns}, values.size(), values.data());
  }
  /// Reads a whole dataset, row after row.
  template <class T>
  [[nodiscard]] std::vector<T> read(const std::string& name) const {
    return read_known<T>(name, {0, rows(name)});
  }
  /// Reads some rows; raises StorageError before anything is allocated where there are fewer.
  template <class T>
  [[nodiscard]] std::vector<T> read_rows(const std::string& name, RowRange range) const {
    require_rows(name, range);
    return read_known<T>(name, range);
  }

  void make_group(const std::string& name);
  /// Makes an empty dataset that append() lengthens.
  void make_table(const std::string& name, const TableLayout& layout);
  template <class T>
  void append(const std::string& name, std::span<const T> values) {
    append_bytes(name, element_of<T>(), values.size(), values.data());
  }

  void write_text(const std::string& name, const std::string& text);
  [[nodiscard]] std::string read_text(const std::string& name) const;

  /// Sets an attribute of a group or dataset, in place of an older one: one number, or several.
  template <class T>
  void write_attribute(const std::string& object, const std::string& name, std::span<const T> values) {
    write_attribute_bytes(object, name, element_of<T>(), values.size(), values.data());
  }
  template <class T>
  void write_attribute(const std::string& object, const std::string& name, T value) {
    write_attribute_bytes(object, name, element_of<T>(), 0, &value);
  }
  template <class T>
  [[nodiscard]] T read_attribute(const std::string& object, const std::string& name) const {
    T value{};
    read_attribute_bytes(object, name, element_of<T>(), &value);
    return value;
  }
  void write_text_attribute(const std::string& object, const std::string& name, const std::string& text);
  [[nodiscard]] std::string read_text_attribute(const std::string& object, const std::string& name) const;

 private:
  Hdf5File(std::int64_t id, std::string path);
  void write_bytes(const std::string& name, const TableLayout& layout, std::uint64_t count,
                   const void* bytes);
  void require_rows(const std::string& name, RowRange range) const;
  template <class T>
  [[nodiscard]] std::vector<T> read_known(const std::string& name, RowRange range) const {
    std::vector<T> values(range.count * columns(name));
    read_bytes(name, element_of<T>(), range, values.data());
    return values;
  }
  void read_bytes(const std::string& name, Element element, RowRange range, void* bytes) const;
  void append_bytes(const std::string& name, Element element, std::uint64_t count, const void* bytes);
  void write_attribute_bytes(const std::string& object, const std::string& name, Element element,
                             std::uint64_t count, const void* bytes);
  void read_attribute_bytes(const std::string& object, const std::string& name, Element element,
                            void* bytes) const;

  std::int64_t id_ = -1;
  std::string path_;
};

}  // namespace fiberfate
