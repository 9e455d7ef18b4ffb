// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/data_check.h"
#include "widgets/look/page.h"
#include "widgets/look/trouble.h"

#include <functional>

class QTableView;

namespace codewheel {

class DataCheckModel;
class EmptyState;
class InlineMessage;
class RoleLabel;

// Why there is no data of a device or bus: what is expected beside what came, step by step, and above that
// what differs first and what to do. Knows no kind of bus: whoever shows it asks the bus.
class WhyPage : public Page
{
    Q_OBJECT

public:
    struct Helpers
    {
        std::function<Trouble(const Refusal &)> troubleOf; // what the computer tells about it
        // What the button for it says; empty: it cannot be done now.
        std::function<QString(DataCheck::Action)> buttonFor;
    };

    explicit WhyPage(Helpers helpers, QWidget *parent = nullptr);

    // Called with each frame. No checks: nothing is chosen.
    void showChecks(const QString &about, const DataChecks &checks);
    QString title() const override { return tr("Why is there no data?"); }
    QString effect() const override;

Q_SIGNALS:
    void actionWanted(codewheel::DataCheck::Action action);

private:
    void showOutcome(const DataChecks &checks);
    void showHelp(const DataCheck *check);
    Trouble troubleOf(const DataCheck &check) const;

    const Helpers m_helpers;
    DataCheck m_helped; // the message is about it
    QString m_button;
    DataCheckModel *m_model;
    RoleLabel *m_outcome;
    InlineMessage *m_help;
    QTableView *m_table;
    EmptyState *m_empty;
};

} // namespace codewheel
