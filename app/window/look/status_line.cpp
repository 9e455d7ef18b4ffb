// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/status_line.h"

#include "catalog/device_description.h"
#include "journal/eeprom_cost.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/on_event.h"
#include "widgets/look/role_label.h"

#include <QLabel>
#include <QLayout>
#include <QStatusBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int narrowest = 320;

QLabel *makeLabel(QStatusBar &bar, const QString &name, const QString &toolTip)
{
    return describe(new QLabel(&bar), name, toolTip);
}

// Setting the same text would cost a repaint of its own, and one of the same length must not lay out the
// window again.
void setTextOf(QLabel *label, const QString &text)
{
    if (label->text() == text)
        return;
    label->setFixedSize(label->fontMetrics().size(Qt::TextSingleLine, text));
    label->setText(text);
}

} // namespace

StatusLine::StatusLine(QStatusBar &bar, QObject *parent)
    : QObject(parent)
    , m_bar(bar)
    , m_state(new RoleLabel(&bar))
    , m_mode(new RoleLabel(&bar))
    , m_otherFaults(nullptr)
    , m_hint(makeLabel(bar, QString(), QString()))
    , m_writes(
          makeLabel(bar, tr("EEPROM writes"),
                    tr("Writes to the memory of the chosen encoder by this program since it was started")))
    , m_always{m_state, m_mode}
{
    m_state->setToolTip(tr("State of the bus"));
    m_mode->setToolTip(tr("Watch: nothing is written. Operate: writing is allowed."));
    bar.setSizeGripEnabled(false);
    bar.setMinimumWidth(narrowest);
    bar.setContentsMargins(0, 0, grid::unit, 0);
    onEventOf(&bar, {QEvent::Resize, QEvent::LayoutRequest}, this, [this] { fit(); });
    // Permanent, since the bar hides all other widgets while it shows a status tip.
    add(m_state);
    add(m_mode);
    m_otherFaults = addState();
    m_hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_hint->setObjectName(QStringLiteral("hint"));
    m_hint->setIndent(grid::margin);
    onEventOf(m_hint, {QEvent::Resize}, this, [this] { showHint(); });
    bar.addPermanentWidget(m_hint, 1);
    bar.addPermanentWidget(m_writes);
    allowEliding(*m_hint);
    allowEliding(*m_writes);
    connect(&bar, &QStatusBar::messageChanged, this, &StatusLine::showHint);
    setState(Role::inactive, tr("not connected"));
}

void StatusLine::add(QWidget *widget)
{
    m_bar.insertPermanentWidget(m_added++, widget);
    connect(widget, &QObject::destroyed, this, [this] { --m_added; });
}

QLabel *StatusLine::addFigure(int rank, const QString &name, const QString &toolTip)
{
    QLabel *label = makeLabel(m_bar, name, toolTip);
    const auto behind = std::ranges::upper_bound(m_figures, rank, {}, &Figure::rank);
    m_figures.insert(behind, {rank, label});
    add(label);
    return label;
}

RoleLabel *StatusLine::addState()
{
    auto *label = new RoleLabel(&m_bar);
    addAlways(label);
    label->hide();
    return label;
}

void StatusLine::addAlways(QWidget *widget)
{
    m_always.emplace_back(widget);
    add(widget);
}

void StatusLine::show(QLabel *figure, const QString &text)
{
    setTextOf(figure, text);
}

void StatusLine::setState(Role role, const QString &text)
{
    m_state->setState(role, text);
}

void StatusLine::setMode(bool isOperating, const QString &bus)
{
    const QString mode = isOperating ? tr("Operate") : tr("Watch");
    m_mode->setState(isOperating ? Role::running : Role::inactive,
                     bus.isEmpty() ? mode : QStringLiteral("%1: %2").arg(bus, mode));
}

void StatusLine::setRecorded(const QString &bus)
{
    m_mode->setState(Role::inactive, tr("%1: recording", "bus").arg(bus));
}

void StatusLine::setOtherFaults(const QStringList &faults)
{
    if (std::exchange(m_faultsTold, faults) == faults)
        return;
    m_otherFaults->setVisible(!faults.isEmpty());
    if (faults.isEmpty())
        return;
    const auto more = static_cast<int>(faults.size()) - 1;
    m_otherFaults->setState(Role::fault,
                            more == 0 ? faults.front()
                                      : tr("%1 and %n more", "fault of a bus", more).arg(faults.front()));
    m_otherFaults->setToolTip(faults.join(QLatin1Char('\n')));
}

void StatusLine::setEncoder(EncoderSession *encoder)
{
    m_encoder = encoder;
    showFrame();
}

// As far as there is room for it.
void StatusLine::showHint()
{
    const int room = m_hint->contentsRect().width() - 2 * grid::margin - grid::unit;
    m_hint->setText(m_hint->fontMetrics().elidedText(m_bar.currentMessage(), Qt::ElideRight, room));
}

// Leaves out as many as necessary, starting with those that matter least during work.
void StatusLine::fit()
{
    const int spacing = m_bar.layout() ? m_bar.layout()->spacing() : grid::unit;
    int needed = 3 * grid::margin;
    for (const QWidget *always : m_always)
        if (always != nullptr && !always->isHidden())
            needed += always->sizeHint().width() + spacing;
    fitWrites(m_bar.width() - needed - spacing);
    if (!m_writes->text().isEmpty())
        needed += m_writes->width() + spacing;
    bool fits = true;
    for (const Figure &figure : m_figures) {
        if (figure.label == nullptr || figure.label->text().isEmpty()) {
            if (figure.label != nullptr)
                figure.label->hide();
            continue;
        }
        needed += figure.label->sizeHint().width() + spacing;
        fits = fits && needed <= m_bar.width();
        figure.label->setVisible(fits);
    }
}

// Its tooltip has all of it.
void StatusLine::fitWrites(int room)
{
    setTextOf(m_writes, m_writes->fontMetrics().elidedText(m_writesText, Qt::ElideRight, std::max(room, 0)));
}

void StatusLine::showFrame()
{
    const auto make = [](const DeviceDescription &device) {
        return device.vendor.isEmpty() ? profileName(device.profile) : device.vendor;
    };
    m_writesText = m_encoder == nullptr || !m_encoder->can().writes
                       ? QString()
                       : tr("%1 %2: %3", "place, make: writes")
                             .arg(m_encoder->place().shown(), make(m_encoder->device()),
                                  eepromCountBrief(m_encoder->eepromCount()));
    const QString toolTip = m_encoder == nullptr ? QString() : eepromCountText(*m_encoder);
    if (m_writes->toolTip() != toolTip)
        m_writes->setToolTip(toolTip);
    fit();
}

} // namespace codewheel
