// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/position_scale.h"
#include "widgets/wizard/wizard_page.h"

#include <map>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace codewheel {

class GearPanel;
class InlineMessage;
class ScalePreview;
class ValueField;

// The wanted values, with what they come to: resolution, total range, a jump at the wrap, the position the
// shaft will read.
class ValuesPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit ValuesPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override { return m_inputIsGood && m_hasAny; }
    void showLatest() override;
    void showKnown() override;

private:
    struct Row
    {
        ValueField *field = nullptr;
        QLabel *now = nullptr;
    };

    void makeRows();
    void readFields();
    void showConsequences();
    QString scaleText(const PositionScale &scale) const;
    QString warningFor(const PositionScale &scale) const;

    std::map<Parameter, Row> m_rows;
    QString m_rowsOf; // key of the device
    QWidget *m_form;
    QCheckBox *m_initialise;
    QLabel *m_scaleText;
    InlineMessage *m_badInput;
    InlineMessage *m_warning;
    GearPanel *m_gear;
    ScalePreview *m_preview;
    bool m_inputIsGood = true;
    bool m_hasAny = false;
};

} // namespace codewheel
