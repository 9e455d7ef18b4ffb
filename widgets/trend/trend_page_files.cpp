// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a trend: pictures, tables, and what is printed.
#include "project/file_access.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/save_file.h"
#include "widgets/trend/trend_export.h"
#include "widgets/trend/trend_page.h"
#include "widgets/trend/trend_values_model.h"

#include <QAction>
#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSvgGenerator>
#include <QTableView>

#include <climits>
#include <set>

namespace codewheel {
namespace {

constexpr QSize pictureSize(1600, 900);
constexpr QSize paperSize(1000, 620);
constexpr int dotsPerInch = 96;
constexpr const char *filesTopic = "trend.md#pictures-and-files";

QByteArray svgOf(const TrendView &view)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setSize(pictureSize);
    svg.setViewBox(QRect(QPoint(), pictureSize));
    svg.setResolution(dotsPerInch);
    svg.setTitle(TrendPage::tr("Trend"));
    QPainter painter(&svg);
    view.draw(painter, pictureSize);
    painter.end();
    return buffer.data();
}

QByteArray pngOf(const TrendView &view)
{
    QImage image(pictureSize, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    view.draw(painter, pictureSize);
    painter.end();
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

} // namespace

void TrendPage::askPicture()
{
    const QString path = askSaveFile(this, tr("Save the picture"), tr("trend.png"),
                                     {tr("Pictures (*.png)"), tr("Drawings (*.svg)")}, filesTopic);
    if (!path.isEmpty())
        savePicture(path);
}

bool TrendPage::savePicture(const QString &path)
{
    const bool isSvg = path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive);
    const auto saved = replaceFile(path, isSvg ? svgOf(*m_view) : pngOf(*m_view), OldFile::goes);
    if (!saved)
        sayNotWritten(path, whyNotWritten(saved.error()));
    else
        say(Role::running, tr("%1 is written.").arg(path));
    return saved.has_value();
}

void TrendPage::sayNotWritten(const QString &path, const QString &why)
{
    say(Role::attention, tr("%1 was not written: %2", "file, reason").arg(path, why));
}

std::optional<PrintedView> TrendPage::printedView() const
{
    if (m_tracks.shown().empty())
        return {};
    PrintedPicture picture{.drawing = QPicture(), .size = paperSize};
    QPainter painter(&picture.drawing);
    m_view->draw(painter, paperSize);
    painter.end();
    return PrintedView{.title = title(),
                       .place = {},
                       .device = {},
                       .pictures = {picture},
                       .values = {{tr("Cursors"), m_cursors->text()}},
                       .table = m_table};
}

// Nothing: there are no two cursors, or nothing is kept.
std::optional<TimeSpan> TrendPage::spanOf(Extract what) const
{
    const auto &[a, b] = m_view->scene().cursors;
    switch (what) {
    case Extract::seen:
        return m_view->scene().span;
    case Extract::betweenCursors:
        return a && b ? std::optional(TimeSpan{std::min(*a, *b), std::max(*a, *b)}) : std::nullopt;
    case Extract::all:
        return m_view->timeOfCurves();
    }
    return {};
}

CsvStyle TrendPage::csvStyle() const
{
    const QTimeZone zone = QTimeZone::systemTimeZone();
    if (m_forSpreadsheets->isChecked())
        return CsvStyle(QLocale(), zone);
    return m_withDates->isChecked() ? CsvStyle::withDates(zone) : CsvStyle();
}

void TrendPage::askExport(Extract what)
{
    const QString path =
        askSaveFile(this, tr("Export the trend"), tr("trend.csv"), {tr("Tables (*.csv)")}, filesTopic);
    if (!path.isEmpty())
        exportTo(path, what);
}

TrendColumn TrendPage::columnOf(const TrendTracks::Shown &shown) const
{
    const Place place = shown.track.place;
    TrendColumn column{.track = shown.track, .name = m_station(place), .scale = m_scales.of(shown)};
    if (const Archive *archive = m_histories.archiveOf(place)) {
        column.shift = archive->shift();
        column.busName = nameAmongOthers(place.bus);
    }
    return column;
}

void TrendPage::exportTo(const QString &path, Extract what)
{
    const auto span = spanOf(what);
    if (!span)
        return;
    TrendExtract extract{.columns = {}, .span = *span};
    for (const TrendTracks::Shown &shown : m_tracks.shown())
        extract.columns.push_back(columnOf(shown));
    delete m_export;
    m_export = new TrendExport(
        std::make_unique<TrendFiles>(path, extract, historyOf(m_histories), csvStyle()),
        [this] { return origin(); }, this);
    connect(m_export, &TrendExport::progressed, this, [this](int percent) {
        if (std::exchange(m_percent, percent) != percent)
            say(Role::running, tr("Writing %1: %2 %").arg(m_export->files().path()).arg(percent),
                tr("Cancel"));
    });
    connect(m_export, &TrendExport::ended, this, &TrendPage::endExport);
}

// What the encoders have now; those that are away are named all the same.
TrendOrigin TrendPage::origin() const
{
    TrendOrigin origin{.version = QCoreApplication::applicationVersion(),
                       .now = QDateTime::currentDateTime(),
                       .marks = m_histories.marks(),
                       .dropped = m_histories.dropped()};
    std::set<Place> places;
    for (const TrendTracks::Shown &shown : m_tracks.shown())
        places.insert(shown.track.place);
    for (const Place place : places) {
        const EncoderSession *encoder = m_buses.encoder(place);
        TrendEncoder its = encoder != nullptr ? trendEncoder(*encoder) : TrendEncoder{.place = place};
        if (m_histories.archiveOf(place) != nullptr)
            its.values = recordedValues(m_histories.known(place));
        its.station = m_station(place);
        its.busName = Place{place.bus, {}}.shown();
        its.stepsPerTurn = m_scales.stepsPerTurn(place);
        origin.encoders.push_back(std::move(its));
    }
    return origin;
}

void TrendPage::endExport(const QString &failure)
{
    const QString path = m_export->files().path();
    if (failure.isEmpty())
        say(Role::running, tr("%1 is written: %n rows; the file beside it says what they are.", nullptr,
                              static_cast<int>(std::min<qint64>(m_export->files().rows(), INT_MAX)))
                               .arg(path));
    else
        sayNotWritten(path, failure);
    m_export->deleteLater();
    m_export = nullptr;
    m_percent = -1;
}

void TrendPage::cancelExport()
{
    if (m_export == nullptr)
        return;
    delete m_export; // discards what was written so far
    m_export = nullptr;
    m_percent = -1;
    say(Role::attention, tr("The export is cancelled; nothing was written."));
}

} // namespace codewheel
