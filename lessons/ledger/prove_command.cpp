#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/bounded.hpp>
#include <derivations/command_line.hpp>
#include <lessons/ledger/prove_command.hpp>
#include <lessons/ledger/report.hpp>

#include <fmt/format.h>

#include <regex>

namespace rederive {

namespace {

const std::vector<std::string> greek{"alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu",
                                     "nu", "xi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta",
                                     "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega"};

void declare_free(Symbols& symbols, const std::string& name) {
  if (symbols.find(name) == nullptr)
    symbols.declare(name, name, name, "1", "(-inf, inf)", "a real number", "");
}

/// Letters stand for real numbers, alone or with an index or dots: x, x1, k_2, omega_0, betadot.
void declare_names_in(const std::string& text, Symbols& symbols) {
  static const std::regex identifier("[A-Za-z_][A-Za-z0-9_]*");
  static const std::regex tail("_?[A-Za-z0-9]{0,3}(_[A-Za-z0-9]{1,3})?|d?dot");
  if (text.size() > Limits{}.characters) return;  // the parser says so
  for (std::sregex_iterator i(text.begin(), text.end(), identifier), none; i != none; ++i) {
    const std::string name = i->str();
    const auto after = text.find_first_not_of(' ', static_cast<std::size_t>(i->position()) + name.size());
    if (name == "pi" || (after != std::string::npos && text[after] == '(')) continue;
    std::size_t stem = name.size() > 1 && (name[1] == '_' || std::isdigit(static_cast<unsigned char>(name[1])) || name.ends_with("dot")) ? 1 : 0;
    for (const std::string& letter : greek)
      if (name.starts_with(letter)) stem = std::max(stem, letter.size());
    if (stem > 0 && std::regex_match(name.substr(stem), tail)) declare_free(symbols, name);
  }
}

/// Narrows a range by one comparison of a symbol with a number.
void narrow(Symbols& symbols, const std::string& name, std::string op, const Tree& bound, bool symbol_on_left) {
  if (!symbol_on_left) op = op == "<" ? ">" : op == "<=" ? ">=" : op == ">" ? "<" : op == ">=" ? "<=" : op;
  const Symbol old = *symbols.find(name);
  Range range = read_range(old.range);
  const bool closed = op.size() == 2, lower_end = op[0] == '>';
  const GiNaC::ex value = lower(bound, symbols);
  const End& present = lower_end ? parse_range(old.range).low : parse_range(old.range).high;
  const int order = present.infinite != 0 ? -1 : (lower_end ? compare(present.value, value) : compare(value, present.value));
  if (order > 0 || (order == 0 && !(lower_end ? range.lower_closed : range.upper_closed))) return;  // nothing new
  (lower_end ? range.lower : range.upper) = print(value, Notation::plain, symbols);
  (lower_end ? range.lower_closed : range.upper_closed) = closed;
  const std::string text = fmt::format("{}{}, {}{}", range.lower_closed ? '[' : '(', range.lower, range.upper, range.upper_closed ? ']' : ')');
  const Interval now = parse_range(text);
  if (now.low.infinite == 0 && now.high.infinite == 0 && compare(now.low.value, now.high.value) >= 0)
    throw BadInput("the assumptions leave no value for " + name);
  symbols.declare(name, old.latex, old.unicode, old.unit, text, old.meaning, old.introduced);
}

template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(explain(error, text));
  }
}

}  // namespace

Context make_context(const ProveRequest& request) {
  Context context{paper_symbols(), {}};
  for (char c = 'a'; c <= 'z'; ++c) declare_free(context.symbols, std::string(1, c));
  for (char c = 'A'; c <= 'Z'; ++c) declare_free(context.symbols, std::string(1, c));
  for (const std::string& letter : greek) declare_free(context.symbols, letter);
  for (const std::string* text : {&request.left, &request.right}) declare_names_in(*text, context.symbols);
  for (const std::string& text : request.assumptions) declare_names_in(text, context.symbols);
  std::vector<Relation> equations;
  for (const std::string& text : request.assumptions) {
    const Relation relation = reading(text, [&] { return parse_relation(text, context.symbols); });
    for (std::size_t k = 0; k < relation.operators.size(); ++k) {
      const Tree &a = relation.sides[k], &b = relation.sides[k + 1];
      const auto is_name = [](const Tree& t) { return t->kind == Node::Kind::symbol && t->text != "pi"; };
      const auto is_number = [&](const Tree& t) {
        return !is_name(t) && GiNaC::is_a<GiNaC::numeric>(reading(text, [&] { return lower(t, context.symbols); }).evalf());
      };
      if (relation.operators[k] == "=" && is_name(a)) equations.push_back(relation);
      else if (relation.operators[k] != "=" && is_name(a) && is_number(b)) narrow(context.symbols, a->text, relation.operators[k], b, true);
      else if (relation.operators[k] != "=" && is_number(a) && is_name(b)) narrow(context.symbols, b->text, relation.operators[k], a, false);
      else throw BadInput("the assumption '" + text + "' does not compare one symbol with numbers; right is, for example, \"x > 0\", \"0 < x < 1\" or \"h = R*cos(alpha)\"");
    }
  }
  for (const Relation& equation : equations)
    context.given.push_back({lower(equation.sides[0], context.symbols), reading("", [&] { return lower(equation.sides[1], context.symbols); })});
  return context;
}

nlohmann::ordered_json decide_bounded(const ProveRequest& request) {
  if (request.order < 0 || request.order > 12 || (request.order > 0) != !request.small.empty())
    throw BadInput("--small and --order (1 to 12) belong together");
  const auto read = [&](const std::string& text, const Symbols& symbols) {
    return reading(text, [&] { return parse_statement(text, symbols); });
  };
  // the child does everything that may be expensive; what it could not read is said here
  const auto work = [&]() -> std::string {
    try {
      const Context context = make_context(request);
      const Relation left = read(request.left, context.symbols), right = read(request.right, context.symbols);
      for (const auto& [text, relation] : {std::pair{&request.left, &left}, std::pair{&request.right, &right}})
        for (const Tree& side : relation->sides) reading(*text, [&] { return lower(side, context.symbols); });
      Proof proof;
      if (request.order > 0) {
        if (!left.operators.empty() || !right.operators.empty()) throw BadInput("--small compares two expressions, not relations");
        for (const std::string& name : request.small)
          if (context.symbols.find(name) == nullptr) throw BadInput("--small names '" + name + "', which is no symbol here");
        proof = prove_approximation(left.sides[0], right.sides[0], request.small, request.order, context.symbols);
      } else {
        proof = prove(left, right, context.symbols);
        if (proof.verdict != Verdict::proved && !context.given.empty()) {
          const Proof under = prove(left, right, context.symbols, context.given);
          if (under.verdict != Verdict::refuted || proof.verdict != Verdict::refuted) proof = under;
          if (proof.verdict == Verdict::proved) proof.verdict = Verdict::proved_under;
        }
      }
      return "J" + to_json(proof).dump();
    } catch (const BadInput& error) {
      return std::string("B") + error.what();
    }
  };
  const Bounded outcome = run_bounded(work, 1.8, 480);
  if (outcome.result && outcome.result->front() == 'B') throw BadInput(outcome.result->substr(1));
  if (outcome.result) return nlohmann::ordered_json::parse(outcome.result->substr(1));
  Proof proof;
  proof.reason = "given up: " + outcome.why;
  return to_json(proof);
}

}  // namespace rederive
