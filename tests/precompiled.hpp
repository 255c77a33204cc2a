// What most tests include, read once.
#pragma once

#include <doctest/doctest.h>

#include <derivations/precompiled.hpp>
