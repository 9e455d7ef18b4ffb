// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/master/status_bits.h"

#include "catalog/hex_code.h"
#include "ring/master_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"

#include <QGridLayout>
#include <QLabel>

namespace codewheel {
namespace {

constexpr int bitsInRow = 3; // a dock is narrow

} // namespace

StatusBits::StatusBits(QWidget *parent)
    : QWidget(parent)
    , m_hex(new QLabel(this))
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setHorizontalSpacing(grid::groupGap);
    grid->setVerticalSpacing(grid::unit / 2);
    m_hex->setFont(numberFont());
    m_hex->setAccessibleName(tr("Diagnostic status register"));
    m_hex->setToolTip(tr("The diagnostic status register; healthy in RUN: 00E0h"));
    m_hex->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    grid->addWidget(m_hex, 0, 0, 1, bitsInRow);
    for (int bit = 0; bit < diagnosticBits; ++bit) {
        auto *label = new QLabel(this);
        label->setToolTip(tr("Bit %1, %2: %3").arg(bit).arg(diagnosticBitName(bit), diagnosticBitText(bit)));
        label->setTextFormat(Qt::PlainText);
        grid->addWidget(label, 1 + bit / bitsInRow, bit % bitsInRow);
        m_bits.push_back(label);
    }
}

void StatusBits::showBits(std::uint16_t bits)
{
    if (m_shown == bits)
        return;
    m_shown = bits;
    m_hex->setText(hexCode(bits, 4));
    for (int bit = 0; bit < diagnosticBits; ++bit) {
        QLabel *label = m_bits[static_cast<std::size_t>(bit)];
        const bool isSet = (bits >> bit & 1) != 0;
        const QString name = diagnosticBitName(bit);
        label->setText((isSet ? u'\u25A0' : u'\u25A1') + QStringLiteral(" ") + name);
        QFont font = textFont(TextSize::small);
        font.setBold(isSet);
        label->setFont(font);
        label->setEnabled(isSet);
        label->setAccessibleName(isSet ? tr("%1 is set").arg(name) : tr("%1 is not set").arg(name));
    }
}

} // namespace codewheel
