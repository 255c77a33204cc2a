#include <fmt/format.h>

#include <derivations/language/lexer.hpp>
#include <derivations/paper/mutate.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/command_line.hpp>
#include <lessons/ledger/certify_command.hpp>
#include <lessons/ledger/claims.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <lessons/ledger/report.hpp>
#include <lessons/ledger/run_ledger.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive::ledger {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;
using namespace page;

namespace {

struct Options {
  bool json = false;
  Paper paper{.source = ""};
  std::string equations, claims;  ///< files instead of those of the paper
  std::string id, format = "text", table, certificate;
  bool coq = false;
  CertifyOptions scripts;
  unsigned seed = 1;
  ProveRequest request;
};

std::vector<Entry> all(const Options& options) {
  std::vector<Entry> entries;
  for (const Row& row : rows_of(options.paper)) entries.push_back(judge(options.paper, row));
  return entries;
}

const Row& row_with(const std::string& id, const Paper& paper) {
  std::string known;
  for (const Row& row : rows_of(paper)) {
    if (row.id == id) return row;
    if (!id.empty() && row.id.starts_with(id)) known += " " + row.id;
  }
  throw BadInput(
      "there is no equation '" + printable_line(id) + "'" +
      (known.empty() ? "; ledger without a subcommand lists all equations" : "; there is" + known));
}

int exit_code(const std::vector<Entry>& entries) {
  for (const Entry& entry : entries)
    if (entry.proof.verdict != entry.row.expected) return not_as_expected;
  return as_expected;
}

void put(const std::string& text) { std::fputs(text.c_str(), stdout); }
void put(const nlohmann::ordered_json& json) { put(json.dump(2) + "\n"); }

int show_all(const Options& options) {
  const auto entries = all(options);
  if (options.json)
    put(to_json(entries, options.paper));
  else
    put(ledger_table(entries, options.paper.symbols, is_lively(1)));
  return exit_code(entries);
}

int show_one(const Options& options) {
  const Entry entry = judge(options.paper, row_with(options.id, options.paper));
  if (options.coq)
    options.json ? put({{"id", entry.row.id}, {"coq", lemma_page(options.paper, entry)}})
                 : put(lemma_page(options.paper, entry));
  else if (options.json)
    put(to_json(entry));
  else
    put(ledger_page(entry, options.paper.symbols, is_lively(1)));
  return exit_code({entry});
}

nlohmann::ordered_json counts_of(const Mutation& m) {
  return {{"mutants", m.mutants}, {"refuted", m.refuted}, {"equal", m.equal}, {"survived", m.survived}};
}

std::string line_of(const Mutation& m) {
  return fmt::format("{:<6} {:>4} {:<7} {:>4} refuted {:>4} equal {:>4} survived\n", m.id, m.mutants,
                     m.mutants == 1 ? "mutant" : "mutants", m.refuted, m.equal, m.survived);
}

int show_mutation(const Options& options) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  Mutation total;
  total.id = "all";
  bool has_errors = false;
  if (!options.id.empty()) (void)row_with(options.id, options.paper);
  for (const Row& row : rows_of(options.paper)) {
    if (!options.id.empty() && row.id != options.id) continue;
    if (is_lively(2)) fmt::print(stderr, "\r{:<8}", row.id);
    const Mutation m = mutate(options.paper, row, options.seed);
    list.push_back({{"id", m.id}});
    list.back().update(counts_of(m));
    if (!m.error.empty()) {
      has_errors = true;
      list.back()["error"] = m.error;
      fmt::print(stderr, "{}\n", printable_line(m.error));
    }
    total.mutants += m.mutants, total.refuted += m.refuted, total.equal += m.equal,
        total.survived += m.survived;
    if (options.json) continue;
    if (m.mutants > 0) put(line_of(m));
    for (const std::string& text : m.survivors) put("         survived: " + text + "\n");
  }
  if (is_lively(2)) fmt::print(stderr, "\r{:<8}\r", "");
  if (options.json)
    put(nlohmann::ordered_json{{"rows", list}, {"totals", counts_of(total)}});
  else
    put(line_of(total));
  return total.survived == 0 && !has_errors ? as_expected : not_as_expected;
}

int show_proof(const Options& options) {
  const auto json = decide_bounded(options.paper, options.request);
  const std::string verdict = json["verdict"];
  if (options.json) {
    put(json);
  } else {
    put(verdict + "\n");
    for (const char* key : {"factor", "reason", "by"})
      if (json[key].is_string()) put(fmt::format("  {:<16} {}\n", key, json[key].get<std::string>()));
    for (const auto& [key, word] : {std::pair("certificate", "certificate"), {"side_conditions", "if"}})
      for (const auto& text : json[key]) put(fmt::format("  {:<16} {}\n", word, text.get<std::string>()));
    if (!json["witness"].is_null()) {
      for (const auto& words : json["witness"]["in_words"])
        put(fmt::format("  {:<16} {}\n", "witness", words.get<std::string>()));
      put(fmt::format("  {:<16} {}\n  {:<16} {}\n", "left", json["witness"]["printed"].get<std::string>(),
                      "right", json["witness"]["derived"].get<std::string>()));
    }
  }
  if (verdict == to_string(Verdict::refuted)) return not_as_expected;
  return verdict == to_string(Verdict::undecided) ? undecided_or_failed : as_expected;
}

int show_table(const Options& options) {
  const auto rows = decide_table(options.paper, read_table(options.table));
  if (options.json)
    put(to_json(rows));
  else
    put(table_page(rows));
  const bool is_expected = std::all_of(rows.begin(), rows.end(), [](const DecidedRow& decided) {
    return decided.verdict == decided.row.expected;
  });
  return is_expected ? as_expected : not_as_expected;
}

/// The paper. Throws BadInput for what it declares or derives wrongly.
Paper made(const std::function<Paper()>& paper) {
  try {
    return paper();
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
}

/// Reads the rows, of the file that is named if there is one. Throws BadInput for a derivation of the paper
/// that has no row in its own file.
void take_rows(Options& options) {
  Paper& paper = options.paper;
  if (!options.equations.empty()) {
    paper.rows = {};
    paper.rows([&] { return rows_in(paper, options.equations); });
    return;
  }
  const std::vector<Row>& rows = rows_of(paper);
  for (const std::string& id : paper.derivations.ids())
    if (std::ranges::find(rows, row_id(id), &Row::id) == rows.end())
      throw BadInput("a derivation is listed for (" + id + "), but it is not a row of " +
                     equations_file(paper).string() + "; its rows are " +
                     joined(rows, ", ", [](const Row& row) { return row.id; }));
}

/// Returns a symbol's name in ASCII, θ as theta, without blanks around it.
std::string symbol_name(const std::string& text, const Symbols& symbols) {
  const auto tokens = reading(text, symbols, [&] { return tokenize(text, symbols, {}); });
  return tokens.size() == 2 && tokens[0].kind == Token::Kind::name ? tokens[0].text : text;
}

constexpr auto about_proving = R"help(Examples:
  $ PROGRAM prove "sin(3*x)" "3*sin(x) - 4*sin(x)^3"
  $ PROGRAM prove "sqrt(x^2)" "x" --assume "x > 0"
  $ PROGRAM prove "sin(x)" "x - x^3/6" --small x --order 3

To ask whether an inequality holds wherever it has a value, compare it with 0 < 1.

The verdict proved holds without the assumed equations; proved_under needs them. The verdict
approximation is possible with --small: the statements differ, but their series agree. An identity is
proved where both sides are defined. If one side is defined where the other is not, that is a side
condition, and it is listed. The line "by" says what the verdict rests on: identity, sign, points or
expansion.

A witness shows the values of two expressions, or of A and B for y = A and y = B; for other equations
and for inequalities it shows the differences of their sides. In JSON, "at" gives the value of every
symbol: a rational number, or digits. Beside digits, "exactly" gives the constant that they stand for,
or "between" gives rational bounds of a root of the equation "solves". "in_words" says the same in
words.

Exit code: 0 if proved; 1 if refuted; 2 for input that cannot be read or output that cannot be
written; 3 if undecided.
)help";

/// The subcommand `prove`, and those of its arguments that decide what it does.
struct Proving {
  const CLI::App* command;
  const CLI::Option *left, *right, *table, *certificate;
};

Proving add_prove(CLI::App& app, Options& options) {
  CLI::App* proving =
      app.add_subcommand("prove", "Decide whether two expressions, equations or inequalities are the same.");
  auto* lhs = proving->add_option("lhs", options.request.left, "First statement, such as \"sin(2*x)\".");
  auto* rhs =
      proving->add_option("rhs", options.request.right, "Second statement, such as \"2*sin(x)*cos(x)\".");
  auto* assume =
      proving
          ->add_option(
              "--assume", options.request.assumptions,
              "Assume a condition such as \"x > 0\", \"0 < x < 1\", \"b < h\", \"mu > tan(alpha)\", "
              "\"x != y\",\n"
              "\"h = R*cos(alpha)\", \"p^2 = 3*g/(4*R)\" or \"x^2+y^2 = 1\". May be given several times.")
          ->take_all()
          ->allow_extra_args(false)
          ->option_text("TEXT");
  auto* small =
      proving->add_option("--small", options.request.small, "Compare the series in these small symbols.")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->option_text("NAME[,NAME]");
  auto* order = proving
                    ->add_option("--order", options.request.order,
                                 "With --small, compare the series up to this order, from 0 to 12.")
                    ->check(whole_number)
                    ->needs(small);
  proving->add_flag(
      "--generous", options.request.generous,
      "Read what people write: 2x, sin^2 x, \\frac{1}{2}, |x|, 2,5. What has two readings is refused.");
  proving->footer(about_proving);
  auto* table =
      proving
          ->add_option("--table", options.table,
                       "Decide every row of a table, and write a page in Markdown or, with --json, in JSON.")
          ->check(CLI::ExistingFile);
  for (auto* other : {lhs, rhs, assume, small, order}) table->excludes(other);
  auto* certificate =
      proving->add_option("--certificate", options.certificate, "Write the proof as a Coq script.")
          ->check(file_name)
          ->excludes(table)
          ->excludes(small)
          ->option_text("FILE.v");
  return {proving, lhs, rhs, table, certificate};
}

/// The subcommands.
struct Commands {
  const CLI::App *show, *certify, *errata, *claims, *mutate, *graph;
  Proving prove;
};

Commands add_commands(CLI::App& app, Options& options) {
  app.add_flag("--json", options.json, "Write one JSON document to standard output.");
  app.add_option("--equations", options.equations,
                 "Read the rows from this file. Default: the equations.toml of the paper.")
      ->check(CLI::ExistingFile);
  app.fallthrough();
  app.require_subcommand(0, 1);

  auto* show = app.add_subcommand("show", "Show everything about one equation.");
  show->add_option("id", options.id, "Number of the equation, such as 17b.")->required();
  show->add_flag("--coq", options.coq, "Show the equation as a lemma of Coq.");
  auto* certifying =
      app.add_subcommand("certify", "Write the rows as lemmas of Coq, and let Coq check them.");
  certifying->add_option("dir", options.scripts.folder,
                         "Folder for the scripts. It may be left out with --check.");
  certifying->add_option("id", options.scripts.ids, "Only these rows, such as 71 17b. Default: all rows.");
  certifying->add_flag("--check", options.scripts.checks, "Run coqc, and say row by row what passes.");
  auto* sheet = app.add_subcommand("errata", "List the errors of the paper, the most consequential first.");
  sheet->add_option("--format", options.format, "Choose the format of the list. Default: text.")
      ->check(CLI::IsMember({"text", "markdown", "latex", "json"}));
  auto* text =
      app.add_subcommand("claims", "List the numbers and statements of the text, each with what was found.");
  text->add_option("id", options.id, "Only this claim, such as c01. Default: all claims.");
  text->add_option("--claims", options.claims,
                   "Read the claims from this file. Default: the claims.toml of the paper.")
      ->check(CLI::ExistingFile);
  auto* mutation =
      app.add_subcommand("mutate", "Spoil every row on purpose and judge the result; nothing may pass.");
  mutation->add_option("id", options.id, "Only this row, such as 17b. Default: all rows.");
  mutation
      ->add_option("--seed", options.seed,
                   "Choose which slips are tried, by any whole number from 0. Default: 1.")
      ->check(whole_number);
  auto* dot = app.add_subcommand("graph", "Write what follows from what, as a graph in DOT.");
  return {show, certifying, sheet, text, mutation, dot, add_prove(app, options)};
}

/// Does what the command line asks for. Returns the exit code.
int run(const Commands& asked, Options& options, const std::function<Paper()>& paper,
        const std::function<Claims()>& claims) {
  if (*asked.claims) {
    if (!claims) throw BadInput("claims: this paper has no claims; only its equations are judged");
    Claims all = claims();
    if (!options.claims.empty()) all.file = options.claims;
    return show_claims(made(paper), all, options.id, options.json);
  }
  options.paper = made(paper);
  if (!*asked.prove.command) take_rows(options);
  if (*asked.show) return show_one(options);
  if (*asked.mutate) return show_mutation(options);
  if (*asked.prove.command && *asked.prove.table) return show_table(options);
  if (*asked.prove.command && (!*asked.prove.left || !*asked.prove.right))
    throw BadInput("prove needs two statements, for example: prove \"sin(2*x)\" \"2*sin(x)*cos(x)\"");
  for (std::string* text : {&options.request.left, &options.request.right}) *text = trimmed(*text);
  for (std::string& name : options.request.small) name = symbol_name(name, options.paper.symbols);
  if (*asked.prove.certificate)
    return (void)show_proof(options), write_certificate(options.paper, options.request, options.certificate);
  if (*asked.prove.command) return show_proof(options);
  options.scripts.json = options.json;
  if (*asked.certify && options.paper.theorems.empty() && options.scripts.ids.empty())
    for (const Row& row : rows_of(options.paper)) options.scripts.ids.push_back(row.id);
  if (*asked.certify) return certify(options.paper, all(options), options.scripts);
  if (*asked.graph) return put(graph(all(options))), as_expected;
  if (*asked.errata)
    return put(errata(all(options), options.json ? "json" : options.format, options.paper)), as_expected;
  return show_all(options);
}

}  // namespace

int run_ledger(const std::function<Paper()>& paper, int argc, char** argv,
               const std::function<Claims()>& claims) {
  CLI::App app{
      "Compares what a paper prints with what is derived. Without a subcommand, lists every equation with "
      "its verdict."};
  Options options;
  const Commands asked = add_commands(app, options);
  app.footer(
      "Examples:\n"
      "  $ PROGRAM show 1\n"
      "  $ PROGRAM prove \"sin(2*x)\" \"2*sin(x)*cos(x)\"\n"
      "  $ PROGRAM errata --format markdown\n\n");
  return run_command(app, argc, argv, [&] { return run(asked, options, paper, claims); });
}

int run_ledger(const Paper& paper, int argc, char** argv) {
  return run_ledger([&] { return paper; }, argc, argv);
}

}  // namespace rederive::ledger
