// Compares two states of a filling bit by bit.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "molding/filling_state.hpp"

namespace fiberfate::test {

/// Bits of a number: NaN is the same as NaN, and -0 is not 0.
inline std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline void expect_same_gates(const FillingState& a, const FillingState& b) {
  ASSERT_EQ(a.gates.size(), b.gates.size());
  for (std::size_t g = 0; g < a.gates.size(); ++g) {
    EXPECT_EQ(a.gates[g].moves, b.gates[g].moves);
    EXPECT_EQ(bits(a.gates[g].arrival_time), bits(b.gates[g].arrival_time));
    EXPECT_EQ(bits(a.gates[g].pressure), bits(b.gates[g].pressure));
    EXPECT_EQ(bits(a.gates[g].rate), bits(b.gates[g].rate));
    EXPECT_EQ(bits(a.gates[g].volume), bits(b.gates[g].volume));
  }
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t e = 0; e < a.events.size(); ++e) {
    EXPECT_EQ(bits(a.events[e].time), bits(b.events[e].time));
    EXPECT_EQ(bits(a.events[e].filled_fraction), bits(b.events[e].filled_fraction));
    EXPECT_EQ(a.events[e].kind, b.events[e].kind);
    EXPECT_EQ(a.events[e].gate, b.events[e].gate);
  }
}

/// Compares all members of two states.
inline void expect_same(const FillingState& a, const FillingState& b) {
  EXPECT_EQ(bits(a.time), bits(b.time));
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.stop_reason, b.stop_reason);
  EXPECT_EQ(a.control, b.control);
  EXPECT_EQ(bits(a.sprue_pressure), bits(b.sprue_pressure));
  EXPECT_EQ(bits(a.flow_rate), bits(b.flow_rate));
  EXPECT_EQ(bits(a.held_pressure), bits(b.held_pressure));
  EXPECT_EQ(bits(a.injected_volume), bits(b.injected_volume));
  EXPECT_EQ(bits(a.filled_volume), bits(b.filled_volume));
  EXPECT_EQ(bits(a.heat.brought_in), bits(b.heat.brought_in));
  EXPECT_EQ(bits(a.heat.dissipated), bits(b.heat.dissipated));
  EXPECT_EQ(bits(a.heat.to_mold), bits(b.heat.to_mold));
  expect_same_gates(a, b);
  EXPECT_TRUE(same_bits(a.sensor_arrivals, b.sensor_arrivals));
  EXPECT_TRUE(same_bits(a.covered, b.covered));
  EXPECT_TRUE(same_bits(a.filled, b.filled));
  EXPECT_TRUE(same_bits(a.excess, b.excess));
  EXPECT_TRUE(same_bits(a.fill_time, b.fill_time));
  EXPECT_TRUE(same_bits(a.pressure, b.pressure));
  EXPECT_TRUE(same_bits(a.gradient, b.gradient));
  EXPECT_TRUE(same_bits(a.inflow, b.inflow));
  EXPECT_TRUE(same_bits(a.mark, b.mark));
  EXPECT_TRUE(same_bits(a.temperature, b.temperature));
  EXPECT_TRUE(same_bits(a.rate, b.rate));
  EXPECT_TRUE(same_bits(a.lengths, b.lengths));
  for (std::size_t m = 0; m < 6; ++m) EXPECT_TRUE(same_bits(a.orientation[m], b.orientation[m])) << m;
}

}  // namespace fiberfate::test
