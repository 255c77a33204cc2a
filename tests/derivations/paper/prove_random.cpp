// Random expressions of the class, rewritten by random true identities (must be proved) and spoiled by one
// random edit (must be refuted, unless 600 bits at some points say that nothing was spoiled).
// REDERIVE_SEED and REDERIVE_PAIRS choose another run, of 10000 pairs, say.
#include <doctest/doctest.h>

#include <derivations/language/lower.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/prove_bounded.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>
#include <tests/random.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::test;

namespace {

/// The same value, written in two ways.
struct Twin {
  std::string left, right;
};

class Generator : public Choices {
 public:
  using Choices::Choices;
  using Choices::pick;
  std::string pick(const char* section) { return pick(words_.at(section)); }

  std::string argument() {
    std::string text = pick("numbers") + pick("phases");
    if (one_in(3)) text += (one_in(2) ? "+" : "-") + pick("phases");
    return text + (one_in(4) ? pick("turns") : "");
  }

  std::string real_argument() {
    return pick("real numbers") + pick("real phases") + (one_in(3) ? "+" + pick("real phases") : "");
  }

  Twin identity() {
    const Cells& row = pick(identities_);
    std::map<std::string, std::string> values;
    for (const char* name : {"$a", "$b", "$r", "$s"})
      values[name] = "(" + (name[1] < 'r' ? argument() : real_argument()) + ")";
    Twin twin{filled(row[0], values), filled(row[1], values)};
    if (one_in(2)) std::swap(twin.left, twin.right);
    return twin;
  }

  Twin expression(int depth) {
    if (depth == 0) return identity();
    const Twin a = expression(depth - 1), b = expression(0);
    switch (below(6)) {
      case 0:
        return {"(" + a.left + ")+(" + b.left + ")", "(" + b.right + ")+(" + a.right + ")"};
      case 1:
        return {"(" + a.left + ")-(" + b.left + ")", "-(" + b.right + ")+(" + a.right + ")"};
      case 2:
        return {"(" + a.left + ")*(" + b.left + ")", "(" + b.right + ")*(" + a.right + ")"};
      case 3:
        return {"(" + a.left + ")/(" + b.left + ")", "1/(" + b.right + ")*(" + a.right + ")"};
      case 4:
        return {"(" + a.left + ")^2", "(" + a.right + ")*(" + a.right + ")"};
      default:
        return {"x*(" + a.left + ")+" + b.left, b.right + "-y*0+x*(" + a.right + ")"};
    }
  }

  /// Returns the text with one slip.
  std::string spoiled(const std::string& text) {
    const auto goes_on = [&](std::size_t k) {
      return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
    };
    for (int tries = 0; tries < 100; ++tries) {
      const Cells& slip = pick(slips_);
      const std::string& from = slip[0];
      const bool is_word = std::isalpha(static_cast<unsigned char>(from[0])) != 0;
      std::vector<std::size_t> places;
      for (std::size_t k = text.find(from); k != std::string::npos; k = text.find(from, k + 1))
        if (!is_word || !(goes_on(k - 1) || (from.back() != '(' && goes_on(k + from.size()))))
          places.push_back(k);
      if (!places.empty()) return std::string(text).replace(pick(places), from.size(), slip[1]);
    }
    return text + "+1";
  }

 private:
  std::map<std::string, Cells> words_ = named_cases("words");
  std::vector<Cells> identities_ = cases("identities"), slips_ = cases("slips");
};

/// Rational points inside the declared ranges.
Point random_point(const std::set<std::string>& names, const Symbols& symbols, std::mt19937& random) {
  Point point;
  for (const std::string& name : names) {
    const Interval range = parse_range(symbols.find(name)->range);
    cln::cl_RA value;
    do value = (cln::cl_RA(static_cast<long>(random() % 1001)) - 500) / static_cast<long>(1 + random() % 300);
    while (!range.contains({value}));
    point.emplace(name, value);
  }
  return point;
}

/// Whether 600 bits at so many points tell the two apart; nothing where they have no values in common.
std::optional<bool> are_different(const Tree& a, const Tree& b, const Symbols& symbols, int points = 12) {
  std::set<std::string> names = names_of(a);
  names.merge(names_of(b));
  std::mt19937 random(1);
  int both = 0;
  for (int k = 0; k < 60 && both < points; ++k) {
    const Sign sign = sign_at(a, b, random_point(names, symbols, random), 600);
    if (sign == Sign::undefined) continue;
    ++both;
    if (sign == Sign::negative || sign == Sign::positive) return true;
  }
  return both == 0 ? std::nullopt : std::optional(false);
}

/// The witness, recomputed: the two sides have values there, and they differ.
bool differ_at(const Witness& witness, const Tree& a, const Tree& b, const Symbols& symbols) {
  Point point;
  for (const auto& [name, value] : witness.at)
    point.emplace(name, Number(parse(value, symbols, {.digits = 2000})));
  for (const auto& [name, value] : witness.exactly)
    point.insert_or_assign(name, Number(parse(value, symbols)));
  const Sign sign = sign_at(a, b, point);
  return sign == Sign::negative || sign == Sign::positive;
}

}  // namespace

TEST_CASE("random identities are proved, and random slips are refuted") {
  const auto seed = static_cast<unsigned>(from_environment("REDERIVE_SEED", 20261120));
  const long pairs = from_environment("REDERIVE_PAIRS", 3'000);
  Generator generator(seed);
  const Symbols symbols = declared_symbols({"x", "y", {}, {}, {}});
  long done = 0, undecided_true = 0, undecided_false = 0, equal_after_all = 0, wrong = 0;
  while (done < pairs) {
    const Twin twin = generator.expression(static_cast<int>(generator.below(3)));
    const std::string slip = generator.spoiled(twin.right);
    Tree left, right, spoiled;
    try {
      left = parse(twin.left, symbols), right = parse(twin.right, symbols), spoiled = parse(slip, symbols);
      for (const Tree& tree : {left, right, spoiled}) (void)lower(tree, symbols);
    } catch (const SyntaxError&) {  // a divisor that is 0, a pole: no statement at all
      continue;
    }
    if (!are_different(left, right, symbols, 1)) continue;  // nowhere defined
    ++done;
    const Verdict truth = decide({{left}, {}}, {{right}, {}}, symbols).verdict;
    if (truth == Verdict::undecided) {
      ++undecided_true;
      if (std::getenv("REDERIVE_SHOW") != nullptr)
        std::cout << "undecided: " << twin.left << "  =  " << twin.right << "\n";
    }
    const bool refuted_a_truth = truth == Verdict::refuted;
    const Proof slipped = decide({{left}, {}}, {{spoiled}, {}}, symbols);
    const auto different = are_different(left, spoiled, symbols);
    const bool proved_a_slip = slipped.verdict == Verdict::proved && different.value_or(true);
    const bool false_witness =
        slipped.verdict == Verdict::refuted && !differ_at(*slipped.witness, left, spoiled, symbols);
    undecided_false += slipped.verdict == Verdict::undecided && different.value_or(false) ? 1 : 0;
    equal_after_all += different && !*different ? 1 : 0;
    if (!refuted_a_truth && !proved_a_slip && !false_witness) continue;
    ++wrong;
    INFO("seed " << seed << ", pair " << done << "\n" << twin.left << "\n" << twin.right << "\n" << slip);
    CHECK_FALSE(refuted_a_truth);
    CHECK_FALSE(proved_a_slip);
    CHECK_FALSE(false_witness);
  }
  std::cout << done << " pairs: " << undecided_true << " truths and " << undecided_false
            << " slips undecided, " << equal_after_all << " slips changed nothing, " << wrong << " wrong\n";
  CHECK(wrong == 0);
  CHECK(undecided_true + undecided_false <= 2 * pairs / 50);
}
