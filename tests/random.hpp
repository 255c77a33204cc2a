// Choices, texts and trees at random: the same ones for the same seed.
#pragma once

#include <cstdlib>
#include <derivations/language/functions.hpp>
#include <derivations/language/tree.hpp>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace rederive::test {
using namespace language;

class Choices {
 public:
  explicit Choices(unsigned seed) : random_(seed) {}

  /// Returns a number from 0 to n - 1.
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  /// Returns whether the one case in `n` comes that is asked for.
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class T>
  const T& pick(const std::vector<T>& items) {
    return items[below(items.size())];
  }

 private:
  std::mt19937 random_;
};

/// Returns the text with a value in place of each name, wherever it occurs.
inline std::string filled(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [name, value] : values)
    for (std::size_t k = 0; (k = text.find(name, k)) != std::string::npos; k += value.size())
      text.replace(k, name.size(), value);
  return text;
}

/// Returns the number in a variable of the environment, such as REDERIVE_SEED and REDERIVE_PAIRS, with which
/// one chooses another run of a test; it is printed.
inline long from_environment(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  const long number = text != nullptr ? std::strtol(text, nullptr, 10) : otherwise;
  std::cout << name << "=" << number << "\n";
  return number;
}

/// Trees of every shape that the grammar has.
class RandomTrees {
 public:
  RandomTrees(unsigned seed, std::vector<std::string> names) : choices_(seed), names_(std::move(names)) {
    for (const auto& function : functions()) functions_.emplace_back(function.name);
  }
  Tree next() { return tree(1 + choices_.below(4)); }

 private:
  using Kind = Node::Kind;

  Tree leaf() {
    if (choices_.one_in(3)) return make_tree(Kind::number, choices_.pick(numbers_));
    return make_tree(Kind::symbol, choices_.one_in(12) ? "pi" : choices_.pick(names_));
  }

  Tree tree(std::size_t depth) {
    if (depth == 0) return leaf();
    const std::size_t kind = choices_.below(9);
    std::vector<Tree> children{tree(depth - 1)};
    if (kind == 0) return make_tree(Kind::negative, "", children);
    if (kind == 1) return make_tree(Kind::power, "", {children[0], tree(choices_.below(depth))});
    if (kind < 4) return make_tree(Kind::call, choices_.pick(functions_), children);
    std::vector<bool> inverse{false};
    for (std::size_t more = 1 + choices_.below(3); more > 0; --more) {
      children.push_back(tree(choices_.below(depth)));
      inverse.push_back(choices_.one_in(2));
    }
    return make_tree(kind < 6 ? Kind::sum : Kind::product, "", children, inverse);
  }

  Choices choices_;
  std::vector<std::string> names_, functions_, numbers_{"1", "2", "3", "10", "0.25", "1e-3", "17"};
};

}  // namespace rederive::test
