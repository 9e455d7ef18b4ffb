// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QFormLayout;
class QLabel;

namespace codewheel {

// A panel in a dock, as high as its content but at most `mostHeight`, beyond which it scrolls.
class ScrolledPanel : public QScrollArea
{
public:
    QSize sizeHint() const override;

protected:
    ScrolledPanel(const QString &name, int mostHeight, QWidget *parent);

    QWidget *content() const { return m_content; }
    // A selectable text beside its caption.
    QLabel *addLine(QFormLayout &form, const QString &caption, const QString &toolTip);

private:
    QWidget *m_content;
    int m_mostHeight;
};

} // namespace codewheel
