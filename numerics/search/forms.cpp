#include <numerics/search/forms.hpp>

namespace rederive::numerics {

int code_of(Form form) {
  switch (form) {
    case Form::eq71:
    case Form::eq104:
      return -1;
    case Form::eq78:
    case Form::eq103:
      return 1;
    case Form::eq86_88:
    case Form::eq92a_96:
      return 2;
  }
  return 0;
}

std::vector<std::string> equations_of(Form form) {
  switch (form) {
    case Form::eq71:
      return {"71"};
    case Form::eq78:
      return {"78"};
    case Form::eq86_88:
      return {"86", "88"};
    case Form::eq92a_96:
      return {"92a", "96"};
    case Form::eq103:
      return {"103"};
    case Form::eq104:
      return {"104"};
  }
  return {};
}

ExactCase exact_case_of(const PulseCase& asked) {
  return {.omega_ratio = Ball(asked.omega_ratio),
          .restitution = Ball(asked.block.restitution),
          .angle = Ball(asked.initial.angle),
          .velocity = Ball(asked.initial.velocity)};
}

}  // namespace rederive::numerics
