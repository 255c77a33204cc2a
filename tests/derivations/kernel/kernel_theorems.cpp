// What the theorems say that are written by hand, and what they start from: rows of the paper, by the values
// of the Coq text. At which points their hypotheses hold.
#include <doctest/doctest.h>

#include <regex>
#include <tests/derivations/kernel/coq_spoil.hpp>
#include <tests/derivations/kernel/theorem_rows.hpp>

using namespace rederive;
using coq::About, coq::compare, coq::entries, coq::not_comparable, coq::Theorem;

TEST_CASE("a theorem written by hand says what its rows say") {
  int compared = 0;
  std::string left_out;
  for (const Theorem& theorem : coq::theorems()) {
    if (const auto found = not_comparable.find(theorem.name); found != not_comparable.end()) {
      left_out += "\n  " + found->first + ": " + found->second;
      continue;
    }
    for (const About& about : coq::abouts_of(theorem))
      for (const std::string& id : about.rows) {
        CHECK_MESSAGE(entries().contains(id),
                      theorem.name << " is about no row, and not_comparable does not say why");
        if (!entries().contains(id)) continue;
        const std::string why = compare(theorem, theorem.statement, about, id);
        CHECK_MESSAGE(why.empty(), theorem.name << " (" << id << "): " << why);
        compared += why.empty() ? 1 : 0;
      }
  }
  MESSAGE(coq::theorems().size() << " theorems, " << compared
                                 << " rows in them compared at 50 points; not comparable:" << left_out);
  CHECK(compared >= 220);
}

TEST_CASE("what is said of theorems is said of some that there are") {
  std::set<std::string> names;
  for (const Theorem& theorem : coq::theorems()) names.insert(theorem.name);
  for (const auto& [its_name, about] : coq::others) {
    const auto& name = its_name;
    CHECK_MESSAGE(names.contains(name), name);
  }
  for (const auto& [its_name, why] : not_comparable) {
    const auto& name = its_name;
    CHECK_MESSAGE(names.contains(name), name);
  }
}

TEST_CASE("a slip in what a theorem says is seen") {
  int tried = 0, seen = 0;
  for (const Theorem& theorem : coq::theorems()) {
    if (!theorem.name.starts_with("derivation_") || not_comparable.contains(theorem.name)) continue;
    const std::string text = coq::without_comments(shipped(theorem.file));
    const std::string statement =
        text.substr(theorem.words, coq::end_of_sentence(text, theorem.words) - theorem.words);
    const About about = coq::abouts_of(theorem)[0];
    for (const char* kind : {"sign", "function"})
      for (const std::string& slip : coq::slips_in(statement, kind)) {
        const Theorem other = coq::with_statement(theorem, slip, theorem.around);
        const auto differs = [&](const std::string& id) {
          return !compare(other, other.statement, about, id).empty();
        };
        ++tried, seen += std::any_of(about.rows.begin(), about.rows.end(), differs) ? 1 : 0;
        break;  // the last of its kind in the statement
      }
  }
  MESSAGE(seen << " of " << tried
               << " are; the others are in hypotheses, or make the statement false in another place");
  CHECK(seen >= 185);
}

namespace {

/// What stands before each theorem: (* from 25b, newton *).
std::vector<std::string> premises_of(const coq::Theorem& theorem) {
  const std::string text = shipped(theorem.file);
  const std::size_t start = text.rfind("(* from ", theorem.start) + 8;
  std::vector<std::string> result;
  static const std::regex word("[^, ]+");
  const std::string ids = text.substr(start, text.find(" *)", start) - start);
  for (std::sregex_iterator of(ids.begin(), ids.end(), word), end; of != end; ++of)
    result.push_back(of->str());
  return result;
}
/// Whether an equation is one of these rows, or one that they follow from.
bool is_row_of(const std::vector<std::string>& ids, const coq::Theorem& theorem, const coq::Text& equation,
               About about) {
  std::vector<std::string> all;
  for (const std::string& id : ids)
    if (entries().contains(id)) {
      all.push_back(id);
      const auto& before = entries().at(id).row.follows_from;
      all.insert(all.end(), before.begin(), before.end());
    }
  about.rows = all;
  return std::any_of(all.begin(), all.end(),
                     [&](auto& id) { return coq::compare(theorem, equation, about, id).empty(); });
}
/// What a theorem starts from beside rows and what it assumes by name.
const std::map<std::string, std::string> other_premises{
    {"derivation_31", "(28a) with (28b) put in"},
    {"derivation_40a", "y of the point at r and phi, as (u15) is its x"},
    {"derivation_42a", "R is the diagonal's half"},
    {"derivation_53b", "(25) calls the ground's acceleration at the start lambda a_p"},
    {"derivation_u27b", "(25) calls the ground's acceleration at the start lambda a_p"},
    {"derivation_u10a", "(25) calls the ground's acceleration at the start lambda a_p"},
    {"derivation_61a", "the ground is at rest: (52) with a_p = 0"},
    {"derivation_61b", "the ground is at rest: (52) with a_p = 0"},
    {"derivation_u12a", "(6) and (16b) at theta = 0"},
};
const std::map<std::string, std::map<std::string, std::string>> names_in_premises{
    {"derivation_60a_60c_u19b", {{"u_gddot", "0"}, {"g", "1"}}},
    {"derivation_60b_u19a", {{"u_gddot", "0"}, {"g", "1"}}},
    {"derivation_r12", {{"theta", "0"}, {"t", "t_i"}, {"thetadot", "thetadot_before"}}}};
/// t_o = T_ex, side = 1: which moment, and which side.
bool is_choice(const coq::Text& equation) {
  return equation->head == "=" && (equation->parts[0]->head == "t_o" || equation->parts[0]->head == "side");
}

}  // namespace

TEST_CASE("the equations that a theorem starts from are rows") {
  const std::set<std::string> names{"newton", "euler", "rotation", "linearised", "rest", "criterion"};
  static const std::regex named("equation_(\\w+)");
  std::set<const coq::Term*> seen;
  int rows = 0, listed = 0, assumed = 0;
  for (const Theorem& theorem : coq::theorems()) {
    if (!theorem.name.starts_with("derivation_")) continue;
    const auto from = premises_of(theorem);
    About about = coq::abouts_of(theorem)[0];
    if (const auto found = names_in_premises.find(theorem.name); found != names_in_premises.end())
      about.names = found->second;
    Theorem own = theorem;  // without what its section assumes
    std::erase_if(own.around, [](const coq::Item& item) { return item.kind == coq::Item::Kind::hypothesis; });
    for (const coq::Text& h : coq::parts_of(own).hypotheses) {
      if ((h->head != "=" && h->head != "forall") || is_choice(h)) continue;
      if (is_row_of(from, theorem, h, about))
        ++rows;
      else if (other_premises.contains(theorem.name))
        ++listed;
      else if (std::any_of(from.begin(), from.end(), [&](auto& id) { return names.contains(id); }))
        ++assumed;
      else
        CHECK_MESSAGE(false, theorem.name << ": a hypothesis is none of the rows that it is from");
    }
    for (const coq::Item& item : theorem.around) {
      std::smatch id;
      if (item.kind != coq::Item::Kind::hypothesis || !std::regex_match(item.name, id, named)) continue;
      if (!seen.insert(item.text.get()).second) continue;
      for (const char* side : {"", "a", "b"}) {  // equation_21 is (21a) and (21b)
        if (!entries().contains(id[1].str() + side)) continue;
        const std::string why = compare(theorem, item.text, about, id[1].str() + side);
        CHECK_MESSAGE(why.empty(), theorem.name << ", " << item.name << ": " << why);
        rows += why.empty() ? 1 : 0;
      }
    }
  }
  MESSAGE(rows << " equations are rows, " << assumed << " are assumed by name, " << listed << " are others");
  CHECK(rows >= 110);
}

namespace {

/// Motions that obey what hypotheses ask for, and what they tend to.
const std::map<std::string, std::map<std::string, std::string>> motions{
    {"derivation_61a", {{"theta", "1/3 * sinh (p * t) + 1/5 * cosh (p * t) - alpha"}}},
    {"derivation_61b", {{"theta", "1/3 * sinh (p * t) + 1/5 * cosh (p * t) + alpha"}}},
    {"derivation_60a_60c_u19b",
     {{"theta", "- side * alpha"}, {"thetadot", "0"}, {"thetaddot", "0"}, {"theta_star", "- side * alpha"}}},
    {"derivation_60b_u19a",
     {{"theta", "- side * alpha"}, {"thetadot", "0"}, {"thetaddot", "0"}, {"theta_star", "- side * alpha"}}},
    {"derivation_r15",
     {{"x",
       "alpha / (1 + (omega_p / p) ^ 2) / cos psi * (omega_p / p * sin psi * sinh (p * t) + "
       "cos (omega_p * t + (PI - psi)) + cos psi * cosh (p * t)) + alpha - alpha * cosh (p * t)"}}},
    {"claim_c69_nothing_lifts", {{"u", "alpha * g * sin t"}}},
};

/// Motions of two pieces, which no formula gives; threshold_instance says that there are such.
const std::set<std::string> proved_to_exist{"threshold_of_the_motion", "claim_c54_figure_8_is_not_linear",
                                            "claim_c55_figure_9_is_not_linear", "one_impact_motion_exists"};

}  // namespace

TEST_CASE("the hypotheses of a theorem written by hand hold at some point") {
  int named = 0;
  for (const Theorem& theorem : coq::theorems()) {
    if (proved_to_exist.contains(theorem.name)) continue;
    const coq::Parts parts = coq::parts_of(theorem);
    const auto found = motions.find(theorem.name);
    const auto known = found == motions.end() ? std::map<std::string, std::string>{} : found->second;
    std::optional<std::string> point;
    for (unsigned long seed = 1; seed < 60 && !point; ++seed) {
      coq::Solver solver(theorem, parts, seed, known);
      if (!solver.meets_all()) continue;
      point = solver.point();
      CHECK_MESSAGE(solver.world.holds(parts.conclusion) != false, theorem.name << " fails at" << *point);
    }
    CHECK_MESSAGE(point, theorem.name);
    if (point) MESSAGE(theorem.name << " at" << *point);
    named += point ? 1 : 0;
  }
  CHECK(named >= 190);
}
