// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "app/window/buses/bus_views.h"
#include "app/window/kinds/canopen/canopen_status.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "vocabulary/refusal.h"

#include <QPointer>

#include <optional>

namespace codewheel {

class CanSettingsForm;
class CanopenActions;
class CanopenAtWork;
class CanopenKeeper;
class CanopenSession;
class ComparisonPage;
class ConnectPage;
class OperateQuestion;

// The views of a CAN bus in the window: the page for connecting it, and the actions that open it.
class CanopenViews final : public BusViews
{
    Q_OBJECT

public:
    CanopenViews(CanopenAtWork &bus, const WindowParts &parts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    QWidget *comparison() const override;
    QMenu *menu() const override;
    void open() override;
    void connectBus() override { showSettings(); }
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void showFrame() override;
    void askToOperate(const std::function<void()> &then) override;
    std::any takeWork() override;
    void goOn(const std::any &work) override;
    QAction *actionFor(DataCheck::Action action) const override;

    void showSettings();

private:
    // What the bar above the pages asks the user to agree to.
    enum class Asked : std::uint8_t {
        nothing,
        unsureWatch, // that watching may acknowledge frames
        otherMaster, // that frames are sent beside another master
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
    ConnectPage *m_connection;
    CanSettingsForm *m_interface;
    CanSettingsForm *m_adapter; // at a serial port
    BackgroundSteps m_test;
    bool m_isPlanned = false; // in the project
    CanopenSettings m_wanted; // when an adapter was last to be opened
    ComparisonPage *m_comparison;
};

} // namespace codewheel
