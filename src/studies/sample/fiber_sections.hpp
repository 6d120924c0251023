// The sections of reports that the studies of fibers share.
#pragma once

#include <string>
#include <vector>

#include "io/vtkhdf_file.hpp"
#include "results/report_document.hpp"
#include "results/result_folder.hpp"
#include "results/summary.hpp"
#include "studies/sample/case.hpp"

namespace fiberfate {

/// Lists what was asked of the fibers at the start.
[[nodiscard]] std::vector<Fact> sample_facts(const SampleCase& sample);

/// Lists what every summary tells: fibers, lengths, orientation, volume fraction, overlap.
[[nodiscard]] std::vector<Fact> outcome_facts(const SummaryFile& summary);

/// Lists times, memory and speed.
[[nodiscard]] FactsSection effort_section(const SummaryFile& summary);

/// Makes equal bins of about the given width that cover [0, highest].
[[nodiscard]] std::vector<double> bin_edges(double highest, double width);
/// Counts values in bins.
[[nodiscard]] std::vector<double> counts(const std::vector<double>& values, const std::vector<double>& edges);

/// Counts fibers by length at the frames nearest to the given times.
[[nodiscard]] HistogramSection length_section(const VtkhdfReader& frames, const std::vector<double>& times,
                                              double bin_width);
/// Counts hinges by curvature 1/R at the frames nearest to the given times.
[[nodiscard]] HistogramSection curvature_section(const VtkhdfReader& frames,
                                                 const std::vector<double>& times);

/// Lists the lengths of fibers, m.
[[nodiscard]] std::vector<double> fiber_lengths(const FiberState& state);

}  // namespace fiberfate
