// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "app/window/buses/bus_views.h"
#include "app/window/connect/link_test.h"
#include "bus/check_outcome.h"
#include "project/project.h"
#include "vocabulary/refusal.h"
#include "vocabulary/role.h"

#include <QPointer>

namespace codewheel {

class AskedBus;
class AskedBusActions;
class AskedBusAtWork;
class AskedBusKeeper;
class ComparisonPage;
class ConnectPage;
class OperateQuestion;
class Page;
class RoleLabel;
struct OperateWarning;

// What the status line shows of an open bus.
struct ShownStatus
{
    Role role;
    QString text;
    QString figures{}; // its tooltip; empty: stays as it is
};

// The views of a bus whose encoders are asked, as far as they do not depend on its kind: the pages for
// connecting it, searching and comparing, the test of its link, and its place in menu and project.
class AskedBusViews : public BusViews
{
    Q_OBJECT

public:
    ~AskedBusViews() override;

    QWidget *comparison() const override;
    QMenu *menu() const override;
    void connectBus() override { showSettings(); }
    void askToOperate(const std::function<void()> &then) override;
    void showFrame() override;
    std::any takeWork() override;
    void goOn(const std::any &work) override;
    QAction *actionFor(DataCheck::Action action) const override;
    bool takesKeys() const override { return true; }
    void setHasKeys(bool has) override;

    virtual void showSettings();
    void showSearch();

protected:
    // What is of its kind in words only.
    struct Traits
    {
        QString name;           // in object names: "can"
        const char *connecting; // in the manual
        std::function<OperateWarning(const EncoderBus &bus)> operateWarning;
        QString whyNotDisconnected;
        RefusalCode mayAgree; // to what its opening was refused for, with this answer
        QString agreement;
    };

    // All of them outlive it.
    AskedBusViews(AskedBusAtWork &bus, AskedBusActions &actions, const WindowParts &parts, Traits traits,
                  QObject *parent);
    // The end of its construction, with what its kind has made for it.
    void begin(AskedBusKeeper &keeper, Page &search);

    const WindowParts &parts() const { return m_parts; }
    InlineMessage &notice() const { return *m_notice; } // asks the user to agree
    ConnectPage &connection() const { return *m_connection; }
    AskedBus *session() const; // null: none is open
    virtual void listPorts();
    virtual void keepLink(const KindData &plan); // in the project
    const std::optional<Place> &chosen() const { return m_chosen; }
    void choose(std::optional<Place> place);

    void tellActions();
    void afterLeaving(const std::function<void()> &then); // once the user agrees to leave the present bus
    void connectSimulated();
    void startAfresh();

    // Of the encoders that are planned on it.
    template <class Address>
    std::vector<Address> plannedAddresses() const
    {
        std::vector<Address> addresses;
        for (const ProjectDevice &encoder : plannedEncoders())
            addresses.push_back(Address::of(encoder.place().node));
        return addresses;
    }
    // `rest`: what the check wants besides its link.
    template <class Check, class Link, class... Rest>
    void startTest(std::unique_ptr<Link> link, Rest &&...rest)
    {
        beginTest();
        m_test.start(std::make_unique<LinkTest<Check, Link>>(
            std::move(link),
            [this](const auto &finding) {
                addStep(finding.outcome, Check::stepText(finding.step, finding.address), finding.sentence,
                        finding.why);
            },
            std::forward<Rest>(rest)...));
    }

private:
    virtual void setBus(AskedBus *bus) = 0; // null: it is about to go
    virtual ShownStatus status() const = 0; // of the open bus
    virtual void showChosen() = 0;
    virtual void test(const KindData &plan) = 0;
    virtual KindData wanted(const KindData &plan) const { return plan; } // with what its page does not show
    virtual TrainingArea *training() const { return nullptr; }           // its panel; null: it has none
    virtual void showOpened();
    virtual void showSimulated() {}
    virtual void showEncoders() { tellActions(); } // some have come or gone, or the bus has
    virtual void jobEnded(const EncoderSession &, const Outcome &) {}
    virtual std::any takeRows() { return {}; } // that its pages have collected
    virtual void showRows(const std::any &) {} // those

    void showCurrent() override;
    void connectAs(const KindData &plan);
    void connectAgreed(const KindData &plan); // to what the page asked
    void showRefused(const Refusal &why);
    void watchJobs();
    void follow(AskedBus *bus);
    void showStatus();
    void tellAfresh();
    void removeChosen();
    void disconnectBus();
    void showPlanned();
    void showNewPlan();
    void showName();
    std::span<const ProjectDevice> plannedEncoders() const;
    void beginTest();
    void addStep(CheckOutcome outcome, const QString &what, const QString &sentence,
                 const std::optional<Refusal> &why);

    AskedBusAtWork &m_bus;
    AskedBusActions &m_actions;
    const WindowParts m_parts;
    const Traits m_traits;
    RoleLabel *m_state; // in the status line
    InlineMessage *m_notice;
    OperateQuestion *m_operateQuestion;
    ConnectPage *m_connection;
    ComparisonPage *m_comparison;
    AskedBusKeeper *m_keeper = nullptr;
    Page *m_search = nullptr;
    QPointer<AskedBus> m_session;
    std::optional<Place> m_chosen;
    BackgroundSteps m_test;
    bool m_isPlanned = false; // in the project
};

} // namespace codewheel
