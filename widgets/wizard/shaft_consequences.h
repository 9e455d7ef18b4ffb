// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/value_notes.h"
#include "widgets/wizard/consequences.h"

namespace codewheel {

class GearPanel;
class ScalePreview;

// For an encoder on a shaft: resolution, total range, a jump at the wrap, the position the shaft will read.
class ShaftConsequences final : public Consequences
{
    Q_OBJECT

public:
    ShaftConsequences(Setup &setup, QWidget *parent);

    void refresh() override;

private:
    QString scaleText(const PositionScale &scale) const;
    QStringList warnings(const std::optional<PositionScale> &scale) const;
    std::vector<ValueNote> notes() const;
    QString warningFor(const PositionScale &scale) const;
    void showLimits();

    GearPanel *m_gear;
    ScalePreview *m_preview;
};

} // namespace codewheel
