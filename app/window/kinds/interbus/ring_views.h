// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/bus_views.h"
#include "app/window/kinds/interbus/ring_status.h"
#include "vocabulary/refusal.h"

#include <array>

namespace codewheel {

class ConnectPage;
class GatewayPanel;
class LedRow;
class MasterPanel;
class OfferPage;
class OfferViews;
class OperateQuestion;
class RingActions;
class RingAtWork;
class RingComparison;
class RegistersPage;
class RingConnection;
class RingLinks;
class RingPlanFields;
class TrainingPanel;

inline constexpr Panel masterPanel{"masterDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Master"),
                                   Qt::ALT | Qt::Key_9, "master.md", Panel::Behind::state};
inline constexpr std::array ringPanels{&masterPanel};

// The views of a ring in the window: its master, its training panel, and the comparison with the project.
class RingViews final : public BusViews
{
    Q_OBJECT

public:
    RingViews(RingAtWork &ring, const WindowParts &parts, QObject *parent);

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override;
    QWidget *comparison() const override;
    bool tellsState() const override { return true; }
    void setChosen(std::optional<Place> place) override;
    void open() override;
    void connectBus() override;
    void connectFound(const KindData &plan, const std::vector<KindData> &devices) override;
    void connectTraining() override { connectBus(); } // offered only for one that is planned as such
    bool takesFaultPlans() const override;
    void loadFaultPlan(const QString &path) override;
    void askToOperate(const std::function<void()> &then) override;
    void showFrame() override;
    std::any takeWork() override;
    void goOn(const std::any &work) override;
    void compare() override;
    FaultBanner::Offer offer(const Fault &fault, FaultAction action) const override;
    void act(const Fault &fault, FaultAction action) override;
    QAction *actionFor(DataCheck::Action action) const override;
    bool takesKeys() const override { return true; }
    void setHasKeys(bool has) override;

private:
    void showCurrent() override;
    void leaveActions();
    void sendRun(Place place);
    void goToPositionMode(Place place);
    std::optional<int> chosenSegment() const; // as the master numbers them
    void showState();
    void showTraining();
    QString whyNotAfresh() const;
    void startAfresh();
    void showStatus();
    void showLink();
    void showRefused(const Refusal &why);
    void showPage(QWidget *page);
    void showConnection();
    void showRegisters();
    void showOffer();

    RingAtWork &m_ring;
    const WindowParts m_parts;
    RingActions &m_actions;
    RingStatus m_status;
    RingConnection *m_connection;
    OperateQuestion *m_operateQuestion;
    MasterPanel *m_master;
    GatewayPanel *m_gateway;
    QStackedWidget *m_masterOrGateway; // in one dock
    TrainingPanel *m_training;
    QStackedWidget *m_trainingOrNone; // a ring behind a gateway cannot be simulated
    ConnectPage *m_connect;
    RegistersPage *m_registers;
    RingLinks *m_links;
    OfferPage *m_offerPage;
    OfferViews *m_offer;
    RingComparison *m_comparison;
    LedRow *m_leds;
    RingPlanFields *m_planFields; // in the structure editor
    std::optional<Place> m_chosen;
};

} // namespace codewheel
