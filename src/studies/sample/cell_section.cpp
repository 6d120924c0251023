// Builds the section of reports that shows the cell in three dimensions.
#include "studies/sample/cell_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/fiber_frame.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t enough_frames =
    40;  // for a motion that is followed easily; before it is fibers that go

/// Which frames are shown, and of how many birth fibers one.
struct Choice {
  std::vector<std::size_t> frames;
  std::int32_t stride = 1;
  NodeEncoding encoding = NodeEncoding::exact;
};

/// Picks some of many, evenly spread, the last one always among them.
std::vector<std::size_t> spread(std::size_t all, std::size_t some) {
  std::vector<std::size_t> picked;
  for (std::size_t i = 0; i < some; ++i) picked.push_back(some == 1 ? all - 1 : i * (all - 1) / (some - 1));
  return picked;
}

/// Chooses by the last frame, which has the most fibers.
Choice choose(const VtkhdfReader& frames, const PageRoom& room) {
  const std::size_t all = frames.times().size();
  const PolyFrame last = frames.read(all - 1);
  const double nodes = static_cast<double>(last.points.size()) / 3;
  const double fibers = static_cast<double>(last.offsets.size()) - 1;
  if (static_cast<double>(all) * 12 * nodes <= room.exact_bytes) return {spread(all, all)};
  const double affordable = room.encoded_bytes / (6 * nodes + 16 * fibers);
  const auto wanted = static_cast<double>(std::min(all, enough_frames));
  const double stride = std::max(1.0, std::ceil(wanted / affordable));
  const std::size_t shown = std::min(all, static_cast<std::size_t>(affordable * stride));
  return {spread(all, shown), static_cast<std::int32_t>(stride), NodeEncoding::grid};
}

std::vector<std::int32_t> whole_numbers(const PolyFrame& frame, const char* name) {
  std::vector<std::int32_t> numbers;
  for (const double value : numbers_of(frame.cell_data, name))
    numbers.push_back(static_cast<std::int32_t>(value));
  return numbers;
}

/// Makes a frame of every fiber whose birth number the stride divides.
FiberFrame frame_to_show(const PolyFrame& polylines, std::int32_t stride) {
  FiberFrame frame;
  frame.time_s = polylines.time;
  const std::vector<double> lattice = numbers_of(polylines.frame_data, "lattice");
  for (std::size_t i = 0; i < 9; ++i)
    frame.lattice(static_cast<int>(i / 3), static_cast<int>(i % 3)) = lattice.at(i);
  const std::vector<std::int32_t> birth = whole_numbers(polylines, "birth_id");
  const std::vector<std::int32_t> birth_node = whole_numbers(polylines, "birth_node");
  const std::vector<double> radius = numbers_of(polylines.cell_data, "radius");
  frame.offsets = {0};
  for (std::size_t fiber = 0; fiber < birth.size(); ++fiber) {
    if (birth[fiber] % stride != 0) continue;
    const auto begin = static_cast<std::ptrdiff_t>(3 * polylines.offsets[fiber]);
    const auto end = static_cast<std::ptrdiff_t>(3 * polylines.offsets[fiber + 1]);
    frame.points.insert(frame.points.end(), polylines.points.begin() + begin, polylines.points.begin() + end);
    frame.offsets.push_back(static_cast<std::int32_t>(frame.points.size() / 3));
    frame.birth.push_back(birth[fiber]);
    frame.birth_node.push_back(birth_node[fiber]);
    frame.radius.push_back(static_cast<float>(radius[fiber]));
  }
  return frame;
}

/// Interpolates the strain at a time; nothing outside of the table.
std::optional<double> strain_at(const CellHistory& history, double time) {
  const std::vector<double>& times = history.times;
  if (times.empty() || time < times.front() || time > times.back()) return std::nullopt;
  const auto above = std::lower_bound(times.begin(), times.end(), time);
  const std::size_t k = above - times.begin();
  if (k == 0) return history.strains[0];
  const double share = (time - times[k - 1]) / (times[k] - times[k - 1]);
  return history.strains[k - 1] + share * (history.strains[k] - history.strains[k - 1]);
}

/// Says what of the fibers is shown.
std::string describe_stride(std::int32_t stride) {
  if (stride == 1) return "all fibers";
  return stride == 2 ? "every second fiber" : fmt::format("one fiber of {}", stride);
}

/// Says what of a large result is shown.
std::string describe(const Choice& choice, std::size_t all) {
  if (choice.encoding == NodeEncoding::exact) return {};
  const std::string frames = choice.frames.size() < all
                                 ? fmt::format("{} of {} frames", choice.frames.size(), all)
                                 : fmt::format("all {} frames", all);
  return fmt::format(
      " Of this large result the picture shows {} and {}, places rounded to 1/65535 of the box around the "
      "fibers; result.vtkhdf beside this page has everything in full.",
      frames, describe_stride(choice.stride));
}

}  // namespace

CellHistory read_cell_history(const CsvTable& series, const CsvTable& breaks) {
  CellHistory history{series.column("time_s"), series.column("strain"), {}};
  const std::vector<double>&times = breaks.column("time_s"), &births = breaks.column("birth_id"),
        &nodes = breaks.column("birth_node");
  for (std::size_t i = 0; i < breaks.rows(); ++i)
    history.breaks.push_back(
        {times[i], static_cast<std::int32_t>(births[i]), static_cast<std::int32_t>(nodes[i])});
  return history;
}

FibersSection fibers_section(const VtkhdfReader& frames, const std::string& caption,
                             const CellHistory& history, const PageRoom& room) {
  FibersSection section{"cell", "The cell", {}, caption};
  const std::size_t all = frames.times().size();
  if (all == 0) return section;
  const Choice choice = choose(frames, room);
  section.encoding = choice.encoding;
  section.caption += describe(choice, all);
  for (const std::size_t number : choice.frames) {
    section.frames.push_back(frame_to_show(frames.read(number), choice.stride));
    section.frames.back().strain = strain_at(history, section.frames.back().time_s);
  }
  const double end = section.frames.back().time_s;
  std::copy_if(history.breaks.begin(), history.breaks.end(), std::back_inserter(section.breaks.emplace()),
               [&](const FiberBreak& one) { return one.birth % choice.stride == 0 && one.time_s <= end; });
  return section;
}

}  // namespace fiberfate
