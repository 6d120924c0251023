// Words the refusal of names.
#include "base/entry_by_name.hpp"

#include <fmt/format.h>

namespace fiberfate {

void refuse_name(std::string_view kind, std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearest_word(name, names);
  throw InputError(fmt::format("there is no {} '{}'", kind, name),
                   near.empty() ? fmt::format("choose one of {}", fmt::join(names, ", "))
                                : fmt::format("did you mean '{}'?", near));
}

}  // namespace fiberfate
