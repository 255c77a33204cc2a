// The value of a tree, node by node, in arithmetic with proven error bounds. The working precision grows
// until the digits asked for are certain, up to a limit; then there is no value to give.
#include <derivations/algebra/ball.hpp>
#include <derivations/algebra/evaluate.hpp>
#include <stdexcept>

namespace rederive {

namespace {

using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

class Evaluation {
 public:
  Evaluation(const Point& point, const Box& box, int digits)
      : point_(point), box_(box), arithmetic_(digits) {}

  Ball value(const Node& node) const {
    switch (node.kind) {
      case Node::Kind::number:
        return {exact(node.text)};
      case Node::Kind::symbol:
        return symbol(node.text);
      case Node::Kind::negative:
        return arithmetic_.negative(value(*node.children[0]));
      case Node::Kind::sum:
        return sum(node);
      case Node::Kind::product:
        return product(node);
      case Node::Kind::power:
        return arithmetic_.power(value(*node.children[0]), value(*node.children[1]));
      case Node::Kind::call:
        return call(node);
    }
    throw NoValue{};
  }

 private:
  Ball symbol(const std::string& name) const {
    if (name == "pi") return arithmetic_.pi();
    if (const auto bounds = box_.find(name); bounds != box_.end()) {
      const auto& [low, high] = bounds->second;
      return {(low + high) / 2, (high - low) / 2};
    }
    const auto found = point_.find(name);
    if (found == point_.end()) throw std::out_of_range("the point gives no value for '" + name + "'");
    return {found->second};
  }

  Ball sum(const Node& node) const {
    Ball total = value(*node.children[0]);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      const Ball part = value(*node.children[i]);
      total = arithmetic_.plus(total, node.inverse[i] ? arithmetic_.negative(part) : part);
    }
    return total;
  }

  Ball product(const Node& node) const {
    Ball total = value(*node.children[0]);
    for (std::size_t i = 1; i < node.children.size(); ++i) {
      const Ball part = value(*node.children[i]);
      total = node.inverse[i] ? arithmetic_.over(total, part) : arithmetic_.times(total, part);
    }
    return total;
  }

  Ball call(const Node& node) const { return arithmetic_.call(node.text, value(*node.children[0])); }

  const Point& point_;
  const Box& box_;
  BallArithmetic arithmetic_;
};

}  // namespace

bool is_certain(const Ball& ball, int digits) {
  return ball.exact() || 2 * ball.radius * cln::expt_pos(cl_I(10), digits) < cln::abs(ball.middle);
}

std::optional<Ball> enclosure(const Tree& tree, const Point& point, const Box& box) {
  try {
    return Evaluation(point, box, 110).value(*tree);
  } catch (const NoValue&) {
  } catch (const cln::runtime_exception&) {
  }
  return std::nullopt;
}

std::optional<cln::cl_R> evaluate(const Tree& tree, const Point& point, int digits) {
  const int most = 4 * digits + 200;
  for (int precision = digits + 10;; precision = std::min(2 * precision, most)) {
    try {
      const Ball ball = Evaluation(point, {}, precision).value(*tree);
      if (is_certain(ball, digits)) return ball.middle;
    } catch (const NoValue& why) {  // else too wide, or undefined: more digits will tell
      if (why.is_certain) return std::nullopt;
    } catch (const cln::runtime_exception&) {  // overflow and the like
    }
    if (precision == most) return std::nullopt;
  }
}

}  // namespace rederive
