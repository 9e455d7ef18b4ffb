// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/monitor/monitor_area.h"

#include "bus/word_channel.h"
#include "catalog/device_description.h"
#include "encoder/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/monitor/word_monitor.h"

#include <QJsonArray>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

namespace codewheel {

namespace {

const QLatin1String monitorsKey("monitors");
const QLatin1String placeKey("place");
const QLatin1String kindKey("kind");
const QLatin1String highHalfKey("highHalf");
const QLatin1String displayKey("display");

constexpr std::array everyKind{MonitorKind::in32, MonitorKind::out32, MonitorKind::in16};

} // namespace

MonitorArea::MonitorArea(Buses &buses, QWidget *parent)
    : QWidget(parent)
    , m_buses(buses)
    , m_add(describe(new QToolButton(this), tr("Add monitor"), tr("Open another word of a device")))
    , m_addMenu(new QMenu(this))
    , m_message(new InlineMessage(this))
    , m_pages(new QStackedWidget(this))
    , m_scroll(new QScrollArea(this))
{
    auto *rows = layOut<QVBoxLayout>(this, 0);
    makeBar();
    rows->addWidget(m_add, 0, Qt::AlignLeft);
    rows->addWidget(m_message);
    rows->addWidget(m_pages, 1);

    auto *empty =
        new EmptyState(Icon::monitor, tr("No monitor is open"),
                       tr("A monitor shows one word of one device, and lets you set the bits of an "
                          "OUT word. Use Add monitor, or the menu of a device in the bus structure."),
                       this);
    m_pages->addWidget(empty);

    auto *column = new QWidget;
    m_column = layOut<QVBoxLayout>(column, grid::margin, grid::unit);
    m_column->addStretch(1);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidget(column);
    m_pages->addWidget(m_scroll);

    connect(&buses, &Buses::updated, this, &MonitorArea::showPicture);
    connect(&buses, &Buses::changed, this, [this] {
        putAside();
        followDevices();
        bringBack();
        for (WordMonitor *monitor : m_monitors)
            monitor->busStateChanged();
        showWhetherEmpty();
    });
    showWhetherEmpty();
}

// A device that was named has another session and other words: its monitors are made anew, in their places.
void MonitorArea::openAgain(Place number)
{
    const auto before = m_monitors;
    for (WordMonitor *monitor : before) {
        if (monitor->place() != number)
            continue;
        const int row = m_column->indexOf(monitor);
        const auto place = std::ranges::find(m_monitors, monitor) - m_monitors.begin();
        WordMonitor *fresh = addMonitor(number, monitor->kind());
        fresh->setHighHalf(monitor->isHighHalf());
        m_monitors.pop_back();
        m_monitors.insert(m_monitors.begin() + place, fresh);
        m_column->removeWidget(fresh);
        m_column->insertWidget(row, fresh);
        remove(monitor);
    }
}

void MonitorArea::putAside()
{
    const auto before = m_monitors;
    for (WordMonitor *monitor : before)
        if (m_buses.open(monitor->place().bus) == nullptr) {
            m_aside.push_back({monitor->place(), monitor->kind(), monitor->isHighHalf()});
            remove(monitor);
        }
}

void MonitorArea::bringBack()
{
    for (const Aside &aside : std::exchange(m_aside, {}))
        if (m_buses.open(aside.place.bus) == nullptr)
            m_aside.push_back(aside);
        else if (hasWord(aside.place, aside.kind) && !monitor(aside.place, aside.kind))
            addMonitor(aside.place, aside.kind)->setHighHalf(aside.isHighHalf);
}

// Monitors of devices that are gone are closed, those of other devices in their places made anew, and of
// those that were named.
void MonitorArea::followDevices()
{
    const auto before = m_monitors;
    for (WordMonitor *monitor : before) {
        if (std::ranges::find(m_monitors, monitor) == m_monitors.end())
            continue; // made anew with another of its device
        const Place number = monitor->place();
        if (!hasWord(number, monitor->kind()))
            remove(monitor);
        else if (monitor->channel() != m_buses.channel(number) ||
                 monitor->encoder() != m_buses.encoder(number) || monitor->isNamedAnew())
            openAgain(number);
    }
}

void MonitorArea::makeBar()
{
    m_add->setText(tr("Add &monitor"));
    m_add->setIcon(lineIcon(Icon::add));
    m_add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_add->setPopupMode(QToolButton::InstantPopup);
    m_add->setAutoRaise(true);
    m_add->setFocusPolicy(Qt::StrongFocus);
    m_add->setMenu(m_addMenu);
    connect(m_addMenu, &QMenu::aboutToShow, this, &MonitorArea::fillAddMenu);
}

void MonitorArea::fillAddMenu()
{
    m_addMenu->clear();
    for (const Place number : m_buses.places())
        for (const MonitorKind kind : everyKind) {
            if (!hasWord(number, kind))
                continue;
            const EncoderSession *encoder = m_buses.encoder(number);
            const QString name = encoder ? encoder->device().fullName() : QString();
            m_addMenu->addAction(
                QStringLiteral("%1  %2  %3").arg(number.shown(), monitorKindText(kind), name).trimmed(), this,
                [this, number, kind] { openMonitor(number, kind); });
        }
    if (m_addMenu->isEmpty())
        m_addMenu->addAction(tr("There is no device on the bus"))->setEnabled(false);
}

bool MonitorArea::hasWord(Place number, MonitorKind kind) const
{
    const WordChannel *channel = m_buses.channel(number);
    if (!channel)
        return false;
    switch (kind) {
    case MonitorKind::in32:
        return channel->inWords() >= 2;
    case MonitorKind::out32:
        return channel->outWords() >= 2;
    case MonitorKind::in16:
        break;
    }
    return channel->inWords() >= 1;
}

void MonitorArea::openMonitor(Place number, MonitorKind kind)
{
    m_message->withdraw();
    WordMonitor *opened = monitor(number, kind);
    if (!opened && !hasWord(number, kind)) {
        m_message->showMessage(Role::attention, whyNot(number, kind));
        return;
    }
    if (!opened)
        opened = addMonitor(number, kind);
    m_column->activate();
    m_scroll->ensureWidgetVisible(opened, 0, 0);
    opened->setFocus();
}

void MonitorArea::openWords(Place number)
{
    openMonitor(number, hasWord(number, MonitorKind::in32) ? MonitorKind::in32 : MonitorKind::in16);
    if (hasWord(number, MonitorKind::out32))
        openMonitor(number, MonitorKind::out32);
}

QString MonitorArea::whyNot(Place number, MonitorKind kind) const
{
    const WordChannel *channel = m_buses.channel(number);
    const EncoderSession *encoder = m_buses.encoder(number);
    if (channel == nullptr && encoder != nullptr)
        return tr("%1 has no words: its position stands in the panels, what passes on its bus in the "
                  "terminal.")
            .arg(number.shown());
    if (channel && channel->inWords() == 0 && channel->outWords() == 0)
        return tr("%1 has no words to show: it takes no part in the process data.").arg(number.shown());
    if (encoder && channel && channel->outWords() == 0 && kind == MonitorKind::out32)
        return refusalText(
            {RefusalKind::notSupported, RefusalId::sendingNotSupported, {encoder->device().fullName()}});
    return tr("%1 has no word %2 to show. Choose another device or word.")
        .arg(number.shown(), monitorKindText(kind));
}

void MonitorArea::openFirst()
{
    for (const Place number : m_buses.places()) {
        if (!hasWord(number, MonitorKind::in32) || !hasWord(number, MonitorKind::out32))
            continue;
        for (const MonitorKind kind : {MonitorKind::in32, MonitorKind::out32})
            if (!monitor(number, kind))
                addMonitor(number, kind);
        return;
    }
}

WordMonitor *MonitorArea::addMonitor(Place number, MonitorKind kind)
{
    WordChannel *channel = m_buses.channel(number);
    EncoderSession *encoder = m_buses.encoder(number);
    auto *monitor =
        new WordMonitor(*channel, encoder, encoder ? &encoder->device() : nullptr, kind, m_scroll->widget());
    monitor->setDisplay(m_displays.value(kind));
    monitor->showPicture(m_buses.open(number.bus)->now());
    m_monitors.push_back(monitor);
    m_column->insertWidget(m_column->count() - 1, monitor);
    connect(monitor, &WordMonitor::closeRequested, this, [this, monitor] { remove(monitor); });
    connect(monitor, &WordMonitor::displayChosen, this,
            [this, kind](const MonitorDisplay &display) { setDisplay(kind, display); });
    connect(channel, &QObject::destroyed, monitor, [this, monitor] { remove(monitor); });
    showWhetherEmpty();
    return monitor;
}

void MonitorArea::remove(WordMonitor *monitor)
{
    std::erase(m_monitors, monitor);
    monitor->hide();
    monitor->deleteLater();
    showWhetherEmpty();
}

void MonitorArea::closeMonitor(Place number, MonitorKind kind)
{
    if (WordMonitor *open = monitor(number, kind))
        remove(open);
}

void MonitorArea::closeAll()
{
    while (!m_monitors.empty())
        remove(m_monitors.back());
}

WordMonitor *MonitorArea::monitor(Place number, MonitorKind kind) const
{
    const auto found = std::ranges::find_if(m_monitors, [number, kind](const WordMonitor *monitor) {
        return monitor->place() == number && monitor->kind() == kind;
    });
    return found == m_monitors.end() ? nullptr : *found;
}

void MonitorArea::setDisplay(MonitorKind kind, const MonitorDisplay &display)
{
    m_displays.insert(kind, display);
    for (WordMonitor *monitor : m_monitors)
        if (monitor->kind() == kind)
            monitor->setDisplay(display);
}

void MonitorArea::showPicture(BusId bus)
{
    const EncoderBus *shown = m_buses.open(bus);
    for (WordMonitor *monitor : m_monitors)
        if (shown != nullptr && monitor->place().bus == bus)
            monitor->showPicture(shown->now());
}

void MonitorArea::showWhetherEmpty()
{
    m_pages->setCurrentIndex(m_monitors.empty() ? 0 : 1);
}

QJsonObject MonitorArea::state() const
{
    QJsonArray monitors;
    const auto add = [&](Place place, MonitorKind kind, bool isHighHalf) {
        QJsonObject json{{placeKey, place.key()}, {kindKey, monitorKindText(kind)}};
        if (isHighHalf)
            json.insert(highHalfKey, true);
        monitors.append(json);
    };
    for (const WordMonitor *monitor : m_monitors)
        add(monitor->place(), monitor->kind(), monitor->isHighHalf());
    for (const Aside &aside : m_aside)
        add(aside.place, aside.kind, aside.isHighHalf);
    QJsonObject displays;
    for (auto it = m_displays.begin(); it != m_displays.end(); ++it)
        displays.insert(monitorKindText(it.key()), it->toJson());
    return {{monitorsKey, monitors}, {displayKey, displays}};
}

void MonitorArea::restoreState(const QJsonObject &state)
{
    closeAll();
    m_aside.clear();
    const QJsonObject displays = state.value(displayKey).toObject();
    for (const MonitorKind kind : everyKind)
        if (const QJsonValue display = displays.value(monitorKindText(kind)); display.isObject())
            setDisplay(kind, MonitorDisplay::fromJson(display.toObject()));
    for (const QJsonValue json : state.value(monitorsKey).toArray()) {
        const auto place = Place::parse(json[placeKey].toString());
        if (const auto kind = monitorKindFromText(json[kindKey].toString()); place && kind)
            m_aside.push_back({*place, *kind, json[highHalfKey].toBool()});
    }
    bringBack();
}

} // namespace codewheel
