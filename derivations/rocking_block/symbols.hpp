// The symbols of the paper as C++ constants, which the build writes from paper.toml.
#pragma once

#include <emitted/rocking_block_symbols.hpp>
