// Every witness is put to the test by the evaluator alone: it is exact, complete, and tells the two apart.
#include <doctest/doctest.h>

#include <algorithm>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <nlohmann/json.hpp>
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
  Point point;  ///< what is rational, and the zero between bounds to 80 places
  std::vector<std::pair<std::string, Tree>> exactly;

  Tree operator()(Tree tree) const {
    for (const auto& [name, value] : exactly) tree = with(tree, name, value);
    return tree;
  }
  std::optional<cln::cl_R> value(const Tree& tree) const { return value_of((*this)(tree), point); }
};

int sign_beside(const Tree& tree, Point point, const std::string& name, const cln::cl_RA& at) {
  point[name] = at;
  const auto value = evaluate(tree, point, 3);
  REQUIRE(value);
  return cln::zerop(*value) ? 0 : cln::minusp(*value) ? -1 : 1;
}

/// Halves the bounds until 80 places are known. There must be opposite signs at the bounds, and values
/// between them.
cln::cl_RA zero_of(const Tree& tree, const Point& point, const std::string& name, Between bounds) {
  CHECK(enclosure(tree, point, {{name, bounds}}));
  const int below = sign_beside(tree, point, name, bounds.low);
  CHECK(below * sign_beside(tree, point, name, bounds.high) == -1);
  while ((bounds.high - bounds.low) * power_of_ten(80) > 1) {
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
void check_difference(const ProveRequest& request, const Put& at, const Symbols& symbols) {
  const Relation left = parse_statement(request.left, symbols),
                 right = parse_statement(request.right, symbols);
  if (left.operators.empty()) {
    const auto value = at.value(left.sides[0]), other = at.value(right.sides[0]);
    REQUIRE(value);
    REQUIRE(other);
    CHECK(cln::abs(*value - *other) * power_of_ten(60) > cln::abs(*value));
  } else {
    const auto first = holds(at, left), second = holds(at, right);
    REQUIRE(first);
    REQUIRE(second);
    CHECK(*first != *second);
  }
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
    const Proof proof = decide(row.request);
    REQUIRE(proof.witness);
    const Symbols symbols = make_context(row.request).symbols;
    std::set<std::string> names;
    for (const std::string* text : {&row.request.left, &row.request.right}) names_in(*text, symbols, names);
    for (const std::string& text : row.request.assumptions)
      if (text.find("!=") == std::string::npos) names_in(text, symbols, names);
    for (const std::string& name : names) CHECK_MESSAGE(proof.witness->at.contains(name), name);
    const Put at = put(*proof.witness, symbols);
    for (const std::string& text : row.request.assumptions) check_assumption(text, at, symbols);
    if (row.request.order == 0) check_difference(row.request, at, symbols), ++looked_at;
  }
  CHECK(looked_at > 250);
}

TEST_CASE("a root that has no other name is between short bounds, with the equation that it solves") {
  const auto w = witness_of({"y = cos(y)", "y = x"});
  INFO(w.dump());
  CHECK(w["printed"] != w["derived"]);
}
