// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <cstdint>
#include <optional>
#include <vector>

class QLabel;

namespace codewheel {

// The diagnostic status register of the master: its sixteen bits by name, set ones marked by a filled square
// and bold letters, and the register as hexadecimal. Used by the master panel.
class StatusBits : public QWidget
{
    Q_OBJECT

public:
    explicit StatusBits(QWidget *parent = nullptr);

    void showBits(std::uint16_t bits);

private:
    QLabel *m_hex;
    std::vector<QLabel *> m_bits; // 0..15
    std::optional<std::uint16_t> m_shown;
};

} // namespace codewheel
