// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/consequences.h"

#include "widgets/models/device_traits.h"
#include "widgets/wizard/rod_consequences.h"
#include "widgets/wizard/shaft_consequences.h"

namespace codewheel {

Consequences *Consequences::make(Setup &setup, QWidget *parent)
{
    if (isRod(setup.encoder->device()))
        return new RodConsequences(setup, parent);
    return new ShaftConsequences(setup, parent);
}

} // namespace codewheel
