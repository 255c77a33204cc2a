// What a judgement says, in words that every format shares.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>

namespace rederive::page {
using namespace language;
using namespace decide;
using namespace mechanics;
using namespace paper;
namespace {

/// Returns "0.123456789…" with six significant digits: enough to see that two numbers differ, short enough to
/// read.
std::string shortened(const std::string& digits) {
  try {
    const double value = std::stod(digits);
    return std::abs(value) < 1e-20 ? "0" : fmt::format("{:.6g}", value);
  } catch (const std::exception&) {
    return digits;  // not a plain number: leave it as the ledger wrote it
  }
}

/// Returns "123…/456…" with six digits.
std::string approximately(const std::string& fraction) {
  const std::size_t bar = fraction.find('/');
  const double under = bar == std::string::npos ? 1 : std::stod(fraction.substr(bar + 1));
  return fmt::format("{:.6f}", std::stod(fraction.substr(0, bar)) / under);
}

/// Returns a value that is short enough to work with by hand: "$x = 2/5$", "$x = pi/6$"; otherwise "$x$ ≈
/// 0.5236". The ledger has the long values.
std::string value_sentence(const Witness& witness, const std::string& symbol, const std::string& value) {
  const auto exactly = witness.exactly.find(symbol);
  const std::string& text = exactly == witness.exactly.end() ? value : exactly->second;
  if (text.size() <= 20 && !witness.between.contains(symbol)) return fmt::format("${} = {}$", symbol, text);
  return fmt::format("${}$ ≈ {}", symbol, approximately(value));
}

std::string witness_sentence(const Witness& witness) {
  const std::string at = joined(witness.at, ", ", [&](const auto& value) {
    return value_sentence(witness, value.first, value.second);
  });
  const std::string printed = shortened(witness.printed), derived = shortened(witness.derived);
  const bool differ = printed != derived;  // six digits may not tell the two apart
  return fmt::format("at {} the printed form comes to {}, the derived one to {}", at,
                     differ ? printed : witness.printed, differ ? derived : witness.derived);
}

/// Returns w != 0 as "$w$ ≠ $0$", because the notation of formulas has no ≠, and w > 0 as "$w > 0$".
std::string condition_text(const Relation& condition) {
  if (condition.operators[0] != "!=") return "$" + print(condition) + "$";
  return "$" + print(condition.sides[0]) + "$ ≠ $" + print(condition.sides[1]) + "$";
}

}  // namespace

std::string headline(const Entry& entry) {
  std::string text = fmt::format("({}): {}", entry.row.id, to_string(entry.proof.verdict));
  if (entry.proof.verdict == Verdict::refuted && !entry.row.errors.empty())
    text += " (" + in_words(entry.row.errors) + ")";
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::vector<Remark> printed_remarks(const Row& row, const Symbols& symbols) {
  if (row.printed.empty()) return {};
  const Relation relation = parse_statement(row.printed, symbols);
  if (row.typed.empty()) return {{.label = "printed", .formula = relation}};
  return {{.label = "printed", .words = "`" + literal(row.typed) + "`"},
          {.label = "worked out", .formula = relation}};
}

Findings findings(const Entry& entry, const Paper& paper) {
  Findings result{.headline = "The ledger on " + headline(entry),
                  .lines = {},
                  .kind = "ledger " + to_string(entry.proof.verdict),
                  .row = entry.row.id};
  const auto formula = [&](const std::string& label, const std::string& text) {
    if (!text.empty())
      result.lines.push_back({.label = label, .formula = parse_statement(text, paper.symbols)});
  };
  const auto words = [&](const std::string& label, const std::string& text) {
    if (!text.empty()) result.lines.push_back({.label = label, .words = text});
  };
  if (!entry.row.fault.empty()) {
    words("why", literal(entry.row.fault));
    return result;
  }
  result.lines = printed_remarks(entry.row, paper.symbols);
  formula("correct", entry.correction);
  const std::string& factor = entry.proof.factor;
  if (!factor.empty() && factor != "1") formula("up to the factor", factor);
  words("provided that", joined(entry.proof.side_conditions, ", ", condition_text));
  if (entry.derivation) words("assuming that", marked(entry.derivation->assumption, paper));
  if (entry.derivation && entry.proof.verdict == Verdict::approximation)
    words("approximation",
          marked(fmt::format("to order {} in {}", entry.derivation->order, entry.derivation->small), paper));
  if (entry.proof.witness) words("witness", witness_sentence(*entry.proof.witness));
  if (entry.dimension && !entry.dimension->consistent)
    words("dimensions", marked(entry.dimension->explanation, paper));
  if (entry.proof.verdict == Verdict::undecided) words("why", marked(entry.proof.reason, paper));
  words("consequence", entry.proof.verdict == Verdict::refuted ? marked(entry.row.consequence, paper) : "");
  words("text repaired", marked(entry.row.scan_repaired, paper));
  return result;
}

}  // namespace rederive::page
