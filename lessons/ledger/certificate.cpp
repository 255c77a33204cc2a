#include <algorithm>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/certificate_steps.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using Json = nlohmann::ordered_json;

namespace {

/// What a text divides by, in the order in which it is met.
void collect_divisors(const Tree& tree, const CertifiedStatement& q, std::vector<Tree>& divisors) {
  for (const Tree& child : tree->children) collect_divisors(child, q, divisors);
  if (tree->kind == Node::Kind::product)
    for (std::size_t k = 0; k < tree->children.size(); ++k)
      if (tree->inverse[k]) divisors.push_back(tree->children[k]);
  if (tree->kind == Node::Kind::power && !q.is_root(tree) && q.rational(tree->children[1])->is_negative())
    divisors.push_back(tree->children[0]);
  if (tree->kind != Node::Kind::call) return;
  for (const auto& [divisor, names] : {std::pair{"cos", std::array{"tan", "sec"}},
                                       {"sin", {"cot", "csc"}},
                                       {"sinh", {"coth", "csch"}},
                                       {"cosh", {"tanh", "sech"}}})
    if (tree->text == names[0] || tree->text == names[1])
      divisors.push_back(call(divisor, tree->children[0]));
}

ex residual(const Relation& relation, std::size_t k, const Symbols& symbols) {
  if (relation.operators.empty()) return lower(relation.sides[0], symbols);
  const std::string& op = relation.operators[k];
  const ex a = lower(relation.sides[op == "=" ? 0 : k], symbols), b = lower(relation.sides[k + 1], symbols);
  return op[0] == '<' ? b - a : a - b;
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

struct Link {
  ex left, right;  ///< residuals
  Tree factor;
};

/// Every link's factor, or nothing where one is not proved.
std::optional<std::vector<Link>> prove_links(const CertifiedStatement& q) {
  std::vector<Link> links;
  for (std::size_t k = 0; k < std::max<std::size_t>(1, q.left.operators.size()); ++k) {
    const Relation& left = q.left;
    const Relation link = left.operators.empty()
                              ? left
                              : Relation{{left.sides[left.operators[k] == "=" ? 0 : k], left.sides[k + 1]},
                                         {left.operators[k]}};
    const Proof proof = prove(link, q.right, q.symbols, q.given);
    if (proof.verdict != Verdict::proved || proof.factor.empty()) return std::nullopt;
    links.push_back(
        {residual(left, k, q.symbols), residual(q.right, 0, q.symbols), parse(proof.factor, q.symbols)});
  }
  return links;
}

/// The same with exact rational numbers for decimals.
Tree exact(const Tree& tree, const Symbols& symbols) {
  if (tree->kind == Node::Kind::number && tree->text.find_first_of(".e") != std::string::npos)
    return to_tree(lower(tree, symbols), symbols);
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = exact(child, symbols);
  return copy;
}

/// A statement in pieces: sides and operators.
Json statement_json(const Relation& relation, const CertifiedStatement& q) {
  Json list{q.text(relation.sides[0])};
  for (std::size_t k = 0; k < relation.operators.size(); ++k)
    list.push_back(relation.operators[k]), list.push_back(q.text(relation.sides[k + 1]));
  return list;
}

/// What z^n + 1 has besides the minimal polynomial of z = e^{iπ/n}.
ex cofactor_of_turns(const Phases& phases) {
  for (const Generator& g : phases.generators())
    if (g.kind == Generator::Kind::circular && g.meaning.is_equal(GiNaC::Pi))
      return GiNaC::quo(GiNaC::pow(g.symbol, g.divisor) + 1, GiNaC::pow(g.symbol, g.degree) - g.value,
                        g.symbol);
  return 1;
}

/// The ranges of all names that are free in a text.
Json ranges_json(const std::vector<Tree>& trees, const CertifiedStatement& q) {
  std::set<std::string> names;
  for (const Tree& tree : trees) collect_names(tree, names);
  for (const Given& g : q.given) names.erase(ex_to<GiNaC::symbol>(g.name).get_name());
  Json ranges = Json::object();
  for (const std::string& name : names)
    if (const Symbol* symbol = q.symbols.find(name); symbol != nullptr && name != "pi")
      ranges[name] = symbol->range;
  return ranges;
}

/// The functions that stand alone in a sum that vanishes, each with what it equals; small coefficients first.
std::vector<std::pair<ex, ex>> solutions(const ex& sum) {
  std::vector<std::pair<GiNaC::numeric, ex>> functions;
  const ex terms = sum.expand();
  for (const ex& term : terms) {
    const ex number = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : ex(1), f = term / number;
    if (is_a<GiNaC::numeric>(number) && !name_of(f).empty() && name_of(f) != "abs")
      functions.emplace_back(ex_to<GiNaC::numeric>(number), f);
  }
  std::stable_sort(functions.begin(), functions.end(),
                   [](const auto& a, const auto& b) { return GiNaC::abs(a.first) < GiNaC::abs(b.first); });
  std::vector<std::pair<ex, ex>> result;
  for (const auto& [number, f] : functions) result.emplace_back(f, (f - terms / number).expand());
  return result;
}

/// What is put down about a statement: all functions in its trees, and every link.
struct Written {
  const std::vector<Tree>& trees;
  Json steps, links;
};

/// Throws Undecidable.
void write_links(const CertifiedStatement& q, const std::vector<Link>& links, Written& written);

/// With one function of a vanishing sum replaced by the others.
void write_with_lemma(const ex& sum, CertifiedStatement q, const std::vector<Link>& links, Written& written) {
  if (q.equal.size() > 3) throw Undecidable("too many sums of inverse functions");
  for (const auto& [function, value] : solutions(sum)) {
    try {
      CertifiedStatement next = q;
      next.equal[function] = value;
      return write_links(next, links, written);
    } catch (const Undecidable&) {  // then another one
    }
  }
  throw Undecidable("a sum that vanishes, and no function in it that the others give");
}

void write_links(const CertifiedStatement& q, const std::vector<Link>& links, Written& written) {
  std::vector<ex> expressions = expressions_in(q, written.trees);
  for (const Link& link : links)
    expressions.insert(expressions.end(), {q.value(link.left), q.value(link.right)});
  const Phases phases(expressions, q.symbols);
  Steps steps(q, phases);
  for (const Tree& tree : written.trees) steps.tree(tree);
  Json list = Json::array();
  for (const Link& link : links) {
    const ex l = phases(q.value(link.left)).normal(), r = phases(q.value(link.right)).normal(),
             f = phases(q.value(link.factor)).normal();
    const ex remains = (l.numer() * r.denom() * f.denom() - r.numer() * f.numer() * l.denom()).expand();
    const auto c = cofactor(phases.reduce(remains), phases, q.symbols);
    if (!c) {
      const auto sum =
          vanishing_sum(q.value(link.left) - q.value(link.factor) * q.value(link.right), q.symbols);
      if (!sum) throw Undecidable("no polynomial identity was found that says it");
      return write_with_lemma(*sum, q, links, written);
    }
    for (const ex& part : {l, r, *c}) steps.generators(part);
    list.push_back({{"left", fraction_text(l)},
                    {"right", fraction_text(r)},
                    {"factor", q.text(link.factor)},
                    {"remains", polynomial_text(remains)},
                    {"over", polynomial_text(l.denom() * r.denom() * f.denom())},
                    {"cofactor", polynomial_text(*c * cofactor_of_turns(phases))}});
  }
  written.links = list, written.steps = steps.take();
}

/// One piece of the domain: its ranges, and all that is put down there.
Json piece_json(const CertifiedStatement& q, const std::vector<Link>& links, const std::vector<Tree>& trees) {
  Written written{trees, {}, {}};
  write_links(q, links, written);
  return {{"ranges", ranges_json(trees, q)}, {"steps", written.steps}, {"links", written.links}};
}

/// The whole domain in one piece, or cut where an absolute value turns.
Json pieces_json(const CertifiedStatement& q, const std::vector<Link>& links,
                 const std::vector<Tree>& trees) {
  try {
    return Json::array({piece_json(q, links, trees)});
  } catch (const Undecidable&) {
    Json pieces = Json::array();
    const ex difference = lower(links[0].factor, q.symbols) * links[0].right;
    for (const Symbols& piece : analytic_pieces(put_in(links[0].left - difference, q.given), q.symbols))
      pieces.push_back(piece_json({q.left, q.right, piece, q.given, {}}, links, trees));
    if (pieces.empty()) throw;
    return pieces;
  }
}

Json write(const CertifiedStatement& q, const std::vector<Link>& links) {
  std::vector<Tree> trees, divisors;
  for (const Given& g : q.given) trees.push_back(to_tree(g.value, q.symbols));
  for (const Relation* relation : {&q.left, &q.right})
    trees.insert(trees.end(), relation->sides.begin(), relation->sides.end());
  for (const Tree& tree : trees) collect_divisors(tree, q, divisors);
  trees.insert(trees.end(), divisors.begin(), divisors.end());
  for (const Link& link : links) trees.push_back(link.factor);
  Json given = Json::object(), texts = Json::array();
  for (const Given& g : q.given)
    given[ex_to<GiNaC::symbol>(g.name).get_name()] = print(g.value, Notation::plain, q.symbols);
  for (const Tree& divisor : divisors)
    if (const std::string text = q.text(divisor); std::find(texts.begin(), texts.end(), text) == texts.end())
      texts.push_back(text);
  return {{"format", "rederive certificate 2"},
          {"left", statement_json(q.left, q)},
          {"right", statement_json(q.right, q)},
          {"given", given},
          {"divisors", texts},
          {"ranges", ranges_json(trees, q)},
          {"pieces", pieces_json(q, links, trees)}};
}

}  // namespace

std::optional<Json> certificate(const Relation& left, const Relation& right, const Symbols& symbols,
                                const std::vector<Given>& given) {
  Relation exact_left = left, exact_right = right;
  for (Relation* relation : {&exact_left, &exact_right})
    for (Tree& side : relation->sides) side = exact(side, symbols);
  CertifiedStatement question{exact_left, exact_right, symbols, needed(left, right, given, symbols), {}};
  const auto links = prove_links(question);
  if (!links) return std::nullopt;
  try {
    return write(question, *links);
  } catch (const Undecidable&) {
    return std::nullopt;
  }
}

}  // namespace rederive
