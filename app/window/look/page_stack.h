// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStackedWidget>

#include <algorithm>

namespace codewheel {

// The pages in the middle of the window, which needs the height of the one that is shown, not of the highest.
// Its width is the same whichever of them have been made already.
class PageStack : public QStackedWidget
{
public:
    using QStackedWidget::QStackedWidget;

    QSize minimumSizeHint() const override
    {
        const QSize least = QStackedWidget::minimumSizeHint();
        return {std::max(least.width(), leastWidth),
                currentWidget() == nullptr ? least.height() : leastHeight(*currentWidget())};
    }
    int heightForWidth(int) const override { return minimumSizeHint().height(); }

private:
    static constexpr int leastWidth = 505; // panels beside it leave a monitor room for its bits
    static int leastHeight(const QWidget &page)
    {
        return std::max(page.minimumSizeHint().height(), page.minimumHeight());
    }
};

} // namespace codewheel
