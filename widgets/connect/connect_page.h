// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/check_outcome.h"
#include "vocabulary/kind_data.h"
#include "widgets/connect/port_row.h"
#include "widgets/look/page.h"
#include "widgets/look/trouble.h"

#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace codewheel {

class CheckList;
class InlineMessage;
class LinkForm;

// How a bus is connected: which kind of link, its settings, a test of them step by step. Knows no kind of
// bus: each brings its forms (LinkForm), and the views of the bus carry out what is wanted.
class ConnectPage : public Page
{
    Q_OBJECT

public:
    explicit ConnectPage(QWidget *parent = nullptr);

    void addForm(LinkForm *form);
    void setVisible(bool visible) override;
    QString title() const override { return tr("Connection"); }
    QString effect() const override;

    void setPorts(const std::vector<PortRow> &ports, const Trouble &trouble);
    // Chooses the form of its link and shows it there.
    void showPlan(const KindData &plan);
    KindData plan() const; // as entered
    // For the page in another language.
    int chosenLink() const;
    void chooseLink(int link);
    // As if the user had chosen this link and pressed Connect.
    void connectBy(const KindData &plan);
    void setConnecting(bool on);
    // A bus that is connected has its settings in the project; it can be connected anew, after asking. Beside
    // a simulated one a real link can be tested.
    enum class Connected : std::uint8_t { no, simulated, real };
    void setConnected(Connected connected);
    void setProblem(const Trouble &trouble); // empty: none
    void tell(const QString &sentence);
    // Ends with agreed() if the user presses the button with this text.
    void ask(const QString &sentence, const QString &answer);

    void setTesting(bool on); // begins a new list of steps
    bool isTesting() const { return m_isTesting; }
    void addStep(CheckOutcome outcome, const QString &what, const QString &sentence);
    const CheckList &steps() const { return *m_steps; }

Q_SIGNALS:
    void portsWanted();
    void connectWanted(const codewheel::KindData &plan);
    void keepWanted(const codewheel::KindData &plan);
    void testWanted(const codewheel::KindData &plan);
    void testCancelled();
    void agreed(const codewheel::KindData &plan); // to what was asked

private:
    QWidget *makeButtons();
    void orderTabs();
    LinkForm *form() const; // the chosen one
    bool takeTyped();
    bool isComplete();
    void choose(int form);
    void connectNow();
    void agree();
    void askToReplace();
    void forgetTest();
    void keep();
    void test();
    void showButtons();
    void scrollToSteps();

    QScrollArea *m_area; // for low windows
    QWidget *m_content;
    QComboBox *m_link;
    QLabel *m_sentence;
    QStackedWidget *m_forms;
    InlineMessage *m_problem;
    CheckList *m_steps;
    QPushButton *m_test;
    QPushButton *m_keep;
    QPushButton *m_connect;
    bool m_isOpened = false;      // has been, so that the fields of what is chosen are there
    bool m_asksToReplace = false; // what m_problem asks
    bool m_isTesting = false;
    bool m_isConnecting = false;
    Connected m_connected = Connected::no;
};

} // namespace codewheel
