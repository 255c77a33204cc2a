#include <fmt/format.h>

#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/assumed.hpp>

namespace rederive {

namespace {

/// A range that is narrower by one bound, a number; nothing where that says nothing new.
std::optional<std::string> with_end(const Symbols& symbols, const std::string& name, const Bound& bound,
                                    bool closed) {
  const GiNaC::ex& value = bound.value;
  const bool lower_end = bound.is_lower;
  const std::string& old = symbols.find(name)->range;
  Range range = read_range(old);
  const Interval present = parse_range(old);
  const End& end = lower_end ? present.low : present.high;
  const int order = end.infinite != 0 ? -1
                    : lower_end       ? compare(end.value, value)
                                      : compare(value, end.value);
  if (order > 0 || (order == 0 && !end.closed)) return std::nullopt;
  (lower_end ? range.lower : range.upper) = print(value, Notation::plain, symbols);
  (lower_end ? range.lower_closed : range.upper_closed) = closed;
  const std::string text = fmt::format("{}{}, {}{}", range.lower_closed ? '[' : '(', range.lower, range.upper,
                                       range.upper_closed ? ']' : ')');
  const Interval now = parse_range(text);
  if (text.front() == '[' && text.back() == ']' && compare(now.low.value, now.high.value) == 0)
    throw BadInput(
        fmt::format("the assumptions leave one value for {0}: say \"{0} = {1}\"", name, range.lower));
  if (now.low.infinite == 0 && now.high.infinite == 0 && compare(now.low.value, now.high.value) >= 0)
    throw BadInput(fmt::format("the assumptions leave no room for {0}: it is in {1}, and '{0} {2} {3}'", name,
                               old, std::string(lower_end ? ">" : "<") + (closed ? "=" : ""),
                               print(value, Notation::plain, symbols)));
  return text;
}

/// Of one symbol on one side and a number on the other, or of what is solved for one.
std::optional<Bound> bound_of_one(const Inequality& i, const Symbols& symbols) {
  const auto names = names_in(i.difference());
  if (names.size() != 1 || symbols.find(*names.begin()) == nullptr) return std::nullopt;
  return solved_for(symbols[*names.begin()], i.difference(), symbols);
}

/// Rational, or a rational multiple of π.
bool has_digits_only(const GiNaC::ex& bound) {
  return bound.info(GiNaC::info_flags::rational) || (bound / GiNaC::Pi).info(GiNaC::info_flags::rational);
}

/// A number that may stand at the end of a range: rational, or with π.
bool fits_a_range(const GiNaC::ex& bound, const Symbols& symbols) {
  try {
    (void)parse_range("(" + print(bound, Notation::plain, symbols) + ", inf)");
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

std::vector<Inequality> parts_of(const Assumed& link, const Symbols& symbols) {
  return without_bars(reading(link.text, [&] { return inequality(link.relation, symbols); }), symbols);
}

std::string refusal(const std::string& text, const std::string& why) {
  return "the assumption '" + text +
         "' neither compares one symbol with numbers or other symbols, nor says what one symbol is or can be "
         "solved for one" +
         (why.empty() ? "" : " (" + why + ")") +
         "; right is, for example, \"x > 0\", \"0 < x < pi/2\", \"b < h\", \"x != y\" or \"h = "
         "R*cos(alpha)\"";
}

}  // namespace

bool has_symbol_in_exponent(const Tree& tree, const Symbols& symbols) {
  if (tree->kind == Node::Kind::power && !names_in(lower(tree->children[1], symbols)).empty()) return true;
  return std::any_of(tree->children.begin(), tree->children.end(),
                     [&](const Tree& child) { return has_symbol_in_exponent(child, symbols); });
}

void refuse(const std::string& text, const std::string& why) { throw BadInput(refusal(text, why)); }

void needs_values(const Assumed& link, const Symbols& symbols, const std::vector<Comparison>& comparisons) {
  for (const Tree& side : link.relation.sides)
    for (const Condition& condition : conditions_of(side, symbols)) {
      if (condition.relation == "!=") continue;
      const std::string text = in_words(condition, symbols);
      const Inequality needed = inequality(parse_relation(text, symbols), symbols);
      if (settled_by(comparisons, needed, symbols) > 0) continue;
      if (has_symbol_in_exponent(side, symbols))  // x^n has values for negative x, too, where n is whole
        refuse(link.text, "it has a value for " + text + ", and maybe elsewhere: assume that as well");
      throw SeveralSolutions(refusal(link.text, "it has a value for " + text + " only: assume that as well"),
                             {text}, in_words(link, symbols));
    }
}

void contradicts(const std::string& text) {
  throw Contradiction("the assumptions contradict each other: '" + text +
                      "' never holds with the declared ranges and what else is assumed");
}

bool narrow(const Assumed& link, Symbols& symbols) {
  const std::vector<Inequality> parts = parts_of(link, symbols);
  std::vector<std::pair<Bound, bool>> bounds;
  for (const Inequality& part : parts) {
    const auto bound = bound_of_one(part, symbols);
    if (!bound) return false;
    if (!fits_a_range(bound->value, symbols)) {
      if (has_digits_only(bound->value))
        throw BadInput("the assumption '" + link.text + "' has a bound that has too many digits");
      return false;
    }
    bounds.push_back({*bound, part.weak});
  }
  needs_values(link, symbols, {});
  for (const auto& [bound, weak] : bounds) {  // each time the symbol itself is declared anew
    const Symbol old = *symbols.find(*names_in(bound.symbol).begin());
    if (const auto range = with_end(symbols, old.name, bound, weak))
      symbols.declare(old.name, old.latex, old.unicode, old.unit, *range, old.meaning, old.introduced);
  }
  return true;
}

namespace {

/// Narrows the range of an excess, where that is all that is left of an inequality: of x < y < x + 1 the
/// second one bounds y - x.
bool narrow_excess(const Inequality& part, const std::string& text, Context& context) {
  Symbols& symbols = context.symbols;
  const GiNaC::ex difference = put_in(part.difference(), context.put_in_at_once(false));
  for (const Comparison& c : context.comparisons) {
    const auto bound = solved_for(symbols[c.excess], difference, symbols);
    if (!bound || !fits_a_range(bound->value, symbols)) continue;
    try {
      if (const auto range = with_end(symbols, c.excess, *bound, part.weak)) symbols.narrow(c.excess, *range);
    } catch (const BadInput&) {
      refuse(text, fmt::format("it leaves one value for {0}: say \"{0} = {1}\"", c.meaning,
                               print(bound->value, Notation::plain, symbols)));
    }
    return true;
  }
  return false;
}

}  // namespace

void compare_symbols(const Assumed& link, Context& context) {
  Symbols& symbols = context.symbols;
  needs_values(link, symbols, context.comparisons);
  avoid_divisors(link.relation, symbols);
  for (const Inequality& part : parts_of(link, symbols)) {
    const int settled = settled_by(context.comparisons, part, symbols);
    if (settled < 0) contradicts(link.text);
    if (settled > 0 || narrow_excess(part, link.text, context)) continue;
    const auto found = compared(part, context.comparisons, symbols);
    const auto each = found || parts_of(link, symbols).size() > 1 ? std::nullopt : pieces(part, symbols);
    if (each && each->empty()) contradicts(link.text);
    if (each && each->front().empty()) continue;
    if (each)
      throw SeveralSolutions(fmt::format("the assumption '{}' holds on several pieces: assume \"{}\" as well",
                                         link.text, fmt::join(*each, "\" or \"")),
                             *each, in_words(link, symbols));
    if (!found && !context.comparisons.empty())
      refuse(link.text,
             "after the comparisons before it, no symbol stands in it linearly, with a factor of known sign; "
             "if both sides are the same, say so by \"=\"");
    if (!found) refuse(link.text, "no symbol stands in it linearly, with a factor of known sign");
    context.comparisons.push_back(*found);
  }
}

}  // namespace rederive
