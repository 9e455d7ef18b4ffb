// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/wizard/wizard_page.h"

#include <map>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace codewheel {

class Consequences;
class InlineMessage;
class ValueField;

// The wanted values, with their consequences.
class ValuesPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit ValuesPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    void leave() override;
    bool mayGoOn() const override { return m_inputIsGood && m_hasAny; }
    void showLatest() override;
    void showKnown() override;
    void showWanted();

private:
    struct Row
    {
        ValueField *field = nullptr;
        QLabel *now = nullptr;
    };

    void makeRows();
    void followPreset();
    void checkFields();
    void takeFields();
    void readPosition();
    void showSetting();
    void makePositionField();

    std::map<Parameter, Row> m_rows;
    QString m_rowsOf; // device key the rows were made for
    QWidget *m_form;
    QCheckBox *m_initialise;
    QHBoxLayout *m_setting;
    ValueField *m_position = nullptr; // to be set, if the command needs it; for this encoder
    InlineMessage *m_badInput;
    QVBoxLayout *m_layout;
    Consequences *m_consequences = nullptr; // for this kind of encoder
    bool m_inputIsGood = true;
    bool m_hasAny = false;
};

} // namespace codewheel
