#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/turns.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/language/real.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// Where the slope of an expression changes its sign, between -12 and 12, to a hundred thousandth.
std::vector<cln::cl_RA> turns_of(const ex& e, const Symbol& symbol, const Symbols& symbols) {
  const Tree slope = to_tree(derivative(e, symbol.ginac), symbols);
  const auto sign_at = [&](const cln::cl_RA& x) {
    const auto value =
        is_strictly_inside(symbol.range, x) ? evaluate(slope, {{symbol.name, x}}, 20) : std::nullopt;
    return !value || cln::zerop(*value) ? 0 : cln::plusp(*value) ? 1 : -1;
  };
  std::vector<cln::cl_RA> result;
  cln::cl_RA low = cln::cl_RA(-1201) / 100;  // so that no turn at a short number is met exactly
  for (int sign = sign_at(low); low < 12;) {
    cln::cl_RA high = low + cln::cl_RA(1) / 4;
    const cln::cl_RA next = high;
    const int after = sign_at(next);
    if (sign * after < 0) {
      while (high - low > cln::cl_RA(1) / 100'000) {
        const cln::cl_RA middle = (low + high) / 2;
        (sign_at(middle) == after ? high : low) = middle;
      }
      result.push_back(low);
    }
    low = next, sign = after;
  }
  return result;
}

/// Two points about a turn, the farthest between which the range of the expression shows its sign.
std::vector<ex> points_about(const cln::cl_RA& turn, const ex& e, const Symbol& symbol,
                             const Symbols& symbols) {
  for (const int parts : {16, 128, 1024, 8192}) {
    const cln::cl_I middle = cln::round1(turn * parts);
    const cln::cl_RA low = (middle - 1) / cln::cl_RA(parts), high = (middle + 1) / cln::cl_RA(parts);
    if (!is_strictly_inside(symbol.range, low) || !is_strictly_inside(symbol.range, high)) continue;
    const ex from = numeric(low), to = numeric(high);
    const auto text = [&](const ex& point) { return print(point, Notation::plain, symbols); };
    Symbols between = symbols;
    between.narrow(symbol.name, "(" + text(from) + ", " + text(to) + ")");
    if (sign_of(e, between) != 0) return {from, to};
  }
  return {};
}

}  // namespace

std::vector<ex> points_beside_turns(const Question& question, const Symbol& symbol) {
  std::vector<ex> result;
  for (const Relation* relation : {&question.left, &question.right})
    for (const Link& link : links_of(*relation)) {
      const ex residual = prepare(residual_of(sides_of(link, question)), question.symbols);
      for (const ex& e : {residual, derivative(residual, symbol.ginac)}) {
        const auto turns = turns_of(e, symbol, question.symbols);
        if (turns.size() > 3) continue;
        for (const cln::cl_RA& turn : turns)
          for (const ex& point : points_about(turn, e, symbol, question.symbols)) result.push_back(point);
      }
    }
  return result;
}

}  // namespace rederive
