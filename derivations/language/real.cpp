#include <derivations/language/real.hpp>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;

namespace {

class Real : public GiNaC::map_function {
 public:
  ex operator()(const ex& e) override {
    if (GiNaC::is_a<GiNaC::numeric>(e) && !e.info(GiNaC::info_flags::real))
      throw std::domain_error("this has no real value");
    if (!GiNaC::is_a<GiNaC::function>(e)) return e.map(*this);
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if (name == "imag_part" || name == "atan2")
      return 0;  // the angle of a real power is that of its positive base
    return name == "conjugate" || name == "real_part" ? (*this)(e.op(0)) : e.map(*this);
  }
};

}  // namespace

ex as_real(const ex& expression) { return Real()(expression); }

ex size_of(const ex& x) {
  const bool is_root = GiNaC::is_a<GiNaC::power>(x) && x.op(1).info(GiNaC::info_flags::rational) &&
                       !x.op(1).info(GiNaC::info_flags::integer);
  return is_root ? x : GiNaC::abs(x);
}

ex derivative(const ex& expression, const ex& symbol) {
  return as_real(expression.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)));
}

}  // namespace rederive
