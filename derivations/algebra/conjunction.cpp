#include <algorithm>
#include <derivations/algebra/cofactors.hpp>
#include <derivations/algebra/conjunction.hpp>
#include <derivations/algebra/exact_points.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/lost.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/root_witness.hpp>
#include <derivations/algebra/roots.hpp>
#include <exception>
#include <functional>
#include <numeric>

namespace rederive {

using GiNaC::ex;

namespace {

/// One link alone: what it asks for, as it stands and as it is compared.
struct Part {
  Tree written;
  ex residual, inner;
  Claim claim;
  std::optional<ex> squared = std::nullopt;
};
using Parts = std::vector<Part>;
using Numbers = std::vector<std::size_t>;

/// Both statements in parts, and a comparison of their first links, for what all of them have in common.
struct Parted {
  Parts left, right;
  Residuals first;
};

Parted parts_of(const Question& question) {
  const std::vector<Link> left = links_of(question.left), right = links_of(question.right);
  Parted result{{}, {}, residuals_of(left[0], right[0], question)};
  for (const Link& link : left) {
    const Residuals r = residuals_of(link, right[0], question);
    result.left.push_back({r.pair.left, r.pair.left_value, r.inner_left, r.left, r.squared_left});
  }
  for (const Link& link : right) {
    const Residuals r = residuals_of(left[0], link, question);
    result.right.push_back({r.pair.right, r.pair.right_value, r.inner_right, r.right, r.squared_right});
  }
  return result;
}

/// A > 0 and B > 0 is A·B > 0, if A + B > 0 everywhere.
std::optional<Part> as_one(const Parts& parts, const Numbers& chosen, const Symbols& symbols) {
  const Part& a = parts[chosen.front()];
  const Part& b = parts[chosen.back()];
  if (chosen.size() == 1) return a;
  if (chosen.size() > 2 || a.claim != b.claim || a.claim == Claim::zero) return std::nullopt;
  if (sign_of((a.inner + b.inner).expand(), symbols) <= 0) return std::nullopt;
  const ex product = a.inner * b.inner;
  return Part{nullptr, product, product, a.claim};
}

Points points_for(const Parted& parts, const Symbols& symbols) {
  std::vector<Tree> trees = trees_of(parts.first.pair);
  for (const Parts* side : {&parts.left, &parts.right})
    for (const Part& part : *side) trees.push_back(part.written);
  return points_for(trees, symbols);
}

/// Finds the matches of all parts.
class Matching {
 public:
  Matching(const Question& question, const Parted& parts)
      : parts_(parts), symbols_(question.symbols), points_(points_for(parts, question.symbols)) {}

  std::optional<std::vector<Match>> find() {
    auto found = find_matches();
    return found && !found->front().never && is_lost() ? std::nullopt : found;
  }

  bool all_follow() {
    Numbers left(parts_.left.size()), right(parts_.right.size());
    std::iota(left.begin(), left.end(), 0), std::iota(right.begin(), right.end(), 0);
    return follow(left, right) && !is_lost();
  }

 private:
  std::optional<std::vector<Match>> find_matches() {
    Numbers left = open(parts_.left, true), right = open(parts_.right, false);
    if (never_.left.size() == 1 && never_.right.size() == 1) return std::vector{never_};
    Numbers other_left = left, other_right = right;  // what no other link alone says
    const std::size_t before = matches_.size();
    for (const std::size_t i : left)
      for (const std::size_t j : right)
        if ((among(i, other_left) || among(j, other_right)) && same(parts_.left[i], parts_.right[j])) {
          std::erase(other_left, i), std::erase(other_right, j);
          matches_.push_back({{i}, {j}});
        }
    if (other_left.empty() && other_right.empty()) return matches_;
    if (follow(other_left, other_right)) return matches_;
    if (left.empty() || right.empty()) return std::nullopt;
    matches_.resize(before);
    const auto a = as_one(parts_.left, left, symbols_), b = as_one(parts_.right, right, symbols_);
    if (!a || !b || !same(*a, *b)) return std::nullopt;
    matches_.push_back({left, right});
    return matches_;
  }

  /// Whether a statement divides by something that is 0 wherever the equations of the other one hold, or of
  /// which that is 0 the other one holds all along.
  bool is_lost() const {
    const Residuals& r = parts_.first;
    return loses(r.left_divisors, r.right_divisors, asked(parts_.right)) ||
           loses(r.right_divisors, r.left_divisors, asked(parts_.left));
  }
  bool loses(const std::vector<ex>& divisors, const std::vector<ex>& others,
             const std::vector<Asked>& links) const {
    const auto follows = [&](const ex& divisor) {
      return by_elimination({divisor, Claim::zero}, links, {}, symbols_).has_value();
    };
    const std::vector<ex> own = own_divisors(divisors, others, symbols_);
    return std::any_of(own.begin(), own.end(), follows) || lost_along(own, links, symbols_);
  }
  static bool among(std::size_t k, const Numbers& numbers) {
    return std::find(numbers.begin(), numbers.end(), k) != numbers.end();
  }
  /// Those that do not always hold.
  Numbers open(const Parts& parts, bool is_left) {
    Numbers result;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const auto holds = settled(parts[k].inner, parts[k].residual, parts[k].claim, symbols_);
      if (holds == true)
        (is_left ? matches_.emplace_back().left : matches_.emplace_back().right) = {k};
      else
        result.push_back(k);
      if (holds == false) (is_left ? never_.left : never_.right) = {k};
    }
    return result;
  }
  /// Whether all of these follow from the links of the other side; then they are matches.
  bool follow(const Numbers& left, const Numbers& right) {
    const std::vector<Asked> of_left = asked(parts_.left), of_right = asked(parts_.right);
    if (!have_values_together(of_left, of_right, parts_.first, symbols_)) return false;
    std::vector<ex> divisors = parts_.first.left_divisors;
    divisors.insert(divisors.end(), parts_.first.right_divisors.begin(), parts_.first.right_divisors.end());
    std::vector<Match> found;
    for (const auto& [numbers, is_left] : {std::pair(left, true), std::pair(right, false)})
      for (const std::size_t k : numbers) {
        auto why =
            consequence((is_left ? of_left : of_right)[k], is_left ? of_right : of_left, divisors, symbols_);
        if (!why) return false;
        found.push_back({is_left ? Numbers{k} : Numbers{}, is_left ? Numbers{} : Numbers{k}, false, why});
      }
    matches_.insert(matches_.end(), found.begin(), found.end());
    return true;
  }
  static std::vector<Asked> asked(const Parts& parts) {
    std::vector<Asked> result;
    for (const Part& part : parts) result.push_back({part.residual, part.claim});
    return result;
  }
  /// Whether everything has a value near a zero of one equation, and the other one fails there: cheaper than
  /// algebra, which would not find a factor.
  bool differ_at_a_zero(const Part& of, const Part& other) const {
    const auto has_value = [](const Point& point) {
      return [&](const Part& part) { return value_of(part.written, point).has_value(); };
    };
    for (const auto& [name, point] : linear_zeros(of.residual, points_, symbols_, Zeros::irrational, 2)) {
      const auto value = other.written ? value_of(other.written, point) : std::nullopt;
      if (value && differ(*value, 0) && is_admitted(parts_.first.pair, {point}, symbols_) &&
          std::all_of(parts_.left.begin(), parts_.left.end(), has_value(point)) &&
          std::all_of(parts_.right.begin(), parts_.right.end(), has_value(point)))
        return true;
    }
    return false;
  }
  bool same(const Part& a, const Part& b) const {
    if (a.claim != b.claim) return false;
    if (a.claim == Claim::zero && (differ_at_a_zero(a, b) || differ_at_a_zero(b, a))) return false;
    Residuals r = parts_.first;
    r.pair.left_value = a.residual, r.pair.right_value = b.residual;
    r.inner_left = a.inner, r.inner_right = b.inner, r.left = r.right = a.claim;
    r.squared_left = a.squared, r.squared_right = b.squared;
    return differ_by_some_factor(r, symbols_) && !lost_to(r, symbols_);
  }

  const Parted& parts_;
  const Symbols& symbols_;
  Points points_;
  std::vector<Match> matches_;
  Match never_{{}, {}, true};
};

/// A root that is looked at, or a point that is exact, and a residual that is 0 there; or what every symbol
/// is.
struct Place {
  Root at;
  ex root_of = 0;
  GiNaC::exmap values = {};
};

/// The sign of a part where the point is, or what it stands for; nothing where that cannot be told.
std::optional<int> sign_of_part(const Part& part, const Place& place, const Symbols& symbols) {
  const Root& at = place.at;
  const auto value = value_of(part.written, at.at);
  if (!value) return std::nullopt;
  if (!place.values.empty() && is_zero_at({part.written, part.residual}, {at, place.values}, symbols))
    return 0;
  if (at.exact && differ(*value, 0)) return cln::plusp(*value) ? 1 : -1;
  if (!place.root_of.is_zero() && GiNaC::is_a<GiNaC::numeric>((part.residual / place.root_of).normal()) &&
      (at.exact || enclosure(part.written, at.at, at.box)))
    return 0;
  const auto sign = at.exact ? std::nullopt : sign_at(part.written, at);
  if (sign) return sign;
  const auto root = zero_near({part.written, part.residual}, at.at, symbols);
  const bool is_certain = root && (at.exact ? root->exact
                                            : !at.meant.empty() && root->meant == at.meant &&
                                                  enclosure(part.written, at.at, at.box));
  return is_certain ? std::optional(0) : std::nullopt;
}

/// Whether all parts hold at a point, and the first that does not, or that is 0; nothing where one has no
/// value, or is so near 0 that it cannot be told.
struct Truth {
  bool holds = true, is_zero = false;
  std::size_t part = 0;
};
std::optional<Truth> truth(const Parts& parts, const Place& place, const Symbols& symbols) {
  Truth result;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto sign = sign_of_part(parts[k], place, symbols);
    if (!sign) return std::nullopt;
    const Claim claim = parts[k].claim;
    const bool zero = *sign == 0, holds = zero ? claim != Claim::positive : claim != Claim::zero && *sign > 0;
    if (result.holds && (!holds || (zero && !result.is_zero))) result = {holds, zero, k};
  }
  return result;
}

/// One value of each side, of parts that tell them apart; nothing where their digits are not certain.
std::optional<Witness> witness_at(const Place& place, const Parted& parts, const Truth& left,
                                  const Truth& right) {
  Pair shown = parts.first.pair;
  shown.left = parts.left[left.part].written, shown.right = parts.right[right.part].written;
  std::vector<Tree> zeros;
  if (left.is_zero) zeros.push_back(shown.left);
  if (right.is_zero) zeros.push_back(shown.right);
  const bool is_certain = (left.is_zero || has_digits_at(shown.left, place.at)) &&
                          (right.is_zero || has_digits_at(shown.right, place.at));
  return is_certain ? std::optional(make_witness(shown, place.at, zeros)) : std::nullopt;
}

/// Some points at which all equations of a statement hold, and one of its inequalities turns, if one is
/// given.
std::vector<Point> solutions_of(const Parts& parts, const Part* inequality, const Points& points,
                                const Symbols& symbols) {
  std::vector<ex> residuals;
  for (const Part& part : parts)
    if (part.claim == Claim::zero || &part == inequality) residuals.push_back(part.residual.expand());
  std::vector<Point> result;
  const auto solution = residuals.size() > 1 ? solved(residuals, symbols) : std::nullopt;
  for (int k = 0; solution && k < Points::count; ++k)
    if (const auto point = completed(*solution, points.at(k), symbols)) result.push_back(*point);
  return result;
}

std::optional<Proof> differ_at(const Place& place, const Parted& parts, const Symbols& symbols) {
  const auto left = truth(parts.left, place, symbols),
             right = left ? truth(parts.right, place, symbols) : std::nullopt;
  if (!right || left->holds == right->holds || !is_admitted(parts.first.pair, place.at, symbols))
    return std::nullopt;
  const auto witness = witness_at(place, parts, *left, *right);
  const std::string why = left->holds ? "at the witness all of the left one holds and the right one fails"
                                      : "at the witness the right one holds and a link of the left one fails";
  return witness ? std::optional(refuted(*witness, why + precision_of(place.at))) : std::nullopt;
}

/// Among so many.
std::optional<Proof> differ_at_a_point(const Parted& parts, const Points& points, int count,
                                       const Symbols& symbols) {
  for (int k = 0; k < count; ++k)
    if (auto proof = differ_at({{points.at(k), true}}, parts, symbols)) return proof;
  return std::nullopt;
}

/// A point at which one statement holds and the other does not: among many, or where all equations of a side
/// hold.
std::optional<Proof> differ_somewhere(const Parted& parts, const Points& points, const Symbols& symbols) {
  if (auto proof = differ_at_a_point(parts, points, Points::many, symbols)) return proof;
  for (const Parts* side : {&parts.left, &parts.right}) {
    std::vector<const Part*> turning{nullptr};
    for (const Part& part : *side)
      if (part.claim != Claim::zero) turning.push_back(&part);
    for (const Part* inequality : turning)
      for (const Point& point : solutions_of(*side, inequality, points, symbols))
        if (auto proof = differ_at({{point, true}}, parts, symbols)) return proof;
  }
  return std::nullopt;
}

/// The same where all the equations of a side hold, though not all symbols are rational.
std::optional<Proof> differ_at_a_solution(const Parted& parts, const Points& points, const Symbols& symbols) {
  for (const Parts* side : {&parts.left, &parts.right}) {
    std::vector<ex> equations;
    for (const Part& part : *side)
      if (part.claim == Claim::zero) equations.push_back(part.residual);
    if (equations.empty()) continue;
    for (const auto& [root, values] : exact_points(equations, points, symbols))
      if (auto proof = differ_at({root, 0, values}, parts, symbols)) return proof;
  }
  return std::nullopt;
}

/// The same where a link turns.
std::optional<Proof> differ_at_a_root(const Parted& parts, const Points& points, const Symbols& symbols) {
  std::vector<Written> links;
  for (const Parts* side : {&parts.left, &parts.right})
    for (const Part& part : *side) links.push_back({part.written, part.residual});
  std::optional<Proof> found;
  for (const Written& link : links)
    if (find_root(link, points, 10, Roots::crossings, symbols, [&](const Root& root) {
          auto proof = differ_at({root, link.value}, parts, symbols);
          if (proof) found = std::move(proof);
          return proof.has_value();
        }))
      return found;
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Match>> matches(const Question& question) {
  return Matching(question, parts_of(question)).find();
}

bool match_at_once(const Question& question) {
  const Parted parts = parts_of(question);
  return !differ_at_a_point(parts, points_for(parts, question.symbols), Points::count, question.symbols) &&
         Matching(question, parts).find();
}

bool follow_from_each_other(const Question& question) {
  const Parted parts = parts_of(question);
  return Matching(question, parts).all_follow();
}

std::optional<Proof> differ_at_one_of(const std::vector<Root>& places, const Question& question) {
  const Parted parts = parts_of(question);
  for (const Root& place : places) {
    GiNaC::exmap values;
    for (const auto& [name, text] : place.meant)
      values[question.symbols[name]] = lower(parse(text, question.symbols), question.symbols);
    if (auto proof = differ_at({place, 0, values}, parts, question.symbols)) return proof;
  }
  return std::nullopt;
}

Proof prove_conjunctions(const Question& question) {
  const Parted parts = parts_of(question);
  const Symbols& symbols = question.symbols;
  const Points points = points_for(parts, symbols);
  if (const auto proof = differ_somewhere(parts, points, symbols)) return *proof;
  std::optional<std::vector<Match>> found;
  std::exception_ptr failure;  // a witness may be found all the same
  try {
    found = Matching(question, parts).find();
  } catch (const std::exception&) {
    failure = std::current_exception();
  }
  auto proof = found ? std::nullopt : differ_at_a_solution(parts, points, symbols);
  if (!found && !proof) proof = differ_at_a_root(parts, points, symbols);
  if (proof) return *proof;
  if (failure) std::rethrow_exception(failure);
  if (!found)
    return undecided("the links of the one were not found to say together what those of the other one say");
  return proved("", found->front().never
                        ? "neither holds for any value in the declared ranges"
                        : "link by link the two say the same, or what follows from the other links");
}

}  // namespace rederive
