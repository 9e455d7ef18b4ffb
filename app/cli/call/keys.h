// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project_keys.h"

namespace codewheel {

// The key of a value for programs, from a table of all of them.
template <typename Enum, std::size_t size>
QString keyOf(const NamedValue<Enum> (&names)[size], Enum value)
{
    return QString::fromLatin1(project_keys::nameOf(names, value));
}

} // namespace codewheel
