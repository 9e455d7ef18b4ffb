// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>
#include <QPixmap>

#include <array>

namespace codewheel {

// The look of one bit. None of it depends on colour alone.
struct BitCell
{
    bool set = false;     // filled with a 1; else outlined with a 0
    bool changed = false; // corner mark
    bool staged = false;  // dashed rim: not sent yet
    bool focused = false; // ring
    bool hovered = false; // strong rim
    bool enabled = true;

    friend bool operator==(const BitCell &, const BitCell &) = default;
};

// Caches each look of a cell as a pixmap, so that a changing word costs one copy per changed bit.
class BitCellPictures
{
public:
    // size in logical pixels
    const QPixmap &picture(BitCell cell, QSize size, qreal scale, const QPalette &palette);
    void clear(); // palette, fonts or style changed

private:
    std::array<QPixmap, 64> m_pictures; // by the six flags
    QSize m_size;
    qreal m_scale = 0;
};

} // namespace codewheel
