// What students type, with what must come of it; what is echoed and suggested reads back as promised.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/page/prose.hpp>
#include <regex>

#include "classroom.hpp"

using namespace rederive;
using namespace rederive::classroom;

namespace {

/// A seed of the exercise in which this is given.
std::string seed_with(const std::string& id, const std::string& given) {
  for (int seed = 1; seed < 100; ++seed)
    if (std::ranges::count(exercise(id, std::to_string(seed)).given, given) > 0) return std::to_string(seed);
  return "";
}

/// Right answers, wrong ones and what is neither, of one exercise, also in spellings of other keyboards.
std::vector<std::string> typed_answers(const Prepared& one) {
  const Exercise& exercise = one.exercise;
  std::vector<std::string> answers = exercise.equivalents;
  answers.push_back(model_answer(one));
  if (!exercise.example.empty()) answers.push_back(exercise.example);
  for (const auto& slip : exercise.slips)
    if (!slip.typed.empty()) answers.push_back(slip.typed);
  if (exercise.kind == Kind::choice || exercise.kind == Kind::wrong_term)
    for (const char* text : {"a", "b", "(C)", "2", "[1]", "term 2"}) answers.emplace_back(text);
  std::vector<std::string> result = answers;
  for (const auto& answer : answers) {
    std::string text = answer;
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"alpha", "α"}, {"theta", "θ"}, {"*", "·"}, {"-", "−"}, {"^2", "²"}, {"sqrt(", "√("}})
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    result.push_back(text);
    result.push_back("(" + answer + ")");
    result.push_back("-(" + answer + ")");
    result.push_back("2*(" + answer + ")");
    result.push_back("abs(" + answer + ")");
    result.push_back(std::regex_replace(answer, std::regex(R"(\*)"), " "));
    result.push_back(std::regex_replace(answer, std::regex(R"((sin|cos)\((\w+)\)\^2)"), "$1^2($2)"));
    result.push_back(std::regex_replace(answer, std::regex(R"((sin|cos)\((\w+)\))"), "$1 $2"));
    result.push_back(std::regex_replace(answer, std::regex(R"((\d)\.(\d))"), "$1,$2"));
  }
  if (exercise.kind == Kind::number) {
    const std::string unit = exercise.unit == "1" ? "" : exercise.unit;
    const double value = one.answer.number;
    for (const auto& text : {fmt::format("{:.12g} {} + {:.12g} {}", value / 4, unit, 3 * value / 4, unit),
                             fmt::format("{:.12g} - {:.12g} {}", 5 * value, 4 * value, unit),
                             fmt::format("({:.12g} - {:.12g}) {}", 5 * value, 4 * value, unit)})
      result.push_back(text);
  }
  return result;
}

/// The texts that a message suggests: "write a or b".
std::vector<std::string> suggested(const std::string& message) {
  const std::string line = message.substr(0, message.find('\n'));
  const std::size_t at = line.find(": write ");
  std::vector<std::string> texts;
  if (at == std::string::npos) return texts;
  std::string rest = line.substr(at + 8);
  for (std::size_t end; (end = rest.find(" or ")) != std::string::npos; rest = rest.substr(end + 4))
    texts.push_back(rest.substr(0, end));
  texts.push_back(rest);
  return texts;
}

}  // namespace

TEST_CASE("right answers that students type are right, and wrong ones are called what they are") {
  struct Row {
    std::string id, answer, verdict, note;
  };
  for (const Row& row : std::vector<Row>{
           {"barrier-and-size", "1.5 m - 1.5*cos(0.2) m", "correct", "correct"},
           {"barrier-and-size", "1.5 - 1.4701 m", "correct", "correct"},
           {"barrier-and-size", "150 cm - 1.4701 m", "correct", "correct"},
           {"barrier-and-size", "(1.5 - 1.5*cos(0.2)) m", "correct", "correct"},
           {"barrier-and-size", "1.5 m - 1.4701", "invalid", "unit"},
           {"first-lift", "5.886 - 2.943 m/s^2", "correct", "correct"},
           {"first-lift", "2.94 m/s2", "correct", "correct"},
           {"first-lift", "294 Gal", "correct", "correct"},
           {"length-of-a-pulse", "0.734 - 0.061 s", "correct", "correct"},
           {"phase-of-a-pulse", "90 deg - 60 deg", "correct", "correct"},
           {"phase-of-a-pulse", "90 - 60 deg", "invalid", "ambiguous_unit"},
           {"restitution", "1 - 3/2*sin(alpha)", "wrong", "power"},
           {"restitution", "sqrt((1-3/2*sin(alpha)^2)^2)", "wrong", "not_everywhere"},
           {"restitution-of-a-statue", "9.82 x 10^-1", "correct", "correct"},
           {"restitution-of-a-statue", "0.964", "wrong", "energy"},
           {"restitution-of-a-statue", "0.018", "wrong", "taken_away"},
           {"restitution-of-a-statue", "0.98", "wrong", "rounding"},
           {"frequency-of-a-bookcase", "0.428 Hz", "correct", "correct"},
           {"frequency-of-a-bookcase", "2.69 Hz", "wrong", "unit"},
           {"frequency-of-a-bookcase", "2.71", "wrong", "half_height"},
           {"frequency-of-a-bookcase", "2.7", "wrong", "rounding"},
           {"misprint-in-17", "term 3", "correct", "correct"},
           {"inertia-about-corner", "2/3*m*R^2", "wrong", "factor"},
           {"sudden-start", "1/tan(alpha)", "wrong", "reciprocal"},
           {"sudden-start", "cot(alpha)", "wrong", "reciprocal"},
           {"linear-equation", "θ̈ + p²*θ = p²*α", "wrong", "sign"},
           {"linear-equation", "thetaddot - p^2*theta = -p^2*alpha", "correct_if", "assumption"},
           {"linear-equation", "thetaddot = p^2*(abs(theta) - alpha - a_p/g*sin(omega_p*t + psi))", "correct",
            "correct"},
           {"critical-condition", "thetadot_ex = 0", "wrong", "missing_angle"},
           {"critical-condition", "abs(thetadot_ex) = p*(alpha+theta_ex)", "correct", "correct"},
           {"critical-condition", "thetadot_ex^2 = p^2*(alpha+theta_ex)^2", "correct", "correct"},
           {"critical-condition", "thetadot_ex^2 = p^2*(alpha-theta_ex)^2", "wrong", "sign"},
           {"release-from-rest", "alpha-(alpha-abs(theta_0))*cosh(p*t)", "correct", "correct"},
           {"release-from-rest", "alpha-abs(alpha-theta_0)*cosh(p*t)", "correct", "correct"},
           {"first-acceleration", "-abs(p^2*(sin(alpha) - lambda*a_p/g*cos(alpha)))", "correct", "correct"},
           {"height-of-centre", "R*(cos(alpha - abs(theta)) - cos(alpha))", "correct", "correct"},
           {"vertical-reaction",
            "g + R*thetadot^2*cos(alpha-theta) + "
            "p^2*R*sin(alpha-theta)*(sin(alpha-theta)+u_gddot/g*cos(alpha-theta))",
            "wrong", "newton"},
           {"motion-by-moments", "J_o*thetaddot + m*g*R*sin(alpha-theta) + m*R*u_gddot*sin(alpha-theta) = 0",
            "wrong", "sin_cos"},
           {"energy-lost", "2/3*m*R²·(1-e²)·θ̇⁻^2", "correct", "correct"},
           {"first-mode-at-two", "2.35769", "wrong", "printed"},
           {"first-mode-at-two", "2.35766", "wrong", "printed"},
           {"first-mode-at-two", "2.35771", "wrong", "printed"},
           {"amplitude-at-five", "2.921", "wrong", "one_impact"},
           {"size-from-p", "5.11", "wrong", "half_diagonal"},
           {"inertia-about-corner", "1 1/3*m*R^2", "invalid", "implicit_multiplication"},
           {"equation-of-motion", "(thetaddot + p^2*(sin(alpha-theta) + u_gddot/g*cos(alpha-theta)))^2 = 0",
            "correct", "correct"},
           {"equation-of-motion", "exp(thetaddot/p^2 + sin(alpha-theta) + u_gddot/g*cos(alpha-theta)) = 1",
            "correct", "correct"},
       }) {
    const Opinion opinion = judged(row.id, row.answer);
    CHECK_MESSAGE(to_string(opinion.outcome) == row.verdict, row.id, ": ", row.answer);
    CHECK_MESSAGE(opinion.note.word == row.note, row.id, ": ", row.answer, ": ", opinion.note.word);
  }
}

TEST_CASE("what is given holds on the other side, too, and at every witness") {
  const std::string tilted = seed_with("release-from-rest", "-alpha < theta_0 < 0"),
                    left = seed_with("critical-condition", "0 < theta_ex < alpha"),
                    turned = seed_with("height-of-centre", "theta < 0");
  CHECK(judged("release-from-rest", "-alpha + (alpha - abs(theta_0))*cosh(p*t)", tilted).outcome ==
        Outcome::correct);
  CHECK(judged("critical-condition", "abs(thetadot_ex) = p*(alpha - theta_ex)", left).outcome ==
        Outcome::correct);
  CHECK(judged("height-of-centre", "R*(cos(alpha - abs(theta)) - cos(alpha))", turned).outcome ==
        Outcome::correct);
  CHECK(prepared("misprint-in-17").symbols.find("theta")->range == "(0, pi/2)");
  int witnesses = 0;
  for (const std::string seed : {"", "1", "2", "3"})
    for (const Prepared& one : all_prepared(seed)) {
      const Exercise& exercise = one.exercise;
      if (exercise.given.empty() || exercise.example.empty()) continue;
      for (const std::string factor : {"", "1/3*", "exp(1/7)*"}) {
        const bool is_equation = exercise.kind == Kind::equation;
        const Opinion opinion = judge_answer(
            one, is_equation ? exercise.example + factor.substr(0, 0) + " + " + factor + exercise.pivot
                             : factor + "(" + exercise.example + ")");
        if (!opinion.witness) continue;
        ++witnesses;
        RoughPoint at;
        for (const auto& [name, value] : opinion.witness->at) at[name] = std::stod(value);
        for (const auto& text : exercise.given)
          for (const auto& link : links_of(parse_relation(text, exercise.language()))) {
            const auto names = names_of(link);
            if (!std::ranges::all_of(names, [&](const auto& name) { return at.contains(name); })) continue;
            CHECK_MESSAGE(holds({link}, at), exercise.id, ": ", text, " at ", place_of(*opinion.witness));
          }
      }
    }
  CHECK(witnesses > 3);
}

TEST_CASE("what was read, typed back, is judged the same") {
  int echoes = 0;
  for (const Prepared& one : all_prepared())
    for (const auto& answer : typed_answers(one)) {
      const Opinion opinion = judge_answer(one, answer);
      if (opinion.outcome == Outcome::invalid) continue;
      REQUIRE_MESSAGE(!opinion.read_as.empty(), one.exercise.id, ": ", answer);
      const Opinion again = judge_answer(one, opinion.read_as);
      ++echoes;
      CHECK_MESSAGE(again.outcome == opinion.outcome, one.exercise.id, ": ", answer, " → ", opinion.read_as);
      CHECK_MESSAGE(again.note.word == opinion.note.word, one.exercise.id, ": ", answer, " → ",
                    opinion.read_as);
      CHECK_MESSAGE(again.read_as == opinion.read_as, one.exercise.id, ": ", answer);
    }
  CHECK(echoes > 500);
}

TEST_CASE("of what is suggested for a right answer, one reading is right, and a single one always") {
  int suggestions = 0;
  for (const Prepared& one : all_prepared())
    for (const auto& answer : typed_answers(one)) {
      if (answer.starts_with("2*(") || answer.starts_with("-(") || answer.starts_with("abs(")) continue;
      const Opinion opinion = judge_answer(one, answer);
      if (opinion.outcome != Outcome::invalid) continue;
      const auto texts = suggested(opinion.feedback);
      for (const auto& text : texts) {
        const Opinion again = judge_answer(one, text);
        ++suggestions;
        CHECK_MESSAGE((again.outcome != Outcome::invalid || again.note.word == "symbol_not_given"),
                      one.exercise.id, ": ", answer, " → ", text, " ", again.feedback);
      }
    }
  CHECK(suggestions > 100);
  for (const Prepared& one : all_prepared())
    for (const auto& right : one.exercise.equivalents)
      for (const auto& typed : {std::regex_replace(right, std::regex(R"(\*)"), " "),
                                std::regex_replace(right, std::regex(R"((sin|cos)\((\w+)\)\^2)"), "$1^2($2)"),
                                std::regex_replace(right, std::regex(R"((sin|cos)\((\w+)\))"), "$1 $2"),
                                std::regex_replace(right, std::regex(R"((\d)\.(\d))"), "$1,$2")}) {
        const auto texts = suggested(judge_answer(one, typed).feedback);
        const bool is_right = std::ranges::any_of(
            texts, [&](const auto& text) { return judge_answer(one, text).outcome == Outcome::correct; });
        CHECK_MESSAGE((texts.empty() || is_right), one.exercise.id, ": ", typed, " → ",
                      judge_answer(one, typed).feedback);
      }
}

TEST_CASE("no brace of a template, and no right answer, is in what a student is told") {
  std::size_t texts = 0;
  const auto check = [&](const Prepared& one, const std::string& text, bool may_be_right = false) {
    ++texts;
    CHECK_MESSAGE(text.find_first_of("{}") == std::string::npos, one.exercise.id, ": ", text);
    if (may_be_right || text.find('\n') != std::string::npos) return;
    for (const auto& span : spans(text)) {
      const bool is_formula = one.exercise.kind == Kind::expression || one.exercise.kind == Kind::equation;
      if (is_formula && span.kind == Span::Kind::math)
        CHECK_MESSAGE(judge_answer(one, span.text).outcome != Outcome::correct, one.exercise.id, ": ", text);
    }
  };
  for (int seed = 0; seed < 6; ++seed)
    for (const Prepared& one : all_prepared(seed == 0 ? "" : std::to_string(seed))) {
      const Exercise& exercise = one.exercise;
      check(one, presentation(exercise), true);
      check(one, solution_text(one), true);
      check(one, exercise.title);
      check(one, exercise.name, true);
      for (const auto& hint : exercise.hints) check(one, hint);
      for (const auto& option : exercise.options)
        for (const auto& text : {option.text, option.says, option.hint}) check(one, text, true);
      for (const auto& assumption : exercise.assumptions) check(one, assumption.says);
      for (const auto& slip : exercise.slips) {
        check(one, slip.says);
        check(one, slip.hint);
      }
      if (seed > 0) continue;
      for (const auto& answer : typed_answers(one)) {
        const Opinion opinion = judge_answer(one, answer);
        if (opinion.outcome == Outcome::invalid) continue;
        check(one, opinion.feedback);
        check(one, opinion.hint);
      }
    }
  CHECK(texts > 2000);
  const std::filesystem::path nowhere =
      std::filesystem::temp_directory_path() / "no-such-progress-of-exercises";
  for (const std::string seed : {"", "1", "2", "3", "4"}) {
    const Classroom room{rocking_block::course(), exercises(seed), nowhere};
    std::string page = page_of_exercises(room, {{"lesson-01", "One\n"}});
    page.erase(page.rfind("<script"));
    for (std::size_t at; (at = page.find("<style>")) != std::string::npos;)
      page.erase(at, page.find("</style>", at) - at);
    CHECK_MESSAGE(page.find_first_of("{}") == std::string::npos, page.substr(page.find_first_of("{}"), 200));
  }
}

TEST_CASE("what is said is true of the answer") {
  const auto hint = [](const std::string& id, const std::string& answer) { return judged(id, answer).hint; };
  CHECK(!has(hint("restitution", "1 - 3/2*sin(alpha)"), "unit"));
  CHECK(said("restitution", "sqrt((1-3/2*sin(alpha)^2)^2)").find("small") == std::string::npos);
  CHECK(judged("restitution", "sqrt((1-3/2*sin(alpha)^2)^2)").witness);
  CHECK(said("inertia-about-corner", "2/3*m*R^2") == "A numerical factor is wrong in your answer.");
  CHECK(has(
      said("motion-by-moments", "J_o*thetaddot + m*g*R*sin(alpha-theta) + m*R*u_gddot*sin(alpha-theta) = 0"),
      "in the term $m*R*u_gddot*sin(alpha - theta)$"));
  CHECK(said("frequency-of-a-bookcase", "0.428 Hz") == "Right: 0.428 Hz are 2.69 radians a second.");
  CHECK(has(said("frequency-of-a-bookcase", "2.69 Hz"), "2.69 Hz are 16.9 radians a second"));
  CHECK(has(said("height-of-centre", "R*cos(theta)"), "$alpha$"));
  CHECK(
      said("restitution-of-a-statue", "0,982").starts_with("write decimal fractions with a point: 0.982\n"));
  CHECK(said("half-sine", "sin(psi)*omega_p/p - cos(psi) = e^(-p*(pi-psi)/omega_p)").find("exp(x)") !=
        std::string::npos);
}

TEST_CASE("a quantity is a number with a unit, or a sum with one unit for all or one for each") {
  const auto value = [](const std::string& text) { return parse_quantity(text).value; };
  const auto refused = [](const std::string& text) {
    try {
      return "read as " + parse_quantity(text).read_as;
    } catch (const SyntaxError& error) {
      return error.note;
    }
  };
  CHECK(value("1.5 m - 50 cm") == doctest::Approx(1));
  CHECK(value("3 - 2 m") == doctest::Approx(1));
  CHECK(value("-(1 - 3) cm") == doctest::Approx(0.02));
  CHECK(value("2 m + 3*(1 m - 50 cm)") == doctest::Approx(3.5));
  CHECK(value("3 kg m^2 s^-2") == doctest::Approx(3));
  CHECK(value("1/2 1/s") == doctest::Approx(0.5));
  CHECK(value("2 (m/s)") == doctest::Approx(2));
  CHECK(value("10 × 30 cm") == doctest::Approx(3));
  CHECK(value("pi - 10 %") == doctest::Approx(3.0415926536));
  CHECK(value("sqrt(3)/2 m/s") == doctest::Approx(0.8660254038));
  CHECK(refused("1 m - 1") == "unit");
  CHECK(refused("1 m + 1 s") == "unit");
  CHECK(refused("m/s") == "number_wanted");
  CHECK(refused("pi - 30 deg") == "ambiguous_unit");
  CHECK(refused("2 m/(100 cm - 1 m)") == "undefined");
  CHECK(refused("3 min 20 s") == "implicit_multiplication");
  CHECK(refused("5 apples") == "unknown_unit");
  for (const std::string text : {"1.5 - 1.47 m", "-3 m/s2", "1/2 1/s", "2 m + 3*(1 m - 50 cm)", "30°", "5 %",
                                 "-(1 - 3) cm", "3 kg m^2 s^-2", "9.82 x 10^-1", "-2 m - (3 - 4) m"}) {
    const Quantity once = parse_quantity(text), twice = parse_quantity(once.read_as);
    CHECK_MESSAGE(twice.read_as == once.read_as, text);
    CHECK_MESSAGE(twice.value == once.value, text);
    CHECK_MESSAGE(twice.dimension == once.dimension, text);
    CHECK_MESSAGE(twice.digits == once.digits, text);
  }
}
