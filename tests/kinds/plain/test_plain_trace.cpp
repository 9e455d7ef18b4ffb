// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus unknown when the trace was written.
#include "bus/buses.h"
#include "tests/kinds/plain/plain_bus.h"
#include "tests/support/model_tester.h"
#include "widgets/models/traffic_model.h"
#include "widgets/trace/trace_view.h"

#include <QTableView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

TEST(PlainTrace, ShowsWhatTheBusTellsOfItsTraffic)
{
    const Catalog catalog = Catalog::builtIn();
    Buses buses;
    test::PlainBus plain(catalog);
    buses.add(plain);
    TraceView view(buses);
    view.setEncoder(plain.encoder(test::plainGate));
    TrafficModel &rows = *view.model(test::plainGate);
    const test::ModelTester tester(rows);
    plain.tellTraffic({.at = 1'500ms,
                       .place = test::plainGate,
                       .kind = TrafficKind::sent,
                       .bytes = "\x10\xAB",
                       .meaning = [] { return QStringLiteral("gate, open"); }});
    plain.tellTraffic({.place = test::plainHoist, .meaning = {}});
    ASSERT_EQ(rows.rowCount(), 1);
    EXPECT_EQ(view.findChild<QTableView *>()->model(), &rows);
    QStringList titles;
    QStringList cells;
    for (int column = 0; column < rows.columnCount(); ++column) {
        titles << rows.headerData(column, Qt::Horizontal).toString();
        cells << rows.index(0, column).data().toString();
    }
    EXPECT_EQ(titles.join(u'|'), QStringLiteral("Time|\u0394 ms|\u2195|Hex|Meaning|Remark"));
    EXPECT_EQ(cells.join(u'|'), QStringLiteral("14:02:01.500||sent|10 AB|gate, open|"));
    EXPECT_EQ(QString::fromUtf8(rows.csv(test::plainGate)),
              QStringLiteral("time,since_last_ms,direction,bytes,meaning,remark,bus,place\r\n"
                             "2026-03-01T14:02:01.500Z,,\"sent\",10 AB,\"gate, open\",\"\",9,n:2\r\n"));
    view.setEncoder(nullptr);
    buses.remove(&plain);
}

} // namespace
} // namespace codewheel
