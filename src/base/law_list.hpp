// Lists of laws, of which kernels take one by its number.
#pragma once

namespace fiberfate {

/// Lists laws, each a template over its arithmetic.
template <template <class> class... Laws>
struct LawList {
  static constexpr int count = sizeof...(Laws);
};

/// The law with a number, as `Law<Math>`.
template <int number, class Math, class List>
struct LawAt;
template <int number, class Math, template <class> class First, template <class> class... Rest>
struct LawAt<number, Math, LawList<First, Rest...>> : LawAt<number - 1, Math, LawList<Rest...>> {};
template <class Math, template <class> class First, template <class> class... Rest>
struct LawAt<0, Math, LawList<First, Rest...>> {
  using Law = First<Math>;
};

/// Returns visit(law) of the law with this number; the first where there is none. It is a switch, so that no
/// branch is copied behind another, where a compiler would fuse its products with other sums.
template <class Result, class Math, class List, class Visit>
[[gnu::always_inline]] inline Result visit_law(int wanted, const Visit& visit) {
  static_assert(List::count <= 24, "visit_law has a case for 24 laws");
#define FIBERFATE_LAW_CASE(number)                                                               \
  case number:                                                                                   \
    if constexpr (number < List::count) return visit(typename LawAt<number, Math, List>::Law{}); \
    [[fallthrough]];
#define FIBERFATE_FOUR_LAW_CASES(number) \
  FIBERFATE_LAW_CASE(number)             \
  FIBERFATE_LAW_CASE(number + 1) FIBERFATE_LAW_CASE(number + 2) FIBERFATE_LAW_CASE(number + 3)
  switch (wanted) {
    FIBERFATE_LAW_CASE(1)
    FIBERFATE_LAW_CASE(2)
    FIBERFATE_LAW_CASE(3)
    FIBERFATE_FOUR_LAW_CASES(4)
    FIBERFATE_FOUR_LAW_CASES(8)
    FIBERFATE_FOUR_LAW_CASES(12)
    FIBERFATE_FOUR_LAW_CASES(16)
    FIBERFATE_FOUR_LAW_CASES(20)
    default:
      return visit(typename LawAt<0, Math, List>::Law{});
  }
#undef FIBERFATE_FOUR_LAW_CASES
#undef FIBERFATE_LAW_CASE
}

}  // namespace fiberfate
