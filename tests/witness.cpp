// Every witness is put to the test by the evaluator alone: it is exact, complete, and tells the two apart.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <nlohmann/json.hpp>
#include <random>
#include <tests/run_program.hpp>

using namespace rederive;

namespace {

Tree with(const Tree& tree, const std::string& name, const Tree& value) {
  if (tree->kind == Node::Kind::symbol && tree->text == name) return value;
  Node node = *tree;
  for (Tree& child : node.children) child = with(child, name, value);
  return std::make_shared<const Node>(std::move(node));
}

/// A witness, as it can be put into a text.
struct Put {
  Point point;  ///< what is rational, and the zero between bounds to 110 places
  std::vector<std::pair<std::string, Tree>> exactly;

  Tree operator()(Tree tree) const {
    for (const auto& [name, value] : exactly) tree = with(tree, name, value);
    return tree;
  }
  bool has(const std::string& name) const {
    return point.contains(name) || std::any_of(exactly.begin(), exactly.end(),
                                               [&](const auto& known) { return known.first == name; });
  }
  std::optional<cln::cl_R> value(const Tree& tree) const { return value_of((*this)(tree), point); }
};

int sign_beside(const Tree& tree, Point point, const std::string& name, const cln::cl_RA& at) {
  point[name] = at;
  const auto value = evaluate(tree, point, 3);
  REQUIRE(value);
  return cln::zerop(*value) ? 0 : cln::minusp(*value) ? -1 : 1;
}

/// Halves the bounds until 110 places are known. There must be opposite signs at the bounds, and values
/// between them.
cln::cl_RA zero_of(const Tree& tree, const Point& point, const std::string& name, Between bounds) {
  CHECK(enclosure(tree, point, {{name, bounds}}));
  const int below = sign_beside(tree, point, name, bounds.low);
  CHECK(below * sign_beside(tree, point, name, bounds.high) == -1);
  while ((bounds.high - bounds.low) * power_of_ten(110) > 1) {
    const cln::cl_RA middle = (bounds.low + bounds.high) / 2;
    (sign_beside(tree, point, name, middle) == below ? bounds.low : bounds.high) = middle;
  }
  return bounds.low;
}

Put put(const Witness& witness, const Symbols& symbols) {
  Put result;
  for (const auto& [name, text] : witness.at)
    if (const auto exactly = witness.exactly.find(name); exactly != witness.exactly.end())
      result.exactly.emplace_back(name, parse(exactly->second, symbols));
    else
      result.point[name] = cln::cl_RA(text.c_str());
  for (const auto& [name, bounds] : witness.between) {
    const Relation equation = parse_relation(witness.solves, symbols);
    result.point[name] = zero_of(result(equation.sides[0]), result.point, name, bounds);
  }
  return result;
}

/// Whether the two sides are the same, to 60 places; where they differ, by more than 1e-50 of their size.
std::optional<int> compare(const Put& at, const Tree& a, const Tree& b) {
  const auto left = at.value(a), right = at.value(b);
  if (!left || !right) return std::nullopt;
  const cln::cl_R size = cln::max(cln::cl_R(1), cln::max(cln::abs(*left), cln::abs(*right)));
  if (cln::abs(*left - *right) * power_of_ten(60) < size) return 0;
  return *left < *right ? -1 : 1;
}

std::optional<bool> holds(const Put& at, const Relation& relation) {
  bool all = true;
  for (std::size_t k = 0; k < relation.operators.size(); ++k) {
    const auto order = compare(at, relation.sides[k], relation.sides[k + 1]);
    if (!order) return std::nullopt;
    const std::string& op = relation.operators[k];
    const bool equal_will_do = op != "<" && op != ">";
    all = all && (*order == 0 ? equal_will_do : op[0] == (*order < 0 ? '<' : '>'));
  }
  return all;
}

void names_in(const std::string& text, const Symbols& symbols, std::set<std::string>& names) {
  for (const Tree& side : parse_statement(text, symbols).sides) collect_names(side, names);
}

void check_assumption(const std::string& text, const Put& at, const Symbols& symbols) {
  INFO("assumed: " << text);
  std::set<std::string> names;
  names_in(text.substr(0, text.find('!')), symbols, names);
  if (std::none_of(names.begin(), names.end(), [&](const std::string& name) { return at.has(name); })) return;
  const auto sign = text.find("!=");
  if (sign == std::string::npos) {
    CHECK(holds(at, parse_relation(text, symbols)).value_or(false));
  } else {
    const auto order =
        compare(at, parse(text.substr(0, sign), symbols), parse(text.substr(sign + 2), symbols));
    CHECK(order.value_or(0) != 0);
  }
}

/// What can be said of two statements at the witness: they are not the same there.
void check_difference(const Relation& left, const Relation& right, const Put& at) {
  if (left.operators.empty()) {
    CHECK(compare(at, left.sides[0], right.sides[0]).value_or(0) != 0);
  } else {
    const auto first = holds(at, left), second = holds(at, right);
    REQUIRE(first);
    REQUIRE(second);
    CHECK(*first != *second);
  }
}

/// The numbers that are shown are values there: of a side, or of a difference of two, which may be 0.
bool is_shown(const std::string& shown, const Put& at, const Relation& left, const Relation& right) {
  std::vector<cln::cl_R> values;
  for (const Relation& statement : {left, right}) {
    std::optional<cln::cl_R> before;
    for (const Tree& side : statement.sides) {
      const auto value = at.value(side);
      if (!value) continue;
      values.push_back(*value);
      if (before) values.push_back(*value - *before), values.push_back(*before - *value);
      if (!before || statement.operators[0] != "=") before = value;
    }
  }
  const cln::cl_R number = evaluate(parse(shown, Symbols(), {.digits = 300}), {}, 80).value();
  return std::any_of(values.begin(), values.end(), [&](const cln::cl_R& value) {
    if (cln::zerop(number)) return cln::abs(value) * power_of_ten(60) < 1;
    return cln::abs(number - value) * power_of_ten(29) <= cln::abs(number);
  });
}

void check(const Witness& witness, const Relation& left, const Relation& right, const Put& at) {
  check_difference(left, right, at);
  CHECK_MESSAGE(is_shown(witness.printed, at, left, right), witness.printed);
  CHECK_MESSAGE(is_shown(witness.derived, at, left, right), witness.derived);
}

Witness read(const nlohmann::ordered_json& json) {
  const auto number = [](const std::string& text) {
    return cln::rational(evaluate(parse(text, Symbols(), {.digits = 300}), {}, 80).value());
  };
  Witness witness{json.at("at"), json.at("printed"), json.at("derived")};
  if (json.contains("exactly")) witness.exactly = json.at("exactly");
  if (!json.contains("between")) return witness;
  witness.solves = json.at("solves");
  for (const auto& [name, bounds] : json.at("between").items())
    witness.between[name] = {number(bounds.at(0)), number(bounds.at(1))};
  return witness;
}

/// The symbols of that case of what is assumed that the witness is in; of the first one, if it is in none.
Symbols symbols_of(const Witness& witness, const ProveRequest& request) {
  const std::vector<Case> cases = cases_of(request);
  const auto is_in = [&](const Case& one) {
    return std::all_of(witness.at.begin(), witness.at.end(), [&](const auto& name_and_value) {
      return is_inside(one.context.symbols.find(name_and_value.first)->range,
                       cln::cl_RA(name_and_value.second.c_str()));
    });
  };
  const auto found = std::find_if(cases.begin(), cases.end(), is_in);
  return (found == cases.end() ? cases.front() : *found).context.symbols;
}

/// All that can be asked of a witness: that it is complete, in all ranges, keeps to what is assumed, and
/// tells the two apart. Of an approximation polynomials are compared.
void check(const Witness& witness, const ProveRequest& request) {
  const Symbols symbols = symbols_of(witness, request);
  std::set<std::string> names;
  for (const std::string* text : {&request.left, &request.right}) names_in(*text, symbols, names);
  for (const std::string& text : request.assumptions)
    if (text.find_first_of("!<>") == std::string::npos) names_in(text, symbols, names);
  for (const std::string& name : names) CHECK_MESSAGE(witness.at.contains(name), name);
  const Put at = put(witness, symbols);
  for (const auto& [name, text] : witness.at)
    CHECK(is_inside(symbols.find(name)->range, at.value(parse(name, symbols)).value()));
  for (const std::string& text : request.assumptions) check_assumption(text, at, symbols);
  if (!request.order)
    check(witness, parse_statement(request.left, symbols), parse_statement(request.right, symbols), at);
}

nlohmann::json witness_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "prove");
  arguments.push_back("--json");
  const Result r = run_program("ledger", arguments);
  CHECK(r.exit_code == 1);
  return nlohmann::json::parse(r.out)["witness"];
}

}  // namespace

TEST_CASE("at every witness of the table one statement holds and the other does not") {
  int looked_at = 0;
  for (const TableRow& row : read_table(std::string(REDERIVE_SOURCE) + "/tests/prove_table.toml")) {
    if (row.expected != "refuted") continue;
    INFO(row.request.left << "  |  " << row.request.right);
    const Proof proof = decide(row.request).proof;
    REQUIRE(proof.witness);
    check(*proof.witness, row.request);
    ++looked_at;
  }
  CHECK(looked_at > 250);
}

TEST_CASE("so it is where statements that have roots without a name are put against each other") {
  const std::vector<std::string> statements{
      "x*exp(x) = y",    "cos(x) = x",      "x^5-x-1 = 0",      "y*exp(y)+x = 0",    "tan(x) = 2*x",
      "b*exp(h) = 2",    "h^3 = b+1",       "sin(alpha) = p/3", "x = y = exp(-z)",   "x < exp(-x)",
      "x^3 >= 3",        "b < cos(b*h)",    "p^2 = 5",          "x = 1/3",           "R = exp(-R*alpha)",
      "alpha = cos(p)",  "sqrt(x) = 1/2-x", "log(x)+x = 0",     "(x-exp(-x))^2 = 0", "(x^3-2)^2 <= 0",
      "0 < x*e^x <= 1",  "b+h = 3",         "R*p^2 = g*alpha",  "x*y = 1",           "atan(x) = y*x-1/2",
      "0 < x < -1/10^50"};
  const std::vector<std::vector<std::string>> assumptions{{},
                                                          {"b < h"},
                                                          {"b = R*sin(alpha)", "h = R*cos(alpha)"},
                                                          {"p = sqrt(3*g/(4*R))"},
                                                          {"x != y"},
                                                          {"y = x*sin(x)"},
                                                          {"b < h", "h < R"},
                                                          {"0 < x <= 2", "p = x+1"},
                                                          {"R = sqrt(b^2+h^2)", "b < h"}};
  std::mt19937 random(20);
  const auto one_of = [&](const auto& list) { return list[random() % list.size()]; };
  int refuted = 0, between = 0;
  for (int k = 0; k < 400; ++k) {
    const ProveRequest request{one_of(statements), one_of(statements), one_of(assumptions), {}, {}};
    INFO(request.left << "  |  " << request.right);
    const auto json = decide_bounded(request).proof;
    if (json["verdict"] != "refuted") continue;
    check(read(json["witness"]), request);
    ++refuted, between += json["witness"].contains("between");
  }
  CHECK(refuted > 300);
  CHECK(between > 50);
}

TEST_CASE("so it is at the witness of every row of the paper that is refuted") {
  int looked_at = 0;
  const std::vector<Row> rows = read_rows(equations_file());
  for (const Row& row : rows) {
    if (row.expected != "refuted") continue;
    INFO(row.id << "  " << row.claim());
    const Entry entry = judge(row, rows);
    REQUIRE(entry.proof.witness);
    const Symbols symbols = symbols_in(row.domain);
    const Put at = put(*entry.proof.witness, symbols);
    for (const Given& given : entry.derivation->given)
      CHECK(compare(at, to_tree(given.name, symbols), to_tree(given.value, symbols)) == 0);
    check(*entry.proof.witness, parse_statement(row.claim(), symbols), derived_relation(*entry.derivation),
          at);
    ++looked_at;
  }
  CHECK(looked_at > 7);
}

TEST_CASE("a root that has no other name is between short bounds, with the equation that it solves") {
  const auto w = witness_of({"x = 1", "x*exp(x) = 1"});
  CHECK(w.at("between") == nlohmann::json{{"x", {"0.567", "0.568"}}});
  CHECK(w.at("solves") == "x*exp(x) - 1 = 0");
  CHECK(w.at("in_words") == nlohmann::json{"x between 0.567 and 0.568 where x*exp(x) - 1 = 0"});
  CHECK(w.at("printed") == "-0.432856709590216127000031337790");  // Ω - 1
  CHECK(w.at("derived") == "0");
  CHECK_FALSE(w.contains("exactly"));
}

TEST_CASE("a root that can be named is named") {
  CHECK(witness_of({"x = 1", "x^3 = 2"}).at("exactly").at("x") == "2^(1/3)");
  CHECK(witness_of({"asin(x) = y", "x = sin(y)"}).at("exactly").at("x") == "-sin(2)");
  CHECK(witness_of({"x = 1", "x = 2"}).contains("exactly") == false);
}

TEST_CASE("bounds of a difference that is assumed positive are bounds of the greater one") {
  const auto w = witness_of({"b = 3", "h - b = cos(h - b)", "--assume", "b < h"});
  REQUIRE(w.at("between").contains("h"));
  CHECK(w.at("solves") == "h - b - cos(h - b) = 0");
  CHECK(w.at("at").size() == 2);
}

TEST_CASE("symbols that equations replace are said, too") {
  const auto w = witness_of({"p^2 = g/R", "g = 2", "--assume", "p = sqrt(3*g/(4*R))"});
  CHECK(w.at("exactly").at("p") == "1/2*sqrt(3)*sqrt(5)");
  CHECK(w.at("at").at("p").get<std::string>().find('/') != std::string::npos);
  const auto rational = witness_of({"m*R^2/3 + m*R^2", "J_o", "--assume", "J_o = 2*m*R^2/3"});
  CHECK(rational.at("at").contains("J_o"));
  CHECK_FALSE(rational.contains("exactly"));
}
