// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/json_object.h"
#include "vocabulary/known.h"

namespace codewheel::project_keys {

// The names of values in a project file, in both directions.
inline constexpr char formatName[] = "codewheel-project";

inline constexpr NamedValue<Evidence> evidences[] = {
    {"read", Evidence::read},
    {"echoed", Evidence::echoed},
    {"told", Evidence::told},
};

template <typename Enum, std::size_t size>
const char *nameOf(const NamedValue<Enum> (&names)[size], Enum value)
{
    for (const NamedValue<Enum> &name : names)
        if (name.value == value)
            return name.name;
    return names[0].name;
}

} // namespace codewheel::project_keys
