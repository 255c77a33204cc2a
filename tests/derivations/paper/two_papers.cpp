// Two papers in one process: the same letters with other units and ranges, each judged as when it is alone.
#include <doctest/doctest.h>

#include <derivations/paper/derivation_file.hpp>
#include <derivations/paper/json.hpp>
#include <derivations/paper/mutate.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/paper/steps.hpp>
#include <derivations/rocking_block/paper.hpp>
#include <nlohmann/json.hpp>
#include <tests/run_program.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::program;
using namespace rederive::paper;
using namespace rederive::rocking_block;

namespace {

Row row(const std::string& id, const std::string& printed, const std::string& domain = "") {
  Row result;
  result.id = id;
  result.printed = printed;
  result.domain = domain;
  return result;
}

/// A paper in which alpha is `unit` in `range`, theta is less than alpha, and size is derived from alpha.
Paper paper_with(const std::string& title, const std::string& unit, const std::string& range) {
  const Symbol alpha{"alpha", "\\alpha", "α", unit, range, "a letter that both papers use", "(1)"},
      theta{"theta", "\\theta", "θ", unit, "(-inf, alpha)", "another one", "(1)"},
      size{"size", "s", "s", unit, "(0, inf)", "a third one", "(1)"};
  Paper paper{.title = title};
  paper.derivations = {
      {"1", [=] { return derived(size, sqrt(pow(alpha, 2)), {in_words("The root of a square")}); }},
      {"2", [=] { return derived(abs(alpha - theta), alpha - theta, {from("1", "Beside #")}); }}};
  paper.declare({theta, alpha, size});
  paper.rows([] {
    return std::vector<Row>{row("1", "size = alpha"), row("2", "fabs(alpha - theta) = alpha - theta")};
  });
  return paper;
}

Paper lengths() { return paper_with("Lengths", "m", "(0, inf)"); }
Paper rates() { return paper_with("Rates", "1/s", "(-inf, 0)"); }

/// All that is found about a row.
std::string found(const Paper& paper, const std::string& id) {
  const Entry entry = judged(paper, id);
  const Mutation spoiled = mutate(paper, row_of(paper, id), 1);
  return to_json(entry).dump() + unit_text(*entry.dimension->dimension) + std::to_string(spoiled.refuted);
}

Verdict proved_in(const Paper& paper, const std::string& left, const std::string& right) {
  return decide(paper, ProveRequest{left, right, {}, {}, {}}).verdict;
}

}  // namespace

TEST_CASE("two papers are judged in turn, each as when it is alone") {
  const Paper &block = rederive::rocking_block::paper(), first = lengths(), second = rates();
  std::map<std::string, std::string> alone;
  for (const char* id : {"1", "2"}) alone[std::string("lengths ") + id] = found(lengths(), id);
  for (const char* id : {"1", "2"}) alone[std::string("rates ") + id] = found(rates(), id);
  const std::string of_the_block = to_json(judged(block, "46b")).dump();
  for (int round = 0; round < 3; ++round)
    for (const char* id : {"1", "2"}) {
      CHECK(found(first, id) == alone[std::string("lengths ") + id]);
      CHECK(found(second, id) == alone[std::string("rates ") + id]);
      CHECK(to_json(judged(block, "46b")).dump() == of_the_block);
    }
  CHECK(judged(first, "1").proof.verdict == Verdict::proved);
  CHECK(judged(second, "1").proof.verdict == Verdict::refuted);
  CHECK(judged(second, "1").correction == "size = -alpha");
  CHECK(judged(first, "2").proof.verdict == Verdict::proved);
  CHECK(judged(second, "2").proof.verdict == Verdict::proved);
  CHECK(judged(second, "2").derivation->steps[0].says == "Beside (1)");
  CHECK(unit_text(*judged(first, "1").dimension->dimension) == "m");
  CHECK(unit_text(*judged(second, "1").dimension->dimension) == "1/s");
}

TEST_CASE("each paper has its own ranges, and no paper has the letters of another") {
  const Paper first = lengths(), second = rates();
  for (int round = 0; round < 2; ++round) {
    CHECK(proved_in(first, "sqrt(alpha^2)", "alpha") == Verdict::proved);
    CHECK(proved_in(second, "sqrt(alpha^2)", "-alpha") == Verdict::proved);
    CHECK(proved_in(first, "sqrt(alpha^2)", "-alpha") == Verdict::refuted);
    CHECK(proved_in(first, "fabs(theta - alpha)", "alpha - theta") == Verdict::proved);
    CHECK(proved_in(rederive::rocking_block::paper(), "cos(alpha)", "fabs(cos(alpha))") == Verdict::proved);
    CHECK(proved_in(first, "cos(alpha)", "fabs(cos(alpha))") == Verdict::refuted);
    CHECK(proved_in(rederive::rocking_block::paper(), "sqrt(p^2)", "p") == Verdict::proved);
    CHECK(proved_in(first, "sqrt(p^2)", "p") == Verdict::refuted);  // any real number there
  }
  CHECK(first.symbols.find("theta_0") == nullptr);
  CHECK_THROWS_AS(parse("thetadot_0", first.symbols), SyntaxError);
}

TEST_CASE("a step that names a constant of its own travels as words, and others as formulas") {
  Symbols symbols;
  const Symbol& x = symbols.declare({"x", "x", "x", "1", "(0, inf)", "a letter", "(1)"});
  Derivations rows;
  rows.add("1", [x] { return derived(x, 2, {{"with", GiNaC::symbol("C_1"), x}, {"and", x, 1 + x}}); });
  const TemporaryFolder folder;
  std::ofstream(folder.path / "derivations.json") << derivations_text(rows, symbols, "");
  const Derivation read = read_derivations(folder.path / "derivations.json", symbols).at("1");
  REQUIRE(read.steps.size() == 3);
  CHECK(read.steps[0].says == "with C_1 = x");
  CHECK(read.steps[0].left.is_zero());
  CHECK(read.steps[1].left.is_equal(x));
}
