// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/shift_bar.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"

#include <QAction>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>

#include <cmath>
#include <utility>

namespace codewheel {
namespace {

constexpr double mostShift = 1e9; // seconds, some 30 years
constexpr int shiftDecimals = 3;

QToolButton *button(QWidget *parent, const char *id, const QString &text, const QString &tip)
{
    auto *made = new QToolButton(parent);
    made->setText(text);
    return describe(made, id, text, tip);
}

} // namespace

ShiftBar::ShiftBar(QWidget *parent)
    : QWidget(parent)
    , m_shift(
          describe(new DecimalField(this), "recordingShift", tr("Shown later by"),
                   tr("How many seconds later than it was this recording is shown, to compare it with other "
                      "curves; below 0: earlier")))
    , m_ways(
          button(this, "shiftWays", tr("Shift"), tr("Shifts the recording so that it lies on other curves")))
    , m_moment(
          button(this, "showMoment", tr("Show moment"),
                 tr("Monitor, dial and parameters show the moment of the recording that is at the cursor")))
{
    m_shift->setRange(-mostShift, mostShift);
    m_shift->setDecimals(shiftDecimals);
    m_shift->setSuffix(tr(" s later"));
    auto *menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    m_begin = add(*menu, "shiftBegin", tr("&Begin together"),
                  tr("Shifts the recording so that it begins where the other curves begin"));
    m_cursor = add(*menu, "shiftCursor", tr("Cursor &A to B"),
                   tr("Shifts the recording so that what is at cursor A comes to lie at cursor B"));
    m_asRecorded =
        add(*menu, "shiftNone", tr("As &recorded"), tr("Shows the recording at the time it was made"));
    m_ways->setMenu(menu);
    m_ways->setPopupMode(QToolButton::InstantPopup);
    auto *label = new QLabel(tr("&Recording:"), this);
    label->setBuddy(m_shift);
    layOutRow(this, {label, m_shift, m_ways, Stretch{1}, m_moment},
              {.spacing = grid::unit, .margins = QMargins()});
    connect(m_shift, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
        if (m_archive)
            m_archive->setShift(Instant(std::llround(seconds * 1e6)));
    });
    connect(m_asRecorded, &QAction::triggered, this, [this] {
        if (m_archive)
            m_archive->setShift({});
    });
    connect(m_begin, &QAction::triggered, this, &ShiftBar::beginWanted);
    connect(m_cursor, &QAction::triggered, this, &ShiftBar::cursorWanted);
    connect(m_moment, &QToolButton::clicked, this, &ShiftBar::momentWanted);
    setCursors(false, false);
    hide();
}

QAction *ShiftBar::add(QMenu &menu, const char *id, const QString &text, const QString &tip)
{
    QAction *action = menu.addAction(text);
    action->setObjectName(QLatin1String(id));
    action->setToolTip(tip);
    return action;
}

void ShiftBar::setArchive(Archive *archive)
{
    if (std::exchange(m_archive, archive) != archive)
        m_shift->setValue(m_shift->value()); // what was refused was meant for the other one
    showAnew();
    setVisible(archive != nullptr);
}

void ShiftBar::setCursors(bool any, bool both)
{
    m_cursor->setEnabled(both);
    m_moment->setEnabled(any);
}

void ShiftBar::showAnew()
{
    const QSignalBlocker quiet(m_shift);
    const Instant shift = m_archive ? m_archive->shift() : Instant();
    if (const double seconds = std::chrono::duration<double>(shift).count(); m_shift->value() != seconds)
        m_shift->setValue(seconds); // otherwise what is refused stays to be corrected
    m_asRecorded->setEnabled(shift != Instant());
}

} // namespace codewheel
