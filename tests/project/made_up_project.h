// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <random>

namespace codewheel {

// Projects with something of everything, for tests and benchmarks. Seeded: the same in each run.
Project madeUpProject(std::mt19937 &random, std::size_t devices);
inline Project madeUpProject(std::uint32_t seed, std::size_t devices)
{
    std::mt19937 random(seed);
    return madeUpProject(random, devices);
}

} // namespace codewheel
