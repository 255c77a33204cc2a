#include <algorithm>
#include <derivations/algebra/links.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/parts_by_sign.hpp>
#include <set>

namespace rederive {

namespace {

bool has_inequality(const Relation& relation) {
  return std::any_of(relation.operators.begin(), relation.operators.end(),
                     [](const std::string& op) { return op != "="; });
}

using Signs = std::vector<std::string>;  ///< "x > 0"

Signs signs(const std::string& a, const std::string& b) {
  return {a + " > " + b, a + " < " + b, a + " = " + b};
}

bool has_value(const std::string& text, const Case& one) {
  ProveRequest alone = one.request;
  alone.left = alone.right = text;
  return has_values(one.context, alone);
}

bool never_holds(const std::string& text, const Case& one) {
  ProveRequest alone = one.request;
  alone.left = text, alone.right = "1 < 0";
  const Verdict verdict = decide_one(one.context, alone).verdict;
  return verdict == Verdict::proved || verdict == Verdict::proved_under;
}

/// Whether one statement has no value, and the other one has none either, names no symbols, or never holds.
bool is_lost(const Case& one) {
  const Symbols& symbols = one.context.symbols;
  const std::string &left = one.request.left, &right = one.request.right;
  const auto is_silent = [&](const std::string& text) {
    return !has_value(text, one) || is_of_numbers(read(text, symbols)) || never_holds(text, one);
  };
  return !has_values(one.context, one.request) && is_silent(left) && is_silent(right);
}

/// The cases with one more assumption of these each, and one of the others each. Those that contradict what
/// is assumed are no cases, nor are those where neither statement holds, as one of them has no value. Nothing
/// where one of them cannot be assumed, or one statement alone has no value.
std::vector<Case> cases_with(const Signs& each, const Signs& of_another, const ProveRequest& request) {
  std::vector<Case> result;
  for (const std::string& one : each)
    for (const std::string& other : of_another.empty() ? Signs{""} : of_another) try {
        ProveRequest with = request;
        with.assumptions.push_back(one);
        if (!other.empty()) with.assumptions.push_back(other);
        for (Case& part : cases_of(with)) {
          if (is_lost(part)) continue;
          if (!has_values(part.context, part.request)) return {};
          result.push_back(std::move(part));
        }
      } catch (const Contradiction&) {
        continue;
      } catch (const BadInput&) {  // of what the user did not say
        return {};
      }
  return result;
}

bool has_either_sign(const std::string& name, const Symbols& symbols) {
  const Interval range = parse_range(symbols.find(name)->range);
  const auto is_beyond = [](const End& end, int side) {
    return end.infinite != 0 || side * compare(end.value, 0) > 0;
  };
  return is_beyond(range.low, -1) && is_beyond(range.high, 1);
}

/// Whether x - y stands somewhere.
bool has_difference(const Case& one, const std::string& x, const std::string& y) {
  const Symbols& symbols = one.context.symbols;
  const GiNaC::ex difference = symbols[x] - symbols[y];
  const auto has_it = [&](const Tree& side) {
    const GiNaC::ex value = lower(side, symbols);
    return value.has(difference) || value.has(-difference);
  };
  const auto in = [&](const std::string& text) {
    const Relation relation = read(text, symbols);
    return std::any_of(relation.sides.begin(), relation.sides.end(), has_it);
  };
  return in(one.request.left) || in(one.request.right);
}

}  // namespace

std::vector<Way> parts_by_sign(const ProveRequest& request) {
  constexpr std::size_t most_names = 3, most_of_either_sign = 2;
  const std::vector<Case> whole = cases_of(request);
  if (whole.size() != 1 || request.order) return {};
  const Symbols& symbols = whole[0].context.symbols;
  const Relation left = read(request.left, symbols), right = read(request.right, symbols);
  if (!has_inequality(left) && !has_inequality(right)) return {};
  std::set<std::string> names;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  std::vector<std::string> of_either_sign;
  for (const std::string& name : names)
    if (has_either_sign(name, symbols)) of_either_sign.push_back(name);
  if (names.size() > most_names || of_either_sign.size() > most_of_either_sign) return {};
  std::vector<Way> ways;
  const auto add = [&](const Signs& each, const Signs& of_another) {
    ways.push_back([=] { return cases_with(each, of_another, request); });
  };
  const auto add_difference = [&] { add(signs(*names.begin(), *names.rbegin()), {}); };
  const bool is_first = names.size() == 2 && has_difference(whole[0], *names.begin(), *names.rbegin());
  if (is_first) add_difference();
  for (const std::string& name : of_either_sign) add(signs(name, "0"), {});
  if (names.size() == 2 && !is_first) add_difference();
  if (of_either_sign.size() == 2) add(signs(of_either_sign[0], "0"), signs(of_either_sign[1], "0"));
  return ways;
}

}  // namespace rederive
