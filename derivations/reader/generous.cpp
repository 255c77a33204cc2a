// Reads tokens generously by recursive descent. Where a text has several readings, each kind of doubt is a
// choice; the text is read once for every combination of the choices that it asks for.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <derivations/language/functions.hpp>
#include <derivations/language/lexer.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/language/text.hpp>
#include <derivations/reader/generous.hpp>
#include <derivations/reader/spelling.hpp>
#include <functional>
#include <optional>
#include <set>
#include <utility>

namespace rederive::reader {
using namespace language;

namespace {
using Kind = Node::Kind;
using Is = Token::Kind;
using Tokens = std::vector<Token>;

/// What may be read in two ways: as the first answer, or as the second.
enum class Doubt {
  divisor,      ///< a/b c: (a/b)*c, or a/(b*c)
  argument,     ///< sin x y: sin(x*y), or sin(x)*y
  functions,    ///< sin a cos b: sin(a)*cos(b), or sin(a*cos(b))
  sum,          ///< sin a - b: sin(a) - b, or sin(a - b)
  power,        ///< sin x^2: sin(x^2), or sin(x)^2
  quotient,     ///< sin x/2: sin(x)/2, or sin(x/2)
  mixed,        ///< 1 1/3: 1 + 1/3, or 1*1/3
  exponential,  ///< e^(p*t): exp(p*t), or the power of a symbol e
  exponent      ///< e^-p t: exp(-p)*t, or exp(-p*t)
};
constexpr unsigned doubts = 9;
constexpr std::string_view reasons[] = {"what is below the fraction line",
                                        "where the argument of a function ends",
                                        "where the argument of a function ends",
                                        "where the argument of a function ends",
                                        "whether the power is of the function or of its argument",
                                        "where the argument of a function ends",
                                        "whether this is a mixed number or a product",
                                        "whether e is the base of exp or the symbol e",
                                        "where the exponent ends"};

bool is_known(const std::string& name, const Symbols& symbols) {
  return name == "pi" || symbols.find(name) != nullptr;
}

/// Returns the name of a function as we write it; "" if it is none.
std::string function_of(const std::string& name) {
  if (is_function(name)) return name;
  const std::string lower = lower_case(name), elsewhere = function_elsewhere(name);
  if (is_function(lower)) return lower;
  return elsewhere.find('(') == std::string::npos ? elsewhere : "";
}

/// Returns the name in ASCII of what a symbol is displayed as: alpha_p for α_p.
std::string in_ascii(const std::string& displayed) {
  std::string name;
  for (std::size_t at = 0, bytes = 1; at < displayed.size() && bytes > 0; at += bytes) {
    const CodePoint point = first_character(std::string_view(displayed).substr(at));
    bytes = point.bytes;
    const std::string greek = greek_name(point.code);
    if (greek.empty() && point.code >= 0x80) return {};
    name += greek.empty() ? displayed.substr(at, bytes) : greek;
  }
  return name;
}

/// Returns whether a cut before this byte parts a letter from its dots or its bar, which decoding wrote as
/// words.
bool parts_a_mark(std::string_view name, std::size_t cut) {
  for (const std::string_view mark : {"ddot", "dot", "bar"})
    for (std::size_t at = name.find(mark); at != name.npos; at = name.find(mark, at + 1))
      if (cut >= at && cut < at + mark.size()) return true;
  return false;
}

/// Turns names that are not known into the names and numbers of which they consist.
class Words {
 public:
  explicit Words(const Vocabulary& reader) : symbols_(reader.symbols), units_(reader.units) {
    for (const auto& [name, symbol] : symbols_.table())
      if (const std::string ascii = in_ascii(symbol.unicode);
          !ascii.empty() && symbols_.find(ascii) == nullptr)
        displayed_.emplace(ascii, name);
  }

  /// Returns the words; the name alone if it has none, or may be misspelt.
  std::vector<std::string> of(const std::string& name, std::string_view typed) const {
    const bool has_marks = std::ranges::any_of(typed, [](char c) { return (c & 0x80) != 0; });
    if (const std::string known = word(name); !known.empty()) return {known};
    if (name.size() > longest_name) return {name};
    std::vector<std::vector<std::string>> best(name.size() + 1);  // of the first bytes of the name
    for (std::size_t end = 1; end <= name.size(); ++end)
      for (std::size_t start = 0; start < end; ++start) {
        if (has_marks && parts_a_mark(name, start)) continue;
        const std::string part = name.substr(start, end - start);
        const bool is_after_function =
            start > 0 && !best[start].empty() && !function_of(best[start].back()).empty();
        const bool is_number = part.find_first_not_of("0123456789") == std::string::npos;
        const bool is_power =
            units_ && is_number && part.size() == 1 && part[0] > '1' && start > 0 && end == name.size();
        std::string known = word(part);
        if (is_number) known = is_after_function ? part : is_power ? "^" + part : "";
        if (known.empty() || (start > 0 && best[start].empty())) continue;
        std::vector<std::string> words = best[start];
        words.push_back(known);
        if (best[end].empty() || words.size() < best[end].size()) best[end] = words;
      }
    const auto& words = best.back();
    const auto is_long = [&](const std::string& w) { return !function_of(w).empty() || w[0] == '^'; };
    const bool may_be_misspelt = typed.size() > 3 && !has_marks && !units_ &&
                                 std::ranges::none_of(words, is_long) && !nearest_to(name).empty();
    const bool is_refused = words.empty() || may_be_misspelt || (units_ && words.size() > 2);
    return is_refused ? std::vector{name} : words;
  }

 private:
  std::string word(const std::string& part) const {
    if (is_known(part, symbols_)) return part;
    if (part == "deg" || part == "percent") return part;
    for (const std::string rate : {"ddot_", "dot_"})  // u with two dots and an index is u_gddot
      if (const std::size_t at = part.find(rate); at != std::string::npos && at > 0) {
        const std::string moved =
            part.substr(0, at) + part.substr(at + rate.size() - 1) + rate.substr(0, rate.size() - 1);
        if (is_known(moved, symbols_)) return moved;
      }
    const auto found = displayed_.find(part);
    if (found != displayed_.end()) return found->second;
    return function_of(part);
  }
  std::string nearest_to(const std::string& name) const { return nearest(name, symbols_.names()); }

  const Symbols& symbols_;
  bool units_;
  std::map<std::string, std::string> displayed_;
};

/// Returns the tokens with the words of unknown names in their place.
Tokens with_words(const Tokens& tokens, const Vocabulary& reader, std::string_view text) {
  const Words words(reader);
  Tokens result;
  for (const Token& token : tokens) {
    const bool is_split = token.kind == Is::name && token.text != "e";
    if (!is_split) {
      result.push_back(token);
      continue;
    }
    const std::string_view typed = text.substr(token.position, token.end - token.position);
    for (const std::string& word : words.of(token.text, typed)) {
      Token part = token;
      part.text = word;
      if (word[0] == '^') part = {Is::superscript, word.substr(1), token.position, token.end};
      if (word[0] >= '0' && word[0] <= '9') part.kind = Is::number;
      if (!result.empty() && result.back().position == token.position) part.position = part.end;
      result.push_back(part);
      if (word.size() < token.text.size()) result.back().end = token.end;
    }
  }
  return result;
}

class Generous {
 public:
  Generous(const Tokens& tokens, std::string_view text, const Vocabulary& reader, const Limits& limits,
           unsigned chosen)
      : tokens_(tokens), text_(text), reader_(reader), limits_(limits), chosen_(chosen) {}

  unsigned asked = 0;  ///< a bit for each doubt that was met

  Relation statement() {
    if (now().kind == Is::end) refuse(Mistake::empty, "there is no formula here");
    Relation relation;
    relation.sides.push_back(sum());
    while (now().kind == Is::relation) {
      relation.operators.push_back(take().text);
      relation.sides.push_back(sum());
    }
    if (now().is(")")) refuse(Mistake::syntax, "this parenthesis closes nothing");
    if (now().is(",")) refuse(Mistake::syntax, "a comma is only allowed between the arguments of a function");
    if (now().kind != Is::end) refuse(Mistake::implicit_multiplication, "the sign before this is missing");
    return relation;
  }

 private:
  const Token& now(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, tokens_.size() - 1)]; }
  const Token& take() { return tokens_[at_++]; }
  bool take_if(std::string_view mark) { return now().is(mark) && ++at_ > 0; }
  [[noreturn]] void refuse(Mistake mistake, const std::string& message, const Token& where) const {
    throw SyntaxError(mistake, where.position, message);
  }
  [[noreturn]] void refuse(Mistake mistake, const std::string& message) const {
    refuse(mistake, message, now());
  }
  std::string quoted(const Token& token) const {
    return "'" + std::string(text_.substr(token.position, token.end - token.position)) + "'";
  }

  /// Returns whether the second way is chosen where the text may be read in two.
  bool second(Doubt doubt) {
    const unsigned bit = 1U << static_cast<unsigned>(doubt);
    asked |= bit;
    return (chosen_ & bit) != 0;
  }

  /// Reads a part one level deeper.
  template <class Read>
  Tree deeper(Read read) {
    if (++depth_ > std::min<std::size_t>(limits_.depth, 300))
      refuse(Mistake::too_deep, fmt::format("this is nested deeper than {} levels", depth_ - 1));
    Tree result = read();
    --depth_;
    return result;
  }

  bool is_name_of_function(const Token& token) const {
    return token.kind == Is::name && !is_known(token.text, reader_.symbols) &&
           !function_of(token.text).empty();
  }
  bool has_blank(std::size_t at) const { return at > 0 && tokens_[at].position > tokens_[at - 1].end; }
  bool is_unit(const Token& token) const {
    return token.kind == Is::name && (token.text == "deg" || token.text == "percent" ||
                                      (reader_.units && reader_.symbols.find(token.text) != nullptr));
  }

  Tree sum() {
    return deeper([&] {
      const std::size_t position = now().position;
      const bool minus = take_if("-");
      if (!minus) take_if("+");
      Tree first = product();
      if (minus) first = make_tree(Kind::negative, "", {first}, {}, position);
      Node node{Kind::sum, "", {first}, {false}, position};
      while (now().is("+") || now().is("-")) {
        node.inverse.push_back(take().text == "-");
        node.children.push_back(product());
      }
      return node.children.size() == 1 ? first : std::make_shared<const Node>(std::move(node));
    });
  }

  Tree product() {
    Node node{Kind::product, "", {}, {}, now().position};
    add_run(node, false);
    while (now().is("*") || now().is("/")) add_run(node, take().text == "/");
    return node.children.size() == 1 && !node.inverse[0] ? node.children[0]
                                                         : std::make_shared<const Node>(std::move(node));
  }

  /// Adds a factor and those that follow without a sign.
  void add_run(Node& node, bool is_divisor) {
    const std::size_t start = at_;
    if (now().is("-") || now().is("+")) {
      const bool minus = take().text == "-";
      const std::size_t position = now().position;
      Node inside{Kind::product, "", {}, {}, position};
      deeper([&] {
        add_run(inside, false);
        return inside.children[0];
      });
      const Tree whole =
          inside.children.size() == 1 ? inside.children[0] : std::make_shared<const Node>(inside);
      add(node, minus ? make_tree(Kind::negative, "", {whole}, {}, position) : whole, is_divisor);
      return;
    }
    Node run{Kind::product, "", {operand()}, {false}, now().position};
    const std::size_t behind = at_;
    while (goes_on()) {
      if (is_reciprocal_unit()) {
        at_ += 2;
        add(run, power(), true);
        continue;
      }
      add(run, operand(), false);
    }
    const bool is_number = behind == start + 1 && tokens_[start].kind == Is::number;
    const bool is_coefficient =  // 1/3 m, not 2x/3 m
        has_blank(behind) && !node.children.empty() && node.children.back()->kind == Kind::number;
    const bool is_plain = !is_divisor || run.children.size() == 1 ||
                          (is_number && (is_coefficient || is_unit(tokens_[behind])));
    const bool is_grouped = !is_plain && second(Doubt::divisor);
    if (is_grouped) return add(node, std::make_shared<const Node>(run), true);
    for (std::size_t k = 0; k < run.children.size(); ++k)
      add(node, run.children[k], k == 0 ? is_divisor : run.inverse[k]);
  }
  static void add(Node& node, Tree factor, bool is_divisor) {
    node.children.push_back(std::move(factor));
    node.inverse.push_back(is_divisor);
  }

  /// Returns whether another factor follows without a sign. Throws for a second number.
  bool goes_on() const {
    if (!now().starts_operand()) return false;
    if (now().text == "and" || now().text == "or")
      refuse(Mistake::syntax, "one statement at a time: " + quoted(now()) + " is not read here");
    if (now().kind == Is::number && !is_reciprocal_unit())
      refuse(Mistake::implicit_multiplication, "a number follows without a sign: the sign is missing");
    return true;
  }
  bool is_reciprocal_unit() const {
    return reader_.units && now().text == "1" && now(1).is("/") && is_unit(now(2));
  }

  /// Reads a factor; 1 1/3 is one if it is a mixed number.
  Tree operand() {
    const Token &whole = now(), &above = now(1), &below = now(3);
    const auto is_integer = [](const Token& token) {
      return token.kind == Is::number && token.text.find_first_not_of("0123456789") == std::string::npos;
    };
    const bool is_mixed = is_integer(whole) && is_integer(above) && now(2).is("/") && is_integer(below) &&
                          !is_unit(now(3)) && has_blank(at_ + 1);
    if (!is_mixed) return power();
    at_ += 4;
    const auto digits = [](const Token& token) {
      return make_tree(Kind::number, token.text, {}, {}, token.position);
    };
    const Tree fraction =
        make_tree(Kind::product, "", {digits(above), digits(below)}, {false, true}, above.position);
    const bool is_product = second(Doubt::mixed);
    return make_tree(is_product ? Kind::product : Kind::sum, "", {digits(whole), fraction}, {false, false},
                     whole.position);
  }

  Tree power() {
    const std::size_t position = now().position;
    if (now().kind == Is::name && now().text == "e" && (now(1).is("^") || now(1).kind == Is::superscript))
      return power_of_e();
    Tree base = with_degrees(primary());
    if (now().kind == Is::superscript)
      base = make_tree(Kind::power, "", {base, superscript()}, {}, position);
    else if (now().is("^"))
      base = make_tree(Kind::power, "", {base, exponent()}, {}, position);
    else
      return base;
    if (now().is("^") || now().kind == Is::superscript)
      refuse(Mistake::syntax, "a power of a power needs parentheses: (x^2)^3");
    return with_degrees(base);
  }

  /// Returns 30*pi/180 for 30 deg, and 5/100 for 5 %. Among units these are units.
  Tree with_degrees(const Tree& base) {
    const bool is_degrees = now().text == "deg", is_percent = now().text == "percent";
    if (reader_.units || now().kind != Is::name || (!is_degrees && !is_percent)) return base;
    if (is_known(now().text, reader_.symbols)) return base;
    const std::size_t position = take().position;
    const auto named = [&](Kind kind, const char* text) { return make_tree(kind, text, {}, {}, position); };
    if (is_percent)
      return make_tree(Kind::product, "", {base, named(Kind::number, "100")}, {false, true}, position);
    return make_tree(Kind::product, "", {base, named(Kind::symbol, "pi"), named(Kind::number, "180")},
                     {false, false, true}, position);
  }

  Tree superscript() {
    const Token& token = take();
    const bool minus = token.text[0] == '-';
    Tree digits = make_tree(Kind::number, token.text.substr(minus ? 1 : 0), {}, {}, token.position);
    check_exponent(*digits, token);
    return minus ? make_tree(Kind::negative, "", {digits}, {}, token.position) : digits;
  }

  Tree exponent() {
    take();
    const Token& start = now();
    const Tree result = deeper([&] { return signed_power(); });
    check_exponent(*result, start);
    return result;
  }
  Tree signed_power() {
    const std::size_t position = now().position;
    if (take_if("+")) return deeper([&] { return signed_power(); });
    if (!take_if("-")) return power();
    return make_tree(Kind::negative, "", {deeper([&] { return signed_power(); })}, {}, position);
  }

  void check_exponent(const Node& exponent, const Token& where) const {
    if (exponent.kind == Kind::negative) return check_exponent(*exponent.children[0], where);
    if (exponent.kind != Kind::number || exact(exponent.text) <= limits_.exponent) return;
    refuse(Mistake::too_large, fmt::format("exponents go up to {}", limits_.exponent), where);
  }

  bool is_given(const std::string& name) const {
    const bool is_listed = reader_.given.empty() || std::ranges::count(reader_.given, name) > 0;
    return reader_.symbols.find(name) != nullptr && is_listed;
  }

  /// Reads e^x, which is exp(x), or a power of the symbol e if there is one.
  Tree power_of_e() {
    const Token& token = take();
    Tree raised = now().is("^") ? exponent() : superscript();
    const bool is_integer = raised->kind == Kind::number || raised->children.size() == 1;
    const bool has_symbol = is_given("e");
    const bool is_symbol = has_symbol && (is_integer || second(Doubt::exponential));
    if (!is_symbol && now().starts_operand() && !has_blank(at_) && now().kind == Is::name &&
        !tokens_[at_ - 1].is(")") && !is_name_of_function(now()) && second(Doubt::exponent))
      raised = with_factors(raised);
    if (is_symbol)
      return make_tree(Kind::power, "", {make_tree(Kind::symbol, "e", {}, {}, token.position), raised}, {},
                       token.position);
    return make_tree(Kind::call, "exp", {raised}, {}, token.position);
  }

  /// Returns the tree times the names that follow; a minus stays before the whole.
  Tree with_factors(const Tree& first) {
    const bool is_negative = first->kind == Kind::negative;
    Node node{Kind::product, "", {is_negative ? first->children[0] : first}, {false}, first->position};
    while (now().kind == Is::name && !is_name_of_function(now())) add(node, power(), false);
    const Tree product = std::make_shared<const Node>(node);
    return is_negative ? make_tree(Kind::negative, "", {product}, {}, first->position) : product;
  }

  Tree primary() {
    const Token& token = now();
    if (token.kind == Is::number) return make_tree(Kind::number, take().text, {}, {}, token.position);
    if (token.kind == Is::name) return name();
    if (take_if("(")) {
      const Tree inside = sum();
      close(token);
      return inside;
    }
    if (!take_if("sqrt")) refuse_operand();
    return deeper([&] { return make_tree(Kind::call, "sqrt", {primary()}, {}, token.position); });
  }

  void close(const Token& opened) {
    if (take_if(")")) return;
    if (now().kind == Is::relation) refuse(Mistake::relation, "a relation is not allowed inside parentheses");
    if (now().is(",")) refuse(Mistake::syntax, "a comma is only allowed between the arguments of a function");
    refuse(Mistake::syntax, "this parenthesis is never closed", opened);
  }

  [[noreturn]] void refuse_operand() const {
    if (now().kind == Is::superscript) refuse(Mistake::syntax, "this exponent has no base");
    if (at_ == 0) refuse(Mistake::syntax, "an operand is missing before " + quoted(now()));
    if (tokens_[at_ - 1].is("(") && now().is(")"))
      refuse(Mistake::syntax, "there is nothing in these parentheses");
    refuse(Mistake::syntax, "an operand is missing after " + quoted(tokens_[at_ - 1]));
  }

  Tree name() {
    const Token& token = take();
    if (is_known(token.text, reader_.symbols)) {
      const bool has_rate =
          token.text.find("dot") != std::string::npos || reader_.symbols.find(token.text + "dot") != nullptr;
      if (has_rate && now().is("(") && now(1).text == "t" && now(2).is(")")) at_ += 3;  // θ(t)
      return make_tree(Kind::symbol, token.text, {}, {}, token.position);
    }
    if (const std::string function = function_of(token.text); !function.empty()) return call(token, function);
    if (token.text == "e")
      return make_tree(Kind::call, "exp", {make_tree(Kind::number, "1", {}, {}, token.position)}, {},
                       token.position);
    if (now().is("(")) refuse(Mistake::unknown_function, unknown_function(token.text, quoted(token)), token);
    refuse(Mistake::unknown_symbol, unknown_symbol(token.text, quoted(token), reader_.symbols), token);
  }

  Tree call(const Token& token, std::string function) {
    Tree raised;
    if (now().kind == Is::superscript || now().is("^")) raised = exponent_of(token, function);
    const bool is_power = function == "pow";
    const std::vector<Tree> arguments = now().is("(") ? this->arguments() : std::vector{bare_argument(token)};
    if (arguments.size() != (is_power ? 2 : 1))
      refuse(Mistake::arguments,
             fmt::format("'{}' takes {}, not {}", function, is_power ? "2 arguments" : "1 argument",
                         arguments.size()),
             token);
    Tree value =
        make_tree(is_power ? Kind::power : Kind::call,
                  is_power ? "" : std::string(find_function(function)->name), arguments, {}, token.position);
    if (has_power_behind_) {
      has_power_behind_ = false;
      const Tree behind = now().is("^") ? exponent() : superscript();
      value = make_tree(Kind::power, "", {value, behind}, {}, token.position);
    }
    return raised ? make_tree(Kind::power, "", {value, raised}, {}, token.position) : value;
  }

  /// Reads the exponent before an argument; sin⁻¹ is asin, which becomes the function.
  Tree exponent_of(const Token& token, std::string& function) {
    const Tree raised = now().is("^") ? exponent() : superscript();
    const bool is_inverse = raised->kind == Kind::negative && raised->children[0]->text == "1";
    if (!is_inverse) return raised;
    if (!is_function("a" + function))
      refuse(Mistake::syntax, "this may mean the inverse function or a quotient: write which", token);
    function = "a" + function;
    return nullptr;
  }

  std::vector<Tree> arguments() {
    const Token& opened = take();
    std::vector<Tree> arguments;
    if (!now().is(")")) arguments.push_back(sum());
    while (take_if(",")) arguments.push_back(sum());
    close(opened);
    return arguments;
  }

  bool is_pure(const Token& token) const {
    if (token.text == "pi") return true;
    const Symbol* symbol = token.kind == Is::name ? reader_.symbols.find(token.text) : nullptr;
    return symbol != nullptr && symbol->unit == "1";
  }
  bool is_measured(const Token& token) const {
    const Symbol* symbol = token.kind == Is::name ? reader_.symbols.find(token.text) : nullptr;
    return symbol != nullptr && symbol->unit != "1" && !reader_.units;
  }

  /// Reads an argument without parentheses: 2α, p t, and what else may belong to it.
  Tree bare_argument(const Token& function) {
    if (!now().starts_operand())
      refuse(Mistake::syntax, "a function needs its argument: write " + function.text + "(x)", function);
    if (is_name_of_function(now())) return deeper([&] { return power(); });
    const std::size_t start = at_;
    Node node{Kind::product, "", {bare_operand()}, {false}, tokens_[start].position};
    bool is_first = true, is_cut = false;
    while (now().starts_operand() && !is_name_of_function(now()) && !has_power_behind_) {
      if (now().kind == Is::number) break;
      if (reader_.units && now().text != "deg" && now().text != "rad") break;
      const bool is_coefficient = is_first && tokens_[start].kind == Is::number && at_ == start + 1;
      const bool is_sure =
          is_coefficient || reader_.units || (is_measured(tokens_[start]) && is_measured(now()));
      if (!is_sure && second(Doubt::argument)) {
        is_cut = true;
        break;
      }
      add(node, bare_operand(), false);
      is_first = false;
    }
    if (!is_cut && !has_power_behind_ && is_name_of_function(now()) && second(Doubt::functions))
      while (is_name_of_function(now())) add(node, deeper([&] { return power(); }), false);
    const bool may_go_on = !is_cut && !has_power_behind_;
    if (may_go_on) go_on_with_signs(node);
    Tree argument = node.children.size() == 1 ? node.children[0] : std::make_shared<const Node>(node);
    return may_go_on ? with_terms(argument) : argument;
  }

  /// Reads a part of an argument. In sin x^2 the power may be that of the function.
  Tree bare_operand() {
    const Tree base = with_degrees(primary());
    const bool has_power = now().is("^") || now().kind == Is::superscript;
    if (!has_power) return base;
    if (second(Doubt::power)) {
      has_power_behind_ = true;
      return base;
    }
    const Tree raised = now().is("^") ? exponent() : superscript();
    return make_tree(Kind::power, "", {base, raised}, {}, base->position);
  }

  /// Takes *b and /b into the argument if that is chosen.
  void go_on_with_signs(Node& node) {
    while (now().is("*") || now().is("/")) {
      const bool is_divisor = now().is("/");
      const Token& next = now(1);
      const bool may_belong =
          is_divisor ? next.kind == Is::number || (next.kind == Is::name && !is_name_of_function(next))
                     : is_pure(next);
      if (!may_belong || !second(Doubt::quotient)) return;
      ++at_;
      add(node, power(), is_divisor);
    }
  }

  /// Returns the argument with the terms behind it that may belong to it: plain angles.
  Tree with_terms(const Tree& first) {
    Node node{Kind::sum, "", {first}, {false}, first->position};
    while ((now().is("+") || now().is("-")) && is_plain_term(at_ + 1) && second(Doubt::sum)) {
      node.inverse.push_back(take().text == "-");
      node.children.push_back(product());
    }
    return node.children.size() == 1 ? first : std::make_shared<const Node>(std::move(node));
  }
  bool is_plain_term(std::size_t at) const {
    bool has_symbol = false;
    for (; tokens_[at].kind == Is::name || tokens_[at].kind == Is::number || tokens_[at].is("*"); ++at) {
      if (tokens_[at].kind == Is::name && !is_pure(tokens_[at])) return false;
      has_symbol = has_symbol || tokens_[at].kind == Is::name;
    }
    const Token& end = tokens_[at];
    return has_symbol &&
           (end.kind == Is::end || end.kind == Is::relation || end.is(")") || end.is("+") || end.is("-"));
  }

  const Tokens& tokens_;
  std::string_view text_;
  const Vocabulary& reader_;
  const Limits& limits_;
  const unsigned chosen_;
  std::size_t at_ = 0, depth_ = 0;
  bool has_power_behind_ = false;  ///< the power behind an argument is that of the function
};

bool has_e(const Relation& relation) {
  const std::function<bool(const Tree&)> any = [&](const Tree& tree) {
    return (tree->kind == Kind::symbol && tree->text == "e") || std::ranges::any_of(tree->children, any);
  };
  return std::ranges::any_of(relation.sides, any);
}

/// Returns whether two readings are seen at once to have the same value.
bool is_same_value(const Relation& a, const Relation& b, const Symbols& symbols) {
  if (a.operators != b.operators) return false;
  for (std::size_t k = 0; k < a.sides.size(); ++k) {
    if (is_same(a.sides[k], b.sides[k])) continue;
    try {
      if (!lower(a.sides[k], symbols).is_equal(lower(b.sides[k], symbols))) return false;
    } catch (const SyntaxError&) {
      return false;
    }
  }
  return true;
}

/// Returns the strict reading; nothing if there is none, or it uses a symbol e that is not given.
std::optional<Relation> strict(std::string_view text, const Vocabulary& reader, const Limits& limits) {
  try {
    Relation read = parse_statement(text, reader.symbols, limits);
    const bool is_e = !reader.given.empty() && std::ranges::count(reader.given, "e") == 0 && has_e(read);
    return is_e ? std::nullopt : std::optional(std::move(read));
  } catch (const SyntaxError& error) {
    if (error.mistake == Mistake::too_long || error.mistake == Mistake::too_deep) throw;
    return {};
  }
}

/// Puts the places of the typed text into a tree.
Tree replaced(const Tree& tree, const Spelt& spelt) {
  Node node = *tree;
  node.position = spelt.places[std::min(node.position, spelt.places.size() - 1)];
  for (Tree& child : node.children) child = replaced(child, spelt);
  return std::make_shared<const Node>(std::move(node));
}

/// Reads a text once for each combination of choices. At most 64 combinations are tried.
Readings all_readings(const Tokens& tokens, std::string_view text, const Vocabulary& reader,
                      const Limits& limits) {
  Readings readings;
  std::vector<unsigned> waiting{0};
  std::set<unsigned> tried{0};
  std::optional<SyntaxError> error;
  for (std::size_t k = 0; k < waiting.size() && k < 64; ++k) {
    Generous parser(tokens, text, reader, limits, waiting[k]);
    try {
      const Relation read = parser.statement();
      const bool is_new = std::ranges::none_of(
          readings.all, [&](const Relation& other) { return is_same_value(other, read, reader.symbols); });
      if (is_new) readings.all.push_back(read);
      if (is_new && readings.all.size() == 2) readings.reason = reasons[std::countr_zero(waiting[k])];
    } catch (const SyntaxError& mistake) {
      if (!error) error = mistake;
    }
    for (unsigned bit = 0; bit < doubts; ++bit)
      if ((parser.asked >> bit & 1U) != 0 && tried.insert(waiting[k] | 1U << bit).second)
        waiting.push_back(waiting[k] | 1U << bit);
  }
  if (readings.all.empty()) throw *error;
  return readings;
}

}  // namespace

Readings generous_readings(std::string_view text, const Vocabulary& reader, const Limits& limits) {
  if (auto read = strict(text, reader, limits)) return {{*read}};
  const Spelt spelt = spell(text, limits);
  try {
    const Tokens tokens = with_words(tokenize(spelt.text, reader.symbols, limits), reader, spelt.text);
    Readings readings = all_readings(tokens, spelt.text, reader, limits);
    for (Relation& read : readings.all)
      for (Tree& side : read.sides) side = replaced(side, spelt);
    return readings;
  } catch (const SyntaxError& error) {
    throw SyntaxError(error.mistake, spelt.places[std::min(error.position, spelt.places.size() - 1)],
                      error.what());
  }
}

std::string advice(const SyntaxError& error, std::string_view text, const Symbols& symbols) {
  constexpr std::size_t longest = 240;
  const bool may_be_read =
      error.mistake == Mistake::implicit_multiplication || error.mistake == Mistake::syntax;
  if (!may_be_read || text.size() > longest) return "";
  try {
    const Readings readings = generous_readings(text, {.symbols = symbols});
    if (readings.all.size() > 2) return "; " + readings.reason + " is not clear";
    std::string written;
    for (const Relation& read : readings.all)
      written += (written.empty() ? ": write " : " or ") + print(read, Notation::plain, symbols);
    return written;
  } catch (const SyntaxError&) {
    return "";
  }
}

}  // namespace rederive::reader
