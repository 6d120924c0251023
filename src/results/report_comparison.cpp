// Merges the documents of several runs.
#include "results/report_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "results/compared_runs.hpp"

namespace fiberfate {
namespace {

/// What a series is a curve of: "L_N, fitted" and "L_N, measured" belong together.
std::string subject(const std::string& label) {
  return label.substr(0, label.rfind(", "));
}

std::string aspect(const std::string& label) {
  const std::size_t comma = label.rfind(", ");
  return comma == std::string::npos ? "" : label.substr(comma);
}

/// Finds a section of a kind by its id.
template <class Section>
const Section* find_section(const ReportDocument& document, const std::string& id) {
  for (const ReportSection& section : document.sections)
    if (const auto* found = std::get_if<Section>(&section); found && found->id == id) return found;
  return nullptr;
}

/// A curve with its own x.
ReportSeries with_x(const ReportSeries& series, const std::vector<double>& shared) {
  ReportSeries own = series;
  if (own.x.empty()) own.x = shared;
  return own;
}

/// The last bars of a histogram as steps, so that bins may differ between runs.
LinesSection as_steps(const HistogramSection& bars) {
  LinesSection section{bars.id, bars.title, bars.x, bars.y, {}, {}, bars.caption};
  const auto steps = [&bars](const std::string& label, const std::vector<double>& values) {
    ReportSeries outline{label, {}};
    for (std::size_t k = 0; k < values.size(); ++k) {
      outline.x.insert(outline.x.end(), {bars.edges[k], bars.edges[k + 1]});
      outline.values.insert(outline.values.end(), 2, values[k]);
    }
    return outline;
  };
  if (!bars.frames.empty())
    section.series.push_back(
        steps(bars.frames.size() > 1 ? "at the end" : bars.frames.back().label, bars.frames.back().values));
  section.legend = LegendValues::none;
  return section;
}

/// The curves of every document, histograms among them; pictures of things stay where they are.
std::vector<LinesSection> charts_of(const ReportDocument& document) {
  std::vector<LinesSection> charts;
  for (const ReportSection& section : document.sections) {
    if (const auto* lines = std::get_if<LinesSection>(&section);
        lines && lines->scales == LinesSection::Scales::independent)
      charts.push_back(*lines);
    if (const auto* bars = std::get_if<HistogramSection>(&section)) charts.push_back(as_steps(*bars));
  }
  return charts;
}

/// The charts of all runs, each id once.
std::vector<LinesSection> all_charts(const std::vector<ComparedRun>& runs) {
  std::vector<LinesSection> all;
  for (const ComparedRun& run : runs)
    for (LinesSection& chart : charts_of(run.document))
      if (std::ranges::find(all, chart.id, &LinesSection::id) == all.end()) all.push_back(std::move(chart));
  return all;
}

/// Merges one section of all runs, subject by subject.
class ChartMerger {
 public:
  ChartMerger(const std::vector<Replicas>& groups, const LinesSection& first)
      : groups_(groups), first_(first) {
    for (const Replicas& group : groups) {
      std::vector<LinesSection> own;
      for (const ComparedRun* run : group.runs)
        for (LinesSection& chart : charts_of(run->document))
          if (chart.id == first.id) own.push_back(std::move(chart));
      charts_.push_back(std::move(own));
    }
  }

  [[nodiscard]] std::vector<LinesSection> merge() const {
    std::vector<std::string> subjects;
    for (const std::vector<LinesSection>& group : charts_)
      for (const LinesSection& chart : group)
        for (const ReportSeries& one : chart.series)
          if (std::ranges::find(subjects, subject(one.label)) == subjects.end())
            subjects.push_back(subject(one.label));
    std::vector<LinesSection> merged;
    for (const std::string& one : subjects) merged.push_back(merge_subject(one, subjects.size()));
    return merged;
  }

 private:
  [[nodiscard]] LinesSection merge_subject(const std::string& name, std::size_t subjects) const {
    LinesSection section{first_.id, first_.title, first_.x, first_.y, {}, {}};
    section.role = first_.role;
    section.legend = first_.legend;
    if (subjects > 1) {
      section.id += "_" + name;
      section.title += ": " + name;
    }
    for (const std::string& label : labels_of(name)) append_label(section, label);
    return section;
  }

  [[nodiscard]] std::vector<std::string> labels_of(const std::string& name) const {
    std::vector<std::string> labels;
    for (const std::vector<LinesSection>& group : charts_)
      for (const LinesSection& chart : group)
        for (const ReportSeries& one : chart.series)
          if (subject(one.label) == name && std::ranges::find(labels, one.label) == labels.end())
            labels.push_back(one.label);
    return labels;
  }

  /// Adds the curves of one label: one a group, or one alone where all are the same.
  void append_label(LinesSection& section, const std::string& label) const {
    std::vector<ReportSeries> curves;
    for (std::size_t group = 0; group < charts_.size(); ++group) {
      std::vector<ReportSeries> replicas;
      for (const LinesSection& chart : charts_[group])
        for (const ReportSeries& one : chart.series)
          if (one.label == label) replicas.push_back(with_x(one, chart.x_values));
      if (replicas.empty()) continue;
      curves.push_back(merge_replicas(replicas));
      curves.back().label = groups_[group].label + aspect(label);
      curves.back().colour = static_cast<int>(group);
    }
    const bool shared =
        curves.size() == groups_.size() && curves.size() > 1 &&
        std::ranges::all_of(curves, [&](const ReportSeries& one) { return are_same(one, curves.front()); });
    if (shared && !aspect(label).empty()) {
      curves.resize(1);
      curves.front().label = label;
      curves.front().colour = static_cast<int>(groups_.size());
    }
    append(section.series, std::move(curves));
  }

  const std::vector<Replicas>& groups_;
  const LinesSection& first_;
  std::vector<std::vector<LinesSection>> charts_;  ///< of every group, one a run
};

/// Reads a number that a case has, or gives its text without quotes.
ComparedValue value_of(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  if (const auto [rest, error] = std::from_chars(text.data(), end, number);
      error == std::errc() && rest == end)
    return {number};
  if (text.size() >= 2 && text.front() == '"') return {text.substr(1, text.size() - 2)};
  return {text};
}

/// Joins texts, each once: "1, 2" of the seeds of two runs.
std::string joined(const std::vector<std::string>& texts) {
  std::vector<std::string> different;
  for (const std::string& text : texts)
    if (std::ranges::find(different, text) == different.end()) different.push_back(text);
  return fmt::format("{}", fmt::join(different, ", "));
}

/// What the runs of a group give for a key.
std::string given_by(const Replicas& group, const std::string& name) {
  std::vector<std::string> texts;
  for (const ComparedRun* run : group.runs) {
    const auto found = std::ranges::find(run->keys, name, &ResolvedKey::name);
    texts.push_back(found == run->keys.end() ? "–" : found->value);
  }
  return joined(texts);
}

/// Lists the keys in which the runs differ; a key that a run does not give is a dash.
ComparisonSection differences(const std::vector<Replicas>& groups, const std::vector<std::string>& labels) {
  ComparisonSection section{"differences", "What differs", labels, {}};
  std::vector<std::pair<std::string, std::string>> names;
  for (const Replicas& group : groups)
    for (const ResolvedKey& key : group.runs.front()->keys)
      if (std::ranges::find(names, key.name, &std::pair<std::string, std::string>::first) == names.end())
        names.emplace_back(key.name, key.unit);
  for (const auto& [name, unit] : names) {
    std::vector<std::string> texts;
    for (const Replicas& group : groups) texts.push_back(given_by(group, name));
    if (std::ranges::all_of(texts, [&texts](const std::string& text) { return text == texts.front(); }))
      continue;
    ComparedFact row{name, {}, unit};
    for (const std::string& text : texts) row.values.push_back(value_of(text));
    section.rows.push_back(std::move(row));
  }
  section.role = SectionRole::wide;
  return section;
}

/// A fact as rows of numbers or texts: a tensor has one a component of its diagonal.
std::vector<std::pair<std::string, std::variant<double, std::string>>> split(const Fact& fact) {
  if (const auto* text = std::get_if<std::string>(&fact.value)) return {{fact.label, *text}};
  if (const auto* number = std::get_if<double>(&fact.value)) return {{fact.label, *number}};
  if (const auto* count = std::get_if<std::int64_t>(&fact.value))
    return {{fact.label, static_cast<double>(*count)}};
  const Mat3& tensor = std::get<Mat3>(fact.value);
  std::vector<std::pair<std::string, std::variant<double, std::string>>> rows;
  for (int i = 0; i < 3; ++i)
    rows.emplace_back(fmt::format("{}, a_{}{}", fact.label, i + 1, i + 1), tensor(i, i));
  return rows;
}

/// The mean of replicas with their ends; texts one after another, each once.
ComparedValue merge_values(const std::vector<std::variant<double, std::string>>& values) {
  if (std::holds_alternative<std::string>(values.front())) {
    std::vector<std::string> texts;
    for (const auto& one : values)
      if (const auto* text = std::get_if<std::string>(&one)) texts.push_back(*text);
    return {joined(texts)};
  }
  double sum = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& one : values) {
    const double number = std::holds_alternative<double>(one) ? std::get<double>(one) : std::nan("");
    sum += number;
    low = std::min(low, number);
    high = std::max(high, number);
  }
  ComparedValue merged{sum / static_cast<double>(values.size())};
  if (values.size() > 1) merged.ends = {{low, high}};
  return merged;
}

/// Finds a row of a section of facts in a run.
std::optional<std::variant<double, std::string>> find_value(const ComparedRun& run,
                                                            const std::string& section,
                                                            const std::string& label) {
  const auto* facts = find_section<FactsSection>(run.document, section);
  if (!facts) return {};
  for (const Fact& fact : facts->rows)
    for (auto& [name, value] : split(fact))
      if (name == label) return std::move(value);
  return {};
}

/// Sets the facts of a section side by side, one column a group.
ComparisonSection side_by_side(const FactsSection& facts, const std::vector<Replicas>& groups,
                               const std::vector<std::string>& labels) {
  ComparisonSection section{facts.id, facts.title, labels, {}};
  section.role = facts.role;
  for (const Fact& fact : facts.rows)
    for (const auto& [label, unused] : split(fact)) {
      ComparedFact row{label, {}, fact.unit, fact.prominence};
      for (const Replicas& group : groups) {
        std::vector<std::variant<double, std::string>> values;
        for (const ComparedRun* run : group.runs)
          if (auto value = find_value(*run, facts.id, label)) values.push_back(*std::move(value));
        row.values.push_back(values.empty() ? ComparedValue{std::string("–")} : merge_values(values));
      }
      section.rows.push_back(std::move(row));
    }
  return section;
}

}  // namespace

ReportDocument compare_reports(const std::vector<ComparedRun>& own_runs) {
  std::vector<ComparedRun> runs = own_runs;
  share_bins(runs);
  const std::vector<Replicas> groups = group_replicas(runs);
  std::vector<std::string> labels;
  for (const Replicas& group : groups) labels.push_back(group.label);
  const ReportDocument& first = runs.front().document;
  ReportDocument document{first.title, fmt::format("{} runs compared", runs.size())};
  document.study = first.study;
  document.version = first.version;
  document.subtitle = "Pictures, maps and tables are in the report of each run.";
  if (groups.size() < runs.size())
    document.subtitle +=
        " Runs that differ only in their seed are shown as their mean; the band spans their minimum and "
        "maximum.";
  if (ComparisonSection section = differences(groups, labels); !section.rows.empty())
    document.sections.emplace_back(std::move(section));
  for (const LinesSection& chart : all_charts(runs))
    append(document.sections, ChartMerger(groups, chart).merge());
  for (const ReportSection& section : first.sections)
    if (const auto* facts = std::get_if<FactsSection>(&section))
      document.sections.emplace_back(side_by_side(*facts, groups, labels));
  return document;
}

}  // namespace fiberfate
