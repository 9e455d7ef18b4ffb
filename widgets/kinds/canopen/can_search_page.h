// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_event.h"
#include "widgets/kinds/canopen/can_found_model.h"
#include "widgets/look/page.h"

#include <QPointer>

class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTableView;

namespace codewheel {

class CanopenSession;
class EmptyState;
class InlineMessage;

// Asks all numbers of a CAN bus who is there, after a question, shows what each node tells of itself, and
// hands over the chosen ones.
class CanSearchPage : public Page
{
    Q_OBJECT

public:
    explicit CanSearchPage(QWidget *parent = nullptr);
    ~CanSearchPage() override;

    QString title() const override { return tr("Search for nodes"); }
    QString effect() const override
    {
        return tr("Sends on the bus: asks each number what it is. Nothing is written.");
    }

    void setBus(codewheel::CanopenSession *bus); // null: none

Q_SIGNALS:
    void takeOverWanted(const std::vector<codewheel::CanFoundRow> &found);

private:
    void ask();
    void start();
    void showScan(const NodesScanned &scan);
    std::vector<CanFoundRow> rowsOf(const std::vector<canopen::FoundNode> &found) const;
    void showEnd(const NodesScanned &scan);
    void showWhatIsPossible();
    QString whyNot() const; // empty: it can be searched

    QPointer<CanopenSession> m_bus;
    bool m_isSearching = false;
    std::vector<canopen::FoundNode> m_last;
    QPushButton *m_start;
    QPushButton *m_cancel;
    QPushButton *m_take;
    QProgressBar *m_progress;
    InlineMessage *m_message;
    CanFoundModel *m_found;
    QTableView *m_table;
    EmptyState *m_empty;
    QStackedWidget *m_content;
};

} // namespace codewheel
