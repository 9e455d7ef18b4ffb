// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "app/window/buses/bus_views.h"
#include "app/window/kinds/canopen/canopen_status.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/nmt.h"
#include "vocabulary/refusal.h"

#include <QPointer>

#include <array>
#include <optional>

class QMessageBox;

namespace codewheel {

class CanBusPanel;
class CanSearchPage;
class CanSettingsForm;
class CanTrafficView;
class CanopenActions;
class CanopenAtWork;
class CanopenKeeper;
class CanopenSession;
class ComparisonPage;
class ConnectPage;
class DictionaryView;
class OperateQuestion;
struct CanFoundRow;
struct FrameSent;
struct Outcome;

inline constexpr Panel canTrafficPanel{"canTrafficDock",
                                       QT_TRANSLATE_NOOP("codewheel::Panels", "CAN traffic"),
                                       Qt::ALT | Qt::SHIFT | Qt::Key_T,
                                       "canopen.md#the-traffic",
                                       Panel::Behind::messages,
                                       false};
inline constexpr Panel canBusPanel{"canBusDock",
                                   QT_TRANSLATE_NOOP("codewheel::Panels", "CAN bus"),
                                   Qt::ALT | Qt::SHIFT | Qt::Key_N,
                                   "canopen.md#the-panel",
                                   Panel::Behind::state,
                                   false};
inline constexpr Panel canObjectsPanel{"canObjectsDock",
                                       QT_TRANSLATE_NOOP("codewheel::Panels", "Objects"),
                                       Qt::ALT | Qt::SHIFT | Qt::Key_D,
                                       "canopen.md#objects",
                                       Panel::Behind::messages,
                                       false};
inline constexpr std::array canPanels{&canTrafficPanel, &canBusPanel, &canObjectsPanel};

// The views of a CAN bus in the window: nodes, objects and traffic, which are in docks, the pages for
// connecting it and searching for nodes, and the actions that open them.
class CanopenViews final : public BusViews
{
    Q_OBJECT

public:
    CanopenViews(CanopenAtWork &bus, const WindowParts &parts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    QWidget *comparison() const override;
    QMenu *menu() const override;
    void setChosen(std::optional<Place> place) override;
    void setRecordingChosen(bool isChosen) override;
    void open() override;
    bool open(Place place) override; // its row among the nodes, since it has no words
    void connectBus() override { showSettings(); }
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void showFrame() override;
    void askToOperate(const std::function<void()> &then) override;
    void useSettings(const ProgramSettings &settings) override;
    std::any takeWork() override;
    void goOn(const std::any &work) override;
    QAction *actionFor(DataCheck::Action action) const override;

    void showSettings();
    void showSearch();

private:
    // What the bar above the pages asks the user to agree to.
    enum class Asked : std::uint8_t {
        nothing,
        unsureWatch, // that watching may acknowledge frames
        otherMaster, // that frames are sent beside another master
        stopOfNode,  // that a job stops its node for a moment
    };

    void showCurrent() override;
    void showStatus();
    void setBus(CanopenSession *bus); // null: it is about to go
    void tellActions();
    void tellAfresh();
    void listAdapters();
    void connectAs(const KindData &plan);
    void connectUnsure(const KindData &plan);
    void connectTrainingBus();
    void test(const KindData &plan);
    void showOpened();
    void showRefused(const Refusal &why);
    void showState();
    void ask(Asked what, const QString &sentence, const QString &answer);
    void withdraw(Asked what);
    void agree();
    void watchJobs();
    void askToStop(Place place, const Outcome &outcome);
    void askToCommand(int node, canopen::NmtCommand command);
    void sendCommand(int node, canopen::NmtCommand command);
    void tellSent(const FrameSent &sent);
    void takeOver(const std::vector<CanFoundRow> &found);
    void removeChosen();
    void showChosen();
    void startAfresh();
    void disconnectBus();
    void showPlanned();
    void showNewPlan();
    void showName();

    CanopenAtWork &m_bus;
    const WindowParts m_parts;
    CanopenActions &m_actions;
    CanopenStatus m_status;
    InlineMessage *m_notice; // asks the user to agree
    Asked m_asked = Asked::nothing;
    CanopenKeeper *m_keeper;
    OperateQuestion *m_operateQuestion;
    QPointer<CanopenSession> m_session;
    std::optional<Place> m_chosen;
    std::optional<Place> m_wouldStop; // the node that a job asks to stop
    QPointer<QMessageBox> m_commandQuestion;
    CanTrafficView *m_traffic;
    CanBusPanel *m_panel;
    DictionaryView *m_objects;
    CanSearchPage *m_search;
    ConnectPage *m_connection;
    CanSettingsForm *m_interface;
    CanSettingsForm *m_adapter; // at a serial port
    BackgroundSteps m_test;
    bool m_isPlanned = false; // in the project
    CanopenSettings m_wanted; // when an adapter was last to be opened
    ComparisonPage *m_comparison;
};

} // namespace codewheel
