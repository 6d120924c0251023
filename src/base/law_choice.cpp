// Choices among the laws of a registry, by name.
#include "base/law_choice.hpp"

namespace fiberfate {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

InputError unknown_law(const char* kind, std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearest_word(name, names);
  return {"there is no " + std::string(kind) + " '" + std::string(name) + "'",
          near.empty() ? "choose one of " + listed(names) : "did you mean '" + near + "'?"};
}

bool reads_constant(const LawText& law, std::string_view constant) {
  return std::ranges::any_of(law.constants,
                             [&](const char* one) { return one != nullptr && one == constant; });
}

}  // namespace fiberfate
