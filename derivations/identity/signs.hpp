// The signs that a real number may have: a subset of {-, 0, +}.
#pragma once

namespace rederive::identity {

class Signs {
 public:
  static constexpr Signs any() { return Signs(7); }
  static constexpr Signs positive() { return Signs(4); }
  static constexpr Signs zero() { return Signs(2); }
  static constexpr Signs negative() { return Signs(1); }
  static constexpr Signs nonnegative() { return Signs(6); }
  static constexpr Signs nonpositive() { return Signs(3); }
  static constexpr Signs nonzero() { return Signs(5); }

  constexpr bool within(Signs other) const { return (bits_ & ~other.bits_) == 0; }
  constexpr bool is_definite() const { return within(nonzero()); }
  /// Returns whether no sign is left, because the facts contradict each other.
  constexpr bool is_none() const { return bits_ == 0; }
  friend constexpr Signs operator&(Signs a, Signs b) { return Signs(a.bits_ & b.bits_); }
  friend constexpr Signs operator|(Signs a, Signs b) { return Signs(a.bits_ | b.bits_); }
  constexpr Signs operator~() const { return Signs(7 & ~bits_); }  ///< the other signs
  constexpr Signs operator-() const { return Signs((bits_ & 2) | (bits_ & 1) << 2 | (bits_ & 4) >> 2); }
  /// Returns the signs of a product.
  friend constexpr Signs operator*(Signs a, Signs b) {
    Signs result(0);
    if ((a.bits_ & 4) != 0) result = result | b;
    if ((a.bits_ & 1) != 0) result = result | -b;
    if ((a.bits_ & 2) != 0 && b.bits_ != 0) result = result | zero();
    return result;
  }
  /// Returns the signs of a sum.
  friend constexpr Signs sum_of(Signs a, Signs b) {
    if (a == zero()) return b;
    if (b == zero()) return a;
    for (const Signs side : {nonnegative(), nonpositive()})
      if (a.within(side) && b.within(side))
        return a.is_definite() || b.is_definite() ? side & nonzero() : side;
    return any();
  }
  /// Returns the signs of the power with an integer exponent above 0.
  friend constexpr Signs power(Signs a, int exponent) {
    if (exponent % 2 != 0) return a;
    return Signs((a.bits_ & 2) | ((a.bits_ & 5) != 0 ? 4u : 0u));
  }
  friend constexpr bool operator==(Signs a, Signs b) = default;

 private:
  constexpr explicit Signs(unsigned bits) : bits_(bits) {}
  unsigned bits_;
};

}  // namespace rederive::identity
