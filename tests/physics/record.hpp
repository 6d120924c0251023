// Exact results, checked and recorded: docs/develop/validation.md is made of what tests record here.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace fiberfate {

/// Checks that a test found an exact result to its tolerance, and records both for
/// scripts/write_validation.py. `name` says what the number is, with its unit in parentheses, "period of a
/// rod of 20 beads (s)"; where the number is an error, 0 is expected. A test may record as many results as it
/// likes, in the order in which the page shows them.
inline void record(const std::string& name, double expected, double found, double tolerance) {
  EXPECT_NEAR(found, expected, tolerance) << name;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string key = "exact_" + std::to_string(test->result()->test_property_count());
  char numbers[100];
  std::snprintf(numbers, sizeof numbers, " | %.9g | %.9g | %.3g", expected, found, tolerance);
  testing::Test::RecordProperty(key, name + numbers);
}

}  // namespace fiberfate
