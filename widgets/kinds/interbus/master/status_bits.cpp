// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/status_bits.h"

#include "catalog/hex_code.h"
#include "kinds/interbus/ring/master_text.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/on_event.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int mostColumns = 4;
constexpr int usualColumns = 2; // in a dock beside the monitors

QFont bitFont(bool isSet)
{
    QFont font = textFont(TextSize::small);
    font.setBold(isSet);
    return font;
}

QString bitText(int bit, bool isSet)
{
    return (isSet ? u'\u25A0' : u'\u25A1') + QStringLiteral(" ") + diagnosticBitName(bit);
}

} // namespace

StatusBits::StatusBits(QWidget *parent)
    : QWidget(parent)
    , m_grid(new QGridLayout(this))
    , m_hex(new QLabel(this))
{
    m_grid->setContentsMargins({});
    m_grid->setHorizontalSpacing(grid::groupGap);
    m_grid->setVerticalSpacing(grid::unit / 2);
    m_hex->setFont(numberFont());
    m_hex->setAccessibleName(tr("Diagnostic status register"));
    m_hex->setToolTip(tr("The diagnostic status register; healthy in RUN: 00E0h"));
    m_hex->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_grid->addWidget(m_hex, 0, 0, 1, mostColumns, Qt::AlignLeft);
    for (int bit = 0; bit < diagnosticBits; ++bit) {
        auto *label = new QLabel(this);
        label->setToolTip(tr("Bit %1, %2: %3").arg(bit).arg(diagnosticBitName(bit), diagnosticBitText(bit)));
        label->setTextFormat(Qt::PlainText);
        m_bits.push_back(label);
    }
    measure();
    arrange(usualColumns);
    onEvent(this, {QEvent::FontChange, QEvent::StyleChange}, [this] { measure(); });
    onEvent(this, {QEvent::Resize}, [this] {
        arrange(std::clamp((width() + grid::groupGap) / (m_widest + grid::groupGap), 1, mostColumns));
    });
}

// All as wide as the widest bit when set, so that nothing moves when one is.
void StatusBits::measure()
{
    const QFontMetrics metrics(bitFont(true));
    m_widest = 0;
    for (int bit = 0; bit < diagnosticBits; ++bit)
        m_widest = std::max(m_widest, metrics.horizontalAdvance(bitText(bit, true)) + 1);
    for (QLabel *label : m_bits)
        label->setFixedWidth(m_widest);
    updateGeometry();
}

void StatusBits::arrange(int columns)
{
    if (m_columns == columns)
        return;
    m_columns = columns;
    for (std::size_t bit = 0; bit < m_bits.size(); ++bit)
        m_grid->addWidget(m_bits[bit], 1 + static_cast<int>(bit) / columns, static_cast<int>(bit) % columns,
                          Qt::AlignLeft);
}

QSize StatusBits::sizeHint() const
{
    return {usualColumns * (m_widest + grid::groupGap), m_grid->sizeHint().height()};
}

QSize StatusBits::minimumSizeHint() const
{
    return {std::max(m_widest, m_hex->minimumSizeHint().width()), m_grid->minimumSize().height()};
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
        label->setText(bitText(bit, isSet));
        label->setFont(bitFont(isSet));
        label->setAccessibleName(isSet ? tr("%1 is set").arg(name) : tr("%1 is not set").arg(name));
    }
}

} // namespace codewheel
