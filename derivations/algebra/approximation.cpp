// Statements that hold to an order in symbols that are small.
#include <algorithm>
#include <derivations/algebra/failure.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Series in symbols that are all of one size: Taylor polynomials, and where there is a pole, negative powers
/// before them.
class Expansion {
 public:
  Expansion(const std::vector<std::string>& small, int order, const Symbols& symbols,
            const std::vector<Given>& given)
      : order_(order), symbols_(symbols), given_(given) {
    for (const std::string& name : small) scaled_[symbols[name]] = size_ * symbols[name];
  }

  ex value(const Tree& tree) const { return put_in(lower(tree, symbols_), given_); }
  ex polynomial(const ex& e) const {
    const ex series = GiNaC::series_to_poly(in_size(e).series(size_ == 0, order_ + 1)).expand();
    ex result = 0;  // the series of a product of polynomials has more terms than those asked for
    for (int k = series.ldegree(size_); k <= order_; ++k) result += series.coeff(size_, k);
    if (has_corner(result)) throw Undecidable("there is a corner where what is small is 0");
    return result.subs(size_ == 1);  // of logarithms
  }
  Tree tree(const ex& e) const { return to_tree(e, symbols_); }
  /// What is left of an expression where all that is small is 0.
  ex lead(const ex& e) const { return in_size(e).subs(size_ == 0); }

  /// What must not be 0 where all that is small is, so that bars and roots have no corner there.
  void add_corners(const Relation& relation, std::vector<std::string>& conditions) const {
    for (const Tree& side : relation.sides) {
      const ex whole = value(side);
      for (auto part = whole.preorder_begin(); part != whole.preorder_end(); ++part) {
        const ex inside = is_bent(*part) ? lead(part->op(0)) : ex(1);
        if (!is_bent(*part) || inside.is_equal(part->op(0)) || sign_of(inside, symbols_) != 0 ||
            vanishes(inside, symbols_))
          continue;  // has_corner() has looked at what is 0 there
        const std::string text = print(inside, Notation::plain, symbols_);
        const auto is_said = [&](const std::string& c) { return c == text + " != 0" || c == text + " > 0"; };
        if (std::none_of(conditions.begin(), conditions.end(), is_said)) conditions.push_back(text + " != 0");
      }
    }
  }

  Relation side_by_side(Relation relation) const {
    for (Tree& side : relation.sides) side = tree(polynomial(value(side)));
    return relation;
  }

 private:
  ex in_size(const ex& e) const { return e.subs(scaled_, GiNaC::subs_options::no_pattern); }

  /// |x|, or a root of x.
  static bool is_bent(const ex& e) {
    return name_of(e) == "abs" || (GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer));
  }
  /// Whether it is bent where what is small is 0.
  bool has_corner(const ex& e) const {
    return std::any_of(e.preorder_begin(), e.preorder_end(), [&](const ex& part) {
      return is_bent(part) && std::any_of(scaled_.begin(), scaled_.end(),
                                          [&](const auto& one) { return part.has(one.first); });
    });
  }

  const GiNaC::symbol size_{"size"};
  GiNaC::exmap scaled_;
  int order_;
  const Symbols& symbols_;
  const std::vector<Given>& given_;
};

/// A relation a*name + b = 0, or > 0 and so on, in which a does not become 0 with what is small, as one
/// between the symbol and the series of -b/a.
std::optional<Relation> solved_for(const std::string& name, const Relation& relation,
                                   const Expansion& expansion, const Symbols& symbols) {
  const SymbolExpression& x = symbols[name];
  const ex residual = expansion.value(relation.sides[0]) - expansion.value(relation.sides[1]);
  if (!residual.has(x)) return std::nullopt;
  const ex slope = residual.diff(x).normal();
  if (slope.has(x)) return std::nullopt;
  const ex rest = residual.subs(x == 0);
  const int sign = sign_of(expansion.lead(slope), symbols);
  if (sign == 0) return std::nullopt;
  std::string op = relation.operators[0];
  if (sign < 0 && op[0] != '=') op[0] = op[0] == '<' ? '>' : '<';
  return Relation{{expansion.tree(x), expansion.tree(expansion.polynomial(-rest / slope))}, {op}};
}

/// Whether the series of two neighbouring sides are the same: of that order nothing is left that
/// says anything.
bool says_nothing(const Relation& polynomials, const Symbols& symbols) {
  for (std::size_t k = 0; k + 1 < polynomials.sides.size(); ++k)
    if (vanishes(lower(polynomials.sides[k], symbols) - lower(polynomials.sides[k + 1], symbols), symbols))
      return true;
  return false;
}

Proof compared_side_by_side(const Relation& left, const Relation& right, const Symbols& symbols,
                            const std::vector<Given>& given) {
  if (!says_nothing(left, symbols) && !says_nothing(right, symbols))
    return prove(left, right, symbols, given);
  Proof proof;
  proof.reason = "to that order nothing is left of the one or the other";
  return proof;
}

Proof compared(const Relation& left, const Relation& right, const std::vector<std::string>& small,
               const Expansion& expansion, const Symbols& symbols, const std::vector<Given>& given) {
  if (left.sides.size() != 2 || right.sides.size() != 2)
    return compared_side_by_side(expansion.side_by_side(left), expansion.side_by_side(right), symbols, given);
  for (const std::string& name : symbols.names()) {
    if (std::count(small.begin(), small.end(), name) > 0) continue;  // what is left out may be of its size
    const auto l = solved_for(name, left, expansion, symbols);
    const auto r = l ? solved_for(name, right, expansion, symbols) : std::nullopt;
    if (r) return prove(*l, *r, symbols, given);
  }
  Proof proof =
      compared_side_by_side(expansion.side_by_side(left), expansion.side_by_side(right), symbols, given);
  if (proof.verdict != Verdict::refuted) return proof;
  proof = {};  // the factor between the two may be 1 to that order
  proof.reason = "there is no symbol that is not small for which both can be solved";
  return proof;
}

}  // namespace

Proof prove_approximation(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                          int order, const Symbols& symbols, const std::vector<Given>& given) {
  try {
    const Expansion expansion(small, order, symbols, given);
    Proof proof = compared(left, right, small, expansion, symbols, given);
    if (proof.verdict != Verdict::proved) return proof;
    proof.verdict = Verdict::approximation;
    for (const Relation* relation : {&left, &right}) expansion.add_corners(*relation, proof.side_conditions);
    return proof;
  } catch (const std::domain_error&) {  // GiNaC: a pole, in the expression or in one of its derivatives
    Proof proof;
    proof.reason = "no series: there is a pole, or a derivative without a value, where what is small is 0";
    return proof;
  } catch (const std::exception& error) {
    Proof proof;
    proof.reason = "no series: " + in_plain_words(error);
    return proof;
  }
}

}  // namespace rederive
