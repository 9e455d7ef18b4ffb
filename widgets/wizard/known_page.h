// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/review_table.h"
#include "widgets/wizard/wizard_page.h"

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class InlineMessage;
class KnownBeforeBar;
class RoleLabel;
class ValueField;

// What is known of the encoder, and how: read, echoed, told or unknown. Reads on request; takes what the user
// enters from the papers, and, if it has several modes, that it is in position mode.
class KnownPage final : public WizardPage
{
    Q_OBJECT

public:
    explicit KnownPage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override;
    bool mayGoBack() const override { return mayGoOn(); }
    void showLatest() override;
    void showKnown() override;
    void showPermission() override;
    void showProgress() override;
    void showOutcome(const Outcome &outcome) override;

private:
    void showTable();
    Parameter parameterAt(int row) const { return m_parameters.at(static_cast<std::size_t>(row)); }
    void read();
    void selectRow();
    void tell();
    void tellPositionMode();

    ReviewTable m_table;
    std::vector<Parameter> m_parameters; // by row
    QTableView *m_view;
    QLabel *m_explanation;
    QPushButton *m_read;
    QLabel *m_tellLabel;
    QHBoxLayout *m_tellRow;
    ValueField *m_tellField = nullptr;
    QLabel *m_tellUnit;
    QPushButton *m_tell;
    RoleLabel *m_mode;
    QPushButton *m_isPositionMode;
    InlineMessage *m_problem;
    KnownBeforeBar *m_before;
    bool m_isRefused = false; // the problem is a refusal: it goes when sending is allowed
    std::optional<JobId> m_reading;
};

} // namespace codewheel
