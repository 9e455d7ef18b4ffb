// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"

#include <QIconEngine>

#include <optional>

namespace codewheel {

// Paints one line icon in the colour the palette has now. Used by lineIcon() only.
class LineIconEngine final : public QIconEngine
{
public:
    LineIconEngine(Icon icon, std::optional<Role> role);

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State state) override;
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override;
    QPixmap scaledPixmap(const QSize &size, QIcon::Mode mode, QIcon::State state, qreal scale) override;
    QList<QSize> availableSizes(QIcon::Mode mode, QIcon::State state) override;
    QString key() const override;
    QIconEngine *clone() const override;

private:
    QColor color(QIcon::Mode mode) const;

    Icon m_icon;
    std::optional<Role> m_role;
};

} // namespace codewheel
