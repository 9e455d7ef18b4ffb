// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/screenshots/kinds/interbus/ring_pictures.h"
#include "app/screenshots/scene.h"
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_offer.h"
#include "kinds/interbus/simulator/fault_plan.h"
#include "widgets/kinds/interbus/offer/offer_page.h"
#include "widgets/kinds/interbus/offer/seat_panel.h"
#include "widgets/kinds/interbus/offer/seats_view.h"

#include <QAction>
#include <QTableView>
#include <QTabWidget>

namespace codewheel {
namespace {

using namespace scene;

constexpr int seatsOfClass = 12;

ServedClient::Time after(int seconds)
{
    return ServedClient::Time(
        std::chrono::milliseconds(TrainingWindow::begin().addSecs(seconds).toMSecsSinceEpoch()));
}

ServedClient client(unsigned id, int place, int unit, std::uint64_t requests, std::uint64_t writes)
{
    ServedClient client{.id = id,
                        .address = QStringLiteral("192.168.0.%1:50112").arg(place),
                        .since = after(static_cast<int>(id)),
                        .unit = unit,
                        .requests = requests,
                        .writes = writes,
                        .refused = id % 2};
    if (writes > 0)
        client.written = ServedClient::Written{
            unit, {fraba.node, 0x0200'00FF, {}}, after(static_cast<int>(requests % 60))};
    return client;
}

std::vector<ServedClient> clientsOfClass()
{
    return {client(1, 31, 1, 18'204, 12), client(2, 32, 2, 17'990, 4), client(3, 33, 3, 310, 0),
            client(5, 35, 5, 9'471, 31)};
}

std::vector<Seat> seatsWith(const std::vector<ServedClient> &clients)
{
    std::vector<Seat> seats;
    for (int unit = 1; unit <= seatsOfClass; ++unit)
        seats.push_back({.unit = unit,
                         .role = Role::running,
                         .state = QStringLiteral("RUN"),
                         .in = 0x0000'3039,
                         .out = 0});
    for (const ServedClient &one : clients) {
        Seat &seat = seats[static_cast<std::size_t>(*one.unit - 1)];
        seat.clients = 1;
        seat.written = one.written;
        if (one.written)
            seat.in = 0xC200'00FF, seat.out = one.written->word.word;
    }
    Seat &disturbed = seats[2];
    disturbed.role = Role::fault;
    disturbed.state = QStringLiteral("BUS FAIL");
    disturbed.in.reset();
    disturbed.out.reset();
    disturbed.faults = trainingFaultText(TrainingFault::wireBreak, fraba.node, 1);
    return seats;
}

OfferPage *pageOf(TrainingWindow &shown)
{
    shown.window().findChild<RingActions *>()->offer->trigger();
    shown.advance(whileMilliseconds);
    return shown.window().findChild<OfferPage *>();
}

// What a trainer does to a seat, as in the panel Training.
void treatSeat(TrainingWindow &shown, OfferPage &page)
{
    page.findChild<QTableView *>(QStringLiteral("seatTable"))->selectRow(2);
    const RingAtWork &ring = *shown.plant().first<RingAtWork>();
    page.offered().seats().panel().showSeat(3, ring.id(), ring.sharedControls());
}

OfferPage *offeredIn(TrainingWindow &shown, const char *table)
{
    OfferPage *page = pageOf(shown);
    const OfferedPlace place{.address = QStringLiteral("192.168.0.12:1502"),
                             .reachesOthers = true,
                             .readOnly = false,
                             .seats = seatsOfClass};
    page->setPlace(place);
    const auto clients = clientsOfClass();
    page->offered().setDevices(servedDevices(shown.bus().structure(), shown.bus().catalog()));
    page->offered().showClients(clients, {.came = 6, .left = 2, .refused = 1});
    page->offered().seats().show(seatsWith(clients));
    auto *tables = page->findChild<QTabWidget *>(QStringLiteral("offeredTables"));
    tables->setCurrentWidget(page->findChild<QWidget *>(QLatin1String(table)));
    treatSeat(shown, *page);
    shown.advance(whileMilliseconds);
    return page;
}

} // namespace

std::vector<Picture> offerPictures()
{
    return {pictureOf("offer", [](TrainingWindow &shown) -> QWidget * { return pageOf(shown); }),
            pictureOf("offered",
                      [](TrainingWindow &shown) -> QWidget * { return offeredIn(shown, "servedClients"); }),
            pictureOf("offered-seats",
                      [](TrainingWindow &shown) -> QWidget * { return offeredIn(shown, "seatPage"); })};
}

} // namespace codewheel
