// Numbers of things of one kind, which cannot be taken for those of another.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// The number of a thing of one kind. It is made of an integer and read as one only where the code says so;
/// `Kind` is a name that is declared nowhere else.
template <class Kind>
class IndexOf {
 public:
  constexpr IndexOf() = default;
  constexpr explicit IndexOf(std::integral auto value) : value_(static_cast<Index>(value)) {}
  [[nodiscard]] constexpr Index value() const { return value_; }

  constexpr IndexOf& operator++() {
    ++value_;
    return *this;
  }
  constexpr IndexOf operator++(int) { return IndexOf(value_++); }
  friend constexpr auto operator<=>(IndexOf, IndexOf) = default;
  friend constexpr IndexOf operator+(IndexOf index, Index steps) { return IndexOf(index.value_ + steps); }
  friend constexpr IndexOf operator-(IndexOf index, Index steps) { return IndexOf(index.value_ - steps); }
  friend constexpr Index operator-(IndexOf a, IndexOf b) { return a.value_ - b.value_; }

 private:
  Index value_ = 0;
};

/// Consecutive numbers from `begin` up to but not `end`.
template <class I>
class IndexRange {
 public:
  class Iterator {
   public:
    constexpr explicit Iterator(I at) : at_(at) {}
    constexpr I operator*() const { return at_; }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    I at_;
  };
  constexpr IndexRange(I begin, I end) : begin_(begin), end_(end) {}
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(begin_); }
  [[nodiscard]] constexpr Iterator end() const { return Iterator(end_); }
  [[nodiscard]] constexpr I front() const { return begin_; }
  [[nodiscard]] constexpr Index size() const { return end_ - begin_; }

 private:
  I begin_, end_;
};

/// The first `count` numbers of a kind.
template <class I>
[[nodiscard]] constexpr IndexRange<I> first_indices(std::integral auto count) {
  return {I(0), I(count)};
}

/// A vector with one entry for each thing of a kind, subscripted by their numbers and nothing else.
template <class I, class T>
class IndexedVector : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  [[nodiscard]] T& operator[](I index) { return std::vector<T>::operator[](index.value()); }
  [[nodiscard]] const T& operator[](I index) const { return std::vector<T>::operator[](index.value()); }
  /// The numbers of all entries.
  [[nodiscard]] IndexRange<I> indices() const { return first_indices<I>(this->size()); }
};

/// A span of the same kind.
template <class I, class T>
class IndexedSpan : public std::span<T> {
 public:
  using Vector = IndexedVector<I, std::remove_const_t<T>>;
  constexpr IndexedSpan() = default;
  IndexedSpan(std::conditional_t<std::is_const_v<T>, const Vector, Vector>& entries)
      : std::span<T>(entries) {}
  explicit IndexedSpan(std::span<T> entries) : std::span<T>(entries) {}
  [[nodiscard]] T& operator[](I index) const { return std::span<T>::operator[](index.value()); }
};

/// Shows numbers as plain integers, to kernels and files.
template <class Kind>
[[nodiscard]] std::span<const Index> numbers(const std::vector<IndexOf<Kind>>& indices) {
  static_assert(sizeof(IndexOf<Kind>) == sizeof(Index) && std::is_standard_layout_v<IndexOf<Kind>>);
  return {reinterpret_cast<const Index*>(indices.data()), indices.size()};
}
template <class Kind>
[[nodiscard]] std::span<Index> numbers(std::vector<IndexOf<Kind>>& indices) {
  return {reinterpret_cast<Index*>(indices.data()), indices.size()};
}

}  // namespace fiberfate
