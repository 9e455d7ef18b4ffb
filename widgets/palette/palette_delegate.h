// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace codewheel {

class PaletteModel;

// A row of the command palette: the title, the key on the right, and below them, small, what it is and
// where; letters that match are bold.
class PaletteDelegate : public QStyledItemDelegate
{
public:
    explicit PaletteDelegate(const PaletteModel &model, QObject *parent = nullptr);

    static int rowHeight(const QWidget &view);

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    void drawLine(QPainter &painter, const QRect &where, const QString &text, const QFont &font) const;

    const PaletteModel &m_model;
};

} // namespace codewheel
