// SPDX-License-Identifier: GPL-3.0-or-later
// One of several programs that share the files of the journal; the child of test_parallel.cpp.
//
//   journal_peer count FILE TIMES     counts that many writes, also reading the ledger in between
//   journal_peer keep FILE TIMES      keeps that many messages, each on request; prints the number of each
//   journal_peer look FILE TIMES      reads the messages that many times
#include "journal/ledger.h"
#include "journal/message_store.h"

#include <QCoreApplication>

#include <cstdio>
#include <unistd.h>

namespace {

using namespace codewheel;

int failed(const DatabaseError &error)
{
    std::fprintf(stderr, "%s\n", qPrintable(error.reason));
    return 1;
}

int countWrites(const DatabasePlace &place, int times)
{
    const EncoderIdentity fraba{.by = CountedBy::place,
                                .vendor = {},
                                .serialNumber = {},
                                .project = {},
                                .place = {firstBus, NodeId("1.0")}};
    auto ledger = Ledger::open(place);
    if (!ledger)
        return failed(ledger.error());
    for (int i = 0; i < times; ++i) {
        const auto other = Ledger::open(place); // like the command line, which counts for ring and line
        if (!other)
            return failed(other.error());
        const auto id = ledger->begin({.at = QDateTime::currentDateTimeUtc(),
                                       .identity = fraba.key(),
                                       .place = fraba.place,
                                       .planned = 1});
        if (!id)
            return failed(id.error());
        if (const auto counted = ledger->count(*id, 1); !counted)
            return failed(counted.error());
        if (const auto settled = ledger->settle(*id, {}); !settled)
            return failed(settled.error());
    }
    return 0;
}

int keepMessages(const QString &file, int times)
{
    MessageStore store({.file = file});
    for (int i = 0; i < times; ++i) {
        if (std::getchar() == EOF)
            return 0;
        store.add({.severity = Severity::fault, .id = MessageId::training, .arguments = {QString::number(i)}},
                  QDateTime::currentDateTime());
        store.flush();
        if (!MessageTable::open(*store.place())) // like their view
            return 1;
        std::printf("%d\n", i);
        std::fflush(stdout);
    }
    ::pause();
    return 0;
}

int look(const DatabasePlace &place, int times)
{
    for (int i = 0; i < times; ++i) {
        const auto table = MessageTable::open(place);
        if (!table)
            return failed(table.error());
        if (const auto messages = table->read(0, 1'000); !messages)
            return failed(messages.error());
    }
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 4)
        return 2;
    const QString &what = arguments[1];
    const int times = arguments[3].toInt();
    if (what == QStringLiteral("keep"))
        return keepMessages(arguments[2], times);
    const DatabasePlace place = DatabasePlace::file(arguments[2]);
    return what == QStringLiteral("count") ? countWrites(place, times) : look(place, times);
}
