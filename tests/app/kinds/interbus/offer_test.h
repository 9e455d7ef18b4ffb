// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_offer.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/app/window_test.h"
#include "tests/links/modbus_client.h"
#include "widgets/kinds/interbus/offer/offer_page.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/role_label.h"

#include <QAction>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableView>

namespace codewheel::test {

inline constexpr int longestOfferWait = 60'000; // ms

template <class Widget>
Widget &partOf(const QWidget &page, const char *name)
{
    auto *found = page.findChild<Widget *>(QLatin1String(name));
    if (found == nullptr)
        qFatal("no %s", name);
    return *found;
}

// The ring runs in its thread, as in the program.
class OfferTest : public test::WindowTest
{
protected:
    OfferTest() { bus().startThread(std::chrono::milliseconds(1)); }

    OfferPage &offerPage() { return *window().findChild<OfferPage *>(); }
    RingAtWork &ring() { return *shown->plant().first<RingAtWork>(); }
    template <class Condition>
    bool waitFor(Condition condition)
    {
        return QTest::qWaitFor(
            [&] {
                window().showFrame();
                shown->messages().catchUp();
                return condition();
            },
            longestOfferWait);
    }
    void click(const char *name)
    {
        auto &button = partOf<QPushButton>(offerPage(), name);
        ASSERT_TRUE(button.isVisible() && button.isEnabled()) << name;
        QTest::mouseClick(&button, Qt::LeftButton);
    }
    void offer(int seats = 0)
    {
        ringActions().offer->trigger();
        EXPECT_EQ(page(), &offerPage());
        partOf<QSpinBox>(offerPage(), "offerPort").setValue(0);
        if (seats > 0) {
            partOf<QRadioButton>(offerPage(), "eachSeat").click();
            partOf<QSpinBox>(offerPage(), "seats").setValue(seats);
        }
        click("offer");
        ASSERT_TRUE(ring().offer().isOn());
    }
    void planGateway()
    {
        Project project = shown->project().project();
        RingPlan plan = ringPlan(project, firstBus);
        plan.link = {QStringLiteral("modbus-tcp"), {{QStringLiteral("host"), QStringLiteral("gateway")}}};
        setRingPlan(project, firstBus, plan);
        shown->project().edit(std::move(project), QStringLiteral("Connection"));
    }
    int port() { return ring().offer().place().address.section(u':', -1).toInt(); }
    QString status()
    {
        const auto &label = partOf<RoleLabel>(window(), "offerState");
        return label.isVisible() ? label.word() : QString();
    }
    QString inTable(const char *table, int row, int column)
    {
        return partOf<QTableView>(offerPage(), table).model()->index(row, column).data().toString();
    }
    bool isSaid(const QString &part)
    {
        shown->messages().catchUp();
        for (int i = 0; i < shown->messages().rowCount(); ++i)
            for (int column = 0; column < shown->messages().columnCount(); ++column)
                if (shown->messages().index(i, column).data().toString().contains(part))
                    return true;
        return false;
    }
    QString problem()
    {
        for (const auto *message : offerPage().findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }
};

} // namespace codewheel::test
