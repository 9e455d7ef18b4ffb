// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace codewheel {

// As high as its content where there is room, otherwise lower and scrollable. For content beside a list on a
// page that has to fit a low window.
class ContentScrollArea : public QScrollArea
{
public:
    // Owns `content`.
    explicit ContentScrollArea(QWidget *content, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    bool m_hasWidth = false; // before the first layout it is any
};

} // namespace codewheel
