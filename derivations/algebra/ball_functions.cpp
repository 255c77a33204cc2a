#include <derivations/algebra/ball.hpp>
#include <functional>
#include <map>
#include <stdexcept>

namespace rederive {

using cln::cl_RA;

Ball BallArithmetic::call(const std::string& name, const Ball& x) const {
  using Function = std::function<Ball(const BallArithmetic&, const Ball&)>;
  using A = BallArithmetic;
  static const Ball one{1}, half_turn{cl_RA(1) / 2};
  static const std::map<std::string, Function> functions = {
      {"sin", &A::sin},
      {"cos", &A::cos},
      {"tan", [](const A& a, const Ball& x) { return a.over(a.sin(x), a.cos(x)); }},
      {"cot", [](const A& a, const Ball& x) { return a.over(a.cos(x), a.sin(x)); }},
      {"sec", [](const A& a, const Ball& x) { return a.over(one, a.cos(x)); }},
      {"csc", [](const A& a, const Ball& x) { return a.over(one, a.sin(x)); }},
      {"sinh", &A::sinh},
      {"cosh", &A::cosh},
      {"tanh", [](const A& a, const Ball& x) { return a.over(a.sinh(x), a.cosh(x)); }},
      {"coth", [](const A& a, const Ball& x) { return a.over(a.cosh(x), a.sinh(x)); }},
      {"sech", [](const A& a, const Ball& x) { return a.over(one, a.cosh(x)); }},
      {"csch", [](const A& a, const Ball& x) { return a.over(one, a.sinh(x)); }},
      {"asin", &A::asin},
      {"acos",
       [](const A& a, const Ball& x) { return a.plus(a.times(half_turn, a.pi()), a.negative(a.asin(x))); }},
      {"atan", &A::atan},
      {"asinh", &A::asinh},
      {"acosh", &A::acosh},
      {"atanh", &A::atanh},
      {"exp", &A::exp},
      {"log", &A::log},
      {"sqrt", &A::sqrt},
      {"fabs", &A::absolute}};
  const auto function = functions.find(name);
  if (function == functions.end()) throw std::out_of_range("there is no function '" + name + "'");
  if (is_outside_domain(name, x)) throw NoValue{true};
  return function->second(*this, x);
}

bool is_outside_domain(const std::string& function, const Ball& x) {
  const auto certainly_above = [](const Ball& ball, int bound) { return ball.least() > bound; };
  const Ball size{cln::abs(x.middle), x.radius};
  const bool at_one = x.exact() && cln::abs(x.middle) == 1;
  if (function == "log") return is_negative(x) || (x.exact() && cln::zerop(x.middle));
  if (function == "sqrt") return is_negative(x);
  if (function == "asin" || function == "acos") return certainly_above(size, 1);
  if (function == "acosh") return x.most() < 1;
  if (function == "atanh") return certainly_above(size, 1) || at_one;
  return false;
}

}  // namespace rederive
