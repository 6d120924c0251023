// The sections of reports that the studies of fibers share.
#include "studies/sample/fiber_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fibers/observables.hpp"
#include "results/fiber_frame.hpp"

namespace fiberfate {
namespace {

constexpr double most_bins = 400;
constexpr double curvature_bins = 50;

std::size_t nearest_frame(const std::vector<double>& times, double time) {
  const auto nearer = [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
  return std::min_element(times.begin(), times.end(), nearer) - times.begin();
}

/// Reads the frames nearest to the times, each once.
std::vector<FiberState> states_at(const VtkhdfReader& frames, const std::vector<double>& times) {
  std::vector<std::size_t> numbers;
  for (const double time : times) numbers.push_back(nearest_frame(frames.times(), time));
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  std::vector<FiberState> states;
  for (const std::size_t number : numbers) states.push_back(fibers_of(frames.read(number)));
  return states;
}

std::string label_of(const FiberState& state) {
  return fmt::format("{:.4g} s", state.time);
}

std::vector<double> curvatures_of(const FiberState& state) {
  std::vector<double> curvatures = hinge_radii(state);
  for (double& value : curvatures) value = 1 / value;
  return curvatures;
}

void append_amount(std::vector<Fact>& facts, const FiberChoices& fibers) {
  if (fibers.count) facts.push_back({"Fibers", *fibers.count});
  if (fibers.volume_fraction) facts.push_back({"Volume fraction", 100 * *fibers.volume_fraction, "%"});
  if (fibers.weight_fraction) facts.push_back({"Weight fraction", 100 * *fibers.weight_fraction, "%"});
}

/// Puts a law of lengths into words.
struct LawTeller {
  static std::string means(double number, double weight) {
    return fmt::format("means {:.4g} mm by number, {:.4g} mm by weight", 1e3 * number, 1e3 * weight);
  }
  std::string operator()(const SingleLength& law) const { return fmt::format("{:.4g} mm", 1e3 * law.length); }
  std::string operator()(const LengthHistogram& law) const {
    return fmt::format("histogram of {} bins, {:.4g} to {:.4g} mm", law.heights.size(),
                       1e3 * law.edges.front(), 1e3 * law.edges.back());
  }
  std::string operator()(const ListedLengths& law) const {
    return fmt::format("{} measured lengths", law.lengths.size());
  }
  std::string operator()(const WeibullLengths& law) const {
    return "Weibull, " + means(law.number_average, law.weight_average);
  }
  std::string operator()(const LogNormalLengths& law) const {
    return "log-normal, " + means(law.number_average, law.weight_average);
  }
};

std::string describe(const LengthLaw& law) {
  return std::visit(LawTeller(), law);
}

}  // namespace

std::vector<Fact> sample_facts(const SampleCase& sample) {
  const FiberChoices& fibers = sample.fibers;
  std::vector<Fact> facts;
  append_amount(facts, fibers);
  if (fibers.length)
    facts.push_back({"Fiber length", *fibers.length, "m"});
  else if (sample.cluster.source == ClusterSource::generate)
    facts.push_back({"Fiber lengths", describe(length_law(fibers))});
  facts.push_back({"Fiber diameter", fibers.diameter, "m"});
  facts.push_back({"Young's modulus", fibers.youngs_modulus, "Pa"});
  if (fibers.rod_length) facts.push_back({"Rod length", *fibers.rod_length, "m"});
  for (std::size_t i = 0; i < fibers.more_kinds.size(); ++i) {
    const FurtherKind& kind = fibers.more_kinds[i];
    facts.push_back({fmt::format("Kind {}", i + 2),
                     fmt::format("{:.4g} µm, {:.4g} GPa; {}", 1e6 * kind.diameter, 1e-9 * kind.youngs_modulus,
                                 describe(length_law(kind))),
                     "", fmt::format("{:.4g} times the volume of the first", kind.volume_share)});
  }
  if (sample.cell.size)
    facts.push_back({"Cell", fmt::format("{:.4g} × {:.4g} × {:.4g} mm", 1e3 * sample.cell.size->x(),
                                         1e3 * sample.cell.size->y(), 1e3 * sample.cell.size->z())});
  if (sample.cluster.source == ClusterSource::file)
    facts.push_back({"Fibers read from", sample.cluster.file});
  if (!sample.cluster.directions.empty())
    facts.push_back(
        {"Orientation asked for", fmt::format("{} measured directions", sample.cluster.directions.size())});
  else if (sample.cluster.source == ClusterSource::generate)
    facts.push_back({"Orientation asked for", sample.cluster.orientation, "", "by length"});
  return facts;
}

std::vector<Fact> outcome_facts(const SummaryFile& summary) {
  return {{"Fibers", summary.count("fibers")},
          {"Rods", summary.count("rods")},
          {"L_N", summary.number("L_N_m"), "m"},
          {"L_W", summary.number("L_W_m"), "m"},
          {"Volume fraction", 100 * summary.number("volume_fraction"), "%"},
          {"Smallest radius of curvature", summary.number("min_radius_m"), "m"},
          {"Contacts per fiber", summary.number("contacts_per_fiber")},
          {"Orientation tensor", summary.tensor("A2"), "", "by length"}};
}

FactsSection effort_section(const SummaryFile& summary) {
  FactsSection section{"effort", "Effort", {}};
  section.rows = {{"Wall time", summary.number("wall_s"), "s"},
                  {"Processor time", summary.number("cpu_s"), "s"},
                  {"Threads", summary.count("threads")},
                  {"Peak memory", summary.number("peak_memory_bytes") / (1 << 20), "MiB"}};
  if (summary.count("steps") == 0) return section;
  section.rows.push_back({"Steps", summary.count("steps")});
  section.rows.push_back(
      {"Rod-steps per second", summary.number("segment_steps_per_s"), "", "of stepping, without output"});
  const std::vector<double> seconds = summary.timings();
  for (std::size_t phase = 0; phase < phase_count; ++phase)
    section.rows.push_back({fmt::format("Time for {}", phase_names[phase]), seconds[phase], "s"});
  return section;
}

std::vector<double> bin_edges(double highest, double width) {
  if (!(highest > 0)) highest = width;
  const double bins = std::clamp(std::ceil(highest / width * (1 - 1e-9)), 1.0, most_bins);
  const double step = bins == most_bins ? highest / bins : width;
  std::vector<double> edges;
  for (int i = 0; i <= static_cast<int>(bins); ++i) edges.push_back(i * step);
  return edges;
}

std::vector<double> counts(const std::vector<double>& values, const std::vector<double>& edges) {
  std::vector<double> bins(edges.size() - 1, 0.0);
  for (const double value : values) {
    if (!(value >= edges.front()) || value > edges.back() * (1 + 1e-9)) continue;
    const auto above = std::upper_bound(edges.begin(), edges.end(), value);
    bins[std::min(above - edges.begin(), std::ssize(bins)) - 1] += 1;
  }
  return bins;
}

HistogramSection length_section(const VtkhdfReader& frames, const std::vector<double>& times,
                                double bin_width) {
  const std::vector<FiberState> states = states_at(frames, times);
  double longest = 0;
  for (const FiberState& state : states) {
    for (const double length : fiber_lengths(state)) longest = std::max(longest, length);
  }
  HistogramSection section{
      "lengths", "Fiber lengths", {"length", "m"}, {"fibers"}, bin_edges(longest, bin_width), {}};
  for (const FiberState& state : states)
    section.frames.push_back({label_of(state), counts(fiber_lengths(state), section.edges)});
  return section;
}

/// The next of 1, 2, 5, 10, 20, …: runs that are compared share their bins.
double round_width(double width) {
  const double decade = std::pow(10.0, std::floor(std::log10(width)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= width) return step * decade;
  return 10 * decade;
}

HistogramSection curvature_section(const VtkhdfReader& frames, const std::vector<double>& times) {
  const std::vector<FiberState> states = states_at(frames, times);
  double largest = 0;
  for (const FiberState& state : states) {
    for (const double curvature : curvatures_of(state)) largest = std::max(largest, curvature);
  }
  if (!(largest > 0)) largest = 1;
  HistogramSection section{"curvature",
                           "Curvature at hinges",
                           {"curvature 1/R", "1/m"},
                           {"hinges"},
                           bin_edges(largest, round_width(largest / curvature_bins)),
                           {}};
  for (const FiberState& state : states)
    section.frames.push_back({label_of(state), counts(curvatures_of(state), section.edges)});
  return section;
}

std::vector<double> fiber_lengths(const FiberState& state) {
  std::vector<double> lengths;
  for (const FiberIndex fiber : state.fibers()) lengths.push_back(fiber_length(state, fiber));
  return lengths;
}

}  // namespace fiberfate
