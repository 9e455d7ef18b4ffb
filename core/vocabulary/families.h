// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"

#include <span>

namespace codewheel {

// Those of kinds/protocols.cpp, and any that were added, before a journal is read.
std::span<const RefusalFamily *const> refusalFamilies();
std::span<const MessageFamily *const> messageFamilies();
void addRefusals(const RefusalFamily &family);
void addMessages(const MessageFamily &family);

} // namespace codewheel
