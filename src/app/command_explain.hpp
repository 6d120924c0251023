// The command explain.
#pragma once

#include <string>

namespace fiberfate {

/// How explanations are laid out.
enum class ExplainLayout {
  terminal,
  markdown,  ///< all keys of all studies: docs/guide/case_keys.md
};

struct ExplainOptions {
  std::string topic;  ///< a key, a table or a study; empty: an overview
  ExplainLayout layout = ExplainLayout::terminal;
};

/// Explains keys: meaning, unit, default, range, source; returns the exit status.
/// Raises InputError with a suggestion for an unknown topic.
int run_explain(const ExplainOptions& options);

/// Documents every key of every study as tables in Markdown.
[[nodiscard]] std::string key_reference();

}  // namespace fiberfate
