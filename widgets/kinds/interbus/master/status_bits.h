// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;

namespace codewheel {

// The diagnostic status register of the master: its sixteen bits by name, set ones marked by a filled square
// and bold letters, in as many columns as there is room for, and the register in hexadecimal. Used by the
// master panel.
class StatusBits : public QWidget
{
    Q_OBJECT

public:
    explicit StatusBits(QWidget *parent = nullptr);

    void showBits(std::uint16_t bits);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

private:
    void measure();
    void arrange(int columns);

    QGridLayout *m_grid;
    QLabel *m_hex;
    std::vector<QLabel *> m_bits; // 0..15
    std::optional<std::uint16_t> m_shown;
    int m_columns = 0;
    int m_widest = 0; // of the bits when set
};

} // namespace codewheel
