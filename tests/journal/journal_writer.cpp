// SPDX-License-Identifier: GPL-3.0-or-later
// The child of test_killed.cpp: keeps messages, and the ledger of a training bus on which handshakes run, and
// prints what it was promised to be on disk, until it is killed.
//
//   journal_writer MESSAGES LEDGER RUN
//
// "message N": messages 0..N of this run are kept. "job": a job is noted. "write": one more write is counted.
#include "catalog/catalog.h"
#include "journal/ledger_keeper.h"
#include "journal/message_store.h"
#include "kinds/interbus/ring/ring_session.h"
#include "kinds/interbus/simulator/training_bus.h"

#include <QCoreApplication>

#include <cstdio>

namespace {

using namespace codewheel;

void say(const QString &line)
{
    std::fputs(qPrintable(line + u'\n'), stdout);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    const Catalog catalog = Catalog::builtIn();
    RingSession bus(makeTrainingBus(catalog).link, catalog, QDateTime::currentDateTime());
    if (arguments.size() != 4 || !bus.open(RingSession::Start::operating))
        return 1;
    MessageStore store({.file = arguments[1]});
    const LedgerKeeper keeper(bus, DatabasePlace::file(arguments[2]));
    if (keeper.problem())
        return 1;
    bus.advance(10);
    EncoderSession &encoder = *bus.encoder(NodeId("1.0"));
    // After the keeper, which was connected first.
    QObject::connect(&encoder, &EncoderSession::jobAboutToStart, &encoder,
                     [] { say(QStringLiteral("job")); });
    QObject::connect(&encoder, &EncoderSession::eepromWritten, &encoder, [](int writes) {
        for (int i = 0; i < writes; ++i)
            say(QStringLiteral("write"));
    });

    for (int number = 0;; ++number) {
        store.add({.severity = number % 7 == 0 ? Severity::fault : Severity::information,
                   .id = MessageId::training,
                   .arguments = {QStringLiteral("%1 %2").arg(arguments[3]).arg(number)}},
                  QDateTime::currentDateTime());
        if (number % 5 == 0) {
            store.flush();
            say(QStringLiteral("message %1").arg(number));
        }
        if (!encoder.runningJob())
            (void)encoder.start(WriteParameters{
                .values = {{Parameter::steps, 256 + number % 100}, {Parameter::revolutions, 1 + number % 2}},
                .previous = {}});
        bus.advance(7);
    }
}
