// What stands for what in a statement that a user types: names, ranges, givens.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/command_line.hpp>
#include <lessons/ledger/prove_command.hpp>
#include <regex>
#include <set>

namespace rederive {

namespace {

const std::string any = "(-inf, inf)";
const std::vector<std::string> greek{
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta",   "theta", "iota", "kappa", "lambda",
    "mu",    "nu",   "xi",    "rho",   "sigma",   "tau",  "phi",   "chi",   "psi",  "omega", "upsilon",
    "Gamma", "Xi",   "Delta", "Theta", "Lambda",  "Pi",   "Sigma", "Phi",   "Psi",  "Omega"};

void declare_free(Symbols& symbols, const std::string& name) {
  if (symbols.find(name) == nullptr) symbols.declare(name, name, name, "1", any, "a real number", "");
}

/// Letters stand for real numbers, alone or with an index or dots: x, x1, k_2, omega_0, betadot.
void declare_names_in(const std::string& text, Symbols& symbols) {
  static const std::regex tail("_?[A-Za-z0-9]{0,3}(_[A-Za-z0-9]{1,3})?|d?dot");
  if (text.size() > Limits{}.characters) return;  // the parser says so
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto belongs = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t start = 0, end; start < text.size(); start = end) {
    end = start;
    while (end < text.size() && belongs(text[end])) ++end;
    if (end == start || !is_letter(text[start])) {
      end = std::max(end, start + 1);
      continue;
    }
    const std::string name = text.substr(start, end - start);
    const auto after = text.find_first_not_of(' ', end);
    if (name.size() > 24 || name == "pi" || (after != std::string::npos && text[after] == '(')) continue;
    const bool indexed =
        name.size() > 1 && (name[1] == '_' || std::isdigit(static_cast<unsigned char>(name[1])) != 0);
    std::size_t stem = indexed || name.ends_with("dot") ? 1 : 0;
    for (const std::string& letter : greek)
      if (name.starts_with(letter)) stem = std::max(stem, letter.size());
    if (stem > 0 && std::regex_match(name.substr(stem), tail)) declare_free(symbols, name);
  }
}

/// Runs `read`; what it finds wrong with `text` becomes BadInput.
template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(explain(error, text));
  }
}

/// Narrows a range by one comparison of a symbol with a number.
void narrow(Symbols& symbols, const std::string& name, std::string op, const GiNaC::ex& value,
            bool symbol_on_left) {
  if (!symbol_on_left) op = std::string(op[0] == '<' ? ">" : "<") + op.substr(1);
  const Symbol old = *symbols.find(name);
  Range range = read_range(old.range);
  const Interval present = parse_range(old.range);
  const bool closed = op.size() == 2, lower_end = op[0] == '>';
  const End& end = lower_end ? present.low : present.high;
  const int order = end.infinite != 0 ? -1
                    : lower_end       ? compare(end.value, value)
                                      : compare(value, end.value);
  if (order > 0 || (order == 0 && !end.closed)) return;  // nothing new
  (lower_end ? range.lower : range.upper) = print(value, Notation::plain, symbols);
  (lower_end ? range.lower_closed : range.upper_closed) = closed;
  const std::string text = fmt::format("{}{}, {}{}", range.lower_closed ? '[' : '(', range.lower, range.upper,
                                       range.upper_closed ? ']' : ')');
  const Interval now = parse_range(text);
  if (text.front() == '[' && text.back() == ']' && compare(now.low.value, now.high.value) == 0)
    throw BadInput(
        fmt::format("the assumptions leave one value for {0}: say \"{0} = {1}\"", name, range.lower));
  if (now.low.infinite == 0 && now.high.infinite == 0 && compare(now.low.value, now.high.value) >= 0)
    throw BadInput("the assumptions and the declared range " + old.range + " leave no room for " + name);
  symbols.declare(name, old.latex, old.unicode, old.unit, text, old.meaning, old.introduced);
}

bool is_name(const Tree& tree) { return tree->kind == Node::Kind::symbol && tree->text != "pi"; }

/// The value of a constant bound; nothing if there are symbols in it.
std::optional<GiNaC::ex> number(const Tree& tree, const std::string& text, const Symbols& symbols) {
  const GiNaC::ex value = reading(text, [&] { return lower(tree, symbols); });
  return GiNaC::is_a<GiNaC::numeric>(value.evalf()) ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse(const std::string& text) {
  throw BadInput(
      "the assumption '" + text +
      "' neither compares one symbol with numbers or other symbols, nor says what one symbol is or can be "
      "solved for one; "
      "right is, for example, \"x > 0\", \"0 < x < pi/2\", \"b < h\", \"x != y\" or \"h = R*cos(alpha)\"");
}

/// Whether it compares one symbol with a number.
bool assume_range(const Tree& a, const std::string& op, const Tree& b, const std::string& text,
                  Symbols& symbols) {
  const bool on_left = is_name(a);
  if (!on_left && !is_name(b)) return false;
  const auto bound = number(on_left ? b : a, text, symbols);
  if (!bound) return false;
  try {
    narrow(symbols, (on_left ? a : b)->text, op, *bound, on_left);
  } catch (const std::logic_error&) {  // the range cannot hold such a bound
    const bool is_read =
        (*bound).info(GiNaC::info_flags::rational) || (*bound / GiNaC::Pi).info(GiNaC::info_flags::rational);
    throw BadInput("the assumption '" + text + "' has a bound that " +
                   (is_read ? "has too many digits" : "is no rational number or multiple of pi"));
  }
  return true;
}

/// "x != y": the right side is read where it stands, so that an error is shown there.
void assume_difference(const std::string& text, std::size_t at, Symbols& symbols) {
  const auto value = [&](const std::string& side) {
    return reading(text, [&] { return lower(parse(side, symbols), symbols); });
  };
  const GiNaC::ex left = value(text.substr(0, at)),
                  right = value(std::string(at + 2, ' ') + text.substr(at + 2)),
                  difference = (left - right).expand();
  if (GiNaC::is_a<GiNaC::numeric>(difference.evalf()))
    throw BadInput("the assumption '" + text + "' says nothing of a symbol");
  symbols.exclude_zero(difference);
}

/// The symbol that an equation says the value of, if any: alone on a side and not on the other. Of two
/// symbols the one that is not small, or that may be anything, so that the range of the other one stays.
std::optional<Given> read_given(const Tree& a, const Tree& b, const std::string& text, const Symbols& symbols,
                                const std::vector<std::string>& small) {
  const auto is_small = [&](const Tree& tree) {
    return std::count(small.begin(), small.end(), tree->text) > 0;
  };
  const bool turn =
      is_name(a) && is_name(b) && (is_small(a) || (symbols.find(b->text)->range == any && !is_small(b)));
  for (const auto& [name, value] : {turn ? std::pair{b, a} : std::pair{a, b}, std::pair{b, a}}) {
    if (!is_name(name)) continue;
    const Given given = reading(text, [&] { return Given{lower(name, symbols), lower(value, symbols)}; });
    if (given.value.has(given.name))
      throw BadInput("the assumption '" + text + "' has its symbol on both sides");
    return given;
  }
  return {};
}

/// An equation that has no symbol alone: solved for one that is not small, in which it is linear, or the
/// power of a positive one; better for one that may be anything.
std::optional<Given> solved_for_one(const GiNaC::ex& residual, const Symbols& symbols,
                                    const std::vector<std::string>& small) {
  const GiNaC::ex polynomial = residual.normal().numer().expand();
  for (const bool is_free : {true, false})
    for (const std::string& name : names_in(polynomial)) {
      const GiNaC::ex& symbol = symbols[name];
      const std::string& range = symbols.find(name)->range;
      const bool is_wanted = (range == any) == is_free && !name.starts_with("excess_") &&
                             std::count(small.begin(), small.end(), name) == 0;
      if (!is_wanted || !polynomial.is_polynomial(symbol)) continue;
      const int n = polynomial.degree(symbol);
      const GiNaC::ex slope = polynomial.coeff(symbol, n), rest = polynomial.coeff(symbol, 0);
      const bool is_power = (polynomial - slope * GiNaC::pow(symbol, n) - rest).expand().is_zero();
      if (!is_power || sign_of(slope, symbols) == 0 || (n > 1 && sign_of(symbol, symbols) <= 0)) continue;
      const GiNaC::ex power = -rest / slope;
      if (n > 1 && is_nonnegative(-power, symbols))
        throw BadInput("the assumptions leave no room for " + name + ": its power " + std::to_string(n) +
                       " would not be positive");
      return Given{symbol, GiNaC::pow(power, GiNaC::numeric(1) / n)};
    }
  return std::nullopt;
}

/// What an equation divides by is not 0, though the computer algebra may have cancelled it.
void avoid_divisors(const Tree& side, Symbols& symbols) {
  for (const GiNaC::ex& divisor : divisors(side, symbols))
    if (sign_of(divisor, symbols) == 0) symbols.exclude_witnesses(divisor);
}

/// Whether nothing says yet what the symbol is, and its value does not come back to it by way of the others.
bool is_new(const Given& given, const Context& context) {
  const std::vector<Given> all = context.put_in_at_once(true);
  return std::none_of(all.begin(), all.end(), [&](const Given& g) { return g.name.is_equal(given.name); }) &&
         !put_in(given.value, all).has(given.name);
}

/// Those that say what a symbol is come first; what the others leave is solved.
void read_equations(const std::vector<std::pair<Relation, std::string>>& equations, Context& context,
                    const std::vector<std::string>& small) {
  Symbols& symbols = context.symbols;
  for (const auto& [equation, text] : equations)
    for (const Tree& side : equation.sides) reading(text, [&] { avoid_divisors(side, symbols); });
  std::vector<std::pair<GiNaC::ex, std::string>> others;
  for (const auto& [equation, text] : equations)
    if (const auto given = read_given(equation.sides[0], equation.sides[1], text, symbols, small);
        given && is_new(*given, context)) {
      context.given.push_back(*given);
    } else {
      const auto value = [&](const Tree& side) {
        return reading(text, [&] { return lower(side, symbols); });
      };
      others.emplace_back(value(equation.sides[0]) - value(equation.sides[1]), text);
    }
  for (const auto& [residual, text] : others) {
    const GiNaC::ex left = put_in(residual, context.put_in_at_once(true));
    if (left.normal().is_zero()) continue;  // it says nothing new
    if (names_in(left.normal()).empty()) {
      if (vanishes(left, symbols)) continue;
      throw BadInput("the assumption '" + text + "' contradicts the other equations that are assumed");
    }
    const auto given = solved_for_one(left, symbols, small);
    const auto names_a_side = [&](const auto& e) {
      return e.second == text && (is_name(e.first.sides[0]) || is_name(e.first.sides[1]));
    };
    if (!given && std::any_of(equations.begin(), equations.end(), names_a_side))
      throw BadInput("the assumption '" + text +
                     "' goes round in a circle with the equations before it, or gives "
                     "a second value to a symbol");
    if (!given) refuse(text);
    context.given.push_back(*given);
  }
}

void check_givens(const std::vector<Given>& given, const Symbols& symbols) {
  for (std::size_t k = 0; k < given.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j)
      if (given[j].name.is_equal(given[k].name))
        throw BadInput("two assumptions say what " + print(given[k].name, Notation::plain, symbols) + " is");
    // provably outside of its own range?
    const Interval range = parse_range(symbols.find(given[k].name)->range);
    const bool below = range.low.infinite == 0 && sign_of(range.low.value - given[k].value, symbols) > 0;
    const bool above = range.high.infinite == 0 && sign_of(given[k].value - range.high.value, symbols) > 0;
    const bool on_open_end =
        (range.low.infinite == 0 && !range.low.closed && given[k].value.is_equal(range.low.value)) ||
        (range.high.infinite == 0 && !range.high.closed && given[k].value.is_equal(range.high.value));
    if (below || above || on_open_end)
      throw BadInput("the assumption on " + print(given[k].name, Notation::plain, symbols) +
                     " contradicts its range " + symbols.find(given[k].name)->range);
  }
}

}  // namespace

Context make_context(const ProveRequest& request, const std::vector<std::string>& freed) {
  Context context{paper_symbols(), {}, {}};
  Symbols& symbols = context.symbols;
  for (const std::string& name : freed) {
    const Symbol old = *symbols.find(name);
    symbols.declare(name, old.latex, old.unicode, old.unit, any, old.meaning, old.introduced);
  }
  for (const char* name : {"t", "r", "d"})
    symbols.declare(name, name, name, symbols.find(name)->unit, any, "a real number", "");
  for (char c = 'a'; c <= 'z'; ++c) declare_free(symbols, std::string(1, c));
  for (char c = 'A'; c <= 'Z'; ++c) declare_free(symbols, std::string(1, c));
  for (const std::string& letter : greek) declare_free(symbols, letter);
  declare_names_in(request.left, symbols);
  declare_names_in(request.right, symbols);
  for (const std::string& text : request.assumptions) declare_names_in(text, symbols);

  std::vector<std::pair<Relation, std::string>> equations, comparisons;
  for (const std::string& text : request.assumptions) {
    if (const auto at = text.find("!="); at != std::string::npos) {
      assume_difference(text, at, symbols);
      continue;
    }
    const Relation relation = reading(text, [&] { return parse_relation(text, symbols); });
    for (std::size_t k = 0; k < relation.operators.size(); ++k) {
      const Relation link{{relation.sides[k], relation.sides[k + 1]}, {relation.operators[k]}};
      if (link.operators[0] == "=")
        equations.push_back({link, text});
      else if (!assume_range(link.sides[0], link.operators[0], link.sides[1], text, symbols))
        comparisons.push_back({link, text});
    }
  }
  for (const auto& [link, text] : comparisons) {
    const int settled = reading(text, [&] { return settled_by(context.comparisons, link, symbols); });
    if (settled < 0) throw BadInput("the assumption '" + text + "' contradicts what is known without it");
    if (settled > 0) continue;
    const auto found = reading(text, [&] { return compared(link, context.comparisons, symbols); });
    if (!found && !context.comparisons.empty())
      throw BadInput("the assumption '" + text + "' goes round in a circle with the comparisons before it");
    if (!found) refuse(text);
    context.comparisons.push_back(*found);
  }
  try {
    read_equations(equations, context, request.small);
    for (const Given& given : context.given) (void)put_in(given.value, context.put_in_at_once(true));
  } catch (const Undecidable& error) {
    throw BadInput(error.what());
  } catch (const std::domain_error&) {  // GiNaC's pole_error among them
    throw BadInput(
        "the equations that are assumed divide by zero, or meet a pole, once each is put into the others");
  }
  check_givens(context.put_in_at_once(true), symbols);
  return context;
}

std::vector<Given> Context::put_in_at_once(bool equations_too) const {
  std::vector<Given> result;
  for (const Comparison& comparison : comparisons) result.push_back(comparison.given);
  if (equations_too) result.insert(result.end(), given.begin(), given.end());
  return result;
}

}  // namespace rederive
