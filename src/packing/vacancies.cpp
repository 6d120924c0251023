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
void sample(const Vec3& begin, const Vec3& end, const Visit& visit) {
  const auto points = static_cast<std::ptrdiff_t>(std::ceil((end - begin).norm() / sampling));
  const Vec3 step = (end - begin) / static_cast<double>(points);
  for (std::ptrdiff_t i = 0; i < points; ++i) visit(Vec3(begin + (static_cast<double>(i) + 0.5) * step));
}

std::ptrdiff_t box_of(double place) {
  return static_cast<std::ptrdiff_t>(std::floor(place));
}

/// Most boxes: those of a cell whose fibers fill a hundredth of it, and some thousands for a few.
double most_boxes(const Chains& chains) {
  double length = 0;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f)
    length += chains.rod_length[f] * static_cast<double>(chains.end_node(f) - chains.begin_node(f) - 1);
  constexpr double boxes_a_length = 0.25 * pi / (0.01 * box_size * box_size * box_size);
  return 65536 + boxes_a_length * length;
}

}  // namespace

Vacancies::Vacancies(const Chains& chains) {
  const Cell& cell = chains.cell;
  const double boxes = cell.volume() / (box_size * box_size * box_size);
  const double size = box_size * std::max(1.0, std::cbrt(boxes / most_boxes(chains)));
  Vec3 count;
  for (int i = 0; i < 3; ++i) {
    count[i] = std::max(1.0, std::floor(cell.lattice.col(i).norm() / size));
    const auto direction = static_cast<std::size_t>(i);
    count_[direction] = static_cast<std::ptrdiff_t>(count[i]);
    walled_[direction] = cell.boundary[direction] != Boundary::periodic;
  }
  fraction_of_point_ = cell.lattice.inverse();
  boxes_of_point_ = count.asDiagonal() * fraction_of_point_;
  filled_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]), 0);
}

Vacancies::Box Vacancies::box_at(const Vec3& point) const {
  const Vec3 place = boxes_of_point_ * point;
  return {box_of(place[0]), box_of(place[1]), box_of(place[2])};
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
  for (int i = 0; i < 3; ++i)
    most[static_cast<std::size_t>(i)] = box_of(distance * boxes_of_point_.row(i).norm());
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

void Vacancies::fill(const Chains& chains, std::size_t fiber) {
  const std::vector<Box> around = boxes_around(chains.radius[fiber] + thickest_radius);
  for (std::size_t k = chains.begin_node(fiber); k + 1 < chains.end_node(fiber); ++k) {
    sample(chains.position[k], chains.position[k + 1], [&](const Vec3& point) {
      const Box box = box_at(point);
      for (const Box& offset : around) {
        const std::ptrdiff_t at = number({box[0] + offset[0], box[1] + offset[1], box[2] + offset[2]});
        if (at >= 0) filled_[static_cast<std::size_t>(at)] = 1;
      }
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
    filled += beyond ? 1 : filled_[static_cast<std::size_t>(number)];
  }
  return static_cast<double>(filled) / static_cast<double>(points);
}

}  // namespace fiberfate
