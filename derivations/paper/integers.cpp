#include <algorithm>
#include <derivations/language/lower.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/integers.hpp>
#include <map>
#include <numeric>
#include <set>

namespace rederive::paper {
using namespace language;
using namespace numbers;
using namespace decide;

using GiNaC::ex;
using GiNaC::numeric;

namespace {

/// Symbols with their remainders for the modulus.
struct Remainders {
  std::map<std::string, int> of;
  int modulus = 1;
};

/// Puts remainders in where only they matter, or finds the modulus that this needs.
class Periodic : public GiNaC::map_function {
 public:
  Periodic(const std::vector<std::string>& names, const Symbols& symbols, const Remainders* remainders)
      : symbols_(symbols), remainders_(remainders) {
    for (const std::string& name : names) whole_.append(symbols[name]);
  }

  ex operator()(const ex& e) override {
    const ex inside = e.map(*this);
    if (GiNaC::is_a<GiNaC::power>(inside) && inside.op(0).info(GiNaC::info_flags::negative) &&
        is_whole(inside.op(1)) && GiNaC::is_a<numeric>(inside.op(0)))
      return pow(-1, reduced(inside.op(1))) * pow(-inside.op(0), inside.op(1));
    if (!GiNaC::is_a<GiNaC::function>(inside)) return inside;
    const std::string name = GiNaC::ex_to<GiNaC::function>(inside).get_name();
    if (name != "sin" && name != "cos" && name != "tan") return inside;
    const ex argument = inside.op(0).expand(), turns = argument.coeff(GiNaC::Pi, 1).expand();
    ex whole = 0;
    const auto take = [&](const ex& term) { whole += is_whole(term) ? term : ex(0); };
    if (GiNaC::is_a<GiNaC::add>(turns))
      std::ranges::for_each(turns, take);
    else
      take(turns);
    return inside.subs(inside.op(0) == argument - GiNaC::Pi * whole + GiNaC::Pi * reduced(whole),
                       GiNaC::subs_options::no_pattern);
  }

  int modulus = 1;

 private:
  /// Whether an expression is a polynomial in whole numbers alone, with rational coefficients.
  bool is_whole(const ex& e) const {
    ex rest = e;
    bool has_any = false;
    for (const ex& symbol : whole_) has_any = has_any || e.has(symbol);
    for (const ex& symbol : whole_) rest = rest.subs(symbol == 1);
    return has_any && e.is_polynomial(whole_) && GiNaC::is_a<numeric>(rest) &&
           rest.info(GiNaC::info_flags::rational);
  }

  /// The polynomial at the remainders, which differs from it by an even number.
  ex reduced(const ex& e) {
    if (remainders_ != nullptr) {
      ex result = e;
      for (const auto& [name, remainder] : remainders_->of) result = result.subs(symbols_[name] == remainder);
      return result;
    }
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
      if (GiNaC::is_a<numeric>(*part))
        modulus = std::lcm(modulus, 2 * GiNaC::ex_to<numeric>(*part).denom().to_int());
    modulus = std::lcm(modulus, 2);
    return e;
  }

  GiNaC::lst whole_;
  const Symbols& symbols_;
  const Remainders* remainders_;
};

/// Changes all expressions by a map; those that then have no value stay as they are.
Compared changed(Compared both, const Symbols& symbols, GiNaC::map_function& map) {
  for (Relation* relation : {&both.printed, &both.derived})
    for (Tree& side : relation->sides) try {
        const ex before = lower(side, symbols), after = map(before);
        if (!after.is_equal(before)) side = to_tree(after, symbols);
      } catch (const std::exception&) {
      }
  for (Given& given : both.given) given.value = map(given.value);
  return both;
}

/// Whole numbers in the range of a symbol, with the remainder, small ones first.
std::vector<int> candidates(const std::string& name, const Symbols& symbols, const Remainders& remainders) {
  constexpr int largest = 30;
  constexpr std::size_t most = 4;
  const Interval range = parse_range(symbols.find(name)->range);
  std::vector<int> found;
  for (int k = 0; k <= 2 * largest && found.size() < most; ++k) {
    const int n = k % 2 == 0 ? -k / 2 : (k + 1) / 2;
    const int distance = n - (remainders.of.contains(name) ? remainders.of.at(name) : n);
    if (distance % remainders.modulus == 0 && range.contains({cln::cl_RA(n)})) found.push_back(n);
  }
  return found;
}

/// A refutation at whole numbers, which are put in one after the other.
std::optional<Proof> refuted(const Compared& both, std::vector<std::string> names, const Symbols& symbols,
                             const Remainders& remainders,
                             const std::function<Proof(const Compared&)>& compare) {
  if (names.empty()) {
    Proof proof = compare(both);
    return proof.verdict == Verdict::refuted ? std::optional(std::move(proof)) : std::nullopt;
  }
  const std::string name = names.back();
  names.pop_back();
  for (const int n : candidates(name, symbols, remainders)) {
    Compared at = both;
    const Tree digits = make_tree(Node::Kind::number, std::to_string(std::abs(n))),
               value = n < 0 ? make_tree(Node::Kind::negative, "", {digits}) : digits;
    at.printed = put_in(at.printed, name, value), at.derived = put_in(at.derived, name, value);
    for (Relation& condition : at.conditions) condition = put_in(condition, name, value);
    for (Given& given : at.given) given.value = given.value.subs(symbols[name] == n);
    if (auto found = refuted(at, names, symbols, remainders, compare)) {
      found->witness->at[name] = std::to_string(n);
      return found;
    }
  }
  return std::nullopt;
}

bool is_whole(const Witness& witness, const std::vector<std::string>& names, const Remainders& remainders) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    const auto at = witness.at.find(name);
    if (at == witness.at.end()) return true;
    if (at->second.find_first_not_of("-0123456789") != std::string::npos || at->second.size() > 8 ||
        witness.between.contains(name) || witness.exactly.contains(name))
      return false;
    return !remainders.of.contains(name) ||
           (std::stoi(at->second) - remainders.of.at(name)) % remainders.modulus == 0;
  });
}

}  // namespace

Proof compare_whole(const Compared& both, const std::vector<std::string>& integers, const Symbols& symbols,
                    const std::function<Proof(const Compared&)>& compare) {
  constexpr int most_cases = 64;
  std::set<std::string> all = names_of(both.printed);
  all.merge(names_of(both.derived));
  for (const Given& given : both.given) all.merge(names_of(to_tree(given.value, symbols)));
  std::vector<std::string> names;
  std::ranges::copy_if(integers, std::back_inserter(names), [&](auto& name) { return all.contains(name); });
  if (names.empty()) return compare(both);
  Periodic finding(names, symbols, nullptr);
  (void)changed(both, symbols, finding);
  const int modulus = finding.modulus;
  int cases = 1;
  for (std::size_t k = 0; k < names.size() && cases <= most_cases; ++k) cases *= modulus;
  if (cases > most_cases) return {.reason = "too many whole numbers decide this"};
  std::optional<Proof> result;
  for (int index = 0; index < cases; ++index) {
    Remainders remainders{{}, modulus};
    for (int rest = index; const std::string& name : names) {
      remainders.of[name] = rest % modulus;
      rest /= modulus;
    }
    Periodic reducing(names, symbols, &remainders);
    Proof proof = compare(modulus == 1 ? both : changed(both, symbols, reducing));
    const bool is_refuted = proof.verdict == Verdict::refuted;
    if (is_refuted && is_whole(*proof.witness, names, remainders)) return proof;
    if (is_refuted || proof.verdict == Verdict::undecided) {
      if (auto at_whole = refuted(both, names, symbols, remainders, compare)) return *at_whole;
      if (is_refuted) proof = {.reason = "they differ, but no whole numbers were found at which they do"};
    }
    if (!result || proof.verdict == Verdict::undecided ||
        (proof.verdict > result->verdict && result->verdict != Verdict::undecided))
      result = proof;
  }
  return *result;
}

}  // namespace rederive::paper
