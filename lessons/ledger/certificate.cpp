#include <algorithm>
#include <derivations/algebra/cells.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/certificate.hpp>
#include <lessons/ledger/certificate_forms.hpp>
#include <lessons/ledger/certificate_json.hpp>
#include <lessons/ledger/certificate_steps.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using Json = nlohmann::ordered_json;

namespace {

/// The givens that the statement needs: those whose names it has, or that say of its names what their own
/// ranges are; and what they have in turn.
std::vector<Given> needed(const Relation& left, const Relation& right, const std::vector<Given>& given,
                          const Symbols& symbols) {
  std::set<std::string> names;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  std::vector<Given> result;
  for (std::size_t round = 0; round <= given.size(); ++round) {
    result.clear();
    for (const Given& g : given) {
      const Symbols there = with_ranges_of({{g.name, put_in(g.value, given)}}, symbols);
      const bool is_said =
          std::any_of(names.begin(), names.end(),
                      [&](const std::string& name) {
                        return there.find(name) != nullptr &&
                               there.find(name)->range != symbols.find(name)->range;
                      }) ||
          std::any_of(there.otherwise().begin(), there.otherwise().end(), [&](const auto& symbol_and_words) {
            return names.contains(symbols.find(symbol_and_words.first)->name);
          });
      if (!names.contains(symbols.find(g.name)->name) && !is_said) continue;
      result.push_back(g);
      collect_names(to_tree(g.value, symbols), names);
    }
  }
  return result;
}

/// The same with exact rational numbers for decimals.
Tree exact(const Tree& tree, const Symbols& symbols) {
  if (tree->kind == Node::Kind::number && tree->text.find_first_of(".e") != std::string::npos)
    return to_tree(lower(tree, symbols), symbols);
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = exact(child, symbols);
  return copy;
}

/// The functions that stand alone in a sum that vanishes, each with what it equals; small coefficients first.
std::vector<std::pair<ex, ex>> solutions(const ex& sum) {
  std::vector<std::pair<GiNaC::numeric, ex>> functions;
  const ex expanded = sum.expand(), terms = is_a<GiNaC::add>(expanded) ? expanded : ex(GiNaC::lst{expanded});
  for (const ex& term : terms) {
    const ex number = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : ex(1), f = term / number;
    if (is_a<GiNaC::numeric>(number) && !name_of(f).empty() && name_of(f) != "abs")
      functions.emplace_back(ex_to<GiNaC::numeric>(number), f);
  }
  std::stable_sort(functions.begin(), functions.end(),
                   [](const auto& a, const auto& b) { return GiNaC::abs(a.first) < GiNaC::abs(b.first); });
  std::vector<std::pair<ex, ex>> result;
  for (const auto& [number, f] : functions) result.emplace_back(f, (f - expanded / number).expand());
  return result;
}

/// What is put down about a statement: all functions in its trees, and every link.
struct Written {
  const std::vector<Tree>& trees;
  Json steps, links;
};

/// Throws Undecidable.
void write_links(const CertifiedStatement& q, const std::vector<CertifiedLink>& links, Written& written);

/// With one function of a vanishing sum replaced by the others.
void write_with_lemma(const ex& sum, CertifiedStatement q, const std::vector<CertifiedLink>& links,
                      Written& written) {
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

/// left - factor·right, which vanishes.
ex difference(const CertifiedLink& link, const CertifiedStatement& q) {
  ex factor = 1;
  for (const CertifiedPart& p : link.factor) factor *= GiNaC::pow(lower(p.part, q.symbols), p.exponent);
  return link.left.residual - put_in(factor, q.given) * link.right.residual;
}

Json link_json(const CertifiedLink& link, const CertifiedStatement& q, const Phases& phases, Steps& steps) {
  Json json = Json::object();
  const bool is_left = !link.left.links.empty();
  if (link.follows) {
    json[is_left ? "left" : "right"] = {{"link", (is_left ? link.left : link.right).links[0]}};
    json["follows"] = consequence_json(*link.follows, q);
    return json;
  }
  if (link.holds) {
    const CertifiedSide& side = is_left ? link.left : link.right;
    if (side.form && side.roots.empty() && lower(side.form, q.symbols).is_zero() &&
        !phases.reduce(phases(q.value(side.residual)).normal().numer()).is_zero())
      throw Undecidable("an equation that always holds, and no polynomial identity that says it");
    Json& part = json[is_left ? "left" : "right"] = part_json(side, 0, q);
    if (side.form)
      part["form"] = q.text(side.form);
    else
      part["parts"] = factor_json(side.parts, q);
    for (const Tree& root : side.roots) part["roots"].push_back(q.text(root));
    json["holds"] = *link.holds;
    return json;
  }
  const ex l = steps.out(phases(q.value(link.left.residual))),
           r = steps.out(phases(q.value(link.right.residual)));
  const ex d = steps.out(phases(q.value(difference(link, q))));
  const auto c = cofactor(phases.reduce(d.numer()), phases, q.symbols);
  if (!c) throw Undecidable("no polynomial identity was found that says it");
  for (const ex& part : {l, r, *c}) steps.generators(part);
  json["left"] = side_json(link.left, l, q), json["right"] = side_json(link.right, r, q);
  json["factor"] = factor_json(link.factor, q);
  for (const auto& [part, more] : link.more) json["more"][q.text(part)] = q.text(more);
  for (const CertifiedBound& b : link.bounds)
    json["bounds"][q.text(b.part)] = {
        {"times", b.times}, {"residual", q.text(b.residual)}, {"more", q.text(b.more)}};
  for (const auto& [part, times] : link.divides) json["divides"][q.text(part)] = q.text(times);
  for (const auto& [part, places] : link.zeros)
    for (const CertifiedZero::Place& p : places) {
      Json& place = json["zeros"][q.text(part)][p.name];
      place = {{"at", q.text(p.at)}};
      if (p.power > 0)
        place["power"] = p.power, place["share"] = q.text(p.share), place["more"] = q.text(p.more);
    }
  json["cofactor"] = polynomial_text(steps.out_cofactor(*c));
  return json;
}

void write_links(const CertifiedStatement& q, const std::vector<CertifiedLink>& links, Written& written) {
  std::vector<ex> expressions = expressions_in(q, written.trees);
  for (const CertifiedLink& link : links)
    for (const ex& e : {link.left.residual, link.right.residual, difference(link, q)})
      expressions.push_back(q.value(e));
  const Phases phases(expressions, q.symbols);
  Steps steps(q, phases);
  for (const Tree& tree : written.trees) steps.tree(tree);
  Json list = Json::array();
  for (const CertifiedLink& link : links) {
    try {
      list.push_back(link_json(link, q, phases, steps));
    } catch (const Undecidable&) {
      const auto sum = vanishing_sum(q.value(difference(link, q)), q.symbols);
      if (!sum) throw;
      return write_with_lemma(*sum, q, links, written);
    }
  }
  written.links = list, written.steps = steps.take();
}

/// One piece of the domain: all that is put down there.
Json piece_json(const CertifiedStatement& q, const std::vector<CertifiedLink>& links,
                const std::vector<Tree>& trees) {
  Written written{trees, {}, {}};
  write_links(q, links, written);
  return {{"steps", written.steps}, {"links", written.links}};
}

/// The whole domain in one piece, or cut where an absolute value turns.
void add_pieces(Json& json, const CertifiedStatement& q, const std::vector<CertifiedLink>& links,
                const std::vector<Tree>& trees) {
  json["cut"] = json["pieces"] = Json::array();
  try {
    json["pieces"].push_back(piece_json(q, links, trees));
  } catch (const Undecidable&) {
    const auto pieces = analytic_pieces(difference(links[0], q), q.symbols);
    if (pieces.empty()) throw;
    for (const auto& [name, range] : json["ranges"].items())
      if (pieces.front().find(name)->range != pieces.back().find(name)->range) json["cut"].push_back(name);
    for (const Symbols& piece : pieces)
      json["pieces"].push_back(piece_json({q.left, q.right, piece, q.given, {}, q.ranges}, links, trees));
  }
}

void add_trees(const CertifiedFactor& factor, std::vector<Tree>& trees) {
  for (const CertifiedPart& p : factor) {
    trees.push_back(p.part);
    if (p.times) trees.push_back(p.times);
  }
}

/// The functions around the sides of a relation are functions, too.
void add_trees(const CertifiedLayer& written, const CertifiedStatement& q, std::vector<Tree>& trees) {
  const auto& [layer, factor] = written;
  add_trees(factor, trees);
  if (layer.function == "even of")  // the same for x and -x
    for (const ex& side : {layer.left, layer.right})
      trees.push_back(to_tree(layer.of.subs(layer.in == -side, GiNaC::subs_options::no_pattern), q.symbols));
  if (layer.function.ends_with("of")) return trees.push_back(to_tree(layer.of, q.symbols));
  for (const ex& inner : {layer.left, layer.right}) {
    const std::string text = "(" + q.text(Forms(q).short_tree(inner)) + ")", f = layer.function;
    const std::string whole = f == "*"                ? text
                              : f[0] == '^'           ? text + "^(" + f.substr(1) + ")"
                              : f.ends_with("(atan)") ? "1/sqrt(1+" + text + "^2)"
                                                      : f + text;
    trees.push_back(parse(whole, q.symbols));
  }
}

/// As it is written, with what the names are where a part is 0.
Tree at_zero(const Tree& tree, const CertifiedZero& zero) {
  for (const auto& place : zero.places)
    if (tree->kind == Node::Kind::symbol && tree->text == place.name) return place.at;
  auto copy = std::make_shared<Node>(*tree);
  for (Tree& child : copy->children) child = at_zero(child, zero);
  return copy;
}

Json never_zero_json(const Symbols& symbols) {
  Json texts = Json::array();
  for (const ex& e : symbols.never_zero()) texts.push_back(print(e, Notation::plain, symbols));
  return texts;
}

Json write(const CertifiedStatement& q, const std::vector<CertifiedLink>& links) {
  std::vector<Tree> trees;
  for (const Given& g : q.given)
    for (const ex& e : {g.value, g.name}) trees.push_back(to_tree(e, q.symbols));
  for (const Relation* relation : {&q.left, &q.right})
    trees.insert(trees.end(), relation->sides.begin(), relation->sides.end());
  Json given = Json::object(), texts = Json::array();
  for (const Given& g : q.given)
    given[ex_to<GiNaC::symbol>(g.name).get_name()] = print(g.value, Notation::plain, q.symbols);
  for (const CertifiedDivisor& divisor : divisors_of(q)) {
    trees.push_back(divisor.tree);
    texts.push_back(q.text(divisor.tree));
  }
  for (const CertifiedLink& link : links) {
    add_trees(link.factor, trees);
    for (const auto* list : {&link.more, &link.divides})
      for (const auto& [part, other] : *list) trees.push_back(other);
    for (const CertifiedZero& zero : link.zeros) {
      trees.push_back(at_zero(zero.part, zero));
      for (const auto& place : zero.places) trees.push_back(place.power > 0 ? place.more : place.at);
      for (const Relation* relation : {&q.left, &q.right})
        for (const Tree& side : relation->sides) trees.push_back(at_zero(side, zero));
    }
    for (const CertifiedBound& b : link.bounds) trees.insert(trees.end(), {b.residual, b.more});
    for (const CertifiedSlope& s : link.slopes) {
      trees.insert(trees.end(), s.put_in.begin(), s.put_in.end());
      for (const Tree& tree : {s.slope, s.bend, s.at_low, s.at_high, s.by})
        if (tree) trees.push_back(tree);
    }
    if (link.follows) {
      trees.insert(trees.end(), {link.follows->more, link.follows->times});
      add_trees(link.follows->product, trees);
      for (const auto& [factor, links_of_term] : link.follows->terms) trees.push_back(factor);
    }
    for (const CertifiedSide& side : {link.left, link.right}) {
      for (const Tree& tree : {side.sum, side.form})
        if (tree) trees.push_back(tree);
      trees.insert(trees.end(), side.roots.begin(), side.roots.end());
      add_trees(side.parts, trees);
      for (const auto& layers : side.layers)
        for (const CertifiedLayer& layer : layers) add_trees(layer, q, trees);
    }
  }
  Json json{{"format", "rederive certificate 11"},
            {"left", statement_json(q.left, q)},
            {"right", statement_json(q.right, q)},
            {"given", given},
            {"divisors", texts},
            {"never zero", never_zero_json(q.symbols)},
            {"ranges", ranges_json(trees, q)}};
  json["parts of divisors"] = parts_of_divisors(links, q);
  json["slopes"] = slopes_json(links, q);
  add_pieces(json, q, links, trees);
  return json;
}

/// Over some of the declared ranges, which are said where they are wider.
Json certificate_over(const Symbols& ranges, const Relation& left, const Relation& right,
                      const std::vector<Given>& given, const Symbols& declared) {
  const Symbols with_ranges = with_ranges_of(given, ranges);
  Symbols narrowed = ranges;
  for (const std::string& name : ranges.names()) narrowed.narrow(name, with_ranges.find(name)->range);
  const CertifiedStatement question{left, right, with_ranges, given, {}, narrowed};
  Json json = write(question, links_of(question));
  json["declared"] = Json::object();
  for (const auto& [name, range] : json["ranges"].items())
    if (const std::string whole = declared.find(name)->range; whole != range) json["declared"][name] = whole;
  return json;
}

/// As sqrt(x-1) = sqrt(1-x) at 1.
bool has_values_at_points_only(const std::optional<Cells>& cells, const Question& question) {
  return cells && std::all_of(cells->pieces.begin(), cells->pieces.end(),
                              [&](const Symbols& piece) { return look_at(question, piece) == Cell::empty; });
}

/// Piece by piece of the range of one symbol. Throws Undecidable.
Json certificate_in(const Cells& cells, const Question& question) {
  const auto& [left, right, symbols, given] = question;
  const CertifiedStatement statement{left, right, symbols, given, {}, symbols};
  Json json{{"format", "rederive certificate 11"},
            {"left", statement_json(left, statement)},
            {"right", statement_json(right, statement)},
            {"in", symbols.find(cells.symbol)->name},
            {"range", symbols.find(cells.symbol)->range},
            {"never zero", never_zero_json(symbols)},
            {"cells", Json::array()}};
  for (const Symbols& piece : cells.pieces) {
    json["cells"].push_back({{"range", piece.find(cells.symbol)->range}});
    const Cell seen = look_at(question, piece);
    if (seen == Cell::unknown) throw Undecidable("it is not known where the sides have values");
    if (seen == Cell::compared)
      json["cells"].back()["certificate"] = certificate_over(piece, left, right, given, piece);
  }
  return json;
}

}  // namespace

Json certificate(const Relation& left, const Relation& right, const Symbols& symbols,
                 const std::vector<Given>& given) {
  Relation exact_left = left, exact_right = right;
  for (Relation* relation : {&exact_left, &exact_right})
    for (Tree& side : relation->sides) side = exact(side, symbols);
  const std::vector<Given> in_it = needed(left, right, given, symbols);
  const Question question{exact_left, exact_right, symbols, in_it};
  const auto cells = cells_of(question);
  if (has_values_at_points_only(cells, question)) return certificate_in(*cells, question);
  std::string why;
  for (const std::optional<Symbols>& ranges :
       {where_both_have_values(question), std::optional(symbols), where_one_may_hold(question)})
    try {
      if (ranges) return certificate_over(*ranges, exact_left, exact_right, in_it, symbols);
    } catch (const Undecidable& error) {  // then over other ranges, or piece by piece
      why = error.what();
    }
  const auto beside_turns = cells_beside_turns(question);
  if (cells) try {
      return certificate_in(*cells, question);
    } catch (const Undecidable&) {
      if (!beside_turns) throw Undecidable(why);
    }
  if (!beside_turns) throw Undecidable(why);
  return certificate_in(*beside_turns, question);
}

Json certificate_of_cases(const std::vector<Json>& cases) {
  Json json{{"format", cases.at(0).at("format")}};
  for (const char* side : {"left", "right"}) json[side] = cases[0].at(side);
  json["cases"] = cases;
  return json;
}

}  // namespace rederive
