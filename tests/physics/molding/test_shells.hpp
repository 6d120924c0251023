// Makes simple structured shells for the tests of filling.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "molding/filling.hpp"

namespace fiberfate::test {

/// Says how a rectangle is divided: cells along x and y, crossed diagonals alternating.
struct Rectangle {
  double length = 0.08;  ///< m, along x
  double width = 0.01;   ///< m, along y
  double thickness = 0.002;
  int along = 80;
  int across = 4;
};

/// Meshes a rectangle with its corner at the origin; `place` moves the nodes (to bend or turn the strip).
inline Shell rectangle(const Rectangle& r, const std::function<Vec3(const Vec3&)>& place = {}) {
  Shell shell;
  for (int j = 0; j <= r.across; ++j)
    for (int i = 0; i <= r.along; ++i) {
      const Vec3 x(r.length * i / r.along, r.width * j / r.across, 0);
      shell.nodes.push_back(place ? place(x) : x);
    }
  const auto node = [&](int i, int j) { return static_cast<Index>(j * (r.along + 1) + i); };
  for (int j = 0; j < r.across; ++j)
    for (int i = 0; i < r.along; ++i) {
      const Index a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1), d = node(i, j + 1);
      if ((i + j) % 2 == 0) {
        shell.triangles.push_back({a, b, c});
        shell.triangles.push_back({a, c, d});
      } else {
        shell.triangles.push_back({a, b, d});
        shell.triangles.push_back({b, c, d});
      }
    }
  shell.thickness.assign(shell.triangles.size(), r.thickness);
  return shell;
}

/// Meshes a ring (or a disc, where `inner` is 0) with triangles of about one size: circles of points, each
/// stitched to the next.
inline Shell disc(double inner, double outer, double size, double thickness) {
  Shell shell;
  const int rings = static_cast<int>(std::lround((outer - inner) / size));
  std::vector<int> begin, count;
  for (int i = 0; i <= rings; ++i) {
    const double radius = std::lerp(inner, outer, static_cast<double>(i) / rings);
    begin.push_back(static_cast<int>(shell.nodes.size()));
    count.push_back(std::max(1, static_cast<int>(std::lround(2 * std::numbers::pi * radius / size))));
    for (int j = 0; j < count.back(); ++j) {
      const double angle = 2 * std::numbers::pi * j / count.back();
      shell.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
  }
  for (int i = 0; i < rings; ++i) {
    const auto inside = [&](int j) { return static_cast<Index>(begin[i] + j % count[i]); };
    const auto outside = [&](int j) { return static_cast<Index>(begin[i + 1] + j % count[i + 1]); };
    int a = 0, b = 0;
    while (a < (count[i] > 1 ? count[i] : 0) || b < count[i + 1]) {
      // Of the two triangles that may come next the one with the shorter new side is nearer to Delaunay's.
      const double grow =
          b < count[i + 1] ? (shell.nodes[inside(a)] - shell.nodes[outside(b + 1)]).norm() : 1e9;
      const double turn =
          count[i] > 1 && a < count[i] ? (shell.nodes[inside(a + 1)] - shell.nodes[outside(b)]).norm() : 1e9;
      const bool on_outer = grow <= turn;
      if (on_outer) {
        shell.triangles.push_back({inside(a), outside(b), outside(b + 1)});
        ++b;
      } else {
        shell.triangles.push_back({inside(a), outside(b), inside(a + 1)});
        ++a;
      }
    }
  }
  shell.thickness.assign(shell.triangles.size(), thickness);
  return shell;
}

inline std::shared_ptr<const ViscosityLaw> viscosity(std::string_view name, std::vector<double> values) {
  return make_viscosity_law(name, values);
}

/// An isothermal filling at constant rate through a film gate along x = 0.
inline FillingParams isothermal(double rate, std::shared_ptr<const ViscosityLaw> law, const Gate& gate) {
  FillingParams params;
  params.material.viscosity = std::move(law);
  params.process.flow = FlowProfile::constant(rate);
  params.gates = {gate};
  params.numerics.heat = HeatModel::none;
  return params;
}

inline Gate film_gate(const Vec3& begin, const Vec3& end) {
  Gate gate;
  gate.position = begin;
  gate.end = end;
  gate.radius = 1e-5;
  return gate;
}

/// A round gate of 1 mm radius.
inline Gate round_gate(const Vec3& position) {
  Gate gate;
  gate.position = position;
  gate.radius = 1e-3;
  return gate;
}

/// Fills to the end, or until a test fails for good, and looks after every step.
template <class Look>
void fill(Filling& filling, const Look& look) {
  while (!filling.finished() && !testing::Test::HasFatalFailure()) {
    filling.advance();
    look();
  }
}

}  // namespace fiberfate::test
