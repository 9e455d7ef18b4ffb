// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ring/comparison.h"
#include "ring/master_link.h"
#include "widgets/project/project_document.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class BusSession;
class ComparisonModel;
class EmptyState;
class InlineMessage;

// The configured ring beside the connected one. Lines are taken over into the project, or into the
// configuration that the master keeps, and that one is loaded back; all can be taken back.
class ComparisonPage : public QWidget
{
    Q_OBJECT

public:
    // Both must outlive it.
    ComparisonPage(ProjectDocument &document, BusSession &bus, QWidget *parent = nullptr);

    void setConnected(bool isConnected);
    int differences() const;

Q_SIGNALS:
    void readInRequested();

private:
    void arrange();
    void compare();
    void takeIntoProject(const std::vector<std::size_t> &lines);
    void plan(RingStructure ring, Comparison comparison, const std::vector<std::size_t> &lines,
              const QString &what);
    void loadBack();
    void takeIntoMaster(const std::vector<std::size_t> &lines);
    void keep(KeptConfiguration configuration);
    bool mayChangeRing(); // else it says why not
    void showKept(const std::optional<KeptConfiguration> &configuration);
    std::vector<std::size_t> selectedLines() const;
    void showWhatIsPossible();

    ProjectDocument &m_document;
    BusSession &m_bus;
    bool m_isConnected = false;
    ComparisonModel *m_model;
    QTableView *m_table;
    QLabel *m_summary;
    QCheckBox *m_onlyDifferences;
    QPushButton *m_readIn;
    QPushButton *m_lineIntoProject;
    QPushButton *m_allIntoProject;
    QPushButton *m_lineIntoMaster;
    QPushButton *m_allIntoMaster;
    QPushButton *m_keptIntoProject;
    InlineMessage *m_message;
    EmptyState *m_empty;
    std::optional<KeptConfiguration> m_kept;   // by the master, as it told
    std::optional<KeptConfiguration> m_before; // what a download replaced
    bool m_isDownloading = false;
    bool m_isRefused = false; // as the message says
};

} // namespace codewheel
