#include <fmt/format.h>

#include <array>
#include <derivations/decide/problem.hpp>
#include <derivations/kernel/coq_text.hpp>
#include <derivations/kernel/row_text.hpp>
#include <derivations/paper/ledger.hpp>
#include <optional>
#include <regex>

namespace rederive::kernel {
using namespace language;
using namespace numbers;
using namespace identity;
using namespace decide;
using namespace paper;

namespace {

/// Returns a symbol or its square, as in omega_p^2/p^2.
Tree power_of(const Tree& symbol, int exponent) {
  if (exponent == 1) return symbol;
  return make_tree(Node::Kind::power, "", {symbol, make_tree(Node::Kind::number, std::to_string(exponent))});
}

/// Returns the product with `name` in place of above/below, name^2 in place of above^2/below^2, and 1/name in
/// place of below/above.
Tree with_quotient(const Tree& product, const Tree& above, const Tree& below, const Tree& name) {
  std::vector<Tree> factors = product->children;
  std::vector<bool> inverse = product->inverse;
  const auto find = [&](const Tree& factor, bool is_inverse) -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < factors.size(); ++k)
      if (is_same(factors[k], factor) && inverse[k] == is_inverse) return k;
    return std::nullopt;
  };
  for (const int exponent : {1, 2})
    for (const bool is_inverse : {false, true}) {
      const auto first = find(power_of(above, exponent), is_inverse);
      const auto second = find(power_of(below, exponent), !is_inverse);
      if (!first || !second) continue;
      factors[*first] = power_of(name, exponent);
      factors[*second] = make_tree(Node::Kind::number, "1"), inverse[*second] = false;
      if (*second != 0 || !inverse[1]) {  // a 1 stays before a divisor
        factors.erase(factors.begin() + static_cast<std::ptrdiff_t>(*second));
        inverse.erase(inverse.begin() + static_cast<std::ptrdiff_t>(*second));
      }
    }
  if (factors.size() == 1 && !inverse[0]) return factors[0];
  return make_tree(Node::Kind::product, "", factors, inverse);
}

/// Returns the tree with the name in all its products.
Tree with_quotient_everywhere(const Tree& tree, const Tree& quotient, const Tree& name) {
  std::vector<Tree> children;
  for (const Tree& child : tree->children)
    children.push_back(with_quotient_everywhere(child, quotient, name));
  const Tree result =
      children.empty() ? tree : make_tree(tree->kind, tree->text, std::move(children), tree->inverse);
  if (result->kind != Node::Kind::product) return result;
  return with_quotient(result, quotient->children[0], quotient->children[1], name);
}

/// Returns the text as the theorems are written: sin(psi)/(p*t) as sin psi / (p * t).
std::string spaced(const std::string& text) {
  static const std::regex call_of_name("(\\w)\\(([\\w']+)\\)"), call("(\\w)\\("), operation("[*/^]");
  const std::string plain = std::regex_replace(text, call_of_name, "$1 $2");
  return std::regex_replace(std::regex_replace(plain, call, "$1 ("), operation, " $& ");
}

/// Returns the relation with a term of Coq in place of a symbol or of a quotient of two symbols.
Relation with_name(Relation relation, const Tree& part, const std::string& term) {
  const Tree name = make_tree(Node::Kind::symbol, term.find(' ') == term.npos ? term : "(" + term + ")");
  for (Tree& side : relation.sides)
    side = part->kind == Node::Kind::product ? with_quotient_everywhere(side, part, name)
                                             : put_in(side, part, name);
  return relation;
}

/// Returns the relation that a placeholder names; `inside` is the text between its braces.
Relation named_relation(const Symbols& symbols, const RelationOf& relation_of,
                        const std::vector<std::string>& functions, const std::string& inside) {
  static const std::regex form("(\\w+)(?: at (\\w+))?((?:, [^,]+ := [^,]+)*)"), name(", ([^,]+) := ([^,]+)");
  std::smatch parts;
  if (!std::regex_match(inside, parts, form))
    throw std::runtime_error(
        "the form is 'ID at TIME, SYMBOL := TERM', without 'at TIME' or names if there are none");
  Relation relation = relation_of(parts[1]);
  const std::string names = parts[3];
  for (std::sregex_iterator one(names.begin(), names.end(), name), end; one != end; ++one) {
    const Tree part = parse((*one)[1].str(), symbols);
    const std::string before = print(relation);
    relation = with_name(relation, part, (*one)[2]);
    if (print(relation) == before) throw std::runtime_error(print(part) + " does not occur in the row");
  }
  for (const std::string& function : functions)
    if (parts[2].matched)
      relation = with_name(relation, parse(function, symbols), function + " " + parts[2].str());
  return relation;
}

std::string whole_text(const Relation& relation) {
  std::string text = coq_text(relation.sides[0]);
  for (std::size_t k = 0; k < relation.operators.size(); ++k)
    text += " " + relation.operators[k] + " " + coq_text(relation.sides[k + 1]);
  return text;
}
std::string left_text(const Relation& relation) { return coq_text(relation.sides.front()); }
std::string right_text(const Relation& relation) { return coq_text(relation.sides.back()); }

/// The beginnings of placeholders, and what each writes.
constexpr std::array<std::pair<const char*, std::string (*)(const Relation&)>, 3> placeholders{
    {{"row{", whole_text}, {"left{", left_text}, {"right{", right_text}}};

/// Returns the text with a relation in place of each placeholder of one kind.
std::string with_placeholders(const Symbols& symbols, const RelationOf& relation_of,
                              const std::vector<std::string>& functions, const std::string& text,
                              const std::string& opening, std::string (*write)(const Relation&)) {
  std::string result;
  std::size_t done = 0;
  for (std::size_t at; (at = text.find(opening, done)) != std::string::npos;) {
    const std::size_t start = at + opening.size(), end = text.find('}', start);
    const std::string inside = text.substr(start, end - start);
    try {
      if (end == std::string::npos) throw std::runtime_error("the closing brace is missing");
      result += text.substr(done, at - done) +
                spaced(write(named_relation(symbols, relation_of, functions, inside)));
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}{}}}: {}", opening, inside, error.what()));
    }
    done = end + 1;
  }
  return result + text.substr(done);
}

}  // namespace

Relation right_form(const Paper& paper, const std::string& id) {
  const Row& row = row_of(paper, id);
  return parse_statement(row.expected == Verdict::refuted ? judged(paper, id).correction : row.claim(),
                         symbols_in(paper, row.domain));
}

std::string with_rows(const Symbols& symbols, const RelationOf& relation_of,
                      const std::vector<std::string>& functions, const std::string& text) {
  std::string result = text;
  for (const auto& [opening, write] : placeholders)
    result = with_placeholders(symbols, relation_of, functions, result, opening, write);
  return result;
}

}  // namespace rederive::kernel
