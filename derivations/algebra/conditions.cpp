#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <map>
#include <set>

namespace rederive {

namespace {

struct Collector {
  const Symbols& symbols;
  const std::vector<Given>& given;
  std::vector<std::string> found;
  std::vector<GiNaC::ex> divisors;

  bool is_granted(const GiNaC::ex& value, const std::string& relation) const {
    const GiNaC::ex e = put_in(value, given);
    return relation == ">="  ? is_nonnegative(e, symbols)
           : relation == ">" ? sign_of(e, symbols) > 0
                             : sign_of(e, symbols) != 0;
  }
  void note(const GiNaC::ex& value, const std::string& relation) {
    if (GiNaC::is_a<GiNaC::numeric>(value) || is_granted(value, relation)) return;
    const bool is_root = GiNaC::is_a<GiNaC::power>(value) && value.op(1).info(GiNaC::info_flags::positive) &&
                         !value.op(1).info(GiNaC::info_flags::integer);
    if (is_root && relation == ">") return note(value.op(0), relation);
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
      note(value, "!=");
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
          note(value(0), may_be_negative(tree->children[1]) ? ">" : ">=");
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
    if (name == "log") note(x, ">");
    if (name == "sqrt") note(x, ">=");
    if (name == "acosh") note(x - 1, ">=");
    if (name == "asin" || name == "acos") note(1 - x * x, ">=");
    if (name == "atanh") note(1 - x * x, ">");
  }
};

}  // namespace

std::vector<std::string> side_conditions(const Tree& tree, const Symbols& symbols,
                                         const std::vector<Given>& given) {
  Collector collector{symbols, given, {}, {}};
  collector.visit(tree);
  return collector.found;
}

std::vector<std::string> said_once(const std::vector<std::string>& conditions) {
  std::vector<std::string> values;  // in the order in which they are first mentioned
  std::map<std::string, std::set<std::string>> said;
  for (const std::string& condition : conditions) {  // "value relation 0"
    const std::size_t after = condition.size() - 2, before = condition.rfind(' ', after - 1);
    const std::string value = condition.substr(0, before);
    if (!said.contains(value)) values.push_back(value);
    said[value].insert(condition.substr(before + 1, after - before - 1));
  }
  std::vector<std::string> result;
  for (const std::string& value : values) {
    const std::set<std::string>& relations = said[value];
    if (relations.contains(">") || relations.size() > 1)
      result.push_back(value + " > 0");
    else
      result.push_back(value + " " + *relations.begin() + " 0");
  }
  return result;
}

std::vector<GiNaC::ex> divisors(const Tree& tree, const Symbols& symbols) {
  Collector collector{symbols, {}, {}, {}};
  collector.visit(tree);
  return collector.divisors;
}

}  // namespace rederive
