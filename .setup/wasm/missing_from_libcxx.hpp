// What the C++ library of emscripten 3.1.6 lacks of C++20, as far as the project uses it: algorithms on ranges, three-way
// comparison of tuples and vectors, std::jthread, and std::from_chars of a double. dependencies.cmake includes it before
// every source.
#pragma once
#include <algorithm>
#include <charconv>
#include <compare>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

namespace std::ranges {


/// Returns a predicate or comparison of what `by` takes from the elements.
template <class Function, class By>
constexpr auto taken(Function& function, By& by) {
  return [&](const auto&... elements) { return invoke(function, invoke(by, elements)...); };
}

// The algorithms with a function of the elements.
#define REDERIVE_ALGORITHM(name)                                          \
  template <class Range, class Function = std::less<>, class By = identity>    \
  constexpr auto name(Range&& range, Function function = {}, By by = {}) { \
    return std::name(begin(range), end(range), taken(function, by));      \
  }
REDERIVE_ALGORITHM(all_of)
REDERIVE_ALGORITHM(any_of)
REDERIVE_ALGORITHM(none_of)
REDERIVE_ALGORITHM(find_if)
REDERIVE_ALGORITHM(find_if_not)
REDERIVE_ALGORITHM(count_if)
REDERIVE_ALGORITHM(sort)
REDERIVE_ALGORITHM(stable_sort)
REDERIVE_ALGORITHM(stable_partition)
REDERIVE_ALGORITHM(min_element)
REDERIVE_ALGORITHM(max_element)
REDERIVE_ALGORITHM(adjacent_find)
#undef REDERIVE_ALGORITHM

template <class Range, class Function>
constexpr void for_each(Range&& range, Function function) {
  for (auto&& element : range) invoke(function, element);
}
template <class Iterator, class Value, class By>
constexpr Iterator find(Iterator first, Iterator last, const Value& value, By by) {
  return std::find_if(first, last, [&](const auto& element) { return invoke(by, element) == value; });
}
template <class Range, class Value, class By = identity>
constexpr auto find(Range&& range, const Value& value, By by = {}) {
  return ranges::find(begin(range), end(range), value, by);
}
template <class Range, class Value, class By = identity>
constexpr auto count(Range&& range, const Value& value, By by = {}) {
  return std::count_if(begin(range), end(range), [&](const auto& element) { return invoke(by, element) == value; });
}
template <class Iterator, class Function, class By>
constexpr Iterator min_element(Iterator first, Iterator last, Function function, By by) {
  return std::min_element(first, last, taken(function, by));
}
template <class Range, class Value, class Function = std::less<>, class By = identity>
constexpr auto upper_bound(Range&& range, const Value& value, Function function = {}, By by = {}) {
  return std::upper_bound(begin(range), end(range), value,
                          [&](const auto& x, const auto& y) { return invoke(function, x, invoke(by, y)); });
}
template <class One, class Other, class Same = std::equal_to<>>
constexpr bool equal(const One& one, const Other& other, Same same = {}) {
  return std::equal(begin(one), end(one), begin(other), end(other), same);
}
template <class Range>
constexpr auto max(const Range& range) {
  return *std::max_element(begin(range), end(range));
}
template <class Value, class Function = std::less<>, class By = identity>
constexpr Value min(initializer_list<Value> range, Function function = {}, By by = {}) {
  return *std::min_element(begin(range), end(range), taken(function, by));
}
template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(begin(range), end(range));
}
template <class Range, class Value>
constexpr void replace(Range&& range, const Value& from, const Value& to) {
  std::replace(begin(range), end(range), from, to);
}
template <class Range, class Output>
constexpr Output copy(Range&& range, Output output) {
  return std::copy(begin(range), end(range), output);
}
template <class Range, class Output, class Function, class By = identity>
constexpr Output copy_if(Range&& range, Output output, Function function, By by = {}) {
  return std::copy_if(begin(range), end(range), output, taken(function, by));
}
template <class Range, class Output>
constexpr Output move(Range&& range, Output output) {
  return std::move(begin(range), end(range), output);
}
template <class Range, class Output, class Function, class By = identity>
constexpr Output transform(Range&& range, Output output, Function function, By by = {}) {
  return std::transform(begin(range), end(range), output, taken(function, by));
}

}  // namespace std::ranges

namespace std {

template <class Value>
constexpr strong_ordering ordering_of(const Value& a, const Value& b) {
  if (a < b) return strong_ordering::less;
  return b < a ? strong_ordering::greater : strong_ordering::equal;
}
// The lists of types differ, or this operator would be preferred to < of tuples, which it calls.
template <class... A, class... B>
constexpr strong_ordering operator<=>(const tuple<A...>& a, const tuple<B...>& b) {
  return ordering_of(a, b);
}
template <class A, class Allocator>
strong_ordering operator<=>(const vector<A, Allocator>& a, const vector<A, Allocator>& b) {
  return ordering_of(a, b);
}

/// A thread that is joined at the end.
struct jthread : thread {
  using thread::thread;
  jthread(jthread&&) = default;
  ~jthread() {
    if (joinable()) join();
  }
};

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  if (text.empty() || string_view("+ \t\n\v\f\r").find(text[0]) != string_view::npos) return {first, errc::invalid_argument};
  char* end = nullptr;
  const double found = strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, errc::invalid_argument};
  value = found;
  return {first + (end - text.c_str()), errc{}};
}

}  // namespace std
