// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_page.h"

#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/models/dragged_place.h"
#include "widgets/trend/curve_bar.h"
#include "widgets/trend/note_bar.h"
#include "widgets/trend/shift_bar.h"
#include "widgets/trend/ticks.h"
#include "widgets/trend/track_text.h"
#include "widgets/trend/trend_chart.h"
#include "widgets/trend/trend_values_model.h"

#include <QAction>
#include <QBoxLayout>
#include <QDropEvent>
#include <QLabel>
#include <QStackedWidget>
#include <QTabBar>
#include <QTableView>
#include <QToolButton>

#include <set>

namespace codewheel {
namespace {

constexpr double kibi = 1024;

} // namespace

QString TrendPage::effect() const
{
    return tr("Nothing is sent here.");
}

void TrendPage::addButtonFor(QAction &action)
{
    auto *button = new QToolButton(this);
    button->setDefaultAction(&action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setIconSize({grid::smallIcon, grid::smallIcon});
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(plainLabel(action.text()));
    m_lastLine->addWidget(button);
}

void TrendPage::showTrack(const Track &track)
{
    if (!m_tracks.add(track))
        say(Role::attention,
            tr("No more than %n curves can be shown. Remove one first.", nullptr, int{TrendTracks::most}));
    const auto index = m_tracks.find(track);
    if (!index)
        return;
    m_scales.look();
    showWhatThereIs();
    m_table->selectRow(static_cast<int>(*index));
}

void TrendPage::showWhatThereIs()
{
    m_pages->setCurrentIndex(m_tracks.shown().empty() ? 0 : 1);
    showCurve();
    showColumns();
}

void TrendPage::showCurve()
{
    const auto curve = currentCurve();
    m_curve->setCurve(curve);
    m_shift->setArchive(curve ? m_histories.archiveOf(m_tracks.shown().at(*curve).track.place) : nullptr);
}

void TrendPage::takeArchives()
{
    std::set<BusId> buses;
    for (const Archive *archive : m_histories.archives())
        for (const Place place : archive->places())
            buses.insert(place.bus);
    m_tracks.setPassing(buses);
    m_together->setVisible(m_histories.archives().size() > 1);
    showCurve();
    showValues();
}

void TrendPage::beginTogether()
{
    Archive *archive = m_shift->archive();
    const auto its = archive != nullptr ? archive->span() : std::nullopt;
    std::optional<Instant> begin;
    for (const TrendTracks::Shown &shown : m_tracks.shown()) {
        const History *history = m_histories.of(shown.track.place, shown.track.channel);
        const auto span = history != nullptr ? history->span() : std::nullopt;
        if (span && m_histories.archiveOf(shown.track.place) != archive)
            begin = std::min(begin.value_or(span->from), span->from);
    }
    if (its && begin)
        archive->setShift(archive->shift() + *begin - its->from);
    else
        say(Role::attention, tr("There is no other curve to begin with. Add one first."));
}

// All begin with the one that begins last, and show what any of them shows.
void TrendPage::layTogether()
{
    std::optional<Instant> begin;
    for (const Archive *archive : m_histories.archives())
        if (const auto its = archive->span())
            begin = std::max(begin.value_or(its->from), its->from);
    for (Archive *archive : m_histories.archives())
        if (const auto its = archive->span())
            archive->setShift(archive->shift() + *begin - its->from);
    bool hasRoom = true;
    for (const Track &track : tracksOfRecordings())
        for (const Archive *archive : m_histories.archives())
            for (const Place place : archive->places())
                if (place.node == track.place.node && archive->of(place, track.channel) != nullptr)
                    hasRoom = m_tracks.add({place, track.channel, track.bit}) && hasRoom;
    if (!hasRoom)
        say(Role::attention, tr("There is no room for more curves. Remove some first."));
    else if (m_tracks.shown().empty())
        say(Role::attention, tr("Add a curve of one of the recordings first."));
    m_view->showAll();
}

std::vector<Track> TrendPage::tracksOfRecordings() const
{
    std::vector<Track> tracks;
    for (const TrendTracks::Shown &shown : m_tracks.shown())
        if (m_histories.archiveOf(shown.track.place) != nullptr)
            tracks.push_back(shown.track);
    return tracks;
}

void TrendPage::putCursorAOnB()
{
    const auto &[a, b] = m_view->scene().cursors;
    if (Archive *archive = m_shift->archive(); archive != nullptr && a && b)
        archive->setShift(archive->shift() + *b - *a);
}

std::optional<std::size_t> TrendPage::currentCurve() const
{
    const int row = m_table->currentIndex().row();
    return row >= 0 && row < m_values->rowCount() ? std::optional(static_cast<std::size_t>(row))
                                                  : std::nullopt;
}

void TrendPage::showFrame()
{
    if (!m_pause->isChecked() && !m_tracks.shown().empty())
        m_view->showFrame();
}

// What is at the cursors at once; what goes through all samples between them once they rest.
void TrendPage::showValues()
{
    m_values->show(m_view->scene(), m_scales, false);
    m_soon.start();
    showCursors();
}

void TrendPage::bringUpToDate()
{
    m_view->showAnew();
    showCursors();
    showMemory();
    m_soon.stop();
    showStatistics();
}

// Goes through all samples between the cursors.
void TrendPage::showStatistics()
{
    m_values->show(m_view->scene(), m_scales, true);
}

QString TrendPage::markAtCursor() const
{
    const TrendScene &scene = m_view->scene();
    const auto cursor = scene.cursors.at(scene.chosenCursor);
    QStringList texts;
    for (const Mark &mark : scene.marks)
        if (mark.at == cursor)
            texts << markText(mark);
    return texts.join(QStringLiteral("; "));
}

void TrendPage::showCursors()
{
    const TrendScene &scene = m_view->scene();
    const QLocale locale;
    const Instant length = scene.span.to - scene.span.from;
    const auto &[a, b] = scene.cursors;
    m_shift->setCursors(a || b, a && b);
    QStringList parts;
    if (a)
        parts << QStringLiteral("A  %1").arg(timeText(*a, length, locale));
    if (b)
        parts << QStringLiteral("B  %1").arg(timeText(*b, length, locale));
    if (a && b)
        parts << QStringLiteral("B \u2212 A  %1").arg(durationText(*b - *a, locale));
    if (parts.isEmpty())
        parts << tr("Click into the curves for cursor A, with Shift for cursor B.");
    if (const QString mark = markAtCursor(); !mark.isEmpty())
        parts << mark;
    m_cursors->setText(parts.join(QStringLiteral("     ")));
}

// How far back it goes, and will go.
void TrendPage::showMemory()
{
    const QLocale locale;
    const auto span = m_histories.span();
    const auto reach = m_histories.reach();
    const auto megabytes = [&](std::size_t bytes) {
        return locale.toString(static_cast<double>(bytes) / kibi / kibi, 'f', 0);
    };
    QStringList parts;
    parts << tr("Kept: %1, %2 of %3 MB", "a duration, megabytes")
                 .arg(roughDurationText(span ? span->to - span->from : Instant(), locale),
                      megabytes(m_histories.bytes()), megabytes(m_histories.limit()));
    if (reach)
        parts << tr("enough for %1 at the present rate").arg(roughDurationText(*reach, locale));
    if (m_histories.dropped() > 0)
        parts << tr("%n cycles came too fast and are missing", nullptr,
                    static_cast<int>(std::min<std::uint64_t>(m_histories.dropped(), INT_MAX)));
    m_memory->setText(parts.join(QStringLiteral("; ")));
}

void TrendPage::showMark(bool forward)
{
    if (m_view->goToMark(forward))
        m_message->withdraw();
    else
        say(Role::attention, forward ? tr("There is no later mark.") : tr("There is no earlier mark."));
}

// At the cursor that keys move, or else at the newest value.
void TrendPage::askNote()
{
    const TrendScene &scene = m_view->scene();
    const auto all = m_histories.span();
    const auto at = scene.cursors.at(scene.chosenCursor) ? scene.cursors.at(scene.chosenCursor)
                    : all                                ? std::optional(all->to)
                                                         : std::nullopt;
    if (!at)
        return;
    QString before;
    for (const Mark &mark : m_histories.marks())
        if (mark.isNote() && mark.at == *at)
            before = std::get<QString>(mark.what);
    m_note->ask(*at, timeText(*at, scene.span.to - scene.span.from, QLocale()), before);
}

void TrendPage::say(Role role, const QString &sentence, const QString &action)
{
    m_message->showMessage(role, sentence, action);
}

void TrendPage::dragEnterEvent(QDragEnterEvent *event)
{
    if (const auto place = placeDragged(*event->mimeData()); place && m_buses.encoder(*place) != nullptr)
        event->acceptProposedAction();
}

void TrendPage::dropEvent(QDropEvent *event)
{
    if (const auto place = placeDragged(*event->mimeData()); place && m_buses.encoder(*place) != nullptr) {
        event->acceptProposedAction();
        showTrack({*place, Channel::position, {}});
    }
}

} // namespace codewheel
