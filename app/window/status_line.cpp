// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/status_line.h"

#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"
#include "line/line_session.h"
#include "ring/bus_session.h"
#include "ring/master_look.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/role_label.h"

#include <QEvent>
#include <QLabel>
#include <QLayout>
#include <QLocale>
#include <QStatusBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int narrowest = 320;

QLabel *addLabel(QStatusBar &bar, const QString &name, const QString &toolTip)
{
    auto *label = describe(new QLabel(&bar), name, toolTip);
    label->setFont(textFont(TextSize::small));
    return label;
}

// Repainting a text that is the same costs a picture of its own, and one that is as long as before must not
// lay out the window anew.
void setTextOf(QLabel *label, const QString &text)
{
    if (label->text() == text)
        return;
    label->setFixedSize(label->fontMetrics().size(Qt::TextSingleLine, text));
    label->setText(text);
}

int crcErrorsOf(const MasterStatus &master)
{
    int errors = 0;
    for (const MasterStatus::Segment &segment : master.segments)
        errors += static_cast<int>(segment.crcErrors);
    return errors;
}

} // namespace

StatusLine::StatusLine(QStatusBar &bar, QObject *parent)
    : QObject(parent)
    , m_bar(bar)
    , m_state(new RoleLabel(&bar))
    , m_mode(new RoleLabel(&bar))
    , m_cycle(addLabel(bar, tr("Cycle time"), tr("The time from one exchange of all words to the next")))
    , m_late(
          addLabel(bar, tr("Late cycles"), tr("Cycles that began too late; they are counted, not caught up")))
    , m_crc(addLabel(bar, tr("CRC errors"), tr("Faulty data cycles since the ring was started")))
    , m_linkLabel(addLabel(bar, tr("Link"), tr("How the program is connected to the ring")))
    , m_lineLabel(new RoleLabel(&bar))
    , m_hint(addLabel(bar, QString(), QString()))
    , m_writes(
          addLabel(bar, tr("EEPROM writes"),
                   tr("Writes to the memory of the chosen encoder by this program since it was started")))
{
    m_state->setToolTip(tr("State of the master"));
    m_mode->setToolTip(tr("Watch: nothing is sent. Operate: writing is allowed."));
    bar.setSizeGripEnabled(false);
    bar.setMinimumWidth(narrowest);
    bar.installEventFilter(this);
    // Permanent, since the bar hides all others while it shows what the mouse or the focus is on.
    bar.addPermanentWidget(m_state);
    bar.addPermanentWidget(m_mode);
    bar.addPermanentWidget(m_cycle);
    bar.addPermanentWidget(m_late);
    bar.addPermanentWidget(m_crc);
    bar.addPermanentWidget(m_linkLabel);
    bar.addPermanentWidget(m_lineLabel);
    m_lineLabel->hide();
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hint->setObjectName(QStringLiteral("hint"));
    m_hint->setIndent(grid::margin);
    bar.addPermanentWidget(m_hint, 1);
    bar.addPermanentWidget(m_writes);
    connect(&bar, &QStatusBar::messageChanged, m_hint, &QLabel::setText);
}

void StatusLine::setBus(BusSession *bus, const QString &link)
{
    if (m_bus != nullptr)
        m_bus->disconnect(this);
    m_bus = bus;
    m_link = link;
    if (bus != nullptr) {
        connect(bus, &BusSession::updated, this, &StatusLine::refresh);
        connect(bus, &BusSession::stateChanged, this, &StatusLine::refresh);
    }
    refresh();
}

void StatusLine::setLine(LineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_line = line;
    if (line) {
        connect(line, &LineSession::updated, this, &StatusLine::showLine);
        connect(line, &LineSession::stateChanged, this, &StatusLine::refresh);
        connect(line, &LineSession::nodesChanged, this, &StatusLine::showLine);
    }
    refresh();
}

void StatusLine::setMode(bool isOperating)
{
    m_isOperating = isOperating;
    showState();
}

void StatusLine::setEncoder(EncoderSession *encoder)
{
    m_encoder = encoder;
    refresh();
}

bool StatusLine::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_bar && (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest))
        fit();
    return QObject::eventFilter(watched, event);
}

// Leaves out as many as must be, those first that matter least while one works.
void StatusLine::fit()
{
    const int spacing = m_bar.layout() ? m_bar.layout()->spacing() : grid::unit;
    int needed = 2 * grid::margin;
    for (const QWidget *always : {static_cast<QWidget *>(m_state), static_cast<QWidget *>(m_mode),
                                  static_cast<QWidget *>(m_lineLabel), static_cast<QWidget *>(m_writes)})
        if (!always->isHidden())
            needed += always->sizeHint().width() + spacing;
    bool fits = true;
    for (QLabel *label : {m_late, m_crc, m_cycle, m_linkLabel}) {
        needed += label->sizeHint().width() + spacing;
        fits = fits && needed <= m_bar.width();
        label->setVisible(fits && !label->text().isEmpty());
    }
}

void StatusLine::refresh()
{
    showState();
    showLine();
    showWrites();
    if (m_bus == nullptr) {
        for (QLabel *label : {m_cycle, m_late, m_crc, m_linkLabel})
            setTextOf(label, {});
        fit();
        return;
    }
    const Snapshot &snapshot = m_bus->latest();
    const QLocale locale;
    const double period = std::chrono::duration<double, std::milli>(snapshot.period).count();
    setTextOf(m_cycle,
              period > 0 ? tr("cycle %1 ms").arg(locale.toString(period, 'f', 1)) : tr("virtual time"));
    setTextOf(m_late, tr("%n late cycles", nullptr, static_cast<int>(snapshot.lateCycles)));
    setTextOf(m_crc,
              snapshot.master ? tr("%n CRC errors", nullptr, crcErrorsOf(*snapshot.master)) : QString());
    setTextOf(m_linkLabel, tr("link: %1").arg(m_link));
    fit();
}

void StatusLine::showLine()
{
    const bool isOpen = m_line && m_line->isOpen();
    m_lineLabel->setVisible(isOpen);
    if (!isOpen)
        return;
    const LineSnapshot &line = m_line->latest();
    const QString port = m_line->linkName().section(QStringLiteral("/dev/"), -1);
    if (!line.connected) {
        m_lineLabel->setState(Role::fault, tr("%1: port is gone", "serial port").arg(port));
        return;
    }
    const auto numbers = m_line->places();
    const auto answering = std::ranges::count_if(numbers, [this](Place number) {
        return m_line->encoder(number)->latest().state == EncoderState::operation;
    });
    const bool allAnswer = answering == std::ssize(numbers);
    m_lineLabel->setState(allAnswer ? Role::running : Role::fault,
                          tr("%1, %2 Bd, %3 of %4 answer", "serial port, baud rate, encoders")
                              .arg(port, QString::number(m_line->settings().baudRate))
                              .arg(answering)
                              .arg(numbers.size()));
    const QString figures = tr("Serial line: %1 answers, %2 time-outs, %3 garbage bytes")
                                .arg(line.figures.answers)
                                .arg(line.figures.timeOuts)
                                .arg(line.figures.garbageBytes);
    if (m_lineLabel->toolTip() != figures)
        m_lineLabel->setToolTip(figures);
}

void StatusLine::showWrites()
{
    const auto make = [](const DeviceDescription &device) {
        return device.vendor.isEmpty() ? profileName(device.profile) : device.vendor;
    };
    setTextOf(m_writes, m_encoder == nullptr || !m_encoder->can().writes
                            ? QString()
                            : tr("%1 %2: %3", "place, make: writes")
                                  .arg(m_encoder->place().shown(), make(m_encoder->device()),
                                       eepromCountBrief(m_encoder->eepromCount())));
    const QString toolTip = m_encoder == nullptr ? QString() : eepromCountText(*m_encoder);
    if (m_writes->toolTip() != toolTip)
        m_writes->setToolTip(toolTip);
}

void StatusLine::showState()
{
    if (m_bus == nullptr)
        m_state->setState(Role::inactive, tr("not connected"));
    else
        m_state->setState(masterRole(m_bus->latest()), masterText(m_bus->latest()));
    if (m_isOperating)
        m_mode->setState(Role::running, tr("Operate"));
    else
        m_mode->setState(Role::inactive, tr("Watch"));
}

} // namespace codewheel
