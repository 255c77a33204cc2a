#include <algorithm>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/certificate.hpp>
#include <set>
#include <sstream>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Json = nlohmann::ordered_json;

namespace {

/// A polynomial as text, term by term: "3*x^2*z1 - 1/2".
std::string polynomial_text(const ex& polynomial) {
  const auto term_text = [](const ex& term) {
    std::vector<std::string> factors;
    numeric number = 1;
    const auto one = [&](const ex& f) {
      std::ostringstream text;
      if (is_a<numeric>(f))
        number = ex_to<numeric>(f);
      else if (is_a<GiNaC::power>(f))
        text << f.op(0) << "^" << f.op(1);
      else
        text << f;
      if (!text.str().empty()) factors.push_back(text.str());
    };
    if (is_a<GiNaC::mul>(term))
      for (const ex& f : term) one(f);
    else
      one(term);
    std::sort(factors.begin(), factors.end());
    std::ostringstream text;
    text << number;
    for (const std::string& f : factors) text << "*" << f;
    return text.str();
  };
  const ex expanded = polynomial.expand();
  if (!is_a<GiNaC::add>(expanded)) return term_text(expanded);
  std::vector<std::string> terms;
  for (const ex& term : expanded) terms.push_back(term_text(term));
  std::sort(terms.begin(), terms.end());
  std::string text;
  for (const std::string& term : terms) text += (text.empty() ? "" : " + ") + term;
  return text;
}

Json fraction_json(const ex& numerator, const ex& denominator) {
  return {{"numerator", polynomial_text(numerator)}, {"denominator", polynomial_text(denominator)}};
}

bool is_circular(const std::string& name) {
  return name == "sin" || name == "cos" || name == "tan" || name == "cot" || name == "sec" || name == "csc";
}
bool is_real(const std::string& name) {
  return name == "exp" || name == "sinh" || name == "cosh" || name == "tanh" || name == "coth" ||
         name == "sech" || name == "csch";
}

Tree call(const std::string& name, const Tree& argument) {
  Node node{};
  node.kind = Node::Kind::call;
  node.text = name;
  node.children = {argument};
  node.inverse = {false};
  return std::make_shared<const Node>(std::move(node));
}

/// What the trees of a statement are made of, in the order in which it is met.
struct Pieces {
  const Symbols& symbols;
  std::vector<Tree> calls, divisors;

  bool is_whole(const Tree& exponent) const {
    const ex value = lower(exponent, symbols);
    return is_a<numeric>(value) && ex_to<numeric>(value).is_integer();
  }

  void visit(const Tree& tree) {
    for (const Tree& child : tree->children) visit(child);
    if (tree->kind == Node::Kind::product)
      for (std::size_t k = 0; k < tree->children.size(); ++k)
        if (tree->inverse[k]) divisors.push_back(tree->children[k]);
    if (tree->kind == Node::Kind::power) {
      if (!is_whole(tree->children[1]))
        calls.push_back(tree);
      else if (ex_to<numeric>(lower(tree->children[1], symbols)).is_negative())
        divisors.push_back(tree->children[0]);
    }
    if (tree->kind != Node::Kind::call) return;
    calls.push_back(tree);
    for (const auto& [name, divisor] : {std::pair{"tan", "cos"},
                                        {"sec", "cos"},
                                        {"cot", "sin"},
                                        {"csc", "sin"},
                                        {"coth", "sinh"},
                                        {"csch", "sinh"},
                                        {"tanh", "cosh"},
                                        {"sech", "cosh"}})
      if (tree->text == name) {
        divisors.push_back(call(divisor, tree->children[0]));
        calls.push_back(divisors.back());
      }
  }
};

struct Link {
  ex left, right;  ///< residuals
  Tree factor;
};

ex residual(const Relation& relation, std::size_t k, const Symbols& symbols) {
  if (relation.operators.empty()) return lower(relation.sides[0], symbols);
  const std::string& op = relation.operators[k];
  const ex a = lower(relation.sides[op == "=" ? 0 : k], symbols), b = lower(relation.sides[k + 1], symbols);
  return op[0] == '<' ? b - a : a - b;
}

Json generators_json(const Phases& phases, const Symbols& symbols) {
  static const char* kinds[] = {"circular", "real", "root", "imaginary", "pi", "opaque"};
  Json list = Json::array();
  for (const Generator& g : phases.generators()) {
    if (g.kind == Generator::Kind::pi) continue;
    Json item{{"name", g.symbol.get_name()},
              {"kind", kinds[static_cast<int>(g.kind)]},
              {"divisor", g.divisor},
              {"degree", g.degree}};
    item["meaning"] = g.kind == Generator::Kind::imaginary ? "" : print(g.meaning, Notation::plain, symbols);
    if (g.degree > 0) {
      const ex value = g.value.numer_denom();
      item["relation"] = fraction_json(value.op(0), value.op(1));
    }
    list.push_back(item);
  }
  return list;
}

/// The givens that the statement needs: those whose names it has, and what they have in turn.
std::vector<Given> needed(const Relation& left, const Relation& right, const std::vector<Given>& given,
                          const Symbols& symbols) {
  std::set<std::string> names;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  std::vector<Given> result;
  for (std::size_t round = 0; round <= given.size(); ++round) {
    result.clear();
    for (const Given& g : given) {
      if (!names.contains(ex_to<GiNaC::symbol>(g.name).get_name())) continue;
      result.push_back(g);
      collect_names(to_tree(g.value, symbols), names);
    }
  }
  return result;
}

}  // namespace

std::optional<Json> certificate(const Relation& left, const Relation& right, const Symbols& symbols,
                                const std::vector<Given>& all_given) {
  const std::vector<Given> given = needed(left, right, all_given, symbols);
  Pieces pieces{symbols, {}, {}};
  std::vector<Link> links;
  const std::size_t count = std::max<std::size_t>(1, left.operators.size());
  for (std::size_t k = 0; k < count; ++k) {
    const Relation link = left.operators.empty()
                              ? left
                              : Relation{{left.sides[left.operators[k] == "=" ? 0 : k], left.sides[k + 1]},
                                         {left.operators[k]}};
    const Proof proof = prove(link, right, symbols, given);
    if (proof.verdict != Verdict::proved || proof.factor.empty()) return std::nullopt;
    links.push_back({put_in(residual(left, k, symbols), given), put_in(residual(right, 0, symbols), given),
                     parse(proof.factor, symbols)});
    pieces.visit(links.back().factor);
  }
  pieces.divisors.clear();
  for (const Given& g : given) pieces.visit(to_tree(g.value, symbols));
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) pieces.visit(side);
  const std::vector<Tree> divisors = pieces.divisors;

  const auto value = [&](const Tree& tree) { return put_in(lower(tree, symbols), given); };
  std::vector<ex> expressions;
  for (const Tree& tree : pieces.calls) expressions.push_back(value(tree));
  for (const Link& link : links)
    expressions.insert(expressions.end(), {link.left, link.right, value(link.factor)});
  const bool has_turns = std::any_of(pieces.calls.begin(), pieces.calls.end(), [&](const Tree& tree) {
    return is_circular(tree->text) && value(tree->children[0]).has(GiNaC::Pi);
  });
  if (has_turns)
    expressions.push_back(GiNaC::sqrt(ex(2)) + GiNaC::sqrt(ex(3)));  // cos(pi/12) is made of them
  try {
    const std::size_t stated = pieces.calls.size();
    const Phases first(expressions, symbols);
    for (const Generator& g : first.generators())  // what the phases are made of counts too
      if (g.kind != Generator::Kind::imaginary) pieces.visit(to_tree(g.meaning, symbols));
    for (std::size_t k = stated; k < pieces.calls.size(); ++k) expressions.push_back(value(pieces.calls[k]));
    std::rotate(pieces.calls.begin(), pieces.calls.begin() + static_cast<std::ptrdiff_t>(stated),
                pieces.calls.end());
    const Phases phases(expressions, symbols);
    Json result{{"format", "rederive certificate 1"},
                {"left", print(left, Notation::plain, symbols)},
                {"right", print(right, Notation::plain, symbols)},
                {"given", Json::object()}};
    for (const Given& g : given)
      result["given"][ex_to<GiNaC::symbol>(g.name).get_name()] = print(g.value, Notation::plain, symbols);
    result["generators"] = generators_json(phases, symbols);
    result["arguments"] = Json::array(), result["facts"] = Json::array(), result["divisors"] = Json::array();
    for (const Tree& tree : pieces.calls) {
      const bool circular = is_circular(tree->text);
      if (circular || is_real(tree->text)) {
        try {
          const auto [exponents, pi] =
              phases.combination(prepare(value(tree->children[0]), symbols), circular);
          Json item{{"of", print(tree->children[0], Notation::plain, symbols)},
                    {"circular", circular},
                    {"phases", Json::object()},
                    {"pi", polynomial_text(pi)}};
          for (const auto& [symbol, exponent] : exponents)
            item["phases"][symbol.get_name()] = exponent.to_int();
          if (std::find(result["arguments"].begin(), result["arguments"].end(), item) ==
              result["arguments"].end())
            result["arguments"].push_back(item);
          continue;
        } catch (const Undecidable&) {  // then it is a fact
        }
      }
      const ex parts = phases(value(tree)).normal().numer_denom();
      Json item{{"of", print(tree, Notation::plain, symbols)},
                {"is", fraction_json(parts.op(0), parts.op(1))}};
      if (std::find(result["facts"].begin(), result["facts"].end(), item) == result["facts"].end())
        result["facts"].push_back(item);
    }
    for (const Tree& divisor : divisors) {
      const std::string text = print(divisor, Notation::plain, symbols);
      if (std::find(result["divisors"].begin(), result["divisors"].end(), text) == result["divisors"].end())
        result["divisors"].push_back(text);
    }
    result["links"] = Json::array();
    for (const Link& link : links) {
      const ex l = phases(link.left).normal().numer_denom(), r = phases(link.right).normal().numer_denom(),
               f = phases(value(link.factor)).normal().numer_denom();
      const ex remains = (l.op(0) * r.op(1) * f.op(1) - r.op(0) * f.op(0) * l.op(1)).expand();
      if (!phases.reduce(remains).is_zero()) return std::nullopt;
      result["links"].push_back({{"left", fraction_json(l.op(0), l.op(1))},
                                 {"right", fraction_json(r.op(0), r.op(1))},
                                 {"factor", print(link.factor, Notation::plain, symbols)},
                                 {"remains", polynomial_text(remains)}});
    }
    return result;
  } catch (const Undecidable&) {
    return std::nullopt;
  }
}

}  // namespace rederive
