// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/offer/seats_view.h"

#include "widgets/kinds/interbus/offer/seat_panel.h"
#include "widgets/kinds/interbus/offer/served_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/heading_width.h"
#include "widgets/look/icons.h"
#include "widgets/look/layouts.h"
#include "widgets/look/may_elide.h"
#include "widgets/look/quiet_table.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

namespace codewheel {

SeatsView::SeatsView(QWidget *parent)
    : QWidget(parent)
    , m_seats(new SeatsModel(this))
    , m_table(named(new QTableView(this), "seatTable"))
    , m_device(describe(new QComboBox(this), "seatDevice", tr("Words of"),
                        tr("The device of each ring whose words the table shows (Alt+W)")))
    , m_panel(named(new SeatPanel(this), "seatPanel"))
    , m_restart(describe(
          new QPushButton(lineIcon(Icon::refresh), tr("Sta&rt seat afresh"), this), "restartSeat",
          tr("Gives the chosen seat a new ring, with factory settings and without what was written to it "
             "(Alt+R)")))
{
    setUpQuietTable(*m_table, *m_seats, tr("Seats"));
    fixColumns(*m_table, {QStringLiteral("64"), QStringLiteral("64"), QString(grid::smallIcon, u'n'),
                          QString(grid::smallIcon, u'n'), ServedText::widestWritten(),
                          QStringLiteral("00000000"), QStringLiteral("00000000")});
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel); // narrow beside the panel
    allowEliding(*m_table, SeatsModel::faults);
    m_restart->setAutoDefault(false);
    connect(m_restart, &QPushButton::clicked, this, [this] {
        if (const auto unit = chosen())
            Q_EMIT restartWanted(*unit);
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this, &SeatsView::showChoice);
    connect(m_seats, &QAbstractItemModel::modelReset, this, &SeatsView::showChoice);
    connect(m_device, &QComboBox::currentIndexChanged, this, &SeatsView::choiceChanged);
    auto *caption = new QLabel(tr("&Words of"), this);
    caption->setBuddy(m_device);
    layOutColumn(this,
                 {layOutRow({caption, m_device, Stretch{1}}),
                  {layOutRow({{m_table, 1}, m_panel}, {.spacing = grid::margin}), 1},
                  layOutRow({Stretch{1}, m_restart})},
                 {.spacing = grid::margin, .margins = allAround(grid::unit)});
    setFocusProxy(m_table);
    showChoice();
}

SeatsView::~SeatsView()
{
    m_table->setModel(nullptr);
}

void SeatsView::setDevices(const std::vector<ServedDevice> &devices)
{
    const QSignalBlocker quiet(m_device);
    m_device->clear();
    for (const ServedDevice &device : devices)
        if (device.registers.in.count > 0 || device.registers.out.count > 0)
            m_device->addItem(QStringLiteral("%1  %2").arg(device.registers.place.toString(), device.name),
                              QVariant::fromValue(device.registers.place));
}

std::optional<NodeId> SeatsView::device() const
{
    return m_device->currentIndex() < 0 ? std::nullopt
                                        : std::optional(m_device->currentData().value<NodeId>());
}

void SeatsView::show(const std::vector<Seat> &seats)
{
    m_seats->show(seats);
}

// The current row may be one that nobody has chosen.
std::optional<int> SeatsView::chosen() const
{
    const auto rows = m_table->selectionModel()->selectedRows();
    return rows.isEmpty() ? std::nullopt : std::optional(m_seats->rowAt(rows.front().row()).unit);
}

void SeatsView::showChoice()
{
    m_restart->setEnabled(chosen().has_value());
    Q_EMIT choiceChanged();
}

} // namespace codewheel
