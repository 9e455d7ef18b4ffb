// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/consequences.h"

namespace codewheel {

class RodPanel;

// For an encoder on a rod: the resolution in mm, and presets that lie off the rod.
class RodConsequences final : public Consequences
{
    Q_OBJECT

public:
    RodConsequences(Setup &setup, QWidget *parent);

    void refresh() override;

private:
    QString scaleText() const;
    QString warning() const;

    RodPanel *m_calculator;
};

} // namespace codewheel
