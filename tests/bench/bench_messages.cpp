// SPDX-License-Identifier: GPL-3.0-or-later
// A million messages on disk: the time to keep them, to open them, to scroll a page, to filter and to search;
// and the longest time for which the window was blocked.
#include "journal/message_store.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/places.h"
#include "widgets/look/appearance.h"
#include "widgets/messages/messages_view.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>
#include <cstdio>

namespace {

using namespace codewheel;

constexpr int messageTotal = 1'000'000;
constexpr int pages = 500;
constexpr QSize viewSize(1200, 400);

double milliseconds(const QElapsedTimer &clock)
{
    return static_cast<double>(clock.nsecsElapsed()) * 1e-6;
}

Message messageAt(int i)
{
    const Place place{firstBus, DeviceNumber{i % 8 + 1, 0}.node()};
    if (i % 1'000 == 0)
        return {.place = place,
                .severity = Severity::fault,
                .id = MessageId::deviceFault,
                .arguments = {std::int64_t{3}, Word{0x86000000}}};
    if (i % 10 == 0)
        return {.place = place,
                .id = MessageId::parametersWritten,
                .arguments = {std::int64_t{1}, std::int64_t{1}, QStringLiteral("Steps = %1").arg(i)}};
    return {.place = place, .id = MessageId::wordWritten, .arguments = {static_cast<Word>(0x02000000 + i)}};
}

void keepAll(MessageStore &store)
{
    const auto begin = QDateTime::currentDateTime().addDays(-30);
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < messageTotal; ++i)
        store.add(messageAt(i), begin.addMSecs(i * 2'000LL));
    const double added = milliseconds(clock);
    store.flush();
    std::printf("keep: %.2f us each for whoever adds them, all on disk after %.1f s\n",
                added * 1'000 / messageTotal, milliseconds(clock) / 1'000);
}

// Waits for the end of the search; reports the longest turn of the event loop, and when the first page
// appeared.
void search(MessageModel &messages, const char *name, const MessageFilter &filter)
{
    QElapsedTimer clock;
    clock.start();
    double longest = 0;
    double first = 0;
    messages.setFilter(filter);
    do {
        QElapsedTimer turn;
        turn.start();
        messages.refresh();
        QApplication::processEvents();
        longest = std::max(longest, milliseconds(turn));
        if (first == 0 && messages.rowCount() > 0)
            first = milliseconds(clock);
        QThread::msleep(1);
    } while (messages.searched());
    std::printf("%s: %d found, the first after %.0f ms, all after %.0f ms, longest turn %.1f ms\n", name,
                messages.rowCount(), first, milliseconds(clock), longest);
}

void scroll(QTableView &table)
{
    std::vector<double> times;
    QScrollBar &bar = *table.verticalScrollBar();
    for (int i = 0; i < pages; ++i) {
        QElapsedTimer clock;
        clock.start();
        if (i % 10 == 0) // and sometimes far away
            bar.setValue(static_cast<int>(static_cast<qint64>(bar.maximum()) * (i * 37 % pages) / pages));
        else
            bar.triggerAction(QAbstractSlider::SliderPageStepAdd);
        QApplication::processEvents();
        times.push_back(milliseconds(clock));
    }
    std::ranges::sort(times);
    std::printf("scroll: a page in %.1f ms (median), %.1f ms at most\n", times[times.size() / 2],
                times.back());
}

} // namespace

int main(int argc, char **argv)
{
    QApplication application(argc, argv);
    applyAppearance(application, {});
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("messages.sqlite"));
    {
        MessageStore store({.file = file, .largestSize = 1'000'000'000});
        keepAll(store);
    }
    QElapsedTimer clock;
    clock.start();
    MessageStore store({.file = file, .largestSize = 1'000'000'000});
    MessageModel messages(store);
    MessagesView view(messages);
    view.resize(viewSize);
    view.show();
    while (messages.rowCount() == 0)
        messages.refresh();
    QApplication::processEvents();
    const double seen = milliseconds(clock);
    messages.catchUp();
    std::printf("open: %.0f MB, %.0f ms until the newest are seen, %.0f ms until %d rows are known\n",
                static_cast<double>(QFileInfo(file).size()) * 1e-6, seen, milliseconds(clock),
                messages.rowCount());
    scroll(*view.findChild<QTableView *>());
    search(messages, "filter by severity", {.least = Severity::fault});
    search(messages, "filter by place", {.place = {.all = false, .at = "2.0"_ring}});
    search(messages, "search a rare text", {.text = QStringLiteral("Steps = 777770")});
    search(messages, "search a frequent text", {.text = QStringLiteral("written")});
    return 0;
}
