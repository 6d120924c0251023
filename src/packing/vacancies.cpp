// Marks filled boxes of the cell and counts those along a line.
#include "packing/vacancies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace fiberfate {
namespace {

// In thickest diameters.
constexpr double box_size = 0.7;
constexpr double sampling = 0.7;  // distance of the points that stand for a line
constexpr double thickest_radius = 0.5;

constexpr int fraction_bits = 32;
constexpr double one = 4294967296;  // 2^32
constexpr std::int64_t fraction_mask = 0xffffffff;

/// Calls `visit` with points along a line.
template <typename Visit>
void sample(const Segment& line, const Visit& visit) {
  const Vec3 whole = line.end - line.begin;
  const auto points = static_cast<std::ptrdiff_t>(std::ceil(whole.norm() / sampling));
  const Vec3 step = whole / static_cast<double>(points);
  for (std::ptrdiff_t i = 0; i < points; ++i) visit(Vec3(line.begin + (static_cast<double>(i) + 0.5) * step));
}

std::ptrdiff_t box_of(double place) {
  return static_cast<std::ptrdiff_t>(std::floor(place));
}
std::array<std::ptrdiff_t, 3> box_of(const Vec3& place) {
  return {box_of(place[0]), box_of(place[1]), box_of(place[2])};
}

/// Most boxes: those of a cell whose fibers fill a hundredth of it, and some thousands for a few.
double most_boxes(const Chains& chains) {
  double length = 0;
  for (const FiberIndex fiber : chains.fibers()) length += chains.length(fiber);
  constexpr double boxes_a_length = 0.25 * pi / (0.01 * box_size * box_size * box_size);
  return 65536 + boxes_a_length * length;
}

}  // namespace

Vacancies::Vacancies(const Chains& chains) {
  const Cell& cell = chains.cell;
  const double boxes = cell.volume() / (box_size * box_size * box_size);
  const double size = box_size * std::max(1.0, std::cbrt(boxes / most_boxes(chains)));
  is_coarse_ = size > box_size;
  Vec3 count;
  for (int i = 0; i < 3; ++i) {
    count[i] = std::max(1.0, std::floor(cell.lattice.col(i).norm() / size));
    count_[i] = static_cast<std::ptrdiff_t>(count[i]);
    walled_[i] = cell.boundary[i] != Boundary::periodic;
  }
  fraction_of_point_ = cell.lattice.inverse();
  boxes_of_point_ = count.asDiagonal() * fraction_of_point_;
  filled_.assign(count_[0] * count_[1] * count_[2], 0);
}

std::ptrdiff_t Vacancies::number(const Box& box) const {
  std::ptrdiff_t number = 0;
  for (std::size_t i = 3; i-- > 0;) {
    std::ptrdiff_t inside = box[i];
    if (inside < 0 || inside >= count_[i]) {
      if (walled_[i]) return -1;
      inside = (inside % count_[i] + count_[i]) % count_[i];
    }
    number = number * count_[i] + inside;
  }
  return number;
}

std::vector<Vacancies::Box> Vacancies::boxes_around(double distance) const {
  const Mat3 point_of_boxes = boxes_of_point_.inverse();
  std::array<std::ptrdiff_t, 3> most{};
  // Rows of the matrix are the gradients of the numbers of boxes.
  for (int i = 0; i < 3; ++i) most[i] = box_of(distance * boxes_of_point_.row(i).norm());
  std::vector<Box> boxes;
  for (std::ptrdiff_t z = -most[2]; z <= most[2]; ++z) {
    for (std::ptrdiff_t y = -most[1]; y <= most[1]; ++y) {
      for (std::ptrdiff_t x = -most[0]; x <= most[0]; ++x) {
        const Vec3 offset(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
        if ((point_of_boxes * offset).norm() < distance) boxes.push_back({x, y, z});
      }
    }
  }
  return boxes;
}

void Vacancies::mark(const Box& box) {
  const std::ptrdiff_t at = number(box);
  if (at >= 0) filled_[at] = 1;
}

void Vacancies::mark_between(const Box& low, const Box& high) {
  for (std::ptrdiff_t z = low[2]; z <= high[2]; ++z) {
    for (std::ptrdiff_t y = low[1]; y <= high[1]; ++y) {
      for (std::ptrdiff_t x = low[0]; x <= high[0]; ++x) mark({x, y, z});
    }
  }
}

void Vacancies::fill(const Chains& chains, FiberIndex fiber) {
  const double contact = chains.radius[fiber] + thickest_radius;
  const std::vector<Box> around = boxes_around(contact);
  const Vec3 reach = contact * boxes_of_point_.rowwise().norm();
  for (const RodIndex rod : chains.rods(fiber)) {
    sample(chains.segment(rod), [&](const Vec3& point) {
      const Vec3 place = boxes_of_point_ * point;
      if (is_coarse_) return mark_between(box_of(place - reach), box_of(place + reach));
      const Box box = box_of(place);
      for (const Box& offset : around) mark({box[0] + offset[0], box[1] + offset[1], box[2] + offset[2]});
    });
  }
}

double Vacancies::filled_share(const StraightAxis& line, double enough) const {
  const auto points = static_cast<std::int64_t>(std::ceil(line.length / sampling));
  const Vec3 step = line.length / static_cast<double>(points) * line.direction;
  const Vec3 first = line.centre - 0.5 * static_cast<double>(points - 1) * step;
  const Vec3 first_share = fraction_of_point_ * first, share_step = fraction_of_point_ * step;
  // Shares of the cell's edges in fixed point: their integer parts are numbers of images.
  std::int64_t place[3], move[3];
  for (int i = 0; i < 3; ++i) {
    place[i] = static_cast<std::int64_t>(std::floor(first_share[i] * one));
    move[i] = static_cast<std::int64_t>(std::floor(share_step[i] * one));
  }
  const auto most = static_cast<std::int64_t>(enough * static_cast<double>(points));
  std::int64_t filled = 0;
  for (std::int64_t n = 0; n < points && filled <= most; ++n) {
    std::int64_t number = 0;
    bool beyond = false;
    for (std::size_t i = 3; i-- > 0;) {
      beyond = beyond || (walled_[i] && (place[i] >> fraction_bits) != 0);
      number = number * count_[i] + (((place[i] & fraction_mask) * count_[i]) >> fraction_bits);
      place[i] += move[i];
    }
    filled += beyond ? 1 : filled_[number];
  }
  return static_cast<double>(filled) / static_cast<double>(points);
}

}  // namespace fiberfate
