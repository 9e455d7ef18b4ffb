// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/connect/trouble_of.h"

#include "doctor/hindrance_of_refusal.h"
#include "vocabulary/refusal_text.h"

namespace codewheel {

Trouble troubleOf(const Hindrance &hindrance)
{
    return {hindrance.sentence, hindrance.command};
}

Trouble troubleOf(const Refusal &why)
{
    const auto hindrance = hindranceOf(why);
    return hindrance ? troubleOf(*hindrance) : Trouble(refusalText(why));
}

} // namespace codewheel
