// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/interbus/ring_pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "widgets/connect/connect_page.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"

#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QDeadlineTimer>
#include <QDockWidget>
#include <QLineEdit>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using namespace scene;
using namespace std::chrono_literals;

constexpr QSize withAllSettings(1280, 1330);
constexpr int untilTested = 10'000; // ms
constexpr int untilCounted = 3'000; // ms
constexpr int betweenLooks = 20;    // ms

// A gateway whose encoders stand still, in a clock of its own: the same in each picture.
class StandingGateway final : public RegisterPort
{
public:
    Result<void> open() override { return {}; }
    void close() override {}
    Done read(RegisterArea area, int first, std::span<Register> to) override
    {
        m_now += roundTrip;
        if (first + static_cast<int>(to.size()) > static_cast<int>(in.size()))
            return tl::unexpected(RegisterError{RegisterError::Kind::exception, 2, {}});
        if (area == RegisterArea::input)
            std::ranges::copy_n(in.begin() + first, static_cast<std::ptrdiff_t>(to.size()), to.begin());
        else
            std::ranges::fill(to, Register{0});
        return {};
    }
    Done write(int, std::span<const Register>) override
    {
        m_now += roundTrip;
        return {};
    }
    Done writeAndRead(int, std::span<const Register>, int readFirst, std::span<Register> to) override
    {
        return read(RegisterArea::holding, readFirst, to);
    }
    Instant now() const override { return m_now; }
    void wait(Instant until) override { m_now = std::max(m_now, until); }
    void interrupt() override {}
    QString name() const override { return QStringLiteral("192.168.0.5:502, unit 1"); }

private:
    static constexpr Instant roundTrip = 1'200us;
    // Of the devices of the training bus, high word first.
    static constexpr std::array<Register, 11> in{0x0000, 0x3039, 0x000F, 0x55FC, 0x0322, 0x0079,
                                                 0x5A11, 0x0000, 0x30D4, 0x0000, 0x1267};

    Instant m_now{};
};

RingActions &ringActions(TrainingWindow &shown)
{
    return *shown.window().findChild<RingActions *>();
}

ConnectPage &connection(TrainingWindow &shown)
{
    return *shown.window().findChild<ConnectPage *>(QStringLiteral("ringConnection"));
}

// As entered by somebody who has just come to the machine.
void enterGateway(TrainingWindow &shown)
{
    shown.plant().first<RingAtWork>()->setPorts(
        [](const GatewaySettings &) { return std::make_unique<StandingGateway>(); });
    ringActions(shown).disconnectBus->trigger();
    ringActions(shown).connection->trigger();
    ConnectPage &page = connection(shown);
    page.findChild<QComboBox *>(QStringLiteral("link"))->setCurrentIndex(1); // Modbus/TCP
    page.findChild<QLineEdit *>(QStringLiteral("host"))->setText(QStringLiteral("192.168.0.5"));
}

void connectGateway(TrainingWindow &shown)
{
    enterGateway(shown);
    press(connection(shown), ConnectPage::tr("&Connect"));
    shown.advance(whileMilliseconds);
}

QWidget *testedConnection(TrainingWindow &shown)
{
    enterGateway(shown);
    ConnectPage &page = connection(shown);
    press(page, ConnectPage::tr("&Test"));
    // The test has a thread of its own.
    for (const QDeadlineTimer end(untilTested); page.isTesting() && !end.hasExpired();)
        QCoreApplication::processEvents(QEventLoop::AllEvents, betweenLooks);
    shown.advance(whileMilliseconds);
    return &page;
}

QWidget *registersAtWork(TrainingWindow &shown)
{
    connectGateway(shown);
    ringActions(shown).registers->trigger();
    shown.advance(whileMilliseconds);
    return shown.window().findChild<RegistersPage *>();
}

QWidget *panelAtWork(TrainingWindow &shown)
{
    connectGateway(shown);
    shown.window().actions().monitors->trigger(); // without a page the panels have their room
    shown.advance(untilCounted);
    return dock(shown, "masterDock");
}

} // namespace

std::vector<Picture> gatewayPictures()
{
    return {pictureOf("connection", testedConnection, withAllSettings),
            pictureOf("registers", registersAtWork), pictureOf("gateway-panel", panelAtWork)};
}

} // namespace codewheel
