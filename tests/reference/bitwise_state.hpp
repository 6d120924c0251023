// Compares states bit by bit.
#pragma once

#include <gtest/gtest.h>

#include "fibers/state.hpp"

namespace fiberfate {

/// Expects every entry that is part of a checkpoint to be the same.
inline void expect_bitwise_equal(const FiberState& a, const FiberState& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.relative_velocity, b.relative_velocity);
  EXPECT_EQ(a.rod_length, b.rod_length);
  EXPECT_EQ(a.first_node, b.first_node);
  EXPECT_EQ(a.birth_id, b.birth_id);
  EXPECT_EQ(a.birth_node, b.birth_node);
  EXPECT_EQ(a.material_id, b.material_id);
  EXPECT_EQ(a.touches_previous, b.touches_previous);
  EXPECT_EQ(a.cell.lattice, b.cell.lattice);
  EXPECT_EQ(a.cell.boundary, b.cell.boundary);
  EXPECT_EQ(a.cell.frame.kind, b.cell.frame.kind);
  EXPECT_EQ(a.cell.frame.first, b.cell.frame.first);
  EXPECT_EQ(a.cell.frame.strain, b.cell.frame.strain);
  EXPECT_EQ(a.cell.frame.basis, b.cell.frame.basis);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.step_size, b.step_size);
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.rod_steps, b.rod_steps);
  EXPECT_EQ(a.breakage_checks, b.breakage_checks);
  EXPECT_EQ(a.breaks, b.breaks);
}

}  // namespace fiberfate
