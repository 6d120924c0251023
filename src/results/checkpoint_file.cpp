// Replaces checkpoint files so that there is a sound one at any moment.
#include "results/checkpoint_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "base/version.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

constexpr std::int64_t format_version = 1;

/// Writes a whole new file beside the one that it will replace and tells its name.
std::string write_fresh(const std::string& path, const CheckpointBody& body) {
  const std::string fresh = path + ".new";
  try {
    Hdf5File file = Hdf5File::create(fresh);
    file.write_attribute("/", "format_version", format_version);
    file.write_text_attribute("/", "program_version", version);
    body(file);
    file.close();
    sync_file(fresh);
  } catch (const StorageError&) {
    std::error_code ignored;  // the first error is the one to report
    std::filesystem::remove(fresh, ignored);
    throw;
  }
  return fresh;
}

}  // namespace

void write_checkpoint_file(const std::string& path, const CheckpointBody& body) {
  rename_file(write_fresh(path, body), path);
}

void rotate_checkpoints(const ResultFolder& folder, const CheckpointBody& body) {
  // The new one is whole on disk before the older two move up, so there is a sound one at any moment.
  const std::string fresh = write_fresh(folder.checkpoint(), body);
  if (std::filesystem::exists(folder.checkpoint()))
    rename_file(folder.checkpoint(), folder.previous_checkpoint());
  rename_file(fresh, folder.checkpoint());
}

Hdf5File open_checkpoint_file(const std::string& path) {
  Hdf5File file = Hdf5File::open(path, Hdf5File::Access::read);
  const auto found = file.read_attribute<std::int64_t>("/", "format_version");
  if (found != format_version)
    throw StorageError(fmt::format("cannot read {}: its format is version {}, this program reads {}", path,
                                   found, format_version));
  return file;
}

CheckpointAge read_newest_checkpoint(const ResultFolder& folder,
                                     const std::function<void(const std::string&)>& warn,
                                     const std::function<void(const std::string& path)>& read) {
  try {
    read(folder.checkpoint());
    return CheckpointAge::newest;
  } catch (const StorageError& error) {
    if (!std::filesystem::exists(folder.previous_checkpoint())) throw;
    warn(fmt::format("{}; continuing from {}", error.what(), folder.previous_checkpoint()));
    read(folder.previous_checkpoint());
    return CheckpointAge::previous;
  }
}

}  // namespace fiberfate
