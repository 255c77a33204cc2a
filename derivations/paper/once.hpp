// A value that is computed when it is first asked for.
#pragma once

#include <memory>
#include <mutex>

namespace rederive::paper {

/// Copies share the value.
template <class Value>
class Once {
 public:
  /// The value, which the first call makes. Throws what `make` throws, and the next call tries again.
  template <class Make>
  const Value& operator()(const Make& make) const {
    std::call_once(state_->flag, [&] { state_->value = make(); });
    return state_->value;
  }

 private:
  struct State {
    std::once_flag flag = {};
    Value value = {};
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace rederive::paper
