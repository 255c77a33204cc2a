// A dimension for every node, from the leaves up; where two disagree, the terms are named.
#include <algorithm>
#include <derivations/algebra/dimension.hpp>
#include <derivations/algebra/print.hpp>

namespace rederive {

namespace {

/// None: 0, which is of any dimension.
using Maybe = std::optional<Dimension>;

constexpr const char* pure_name = "a pure number";
const Dimension pure = {0, 0, 0};

struct Inconsistent {
  std::string explanation;
};

std::string named(const Dimension& dimension) { return dimension == pure ? pure_name : unit_text(dimension); }

/// One term of a sum, and what to call it.
struct LabelledTerm {
  std::string label;
  Maybe dimension;
};

/// The dimension that most terms have, the first of them where there are as many of another.
Maybe usual(const std::vector<LabelledTerm>& terms) {
  Maybe best;
  std::ptrdiff_t most = 0;
  for (const LabelledTerm& term : terms) {
    const auto count = std::count_if(terms.begin(), terms.end(), [&](const LabelledTerm& other) {
      return other.dimension == term.dimension;
    });
    if (term.dimension && count > most) {
      best = term.dimension;
      most = count;
    }
  }
  return best;
}

/// "term 3 is kg·m²/s, the others kg·m²/s²"
std::string disagreement(const std::vector<LabelledTerm>& terms, const Dimension& reference) {
  std::string text;
  std::vector<LabelledTerm> others;
  for (const LabelledTerm& term : terms) {
    if (!term.dimension) continue;
    if (*term.dimension == reference) {
      others.push_back(term);
    } else {
      text += (text.empty() ? "" : " and ") + term.label + " is " + named(*term.dimension);
    }
  }
  return text + ", " + (others.size() == 1 ? others[0].label + " is" : "the others") + " " + named(reference);
}

Maybe common(const std::vector<LabelledTerm>& terms, const std::string& where) {
  const Maybe reference = usual(terms);
  const bool agree = std::all_of(terms.begin(), terms.end(), [&](const LabelledTerm& term) {
    return !term.dimension || term.dimension == reference;
  });
  if (!agree) throw Inconsistent{where + disagreement(terms, *reference)};
  return reference;
}

class Dimensions {
 public:
  explicit Dimensions(const Symbols& symbols) : symbols_(symbols) {}

  Maybe of(const Node& node) const {
    switch (node.kind) {
      case Node::Kind::number:
        return cln::zerop(exact(node.text)) ? Maybe() : Maybe(pure);
      case Node::Kind::symbol:
        return symbol(node.text);
      case Node::Kind::negative:
        return of(*node.children[0]);
      case Node::Kind::sum:
        return common(terms(node, ""), "in " + shown(node) + ": ");
      case Node::Kind::product:
        return product(node);
      case Node::Kind::power:
        return power(node);
      case Node::Kind::call:
        return call(node);
    }
    return std::nullopt;
  }

  /// The terms of a side, each with its label; a side that is no sum is one term.
  std::vector<LabelledTerm> terms(const Node& side, const std::string& place) const {
    if (side.kind != Node::Kind::sum) return {{"term 1" + place, of(side)}};
    std::vector<LabelledTerm> result;
    for (std::size_t i = 0; i < side.children.size(); ++i) {
      result.push_back({"term " + std::to_string(i + 1) + place, of(*side.children[i])});
    }
    return result;
  }

 private:
  std::string shown(const Node& node) const {
    return print(std::make_shared<const Node>(node), Notation::plain, symbols_);
  }

  Maybe symbol(const std::string& name) const {
    if (name == "pi") return pure;
    const Symbol* known = symbols_.find(name);
    if (known == nullptr) throw Inconsistent{"the unit of " + name + " is not known"};
    return parse_unit(known->unit);
  }

  Maybe product(const Node& node) const {
    Dimension total = pure;
    bool zero = false;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Maybe factor = of(*node.children[i]);
      if (!factor) zero = true;
      if (!factor) continue;
      for (std::size_t k = 0; k < total.size(); ++k) {
        total[k] += node.inverse[i] ? -(*factor)[k] : (*factor)[k];
      }
    }
    return zero ? Maybe() : Maybe(total);
  }

  Maybe power(const Node& node) const {
    const Maybe base = of(*node.children[0]);
    expect_pure(*node.children[1], "the exponent " + shown(*node.children[1]));
    if (!base || *base == pure) return base;
    const GiNaC::ex exponent = lower(node.children[1], symbols_);
    if (!exponent.info(GiNaC::info_flags::rational)) {
      throw Inconsistent{shown(*node.children[0]) + " is " + named(*base) +
                         ", and its exponent is no number"};
    }
    return scaled(*base, GiNaC::ex_to<GiNaC::numeric>(exponent));
  }

  Maybe call(const Node& node) const {
    if (node.text == "sqrt" || node.text == "fabs") {
      const Maybe argument = of(*node.children[0]);
      return argument && node.text == "sqrt" ? scaled(*argument, GiNaC::numeric(1, 2)) : argument;
    }
    for (const Tree& argument : node.children) expect_pure(*argument, "the argument of " + node.text);
    return pure;
  }

  static Dimension scaled(Dimension dimension, const GiNaC::numeric& factor) {
    for (GiNaC::numeric& exponent : dimension) exponent *= factor;
    return dimension;
  }

  void expect_pure(const Node& node, const std::string& what) const {
    const Maybe dimension = of(node);
    if (dimension && *dimension != pure) {
      throw Inconsistent{what + " is " + named(*dimension) + ", not " + pure_name};
    }
  }

  const Symbols& symbols_;
};

std::string side_name(std::size_t side, std::size_t sides) {
  if (sides == 2) return side == 0 ? "the left side" : "the right side";
  return "side " + std::to_string(side + 1);
}

/// The terms of all sides; whole sides where each is one term.
std::vector<LabelledTerm> all_terms(const Relation& relation, const Dimensions& dimensions) {
  const std::size_t count = relation.sides.size();
  const auto is_sum = [](const Tree& side) { return side->kind == Node::Kind::sum; };
  const auto sums = std::count_if(relation.sides.begin(), relation.sides.end(), is_sum);
  std::vector<LabelledTerm> all;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = side_name(i, count);
    const bool lone = !is_sum(relation.sides[i]);
    for (LabelledTerm term : dimensions.terms(*relation.sides[i], sums > 1 ? " of " + name : "")) {
      if (lone) term.label = name;
      all.push_back(term);
    }
  }
  return all;
}

template <class Judge>
DimensionReport report(const Judge& judge) {
  try {
    return {true, judge(), ""};
  } catch (const Inconsistent& problem) {
    return {false, std::nullopt, problem.explanation};
  }
}

}  // namespace

DimensionReport dimension(const Tree& tree, const Symbols& symbols) {
  const Dimensions dimensions(symbols);
  return report([&] { return common(dimensions.terms(*tree, ""), ""); });
}

DimensionReport dimension(const Relation& relation, const Symbols& symbols) {
  const Dimensions dimensions(symbols);
  if (relation.sides.size() == 1) return dimension(relation.sides[0], symbols);
  return report([&] { return common(all_terms(relation, dimensions), ""); });
}

}  // namespace rederive
