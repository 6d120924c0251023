// The HTML page into which a report document is put.
#pragma once

#include <string_view>

namespace fiberfate {

/// Gives the built page of report/, or nothing when fiberfate was built with FIBERFATE_REPORT=OFF.
[[nodiscard]] std::string_view report_template();

}  // namespace fiberfate
