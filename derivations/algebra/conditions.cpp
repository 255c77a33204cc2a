#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <map>

namespace rederive {

namespace {

struct Collector {
  const Symbols& symbols;
  std::vector<std::string> found;
  std::vector<GiNaC::ex> divisors;

  void note(const GiNaC::ex& value, const std::string& relation, bool granted) {
    if (granted || GiNaC::is_a<GiNaC::numeric>(value)) return;
    const std::string text = print(value, Notation::plain, symbols) + " " + relation + " 0";
    if (std::find(found.begin(), found.end(), text) == found.end()) found.push_back(text);
  }
  void nonzero(const GiNaC::ex& value) {
    if (GiNaC::is_a<GiNaC::mul>(value)) {
      std::map<std::string, GiNaC::ex> in_order;  // of the alphabet, which is the same in each run
      for (const GiNaC::ex& factor : value) in_order.emplace(print(factor, Notation::plain, symbols), factor);
      for (const auto& [text, factor] : in_order) nonzero(factor);
    } else if (GiNaC::is_a<GiNaC::power>(value) && sign_of(value.op(1), symbols) > 0) {
      nonzero(value.op(0));
    } else {
      divisors.push_back(value);
      note(value, "!=", sign_of(value, symbols) != 0);
    }
  }

  bool may_be_negative(const Tree& exponent) const { return sign_of(lower(exponent, symbols), symbols) <= 0; }

  void visit(const Tree& tree) {
    for (const Tree& child : tree->children) visit(child);
    const auto value = [&](std::size_t k) { return lower(tree->children[k], symbols); };
    switch (tree->kind) {
      case Node::Kind::product:
        for (std::size_t k = 0; k < tree->children.size(); ++k)
          if (tree->inverse[k]) nonzero(value(k));
        break;
      case Node::Kind::power: {
        const GiNaC::ex exponent = value(1);
        const bool whole =
            GiNaC::is_a<GiNaC::numeric>(exponent) && GiNaC::ex_to<GiNaC::numeric>(exponent).is_integer();
        if (!whole)
          note(value(0), may_be_negative(tree->children[1]) ? ">" : ">=",
               may_be_negative(tree->children[1]) ? sign_of(value(0), symbols) > 0
                                                  : is_nonnegative(value(0), symbols));
        else if (may_be_negative(tree->children[1]))
          nonzero(value(0));
        break;
      }
      case Node::Kind::call:
        call(tree->text, value(0));
        break;
      default:
        break;
    }
  }

  void call(const std::string& name, const GiNaC::ex& x) {
    if (name == "tan" || name == "sec") nonzero(GiNaC::cos(x));
    if (name == "cot" || name == "csc") nonzero(GiNaC::sin(x));
    if (name == "coth" || name == "csch") nonzero(GiNaC::sinh(x));
    if (name == "log") note(x, ">", sign_of(x, symbols) > 0);
    if (name == "sqrt") note(x, ">=", is_nonnegative(x, symbols));
    if (name == "acosh") note(x - 1, ">=", is_nonnegative(x - 1, symbols));
    if (name == "asin" || name == "acos") note(1 - x * x, ">=", is_nonnegative(1 - x * x, symbols));
    if (name == "atanh") note(1 - x * x, ">", sign_of(1 - x * x, symbols) > 0);
  }
};

}  // namespace

std::vector<std::string> side_conditions(const Tree& tree, const Symbols& symbols) {
  Collector collector{symbols, {}, {}};
  collector.visit(tree);
  return collector.found;
}

std::vector<GiNaC::ex> divisors(const Tree& tree, const Symbols& symbols) {
  Collector collector{symbols, {}, {}};
  collector.visit(tree);
  return collector.divisors;
}

}  // namespace rederive
