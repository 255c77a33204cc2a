// What most tests include, read once.
#pragma once

#include <doctest/doctest.h>

#include <.setup/precompiled.hpp>
