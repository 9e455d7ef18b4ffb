// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/last_positions.h"
#include "vocabulary/message.h"
#include "widgets/look/page.h"
#include "widgets/look/quick_press.h"
#include "widgets/transfer/replace_step.h"

#include <vector>

class QLabel;
class QPushButton;
class QStackedWidget;

namespace codewheel {

class InlineMessage;
class ReplaceAccountStep;
class ReplacePositionStep;
class ReplaceWriteStep;
class StepList;

// An encoder has been replaced, perhaps at night: which one is there now, which position it is to show, what
// is written to it from the project, and what was written. A page of the main window, step by step like the
// parameter wizard.
class ReplacePage : public Page
{
    Q_OBJECT

public:
    // All must outlive it.
    ReplacePage(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
                LastPositions &positions, QWidget *parent = nullptr);

    // What the kind of the bus adds, from the next replace() on.
    void setStepsOfKind(MakeReplaceSteps make) { m_makeStepsOfKind = std::move(make); }
    // Starts afresh; not while something is being written.
    void replace(Place number);
    bool isBusy() const;
    QString title() const override;
    QString about() const override;
    QString effect() const override;
    QString lostByClosing() const override;
    void leave() override;

Q_SIGNALS:
    void messaged(const codewheel::Message &message);

private:
    // A replacement that did not become done: the next try at its place begins with what was given.
    struct Unfinished
    {
        Place place;
        Replacement label;
        QString key;
    };

    void makeSteps();
    void addStep(ReplaceStep *step); // null: none
    void showStep(const ReplaceStep *step);
    void showNext(int by);
    void showList();
    void next();
    void back();
    bool canBeRepeated() const;
    void putIntoProject();
    void takePlanned();
    void followProject();
    void leaveProject();
    void showAccount();
    void showButtons();
    void followBuses();
    bool isConnected() const;
    void showWait();
    void beginAnew();
    ReplaceStep *current() const;
    bool isLast() const;
    bool isDone() const { return !m_unfinished; } // all that was to be written
    QString doneSoFar() const;

    Replacing m_replacing;
    std::optional<Unfinished> m_unfinished;
    LastPositions &m_positions;
    MakeReplaceSteps m_makeStepsOfKind;
    std::vector<ReplaceStep *> m_steps;
    ReplaceStep *m_device = nullptr;
    ReplacePositionStep *m_position = nullptr;
    ReplaceWriteStep *m_write = nullptr;
    ReplaceAccountStep *m_account = nullptr;
    QuickPress m_press;      // the current one is shown
    bool m_hasBegun = false; // writing: what was reviewed is fixed from then on
    bool m_isResultSeen = false;
    bool m_waits = false; // its bus is not connected, so what was shown of it is of before
    InlineMessage *m_wait;
    StepList *m_list = nullptr;
    QLabel *m_stepName; // if there is no room for the list
    QStackedWidget *m_pages;
    QPushButton *m_back;
    QPushButton *m_next;
    QPushButton *m_cancel;
};

} // namespace codewheel
