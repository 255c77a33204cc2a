#include <algorithm>
#include <derivations/algebra/conjunction.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/in_square.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/certificate_factors.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// With exp(log(x)), or sqrt(x)^2, for every x whose range the domain narrows so.
Tree with_functions(const Tree& tree, const Symbols& symbols, const Symbols& domain) {
  if (tree->kind == Node::Kind::symbol) {
    const Symbol *whole = symbols.find(tree->text), *narrow = domain.find(tree->text);
    if (whole == nullptr || whole->range == narrow->range) return tree;
    const bool is_log = narrow->range[0] == '(';
    return parse((is_log ? "exp(log(" : "(sqrt(") + tree->text + (is_log ? "))" : ")^2)"), symbols);
  }
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = with_functions(child, symbols, domain);
  return copy;
}

/// Finds what makes one link hold.
struct Finder : Factors {
  const Question question{q.left, q.right, q.symbols, q.given};

  /// Of one side alone; `op` as residuals have it.
  std::optional<CertifiedLink> settle(CertifiedSide side, const std::string& op, bool is_left) const {
    const auto holds = settled(side.residual, claim_of(op), q.symbols);
    if (!holds) return std::nullopt;
    const auto form = *holds && op == "=" ? ex(0) : form_of_one_sign(side.residual);
    const auto parts = form ? CertifiedFactor{} : parts_of_one_sign(side.residual);
    const auto square = form || parts || !*holds ? std::nullopt : shown_in_square(side.residual, q.symbols);
    if (!form && !parts && !square) return std::nullopt;
    if (square) {
      for (const ex& root : square->roots) side.roots.push_back(tree(root));
      side.form = tree(form_of_one_sign(square->rest).value_or(square->rest));
    }
    if (form) side.form = sign_by_slope(*form, q.symbols) ? to_tree(*form, q.symbols) : tree(*form);
    if (parts) side.parts = *parts;
    CertifiedLink link;
    (is_left ? link.left : link.right) = side, link.holds = holds;
    return link;
  }

  /// What was taken off such sides. That x is positive beside log(x) is seen of exp(log(x)).
  std::optional<std::vector<CertifiedLayer>> put_down(const std::vector<Layer>& layers, Sides sides) const {
    std::vector<CertifiedLayer> result;
    for (const Layer& layer : layers) {
      const Symbols domain = narrowed_by_functions(sides, q.symbols);
      const CertifiedStatement there{q.left, q.right, domain, q.given, q.equal, q.ranges};
      auto factor = layer.function == "*" ? Factors(there, divisors).of_value(layer.factor)
                                          : std::optional(CertifiedFactor{});
      if (!factor) return std::nullopt;
      for (CertifiedPart& p : *factor) p.part = with_functions(p.part, q.symbols, domain);
      result.push_back({layer, *factor});
      sides = {layer.left, "", layer.right};
    }
    return result;
  }

  /// How the sides of a link are taken.
  enum class Taken { as_they_stand, unwrapped, squared };

  /// Links of one statement; and "=", ">" or ">=".
  std::optional<std::pair<CertifiedSide, std::string>> side(const Relation& relation,
                                                            const std::vector<std::size_t>& numbers,
                                                            Taken taken) const {
    CertifiedSide result{numbers, {}, 1};
    std::string op;
    ex sum = 0;
    for (const std::size_t k : numbers) {
      Sides s = sides_of(rederive::links_of(relation)[k], question);
      std::vector<Layer> layers;
      if (taken != Taken::as_they_stand) s = unwrapped(s, q.symbols, &layers);
      const auto squares = taken == Taken::squared ? squared(s, q.symbols, &layers) : s;
      if (!squares) return std::nullopt;
      s = *squares;
      op = s.op[0] == '<' ? ">" + s.op.substr(1) : s.op;
      const auto written = put_down(layers, sides_of(rederive::links_of(relation)[k], question));
      if (!written) return std::nullopt;
      result.layers.push_back(*written);
      result.residual *= residual_of(s), sum += residual_of(s);
    }
    if (numbers.size() > 1) {
      const auto form = form_of_one_sign(sum.expand());
      if (!form) return std::nullopt;
      result.sum = tree(*form);
    }
    return std::pair{result, op};
  }

  bool is_high(const Relation& relation, const std::vector<std::size_t>& numbers) const {
    return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t k) {
      return has_high_power(residual_of(sides_of(rederive::links_of(relation)[k], question)));
    });
  }
  /// Whether a factor has arcs, or logarithms, that the statement has not: atan(u) - atan(v) as one of them.
  bool has_new_arcs(const CertifiedFactor& factor) const {
    std::set<std::string> known;
    for (const Relation* relation : {&q.left, &q.right})
      for (const Tree& side : relation->sides) collect_arcs(side, known);
    std::set<std::string> all = known;
    for (const CertifiedPart& p : factor) collect_arcs(p.part, all);
    return all.size() > known.size();
  }
  void collect_arcs(const Tree& tree, std::set<std::string>& texts) const {
    if (tree->kind == Node::Kind::call && (tree->text[0] == 'a' || tree->text == "log"))
      texts.insert(print(lower(tree, q.symbols), Notation::plain, q.symbols));
    for (const Tree& child : tree->children) collect_arcs(child, texts);
  }
  std::optional<CertifiedLink> find_same(const Match& match) const {
    std::vector<std::pair<Taken, Taken>> ways{{Taken::as_they_stand, Taken::as_they_stand},
                                              {Taken::unwrapped, Taken::unwrapped},
                                              {Taken::squared, Taken::unwrapped},
                                              {Taken::unwrapped, Taken::squared}};
    if (is_high(q.left, match.left) || is_high(q.right, match.right))
      std::rotate(ways.begin(), ways.begin() + 1, ways.end());
    std::vector<std::pair<CertifiedLink, std::string>> links;
    for (const auto& [of_left, of_right] : ways) {
      const auto left = side(q.left, match.left, of_left), right = side(q.right, match.right, of_right);
      if (left && right && left->second == right->second)
        links.push_back({{left->first, right->first, {}, {}, {}}, left->second});
    }
    std::stable_partition(links.begin(), links.end(),
                          [](const auto& one) { return differ_by_powers(one.first); });
    std::optional<CertifiedLink> found;
    for (auto& [link, op] : links) {
      if (!find_factor(link, op)) continue;
      if (!has_new_arcs(link.factor)) return link;
      if (!found) found = link;
    }
    return found;
  }
  /// Whether one residual is the other times a number and powers of symbols: then no more need be looked for.
  static bool differ_by_powers(const CertifiedLink& link) {
    if (link.right.residual.is_zero()) return false;
    const ex ratio = (link.left.residual / link.right.residual).normal();
    return std::none_of(ratio.preorder_begin(), ratio.preorder_end(), [](const ex& part) {
      return GiNaC::is_a<GiNaC::add>(part) || GiNaC::is_a<GiNaC::function>(part);
    });
  }
  /// A link that always holds, or never.
  CertifiedLink find_settled(const std::vector<std::size_t>& number, bool is_left) const {
    std::optional<CertifiedLink> found;
    for (const Taken taken : {Taken::as_they_stand, Taken::unwrapped}) {
      const auto taken_so = side(is_left ? q.left : q.right, number, taken);
      const auto link = taken_so ? settle(taken_so->first, taken_so->second, is_left) : std::nullopt;
      if (!link) continue;
      const CertifiedSide& shown = is_left ? link->left : link->right;
      if (!shown.form || !has_new_arcs({{shown.form, 1}})) return *link;
      if (!found) found = link;
    }
    if (!found) throw Undecidable("no form shows that a link always holds, or never");
    return *found;
  }
  /// A link that follows from those of the other side.
  CertifiedLink find_consequence(const Match& match) const {
    const auto written = [&](const ex& e) { return tree(form_of_one_sign(e).value_or(e)); };
    CertifiedLink link;
    link.left.links = match.left, link.right.links = match.right;
    const Tree more = written(match.why->more), times = written(match.why->times);
    link.follows = {{}, more, times, match.why->squared};
    if (sign_of(match.why->times, q.symbols) == 0)  // of an inequality it may be 0
      link.follows->product = of_value(match.why->times).value_or(CertifiedFactor{});
    for (const auto& [factor, links] : match.why->terms)
      link.follows->terms.emplace_back(written(factor), links);
    return link;
  }
};

/// One relation against one.
bool is_pair(const CertifiedStatement& q) {
  return q.left.operators.size() == 1 && q.right.operators.size() == 1;
}

}  // namespace

std::vector<CertifiedLink> links_of(const CertifiedStatement& q) {
  if (prove(q.left, q.right, q.symbols, q.given).verdict != Verdict::proved) throw Undecidable("not proved");
  if (q.left.operators.empty()) {
    const auto side = [&](const Relation& expression) {
      return CertifiedSide{{0}, {{}}, put_in(lower(expression.sides[0], q.symbols), q.given)};
    };
    return {{side(q.left), side(q.right), {}, {}, {}}};
  }
  const std::vector<CertifiedDivisor> divisors = divisors_of(q);
  const Finder finder{Factors(q, divisors)};
  if (const auto link = is_pair(q) ? finder.find_same({{0}, {0}}) : std::nullopt)
    return {finder.with_slopes(*link)};
  std::vector<CertifiedLink> links;
  for (const Match& match : matches(finder.question).value_or(std::vector<Match>{}))
    if (match.why) {
      links.push_back(finder.find_consequence(match));
    } else if (match.never || match.left.empty() || match.right.empty()) {
      if (!match.left.empty()) links.push_back(finder.find_settled(match.left, true));
      if (!match.right.empty()) links.push_back(finder.find_settled(match.right, false));
    } else {
      const auto link = finder.find_same(match);
      if (!link) throw Undecidable("no factor without zeros was found");
      links.push_back(*link);
    }
  if (links.empty() && is_pair(q))
    for (const bool is_left : {true, false}) links.push_back(finder.find_settled({0}, is_left));
  if (links.empty()) throw Undecidable("nothing was found that says it link by link");
  for (CertifiedLink& link : links) link = finder.with_slopes(link);
  return links;
}

}  // namespace rederive
