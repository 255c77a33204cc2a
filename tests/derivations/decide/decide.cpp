// The verdicts on statements, what they rest on, and the order in which they are found.
#include <doctest/doctest.h>

#include <derivations/decide/decide.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/paper/prove.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>

using namespace rederive::language;
using namespace rederive::decide;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::test;
using Text = std::string;
using Texts = std::vector<std::string>;

namespace {

const Symbols& symbols() {
  static const Symbols table = [] {
    Symbols result;
    for (const auto& [names, range] : {std::pair("xyzt", all_numbers), {"pqm", "(0, inf)"}, {"s", "(0, 1)"}})
      for (const char letter : Text(names)) {
        const Text name(1, letter);
        result.declare({name, name, name, "1", range, "", ""});
      }
    return result;
  }();
  return table;
}

Relation read(const Text& text) {
  const auto unequal = text.find("!=");
  if (unequal == Text::npos) return parse_statement(text, symbols());
  return {{parse(text.substr(0, unequal), symbols()), parse(text.substr(unequal + 2), symbols())}, {"!="}};
}

std::vector<Relation> read(const Texts& texts) {
  std::vector<Relation> relations;
  for (const Text& text : texts) relations.push_back(read(text));
  return relations;
}

Proof decided(const Text& left, const Text& right, const Texts& assumptions = {}) {
  INFO(left << "  |  " << right);
  const Proof proof = decide(read(left), read(right), symbols(), {}, read(assumptions));
  CHECK_FALSE(proof.reason.empty());
  CHECK(proof.witness.has_value() == (proof.verdict == Verdict::refuted));
  CHECK((proof.by == By::nothing) == (proof.verdict == Verdict::undecided));
  return proof;
}

/// The side conditions of a proof, in our syntax.
Texts conditions(const Proof& proof) {
  Texts texts;
  for (const Relation& condition : proof.side_conditions) texts.push_back(print(condition));
  return texts;
}

/// Decides a row that begins with two statements and has its assumptions from the fourth cell on.
Proof decided(const Cells& row) { return decided(row[0], row[1], rest(row, 3)); }

}  // namespace

TEST_CASE("statements have the verdicts that they should have, each by what finds it first") {
  each_case("verdicts", [](const Cells& row) {
    const Proof proof = decided(row);
    const bool says_how = row[2].find(" by ") != Text::npos;
    CHECK(to_string(proof.verdict) + (says_how ? " by " + word_of(proof.by) : "") == row[2]);
  });
  each_case("never", [](const Cells& row) { CHECK(to_string(decided(row).verdict) != row[2]); });
  each_case("factors", [](const Cells& row) { CHECK(decided(row).factor == row[2]); });
}

TEST_CASE("where one side has no value is a side condition, and nothing is said twice") {
  each_case("conditions", [](const Cells& row) {
    CHECK(conditions(decided(row)) == (row[2].empty() ? Texts() : Texts{row[2]}));
  });
}

TEST_CASE("every certificate of signs is an identity, under the signs of its case") {
  std::size_t signs_of_cases = 0;
  each_case("certificates", [&](const Cells& row) {
    const Proof proof = decided(row[0], row[1], rest(row, 2));
    CHECK(proof.by == By::sign);
    CHECK_FALSE(proof.certificate.empty());
    for (const Text& line : proof.certificate) {
      const auto equals = line.find(" = 0"), where = line.find(" where ");
      REQUIRE(equals != Text::npos);
      Texts signs;  // "where u >= 0 and v <= 0"
      for (std::size_t from = where; from != Text::npos; ++signs_of_cases) {
        const auto start = line.find(' ', from + 1) + 1;
        from = line.find(" and ", start);
        signs.push_back(line.substr(start, from - start));
      }
      const Proof replayed = decided(line.substr(0, equals), "0", signs);
      CHECK(replayed.verdict == Verdict::proved);
      CHECK(replayed.by == By::identity);
      CHECK(decided(line.substr(0, equals) + " + 1", "0", signs).verdict == Verdict::refuted);
    }
  });
  CHECK(signs_of_cases > 3);
}

TEST_CASE("what has no value wherever the other side has some is refuted, and the witness says so") {
  each_case("without_value", [](const Cells& row) {
    const Proof proof = decided(row);
    REQUIRE(proof.verdict == Verdict::refuted);
    CHECK(proof.by == By::sign);
    const bool printed = proof.witness->printed == "no value", derived = proof.witness->derived == "no value";
    CHECK(printed != derived);
    if (row[2] != "one") CHECK(printed == (row[2] == "printed"));
  });
}

TEST_CASE("a witness is small, complete and exact, with as many digits as tell its two values apart") {
  const Witness witness = decided("m*x+y", "m*x-y").witness.value();
  CHECK(witness.at.size() == 3);
  CHECK(in_words(witness).size() == 3);
  each_case("digits", [](const Cells& row) {
    const Witness found = decided(row[0], row[1]).witness.value();
    CHECK(found.printed != found.derived);
    CHECK(found.printed.size() == std::stoul(row[2]));
  });
}

TEST_CASE("assumptions contradict each other, or do not") {
  each_case("contradictory", [](const Cells& row) { CHECK(contradict(read(row), symbols())); });
  each_case("consistent", [](const Cells& row) { CHECK_FALSE(contradict(read(row), symbols())); });
}

TEST_CASE("series to an order in a small symbol") {
  each_case("series", [](Text left, Text right, Text order, Text verdict) {
    CHECK(to_string(decide_to_order(read(left), read(right), {"x"}, std::stoi(order), symbols()).verdict) ==
          verdict);
  });
  CHECK(conditions(decide_to_order(read("x/(y+x)"), read("0"), {"x"}, 0, symbols())) == Texts{"y != 0"});
}
