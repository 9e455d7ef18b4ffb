// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/curve_bar.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/trend/track_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>

#include <utility>

namespace codewheel {
namespace {

constexpr double mostTravel = 1e6; // mm per turn
constexpr int travelDecimals = 4;

QToolButton *iconButton(QWidget *parent, Icon icon, const char *id, const QString &name, const QString &tip)
{
    auto *button = new QToolButton(parent);
    button->setIcon(lineIcon(icon));
    button->setIconSize({grid::smallIcon, grid::smallIcon});
    button->setAutoRaise(true);
    return describe(button, id, name, tip);
}

} // namespace

CurveBar::CurveBar(TrendTracks &tracks, const EncoderScales &scales, QWidget *parent)
    : QWidget(parent)
    , m_tracks(tracks)
    , m_scales(scales)
    , m_unit(describe(new QComboBox(this), "curveUnit", tr("Unit"), tr("The unit of the chosen curve")))
    , m_travel(
          describe(new DecimalField(this), "curveTravel", tr("Travel per turn"),
                   tr("How far the machine moves in one turn of this encoder; applies to all its curves")))
    , m_shares(
          describe(new QCheckBox(tr("On the a&xis above"), this), "curveAxis",
                   tr("Draws the chosen curve on the axis of the one above it, where both have one unit")))
    , m_up(iconButton(this, Icon::up, "curveUp", tr("Up"), tr("Moves the chosen curve up (Alt+Up)")))
    , m_down(
          iconButton(this, Icon::down, "curveDown", tr("Down"), tr("Moves the chosen curve down (Alt+Down)")))
    , m_remove(iconButton(this, Icon::remove, "curveRemove", tr("Remove curve"),
                          tr("Removes the chosen curve; what is kept of it stays (Delete)")))
{
    m_travel->setRange(0, mostTravel);
    m_travel->setDecimals(travelDecimals);
    m_travel->setSuffix(tr(" mm per turn"));
    m_travel->setSpecialValueText(tr("How many mm per turn?"));
    m_unit->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_travel->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    layOutRow(this, {m_unit, m_travel, m_shares, Stretch{1}, m_up, m_down, m_remove},
              {.spacing = grid::unit, .margins = QMargins()});
    connect(m_unit, &QComboBox::activated, this, [this](int row) {
        if (m_index)
            m_tracks.setUnit(*m_index, static_cast<TrackUnit>(m_unit->itemData(row).toInt()));
    });
    connect(m_travel, &QDoubleSpinBox::valueChanged, this, [this](double millimetres) {
        if (const auto its = shown(); its && millimetres > 0)
            m_tracks.setTravel(its->track.place, millimetres);
    });
    connect(m_shares, &QCheckBox::clicked, this, [this](bool shares) {
        if (m_index)
            m_tracks.shareAxis(*m_index, shares);
    });
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
    connect(m_remove, &QToolButton::clicked, this, [this] {
        if (m_index)
            m_tracks.remove(*m_index);
    });
    setCurve({});
}

std::optional<TrendTracks::Shown> CurveBar::shown() const
{
    return m_index && *m_index < m_tracks.shown().size() ? std::optional(m_tracks.shown()[*m_index])
                                                         : std::nullopt;
}

void CurveBar::move(int by)
{
    if (!m_index || (by < 0 && *m_index == 0) || (by > 0 && *m_index + 1 >= m_tracks.shown().size()))
        return;
    const std::size_t from = *m_index;
    const std::size_t to = by < 0 ? from - 1 : from + 1;
    m_index = to;
    m_tracks.move(from, to);
    Q_EMIT moved(to);
}

void CurveBar::setCurve(std::optional<std::size_t> index)
{
    if (std::exchange(m_index, index) != index)
        m_travel->setValue(m_travel->value()); // what was refused was meant for the other one
    showAnew();
}

// Units that cannot be had say why when they are pointed at.
void CurveBar::showUnits(const TrendTracks::Shown &shown)
{
    m_unit->clear();
    for (const TrackUnit unit : trackUnits) {
        const bool needsTravel = unit == TrackUnit::millimetres && m_scales.asksForTravel(shown.track.place);
        m_unit->addItem(shown.track.channel == Channel::speed ? unitSymbol({unit, 1}, Channel::speed)
                                                              : unitName(unit),
                        static_cast<int>(unit));
        if (m_scales.has(shown.track.place, unit) || needsTravel)
            continue;
        auto *item = qobject_cast<QStandardItemModel *>(m_unit->model())->item(m_unit->count() - 1);
        item->setEnabled(false);
        item->setToolTip(whyNot(shown.track.place, unit));
    }
    // What is drawn, unless it waits for the travel.
    const TrackUnit unit = m_scales.asksForTravel(shown.track.place) ? shown.unit : m_scales.of(shown).unit;
    m_unit->setCurrentIndex(m_unit->findData(static_cast<int>(unit)));
}

QString CurveBar::whyNot(Place place, TrackUnit unit) const
{
    if (!m_scales.isRod(place))
        return tr("How many steps this encoder has per turn is not known: read its parameters.");
    return unit == TrackUnit::millimetres
               ? tr("The measuring length, or the length of the rod, is not known: read or set them.")
               : tr("A linear encoder has no turns.");
}

void CurveBar::showTravel(const TrendTracks::Shown &shown)
{
    m_travel->setVisible(shown.unit == TrackUnit::millimetres && m_scales.asksForTravel(shown.track.place));
    if (const double travel = m_tracks.travel(shown.track.place).value_or(0); m_travel->value() != travel)
        m_travel->setValue(travel); // otherwise what is refused stays to be corrected
}

void CurveBar::showAnew()
{
    const QSignalBlocker quietUnit(m_unit);
    const QSignalBlocker quietTravel(m_travel);
    const auto its = shown();
    const bool isNumber = its && bitCount(its->track.channel) == 0;
    m_unit->setEnabled(isNumber);
    m_shares->setEnabled(its && *m_index > 0 && canShareAxis(m_tracks.shown()[*m_index - 1], *its));
    m_shares->setChecked(its && its->sharesAxis);
    m_up->setEnabled(its && *m_index > 0);
    m_down->setEnabled(its && *m_index + 1 < m_tracks.shown().size());
    m_remove->setEnabled(its.has_value());
    if (isNumber) {
        showUnits(*its);
        showTravel(*its);
    } else {
        m_unit->clear();
        m_travel->hide();
    }
}

} // namespace codewheel
