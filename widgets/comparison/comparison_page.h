// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"
#include "widgets/structure_editor/plan_edits.h"

#include <QPointer>

#include <optional>

class QCheckBox;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class AgeTimer;
class ComparisonModel;
class EmptyState;
class EncoderBus;
class InlineMessage;

// What is configured for a bus beside what is connected, by the rules of its kind. Lines can be taken over
// into the project. A kind with more to compare derives from this.
class ComparisonPage : public Page
{
    Q_OBJECT

public:
    // Document and catalog must outlive it.
    ComparisonPage(ProjectDocument &document, const Catalog &catalog, BusId bus, const QString &kind,
                   QWidget *parent = nullptr);

    void setBus(EncoderBus *bus); // null: there is none
    int differences() const;
    QString title() const override { return tr("Compare with the bus"); }
    QString about() const override;
    QString effect() const override;

protected:
    void compare();
    void takeIntoProject(const std::vector<std::size_t> &lines);
    std::vector<std::size_t> selectedLines() const;
    bool isConnected() const;
    const Comparison &comparison() const;
    PlanEdits &edits() { return m_edits; }
    InlineMessage &message() { return *m_message; }
    QHBoxLayout &top() { return *m_top; }
    QGridLayout &buttons() { return *m_buttons; }
    virtual void showState(); // connected or not, running or stopped
    virtual void showWhatIsPossible();

private:
    void arrange();
    void followAnswers();
    void showSummary();

    PlanEdits m_edits;
    QPointer<EncoderBus> m_bus;
    ConnectedBus m_connected;
    std::optional<Instant> m_comparedAt;
    ComparisonModel *m_model;
    QTableView *m_table;
    QLabel *m_summary;
    QCheckBox *m_onlyDifferences;
    QPushButton *m_lineIntoProject;
    QPushButton *m_allIntoProject;
    InlineMessage *m_message;
    EmptyState *m_empty;
    AgeTimer *m_age;
    QHBoxLayout *m_top;
    QGridLayout *m_buttons;
};

std::vector<std::size_t> allLines(const Comparison &comparison);

} // namespace codewheel
