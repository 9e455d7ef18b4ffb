// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_row_options.h"

#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/trace/traffic_table.h"

#include <QCheckBox>
#include <QHBoxLayout>

namespace codewheel {

EscLineRowOptions::EscLineRowOptions(TrafficTable &table, QWidget *parent)
    : QWidget(parent)
{
    auto *row = layOut<QHBoxLayout>(this, grid::margin);
    auto *automatic =
        addBox(tr("Hide automatic requests"),
               tr("Leaves out what the program asks by itself (position, warnings, alarms, serial "
                  "number, version, device code) and the answers. They are kept, and shown again "
                  "when this is cleared."),
               table.filter().hidesAutomatic());
    auto *text = addBox(tr("Text"), tr("Shows the bytes as text, control characters as pictures"), true);
    auto *hex = addBox(tr("Hex"), tr("Shows the bytes as hexadecimal numbers"), true);
    row->addStretch(1);
    connect(automatic, &QCheckBox::toggled, this, [this, &table](bool on) {
        table.filter().hideAutomatic(on);
        Q_EMIT changed();
    });
    connect(text, &QCheckBox::toggled, &table,
            [&table](bool on) { table.showColumn(TrafficColumn::text, on); });
    connect(hex, &QCheckBox::toggled, &table,
            [&table](bool on) { table.showColumn(TrafficColumn::bytes, on); });
}

QCheckBox *EscLineRowOptions::addBox(const QString &text, const QString &toolTip, bool isOn)
{
    auto *box = new QCheckBox(text, this);
    box->setToolTip(toolTip);
    box->setChecked(isOn);
    layout()->addWidget(box);
    return box;
}

} // namespace codewheel
