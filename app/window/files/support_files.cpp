// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/support_files.h"

#include "app/window/buses/plant.h"
#include "app/window/files/private_names.h"
#include "app/window/kinds/window_kinds.h"
#include "bus/bus_outline.h"
#include "journal/message_writer.h"
#include "project/project_json.h"
#include "widgets/messages/message_model.h"
#include "widgets/models/traffic_model.h"
#include "widgets/project/project_document.h"
#include "widgets/trace/trace_view.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QLocale>
#include <QScreen>
#include <QSysInfo>

namespace codewheel {
namespace {

constexpr qint64 mostMessages = 20'000; // several weeks; 4 MB

struct Support
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Support)
};

QByteArray lines(const QStringList &rows)
{
    return (rows.join(u'\n') + u'\n').toUtf8();
}

QByteArray messageTable(const MessageModel &messages)
{
    QBuffer table;
    table.open(QIODevice::WriteOnly);
    MessageWriter writer(table, MessageWriter::Format::csv);
    writer.begin();
    writer.write(messages.newest(mostMessages));
    writer.end();
    return table.data();
}

// In English, for any reader.
QByteArray versions()
{
    QStringList rows{
        QStringLiteral("Codewheel %1").arg(QCoreApplication::applicationVersion()),
        QStringLiteral("Qt %1, built with %2").arg(QLatin1String(qVersion()), QLatin1String(QT_VERSION_STR)),
        QStringLiteral("System: %1, %2 %3, %4")
            .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(), QSysInfo::kernelVersion(),
                 QSysInfo::currentCpuArchitecture()),
        QStringLiteral("Language: %1; system: %2").arg(QLocale().name(), QLocale::system().name()),
        QStringLiteral("Windows: %1").arg(QGuiApplication::platformName())};
    for (const QScreen *screen : QGuiApplication::screens())
        rows << QStringLiteral("Screen: %1 x %2, scale %3, %4 dpi")
                    .arg(screen->size().width())
                    .arg(screen->size().height())
                    .arg(screen->devicePixelRatio())
                    .arg(qRound(screen->logicalDotsPerInch()));
    return lines(rows);
}

QByteArray adapters()
{
    QStringList rows;
    for (const WindowKind *kind : windowKinds())
        if (kind->adapters != nullptr)
            rows << kind->adapters();
    if (rows.isEmpty())
        rows << QStringLiteral("No adapter.");
    return lines(rows);
}

QByteArray buses(const Plant &plant)
{
    QStringList rows;
    for (const BusAtWork *bus : plant.all()) {
        rows << QStringLiteral("Bus %1, %2, %3%4")
                    .arg(bus->id().number)
                    .arg(plant.nameOf(bus->id()), bus->kind(),
                         bus->isTraining() ? QStringLiteral(", training") : QString());
        if (bus->bus() == nullptr) {
            rows << QStringLiteral("  not connected");
            continue;
        }
        const BusOutline &outline = bus->bus()->outline();
        rows << QStringLiteral("  %1: %2; %3")
                    .arg(outline.title(), outline.state().word,
                         bus->bus()->isOperating() ? QStringLiteral("Operate") : QStringLiteral("Watch"));
        const std::vector<BusNode> nodes = outline.nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            rows << QStringLiteral("  %1 %2 (%3): %4")
                        .arg(Place{bus->id(), nodes[i].node}.key(), nodes[i].name, nodes[i].profile,
                             outline.state(i).shown.word);
    }
    return lines(rows);
}

// "trace-1.0.csv", "trace-4-esc-12.csv"
QString traceName(Place place)
{
    QString name = place.key();
    for (QChar &each : name)
        if (!each.isLetterOrNumber() && each != u'.')
            each = u'-';
    return QStringLiteral("trace-%1.csv").arg(name);
}

} // namespace

std::vector<SupportFile> supportFiles(const SupportSources &sources)
{
    std::vector<SupportFile> files;
    const auto add = [&files, names = PrivateNames::ofThisComputer()](
                         const QString &name, const QByteArray &bytes, const QString &what) {
        files.push_back({{name, withoutPrivateNames(QString::fromUtf8(bytes), names).toUtf8()}, what});
    };
    add(QStringLiteral("project.codewheel"), projectToJson(sources.project.project()),
        Support::tr("The project as it is now, unsaved changes included"));
    add(QStringLiteral("messages.csv"), messageTable(sources.messages),
        Support::tr("The newest messages, %1 at most").arg(QLocale().toString(mostMessages)));
    for (const Place place : sources.traces.places())
        if (const TrafficModel *rows = sources.traces.model(place); rows != nullptr && rows->rowCount() > 0)
            add(traceName(place), rows->csv(place), Support::tr("Handshake trace of %1").arg(place.shown()));
    add(QStringLiteral("versions.txt"), versions(),
        Support::tr("Versions of program and system, language, screens"));
    add(QStringLiteral("adapters.txt"), adapters(), Support::tr("Serial ports and their adapters"));
    add(QStringLiteral("buses.txt"), buses(sources.plant), Support::tr("Buses, their states and devices"));
    return files;
}

} // namespace codewheel
