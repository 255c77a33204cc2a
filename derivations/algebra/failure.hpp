// What an exception comes to, said to a reader: GiNaC and CLN speak of their own insides.
#pragma once

#include <cln/exception.h>

#include <derivations/algebra/phases.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <new>
#include <stdexcept>
#include <string>

namespace rederive {

/// Our own words stay; a pole, an overflow and the rest get a sentence each. std::bad_alloc is thrown on: how
/// much memory there is knows only who gave it.
inline std::string in_plain_words(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) throw;
  if (dynamic_cast<const Undecidable*>(&error) != nullptr ||
      dynamic_cast<const SyntaxError*>(&error) != nullptr)
    return error.what();
  if (dynamic_cast<const std::domain_error*>(&error) != nullptr)  // GiNaC's pole_error among them
    return "on the way to a decision something has no value: a division by 0, or a pole of a function";
  if (dynamic_cast<const cln::runtime_exception*>(&error) != nullptr ||
      dynamic_cast<const std::overflow_error*>(&error) != nullptr)
    return "numbers or exponents grow too large on the way to a decision";
  return "on the way to a decision it turns into something that is not in the class";
}

}  // namespace rederive
